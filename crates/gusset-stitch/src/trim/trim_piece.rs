//! A prepared piece: triangles for nearest-point searches, and confidences.

use super::trim_request::Options;
use crate::align::CentredPiece;
use crate::boundary::{self, boundary_loops};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::kd_tree::KdTree;
use gusset_base::job::Job;
use gusset_base::par;
use gusset_mesh::{FaceTriangles, MeshView};

const STAGE: &str = "looking at the pieces";
const VERTICES_PER_TASK: usize = 1 << 10;
/// Loops with fewer vertices are small holes, which do not reduce the confidence.
const MIN_BORDER_VERTICES: usize = 32;
/// Smallest factor of the confidence, for surfaces seen at a grazing angle.
const MIN_GRAZING_FACTOR: f64 = 0.1;

/// A prepared piece.
pub(super) struct TrimPiece {
    pub(super) scan: CentredPiece,
    /// The faces as triangles.
    pub(super) triangles: Vec<[u32; 3]>,
    /// The face of each triangle.
    pub(super) faces: Vec<u32>,
    /// The confidence of each vertex, in mean edges.
    pub(super) confidence: Vec<f64>,
}

impl TrimPiece {
    /// Prepares a piece. O(V log V).
    pub(super) fn new(
        mesh: &MeshView<'_>,
        k: usize,
        unit: f64,
        origin: DVec3,
        options: &Options<'_>,
        job: &Job<'_>,
    ) -> Result<TrimPiece> {
        let scan = CentredPiece::new(mesh, unit, Some(origin), &job.sub_job(0.0, 0.5))?;
        let FaceTriangles { corners: triangles, faces, .. } = FaceTriangles::from_mesh(mesh, &job.sub_job(0.5, 0.5))?;
        let borders = boundary_loops(mesh, &boundary::Options::default(), &job.sub_job(0.5, 0.6))?;
        let mut rim = Vec::new();
        for border in borders.iter().filter(|border| border.vertices.len() >= MIN_BORDER_VERTICES) {
            alloc::extend(&mut rim, border.vertices.iter().map(|&v| scan.points[v as usize]))?;
        }
        // Put all points in one group: of coincident points, only one is visited.
        let tree = KdTree::with_groups(&rim, &alloc::filled(0, rim.len())?, &job.sub_job(0.6, 0.6), STAGE)?;
        let viewpoint = options.viewpoints.get(k).map(|viewpoint| *viewpoint / unit - origin);
        let of = |v: usize| {
            let (p, n) = (scan.points[v], scan.normals[v]);
            // On a closed piece, all places are equally far from a border.
            let distance = tree.nearest(p, f64::INFINITY, |_| true).map_or(scan.bounds.diagonal(), |(s, _)| s.sqrt());
            let sight =
                viewpoint.map_or(1.0, |viewpoint| (viewpoint - p).normalize_or_zero().dot(n).max(MIN_GRAZING_FACTOR));
            if scan.spacing > 0.0 { sight * distance / scan.spacing } else { 0.0 }
        };
        let parts = par::map_cancellable(
            &job.sub_job(0.6, 1.0),
            STAGE,
            par::split_into_ranges(scan.points.len(), VERTICES_PER_TASK),
            |range| alloc::collect(range.map(of)),
        )?;
        let mut confidence = alloc::with_capacity(scan.points.len())?;
        alloc::append_all(&mut confidence, parts)?;
        Ok(TrimPiece { scan, triangles, faces, confidence })
    }
}

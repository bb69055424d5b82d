//! Samples of a piece's surface at a common spacing.
//!
//! Dense points represent equal areas. The samples are dense points with a minimum distance from
//! each other. Their normals are means, which reduces noise. Points are placed in the order of the
//! faces, so that they do not depend on the pose of the piece.

use super::centred_piece::CentredPiece;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::kd_tree::{KdTree, ScaledRadius};
use gusset_base::job::Job;
use gusset_mesh::MeshView;

pub(super) const STAGE: &str = "comparing surfaces";
/// The area of the largest piece, in squared spacings. It bounds the number of samples.
const MAX_PIECE_AREA: f64 = 1000.0;
/// Number of dense points for each squared spacing.
const DENSE_POINTS_PER_AREA: f64 = 9.0;
/// Smallest distance of two samples that face the same side, in spacings.
const MIN_SAMPLE_DISTANCE: f64 = 0.8;
/// Radius within which the normal of a sample is a mean, in spacings.
const NORMAL_RADIUS: f64 = 1.0;
/// Number of dense points between two progress reports.
const POINTS_PER_REPORT: usize = 1 << 9;
/// The fractional parts of the multiples of these numbers fill a square evenly: M. Roberts' R2
/// sequence.
const PLASTIC_STEPS: [f64; 2] = [0.754_877_666_246_692_7, 0.569_840_290_998_053_2];

/// Points with unit normals.
#[derive(Default)]
pub(super) struct OrientedPoints {
    pub(super) points: Vec<DVec3>,
    pub(super) normals: Vec<DVec3>,
}

/// Returns the spacing of the samples of all pieces: the largest piece has 1,000 squared spacings.
/// O(F).
pub(super) fn choose_common_spacing<'a>(
    pieces: impl Iterator<Item = (&'a MeshView<'a>, &'a CentredPiece)>,
    job: &Job<'_>,
) -> Result<f64> {
    let mut largest = 0.0f64;
    for (mesh, scan) in pieces {
        let mut area = 0.0;
        for f in 0..mesh.faces().len() {
            job.step_within_list(f, STAGE)?;
            area += triangle_fan(mesh, f).map(|corners| triangle_area(scan, corners)).sum::<f64>();
        }
        largest = largest.max(area);
    }
    Ok((largest / MAX_PIECE_AREA).sqrt())
}

/// Returns the triangles of a face: a fan at its first corner.
fn triangle_fan(mesh: &MeshView<'_>, f: usize) -> impl Iterator<Item = [usize; 3]> {
    let corners = move || mesh.face(f).map(|v| v as usize);
    let first = corners().next().unwrap_or(0);
    corners().skip(1).zip(corners().skip(2)).map(move |(u, v)| [first, u, v])
}

fn triangle_area(scan: &CentredPiece, corners: [usize; 3]) -> f64 {
    let [p, q, r] = corners.map(|v| scan.points[v]);
    (q - p).cross(r - p).length() / 2.0
}

/// Returns points of the surface, nine for each squared spacing. O(F), plus the points.
pub(super) fn place_dense_points(
    mesh: &MeshView<'_>,
    scan: &CentredPiece,
    spacing: f64,
    job: &Job<'_>,
) -> Result<OrientedPoints> {
    let area_per_point = spacing * spacing / DENSE_POINTS_PER_AREA;
    let mut dense = OrientedPoints::default();
    // The first point is in the middle of its area.
    let mut open_area = 0.5 * area_per_point;
    for f in 0..mesh.faces().len() {
        job.step_within_list(f, STAGE)?;
        for corners in triangle_fan(mesh, f) {
            open_area += triangle_area(scan, corners);
            while open_area >= area_per_point {
                open_area -= area_per_point;
                let n = dense.points.len() as f64;
                let [mut a, mut b] = PLASTIC_STEPS.map(|step| (n * step).fract());
                if a + b > 1.0 {
                    (a, b) = (1.0 - a, 1.0 - b);
                }
                let mix = |[x, y, z]: [DVec3; 3]| x * (1.0 - a - b) + y * a + z * b;
                alloc::push(&mut dense.points, mix(corners.map(|v| scan.points[v])))?;
                alloc::push(&mut dense.normals, mix(corners.map(|v| scan.normals[v])).normalize_or_zero())?;
            }
        }
    }
    Ok(dense)
}

/// Returns the samples among the dense points: in their order, each that no sample before covers.
/// `tree` is over the dense points.
pub(super) fn choose_sparse_points(
    dense: &OrientedPoints,
    tree: &KdTree<'_>,
    spacing: f64,
    job: &Job<'_>,
) -> Result<OrientedPoints> {
    let mut is_covered = alloc::filled(false, dense.points.len())?;
    let mut sparse = OrientedPoints::default();
    for i in 0..dense.points.len() {
        job.step_every(POINTS_PER_REPORT, i, dense.points.len(), STAGE)?;
        let (point, normal) = (dense.points[i], dense.normals[i]);
        if is_covered[i] || normal == DVec3::ZERO {
            continue;
        }
        tree.for_each_within(point, ScaledRadius::new(MIN_SAMPLE_DISTANCE * spacing), &mut |_, k| {
            is_covered[k as usize] |= dense.normals[k as usize].dot(normal) > 0.0;
        });
        let mut mean = DVec3::ZERO;
        tree.for_each_within(point, ScaledRadius::new(NORMAL_RADIUS * spacing), &mut |_, k| {
            let other = dense.normals[k as usize];
            mean += if other.dot(normal) > 0.0 { other } else { DVec3::ZERO };
        });
        alloc::push(&mut sparse.points, point)?;
        alloc::push(&mut sparse.normals, mean.normalize_or(normal))?;
    }
    Ok(sparse)
}

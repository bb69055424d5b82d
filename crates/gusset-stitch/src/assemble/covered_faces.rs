//! Faces that kept faces of the pieces cover: dropping them loses no data.
//!
//! A face is covered if the kept face nearest to its centre is within the largest distance of two
//! meshes of one surface, and faces the same side.

use super::assemble_request::Assembly;
use crate::trim::SameSurfaceLimits;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::scale::common_unit;
use gusset_base::geom::triangle_places::TriangleTree;
use gusset_base::job::Job;
use gusset_mesh::{FaceTriangles, MeshView, NONE};

const STAGE: &str = "looking for faces that others cover";

/// The kept faces of the pieces as triangles.
struct KeptTriangles {
    points: Vec<DVec3>,
    triangles: Vec<[u32; 3]>,
    /// The unit of the points.
    unit: f64,
}

impl KeptTriangles {
    /// Collects the faces of the pieces in the result for which `counts` holds, each in the
    /// orientation that it has in its piece. O(F) for F faces.
    fn new(done: &Assembly, counts: impl Fn(u32) -> bool, job: &Job<'_>) -> Result<Self> {
        let view = done.mesh.view(&job.sub_job(0.0, 0.5))?;
        let all = FaceTriangles::from_mesh(&view, &job.sub_job(0.5, 1.0))?;
        let mut points = alloc::collect((0..view.positions().len()).map(|v| view.positions().get(v as u32)))?;
        let unit = common_unit(&points);
        points.iter_mut().for_each(|p| *p /= unit);
        let of_pieces = all.corners.iter().zip(&all.faces).filter_map(|(&[p, q, r], &f)| {
            let turned = done.turned.get(f as usize).filter(|_| counts(f))?;
            Some(if *turned { [p, r, q] } else { [p, q, r] })
        });
        let triangles = alloc::gather(of_pieces)?;
        Ok(KeptTriangles { points, triangles, unit })
    }

    fn normal(&self, triangle: u32) -> DVec3 {
        let [p, q, r] = self.triangles[triangle as usize].map(|v| self.points[v as usize]);
        (q - p).cross(r - p).normalize_or_zero()
    }
}

/// Visits the given faces of each piece, and tells for each whether kept faces of the result cover
/// it. Kept faces for which `counts` is false are ignored.
///
/// O((F + n) log F) for n faces and F kept faces.
pub(super) fn visit_covering_triangles(
    pieces: &[MeshView<'_>],
    done: &Assembly,
    faces: &[[u32; 2]],
    counts: impl Fn(u32) -> bool,
    same: SameSurfaceLimits,
    job: &Job<'_>,
    mut visit: impl FnMut([u32; 2], bool) -> Result<()>,
) -> Result<()> {
    if faces.is_empty() {
        return Ok(());
    }
    let kept = KeptTriangles::new(done, counts, &job.sub_job(0.0, 0.2))?;
    let tree = TriangleTree::new(&kept.points, &kept.triangles, STAGE, &job.sub_job(0.2, 0.4))?;
    let reach = same.distance / kept.unit;
    let mut guess = None;
    for (n, &[k, f]) in faces.iter().enumerate() {
        job.sub_job(0.4, 1.0).step_within_list(n, STAGE)?;
        let piece = &pieces[k as usize];
        let (centre, normal) = centre_and_normal(piece, f as usize, kept.unit);
        let place = tree.nearest_with_guess(centre, reach * reach, guess);
        guess = place.map(|place| place.triangle).or(guess);
        visit([k, f], place.is_some_and(|place| kept.normal(place.triangle).dot(normal) >= same.cosine))?;
    }
    Ok(())
}

/// Returns the faces of the pieces that are not in the result and are not covered: (piece, face),
/// in ascending order.
pub(super) fn list_lost_faces(
    pieces: &[MeshView<'_>],
    done: &Assembly,
    same: SameSurfaceLimits,
    job: &Job<'_>,
) -> Result<Vec<[u32; 2]>> {
    let mut dropped = Vec::new();
    for (map, k) in done.maps.iter().zip(0..) {
        alloc::extend(&mut dropped, (0..).zip(&map.faces).filter(|&(_, &name)| name == NONE).map(|(f, _)| [k, f]))?;
    }
    let mut lost = Vec::new();
    visit_covering_triangles(
        pieces,
        done,
        &dropped,
        |_| true,
        same,
        job,
        |face, is_covered| {
            if is_covered { Ok(()) } else { alloc::push(&mut lost, face) }
        },
    )?;
    Ok(lost)
}

/// Returns the mean of the corners of a face in `unit`, and its unit normal; 0 for a degenerate
/// face.
fn centre_and_normal(mesh: &MeshView<'_>, f: usize, unit: f64) -> (DVec3, DVec3) {
    let corners = || mesh.face(f).map(|v| mesh.positions().get(v) / unit);
    let centre = corners().sum::<DVec3>() / corners().len() as f64;
    let arms = corners().map(|p| p - centre);
    let area: DVec3 = arms.clone().zip(arms.cycle().skip(1)).map(|(p, q)| p.cross(q)).sum();
    (centre, area.normalize_or_zero())
}

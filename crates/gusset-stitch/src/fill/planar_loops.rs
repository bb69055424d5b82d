//! Planar loops: their plane, and their ears.

use glam::{DVec2, DVec3};
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::polygon;
use gusset_base::job::Job;

/// Largest distance of planar points from their plane, relative to the size of the point set.
const MAX_PLANAR_DEVIATION: f64 = 1e-6;

/// Triangulates the loop through `points` by [ear clipping](polygon::clip_ears) in projection along
/// its mean normal. Returns `None` if every remaining ear has a `taken` edge.
pub(super) fn clip_ears(
    points: &[DVec3],
    taken: &dyn Fn(u32, u32) -> bool,
    job: &Job<'_>,
) -> Result<Option<Vec<[u32; 3]>>> {
    polygon::clip_ears(points, &project_to_plane(points)?, taken, job)
}

/// Returns the unit normal of a loop by Newell's formula; the z axis for a degenerate loop.
pub(super) fn mean_normal(points: &[DVec3]) -> DVec3 {
    let next = points.iter().cycle().skip(1);
    let normal: DVec3 = points.iter().zip(next).map(|(&p, &q)| (p - points[0]).cross(q - points[0])).sum();
    normal.try_normalize().unwrap_or(DVec3::Z)
}

/// Returns true if all points lie in the plane through the first point with this normal, up to
/// single-precision round-off.
pub(super) fn is_planar(points: &[DVec3], normal: DVec3) -> bool {
    let size = points.iter().map(|p| p.distance(points[0])).fold(0.0, f64::max);
    points.iter().all(|&p| (p - points[0]).dot(normal).abs() <= MAX_PLANAR_DEVIATION * size)
}

/// Projects the loop along its mean normal, counter-clockwise.
fn project_to_plane(points: &[DVec3]) -> Result<Vec<DVec2>> {
    let (origin, normal) = (points[0], mean_normal(points));
    let x = normal.any_orthonormal_vector();
    let y = normal.cross(x);
    alloc::collect(points.iter().map(|&p| DVec2::new((p - origin).dot(x), (p - origin).dot(y))))
}

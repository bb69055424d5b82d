//! Arc lengths along a polyline, and points at equal arc lengths, in linear time.

use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;

/// Returns `count` points at equal arc lengths, including both ends of an open polyline. The
/// polyline must have at least one point.
pub(super) fn samples_by_arc_length(points: &[DVec3], closed: bool, count: usize) -> Result<Vec<DVec3>> {
    let n = points.len();
    let edges = if closed { n } else { n - 1 };
    let edge = |i: usize| points[i].distance(points[(i + 1) % n]);
    let length: f64 = (0..edges).map(edge).sum();
    let parts = if closed { count } else { count - 1 } as f64;
    let mut samples = alloc::filled(points[0], count)?;
    let (mut i, mut start) = (0, 0.0);
    for (k, sample) in samples.iter_mut().enumerate() {
        let at = length * k as f64 / parts;
        while i + 1 < edges && start + edge(i) < at {
            start += edge(i);
            i += 1;
        }
        let t = if edge(i) > 0.0 { ((at - start) / edge(i)).clamp(0.0, 1.0) } else { 0.0 };
        *sample = points[i].lerp(points[(i + 1) % n], t);
    }
    Ok(samples)
}

/// Returns the length of a polyline before each of its points; for a closed polyline also the total
/// length.
pub fn lengths(points: &[DVec3], closed: bool) -> Result<Vec<f64>> {
    let n = points.len();
    let edges = if closed { n } else { n - 1 };
    let mut along = alloc::filled(0.0, edges + 1)?;
    for i in 0..edges {
        along[i + 1] = along[i] + points[i].distance(points[(i + 1) % n]);
    }
    Ok(along)
}

/// Returns the point nearest to `p` on the two edges of a polyline that meet at point `v`.
pub fn nearest_point_on_adjacent_edges(points: &[DVec3], closed: bool, v: usize, p: DVec3) -> DVec3 {
    let n = points.len();
    let here = points[v];
    let on_edge = |other: DVec3| {
        let edge = other - here;
        let squared = edge.length_squared();
        let t = if squared > 0.0 { ((p - here).dot(edge) / squared).clamp(0.0, 1.0) } else { 0.0 };
        here + edge * t
    };
    // The ends of an open polyline have one edge only: use the end itself for the missing edge.
    let end = |at: usize| !closed && v == at;
    let before = on_edge(if end(0) { here } else { points[(v + n - 1) % n] });
    let after = on_edge(if end(n - 1) { here } else { points[(v + 1) % n] });
    if before.distance_squared(p) < after.distance_squared(p) { before } else { after }
}

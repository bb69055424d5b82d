//! Borders that intersect themselves in the plane.
//!
//! A map of a disc without folded triangles is injective if its border does not intersect itself
//! (Smith, Schaefer, section 3).

use super::STAGE;
use glam::DVec2;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_base::sort::sort;
use robust::{Coord, orient2d};

/// Counts the pairs of border edges without a common vertex that intersect, up to `enough`.
/// Touching counts and is decided exactly; with a `slack`, both edges must extend beyond the
/// crossing by more than that on both sides.
///
/// Edges are swept from left to right: O(b log b + p) for b edges and p pairs of edges that overlap
/// in x.
pub(super) fn count_border_intersections(
    border: &[[u32; 2]],
    x: &[DVec2],
    slack: f64,
    enough: u32,
    job: &Job<'_>,
) -> Result<u32> {
    let job = &job.sub_job(0.0, 0.0);
    let low = |edge: &[u32; 2]| edge.map(|v| x[v as usize].x).into_iter().fold(f64::INFINITY, f64::min);
    let high = |edge: &[u32; 2]| edge.map(|v| x[v as usize].x).into_iter().fold(f64::NEG_INFINITY, f64::max);
    let mut order = alloc::collect(0..border.len() as u32)?;
    let key = |&k: &u32| low(&border[k as usize]);
    sort(&mut order, |a, b| key(a).total_cmp(&key(b)).then(a.cmp(b)), job, STAGE)?;
    let (mut open, mut count) = (Vec::<u32>::new(), 0);
    for (done, &k) in order.iter().enumerate() {
        job.step_within_heavy_list(64, done, STAGE)?;
        let edge = border[k as usize];
        let left = low(&edge);
        open.retain(|&other| high(&border[other as usize]) >= left);
        for &other in &open {
            let other = border[other as usize];
            let is_neighbour = other.iter().any(|v| edge.contains(v));
            if !is_neighbour && segments_meet(edge.map(|v| x[v as usize]), other.map(|v| x[v as usize]), slack) {
                count += 1;
                if count == enough {
                    return Ok(count);
                }
            }
        }
        alloc::push(&mut open, k)?;
    }
    Ok(count)
}

fn segments_meet([p, q]: [DVec2; 2], [r, s]: [DVec2; 2], slack: f64) -> bool {
    let apart = |k: usize| p[k].max(q[k]) < r[k].min(s[k]) || r[k].max(s[k]) < p[k].min(q[k]);
    if apart(0) || apart(1) {
        return false;
    }
    let coord = |p: DVec2| Coord { x: p.x, y: p.y };
    // The segment ab has c and d on different sides, or one of them on its line.
    let separates = |[a, b]: [DVec2; 2], [c, d]: [DVec2; 2]| {
        let [left, right] = [c, d].map(|end| orient2d(coord(a), coord(b), coord(end)));
        let depth = slack * a.distance(b);
        let is_opposed = !(left > 0.0 && right > 0.0 || left < 0.0 && right < 0.0);
        is_opposed && (slack == 0.0 || left.abs().min(right.abs()) > depth)
    };
    separates([p, q], [r, s]) && separates([r, s], [p, q])
}

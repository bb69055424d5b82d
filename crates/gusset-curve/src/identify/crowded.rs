//! Crowded nodes: nodes that almost repeat a neighbour.
//!
//! Nodes are checked in blocks. A block whose smallest and largest distances are of similar size has no crowded
//! node, which settles nearly all blocks. O(n).

use super::outline_nodes::OutlineNodes;
use super::report::PointStatus;
use glam::DVec3;

/// A node is crowded if its distance from a neighbour is below this fraction of the smaller of the
/// distances before and after.
const MAX_TO_SMALLER_DISTANCE: f64 = 0.01;
/// The same for the larger of the distances.
const MAX_TO_LARGER_DISTANCE: f64 = 1e-4;
/// Distances that are checked together.
const DISTANCES_PER_BLOCK: usize = 32;

/// Flags the crowded nodes of an outline.
pub(super) fn flag_crowded_nodes(nodes: &mut OutlineNodes) {
    let OutlineNodes { points, results, closed, dividing_nodes: cuts, .. } = nodes;
    // A closed outline with cuts repeats its first node at the end.
    let count = points.len() - usize::from(*closed && !cuts.is_empty());
    let points = &points[..count];
    let spans = if *closed { count } else { count.saturating_sub(1) };
    if spans < 3 {
        return;
    }
    let flag = |k: usize| {
        let status = &mut results[k].status;
        if matches!(status, PointStatus::Ok | PointStatus::ClampedParameter) {
            *status = PointStatus::Crowded;
        }
    };
    let mut flag = flag;
    let closing = if *closed { points[count - 1].distance_squared(points[0]) } else { f64::NAN };
    for from in (0..spans).step_by(DISTANCES_PER_BLOCK) {
        let to = (from + DISTANCES_PER_BLOCK).min(spans);
        // The distances of the block, one before and one after it.
        let near = &points[from.saturating_sub(1)..(to + 2).min(count)];
        let (mut least, mut most) = min_and_max_squared_distance(near);
        if from == 0 || to + 1 >= spans {
            let first = points[0].distance_squared(points[1]);
            (least, most) = (least.min(closing).min(first), most.max(closing).max(first));
        }
        if least <= 1.01 * MAX_TO_SMALLER_DISTANCE * MAX_TO_SMALLER_DISTANCE * most {
            let squared = |k: usize| points[k].distance_squared(points[if k + 1 == count { 0 } else { k + 1 }]);
            for k in from..to {
                // Beyond an end of an open outline, the distances on one side count.
                let before = if k > 0 { squared(k - 1) } else { closing };
                let after = if k + 1 < spans {
                    squared(k + 1)
                } else if *closed {
                    squared(0)
                } else {
                    f64::NAN
                };
                let (here, smaller, larger) = (squared(k), before.min(after), before.max(after));
                let is_below = |fraction: f64, distance: f64| here < fraction * fraction * distance;
                if is_below(MAX_TO_SMALLER_DISTANCE, smaller) || is_below(MAX_TO_LARGER_DISTANCE, larger) {
                    flag(k);
                    flag(if k + 1 == count { 0 } else { k + 1 });
                }
            }
        }
    }
    if count < results.len() {
        results[count].status = results[0].status;
    }
}

/// Returns the smallest and the largest squared distance between consecutive points.
fn min_and_max_squared_distance(points: &[DVec3]) -> (f64, f64) {
    points.windows(2).fold((f64::INFINITY, 0.0_f64), |(least, most), pair| {
        let squared = pair[1].distance_squared(pair[0]);
        (if squared < least { squared } else { least }, if squared > most { squared } else { most })
    })
}

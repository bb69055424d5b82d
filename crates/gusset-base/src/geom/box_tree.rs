//! A bounding volume hierarchy over a list of boxes in which neighbours are close together.
//!
//! The tree is a complete binary tree over the list, without pointers. Node k has the children 2 k
//! and 2 k + 1. The leaves are the last nodes, padded with empty boxes to a power of two.
//! Consecutive parts of a curve are already in a suitable order; [`spatial_order`] orders other
//! boxes.

use super::Aabb;
use crate::alloc;
use crate::error::Result;
use crate::job::Job;
use crate::sort::{select_by_rank, select_by_rank_reported};
use glam::DVec3;

/// The tree. Takes 48 bytes a node, with at most four nodes for each leaf.
pub struct BoxTree {
    nodes: Vec<Aabb>,
    leaves: usize,
}

impl BoxTree {
    /// Builds the tree. O(n).
    pub fn new(boxes: impl ExactSizeIterator<Item = Aabb>) -> Result<Self> {
        Self::new_cancellable(boxes, &Job::default(), "")
    }

    /// [`new`](Self::new) for many boxes: the host can cancel.
    pub fn new_cancellable(
        mut boxes: impl ExactSizeIterator<Item = Aabb>,
        job: &Job<'_>,
        stage: &'static str,
    ) -> Result<Self> {
        let (count, leaves) = (boxes.len(), boxes.len().next_power_of_two());
        let mut nodes = alloc::with_capacity(2 * leaves)?;
        job.work_in_ranges(stage, leaves, |range| {
            nodes.resize(range.end, Aabb::EMPTY);
            Ok(())
        })?;
        job.work_in_ranges(stage, count, |range| {
            nodes.extend(boxes.by_ref().take(range.len()));
            Ok(())
        })?;
        job.work_in_ranges(stage, leaves - count, |range| {
            nodes.resize(nodes.len() + range.len(), Aabb::EMPTY);
            Ok(())
        })?;
        job.work_in_ranges(stage, leaves, |range| {
            for k in range.map(|k| leaves - k).filter(|&k| k < leaves) {
                nodes[k] = nodes[2 * k].union(nodes[2 * k + 1]);
            }
            Ok(())
        })?;
        Ok(BoxTree { nodes, leaves })
    }

    /// Visits the leaves whose boxes are closer to `p` than the best distance so far, the nearer
    /// child first. `leaf` receives the index of a leaf and returns the new best squared distance.
    pub fn visit_nearest(&self, p: glam::DVec3, mut best: f64, leaf: &mut impl FnMut(usize) -> f64) {
        // The stack holds at most one node of each level besides the current one.
        let mut stack = [(0usize, 0.0); 64];
        let mut len = 1;
        stack[0] = (1, self.nodes[1].distance_squared(p));
        while len > 0 {
            len -= 1;
            let (node, distance) = stack[len];
            if distance >= best {
                continue;
            }
            if node >= self.leaves {
                best = leaf(node - self.leaves);
                continue;
            }
            let [a, b] = [2 * node, 2 * node + 1].map(|k| (k, self.nodes[k].distance_squared(p)));
            let (near, far) = if a.1 <= b.1 { (a, b) } else { (b, a) };
            stack[len] = far;
            stack[len + 1] = near;
            len += 2;
        }
    }

    /// Calls `leaf` for the leaves whose boxes are within `slack` of `b` along every axis, in
    /// ascending order.
    pub fn visit_overlapping(&self, b: &Aabb, slack: f64, leaf: impl FnMut(usize) -> Result<()>) -> Result<()> {
        self.visit_accepted(|_, node| node.is_within(b, slack), leaf)
    }

    /// Calls `leaf` in ascending order for each leaf that `enter` accepts, together with all nodes
    /// above it. `enter` receives the index and box of a node.
    #[inline]
    pub fn visit_accepted(
        &self,
        enter: impl Fn(usize, &Aabb) -> bool,
        mut leaf: impl FnMut(usize) -> Result<()>,
    ) -> Result<()> {
        let mut stack = [0usize; 64];
        let mut len = 1;
        stack[0] = 1;
        while len > 0 {
            len -= 1;
            let node = stack[len];
            if !enter(node, &self.nodes[node]) {
                continue;
            }
            if node >= self.leaves {
                leaf(node - self.leaves)?;
                continue;
            }
            stack[len] = 2 * node + 1;
            stack[len + 1] = 2 * node;
            len += 2;
        }
        Ok(())
    }
}

/// Returns an order of boxes in which runs of `group`, 2 `group`, 4 `group`, ... consecutive boxes
/// are compact.
///
/// Each part is split along one axis by the lower or the upper corners of its boxes, whichever are
/// spread more. Long boxes with a common end therefore stay together, like the needles of a fan,
/// even if other boxes lie across them. The split position makes the tree over the groups complete.
/// Reports progress before each large part. O(n log n).
pub fn spatial_order(boxes: &[Aabb], group_size: usize, job: &Job<'_>, stage: &'static str) -> Result<Vec<u32>> {
    let mut order = alloc::collect((0..boxes.len()).map(|i| i as u32))?;
    let mut done = 0;
    let mut report = |count: usize| {
        job.step(done as f64 / boxes.len() as f64, stage)?;
        done += count;
        Ok(())
    };
    split_boxes(boxes, &mut order, group_size, &mut report)?;
    Ok(order)
}

/// The largest part that is split without a progress report.
const MAX_UNREPORTED_BOXES: usize = 1 << 14;

/// Splits a part recursively. Calls `report` with the number of boxes for each part of at most
/// [`MAX_UNREPORTED_BOXES`] boxes, and with 0 during larger ones.
fn split_boxes(
    boxes: &[Aabb],
    order: &mut [u32],
    group_size: usize,
    report: &mut dyn FnMut(usize) -> Result<()>,
) -> Result<()> {
    if order.len() <= MAX_UNREPORTED_BOXES {
        report(order.len())?;
        split_boxes_unreported(boxes, order, group_size);
    } else if order.len() > group_size {
        report(0)?;
        let (end, axis) = choose_split_rule(boxes, order);
        report(0)?;
        let split_position = split_position(order, group_size);
        select_by_rank_reported(order, split_position, |i| end(&boxes[i as usize])[axis], &mut || report(0))?;
        let (first, second) = order.split_at_mut(split_position);
        split_boxes(boxes, first, group_size, report)?;
        split_boxes(boxes, second, group_size, report)?;
    }
    Ok(())
}

fn split_boxes_unreported(boxes: &[Aabb], order: &mut [u32], group_size: usize) {
    if order.len() > group_size {
        let (end, axis) = choose_split_rule(boxes, order);
        let split_position = split_position(order, group_size);
        select_by_rank(order, split_position, |i| end(&boxes[i as usize])[axis]);
        let (first, second) = order.split_at_mut(split_position);
        split_boxes_unreported(boxes, first, group_size);
        split_boxes_unreported(boxes, second, group_size);
    }
}

/// One end of the boxes, and the axis along which these ends are spread most.
type SplitRule = (fn(&Aabb) -> DVec3, usize);

fn choose_split_rule(boxes: &[Aabb], order: &[u32]) -> SplitRule {
    let spread = |end: fn(&Aabb) -> DVec3| Aabb::from_points(order.iter().map(|&i| end(&boxes[i as usize]))).size();
    let ends: [fn(&Aabb) -> DVec3; 2] = [|b| b.low, |b| b.high];
    let [low, high] = ends.map(spread);
    let (end, spread) = if low.max_element() > high.max_element() { (ends[0], low) } else { (ends[1], high) };
    (end, spread.max_position())
}

/// Returns the position at which a part is split, a whole number of groups.
fn split_position(order: &[u32], group_size: usize) -> usize {
    group_size * (order.len().div_ceil(group_size).next_power_of_two() / 2)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn queries_agree_with_brute_force(
            corners in prop::collection::vec((0u8..9, 0u8..9, 0u8..9, 0u8..3, 0u8..3, 0u8..3), 1..80),
            group in 1usize..5,
        ) {
            let boxes: Vec<Aabb> = corners.iter().map(|&(x, y, z, u, v, w)| {
                let low = DVec3::new(x.into(), y.into(), z.into());
                Aabb { low, high: low + DVec3::new(u.into(), v.into(), w.into()) }
            }).collect();
            let order = spatial_order(&boxes, group, &Job::default(), "").unwrap();
            let around = |group: &[u32]| group.iter().fold(Aabb::EMPTY, |whole, &i| whole.union(boxes[i as usize]));
            let tree = BoxTree::new(order.chunks(group).map(around)).unwrap();
            for (k, query) in boxes.iter().enumerate() {
                for slack in [0.0, 1.0] {
                    let (mut leaves, mut found) = (Vec::new(), Vec::<u32>::new());
                    tree.visit_overlapping(query, slack, |leaf| {
                        leaves.push(leaf);
                        found.extend(order.chunks(group).nth(leaf).into_iter().flatten().copied());
                        Ok(())
                    }).unwrap();
                    prop_assert!(leaves.is_sorted());
                    found.retain(|&i| boxes[i as usize].is_within(query, slack));
                    found.sort_unstable();
                    let near = |&i: &u32| boxes[i as usize].is_within(query, slack);
                    prop_assert_eq!(found, (0..boxes.len() as u32).filter(near).collect::<Vec<_>>());
                }
                let point = query.high + k as f64 / 7.0;
                let mut best = f64::INFINITY;
                tree.visit_nearest(point, best, &mut |leaf| {
                    let group = order.chunks(group).nth(leaf).unwrap();
                    let distance = |&i: &u32| boxes[i as usize].distance_squared(point);
                    best = group.iter().map(distance).fold(best, f64::min);
                    best
                });
                let truth = boxes.iter().map(|b| b.distance_squared(point)).fold(f64::INFINITY, f64::min);
                prop_assert_eq!(best, truth);
            }
        }
    }
}

//! Nearest-point and range queries on a set of points: a balanced k-d tree without pointers.
//!
//! The points' indices are permuted so that the middle element of every range splits it along the
//! range's widest axis, and both halves are trees in turn (Friedman, Bentley and Finkel 1977). A
//! query skips a half if the half's cell is farther away than the best point so far. Building takes
//! O(n log n). A query takes O(log n) unless many points are equally far away.

use crate::alloc;
use crate::error::Result;
use crate::geom::Aabb;
use crate::geom::scale::common_unit;
use crate::job::Job;
use crate::sort::{select_by_rank, select_by_rank_reported};
use glam::DVec3;
use std::ops::{ControlFlow, Range};

/// Ranges of at most this many points are searched linearly.
const MAX_LEAF_POINTS: usize = 8;

/// Ranges of at most this many points are split between two progress reports.
const MAX_UNREPORTED_POINTS: usize = 1 << 15;

/// The smallest distance in `order` between the middles of two ranges that are not searched
/// linearly. The smaller such range has at least 9 points, so at least 4 on either side of its
/// middle.
const MIN_INNER_NODE_SPACING: usize = 5;

/// Marks a range whose points belong to several groups.
const SEVERAL_GROUPS: u32 = u32::MAX;

/// A set of points prepared for nearest-point queries.
pub struct KdTree<'a> {
    points: &'a [DVec3],
    order: Vec<u32>,
    /// The splitting axis of the range whose middle is at this position of `order`.
    split_axes: Vec<u8>,
    /// The common group of the range whose middle is at this position, or [`SEVERAL_GROUPS`]. Empty
    /// for a tree without groups.
    group_of_range: Vec<u32>,
    /// The smallest index in the range whose middle is at this position. Empty for a tree without
    /// groups.
    least_index_of_range: Vec<u32>,
    /// The bounding boxes of the inner ranges. The box of a range with middle index m is at m /
    /// [`MIN_INNER_NODE_SPACING`], rounded down. Empty for a tree without boxes.
    range_boxes: Vec<Aabb>,
    bounding_box: Aabb,
}

impl<'a> KdTree<'a> {
    /// Builds the tree. O(n log n); extra memory: 5 bytes a point.
    pub fn new(points: &'a [DVec3], job: &Job<'_>, stage: &'static str) -> Result<Self> {
        let mut tree = KdTree {
            points,
            order: alloc::collect((0..points.len()).map(|i| i as u32))?,
            split_axes: alloc::filled(0, points.len())?,
            group_of_range: Vec::new(),
            least_index_of_range: Vec::new(),
            range_boxes: Vec::new(),
            bounding_box: Aabb::from_points(points),
        };
        let mut done = 0;
        let mut report = |count: usize| {
            job.step(done as f64 / points.len().max(1) as f64, stage)?;
            done += count;
            Ok(())
        };
        split_points_reported(points, &mut tree.order, &mut tree.split_axes, &mut report)?;
        Ok(tree)
    }

    /// Builds a tree with bounding boxes. It suits queries far away from points that are close
    /// together, such as samples of a curve: bounding boxes discriminate where the cells do not.
    /// Takes 10 bytes a point more.
    #[inline]
    pub fn with_range_boxes(points: &'a [DVec3], job: &Job<'_>, stage: &'static str) -> Result<Self> {
        let mut tree = Self::new(points, job, stage)?;
        let mut boxes = alloc::filled(Aabb::EMPTY, points.len().div_ceil(MIN_INNER_NODE_SPACING))?;
        tree.compute_boxes_of_ranges(0..points.len(), &mut boxes);
        tree.range_boxes = boxes;
        Ok(tree)
    }

    /// Returns the points' indices in the order of the tree, in which neighbours are close
    /// together.
    #[inline]
    pub fn tree_order(&self) -> &[u32] {
        &self.order
    }

    /// Stores and returns the bounding box of a range.
    fn compute_boxes_of_ranges(&self, range: Range<usize>, out: &mut [Aabb]) -> Aabb {
        if range.len() <= MAX_LEAF_POINTS {
            return Aabb::from_points(self.order[range].iter().map(|&index| self.points[index as usize]));
        }
        let middle = usize::midpoint(range.start, range.end);
        let low = self.compute_boxes_of_ranges(range.start..middle, out);
        let high = self.compute_boxes_of_ranges(middle + 1..range.end, out);
        let mut whole = low.union(high);
        whole.add(self.points[self.order[middle] as usize]);
        out[middle / MIN_INNER_NODE_SPACING] = whole;
        whole
    }

    /// Builds a tree that also answers [`nearest_in_other_groups`](Self::nearest_in_other_groups).
    /// `groups` has the group of each point, below 2^32 - 1.
    pub fn with_groups(points: &'a [DVec3], groups: &[u32], job: &Job<'_>, stage: &'static str) -> Result<Self> {
        let mut tree = Self::new(points, job, stage)?;
        let mut group = alloc::filled(SEVERAL_GROUPS, points.len())?;
        tree.compute_groups_of_ranges(0..points.len(), groups, &mut group);
        tree.group_of_range = group;
        let mut least = alloc::filled(0, points.len())?;
        tree.compute_min_indices_of_ranges(0..points.len(), &mut least);
        tree.least_index_of_range = least;
        Ok(tree)
    }

    /// Stores and returns the smallest index of a range; [`u32::MAX`] if the range is empty.
    fn compute_min_indices_of_ranges(&self, range: Range<usize>, out: &mut [u32]) -> u32 {
        if range.is_empty() {
            return u32::MAX;
        }
        let middle = usize::midpoint(range.start, range.end);
        let low = self.compute_min_indices_of_ranges(range.start..middle, out);
        let high = self.compute_min_indices_of_ranges(middle + 1..range.end, out);
        out[middle] = low.min(high).min(self.order[middle]);
        out[middle]
    }

    /// Stores and returns the common group of a range.
    fn compute_groups_of_ranges(&self, range: Range<usize>, groups: &[u32], out: &mut [u32]) -> u32 {
        let of = |place: usize| groups[self.order[place] as usize];
        let middle = usize::midpoint(range.start, range.end);
        let whole = if range.len() <= MAX_LEAF_POINTS {
            let first = range.clone().next().map_or(SEVERAL_GROUPS, of);
            if range.clone().all(|place| of(place) == first) { first } else { SEVERAL_GROUPS }
        } else {
            let low = self.compute_groups_of_ranges(range.start..middle, groups, out);
            let high = self.compute_groups_of_ranges(middle + 1..range.end, groups, out);
            if low == high && low == of(middle) { low } else { SEVERAL_GROUPS }
        };
        if !range.is_empty() {
            out[middle] = whole;
        }
        whole
    }

    /// [`nearest`](Self::nearest) restricted to points outside the group `own`. Skips subtrees
    /// whose points all belong to `own`.
    pub fn nearest_in_other_groups(
        &self,
        query: DVec3,
        limit: f64,
        own: u32,
        accept: impl Fn(u32) -> bool,
    ) -> Option<(f64, u32)> {
        let mut best = (limit, u32::MAX);
        self.search_nearest(
            0..self.order.len(),
            query,
            self.bounding_box.axis_distances(query),
            own,
            &accept,
            &mut best,
        );
        (best.1 != u32::MAX).then_some(best)
    }

    /// Returns the nearest point that satisfies `accept` and is not farther than `limit` (squared),
    /// as (squared distance, index). Breaks ties by the smallest index.
    pub fn nearest(&self, query: DVec3, limit: f64, accept: impl Fn(u32) -> bool) -> Option<(f64, u32)> {
        self.nearest_in_other_groups(query, limit, SEVERAL_GROUPS, accept)
    }

    /// Searches a range of `order`. `off` is the vector from the range's cell to the query, whose
    /// length bounds the distance of every point of the range from below. Skips ranges of group
    /// `own`.
    fn search_nearest(
        &self,
        range: Range<usize>,
        query: DVec3,
        off: DVec3,
        own: u32,
        accept: &impl Fn(u32) -> bool,
        best: &mut (f64, u32),
    ) {
        let middle = usize::midpoint(range.start, range.end);
        if own != SEVERAL_GROUPS && self.group_of_range.get(middle) == Some(&own) {
            return;
        }
        // If the points coincide, skip ranges that cannot improve the index.
        if self.least_index_of_range.get(middle).is_some_and(|&least| least >= best.1) && off.length_squared() >= best.0
        {
            return;
        }
        // Testing the points of a leaf costs no more than testing its box.
        if !self.range_boxes.is_empty()
            && range.len() > MAX_LEAF_POINTS
            && let Some(around) = self.range_boxes.get(middle / MIN_INNER_NODE_SPACING)
            && around.distance_squared(query) > best.0
        {
            return;
        }
        let mut visit = |index: u32| {
            let candidate = (self.points[index as usize].distance_squared(query), index);
            if candidate < *best && accept(index) {
                *best = candidate;
            }
        };
        if range.len() <= MAX_LEAF_POINTS {
            self.order[range].iter().for_each(|&index| visit(index));
            return;
        }
        visit(self.order[middle]);
        let axis = self.split_axes[middle] as usize;
        let offset = query[axis] - self.points[self.order[middle] as usize][axis];
        let (low, high) = (range.start..middle, middle + 1..range.end);
        let (near, far) = if offset <= 0.0 { (low, high) } else { (high, low) };
        self.search_nearest(near, query, off, own, accept, best);
        let mut beyond = off;
        beyond[axis] = offset.abs().max(off[axis]);
        // Not `<`: an equally near point of smaller index may lie beyond.
        if beyond.length_squared() <= best.0 {
            self.search_nearest(far, query, beyond, own, accept, best);
        }
    }
}

impl KdTree<'_> {
    /// Calls `visit` with (squared distance in units of the reach, index) for every point within
    /// `reach` of the query, in unspecified order. O(log n) for each point found.
    pub fn for_each_within(&self, query: DVec3, reach: ScaledRadius, visit: &mut impl FnMut(f64, u32)) {
        let _ = self.try_for_each_within(query, reach, &mut |squared, index| {
            visit(squared, index);
            ControlFlow::Continue(())
        });
    }

    /// [`for_each_within`](Self::for_each_within), until `visit` breaks.
    pub fn try_for_each_within(
        &self,
        query: DVec3,
        reach: ScaledRadius,
        visit: &mut impl FnMut(f64, u32) -> ControlFlow<()>,
    ) -> ControlFlow<()> {
        self.try_for_each_of_range_within(0..self.order.len(), query, reach, visit)
    }

    fn try_for_each_of_range_within(
        &self,
        range: Range<usize>,
        query: DVec3,
        reach: ScaledRadius,
        visit: &mut impl FnMut(f64, u32) -> ControlFlow<()>,
    ) -> ControlFlow<()> {
        let mut test = |index: u32| {
            let squared = reach.scaled_length_squared(self.points[index as usize] - query);
            if squared <= reach.limit { visit(squared, index) } else { ControlFlow::Continue(()) }
        };
        if range.len() <= MAX_LEAF_POINTS {
            return self.order[range].iter().try_for_each(|&index| test(index));
        }
        let middle = usize::midpoint(range.start, range.end);
        test(self.order[middle])?;
        let axis = self.split_axes[middle] as usize;
        let offset = self.points[self.order[middle] as usize][axis] - query[axis];
        let near = reach.scaled_length_squared(DVec3::new(offset, 0.0, 0.0)) <= reach.limit;
        if near || offset >= 0.0 {
            self.try_for_each_of_range_within(range.start..middle, query, reach, visit)?;
        }
        if near || offset <= 0.0 {
            self.try_for_each_of_range_within(middle + 1..range.end, query, reach, visit)?;
        }
        ControlFlow::Continue(())
    }
}

/// A distance scaled by a power of two close to its own size, so that its square neither overflows
/// nor underflows.
#[derive(Clone, Copy)]
pub struct ScaledRadius {
    unit: f64,
    limit: f64,
}

impl ScaledRadius {
    /// `distance` must be finite and positive.
    #[inline]
    pub fn new(distance: f64) -> Self {
        let unit = common_unit(&[DVec3::splat(distance)]);
        ScaledRadius { unit, limit: (distance / unit) * (distance / unit) }
    }

    /// Returns true if the vector is at most as long as the radius.
    #[inline]
    pub fn contains(self, difference: DVec3) -> bool {
        self.scaled_length_squared(difference) <= self.limit
    }

    /// Returns the scaled squared length of a vector; infinite if it overflows.
    fn scaled_length_squared(self, difference: DVec3) -> f64 {
        (difference / self.unit).length_squared()
    }
}

/// Splits a range recursively. Calls `report` for every large range, with the number of points that
/// are split without further reports.
fn split_points_reported(
    points: &[DVec3],
    order: &mut [u32],
    axes: &mut [u8],
    report: &mut impl FnMut(usize) -> Result<()>,
) -> Result<()> {
    if order.len() <= MAX_UNREPORTED_POINTS {
        report(order.len())?;
        split_points(points, order, axes);
        return Ok(());
    }
    report(1)?;
    let axis = longest_axis(points, order);
    report(0)?;
    let middle = order.len() / 2;
    select_by_rank_reported(order, middle, |i| points[i as usize][axis], &mut || report(0))?;
    let [(left, left_axes), (right, right_axes)] = halves_around_middle(order, axes, axis);
    split_points_reported(points, left, left_axes, report)?;
    split_points_reported(points, right, right_axes, report)
}

fn split_points(points: &[DVec3], order: &mut [u32], axes: &mut [u8]) {
    if order.len() > MAX_LEAF_POINTS {
        let axis = longest_axis(points, order);
        select_by_rank(order, order.len() / 2, |i| points[i as usize][axis]);
        halves_around_middle(order, axes, axis).into_iter().for_each(|(order, axes)| split_points(points, order, axes));
    }
}

/// Returns the axis along which the points of a range are spread most.
fn longest_axis(points: &[DVec3], order: &[u32]) -> usize {
    Aabb::from_points(order.iter().map(|&i| points[i as usize])).size().max_position()
}

/// Returns the halves on either side of the middle of a range. Stores `axis` as the splitting axis
/// of the middle.
fn halves_around_middle<'a>(
    order: &'a mut [u32],
    split_axes: &'a mut [u8],
    axis: usize,
) -> [(&'a mut [u32], &'a mut [u8]); 2] {
    let middle = order.len() / 2;
    split_axes[middle] = axis as u8;
    let (left, right) = order.split_at_mut(middle);
    let (left_axes, right_axes) = split_axes.split_at_mut(middle);
    [(left, left_axes), (&mut right[1..], &mut right_axes[1..])]
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn nearest_agrees_with_brute_force(
            // A coarse lattice makes equal distances common and so tests the tie rule.
            cells in prop::collection::vec((0u8..6, 0u8..6, 0u8..6), 1..200),
            query in (0u8..13, 0u8..13, 0u8..13),
            skip in 1u32..5,
        ) {
            let points: Vec<DVec3> =
                cells.iter().map(|&(x, y, z)| DVec3::new(f64::from(x), f64::from(y), f64::from(z))).collect();
            let query = DVec3::new(f64::from(query.0), f64::from(query.1), f64::from(query.2)) / 2.0;
            let nearest = |accept: &dyn Fn(u32) -> bool| {
                let accepted = (0..points.len() as u32).filter(|&i| accept(i));
                let distances = accepted.map(|i| (points[i as usize].distance_squared(query), i));
                distances.min_by(|a, b| a.partial_cmp(b).unwrap())
            };
            let accept = |i: u32| i.is_multiple_of(skip);
            let expected = nearest(&accept);
            let tree = KdTree::new(&points, &Job::default(), "").unwrap();
            prop_assert_eq!(tree.nearest(query, f64::INFINITY, accept), expected);
            let with_boxes = KdTree::with_range_boxes(&points, &Job::default(), "").unwrap();
            prop_assert_eq!(with_boxes.nearest(query, f64::INFINITY, accept), expected);
            // Groups of neighbours, so that whole subtrees belong to one group.
            let groups: Vec<u32> = points.iter().map(|p| p.x as u32 / 2).collect();
            let tree = KdTree::with_groups(&points, &groups, &Job::default(), "").unwrap();
            for own in 0..4 {
                let accept = |i: u32| accept(i) && groups[i as usize] != own;
                prop_assert_eq!(tree.nearest_in_other_groups(query, f64::INFINITY, own, accept), nearest(&accept));
            }
            for (reach, unit) in [(0.5, 1.0), (1.0, 2f64.powi(-980)), (1.5, 2f64.powi(900)), (3.0, 1.0)] {
                let scaled: Vec<DVec3> = points.iter().map(|&p| p * unit).collect();
                let mut found = Vec::new();
                let tree = KdTree::new(&scaled, &Job::default(), "").unwrap();
                tree.for_each_within(query * unit, ScaledRadius::new(reach * unit), &mut |_, i| found.push(i));
                found.sort_unstable();
                // Lattice points in a unit that is a power of two: nothing is rounded.
                let close = |&i: &u32| points[i as usize].distance(query) <= reach;
                prop_assert_eq!(found, (0..points.len() as u32).filter(close).collect::<Vec<_>>());
            }
        }
    }
}

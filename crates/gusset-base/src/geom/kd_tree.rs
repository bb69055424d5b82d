//! Nearest point of a set, and all points within a distance: a balanced k-d tree without pointers.
//!
//! The points' indices are permuted so that the middle element of every range splits it by the
//! range's widest axis, and the two halves are trees in turn (Friedman, Bentley and Finkel 1977).
//! No point of a half is nearer than its cell, so that a half whose cell is farther than the best
//! point so far is left out. Building takes O(n log n), a query O(log n) for points that are not
//! all equidistant.

use crate::alloc;
use crate::error::Result;
use crate::geom::Aabb;
use crate::geom::scale::common_unit;
use crate::job::Job;
use crate::sort::{select, select_reported};
use glam::DVec3;
use std::ops::{ControlFlow, Range};

/// Ranges of at most this many points are searched one by one.
const MAX_LEAF_POINTS: usize = 8;

/// Ranges of at most this many points are split between two progress reports.
const MAX_UNREPORTED: usize = 1 << 15;

/// The middles of ranges that are not searched one by one are this far from each other at least:
/// the smaller range, of 9 points or more, has 4 on either side of its own, and ends beside the
/// other.
const MIN_MIDDLE_DISTANCE: usize = 5;

/// Points of several groups.
const MIXED: u32 = u32::MAX;

/// A set of points that answers nearest-point queries.
pub struct KdTree<'a> {
    points: &'a [DVec3],
    order: Vec<u32>,
    /// The splitting axis of the range whose middle is at this place of `order`.
    axis: Vec<u8>,
    /// The group of all points of the range whose middle is at this place, or [`MIXED`]; empty if
    /// there are no groups.
    group: Vec<u32>,
    /// The smallest index of the range whose middle is at this place; empty if there are no groups.
    least: Vec<u32>,
    /// The box round all points of the range whose middle is at [`MIN_MIDDLE_DISTANCE`] times this
    /// place, or up to 4 beyond; empty if there are none.
    boxes: Vec<Aabb>,
    whole: Aabb,
}

impl<'a> KdTree<'a> {
    /// Extra memory: 5 bytes a point. O(n log n).
    pub fn new(points: &'a [DVec3], job: &Job<'_>, stage: &'static str) -> Result<Self> {
        let mut tree = KdTree {
            points,
            order: alloc::collect((0..points.len()).map(|i| i as u32))?,
            axis: alloc::filled(0, points.len())?,
            group: Vec::new(),
            least: Vec::new(),
            boxes: Vec::new(),
            whole: Aabb::of(points),
        };
        let mut done = 0;
        let mut report = |count: usize| {
            job.step(done as f64 / points.len().max(1) as f64, stage)?;
            done += count;
            Ok(())
        };
        split_reported(points, &mut tree.order, &mut tree.axis, &mut report)?;
        Ok(tree)
    }

    /// A tree for queries that are far away from points which are close together, such as those of
    /// a curve: what cells do not tell apart, boxes that fit do. 10 bytes a point more.
    #[inline]
    pub fn boxed(points: &'a [DVec3], job: &Job<'_>, stage: &'static str) -> Result<Self> {
        let mut tree = Self::new(points, job, stage)?;
        let mut boxes = alloc::filled(Aabb::EMPTY, points.len().div_ceil(MIN_MIDDLE_DISTANCE))?;
        tree.find_boxes(0..points.len(), &mut boxes);
        tree.boxes = boxes;
        Ok(tree)
    }

    /// The points' indices in the order of the tree: neighbours are near each other.
    #[inline]
    pub fn order(&self) -> &[u32] {
        &self.order
    }

    /// Enters and returns the box of a range.
    fn find_boxes(&self, range: Range<usize>, out: &mut [Aabb]) -> Aabb {
        if range.len() <= MAX_LEAF_POINTS {
            return Aabb::of(self.order[range].iter().map(|&index| self.points[index as usize]));
        }
        let middle = usize::midpoint(range.start, range.end);
        let low = self.find_boxes(range.start..middle, out);
        let high = self.find_boxes(middle + 1..range.end, out);
        let mut whole = low.union(high);
        whole.add(self.points[self.order[middle] as usize]);
        out[middle / MIN_MIDDLE_DISTANCE] = whole;
        whole
    }

    /// A tree that also answers [`nearest_elsewhere`](Self::nearest_elsewhere): each point is of
    /// one of the `groups`, all below 2^32 - 1.
    pub fn grouped(points: &'a [DVec3], groups: &[u32], job: &Job<'_>, stage: &'static str) -> Result<Self> {
        let mut tree = Self::new(points, job, stage)?;
        let mut group = alloc::filled(MIXED, points.len())?;
        tree.find_groups(0..points.len(), groups, &mut group);
        tree.group = group;
        let mut least = alloc::filled(0, points.len())?;
        tree.find_least(0..points.len(), &mut least);
        tree.least = least;
        Ok(tree)
    }

    /// Enters and returns the smallest index of a range; [`u32::MAX`] of none.
    fn find_least(&self, range: Range<usize>, out: &mut [u32]) -> u32 {
        if range.is_empty() {
            return u32::MAX;
        }
        let middle = usize::midpoint(range.start, range.end);
        let low = self.find_least(range.start..middle, out);
        let high = self.find_least(middle + 1..range.end, out);
        out[middle] = low.min(high).min(self.order[middle]);
        out[middle]
    }

    /// Enters and returns the group that all of a range is of.
    fn find_groups(&self, range: Range<usize>, groups: &[u32], out: &mut [u32]) -> u32 {
        let of = |place: usize| groups[self.order[place] as usize];
        let middle = usize::midpoint(range.start, range.end);
        let whole = if range.len() <= MAX_LEAF_POINTS {
            let first = range.clone().next().map_or(MIXED, of);
            if range.clone().all(|place| of(place) == first) { first } else { MIXED }
        } else {
            let low = self.find_groups(range.start..middle, groups, out);
            let high = self.find_groups(middle + 1..range.end, groups, out);
            if low == high && low == of(middle) { low } else { MIXED }
        };
        if !range.is_empty() {
            out[middle] = whole;
        }
        whole
    }

    /// As [`nearest`](Self::nearest), among the points that are of another group than `own`; parts
    /// of the tree that are all of it are passed over.
    pub fn nearest_elsewhere(
        &self,
        query: DVec3,
        limit: f64,
        own: u32,
        accept: impl Fn(u32) -> bool,
    ) -> Option<(f64, u32)> {
        let mut best = (limit, u32::MAX);
        self.search(0..self.order.len(), query, self.whole.outside(query), own, &accept, &mut best);
        (best.1 != u32::MAX).then_some(best)
    }

    /// The nearest point that `accept`s, as (squared distance, index), among those not farther than
    /// `limit` (squared); of equally near ones the smallest index.
    pub fn nearest(&self, query: DVec3, limit: f64, accept: impl Fn(u32) -> bool) -> Option<(f64, u32)> {
        self.nearest_elsewhere(query, limit, MIXED, accept)
    }

    /// Searches a range of `order`. `off` is how far the query lies outside the range's cell along
    /// each axis: no point of the range is nearer than its length. Ranges of group `own` are passed
    /// over.
    fn search(
        &self,
        range: Range<usize>,
        query: DVec3,
        off: DVec3,
        own: u32,
        accept: &impl Fn(u32) -> bool,
        best: &mut (f64, u32),
    ) {
        let middle = usize::midpoint(range.start, range.end);
        if own != MIXED && self.group.get(middle) == Some(&own) {
            return;
        }
        // Of points that lie in one, the smallest index is looked for among those with smaller ones.
        if self.least.get(middle).is_some_and(|&least| least >= best.1) && off.length_squared() >= best.0 {
            return;
        }
        // The points of a leaf are no more work than its box.
        if !self.boxes.is_empty()
            && range.len() > MAX_LEAF_POINTS
            && let Some(around) = self.boxes.get(middle / MIN_MIDDLE_DISTANCE)
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
        let axis = self.axis[middle] as usize;
        let offset = query[axis] - self.points[self.order[middle] as usize][axis];
        let (low, high) = (range.start..middle, middle + 1..range.end);
        let (near, far) = if offset <= 0.0 { (low, high) } else { (high, low) };
        self.search(near, query, off, own, accept, best);
        let mut beyond = off;
        beyond[axis] = offset.abs().max(off[axis]);
        // Not `<`: an equally near point of smaller index may lie beyond.
        if beyond.length_squared() <= best.0 {
            self.search(far, query, beyond, own, accept, best);
        }
    }
}

impl KdTree<'_> {
    /// Calls `visit` with (squared distance in units of the reach, index) of every point within
    /// `reach` of the query, in no particular order. O(log n) for each point found.
    pub fn for_each_within(&self, query: DVec3, reach: Radius, visit: &mut impl FnMut(f64, u32)) {
        let _ = self.visit_within(query, reach, &mut |squared, index| {
            visit(squared, index);
            ControlFlow::Continue(())
        });
    }

    /// The same, until `visit` breaks off.
    pub fn visit_within(
        &self,
        query: DVec3,
        reach: Radius,
        visit: &mut impl FnMut(f64, u32) -> ControlFlow<()>,
    ) -> ControlFlow<()> {
        self.search_within(0..self.order.len(), query, reach, visit)
    }

    fn search_within(
        &self,
        range: Range<usize>,
        query: DVec3,
        reach: Radius,
        visit: &mut impl FnMut(f64, u32) -> ControlFlow<()>,
    ) -> ControlFlow<()> {
        let mut test = |index: u32| {
            let squared = reach.squared(self.points[index as usize] - query);
            if squared <= reach.limit { visit(squared, index) } else { ControlFlow::Continue(()) }
        };
        if range.len() <= MAX_LEAF_POINTS {
            return self.order[range].iter().try_for_each(|&index| test(index));
        }
        let middle = usize::midpoint(range.start, range.end);
        test(self.order[middle])?;
        let axis = self.axis[middle] as usize;
        let offset = self.points[self.order[middle] as usize][axis] - query[axis];
        let near = reach.squared(DVec3::new(offset, 0.0, 0.0)) <= reach.limit;
        if near || offset >= 0.0 {
            self.search_within(range.start..middle, query, reach, visit)?;
        }
        if near || offset <= 0.0 {
            self.search_within(middle + 1..range.end, query, reach, visit)?;
        }
        ControlFlow::Continue(())
    }
}

/// A distance, held so that its square neither overflows nor vanishes: in a power-of-two unit of
/// its own size.
#[derive(Clone, Copy)]
pub struct Radius {
    unit: f64,
    limit: f64,
}

impl Radius {
    /// `distance` is finite and positive.
    #[inline]
    pub fn new(distance: f64) -> Self {
        let unit = common_unit(&[DVec3::splat(distance)]);
        Radius { unit, limit: (distance / unit) * (distance / unit) }
    }

    /// True if a difference of points is no longer.
    #[inline]
    pub fn contains(self, difference: DVec3) -> bool {
        self.squared(difference) <= self.limit
    }

    /// The squared length of a difference of points; infinite if it is that much longer.
    fn squared(self, difference: DVec3) -> f64 {
        (difference / self.unit).length_squared()
    }
}

/// Splits a range and its halves; `report` is called for every large one, with the number of points
/// that it sees to alone.
fn split_reported(
    points: &[DVec3],
    order: &mut [u32],
    axes: &mut [u8],
    report: &mut impl FnMut(usize) -> Result<()>,
) -> Result<()> {
    if order.len() <= MAX_UNREPORTED {
        report(order.len())?;
        split(points, order, axes);
        return Ok(());
    }
    report(1)?;
    let axis = longest_axis(points, order);
    report(0)?;
    let middle = order.len() / 2;
    select_reported(order, middle, |i| points[i as usize][axis], &mut || report(0))?;
    let [(left, left_axes), (right, right_axes)] = halves(order, axes, axis);
    split_reported(points, left, left_axes, report)?;
    split_reported(points, right, right_axes, report)
}

fn split(points: &[DVec3], order: &mut [u32], axes: &mut [u8]) {
    if order.len() > MAX_LEAF_POINTS {
        let axis = longest_axis(points, order);
        select(order, order.len() / 2, |i| points[i as usize][axis]);
        halves(order, axes, axis).into_iter().for_each(|(order, axes)| split(points, order, axes));
    }
}

/// The axis along which the points of a range are spread most.
fn longest_axis(points: &[DVec3], order: &[u32]) -> usize {
    Aabb::of(order.iter().map(|&i| points[i as usize])).size().max_position()
}

/// The halves on either side of the middle of a range, which is at its place along an axis.
fn halves<'a>(order: &'a mut [u32], axes: &'a mut [u8], axis: usize) -> [(&'a mut [u32], &'a mut [u8]); 2] {
    let middle = order.len() / 2;
    axes[middle] = axis as u8;
    let (left, right) = order.split_at_mut(middle);
    let (left_axes, right_axes) = axes.split_at_mut(middle);
    [(left, left_axes), (&mut right[1..], &mut right_axes[1..])]
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn equals_brute_force(
            // A coarse lattice, so that equal distances are common and the tie rule is tested.
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
            let boxed = KdTree::boxed(&points, &Job::default(), "").unwrap();
            prop_assert_eq!(boxed.nearest(query, f64::INFINITY, accept), expected);
            // Groups of neighbours, so that whole parts of the tree are of one.
            let groups: Vec<u32> = points.iter().map(|p| p.x as u32 / 2).collect();
            let tree = KdTree::grouped(&points, &groups, &Job::default(), "").unwrap();
            for own in 0..4 {
                let accept = |i: u32| accept(i) && groups[i as usize] != own;
                prop_assert_eq!(tree.nearest_elsewhere(query, f64::INFINITY, own, accept), nearest(&accept));
            }
            for (reach, unit) in [(0.5, 1.0), (1.0, 2f64.powi(-980)), (1.5, 2f64.powi(900)), (3.0, 1.0)] {
                let scaled: Vec<DVec3> = points.iter().map(|&p| p * unit).collect();
                let mut found = Vec::new();
                let tree = KdTree::new(&scaled, &Job::default(), "").unwrap();
                tree.for_each_within(query * unit, Radius::new(reach * unit), &mut |_, i| found.push(i));
                found.sort_unstable();
                // On a lattice, in a power of two: nothing is rounded.
                let close = |&i: &u32| points[i as usize].distance(query) <= reach;
                prop_assert_eq!(found, (0..points.len() as u32).filter(close).collect::<Vec<_>>());
            }
        }
    }
}

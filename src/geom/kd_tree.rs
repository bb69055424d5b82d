//! Nearest point of a set: a balanced k-d tree without pointers.
//!
//! The points' indices are permuted so that the middle element of every range splits it by the range's widest axis, and
//! the two halves are trees in turn. Building takes O(n log n), a query O(log n) for points that are not all equidistant.

use crate::alloc;
use crate::error::Result;
use glam::DVec3;

/// Ranges of at most this many points are searched one by one.
const LEAF: usize = 8;

/// A set of points that answers nearest-point queries.
pub(crate) struct KdTree<'a> {
    points: &'a [DVec3],
    order: Vec<u32>,
    /// The splitting axis of the range whose middle is at this place of `order`.
    axis: Vec<u8>,
}

impl<'a> KdTree<'a> {
    /// Extra memory: 5 bytes a point.
    pub(crate) fn new(points: &'a [DVec3]) -> Result<Self> {
        let mut tree = KdTree {
            points,
            order: alloc::collect((0..points.len()).map(|i| i as u32))?,
            axis: alloc::filled(0, points.len())?,
        };
        split(points, &mut tree.order, &mut tree.axis);
        Ok(tree)
    }

    /// The nearest point that `accept`s, as (squared distance, index), among those not farther than `limit` (squared); of
    /// equally near ones the smallest index.
    pub(crate) fn nearest(&self, query: DVec3, limit: f64, accept: impl Fn(u32) -> bool) -> Option<(f64, u32)> {
        let mut best = (limit, u32::MAX);
        self.search(0, self.order.len(), query, &accept, &mut best);
        (best.1 != u32::MAX).then_some(best)
    }

    fn search(&self, from: usize, to: usize, query: DVec3, accept: &impl Fn(u32) -> bool, best: &mut (f64, u32)) {
        let mut visit = |index: u32| {
            let candidate = (self.points[index as usize].distance_squared(query), index);
            if candidate < *best && accept(index) {
                *best = candidate;
            }
        };
        if to - from <= LEAF {
            self.order[from..to].iter().for_each(|&index| visit(index));
            return;
        }
        let middle = usize::midpoint(from, to);
        visit(self.order[middle]);
        let axis = self.axis[middle] as usize;
        let offset = query[axis] - self.points[self.order[middle] as usize][axis];
        let (near, far) =
            if offset <= 0.0 { ((from, middle), (middle + 1, to)) } else { ((middle + 1, to), (from, middle)) };
        self.search(near.0, near.1, query, accept, best);
        // Not `<`: an equally near point of smaller index may lie beyond.
        if offset * offset <= best.0 {
            self.search(far.0, far.1, query, accept, best);
        }
    }
}

fn split(points: &[DVec3], order: &mut [u32], axes: &mut [u8]) {
    if order.len() <= LEAF {
        return;
    }
    let (mut low, mut high) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
    for &i in order.iter() {
        low = low.min(points[i as usize]);
        high = high.max(points[i as usize]);
    }
    let axis = (high - low).max_position();
    let middle = order.len() / 2;
    order.select_nth_unstable_by(middle, |&i, &j| {
        points[i as usize][axis].total_cmp(&points[j as usize][axis]).then(i.cmp(&j))
    });
    axes[middle] = axis as u8;
    let (left, right) = order.split_at_mut(middle);
    let (left_axes, right_axes) = axes.split_at_mut(middle);
    split(points, left, left_axes);
    split(points, &mut right[1..], &mut right_axes[1..]);
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
            let accept = |i: u32| i.is_multiple_of(skip);
            let expected = (0..points.len() as u32)
                .filter(|&i| accept(i))
                .map(|i| (points[i as usize].distance_squared(query), i))
                .min_by(|a, b| a.partial_cmp(b).unwrap());
            let tree = KdTree::new(&points).unwrap();
            prop_assert_eq!(tree.nearest(query, f64::INFINITY, accept), expected);
        }
    }
}

//! Boxes that overlap a box: a balanced tree without pointers.
//!
//! The boxes are permuted so that every range of them is split in the middle, by their centres along the widest axis. The
//! nodes lie in depth-first order: the left child follows its parent, the right one is where the parent says.

use crate::alloc;
use crate::error::Result;
use crate::geom::Aabb;
use std::ops::Range;

/// Ranges of at most this many boxes are leaves.
const LEAF: usize = 4;

/// A set of boxes.
pub(super) struct BoxTree<'a> {
    boxes: &'a [Aabb],
    order: Vec<u32>,
    /// The boxes of the nodes in depth-first order, and each one's right child.
    nodes: Vec<(Aabb, u32)>,
}

impl<'a> BoxTree<'a> {
    /// O(n log n); extra memory about 60 bytes a box.
    pub(super) fn new(boxes: &'a [Aabb]) -> Result<Self> {
        let mut tree = BoxTree {
            boxes,
            order: alloc::collect((0..boxes.len()).map(|i| i as u32))?,
            // Leaves have more than half of LEAF boxes, but for a tree of one.
            nodes: alloc::with_capacity(boxes.len() + 1)?,
        };
        tree.split(0..boxes.len());
        Ok(tree)
    }

    fn split(&mut self, range: Range<usize>) {
        let whole = self.order[range.clone()].iter().fold(Aabb::EMPTY, |b, &i| b.union(self.boxes[i as usize]));
        let node = self.nodes.len();
        self.nodes.push((whole, 0));
        if range.len() <= LEAF {
            return;
        }
        let axis = whole.size().max_position();
        let middle = range.len() / 2;
        let boxes = self.boxes;
        let centre = |i: u32| boxes[i as usize].low[axis] + boxes[i as usize].high[axis];
        self.order[range.clone()]
            .select_nth_unstable_by(middle, |&i, &j| centre(i).total_cmp(&centre(j)).then(i.cmp(&j)));
        self.split(range.start..range.start + middle);
        self.nodes[node].1 = self.nodes.len() as u32;
        self.split(range.start + middle..range.end);
    }

    /// The box round everything.
    pub(super) fn whole(&self) -> &Aabb {
        &self.nodes[0].0
    }

    /// Visits the boxes that overlap `query`.
    pub(super) fn overlapping(&self, query: &Aabb, visit: &mut impl FnMut(u32)) {
        self.search(0..self.order.len(), 0, query, visit);
    }

    fn search(&self, range: Range<usize>, node: usize, query: &Aabb, visit: &mut impl FnMut(u32)) {
        let (whole, right) = &self.nodes[node];
        if !whole.overlaps(query) {
            return;
        }
        if range.len() <= LEAF {
            let overlap = |&&i: &&u32| self.boxes[i as usize].overlaps(query);
            self.order[range].iter().filter(overlap).for_each(|&i| visit(i));
            return;
        }
        let middle = range.len() / 2;
        self.search(range.start..range.start + middle, node + 1, query, visit);
        self.search(range.start + middle..range.end, *right as usize, query, visit);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn equals_brute_force(
            corners in prop::collection::vec((0u8..9, 0u8..9, 0u8..9, 0u8..3, 0u8..3, 0u8..3), 1..80),
        ) {
            let boxes: Vec<Aabb> = corners.iter().map(|&(x, y, z, u, v, w)| {
                let low = DVec3::new(f64::from(x), f64::from(y), f64::from(z));
                Aabb { low, high: low + DVec3::new(f64::from(u), f64::from(v), f64::from(w)) }
            }).collect();
            let tree = BoxTree::new(&boxes).unwrap();
            for query in &boxes {
                let mut found = Vec::new();
                tree.overlapping(query, &mut |i| found.push(i));
                found.sort_unstable();
                let expected: Vec<u32> = (0..boxes.len() as u32).filter(|&i| boxes[i as usize].overlaps(query)).collect();
                prop_assert_eq!(found, expected);
            }
        }
    }
}

//! Boxes round consecutive things, and boxes round those: which of them can matter is found without looking at all.
//!
//! Neighbours on a curve are neighbours in space, so the tree is the plain binary one over the order: node k has the children
//! 2 k and 2 k + 1, and the leaves are the last nodes.

use crate::alloc;
use crate::error::Result;
use glam::DVec3;

/// An axis-aligned box; the empty one has its ends at infinity.
#[derive(Debug, Clone, Copy)]
pub(super) struct Aabb {
    pub(super) low: DVec3,
    pub(super) high: DVec3,
}

impl Aabb {
    pub(super) const EMPTY: Aabb = Aabb { low: DVec3::INFINITY, high: DVec3::NEG_INFINITY };

    pub(super) fn of(points: &[DVec3]) -> Self {
        points.iter().fold(Self::EMPTY, |b, &p| Aabb { low: b.low.min(p), high: b.high.max(p) })
    }

    fn and(&self, other: &Aabb) -> Self {
        Aabb { low: self.low.min(other.low), high: self.high.max(other.high) }
    }

    /// The square of the distance to a point; infinite for the empty box.
    pub(super) fn distance_squared(&self, p: DVec3) -> f64 {
        (self.low - p).max(p - self.high).max(DVec3::ZERO).length_squared()
    }

    /// Whether the boxes come nearer than `slack` to each other along every axis.
    pub(super) fn near(&self, other: &Aabb, slack: f64) -> bool {
        (self.low - other.high).max(other.low - self.high).max_element() <= slack
    }

    /// The longest side.
    pub(super) fn size(&self) -> f64 {
        (self.high - self.low).max_element()
    }
}

/// The tree.
pub(super) struct Tree {
    nodes: Vec<Aabb>,
    leaves: usize,
}

impl Tree {
    /// O(n).
    pub(super) fn new(boxes: impl ExactSizeIterator<Item = Aabb>) -> Result<Self> {
        let leaves = boxes.len().next_power_of_two();
        let mut nodes = alloc::filled(Aabb::EMPTY, 2 * leaves)?;
        for (node, b) in nodes[leaves..].iter_mut().zip(boxes) {
            *node = b;
        }
        for k in (1..leaves).rev() {
            nodes[k] = nodes[2 * k].and(&nodes[2 * k + 1]);
        }
        Ok(Tree { nodes, leaves })
    }

    /// Goes down to the leaves whose boxes are nearer to `p` than the best so far, the nearer child first. `leaf` is given
    /// the leaf, and returns the square of the best distance.
    pub(super) fn nearest(&self, p: DVec3, mut best: f64, leaf: &mut impl FnMut(usize) -> f64) {
        // At most one node a level waits, beside the one at work.
        let mut waiting = [(0usize, 0.0); 64];
        let mut len = 1;
        waiting[0] = (1, self.nodes[1].distance_squared(p));
        while len > 0 {
            len -= 1;
            let (node, distance) = waiting[len];
            if distance >= best {
                continue;
            }
            if node >= self.leaves {
                best = leaf(node - self.leaves);
                continue;
            }
            let [a, b] = [2 * node, 2 * node + 1].map(|k| (k, self.nodes[k].distance_squared(p)));
            let (near, far) = if a.1 <= b.1 { (a, b) } else { (b, a) };
            waiting[len] = far;
            waiting[len + 1] = near;
            len += 2;
        }
    }

    /// Calls `leaf` for the leaves whose boxes come nearer than `slack` to `b`, in ascending order.
    pub(super) fn overlapping(&self, b: &Aabb, slack: f64, mut leaf: impl FnMut(usize) -> Result<()>) -> Result<()> {
        let mut waiting = [0usize; 64];
        let mut len = 1;
        waiting[0] = 1;
        while len > 0 {
            len -= 1;
            let node = waiting[len];
            if !self.nodes[node].near(b, slack) {
                continue;
            }
            if node >= self.leaves {
                leaf(node - self.leaves)?;
                continue;
            }
            waiting[len] = 2 * node + 1;
            waiting[len + 1] = 2 * node;
            len += 2;
        }
        Ok(())
    }
}

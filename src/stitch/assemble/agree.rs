//! Consistent orientation of components across gaps: a union-find with parity over the pairs of
//! loops, nearest first; a pair that contradicts those before it is refused.

use crate::alloc;
use crate::error::Result;

/// Sets of components whose orientations are bound to each other: a union-find structure that knows for each element whether
/// it is turned against its root, which is the smallest of the set.
pub(super) struct Agreement {
    up: Vec<u32>,
    turned: Vec<bool>,
}

impl Agreement {
    /// `count` components that know nothing of each other.
    pub(super) fn new(count: usize) -> Result<Self> {
        Ok(Agreement { up: alloc::collect((0..count).map(|i| i as u32))?, turned: alloc::filled(false, count)? })
    }

    /// The root of the set of `i`, and whether `i` is turned against it. Nearly constant time.
    pub(super) fn root(&mut self, i: u32) -> (u32, bool) {
        let (mut root, mut turned) = (i, false);
        while self.up[root as usize] != root {
            turned ^= self.turned[root as usize];
            root = self.up[root as usize];
        }
        // All on the way hang on the root from now on.
        let (mut k, mut rest) = (i, turned);
        while k != root {
            let next = std::mem::replace(&mut self.up[k as usize], root);
            rest ^= std::mem::replace(&mut self.turned[k as usize], rest);
            k = next;
        }
        (root, turned)
    }

    /// Binds `i` to `j`, turned against it or not; false if the opposite is true already.
    pub(super) fn bind(&mut self, i: u32, j: u32, against: bool) -> bool {
        let ((root_i, turned_i), (root_j, turned_j)) = (self.root(i), self.root(j));
        if root_i == root_j {
            return (turned_i ^ turned_j) == against;
        }
        let (root, other) = (root_i.min(root_j), root_i.max(root_j));
        self.up[other as usize] = root;
        self.turned[other as usize] = turned_i ^ turned_j ^ against;
        true
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_ring_with_one_twist_is_refused() {
        let mut agreement = Agreement::new(4).unwrap();
        assert!(agreement.bind(2, 3, true));
        assert!(agreement.bind(0, 1, false));
        assert!(agreement.bind(3, 1, true));
        // 2 = not 3 = 1 = 0.
        assert!(agreement.bind(0, 2, false));
        assert!(!agreement.bind(2, 0, true));
        assert_eq!(
            (0..4).map(|i| agreement.root(i)).collect::<Vec<_>>(),
            [(0, false), (0, false), (0, false), (0, true)]
        );
    }
}

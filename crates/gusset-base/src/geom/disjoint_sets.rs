//! Disjoint sets of numbered elements: the union-find structure, plain and with parities.
//!
//! The root of a set is its smallest element, because a parent never exceeds its child. Results
//! therefore depend on the sets alone and not on the order of the unions. `find` halves the paths
//! that it climbs (Tarjan and van Leeuwen 1984). m operations on n elements take O(m log n) in the
//! worst case and nearly linear time in practice. 4 bytes an element.

use crate::alloc;
use crate::error::Result;
use crate::job::Job;

/// Disjoint sets of the elements 0, 1, ...
#[derive(Debug, Default)]
pub struct DisjointSets {
    parents: Vec<u32>,
}

impl DisjointSets {
    /// Creates `count` sets of one element each.
    #[inline]
    pub fn new(count: usize) -> Result<Self> {
        let mut sets = DisjointSets::default();
        sets.reset(count)?;
        Ok(sets)
    }

    /// Creates sets from a parent for every element. A parent must not exceed its element; a root
    /// is its own parent.
    #[inline]
    pub fn from_parents(parents: Vec<u32>) -> Self {
        debug_assert!(parents.iter().zip(0..).all(|(&parent, child)| parent <= child));
        DisjointSets { parents }
    }

    /// Resets to `count` sets of one element each, reusing the memory.
    #[inline]
    pub fn reset(&mut self, count: usize) -> Result<()> {
        self.parents.clear();
        alloc::reserve(&mut self.parents, count)?;
        self.parents.extend(0..count as u32);
        Ok(())
    }

    /// Returns the parent of an element; a root is its own parent.
    #[inline]
    pub fn parent(&self, i: u32) -> u32 {
        self.parents[i as usize]
    }

    /// Makes an element that is alone in its set a child of a smaller element.
    #[inline]
    pub fn attach(&mut self, i: u32, parent: u32) {
        self.parents[i as usize] = parent;
    }

    /// Returns the root of the set of `i`, which is the set's smallest element.
    #[inline]
    pub fn find(&mut self, mut i: u32) -> u32 {
        while self.parents[i as usize] != i {
            let above = self.parents[self.parents[i as usize] as usize];
            self.parents[i as usize] = above;
            i = above;
        }
        i
    }

    /// Merges two sets. Returns false if the elements already were in one set.
    #[inline]
    pub fn union(&mut self, i: u32, j: u32) -> bool {
        let (i, j) = (self.find(i), self.find(j));
        self.parents[i.max(j) as usize] = i.min(j);
        i != j
    }

    /// Returns the roots, in ascending order.
    pub fn roots(&self) -> impl Iterator<Item = u32> + '_ {
        (0..).zip(&self.parents).filter(|&(i, &parent)| i == parent).map(|(i, _)| i)
    }

    /// Returns the root of every element in a single pass, because parents precede their children.
    /// The host can cancel.
    pub fn into_roots(mut self, job: &Job<'_>, stage: &'static str) -> Result<Vec<u32>> {
        job.work_in_ranges(stage, self.parents.len(), |range| {
            for i in range {
                self.parents[i] = self.parents[self.parents[i] as usize];
            }
            Ok(())
        })?;
        Ok(self.parents)
    }
}

/// Disjoint sets whose elements are each equal or opposed to their root. They model constraints
/// such as orientations that depend on each other.
pub struct ParitySets {
    /// Twice the parent, plus 1 if the element is opposed to it.
    parents: Vec<u32>,
}

impl ParitySets {
    /// Creates `count` sets of one element each; `count` is below 2^31.
    #[inline]
    pub fn new(count: usize) -> Result<Self> {
        Ok(ParitySets { parents: alloc::collect((0..count).map(|i| 2 * i as u32))? })
    }

    /// Returns twice the root of the set of `i`, plus 1 if `i` is opposed to the root.
    #[inline]
    fn root_and_parity(&mut self, i: u32) -> u32 {
        let mut at = 2 * i;
        loop {
            let parent = self.parents[at as usize / 2];
            if parent / 2 == at / 2 {
                return at;
            }
            let above = self.parents[parent as usize / 2] ^ parent & 1;
            self.parents[at as usize / 2] = above;
            at = above ^ at & 1;
        }
    }

    /// Returns the root of the set of `i`, which is its smallest element, and whether `i` is
    /// opposed to it.
    #[inline]
    pub fn find(&mut self, i: u32) -> (u32, bool) {
        let root = self.root_and_parity(i);
        (root / 2, root & 1 == 1)
    }

    /// Constrains `i` to be equal or opposed to `j`. Returns false if the opposite already holds.
    pub fn union(&mut self, i: u32, j: u32, opposed: bool) -> bool {
        let (i, j) = (self.root_and_parity(i), self.root_and_parity(j));
        if i / 2 == j / 2 {
            return (i ^ j) & 1 == u32::from(opposed);
        }
        let (least, greatest) = (i.min(j), i.max(j));
        self.parents[greatest as usize / 2] = least & !1 | (least ^ greatest ^ u32::from(opposed)) & 1;
        true
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        /// Compares with labels that are rewritten one by one.
        #[test]
        fn agrees_with_relabelling(pairs in prop::collection::vec((0u32..20, 0u32..20), 0..30)) {
            let mut sets = DisjointSets::new(20).unwrap();
            let mut labels: Vec<u32> = (0..20).collect();
            for &(i, j) in &pairs {
                let (a, b) = (labels[i as usize], labels[j as usize]);
                prop_assert_eq!(sets.union(i, j), a != b);
                labels.iter_mut().filter(|label| **label == a.max(b)).for_each(|label| *label = a.min(b));
            }
            prop_assert_eq!((0..20).map(|i| sets.find(i)).collect::<Vec<_>>(), labels.clone());
            let mut roots = labels.clone();
            roots.dedup();
            roots.sort_unstable();
            roots.dedup();
            prop_assert_eq!(sets.roots().collect::<Vec<_>>(), roots);
            prop_assert_eq!(sets.into_roots(&Job::default(), "").unwrap(), labels);
        }

        /// Compares with all assignments of signs to a few elements.
        #[test]
        fn parities_hold_in_every_assignment(
            bonds in prop::collection::vec((0u32..6, 0u32..6, any::<bool>()), 0..9),
        ) {
            let mut sets = ParitySets::new(6).unwrap();
            let mut assignments: Vec<u32> = (0..64).collect();
            for (i, j, opposed) in bonds {
                let holds = |&signs: &u32| ((signs >> i ^ signs >> j) & 1 == 1) == opposed;
                let possible = assignments.iter().any(holds);
                prop_assert_eq!(sets.union(i, j, opposed), possible);
                if possible {
                    assignments.retain(holds);
                }
            }
            for i in 0..6 {
                let (root, opposed) = sets.find(i);
                prop_assert!(root <= i);
                prop_assert!(assignments.iter().all(|signs| ((signs >> i ^ signs >> root) & 1 == 1) == opposed));
            }
        }
    }
}

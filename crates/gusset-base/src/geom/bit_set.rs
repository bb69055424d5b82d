//! A set of small numbers, stored as one bit each.

use crate::alloc;
use crate::error::Result;

/// A set of numbers below a limit; takes 1 bit for each number below it.
#[derive(Debug, PartialEq)]
pub struct BitSet {
    words: Vec<u64>,
}

impl BitSet {
    /// Creates the empty set of numbers below `limit`.
    #[inline]
    pub fn new(limit: usize) -> Result<Self> {
        Ok(BitSet { words: alloc::zeroed(limit.div_ceil(64))? })
    }

    #[inline]
    pub fn insert(&mut self, i: u32) {
        self.words[i as usize / 64] |= 1 << (i % 64);
    }

    /// Removes the number if the set contains it; otherwise inserts it.
    #[inline]
    pub fn toggle(&mut self, i: u32) {
        self.words[i as usize / 64] ^= 1 << (i % 64);
    }

    /// Returns true if the set contains the number.
    #[inline]
    pub fn contains(&self, i: u32) -> bool {
        self.words[i as usize / 64] >> (i % 64) & 1 == 1
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use std::collections::BTreeSet;

    proptest! {
        #[test]
        fn agrees_with_a_tree_set(numbers in prop::collection::btree_set(0u32..200, 0..60)) {
            let mut set = BitSet::new(200).unwrap();
            numbers.iter().for_each(|&i| set.insert(i));
            prop_assert_eq!((0..200).filter(|&i| set.contains(i)).collect::<BTreeSet<_>>(), numbers);
        }
    }
}

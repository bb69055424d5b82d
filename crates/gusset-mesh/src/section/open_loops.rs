//! A set of numbers below a bound: counts and finds the members above a number in O(log n), by the sums
//! of P. Fenwick, "A new data structure for cumulative frequency tables", 1994.

use crate::NONE;
use gusset_base::alloc;
use gusset_base::error::Result;

/// The loops that contain the present place on a line, by rank.
pub(super) struct OpenLoops {
    is_open: Vec<bool>,
    /// Entry k is the number of members in the block of numbers that ends at k.
    counts: Vec<u32>,
    open_count: u32,
}

impl OpenLoops {
    pub(super) fn new(bound: usize) -> Result<Self> {
        Ok(OpenLoops { is_open: alloc::filled(false, bound)?, counts: alloc::filled(0, bound + 1)?, open_count: 0 })
    }

    /// Adds a number, or removes it if it is a member.
    pub(super) fn toggle(&mut self, number: u32) {
        let is_open = &mut self.is_open[number as usize];
        *is_open = !*is_open;
        let step = if *is_open { 1 } else { u32::MAX };
        self.open_count = self.open_count.wrapping_add(step);
        let mut k = number as usize + 1;
        while k < self.counts.len() {
            self.counts[k] = self.counts[k].wrapping_add(step);
            k += lowest_bit(k);
        }
    }

    /// Returns the number of members up to a number, inclusive.
    fn count_up_to(&self, number: u32) -> u32 {
        let (mut count, mut k) = (0, number as usize + 1);
        while k > 0 {
            count += self.counts[k];
            k -= lowest_bit(k);
        }
        count
    }

    /// Returns the number of members above a number.
    pub(super) fn count_above(&self, number: u32) -> u32 {
        self.open_count - self.count_up_to(number)
    }

    /// Returns the smallest member above a number, or [`NONE`].
    pub(super) fn find_above(&self, number: u32) -> u32 {
        let mut before = self.count_up_to(number);
        if before == self.open_count {
            return NONE;
        }
        // The largest k whose numbers below it have at most `before` members.
        let mut k = 0;
        let mut step = self.counts.len().next_power_of_two();
        while step > 0 {
            if k + step < self.counts.len() && self.counts[k + step] <= before {
                k += step;
                before -= self.counts[k];
            }
            step /= 2;
        }
        k as u32
    }
}

fn lowest_bit(k: usize) -> usize {
    k & k.wrapping_neg()
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use std::collections::BTreeSet;

    proptest! {
        #[test]
        fn members_are_those_of_a_set(toggled in prop::collection::vec(0u32..40, 0..60), bound in 40u32..70) {
            let mut open = OpenLoops::new(bound as usize).unwrap();
            let mut set = BTreeSet::new();
            for number in toggled {
                open.toggle(number);
                if !set.remove(&number) {
                    set.insert(number);
                }
                for number in 0..bound {
                    prop_assert_eq!(open.count_above(number) as usize, set.range(number + 1..).count());
                    prop_assert_eq!(open.find_above(number), set.range(number + 1..).next().copied().unwrap_or(NONE));
                }
            }
        }
    }
}

//! Best-first branch and bound: a queue of tasks by lower bound, and the loop that opens them.
//!
//! Invariant: every part that is neither settled nor excluded is in the queue, under a lower bound
//! of all its distances. If the loop ends early, the bound of the first task left is therefore a
//! lower bound of the remaining distances. O(log n) for each task.

use gusset_base::error::Error;
use std::cmp::Ordering;
use std::collections::BinaryHeap;

/// Waiting tasks, ordered by lower bound and then by key. The order of equal keys is unspecified,
/// but deterministic.
#[derive(Debug)]
pub(super) struct Frontier<T, K = ()> {
    heap: BinaryHeap<FrontierEntry<T, K>>,
}

#[derive(Debug)]
struct FrontierEntry<T, K> {
    bound: f64,
    key: K,
    task: T,
}

/// The entry with the smallest bound compares as the greatest, so that the heap returns it first.
impl<T, K: Ord> Ord for FrontierEntry<T, K> {
    fn cmp(&self, other: &Self) -> Ordering {
        other.bound.total_cmp(&self.bound).then_with(|| other.key.cmp(&self.key))
    }
}

impl<T, K: Ord> PartialOrd for FrontierEntry<T, K> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl<T, K: Ord> PartialEq for FrontierEntry<T, K> {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl<T, K: Ord> Eq for FrontierEntry<T, K> {}

impl<T, K: Ord> Default for Frontier<T, K> {
    fn default() -> Self {
        Frontier { heap: BinaryHeap::new() }
    }
}

impl<T, K: Ord> Frontier<T, K> {
    pub(super) fn clear(&mut self) {
        self.heap.clear();
    }

    /// Adds a task, all of whose distances are at least `bound`.
    pub(super) fn push(&mut self, bound: f64, key: K, task: T) -> Result<(), Error> {
        let bytes = size_of::<FrontierEntry<T, K>>() as u64;
        self.heap.try_reserve(1).map_err(|_| Error::OutOfMemory { bytes })?;
        self.heap.push(FrontierEntry { bound, key, task });
        Ok(())
    }
}

/// A search that opens its tasks by rising lower bounds.
pub(super) trait BranchAndBound {
    /// A part of the search space that may contain a solution.
    type SearchTask;
    /// Orders tasks of equal bound.
    type TieBreakKey: Ord;
    /// The reason why the whole search ends early.
    type StopReason;

    /// The queue of waiting tasks.
    fn frontier(&mut self) -> &mut Frontier<Self::SearchTask, Self::TieBreakKey>;

    /// False if the search wants no task with this bound or a higher one.
    fn is_bound_wanted(&mut self, bound: f64) -> bool;

    /// Extracts solutions from a task, and adds its parts to the frontier.
    fn branch_task(&mut self, bound: f64, task: Self::SearchTask) -> Result<(), Self::StopReason>;

    /// Opens tasks until the queue is empty, or its first task is not wanted. Returns the smallest
    /// bound of the tasks left, if any.
    fn search_best_first(&mut self) -> Result<Option<f64>, Self::StopReason> {
        while let Some(FrontierEntry { bound, task, .. }) = self.frontier().heap.pop() {
            if !self.is_bound_wanted(bound) {
                return Ok(Some(bound));
            }
            self.branch_task(bound, task)?;
        }
        Ok(None)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Finds the smallest of some numbers by halving ranges of them, and counts the ranges it
    /// opens.
    struct SmallestNumberSearch<'a> {
        numbers: &'a [f64],
        frontier: Frontier<(usize, usize), usize>,
        best: f64,
        opened: usize,
    }

    impl BranchAndBound for SmallestNumberSearch<'_> {
        type SearchTask = (usize, usize);
        type TieBreakKey = usize;
        type StopReason = Error;

        fn frontier(&mut self) -> &mut Frontier<(usize, usize), usize> {
            &mut self.frontier
        }

        fn is_bound_wanted(&mut self, bound: f64) -> bool {
            bound < self.best
        }

        fn branch_task(&mut self, bound: f64, (from, to): (usize, usize)) -> Result<(), Error> {
            self.opened += 1;
            if to - from == 1 {
                assert_eq!(bound, self.numbers[from]);
                self.best = self.best.min(bound);
                return Ok(());
            }
            for (from, to) in [(from, (from + to) / 2), ((from + to) / 2, to)] {
                let least = self.numbers[from..to].iter().copied().fold(f64::INFINITY, f64::min);
                self.frontier.push(least, from, (from, to))?;
            }
            Ok(())
        }
    }

    #[test]
    fn exact_bounds_lead_straight_to_the_smallest_number() {
        let numbers: Vec<f64> = (0..64).map(|k| f64::from(k * 37 % 64)).collect();
        let mut search =
            SmallestNumberSearch { numbers: &numbers, frontier: Frontier::default(), best: f64::INFINITY, opened: 0 };
        search.frontier.push(0.0, 0, (0, 64)).unwrap();
        // The second smallest number is in a task that is left.
        assert_eq!(search.search_best_first().unwrap(), Some(1.0));
        assert_eq!((search.best, search.opened), (0.0, 7));
    }

    #[test]
    fn equal_bounds_are_ordered_by_key() {
        let mut frontier = Frontier::default();
        for key in [3, 1, 2] {
            frontier.push(0.5, key, ()).unwrap();
        }
        frontier.push(0.25, 9, ()).unwrap();
        let keys: Vec<i32> = std::iter::from_fn(|| frontier.heap.pop()).map(|entry| entry.key).collect();
        assert_eq!(keys, [9, 1, 2, 3]);
    }
}

//! Cancellable sorting in place: parts are split at their medians until they are small enough to be
//! sorted between two reports. O(n log n).

use crate::error::Result;
use crate::job::Job;
use std::cmp::Ordering;

/// Elements sorted between two progress reports.
const PART: usize = 1 << 16;

/// Sorts in place, unstably: `compare` must be a total order without ties for results to be deterministic.
///
/// # Errors
/// [`Error::Cancelled`](crate::Error::Cancelled); the elements are then in some order.
pub(crate) fn sort<T>(
    items: &mut [T],
    compare: impl Fn(&T, &T) -> Ordering,
    job: &Job<'_>,
    stage: &'static str,
) -> Result<()> {
    let whole = items.len().max(1) as f64;
    // Parts still to be sorted, the first on top.
    let mut parts = vec![items];
    let mut done = 0;
    while let Some(part) = parts.pop() {
        job.step(done as f64 / whole, stage)?;
        if part.len() <= PART {
            part.sort_unstable_by(&compare);
            done += part.len();
        } else {
            let middle = part.len() / 2;
            part.select_nth_unstable_by(middle, &compare);
            let (first, last) = part.split_at_mut(middle);
            parts.extend([last, first]);
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::job::Progress;
    use std::cell::Cell;
    use std::ops::ControlFlow;

    /// Numbers without order, some of them several times.
    fn numbers(count: u64) -> Vec<u64> {
        (0..count).map(|k| (k.wrapping_mul(0x9e37_79b9_7f4a_7c15) >> 20) % (count / 2 + 1)).collect()
    }

    #[test]
    fn the_same_as_in_one_go() {
        for count in [0, 1, 2, 1000, 3 * PART as u64 + 17] {
            let (mut ours, mut plain) = (numbers(count), numbers(count));
            sort(&mut ours, u64::cmp, &Job::default(), "sorting").unwrap();
            plain.sort_unstable();
            assert_eq!(ours, plain);
        }
    }

    #[test]
    fn a_host_can_cancel() {
        struct Counter(Cell<u32>);
        impl Progress for Counter {
            fn step(&self, fraction: f64, _: &'static str) -> ControlFlow<()> {
                assert!((0.0..=1.0).contains(&fraction));
                self.0.set(self.0.get() + 1);
                if self.0.get() == 5 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
            }
        }
        let counter = Counter(Cell::new(0));
        let done = sort(&mut numbers(4 * PART as u64), u64::cmp, &Job::new(1, &counter), "sorting");
        assert_eq!((done, counter.0.get()), (Err(crate::Error::Cancelled), 5));
    }
}

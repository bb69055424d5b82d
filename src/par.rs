//! Work on many threads whose result does not depend on their number.
//!
//! The range is cut into chunks of a fixed length, and the results come back in chunk order: whatever is reduced over
//! them is reduced in the same order on one thread and on a hundred. No thread outlives the call.

use std::ops::Range;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;

/// Applies `work` to consecutive ranges of `chunk` elements that cover `0..len`, and returns the results in order.
///
/// `threads`: 0 for as many as the machine has; the calling thread is one of them.
pub(crate) fn chunks<R: Send>(
    threads: usize,
    len: usize,
    chunk: usize,
    work: impl Fn(Range<usize>) -> R + Sync,
) -> Vec<R> {
    let count = len.div_ceil(chunk);
    let range = |i: usize| i * chunk..len.min((i + 1) * chunk);
    let wanted = match threads {
        // Asking the system takes longer than a small job.
        _ if count <= 1 => 1,
        0 => thread::available_parallelism().map_or(1, usize::from),
        n => n,
    };
    let helpers = wanted.min(count).saturating_sub(1);
    if helpers == 0 {
        return (0..count).map(|i| work(range(i))).collect();
    }

    let next = AtomicUsize::new(0);
    let take = || {
        let mut done = Vec::new();
        loop {
            let i = next.fetch_add(1, Ordering::Relaxed);
            if i >= count {
                return done;
            }
            done.push((i, work(range(i))));
        }
    };
    let mut results = thread::scope(|scope| {
        // A thread that cannot be started is no failure: the others take its share.
        let handles: Vec<_> =
            (0..helpers).map_while(|_| thread::Builder::new().spawn_scoped(scope, take).ok()).collect();
        let mut results = take();
        for handle in handles {
            match handle.join() {
                Ok(part) => results.extend(part),
                Err(panic) => std::panic::resume_unwind(panic),
            }
        }
        results
    });
    results.sort_unstable_by_key(|&(i, _)| i);
    results.into_iter().map(|(_, result)| result).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_same_for_any_thread_count() {
        let sums = |threads| chunks(threads, 1001, 10, |range| range.map(|i| 1.0 / (i + 1) as f64).sum::<f64>());
        let one = sums(1);
        assert_eq!(one.len(), 101);
        for threads in [0, 2, 3, 64] {
            assert_eq!(one, sums(threads));
        }
        assert!(chunks(4, 0, 10, |range| range.len()).is_empty());
    }
}

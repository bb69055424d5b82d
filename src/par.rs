//! Work on many threads whose result does not depend on their number.
//!
//! The work is cut into items that do not depend on the number of threads, and the results come back in the order of the
//! items: whatever is reduced over them is reduced in the same order on one thread and on a hundred. No thread outlives the
//! call.

use std::ops::Range;
use std::sync::{Mutex, PoisonError};
use std::thread;

/// Applies `work` to every item and returns the results in order.
///
/// `threads`: 0 for as many as the machine has; the calling thread is one of them.
pub(crate) fn map<T: Send, R: Send>(
    threads: usize,
    items: impl ExactSizeIterator<Item = T> + Send,
    work: impl Fn(T) -> R + Sync,
) -> Vec<R> {
    let count = items.len();
    let wanted = at_most(count, threads);
    if wanted <= 1 {
        return items.map(work).collect();
    }

    let queue = Mutex::new(items.enumerate());
    let take = || {
        let mut done = Vec::new();
        loop {
            let next = queue.lock().unwrap_or_else(PoisonError::into_inner).next();
            match next {
                Some((i, item)) => done.push((i, work(item))),
                None => return done,
            }
        }
    };
    let mut results = thread::scope(|scope| {
        // A thread that cannot be started is no failure: the others take its share.
        let handles: Vec<_> =
            (1..wanted).map_while(|_| thread::Builder::new().spawn_scoped(scope, take).ok()).collect();
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

/// [`map`] over consecutive ranges of `chunk` elements that cover `0..len`.
pub(crate) fn chunks<R: Send>(
    threads: usize,
    len: usize,
    chunk: usize,
    work: impl Fn(Range<usize>) -> R + Sync,
) -> Vec<R> {
    map(threads, (0..len.div_ceil(chunk)).map(|i| i * chunk..len.min((i + 1) * chunk)), work)
}

/// How many threads `threads` stands for (0: as many as the machine has), but at most `limit`, and at least 1.
pub(crate) fn at_most(limit: usize, threads: usize) -> usize {
    match threads {
        // Asking the system takes longer than a small job.
        _ if limit <= 1 => 1,
        0 => thread::available_parallelism().map_or(1, usize::from).min(limit),
        n => n.min(limit),
    }
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

    #[test]
    fn items_may_be_parts_of_an_array() {
        for threads in [1, 2, 64] {
            let mut squares = vec![0; 1000];
            let parts = map(threads, squares.chunks_mut(7).enumerate(), |(i, part)| {
                part.iter_mut().zip(7 * i..).for_each(|(square, k)| *square = k * k);
                part.len()
            });
            assert_eq!(parts.iter().sum::<usize>(), 1000);
            assert!(squares.iter().enumerate().all(|(k, &square)| square == k * k));
        }
    }
}

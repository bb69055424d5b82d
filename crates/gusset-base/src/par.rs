//! Parallel loops whose results do not depend on the number of threads.
//!
//! The work is divided into items independently of the number of threads, and the results arrive in
//! the order of the items. A reduction over the results therefore runs in the same order on any
//! number of threads. Threads end before the call returns.

use crate::alloc;
use crate::error::Result;
use crate::job::{Job, Progress};
use crate::threads::{count_processors, lock, run_beside};
use std::ops::{ControlFlow, Range};
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Condvar, Mutex, PoisonError};
use std::time::Duration;

/// The longest time between two progress reports while a thread waits for another.
const MAX_TIME_BETWEEN_REPORTS: Duration = Duration::from_millis(10);

/// Applies `work` to every item and returns the results in order.
///
/// If `threads` is 0, the call uses as many threads as the machine has. The calling thread is one
/// of them.
///
/// # Errors
/// [`Error::OutOfMemory`](crate::Error::OutOfMemory), for the results.
pub fn map<T: Send, R: Send>(
    threads: usize,
    items: impl ExactSizeIterator<Item = T> + Send,
    work: impl Fn(T) -> R + Sync,
) -> Result<Vec<R>> {
    map_on_threads(threads, items, work, |_| Ok(()))
}

/// [`map`] that the host can cancel. The calling thread reports progress before each item that it
/// takes. After a cancel, no thread takes another item. Choose items large enough to be worth a
/// report and small enough not to delay one.
///
/// # Errors
/// [`Error::Cancelled`](crate::Error::Cancelled),
/// [`Error::OutOfMemory`](crate::Error::OutOfMemory).
pub fn map_cancellable<T: Send, R: Send>(
    job: &Job<'_>,
    stage: &'static str,
    items: impl ExactSizeIterator<Item = T> + Send,
    work: impl Fn(T) -> R + Sync,
) -> Result<Vec<R>> {
    let count = items.len().max(1) as f64;
    job.step(0.0, stage)?;
    map_on_threads(job.requested_threads(), items, work, |i| job.step(i as f64 / count, stage))
}

/// [`map_cancellable`] for items that may be large: `work` also receives a job. On the calling
/// thread it is a part of the host's job. On the other threads it fails as soon as the host cancels
/// or an item fails. While the calling thread waits for the others, it reports to the host.
/// Progress and notes from the other threads are dropped.
///
/// # Errors
/// The first item's error in the order of the items, or an error of [`map_cancellable`].
pub fn map_jobs<T: Send, R: Send>(
    job: &Job<'_>,
    stage: &'static str,
    items: impl ExactSizeIterator<Item = T> + Send,
    work: impl Fn(T, &Job<'_>) -> Result<R> + Sync,
) -> Result<Vec<R>> {
    let count = items.len();
    let helpers = resolve_thread_count(count, job.requested_threads()).saturating_sub(1);
    let queue = Mutex::new(items.enumerate());
    // Allocates all results before the first item, so that nothing fails after the last.
    let (results, mut all) = (empty_result_slots(count)?, alloc::with_capacity(count)?);
    let do_next = |job_of: JobOfItem<'_>| -> Result<ItemOutcome> {
        let Some((i, item)) = lock(&queue).next() else { return Ok(ItemOutcome::NothingLeft) };
        let result = work(item, &job_of(i)?);
        let step = if result.is_err() { ItemOutcome::Failed } else { ItemOutcome::Succeeded };
        lock(&results)[i] = Some(result);
        Ok(step)
    };
    run_items_with_jobs(helpers, job, stage, count, &do_next)?;
    for result in results.into_inner().unwrap_or_else(PoisonError::into_inner).into_iter().flatten() {
        all.push(result?);
    }
    Ok(all)
}

/// Returns the job of an item, or the reason not to begin it.
type JobOfItem<'a> = &'a dyn Fn(usize) -> Result<Job<'a>>;

/// The outcome of taking the next item.
enum ItemOutcome {
    /// No items are left.
    NothingLeft,
    /// The item succeeded.
    Succeeded,
    /// The item failed.
    Failed,
}

/// Calls `do_next_item` on the calling thread and on `helpers` others until an item fails or none
/// is left. It is not generic over the items, so that it is compiled only once.
fn run_items_with_jobs(
    helpers: usize,
    job: &Job<'_>,
    stage: &'static str,
    count: usize,
    do_next_item: &(dyn Fn(JobOfItem<'_>) -> Result<ItemOutcome> + Sync),
) -> Result<()> {
    let (busy, stopped) = (BusyThreadCount::default(), AtomicBool::new(false));
    let take_next = |job_of: JobOfItem<'_>| -> Result<bool> {
        if stopped.load(Ordering::Relaxed) {
            return Ok(false);
        }
        let step = do_next_item(job_of)?;
        stopped.fetch_or(matches!(step, ItemOutcome::Failed), Ordering::Relaxed);
        Ok(matches!(step, ItemOutcome::Succeeded))
    };
    let help = || {
        let _one = busy.count_thread();
        let flagged = CancelOnFlag(&stopped);
        while matches!(take_next(&|_| Ok(Job::new(1, &flagged))), Ok(true)) {}
    };
    let mut reported = Ok(());
    let mut lead = |_| {
        let stop = SetFlagOnDrop(&stopped);
        let ask = |done: usize| job.step(done as f64 / count.max(1) as f64, stage);
        let own_job = |i: usize| ask(i).map(|()| job.sub_job_of_item(i, count).with_threads(1));
        reported = (|| {
            while take_next(&own_job)? {}
            busy.wait_until_idle(|| ask(count))
        })();
        if reported.is_ok() {
            std::mem::forget(stop);
        }
    };
    run_beside(helpers, &help, &mut lead);
    reported
}

/// Returns a slot for each of `count` results.
fn empty_result_slots<R>(count: usize) -> Result<Mutex<Vec<Option<R>>>> {
    Ok(Mutex::new(alloc::collect((0..count).map(|_| None))?))
}

/// Implements [`map`]: returns the results in the order of the items. The calling thread calls
/// `before` with the index of each item that it takes.
fn map_on_threads<T: Send, R: Send>(
    threads: usize,
    items: impl ExactSizeIterator<Item = T> + Send,
    work: impl Fn(T) -> R + Sync,
    before: impl Fn(usize) -> Result<()>,
) -> Result<Vec<R>> {
    let count = items.len();
    let helpers = resolve_thread_count(count, threads).saturating_sub(1);
    let queue = Mutex::new(items.enumerate());
    let (results, mut all) = (empty_result_slots(count)?, alloc::with_capacity(count)?);
    let do_next = |before: BeforeItem<'_>| -> Result<bool> {
        let Some((i, item)) = lock(&queue).next() else { return Ok(false) };
        before(i)?;
        let result = work(item);
        lock(&results)[i] = Some(result);
        Ok(true)
    };
    run_items(helpers, &before, &do_next)?;
    all.extend(results.into_inner().unwrap_or_else(PoisonError::into_inner).into_iter().flatten());
    Ok(all)
}

/// Called with the index of an item before the item begins.
type BeforeItem<'a> = &'a dyn Fn(usize) -> Result<()>;

/// Calls `do_next_item` on the calling thread and on `helpers` others until no item is left or
/// `before` fails. Only the calling thread calls `before`. Like [`run_items_with_jobs`], it is not
/// generic over the items.
fn run_items(
    helpers: usize,
    before: BeforeItem<'_>,
    do_next_item: &(dyn Fn(BeforeItem<'_>) -> Result<bool> + Sync),
) -> Result<()> {
    let stopped = AtomicBool::new(false);
    let help = || {
        let mut is_done = false;
        while !is_done && !stopped.load(Ordering::Relaxed) {
            is_done = !matches!(do_next_item(&|_| Ok(())), Ok(true));
        }
    };
    let mut reported = Ok(());
    let mut lead = |_| {
        reported = (|| {
            while do_next_item(before)? {}
            Ok(())
        })();
        stopped.store(reported.is_err(), Ordering::Relaxed);
    };
    run_beside(helpers, &help, &mut lead);
    reported
}

/// Runs two closures, the second on a thread of its own if the job allows one. While the calling
/// thread waits, it reports to the host. If the first closure fails or the host cancels, the second
/// closure is cancelled at its next report. Its progress and notes are dropped. Both hold their
/// memory at the same time.
///
/// # Errors
/// The error of the first closure, then of the second;
/// [`Error::Cancelled`](crate::Error::Cancelled).
pub fn run_both<R, S: Send>(
    job: &Job<'_>,
    stage: &'static str,
    first: impl FnOnce(&Job<'_>) -> Result<R>,
    second: impl FnOnce(&Job<'_>) -> Result<S> + Send,
) -> Result<(R, S)> {
    if resolve_thread_count(2, job.requested_threads()) < 2 {
        return Ok((first(&job.sub_job(0.0, 0.5))?, second(&job.sub_job(0.5, 1.0))?));
    }
    let stopped = AtomicBool::new(false);
    let (second, done) = (Mutex::new(Some(second)), Mutex::new(None));
    let busy = BusyThreadCount::default();
    let help = || {
        let _one = busy.count_thread();
        let second = lock(&second).take();
        *lock(&done) = second.map(|second| second(&Job::new(1, &CancelOnFlag(&stopped))));
    };
    let (mut first, mut first_result) = (Some(first), None);
    let mut lead = |_| {
        let stop = SetFlagOnDrop(&stopped);
        first_result = first.take().map(|first| {
            let found = first(&job.sub_job(0.0, 0.5))?;
            // Runs the second closure here if the other thread has not begun it.
            let late = lock(&second).take();
            let late = late.map(|second| second(&job.sub_job(0.5, 1.0))).transpose()?;
            busy.wait_until_idle(|| job.step(0.5, stage))?;
            Ok((found, late))
        });
        if matches!(first_result, Some(Ok(_))) {
            std::mem::forget(stop);
        }
    };
    run_beside(1, &help, &mut lead);
    let (found, late) = first_result.unwrap_or(Err(crate::Error::Cancelled))?;
    match late.map(Ok).or(done.into_inner().unwrap_or_else(PoisonError::into_inner)) {
        Some(second) => Ok((found, second?)),
        None => Err(crate::Error::Cancelled),
    }
}

/// Counts the helper threads that are at work.
#[derive(Default)]
struct BusyThreadCount {
    count: AtomicUsize,
    /// Held by a waiting thread from its look at the count until it sleeps.
    wake_lock: Mutex<()>,
    count_fell: Condvar,
}

impl BusyThreadCount {
    /// Counts one more thread until the returned guard is dropped.
    fn count_thread(&self) -> impl Drop + use<'_> {
        self.count.fetch_add(1, Ordering::Relaxed);
        BusyThreadGuard(self)
    }

    /// Waits until the count is 0. Calls `ask` before and during the wait.
    fn wait_until_idle(&self, ask: impl Fn() -> Result<()>) -> Result<()> {
        while self.count.load(Ordering::Acquire) > 0 {
            ask()?;
            let looking = lock(&self.wake_lock);
            if self.count.load(Ordering::Acquire) > 0 {
                drop(self.count_fell.wait_timeout(looking, MAX_TIME_BETWEEN_REPORTS));
            }
        }
        Ok(())
    }
}

/// The guard of one thread in [`BusyThreadCount`].
struct BusyThreadGuard<'a>(&'a BusyThreadCount);

impl Drop for BusyThreadGuard<'_> {
    fn drop(&mut self) {
        self.0.count.fetch_sub(1, Ordering::Release);
        drop(lock(&self.0.wake_lock));
        self.0.count_fell.notify_one();
    }
}

/// Sets the flag of [`CancelOnFlag`] when dropped, after a failure or a panic.
struct SetFlagOnDrop<'a>(&'a AtomicBool);

impl Drop for SetFlagOnDrop<'_> {
    fn drop(&mut self) {
        self.0.store(true, Ordering::Relaxed);
    }
}

/// A progress receiver that cancels once its flag is set.
struct CancelOnFlag<'a>(&'a AtomicBool);

impl Progress for CancelOnFlag<'_> {
    fn step(&self, _: f64, _: &'static str) -> ControlFlow<()> {
        if self.0.load(Ordering::Relaxed) { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }
}

/// Divides `0..len` into consecutive ranges of `size` elements.
pub fn split_into_ranges(len: usize, size: usize) -> impl ExactSizeIterator<Item = Range<usize>> + Send {
    (0..len.div_ceil(size)).map(move |i| i * size..len.min((i + 1) * size))
}

/// Resolves a number of threads: 0 means as many as there are processors for this thread. The result is at most `limit`
/// and at least 1.
pub fn resolve_thread_count(limit: usize, threads: usize) -> usize {
    match threads {
        // Asking the system takes longer than a small job.
        _ if limit <= 1 => 1,
        0 => count_processors().min(limit),
        n => n.min(limit),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Error;
    use std::cell::Cell;
    use std::sync::atomic::AtomicUsize;

    #[test]
    fn results_are_equal_for_any_thread_count() {
        let sums = |threads| {
            map(threads, split_into_ranges(1001, 10), |range| range.map(|i| 1.0 / (i + 1) as f64).sum::<f64>()).unwrap()
        };
        let one = sums(1);
        assert_eq!(one.len(), 101);
        for threads in [0, 2, 3, 64] {
            assert_eq!(one, sums(threads));
        }
        assert_eq!(map(4, split_into_ranges(0, 10), |range| range.len()), Ok(Vec::new()));
    }

    #[test]
    fn progress_is_reported_before_every_item_of_this_thread() {
        struct ProgressCounter(Cell<u32>);
        impl crate::Progress for ProgressCounter {
            fn step(&self, fraction: f64, _: &'static str) -> ControlFlow<()> {
                assert!((0.0..1.0).contains(&fraction));
                self.0.set(self.0.get() - 1);
                if self.0.get() == 0 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
            }
        }
        let run = |threads, calls| {
            let counter = ProgressCounter(Cell::new(calls));
            let begun = AtomicUsize::new(0);
            let work = |range: Range<usize>| begun.fetch_add(1, Ordering::Relaxed) + range.len();
            let done = map_cancellable(&Job::new(threads, &counter), "work", split_into_ranges(1000, 10), work);
            (done.map(|done| done.len()), begun.into_inner(), calls - counter.0.get())
        };
        // One report at first, and one for each item.
        assert_eq!(run(1, 1000), (Ok(100), 100, 101));
        assert_eq!(run(1, 41), (Err(crate::Error::Cancelled), 39, 41));
        for threads in [2, 16] {
            assert_eq!(run(threads, 1000).0, Ok(100));
            let (done, begun, _) = run(threads, 1);
            assert_eq!((done, begun), (Err(crate::Error::Cancelled), 0));
        }
    }

    #[test]
    fn large_items_are_cancelled() {
        // The host cancels at its third report. An item that never ends must then end on any
        // thread.
        struct CancelsAfterSteps(Cell<u32>);
        impl crate::Progress for CancelsAfterSteps {
            fn step(&self, _: f64, _: &'static str) -> ControlFlow<()> {
                self.0.set(self.0.get().saturating_sub(1));
                if self.0.get() == 0 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
            }
        }
        let endless = |_: usize, job: &Job<'_>| -> Result<()> {
            loop {
                job.step(0.0, "endless")?;
            }
        };
        for threads in [1, 2, 16] {
            let patience = CancelsAfterSteps(Cell::new(3));
            assert_eq!(map_jobs(&Job::new(threads, &patience), "work", 0..5, endless), Err(Error::Cancelled));
            let job = Job::new(threads, &NeverCancels);
            assert_eq!(map_jobs(&job, "work", 0..50, |i: usize, _: &Job<'_>| Ok(i * i)).unwrap()[7], 49);
            let fails = |i: usize, _: &Job<'_>| if i == 3 { Err(Error::Cancelled) } else { Ok(i) };
            assert_eq!(map_jobs(&job, "work", 0..50, fails), Err(Error::Cancelled));
            // One item fails, and the other items stop.
            let either = |i: usize, job: &Job<'_>| if i == 0 { Err(Error::Cancelled) } else { endless(i, job) };
            assert_eq!(map_jobs(&job, "work", 0..2, either), Err(Error::Cancelled));
        }
    }

    #[test]
    fn run_both_runs_both_and_either_stops_the_other() {
        let work = |n: u32| move |_: &Job<'_>| Ok(n);
        for threads in [1, 2, 16] {
            let job = Job::new(threads, &NeverCancels);
            assert_eq!(run_both(&job, "both", work(1), work(2)), Ok((1, 2)));
            let refuse = |_: &Job<'_>| Err::<u32, _>(Error::Cancelled);
            assert_eq!(run_both(&job, "both", work(1), refuse), Err(Error::Cancelled));
            // Runs until its report fails.
            let endless = |job: &Job<'_>| loop {
                job.step(0.0, "endless")?;
            };
            let found: Result<(u32, u32)> = run_both(&job, "both", refuse, endless);
            assert_eq!(found, Err(Error::Cancelled));
        }
    }

    #[test]
    fn a_panic_of_either_stops_the_other_and_is_passed_on() {
        let endless = |job: &Job<'_>| loop {
            job.step(0.0, "endless")?;
        };
        let fails = |_: &Job<'_>| -> Result<()> { std::panic::panic_any("of work") };
        let passed_on = |found: std::thread::Result<Result<((), ())>>| *found.unwrap_err().downcast::<&str>().unwrap();
        for threads in [1, 2] {
            let job = Job::new(threads, &NeverCancels);
            let first =
                std::panic::catch_unwind(std::panic::AssertUnwindSafe(|| run_both(&job, "both", fails, endless)));
            assert_eq!(passed_on(first), "of work");
            let second =
                std::panic::catch_unwind(std::panic::AssertUnwindSafe(|| run_both(&job, "both", |_| Ok(()), fails)));
            assert_eq!(passed_on(second), "of work");
        }
    }

    #[test]
    fn progress_is_reported_while_this_thread_waits() {
        struct CancelsAfterSteps(Cell<u32>);
        impl Progress for CancelsAfterSteps {
            fn step(&self, _: f64, _: &'static str) -> ControlFlow<()> {
                self.0.set(self.0.get() - 1);
                if self.0.get() == 0 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
            }
        }
        let endless = |job: &Job<'_>| loop {
            job.step(0.0, "endless")?;
        };
        let patience = CancelsAfterSteps(Cell::new(3));
        let found: Result<((), ())> = run_both(&Job::new(2, &patience), "both", |_| Ok(()), endless);
        assert_eq!((found, patience.0.get()), (Err(Error::Cancelled), 0));
    }

    struct NeverCancels;

    impl Progress for NeverCancels {
        fn step(&self, _: f64, _: &'static str) -> ControlFlow<()> {
            ControlFlow::Continue(())
        }
    }

    #[test]
    fn items_may_be_parts_of_an_array() {
        for threads in [1, 2, 64] {
            let mut squares = vec![0; 1000];
            let parts = map(threads, squares.chunks_mut(7).enumerate(), |(i, part)| {
                part.iter_mut().zip(7 * i..).for_each(|(square, k)| *square = k * k);
                part.len()
            })
            .unwrap();
            assert_eq!(parts.iter().sum::<usize>(), 1000);
            assert!(squares.iter().enumerate().all(|(k, &square)| square == k * k));
        }
    }
}

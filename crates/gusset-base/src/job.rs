//! Progress, cancellation, notes and the number of threads of a long computation.

use crate::error::{Error, Result};
use crate::reserve;
use std::ops::{ControlFlow, Range};

/// The number of simple elements that take a few milliseconds.
const ELEMENTS_PER_REPORT: usize = 1 << 17;

/// Receives progress and notes. All calls come from the thread that started the computation.
pub trait Progress {
    /// Receives the completed fraction (0 to 1, never decreasing within a call) and the current
    /// stage. Return `Break` to cancel: the computation then soon returns [`Error::Cancelled`].
    fn step(&self, fraction: f64, stage: &'static str) -> ControlFlow<()>;

    /// Reports that the computation is complete, before its results are returned. `Break` cancels.
    fn finish(&self) -> ControlFlow<()> {
        ControlFlow::Continue(())
    }

    /// Receives a message that may interest the caller but is not an error.
    fn note(&self, _message: &str) {}
}

/// Ignores progress and never cancels.
struct SilentProgress;

impl Progress for SilentProgress {
    fn step(&self, _: f64, _: &'static str) -> ControlFlow<()> {
        ControlFlow::Continue(())
    }
}

/// The context of one computation: its threads and its progress receiver.
#[derive(Clone, Copy)]
pub struct Job<'a> {
    threads: usize,
    progress: &'a dyn Progress,
    first_fraction: f64,
    last_fraction: f64,
    /// The bytes taken from the memory reserve before the job began.
    bytes_drawn_at_start: u64,
}

impl<'a> Job<'a> {
    /// Creates a job. If `threads` is 0, it uses as many threads as the machine has; 1 means the
    /// calling thread only. The result does not depend on the number of threads.
    pub fn new(threads: usize, progress: &'a dyn Progress) -> Self {
        Job {
            threads,
            progress,
            first_fraction: 0.0,
            last_fraction: 1.0,
            bytes_drawn_at_start: reserve::bytes_drawn_since_start(),
        }
    }

    /// Returns the requested number of threads; 0 means automatic.
    pub fn requested_threads(&self) -> usize {
        self.threads
    }

    /// Returns a copy of the job with a different number of threads.
    pub fn with_threads(&self, threads: usize) -> Job<'a> {
        Job { threads, ..*self }
    }

    /// Returns the job of one part of the work. The part's range 0..1 is `from..to` of the whole.
    pub fn sub_job(&self, from: f64, to: f64) -> Job<'a> {
        let span = self.last_fraction - self.first_fraction;
        Job {
            first_fraction: self.first_fraction + span * from,
            last_fraction: self.first_fraction + span * to,
            ..*self
        }
    }

    /// Returns the job of part `k` of `count` equal parts.
    pub fn sub_job_of_item(&self, k: usize, count: usize) -> Job<'a> {
        self.sub_job(k as f64 / count as f64, (k + 1) as f64 / count as f64)
    }

    /// Reports progress. Returns [`Error::Cancelled`] if the host cancels. In the libraries for C,
    /// returns [`Error::OutOfMemory`] if an infallible allocation was served from the reserve.
    #[inline(never)]
    pub fn step(&self, fraction: f64, stage: &'static str) -> Result<()> {
        self.check_memory()?;
        self.step_without_memory_check(fraction, stage)
    }

    /// Reports progress like [`Job::step`], but without checking the reserve. Use it in work that
    /// modifies the caller's data in place, after a call of [`Job::check_memory`].
    pub fn step_without_memory_check(&self, fraction: f64, stage: &'static str) -> Result<()> {
        // Work without elements reports 0 / 0.
        let fraction = if fraction.is_nan() { 0.0 } else { fraction.clamp(0.0, 1.0) };
        error_if_cancelled(
            self.progress.step(self.first_fraction + (self.last_fraction - self.first_fraction) * fraction, stage),
        )
    }

    /// Reports that the computation is complete. Call it after the last step, before modifying the
    /// caller's data.
    ///
    /// # Errors
    ///
    /// As [`Job::step`].
    pub fn finish(&self) -> Result<()> {
        self.check_memory()?;
        error_if_cancelled(self.progress.finish())
    }

    /// Returns [`Error::OutOfMemory`] if any thread has taken memory from the reserve since the job
    /// began. Call it before modifying the caller's data.
    #[inline]
    pub fn check_memory(&self) -> Result<()> {
        match reserve::bytes_drawn_since_start() - self.bytes_drawn_at_start {
            0 => Ok(()),
            bytes => Err(Error::OutOfMemory { bytes }),
        }
    }

    /// Reports progress before element `k` of `count`, once in every `interval` elements.
    #[inline]
    pub fn step_every(&self, interval: usize, k: usize, count: usize, stage: &'static str) -> Result<()> {
        if k.is_multiple_of(interval) { self.step(k as f64 / count as f64, stage) } else { Ok(()) }
    }

    /// Reports within work on element `k` of a list that is usually short. It skips the first
    /// element, so that many short lists report nothing.
    #[inline]
    pub fn step_within_list(&self, k: usize, stage: &'static str) -> Result<()> {
        if k % ELEMENTS_PER_REPORT == ELEMENTS_PER_REPORT - 1 { self.step(0.0, stage) } else { Ok(()) }
    }

    /// [`Job::step_within_list`] for elements that each take as long as `weight` simple ones. `weight`
    /// is a power of two.
    #[inline]
    pub fn step_within_heavy_list(&self, weight: usize, k: usize, stage: &'static str) -> Result<()> {
        self.step_within_list(k * weight + (weight - 1), stage)
    }

    /// Runs `work` on consecutive ranges of `0..len` that take a few milliseconds each, and reports
    /// before each.
    pub fn work_in_ranges(
        &self,
        stage: &'static str,
        len: usize,
        mut work: impl FnMut(Range<usize>) -> Result<()>,
    ) -> Result<()> {
        for start in (0..len).step_by(ELEMENTS_PER_REPORT) {
            self.step(start as f64 / len as f64, stage)?;
            work(start..len.min(start + ELEMENTS_PER_REPORT))?;
        }
        Ok(())
    }

    /// Passes a note to the host.
    pub fn note(&self, message: &str) {
        self.progress.note(message);
    }
}

fn error_if_cancelled(answer: ControlFlow<()>) -> Result<()> {
    match answer {
        ControlFlow::Continue(()) => Ok(()),
        ControlFlow::Break(()) => Err(Error::Cancelled),
    }
}

impl Default for Job<'_> {
    /// Automatic threads, without a progress receiver.
    fn default() -> Self {
        Job::new(0, &SilentProgress)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::cell::RefCell;

    struct ProgressRecorder(RefCell<Vec<f64>>);

    impl Progress for ProgressRecorder {
        fn step(&self, fraction: f64, _: &'static str) -> ControlFlow<()> {
            self.0.borrow_mut().push(fraction);
            if fraction > 0.7 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        }
    }

    #[test]
    fn parts_nest_and_break_cancels() {
        let recorder = ProgressRecorder(RefCell::default());
        let job = Job::new(1, &recorder).sub_job(0.5, 1.0).sub_job(0.0, 0.5);
        assert_eq!(job.step(0.0, "a"), Ok(()));
        assert_eq!(job.step(f64::NAN, "a"), Ok(()));
        assert_eq!(job.step(2.0, "b"), Err(Error::Cancelled));
        assert_eq!(Job::new(1, &recorder).sub_job_of_item(1, 4).step(0.5, "c"), Ok(()));
        assert_eq!(*recorder.0.borrow(), [0.5, 0.5, 0.75, 0.375]);
    }

    #[test]
    fn heavy_elements_are_reported_more_often() {
        for weight in [1, 16, 64] {
            let recorder = ProgressRecorder(RefCell::default());
            let count = 3 * ELEMENTS_PER_REPORT / weight;
            (0..count).try_for_each(|k| Job::new(1, &recorder).step_within_heavy_list(weight, k, "a")).unwrap();
            assert_eq!(recorder.0.borrow().len(), 3);
        }
    }
}

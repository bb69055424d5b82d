//! Progress, cancellation, notes and the number of threads of a long computation.

use crate::error::{Error, Result};
use crate::reserve;
use std::ops::{ControlFlow, Range};

/// Elements of simple work that are done within a few milliseconds.
const ELEMENTS_PER_REPORT: usize = 1 << 17;

/// Receives progress and notes. All calls come from the thread that started the computation.
pub trait Progress {
    /// `fraction` of the whole is done (0 to 1, never decreasing within a call of the library) and
    /// `stage` begins or goes on. `Break` cancels: the computation returns [`Error::Cancelled`]
    /// soon after.
    fn step(&self, fraction: f64, stage: &'static str) -> ControlFlow<()>;

    /// The computation is complete, and its results are about to be handed over. `Break` cancels.
    fn finish(&self) -> ControlFlow<()> {
        ControlFlow::Continue(())
    }

    /// Something the caller may want to know that is no failure.
    fn note(&self, _message: &str) {}
}

/// Neither listens nor cancels.
struct Silent;

impl Progress for Silent {
    fn step(&self, _: f64, _: &'static str) -> ControlFlow<()> {
        ControlFlow::Continue(())
    }
}

/// The circumstances of one computation.
#[derive(Clone, Copy)]
pub struct Job<'a> {
    threads: usize,
    progress: &'a dyn Progress,
    from: f64,
    to: f64,
    /// What had been taken from the reserve when the job began.
    drawn: u64,
}

impl<'a> Job<'a> {
    /// `threads`: 0 for as many as the machine has, 1 for the calling thread only. The result does
    /// not depend on it.
    pub fn new(threads: usize, progress: &'a dyn Progress) -> Self {
        Job { threads, progress, from: 0.0, to: 1.0, drawn: reserve::drawn() }
    }

    /// The number of threads asked for; 0 is automatic.
    pub fn threads(&self) -> usize {
        self.threads
    }

    /// The same job with another number of threads.
    pub fn with_threads(&self, threads: usize) -> Job<'a> {
        Job { threads, ..*self }
    }

    /// The same job seen by one of its parts: what the part calls 0..1 is `from..to` of the whole.
    pub fn part(&self, from: f64, to: f64) -> Job<'a> {
        let span = self.to - self.from;
        Job { from: self.from + span * from, to: self.from + span * to, ..*self }
    }

    /// Part `k` of `count` equal ones.
    pub fn share(&self, k: usize, count: usize) -> Job<'a> {
        self.part(k as f64 / count as f64, (k + 1) as f64 / count as f64)
    }

    /// Reports progress; [`Error::Cancelled`] if the host wants to stop, and in the libraries for C
    /// [`Error::OutOfMemory`] if memory was refused that could not be asked for.
    #[inline(never)]
    pub fn step(&self, fraction: f64, stage: &'static str) -> Result<()> {
        self.memory()?;
        self.report(fraction, stage)
    }

    /// [`Job::step`] of work that changes what the caller has as it goes on: memory was asked for
    /// before it.
    pub fn report(&self, fraction: f64, stage: &'static str) -> Result<()> {
        // Of nothing to do, the part that is done may be no number.
        let fraction = if fraction.is_nan() { 0.0 } else { fraction.clamp(0.0, 1.0) };
        answer(self.progress.step(self.from + (self.to - self.from) * fraction, stage))
    }

    /// Tells the host that the computation is complete. To be called after the last step, before
    /// anything is changed that the caller has.
    ///
    /// # Errors
    ///
    /// As [`Job::step`].
    pub fn finish(&self) -> Result<()> {
        self.memory()?;
        answer(self.progress.finish())
    }

    /// [`Error::OutOfMemory`] if any thread has taken memory from the reserve since the job began.
    /// Asked for before anything is changed that the caller has.
    #[inline]
    pub fn memory(&self) -> Result<()> {
        match reserve::drawn() - self.drawn {
            0 => Ok(()),
            bytes => Err(Error::OutOfMemory { bytes }),
        }
    }

    /// Reports progress before element `k` of `count`, once in every `interval` elements.
    #[inline]
    pub fn step_every(&self, interval: usize, k: usize, count: usize, stage: &'static str) -> Result<()> {
        if k.is_multiple_of(interval) { self.step(k as f64 / count as f64, stage) } else { Ok(()) }
    }

    /// Reports within work on element `k` of a list that is short as a rule: not at the first, so
    /// that many short lists report nothing.
    #[inline]
    pub fn step_within(&self, k: usize, stage: &'static str) -> Result<()> {
        if k % ELEMENTS_PER_REPORT == ELEMENTS_PER_REPORT - 1 { self.step(0.0, stage) } else { Ok(()) }
    }

    /// [`Job::step_within`] where each element takes as long as `weight` simple ones, a power of
    /// two.
    #[inline]
    pub fn step_within_heavy(&self, weight: usize, k: usize, stage: &'static str) -> Result<()> {
        self.step_within(k * weight + (weight - 1), stage)
    }

    /// Does work of `len` elements, so many at a time that no host waits, and reports before each
    /// time.
    pub fn ranges(
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

fn answer(given: ControlFlow<()>) -> Result<()> {
    match given {
        ControlFlow::Continue(()) => Ok(()),
        ControlFlow::Break(()) => Err(Error::Cancelled),
    }
}

impl Default for Job<'_> {
    /// Automatic threads, nobody listening.
    fn default() -> Self {
        Job::new(0, &Silent)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::cell::RefCell;

    struct Recorder(RefCell<Vec<f64>>);

    impl Progress for Recorder {
        fn step(&self, fraction: f64, _: &'static str) -> ControlFlow<()> {
            self.0.borrow_mut().push(fraction);
            if fraction > 0.7 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        }
    }

    #[test]
    fn parts_nest_and_break_cancels() {
        let recorder = Recorder(RefCell::default());
        let job = Job::new(1, &recorder).part(0.5, 1.0).part(0.0, 0.5);
        assert_eq!(job.step(0.0, "a"), Ok(()));
        assert_eq!(job.step(f64::NAN, "a"), Ok(()));
        assert_eq!(job.step(2.0, "b"), Err(Error::Cancelled));
        assert_eq!(Job::new(1, &recorder).share(1, 4).step(0.5, "c"), Ok(()));
        assert_eq!(*recorder.0.borrow(), [0.5, 0.5, 0.75, 0.375]);
    }

    #[test]
    fn heavy_elements_are_reported_more_often() {
        for weight in [1, 16, 64] {
            let recorder = Recorder(RefCell::default());
            let count = 3 * ELEMENTS_PER_REPORT / weight;
            (0..count).try_for_each(|k| Job::new(1, &recorder).step_within_heavy(weight, k, "a")).unwrap();
            assert_eq!(recorder.0.borrow().len(), 3);
        }
    }
}

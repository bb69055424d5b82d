//! Properties of every computation: equal answers for any number of threads, growing progress, and
//! `Cancelled` if a step cancels.

use gusset::{Error, Job, Progress, Result};
use std::cell::Cell;
use std::fmt::Debug;
use std::ops::ControlFlow;

/// Counts steps, and breaks at one of them.
struct Steps {
    left: Cell<u64>,
    fraction: Cell<f64>,
}

impl Steps {
    fn until(end: u64) -> Self {
        Steps { left: Cell::new(end), fraction: Cell::new(0.0) }
    }
}

impl Progress for Steps {
    fn step(&self, fraction: f64, stage: &'static str) -> ControlFlow<()> {
        assert!((0.0..=1.0).contains(&fraction), "{stage}: {fraction}");
        assert!(fraction >= self.fraction.replace(fraction) - 1e-9, "{stage}: back to {fraction}");
        match self.left.get() {
            0 => ControlFlow::Break(()),
            left => {
                self.left.set(left - 1);
                ControlFlow::Continue(())
            }
        }
    }
}

/// Returns the answer of one thread. For some choices it is compared with the answer of two
/// threads, or the computation is repeated and cancelled.
///
/// # Errors
/// The errors of `run`.
///
/// # Panics
/// If the answers differ, progress runs backwards, or a cancel is not obeyed.
pub fn agreed<T: Debug>(choice: u8, run: impl Fn(&Job<'_>) -> Result<T>) -> Result<T> {
    let counted = Steps::until(u64::MAX);
    let alone = run(&Job::new(1, &counted));
    let steps = u64::MAX - counted.left.get();
    match choice % 8 {
        0 => {
            let together = run(&Job::new(2, &Steps::until(u64::MAX)));
            assert_eq!(format!("{alone:?}"), format!("{together:?}"), "the number of threads matters");
        }
        1..=2 if steps > 0 => {
            let at = u64::from(choice / 8) * 7919 % steps;
            let cancelled = run(&Job::new(1, &Steps::until(at)));
            assert!(matches!(cancelled, Err(Error::Cancelled)), "cancelled at step {at} of {steps}: {cancelled:?}");
        }
        _ => {}
    }
    alone
}

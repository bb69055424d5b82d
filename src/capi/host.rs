//! The host as the core sees it: progress, cancellation and notes.

use crate::job::Progress;
use std::cell::Cell;
use std::ffi::{CString, c_char, c_int, c_void};
use std::ops::ControlFlow;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};

/// The callbacks of a host, each with its user pointer.
#[derive(Clone, Copy)]
pub(crate) struct HostCallbacks {
    pub(crate) progress: Option<unsafe extern "C" fn(*mut c_void, f64, *const c_char) -> c_int>,
    pub(crate) progress_user: *mut c_void,
    pub(crate) log: Option<unsafe extern "C" fn(*mut c_void, *const c_char)>,
    pub(crate) log_user: *mut c_void,
}

/// The state of a call that any thread may read, and the request to cancel.
#[derive(Default)]
pub(crate) struct CallWatch {
    /// Whether a thread requested a cancel.
    pub(crate) cancelled: AtomicBool,
    /// The largest reported fraction, as the bits of an f64.
    fraction: AtomicU64,
}

impl CallWatch {
    /// Returns the largest reported fraction.
    pub(crate) fn largest_fraction(&self) -> f64 {
        f64::from_bits(self.fraction.load(Ordering::Relaxed))
    }
}

/// The host during one call.
pub(crate) struct HostProgress<'a> {
    watch: &'a CallWatch,
    callbacks: HostCallbacks,
    /// Whether the callback cancelled. The call then stays cancelled, whatever the callback returns
    /// later.
    is_stopped: Cell<bool>,
    /// The stage of the last report; none before the first.
    stage: Cell<Option<&'static str>>,
}

impl<'a> HostProgress<'a> {
    /// Creates the host at the start of a call.
    pub(crate) fn new(watch: &'a CallWatch, callbacks: HostCallbacks) -> Self {
        watch.fraction.store(0, Ordering::Relaxed);
        HostProgress { watch, callbacks, is_stopped: Cell::new(false), stage: Cell::new(None) }
    }
}

impl Progress for HostProgress<'_> {
    fn step(&self, fraction: f64, stage: &'static str) -> ControlFlow<()> {
        let fraction = fraction.max(self.watch.largest_fraction());
        self.watch.fraction.store(fraction.to_bits(), Ordering::Relaxed);
        self.stage.set(Some(stage));
        if let Some(callback) = self.callbacks.progress
            && !self.is_stopped.get()
        {
            // Without an allocation: a host may be called often, and while the system has no
            // memory.
            let mut text = [0_u8; 80];
            let length = stage.len().min(text.len() - 1);
            text[..length].copy_from_slice(&stage.as_bytes()[..length]);
            // SAFETY: the host provided this function for this purpose, and the 0-terminated text
            // lives during the call.
            let answer = unsafe { callback(self.callbacks.progress_user, fraction, text.as_ptr().cast()) };
            self.is_stopped.set(answer != 0);
        }
        if self.is_stopped.get() || self.watch.cancelled.load(Ordering::Relaxed) {
            ControlFlow::Break(())
        } else {
            ControlFlow::Continue(())
        }
    }

    /// Reports 1 once. A call that has reported nothing stays silent.
    fn finish(&self) -> ControlFlow<()> {
        let is_reported = self.watch.largest_fraction() >= 1.0;
        match self.stage.get() {
            Some(stage) if !is_reported => self.step(1.0, stage),
            _ => {
                self.watch.fraction.store(1.0_f64.to_bits(), Ordering::Relaxed);
                ControlFlow::Continue(())
            }
        }
    }

    fn note(&self, message: &str) {
        if let Some(callback) = self.callbacks.log {
            let message = CString::new(message).unwrap_or_default();
            // SAFETY: as above.
            unsafe { callback(self.callbacks.log_user, message.as_ptr()) };
        }
    }
}

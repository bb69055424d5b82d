//! A host as the core sees it.

use crate::job::Progress;
use std::cell::Cell;
use std::ffi::{CString, c_char, c_int, c_void};
use std::ops::ControlFlow;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};

/// The functions that a host wants called, each with what it is handed.
#[derive(Clone, Copy)]
pub(crate) struct Callbacks {
    pub(crate) progress: Option<unsafe extern "C" fn(*mut c_void, f64, *const c_char) -> c_int>,
    pub(crate) progress_user: *mut c_void,
    pub(crate) log: Option<unsafe extern "C" fn(*mut c_void, *const c_char)>,
    pub(crate) log_user: *mut c_void,
}

/// What any thread may see of a call, and ask of it.
#[derive(Default)]
pub(crate) struct Watch {
    /// Somebody asked to stop.
    pub(crate) cancelled: AtomicBool,
    /// The greatest part that was reported: the bits of an f64.
    fraction: AtomicU64,
}

impl Watch {
    /// The greatest part that was reported.
    pub(crate) fn fraction(&self) -> f64 {
        f64::from_bits(self.fraction.load(Ordering::Relaxed))
    }
}

/// The host of one call.
pub(crate) struct Host<'a> {
    watch: &'a Watch,
    callbacks: Callbacks,
    /// The callback asked to stop: this call is over, whatever it does next.
    stopped: Cell<bool>,
    /// The stage of the last report; none before the first.
    stage: Cell<Option<&'static str>>,
}

impl<'a> Host<'a> {
    /// The host of a call that begins.
    pub(crate) fn new(watch: &'a Watch, callbacks: Callbacks) -> Self {
        watch.fraction.store(0, Ordering::Relaxed);
        Host { watch, callbacks, stopped: Cell::new(false), stage: Cell::new(None) }
    }
}

impl Progress for Host<'_> {
    fn step(&self, fraction: f64, stage: &'static str) -> ControlFlow<()> {
        let fraction = fraction.max(self.watch.fraction());
        self.watch.fraction.store(fraction.to_bits(), Ordering::Relaxed);
        self.stage.set(Some(stage));
        if let Some(callback) = self.callbacks.progress
            && !self.stopped.get()
        {
            // Without an allocation: a host may be asked often, and while it has no memory.
            let mut text = [0_u8; 80];
            let length = stage.len().min(text.len() - 1);
            text[..length].copy_from_slice(&stage.as_bytes()[..length]);
            // SAFETY: the host gave this function for this purpose, and the text, which ends with a
            // 0, lives through the call.
            let answer = unsafe { callback(self.callbacks.progress_user, fraction, text.as_ptr().cast()) };
            self.stopped.set(answer != 0);
        }
        if self.stopped.get() || self.watch.cancelled.load(Ordering::Relaxed) {
            ControlFlow::Break(())
        } else {
            ControlFlow::Continue(())
        }
    }

    /// Reports 1 once. A call that has reported nothing stays silent.
    fn finish(&self) -> ControlFlow<()> {
        let is_reported = self.watch.fraction() >= 1.0;
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

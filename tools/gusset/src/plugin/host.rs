//! Callbacks of a run: progress, remarks, cancelling.

use gusset::capi::plugin::descriptor::gusset_host;
use std::ffi::{CStr, c_char, c_void};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::ptr;

/// Follows a run.
pub(crate) trait Watcher {
    /// Receives the part done, 0 to 1, and the current work. Returns true to cancel.
    fn progress(&self, fraction: f64, stage: &str) -> bool;
    /// Receives a remark that is not a failure.
    fn remark(&self, text: &str);
}

/// The callbacks of a run.
pub(super) struct Callbacks<'a> {
    watcher: &'a dyn Watcher,
}

impl<'a> Callbacks<'a> {
    pub(super) fn new(watcher: &'a dyn Watcher) -> Self {
        Self { watcher }
    }

    /// Returns the struct that a plugin takes. It must not outlive `self`.
    pub(super) fn host(&self, threads: u32, origins: bool) -> gusset_host {
        gusset_host {
            struct_size: size_of::<gusset_host>(),
            user: ptr::from_ref(self).cast_mut().cast(),
            progress: Some(progress),
            log: Some(log),
            threads,
            origins: u32::from(origins),
        }
    }
}

/// Tells the watcher of `Callbacks` of progress.
pub(super) unsafe extern "C" fn progress(user: *mut c_void, fraction: f64, stage: *const c_char) -> i32 {
    // SAFETY: the plugin passes back the pointer of `host`.
    let callbacks = unsafe { &*user.cast::<Callbacks<'_>>() };
    // A panic must not cross the plugin; the run goes on without progress.
    let cancel = catch_unwind(AssertUnwindSafe(|| callbacks.watcher.progress(fraction, &callback_text(stage))));
    i32::from(cancel.unwrap_or(false))
}

unsafe extern "C" fn log(user: *mut c_void, message: *const c_char) {
    // SAFETY: as above.
    let callbacks = unsafe { &*user.cast::<Callbacks<'_>>() };
    let _ = catch_unwind(AssertUnwindSafe(|| callbacks.watcher.remark(&callback_text(message))));
}

fn callback_text(text: *const c_char) -> String {
    if text.is_null() {
        return String::new();
    }
    // SAFETY: texts of callbacks are C strings during the callback.
    unsafe { CStr::from_ptr(text) }.to_string_lossy().into_owned()
}

//! The context: how a host steers a call and learns what happened.

use super::glue::{lend, versioned};
use super::guard::guard;
use super::input;
use super::status::{Failure, gusset_element, gusset_status};
use crate::error::Error;
use crate::job::{Job, Progress};
use libc::{c_char, c_int, c_void};
use std::cell::Cell;
use std::ffi::CString;
use std::ops::ControlFlow;
use std::ptr;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::{Mutex, MutexGuard, TryLockError};

/// Threads, progress, cancel, log, and the outcome of the last call. Opaque; one thread uses it at
/// a time, but gusset_context_cancel and gusset_context_get_progress may be called from any.
pub struct gusset_context {
    cancelled: AtomicBool,
    /// The bits of an f64.
    fraction: AtomicU64,
    state: Mutex<State>,
}

/// Called now and then during long work, on the thread that made the call. fraction: part done, 0
/// to 1. stage: what is being done, valid during the callback only. Return nonzero to cancel the
/// call. It must not use the context, except for gusset_context_cancel and
/// gusset_context_get_progress, and must not throw or longjmp.
pub type gusset_progress_fn =
    Option<unsafe extern "C" fn(user: *mut c_void, fraction: f64, stage: *const c_char) -> c_int>;

/// Called with remarks that are no failures, on the thread that made the call; message is valid
/// during the callback only. The same rules as for progress.
pub type gusset_log_fn = Option<unsafe extern "C" fn(user: *mut c_void, message: *const c_char)>;

#[derive(Clone, Copy)]
struct Settings {
    threads: u32,
    progress: gusset_progress_fn,
    progress_user: *mut c_void,
    log: gusset_log_fn,
    log_user: *mut c_void,
}

struct State {
    settings: Settings,
    message: CString,
    report: gusset_error_report,
}

/// What went wrong in the last call, for programs.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_error_report {
    /// sizeof(gusset_error_report), set by the caller.
    pub struct_size: usize,
    /// The status that the call returned.
    pub status: i32,
    /// What index counts: one of GUSSET_ELEMENT_...
    pub element: gusset_element,
    /// The first offending element.
    pub index: u64,
    /// Its value where it has one: the coordinate, the vertex index, the limit exceeded.
    pub value: f64,
    /// The mesh or loop that it belongs to: 0 the first, 1 the second.
    pub input: u32,
    /// 0.
    pub reserved: u32,
}

versioned! { gusset_error_report: 40 }

impl gusset_error_report {
    const OK: gusset_error_report = gusset_error_report {
        struct_size: size_of::<gusset_error_report>(),
        status: 0,
        element: 0,
        index: 0,
        value: 0.0,
        input: 0,
        reserved: 0,
    };
}

/// The core's view of the host: a progress callback, a log callback, a flag.
struct Host<'a> {
    context: &'a gusset_context,
    settings: Settings,
    /// The greatest part that was reported.
    done: Cell<f64>,
    /// The callback asked to stop: this call is over, whatever it does next.
    stopped: Cell<bool>,
}

impl Progress for Host<'_> {
    fn step(&self, fraction: f64, stage: &'static str) -> ControlFlow<()> {
        let fraction = fraction.max(self.done.get());
        self.done.set(fraction);
        self.context.fraction.store(fraction.to_bits(), Ordering::Relaxed);
        if let Some(callback) = self.settings.progress
            && !self.stopped.get()
        {
            let stage = CString::new(stage).unwrap_or_default();
            // SAFETY: the host gave this function for this purpose, and the text lives through the
            // call.
            let answer = unsafe { callback(self.settings.progress_user, fraction, stage.as_ptr()) };
            self.stopped.set(answer != 0);
        }
        if self.stopped.get() || self.context.cancelled.load(Ordering::Relaxed) {
            ControlFlow::Break(())
        } else {
            ControlFlow::Continue(())
        }
    }

    fn note(&self, message: &str) {
        if let Some(callback) = self.settings.log {
            let message = CString::new(message).unwrap_or_default();
            // SAFETY: as above.
            unsafe { callback(self.settings.log_user, message.as_ptr()) };
        }
    }
}

impl gusset_context {
    fn lock(&self) -> Result<MutexGuard<'_, State>, Failure> {
        match self.state.try_lock() {
            Ok(state) => Ok(state),
            Err(TryLockError::Poisoned(poisoned)) => Ok(poisoned.into_inner()),
            Err(TryLockError::WouldBlock) => {
                Err(Failure::new(gusset_status::GUSSET_ERROR_CONTEXT_BUSY, "the context is in use by another call"))
            }
        }
    }

    /// Runs a call and records its outcome.
    pub(crate) fn run(
        context: *const gusset_context,
        body: impl FnOnce(&Job<'_>) -> Result<(), Failure>,
    ) -> gusset_status {
        if context.is_null() {
            return body(&Job::default()).map_or_else(|failure| failure.status, |()| gusset_status::GUSSET_OK);
        }
        let entered = input::reference(context, "context").and_then(|context| Ok((context, context.lock()?)));
        let (context, mut state) = match entered {
            Ok(entered) => entered,
            Err(failure) => return failure.status,
        };
        context.fraction.store(0, Ordering::Relaxed);
        let host = Host { context, settings: state.settings, done: Cell::new(0.0), stopped: Cell::new(false) };
        let job = Job::new(host.settings.threads as usize, &host);
        // Caught here as well as in guard(), so that the report says so.
        let body = std::panic::AssertUnwindSafe(|| {
            // A cancel that came before the call holds for it, however short it is.
            if context.cancelled.load(Ordering::Relaxed) { Err(Error::Cancelled.into()) } else { body(&job) }
        });
        let outcome = std::panic::catch_unwind(body).unwrap_or_else(|panic| {
            std::mem::forget(panic);
            Err(Failure::new(gusset_status::GUSSET_ERROR_PANIC, "internal error: please report it"))
        });
        state.record(outcome)
    }
}

impl State {
    fn record(&mut self, outcome: Result<(), Failure>) -> gusset_status {
        let (status, message, report) = match outcome {
            Ok(()) => (gusset_status::GUSSET_OK, CString::default(), gusset_error_report::OK),
            Err(failure) => {
                let report = gusset_error_report {
                    status: failure.status as i32,
                    element: failure.element,
                    index: failure.index,
                    value: failure.value,
                    input: failure.input,
                    ..gusset_error_report::OK
                };
                (failure.status, CString::new(failure.message.into_owned()).unwrap_or_default(), report)
            }
        };
        (self.message, self.report) = (message, report);
        status
    }
}

/// Creates a context with automatic threads and no callbacks.
///
/// Destroy it with gusset_context_destroy.
///
/// @param[out] context threads, progress, cancellation and error report; NULL for the defaults.
/// @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT.
/// @complexity O(1).
/// @since 0.1
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_context_create(context: *mut *mut gusset_context) -> gusset_status {
    guard(ptr::null(), |_| {
        let out = input::output(context, ptr::null_mut(), "context")?;
        let none = ptr::null_mut();
        let settings = Settings { threads: 0, progress: None, progress_user: none, log: None, log_user: none };
        let state = Mutex::new(State { settings, message: CString::default(), report: gusset_error_report::OK });
        let created = gusset_context { cancelled: AtomicBool::new(false), fraction: AtomicU64::new(0), state };
        *out = Box::into_raw(Box::new(created));
        Ok(())
    })
}

/// Destroys a context; NULL is allowed.
///
/// No call may be using it.
///
/// @param[in,out] context the context.
/// @since 0.1
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gusset_context_destroy(context: *mut gusset_context) {
    input::destroy(context);
}

/// Sets the number of threads, on which results do not depend.
///
/// @param[in,out] context the context.
/// @param threads 0 as many as the machine has, 1 the calling thread only.
/// @return GUSSET_OK, or an error: NULL_ARGUMENT, CONTEXT_BUSY.
/// @complexity O(1).
/// @since 0.1
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gusset_context_set_threads(context: *mut gusset_context, threads: u32) -> gusset_status {
    change(context, |settings| settings.threads = threads)
}

/// Sets the progress callback.
///
/// @param[in,out] context the context.
/// @param progress NULL for none.
/// @param[out] user handed to it, and not looked at.
/// @return GUSSET_OK, or an error: NULL_ARGUMENT, CONTEXT_BUSY.
/// @complexity O(1).
/// @since 0.1
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gusset_context_set_progress(
    context: *mut gusset_context,
    progress: gusset_progress_fn,
    user: *mut c_void,
) -> gusset_status {
    change(context, |settings| (settings.progress, settings.progress_user) = (progress, user))
}

/// Sets the log callback.
///
/// @param[in,out] context the context.
/// @param log NULL for none.
/// @param[out] user handed to it, and not looked at.
/// @return GUSSET_OK, or an error: NULL_ARGUMENT, CONTEXT_BUSY.
/// @complexity O(1).
/// @since 0.1
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gusset_context_set_log(
    context: *mut gusset_context,
    log: gusset_log_fn,
    user: *mut c_void,
) -> gusset_status {
    change(context, |settings| (settings.log, settings.log_user) = (log, user))
}

fn change(context: *const gusset_context, set: impl FnOnce(&mut Settings)) -> gusset_status {
    guard(ptr::null(), |_| {
        set(&mut input::reference(context, "context")?.lock()?.settings);
        Ok(())
    })
}

/// Cancels the running call, and every later one until gusset_context_reset.
///
/// @param context the context.
/// @complexity O(1).
/// @threads From any thread; NULL is allowed.
/// @since 0.1
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gusset_context_cancel(context: *const gusset_context) {
    if let Ok(context) = input::reference(context, "context") {
        context.cancelled.store(true, Ordering::Relaxed);
    }
}

/// Takes a cancel back.
///
/// NULL is allowed.
///
/// @param context the context.
/// @complexity O(1).
/// @since 0.1
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gusset_context_reset(context: *const gusset_context) {
    if let Ok(context) = input::reference(context, "context") {
        context.cancelled.store(false, Ordering::Relaxed);
    }
}

/// How much of the running (or last) call is done, 0 to 1; 0 for NULL.
///
/// @param context the context.
/// @return 0 to 1; 0 for NULL.
/// @complexity O(1).
/// @since 0.1
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gusset_context_get_progress(context: *const gusset_context) -> f64 {
    input::reference(context, "context").map_or(0.0, |context| f64::from_bits(context.fraction.load(Ordering::Relaxed)))
}

/// What went wrong in the last call with this context, as an English sentence; empty after a
/// success.
///
/// Never NULL. Valid until the next call with the context. Empty too for NULL, and while a call is
/// running.
///
/// @param context the context.
/// @return a NUL-terminated UTF-8 string, never NULL.
/// @complexity O(1).
/// @since 0.1
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gusset_context_get_message(context: *const gusset_context) -> *const c_char {
    let state = input::reference(context, "context").and_then(gusset_context::lock);
    state.map_or(c"".as_ptr(), |state| state.message.as_ptr())
}

/// What went wrong in the last call with this context, as numbers.
///
/// @param context the context.
/// @param[out] report receives the report; struct_size is set by the caller.
/// @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE,
///     CONTEXT_BUSY.
/// @complexity O(1).
/// @since 0.1
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gusset_context_get_report(
    context: *const gusset_context,
    report: *mut gusset_error_report,
) -> gusset_status {
    lend!(context, report, |context| context.lock()?.report)
}

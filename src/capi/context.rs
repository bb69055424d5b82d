//! Contexts: Settings and outcomes of calls.

use super::glue::versioned;
use super::guard::catch_panic;
use super::handle::{self, OpaqueHandle, handle};
use super::host::{CallWatch, HostCallbacks, HostProgress};
use super::input::{self, VersionedStruct};
use super::status::{Failure, gusset_element, gusset_status, status_text};
use crate::error::Error;
use crate::job::{Job, Progress};
use gusset_base::reserve;
use std::borrow::Cow;
use std::ffi::{CStr, CString, c_char, c_int, c_void};
use std::ptr;
use std::sync::atomic::Ordering;
use std::sync::{Mutex, MutexGuard, TryLockError};

/// Threads, progress, cancellation, log, and the outcome of the last call. One thread uses it at a
/// time, except for cancel, reset and get_progress.
pub struct gusset_context {
    watch: CallWatch,
    state: Mutex<ContextState>,
}

handle! { gusset_context }

/// Receives the progress of long work, on the calling thread. A nonzero return cancels this call
/// only. The callback must not throw, longjmp, or use the context except by cancel and
/// get_progress.
/// - fraction: the part done, 0 to 1, nondecreasing; 1 after success.
/// - stage: the current work; valid during the callback.
pub type gusset_progress_fn =
    Option<unsafe extern "C" fn(user: *mut c_void, fraction: f64, stage: *const c_char) -> c_int>;

/// Receives remarks that are not errors, under the rules of gusset_progress_fn. Sentences may
/// change; programs read results. Stitching, filling and joining report
/// - a second piece or component turned over to agree with the first;
/// - a closed component turned over that faced the wrong side;
/// - fairing without new vertices;
/// - rows, cells or fairing with a blend;
/// - a strip instead of a blend;
/// - near_loops_left above 0 or zero_volume not empty in gusset_join_report.
pub type gusset_log_fn = Option<unsafe extern "C" fn(user: *mut c_void, message: *const c_char)>;

struct ContextState {
    threads: u32,
    callbacks: HostCallbacks,
    message: Cow<'static, CStr>,
    report: gusset_error_report,
}

/// Report of the last error.
#[repr(C)]
#[derive(Clone, Copy, Default)]
pub struct gusset_error_report {
    /// sizeof(gusset_error_report).
    pub struct_size: usize,
    /// Status that the call returned.
    pub status: i32,
    /// Element that a report's index counts.
    pub element: gusset_element,
    /// First offending element.
    pub index: u64,
    /// Its value, such as a coordinate, vertex index or limit.
    pub value: f64,
    /// Mesh, piece, input or loop of the element.
    pub input: u32,
    /// 0.
    pub reserved: u32,
}

versioned! { gusset_error_report: 40 }

impl gusset_context {
    fn lock_state(&self) -> Result<MutexGuard<'_, ContextState>, Failure> {
        match self.state.try_lock() {
            Ok(state) => Ok(state),
            Err(TryLockError::Poisoned(poisoned)) => Ok(poisoned.into_inner()),
            Err(TryLockError::WouldBlock) => Err(Failure::new(
                gusset_status::GUSSET_ERROR_CONTEXT_BUSY,
                "another call uses the context; pass another context",
            )),
        }
    }
}

impl ContextState {
    fn record_outcome(&mut self, outcome: Result<(), Failure>) -> gusset_status {
        (self.message, self.report) = (Cow::Borrowed(c""), gusset_error_report::default());
        let Err(failure) = outcome else { return gusset_status::GUSSET_OK };
        let Failure { status, message, element, index, value, input } = failure;
        let message = CString::new(message.into_owned()).unwrap_or_default();
        // A context must not keep blocks in the reserve.
        let kept = !reserve::contains_block(message.as_ptr());
        self.message = if kept { Cow::Owned(message) } else { Cow::Borrowed(status_text(status as i32)) };
        self.report = gusset_error_report { status: status as i32, element, index, value, input, ..self.report };
        status
    }
}

/// Runs `body` with the context's job, or with the defaults if the context is NULL, and records the
/// outcome in the context. A call that took memory from the reserve fails.
pub(crate) fn guard_call(
    context: *const gusset_context,
    body: impl FnOnce(&Job<'_>) -> Result<(), Failure>,
) -> gusset_status {
    guard_changing_call(context, |job| run_and_finish(body, job))
}

/// Returns the result of `body`, or an error if the reserve had to provide memory, or if the host
/// cancels.
fn run_and_finish<T>(body: impl FnOnce(&Job<'_>) -> Result<T, Failure>, job: &Job<'_>) -> Result<T, Failure> {
    let made = body(job)?;
    job.finish()?;
    Ok(made)
}

/// [`guard_call`] for a `body` that modifies the caller's data, writes to its outputs, or makes handles.
/// These changes cannot be undone, so `body` calls [`Job::finish`] itself before it makes them, or
/// [`Job::check_memory`] if it reports while it makes them.
pub(crate) fn guard_changing_call(
    context: *const gusset_context,
    body: impl FnOnce(&Job<'_>) -> Result<(), Failure>,
) -> gusset_status {
    let mut body = Some(body);
    run_guarded_call(context, &mut |job| body.take().map_or(Ok(()), |body| body(job)))
}

/// Calls `body` at most once. It is not generic over `body`, so that it is compiled only once.
fn run_guarded_call(
    context: *const gusset_context,
    body: &mut dyn FnMut(&Job<'_>) -> Result<(), Failure>,
) -> gusset_status {
    let outcome = catch_panic(|| {
        if context.is_null() {
            return body(&Job::default()).map(|()| gusset_status::GUSSET_OK);
        }
        let context = handle::get_object(context, "context")?;
        let mut state = context.lock_state()?;
        let host = HostProgress::new(&context.watch, state.callbacks);
        let job = Job::new(state.threads as usize, &host);
        // Catch panics here too, so that the report mentions them.
        let outcome = catch_panic(|| {
            // A cancel before the call also cancels the call, even a short one.
            if context.watch.cancelled.load(Ordering::Relaxed) { Err(Error::Cancelled.into()) } else { body(&job) }
        });
        if outcome.is_ok() {
            // Too late to cancel a body that changed things while it reported.
            let _ = host.finish();
        }
        Ok(state.record_outcome(outcome))
    });
    outcome.unwrap_or_else(|failure: Failure| failure.status)
}

/// Runs `body` like [`guard_call`] and stores its result in `out`. It first sets `out` to `cleared`,
/// which the host then finds there after any failure.
pub(crate) fn answer_into_output<T>(
    context: *const gusset_context,
    (out, name): (*mut T, &'static str),
    cleared: T,
    body: impl FnOnce(&Job<'_>) -> Result<T, Failure>,
) -> gusset_status {
    let slot = input::cleared_output(out, cleared, name);
    guard_changing_call(context, |job| {
        // First of all, the result needs a place.
        let slot = slot?;
        *slot = run_and_finish(body, job)?;
        Ok(())
    })
}

/// [`answer_into_output`] with an output that may be NULL.
pub(crate) fn answer_into_optional_output<T>(
    context: *const gusset_context,
    (out, name): (*mut T, &'static str),
    cleared: T,
    body: impl FnOnce(&Job<'_>) -> Result<T, Failure>,
) -> gusset_status {
    let slot = input::cleared_optional_output(out, cleared, name);
    guard_changing_call(context, |job| {
        let slot = slot?;
        input::set_optional_output(slot, run_and_finish(body, job)?);
        Ok(())
    })
}

/// [`answer_into_output`] with a struct that has a `struct_size`.
pub(crate) fn answer_into_struct<T: VersionedStruct>(
    context: *const gusset_context,
    (out, name): (*mut T, &'static str),
    body: impl FnOnce(&Job<'_>) -> Result<T, Failure>,
) -> gusset_status {
    let out = input::output_struct(out, name);
    guard_changing_call(context, |job| {
        let out = out?;
        out.write_known_fields(run_and_finish(body, job)?);
        Ok(())
    })
}

/// [`answer_into_output`] with a new handle.
pub(crate) fn create_handle<T: OpaqueHandle>(
    context: *const gusset_context,
    out: *mut *mut T,
    name: &'static str,
    body: impl FnOnce(&Job<'_>) -> Result<T, Failure>,
) -> gusset_status {
    create_handle_and_outputs(context, out, name, |job| Ok((body(job)?, ())), |()| ())
}

/// [`create_handle`] for a body that produces more than the handle. `tell` writes the rest to other
/// outputs.
pub(crate) fn create_handle_and_outputs<T: OpaqueHandle, U>(
    context: *const gusset_context,
    out: *mut *mut T,
    name: &'static str,
    body: impl FnOnce(&Job<'_>) -> Result<(T, U), Failure>,
    tell: impl FnOnce(U),
) -> gusset_status {
    let slot = input::cleared_output(out, ptr::null_mut(), name);
    guard_changing_call(context, |job| {
        let slot = slot?;
        let boxed = |job: &Job<'_>| body(job).map(|(made, told)| (handle::box_with_kind(made), told));
        let (made, told) = run_and_finish(boxed, job)?;
        tell(told);
        *slot = handle::into_handle(made);
        Ok(())
    })
}

/// `lend!(handle, out, |it| struct)` fills the caller's struct `out` from the object of `handle`.
/// The body may use `?`.
macro_rules! lend {
    ($handle:ident, $out:ident, |$it:pat_param| $body:expr) => {
        $crate::capi::context::answer_into_struct(std::ptr::null(), ($out, stringify!($out)), |_| {
            let $it = $crate::capi::handle::get_object($handle, stringify!($handle))?;
            Ok($body)
        })
    };
}
pub(crate) use lend;

/// Creates a context with automatic threads and without callbacks.
///
/// @complexity O(1).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_context_create(context: *mut *mut gusset_context) -> gusset_status {
    create_handle(ptr::null(), context, "context", |_| {
        let none = ptr::null_mut();
        let callbacks = HostCallbacks { progress: None, progress_user: none, log: None, log_user: none };
        let (message, report) = (Cow::Borrowed(c""), gusset_error_report::default());
        let state = Mutex::new(ContextState { threads: 0, callbacks, message, report });
        Ok(gusset_context { watch: CallWatch::default(), state })
    })
}

/// Destroys a context. No call may be using it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gusset_context_destroy(context: *mut gusset_context) {
    handle::destroy(context);
}

/// Sets the number of threads.
///
/// @param threads 0: a thread for each processor that the calling thread may use; 1: the calling
///     thread.
/// @complexity O(1).
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gusset_context_set_threads(context: *mut gusset_context, threads: u32) -> gusset_status {
    change_state(context, |state| state.threads = threads)
}

/// Sets the progress callback.
///
/// @param progress NULL: none.
/// @complexity O(1).
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gusset_context_set_progress(
    context: *mut gusset_context,
    progress: gusset_progress_fn,
    user: *mut c_void,
) -> gusset_status {
    change_state(context, |ContextState { callbacks, .. }| {
        (callbacks.progress, callbacks.progress_user) = (progress, user);
    })
}

/// Sets the log callback.
///
/// @param log NULL: none.
/// @complexity O(1).
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gusset_context_set_log(
    context: *mut gusset_context,
    log: gusset_log_fn,
    user: *mut c_void,
) -> gusset_status {
    change_state(context, |ContextState { callbacks, .. }| (callbacks.log, callbacks.log_user) = (log, user))
}

fn change_state(context: *const gusset_context, set: impl FnOnce(&mut ContextState)) -> gusset_status {
    guard_call(ptr::null(), |_| {
        let mut state = handle::get_object(context, "context")?.lock_state()?;
        set(&mut state);
        state.record_outcome(Ok(()));
        Ok(())
    })
}

/// Cancels running and later calls until gusset_context_reset.
///
/// @complexity O(1).
/// @threads Any; NULL is allowed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gusset_context_cancel(context: *const gusset_context) {
    if let Ok(context) = handle::get_object(context, "context") {
        context.watch.cancelled.store(true, Ordering::Relaxed);
    }
}

/// Withdraws a cancellation.
///
/// @complexity O(1).
/// @threads Any; NULL is allowed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gusset_context_reset(context: *const gusset_context) {
    if let Ok(context) = handle::get_object(context, "context") {
        context.watch.cancelled.store(false, Ordering::Relaxed);
    }
}

/// Returns the done part of the running or last call.
///
/// @return 0 to 1; 0 for NULL.
/// @complexity O(1).
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gusset_context_get_progress(context: *const gusset_context) -> f64 {
    handle::get_object(context, "context").map_or(0.0, |context| context.watch.largest_fraction())
}

/// Explains the last call's error in an English sentence.
///
/// @return UTF-8, never NULL, valid until the next call with the context; empty after a success,
///     during a call, and for NULL.
/// @complexity O(1).
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gusset_context_get_message(context: *const gusset_context) -> *const c_char {
    let state = handle::get_object(context, "context").and_then(gusset_context::lock_state);
    state.map_or(c"".as_ptr(), |state| state.message.as_ptr())
}

/// Copies the report of the last call, cleared after a success.
///
/// @complexity O(1).
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gusset_context_get_report(
    context: *const gusset_context,
    report: *mut gusset_error_report,
) -> gusset_status {
    lend!(context, report, |context| context.lock_state()?.report)
}

//! What becomes of a panic, and of a context that is in use.

use super::context::gusset_context;
use super::input::{self, Versioned};
use super::status::{Failure, gusset_status};
use crate::job::Job;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::ptr;

/// Runs `body` as [`guard`] does and gives its result to the host through `out`, which is cleared
/// before anything else: whatever becomes of the context, the host finds NULL there after a
/// failure.
pub(crate) fn create<T>(
    context: *const gusset_context,
    out: *mut *mut T,
    name: &'static str,
    body: impl FnOnce(&Job<'_>) -> Result<T, Failure>,
) -> gusset_status {
    let slot = input::output(out, ptr::null_mut(), name);
    guard(context, |job| {
        // First of all: there must be a place for the result.
        let slot = slot?;
        *slot = Box::into_raw(Box::new(body(job)?));
        Ok(())
    })
}

/// Fills a struct of the caller's from a handle; each pointer with its name. The macro of the same
/// name says the names.
pub(crate) fn lend<'a, H: 'a, T: Versioned>(
    handle: (*const H, &'static str),
    out: (*mut T, &'static str),
    body: impl FnOnce(&'a H) -> Result<T, Failure>,
) -> gusset_status {
    guard(ptr::null(), |_| {
        let out = input::output_struct(out.0, out.1)?;
        out.write(body(input::reference(handle.0, handle.1)?)?);
        Ok(())
    })
}

/// Runs `body` with the context's job, or with the defaults if the context is NULL; records the
/// outcome in the context.
///
/// A panic becomes `GUSSET_ERROR_PANIC`: nothing unwinds into the host.
pub(crate) fn guard(
    context: *const gusset_context,
    body: impl FnOnce(&Job<'_>) -> Result<(), Failure>,
) -> gusset_status {
    let caught = catch_unwind(AssertUnwindSafe(|| gusset_context::run(context, body)));
    caught.unwrap_or_else(|panic| {
        // The payload's own destructor could panic; it is small and rare, so it is leaked.
        std::mem::forget(panic);
        gusset_status::GUSSET_ERROR_PANIC
    })
}

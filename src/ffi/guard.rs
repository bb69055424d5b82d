//! What becomes of a panic.

use super::status::{Failure, gusset_status};
use std::panic::{AssertUnwindSafe, catch_unwind};

/// Runs `body`, of which nothing unwinds into the host: a panic becomes `GUSSET_ERROR_PANIC`.
pub(crate) fn caught<T, E: From<Failure>>(body: impl FnOnce() -> Result<T, E>) -> Result<T, E> {
    catch_unwind(AssertUnwindSafe(body)).unwrap_or_else(|panic| {
        // The payload's own destructor could panic; it is small and rare, so it is leaked.
        std::mem::forget(panic);
        Err(Failure::new(gusset_status::GUSSET_ERROR_PANIC, "internal error: please report it").into())
    })
}

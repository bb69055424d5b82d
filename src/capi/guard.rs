//! What becomes of a panic.

use super::status::{Failure, gusset_status};
use std::panic::{AssertUnwindSafe, PanicHookInfo, catch_unwind, set_hook, take_hook};
use std::sync::OnceLock;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread::panicking;

/// What is told of a panic.
type Hook = dyn Fn(&PanicHookInfo<'_>) + Send + Sync;

/// Calls under way, in all threads: their own and those that they start may panic.
static CALLS: AtomicUsize = AtomicUsize::new(0);
/// What tells of panics outside of calls. The shared library has a standard library of its own,
/// where there are none; a Rust program that links this crate has.
static OUTSIDE: OnceLock<Box<Hook>> = OnceLock::new();

/// Lets panics in calls go untold; gives what told of them before. Neither box takes memory: that
/// of the standard library has no state, nor has this one.
fn silenced() -> Box<Hook> {
    let outside = take_hook();
    set_hook(Box::new(|info| {
        if let (0, Some(outside)) = (CALLS.load(Ordering::Relaxed), OUTSIDE.get()) {
            outside(info);
        }
    }));
    outside
}

/// A call under way.
struct Call;

impl Call {
    fn begin() -> Self {
        CALLS.fetch_add(1, Ordering::Relaxed);
        // A host's thread that panics may not change what tells of it.
        if !panicking() {
            OUTSIDE.get_or_init(silenced);
        }
        Call
    }
}

impl Drop for Call {
    fn drop(&mut self) {
        CALLS.fetch_sub(1, Ordering::Relaxed);
    }
}

/// Runs `body`, of which nothing unwinds into the host: a panic becomes `GUSSET_ERROR_PANIC`, and
/// prints nothing.
pub fn caught<T, E: From<Failure>>(body: impl FnOnce() -> Result<T, E>) -> Result<T, E> {
    let _call = Call::begin();
    catch_unwind(AssertUnwindSafe(body)).unwrap_or_else(|panic| {
        // The payload's own destructor could panic; it is small and rare, so it is leaked.
        std::mem::forget(panic);
        Err(Failure::new(gusset_status::GUSSET_ERROR_PANIC, "internal error: please report it").into())
    })
}

#[cfg(test)]
mod tests {
    use crate::capi::context::{
        guard, gusset_context, gusset_context_create, gusset_context_destroy, gusset_context_get_message,
    };
    use crate::capi::scene::{gusset_scene_add, gusset_scene_create, gusset_scene_destroy};
    use crate::capi::status::gusset_status::{GUSSET_ERROR_PANIC, GUSSET_OK};
    use std::ffi::CStr;
    use std::process::Command;
    use std::{env, panic, ptr, thread};

    /// Set in the process that panics: only another one can see what it prints.
    const PLANTED: &str = "GUSSET_TEST_PLANTED_PANIC";

    /// Panics within calls, in their threads and in those that they start, beside a handle made
    /// before.
    fn planted() {
        let (mut context, mut scene, mut group) = (ptr::null_mut::<gusset_context>(), ptr::null_mut(), 0);
        // SAFETY: each handle comes from its `_create` function and goes to its `_destroy` function
        // once.
        unsafe {
            assert_eq!(gusset_context_create(&raw mut context), GUSSET_OK);
            assert_eq!(gusset_scene_create(context, &raw mut scene), GUSSET_OK);
            for context in [context, ptr::null_mut()] {
                assert_eq!(guard(context, |_| panic!("planted")), GUSSET_ERROR_PANIC);
                let status = guard(context, |_| {
                    thread::scope(|scope| {
                        scope.spawn(|| panic!("planted"));
                    });
                    Ok(())
                });
                assert_eq!(status, GUSSET_ERROR_PANIC);
            }
            assert_eq!(guard(context, |_| panic!("planted")), GUSSET_ERROR_PANIC);
            assert_eq!(CStr::from_ptr(gusset_context_get_message(context)), c"internal error: please report it");
            assert_eq!(gusset_scene_add(context, scene, ptr::null(), &raw mut group), GUSSET_OK);
            assert_eq!(CStr::from_ptr(gusset_context_get_message(context)), c"");
            gusset_scene_destroy(scene);
            gusset_context_destroy(context);
        }
    }

    #[test]
    fn a_panic_is_a_status_and_prints_nothing() {
        if env::var_os(PLANTED).is_some() {
            planted();
            // Between calls panics are told as ever.
            let _ = panic::catch_unwind(|| panic!("of the host"));
            return;
        }
        let own = thread::current().name().unwrap().to_owned();
        let mut child = Command::new(env::current_exe().unwrap());
        let child =
            child.args([&own, "--exact", "--nocapture", "--test-threads=1"]).env(PLANTED, "1").output().unwrap();
        let [out, err] = [child.stdout, child.stderr].map(|text| String::from_utf8(text).unwrap());
        assert!(child.status.success() && out.contains("1 passed"), "{out}{err}");
        assert!(!err.contains("planted") && err.matches("panicked at").count() == 1, "{err}");
        assert!(err.contains("of the host"), "{err}");
    }
}

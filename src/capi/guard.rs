//! Panics: turns them into a status, and silences the panic hook during calls.

use super::status::{Failure, gusset_status};
use std::panic::{AssertUnwindSafe, PanicHookInfo, catch_unwind, set_hook, take_hook};
use std::sync::OnceLock;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread::panicking;

/// A panic hook.
type PanicHook = dyn Fn(&PanicHookInfo<'_>) + Send + Sync;

/// The number of calls in progress, over all threads. A panic in these threads, or in threads that
/// they start, must stay silent.
static CALLS_IN_PROGRESS: AtomicUsize = AtomicUsize::new(0);
/// The panic hook that was installed before this library's. It is called for panics outside calls,
/// as a Rust program that links this crate can have. The shared library has its own copy of the
/// standard library, where such panics do not occur.
static HOOK_OUTSIDE_CALLS: OnceLock<Box<PanicHook>> = OnceLock::new();

/// Installs a hook that is silent during calls, and returns the previous hook. Neither box
/// allocates: the standard library's hook and this one have no state.
fn install_silent_hook() -> Box<PanicHook> {
    let outside = take_hook();
    set_hook(Box::new(|info| {
        if let (0, Some(outside)) = (CALLS_IN_PROGRESS.load(Ordering::Relaxed), HOOK_OUTSIDE_CALLS.get()) {
            outside(info);
        }
    }));
    outside
}

/// A call in progress, in any thread. Panics are silent while one exists.
struct CallWithSilentPanics;

impl CallWithSilentPanics {
    fn begin_silent_call() -> Self {
        CALLS_IN_PROGRESS.fetch_add(1, Ordering::Relaxed);
        // A host's thread that is panicking must not change the hook.
        if !panicking() {
            HOOK_OUTSIDE_CALLS.get_or_init(install_silent_hook);
        }
        CallWithSilentPanics
    }
}

impl Drop for CallWithSilentPanics {
    fn drop(&mut self) {
        CALLS_IN_PROGRESS.fetch_sub(1, Ordering::Relaxed);
    }
}

/// Runs `body` and catches panics, which must not unwind into the host. A panic becomes
/// `GUSSET_ERROR_PANIC` and prints nothing.
pub fn catch_panic<T, E: From<Failure>>(body: impl FnOnce() -> Result<T, E>) -> Result<T, E> {
    let _call = CallWithSilentPanics::begin_silent_call();
    catch_unwind(AssertUnwindSafe(body)).unwrap_or_else(|panic| {
        // The payload's own destructor could panic. The payload is small and rare, so leak it.
        std::mem::forget(panic);
        Err(Failure::new(gusset_status::GUSSET_ERROR_PANIC, "internal error: please report it with the input").into())
    })
}

#[cfg(test)]
mod tests {
    use crate::capi::context::{
        guard_call, gusset_context, gusset_context_create, gusset_context_destroy, gusset_context_get_message,
    };
    use crate::capi::scene::{gusset_scene_add, gusset_scene_create, gusset_scene_destroy};
    use crate::capi::status::gusset_status::{GUSSET_ERROR_PANIC, GUSSET_OK};
    use std::ffi::CStr;
    use std::process::Command;
    use std::{env, panic, ptr, thread};

    /// Set in the process that panics, because only another process can see its output.
    const PLANTED_PANIC_VARIABLE: &str = "GUSSET_TEST_PLANTED_PANIC";

    /// Panics within calls, in their threads and in threads that they start, next to an existing
    /// handle.
    fn panic_within_calls() {
        let (mut context, mut scene, mut group) = (ptr::null_mut::<gusset_context>(), ptr::null_mut(), 0);
        // SAFETY: each handle comes from its `_create` function and is passed to its `_destroy`
        // function once.
        unsafe {
            assert_eq!(gusset_context_create(&raw mut context), GUSSET_OK);
            assert_eq!(gusset_scene_create(context, &raw mut scene), GUSSET_OK);
            for context in [context, ptr::null_mut()] {
                assert_eq!(guard_call(context, |_| panic!("planted")), GUSSET_ERROR_PANIC);
                let status = guard_call(context, |_| {
                    thread::scope(|scope| {
                        scope.spawn(|| panic!("planted"));
                    });
                    Ok(())
                });
                assert_eq!(status, GUSSET_ERROR_PANIC);
            }
            assert_eq!(guard_call(context, |_| panic!("planted")), GUSSET_ERROR_PANIC);
            assert_eq!(
                CStr::from_ptr(gusset_context_get_message(context)),
                c"internal error: please report it with the input"
            );
            assert_eq!(gusset_scene_add(context, scene, ptr::null(), &raw mut group), GUSSET_OK);
            assert_eq!(CStr::from_ptr(gusset_context_get_message(context)), c"");
            gusset_scene_destroy(scene);
            gusset_context_destroy(context);
        }
    }

    #[test]
    fn a_panic_is_a_status_and_prints_nothing() {
        if env::var_os(PLANTED_PANIC_VARIABLE).is_some() {
            panic_within_calls();
            // Between calls, panics are printed as usual.
            let _ = panic::catch_unwind(|| panic!("of the host"));
            return;
        }
        let own = thread::current().name().unwrap().to_owned();
        let mut child = Command::new(env::current_exe().unwrap());
        let child = child
            .args([&own, "--exact", "--nocapture", "--test-threads=1"])
            .env(PLANTED_PANIC_VARIABLE, "1")
            .output()
            .unwrap();
        let [out, err] = [child.stdout, child.stderr].map(|text| String::from_utf8(text).unwrap());
        assert!(child.status.success() && out.contains("1 passed"), "{out}{err}");
        assert!(!err.contains("planted") && err.matches("panicked at").count() == 1, "{err}");
        assert!(err.contains("of the host"), "{err}");
    }
}

//! Threads that end before the call returns.
//!
//! The standard library aborts if it cannot allocate the record of a new thread. On systems with
//! POSIX threads, this module uses those instead.

#![allow(unsafe_code, reason = "POSIX threads, which borrow from the thread that starts them")]

use std::sync::{Mutex, MutexGuard, TryLockError};
use std::thread;

/// Runs `lead` on the calling thread and `help` on at most `helpers` others, and returns when all
/// have returned. `lead` receives the number of threads that were started. A thread that cannot be
/// started is not an error. A panic on any thread is propagated.
pub fn run_beside(helpers: usize, help: &(dyn Fn() + Sync), lead: &mut dyn FnMut(usize)) {
    if helpers == 0 {
        return lead(0);
    }
    started::run_beside(helpers, help, lead);
}

/// Returns the number of processors on which the calling thread may run, at least 1.
///
/// It opens no files: sandboxes may end a process that does. The standard library would read the
/// control groups of the process. Processor time that they limit is therefore not taken into
/// account.
#[cfg(target_os = "linux")]
pub fn count_processors() -> usize {
    // The kernel refuses a mask with fewer bits than processors. It supports at most 8192.
    let mut mask = [0_u64; 1024];
    // SAFETY: the call writes at most the given number of bytes, which the mask has.
    let written = unsafe { libc::sched_getaffinity(0, size_of_val(&mask), mask.as_mut_ptr().cast()) };
    if written == 0 { mask.iter().map(|bits| bits.count_ones() as usize).sum::<usize>().max(1) } else { 1 }
}

/// Returns the number of threads that the system advises, at least 1.
#[cfg(not(target_os = "linux"))]
pub fn count_processors() -> usize {
    thread::available_parallelism().map_or(1, usize::from)
}

/// Locks a mutex that is held for a few instructions at a time. It spins instead of sleeping,
/// because the thread sanitizer cannot see how the standard library sleeps. A panic does not poison
/// the data, since no update takes two steps.
pub fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    loop {
        match mutex.try_lock() {
            Ok(guard) => return guard,
            Err(TryLockError::Poisoned(panicked)) => return panicked.into_inner(),
            Err(TryLockError::WouldBlock) => thread::yield_now(),
        }
    }
}

#[cfg(unix)]
mod started {
    use super::lock;
    use crate::alloc;
    use libc::{c_void, pthread_attr_t, pthread_t};
    use std::any::Any;
    use std::mem::MaybeUninit;
    use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
    use std::ptr;
    use std::sync::{Mutex, PoisonError};

    /// The stack size in bytes, equal to the standard library's default.
    const STACK_BYTES: usize = 2 << 20;

    /// The data that the threads share.
    struct SharedWork<'a> {
        help: &'a (dyn Fn() + Sync),
        panic: Mutex<Option<Box<dyn Any + Send>>>,
    }

    extern "C" fn run_helper_thread(shared: *mut c_void) -> *mut c_void {
        // SAFETY: the starting thread joins this one before it drops `shared`.
        let shared = unsafe { &*shared.cast::<SharedWork<'_>>() };
        if let Err(panic) = catch_unwind(AssertUnwindSafe(shared.help)) {
            *lock(&shared.panic) = Some(panic);
        }
        ptr::null_mut()
    }

    /// Running threads, which are joined on drop, even after a panic.
    struct RunningThreads(Vec<pthread_t>);

    impl Drop for RunningThreads {
        fn drop(&mut self) {
            for &thread in &self.0 {
                // SAFETY: the thread was started and is joined once.
                unsafe { libc::pthread_join(thread, ptr::null_mut()) };
            }
        }
    }

    /// Starts a thread. Returns `None` if the system refuses.
    fn start_thread(shared: &SharedWork<'_>) -> Option<pthread_t> {
        let (mut attributes, mut thread) =
            (MaybeUninit::<pthread_attr_t>::uninit(), MaybeUninit::<pthread_t>::uninit());
        // SAFETY: the attributes are initialised, used and destroyed. `shared` is `Sync` and
        // outlives the thread, because the caller joins it.
        unsafe {
            if libc::pthread_attr_init(attributes.as_mut_ptr()) != 0 {
                return None;
            }
            libc::pthread_attr_setstacksize(attributes.as_mut_ptr(), STACK_BYTES);
            let argument = ptr::from_ref(shared).cast_mut().cast();
            let failed = libc::pthread_create(thread.as_mut_ptr(), attributes.as_ptr(), run_helper_thread, argument);
            libc::pthread_attr_destroy(attributes.as_mut_ptr());
            (failed == 0).then(|| thread.assume_init())
        }
    }

    pub(super) fn run_beside(helpers: usize, help: &(dyn Fn() + Sync), lead: &mut dyn FnMut(usize)) {
        let shared = SharedWork { help, panic: Mutex::new(None) };
        // Starts no threads if their list cannot be allocated.
        let mut threads = RunningThreads(alloc::with_capacity(helpers).unwrap_or_default());
        while threads.0.len() < helpers.min(threads.0.capacity())
            && let Some(thread) = start_thread(&shared)
        {
            threads.0.push(thread);
        }
        lead(threads.0.len());
        drop(threads);
        if let Some(panic) = shared.panic.into_inner().unwrap_or_else(PoisonError::into_inner) {
            resume_unwind(panic);
        }
    }
}

#[cfg(not(unix))]
mod started {
    use std::thread;

    pub(super) fn run_beside(helpers: usize, help: &(dyn Fn() + Sync), lead: &mut dyn FnMut(usize)) {
        thread::scope(|scope| {
            let handles: Vec<_> =
                (0..helpers).map_while(|_| thread::Builder::new().spawn_scoped(scope, help).ok()).collect();
            lead(handles.len());
            for handle in handles {
                handle.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic));
            }
        });
    }
}

#[cfg(test)]
mod tests {
    use super::{count_processors, run_beside};
    use std::panic::{AssertUnwindSafe, catch_unwind};
    use std::sync::atomic::{AtomicUsize, Ordering};

    #[test]
    fn all_threads_return_and_a_panic_is_propagated() {
        for helpers in [0, 1, 7] {
            let (ran, mut helper_count) = (AtomicUsize::new(0), 0);
            let help = || {
                std::thread::yield_now();
                ran.fetch_add(1, Ordering::Relaxed);
            };
            run_beside(helpers, &help, &mut |others| helper_count = others);
            assert_eq!((helper_count, ran.load(Ordering::Relaxed)), (helpers, helpers));
            let own_panic = catch_unwind(AssertUnwindSafe(|| {
                run_beside(helpers, &help, &mut |_| std::panic::panic_any("this"));
            }));
            assert_eq!(*own_panic.unwrap_err().downcast::<&str>().unwrap(), "this");
            assert_eq!(ran.load(Ordering::Relaxed), 2 * helpers);
        }
        let fails = || std::panic::panic_any("another");
        let passed_on = catch_unwind(AssertUnwindSafe(|| run_beside(3, &fails, &mut |_| ())));
        assert_eq!(*passed_on.unwrap_err().downcast::<&str>().unwrap(), "another");
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn processors_are_those_of_the_thread() {
        let bind = |mask: &libc::cpu_set_t| {
            // SAFETY: the call reads the mask.
            unsafe { libc::sched_setaffinity(0, size_of_val(mask), mask) }
        };
        // Another thread, because the mask belongs to one.
        let bound = std::thread::spawn(move || {
            // SAFETY: a mask of zeros is valid, and the call writes at most its size.
            let (all, mut one) = unsafe {
                let mut all: libc::cpu_set_t = std::mem::zeroed();
                assert_eq!(libc::sched_getaffinity(0, size_of_val(&all), &raw mut all), 0);
                (all, std::mem::zeroed())
            };
            // SAFETY: all numbers are within the masks.
            let allowed: Vec<_> = (0..1024).filter(|&k| unsafe { libc::CPU_ISSET(k, &all) }).collect();
            assert_eq!(count_processors(), allowed.len());
            // SAFETY: as above.
            unsafe { libc::CPU_SET(allowed[allowed.len() - 1], &mut one) };
            (bind(&one), count_processors())
        });
        assert_eq!(bound.join().unwrap(), (0, 1));
    }
}

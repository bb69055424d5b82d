//! Memory that a computation takes. Only the fuzzers measure it: tests share their process with the library's own allocator.

use std::sync::atomic::{AtomicU64, Ordering::Relaxed};

static TAKEN: AtomicU64 = AtomicU64::new(0);
static LARGEST: AtomicU64 = AtomicU64::new(0);

/// Runs a computation. Returns its result and the largest memory in bytes that it took at a time: 0 in tests.
pub fn measured<T>(run: impl FnOnce() -> T) -> (T, u64) {
    let before = TAKEN.load(Relaxed);
    LARGEST.store(before, Relaxed);
    let result = run();
    (result, LARGEST.load(Relaxed) - before)
}

#[cfg(feature = "libfuzzer")]
mod counting {
    use super::{LARGEST, TAKEN};
    use std::alloc::{GlobalAlloc, Layout, System};
    use std::sync::atomic::Ordering::Relaxed;

    /// Counts the bytes of the system's allocator.
    struct Counting;

    #[global_allocator]
    static ALLOCATOR: Counting = Counting;

    fn add(bytes: usize) {
        let taken = TAKEN.fetch_add(bytes as u64, Relaxed) + bytes as u64;
        LARGEST.fetch_max(taken, Relaxed);
    }

    fn remove(bytes: usize) {
        TAKEN.fetch_sub(bytes as u64, Relaxed);
    }

    // SAFETY: passes each call on to the system's allocator.
    unsafe impl GlobalAlloc for Counting {
        unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
            add(layout.size());
            // SAFETY: the caller's promises are those that the system's allocator asks for.
            unsafe { System.alloc(layout) }
        }

        unsafe fn alloc_zeroed(&self, layout: Layout) -> *mut u8 {
            add(layout.size());
            // SAFETY: as above.
            unsafe { System.alloc_zeroed(layout) }
        }

        unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
            remove(layout.size());
            // SAFETY: as above.
            unsafe { System.dealloc(pointer, layout) }
        }

        unsafe fn realloc(&self, pointer: *mut u8, layout: Layout, size: usize) -> *mut u8 {
            add(size);
            remove(layout.size());
            // SAFETY: as above.
            unsafe { System.realloc(pointer, layout, size) }
        }
    }
}

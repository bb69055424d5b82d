//! Allocation within the module's memory, for hosts that run it as WebAssembly and cannot allocate there otherwise.

use std::alloc::{Layout, alloc, dealloc};
use std::ptr;

/// The alignment of every block. Numbers of the interface need at most this.
const ALIGN: usize = 16;

fn layout(size: usize) -> Option<Layout> {
    Layout::from_size_align(size, ALIGN).ok().filter(|layout| layout.size() > 0)
}

/// Allocates `size` bytes with unspecified content. Returns NULL for 0 bytes, or if memory runs out.
#[unsafe(no_mangle)]
pub extern "C" fn gusset_memory_allocate(size: usize) -> *mut u8 {
    // SAFETY: the layout has at least one byte.
    layout(size).map_or(ptr::null_mut(), |layout| unsafe { alloc(layout) })
}

/// Frees a block of `gusset_memory_allocate` with its size. NULL is allowed.
///
/// # Safety
/// `block` is NULL, or a block of this size that is freed once.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gusset_memory_free(block: *mut u8, size: usize) {
    if let Some(layout) = layout(size).filter(|_| !block.is_null()) {
        // SAFETY: the caller's promise.
        unsafe { dealloc(block, layout) };
    }
}

#[cfg(test)]
mod tests {
    use super::{ALIGN, gusset_memory_allocate, gusset_memory_free};

    #[test]
    fn blocks_are_aligned_and_refused_sizes_are_null() {
        assert!(gusset_memory_allocate(0).is_null() && gusset_memory_allocate(usize::MAX).is_null());
        for size in [1, 17, 4096] {
            let block = gusset_memory_allocate(size);
            assert!(!block.is_null() && block.addr().is_multiple_of(ALIGN));
            // SAFETY: a block of this size, freed once.
            unsafe {
                block.write_bytes(7, size);
                gusset_memory_free(block, size);
            }
        }
        // SAFETY: NULL is allowed.
        unsafe { gusset_memory_free(std::ptr::null_mut(), 0) };
    }
}

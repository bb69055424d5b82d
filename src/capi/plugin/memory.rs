//! Allocation within the library's memory, for hosts that run it as WebAssembly and cannot allocate
//! there otherwise.

use gusset_base::reserve;
use std::alloc::{Layout, alloc, dealloc};
use std::ptr;

/// The alignment of every block. Numbers of the interface need at most this.
const BLOCK_ALIGNMENT: usize = 16;

fn block_layout(size: usize) -> Option<Layout> {
    Layout::from_size_align(size, BLOCK_ALIGNMENT).ok().filter(|layout| layout.size() > 0)
}

/// Allocates `size` bytes with unspecified content. Returns NULL for 0 bytes, or if memory runs
/// out. Never draws on the reserve for calls that cannot fail.
#[unsafe(no_mangle)]
pub extern "C" fn gusset_memory_allocate(size: usize) -> *mut u8 {
    let Some(layout) = block_layout(size) else { return ptr::null_mut() };
    // SAFETY: a layout of more than no bytes.
    let block = unsafe { alloc(layout) };
    if reserve::contains_block(block) {
        // SAFETY: a block of that layout, which nobody has.
        unsafe { dealloc(block, layout) };
        return ptr::null_mut();
    }
    block
}

/// Frees a block of gusset_memory_allocate with its size; NULL is allowed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gusset_memory_free(block: *mut u8, size: usize) {
    if let Some(layout) = block_layout(size).filter(|_| !block.is_null()) {
        // SAFETY: the caller's promise: a block of that layout.
        unsafe { dealloc(block, layout) };
    }
}

#[cfg(test)]
mod tests {
    use super::{BLOCK_ALIGNMENT, gusset_memory_allocate, gusset_memory_free};

    #[test]
    fn blocks_are_aligned_and_what_cannot_be_is_null() {
        assert!(gusset_memory_allocate(0).is_null() && gusset_memory_allocate(usize::MAX).is_null());
        let blocks = [1, 17, 4096].map(|size| (gusset_memory_allocate(size), size));
        for (block, size) in blocks {
            assert!(!block.is_null() && block.addr().is_multiple_of(BLOCK_ALIGNMENT));
            // SAFETY: a block of that size, given back once.
            unsafe {
                block.write_bytes(7, size);
                gusset_memory_free(block, size);
            }
        }
        // SAFETY: NULL is allowed.
        unsafe { gusset_memory_free(std::ptr::null_mut(), 0) };
    }
}

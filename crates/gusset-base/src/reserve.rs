//! A reserve of memory for the moment when the system runs out. Only the libraries for C have it
//! (feature `reserve`), because a Rust program chooses its own allocator.
//!
//! Memory that grows with the input is requested through `alloc`, where a refusal is an error. The
//! standard library and third-party crates also make small allocations that cannot fail without
//! aborting. If the system refuses one of these, the allocator serves it from the reserve. The job
//! of the call notices at its next step ([`bytes_drawn_since_start`]) and ends the call with an error, which
//! frees the memory.
//!
//! The reserve is static and divided into arenas, in which blocks lie one behind another. An arena
//! is reset when its last block is freed. The state of an arena is one number that threads change
//! by compare-and-swap. It needs no lock that a suspended thread could hold, and no thread-local
//! data.

#![allow(unsafe_code, reason = "an allocator")]

/// Returns the number of bytes taken from the reserve since the program began. Two equal readings
/// mean that nothing was taken in between.
#[inline]
pub fn bytes_drawn_since_start() -> u64 {
    #[cfg(feature = "reserve")]
    return arenas::RESERVE_ARENAS.drawn.load(std::sync::atomic::Ordering::Relaxed);
    #[cfg(not(feature = "reserve"))]
    0
}

/// Returns true if a block lies in the reserve: the system has refused memory, and a call still holds what replaced it.
#[inline]
pub fn holds_blocks() -> bool {
    #[cfg(feature = "reserve")]
    return bytes_drawn_since_start() > 0 && arenas::RESERVE_ARENAS.holds_blocks();
    #[cfg(not(feature = "reserve"))]
    false
}

/// Returns true if the block lies in the reserve.
#[inline]
pub fn contains_block<T>(block: *const T) -> bool {
    #[cfg(feature = "reserve")]
    return arenas::RESERVE_ARENAS.offset_of(block.cast()).is_some();
    #[cfg(not(feature = "reserve"))]
    {
        let _ = block;
        false
    }
}

#[cfg(feature = "reserve")]
pub use arenas::ReserveBackedAllocator;

#[cfg(feature = "reserve")]
mod arenas {
    use std::alloc::{GlobalAlloc, Layout, System};
    use std::cell::UnsafeCell;
    use std::ptr;
    use std::sync::atomic::{AtomicPtr, AtomicU64, AtomicUsize, Ordering};

    const ARENA_COUNT: usize = 32;
    /// The size of one arena in bytes, and the largest block that the reserve serves.
    const ARENA_BYTES: usize = 1 << 17;
    const MAX_ALIGN_BYTES: usize = 64;

    /// The memory of the reserve, and its allocation state. A static that is all zeros takes no
    /// space in the executable and no physical memory until it is used.
    #[repr(C, align(64))]
    pub(super) struct ReserveArenas {
        bytes: UnsafeCell<[u8; ARENA_COUNT * ARENA_BYTES]>,
        /// The state of each arena. The low half is the number of bytes in use, the high half the
        /// number of live blocks.
        states: [AtomicU64; ARENA_COUNT],
        pub(super) drawn: AtomicU64,
    }

    // SAFETY: the bytes are accessed only through blocks, and the states give each block one owner.
    unsafe impl Sync for ReserveArenas {}

    pub(super) static RESERVE_ARENAS: ReserveArenas = ReserveArenas {
        bytes: UnsafeCell::new([0; ARENA_COUNT * ARENA_BYTES]),
        states: [const { AtomicU64::new(0) }; ARENA_COUNT],
        drawn: AtomicU64::new(0),
    };

    /// One block in the state of an arena.
    const BLOCK_COUNT_INCREMENT: u64 = 1 << 32;

    fn used_bytes(state: u64) -> usize {
        (state & (BLOCK_COUNT_INCREMENT - 1)) as usize
    }

    impl ReserveArenas {
        /// Returns the offset of a block in the reserve, if the block lies there.
        #[inline]
        pub(super) fn offset_of(&self, block: *const u8) -> Option<usize> {
            let offset = (block as usize).wrapping_sub(self.bytes.get() as usize);
            (offset < ARENA_COUNT * ARENA_BYTES).then_some(offset)
        }

        pub(super) fn holds_blocks(&self) -> bool {
            self.states.iter().any(|state| state.load(Ordering::Relaxed) != 0)
        }

        /// Allocates a block from the reserve; returns null if no arena has room.
        #[cold]
        #[inline(never)]
        fn allocate_from_arena(&self, layout: Layout) -> *mut u8 {
            if layout.align() > MAX_ALIGN_BYTES || layout.size() > ARENA_BYTES {
                return ptr::null_mut();
            }
            for (arena, state) in self.states.iter().enumerate() {
                let mut start = 0;
                let taken = state.fetch_update(Ordering::AcqRel, Ordering::Acquire, |now| {
                    start = used_bytes(now).next_multiple_of(layout.align());
                    let end = start + layout.size();
                    (end <= ARENA_BYTES)
                        .then(|| (now & !(BLOCK_COUNT_INCREMENT - 1)) + BLOCK_COUNT_INCREMENT + end as u64)
                });
                if taken.is_ok() {
                    self.drawn.fetch_add(layout.size() as u64, Ordering::Relaxed);
                    return self.bytes.get().cast::<u8>().wrapping_add(arena * ARENA_BYTES + start);
                }
            }
            ptr::null_mut()
        }

        /// Frees a block. An arena without blocks is reset. If the block was the last one of its
        /// arena, its room is reused.
        #[cold]
        #[inline(never)]
        fn free_in_arena(&self, offset: usize, size: usize) {
            let start = offset % ARENA_BYTES;
            let _ = self.states[offset / ARENA_BYTES].fetch_update(Ordering::AcqRel, Ordering::Acquire, |now| {
                let end = if used_bytes(now) == start + size { start } else { used_bytes(now) };
                Some(if now >> 32 == 1 {
                    0
                } else {
                    (now & !(BLOCK_COUNT_INCREMENT - 1)) - BLOCK_COUNT_INCREMENT + end as u64
                })
            });
        }
    }

    /// The origin of a block that grew into the reserve: the system's block, which is kept until
    /// the block in the reserve is freed. A vector that must not stay in the reserve thus returns
    /// to its old block without allocating.
    struct BlockOrigin {
        block: AtomicPtr<u8>,
        from: AtomicPtr<u8>,
        size: AtomicUsize,
    }

    static BLOCK_ORIGINS: [BlockOrigin; 64] = [const {
        BlockOrigin {
            block: AtomicPtr::new(ptr::null_mut()),
            from: AtomicPtr::new(ptr::null_mut()),
            size: AtomicUsize::new(0),
        }
    }; 64];

    impl BlockOrigin {
        /// Records the origin of a block. Returns false if the table is full.
        fn record_origin(block: *mut u8, from: *mut u8, size: usize) -> bool {
            let free = |record: &&BlockOrigin| {
                let none = ptr::null_mut();
                record.block.compare_exchange(none, block, Ordering::AcqRel, Ordering::Relaxed).is_ok()
            };
            BLOCK_ORIGINS.iter().find(free).is_some_and(|record| {
                record.from.store(from, Ordering::Relaxed);
                record.size.store(size, Ordering::Relaxed);
                true
            })
        }

        /// Removes and returns the origin of a block and its size.
        fn remove_origin(block: *mut u8) -> Option<(*mut u8, usize)> {
            let record = BLOCK_ORIGINS.iter().find(|record| record.block.load(Ordering::Acquire) == block)?;
            let origin = (record.from.load(Ordering::Relaxed), record.size.load(Ordering::Relaxed));
            record.block.store(ptr::null_mut(), Ordering::Release);
            Some(origin)
        }
    }

    /// Reallocates a block to another size. Returns null and leaves `block` unchanged if there is
    /// no memory.
    ///
    /// # Safety
    /// The requirements of [`GlobalAlloc::realloc`].
    #[cold]
    #[inline(never)]
    unsafe fn reallocate(block: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        let Ok(new) = Layout::from_size_align(size, layout.align()) else { return ptr::null_mut() };
        let offset = RESERVE_ARENAS.offset_of(block);
        // SAFETY: the caller guarantees `block` and both sizes, which are not 0. A recorded origin
        // is a block of the system with the recorded size, and has no other owner.
        unsafe {
            if let Some(offset) = offset
                && let Some((from, before)) = BlockOrigin::remove_origin(block)
            {
                if before == size {
                    ptr::copy_nonoverlapping(block, from, layout.size().min(size));
                    RESERVE_ARENAS.free_in_arena(offset, layout.size());
                    return from;
                }
                System.dealloc(from, Layout::from_size_align_unchecked(before, layout.align()));
            }
            let made = ReserveBackedAllocator.alloc(new);
            if made.is_null() {
                return made;
            }
            ptr::copy_nonoverlapping(block, made, layout.size().min(size));
            let is_moved = offset.is_none() && RESERVE_ARENAS.offset_of(made).is_some();
            if !(is_moved && BlockOrigin::record_origin(made, block, layout.size())) {
                ReserveBackedAllocator.dealloc(block, layout);
            }
            made
        }
    }

    /// Frees a block of the reserve. If a system's block was moved there when it grew, frees that
    /// old block too.
    ///
    /// # Safety
    /// The requirements of [`GlobalAlloc::dealloc`].
    #[cold]
    #[inline(never)]
    unsafe fn free_block(block: *mut u8, offset: usize, layout: Layout) {
        if let Some((from, size)) = BlockOrigin::remove_origin(block) {
            // SAFETY: as in `reallocate`.
            unsafe { System.dealloc(from, Layout::from_size_align_unchecked(size, layout.align())) };
        }
        RESERVE_ARENAS.free_in_arena(offset, layout.size());
    }

    /// The system's allocator, backed by the reserve.
    pub struct ReserveBackedAllocator;

    // SAFETY: each block returns to the allocator that it came from, either the system's or the
    // reserve. Blocks of the reserve have the requested size and alignment, and one owner each.
    unsafe impl GlobalAlloc for ReserveBackedAllocator {
        unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
            // SAFETY: guaranteed by the caller.
            let block = unsafe { System.alloc(layout) };
            if block.is_null() { RESERVE_ARENAS.allocate_from_arena(layout) } else { block }
        }

        unsafe fn alloc_zeroed(&self, layout: Layout) -> *mut u8 {
            // SAFETY: guaranteed by the caller.
            let mut block = unsafe { System.alloc_zeroed(layout) };
            if block.is_null() {
                block = RESERVE_ARENAS.allocate_from_arena(layout);
                if !block.is_null() {
                    // SAFETY: the block has that size. It may have been used before.
                    unsafe { block.write_bytes(0, layout.size()) };
                }
            }
            block
        }

        unsafe fn dealloc(&self, block: *mut u8, layout: Layout) {
            match RESERVE_ARENAS.offset_of(block) {
                // SAFETY: guaranteed by the caller.
                Some(offset) => unsafe { free_block(block, offset, layout) },
                // SAFETY: guaranteed by the caller.
                None => unsafe { System.dealloc(block, layout) },
            }
        }

        unsafe fn realloc(&self, block: *mut u8, layout: Layout, size: usize) -> *mut u8 {
            if RESERVE_ARENAS.offset_of(block).is_none() {
                // SAFETY: guaranteed by the caller.
                let made = unsafe { System.realloc(block, layout, size) };
                if !made.is_null() {
                    return made;
                }
            }
            // SAFETY: guaranteed by the caller.
            unsafe { reallocate(block, layout, size) }
        }
    }

    #[cfg(test)]
    mod tests {
        use super::*;

        #[test]
        fn the_origin_of_a_moved_block_is_recorded() {
            let mut blocks = [[0_u8; 8]; 66];
            let blocks = blocks.each_mut().map(|block| block.as_mut_ptr());
            let noted = |k: usize| BlockOrigin::record_origin(blocks[k], blocks[k + 1], k);
            assert!((0..64).all(noted) && !noted(64));
            assert_eq!(BlockOrigin::remove_origin(blocks[7]), Some((blocks[8], 7)));
            assert!(BlockOrigin::remove_origin(blocks[7]).is_none() && noted(64) && !noted(7));
            assert_eq!(BlockOrigin::remove_origin(blocks[64]), Some((blocks[65], 64)));
            assert!((0..64).all(|k| BlockOrigin::remove_origin(blocks[k]).is_some() == (k != 7)));
        }

        #[test]
        fn blocks_of_the_reserve_are_disjoint_and_are_reused() {
            // A separate reserve, because jobs of other tests would find the program's reserve in
            // use.
            static TEST_ARENAS: ReserveArenas = ReserveArenas {
                bytes: UnsafeCell::new([0; ARENA_COUNT * ARENA_BYTES]),
                states: [const { AtomicU64::new(0) }; ARENA_COUNT],
                drawn: AtomicU64::new(0),
            };
            let of = |size, align| Layout::from_size_align(size, align).unwrap();
            let unused = || !TEST_ARENAS.holds_blocks();
            let mut held = Vec::new();
            for k in 0.. {
                let layout = of(1 + k * 7919 % 9000, 1 << (k % 7));
                let block = TEST_ARENAS.allocate_from_arena(layout);
                if block.is_null() {
                    break;
                }
                assert!(block.addr().is_multiple_of(layout.align()) && TEST_ARENAS.offset_of(block).is_some());
                assert!(RESERVE_ARENAS.offset_of(block).is_none());
                // SAFETY: the block has that size.
                unsafe { block.write_bytes(k as u8, layout.size()) };
                held.push((block, layout));
            }
            let total: usize = held.iter().map(|(_, layout)| layout.size()).sum();
            assert!(total > ARENA_COUNT * ARENA_BYTES * 3 / 4, "{total}");
            assert_eq!(TEST_ARENAS.drawn.load(Ordering::Relaxed), total as u64);
            for (k, &(block, layout)) in held.iter().enumerate() {
                // SAFETY: as above.
                let bytes = unsafe { std::slice::from_raw_parts(block, layout.size()) };
                assert!(bytes.iter().all(|&byte| byte == k as u8));
            }
            for refused in [of(ARENA_BYTES, 1), of(ARENA_BYTES + 1, 1), of(1, 128)] {
                assert!(TEST_ARENAS.allocate_from_arena(refused).is_null());
            }
            held.drain(..).for_each(|(block, layout)| {
                TEST_ARENAS.free_in_arena(TEST_ARENAS.offset_of(block).unwrap(), layout.size());
            });
            assert!(unused());
            // Freed blocks are reused: many small ones in turn take the room of one.
            let kept = TEST_ARENAS.allocate_from_arena(of(8, 8));
            for _ in 0..ARENA_BYTES {
                let block = TEST_ARENAS.allocate_from_arena(of(64, 8));
                TEST_ARENAS.free_in_arena(TEST_ARENAS.offset_of(block).unwrap(), 64);
            }
            assert!(TEST_ARENAS.states[1..].iter().all(|state| state.load(Ordering::Relaxed) == 0));
            TEST_ARENAS.free_in_arena(TEST_ARENAS.offset_of(kept).unwrap(), 8);
            assert!(unused());
        }

        #[test]
        fn blocks_of_many_threads_are_disjoint() {
            static TEST_ARENAS: ReserveArenas = ReserveArenas {
                bytes: UnsafeCell::new([0; ARENA_COUNT * ARENA_BYTES]),
                states: [const { AtomicU64::new(0) }; ARENA_COUNT],
                drawn: AtomicU64::new(0),
            };
            std::thread::scope(|scope| {
                for name in 1..=4_u8 {
                    scope.spawn(move || {
                        for round in 0..2000 {
                            let layout = Layout::from_size_align(1 + round * 31 % 3000, 8).unwrap();
                            let blocks = [0; 5].map(|_| TEST_ARENAS.allocate_from_arena(layout));
                            for block in blocks {
                                assert!(!block.is_null());
                                // SAFETY: the block has that size and belongs to this thread.
                                unsafe { block.write_bytes(name, layout.size()) };
                            }
                            std::thread::yield_now();
                            for block in blocks {
                                // SAFETY: as above.
                                let bytes = unsafe { std::slice::from_raw_parts(block, layout.size()) };
                                assert!(bytes.iter().all(|&byte| byte == name));
                                TEST_ARENAS.free_in_arena(TEST_ARENAS.offset_of(block).unwrap(), layout.size());
                            }
                        }
                    });
                }
            });
            assert!(TEST_ARENAS.states.iter().all(|state| state.load(Ordering::Relaxed) == 0));
        }
    }
}

//! A reserve of memory for the moment at which the system has none: part of the libraries for C
//! only (feature `reserve`), as the allocator of a Rust program is that program's choice.
//!
//! What grows with the input is asked for by `alloc`, where failure is an error. The standard
//! library and crates make small allocations on their own, which cannot fail but by abort. When
//! the system refuses one of these, it is taken from the reserve; the job of the call sees that at
//! its next step ([`drawn`]) and ends the call with an error, which gives the memory back.
//!
//! The reserve is static, cut into arenas in which blocks lie one behind another. An arena begins
//! anew when its last block is given back. Its state is one number, changed by compare-and-swap: no
//! lock, which a thread could hold while it is stopped, and nothing that belongs to a thread.

#![allow(unsafe_code, reason = "an allocator")]

/// Bytes taken from the reserve since the program began. Of two equal readings, none was between.
#[inline]
pub fn drawn() -> u64 {
    #[cfg(feature = "reserve")]
    return arenas::RESERVE.drawn.load(std::sync::atomic::Ordering::Relaxed);
    #[cfg(not(feature = "reserve"))]
    0
}

/// Whether a block is in the reserve.
#[inline]
pub fn holds<T>(block: *const T) -> bool {
    #[cfg(feature = "reserve")]
    return arenas::RESERVE.offset_of(block.cast()).is_some();
    #[cfg(not(feature = "reserve"))]
    {
        let _ = block;
        false
    }
}

#[cfg(feature = "reserve")]
pub use arenas::Backed;

#[cfg(feature = "reserve")]
mod arenas {
    use std::alloc::{GlobalAlloc, Layout, System};
    use std::cell::UnsafeCell;
    use std::ptr;
    use std::sync::atomic::{AtomicPtr, AtomicU64, AtomicUsize, Ordering};

    const ARENAS: usize = 32;
    /// Bytes of one arena, and thus of the largest block.
    const ARENA: usize = 1 << 16;
    const MAX_ALIGN: usize = 64;

    /// Memory, and what of it is in use. Of a static one that begins with zeros, the program's file
    /// and its memory hold nothing before it is used.
    #[repr(C, align(64))]
    pub(super) struct Arenas {
        bytes: UnsafeCell<[u8; ARENAS * ARENA]>,
        /// Of each arena: below, how far it is used; above, its blocks that are in use.
        states: [AtomicU64; ARENAS],
        pub(super) drawn: AtomicU64,
    }

    // SAFETY: the bytes are touched through blocks only, which the states give to one owner each.
    unsafe impl Sync for Arenas {}

    pub(super) static RESERVE: Arenas = Arenas {
        bytes: UnsafeCell::new([0; ARENAS * ARENA]),
        states: [const { AtomicU64::new(0) }; ARENAS],
        drawn: AtomicU64::new(0),
    };

    /// One block in the state of an arena.
    const ONE: u64 = 1 << 32;

    fn used(state: u64) -> usize {
        (state & (ONE - 1)) as usize
    }

    impl Arenas {
        /// Where a block begins in the reserve, if it does.
        #[inline]
        pub(super) fn offset_of(&self, block: *const u8) -> Option<usize> {
            let offset = (block as usize).wrapping_sub(self.bytes.get() as usize);
            (offset < ARENAS * ARENA).then_some(offset)
        }

        /// A block of the reserve; null if it has none of that size.
        #[cold]
        #[inline(never)]
        fn draw(&self, layout: Layout) -> *mut u8 {
            if layout.align() > MAX_ALIGN || layout.size() > ARENA {
                return ptr::null_mut();
            }
            for (arena, state) in self.states.iter().enumerate() {
                let mut start = 0;
                let taken = state.fetch_update(Ordering::AcqRel, Ordering::Acquire, |now| {
                    start = used(now).next_multiple_of(layout.align());
                    let end = start + layout.size();
                    (end <= ARENA).then(|| (now & !(ONE - 1)) + ONE + end as u64)
                });
                if taken.is_ok() {
                    self.drawn.fetch_add(layout.size() as u64, Ordering::Relaxed);
                    return self.bytes.get().cast::<u8>().wrapping_add(arena * ARENA + start);
                }
            }
            ptr::null_mut()
        }

        /// Takes a block back: an arena without blocks begins anew, and behind the last block there
        /// is room.
        #[cold]
        #[inline(never)]
        fn give_back(&self, offset: usize, size: usize) {
            let start = offset % ARENA;
            let _ = self.states[offset / ARENA].fetch_update(Ordering::AcqRel, Ordering::Acquire, |now| {
                let end = if used(now) == start + size { start } else { used(now) };
                Some(if now >> 32 == 1 { 0 } else { (now & !(ONE - 1)) - ONE + end as u64 })
            });
        }
    }

    /// Where a block of the reserve came from when it grew: the system's block, which is kept until
    /// the other is given back. A vector that must not be in the reserve returns to it, and needs
    /// no memory for that.
    struct Move {
        block: AtomicPtr<u8>,
        from: AtomicPtr<u8>,
        size: AtomicUsize,
    }

    static MOVES: [Move; 64] = [const {
        Move {
            block: AtomicPtr::new(ptr::null_mut()),
            from: AtomicPtr::new(ptr::null_mut()),
            size: AtomicUsize::new(0),
        }
    }; 64];

    impl Move {
        /// Notes where a block came from; false if there is no room for that.
        fn note(block: *mut u8, from: *mut u8, size: usize) -> bool {
            let free = |of: &&Move| {
                let none = ptr::null_mut();
                of.block.compare_exchange(none, block, Ordering::AcqRel, Ordering::Relaxed).is_ok()
            };
            MOVES.iter().find(free).is_some_and(|own| {
                own.from.store(from, Ordering::Relaxed);
                own.size.store(size, Ordering::Relaxed);
                true
            })
        }

        /// Where a block came from, and how large that is; it is noted no longer.
        fn take(block: *mut u8) -> Option<(*mut u8, usize)> {
            let own = MOVES.iter().find(|of| of.block.load(Ordering::Acquire) == block)?;
            let found = (own.from.load(Ordering::Relaxed), own.size.load(Ordering::Relaxed));
            own.block.store(ptr::null_mut(), Ordering::Release);
            Some(found)
        }
    }

    /// A block of another size with the same content; `block` is as it was if there is none.
    ///
    /// # Safety
    /// That of `realloc`.
    #[cold]
    #[inline(never)]
    unsafe fn moved(block: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        let Ok(new) = Layout::from_size_align(size, layout.align()) else { return ptr::null_mut() };
        let offset = RESERVE.offset_of(block);
        // SAFETY: the caller's promises on `block` and the two sizes, neither of which is 0; what
        // was noted is the system's, has that size, and nobody else has it.
        unsafe {
            if let Some(offset) = offset
                && let Some((from, before)) = Move::take(block)
            {
                if before == size {
                    ptr::copy_nonoverlapping(block, from, layout.size().min(size));
                    RESERVE.give_back(offset, layout.size());
                    return from;
                }
                System.dealloc(from, Layout::from_size_align_unchecked(before, layout.align()));
            }
            let made = Backed.alloc(new);
            if made.is_null() {
                return made;
            }
            ptr::copy_nonoverlapping(block, made, layout.size().min(size));
            let is_moved = offset.is_none() && RESERVE.offset_of(made).is_some();
            if !(is_moved && Move::note(made, block, layout.size())) {
                Backed.dealloc(block, layout);
            }
            made
        }
    }

    /// Takes a block of the reserve back, and what it came from.
    ///
    /// # Safety
    /// That of `dealloc`.
    #[cold]
    #[inline(never)]
    unsafe fn free(block: *mut u8, offset: usize, layout: Layout) {
        if let Some((from, size)) = Move::take(block) {
            // SAFETY: as in `moved`.
            unsafe { System.dealloc(from, Layout::from_size_align_unchecked(size, layout.align())) };
        }
        RESERVE.give_back(offset, layout.size());
    }

    /// The system's allocator, with the reserve behind it.
    pub struct Backed;

    // SAFETY: blocks of the system's allocator go back to it, and those of the reserve, which have
    // the size and the alignment that were asked for and one owner each, to the reserve.
    unsafe impl GlobalAlloc for Backed {
        unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
            // SAFETY: the caller's promises.
            let block = unsafe { System.alloc(layout) };
            if block.is_null() { RESERVE.draw(layout) } else { block }
        }

        unsafe fn alloc_zeroed(&self, layout: Layout) -> *mut u8 {
            // SAFETY: the caller's promises.
            let mut block = unsafe { System.alloc_zeroed(layout) };
            if block.is_null() {
                block = RESERVE.draw(layout);
                if !block.is_null() {
                    // SAFETY: a block of that size. It may have been used before.
                    unsafe { block.write_bytes(0, layout.size()) };
                }
            }
            block
        }

        unsafe fn dealloc(&self, block: *mut u8, layout: Layout) {
            match RESERVE.offset_of(block) {
                // SAFETY: the caller's promises.
                Some(offset) => unsafe { free(block, offset, layout) },
                // SAFETY: the caller's promises.
                None => unsafe { System.dealloc(block, layout) },
            }
        }

        unsafe fn realloc(&self, block: *mut u8, layout: Layout, size: usize) -> *mut u8 {
            if RESERVE.offset_of(block).is_none() {
                // SAFETY: the caller's promises.
                let made = unsafe { System.realloc(block, layout, size) };
                if !made.is_null() {
                    return made;
                }
            }
            // SAFETY: the caller's promises.
            unsafe { moved(block, layout, size) }
        }
    }

    #[cfg(test)]
    mod tests {
        use super::*;

        #[test]
        fn a_block_that_was_moved_knows_where_it_came_from() {
            let mut blocks = [[0_u8; 8]; 66];
            let blocks = blocks.each_mut().map(|block| block.as_mut_ptr());
            let noted = |k: usize| Move::note(blocks[k], blocks[k + 1], k);
            assert!((0..64).all(noted) && !noted(64));
            assert_eq!(Move::take(blocks[7]), Some((blocks[8], 7)));
            assert!(Move::take(blocks[7]).is_none() && noted(64) && !noted(7));
            assert_eq!(Move::take(blocks[64]), Some((blocks[65], 64)));
            assert!((0..64).all(|k| Move::take(blocks[k]).is_some() == (k != 7)));
        }

        #[test]
        fn blocks_of_the_reserve_are_apart_and_come_back() {
            // Not that of the program, whose jobs would find no memory.
            static OWN: Arenas = Arenas {
                bytes: UnsafeCell::new([0; ARENAS * ARENA]),
                states: [const { AtomicU64::new(0) }; ARENAS],
                drawn: AtomicU64::new(0),
            };
            let of = |size, align| Layout::from_size_align(size, align).unwrap();
            let unused = || OWN.states.iter().all(|state| state.load(Ordering::Relaxed) == 0);
            let mut held = Vec::new();
            for k in 0.. {
                let layout = of(1 + k * 7919 % 9000, 1 << (k % 7));
                let block = OWN.draw(layout);
                if block.is_null() {
                    break;
                }
                assert!(block.addr().is_multiple_of(layout.align()) && OWN.offset_of(block).is_some());
                assert!(RESERVE.offset_of(block).is_none());
                // SAFETY: a block of that size.
                unsafe { block.write_bytes(k as u8, layout.size()) };
                held.push((block, layout));
            }
            let total: usize = held.iter().map(|(_, layout)| layout.size()).sum();
            assert!(total > ARENAS * ARENA * 3 / 4, "{total}");
            assert_eq!(OWN.drawn.load(Ordering::Relaxed), total as u64);
            for (k, &(block, layout)) in held.iter().enumerate() {
                // SAFETY: as above.
                let bytes = unsafe { std::slice::from_raw_parts(block, layout.size()) };
                assert!(bytes.iter().all(|&byte| byte == k as u8));
            }
            for refused in [of(ARENA, 1), of(ARENA + 1, 1), of(1, 128)] {
                assert!(OWN.draw(refused).is_null());
            }
            held.drain(..).for_each(|(block, layout)| {
                OWN.give_back(OWN.offset_of(block).unwrap(), layout.size());
            });
            assert!(unused());
            // Small blocks one after another take no more room than one.
            let kept = OWN.draw(of(8, 8));
            for _ in 0..ARENA {
                let block = OWN.draw(of(64, 8));
                OWN.give_back(OWN.offset_of(block).unwrap(), 64);
            }
            assert!(OWN.states[1..].iter().all(|state| state.load(Ordering::Relaxed) == 0));
            OWN.give_back(OWN.offset_of(kept).unwrap(), 8);
            assert!(unused());
        }

        #[test]
        fn blocks_of_many_threads_are_apart() {
            static OWN: Arenas = Arenas {
                bytes: UnsafeCell::new([0; ARENAS * ARENA]),
                states: [const { AtomicU64::new(0) }; ARENAS],
                drawn: AtomicU64::new(0),
            };
            std::thread::scope(|scope| {
                for name in 1..=4_u8 {
                    scope.spawn(move || {
                        for round in 0..2000 {
                            let layout = Layout::from_size_align(1 + round * 31 % 3000, 8).unwrap();
                            let blocks = [0; 5].map(|_| OWN.draw(layout));
                            for block in blocks {
                                assert!(!block.is_null());
                                // SAFETY: a block of that size, of this thread.
                                unsafe { block.write_bytes(name, layout.size()) };
                            }
                            std::thread::yield_now();
                            for block in blocks {
                                // SAFETY: as above.
                                let bytes = unsafe { std::slice::from_raw_parts(block, layout.size()) };
                                assert!(bytes.iter().all(|&byte| byte == name));
                                OWN.give_back(OWN.offset_of(block).unwrap(), layout.size());
                            }
                        }
                    });
                }
            });
            assert!(OWN.states.iter().all(|state| state.load(Ordering::Relaxed) == 0));
        }
    }
}

//! Many outlines in one call take no allocation each.

#![allow(unsafe_code, reason = "an allocator that counts")]

use crate::common::Silent;
use gusset::Job;
use gusset::outline::{Lock, Mode, Options, Outlines, Points, fit};
use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;

struct Counting;

thread_local! {
    /// Of the thread that asks: other tests run beside this one.
    static CALLS: Cell<usize> = const { Cell::new(0) };
}

// SAFETY: everything is handed on to the system's allocator.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        CALLS.set(CALLS.get() + 1);
        // SAFETY: the caller's promise.
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        // SAFETY: the caller's promise.
        unsafe { System.dealloc(pointer, layout) }
    }

    unsafe fn realloc(&self, pointer: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        CALLS.set(CALLS.get() + 1);
        // SAFETY: the caller's promise.
        unsafe { System.realloc(pointer, layout, size) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

/// Allocations for `count` outlines of 20 points each in one call.
fn allocations(count: u32, options: &Options, closed: bool) -> usize {
    let mut points = Vec::new();
    let mut offsets = vec![0];
    for k in 0..count {
        for i in 0..20 {
            let t = std::f64::consts::TAU * f64::from(i) / 20.0;
            points.push([t.cos() * (1.0 + 0.2 * f64::from((i * 7 + k) % 5)), t.sin()]);
        }
        offsets.push(points.len() as u32);
    }
    let outlines = Outlines { points: Points::from(&points[..]), offsets: Some(&offsets), closed, constraints: &[] };
    let before = CALLS.get();
    let done = fit(&outlines, options, &Job::new(1, &Silent)).unwrap();
    assert_eq!(done.len(), count as usize);
    CALLS.get() - before
}

#[test]
fn outlines_take_no_allocation_each() {
    for closed in [true, false] {
        for mode in [Mode::Composite, Mode::BlendC1, Mode::BlendC2, Mode::CubicC2] {
            for lock in [Lock::Parameter, Lock::SelfConsistent] {
                let options = Options { mode, lock, ..Options::default() };
                let (few, many) = (allocations(100, &options, closed), allocations(30_000, &options, closed));
                // A list of batches grows by doubling.
                assert!(many <= few + 10, "{mode:?} {lock:?}: {few} {many}");
            }
        }
    }
}

//! Many outlines in one call take no allocation each.

#![allow(unsafe_code, reason = "allocations are counted")]

use crate::common::Silent;
use gusset::Job;
use gusset::curve::{CurveKind, Lock, Options, Outlines, Points, fit};
use std::cell::Cell;

thread_local! {
    /// Memory of the current thread, because other tests run at the same time.
    static CALLS: Cell<usize> = const { Cell::new(0) };
}

unsafe extern "C" {
    fn __libc_malloc(size: usize) -> *mut u8;
    fn __libc_calloc(count: usize, size: usize) -> *mut u8;
    fn __libc_realloc(block: *mut u8, size: usize) -> *mut u8;
}

// The library has the allocator of this program, which asks the C library: what stands before that
// counts.

#[unsafe(no_mangle)]
extern "C" fn malloc(size: usize) -> *mut u8 {
    CALLS.set(CALLS.get() + 1);
    // SAFETY: what this function stands before.
    unsafe { __libc_malloc(size) }
}

#[unsafe(no_mangle)]
extern "C" fn calloc(count: usize, size: usize) -> *mut u8 {
    CALLS.set(CALLS.get() + 1);
    // SAFETY: as above.
    unsafe { __libc_calloc(count, size) }
}

#[unsafe(no_mangle)]
unsafe extern "C" fn realloc(block: *mut u8, size: usize) -> *mut u8 {
    CALLS.set(CALLS.get() + 1);
    // SAFETY: as above, with the caller's promise.
    unsafe { __libc_realloc(block, size) }
}

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
        for curve_kind in [CurveKind::Composite, CurveKind::BlendC1, CurveKind::BlendC2, CurveKind::CubicC2] {
            for lock in [Lock::Parameter, Lock::SelfConsistent] {
                let options = Options { curve: curve_kind, lock, ..Options::default() };
                let (few, many) = (allocations(100, &options, closed), allocations(30_000, &options, closed));
                assert!(few > 0);
                // A list of batches grows by doubling.
                assert!(many <= few + 10, "{curve_kind:?} {lock:?}: {few} {many}");
            }
        }
    }
}

//! Kernels: loops over slices, compiled for wider vectors too and chosen at run time.
//!
//! A kernel is written as plain arithmetic. The compiler neither reorders nor fuses floating point
//! operations, whatever vectors it may use, so that all ways through here give the same bits.
//!
//! What the compiler needs to see in such a loop: slices of one length that are arguments of a
//! function, as only those are known not to overlap; no calls that are not inlined; and sums, which
//! it may not reorder, written as several side by side.

/// A loop over slices. `run` must be `#[inline(always)]`, and so must be what it calls: code that
/// is not inlined is compiled for the narrow vectors only.
pub trait Kernel {
    /// What it returns.
    type Output;

    /// The loop.
    fn run(self) -> Self::Output;
}

/// Runs a kernel with the widest vectors that the processor has.
#[inline]
pub fn run<K: Kernel>(kernel: K) -> K::Output {
    #[cfg(target_arch = "x86_64")]
    if std::arch::is_x86_feature_detected!("avx2") {
        // SAFETY: the processor has AVX2.
        #[allow(unsafe_code, reason = "the compiler cannot know the processor")]
        return unsafe { with_avx2(kernel) };
    }
    kernel.run()
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2")]
fn with_avx2<K: Kernel>(kernel: K) -> K::Output {
    kernel.run()
}

//! Kernels: loops over slices that are also compiled for wider vectors and selected at run time.
//!
//! A kernel is written as plain arithmetic. The compiler does not reorder or fuse floating-point
//! operations, so every version returns the same bits.
//!
//! For a loop to be vectorised, its slices must have equal length and be arguments of a function,
//! which tells the compiler that they do not overlap. All calls must be inlined. Sums must be split
//! into several independent ones, because the compiler may not reorder them.

/// A loop over slices. Mark `run` and everything that it calls `#[inline(always)]`, because a
/// function that is not inlined is compiled for narrow vectors only.
pub trait Kernel {
    /// The result of the loop.
    type Output;

    /// Runs the loop.
    fn run(self) -> Self::Output;
}

/// Runs a kernel with the widest vectors that the processor supports.
#[inline]
pub fn run<K: Kernel>(kernel: K) -> K::Output {
    #[cfg(target_arch = "x86_64")]
    if std::arch::is_x86_feature_detected!("avx2") {
        // SAFETY: the processor has AVX2.
        #[allow(unsafe_code, reason = "the compiler cannot know the processor")]
        return unsafe { run_with_avx2(kernel) };
    }
    kernel.run()
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2")]
fn run_with_avx2<K: Kernel>(kernel: K) -> K::Output {
    kernel.run()
}

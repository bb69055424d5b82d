//! The two types of coordinates.

use crate::mesh::Scalar;
use std::fmt::Debug;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// `f32` or `f64`.
///
/// What nets compute node by node they compute in the nodes' own type, with the operations of IEEE 754 only and without
/// fusing them: the same bits on every machine, whatever vectors it has.
pub trait Real:
    bytemuck::Pod
    + Debug
    + PartialOrd
    + Send
    + Sync
    + Into<f64>
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + sealed::Sealed
{
    /// The name of the type.
    const SCALAR: Scalar;

    /// The greatest finite number.
    const GREATEST: f64;

    /// Rounds to this type.
    fn of(value: f64) -> Self;

    /// The square root, correctly rounded.
    #[must_use]
    fn root(self) -> Self;
}

mod sealed {
    pub trait Sealed {}
    impl Sealed for f32 {}
    impl Sealed for f64 {}
}

impl Real for f32 {
    const SCALAR: Scalar = Scalar::F32;
    const GREATEST: f64 = f32::MAX as f64;

    #[inline(always)]
    fn of(value: f64) -> Self {
        value as f32
    }

    #[inline(always)]
    fn root(self) -> Self {
        self.sqrt()
    }
}

impl Real for f64 {
    const SCALAR: Scalar = Scalar::F64;
    const GREATEST: f64 = f64::MAX;

    #[inline(always)]
    fn of(value: f64) -> Self {
        value
    }

    #[inline(always)]
    fn root(self) -> Self {
        self.sqrt()
    }
}

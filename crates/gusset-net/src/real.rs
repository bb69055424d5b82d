//! The two scalar types of coordinates.

use gusset_mesh::Scalar;
use std::fmt::Debug;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// `f32` or `f64`.
///
/// Computations on single nodes use the nodes' own type, by IEEE 754 operations without
/// contraction. They give the same bits on every machine, for any vector width.
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
    /// The tag of the type.
    const SCALAR: Scalar;

    /// The largest finite number.
    const MAX: f64;

    /// Rounds to this type.
    fn from_f64(value: f64) -> Self;

    /// Returns the square root, correctly rounded.
    #[must_use]
    fn sqrt(self) -> Self;
}

mod sealed {
    pub trait Sealed {}
}

macro_rules! real {
    ($($scalar:ident: $tag:ident),+) => {$(
        impl sealed::Sealed for $scalar {}

        impl Real for $scalar {
            const SCALAR: Scalar = Scalar::$tag;
            const MAX: f64 = $scalar::MAX as f64;

            #[inline(always)]
            fn from_f64(value: f64) -> Self {
                value as $scalar
            }

            #[inline(always)]
            fn sqrt(self) -> Self {
                self.sqrt()
            }
        }
    )+};
}

real! { f32: F32, f64: F64 }

//! Levels: coordinates as whole numbers, so that residuals are differences of integers.
//!
//! Lossless levels are bit patterns in numerical order; quantised ones count equal steps. O(1) a
//! number.

use crate::Real;

/// A coordinate type with access to its bits.
pub(super) trait CoordinateBits: Real {
    /// Bytes of a number.
    const SIZE: usize = size_of::<Self>();
    /// Returns the number as an integer that sorts numerically, from -infinity to infinity, with -0
    /// before 0 and NaN beyond both.
    fn to_ordered_bits(self) -> i64;
    /// Returns the number with the given ordered bits, if they are in range.
    fn from_ordered_bits(level: i64) -> Option<Self>;
    /// Little-endian bytes.
    fn write_bytes(self, to: &mut [u8]);
    /// From little-endian bytes, exactly [`CoordinateBits::SIZE`] of them.
    fn read_bytes(from: &[u8]) -> Self;
    /// A quiet NaN.
    const MISSING: Self;
}

macro_rules! bits {
    ($($scalar:ident: $whole:ident),+) => {$(
        impl CoordinateBits for $scalar {
            const MISSING: Self = $scalar::NAN;

            #[inline(always)]
            fn to_ordered_bits(self) -> i64 {
                let bits = self.to_bits() as $whole;
                (bits ^ ((bits >> ($whole::BITS - 1)) & $whole::MAX)).into()
            }

            #[inline(always)]
            fn from_ordered_bits(level: i64) -> Option<Self> {
                let level = $whole::try_from(level).ok()?;
                Some($scalar::from_bits((level ^ ((level >> ($whole::BITS - 1)) & $whole::MAX)) as _))
            }

            #[inline(always)]
            fn write_bytes(self, to: &mut [u8]) {
                to.copy_from_slice(&self.to_le_bytes());
            }

            #[inline(always)]
            fn read_bytes(from: &[u8]) -> Self {
                let mut bytes = [0; Self::SIZE];
                bytes.copy_from_slice(from);
                $scalar::from_le_bytes(bytes)
            }
        }
    )+};
}

bits! { f32: i32, f64: i64 }

/// A map between numbers and levels.
pub(super) trait LevelMap<T>: Sync {
    /// Returns the level of a number.
    fn level_of_number(&self, axis: usize, number: T) -> i64;
    /// Returns the number of a level, if it is in range.
    fn number_of_level(&self, axis: usize, level: i64) -> Option<T>;
    /// Returns the value of a level for predictors, nearly linear in the number; not finite for NaN
    /// and infinities.
    fn predictor_value(&self, level: i64) -> f64;
    /// Returns the level nearest to a finite value.
    fn nearest_level(&self, axis: usize, value: f64) -> i64;
    /// Returns the spacing of values near this one.
    fn value_spacing(&self, value: f64) -> f64;
    /// Returns true for a node that is marked as missing and not coded.
    fn is_missing(&self, node: [T; 3]) -> bool;
    /// Returns the coordinates that missing nodes get.
    fn missing_node(&self) -> [T; 3];
}

/// Levels of bit patterns: lossless.
#[derive(Debug, Clone, Copy)]
pub(super) struct LosslessLevels<T> {
    /// The coordinates of missing nodes.
    pub(super) missing: [T; 3],
}

impl<T: CoordinateBits> LevelMap<T> for LosslessLevels<T> {
    #[inline(always)]
    fn level_of_number(&self, _: usize, number: T) -> i64 {
        number.to_ordered_bits()
    }

    #[inline(always)]
    fn number_of_level(&self, _: usize, level: i64) -> Option<T> {
        T::from_ordered_bits(level)
    }

    #[inline(always)]
    fn predictor_value(&self, level: i64) -> f64 {
        T::from_ordered_bits(level).map_or(0.0, Into::into)
    }

    #[inline(always)]
    fn nearest_level(&self, _: usize, value: f64) -> i64 {
        T::from_f64(value).to_ordered_bits()
    }

    fn value_spacing(&self, value: f64) -> f64 {
        if value.abs() > 1e-290 { value.abs() * if T::SIZE == 4 { 6e-8 } else { 1.1e-16 } } else { 1e-300 }
    }

    #[inline(always)]
    fn is_missing(&self, node: [T; 3]) -> bool {
        let levels = self.missing.map(T::to_ordered_bits);
        node.map(T::to_ordered_bits) == levels && !node.iter().all(|&number| number.into().is_finite())
    }

    #[inline(always)]
    fn missing_node(&self) -> [T; 3] {
        self.missing
    }
}

/// The levels 0 to `last_level` in equal steps: level k is `origin + k * step`, computed in double
/// precision and rounded to the scalar type.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct UniformLevels {
    pub(super) origin: [f64; 3],
    pub(super) step: [f64; 3],
    pub(super) last_level: i64,
}

impl<T: CoordinateBits> LevelMap<T> for UniformLevels {
    #[inline(always)]
    fn level_of_number(&self, axis: usize, number: T) -> i64 {
        let value: f64 = number.into();
        let steps = (value - self.origin[axis]) / self.step[axis];
        LevelMap::<T>::nearest_level(self, axis, steps)
    }

    #[inline(always)]
    fn number_of_level(&self, axis: usize, level: i64) -> Option<T> {
        let in_range = (0..=self.last_level).contains(&level);
        in_range.then(|| T::from_f64(self.origin[axis] + level as f64 * self.step[axis]))
    }

    #[inline(always)]
    fn predictor_value(&self, level: i64) -> f64 {
        level as f64
    }

    #[inline(always)]
    fn nearest_level(&self, _: usize, value: f64) -> i64 {
        let last = self.last_level as f64;
        let value = if value > 0.0 { value } else { 0.0 };
        let value = if value < last { value } else { last };
        (value + 0.5) as i64
    }

    fn value_spacing(&self, _: f64) -> f64 {
        1.0
    }

    #[inline(always)]
    fn is_missing(&self, node: [T; 3]) -> bool {
        !node.iter().all(|&number| number.into().is_finite())
    }

    #[inline(always)]
    fn missing_node(&self) -> [T; 3] {
        [T::MISSING; 3]
    }
}

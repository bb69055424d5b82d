//! Signed integers of up to 2560 bits on the stack.
//!
//! A number keeps its sign, its magnitude in limbs of 64 bits, and the number of limbs in use.
//! Small numbers are therefore cheap. Coordinates have at most [`MAX_COORDINATE_BITS`] bits, and the
//! largest determinant of this crate has 20 times this number of bits plus 43.

use std::cmp::Ordering;

/// Number of bits of the largest coordinate.
pub(super) const MAX_COORDINATE_BITS: i32 = 120;

/// Number of limbs: 20 * 120 + 43 bits fit.
const LIMBS: usize = 40;

/// A signed integer.
#[derive(Clone, Copy)]
pub(super) struct WideInt {
    /// The number of limbs in use. The highest is not 0.
    len: usize,
    is_negative: bool,
    limbs: [u64; LIMBS],
}

impl WideInt {
    pub(super) const ZERO: WideInt = WideInt { len: 0, is_negative: false, limbs: [0; LIMBS] };

    /// Returns the number of a double that is an integer below 2^[`MAX_COORDINATE_BITS`].
    pub(super) fn from_integral(x: f64) -> WideInt {
        let mut made = WideInt::ZERO;
        if x == 0.0 {
            return made;
        }
        let exponent = ((x.to_bits() >> 52) & 0x7ff) as i32 - 1075;
        let mantissa = (x.to_bits() & ((1 << 52) - 1)) | 1 << 52;
        let wide = if exponent >= 0 {
            // At most 120 bits.
            u128::from(mantissa) << exponent.min(75)
        } else {
            u128::from(mantissa >> (-exponent).min(63))
        };
        made.limbs[0] = wide as u64;
        made.limbs[1] = (wide >> 64) as u64;
        made.is_negative = x < 0.0;
        made.trimmed(2)
    }

    /// Returns the number with these limbs, the lowest first.
    pub(super) fn from_limbs(limbs: &[u64], is_negative: bool) -> WideInt {
        let mut made = WideInt { len: 0, is_negative, limbs: [0; LIMBS] };
        made.limbs[..limbs.len()].copy_from_slice(limbs);
        made.trimmed(limbs.len())
    }

    /// Returns the limbs in use, the lowest first.
    pub(super) fn limbs(&self) -> &[u64] {
        &self.limbs[..self.len]
    }

    pub(super) fn is_negative(&self) -> bool {
        self.is_negative
    }

    /// Returns -1, 0 or 1.
    pub(super) fn sign(&self) -> i32 {
        match (self.len, self.is_negative) {
            (0, _) => 0,
            (_, true) => -1,
            (_, false) => 1,
        }
    }

    /// Sets the number of limbs in use, at most `len`.
    fn trimmed(mut self, len: usize) -> WideInt {
        self.len = self.limbs[..len].iter().rposition(|&limb| limb != 0).map_or(0, |top| top + 1);
        self.is_negative &= self.len > 0;
        self
    }

    /// Returns the number of bits of the magnitude.
    pub(super) fn bits(&self) -> u32 {
        self.limbs().last().map_or(0, |top| 64 * self.len as u32 - top.leading_zeros())
    }

    /// Returns the 64 highest bits of the magnitude, the highest of them set. 0 for 0.
    pub(super) fn highest_bits(&self) -> u64 {
        let Some(&top) = self.limbs().last() else { return 0 };
        let shift = top.leading_zeros();
        let below = if self.len > 1 { self.limbs[self.len - 2] } else { 0 };
        if shift == 0 { top } else { top << shift | below >> (64 - shift) }
    }

    /// Returns the number times 2^`bits`.
    pub(super) fn shifted(&self, bits: u32) -> WideInt {
        let (whole, rest) = ((bits / 64) as usize, bits % 64);
        let mut made = WideInt { len: 0, is_negative: self.is_negative, limbs: [0; LIMBS] };
        let len = (self.len + whole + 1).min(LIMBS);
        for k in 0..self.len {
            let limb = u128::from(self.limbs[k]) << rest;
            if let Some(low) = made.limbs.get_mut(k + whole) {
                *low |= limb as u64;
            }
            if let Some(high) = made.limbs.get_mut(k + whole + 1) {
                *high = (limb >> 64) as u64;
            }
        }
        made.trimmed(len)
    }

    fn compare_magnitudes(&self, other: &WideInt) -> Ordering {
        self.len.cmp(&other.len).then_with(|| self.limbs().iter().rev().cmp(other.limbs().iter().rev()))
    }

    pub(super) fn compare(&self, other: &WideInt) -> Ordering {
        match (self.sign(), other.sign()) {
            (1, 1) => self.compare_magnitudes(other),
            (-1, -1) => other.compare_magnitudes(self),
            (a, b) => a.cmp(&b),
        }
    }

    pub(super) fn negated(mut self) -> WideInt {
        self.is_negative = self.len > 0 && !self.is_negative;
        self
    }

    /// Returns the sum with a number whose sign is replaced.
    fn plus_signed(&self, other: &WideInt, other_is_negative: bool) -> WideInt {
        if other.len == 0 {
            return *self;
        }
        let mut made = WideInt::ZERO;
        if self.is_negative == other_is_negative || self.len == 0 {
            let (long, short) = if self.len >= other.len { (self, other) } else { (other, self) };
            let mut carry = false;
            for k in 0..long.len {
                let (sum, first) = long.limbs[k].overflowing_add(short.limbs[k]);
                let (sum, second) = sum.overflowing_add(u64::from(carry));
                made.limbs[k] = sum;
                carry = first | second;
            }
            let len = (long.len + 1).min(LIMBS);
            if long.len < LIMBS {
                made.limbs[long.len] = u64::from(carry);
            }
            made.is_negative = other_is_negative;
            return made.trimmed(len);
        }
        let (long, short, is_negative) = match self.compare_magnitudes(other) {
            Ordering::Less => (other, self, other_is_negative),
            _ => (self, other, self.is_negative),
        };
        let mut borrow = false;
        for k in 0..long.len {
            let (rest, first) = long.limbs[k].overflowing_sub(short.limbs[k]);
            let (rest, second) = rest.overflowing_sub(u64::from(borrow));
            made.limbs[k] = rest;
            borrow = first | second;
        }
        made.is_negative = is_negative;
        made.trimmed(long.len)
    }

    pub(super) fn plus(&self, other: &WideInt) -> WideInt {
        self.plus_signed(other, other.is_negative)
    }

    pub(super) fn minus(&self, other: &WideInt) -> WideInt {
        self.plus_signed(other, !other.is_negative)
    }

    pub(super) fn times(&self, other: &WideInt) -> WideInt {
        let mut made = WideInt { len: 0, is_negative: self.is_negative != other.is_negative, limbs: [0; LIMBS] };
        for (i, &a) in self.limbs().iter().enumerate() {
            let mut carry = 0;
            for (&b, place) in other.limbs().iter().zip(&mut made.limbs[i..]) {
                let product = u128::from(a) * u128::from(b) + u128::from(*place) + u128::from(carry);
                *place = product as u64;
                carry = (product >> 64) as u64;
            }
            if let Some(place) = made.limbs.get_mut(i + other.len) {
                *place = carry;
            }
        }
        made.trimmed((self.len + other.len).min(LIMBS))
    }
}

/// A vector of three integers.
pub(super) type WideVec = [WideInt; 3];

pub(super) fn difference(a: &WideVec, b: &WideVec) -> WideVec {
    [0, 1, 2].map(|k| a[k].minus(&b[k]))
}

pub(super) fn dot(a: &WideVec, b: &WideVec) -> WideInt {
    a[0].times(&b[0]).plus(&a[1].times(&b[1])).plus(&a[2].times(&b[2]))
}

/// Returns a component of the cross product.
pub(super) fn cross_component(a: &WideVec, b: &WideVec, k: usize) -> WideInt {
    let (i, j) = ((k + 1) % 3, (k + 2) % 3);
    a[i].times(&b[j]).minus(&a[j].times(&b[i]))
}

pub(super) fn cross(a: &WideVec, b: &WideVec) -> WideVec {
    [0, 1, 2].map(|k| cross_component(a, b, k))
}

/// Returns |top| / |bottom| in double precision, rounded to nearest, ties to even. `bottom` is not 0.
pub(super) fn rounded_quotient(top: &WideInt, bottom: &WideInt) -> f64 {
    if top.len == 0 {
        return 0.0;
    }
    // The quotient of the 64 highest bits lies between 2^63 and 2^65, and errs by at most 4.
    let quotient = (u128::from(top.highest_bits()) << 64) / u128::from(bottom.highest_bits());
    let exponent = top.bits() as i32 - bottom.bits() as i32 - 64;
    let excess = 128 - quotient.leading_zeros() - 53;
    let (rest, half) = (quotient & ((1 << excess) - 1), 1 << (excess - 1));
    let mut mantissa = (quotient >> excess) as u64;
    let exponent = exponent + excess as i32;
    if rest.abs_diff(half) > 8 {
        mantissa += u64::from(rest > half);
    } else {
        // Compares the exact quotient with (2 mantissa + 1) / 2 * 2^exponent.
        let mut middle = WideInt::from_limbs(&[2 * mantissa + 1], false).times(bottom);
        let (mut whole, shift) = (*top, exponent - 1);
        whole.is_negative = false;
        middle.is_negative = false;
        if shift >= 0 {
            middle = middle.shifted(shift as u32);
        } else {
            whole = whole.shifted(-shift as u32);
        }
        mantissa += match whole.compare_magnitudes(&middle) {
            Ordering::Less => 0,
            Ordering::Equal => mantissa & 1,
            Ordering::Greater => 1,
        };
    }
    // Exponents of quotients of coordinates are far from the limits of doubles, unless tiny.
    mantissa as f64 * power_of_two(exponent)
}

/// Returns 2^`exponent`, or the nearest normal power of two.
pub(super) fn power_of_two(exponent: i32) -> f64 {
    f64::from_bits(((exponent + 1023).clamp(1, 2046) as u64) << 52)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn from_i128(x: i128) -> WideInt {
        let size = x.unsigned_abs();
        WideInt::from_limbs(&[size as u64, (size >> 64) as u64], x < 0)
    }

    /// Returns the remainder of division by a prime below 2^62.
    fn remainder(x: &WideInt, prime: u64) -> u64 {
        let rest =
            x.limbs().iter().rev().fold(0u128, |rest, &limb| ((rest << 64) | u128::from(limb)) % u128::from(prime));
        if x.is_negative() { (prime - rest as u64) % prime } else { rest as u64 }
    }

    proptest! {
        #[test]
        fn small_numbers_agree_with_i128(a in any::<i64>(), b in any::<i64>(), c in any::<i64>()) {
            let [x, y, z] = [a, b, c].map(i128::from);
            let [p, q, r] = [x, y, z].map(from_i128);
            let expected = x * y - z;
            let made = p.times(&q).minus(&r);
            prop_assert_eq!(made.compare(&from_i128(expected)), Ordering::Equal);
            prop_assert_eq!(made.sign(), expected.signum() as i32);
            prop_assert_eq!(p.compare(&q), x.cmp(&y));
            prop_assert_eq!(p.plus(&r).compare(&from_i128(x + z)), Ordering::Equal);
            prop_assert_eq!(from_i128(expected).bits(), 128 - expected.unsigned_abs().leading_zeros());
        }

        #[test]
        fn large_products_agree_modulo_a_prime(
            a in prop::collection::vec(any::<u64>(), 0..12),
            b in prop::collection::vec(any::<u64>(), 0..12),
            c in prop::collection::vec(any::<u64>(), 0..24),
            signs in any::<[bool; 3]>(),
            shift in 0u32..200,
        ) {
            const PRIME: u64 = (1 << 61) - 1;
            let x = WideInt::from_limbs(&a, signs[0]);
            let y = WideInt::from_limbs(&b, signs[1]);
            let z = WideInt::from_limbs(&c, signs[2]);
            let [p, q, r] = [&x, &y, &z].map(|n| u128::from(remainder(n, PRIME)));
            let prime = u128::from(PRIME);
            let expected = (p * q + r) % prime * (1 << (shift % 61)) % prime;
            prop_assert_eq!(u128::from(remainder(&x.times(&y).plus(&z).shifted(shift), PRIME)), expected);
        }

        #[test]
        fn quotients_are_rounded_to_nearest(
            m in 1u64 << 52..1 << 53,
            bottom in 2u64..,
            any_rest in any::<u64>(),
            near_half in prop::option::of(-2i64..3),
            shifts in any::<[u8; 2]>(),
        ) {
            // The quotient is m + rest / bottom. Doubles from m to m + 1 lie 1 apart.
            let around_half = |near| (bottom / 2).saturating_add_signed(near).min(bottom - 1);
            let rest = near_half.map_or(any_rest % bottom, around_half);
            let [whole, divisor, remainder] = [m, bottom, rest].map(|x| from_i128(x.into()));
            let top = whole.times(&divisor).plus(&remainder).shifted(shifts[0].into());
            let made = rounded_quotient(&top, &divisor.shifted(shifts[1].into()));
            let goes_up = match (2 * u128::from(rest)).cmp(&bottom.into()) {
                Ordering::Less => false,
                Ordering::Equal => m % 2 == 1,
                Ordering::Greater => true,
            };
            let scale = power_of_two(i32::from(shifts[0]) - i32::from(shifts[1]));
            prop_assert_eq!(made, (m + u64::from(goes_up)) as f64 * scale);
        }
    }

    #[test]
    fn quotients_break_ties_to_even() {
        let wide = |x: u64| WideInt::from_limbs(&[0, x], false);
        let two_to_64 = wide(1);
        // (2^53 + 1) * 2^64 over 2^64 lies between two doubles.
        for (top, expected) in [((1u64 << 53) + 1, 2f64.powi(53)), ((1 << 53) + 3, 2f64.powi(53) + 4.0)] {
            assert_eq!(rounded_quotient(&wide(top), &two_to_64), expected);
        }
        // One unit of the lowest limb decides.
        let above = wide((1 << 53) + 1).plus(&WideInt::from_limbs(&[1], false));
        assert_eq!(rounded_quotient(&above, &two_to_64), 2f64.powi(53) + 2.0);
        let below = wide((1 << 53) + 3).minus(&WideInt::from_limbs(&[1], false));
        assert_eq!(rounded_quotient(&below, &two_to_64), 2f64.powi(53) + 2.0);
    }

    #[test]
    fn integral_doubles_are_exact() {
        for x in [0.0, 1.0, -3.0, 2f64.powi(119), -(2f64.powi(53) - 1.0) * 2f64.powi(60), 12_345_678.0] {
            let made = WideInt::from_integral(x);
            assert_eq!(rounded_quotient(&made, &WideInt::from_integral(1.0)), x.abs());
            assert_eq!(made.sign(), if x == 0.0 { 0 } else { x.signum() as i32 });
        }
    }
}

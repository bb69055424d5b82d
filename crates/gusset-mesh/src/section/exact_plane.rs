//! The signed distance of points from a plane, with an exact sign.
//!
//! The plane n · (p - o) = c has the doubles that the caller gave. A sum with a bound of its
//! rounding error decides most points. The other points are decided by an expansion: a sum of
//! doubles that do not overlap, which is exact. See J. Shewchuk, "Adaptive precision floating-point
//! arithmetic and fast robust geometric predicates", 1997. The sign is exact unless a product of a
//! coordinate and a component of the normal underflows.

use glam::DVec3;
use gusset_base::error::{Error, Result};
use gusset_base::geom::scale::floor_to_power_of_two;

/// The largest absolute coordinate. Products with the scaled normal do not overflow.
pub(super) const MAX_COORDINATE: f64 = 1e150;

/// The rounding error of n · (p - o) is below this multiple of the sum of the absolute products:
/// the difference, the product, two sums and the comparison round once each.
const ROUNDING_BOUND: f64 = 6.0 * f64::EPSILON;

/// The largest number of terms: six products of two doubles each, and the level.
const MAX_TERMS: usize = 13;

/// A relative error of 2^-33 is allowed where distances give the place of a point on an edge.
const PLACE_ACCURACY: f64 = (1u64 << 33) as f64;

/// A family of parallel planes n · (p - o) = c, one for each level c.
pub(super) struct ExactPlane {
    origin: DVec3,
    /// The caller's normal times a power of two, so that its largest component is 1 to 2.
    normal: DVec3,
    /// The length of `normal`.
    length: f64,
}

/// The approximate value of n · (p - o), and a bound of its error.
#[derive(Clone, Copy)]
pub(super) struct BoundedValue {
    pub(super) value: f64,
    pub(super) error_bound: f64,
}

impl ExactPlane {
    pub(super) fn new(origin: DVec3, normal: DVec3) -> Result<Self> {
        let normal = normal / floor_to_power_of_two(normal.abs().max_element());
        // A normal below 2^-900 stays small.
        let length = normal.length();
        Error::require(length > 0.0 && length.is_finite(), "normal", length, "a finite vector other than 0")?;
        Ok(ExactPlane { origin, normal, length })
    }

    /// Returns the unit normal.
    pub(super) fn unit_normal(&self) -> DVec3 {
        self.normal / self.length
    }

    /// Returns the level of the plane at a distance from the origin.
    pub(super) fn scaled_level(&self, distance: f64) -> f64 {
        distance * self.length
    }

    /// Returns n · (p - o) rounded.
    #[inline]
    pub(super) fn bounded_value(&self, p: DVec3) -> BoundedValue {
        let products = self.normal * (p - self.origin);
        let sum = products.abs().element_sum();
        BoundedValue { value: products.element_sum(), error_bound: ROUNDING_BOUND * sum }
    }

    /// Returns n · (p - o) - c with the exact sign, and with a relative error of a few roundings.
    #[cold]
    pub(super) fn exact_distance(&self, p: DVec3, level: f64) -> f64 {
        let mut sum = Expansion::default();
        for k in 0..3 {
            for term in
                two_product(self.normal[k], p[k]).into_iter().chain(two_product(-self.normal[k], self.origin[k]))
            {
                sum.add(term);
            }
        }
        sum.add(-level);
        sum.estimate()
    }

    /// Returns n · (p - o) - c, accurate enough to place a point on an edge.
    #[inline]
    pub(super) fn distance(&self, p: DVec3, level: f64) -> f64 {
        let BoundedValue { value, error_bound: error } = self.bounded_value(p);
        let distance = value - level;
        if distance.abs() > PLACE_ACCURACY * error { distance } else { self.exact_distance(p, level) }
    }
}

/// An exact sum: terms that do not overlap, in ascending order of magnitude.
#[derive(Default)]
struct Expansion {
    terms: [f64; MAX_TERMS],
    len: usize,
}

impl Expansion {
    /// Adds a number exactly.
    fn add(&mut self, x: f64) {
        let (mut carry, mut kept) = (x, 0);
        for k in 0..self.len {
            let [sum, rest] = two_sum(carry, self.terms[k]);
            if rest != 0.0 {
                self.terms[kept] = rest;
                kept += 1;
            }
            carry = sum;
        }
        if carry != 0.0 {
            self.terms[kept] = carry;
            kept += 1;
        }
        self.len = kept;
    }

    /// Returns the sum rounded. The largest term exceeds the sum of all others, so the sign is
    /// exact.
    fn estimate(&self) -> f64 {
        self.terms[..self.len].iter().sum()
    }
}

/// Returns a + b rounded, and its rounding error.
fn two_sum(a: f64, b: f64) -> [f64; 2] {
    let sum = a + b;
    let b_part = sum - a;
    let a_part = sum - b_part;
    [sum, (a - a_part) + (b - b_part)]
}

/// Splits a double into two halves of at most 26 bits each.
fn split(a: f64) -> [f64; 2] {
    let c = 134_217_729.0 * a;
    let high = c - (c - a);
    [high, a - high]
}

/// Returns the rounding error of a · b, and a · b rounded.
fn two_product(a: f64, b: f64) -> [f64; 2] {
    let product = a * b;
    let ([a_high, a_low], [b_high, b_low]) = (split(a), split(b));
    let rest = ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low;
    [rest, product]
}

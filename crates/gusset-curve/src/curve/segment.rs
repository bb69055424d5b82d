//! One Bézier segment, given by its control points: points, derivatives, parts.

use glam::DVec3;
use gusset_base::geom::bernstein::{self, MAX_COEFFICIENTS, Roots, add_product, roots, value_and_slope};
use std::ops::{Deref, DerefMut};

/// Returns true if all control points of a segment coincide.
pub(crate) fn is_single_point(controls: &[DVec3]) -> bool {
    controls.iter().all(|&p| p == controls[0])
}

/// The highest degree of a segment.
pub const MAX_DEGREE: usize = bernstein::MAX_DEGREE;

/// Returns the point at parameter `t`, by de Casteljau's scheme, unrolled for the most common
/// degrees.
#[inline]
pub(crate) fn point_at(controls: &[DVec3], t: f64) -> DVec3 {
    let s = 1.0 - t;
    match *controls {
        [] => DVec3::ZERO,
        [p] => p,
        [p, q] => p * s + q * t,
        [p, q, r] => (p * s + q * t) * s + (q * s + r * t) * t,
        _ => evaluate_by_horner(controls, t),
    }
}

/// A bound of 2^64, the sum of all binomials of the highest degree.
const MAX_BINOMIAL_SUM: f64 = (1u128 << 80) as f64;

/// Returns the sum of the Bernstein terms. Control points so large that a term overflows are scaled
/// first.
fn evaluate_by_horner(controls: &[DVec3], t: f64) -> DVec3 {
    let point = scaled_bernstein_sum(controls, t, 1.0);
    if point.is_finite() { point } else { scaled_bernstein_sum(controls, t, 1.0 / MAX_BINOMIAL_SUM) * MAX_BINOMIAL_SUM }
}

/// Returns the sum of the terms times `unit` by a Horner-like scheme. It starts at the nearer end,
/// so that the ratio x of its powers is at most 1.
fn scaled_bernstein_sum(controls: &[DVec3], t: f64, unit: f64) -> DVec3 {
    let n = controls.len() - 1;
    let backwards = t > 0.5;
    let (t, s) = if backwards { (1.0 - t, t) } else { (t, 1.0 - t) };
    let at = |i: usize| controls[if backwards { n - i } else { i }] * unit;
    // sum C(n, i) t^i s^(n - i) B_i = s^n sum C(n, i) x^i B_i, with x = t / s <= 1.
    let x = t / s;
    let mut sum = at(0);
    let (mut factor, mut scale) = (1.0, s);
    for i in 1..=n {
        factor *= x * (n + 1 - i) as f64 / i as f64;
        sum += at(i) * factor;
        if i < n {
            scale *= s;
        }
    }
    sum * scale
}

/// Returns the vector from the first control point to the next distinct one.
pub(crate) fn vector_to_next_distinct_control(controls: &[DVec3]) -> DVec3 {
    let first = controls[0];
    controls.iter().find(|&&p| p != first).map_or(DVec3::ZERO, |&p| p - first)
}

/// Returns the vector from the last distinct control point to the last one.
pub(crate) fn vector_from_previous_distinct_control(controls: &[DVec3]) -> DVec3 {
    let last = controls[controls.len() - 1];
    controls.iter().rev().find(|&&p| p != last).map_or(DVec3::ZERO, |&p| last - p)
}

/// (C - q) . C' / n for a segment C of degree n: half the derivative of the squared distance from
/// `q`, divided by n. It is a polynomial of degree 2 n - 1.
pub(crate) struct SquaredDistanceSlope {
    coefficients: [f64; MAX_COEFFICIENTS],
    len: usize,
    /// The largest value that rounding can make of 0.
    rounding_error: f64,
}

impl SquaredDistanceSlope {
    pub(crate) fn new(controls: &[DVec3], q: DVec3) -> Self {
        let n = controls.len() - 1;
        let mut coefficients = [0.0; MAX_COEFFICIENTS];
        let product = &mut coefficients[..2 * n];
        for axis in 0..3 {
            let (mut place, mut step) = ([0.0; MAX_DEGREE + 1], [0.0; MAX_DEGREE]);
            for (to, p) in place.iter_mut().zip(controls) {
                *to = p[axis] - q[axis];
            }
            for (to, pair) in step.iter_mut().zip(controls.windows(2)) {
                *to = pair[1][axis] - pair[0][axis];
            }
            add_product(&place[..=n], &step[..n], 1.0, product);
        }
        let largest = product.iter().fold(0.0f64, |m, x| m.max(x.abs()));
        SquaredDistanceSlope { coefficients, len: 2 * n, rounding_error: 4.0 * f64::EPSILON * largest }
    }

    fn coefficients(&self) -> &[f64] {
        &self.coefficients[..self.len]
    }

    /// Returns the stationary points of the distance. An interval on which rounding hides the
    /// slope's sign yields one root.
    pub(crate) fn slope_roots(&self) -> Roots {
        roots(self.coefficients(), self.rounding_error)
    }

    /// Returns the interval around a root on which rounding hides the slope's sign, up to twice as
    /// long to either side. Returns `None` for a root that is well defined. Near a singular point,
    /// where C' is small too, the interval may be long and the minimum anywhere in it.
    pub(crate) fn interval_around_ill_conditioned_root(&self, root: f64) -> Option<[f64; 2]> {
        let slope = |t: f64| value_and_slope(self.coefficients(), t);
        if slope(root).1.abs() * MAX_ROOT_ERROR > self.rounding_error {
            return None;
        }
        let end = |sign: f64| {
            let mut step = MAX_ROOT_ERROR;
            while step < 1.0 && slope((root + sign * step).clamp(0.0, 1.0)).0.abs() <= self.rounding_error {
                step *= 2.0;
            }
            (root + sign * step).clamp(0.0, 1.0)
        };
        Some([end(-1.0), end(1.0)])
    }
}

/// A root is well defined if rounding moves it by at most this much.
const MAX_ROOT_ERROR: f64 = 1.0 / (1u64 << 40) as f64;

/// The control points of a segment of any degree, in a fixed-size buffer without allocation.
#[derive(Clone, Copy)]
pub(crate) struct SegmentBuffer {
    controls: [DVec3; MAX_DEGREE + 1],
    len: usize,
}

impl SegmentBuffer {
    pub(crate) fn new(controls: &[DVec3]) -> Self {
        Self::from_mapped(controls, |p| p)
    }

    pub(crate) fn from_mapped(controls: &[DVec3], map: impl Fn(DVec3) -> DVec3) -> Self {
        let mut buffer = SegmentBuffer { controls: [DVec3::ZERO; MAX_DEGREE + 1], len: controls.len() };
        buffer.controls.iter_mut().zip(controls).for_each(|(to, &p)| *to = map(p));
        buffer
    }

    /// Replaces the control points by the derivative's, n (B_(i+1) - B_i). A constant leaves none.
    pub(crate) fn differentiate(&mut self) {
        self.len = bernstein::differentiate(&mut self.controls[..self.len]);
    }

    /// Elevates the degree to `degree`, if that is higher.
    pub(crate) fn elevate(&mut self, degree: usize) {
        let from = self.len - 1;
        self.len = self.len.max(degree + 1);
        bernstein::elevate(self, from);
    }

    /// Keeps the part after `t` and returns the part before it, by de Casteljau's scheme.
    pub(crate) fn split_off_part_before(&mut self, t: f64) -> Self {
        let mut front = *self;
        bernstein::split(self, t, &mut front);
        front
    }

    /// Returns the part between the parameters `from` < `to`. At 0 and 1 the end points keep their
    /// bits.
    pub(crate) fn into_part_between(mut self, from: f64, to: f64) -> Self {
        let mut end = to;
        if from > 0.0 {
            self.split_off_part_before(from);
            end = (to - from) / (1.0 - from);
        }
        if to < 1.0 { self.split_off_part_before(end) } else { self }
    }
}

impl Deref for SegmentBuffer {
    type Target = [DVec3];

    fn deref(&self) -> &[DVec3] {
        &self.controls[..self.len]
    }
}

impl DerefMut for SegmentBuffer {
    fn deref_mut(&mut self) -> &mut [DVec3] {
        &mut self.controls[..self.len]
    }
}

/// Returns the point at `t` and its derivatives with respect to the parameter, N values in all; 0
/// beyond the degree.
pub(crate) fn point_and_derivatives<const N: usize>(controls: &[DVec3], t: f64) -> [DVec3; N] {
    let mut derived = SegmentBuffer::new(controls);
    [(); N].map(|()| {
        let value = point_at(&derived, t);
        derived.differentiate();
        value
    })
}

//! One Bézier segment by its control points: points, derivatives, parts.

use crate::geom::bernstein::{self, MAX_COEFFICIENTS, Roots, add_product, roots};
use glam::DVec3;
use std::ops::{Deref, DerefMut};

/// The highest degree of a segment.
pub const MAX_DEGREE: usize = bernstein::MAX_DEGREE;

/// The point at parameter `t`: de Casteljau's scheme, written out for the degrees that occur most.
#[inline]
pub(crate) fn point(controls: &[DVec3], t: f64) -> DVec3 {
    let s = 1.0 - t;
    match *controls {
        [] => DVec3::ZERO,
        [p] => p,
        [p, q] => p * s + q * t,
        [p, q, r] => (p * s + q * t) * s + (q * s + r * t) * t,
        _ => horner(controls, t),
    }
}

/// A bound of the sum of all binomials of the highest degree, 2^64 in all.
const MAX_BINOMIAL_SUM: f64 = (1u128 << 80) as f64;

/// The sum of the Bernstein terms; control points so large that a term overflows are scaled first.
fn horner(controls: &[DVec3], t: f64) -> DVec3 {
    let point = scaled_sum(controls, t, 1.0);
    if point.is_finite() { point } else { scaled_sum(controls, t, 1.0 / MAX_BINOMIAL_SUM) * MAX_BINOMIAL_SUM }
}

/// The sum of the terms times `unit`, by a scheme like Horner's from the nearer end, so that no
/// power overflows its binomial.
fn scaled_sum(controls: &[DVec3], t: f64, unit: f64) -> DVec3 {
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

/// From the first control point to the next one that differs.
pub(crate) fn first_leg(controls: &[DVec3]) -> DVec3 {
    let first = controls[0];
    controls.iter().find(|&&p| p != first).map_or(DVec3::ZERO, |&p| p - first)
}

/// To the last control point, from the one before that differs.
pub(crate) fn last_leg(controls: &[DVec3]) -> DVec3 {
    let last = controls[controls.len() - 1];
    controls.iter().rev().find(|&&p| p != last).map_or(DVec3::ZERO, |&p| last - p)
}

/// The parameters at which the distance from `q` is stationary: the roots of (C - q) . C', of
/// degree 2 n - 1. Multiple ones are no minima that matter: what rounding may have made counts as
/// 0.
pub(crate) fn stationary_points(controls: &[DVec3], q: DVec3) -> Roots {
    let n = controls.len() - 1;
    let mut product = [0.0; MAX_COEFFICIENTS];
    let product = &mut product[..2 * n];
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
    roots(product, 4.0 * f64::EPSILON * largest)
}

/// The control points of a segment of any degree, kept in place: no allocation.
#[derive(Clone, Copy)]
pub(crate) struct SegmentBuffer {
    controls: [DVec3; MAX_DEGREE + 1],
    len: usize,
}

impl SegmentBuffer {
    pub(crate) fn new(controls: &[DVec3]) -> Self {
        Self::mapped(controls, |p| p)
    }

    pub(crate) fn mapped(controls: &[DVec3], map: impl Fn(DVec3) -> DVec3) -> Self {
        let mut buffer = SegmentBuffer { controls: [DVec3::ZERO; MAX_DEGREE + 1], len: controls.len() };
        buffer.controls.iter_mut().zip(controls).for_each(|(to, &p)| *to = map(p));
        buffer
    }

    /// Replaces the control points by those of the derivative, n (B_(i+1) - B_i); a constant leaves
    /// none.
    pub(crate) fn derive(&mut self) {
        self.len = bernstein::derive(&mut self.controls[..self.len]);
    }

    /// Raises the degree to `degree`, if that is higher.
    pub(crate) fn elevate(&mut self, degree: usize) {
        let from = self.len - 1;
        self.len = self.len.max(degree + 1);
        bernstein::elevate(self, from);
    }

    /// Keeps the part after `t`, and returns the part before it: de Casteljau's scheme.
    pub(crate) fn split_off_front(&mut self, t: f64) -> Self {
        let mut front = *self;
        bernstein::split(self, t, &mut front);
        front
    }

    /// The part between two parameters, `from < to`; ends that are ends of the segment stay as they
    /// are.
    pub(crate) fn part(mut self, from: f64, to: f64) -> Self {
        let mut end = to;
        if from > 0.0 {
            self.split_off_front(from);
            end = (to - from) / (1.0 - from);
        }
        if to < 1.0 { self.split_off_front(end) } else { self }
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

/// The point at `t` and its derivatives by the parameter, N values in all; 0 beyond the degree.
pub(crate) fn jet<const N: usize>(controls: &[DVec3], t: f64) -> [DVec3; N] {
    let mut derived = SegmentBuffer::new(controls);
    [(); N].map(|()| {
        let value = point(&derived, t);
        derived.derive();
        value
    })
}

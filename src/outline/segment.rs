//! One Bézier segment by its control points.

use glam::DVec3;

/// The point at parameter `t`: de Casteljau's scheme, written out for the degrees that occur most.
#[inline]
pub(super) fn point(controls: &[DVec3], t: f64) -> DVec3 {
    let s = 1.0 - t;
    match *controls {
        [] => DVec3::ZERO,
        [p] => p,
        [p, q] => p * s + q * t,
        [p, q, r] => (p * s + q * t) * s + (q * s + r * t) * t,
        _ => horner(controls, t),
    }
}

/// The binomials of the highest degree, up to 2^61, and the sum of the terms are less than this.
const LARGE: f64 = (1u128 << 80) as f64;

/// The sum of the Bernstein terms; control points so large that a term overflows are scaled first.
fn horner(controls: &[DVec3], t: f64) -> DVec3 {
    let point = terms(controls, t, 1.0);
    if point.is_finite() { point } else { terms(controls, t, 1.0 / LARGE) * LARGE }
}

/// The sum by a scheme like Horner's, from the nearer end, so that no power overflows its binomial.
fn terms(controls: &[DVec3], t: f64, unit: f64) -> DVec3 {
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
pub(super) fn first_leg(controls: &[DVec3]) -> DVec3 {
    let first = controls[0];
    controls.iter().find(|&&p| p != first).map_or(DVec3::ZERO, |&p| p - first)
}

/// To the last control point, from the one before that differs.
pub(super) fn last_leg(controls: &[DVec3]) -> DVec3 {
    let last = controls[controls.len() - 1];
    controls.iter().rev().find(|&&p| p != last).map_or(DVec3::ZERO, |&p| last - p)
}

//! The real roots of a cubic in closed form.

use gusset_base::sort;

/// Returns the one to three real roots of a t^3 + b t^2 + c t + d, ascending. Returns `None` if a
/// is too small relative to the other coefficients for the formula.
///
/// With t = x - b / (3 a), the equation is x^3 + 3 p x + 2 q = 0 with the discriminant q^2 + p^3.
/// One real root follows from Cardano's formula, three from Viète's cosines. Two Newton steps then
/// refine each root.
pub(super) fn real_cubic_roots(a: f64, b: f64, c: f64, d: f64) -> Option<([f64; 3], usize)> {
    let size = b.abs().max(c.abs()).max(d.abs());
    if a.abs() <= 1e-6 * size || a == 0.0 {
        return None;
    }
    let (b, c, d) = (b / a, c / a, d / a);
    let shift = -b / 3.0;
    let p = c / 3.0 - shift * shift;
    let q = (d + shift * (c + shift * (b + shift))) * 0.5;
    let discriminant = q * q + p * p * p;
    let mut roots = [0.0; 3];
    let count = if discriminant >= 0.0 {
        // u^3 = -q -+ sqrt, with the sign that avoids cancellation; v = -p / u.
        let root = discriminant.sqrt();
        let u = libm::cbrt(if q > 0.0 { -q - root } else { root - q });
        let v = if u == 0.0 { 0.0 } else { -p / u };
        // Rounding may have hidden a double root at -(u + v) / 2, so add it as a candidate.
        roots = [shift + u + v, shift - 0.5 * (u + v), 0.0];
        2
    } else {
        let radius = (-p).sqrt();
        let angle = libm::acos((-q / (radius * radius * radius)).clamp(-1.0, 1.0)) / 3.0;
        let third = 2.0 * std::f64::consts::FRAC_PI_3;
        for (k, root) in roots.iter_mut().enumerate() {
            *root = shift + 2.0 * radius * libm::cos(angle - third * k as f64);
        }
        3
    };
    for t in &mut roots[..count] {
        for _ in 0..2 {
            let value = d + *t * (c + *t * (b + *t));
            let slope = c + *t * (2.0 * b + 3.0 * *t);
            let next = *t - value / slope;
            if next.is_finite() && (next - *t).abs() < 1e-3 * (1.0 + t.abs()) {
                *t = next;
            }
        }
    }
    sort::sort_stable(&mut roots[..count], &f64::total_cmp);
    Some((roots, count))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn known_roots_are_found(r in [-2.0..2.0f64, -2.0..2.0f64, -2.0..2.0f64]) {
            let [x, y, z] = r;
            let (found, count) = real_cubic_roots(1.0, -(x + y + z), x * y + y * z + z * x, -x * y * z).unwrap();
            for root in r {
                // A double root may be off by 1e-8.
                prop_assert!(found[..count].iter().any(|t| (t - root).abs() < 1e-5), "{:?} {:?}", r, found);
            }
        }
    }
}

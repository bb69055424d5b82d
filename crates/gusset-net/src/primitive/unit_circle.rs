//! Points of the unit circle that are exactly periodic and symmetric. O(1).

use std::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_2};

/// Returns cosine and sine of `k` n-ths of a turn.
///
/// The bits for k and k + n are equal, quarter turns are exact, and the values are symmetric: each
/// is a value of the first eighth of a turn, up to sign and exchange. Zeros are positive.
pub(super) fn point_on_unit_circle(k: usize, n: usize) -> [f64; 2] {
    let (k, n) = (k as u64 % n as u64, n as u64);
    let (quarter, rest) = (4 * k / n, 4 * k % n);
    let angle = |numerator: u64| FRAC_PI_2 * (numerator as f64 / n as f64);
    let [c, s] = match (2 * rest).cmp(&n) {
        std::cmp::Ordering::Less => [libm::cos(angle(rest)), libm::sin(angle(rest))],
        std::cmp::Ordering::Equal => [FRAC_1_SQRT_2; 2],
        std::cmp::Ordering::Greater => [libm::sin(angle(n - rest)), libm::cos(angle(n - rest))],
    };
    let turned = match quarter {
        0 => [c, s],
        1 => [-s, c],
        2 => [-c, -s],
        _ => [s, -c],
    };
    turned.map(|value| value + 0.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_are_periodic_and_symmetric() {
        for n in 1..40 {
            for k in 0..n {
                let [c, s] = point_on_unit_circle(k, n);
                assert_eq!([c, s].map(f64::to_bits), point_on_unit_circle(k + n, n).map(f64::to_bits));
                assert!((c * c + s * s - 1.0).abs() < 1e-15);
                assert!((c - (std::f64::consts::TAU * k as f64 / n as f64).cos()).abs() < 1e-14);
                let [mirrored, opposite] = point_on_unit_circle(n - k, n);
                assert!(mirrored == c && opposite == -s);
            }
        }
        assert_eq!(point_on_unit_circle(1, 4), [0.0, 1.0]);
        assert_eq!(point_on_unit_circle(9, 12), [0.0, -1.0]);
    }
}

//! Sign changes of a polynomial in Bernstein form between 0 and 1.
//!
//! The value 0 counts as positive, as if an infinitesimal number were added to the polynomial. No
//! coefficient is then 0, and Descartes' rule in Bernstein form (Farouki and Rajan 1987) is exact.
//! Without sign changes among the coefficients, the polynomial lacks roots. With one change, it has
//! one simple root. Otherwise the interval is halved. The results always agree with the signs at
//! the ends, even with rounding, so callers may rely on parity.

use gusset_base::geom::bernstein::{
    sign_changes, value_and_slope_by_differences as value_and_slope, visit_by_bisection,
};

/// Intervals of this length are not halved: roots closer to each other count as one, or none.
const MIN_HALVED_INTERVAL: f64 = 1.0 / (1_u64 << 44) as f64;

/// A sign change.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct SideSignChange {
    pub(super) side_parameter: f64,
    /// True if the sign changes from minus to plus with increasing t.
    pub(super) rising: bool,
}

/// Whether a value counts as positive. 0 does.
#[inline(always)]
pub(super) fn counts_as_positive(value: f64) -> bool {
    value >= 0.0
}

/// Finds the sign changes in ascending order. `ends` tells whether the ends count as positive. If
/// the polynomial has another sign at an end, the sign changes at the end itself.
#[inline]
pub(super) fn find_sign_changes<const M: usize>(c: &[f64; M], ends: [bool; 2], mut found: impl FnMut(SideSignChange)) {
    let [start, end] = [counts_as_positive(c[0]), counts_as_positive(c[M - 1])];
    if start != ends[0] {
        found(SideSignChange { side_parameter: 0.0, rising: start });
    }
    find_inner_sign_changes(c, &mut found);
    if end != ends[1] {
        found(SideSignChange { side_parameter: 1.0, rising: ends[1] });
    }
}

/// Finds the sign changes in the interior.
#[inline]
fn find_inner_sign_changes<const M: usize>(c: &[f64; M], found: &mut impl FnMut(SideSignChange)) {
    visit_by_bisection(&mut c.clone(), [0.0, 1.0], &mut |c, [from, to]| {
        let rising = counts_as_positive(c[M - 1]);
        match sign_changes(c.iter().map(|&x| counts_as_positive(x))) {
            0 => return false,
            1 => found(SideSignChange {
                side_parameter: from + (to - from) * find_bracketed_root(c, [0.0, 1.0]),
                rising,
            }),
            _ if to - from > MIN_HALVED_INTERVAL => return true,
            _ if counts_as_positive(c[0]) != rising => {
                found(SideSignChange { side_parameter: 0.5 * (from + to), rising });
            }
            _ => {}
        }
        false
    });
}

/// Smallest distance of the first guess of a root from the ends, as a fraction of the interval.
const MIN_GUESS_FRACTION_FROM_ENDS: f64 = 1.0 / 1024.0;

/// The root between `low` and `high`, where the polynomial has opposite signs and changes sign
/// once. Newton's method, safeguarded by bisection.
///
/// The value 0 at an end counts as positive. If the polynomial is positive next to such an end, the
/// root is elsewhere, and secants and tangents must not end there.
#[inline]
pub(super) fn find_bracketed_root<const M: usize>(c: &[f64; M], [low, high]: [f64; 2]) -> f64 {
    let ([start, first], [end, last]) = (value_and_slope(c, low), value_and_slope(c, high));
    let rising = counts_as_positive(end);
    if counts_as_positive(start) == rising {
        // Rounding removed the sign change. The caller must judge the value.
        return if start.abs() <= end.abs() { low } else { high };
    }
    // The sign changes at the end itself.
    if start == 0.0 && first < 0.0 {
        return low;
    }
    if end == 0.0 && last > 0.0 {
        return high;
    }
    let (mut from, mut to) = (low, high);
    let mut t = from
        + (to - from) * (start / (start - end)).clamp(MIN_GUESS_FRACTION_FROM_ENDS, 1.0 - MIN_GUESS_FRACTION_FROM_ENDS);
    for _ in 0..100 {
        let [value, slope] = value_and_slope(c, t);
        if counts_as_positive(value) == rising {
            to = t;
        } else {
            from = t;
        }
        let newton = t - value / slope;
        // NaN and infinity, from slope 0, fail this test too.
        let inside = newton >= from && newton <= to && newton > low && newton < high;
        let next = if inside { newton } else { 0.5 * (from + to) };
        let step = (next - t).abs();
        t = next;
        if step <= 1e-11 && next == newton || to - from <= 4e-16 {
            break;
        }
    }
    t
}

#[cfg(test)]
mod tests {
    use super::*;

    fn all_crossings<const M: usize>(c: [f64; M], ends: [bool; 2]) -> Vec<SideSignChange> {
        let mut list = Vec::new();
        find_sign_changes(&c, ends, |crossing| list.push(crossing));
        list
    }

    #[test]
    fn signs_at_the_ends_are_kept() {
        // A line through 1/2, with true and with false signs at its ends.
        let line = [-1.0, -1.0 / 3.0, 1.0 / 3.0, 1.0];
        assert_eq!(all_crossings(line, [false, true]), [SideSignChange { side_parameter: 0.5, rising: true }]);
        for ends in [[true, true], [false, false], [true, false]] {
            let list = all_crossings(line, ends);
            let mut sign = ends[0];
            for crossing in &list {
                assert_eq!(crossing.rising, !sign);
                sign = crossing.rising;
            }
            assert!(sign == ends[1] && list.iter().any(|crossing| crossing.side_parameter == 0.5), "{list:?}");
        }
        // The zero polynomial is positive. A value 0 at the start of a negative polynomial is a
        // root there.
        assert!(all_crossings([0.0; 4], [true, true]).is_empty());
        assert_eq!(
            all_crossings([0.0, -1.0, -1.0, -1.0], [true, false]),
            [SideSignChange { side_parameter: 0.0, rising: false }]
        );
        // The polynomial is 0 at an end, positive next to it, and changes sign elsewhere.
        let [inner] = all_crossings([-1.0, -0.1, 0.3, 0.0], [false, true])[..] else { panic!() };
        assert!(
            inner.rising
                && inner.side_parameter < 0.9
                && value_and_slope(&[-1.0, -0.1, 0.3, 0.0], inner.side_parameter)[0].abs() < 1e-15
        );
        let [inner] = all_crossings([0.0, 0.3, -0.1, -1.0], [true, false])[..] else { panic!() };
        assert!(
            !inner.rising
                && inner.side_parameter > 0.1
                && value_and_slope(&[0.0, 0.3, -0.1, -1.0], inner.side_parameter)[0].abs() < 1e-15
        );
        // A double root, touched from above and from below.
        assert!(all_crossings([0.25, -0.25, 0.25], [true, true]).len() % 2 == 0);
        assert!(all_crossings([0.25 + 1e-12, -0.25, 0.25], [true, true]).is_empty());
        let two = all_crossings([0.25 - 1e-12, -0.25, 0.25], [true, true]);
        assert!(
            two.len() == 2
                && two[1].side_parameter - two[0].side_parameter < 3e-6
                && two[1].side_parameter > two[0].side_parameter
        );
    }

    #[test]
    fn all_roots_of_a_product_are_found() {
        // (t - 0.2) (t - 0.5) (t - 0.9) as a cubic, from its blossom at 0 and 1.
        let (a, b, d) = (0.2, 0.5, 0.9);
        let blossom = |x: f64, y: f64, z: f64| {
            x * y * z - (a + b + d) / 3.0 * (x * y + y * z + z * x) + (a * b + b * d + d * a) / 3.0 * (x + y + z)
                - a * b * d
        };
        let c = [blossom(0., 0., 0.), blossom(0., 0., 1.), blossom(0., 1., 1.), blossom(1., 1., 1.)];
        let list = all_crossings(c, [false, true]);
        assert_eq!(list.len(), 3);
        for (crossing, root) in list.iter().zip([a, b, d]) {
            assert!((crossing.side_parameter - root).abs() < 1e-14, "{list:?}");
        }
        assert!(list[0].rising && !list[1].rising && list[2].rising);
    }
}

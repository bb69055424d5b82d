//! Where a polynomial in Bernstein form changes its sign between 0 and 1.
//!
//! Values of 0 count as positive, as if an infinitely small number were added to the polynomial: then no coefficient is 0, and Descartes'
//! rule in Bernstein form (Farouki and Rajan 1987) is exact: no change of sign among the coefficients, no root; one change, one simple
//! root; otherwise the interval is halved. What is found fits the signs at the ends in any case, rounding or not: whoever relies on
//! parity may.

use crate::surface::subdivision::polynomial;

/// Halvings of the interval: what is nearer to each other is one root, or none.
const DEPTH: u32 = 44;

/// A change of sign.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Crossing {
    pub(super) t: f64,
    /// From minus to plus, as t rises.
    pub(super) rising: bool,
}

/// The sign of a value: 0 is positive.
#[inline(always)]
pub(super) fn positive(value: f64) -> bool {
    value >= 0.0
}

/// The changes of sign by rising t. `ends`: whether the ends count as positive; where the polynomial has another sign there, it changes
/// at the end itself.
#[inline]
pub(super) fn crossings<const M: usize>(c: &[f64; M], ends: [bool; 2], mut found: impl FnMut(Crossing)) {
    let [start, end] = [positive(c[0]), positive(c[M - 1])];
    if start != ends[0] {
        found(Crossing { t: 0.0, rising: start });
    }
    isolate(c, 0.0, 1.0, DEPTH, &mut found);
    if end != ends[1] {
        found(Crossing { t: 1.0, rising: ends[1] });
    }
}

/// The changes of sign of a part, which reaches from `from` to `to`.
fn isolate<const M: usize>(c: &[f64; M], from: f64, to: f64, depth: u32, found: &mut impl FnMut(Crossing)) {
    let changes = (1..M).filter(|&k| positive(c[k]) != positive(c[k - 1])).count();
    if changes == 0 {
        return;
    }
    if changes == 1 {
        let t = bracketed(c, [0.0, 1.0]);
        return found(Crossing { t: from + (to - from) * t, rising: positive(c[M - 1]) });
    }
    if depth == 0 {
        if positive(c[0]) != positive(c[M - 1]) {
            found(Crossing { t: 0.5 * (from + to), rising: positive(c[M - 1]) });
        }
        return;
    }
    let (mut low, mut high) = (*c, *c);
    for (k, coefficient) in low.iter_mut().enumerate().skip(1) {
        for a in 0..M - k {
            high[a] = 0.5 * (high[a] + high[a + 1]);
        }
        *coefficient = high[0];
    }
    let middle = 0.5 * (from + to);
    isolate(&low, from, middle, depth - 1, found);
    isolate(&high, middle, to, depth - 1, found);
}

/// How near to the ends the first guess of a root may be, in parts of the interval.
const EDGE: f64 = 1.0 / 1024.0;

/// A root between `from` and `to`, where the polynomial has different signs and changes its sign once: Newton's method, kept between by
/// halving.
///
/// A value of 0 at an end counts as positive. If the polynomial is positive next to it, the sign changes elsewhere: neither a secant nor a
/// tangent may end there.
#[inline]
pub(super) fn bracketed<const M: usize>(c: &[f64; M], [low, high]: [f64; 2]) -> f64 {
    let ([start, first], [end, last]) = (polynomial(c, low), polynomial(c, high));
    let rising = positive(end);
    if positive(start) == rising {
        // Nothing to bracket but rounding: whoever calls judges the value.
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
    let mut t = from + (to - from) * (start / (start - end)).clamp(EDGE, 1.0 - EDGE);
    for _ in 0..100 {
        let [value, slope] = polynomial(c, t);
        if positive(value) == rising {
            to = t;
        } else {
            from = t;
        }
        let newton = t - value / slope;
        // NaN and infinity of slope 0 fail the test too.
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

    fn found<const M: usize>(c: [f64; M], ends: [bool; 2]) -> Vec<Crossing> {
        let mut list = Vec::new();
        crossings(&c, ends, |crossing| list.push(crossing));
        list
    }

    #[test]
    fn signs_at_the_ends_are_kept() {
        // A line through 1/2, with true and with false signs at its ends.
        let line = [-1.0, -1.0 / 3.0, 1.0 / 3.0, 1.0];
        assert_eq!(found(line, [false, true]), [Crossing { t: 0.5, rising: true }]);
        for ends in [[true, true], [false, false], [true, false]] {
            let list = found(line, ends);
            let mut sign = ends[0];
            for crossing in &list {
                assert_eq!(crossing.rising, !sign);
                sign = crossing.rising;
            }
            assert!(sign == ends[1] && list.iter().any(|crossing| crossing.t == 0.5), "{list:?}");
        }
        // 0 all along is positive; 0 at the start of what is negative is a root there.
        assert!(found([0.0; 4], [true, true]).is_empty());
        assert_eq!(found([0.0, -1.0, -1.0, -1.0], [true, false]), [Crossing { t: 0.0, rising: false }]);
        // 0 at an end of what is positive there, and changes its sign elsewhere.
        let [inner] = found([-1.0, -0.1, 0.3, 0.0], [false, true])[..] else { panic!() };
        assert!(inner.rising && inner.t < 0.9 && polynomial(&[-1.0, -0.1, 0.3, 0.0], inner.t)[0].abs() < 1e-15);
        let [inner] = found([0.0, 0.3, -0.1, -1.0], [true, false])[..] else { panic!() };
        assert!(!inner.rising && inner.t > 0.1 && polynomial(&[0.0, 0.3, -0.1, -1.0], inner.t)[0].abs() < 1e-15);
        // A double root, touched from above and from below.
        assert!(found([0.25, -0.25, 0.25], [true, true]).len() % 2 == 0);
        assert!(found([0.25 + 1e-12, -0.25, 0.25], [true, true]).is_empty());
        let two = found([0.25 - 1e-12, -0.25, 0.25], [true, true]);
        assert!(two.len() == 2 && two[1].t - two[0].t < 3e-6 && two[1].t > two[0].t);
    }

    #[test]
    fn all_roots_of_a_product() {
        // (t - 0.2) (t - 0.5) (t - 0.9) as a cubic: the blossom at 0 and 1.
        let (a, b, d) = (0.2, 0.5, 0.9);
        let blossom = |x: f64, y: f64, z: f64| {
            x * y * z - (a + b + d) / 3.0 * (x * y + y * z + z * x) + (a * b + b * d + d * a) / 3.0 * (x + y + z)
                - a * b * d
        };
        let c = [blossom(0., 0., 0.), blossom(0., 0., 1.), blossom(0., 1., 1.), blossom(1., 1., 1.)];
        let list = found(c, [false, true]);
        assert_eq!(list.len(), 3);
        for (crossing, root) in list.iter().zip([a, b, d]) {
            assert!((crossing.t - root).abs() < 1e-14, "{list:?}");
        }
        assert!(list[0].rising && !list[1].rising && list[2].rising);
    }
}

//! All real roots of a polynomial in Bernstein form between 0 and 1.
//!
//! Descartes' rule in Bernstein form (Farouki and Rajan 1987): the number of roots in (0, 1) is the
//! number of sign changes of the coefficients, or less by an even number. No change or one change
//! decides an interval. Otherwise de Casteljau's scheme halves it exactly. Newton's method, kept
//! within its bracket, converges to a single root.
//!
//! At multiple roots, rounding hides the sign: values within `noise` of 0 cannot be distinguished
//! from 0. The rule is therefore applied to f - noise and f + noise. If neither has more than one
//! sign change, f is within the noise on at most one interval; otherwise the halving continues.
//! Intervals whose coefficients are all within the noise merge with adjacent roots into one root.
//! The root is placed where the polynomial changes its sign, or else its first or second
//! derivative, or else in the middle. A root of multiplicity m is thus found once. Places that come
//! closer to 0 than the noise without reaching 0 count as double roots.

use super::casteljau::{differentiate, halve};
use super::polynomial::{MAX_COEFFICIENTS, value_and_slope};

/// The roots, in ascending order.
#[derive(Clone, Copy)]
pub struct Roots {
    roots: [f64; MAX_COEFFICIENTS],
    len: usize,
    /// The polynomial is indistinguishable from 0 everywhere. The list of roots is then empty.
    pub everywhere: bool,
}

impl Default for Roots {
    fn default() -> Self {
        Roots { roots: [0.0; MAX_COEFFICIENTS], len: 0, everywhere: false }
    }
}

impl Roots {
    #[inline]
    pub fn as_slice(&self) -> &[f64] {
        &self.roots[..self.len]
    }

    fn push(&mut self, t: f64) {
        if self.len < MAX_COEFFICIENTS {
            self.roots[self.len] = t;
            self.len += 1;
        }
    }
}

/// Visits a polynomial over `from` to `to`. If `visit` returns true, it visits the halves
/// recursively, from left to right. O(n^2) for each halving.
pub fn visit_by_bisection<A: AsRef<[f64]> + AsMut<[f64]> + Clone>(
    c: &mut A,
    [from, to]: [f64; 2],
    visit: &mut impl FnMut(&A, [f64; 2]) -> bool,
) {
    if visit(c, [from, to]) {
        let mut before = c.clone();
        halve(c.as_mut(), before.as_mut());
        let middle = 0.5 * (from + to);
        visit_by_bisection(&mut before, [from, middle], visit);
        visit_by_bisection(c, [middle, to], visit);
    }
}

/// Returns the number of sign changes. By Descartes' rule, the number of roots in (0, 1) is at most
/// this and differs by an even number.
#[inline(always)]
pub fn sign_changes(signs: impl Iterator<Item = bool>) -> usize {
    let mut last = None;
    signs.filter(|&sign| last.replace(sign).is_some_and(|last| last != sign)).count()
}

/// Coefficients in a fixed-size buffer.
#[derive(Clone)]
struct CoefficientBuffer {
    coefficients: [f64; MAX_COEFFICIENTS],
    len: usize,
}

impl CoefficientBuffer {
    fn from_slice(given: &[f64]) -> Self {
        let mut c = [0.0; MAX_COEFFICIENTS];
        c[..given.len()].copy_from_slice(given);
        CoefficientBuffer { coefficients: c, len: given.len() }
    }
}

impl AsRef<[f64]> for CoefficientBuffer {
    fn as_ref(&self) -> &[f64] {
        &self.coefficients[..self.len]
    }
}

impl AsMut<[f64]> for CoefficientBuffer {
    fn as_mut(&mut self) -> &mut [f64] {
        &mut self.coefficients[..self.len]
    }
}

/// Intervals of this width are not halved.
const MIN_INTERVAL_WIDTH: f64 = 1.0 / (1u64 << 48) as f64;

/// The maximum number of halvings for one polynomial. Its roots need fewer, but values that
/// rounding moves back and forth across the noise could need any number.
const MAX_INTERVAL_HALVINGS: u32 = 20_000;

/// Finds the roots of a polynomial with 1 to [`MAX_COEFFICIENTS`] coefficients. Values up to
/// `noise` (absolute) count as 0.
///
/// O(n^2) for each halving. A simple root takes about log2(1 / d) halvings if the next root is at
/// distance d. A root of multiplicity m takes about log2(1 / noise) / m.
pub fn roots(c: &[f64], noise: f64) -> Roots {
    let mut found = Roots::default();
    if c.is_empty() || c.len() > MAX_COEFFICIENTS {
        return found;
    }
    if c.iter().all(|x| x.abs() <= noise) {
        found.everywhere = true;
        return found;
    }
    // If the last interval has no root, the signs of its coefficients decide.
    if c.iter().all(|&x| x > noise) || c.iter().all(|&x| x < -noise) {
        return found;
    }
    if let [a, b] = *c {
        push_linear_root(a, b, noise, &mut found);
        return found;
    }
    if let [a, b, d] = *c
        && push_quadratic_roots(a, b, d, noise, &mut found)
    {
        return found;
    }
    let mut search = RootIsolation {
        coefficients: c,
        noise,
        clusters: [(0.0, 0.0); MAX_COEFFICIENTS],
        len: 0,
        halvings_left: MAX_INTERVAL_HALVINGS,
    };
    visit_by_bisection(&mut CoefficientBuffer::from_slice(c), [0.0, 1.0], &mut |part, interval| {
        search.isolate_roots(part.as_ref(), interval)
    });
    for &(low, high) in &search.clusters[..search.len] {
        found.push(search.root_of_cluster(low, high));
    }
    found
}

/// The root of a (1 - t) + b t, where a and b are not both within the noise.
fn push_linear_root(a: f64, b: f64, noise: f64, found: &mut Roots) {
    if a.abs() <= noise {
        found.push(0.0);
    } else if b.abs() <= noise {
        found.push(1.0);
    } else if (a < 0.0) != (b < 0.0) {
        found.push(a / (a - b));
    }
}

/// Finds the roots of a (1 - t)^2 + 2 b t (1 - t) + d t^2 in closed form. Returns false if a root
/// is too close to an end, or two roots are too close to each other, so that the search must
/// decide.
///
/// With A = a - 2 b + d and B = b - a, the equation is A t^2 + 2 B t + a = 0. Its roots are a / q
/// and q / A with q = -B -+ sqrt(b^2 - a d), where the sign avoids cancellation.
fn push_quadratic_roots(a: f64, b: f64, d: f64, noise: f64, found: &mut Roots) -> bool {
    let discriminant = b * b - a * d;
    let size = a.abs().max(b.abs()).max(d.abs());
    if a.abs() <= noise || d.abs() <= noise || discriminant.abs() <= 4.0 * noise * size {
        return false;
    }
    if discriminant < 0.0 {
        return true;
    }
    let (quadratic, linear) = ((a - b) + (d - b), b - a);
    let root = discriminant.sqrt();
    let q = if linear < 0.0 { root - linear } else { -root - linear };
    // q is 0 only if the discriminant is 0.
    let (mut first, mut second) = (a / q, q / quadratic);
    if first > second {
        (first, second) = (second, first);
    }
    for t in [first, second] {
        // NaN and infinity from A = 0 fail this test too.
        if (0.0..=1.0).contains(&t) {
            found.push(t);
        }
    }
    true
}

struct RootIsolation<'a> {
    coefficients: &'a [f64],
    noise: f64,
    /// The intervals where the polynomial is within the noise; most are single points.
    clusters: [(f64, f64); MAX_COEFFICIENTS],
    len: usize,
    halvings_left: u32,
}

impl RootIsolation<'_> {
    /// Finds the roots between two ends, from left to right; the polynomial has the coefficients
    /// `coefficients` there. Returns true if the halves must be searched instead.
    fn isolate_roots(&mut self, coefficients: &[f64], [low, high]: [f64; 2]) -> bool {
        let noise = self.noise;
        if coefficients.iter().all(|x| x.abs() <= noise) {
            self.add_root_interval(low, high);
            return false;
        }
        let changes = |level: f64| sign_changes(coefficients.iter().map(|&x| x > level));
        if changes(noise).max(changes(-noise)) > 1 {
            let decides = high - low <= MIN_INTERVAL_WIDTH || self.halvings_left == 0;
            if decides {
                self.add_root_interval(low, high);
            } else {
                self.halvings_left -= 1;
            }
            return !decides;
        }
        // The polynomial is within the noise on at most one interval, at a crossing or at an end.
        let (first, last) = (coefficients[0], coefficients[coefficients.len() - 1]);
        if first.abs() <= noise {
            self.add_root_interval(low, low);
        } else if last.abs() <= noise {
            self.add_root_interval(high, high);
        } else if (first < 0.0) != (last < 0.0) {
            let t = low + (high - low) * bracketed_root(0.0, 1.0, first, |t| value_and_slope(coefficients, t));
            self.add_root_interval(t, t);
        }
        false
    }

    /// Appends a root, or an interval of roots. If an interval ends within the noise, the next one
    /// starts within the noise, and both belong to the same root.
    fn add_root_interval(&mut self, low: f64, high: f64) {
        if self.len > 0 {
            let last = &mut self.clusters[self.len - 1];
            if low <= last.1 {
                last.1 = last.1.max(high);
                return;
            }
        }
        if self.len < MAX_COEFFICIENTS {
            self.clusters[self.len] = (low, high);
            self.len += 1;
        }
    }

    /// Returns the root of a cluster. Prefers an end of the whole interval, because the adjacent
    /// segment finds the same root there.
    fn root_of_cluster(&self, low: f64, high: f64) -> f64 {
        if low == high || low <= 0.0 {
            return low.max(0.0);
        }
        if high >= 1.0 {
            return 1.0;
        }
        let (a, b) = ((low - (high - low)).max(0.0), (high + (high - low)).min(1.0));
        let mut derived = [0.0; MAX_COEFFICIENTS];
        derived[..self.coefficients.len()].copy_from_slice(self.coefficients);
        let mut n = self.coefficients.len();
        for _ in 0..3 {
            let c = &derived[..n];
            let (fa, fb) = (value_and_slope(c, a).0, value_and_slope(c, b).0);
            let largest = c.iter().fold(0.0f64, |m, x| m.max(x.abs()));
            if fa * fb < 0.0 && fa.abs().min(fb.abs()) > 4.0 * self.noise.max(f64::EPSILON * largest) {
                return bracketed_root(a, b, fa, |t| value_and_slope(c, t));
            }
            if n == 1 {
                break;
            }
            n = differentiate(&mut derived[..n]);
        }
        0.5 * (low + high)
    }
}

/// Finds the root of a function in a bracket. `at_low` is the value at `low`, and the value at
/// `high` has the opposite sign. Newton's method starts in the middle; a step that leaves the
/// bracket or does not halve the previous step is replaced by bisection. At most 100 rounds.
pub fn bracketed_root(mut low: f64, mut high: f64, at_low: f64, f: impl Fn(f64) -> (f64, f64)) -> f64 {
    let mut t = 0.5 * (low + high);
    let mut last_step = high - low;
    for _ in 0..100 {
        let (value, slope) = f(t);
        if value == 0.0 {
            return t;
        }
        if (value < 0.0) == (at_low < 0.0) {
            low = t;
        } else {
            high = t;
        }
        let newton = t - value / slope;
        let inside = newton > low && newton < high && (newton - t).abs() <= 0.5 * last_step.abs();
        let next = if inside { newton } else { 0.5 * (low + high) };
        last_step = next - t;
        if next == t || next <= low || next >= high {
            return next;
        }
        t = next;
    }
    t
}

#[cfg(test)]
mod tests {
    use super::super::polynomial::add_product;
    use super::*;
    use proptest::prelude::*;

    /// Returns the polynomial with the given roots.
    fn polynomial_with_roots(at: &[f64]) -> Vec<f64> {
        at.iter().fold(vec![1.0], |f, &r| {
            let mut product = vec![0.0; f.len() + 1];
            add_product(&f, &[-r, 1.0 - r], 1.0, &mut product);
            product
        })
    }

    fn normalise_coefficients(mut c: Vec<f64>) -> Vec<f64> {
        let size = c.iter().fold(0.0f64, |m, x| m.max(x.abs()));
        c.iter_mut().for_each(|x| *x /= size);
        c
    }

    const ROOT_NOISE: f64 = 1e-14;

    #[test]
    fn known_roots_are_found() {
        for (given, expected, error) in [
            (&[0.5][..], &[0.5][..], 1e-16),
            (&[0.25, 0.75], &[0.25, 0.75], 1e-15),
            (&[0.25, 0.25], &[0.25], 1e-7),
            (&[-0.5, 1.5], &[], 0.0),
            (&[0.0, 1.0], &[0.0, 1.0], 0.0),
            (&[0.0, 0.0, 0.3], &[0.0, 0.3], 1e-13),
            (&[0.1, 0.2, 0.3, 0.4, 0.5], &[0.1, 0.2, 0.3, 0.4, 0.5], 1e-9),
            (&[0.3, 0.3, 0.3], &[0.3], 1e-4),
            (&[0.3, 0.3, 0.7, 0.7], &[0.3, 0.7], 1e-6),
            (&[1.0, 1.0, 1.0, 0.5], &[0.5, 1.0], 1e-12),
            (&[0.123, 0.123_001, 0.9], &[0.123, 0.123_001, 0.9], 1e-8),
        ] {
            let found = roots(&normalise_coefficients(polynomial_with_roots(given)), ROOT_NOISE);
            assert_eq!(found.as_slice().len(), expected.len(), "{given:?}: {:?}", found.as_slice());
            for (a, b) in found.as_slice().iter().zip(expected) {
                assert!((a - b).abs() <= error, "{given:?}: {:?}", found.as_slice());
            }
        }
        assert!(roots(&[1e-15, -1e-15, 0.0], ROOT_NOISE).everywhere);
        assert!(roots(&[], ROOT_NOISE).as_slice().is_empty());
        assert!(roots(&[1.0, 0.2, 1.0], ROOT_NOISE).as_slice().is_empty());
        assert!(roots(&[1.0, f64::NAN, -1.0, 2.0], ROOT_NOISE).as_slice().len() < 4);
    }

    /// (t - a)^2 times a factor that is not 0 at `a`, raised by less than the noise, touches 0 for
    /// any rounding. The polynomial raised by 5 times the noise does not.
    #[test]
    fn every_double_root_is_found_and_no_other() {
        let factors: [&[f64]; 4] = [&[1.0], &[-0.7, 0.3], &[0.3, 0.5, 0.1], &[1.0, 0.2, 0.3, 2.0]];
        for (k, factor) in factors.iter().enumerate() {
            for i in 1..400 {
                let a = f64::from(i) / 400.0 + 1e-4 * (f64::from(i) * 0.7).sin();
                let Some(sign) = [value_and_slope(factor, a).0].into_iter().find(|x| x.abs() > 0.05) else { continue };
                let mut product = vec![0.0; factor.len() + 2];
                add_product(&[a * a, -a * (1.0 - a), (1.0 - a) * (1.0 - a)], factor, 1.0, &mut product);
                for (lift, touches) in [(0.0, 1), (0.5, 1), (-0.5, 1), (5.0, 0)] {
                    let c: Vec<f64> = product.iter().map(|x| x + lift * ROOT_NOISE * sign.signum()).collect();
                    let found = roots(&c, ROOT_NOISE);
                    let near = found.as_slice().iter().filter(|&&t| (t - a).abs() < 1e-5);
                    assert_eq!(near.count(), touches, "factor {k}, a {a}, lift {lift}: {:?}", found.as_slice());
                }
            }
        }
    }

    proptest! {
        #[test]
        fn separated_roots_are_all_found(
            at in proptest::collection::vec(0.0..1.0f64, 1..7), outside in proptest::collection::vec(1.2..3.0f64, 0..4)
        ) {
            let mut at = at;
            at.sort_by(f64::total_cmp);
            at.dedup_by(|a, b| *a - *b < 0.05);
            let all: Vec<f64> = at.iter().copied().chain(outside).collect();
            let found = roots(&normalise_coefficients(polynomial_with_roots(&all)), ROOT_NOISE);
            prop_assert_eq!(found.as_slice().len(), at.len());
            for (a, b) in found.as_slice().iter().zip(&at) {
                prop_assert!((a - b).abs() < 1e-8);
            }
        }

        #[test]
        fn signs_change_only_at_roots(c in proptest::collection::vec(-1.0..1.0f64, 1..20)) {
            let found = roots(&c, ROOT_NOISE);
            let mut stops = vec![0.0];
            stops.extend_from_slice(found.as_slice());
            stops.push(1.0);
            for pair in stops.windows(2) {
                let inside = |k: i32| pair[0] + (pair[1] - pair[0]) * (0.01 + 0.98 * f64::from(k) / 50.0);
                let values: Vec<f64> = (0..=50).map(|k| value_and_slope(&c, inside(k)).0).collect();
                prop_assert!(values.iter().all(|&v| v >= -1e-12) || values.iter().all(|&v| v <= 1e-12));
            }
            for &t in found.as_slice() {
                prop_assert!(value_and_slope(&c, t).0.abs() < 1e-12);
            }
        }
    }
}

//! De Casteljau's scheme: evaluation, subdivision, degree elevation, derivatives, blossoms and
//! basis functions.
//!
//! Source: Farin, Curves and Surfaces for CAGD (2002), chapters 4 to 6. A column of the scheme
//! replaces each coefficient by a combination of itself and the next one. O(n^2).

use glam::{DVec2, DVec3, DVec4};
use std::ops::{Mul, Sub};

/// A coefficient: a number, a point, or a row of coefficients.
pub trait Coefficient: Copy {
    /// Replaces the coefficient by (1 - t) times itself plus t times the next one.
    fn blend(&mut self, next: &Self, t: f64);

    /// Replaces the coefficient by the mean of itself and the next one.
    fn average(&mut self, next: &Self);
}

macro_rules! plain_coefficients {
    ($($kind:ty)*) => {$(
        impl Coefficient for $kind {
            #[inline(always)]
            fn blend(&mut self, next: &Self, t: f64) {
                *self = *self * (1.0 - t) + *next * t;
            }

            #[inline(always)]
            fn average(&mut self, next: &Self) {
                *self = 0.5 * (*self + *next);
            }
        }
    )*};
}
plain_coefficients! { f64 DVec2 DVec3 DVec4 }

impl<T: Coefficient, const N: usize> Coefficient for [T; N] {
    #[inline(always)]
    fn blend(&mut self, next: &Self, t: f64) {
        self.iter_mut().zip(next).for_each(|(x, next)| x.blend(next, t));
    }

    #[inline(always)]
    fn average(&mut self, next: &Self) {
        self.iter_mut().zip(next).for_each(|(x, next)| x.average(next));
    }
}

/// One column of de Casteljau's scheme: combines each coefficient except the last with the next
/// one.
#[inline(always)]
fn combine_neighbours<T>(c: &mut [T], combine: impl Fn(&mut T, &T)) {
    for k in 1..c.len() {
        let (before, after) = c.split_at_mut(k);
        combine(&mut before[k - 1], &after[0]);
    }
}

/// Applies de Casteljau's columns at t until `keep` coefficients are left, at the start of `c`. The
/// other coefficients keep their last values.
#[inline(always)]
pub fn reduce_by_casteljau<T: Coefficient>(c: &mut [T], t: f64, keep: usize) {
    for count in (keep..c.len()).rev() {
        combine_neighbours(&mut c[..=count], |x, next| x.blend(next, t));
    }
}

#[inline(always)]
pub fn evaluate<T: Coefficient, const N: usize>(c: &[T; N], t: f64) -> T {
    let mut work = *c;
    reduce_by_casteljau(&mut work, t, 1);
    work[0]
}

/// Returns the value and the first derivative at t.
#[inline(always)]
pub fn evaluate_with_slope<T, const N: usize>(c: &[T; N], t: f64) -> [T; 2]
where
    T: Coefficient + Sub<Output = T> + Mul<f64, Output = T>,
{
    let mut work = *c;
    reduce_by_casteljau(&mut work, t, 2);
    let slope = (work[1] - work[0]) * (N - 1) as f64;
    reduce_by_casteljau(&mut work[..2], t, 1);
    [work[0], slope]
}

/// Returns the value and the first derivative at t. It blends by x + t (y - x), which is cheaper
/// than (1 - t) x + t y but may miss y at t = 1.
#[inline(always)]
pub fn value_and_slope_by_differences<const N: usize>(c: &[f64; N], t: f64) -> [f64; 2] {
    let mut work = *c;
    for count in (2..N).rev() {
        combine_neighbours(&mut work[..=count], |x, next| *x += t * (next - *x));
    }
    let rise = work[1] - work[0];
    [work[0] + t * rise, (N - 1) as f64 * rise]
}

/// Splits at t. `c` keeps the part after t; `before` receives the part before it.
#[inline(always)]
pub fn split<T: Coefficient>(c: &mut [T], t: f64, before: &mut [T]) {
    let n = c.len();
    for (k, first) in before.iter_mut().enumerate().take(n) {
        *first = c[0];
        combine_neighbours(&mut c[..n - k], |x, next| x.blend(next, t));
    }
}

/// Splits at 1/2. `c` keeps the part after 1/2; `before` receives the part before it.
#[inline(always)]
pub fn halve<T: Coefficient>(c: &mut [T], before: &mut [T]) {
    let n = c.len();
    for (k, first) in before.iter_mut().enumerate().take(n) {
        *first = c[0];
        combine_neighbours(&mut c[..n - k], Coefficient::average);
    }
}

/// Returns the parts before and after 1/2.
#[inline(always)]
pub fn halves<T: Coefficient, const N: usize>(c: &[T; N]) -> [[T; N]; 2] {
    let (mut before, mut after) = (*c, *c);
    halve(&mut after, &mut before);
    [before, after]
}

/// Restricts a polynomial to a range of parameters. The range [0, 1] returns it bit for bit.
#[inline(always)]
pub fn restrict<T: Coefficient>(c: &mut [T], [from, to]: [f64; 2]) {
    let mut end = to;
    if from > 0.0 {
        reduce_by_casteljau(c, from, 1);
        end = (to - from) / (1.0 - from);
    }
    if to < 1.0 {
        for first in 1..c.len() {
            for k in (first..c.len()).rev() {
                let mut x = c[k - 1];
                x.blend(&c[k], end);
                c[k] = x;
            }
        }
    }
}

/// Elevates a polynomial of `degree` to the degree that fills `c`. Each step to degree n sets
/// c'_k = k / n c_(k - 1) + (1 - k / n) c_k.
#[inline(always)]
pub fn elevate<T: Coefficient>(c: &mut [T], degree: usize) {
    for n in degree + 1..c.len() {
        c[n] = c[n - 1];
        for k in (1..n).rev() {
            let before = c[k - 1];
            c[k].blend(&before, k as f64 / n as f64);
        }
    }
}

/// Replaces the coefficients by the derivative's, n (c_(i + 1) - c_i), and returns their number: 0
/// for a constant.
#[inline(always)]
pub fn differentiate<T: Copy + Sub<Output = T> + Mul<f64, Output = T>>(c: &mut [T]) -> usize {
    let n = c.len().saturating_sub(1);
    for i in 0..n {
        c[i] = (c[i + 1] - c[i]) * n as f64;
    }
    n
}

/// Returns the blossom (Ramshaw 1987): the symmetric multi-affine function that equals the
/// polynomial if all arguments are equal. It takes one argument for each degree. Exact where the
/// arguments are 0 and 1.
#[inline(always)]
pub fn blossom<T: Coefficient, const N: usize>(c: &[T; N], arguments: impl IntoIterator<Item = f64>) -> T {
    let mut work = *c;
    for (count, t) in (1..N).rev().zip(arguments) {
        combine_neighbours(&mut work[..=count], |x, next| x.blend(next, t));
    }
    work[0]
}

/// Computes the values at t of the Bernstein polynomials whose degree fills `values`.
#[inline(always)]
pub fn bernstein_values(values: &mut [f64], t: f64) {
    values[0] = 1.0;
    for degree in 1..values.len() {
        values[degree] = 0.0;
        raise_basis_degree(&mut values[..=degree], t);
    }
}

/// Raises the degree of the basis by one. `values` holds the Bernstein polynomials at t, then a 0.
#[inline(always)]
fn raise_basis_degree(values: &mut [f64], t: f64) {
    for k in (1..values.len()).rev() {
        values[k] = (1.0 - t) * values[k] + t * values[k - 1];
    }
    values[0] *= 1.0 - t;
}

/// Returns the Bernstein polynomials of degree N - 1 >= 1 at t, and their derivatives.
#[inline(always)]
pub fn bernstein_values_and_slopes<const N: usize>(t: f64) -> [[f64; N]; 2] {
    let (mut values, mut slopes) = ([0.0; N], [0.0; N]);
    bernstein_values(&mut values[..N - 1], t);
    for k in 0..N {
        let before = if k > 0 { values[k - 1] } else { 0.0 };
        slopes[k] = (N - 1) as f64 * (before - values[k]);
    }
    raise_basis_degree(&mut values, t);
    [values, slopes]
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// Evaluates the definition term by term, with binomials from Pascal's triangle.
    fn evaluate_by_definition(c: &[f64], t: f64) -> f64 {
        let mut row = vec![1.0];
        for _ in 1..c.len() {
            row = (0..=row.len())
                .map(|k| if k > 0 { row[k - 1] } else { 0.0 } + row.get(k).copied().unwrap_or(0.0))
                .collect();
        }
        let term =
            |(i, (c, b)): (usize, (&f64, &f64))| b * c * t.powi(i as i32) * (1.0 - t).powi((row.len() - 1 - i) as i32);
        c.iter().zip(&row).enumerate().map(term).sum()
    }

    fn any_coefficients() -> impl Strategy<Value = [f64; 6]> {
        prop::array::uniform6(-1.0..1.0f64)
    }

    proptest! {
        #[test]
        fn values_agree_with_the_definition(c in any_coefficients(), t in 0.0..1.0f64) {
            let truth = evaluate_by_definition(&c, t);
            let steps: Vec<f64> = c.windows(2).map(|pair| 5.0 * (pair[1] - pair[0])).collect();
            let slope = evaluate_by_definition(&steps, t);
            let near = |a: f64, b: f64| (a - b).abs() < 1e-13;
            prop_assert!(near(evaluate(&c, t), truth));
            for [value, derivative] in [evaluate_with_slope(&c, t), value_and_slope_by_differences(&c, t)] {
                prop_assert!(near(value, truth) && near(derivative, slope));
            }
            prop_assert!(near(blossom(&c, [t; 5]), truth));
            let [values, slopes] = bernstein_values_and_slopes::<6>(t);
            let sum = |weights: [f64; 6]| weights.iter().zip(c).map(|(w, c)| w * c).sum::<f64>();
            prop_assert!(near(sum(values), truth) && near(sum(slopes), slope));
            let mut derived = c;
            prop_assert_eq!(differentiate(&mut derived), 5);
            prop_assert_eq!(&derived[..5], &steps[..]);
            let mut raised = [0.0; 9];
            raised[..6].copy_from_slice(&c);
            elevate(&mut raised, 5);
            prop_assert!(near(evaluate_by_definition(&raised, t), truth));
        }

        #[test]
        fn parts_agree_with_the_whole(c in any_coefficients(), t in 0.0..1.0f64, from in 0.0..0.5f64, to in 0.5..1.0f64) {
            let near = |a: f64, b: f64| (a - b).abs() < 1e-13;
            for at in [from, to] {
                let (mut after, mut before) = (c, [0.0; 6]);
                split(&mut after, at, &mut before);
                prop_assert!(near(evaluate_by_definition(&before, t), evaluate_by_definition(&c, at * t)));
                prop_assert!(near(evaluate_by_definition(&after, t), evaluate_by_definition(&c, at + (1.0 - at) * t)));
            }
            let [before, after] = halves(&c);
            prop_assert!(near(evaluate_by_definition(&before, t), evaluate_by_definition(&c, 0.5 * t)));
            prop_assert!(near(evaluate_by_definition(&after, t), evaluate_by_definition(&c, 0.5 + 0.5 * t)));
            let mut part = c;
            restrict(&mut part, [from, to]);
            prop_assert!(near(evaluate_by_definition(&part, t), evaluate_by_definition(&c, from + (to - from) * t)));
            let mut all = c;
            restrict(&mut all, [0.0, 1.0]);
            prop_assert_eq!(all, c);
        }

        /// Compares a net with a curve of curves, and a curve of points with curves of coordinates.
        #[test]
        fn nets_agree_with_polynomials_of_rows(rows in prop::array::uniform4(prop::array::uniform4(-1.0..1.0f64))) {
            let turned = |c: &[[f64; 4]; 4]| -> [[f64; 4]; 4] {
                std::array::from_fn(|a| std::array::from_fn(|b| c[b][a]))
            };
            let points = rows.map(|[x, y, z, _]| DVec3::new(x, y, z));
            let along = |axis: usize| halves(&points.map(|p| p[axis]));
            for (half, of) in halves(&points).iter().enumerate() {
                for (k, p) in of.iter().enumerate() {
                    prop_assert_eq!(p.to_array(), [0, 1, 2].map(|axis| along(axis)[half][k]));
                }
            }
            for b in 0..4 {
                prop_assert_eq!(evaluate(&rows, 0.3)[b], evaluate(&turned(&rows)[b], 0.3));
            }
        }
    }
}

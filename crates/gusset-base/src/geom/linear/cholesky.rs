//! Small symmetric positive definite systems, by Cholesky's method.

use glam::DVec3;

/// Solves the equations of a matrix, given by its lower triangle, in place. The triangle becomes
/// its factor and the right sides become the solution. O(n^3) for n equations, at most `N`.
///
/// A pivot that rounding makes smaller counts as the smallest positive number, so the caller must
/// validate the result.
pub fn solve<const N: usize>(lower: &mut [[f64; N]; N], right: &mut [DVec3]) {
    for i in 0..right.len() {
        for j in 0..=i {
            let known: f64 = (0..j).map(|k| lower[i][k] * lower[j][k]).sum();
            let rest = lower[i][j] - known;
            lower[i][j] = if i == j { rest.max(f64::MIN_POSITIVE).sqrt() } else { rest / lower[j][j] };
        }
        let (before, rest) = right.split_at_mut(i);
        before.iter().zip(&lower[i]).for_each(|(&x, factor)| rest[0] -= x * factor);
        rest[0] /= lower[i][i];
    }
    for i in (0..right.len()).rev() {
        let (before, after) = right.split_at_mut(i + 1);
        after.iter().zip(&lower[i + 1..]).for_each(|(&x, row)| before[i] -= x * row[i]);
        before[i] /= lower[i][i];
    }
}

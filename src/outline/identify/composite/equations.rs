//! The linear equations of composite curves: control points for given parameters and joint
//! parameters.
//!
//! Section i is (J_(i-1), B_i, J_i) with the joints J_i = (1 - beta_i) B_i + beta_i B_(i+1) on the
//! control polygon, and passes its point at t_i:
//!
//! (1 - t)^2 J_(i-1) + 2 t (1 - t) B_i + t^2 J_i = P_i,
//!
//! a tridiagonal system for the B_i. With beta = 1/2 its rows are dominant by 2 t (1 - t) at least,
//! so it has one solution for any points at all, in any dimension, and the norm of its inverse is
//! at most 1 / min 2 t (1 - t): 3.6 for parameters between 1/6 and 5/6. O(n).

use crate::geom::linear::tridiagonal;
use crate::outline::identify::solution::Solution;
use crate::outline::identify::subcurve::Subcurve;

/// Solves for the control points. False if the equations are singular, which takes joint parameters
/// other than 1/2.
pub(super) fn solve(sub: &Subcurve<'_>, solution: &mut Solution) -> bool {
    let Solution { t, beta, controls, upper, across, .. } = solution;
    let n = sub.len();
    let (t, controls) = (&t[..n], &mut controls[..n]);
    let known = |i: usize| sub.points[i];
    if sub.closed {
        return if beta.is_empty() {
            tridiagonal::solve_cyclic(controls, upper, across, |i, _| row(t[i], 0.5, 0.5), known)
        } else {
            tridiagonal::solve_cyclic(controls, upper, across, |i, before| row(t[i], beta[before], beta[i]), known)
        };
    }
    let last = n - 1;
    let [start, end] = sub.end_controls();
    controls[0] = start.unwrap_or(sub.points[0]);
    controls[last] = end.unwrap_or(sub.points[last]);
    let joint_parameter = |i: usize| Solution::joint_parameter(sub, beta, i);
    tridiagonal::solve(controls, upper, |i| row(t[i], joint_parameter(i - 1), joint_parameter(i)), known)
}

/// The coefficients of B_(i-1), B_i and B_(i+1) in row i, between the joints with the parameters
/// `before` and `after`.
#[inline]
pub(super) fn row(t: f64, before: f64, after: f64) -> [f64; 3] {
    let s = 1.0 - t;
    let (first, last) = (s * s, t * t);
    [first * (1.0 - before), 2.0 * t * s + first * before + last * (1.0 - after), last * after]
}

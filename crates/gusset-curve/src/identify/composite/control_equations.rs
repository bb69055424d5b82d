//! The linear equations of composite curves: control points for given parameters and joint
//! parameters.
//!
//! Section i is (J_(i-1), B_i, J_i) with the joints J_i = (1 - beta_i) B_i + beta_i B_(i+1) on the
//! control polygon. It passes its point at t_i:
//!
//! (1 - t)^2 J_(i-1) + 2 t (1 - t) B_i + t^2 J_i = P_i.
//!
//! This is a tridiagonal system for the B_i. With beta = 1/2 its rows are dominant by at least 2 t
//! (1 - t), so it has exactly one solution for any points in any dimension. The norm of its inverse
//! is at most 1 / min 2 t (1 - t), which is 3.6 for parameters between 1/6 and 5/6. O(n).
//!
//! A section may be a cubic in the same triangle, with the legs of the quadratic as tangents:
//!
//! J_(i-1), J_(i-1) + lambda (B_i - J_(i-1)), J_i + mu (B_i - J_i), J_i.
//!
//! With lambda = mu = 2/3 it is the quadratic. Its point at t has different weights of the three
//! corners, see [`cubic_section_weights`]; everything else stays.

use crate::identify::composite_solution::CompositeSolution;
use crate::identify::subcurve::Subcurve;
use gusset_base::geom::linear::tridiagonal;

/// Solves for the control points. Returns false if the equations are singular, which can happen
/// only with joint parameters other than 1/2.
pub(super) fn solve_control_points(sub: &Subcurve<'_>, solution: &mut CompositeSolution) -> bool {
    let CompositeSolution {
        point_parameters: t,
        betas: beta,
        handles,
        controls,
        elimination_factors: upper,
        last_unknown_factors: across,
        ..
    } = solution;
    let n = sub.len();
    let (t, controls) = (&t[..n], &mut controls[..n]);
    let known = |i: usize| sub.points[i];
    let cubic = |i: usize, before: f64, after: f64| {
        coefficients_from_weights(cubic_section_weights(t[i], handles[i]), before, after)
    };
    if sub.closed {
        return if !handles.is_empty() {
            tridiagonal::solve_cyclic(controls, upper, across, |i, before| cubic(i, beta[before], beta[i]), known)
        } else if beta.is_empty() {
            tridiagonal::solve_cyclic(controls, upper, across, |i, _| control_point_coefficients(t[i], 0.5, 0.5), known)
        } else {
            tridiagonal::solve_cyclic(
                controls,
                upper,
                across,
                |i, before| control_point_coefficients(t[i], beta[before], beta[i]),
                known,
            )
        };
    }
    let last = n - 1;
    let [start, end] = sub.end_controls();
    controls[0] = start.unwrap_or(sub.points[0]);
    controls[last] = end.unwrap_or(sub.points[last]);
    let joint_parameter = |i: usize| CompositeSolution::joint_parameter(sub, beta, i);
    if !handles.is_empty() {
        return tridiagonal::solve(controls, upper, |i| cubic(i, joint_parameter(i - 1), joint_parameter(i)), known);
    }
    tridiagonal::solve(
        controls,
        upper,
        |i| control_point_coefficients(t[i], joint_parameter(i - 1), joint_parameter(i)),
        known,
    )
}

/// Returns the coefficients of B_(i-1), B_i and B_(i+1) in row i, between the joints with the
/// parameters `before` and `after`.
#[inline]
pub(super) fn control_point_coefficients(t: f64, before: f64, after: f64) -> [f64; 3] {
    let s = 1.0 - t;
    coefficients_from_weights([s * s, 2.0 * t * s, t * t], before, after)
}

/// Returns the coefficients of [`control_point_coefficients`], given the weights of the section's
/// corners in its point.
#[inline]
pub(super) fn coefficients_from_weights([first, middle, last]: [f64; 3], before: f64, after: f64) -> [f64; 3] {
    [first * (1.0 - before), middle + first * before + last * (1.0 - after), last * after]
}

/// Returns the weights of J_(i-1), B_i and J_i in the point at `t` of a cubic section with the
/// handles lambda and mu.
#[inline]
pub(super) fn cubic_section_weights(t: f64, [lambda, mu]: [f64; 2]) -> [f64; 3] {
    let s = 1.0 - t;
    let (first, last) = (3.0 * s * s * t, 3.0 * s * t * t);
    [s * s * s + first * (1.0 - lambda), first * lambda + last * mu, t * t * t + last * (1.0 - mu)]
}

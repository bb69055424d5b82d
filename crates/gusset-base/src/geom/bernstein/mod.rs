//! Polynomials in Bernstein form over 0 <= t <= 1: f(t) = sum over i of C(n, i) t^i (1 - t)^(n - i)
//! c_i.
//!
//! Coefficients are numbers, points, or rows of either. The net of a tensor patch is a polynomial
//! in u whose coefficients are rows, so one scheme serves both parameters. Most functions use de
//! Casteljau's scheme. Its columns are convex combinations of neighbours and therefore stable
//! (Farouki and Rajan 1987). It costs O(n^2).
//!
//! - `casteljau`: evaluation, subdivision, degree elevation, derivatives, blossoms and basis
//!   functions;
//! - `polynomial`: evaluation in O(n), binomial coefficients, products and integrals of scalar
//!   polynomials;
//! - `roots`: real roots by Descartes' rule.

mod casteljau;
mod polynomial;
mod roots;

pub use casteljau::{
    bernstein_values, bernstein_values_and_slopes, blossom, differentiate, elevate, evaluate, evaluate_with_slope,
    halve, halves, reduce_by_casteljau, restrict, split, value_and_slope_by_differences,
};
pub use polynomial::{
    MAX_COEFFICIENTS, MAX_DEGREE, add_product, binomial_row, integral, integral_of_product, value_and_slope,
};
pub use roots::{Roots, bracketed_root, roots, sign_changes, visit_by_bisection};

//! Systems of linear equations.
//!
//! - [`banded`]: symmetric positive definite systems with entries near the diagonal, in linear
//!   time.
//! - [`cholesky`]: small symmetric positive definite systems.
//! - [`dense`]: small square systems, by elimination with row exchanges.
//! - [`eigen`](mod@eigen): eigenvalues and eigenvectors of small symmetric matrices.
//! - [`tridiagonal`]: open and cyclic systems with dominant rows, in linear time.

pub mod banded;
pub mod cholesky;
pub mod dense;
pub mod eigen;
pub mod tridiagonal;

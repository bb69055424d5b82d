//! Systems of linear equations.
//!
//! * [`banded`]: symmetric ones whose entries are near the diagonal, in linear time.
//! * [`cholesky`]: small symmetric ones that are positive definite.
//! * [`dense`]: small square systems, by elimination with row exchanges.
//! * [`eigen`](mod@eigen): eigenvalues and eigenvectors of small symmetric matrices.
//! * [`tridiagonal`]: open and cyclic ones with dominant rows, in linear time.

pub mod banded;
pub mod cholesky;
pub mod dense;
pub mod eigen;
pub mod tridiagonal;

//! Systems of linear equations.
//!
//! * [`dense`]: small square systems, by elimination with row exchanges.
//! * [`tridiagonal`]: open and cyclic ones with dominant rows, in linear time.

pub(crate) mod dense;
pub(crate) mod tridiagonal;

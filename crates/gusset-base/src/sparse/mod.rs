//! Sparse symmetric systems of linear equations.
//!
//! The factor L D L^T is computed by a multifrontal method (see `factor`), in an order of the
//! unknowns found by nested dissection (see `order`).
//!
//! | file | content |
//! |---|---|
//! | `symmetric` | a sparse symmetric matrix |
//! | `order` | an order of the unknowns that keeps the factor sparse |
//! | `tree` | the elimination tree, and the number of entries in each column of the factor |
//! | `supernodes` | columns of the factor that are computed together |
//! | `front` | elimination in a dense matrix |
//! | `factor` | the factor |
//! | `solve` | solutions by the factor |

mod factor;
#[cfg(test)]
mod factor_tests;
mod front;
mod order;
mod solve;
mod supernodes;
mod symmetric;
mod tree;

pub use order::{Coupling, dissect};
pub use symmetric::Symmetric;

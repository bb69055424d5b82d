//! Sparse symmetric systems of linear equations.
//!
//! The factor L D L^T is computed by a multifrontal method (see `factor`), in an order of the
//! unknowns found by nested dissection (see `elimination_order`).
//!
//! | file | content |
//! |---|---|
//! | `symmetric` | a sparse symmetric matrix |
//! | `elimination_order` | an order of the unknowns that keeps the factor sparse |
//! | `elimination_tree` | the elimination tree, and the number of entries in each column of the factor |
//! | `supernodes` | columns of the factor that are computed together |
//! | `frontal_matrix` | elimination in a dense matrix |
//! | `factor` | the factor |
//! | `solve_factored` | solutions by the factor |

mod elimination_order;
mod elimination_tree;
mod factor;
#[cfg(test)]
mod factor_tests;
mod frontal_matrix;
mod solve_factored;
mod supernodes;
mod symmetric;

pub use elimination_order::{UnknownCouplings, order_by_nested_dissection};
pub use symmetric::SparseSymmetric;

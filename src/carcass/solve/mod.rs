//! Equations over patches, in Bernstein form: what cannot be missed.

mod field;
mod roots;

pub(crate) use field::Field;
pub(crate) use roots::{Roots, roots};

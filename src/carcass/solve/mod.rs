//! Equations over patches, in Bernstein form: what cannot be missed.

mod field;
mod roots;

pub(crate) use field::{Field, polynomial};
pub(crate) use roots::{Roots, roots};

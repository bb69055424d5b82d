//! Equations over patches, in Bernstein form: what cannot be missed.

mod curve;
mod field;
mod roots;
mod spots;

pub(crate) use curve::{Crossings, Room, crossings, halved};
pub(crate) use field::Field;
pub(crate) use roots::{Roots, roots, simple_roots};
pub(crate) use spots::Spot;

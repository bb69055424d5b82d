//! Equations over patches, in Bernstein form: what cannot be missed.

mod curve;
mod field;
mod roots;
mod spots;

pub(crate) use curve::{Crossing, Crossings, Room, crossings};
pub(crate) use field::Field;
pub(crate) use roots::{Roots, roots};
pub(crate) use spots::{Open, Spot, add_spots};

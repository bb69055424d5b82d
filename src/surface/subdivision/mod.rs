//! Equations over patches, in Bernstein form: what cannot be missed.

mod curve;
mod field;
mod roots;
mod spots;

pub(crate) use curve::{Crossings, CurveWorkspace, crossings, halved};
pub(crate) use field::{Field, polynomial};
#[allow(unused_imports, reason = "not every set of searches needs it")]
pub(crate) use roots::roots;
pub(crate) use roots::{Roots, simple_roots};
pub(crate) use spots::Spot;

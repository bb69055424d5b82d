//! Nets of other sizes: resampling, levels of detail, decimation.
//!
//! For nets that are glued along whole sides (see [`Sides`](super::topology::Sides)). Invariant:
//! the result has the same sides, and glued nodes have equal bits. Splines after Catmull and Rom,
//! "A class of local interpolating splines", 1974. O(nodes).

mod decimate;
mod interpolate;
mod whole_sides;

pub use decimate::{Decimated, decimate};
pub use interpolate::{Interpolation, pyramid, resample};

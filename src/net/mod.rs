//! Nets: tetragonal regular networks (TRN).
//!
//! The model is Deryagin's: H x W nodes in three coordinate matrices, joined to cells by their indices alone, and closed to
//! surfaces of any kind by a characteristic matrix that says which links are contracted to a point.
//!
//! * [`Shape`]: size and numbering. [`Planes`], [`Coordinates`]: the matrices. [`Net`]: all together.
//! * [`topology`]: what is glued to what, the classes of glued nodes, the 18 local gluings.
//! * [`Bridge`]: what lies between nets that were joined.
//! * [`stream`]: nets as bytes.

mod bridge;
mod model;
mod planes;
mod real;
mod shape;
pub mod stream;
pub mod topology;

pub use bridge::{Bridge, BridgeKind, BridgeMode, BridgeProperties, Direction};
pub(crate) use model::each;
pub use model::{Coordinates, Net};
pub use planes::Planes;
pub use real::Real;
pub use shape::{MAX_NODES, Shape};
pub use topology::{Classes, Matrix, Seam, Sides, Topology};

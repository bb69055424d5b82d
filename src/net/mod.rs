//! Nets: tetragonal regular networks (TRN).
//!
//! The model is Deryagin's: H x W nodes in three coordinate matrices, joined to cells by their indices alone, and closed to
//! surfaces of any kind by a characteristic matrix that says which links are contracted to a point.
//!
//! * [`Shape`]: size and numbering. [`Planes`], [`Coordinates`]: the matrices. [`Net`]: all together.
//! * [`topology`]: what is glued to what, the classes of glued nodes, the 18 local gluings.
//! * [`complex`]: what surface that makes. [`Net::validate`]: whether glued nodes lie together. [`derive()`]: what lies together.
//! * [`closure`]: boxes, and surfaces with a side turned round. [`primitive`]: whole nets of standard shapes.
//! * [`Bridge`]: what lies between nets that were joined.
//! * Parts, flips, quarter turns, reformatting: methods of [`Net`]. [`concatenate`], [`Net::split`]: joining, taking apart.
//! * [`stream`]: nets as bytes.

pub mod analyse;
mod arrange;
mod bridge;
pub mod closure;
mod coincide;
pub mod complex;
pub mod convert;
mod derive;
pub mod field;
mod fold;
mod hidden;
mod join;
pub mod measure;
mod model;
pub mod normals;
mod pieces;
mod planes;
pub mod primitive;
mod real;
mod reformat;
pub mod resample;
pub mod scene;
mod separate;
mod shape;
pub mod stream;
pub mod topology;
pub mod transform;
mod validate;

pub use bridge::{Bridge, BridgeKind, BridgeMode, BridgeProperties, Direction};
pub use derive::derive;
pub use join::{JoinOptions, concatenate, concatenate_all};
pub(crate) use model::each;
pub use model::{Coordinates, Net};
pub use planes::Planes;
pub use real::Real;
pub use reformat::Replication;
pub use shape::{MAX_NODES, Shape};
pub use topology::{Classes, Matrix, Seam, Sides, Topology};
pub use validate::{Finding, FindingKind};

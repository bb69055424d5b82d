//! Nets: tetragonal regular networks (TRN).
//!
//! The model is A. A. Deryagin's ("Modelling of 3D objects and scenes by tetragonal regular
//! networks"): H x W nodes in three coordinate matrices, joined to cells by their indices alone,
//! and closed to surfaces of any kind by a characteristic matrix of contracted links.
//! `docs/errata.md` lists where the paper is corrected.
//!
//! * [`Shape`]: size and numbering. [`Planes`], [`Coordinates`]: the matrices. [`Net`]: all
//!   together.
//! * [`topology`]: the gluing, the classes of glued nodes, the 18 local gluings.
//! * [`complex`]: the surface that the gluing makes. [`Net::validate`]: whether glued nodes
//!   coincide.
//!   [`detect_gluing()`]: the gluing that coordinates imply.
//! * [`closure`]: boxes, and surfaces with a reversed side. [`primitive`]: nets of standard shapes.
//! * [`concatenate`], [`Net::split`]: joining and splitting, with a [`Bridge`] between.
//! * Parts, flips, quarter turns, reformatting: methods of [`Net`].
//! * [`field`], [`transform`]: deformations. [`analyse`]: their effect. [`normals`], [`measure`]:
//!   normals, areas, volumes. [`planarise()`]: plane cells. [`settle()`]: bridges under forces.
//!   [`morph()`]: nets between two.
//! * [`resample`]: other sizes. [`scene`]: nets in groups. [`convert`]: meshes and height fields.
//!   [`stream`]: nets as bytes.

pub mod analyse;
mod arrange;
mod bridge;
mod chunks;
pub mod closure;
mod coincidence;
pub mod complex;
pub mod convert;
mod detect_gluing;
mod direction;
pub mod field;
mod fold;
mod hidden_cells;
mod join;
pub mod measure;
mod model;
mod morph;
pub mod normals;
pub mod planarise;
mod planes;
pub mod primitive;
mod real;
mod reformat;
pub mod resample;
pub mod scene;
mod separate;
pub mod settle;
mod shape;
pub mod stream;
pub mod topology;
pub mod transform;
mod validate;

pub use bridge::{Bridge, BridgeKind, BridgeMode, BridgeProperties};
pub use detect_gluing::detect_gluing;
pub use direction::Direction;
pub use join::{JoinOptions, concatenate, concatenate_all};
pub use model::{Coordinates, Net};
pub use morph::{MorphPath, morph};
pub use planarise::planarise;
pub use planes::Planes;
pub use real::Real;
pub use reformat::Replication;
pub use settle::settle;
pub use shape::{MAX_NODES, Shape};
pub use topology::{Classes, Matrix, Seam, Sides, Topology};
pub use validate::{Finding, FindingKind};

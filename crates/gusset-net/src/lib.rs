//! Nets: regular grids of quads whose sides may be glued, called tetragonal regular networks.
//!
//! The crate follows A. A. Deryagin, *Modelling of 3D objects and scenes by tetragonal regular
//! networks*. A net has H x W nodes in three coordinate matrices. Indices alone say which nodes are
//! neighbours. A characteristic matrix of contracted links closes the grid to surfaces of any kind.
//! The errata of the paper are in `docs/errata.md`.
//!
//! | subject | where |
//! |---|---|
//! | size, numbering, coordinates, the net itself | [`Shape`], [`XyzMatrices`], [`Coordinates`], [`Net`] |
//! | gluing, classes of glued nodes, the 18 local gluings | [`topology`] |
//! | the surface after gluing | [`complex`] |
//! | whether glued nodes coincide; the gluing that coordinates imply | [`Net::validate`]; [`detect_gluing()`] |
//! | gluing in one step; changed copies | [`glue`]; [`CopyOptions`] |
//! | boxes, surfaces with a reversed side; standard shapes | [`closure`]; [`primitive`] |
//! | parts, flips, quarter turns, other row lengths | methods of [`Net`] |
//! | joining and splitting, with bridges between | [`concatenate`], [`Net::split`], [`Bridge`] |
//! | affine maps, deformations, the folds that they cause | [`transform`], [`field`], [`analyse`] |
//! | normals, areas, volumes | [`normals`], [`measure`] |
//! | plane cells; bridges under forces; nets between two | [`planarise()`]; [`settle()`]; [`morph()`] |
//! | other sizes, levels of detail | [`resample`] |
//! | groups of nets | [`scene`] |
//! | meshes and height fields; bytes | [`convert`]; [`stream`] |
//!
//! Coordinates are in single or double precision, in memory of the caller or of the net. Operations
//! are loops over rows. Glued nodes that have equal bits keep equal bits.

pub mod analyse;
mod arrange;
mod bridge;
mod chunks;
pub mod closure;
mod coincidence;
pub mod complex;
pub mod convert;
mod copy;
mod detect_gluing;
mod direction;
pub mod field;
mod fold;
pub mod glue;
mod hidden_cells;
mod join;
pub mod measure;
mod model;
mod morph;
pub mod normals;
pub mod planarise;
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
mod xyz_matrices;

pub use arrange::GridSymmetry;
pub use bridge::{Bridge, BridgeKind, BridgeMode, BridgeProperties};
pub use copy::CopyOptions;
pub use detect_gluing::detect_gluing;
pub use direction::Direction;
pub use join::{JoinOptions, concatenate, concatenate_all};
pub use model::{Coordinates, Net};
pub use morph::{MorphPath, morph};
pub use planarise::planarise;
pub use real::Real;
pub use reformat::Replication;
pub use settle::settle;
pub use shape::{MAX_NODES, Shape};
pub use topology::{LinkMatrix, NodeClasses, Seam, Sides, Topology};
pub use validate::{FindingKind, ValidationFinding};
pub use xyz_matrices::XyzMatrices;

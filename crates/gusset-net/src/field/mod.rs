//! Deformation fields (Deryagin, "Spatial operations"): one description of shaping, animation and
//! projection.
//!
//! * [`Field`]: a map of space that can be applied in part. [`deform`]: chains of fields in one
//!   pass.
//! * [`twist`], [`taper`], [`bend`], [`shear`]: shaping. [`spherify`]: projection onto a sphere.
//!   [`cylinder_wrap`], [`cone_wrap`], [`torus_wrap`], [`sphere_wrap`]: sheets that roll up.
//! * [`Lattice`]: free-form. [`projection()`]: any 4 x 4 matrix, parallel, perspective.
//!   [`displace_along_normals`]: along the normals.
//! * [`TimedStrength`]: the strength of a field as a function of time.
//!
//! Invariant: a field maps each point independently, so that nodes of equal bits, such as glued
//! ones, keep equal bits. O(nodes x fields).

mod deform;
mod lattice;
mod space_map;
mod projection;
mod shaping;
mod surface_fields;
mod timed;
mod wrap;

pub use deform::{DeformationStep, deform};
pub use lattice::Lattice;
pub use projection::{parallel_projection, perspective_projection, projection};
pub use shaping::{bend, shear, taper, twist};
pub use space_map::{Field, PointsMut};
pub(crate) use surface_fields::snap_groups;
pub use surface_fields::{RowsMut, deform_by_callback, displace_along_normals, snap_glued_nodes};
pub use timed::{Easing, TimedStrength};
pub use wrap::{cone_wrap, cylinder_wrap, sphere_wrap, spherify, torus_wrap};

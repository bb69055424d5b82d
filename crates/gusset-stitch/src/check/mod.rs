//! The check of a mesh: counts, topological invariants and lists of defects.
//!
//! * [`report`](self): result and entry point.
//! * [`bow_ties`](self): bow-tie vertices.
//! * [`duplicate_faces`](self): duplicate faces.
//! * [`intersecting_faces`](self): faces that intersect each other.

mod bow_ties;
mod report;
mod duplicate_faces;
mod intersecting_faces;

pub use intersecting_faces::find_intersecting_faces;
pub use report::{Check, check};

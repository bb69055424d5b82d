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

pub(crate) use bow_ties::join_corners_at_edge;
pub(crate) use duplicate_faces::duplicate_face_groups;
pub use intersecting_faces::find_intersecting_faces;
pub(crate) use report::find_zero_area_faces;
pub use report::{Check, check};

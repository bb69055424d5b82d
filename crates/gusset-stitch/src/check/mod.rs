//! The check of a mesh: counts, topological invariants and lists of defects.
//!
//! * [`report`](self): result and entry point.
//! * [`bow_ties`](self): bow-tie vertices.
//! * [`duplicate_faces`](self): duplicate faces.

mod bow_ties;
mod report;
mod duplicate_faces;

pub use report::{Check, check};

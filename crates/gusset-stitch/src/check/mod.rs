//! The check of a mesh: counts, topological invariants and lists of defects.
//!
//! * [`report`](self): result and entry point.
//! * [`bow_ties`](self): bow-tie vertices.
//! * [`twins`](self): duplicate faces.

mod bow_ties;
mod report;
mod twins;

pub use report::{Check, check};

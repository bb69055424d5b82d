//! The check of a mesh: counts, topological invariants and lists of defects.
//!
//! * [`report`](self): result and entry point.
//! * [`fans`](self): bow-tie vertices.
//! * [`twins`](self): duplicate faces.

mod fans;
mod report;
mod twins;

pub use report::{Check, check};

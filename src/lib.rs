//! Joins surfaces that come in pieces.
mod alloc;
pub mod boundary;
pub mod error;
pub mod ffi;
mod geom;
pub mod job;
pub mod mesh;
mod par;
pub mod stitch;
pub use error::{Error, Result, Side};
pub use job::{Job, Progress};

//! The check: counts, lists and properties of everything wrong or unusual in a mesh.
//!
//! * [`report`](self): the types and the entry point. [`fans`](self): vertices where the surface touches itself.
//!   [`twins`](self): faces that occur twice.

mod fans;
mod report;
mod twins;

pub use report::{Check, check};

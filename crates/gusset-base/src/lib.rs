//! What the crates of `gusset` share.
//!
//! [`Error`] and [`Job`] are part of the public interface of every crate. All other modules serve
//! the crates of the workspace alone and may change at any time.
//!
//! | module | what it holds |
//! |---|---|
//! | [`error`] | causes of failure, each with the element at fault |
//! | [`job`] | progress, cancellation and threads of one computation |
//! | `alloc`, `reserve` | fallible allocation, and the memory behind it in the libraries for C |
//! | `choice` | options with a stable order and a text for each value |
//! | `par`, `threads` | loops shared by threads that end with the call |
//! | `simd` | kernels compiled for wider vectors |
//! | `sort` | sorting and selection that report progress |
//! | `geom` | vectors, boxes, spatial indices, polynomials, linear systems |
//! | `sparse` | factorisation of sparse symmetric matrices |

#[doc(hidden)]
pub mod alloc;
#[doc(hidden)]
pub mod choice;
pub mod error;
#[doc(hidden)]
pub mod geom;
pub mod job;
#[doc(hidden)]
pub mod par;
#[doc(hidden)]
pub mod reserve;
#[doc(hidden)]
pub mod simd;
#[doc(hidden)]
pub mod sort;
#[doc(hidden)]
pub mod sparse;
#[doc(hidden)]
pub mod testing;
#[doc(hidden)]
pub mod threads;

pub use error::{Element, Error, PairFault, Result, Side};
pub use job::{Job, Progress};

/// The index that means "none".
pub const NONE: u32 = u32::MAX;

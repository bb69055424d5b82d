//! The ground floor of `gusset`: errors, memory, jobs, threads, and the geometry that all crates
//! share.
//!
//! [`Error`] and [`Job`] are part of the public interface of every crate. All other modules serve
//! the crates of the workspace alone and may change at any time.
//!
//! | module | content |
//! |---|---|
//! | [`error`] | causes of failure, each with the element at fault |
//! | [`job`] | progress, cancellation and threads of one computation |
//! | `alloc`, `reserve` | fallible allocation, and the memory behind it in the libraries for C |
//! | `choice` | options with a stable order and a text for each value |
//! | `par`, `threads` | loops shared by threads that end with the call |
//! | `simd` | kernels compiled for wider vectors |
//! | `sort` | sorting and selection that report progress |
//! | `geom` | vectors, boxes, spatial indices, Bernstein polynomials, small linear systems |
//! | `sparse` | factorisation of sparse symmetric matrices |
//!
//! The polynomials follow Farouki and Rajan (1987), the sparse solver Duff and Reid (1983) and
//! George (1973).
//!
//! Three rules hold here and above. Memory that grows with the input is requested by `alloc`, which
//! returns an error. Long loops report to the job, so that the host can cancel. Results have the
//! same bits for any number of threads and on any machine.

#[doc(hidden)]
pub mod alloc;
#[doc(hidden)]
pub mod choice;
pub mod error;
mod error_subject;
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

pub use error::{Allowed, Component, Element, Error, LoopPairFault, Result, Side};
pub use job::{Job, Progress};

/// The index that means "none".
pub const NONE: u32 = u32::MAX;

//! The C interface: checks pointers, turns panics into status codes, computes nothing.
//!
//! | file | what it owns |
//! |---|---|
//! | [`status`] | the status codes, and which one each error of the core becomes |
//! | `glue` | macros that write impls for structs and enums |
//! | `guard` | panics made failures |
//! | `input` | raw pointers to slices, buffers, flags and structs |
//! | `handle` | objects behind opaque pointers, with their kinds |
//! | `host` | callbacks, as the core calls them |
//! | [`context`] | threads, progress, cancel, log, message, report; how calls begin and end |
//! | [`transform`] | affine maps |
//! | [`version`] | versions of the library and of its binary interface |
//!
//! | folder | what it owns |
//! |---|---|
//! | [`mesh`] | the mesh view; boundaries, checks, repairs; stitching, holes, joining |
//! | [`curve`] | the handle of a curve, places on it; outlines, frames of a body |
//! | [`net`] | the handle of a net; gluing, motion, measures |
//! | [`scene`], [`stream`] | nets in groups; nets as bytes |
//! | [`surface`] | sheets, the handle of a surface, its queries |
//! | [`papers`] | winged-edge tables, the search by the logical scale |
//! | [`plugin`] | the other interface: one symbol and tables of filters, with a header of its own |
//!
//! Unsafe code is here, in the kernels of `simd`, in `threads` and in `reserve`, nowhere else.

#![allow(unsafe_code, reason = "the border to C")]
#![allow(non_camel_case_types, reason = "these are the names that C sees")]
#![allow(rustdoc::broken_intra_doc_links, reason = "the comments are written for C, where brackets index arrays")]
#![allow(clippy::missing_safety_doc, reason = "each C function documents its pointers in C's terms")]

mod choice_text;
pub mod context;
pub mod curve;
mod glue;
#[doc(hidden)]
pub mod guard;
pub(crate) mod handle;
mod host;
#[doc(hidden)]
pub mod input;
pub mod mesh;
pub mod net;
pub mod papers;
/// cbindgen:ignore
pub mod plugin;
pub mod scene;
pub mod status;
mod status_text;
pub mod stream;
pub mod surface;
pub mod transform;
pub mod version;

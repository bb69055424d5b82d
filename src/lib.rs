//! Joins surfaces that come in pieces.
//!
//! `gusset` finds the free boundary loops of open polygon meshes and stitches them together: two
//! open pieces become one closed, valid mesh. It is a Rust library with a C interface
//! (`include/gusset.h`) and a C++ one (`include/gusset.hpp`).
//!
//! ```
//! use gusset::mesh::{Faces, MeshView, Positions};
//! use gusset::stitch::{Options, Request, stitch};
//! use gusset::Job;
//!
//! // Two open pyramids, point up and point down, with a gap between their square rims.
//! let up = [[0.0, 0.0, 2.0], [1.0, 0.0, 1.0], [0.0, 1.0, 1.0], [-1.0, 0.0, 1.0], [0.0, -1.0, 1.0]];
//! let down = up.map(|[x, y, z]| [x, -y, -z]);
//! let faces = [[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 1]];
//!
//! let job = Job::default();
//! let a = MeshView::new(Positions::from(&up[..]), Faces::triangles(&faces)?, &job)?;
//! let b = MeshView::new(Positions::from(&down[..]), Faces::triangles(&faces)?, &job)?;
//! let request = Request { a: &a, loop_a: None, b: Some(&b), loop_b: None };
//! let joined = stitch(&request, &Options::default(), &job)?;
//! assert_eq!(joined.mesh.face_count(), 4 + 4 + 8);
//! assert_eq!(joined.quality.loops_left, 0);
//! # Ok::<(), gusset::Error>(())
//! ```
//!
//! | module | what it does |
//! |---|---|
//! | [`mesh`] | the view of the host's arrays, the mesh that results come in, half-edges |
//! | [`boundary`] | free boundary loops |
//! | [`winged`] | winged-edge tables, and loops on them |
//! | [`check`] | everything wrong or unusual in a mesh |
//! | [`repair`] | vertices that lie together made one, orientation made consistent |
//! | [`stitch`] | a strip of new faces between two loops, and many pieces in one mesh |
//! | [`fill`] | holes closed by new faces |
//! | [`develop`] | surfaces laid out in the plane |
//! | [`outline`] | Bézier curves through given points |
//! | [`net`] | regular networks of quads, closed to surfaces by gluing; scenes of them |
//! | [`surface`] | surfaces through nets of curves, and what can be asked of them |
//! | [`filters`] | the table of named filters with typed parameters, for hosts |
//! | [`job`] | progress, cancel and threads of a computation |
//! | [`error`] | causes of failure, each with the element it is about |
//! | [`ffi`] | the C interface |
//!
//! Data flows one way: host arrays, view, core, result. The core has no global state (but with the
//! feature `reserve`, the libraries for C), nothing is
//! printed, no file is touched, and the same input gives the same bytes for any number of threads.

pub mod align;
mod alloc;
pub mod attributes;
mod blend;
pub mod boundary;
pub mod check;
mod choice;
pub mod develop;
pub mod error;
mod fair;
pub mod ffi;
pub mod fill;
pub mod filters;
mod geom;
mod intersect;
pub mod job;
pub mod mesh;
pub mod net;
pub mod outline;
mod par;
mod remesh;
pub mod repair;
mod reserve;
mod simd;
mod sort;
pub mod stitch;
pub mod surface;
#[cfg(test)]
mod testing;
mod threads;
pub mod trim;
pub mod winged;

pub use error::{Element, Error, PairFault, Result, Side};
pub use job::{Job, Progress};

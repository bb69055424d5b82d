//! Joins surfaces that come in pieces.
//!
//! `gusset` finds the free boundary loops of open polygon meshes and stitches them together: two
//! open pieces become one closed, valid mesh. It also builds regular networks of quads, answers
//! queries about smooth surfaces, and fits Bézier curves through given points.
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
//! This crate collects the crates of the workspace. It adds the interfaces for other languages.
//!
//! | module | what it does |
//! |---|---|
//! | [`mesh`] | views the host's arrays, owns the meshes of results, pairs half-edges |
//! | [`boundary`] | finds free boundary loops |
//! | [`winged`] | builds winged-edge tables, and finds loops on them |
//! | [`certify`] | states facts about a result that others can check |
//! | [`check`] | reports everything wrong or unusual in a mesh |
//! | [`repair`] | merges coincident vertices, sews borders, makes orientation consistent |
//! | [`align`] | finds the poses of overlapping pieces |
//! | [`arrange`] | unites solids that overlap |
//! | [`trim`] | removes what overlapping pieces cover twice |
//! | [`stitch`] | joins two loops by a strip of new faces |
//! | [`fill`] | closes holes by new faces |
//! | [`assemble`] | joins many pieces into one mesh |
//! | [`develop`] | lays surfaces out in the plane |
//! | [`curve`] | passes Bézier curves through given points |
//! | [`net`] | builds regular networks of quads, glued to surfaces; scenes of them |
//! | [`surface`] | builds surfaces through nets of curves, and answers queries about them |
//! | [`attributes`] | carries values of vertices, corners and faces to results |
//! | [`filters`] | lists named filters with typed parameters, for hosts |
//! | [`job`] | progress, cancellation and threads of one computation |
//! | [`error`] | causes of failure, each with the element at fault |
//! | [`capi`] | the C interface |
//!
//! Data flows one way: host arrays, view, core, result. The library prints nothing, touches no
//! file, and gives the same bytes for any number of threads. It has no global state, except the
//! memory reserve of the libraries for C (feature `reserve`).

pub mod capi;

// Exports `gusset_files_entry` from the shared library.
#[cfg(feature = "files")]
extern crate gusset_files as _;

pub use glam;
pub use gusset_attributes as attributes;
pub use gusset_base::{Allowed, Component, Element, Error, Job, LoopPairFault, Progress, Result, Side, error, job};
pub use gusset_curve as curve;
pub use gusset_filters as filters;
pub use gusset_mesh as mesh;
pub use gusset_net as net;
pub use gusset_stitch::{
    align, arrange, assemble, boundary, certify, check, develop, fill, repair, solid, stitch, trim, winged,
};
pub use gusset_surface as surface;

/// The allocator of the libraries for C.
#[cfg(feature = "reserve")]
#[global_allocator]
static ALLOCATOR: gusset_base::reserve::ReserveBackedAllocator = gusset_base::reserve::ReserveBackedAllocator;

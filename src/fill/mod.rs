//! Filling holes: new faces that close boundary loops.
//!
//! Sources: G. Barequet, M. Sharir, *Filling gaps in the boundary of a polyhedron* (1995); P.
//! Liepa, *Filling holes in meshes* (2003). The minimum-weight triangulation of its rim closes
//! a hole. On request the triangles are refined to the density of the surrounding mesh, and the
//! new vertices faired so that the patch continues the surface.
//!
//! | file | subject |
//! |---|---|
//! | [`request`](self) | options, results, status of each hole |
//! | [`choose`](self) | selection of the loops to fill |
//! | [`surroundings`](self) | the old faces round a hole |
//! | [`patch`](self) | the patch of one hole |
//! | [`triangulate`](self) | minimum-weight triangulation |
//! | [`clip`](self) | ear clipping of long loops |
//! | [`refine`](self) | new vertices at the density of the rim |
//! | [`holes`](self) | all patches in one mesh |

mod choose;
mod clip;
mod holes;
mod patch;
mod refine;
mod request;
mod surroundings;
mod triangulate;

pub use holes::fill_holes;
pub use request::{Fairing, Filled, Hole, HoleStatus, Limits, Options, Refinement, Weight};

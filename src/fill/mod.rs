//! Filling holes: new faces that close boundary loops.
//!
//! Sources: G. Barequet, M. Sharir, *Filling gaps in the boundary of a polyhedron* (1995); P.
//! Liepa, *Filling holes in meshes* (2003). The minimum-weight triangulation of its rim closes
//! a hole. On request a blend (`crate::blend`) takes its place: triangles as fine as those round
//! the hole, the new vertices faired so that the patch continues the surface.
//!
//! | file | subject |
//! |---|---|
//! | [`request`](self) | options, results, status of each hole |
//! | [`choose`](self) | selection of the loops to fill |
//! | [`near`](self) | the old faces near the holes |
//! | [`surroundings`](self) | the old faces that touch the rims |
//! | [`rim`](self) | one hole in numbers of its own |
//! | [`weigh`](self) | what a triangulation costs |
//! | [`chords`](self) | the chords that it may use |
//! | [`search`](self) | the triangulation of least cost |
//! | [`loops`](self) | several loops, one patch |
//! | [`clip`](self) | ear clipping of long planar loops |
//! | [`patch`](self) | the ways to fill one hole |
//! | [`placed`](self) | patches in the mesh |
//! | [`cuts`](self) | faces that cut each other |
//! | [`holes`](self) | all patches in one mesh |

mod choose;
mod chords;
mod clip;
mod cuts;
mod holes;
#[cfg_attr(not(test), expect(dead_code, reason = "holes do not ask for it yet"))]
mod loops;
mod near;
mod patch;
mod placed;
mod request;
mod rim;
mod search;
mod surroundings;
mod weigh;

pub use holes::fill_holes;
pub use request::{Fairing, Filled, Finish, Hole, HoleStatus, Keep, Limits, Measures, Options, Refinement, Weight};

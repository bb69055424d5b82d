//! Filling of holes: new faces that close boundary loops.
//!
//! Sources: G. Barequet, M. Sharir, *Filling gaps in the boundary of a polyhedron* (1995); P.
//! Liepa, *Filling holes in meshes* (2003). A hole is closed by the minimum-weight triangulation of
//! its rim. On request a blend (`crate::blend`) replaces it: triangles as fine as those around the
//! hole, with new vertices faired so that the patch continues the surface. One patch may close
//! several loops.
//!
//! | file | subject |
//! |---|---|
//! | [`fill_request`](self) | options, results, status of each hole |
//! | [`choose`](self) | selection of the loops to fill |
//! | [`near`](self) | the old faces near the holes |
//! | [`surroundings`](self) | the old faces that touch the rims |
//! | [`patch_rim`](self) | the loops of one patch with their own vertex numbers |
//! | [`weigh`](self) | the cost of a triangulation |
//! | [`chords`](self) | the chords of a triangulation |
//! | [`search`](self) | the triangulation of least cost |
//! | [`loops`](self) | several loops closed by one patch |
//! | [`clip`](self) | ear clipping of long planar loops |
//! | [`creases`](self) | creases continued across a hole |
//! | [`patch`](self) | the attempts to fill one rim |
//! | [`placed`](self) | patches in the mesh |
//! | [`patch_cuts`](self) | intersecting faces |
//! | [`groups`](self) | the loops that share a patch |
//! | [`cheapest`](self) | the loops that cost less together |
//! | [`filling`](self) | all patches |
//! | [`result`](self) | the patches appended to the mesh, reports |
//! | [`holes`](self) | the steps in order |

mod cheapest;
mod choose;
mod chords;
mod clip;
mod creases;
mod fill_request;
mod filling;
mod groups;
mod holes;
mod loops;
mod near;
mod patch;
mod patch_cuts;
mod patch_rim;
mod placed;
mod result;
mod search;
mod surroundings;
mod weigh;

pub(crate) use clip::clip_ears;
pub use fill_request::{
    Continuity, Fairing, Filled, Finish, Hole, HoleStatus, Keep, Limits, Measures, Options, Refinement, Selection,
    Together, Weight,
};
pub use holes::fill_holes;

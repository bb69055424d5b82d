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
//! | [`candidate_loops`](self) | selection of the loops to fill |
//! | [`unsewn_loops`](self) | the loops along borders that coincide |
//! | [`faces_near_boxes`](self) | the old faces near the holes |
//! | [`old_faces_at_rims`](self) | the old faces that touch the rims |
//! | [`patch_rim`](self) | the loops of one patch with their own vertex numbers |
//! | [`triangulation_cost`](self) | the cost of a triangulation |
//! | [`chords`](self) | the chords of a triangulation |
//! | [`triangulation_search`](self) | the triangulation of least cost |
//! | [`loops`](self) | several loops closed by one patch |
//! | [`planar_loops`](self) | ear clipping of long planar loops |
//! | [`creases`](self) | creases continued across a hole |
//! | [`patch`](self) | the attempts to fill one rim |
//! | [`placed_patch`](self) | patches in the mesh |
//! | [`patch_cuts`](self) | intersecting faces |
//! | [`patch_groups`](self) | the loops that share a patch |
//! | [`group_by_cost`](self) | the loops that cost less together |
//! | [`hole_filling`](self) | all patches |
//! | [`fill_result`](self) | the patches appended to the mesh, reports |
//! | [`holes`](self) | the steps in order |

mod group_by_cost;
mod candidate_loops;
mod chords;
mod planar_loops;
mod creases;
mod fill_request;
mod hole_filling;
mod patch_groups;
mod holes;
mod loops;
mod faces_near_boxes;
mod patch;
mod patch_cuts;
mod patch_rim;
mod placed_patch;
mod fill_result;
mod triangulation_search;
mod old_faces_at_rims;
mod triangulation_cost;
mod unsewn_loops;

pub use fill_request::{
    Continuity, Fairing, Filled, Finish, Hole, HoleStatus, Keep, Limits, LoopSelection, Measures, Options, Refinement,
    Together, Weight,
};
pub use holes::{HoleSurvey, fill_holes};

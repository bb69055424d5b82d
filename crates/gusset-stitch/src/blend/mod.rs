//! Blends: fine triangles that replace coarse ones between fixed rims, on a surface that continues
//! the old one. Strips and triangulations of holes become blends.
//!
//! The coarse triangles guide the surface. Their sides are halved to
//! [`NEW_SIDE_TO_OLD_SIDE_RATIO`](blend_plan) of the old sides at the rims, short sides are
//! collapsed, and vertices are inserted at small angles ([`crate::remesh`]). The new vertices then
//! move to the minimum of a thin plate's energy, clamped to the old faces ([`crate::fair`]). This
//! is repeated; if the result intersects, with fewer rounds or with protection against folds.
//!
//! The plate has a rest shape: the curvature of the coarse triangles, smoothed over their ridges. A
//! plate that is flat at rest would narrow to a neck between two tubes, and over a few radii to a
//! point. Over many radii it follows the coarse triangles, or a guide surface in their place:
//! between bent tubes the coarse triangles themselves narrow to a neck. In a hole, the rest shape
//! is the plate's own smoothed curvature from the second solution on. Creases that the old faces
//! lack are smoothed out. Finally the sharp triangles at the shortest rim edges are refined; there
//! the plate would follow round-off.
//!
//! Sources: M. Botsch, L. Kobbelt, *A remeshing approach to multiresolution modeling* (2004), for
//! the order of the steps; P. Liepa, *Filling holes in meshes* (2003), for the plate. The constants
//! were tuned so that joints come nearest to the parts cut out of closed meshes, with good angles
//! (`make bench ONLY=truth`).
//!
//! | file | subject |
//! |---|---|
//! | [`old_ring`](self) | the old faces around the rims |
//! | [`blend_plan`](self) | the steps |
//! | [`fold_free_moves`](self) | vertex moves without folds |

mod fold_free_moves;
mod blend_plan;
mod old_ring;

pub(crate) use blend_plan::{BlendFairing, BlendPlan, GuideSurface, NewVertexLimits};
pub(crate) use old_ring::{MAX_FAN_TRIANGLES, OldRing, SecondRing};

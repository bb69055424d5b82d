//! Blends: fine triangles in the place of coarse ones between rims that stay, on a surface that goes
//! on as the old one does. What a strip or the triangulation of a hole becomes.
//!
//! The coarse triangles say which way the surface goes. Their sides are halved until they are as
//! long as the old ones at the rims (more exactly [`SIZE`](plan) of them), short ones are collapsed,
//! and vertices added where angles are small ([`crate::remesh`]); then all new vertices move to
//! where a thin plate clamped to the old faces bends least ([`crate::fair`]), more than once, or,
//! where that cuts, with care or less often. The plate is bent by itself as the coarse triangles
//! are, their ridges averaged out: one that is flat by itself would narrow to a neck between two
//! tubes, and, a few radii long, to a point. Across many radii it hangs on them. In a hole it follows
//! its own averaged curvature from the second solution on. Creases that the old faces do not have are
//! ironed out. At last the sharp triangles at the shortest edges of the rims are refined: there the
//! plate would follow round-off.
//!
//! Sources: M. Botsch, L. Kobbelt, *A remeshing approach to multiresolution modeling* (2004), for
//! the order of the steps; P. Liepa, *Filling holes in meshes* (2003), for the plate. The constants
//! are those of the joints that were nearest to what had been cut out of closed meshes, and whose
//! angles were best (`make bench ONLY=truth`).
//!
//! | file | subject |
//! |---|---|
//! | [`ring`](self) | the old faces round the rims |
//! | [`plan`](self) | the steps |
//! | [`fold_free_moves`](self) | vertices that fold triangles taken back |

mod fold_free_moves;
mod plan;
mod ring;

pub(crate) use plan::{Limits, Plan, Way};
pub(crate) use ring::{Beyond, MAX_FAN_TRIANGLES, OldRing};

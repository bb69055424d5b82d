//! Creases of the old surface that go on across a hole.
//!
//! A crease ends on a rim where one old edge that ends there is sharp, and far sharper than what is
//! usual round the hole. Ends whose tangents, and the surfaces on either side, go on in each other
//! are joined by a curve, three or more that point at one place in that place. The curves cut the
//! hole into parts, each of which is filled by itself: to it the surface beyond a curve is unknown, so
//! that it continues smoothly what is on its own side, and meets the other parts in a sharp edge.
//! Where a jagged rim follows a crease for some edges, the curve begins where it leaves it, and where
//! the crease does not leave it, what is beyond is unknown there, too.
//!
//! Sources: A. Sharf, M. Alexa, D. Cohen-Or, *Context-based surface completion* (2004), for features
//! first and surfaces between them later; the curve is a cubic with the tangents of the circles
//! through an end's last edge and the other end, which is exact for creases that are straight or
//! arcs. Nothing is random; what fits nothing is left, and a rim without ends is filled as before.
//!
//! | file | subject |
//! |---|---|
//! | [`ends`](self) | where creases end on the rim |
//! | [`joins`](self) | which ends belong together |
//! | [`curve`](self) | the curve between two |
//! | [`bridges`](self) | the curves across the hole |
//! | [`parts`](self) | the parts of the hole |

mod bridges;
mod curve;
mod ends;
mod joins;
mod parts;
#[cfg(test)]
mod tests;

use super::patch_rim::Rim;
use bridges::Bridges;
use glam::DVec3;
use gusset_base::error::Result;
use joins::Join;
use parts::Outlines;

pub(super) use parts::Part;

/// A hole cut along creases.
pub(super) struct Division {
    /// The vertices of the curves, numbered after the rim's.
    pub(super) points: Vec<DVec3>,
    pub(super) parts: Vec<Part>,
}

/// Cuts a hole along the creases that end on its rim; `None` if none go on, and the rim follows none,
/// or if it has several loops. `taken`: of two vertices of the rim that must not get an edge. `limit`:
/// how many new vertices the curves may have, `None` for none.
///
/// O(n) for n old triangles round the rim and O(m^6) for its m ends, few on any shape.
pub(super) fn divide(rim: &Rim, taken: &dyn Fn(u32, u32) -> bool, limit: Option<u32>) -> Result<Option<Division>> {
    if rim.lengths.len() > 1 {
        return Ok(None);
    }
    let corners = ends::corners(rim)?;
    let (ends, touches) = ends::ends(rim, &corners)?;
    let joins = joins::joins(rim, &ends)?;
    let mut bridges = Bridges::new(rim, &ends)?;
    // Of each end of a curve.
    let limit = limit.map(|limit| limit as usize / ends.len().max(1));
    for join in &joins {
        match (join, limit) {
            (&Join::Pair(pair), _) => bridges.join(pair, taken, limit)?,
            (Join::Star { centre, arms }, Some(limit)) if limit > 0 => bridges.meet(*centre, arms, limit)?,
            (Join::Star { .. }, _) => {}
        }
    }
    let outlines = Outlines { rim, corners: &corners, ends: &ends, touches: &touches, bridges: &bridges.bridges };
    let parts = outlines.parts(&bridges.points)?;
    Ok(parts.map(|parts| Division { points: bridges.points, parts }))
}

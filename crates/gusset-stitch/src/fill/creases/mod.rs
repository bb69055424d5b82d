//! Continuation of the old surface's creases across a hole.
//!
//! A crease ends on a rim where one old edge is sharp, and far sharper than the median around the
//! hole. Two ends are joined by a curve if their tangents, and the surfaces on both sides, continue
//! each other. Three or more ends that point at one place are joined there. The curves cut the hole
//! into parts, which are filled one by one. A part treats the surface across a curve as unknown: it
//! continues its own side smoothly, and meets the other parts in a sharp edge. A jagged rim may
//! follow a crease for some edges: the curve begins where the crease leaves the rim. If the crease
//! does not leave the rim, the surface beyond it is treated as unknown too.
//!
//! Source: A. Sharf, M. Alexa, D. Cohen-Or, *Context-based surface completion* (2004), for filling
//! features before the surfaces between them. The curve is a cubic. Its end tangents are tangent to
//! circles, each through the last crease edge of one end and the tip of the other. It reproduces
//! creases that are straight or circular arcs. Nothing is random. Unmatched ends are ignored, and a
//! rim without ends is filled as one part.
//!
//! | file | subject |
//! |---|---|
//! | [`crease_ends`](self) | crease ends on the rim |
//! | [`crease_joins`](self) | the matching of crease ends |
//! | [`crease_curve`](self) | the curve between two ends |
//! | [`crease_bridges`](self) | the curves across the hole |
//! | [`hole_parts`](self) | the parts of the hole |

mod crease_bridges;
mod crease_curve;
mod crease_ends;
mod crease_joins;
mod hole_parts;
#[cfg(test)]
mod tests;

use super::patch_rim::PatchRim;
use crease_bridges::CreaseBridges;
use crease_joins::CreaseJoin;
use glam::DVec3;
use gusset_base::error::Result;
use hole_parts::PartOutlines;

pub(super) use hole_parts::HolePart;

/// A hole cut along creases.
pub(super) struct DividedHole {
    /// The vertices of the curves, numbered after the rim's.
    pub(super) points: Vec<DVec3>,
    pub(super) parts: Vec<HolePart>,
}

/// Cuts a hole along the creases that end on its rim.
///
/// Returns `None` if no crease continues and the rim does not follow one, or if the rim has several
/// loops. `taken` is true for two rim vertices that must not get an edge. `limit` bounds the number
/// of new vertices on the curves; `None` allows no new vertices.
///
/// O(n) for n old triangles around the rim, plus O(m^6) for its m ends, which are few on any shape.
pub(super) fn divide_along_creases(
    rim: &PatchRim,
    taken: &dyn Fn(u32, u32) -> bool,
    limit: Option<u32>,
) -> Result<Option<DividedHole>> {
    if rim.loop_lengths.len() > 1 {
        return Ok(None);
    }
    let corners = crease_ends::collect_rim_corners(rim)?;
    let (ends, along_rim) = crease_ends::find_crease_ends(rim, &corners)?;
    let joins = crease_joins::match_crease_ends(rim, &ends)?;
    let mut bridges = CreaseBridges::new(rim, &ends)?;
    // The limit for each end of a curve.
    let limit = limit.map(|limit| limit as usize / ends.len().max(1));
    for join in &joins {
        match (join, limit) {
            (&CreaseJoin::Pair(pair), _) => bridges.join_two_ends(pair, taken, limit)?,
            (CreaseJoin::Star { centre, arms }, Some(limit)) if limit > 0 => {
                bridges.join_ends_at_point(*centre, arms, limit)?;
            }
            (CreaseJoin::Star { .. }, _) => {}
        }
    }
    let outlines =
        PartOutlines { rim, corners: &corners, ends: &ends, along_rim: &along_rim, bridges: &bridges.bridges };
    let parts = outlines.build_parts(&bridges.points)?;
    Ok(parts.map(|parts| DividedHole { points: bridges.points, parts }))
}

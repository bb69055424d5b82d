//! Slits: the open parts between two borders that are partly sewn.
//!
//! If two borders coincide only in some edges, sewing leaves loops that run along the rest of one
//! border and back along the other. They turn at vertices that sewing merged. A loop of this kind
//! is joined with itself if its sides are less than an edge apart, and face each other, or bound
//! surfaces that continue each other. Sides may also be so near that they overlap. A wider loop may
//! be a hole that the seam crosses, and stays open. The sides of the loop around two patches that
//! are sewn side by side look away from each other.
//!
//! One side takes both ends, so that the strip begins and ends at edges of the other. With M + N
//! vertices the strip has M + N - 2 triangles, and leaves nothing open. The criteria are our own.

use super::assemble_request::Extent;
use super::candidates::{FacingLoops, FacingSearch, SlitLoop};
use super::side_facing::{EdgeDepths, RimRun, SideFacing};
use crate::boundary::Loop;
use crate::stitch::facing::Arc;
use crate::stitch::stitch_rim::Rim;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_mesh::MeshView;

/// The widest slit, in mean edges, unless the caller sets a limit.
const DEFAULT_MAX_SLIT_MEAN_EDGES: f64 = 1.0;

/// Each two merged vertices of a loop may be the ends of its slit. A loop with more of them is not
/// a slit.
const MAX_SLIT_ENDS: usize = 6;

impl SlitLoop {
    /// Returns the slit of a loop that passes vertices of `seam`, which is ascending. Chooses the
    /// two ends between which the sides are nearest.
    ///
    /// `unit` is the unit of the rim's points. O(n log n) for n vertices and the corners of the
    /// faces along the loop.
    pub(super) fn find_in_loop(
        mesh: &MeshView<'_>,
        found: &Loop<'_>,
        rim: &Rim,
        unit: f64,
        seam: &[u32],
        job: &Job<'_>,
    ) -> Result<Option<SlitLoop>> {
        let n = rim.vertices.len();
        let on_seam = (0..n).filter(|&i| seam.binary_search(&rim.vertices[i]).is_ok());
        let ends = alloc::gather(on_seam.take(MAX_SLIT_ENDS + 1))?;
        if ends.len() < 2 || ends.len() > MAX_SLIT_ENDS {
            return Ok(None);
        }
        let depths = EdgeDepths::measure(mesh, found, rim, unit)?;
        let is_near = |gap: f64| depths.is_near_gap(gap, 0..n);
        let mut best: Option<SlitLoop> = None;
        for (k, &s) in ends.iter().enumerate() {
            for &t in &ends[k + 1..] {
                let slit = SlitLoop::slit_between_ends(rim, [s, t], is_near, job)?;
                let rank = |slit: &SlitLoop| (!slit.may_be_closed, slit.mean_gap);
                let better = |slit: &SlitLoop| best.is_none_or(|best| rank(slit) < rank(&best));
                best = slit.filter(better).or(best);
            }
        }
        Ok(best)
    }

    /// Returns the slit with the ends at places `s` and `t`. `is_near` tells whether a gap is
    /// small.
    fn slit_between_ends(
        rim: &Rim,
        [s, t]: [usize; 2],
        is_near: impl Fn(f64) -> bool,
        job: &Job<'_>,
    ) -> Result<Option<SlitLoop>> {
        let n = rim.vertices.len();
        // The side with fewer vertices takes the ends.
        let (from, to) = if t - s <= n - (t - s) { (s, t) } else { (t, s) };
        let edges = (to + n - from) % n;
        let arcs = [Arc { first: from, count: edges + 1 }, Arc { first: (to + 1) % n, count: n - edges - 1 }];

        let sides = [arcs[0], Arc { first: to, count: n - edges + 1 }].map(|arc| RimRun { rim, arc });
        let seen = SideFacing::between(&sides[0], &sides[1], job)?;
        Ok(seen.map(|seen| SlitLoop {
            arcs,
            mean_gap: seen.mean_gap,
            is_narrow: seen.is_narrow(),
            is_opposed: seen.is_opposed(),
            may_be_closed: seen.may_close(is_near(seen.mean_gap)),
        }))
    }

    /// Returns the two sides as a pair of loop `r` with itself.
    pub(super) fn as_facing_loops(&self, r: usize) -> FacingLoops {
        FacingLoops { rims: [r, r], arcs: Some(self.arcs), mean_gap: self.mean_gap }
    }
}

impl FacingSearch<'_> {
    /// Returns the slits to be joined with themselves. `wide` lists loops to be joined at any gap,
    /// in ascending order.
    pub(super) fn unused_slits<'s>(&'s self, wide: &'s [usize]) -> impl Iterator<Item = FacingLoops> + 's {
        let closes = move |&(r, slit): &(usize, SlitLoop)| {
            let wanted = self.extent != Extent::WholeLoops && !self.is_joined_loop[r];
            let is_near = slit.may_be_closed && slit.mean_gap <= self.max_slit_gap(r);
            wanted && (is_near || wide.binary_search(&r).is_ok()) && !self.is_excluded_pair(r, r)
        };
        let all = self.slits.iter().enumerate().filter_map(|(r, slit)| Some((r, (*slit)?)));
        all.filter(closes).map(|(r, slit)| slit.as_facing_loops(r))
    }

    /// Returns the largest gap between the sides of loop `r`.
    pub(super) fn max_slit_gap(&self, r: usize) -> f64 {
        let own = &self.candidates[r];
        let is_narrow = self.slits[r].is_some_and(|slit| slit.is_narrow);
        let by_radius = if is_narrow { f64::INFINITY } else { 0.5 * own.mean_radius };
        self.max_gap.unwrap_or((DEFAULT_MAX_SLIT_MEAN_EDGES * own.mean_edge_length).min(by_radius))
    }
}

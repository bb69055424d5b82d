//! Slits: the open parts between two borders that are partly sewn.
//!
//! If two borders coincide only in some edges, sewing leaves loops that run along the rest of one
//! border and back along the other. They turn at vertices that sewing merged. A loop of this kind
//! is joined with itself in two cases. Its sides may face each other across less than an edge, or
//! they may be so near that they overlap. A wider loop may be a hole that the seam crosses, and
//! stays open. The sides of the loop around two patches that are sewn side by side look away from
//! each other.
//!
//! One side takes both ends, so that the strip begins and ends at edges of the other. With M + N
//! vertices the strip has M + N - 2 triangles, and leaves nothing open. The criteria are our own.

use super::candidates::{FacingLoops, FacingSearch, STAGE, SlitLoop};
use super::whole_loops::rim_conormals;
use crate::boundary::Loop;
use crate::stitch::facing::Arc;
use crate::stitch::polyline::nearest_point_on_adjacent_edges;
use crate::stitch::stitch_rim::Rim;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::kd_tree::KdTree;
use gusset_base::job::Job;
use gusset_mesh::MeshView;

/// Smallest sum of the sides' looks at each other.
const MIN_FACING_COSINE_SUM_OF_SIDES: f64 = 0.3;

/// Sides are near if their distance is at most this fraction of the depth of the faces along them,
/// or of shorter edges.
const MAX_NEAR_GAP_TO_DEPTH_RATIO: f64 = 0.25;

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
        let conormals = rim_conormals(rim)?;
        let side = |i: usize| rim.points[i].distance(rim.points[(i + 1) % n]);
        let depth =
            |i: usize| face_depth(mesh, found.faces[i], rim.points[i], rim.points[(i + 1) % n], unit).min(side(i));
        let (length, area) = (0..n).fold((0.0, 0.0), |(length, area), i| (length + side(i), area + side(i) * depth(i)));
        let is_near = |gap: f64| gap * length <= MAX_NEAR_GAP_TO_DEPTH_RATIO * area;
        let mut best: Option<SlitLoop> = None;
        for (k, &s) in ends.iter().enumerate() {
            for &t in &ends[k + 1..] {
                let slit = SlitLoop::slit_between_ends(rim, &conormals, [s, t], is_near, job)?;
                let rank = |slit: &SlitLoop| (!slit.closes, slit.gap);
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
        conormals: &[DVec3],
        [s, t]: [usize; 2],
        is_near: impl Fn(f64) -> bool,
        job: &Job<'_>,
    ) -> Result<Option<SlitLoop>> {
        let n = rim.vertices.len();
        // The side with fewer vertices takes the ends.
        let (from, to) = if t - s <= n - (t - s) { (s, t) } else { (t, s) };
        let edges = (to + n - from) % n;
        let arcs = [Arc { first: from, count: edges + 1 }, Arc { first: (to + 1) % n, count: n - edges - 1 }];

        let there =
            measure_side_facing(rim, conormals, Arc { first: (from + 1) % n, count: edges - 1 }, (to, n - edges), job)?;
        let back = measure_side_facing(rim, conormals, arcs[1], (from, edges), job)?;
        let (gap, looks) = match (there, back) {
            (Some(x), Some(y)) => (x.0.max(y.0), x.1 + y.1),
            (Some(x), None) | (None, Some(x)) => (x.0, 2.0 * x.1),
            (None, None) => return Ok(None),
        };
        Ok(Some(SlitLoop { arcs, gap, closes: looks >= MIN_FACING_COSINE_SUM_OF_SIDES || is_near(gap) }))
    }

    /// Returns the two sides as a pair of loop `r` with itself.
    pub(super) fn as_facing_loops(&self, r: usize) -> FacingLoops {
        FacingLoops { rims: [r, r], arcs: Some(self.arcs), gap: self.gap }
    }
}

impl FacingSearch<'_> {
    /// Returns the slits to be joined with themselves.
    pub(super) fn unused_slits(&self) -> impl Iterator<Item = FacingLoops> + '_ {
        let closes = |&(r, slit): &(usize, SlitLoop)| {
            let (wanted, near) = (self.arcs && !self.used[r], slit.gap <= self.max_slit_gap(r));
            slit.closes && wanted && near && !self.is_excluded_pair(r, r)
        };
        let all = self.slits.iter().enumerate().filter_map(|(r, slit)| Some((r, (*slit)?)));
        all.filter(closes).map(|(r, slit)| slit.as_facing_loops(r))
    }

    /// Returns the largest gap between the sides of loop `r`.
    pub(super) fn max_slit_gap(&self, r: usize) -> f64 {
        let own = &self.candidates[r];
        self.max_gap.unwrap_or((DEFAULT_MAX_SLIT_MEAN_EDGES * own.spacing).min(0.5 * own.radius))
    }
}

/// Measures how the vertices of an arc see the polyline with `edges` edges from place `first`.
/// Returns their mean distance, and the mean cosine between conormals and directions to the
/// polyline, both weighted by length; `None` without vertices.
fn measure_side_facing(
    rim: &Rim,
    conormals: &[DVec3],
    arc: Arc,
    (first, edges): (usize, usize),
    job: &Job<'_>,
) -> Result<Option<(f64, f64)>> {
    let n = rim.points.len();
    let line = alloc::collect((0..edges + 1).map(|k| rim.points[(first + k) % n]))?;
    let tree = KdTree::new(&line, &job.part(0.0, 0.5), STAGE)?;
    let side = |i: usize| rim.points[i].distance(rim.points[(i + 1) % n]);
    let (mut sum, mut gap, mut cosine) = (0.0, 0.0, 0.0);
    for (k, i) in arc.places(n).enumerate() {
        job.part(0.5, 1.0).step_every(1 << 12, k, arc.count, STAGE)?;
        let p = rim.points[i];
        let Some((_, v)) = tree.nearest(p, f64::INFINITY, |_| true) else {
            continue;
        };
        let way = nearest_point_on_adjacent_edges(&line, false, v as usize, p) - p;
        let (weight, distance) = (side((i + n - 1) % n) + side(i), way.length());
        sum += weight;
        gap += weight * distance;
        cosine += weight * if distance > 0.0 { way.dot(conormals[i]) / distance } else { 1.0 };
    }
    Ok((sum > 0.0).then(|| (gap / sum, cosine / sum)))
}

/// Returns the depth of face `f` from its edge from `p` to `q`, in `unit`.
fn face_depth(mesh: &MeshView<'_>, f: u32, p: DVec3, q: DVec3, unit: f64) -> f64 {
    let along = (q - p).normalize_or_zero();
    let off = |v: u32| (mesh.positions().get(v) / unit - p).reject_from_normalized(along).length();
    mesh.face(f as usize).map(off).fold(0.0, f64::max)
}

//! What is left of two borders that are sewn along a part.
//!
//! Of borders that coincide in some edges only, sewing leaves loops that run along what is left of
//! one border and back along the other: slits. They turn where sewing made one vertex of several.
//! A loop that does so is joined with itself if its sides look at each other across less than an
//! edge, or if they are so near that they may also overlap. What is wider may be a hole that the
//! seam crosses, and stays open; and the sides of the loop round two patches that are sewn side by
//! side look away from each other.
//!
//! One side takes both ends, so that the strip begins and ends at an edge of the other: of M + N
//! vertices it has M + N - 2 triangles, and nothing is left open. The criteria are ours.

use super::candidates::{Facing, FacingSearch, STAGE, Slit};
use super::whole_loops::conormals;
use crate::boundary::Loop;
use crate::stitch::facing::Arc;
use crate::stitch::polyline::nearest_beside;
use crate::stitch::stitch_rim::Rim;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::kd_tree::KdTree;
use gusset_base::job::Job;
use gusset_mesh::MeshView;

/// The least that the sides look at each other in sum.
const MIN_SUM_OF_LOOKS: f64 = 0.3;

/// Sides are near if their distance is at most this part of the depth of the faces along them, or
/// of the edges if those are shorter.
const MAX_PART_OF_DEPTH: f64 = 0.25;

/// The widest slit, in mean edges, unless a gap is given.
const MAX_GAP: f64 = 1.0;

/// Of so many vertices that sewing made of several, each two may be the ends; of more none.
const MAX_ENDS: usize = 6;

impl Slit {
    /// Of a loop that passes some of the `seam`'s vertices, which ascend: with the two ends between
    /// which the sides are nearest. `unit`: what the rim's points are multiplied by. O(n log n) for
    /// n vertices, and the corners of the faces along it.
    pub(super) fn of(
        mesh: &MeshView<'_>,
        found: &Loop<'_>,
        rim: &Rim,
        unit: f64,
        seam: &[u32],
        job: &Job<'_>,
    ) -> Result<Option<Slit>> {
        let n = rim.vertices.len();
        let on_seam = (0..n).filter(|&i| seam.binary_search(&rim.vertices[i]).is_ok());
        let ends = alloc::gather(on_seam.take(MAX_ENDS + 1))?;
        if ends.len() < 2 || ends.len() > MAX_ENDS {
            return Ok(None);
        }
        let conormals = conormals(rim)?;
        let side = |i: usize| rim.points[i].distance(rim.points[(i + 1) % n]);
        let depth = |i: usize| depth(mesh, found.faces[i], rim.points[i], rim.points[(i + 1) % n], unit).min(side(i));
        let (length, area) = (0..n).fold((0.0, 0.0), |(length, area), i| (length + side(i), area + side(i) * depth(i)));
        let is_near = |gap: f64| gap * length <= MAX_PART_OF_DEPTH * area;
        let mut best: Option<Slit> = None;
        for (k, &s) in ends.iter().enumerate() {
            for &t in &ends[k + 1..] {
                let slit = Slit::between(rim, &conormals, [s, t], is_near, job)?;
                let rank = |slit: &Slit| (!slit.closes, slit.gap);
                let better = |slit: &Slit| best.is_none_or(|best| rank(slit) < rank(&best));
                best = slit.filter(better).or(best);
            }
        }
        Ok(best)
    }

    /// The one that turns at places `s` and `t`; `is_near` tells if sides that far apart are near.
    fn between(
        rim: &Rim,
        conormals: &[DVec3],
        [s, t]: [usize; 2],
        is_near: impl Fn(f64) -> bool,
        job: &Job<'_>,
    ) -> Result<Option<Slit>> {
        let n = rim.vertices.len();
        // The side with fewer vertices takes the ends.
        let (from, to) = if t - s <= n - (t - s) { (s, t) } else { (t, s) };
        let edges = (to + n - from) % n;
        let arcs = [Arc { first: from, count: edges + 1 }, Arc { first: (to + 1) % n, count: n - edges - 1 }];

        let there = look(rim, conormals, Arc { first: (from + 1) % n, count: edges - 1 }, (to, n - edges), job)?;
        let back = look(rim, conormals, arcs[1], (from, edges), job)?;
        let (gap, looks) = match (there, back) {
            (Some(x), Some(y)) => (x.0.max(y.0), x.1 + y.1),
            (Some(x), None) | (None, Some(x)) => (x.0, 2.0 * x.1),
            (None, None) => return Ok(None),
        };
        Ok(Some(Slit { arcs, gap, closes: looks >= MIN_SUM_OF_LOOKS || is_near(gap) }))
    }

    /// The sides of loop `r`, whose slit it is.
    pub(super) fn facing(&self, r: usize) -> Facing {
        Facing { rims: [r, r], arcs: Some(self.arcs), gap: self.gap }
    }
}

impl FacingSearch<'_> {
    /// The loops that are joined with themselves, along parts of them.
    pub(super) fn slits(&self) -> impl Iterator<Item = Facing> + '_ {
        let closes = |&(r, slit): &(usize, Slit)| {
            let (wanted, near) = (self.arcs && !self.used[r], slit.gap <= self.slit_limit(r));
            slit.closes && wanted && near && !self.is_excluded(r, r)
        };
        let all = self.slits.iter().enumerate().filter_map(|(r, slit)| Some((r, (*slit)?)));
        all.filter(closes).map(|(r, slit)| slit.facing(r))
    }

    /// The greatest distance between the sides of loop `r`.
    pub(super) fn slit_limit(&self, r: usize) -> f64 {
        let own = &self.candidates[r];
        self.max_gap.unwrap_or((MAX_GAP * own.spacing).min(0.5 * own.radius))
    }
}

/// How the vertices of an arc see the polyline of `edges` edges from place `first` on: their mean
/// distance, and the mean cosine of the angle between conormals and the ways there, by length;
/// `None` of none.
fn look(
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
        let way = nearest_beside(&line, false, v as usize, p) - p;
        let (weight, distance) = (side((i + n - 1) % n) + side(i), way.length());
        sum += weight;
        gap += weight * distance;
        cosine += weight * if distance > 0.0 { way.dot(conormals[i]) / distance } else { 1.0 };
    }
    Ok((sum > 0.0).then(|| (gap / sum, cosine / sum)))
}

/// How far face `f` reaches from its edge from `p` to `q`, in `unit`.
fn depth(mesh: &MeshView<'_>, f: u32, p: DVec3, q: DVec3, unit: f64) -> f64 {
    let along = (q - p).normalize_or_zero();
    let off = |v: u32| (mesh.positions().get(v) / unit - p).reject_from_normalized(along).length();
    mesh.face(f as usize).map(off).fold(0.0, f64::max)
}

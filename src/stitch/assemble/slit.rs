//! What is left of two borders that are sewn along a part.
//!
//! Of borders that coincide in some edges only, sewing leaves loops that run along what is left of
//! one border and back along the other: slits. They turn where sewing made one vertex of several.
//! A loop that does so twice is joined with itself if its sides look at each other, or if they are
//! so near that they may also overlap. (The loop round two patches that are sewn side by side turns
//! twice, too; its sides look away from each other.)
//!
//! One side takes both ends, so that the strip begins and ends at an edge of the other: of M + N
//! vertices it has M + N - 2 triangles, and nothing is left open. The criteria are ours.

use super::candidates::{Facing, FacingSearch, Slit};
use super::whole_loops::conormals;
use crate::alloc;
use crate::boundary::Loop;
use crate::error::Result;
use crate::geom::kd_tree::KdTree;
use crate::job::Job;
use crate::mesh::MeshView;
use crate::stitch::facing::Arc;
use crate::stitch::polyline::nearest_beside;
use crate::stitch::rim::Rim;
use glam::DVec3;

/// The least that the sides look at each other in sum.
const MIN_SUM_OF_LOOKS: f64 = 0.3;

/// Sides are near if their distance is at most this part of the depth of the faces along them.
const MAX_PART_OF_DEPTH: f64 = 0.25;

impl Slit {
    /// Of a loop that passes two of the `seam`'s vertices, which ascend. `unit`: what the rim's
    /// points are multiplied by. O(n log n) for n vertices.
    pub(super) fn of(
        mesh: &MeshView<'_>,
        found: &Loop<'_>,
        rim: &Rim,
        unit: f64,
        seam: &[u32],
    ) -> Result<Option<Slit>> {
        let n = rim.vertices.len();
        let mut ends = (0..n).filter(|&i| seam.binary_search(&rim.vertices[i]).is_ok());
        let (Some(s), Some(t), None) = (ends.next(), ends.next(), ends.next()) else {
            return Ok(None);
        };
        // The side with fewer vertices takes the ends.
        let (from, to) = if t - s <= n - (t - s) { (s, t) } else { (t, s) };
        let edges = (to + n - from) % n;
        let arcs = [Arc { first: from, count: edges + 1 }, Arc { first: (to + 1) % n, count: n - edges - 1 }];

        let conormals = conormals(rim)?;
        let there = look(rim, &conormals, Arc { first: (from + 1) % n, count: edges - 1 }, (to, n - edges))?;
        let back = look(rim, &conormals, arcs[1], (from, edges))?;
        let (gap, looks) = match (there, back) {
            (Some(x), Some(y)) => (x.0.max(y.0), x.1 + y.1),
            (Some(x), None) | (None, Some(x)) => (x.0, 2.0 * x.1),
            (None, None) => return Ok(None),
        };
        let side = |i: usize| rim.points[i].distance(rim.points[(i + 1) % n]);
        let depth = |i: usize| depth(mesh, found.faces[i], rim.points[i], rim.points[(i + 1) % n], unit);
        let (length, area) = (0..n).fold((0.0, 0.0), |(length, area), i| (length + side(i), area + side(i) * depth(i)));
        let is_near = gap * length <= MAX_PART_OF_DEPTH * area;
        Ok(Some(Slit { arcs, gap, closes: looks >= MIN_SUM_OF_LOOKS || is_near }))
    }

    /// The sides of loop `r`, whose slit it is.
    pub(super) fn facing(&self, r: usize) -> Facing {
        Facing { rims: [r, r], arcs: Some(self.arcs), gap: self.gap }
    }
}

impl FacingSearch<'_> {
    /// The loops that are joined with themselves.
    pub(super) fn slits(&self) -> impl Iterator<Item = Facing> + '_ {
        let closes = |&(r, slit): &(usize, Slit)| {
            slit.closes && slit.gap <= self.limit(r, r) && !self.used[r] && !self.is_excluded(r, r)
        };
        let all = self.slits.iter().enumerate().filter_map(|(r, slit)| Some((r, (*slit)?)));
        all.filter(closes).map(|(r, slit)| slit.facing(r))
    }
}

/// How the vertices of an arc see the polyline of `edges` edges from place `first` on: their mean
/// distance, and the mean cosine of the angle between conormals and the ways there; `None` of none.
fn look(rim: &Rim, conormals: &[DVec3], arc: Arc, (first, edges): (usize, usize)) -> Result<Option<(f64, f64)>> {
    let n = rim.points.len();
    let line = alloc::collect((0..edges + 1).map(|k| rim.points[(first + k) % n]))?;
    let tree = KdTree::new(&line, &Job::default(), "")?;
    let (mut gap, mut cosine) = (0.0, 0.0);
    for i in arc.places(n) {
        let p = rim.points[i];
        let Some((_, v)) = tree.nearest(p, f64::INFINITY, |_| true) else {
            continue;
        };
        let way = nearest_beside(&line, false, v as usize, p) - p;
        let distance = way.length();
        gap += distance;
        cosine += if distance > 0.0 { way.dot(conormals[i]) / distance } else { 1.0 };
    }
    let count = arc.count as f64;
    Ok((arc.count > 0).then(|| (gap / count, cosine / count)))
}

/// How far face `f` reaches from its edge from `p` to `q`, in `unit`.
fn depth(mesh: &MeshView<'_>, f: u32, p: DVec3, q: DVec3, unit: f64) -> f64 {
    let along = (q - p).normalize_or_zero();
    let off = |v: u32| (mesh.positions().get(v) / unit - p).reject_from_normalized(along).length();
    mesh.face(f as usize).map(off).fold(0.0, f64::max)
}

//! Costs that lie between neighbouring triangles.
//!
//! **Smooth.** Over all edges shared by two triangles of the strip, the sum of (1 - cos t) times
//! the edge's length, t being the angle between their normals. For small angles that is t^2 / 2
//! times the length, like the energy of a bent plate: many small bends cost less than one sharp
//! one. Along the rims the second triangle is the old face, where it is known.
//!
//! **Continuation.** The sum of 2 sin(t / 2), whatever the edge's length, with [`RIM_WEIGHT`] along
//! the rims: nearly linear in t, so that a surface may turn in one place rather than a little
//! everywhere, as where the old faces themselves go on across the gap. To it comes, over the
//! triangles, the square of the distance that the surface which was there is likely to have had from
//! them: a meridian from A_i to B_j whose ends lie h and k off each other's tangent planes bulges by
//! b^2 = (h^2 + k^2) / 32 in the middle, as the cubic with these tangents does, and a triangle
//! between two such has the mean square (b1^2 + b1 b2 + b2^2) / 3. All lengths are in mean edges of
//! the rims. Weights and the powers of t and of the length are those whose strips were nearest to
//! what had been cut out of closed meshes (`make bench ONLY=truth`).
//!
//! A triangle without area counts as perpendicular to its neighbours.

use super::rims::{Pair, RimPair};
use crate::alloc;
use crate::error::Result;
use glam::DVec3;

/// What bends along the rims cost more than those across meridians, for [`Bends::continuation`].
const RIM_WEIGHT: f64 = 4.0;

pub(super) struct Bends<'a> {
    a: &'a [DVec3],
    b: &'a [DVec3],
    /// See [`RimPair::sides`].
    sides: Option<[&'a [DVec3]; 2]>,
    /// Weight of the meridians' squared lengths.
    tie: f64,
    continuation: Option<Tangents>,
}

/// What a surface that continues others is measured by.
struct Tangents {
    /// The normals at the vertices of either rim.
    normals: [Vec<DVec3>; 2],
    /// One over the mean edge of the rims.
    per_edge: f64,
}

/// The triangles that steps into a node add: by a step on A, by a step on B.
#[derive(Clone, Copy, Default)]
pub(super) struct Triangles {
    /// Their unit normals; 0 for one that does not exist or has no area.
    pub(super) normals: [DVec3; 2],
    areas: [f64; 2],
    /// The squared bulge of the node's meridian.
    bulge: f64,
}

impl<'a> Bends<'a> {
    /// The least bends; `tie`: see [`tie_break`].
    pub(super) fn smooth(rims: &RimPair<'a>, tie: f64) -> Self {
        let &RimPair { a, b, sides, .. } = rims;
        Bends { a, b, sides, tie, continuation: None }
    }

    /// The best continuation of both surfaces.
    pub(super) fn continuation(rims: &RimPair<'a>, tie: f64) -> Result<Self> {
        let &RimPair { a, b, sides, closed, .. } = rims;
        let length = |line: &[DVec3]| line.windows(2).map(|edge| edge[0].distance(edge[1])).sum::<f64>();
        let mean = (length(a) + length(b)) / (a.len() + b.len() - 2).max(1) as f64;
        let normals = |line: &[DVec3], side: Option<&[DVec3]>| match side {
            Some(side) => vertex_normals(side, line.len(), closed),
            None => alloc::filled(DVec3::ZERO, line.len()),
        };
        let tangents = Tangents {
            normals: [normals(a, sides.map(|sides| sides[0]))?, normals(b, sides.map(|sides| sides[1]))?],
            per_edge: if mean > 0.0 { 1.0 / mean } else { 0.0 },
        };
        let tie = tie * tangents.per_edge;
        Ok(Bends { a, b, sides, tie, continuation: Some(tangents) })
    }

    /// The triangles A_i A_i-1 B_j and A_i B_j-1 B_j.
    pub(super) fn triangles(&self, i: usize, j: usize) -> Triangles {
        let across = self.b[j] - self.a[i];
        let by_a = if i > 0 { (self.a[i - 1] - self.a[i]).cross(across) } else { DVec3::ZERO };
        let by_b = if j > 0 { (self.b[j - 1] - self.a[i]).cross(across) } else { DVec3::ZERO };
        let normals = [by_a.normalize_or_zero(), by_b.normalize_or_zero()];
        let Some(Tangents { normals: [at_a, at_b], per_edge }) = &self.continuation else {
            return Triangles { normals, ..Triangles::default() };
        };
        let square = per_edge * per_edge;
        let (h, k) = (at_a[i].dot(across), at_b[j].dot(across));
        Triangles {
            normals,
            areas: [by_a, by_b].map(|double| 0.5 * double.length() * square),
            bulge: (h * h + k * k) / 32.0 * square,
        }
    }

    /// The bend across meridian (i, j) between triangles with normals `p` and `q`.
    pub(super) fn across(&self, i: usize, j: usize, p: DVec3, q: DVec3) -> f64 {
        match self.continuation {
            Some(_) => p.distance(q),
            None => self.a[i].distance(self.b[j]) * (1.0 - p.dot(q)),
        }
    }

    /// What the triangle costs by itself that a step into (i, j) adds, of `here` the one on `on_a`:
    /// the bend along its rim, its bulge, and the tie break. `before`: the triangles of the node
    /// that the step comes from.
    pub(super) fn along(&self, i: usize, j: usize, on_a: bool, here: &Triangles, before: &Triangles) -> f64 {
        let tie = self.tie * self.a[i].distance_squared(self.b[j]);
        let normal = here.normals[usize::from(!on_a)];
        let side = self.sides.map(|[along_a, along_b]| if on_a { along_a[i - 1] } else { along_b[j - 1] });
        if self.continuation.is_some() {
            let bulge = (here.bulge + before.bulge + (here.bulge * before.bulge).sqrt()) / 3.0;
            let rim = side.map_or(0.0, |side| RIM_WEIGHT * normal.distance(side));
            return tie + rim + here.areas[usize::from(!on_a)] * bulge;
        }
        let edge = if on_a { self.a[i].distance(self.a[i - 1]) } else { self.b[j].distance(self.b[j - 1]) };
        tie + side.map_or(0.0, |side| edge * (1.0 - normal.dot(side)))
    }
}

/// The normals at the vertices of a rim, the mean of its two faces there; of a closed rim the last
/// point is the first again.
fn vertex_normals(sides: &[DVec3], points: usize, closed: bool) -> Result<Vec<DVec3>> {
    let around = |k: usize| match (k.checked_sub(1), sides.get(k)) {
        (Some(before), Some(&after)) => sides[before] + after,
        (None, Some(&after)) if closed => sides[sides.len() - 1] + after,
        (Some(before), None) if closed => sides[before] + sides[0],
        (Some(before), None) => sides[before],
        (None, after) => after.copied().unwrap_or_default(),
    };
    alloc::collect((0..points).map(|k| around(k).normalize_or_zero()))
}

/// A weight for the meridians' squared lengths, as on flat ground all strips are alike, and
/// round-off would choose: on the paper's own strip they come to 2^-20 of the meridians' lengths.
pub(super) fn tie_break(rims: &RimPair<'_>, paper: &[Pair]) -> f64 {
    let squared = |&[i, j]: &Pair| rims.a[i as usize].distance_squared(rims.b[j as usize]);
    let (lengths, squares) =
        paper.iter().map(squared).fold((0.0, 0.0), |(lengths, squares), s| (lengths + s.sqrt(), squares + s));
    if squares > 0.0 { 0.5f64.powi(20) * lengths / squares } else { 0.0 }
}

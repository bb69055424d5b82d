//! The cost of bends: over all edges shared by two triangles of the strip, the sum of (1 - cos
//! of the angle between their normals) times the edge's length. Along the rims the second
//! triangle is the old face, where it is known.
//!
//! For small angles t the cost is t^2 / 2 times the length, like the energy of a bent plate:
//! many small bends cost less than one sharp one. A triangle without area counts as
//! perpendicular to its neighbours.

use super::rims::{Pair, RimPair};
use glam::DVec3;

pub(super) struct Bends<'a> {
    a: &'a [DVec3],
    b: &'a [DVec3],
    /// See [`RimPair::sides`].
    sides: Option<[&'a [DVec3]; 2]>,
    /// Weight of the meridians' squared lengths.
    tie: f64,
}

/// The unit normals of the triangles that steps into a node add: by a step on A, by a step on B.
pub(super) type Normals = [DVec3; 2];

impl<'a> Bends<'a> {
    /// `tie`: see [`tie_break`].
    pub(super) fn new(rims: &RimPair<'a>, tie: f64) -> Self {
        let &RimPair { a, b, sides, .. } = rims;
        Bends { a, b, sides, tie }
    }

    /// The normals of the triangles A_i A_i-1 B_j and A_i B_j-1 B_j; 0 for one that does not exist
    /// or has no area.
    pub(super) fn normals(&self, i: usize, j: usize) -> Normals {
        let across = self.b[j] - self.a[i];
        let by_a = if i > 0 { (self.a[i - 1] - self.a[i]).cross(across).normalize_or_zero() } else { DVec3::ZERO };
        let by_b = if j > 0 { (self.b[j - 1] - self.a[i]).cross(across).normalize_or_zero() } else { DVec3::ZERO };
        [by_a, by_b]
    }

    /// The bend across meridian (i, j) between triangles with normals `p` and `q`.
    pub(super) fn across(&self, i: usize, j: usize, p: DVec3, q: DVec3) -> f64 {
        self.a[i].distance(self.b[j]) * (1.0 - p.dot(q))
    }

    /// The bend of the triangle that a step into (i, j) adds, with normal `p`, along its rim, and
    /// the tie break.
    pub(super) fn along(&self, i: usize, j: usize, on_a: bool, p: DVec3) -> f64 {
        let tie = self.tie * self.a[i].distance_squared(self.b[j]);
        let Some([along_a, along_b]) = self.sides else {
            return tie;
        };
        let (edge, side) = if on_a {
            (self.a[i].distance(self.a[i - 1]), along_a[i - 1])
        } else {
            (self.b[j].distance(self.b[j - 1]), along_b[j - 1])
        };
        tie + edge * (1.0 - p.dot(side))
    }
}

/// A weight for the meridians' squared lengths, as on flat ground all strips are alike, and
/// round-off would choose: on the paper's own strip they come to 2^-20 of the meridians' lengths.
pub(super) fn tie_break(rims: &RimPair<'_>, paper: &[Pair]) -> f64 {
    let squared = |&[i, j]: &Pair| rims.a[i as usize].distance_squared(rims.b[j as usize]);
    let (lengths, squares) =
        paper.iter().map(squared).fold((0.0, 0.0), |(lengths, squares), s| (lengths + s.sqrt(), squares + s));
    if squares > 0.0 { 0.5f64.powi(20) * lengths / squares } else { 0.0 }
}

//! Options and results of trimming.

use glam::DVec3;

/// How to trim.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Options<'a> {
    /// Surfaces that are no farther apart than this are one, in the unit of the positions; `None`:
    /// four mean edges of the coarser piece.
    pub max_distance: Option<f64>,
    /// Surfaces whose normals differ by more are two, in radians, below a quarter of a circle; 0:
    /// 60 degrees.
    pub max_angle: f64,
    /// Where each piece was seen from, in the unit of the positions; empty if nothing is known.
    /// What was seen under a flat angle counts for less.
    pub viewpoints: &'a [DVec3],
    /// Parts of fewer faces are no surface, but for whole components of the pieces; 0: 30.
    pub min_faces: u32,
}

/// What has fewer faces is no surface, if the caller says nothing.
const MIN_FACES: u32 = 30;
/// What others show as well is spared up to so many times as many faces.
pub(super) const SPARE: u32 = 20;

impl Options<'_> {
    /// What has fewer faces is no surface.
    pub(super) fn least(&self) -> u32 {
        if self.min_faces == 0 { MIN_FACES } else { self.min_faces }
    }

    /// What has fewer faces can be spared.
    pub(crate) fn least_island(&self) -> u32 {
        SPARE.saturating_mul(self.least())
    }
}

/// What is left of pieces.
#[derive(Debug, Clone, PartialEq)]
pub struct Trimmed {
    /// For each piece the faces that are kept, ascending.
    pub kept: Vec<Vec<u32>>,
    /// For each piece the vertices that lie on another one.
    pub covered: Vec<u32>,
    /// The pairs of pieces, the smaller first, that show the same surface somewhere, and face the
    /// same way there. Ascending.
    pub pairs: Vec<[u32; 2]>,
    /// The mean edge of the coarsest piece, in the unit of the positions.
    pub spacing: f64,
    /// Faces that cut some of a piece before theirs after all else; they went, with those round them.
    pub crossings: u32,
}

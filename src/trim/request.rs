//! Options and results of trimming.

use glam::DVec3;

/// How to trim.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Options<'a> {
    /// Surfaces that are no farther apart than this are one, in the unit of the positions; `None`:
    /// four mean edges of the coarser piece.
    pub max_distance: Option<f64>,
    /// Surfaces whose normals differ by more are two, in radians, below a quarter of a circle; 0: 60
    /// degrees.
    pub max_angle: f64,
    /// Where each piece was seen from, in the unit of the positions; empty if nothing is known.
    /// What was seen under a flat angle counts for less.
    pub eyes: &'a [DVec3],
    /// Parts of fewer faces are no surface, but for whole components of the pieces; 0: 30.
    pub min_faces: u32,
}

/// What is left of pieces.
#[derive(Debug, Clone, PartialEq)]
pub struct Trimmed {
    /// For each piece the faces that are kept, ascending.
    pub kept: Vec<Vec<u32>>,
    /// For each piece the vertices that lie on another one.
    pub covered: Vec<u32>,
    /// Faces of different pieces that cut each other after all else, and were taken out with those
    /// round them.
    pub crossings: u32,
}

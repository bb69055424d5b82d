//! Options and results of trimming.

use glam::DVec3;

/// Options of [`trim`](super::trim()).
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Options<'a> {
    /// The largest distance between two meshes of one surface, in the unit of the positions; `None`
    /// means four mean edges of the coarser piece.
    pub max_distance: Option<f64>,
    /// The largest angle between the normals of two meshes of one surface, in radians, below a
    /// quarter of a circle; 0 means 60 degrees.
    pub max_angle: f64,
    /// The viewpoint of each piece, in the unit of the positions; empty if unknown. Surfaces that
    /// were seen at a grazing angle have less confidence.
    pub viewpoints: &'a [DVec3],
    /// Parts with fewer faces are removed, except whole components of the pieces; 0 means 30.
    pub min_faces: u32,
}

/// Default for the smallest number of faces of a part.
const DEFAULT_MIN_FACES: u32 = 30;
/// Parts that other pieces show too are removed if they have fewer than this multiple of that
/// number.
pub(super) const SPARE_ISLAND_FACTOR: u32 = 20;

impl Options<'_> {
    /// Returns the smallest number of faces of a part.
    pub(super) fn min_part_faces(&self) -> u32 {
        if self.min_faces == 0 { DEFAULT_MIN_FACES } else { self.min_faces }
    }

    /// Returns the smallest cosine between normals of one surface.
    pub(super) fn min_normal_cosine(&self) -> f64 {
        libm::cos(if self.max_angle == 0.0 { DEFAULT_MAX_NORMAL_RADIANS } else { self.max_angle })
    }

    /// Returns the largest difference between places of one surface, on pieces whose coarsest has
    /// the mean edge `spacing`.
    pub(crate) fn same_surface_limits(&self, spacing: f64) -> SameSurfaceLimits {
        let distance = self.max_distance.unwrap_or(DEFAULT_MAX_DISTANCE_MEAN_EDGES * spacing);
        SameSurfaceLimits { distance, cosine: self.min_normal_cosine() }
    }

    /// Returns the smallest number of faces of a part that other pieces show too.
    pub(crate) fn min_island_faces(&self) -> u32 {
        SPARE_ISLAND_FACTOR.saturating_mul(self.min_part_faces())
    }
}

/// Default largest distance between meshes of one surface, in mean edges.
pub(super) const DEFAULT_MAX_DISTANCE_MEAN_EDGES: f64 = 4.0;
/// Default largest angle between normals of one surface, in radians.
const DEFAULT_MAX_NORMAL_RADIANS: f64 = std::f64::consts::FRAC_PI_3;

/// The largest difference between places of one surface.
#[derive(Clone, Copy)]
pub(crate) struct SameSurfaceLimits {
    /// The largest distance, in the unit of the positions.
    pub(crate) distance: f64,
    /// The smallest cosine between normals.
    pub(crate) cosine: f64,
}

/// The kept faces of the pieces.
#[derive(Debug, Clone, PartialEq)]
pub struct KeptFacesOfPieces {
    /// For each piece, the kept faces, ascending.
    pub kept: Vec<Vec<u32>>,
    /// For each piece, the number of vertices that lie on another piece.
    pub covered: Vec<u32>,
    /// The pairs of pieces, the smaller first, that show the same surface and face the same side
    /// there. Ascending.
    pub pairs: Vec<[u32; 2]>,
    /// The mean edge of the coarsest piece, in the unit of the positions.
    pub spacing: f64,
    /// The number of kept faces that intersected an earlier piece. They were removed, with the
    /// faces around them.
    pub crossings: u32,
}

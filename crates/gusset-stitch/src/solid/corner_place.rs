//! Places on faces of the input.

use crate::repair::corner_origins::CornerOrigin;
use gusset_mesh::NONE;

/// A place on a face of the input: up to three of its corners, with weights that sum to 1. Unused
/// corners are [`NONE`] and have weight 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CornerPlace {
    /// The corners of the input.
    pub corners: [u32; 3],
    /// The weight of each corner, at least 0.
    pub weights: [f64; 3],
}

impl CornerPlace {
    /// The place of the corners of a patch.
    pub(super) const NONE: CornerPlace = CornerPlace { corners: [NONE; 3], weights: [0.0; 3] };

    /// Returns the place of a corner.
    pub(super) fn at_corner(corner: u32) -> CornerPlace {
        CornerPlace { corners: [corner, NONE, NONE], weights: [1.0, 0.0, 0.0] }
    }

    /// Returns the mean of up to three places of one face. At most three corners remain, those with
    /// the largest weights.
    pub(super) fn mean(places: [(CornerPlace, f64); 3]) -> CornerPlace {
        let mut sums = [(NONE, 0.0); 9];
        let mut count = 0;
        for (place, share) in places {
            for (corner, weight) in place.corners.into_iter().zip(place.weights) {
                if corner == NONE || share * weight <= 0.0 {
                    continue;
                }
                let k = sums[..count].iter().position(|&(other, _)| other == corner).unwrap_or(count);
                sums[k] = (corner, sums[k].1 + share * weight);
                count = count.max(k + 1);
            }
        }
        sums[..count].sort_unstable_by(|a, b| b.1.total_cmp(&a.1).then(a.0.cmp(&b.0)));
        let total: f64 = sums[..3].iter().map(|&(_, weight)| weight).sum();
        if total <= 0.0 {
            return CornerPlace::NONE;
        }
        CornerPlace { corners: [0, 1, 2].map(|k| sums[k].0), weights: [0, 1, 2].map(|k| sums[k].1 / total) }
    }

    /// Returns the place between two corners of a mesh, whose own places `place_of` returns.
    pub(super) fn between(origin: CornerOrigin, place_of: impl Fn(u32) -> CornerPlace) -> CornerPlace {
        let start = place_of(origin.start);
        if origin.at <= 0.0 {
            return start;
        }
        let end = place_of(origin.end);
        CornerPlace::mean([(start, 1.0 - origin.at), (end, origin.at), (CornerPlace::NONE, 0.0)])
    }
}

//! Parts of a patch, with lower bounds of their distances that need no descent.

use crate::Patch;
use glam::{DVec2, DVec3};
use gusset_base::geom::bernstein::restrict;

/// Smallest size of a part in a parameter: 26 halvings.
const MIN_PART_PARAMETER_SIZE: f64 = 1.0 / (1 << 26) as f64;
/// Number of parts of a patch examined before the patch is left undecided.
pub(super) const MAX_PARTS_PER_PATCH: usize = 192;

/// A part of a patch: control net, range of parameters, and a lower bound of the distance.
pub(super) struct PatchPart<const N: usize> {
    pub(super) patch: Patch<N>,
    pub(super) low_parameters: DVec2,
    pub(super) parameter_lengths: DVec2,
    pub(super) distance_bound: f64,
}

impl<const N: usize> PatchPart<N> {
    /// The whole patch as a part.
    pub(super) fn whole_patch(patch: &Patch<N>) -> Self {
        PatchPart { patch: *patch, low_parameters: DVec2::ZERO, parameter_lengths: DVec2::ONE, distance_bound: 0.0 }
    }

    /// The part of a patch with the given smallest parameters and size.
    pub(super) fn from_range(patch: &Patch<N>, from: DVec2, size: DVec2, bound: f64) -> Self {
        let (mut patch, to) = (*patch, from + size);
        patch.points.iter_mut().for_each(|row| restrict(row, [from.y, to.y]));
        restrict(&mut patch.points, [from.x, to.x]);
        PatchPart { patch, low_parameters: from, parameter_lengths: size, distance_bound: bound }
    }

    /// Converts parameters of the part to parameters of the whole patch.
    pub(super) fn place_in_patch(&self, local: DVec2) -> DVec2 {
        self.low_parameters + self.parameter_lengths * local
    }

    /// True if the part is too small to be split.
    pub(super) fn is_too_small_to_split(&self) -> bool {
        self.parameter_lengths.min_element() <= MIN_PART_PARAMETER_SIZE
    }

    /// Halves the part across its longer direction, or across both if they are similar.
    pub(super) fn split_part(&self, mut add: impl FnMut(PatchPart<N>)) {
        let half = 0.5 * self.parameter_lengths;
        let mut give = |patch, corner: DVec2, size| {
            add(PatchPart { patch, low_parameters: self.low_parameters + corner, parameter_lengths: size, ..*self });
        };
        let [u, v] = self.patch.max_end_point_distances();
        if u > 2.0 * v {
            let [low, high] = self.patch.halves();
            give(low, DVec2::ZERO, DVec2::new(half.x, self.parameter_lengths.y));
            give(high, DVec2::new(half.x, 0.0), DVec2::new(half.x, self.parameter_lengths.y));
        } else if v > 2.0 * u {
            let [low, high] = self.patch.transposed().halves();
            give(low.transposed(), DVec2::ZERO, DVec2::new(self.parameter_lengths.x, half.y));
            give(high.transposed(), DVec2::new(0.0, half.y), DVec2::new(self.parameter_lengths.x, half.y));
        } else {
            let corners = [DVec2::ZERO, DVec2::Y, DVec2::X, DVec2::ONE];
            for (patch, corner) in self.patch.quarters().into_iter().zip(corners) {
                give(patch, half * corner, half);
            }
        }
    }

    /// Raises the bound to the bounds that need no descent: the distance of the box, and of the
    /// half-space through the middle.
    pub(super) fn with_cheap_distance_bounds(mut self, query: DVec3) -> PatchPart<N> {
        let [[a, b], [c, d]] = self.patch.corner_points();
        let direction = (4.0 * query - (a + b + c + d)).normalize_or_zero();
        let bound =
            self.patch.distance_bound_by_box(query).max(self.patch.distance_bound_by_half_space(query, direction));
        self.distance_bound = self.distance_bound.max(bound);
        self
    }
}

impl<const N: usize> Patch<N> {
    /// The largest distances between first and last control points, in u and in v.
    fn max_end_point_distances(&self) -> [f64; 2] {
        let p = &self.points;
        let across = |k: usize| [p[0][k].distance_squared(p[N - 1][k]), p[k][0].distance_squared(p[k][N - 1])];
        let extents = (0..N).map(across).fold([0.0_f64; 2], |[u, v], [x, y]| [u.max(x), v.max(y)]);
        extents.map(f64::sqrt)
    }
}

//! The proven nearest point of one patch.
//!
//! The bounds at the foot of a descent (see `patch_bounds`) may prove too little for the tolerance.
//! Branch and bound then splits the patch, down to 2^-26 of a side, into at most
//! [`MAX_PARTS_PER_PATCH`] parts.

use super::foot_point::{FootPoint, MAX_NEWTON_STEPS_ON_PART, MAX_NEWTON_STEPS_ON_PATCH, descend_to_foot};
use super::patch_bounds::best_distance_bound_of_patch;
use super::patch_part::{MAX_PARTS_PER_PATCH, PatchPart};
use crate::Patch;
use crate::frontier::{BranchAndBound, Frontier};
use glam::{DVec2, DVec3};
use std::convert::Infallible;

/// The nearest point found on a patch.
#[derive(Debug, Clone, Copy)]
pub(super) struct NearestPlaceOnPatch {
    pub(super) parameters: DVec2,
    pub(super) distance: f64,
    /// A lower bound of the distance of the patch.
    pub(super) distance_bound: f64,
}

impl NearestPlaceOnPatch {
    fn new(foot: &FootPoint, bound: f64) -> Self {
        NearestPlaceOnPatch {
            parameters: foot.parameters,
            distance: foot.distance,
            distance_bound: bound.min(foot.distance),
        }
    }
}

/// Waiting parts. Among equal bounds, the part added first comes first.
pub(super) type PartFrontier<const N: usize> = Frontier<PatchPart<N>, u32>;

/// Finds the nearest point of a patch to `query`, starting from `start`. Returns `None` if the
/// whole patch is farther than `max_distance`. `frontier` is a workspace.
///
/// The result does not depend on the limit. It is the nearest point within `tolerance`, unless its
/// bound shows that the search ended without proof.
pub(super) fn nearest_on_patch<const N: usize>(
    patch: &Patch<N>,
    query: DVec3,
    start: DVec2,
    max_distance: f64,
    tolerance: f64,
    frontier: &mut PartFrontier<N>,
) -> Option<NearestPlaceOnPatch> {
    let best = descend_to_foot(patch, query, start, MAX_NEWTON_STEPS_ON_PATCH);
    let bound = best_distance_bound_of_patch(patch, query, &best, 0.0, tolerance);
    if bound > max_distance {
        return None;
    }
    if bound >= best.distance - tolerance {
        return Some(NearestPlaceOnPatch::new(&best, bound));
    }
    let proven = f64::INFINITY;
    PatchSearch {
        patch,
        query,
        max_distance,
        tolerance,
        nearest_foot: best,
        least_settled_bound: proven,
        examined_part_count: 0,
        added_part_count: 0,
        frontier,
    }
    .find_nearest()
}

/// A search of a patch that must be split.
struct PatchSearch<'a, const N: usize> {
    patch: &'a Patch<N>,
    query: DVec3,
    max_distance: f64,
    tolerance: f64,
    nearest_foot: FootPoint,
    /// The smallest bound of the settled parts.
    least_settled_bound: f64,
    examined_part_count: usize,
    added_part_count: u32,
    frontier: &'a mut PartFrontier<N>,
}

impl<const N: usize> PatchSearch<'_, N> {
    #[cold]
    fn find_nearest(mut self) -> Option<NearestPlaceOnPatch> {
        self.frontier.clear();
        self.split_part(&PatchPart::whole_patch(self.patch));
        let Ok(left) = self.search_best_first();
        let bound = self.least_settled_bound.min(left.unwrap_or(f64::INFINITY));
        (bound <= self.max_distance).then(|| NearestPlaceOnPatch::new(&self.nearest_foot, bound))
    }

    fn split_part(&mut self, part: &PatchPart<N>) {
        part.split_part(|part| {
            let part = part.with_cheap_distance_bounds(self.query);
            let bound = part.distance_bound;
            if self.frontier.push(bound, self.added_part_count, part).is_err() {
                self.least_settled_bound = self.least_settled_bound.min(bound);
            }
            self.added_part_count += 1;
        });
    }
}

impl<const N: usize> BranchAndBound for PatchSearch<'_, N> {
    type SearchTask = PatchPart<N>;
    type TieBreakKey = u32;
    type StopReason = Infallible;

    fn frontier(&mut self) -> &mut PartFrontier<N> {
        self.frontier
    }

    fn is_bound_wanted(&mut self, bound: f64) -> bool {
        bound.min(self.least_settled_bound) <= self.max_distance
            && bound < self.nearest_foot.distance - self.tolerance
            && self.examined_part_count < MAX_PARTS_PER_PATCH
    }

    fn branch_task(&mut self, bound: f64, part: PatchPart<N>) -> Result<(), Infallible> {
        self.examined_part_count += 1;
        let local = descend_to_foot(&part.patch, self.query, DVec2::splat(0.5), MAX_NEWTON_STEPS_ON_PART);
        if local.distance < self.nearest_foot.distance {
            // Evaluated on the whole patch, because the part's control points are rounded.
            let foot = FootPoint::from_place(self.patch, self.query, part.place_in_patch(local.parameters));
            if foot.distance < self.nearest_foot.distance {
                self.nearest_foot = foot;
            }
        }
        let bound = best_distance_bound_of_patch(&part.patch, self.query, &local, bound, self.tolerance);
        if bound >= self.nearest_foot.distance - self.tolerance || part.is_too_small_to_split() {
            self.least_settled_bound = self.least_settled_bound.min(bound);
        } else {
            self.split_part(&PatchPart { distance_bound: bound, ..part });
        }
        Ok(())
    }
}

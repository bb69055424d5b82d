//! Entry points of the nearest-point query.
//!
//! Sheets are searched depth first, then by rising lower bounds (`nearest_search`). Cost: O(log n)
//! boxes and a few patches for most queries. Near a centre of curvature, the cost may reach the
//! limits of `nearest_search`.

use super::nearest_search::{NearestPointSearch, NearestSurfaceSearch};
use super::query_checks::check_query_and_distance;
use crate::{Place, Surface};
use glam::DVec3;

/// The nearest point of a surface, or a local minimum of the distance.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Closest {
    /// The place of the point.
    pub place: Place,
    /// The point.
    pub point: DVec3,
    /// The unit normal there, or its limit at a pole; zero if no normal exists. Away from open
    /// borders, the sign of (query - point) . normal tells the side of the surface.
    pub normal: DVec3,
    /// The distance of the point from the query.
    pub distance: f64,
    /// A lower bound of the distances of all points of the surface.
    pub bound: f64,
    /// True if the distance exceeds the bound by at most the tolerance, or the rounding of
    /// coordinates. False if the proof would need too many parts of patches, which happens near
    /// centres of curvature.
    pub proven: bool,
    /// True if another point is equally close within the tolerance, and its distance from this
    /// point exceeds a hundredth of the distance. A long search does not look for all such points,
    /// so a result that is not proven may be ambiguous although this is false.
    pub is_ambiguous: bool,
}

impl Surface<'_> {
    /// Returns the nearest point at most `limit` from `query`. Returns `None` if no point is that
    /// close, or if a coordinate of the query is NaN or beyond 1e150.
    ///
    /// Among points at equal distance, returns the one on the first sheet, and there in the first
    /// cell by rows.
    pub fn closest(&self, query: DVec3, limit: f64) -> Option<Closest> {
        self.closest_with_workspace(query, limit, &mut NearestPointSearch::default())
    }

    pub(super) fn closest_with_workspace(
        &self,
        query: DVec3,
        limit: f64,
        search: &mut NearestPointSearch,
    ) -> Option<Closest> {
        check_query_and_distance("limit", query, limit).ok()?;
        let tolerance = self.distance_tolerance_for(query);
        NearestSurfaceSearch { surface: self, search }.find_nearest(query, limit, tolerance);
        let best = search.incumbent.nearest_answer.filter(|best| best.distance <= limit)?;
        let (place, bound) = (best.place(), search.least_settled_bound.min(best.distance));
        Some(Closest {
            place,
            point: best.point,
            normal: if best.normal == DVec3::ZERO { self.normal(place) } else { best.normal },
            distance: best.distance,
            bound,
            proven: best.distance.is_finite() && bound >= best.distance - tolerance,
            is_ambiguous: search.incumbent.is_ambiguous(&best),
        })
    }

    /// The length to which distances from a point are proven: the tolerance, or the rounding of
    /// distances if that is larger. Rounding is a few units in the last place of the largest
    /// coordinate.
    pub(super) fn distance_tolerance_for(&self, query: DVec3) -> f64 {
        let rounding = 16.0 * f64::EPSILON * self.max_coordinate().max(query.abs().max_element());
        self.tolerance().max(rounding)
    }
}

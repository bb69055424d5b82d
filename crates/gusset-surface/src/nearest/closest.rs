//! Entry points of the nearest-point query.
//!
//! Sheet by sheet depth first, then by rising lower bounds (`nearest_search`). Cost: O(log n) boxes and a
//! few patches for most queries; near a centre of curvature up to the limits of `nearest_search`.

use super::nearest_search::{NearestSearch, SurfaceSearch};
use super::query::check;
use crate::{Place, Surface};
use glam::DVec3;

/// The nearest point of a surface, or one where the distance is locally least.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Closest {
    /// Where it is.
    pub place: Place,
    /// The point.
    pub point: DVec3,
    /// The unit normal there, or its limit at a pole; 0 if there is none. The side of the surface
    /// is the sign of (query - point) . normal, away from open borders.
    pub normal: DVec3,
    /// Its distance.
    pub distance: f64,
    /// No point of the surface is nearer than this.
    pub bound: f64,
    /// True if the bound is within the tolerance of the distance, or within the rounding of
    /// coordinates; false if the proof would take too many parts of patches, as it may where the
    /// query is a centre of curvature.
    pub proven: bool,
    /// True if another point is as near, within the tolerance, and farther from this one than a
    /// hundredth of the distance. A long search does not look for all of them: an answer that is
    /// not proven may be ambiguous without being reported so.
    pub is_ambiguous: bool,
}

impl Surface<'_> {
    /// The nearest point that is no farther than `limit`; `None` if there is none, or the query
    /// has a coordinate that is NaN or beyond 1e150.
    ///
    /// Of several at the same distance: of the first sheet, there of the first cell, by rows.
    pub fn closest(&self, query: DVec3, limit: f64) -> Option<Closest> {
        self.closest_with(query, limit, &mut NearestSearch::default())
    }

    pub(super) fn closest_with(&self, query: DVec3, limit: f64, search: &mut NearestSearch) -> Option<Closest> {
        check("limit", query, limit).ok()?;
        let tolerance = self.query_tolerance(query);
        SurfaceSearch { surface: self, search }.find(query, limit, tolerance);
        let best = search.incumbent.best.filter(|best| best.distance <= limit)?;
        let (place, bound) = (best.place(), search.settled.min(best.distance));
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

    /// The length to which distances from a point are proved: the tolerance, or the rounding of
    /// distances, a few units in the last place of the greatest coordinate.
    pub(super) fn query_tolerance(&self, query: DVec3) -> f64 {
        let rounding = 16.0 * f64::EPSILON * self.max_coordinate().max(query.abs().max_element());
        self.tolerance().max(rounding)
    }
}

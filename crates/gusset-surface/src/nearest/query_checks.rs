//! Checks of query points and distances.

use crate::line_intersection::MAX_LINE_COORDINATE;
use glam::DVec3;
use gusset_base::error::{Element, Error, Result};

/// Returns [`Error::NotFinite`] or [`Error::CoordinateTooLarge`] with the index of the query, if a
/// coordinate is not finite, or so large that its square would overflow.
pub(super) fn check_query_point(query: DVec3, index: u64) -> Result<()> {
    Error::check_magnitude(Element::Query, index, query, MAX_LINE_COORDINATE)
}

/// Checks a single query. Returns [`Error::OptionOutOfRange`] if the distance is negative or NaN.
pub(super) fn check_query_and_distance(option: &'static str, query: DVec3, distance: f64) -> Result<()> {
    check_query_point(query, 0)?;
    Error::require(distance >= 0.0, option, distance, "at least 0")
}

//! The conditions that a query point and a distance must meet.

use crate::error::{Element, Error, Result};
use crate::surface::checks::require;
use crate::surface::line_intersection::MAX_COORDINATE;
use glam::DVec3;

/// A coordinate that is NaN, or so great that its square would overflow.
pub(super) fn unusable_coordinate(query: DVec3) -> Option<f64> {
    query.to_array().into_iter().find(|x| x.is_nan() || x.abs() > MAX_COORDINATE)
}

/// [`Error::NotFinite`], or [`Error::OptionOutOfRange`] for a distance that is negative or NaN.
pub(super) fn check(option: &'static str, query: DVec3, distance: f64) -> Result<()> {
    if let Some(value) = unusable_coordinate(query) {
        return Err(Error::NotFinite { element: Element::Query, index: 0, value });
    }
    require(distance >= 0.0, option, distance)
}

//! The conditions that a query point and a distance must meet.

use crate::line_intersection::MAX_COORDINATE;
use glam::DVec3;
use gusset_base::error::{Element, Error, Result};

/// [`Error::NotFinite`] and [`Error::CoordinateTooLarge`] with the number of a query point whose
/// coordinates are no numbers, or so great that their squares would overflow.
pub(super) fn check_query(query: DVec3, index: u64) -> Result<()> {
    Error::check_finite(Element::Query, index, query)?;
    match query.to_array().into_iter().find(|x| x.abs() > MAX_COORDINATE) {
        Some(value) => Err(Error::CoordinateTooLarge { element: Element::Query, index, value }),
        None => Ok(()),
    }
}

/// The same of a single query, and [`Error::OptionOutOfRange`] for a distance that is negative or
/// NaN.
pub(super) fn check(option: &'static str, query: DVec3, distance: f64) -> Result<()> {
    check_query(query, 0)?;
    Error::require(distance >= 0.0, option, distance)
}

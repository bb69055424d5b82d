//! Checks of directions, points and levels that are given.

use crate::error::{Error, Result};
use glam::DVec3;

/// A direction's unit vector.
pub(super) fn direction(given: DVec3, option: &'static str) -> Result<DVec3> {
    finite(given, option)?;
    // Neither overflow nor underflow.
    let largest = given.abs().max_element();
    if largest > 0.0 { Ok((given / largest).normalize()) } else { Err(Error::OptionOutOfRange { option, value: 0.0 }) }
}

pub(super) fn finite(given: DVec3, option: &'static str) -> Result<()> {
    match given.to_array().into_iter().find(|x| !x.is_finite()) {
        Some(value) => Err(Error::OptionOutOfRange { option, value }),
        None => Ok(()),
    }
}

/// Levels, by whatever name, are finite and rise.
pub(super) fn rising(levels: &[f64], option: &'static str) -> Result<()> {
    let bad = levels.iter().enumerate().find(|&(k, level)| !level.is_finite() || (k > 0 && *level <= levels[k - 1]));
    match bad {
        Some((_, &value)) => Err(Error::OptionOutOfRange { option, value }),
        None => Ok(()),
    }
}

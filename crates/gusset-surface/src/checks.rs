//! Checks of arguments.

use glam::DVec3;
use gusset_base::error::{Element, Error, Result};
use std::borrow::Borrow;

/// Returns the unit vector of a direction.
pub(super) fn unit_vector(direction: DVec3, option: &'static str) -> Result<DVec3> {
    check_finite(direction, option)?;
    // Scaling first avoids overflow and underflow.
    let largest = direction.abs().max_element();
    Error::require(largest > 0.0, option, 0.0, "a vector other than 0")?;
    Ok((direction / largest).normalize())
}

pub(super) fn check_finite(vector: DVec3, option: &'static str) -> Result<()> {
    vector
        .to_array()
        .into_iter()
        .try_for_each(|x| Error::require(x.is_finite(), option, x, "finite in every coordinate"))
}

/// Checks that levels (planes, angles, values) are finite and strictly increasing.
pub(super) fn check_ascending(levels: &[f64], option: &'static str) -> Result<()> {
    let rises = |k: usize| levels[k].is_finite() && (k == 0 || levels[k] > levels[k - 1]);
    (0..levels.len()).try_for_each(|k| Error::require(rises(k), option, levels[k], "finite and above the previous one"))
}

/// Returns [`Error::NotFinite`] for the first node with a coordinate that is NaN or infinite.
pub(super) fn check_nodes_finite(nodes: impl IntoIterator<Item = impl Borrow<DVec3>>) -> Result<()> {
    (0..).zip(nodes).try_for_each(|(index, node)| Error::check_finite(Element::Node, index, *node.borrow()))
}

/// Returns the first `count` points of an array, after a check that they are finite.
pub(super) fn first_finite_points<'a>(points: &'a [DVec3], count: u64, what: &'static str) -> Result<&'a [DVec3]> {
    let Some(points) = usize::try_from(count).ok().and_then(|count| points.get(..count)) else {
        return Err(Error::ArrayTooShort { what, needed: 24 * count, given: 24 * points.len() as u64 });
    };
    check_nodes_finite(points)?;
    Ok(points)
}

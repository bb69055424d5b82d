//! Common parts of filters that cut by several planes: the parameters that place the planes.

use super::typed_param::{COORDINATE_RANGE, LENGTH_RANGE, Param, TypedParam};
use glam::DVec3;
use gusset_base::geom::Aabb;

/// The normal of parallel planes.
pub(super) const DIRECTION: TypedParam<DVec3> = Param::direction("Direction", "The normal of the planes.");

/// The number of planes.
pub(super) const NUMBER: TypedParam<u32> = Param::int("Number", "The number of planes.", [1.0, 10_000.0], &[10.0]);

/// The distance of the first plane from the origin.
pub(super) const OFFSET: TypedParam<f64> = Param::length(
    "Offset",
    "The distance of the first plane from the origin along the direction, for given planes.",
    COORDINATE_RANGE,
    &[0.0],
)
.suggested(|_, extent| Some(extent.low.z + 0.05 * extent_in_z(extent)));

/// The spacing of the planes.
pub(super) const DISTANCE: TypedParam<f64> =
    Param::length("Distance", "The spacing of the planes, for given planes.", LENGTH_RANGE, &[1.0])
        .suggested(|_, extent| Some(0.1 * extent_in_z(extent)));

/// The extent along the z axis, the default direction, which ten planes divide by default.
fn extent_in_z(extent: &Aabb) -> f64 {
    Some(extent.size().z).filter(|&height| height > 0.0).unwrap_or(extent.diagonal())
}

/// The offset of the first plane and the spacing of planes that divide a range evenly. Half a spacing
/// remains at each end.
pub(super) fn first_offset_and_spacing([from, to]: [f64; 2], number: u32) -> [f64; 2] {
    let distance = (to - from) / f64::from(number);
    [from + 0.5 * distance, distance]
}

/// Offsets at a spacing, without the offsets that rounding makes equal.
pub(super) fn offsets_at_spacing([first, distance]: [f64; 2], number: u32) -> Vec<f64> {
    let mut offsets: Vec<f64> = (0..number).map(|k| first + f64::from(k) * distance).collect();
    offsets.dedup();
    offsets
}

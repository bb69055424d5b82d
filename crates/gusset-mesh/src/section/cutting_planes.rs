//! Planes: single ones, stacks, planes about an axis, planes across a polyline.

use super::cut_stack::MAX_PLANES;
use super::exact_plane::MAX_COORDINATE;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::{Element, Error, Result};

/// A plane through a point. Points on the side of the normal are above it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Plane {
    /// A point of the plane.
    pub point: DVec3,
    /// Any length but 0.
    pub normal: DVec3,
}

/// Parallel planes.
#[derive(Debug, Clone, Copy)]
pub struct PlaneStack<'a> {
    /// A point of the plane with offset 0.
    pub point: DVec3,
    /// The common normal, of any length but 0.
    pub normal: DVec3,
    /// The distances of the planes from the point along the normal, ascending.
    pub offsets: &'a [f64],
}

impl Plane {
    pub(super) fn check(&self) -> Result<()> {
        check_vector(self.point, "point")?;
        check_direction(self.normal, "normal")
    }
}

/// Checks a point: its coordinates are finite, at most 1e150.
fn check_vector(vector: DVec3, option: &'static str) -> Result<()> {
    vector
        .to_array()
        .into_iter()
        .try_for_each(|x| Error::require(x.abs() <= MAX_COORDINATE, option, x, "at most 1e150 in every coordinate"))
}

/// Checks a direction: finite, not 0.
fn check_direction(direction: DVec3, option: &'static str) -> Result<()> {
    direction
        .to_array()
        .into_iter()
        .try_for_each(|x| Error::require(x.is_finite(), option, x, "finite in every coordinate"))?;
    Error::require(direction != DVec3::ZERO, option, 0.0, "a vector other than 0")
}

pub(super) fn check_stack(stack: &PlaneStack<'_>) -> Result<()> {
    Plane { point: stack.point, normal: stack.normal }.check()?;
    let offsets = stack.offsets;
    Error::check_count("planes", offsets.len() as u64, MAX_PLANES)?;
    let ascends = |k: usize| offsets[k].abs() <= MAX_COORDINATE && (k == 0 || offsets[k] > offsets[k - 1]);
    (0..offsets.len()).try_for_each(|k| {
        Error::require(ascends(k), "offsets", offsets[k], "at most 1e150, and above the previous one")
    })
}

/// Returns the unit vector of a direction that is not 0.
fn normalise_direction(direction: DVec3) -> DVec3 {
    // Scaling first avoids overflow and underflow.
    (direction / direction.abs().max_element()).normalize()
}

/// Returns planes that contain the axis through `point` along `axis`. The plane of an angle extends
/// from the axis in the direction of `reference`, turned about the axis by the angle (radians,
/// counter-clockwise seen against the axis). Its normal points to larger angles.
///
/// # Errors
/// [`Error::OptionOutOfRange`] if a vector is 0 or not finite, if the reference is parallel to the
/// axis, or if an angle is not finite; [`Error::OutOfMemory`].
pub fn planes_about_axis(point: DVec3, axis: DVec3, reference: DVec3, angles: &[f64]) -> Result<Vec<Plane>> {
    check_vector(point, "point")?;
    check_direction(axis, "axis")?;
    check_direction(reference, "reference")?;
    let (axis, reference) = (normalise_direction(axis), normalise_direction(reference));
    let across = axis.cross(reference);
    Error::require(across.length() > 1e-12, "reference", across.length(), "at an angle to the axis")?;
    let across = across.normalize();
    let along = across.cross(axis);
    angles.iter().try_for_each(|&angle| Error::require(angle.is_finite(), "angles", angle, "finite"))?;
    alloc::collect(angles.iter().map(|&angle| {
        let (sine, cosine) = libm::sincos(angle);
        Plane { point, normal: across * cosine - along * sine }
    }))
}

/// Returns planes across a polyline, at distances from its first point along the polyline. A plane
/// is perpendicular to the tangent: the bisector of the two segments at an inner vertex, and
/// interpolated linearly between vertices. Consecutive equal points count once. A closed polyline
/// returns to its first point.
///
/// # Errors
/// [`Error::NotFinite`] or [`Error::CoordinateTooLarge`] with the index of a point;
/// [`Error::EmptyCurve`] if the polyline has no length; [`Error::OptionOutOfRange`] if a distance
/// is not between 0 and the length; [`Error::OutOfMemory`].
pub fn planes_across_polyline(points: &[DVec3], is_closed: bool, distances: &[f64]) -> Result<Vec<Plane>> {
    for (index, point) in (0..).zip(points) {
        Error::check_magnitude(Element::Point, index, *point, MAX_COORDINATE)?;
    }
    let mut distinct: Vec<DVec3> = alloc::with_capacity(points.len() + 1)?;
    points.iter().for_each(|&point| {
        if distinct.last() != Some(&point) {
            distinct.push(point);
        }
    });
    if is_closed && distinct.len() > 1 && distinct.first() != distinct.last() {
        distinct.push(distinct[0]);
    }
    if distinct.len() < 2 {
        return Err(Error::EmptyCurve);
    }
    // The polyline's own arrays: directions of segments, distances of vertices.
    let count = distinct.len() - 1;
    let directions = alloc::collect((0..count).map(|k| normalise_direction(distinct[k + 1] - distinct[k])))?;
    let mut places = alloc::filled(0.0, count + 1)?;
    for k in 0..count {
        places[k + 1] = places[k] + distinct[k].distance(distinct[k + 1]);
    }
    let tangent_at_vertex = |k: usize| {
        let before = if k > 0 {
            k - 1
        } else if is_closed {
            count - 1
        } else {
            0
        };
        let after = if k < count {
            k
        } else if is_closed {
            0
        } else {
            count - 1
        };
        let sum = directions[before] + directions[after];
        // A polyline that turns back has no bisector: take the direction of arrival.
        if sum.length() > 1e-9 { sum.normalize() } else { directions[before] }
    };
    let length = places[count];
    distances.iter().try_for_each(|&d| Error::require((0.0..=length).contains(&d), "distances", d, 0.0..=length))?;
    alloc::collect(distances.iter().map(|&distance| {
        let k = places[1..count].partition_point(|&place| place <= distance);
        let share = (distance - places[k]) / (places[k + 1] - places[k]);
        let point = distinct[k].lerp(distinct[k + 1], share);
        let tangent = tangent_at_vertex(k).lerp(tangent_at_vertex(k + 1), share);
        // Opposite tangents at both ends cancel in the middle.
        let normal = if tangent.length() > 1e-9 { tangent.normalize() } else { directions[k] };
        Plane { point, normal }
    }))
}

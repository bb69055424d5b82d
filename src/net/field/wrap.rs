//! Maps of sheets onto a sphere, a cylinder and a torus (Deryagin, "hard" deformations: they bring
//! nodes together that the net did not glue, see [`analyse`](crate::net::analyse)). O(1) a node.

use super::map::{Field, Partial, Points, along_line, check_finite, each_point, each_point_simd};
use crate::error::{Error, Result};
use crate::net::transform::Axis;
use glam::DVec3;

/// The central projection onto a sphere. In part: along the line to the image. Undefined at the
/// centre.
///
/// # Errors
/// [`Error::OptionOutOfRange`] if a number is not finite, or the radius not above 0; as for all
/// that follow.
pub fn spherify(centre: DVec3, radius: f64) -> Result<impl Field> {
    check_finite(&centre.to_array().map(|value| ("centre", value)))?;
    Error::require(radius > 0.0 && radius.is_finite(), "radius", radius)?;
    let centre = centre.to_array();
    Ok(Partial(move |strength: f64, points: Points<'_>| {
        let map = move |point: [f64; 3]| {
            let away = [0, 1, 2].map(|k| point[k] - centre[k]);
            // Scaled first, as squares could overflow or underflow.
            let largest = away[0].abs().max(away[1].abs()).max(away[2].abs());
            let [x, y, z] = away.map(|value| value / largest);
            let ratio = radius / (x * x + y * y + z * z).sqrt();
            [centre[0] + ratio * x, centre[1] + ratio * y, centre[2] + ratio * z]
        };
        each_point_simd(points, along_line(strength, map));
    }))
}

/// Rolls space up about an axis. Of the two axes that follow it (x after z), the first becomes the
/// arc and the second the height above the cylinder; coordinates along the axis stay. In part:
/// along the line to the image.
///
/// # Errors
/// [`Error::OptionOutOfRange`].
pub fn cylinder_wrap(axis: Axis, radius: f64) -> Result<impl Field> {
    Error::require(radius > 0.0 && radius.is_finite(), "radius", radius)?;
    Ok(move |strength: f64, points: Points<'_>| {
        let map = |[u, v, w]: [f64; 3]| {
            let (sine, cosine) = libm::sincos(u / radius);
            let distance = radius + v;
            [distance * sine, distance * cosine, w]
        };
        each_point(axis.last(points), along_line(strength, map));
    })
}

/// Rolls space up to a torus about an axis. Of the two axes that follow it (x after z), the first
/// goes round the axis, and the second round the tube, from its outside towards the tip of the
/// axis; the coordinate along the axis becomes the height above the torus. `major`: from the axis
/// to the middle of the tube; `minor`: the radius of the tube. Arcs have the lengths they had at
/// these radii. In part: along the line to the image.
///
/// # Errors
/// [`Error::OptionOutOfRange`].
pub fn torus_wrap(axis: Axis, major: f64, minor: f64) -> Result<impl Field> {
    Error::require(major > 0.0 && major.is_finite(), "major", major)?;
    Error::require(minor > 0.0 && minor.is_finite(), "minor", minor)?;
    Ok(move |strength: f64, points: Points<'_>| {
        let map = |[u, v, w]: [f64; 3]| {
            let (round_sine, round_cosine) = libm::sincos(u / major);
            let (tube_sine, tube_cosine) = libm::sincos(v / minor);
            let thickness = minor + w;
            let distance = major + thickness * tube_cosine;
            [distance * round_cosine, distance * round_sine, thickness * tube_sine]
        };
        each_point(axis.last(points), along_line(strength, map));
    })
}

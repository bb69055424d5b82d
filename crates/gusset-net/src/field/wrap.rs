//! The central projection onto a sphere, and the rolling of sheets to cylinders, cones, tori and
//! spheres. These are Deryagin's "hard" deformations (Fig. 3): they bring nodes together that the
//! net does not glue, see [`analyse`](crate::analyse). O(1) a node.
//!
//! At strength t, a sheet in the plane of height 0 is bent to t times the final curvature, and arcs
//! keep their lengths. [`roll_line_to_arc`] bends a line. Each wrap consists of one or two rolls
//! and a rigid motion, which preserves lengths.

use super::space_map::{
    Field, PartlyDefinedField, PointsMut, check_parameters_finite, interpolate_to_image, map_each_point,
    map_each_point_simd,
};
use crate::transform::Axis;
use glam::DVec3;
use gusset_base::error::{Error, Result};
use std::f64::consts::{FRAC_PI_2, TAU};

/// Returns the central projection onto a sphere. At strength t, points move by t along the line to
/// their image. Undefined at the centre.
///
/// # Errors
/// [`Error::OptionOutOfRange`] if a number is not finite, or the radius is not above 0; likewise
/// for all functions below.
pub fn spherify(centre: DVec3, radius: f64) -> Result<impl Field> {
    check_parameters_finite(&centre.to_array().map(|value| ("centre", value)))?;
    check_positive("radius", radius)?;
    let centre = centre.to_array();
    Ok(PartlyDefinedField(move |strength: f64, points: PointsMut<'_>| {
        let map = move |point: [f64; 3]| {
            let away = [0, 1, 2].map(|k| point[k] - centre[k]);
            // Scaled first, because squares could overflow or underflow.
            let largest = away[0].abs().max(away[1].abs()).max(away[2].abs());
            let [x, y, z] = away.map(|value| value / largest);
            let ratio = radius / (x * x + y * y + z * z).sqrt();
            [centre[0] + ratio * x, centre[1] + ratio * y, centre[2] + ratio * z]
        };
        map_each_point_simd(points, interpolate_to_image(strength, map));
    }))
}

/// Bends space around `axis`, as a sheet is bent onto a cylinder. The next axis (x after z) becomes
/// arc length, and the axis after that becomes height above the cylinder. Coordinates along `axis`
/// stay. At strength t the curvature is t / `radius`. A sheet at height 0 keeps its lengths.
///
/// # Errors
/// [`Error::OptionOutOfRange`].
pub fn cylinder_wrap(axis: Axis, radius: f64) -> Result<impl Field> {
    check_positive("radius", radius)?;
    Ok(move |strength: f64, points: PointsMut<'_>| {
        map_each_point(axis.permute_axis_last(points), |[u, v, w]| {
            let [along, out] = roll_line_about_origin(strength, radius, [u, v]);
            [along, out, w]
        });
    })
}

/// Rolls space up to a cone around an axis. The next axis (x after z) becomes the arc of the circle
/// of the given radius, and the axis after that the height above the cone. The coordinate w along
/// the axis becomes the length along the cone's generators, which lean towards the axis by `angle`.
/// The apex is at w = radius / sin(angle); the angle 0 makes a cylinder.
///
/// At strength t, the sheet leans by t `angle` and is bent to the curvature t / `radius`, a part of
/// a cone with a smaller angle and longer generators. Generators keep their lengths, and so does
/// the circle at w = 0. The circle at w becomes 1 - (t / radius) w sin(t angle) times as long.
///
/// # Errors
/// [`Error::OptionOutOfRange`], also for an angle beyond a right one.
pub fn cone_wrap(axis: Axis, radius: f64, angle: f64) -> Result<impl Field> {
    check_positive("radius", radius)?;
    Error::require(angle.abs() <= FRAC_PI_2, "angle", angle, "from -pi / 2 to pi / 2")?;
    Ok(move |strength: f64, points: PointsMut<'_>| {
        let (sine, cosine) = libm::sincos(strength * angle);
        map_each_point(axis.permute_axis_last(points), |[u, v, w]| {
            let (height, axial) = (v * cosine - w * sine, w * cosine + v * sine);
            let [along, out] = roll_line_about_origin(strength, radius, [u, height]);
            [along, out, axial]
        });
    })
}

/// Rolls space up to a torus around an axis. The next axis (x after z) runs around the axis. The
/// axis after that runs around the tube, from its outside towards the tip of the axis. The
/// coordinate along the axis becomes the height above the torus. `major` is the distance from the
/// axis to the middle of the tube, `minor` the radius of the tube. Arcs keep the lengths that they
/// have at these radii.
///
/// Strengths t follow the stages of Fig. 3 b, d. Up to t = 1/2 the sheet rolls up to a straight
/// tube with the curvature 2 t / `minor`, and keeps all its lengths. Then the middle of the tube
/// bends to the curvature k = (2 t - 1) / `major`. The circles of the tube keep their lengths, and
/// the lines along it become 1 + k `minor` cos(v / minor) times as long. The sheet turns to its
/// place about the axis at a uniform rate.
///
/// # Errors
/// [`Error::OptionOutOfRange`].
pub fn torus_wrap(axis: Axis, major: f64, minor: f64) -> Result<impl Field> {
    check_positive("major", major)?;
    check_positive("minor", minor)?;
    Ok(move |strength: f64, points: PointsMut<'_>| {
        let [tube, ring] = split_strength_into_two_stages(strength);
        let place = RigidMotionToAxis::new(strength, major + minor);
        map_each_point(axis.permute_axis_last(points), |[u, v, w]| {
            if strength == 1.0 {
                let (round_sine, round_cosine) = libm::sincos(u / major);
                let (tube_sine, tube_cosine) = libm::sincos(v / minor);
                let thickness = minor + w;
                let distance = major + thickness * tube_cosine;
                return [distance * round_cosine, distance * round_sine, thickness * tube_sine];
            }
            let [along, height] = roll_line_to_arc(tube / minor, [v, w]);
            // The middle of the tube is the line that keeps its length.
            let [round, out] = roll_line_to_arc(ring / major, [u, height + minor]);
            place.move_point([round, along, out - minor])
        });
    })
}

/// Rolls space up to a sphere around an axis. The next axis (x after z) runs around the equator.
/// The axis after that runs along the meridians, from the equator towards the tip of the axis. The
/// coordinate along the axis becomes the height above the sphere. A sheet from 0 to 2 pi `radius`
/// and from -pi / 2 `radius` to pi / 2 `radius` covers the whole sphere.
///
/// Strengths t follow the stages of Fig. 3 a, c, e. Up to t = 1/2 the sheet rolls up to a tube as
/// long as a meridian, with the curvature 2 t / `radius`, and keeps all its lengths. Then the
/// meridians bend to the curvature q / `radius`, q = 2 t - 1, and keep their lengths. The parallel
/// at v becomes 1 - (1 - cos(q v / radius)) / q times as long, until the ends of the tube close to
/// the poles. The sheet turns to its place about the axis at a uniform rate.
///
/// # Errors
/// [`Error::OptionOutOfRange`].
pub fn sphere_wrap(axis: Axis, radius: f64) -> Result<impl Field> {
    check_positive("radius", radius)?;
    Ok(move |strength: f64, points: PointsMut<'_>| {
        let [tube, meridian] = split_strength_into_two_stages(strength);
        let place = RigidMotionToAxis::new(strength, radius);
        map_each_point(axis.permute_axis_last(points), |[u, v, w]| {
            if strength == 1.0 {
                let (round_sine, round_cosine) = libm::sincos(u / radius);
                let (sine, cosine) = libm::sincos(v / radius);
                let distance = (radius + w) * cosine;
                return [distance * round_cosine, distance * round_sine, (radius + w) * sine];
            }
            let [along, height] = roll_line_to_arc(meridian / radius, [v, w]);
            let [round, out] = roll_line_to_arc(tube / radius, [u, height]);
            place.move_point([round, along, out])
        });
    })
}

/// Bends the line of height 0 to an arc of the given curvature: the point at the length `along`, at
/// the height `out` on the convex side. The line is tangent to the arc at 0 and keeps its length.
/// The line at the height h becomes 1 + curvature h times as long.
#[inline(always)]
fn roll_line_to_arc(curvature: f64, [along, out]: [f64; 2]) -> [f64; 2] {
    // The chord of the arc has length 2 sin(half) / curvature and direction half.
    let half = 0.5 * curvature * along;
    let (half_sine, half_cosine) = libm::sincos(half);
    let (sine, cosine) = libm::sincos(2.0 * half);
    let chord = if half == 0.0 { along } else { along * (half_sine / half) };
    [chord * half_cosine + out * sine, out * cosine - chord * half_sine]
}

/// Rolls the line of height 0 about the origin to the curvature `strength` / `radius`, and moves it
/// away from the origin by `strength` times the radius.
#[inline(always)]
fn roll_line_about_origin(strength: f64, radius: f64, [along, out]: [f64; 2]) -> [f64; 2] {
    if strength == 1.0 {
        let (sine, cosine) = libm::sincos(along / radius);
        return [(radius + out) * sine, (radius + out) * cosine];
    }
    let [along, out] = roll_line_to_arc(strength / radius, [along, out]);
    [along, out + strength * radius]
}

/// Returns the progress of two successive stages, each from 0 to 1. At strength 1/2 the first stage
/// is complete and the second begins.
fn split_strength_into_two_stages(strength: f64) -> [f64; 2] {
    [(2.0 * strength).min(1.0), (2.0 * strength - 1.0).max(0.0)]
}

/// The rigid motion that takes a sheet to its place about the axis, at a given strength. It is a
/// rotation by a third of a turn about (1, 1, 1), which takes each axis to the next, and a
/// displacement along the first axis.
struct RigidMotionToAxis {
    /// The first row of the rotation; the other rows are cyclic shifts of it.
    row: [f64; 3],
    displacement: f64,
}

impl RigidMotionToAxis {
    fn new(strength: f64, displacement: f64) -> Self {
        let (sine, cosine) = libm::sincos(strength * (TAU / 3.0));
        let (rest, across) = ((1.0 - cosine) / 3.0, sine / 3.0f64.sqrt());
        let row = [(1.0 + 2.0 * cosine) / 3.0, rest - across, rest + across];
        RigidMotionToAxis { row, displacement: strength * displacement }
    }

    #[inline(always)]
    fn move_point(&self, [x, y, z]: [f64; 3]) -> [f64; 3] {
        let [a, b, c] = self.row;
        [a * x + b * y + c * z + self.displacement, c * x + a * y + b * z, b * x + c * y + a * z]
    }
}

/// Returns [`Error::OptionOutOfRange`] unless the length is finite and above 0.
fn check_positive(option: &'static str, length: f64) -> Result<()> {
    Error::require(length > 0.0 && length.is_finite(), option, length, "finite and above 0")
}

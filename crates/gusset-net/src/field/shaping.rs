//! Twist, taper, bend and shear about a coordinate axis: Barr, "Global and Local Deformations of
//! Solid Primitives", 1984.
//!
//! Conjugation by an [`Affine`](crate::transform::Affine) in the chain gives any other axis.
//! O(1) a node.

use super::space_map::{Field, PointsMut, check_parameters_finite, map_each_point, map_each_point_simd};
use crate::transform::Axis;
use gusset_base::error::{Allowed, Error, Result};

/// Returns a rotation about an axis by an angle that grows along the axis: `rate` radians for each
/// unit, right-handed, starting at the coordinate `origin`. At strength t, the angle is t times as
/// large.
///
/// # Errors
/// [`Error::OptionOutOfRange`] if a number is not finite; likewise for all functions below.
pub fn twist(axis: Axis, rate: f64, origin: f64) -> Result<impl Field> {
    check_parameters_finite(&[("rate", rate), ("origin", origin)])?;
    Ok(move |strength: f64, points: PointsMut<'_>| {
        let rate = strength * rate;
        map_each_point(axis.permute_axis_last(points), |[u, v, w]| {
            let (sine, cosine) = libm::sincos(rate * (w - origin));
            [u * cosine - v * sine, u * sine + v * cosine, w]
        });
    })
}

/// Returns a scaling across an axis that changes along the axis: distances from the axis grow by
/// `rate` times themselves for each unit, starting at the coordinate `origin`. At strength t, the
/// rate is t times as large.
///
/// # Errors
/// [`Error::OptionOutOfRange`].
pub fn taper(axis: Axis, rate: f64, origin: f64) -> Result<impl Field> {
    check_parameters_finite(&[("rate", rate), ("origin", origin)])?;
    Ok(move |strength: f64, points: PointsMut<'_>| {
        let rate = strength * rate;
        map_each_point_simd(axis.permute_axis_last(points), move |[u, v, w]| {
            let ratio = 1.0 + rate * (w - origin);
            [u * ratio, v * ratio, w]
        });
    })
}

/// Bends an axis to an arc of the given curvature, from its coordinate `from` to `to`, towards the
/// next axis (x after z). Points before `from` stay, and the axis continues straight beyond `to`.
/// Lengths along the axis are kept. At strength t, the curvature is t times as large.
///
/// # Errors
/// [`Error::OptionOutOfRange`], also if `to` is less than `from`; `to` may be infinite.
pub fn bend(axis: Axis, curvature: f64, from: f64, to: f64) -> Result<impl Field> {
    check_parameters_finite(&[("curvature", curvature), ("from", from)])?;
    Error::require(to >= from, "to", to, Allowed::AtLeast(from))?;
    Ok(move |strength: f64, points: PointsMut<'_>| {
        let curvature = strength * curvature;
        map_each_point(axis.permute_axis_last(points), |[u, v, w]| {
            let bent = w.max(from).min(to) - from;
            let (rest, half) = (w - from - bent, 0.5 * curvature * bent);
            let (sine, cosine) = libm::sincos(2.0 * half);
            // The chord of the arc has length 2 sin(half) / curvature and direction half.
            let (half_sine, half_cosine) = libm::sincos(half);
            let chord = if half == 0.0 { bent } else { bent * half_sine / half };
            let u_new = chord * half_sine + u * cosine + rest * sine;
            [u_new, v, from + chord * half_cosine - u * sine + rest * cosine]
        });
    })
}

/// Returns a displacement along one axis in proportion to the coordinate on another: the coordinate
/// `along` grows by `rate` times the coordinate `by`. At strength t, the rate is t times as large.
///
/// # Errors
/// [`Error::OptionOutOfRange`], also if both axes are equal.
pub fn shear(along: Axis, by: Axis, rate: f64) -> Result<impl Field> {
    check_parameters_finite(&[("rate", rate)])?;
    Error::require(along != by, "axis", by.index() as f64, "different from the displaced axis")?;
    Ok(move |strength: f64, [x, y, z]: PointsMut<'_>| {
        let rate = strength * rate;
        let (to, from) = match (along, by) {
            (Axis::X, Axis::Y) => (x, y),
            (Axis::X, _) => (x, z),
            (Axis::Y, Axis::X) => (y, x),
            (Axis::Y, _) => (y, z),
            (Axis::Z, Axis::X) => (z, x),
            (Axis::Z, _) => (z, y),
        };
        to.iter_mut().zip(from).for_each(|(to, from)| *to += rate * *from);
    })
}

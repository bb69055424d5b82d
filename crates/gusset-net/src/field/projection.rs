//! Projective maps: parallel and central projection onto a plane, and every other 4 x 4 matrix. At
//! strength t, points move by t along the line to their image.

use super::space_map::{
    Field, PartlyDefinedField, PointsMut, check_parameters_finite, interpolate_to_image, map_each_point_simd,
};
use glam::DVec3;
use gusset_base::error::{Error, Result};

/// (x, y, z, 1) is multiplied by `rows`, and the first three components are divided by the fourth.
/// Undefined where the fourth component is 0.
///
/// # Errors
/// [`Error::OptionOutOfRange`] if a number is not finite.
pub fn projection(rows: [[f64; 4]; 4]) -> Result<impl Field> {
    rows.as_flattened().iter().try_for_each(|&value| Error::require(value.is_finite(), "values", value, "finite"))?;
    Ok(PartlyDefinedField(move |strength: f64, points: PointsMut<'_>| {
        let map = move |[x, y, z]: [f64; 3]| {
            let [x, y, z, w] = rows.map(|[a, b, c, d]| a * x + b * y + c * z + d);
            [x / w, y / w, z / w]
        };
        map_each_point_simd(points, interpolate_to_image(strength, map));
    }))
}

/// Projects onto the plane through `point` with the given `normal`, along `direction`. The vectors
/// need not have unit length.
///
/// # Errors
/// [`Error::OptionOutOfRange`], also if the direction is parallel to the plane.
pub fn parallel_projection(point: DVec3, normal: DVec3, direction: DVec3) -> Result<impl Field> {
    let along = normal.dot(direction);
    check_parameters_finite(&[("plane", normal.dot(point)), ("direction", along)])?;
    Error::require(along != 0.0, "direction along the plane's normal", along, "other than 0")?;
    // p - d (n . (p - q)) / (n . d)
    let slope = direction / along;
    let mut rows = [[0.0, 0.0, 0.0, 1.0]; 4];
    for (k, row) in rows.iter_mut().enumerate().take(3) {
        let [a, b, c] = (DVec3::AXES[k] - slope[k] * normal).to_array();
        *row = [a, b, c, slope[k] * normal.dot(point)];
    }
    projection(rows)
}

/// Projects onto the plane through `point` with the given `normal`, along the lines through `eye`.
/// Points behind the eye have inverted images. Points as high above the plane as the eye lack an
/// image.
///
/// # Errors
/// [`Error::OptionOutOfRange`], also if the eye is in the plane.
pub fn perspective_projection(eye: DVec3, point: DVec3, normal: DVec3) -> Result<impl Field> {
    // The normal times the vector from the eye to the plane. A matrix would cancel terms as large
    // as the squared distance from the origin.
    let depth = normal.dot(point - eye);
    Error::require(depth != 0.0, "distance of eye from the plane", depth, "other than 0")?;
    check_parameters_finite(&[("plane", depth)])?;
    check_parameters_finite(&eye.to_array().map(|value| ("eye", value)))?;
    check_parameters_finite(&normal.to_array().map(|value| ("normal", value)))?;
    Ok(PartlyDefinedField(move |strength: f64, points: PointsMut<'_>| {
        let map = move |point: [f64; 3]| {
            let ray = DVec3::from_array(point) - eye;
            (eye + ray * (depth / normal.dot(ray))).to_array()
        };
        map_each_point_simd(points, interpolate_to_image(strength, map));
    }))
}

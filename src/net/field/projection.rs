//! Projective maps: parallel and central projection onto a plane, and every other 4 x 4 matrix.

use super::map::{Field, Points, along_line, check_finite, each_point_simd};
use crate::error::{Error, Result};
use glam::DVec3;

/// A projective map: (x, y, z, 1) is multiplied by `rows`, and the first three components are
/// divided by the fourth. In part: along the line to the image. Undefined where the fourth
/// component is 0.
#[derive(Debug, Clone, Copy)]
pub struct Projection {
    map: Map,
}

#[derive(Debug, Clone, Copy)]
enum Map {
    Rows([[f64; 4]; 4]),
    /// Central projection; `depth`: the normal times the vector from the eye to the plane. As a
    /// matrix, terms as large as the squared distance from the origin would have to cancel.
    Central {
        eye: DVec3,
        normal: DVec3,
        depth: f64,
    },
}

impl Projection {
    /// # Errors
    /// [`Error::OptionOutOfRange`] if a number is not finite.
    pub fn new(rows: [[f64; 4]; 4]) -> Result<Self> {
        match rows.into_iter().flatten().find(|value| !value.is_finite()) {
            Some(value) => Err(Error::OptionOutOfRange { option: "matrix", value }),
            None => Ok(Projection { map: Map::Rows(rows) }),
        }
    }

    /// Onto the plane through `point` with the given `normal`, along `direction`. Neither need be a
    /// unit vector.
    ///
    /// # Errors
    /// [`Error::OptionOutOfRange`], also if the direction is parallel to the plane.
    pub fn parallel(point: DVec3, normal: DVec3, direction: DVec3) -> Result<Self> {
        let along = normal.dot(direction);
        check_finite(&[("plane", normal.dot(point)), ("direction", along)])?;
        if along == 0.0 {
            return Err(Error::OptionOutOfRange { option: "direction", value: along });
        }
        // p - d (n . (p - q)) / (n . d)
        let slope = direction / along;
        let mut rows = [[0.0, 0.0, 0.0, 1.0]; 4];
        for (k, row) in rows.iter_mut().enumerate().take(3) {
            let [a, b, c] = (DVec3::AXES[k] - slope[k] * normal).to_array();
            *row = [a, b, c, slope[k] * normal.dot(point)];
        }
        Self::new(rows)
    }

    /// Onto the plane through `point` with the given `normal`, along the lines through `eye`.
    /// Points behind the eye have inverted images; those as high above the plane as the eye have
    /// none.
    ///
    /// # Errors
    /// [`Error::OptionOutOfRange`], also if the eye is in the plane.
    pub fn perspective(eye: DVec3, point: DVec3, normal: DVec3) -> Result<Self> {
        let depth = normal.dot(point - eye);
        if depth == 0.0 {
            return Err(Error::OptionOutOfRange { option: "eye", value: depth });
        }
        check_finite(&[("plane", depth)])?;
        check_finite(&eye.to_array().map(|value| ("eye", value)))?;
        check_finite(&normal.to_array().map(|value| ("normal", value)))?;
        Ok(Projection { map: Map::Central { eye, normal, depth } })
    }
}

impl Field for Projection {
    fn map(&self, strength: f64, points: Points<'_>) {
        match self.map {
            Map::Rows(rows) => {
                let map = |[x, y, z]: [f64; 3]| {
                    let [x, y, z, w] = rows.map(|[a, b, c, d]| a * x + b * y + c * z + d);
                    [x / w, y / w, z / w]
                };
                each_point_simd(points, along_line(strength, map));
            }
            Map::Central { eye, normal, depth } => {
                let map = |point: [f64; 3]| {
                    let ray = DVec3::from_array(point) - eye;
                    (eye + ray * (depth / normal.dot(ray))).to_array()
                };
                each_point_simd(points, along_line(strength, map));
            }
        }
    }

    fn is_total(&self) -> bool {
        false
    }
}

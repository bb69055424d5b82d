//! Projections: parallel, perspective, and every other map that takes lines to lines.

use super::{Field, Points, each_point_widely, finite, partly};
use crate::error::{Error, Result};
use glam::DVec3;

/// A map of homogeneous coordinates: (x, y, z, 1) goes to `rows` times itself, and the first three are divided by the fourth. In
/// part: that part of the straight way. Not defined where the fourth is 0.
#[derive(Debug, Clone, Copy)]
pub struct Projection {
    rows: [[f64; 4]; 4],
}

impl Projection {
    /// # Errors
    /// [`Error::OptionOutOfRange`] if a number is not finite.
    pub fn new(rows: [[f64; 4]; 4]) -> Result<Self> {
        match rows.into_iter().flatten().find(|value| !value.is_finite()) {
            Some(value) => Err(Error::OptionOutOfRange { option: "matrix", value }),
            None => Ok(Projection { rows }),
        }
    }

    /// Onto the plane through `point` with the given `normal`, along `direction`. Neither need be a unit vector.
    ///
    /// # Errors
    /// [`Error::OptionOutOfRange`], also if the direction is parallel to the plane.
    pub fn parallel(point: DVec3, normal: DVec3, direction: DVec3) -> Result<Self> {
        let along = normal.dot(direction);
        finite(&[("plane", normal.dot(point)), ("direction", along)])?;
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

    /// Onto the plane through `point` with the given `normal`, along the lines through `eye`. Points behind the eye come out on the
    /// plane too, turned round; those as high above the plane as the eye have no image.
    ///
    /// # Errors
    /// [`Error::OptionOutOfRange`], also if the eye is in the plane.
    pub fn perspective(eye: DVec3, point: DVec3, normal: DVec3) -> Result<Self> {
        let depth = normal.dot(point - eye);
        if depth == 0.0 {
            return Err(Error::OptionOutOfRange { option: "eye", value: depth });
        }
        // eye + (p - eye) depth / (n . (p - eye))
        let height = normal.dot(eye);
        let mut rows = [[normal.x, normal.y, normal.z, -height]; 4];
        for (k, row) in rows.iter_mut().enumerate().take(3) {
            let [a, b, c] = (eye[k] * normal + depth * DVec3::AXES[k]).to_array();
            *row = [a, b, c, -eye[k] * (height + depth)];
        }
        Self::new(rows)
    }
}

impl Field for Projection {
    fn map(&self, strength: f64, points: Points<'_>) {
        let map = |[x, y, z]: [f64; 3]| {
            let [x, y, z, w] = self.rows.map(|[a, b, c, d]| a * x + b * y + c * z + d);
            [x / w, y / w, z / w]
        };
        each_point_widely(points, partly(strength, map));
    }

    fn is_total(&self) -> bool {
        false
    }
}

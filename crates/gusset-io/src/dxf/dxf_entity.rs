//! Entities, and transforms of their coordinates.

use super::dxf_pairs::{Pair, PairReader};
use crate::error::ReadError;
use crate::outline_pen::Vector;
use crate::text::{integer, number};

/// The group codes of an entity up to the next one.
#[derive(Default)]
pub(super) struct Entity<'a> {
    pub(super) kind: &'a [u8],
    pub(super) pairs: Vec<Pair<'a>>,
}

impl<'a> Entity<'a> {
    /// Reads what follows the kind of an entity, up to the kind of the next one, which it returns.
    pub(super) fn read(&mut self, kind: &'a [u8], reader: &mut PairReader<'a>) -> Result<Option<&'a [u8]>, ReadError> {
        self.kind = kind;
        self.pairs.clear();
        while let Some(pair) = reader.next()? {
            if pair.code == 0 {
                return Ok(Some(pair.value));
            }
            self.pairs.try_reserve(1)?;
            self.pairs.push(pair);
        }
        Ok(None)
    }

    pub(super) fn text_of_code(&self, code: i32) -> Option<&'a [u8]> {
        self.pairs.iter().find(|pair| pair.code == code).map(|pair| pair.value)
    }

    pub(super) fn number_of_code(&self, code: i32) -> Option<f64> {
        self.text_of_code(code).and_then(number)
    }

    /// Returns an integer, or 0 if there is none.
    pub(super) fn integer_of_code(&self, code: i32) -> i64 {
        self.text_of_code(code).and_then(integer).unwrap_or(0)
    }

    /// Returns the point whose x has a code. The codes of y and z are greater by 10 and 20. Missing numbers are 0.
    pub(super) fn point_of_code(&self, code: i32) -> Vector {
        [code, code + 10, code + 20].map(|code| self.number_of_code(code).unwrap_or(0.0))
    }

    /// Returns the system of coordinates that belongs to the extrusion direction.
    pub(super) fn object_frame(&self) -> Frame {
        if self.number_of_code(210).is_none()
            && self.number_of_code(220).is_none()
            && self.number_of_code(230).is_none()
        {
            return Frame::IDENTITY;
        }
        Frame::from_extrusion(self.point_of_code(210))
    }
}

/// An affine map: images of the axes, and of the origin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Frame {
    pub(super) axes: [Vector; 3],
    pub(super) origin: Vector,
}

impl Frame {
    pub(super) const IDENTITY: Self =
        Self { axes: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], origin: [0.0; 3] };

    /// Makes the axes of an extrusion direction by Autodesk's "arbitrary axis algorithm".
    fn from_extrusion(direction: Vector) -> Self {
        const LARGEST_NEAR_Z: f64 = 1.0 / 64.0;
        let Some(z) = unit_vector(direction) else { return Self::IDENTITY };
        let is_near_z = z[0].abs() < LARGEST_NEAR_Z && z[1].abs() < LARGEST_NEAR_Z;
        let helper = if is_near_z { [0.0, 1.0, 0.0] } else { [0.0, 0.0, 1.0] };
        let Some(x) = unit_vector(cross(helper, z)) else { return Self::IDENTITY };
        Self { axes: [x, cross(z, x), z], origin: [0.0; 3] }
    }

    pub(super) fn map_vector(&self, vector: Vector) -> Vector {
        [0, 1, 2].map(|axis| (0..3).map(|part| vector[part] * self.axes[part][axis]).sum())
    }

    pub(super) fn map_point(&self, point: Vector) -> Vector {
        let turned = self.map_vector(point);
        [0, 1, 2].map(|axis| turned[axis] + self.origin[axis])
    }

    /// Returns the map that applies `inner` first.
    pub(super) fn compose_after(&self, inner: &Self) -> Self {
        Self { axes: inner.axes.map(|axis| self.map_vector(axis)), origin: self.map_point(inner.origin) }
    }

    pub(super) fn translation(origin: Vector) -> Self {
        Self { origin, ..Self::IDENTITY }
    }

    /// Makes the map that scales and then turns about z.
    pub(super) fn scaled_rotation(scales: Vector, degrees: f64) -> Self {
        let (sin, cos) = sin_cos_degrees(degrees);
        let axes =
            [[scales[0] * cos, scales[0] * sin, 0.0], [-scales[1] * sin, scales[1] * cos, 0.0], [0.0, 0.0, scales[2]]];
        Self { axes, origin: [0.0; 3] }
    }
}

/// Returns the sine and cosine of an angle in degrees. Quarter turns are exact.
fn sin_cos_degrees(degrees: f64) -> (f64, f64) {
    match degrees.rem_euclid(360.0) {
        0.0 => (0.0, 1.0),
        90.0 => (1.0, 0.0),
        180.0 => (0.0, -1.0),
        270.0 => (-1.0, 0.0),
        _ => degrees.to_radians().sin_cos(),
    }
}

pub(super) fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

pub(super) fn unit_vector(vector: Vector) -> Option<Vector> {
    let length = vector.iter().map(|part| part * part).sum::<f64>().sqrt();
    (length > 0.0 && length.is_finite()).then(|| vector.map(|part| part / length))
}

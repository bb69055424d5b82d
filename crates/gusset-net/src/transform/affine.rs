//! Affine maps: Deryagin's T, R, S and C ("Spatial operations"), and all others. O(1).

use glam::{DAffine3, DMat3, DVec3};
use gusset_base::error::{Error, Result};

/// An axis of coordinates.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Axis {
    /// The abscissa.
    X,
    /// The ordinate.
    Y,
    /// The applicate.
    Z,
}

impl Axis {
    /// 0, 1 or 2.
    pub fn index(self) -> usize {
        self as usize
    }

    /// Cyclically permutes a triple by axis so that this axis is the last.
    pub(crate) fn permute_axis_last<T>(self, [x, y, z]: [T; 3]) -> [T; 3] {
        match self {
            Axis::X => [y, z, x],
            Axis::Y => [z, x, y],
            Axis::Z => [x, y, z],
        }
    }
}

/// The sense of a rotation.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum RotationSense {
    /// Right-handed: anticlockwise seen from the tip of the axis.
    #[default]
    RightHanded,
    /// Left-handed, as printed: the paper's formula is written for row vectors and applied to
    /// columns.
    AsPrinted,
}

/// An affine map of finite numbers: a 3 x 3 matrix and a displacement.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Affine(DAffine3);

impl Affine {
    /// The identity.
    pub const IDENTITY: Affine = Affine(DAffine3::IDENTITY);

    /// Creates any affine map: (x, y, z) maps to `rows` times (x, y, z, 1).
    ///
    /// # Errors
    /// [`Error::OptionOutOfRange`] if a number is not finite.
    pub fn new(rows: [[f64; 4]; 3]) -> Result<Self> {
        let [x, y, z] = rows.map(|[a, b, c, _]| DVec3::new(a, b, c));
        let displacement = DVec3::from_array(rows.map(|row| row[3]));
        Self::from_linear_and_displacement(DMat3::from_cols(x, y, z).transpose(), displacement)
    }

    /// Returns the paper's T(c): a translation.
    ///
    /// # Errors
    /// [`Error::OptionOutOfRange`] if a number is not finite; likewise for all functions below.
    pub fn translation(by: DVec3) -> Result<Self> {
        Self::from_linear_and_displacement(DMat3::IDENTITY, by)
    }

    /// Returns the paper's R(V, alpha), Rodrigues' formula, about the axis through `pivot` (the
    /// origin in the paper). The axis need not be a unit vector. `angle` is in radians.
    ///
    /// # Errors
    /// Also [`Error::OptionOutOfRange`] if the axis is zero.
    pub fn rotation(axis: DVec3, angle: f64, pivot: DVec3, sense: RotationSense) -> Result<Self> {
        // Scaled first, so that the length does not overflow or underflow.
        let unit = (axis / axis.abs().max_element()).normalize();
        Error::require(unit.is_finite(), "axis", axis.length(), "a finite vector other than 0")?;
        let (sine, cosine) = libm::sincos(if sense == RotationSense::AsPrinted { -angle } else { angle });
        let outer = DMat3::from_cols(unit * unit.x, unit * unit.y, unit * unit.z);
        let cross = DMat3::from_cols(
            DVec3::new(0.0, unit.z, -unit.y),
            DVec3::new(-unit.z, 0.0, unit.x),
            DVec3::new(unit.y, -unit.x, 0.0),
        );
        let linear = DMat3::from_diagonal(DVec3::splat(cosine)) + outer * (1.0 - cosine) + cross * sine;
        Self::from_linear_and_displacement(linear, pivot - linear * pivot)
    }

    /// Returns the paper's S(k): scales distances from the origin by `ratio`. Negative ratios
    /// mirror.
    ///
    /// # Errors
    /// [`Error::OptionOutOfRange`].
    pub fn scaling(ratio: f64) -> Result<Self> {
        Self::stretching(DVec3::splat(ratio))
    }

    /// Returns the paper's C(k): scales distances from a coordinate axis by `ratio`. Points on the
    /// axis stay, and distances along the axis are kept.
    ///
    /// # Errors
    /// [`Error::OptionOutOfRange`].
    pub fn compression(axis: Axis, ratio: f64) -> Result<Self> {
        let mut ratios = DVec3::splat(ratio);
        ratios[axis.index()] = 1.0;
        Self::stretching(ratios)
    }

    /// Scales each coordinate by its own ratio.
    ///
    /// # Errors
    /// [`Error::OptionOutOfRange`].
    pub fn stretching(ratios: DVec3) -> Result<Self> {
        Self::from_linear_and_displacement(DMat3::from_diagonal(ratios), DVec3::ZERO)
    }

    fn from_linear_and_displacement(linear: DMat3, displacement: DVec3) -> Result<Self> {
        let map = Affine(DAffine3::from_mat3_translation(linear, displacement));
        map.rows()
            .as_flattened()
            .iter()
            .try_for_each(|&value| Error::require(value.is_finite(), "values", value, "finite"))?;
        Ok(map)
    }

    /// Returns the composition: this map, then another.
    ///
    /// # Errors
    /// [`Error::OptionOutOfRange`] if the product overflows.
    pub fn then(&self, next: &Affine) -> Result<Self> {
        let DAffine3 { matrix3, translation } = next.0 * self.0;
        Self::from_linear_and_displacement(matrix3, translation)
    }

    /// Returns the rows.
    pub fn rows(&self) -> [[f64; 4]; 3] {
        [0, 1, 2].map(|k| self.0.matrix3.row(k).extend(self.0.translation[k]).to_array())
    }

    /// Returns the ratio of volumes; negative if the map mirrors.
    pub fn determinant(&self) -> f64 {
        self.0.matrix3.determinant()
    }

    /// Returns true if the map reverses orientation, even where the ratio of volumes overflows or
    /// underflows.
    pub fn is_mirroring(&self) -> bool {
        is_orientation_reversing(self.0.matrix3)
    }

    /// Returns the image of a point.
    pub fn apply(&self, point: DVec3) -> DVec3 {
        self.0.transform_point3(point)
    }
}

/// Returns true if a matrix reverses orientation.
pub(crate) fn is_orientation_reversing(matrix: DMat3) -> bool {
    // Rows, then columns, are scaled by powers of two, which is exact and keeps the sign.
    let scaled = |vector: DVec3| {
        let (_, exponent) = libm::frexp(vector.abs().max_element());
        DVec3::from_array(vector.to_array().map(|value| libm::ldexp(value, -exponent)))
    };
    let [x, y, z] = [0, 1, 2].map(|k| scaled(matrix.row(k)));
    let columns = DMat3::from_cols(x, y, z).transpose();
    let [x, y, z] = [columns.x_axis, columns.y_axis, columns.z_axis].map(scaled);
    DMat3::from_cols(x, y, z).determinant() < 0.0
}

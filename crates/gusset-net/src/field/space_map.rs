//! Maps of space, and loops over points that vectorise where the map is plain arithmetic. O(1) a
//! point.

use crate::transform::Affine;
use gusset_base::error::{Error, Result};
use gusset_base::simd::{self, Kernel};

/// Points to move: their x, y and z, slices of equal length.
pub type PointsMut<'a> = [&'a mut [f64]; 3];

/// A map of space.
pub trait Field: Sync {
    /// Moves each point independently. `strength` is 1 for the whole map and never 0; each field
    /// defines its meaning for values between 0 and 1, and beyond. A point outside the field's
    /// domain becomes NaN.
    fn map_points(&self, strength: f64, points: PointsMut<'_>);

    /// Returns true if finite points stay finite, except by overflow.
    fn is_defined_everywhere(&self) -> bool {
        true
    }
}

/// A function of strength and points is a total field.
impl<F: Fn(f64, PointsMut<'_>) + Sync> Field for F {
    fn map_points(&self, strength: f64, points: PointsMut<'_>) {
        self(strength, points);
    }
}

/// Marks a field that is undefined at some points, which become NaN.
pub(super) struct PartlyDefinedField<F>(pub(super) F);

impl<F: Field> Field for PartlyDefinedField<F> {
    fn map_points(&self, strength: f64, points: PointsMut<'_>) {
        self.0.map_points(strength, points);
    }

    fn is_defined_everywhere(&self) -> bool {
        false
    }
}

/// Applies `map` to each point; for maps with function calls, which do not vectorise.
#[inline(always)]
pub(super) fn map_each_point([x, y, z]: PointsMut<'_>, map: impl Fn([f64; 3]) -> [f64; 3]) {
    map_coordinates(x, y, z, map);
}

/// Applies `map` to each point; for maps of plain arithmetic, which vectorise.
pub(super) fn map_each_point_simd(points: PointsMut<'_>, map: impl Fn([f64; 3]) -> [f64; 3]) {
    simd::run(MapEachPointKernel { points, map });
}

struct MapEachPointKernel<'a, F> {
    points: PointsMut<'a>,
    map: F,
}

impl<F: Fn([f64; 3]) -> [f64; 3]> Kernel for MapEachPointKernel<'_, F> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        map_each_point(self.points, self.map);
    }
}

/// This is a separate function, because only arguments are known not to alias.
#[inline(always)]
fn map_coordinates(x: &mut [f64], y: &mut [f64], z: &mut [f64], map: impl Fn([f64; 3]) -> [f64; 3]) {
    for ((x, y), z) in x.iter_mut().zip(y).zip(z) {
        [*x, *y, *z] = map([*x, *y, *z]);
    }
}

/// Returns the point at parameter `strength` on the line from a point to its image.
pub(super) fn interpolate_to_image(strength: f64, map: impl Fn([f64; 3]) -> [f64; 3]) -> impl Fn([f64; 3]) -> [f64; 3] {
    move |from| {
        let to = map(from);
        // At strength 1, avoid further rounding.
        if strength == 1.0 { to } else { [0, 1, 2].map(|k| from[k] + strength * (to[k] - from[k])) }
    }
}

/// Returns [`Error::OptionOutOfRange`] for the first parameter that is not finite.
pub(super) fn check_parameters_finite(parameters: &[(&'static str, f64)]) -> Result<()> {
    parameters.iter().try_for_each(|&(option, value)| Error::require(value.is_finite(), option, value, "finite"))
}

/// At strength t, points move by t along the line to their image.
impl Field for Affine {
    fn map_points(&self, strength: f64, points: PointsMut<'_>) {
        let rows = self.rows();
        map_each_point_simd(
            points,
            interpolate_to_image(strength, |[x, y, z]| rows.map(|[a, b, c, d]| a * x + b * y + c * z + d)),
        );
    }
}

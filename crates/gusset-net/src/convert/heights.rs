//! Nets of height fields. O(nodes).

use crate::arrange::build_matrices;
use crate::{Coordinates, Net, Real, Shape, Sides, Topology, XyzMatrices, each};
use glam::DVec3;
use gusset_base::error::{Error, Result};
use gusset_base::job::Job;

/// A height field, as in digital elevation models.
#[derive(Debug, Clone, Copy)]
pub struct Heights<'a, T> {
    /// The size.
    pub shape: Shape,
    /// Row after row.
    pub values: &'a [T],
    /// Numbers from row to row; 0 for rows without gaps.
    pub stride: usize,
    /// The step from column to column (x) and from row to row (y), which is negative for rows from
    /// north to south. Neither may be 0.
    pub spacing: [f64; 2],
    /// The position of the first node at height 0.
    pub origin: DVec3,
    /// The number that marks a missing height. NaN and infinities always mark one.
    pub no_data: Option<f64>,
}

/// Returns the net of a height field, in its scalar type: x = origin + j spacing, y = origin + i
/// spacing, z = origin + height. Missing heights become missing nodes. Faces are counter-clockwise
/// seen from above, for either sign of the spacing. O(nodes).
///
/// # Errors
/// - [`Error::StrideTooSmall`], [`Error::ArrayTooShort`], [`Error::SizeOverflow`].
/// - [`Error::OptionOutOfRange`]: the spacing or origin is not finite, or neighbouring nodes
///   coincide in the type of the heights.
/// - [`Error::OutOfMemory`], [`Error::Cancelled`].
pub fn net_of_heights<T: Real>(heights: &Heights<'_, T>, job: &Job<'_>) -> Result<Net<'static>>
where
    Coordinates<'static>: From<XyzMatrices<'static, T>>,
{
    let Heights { shape, values, stride, spacing: [dx, dy], origin, no_data } = *heights;
    [dx, dy]
        .into_iter()
        .try_for_each(|step| Error::require(step.is_finite() && step != 0.0, "spacing", step, "finite and not 0"))?;
    origin
        .to_array()
        .into_iter()
        .try_for_each(|value| Error::require(value.is_finite(), "origin", value, "finite in every coordinate"))?;
    // Neighbours must differ, and be finite, in the type of the heights.
    for (origin, step, count) in [(origin.x, dx, shape.columns()), (origin.y, dy, shape.rows())] {
        let at = |k: usize| T::from_f64(origin + k as f64 * step);
        let are_apart = at(0) != at(1) && at(count - 2) != at(count - 1);
        Error::require(
            are_apart && at(count - 1).into().is_finite(),
            "spacing",
            step,
            "large enough to separate neighbours in the type of the heights",
        )?;
    }
    let no_data = no_data.map(|value| T::from_f64(value).into());
    let needed = XyzMatrices::<T>::matrix_length(shape, stride)?;
    if values.len() < needed {
        let (needed, given) = ((needed * size_of::<T>()) as u64, size_of_val(values) as u64);
        return Err(Error::ArrayTooShort { what: "heights", needed, given });
    }
    let columns = shape.columns();
    let stride = if stride == 0 { columns } else { stride };
    let matrices = build_matrices(shape, job, |axis, rows, to: &mut [T]| {
        for (i, to) in rows.zip(to.chunks_exact_mut(columns)) {
            match axis {
                0 => to.iter_mut().enumerate().for_each(|(j, x)| *x = T::from_f64(origin.x + j as f64 * dx)),
                1 => to.fill(T::from_f64(origin.y + i as f64 * dy)),
                _ => {
                    let from = &values[i * stride..][..columns];
                    to.iter_mut()
                        .zip(from)
                        .for_each(|(z, &h)| *z = T::from_f64(origin.z + height_or_nan(h.into(), no_data)));
                }
            }
        }
    })?;
    let topology = Topology::from_sides(shape, Sides::SHEET).with_reversed((dx < 0.0) != (dy < 0.0));
    Ok(Net::new(Coordinates::from(matrices), topology))
}

/// Returns the height, or NaN if it is missing.
fn height_or_nan(value: f64, no_data: Option<f64>) -> f64 {
    if value.is_finite() && no_data != Some(value) { value } else { f64::NAN }
}

impl Net<'_> {
    /// Makes every node missing that has the coordinate `value`, rounded to the scalar type.
    /// O(nodes).
    pub fn clear_no_data(&mut self, value: f64) {
        each!(self.coordinates_mut(), planes => clear_nodes_with_value(planes, value));
    }
}

fn clear_nodes_with_value<T: Real>(planes: &mut XyzMatrices<'_, T>, value: f64) {
    let value = T::from_f64(value);
    for i in 0..planes.shape().rows() {
        let [x, y, z] = planes.row_mut(i);
        for ((x, y), z) in x.iter_mut().zip(y).zip(z) {
            if [*x, *y, *z].contains(&value) {
                [*x, *y, *z] = [T::from_f64(f64::NAN); 3];
            }
        }
    }
}

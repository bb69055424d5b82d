//! The grid that coordinates are rounded to.
//!
//! The step follows from the number of bits and the bounding box. But a scanner often has a step of its own: if the coordinates of
//! an axis already lie at equal distances, larger than the step that is asked for, their own step is taken; they are then the
//! more exact and take fewer bits.

use super::levels::{Bits, Grid, Levels};
use crate::alloc;
use crate::error::{Error, Result};
use crate::net::Planes;

/// How many numbers are looked at to find the step that coordinates have of their own.
const LOOKED_AT: usize = 4096;

/// The grid of `bits` bits for the nodes that are not missing: one step for all axes, or one each.
///
/// # Errors
/// [`Error::OptionOutOfRange`] for coordinates too large for differences of them, [`Error::OutOfMemory`].
pub(super) fn grid<T: Bits>(planes: &Planes<'_, T>, bits: u32, per_axis: bool) -> Result<Grid> {
    let last = (1i64 << bits) - 1;
    let [least, most] = bounds(planes);
    let largest = least.iter().chain(&most).fold(0.0, |largest: f64, x| largest.max(x.abs()));
    if largest > f64::MAX / 4.0 {
        return Err(Error::OptionOutOfRange { option: "coordinates", value: largest });
    }
    let extents: [f64; 3] = std::array::from_fn(|axis| most[axis] - least[axis]);
    let whole = extents.iter().fold(0.0, |whole: f64, &extent| whole.max(extent));
    let step = |axis: usize| {
        let step = if per_axis { extents[axis] } else { whole } / last as f64;
        // Below, numbers have fewer digits and quotients are not exact.
        if step > 0.0 { step.max(1e-290) } else { 1.0 }
    };
    let mut grid = Grid { origin: least, step: std::array::from_fn(step), last };
    for axis in 0..3 {
        if let Some((origin, step)) = own_step(planes, axis, grid.step[axis])? {
            let finer = Grid {
                origin: std::array::from_fn(|k| if k == axis { origin } else { grid.origin[k] }),
                step: std::array::from_fn(|k| if k == axis { step } else { grid.step[k] }),
                last,
            };
            if is_exact_enough(planes, axis, &finer, grid.step[axis] / 2.0) {
                grid = finer;
            }
        }
    }
    Ok(grid)
}

/// The bounding box of the nodes that are not missing; zeros if there are none.
fn bounds<T: Bits>(planes: &Planes<'_, T>) -> [[f64; 3]; 2] {
    let mut bounds = [[f64::INFINITY; 3], [f64::NEG_INFINITY; 3]];
    for i in 0..planes.shape().rows() {
        let [x, y, z] = planes.row(i);
        for ((&x, &y), &z) in x.iter().zip(y).zip(z) {
            let node: [f64; 3] = [x.into(), y.into(), z.into()];
            // The sum is finite if all three are, or too large to be taken.
            if (node[0] * 0.25 + node[1] * 0.25 + node[2] * 0.25).is_finite() {
                for (axis, value) in node.into_iter().enumerate() {
                    bounds[0][axis] = if value < bounds[0][axis] { value } else { bounds[0][axis] };
                    bounds[1][axis] = if value > bounds[1][axis] { value } else { bounds[1][axis] };
                }
            }
        }
    }
    if bounds[0][0] > bounds[1][0] { [[0.0; 3]; 2] } else { bounds }
}

/// First coordinate and distance, if some of the coordinates of an axis lie at equal distances larger than `step`.
fn own_step<T: Bits>(planes: &Planes<'_, T>, axis: usize, step: f64) -> Result<Option<(f64, f64)>> {
    let (w, count) = (planes.shape().columns(), planes.shape().node_count());
    let mut found: Vec<f64> = alloc::with_capacity(LOOKED_AT)?;
    // An odd distance visits all columns.
    let every = count.div_ceil(LOOKED_AT) | 1;
    for at in (0..count).step_by(every) {
        let value: f64 = planes.row(at / w)[axis][at % w].into();
        if value.is_finite() {
            found.push(value);
        }
    }
    found.sort_unstable_by(f64::total_cmp);
    let near = step / 8.0;
    found.dedup_by(|next, first| *next - *first <= near);
    let least = found.windows(2).map(|pair| pair[1] - pair[0]).fold(f64::INFINITY, f64::min);
    if found.len() < 3 || least < 1.25 * step {
        return Ok(None);
    }
    // The distance becomes the more exact the farther it is measured.
    let (mut distance, mut steps) = (least, 0.0);
    for pair in found.windows(2) {
        steps += libm::rint((pair[1] - pair[0]) / distance);
        distance = (pair[1] - found[0]) / steps;
    }
    Ok(Some((found[0] - distance * libm::rint((found[0] - bounds(planes)[0][axis]) / distance), distance)))
}

/// True if no coordinate of an axis is off by more than `tolerance` once it is rounded to the grid.
fn is_exact_enough<T: Bits>(planes: &Planes<'_, T>, axis: usize, grid: &Grid, tolerance: f64) -> bool {
    (0..planes.shape().rows()).all(|i| {
        planes.row(i)[axis].iter().all(|&number| {
            let value: f64 = number.into();
            let rounded: Option<T> = grid.number(axis, Levels::<T>::level(grid, axis, number));
            !value.is_finite() || rounded.is_some_and(|rounded| (rounded.into() - value).abs() <= tolerance)
        })
    })
}

//! The choice of quantisation levels.
//!
//! The step follows from the number of bits and the bounding box. Scanners often have an intrinsic
//! step. If the coordinates of an axis already lie in equal steps larger than the requested one,
//! the intrinsic step is used, which is more accurate and takes fewer bits. O(nodes).
//!
//! Tiles of one net that are coded apart need common levels: then nodes that tiles share stay equal.
//! The caller gives these levels by a box around all tiles.

use super::levels::{CoordinateBits, LevelMap, UniformLevels};
use crate::XyzMatrices;
use gusset_base::alloc;
use gusset_base::error::{Allowed, Error, Result};

/// Levels for all tiles of a large net. Tiles that are coded apart, with equal boxes, stay equal in
/// the nodes that they share.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LevelBox {
    /// The smallest coordinates of all tiles: level 0.
    pub low: [f64; 3],
    /// The largest coordinates of all tiles.
    pub high: [f64; 3],
    /// The distance of levels on all axes, instead of the one by the bits. The stream then has the
    /// least number of bits from 8 to 24 that reaches across the box.
    pub step: Option<f64>,
}

/// Coordinates in the sample for the intrinsic step.
const MAX_SAMPLED_COORDINATES: usize = 4096;

/// Chooses levels with indices of `bits` bits for the existing nodes. All axes have one step, or each axis
/// its own if `per_axis`.
///
/// # Errors
/// [`Error::OptionOutOfRange`] for coordinates whose differences could overflow,
/// [`Error::OutOfMemory`].
pub(super) fn choose_levels_for_nodes<T: CoordinateBits>(
    planes: &XyzMatrices<'_, T>,
    bits: u32,
    per_axis: bool,
) -> Result<UniformLevels> {
    let last = (1i64 << bits) - 1;
    let [low, high] = coordinate_bounds(planes);
    let largest = low.iter().chain(&high).fold(0.0, |largest: f64, x| largest.max(x.abs()));
    Error::require(largest <= f64::MAX / 4.0, "coordinates", largest, Allowed::AtMost(f64::MAX / 4.0))?;
    let extents: [f64; 3] = std::array::from_fn(|axis| high[axis] - low[axis]);
    let whole = extents.iter().fold(0.0, |whole: f64, &extent| whole.max(extent));
    let step = |axis: usize| step_of_extent(if per_axis { extents[axis] } else { whole }, last);
    let mut grid = UniformLevels { origin: low, step: std::array::from_fn(step), last_level: last };
    for axis in 0..3 {
        if let Some((origin, step)) = intrinsic_step(planes, axis, grid.step[axis])? {
            let mut finer = grid;
            (finer.origin[axis], finer.step[axis]) = (origin, step);
            if is_rounding_within_tolerance(planes, axis, &finer, grid.step[axis] / 2.0) {
                grid = finer;
            }
        }
    }
    Ok(grid)
}

/// Returns the step of levels 0 to `last` over an extent.
fn step_of_extent(extent: f64, last: i64) -> f64 {
    let step = extent / last as f64;
    // Subnormal quotients are not exact.
    if step > 0.0 { step.max(1e-290) } else { 1.0 }
}

/// Divides the caller's box into levels of the coordinates. Returns the levels, and the number of bits of
/// a level's index.
///
/// # Errors
/// [`Error::OptionOutOfRange`] for a box that is empty or too large, or a step for which 24 bits do
/// not suffice. [`Error::NodeOutsideBox`] for the first existing node outside the box.
pub(super) fn divide_box_into_levels<T: CoordinateBits>(
    planes: &XyzMatrices<'_, T>,
    bits: u32,
    per_axis: bool,
    given: &LevelBox,
) -> Result<(UniformLevels, u32)> {
    for axis in 0..3 {
        let [low, high] = [given.low[axis], given.high[axis]];
        Error::require(low.abs() <= f64::MAX / 4.0, "low", low, -f64::MAX / 4.0..=f64::MAX / 4.0)?;
        Error::require(high.abs() <= f64::MAX / 4.0 && low <= high, "high", high, low..=f64::MAX / 4.0)?;
    }
    let extents: [f64; 3] = std::array::from_fn(|axis| given.high[axis] - given.low[axis]);
    let whole = extents.iter().fold(0.0, |whole: f64, &extent| whole.max(extent));
    let (bits, step) = match given.step {
        Some(step) => {
            let reaches = |bits: &u32| step * ((1i64 << bits) - 1) as f64 >= whole;
            let bits = Some(step).filter(|step| step.is_normal() && *step > 0.0).and_then(|_| (8..=24).find(reaches));
            (
                bits.ok_or(Error::OptionOutOfRange {
                    option: "step",
                    value: step,
                    allowed: "above 0, and large enough for 24 bits".into(),
                })?,
                [step; 3],
            )
        }
        None => {
            let last = (1i64 << bits) - 1;
            let extent = |axis: usize| if per_axis { extents[axis] } else { whole };
            (bits, std::array::from_fn(|axis| step_of_extent(extent(axis), last)))
        }
    };
    let columns = planes.shape().columns();
    for i in 0..planes.shape().rows() {
        let rows = planes.row(i);
        for j in 0..columns {
            let node: [f64; 3] = rows.map(|row| row[j].into());
            let is_outside = |axis: usize| !(given.low[axis]..=given.high[axis]).contains(&node[axis]);
            if node.iter().all(|x| x.is_finite()) && (0..3).any(is_outside) {
                return Err(Error::NodeOutsideBox { node: (i * columns + j) as u32 });
            }
        }
    }
    Ok((UniformLevels { origin: given.low, step, last_level: (1 << bits) - 1 }, bits))
}

/// Returns the bounding box of the existing nodes; zeros if there are none.
fn coordinate_bounds<T: CoordinateBits>(planes: &XyzMatrices<'_, T>) -> [[f64; 3]; 2] {
    let mut bounds = [[f64::INFINITY; 3], [f64::NEG_INFINITY; 3]];
    for i in 0..planes.shape().rows() {
        let [x, y, z] = planes.row(i);
        for ((&x, &y), &z) in x.iter().zip(y).zip(z) {
            let node: [f64; 3] = [x.into(), y.into(), z.into()];
            // The sum is finite if all three are, unless they are too large to be quantised.
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

/// Returns the first coordinate and the step of an axis, if a sample of its coordinates lies in
/// equal steps larger than `step`.
fn intrinsic_step<T: CoordinateBits>(
    planes: &XyzMatrices<'_, T>,
    axis: usize,
    step: f64,
) -> Result<Option<(f64, f64)>> {
    let (w, count) = (planes.shape().columns(), planes.shape().node_count());
    let mut found: Vec<f64> = alloc::with_capacity(MAX_SAMPLED_COORDINATES)?;
    // An odd stride visits all columns.
    let every = count.div_ceil(MAX_SAMPLED_COORDINATES) | 1;
    for at in (0..count).step_by(every) {
        let value: f64 = planes.row(at / w)[axis][at % w].into();
        if value.is_finite() {
            found.push(value);
        }
    }
    found.sort_unstable_by(f64::total_cmp);
    let near = step / 8.0;
    found.dedup_by(|next, first| *next - *first <= near);
    let smallest = found.windows(2).map(|pair| pair[1] - pair[0]).fold(f64::INFINITY, f64::min);
    if found.len() < 3 || smallest < 1.25 * step {
        return Ok(None);
    }
    // The estimate improves with the distance over which it is measured.
    let (mut distance, mut steps) = (smallest, 0.0);
    for pair in found.windows(2) {
        steps += libm::rint((pair[1] - pair[0]) / distance);
        distance = (pair[1] - found[0]) / steps;
    }
    Ok(Some((found[0] - distance * libm::rint((found[0] - coordinate_bounds(planes)[0][axis]) / distance), distance)))
}

/// Returns true if rounding to the levels moves the coordinates of an axis by at most `tolerance`.
fn is_rounding_within_tolerance<T: CoordinateBits>(
    planes: &XyzMatrices<'_, T>,
    axis: usize,
    grid: &UniformLevels,
    tolerance: f64,
) -> bool {
    (0..planes.shape().rows()).all(|i| {
        planes.row(i)[axis].iter().all(|&number| {
            let value: f64 = number.into();
            let rounded: Option<T> = grid.number_of_level(axis, LevelMap::<T>::level_of_number(grid, axis, number));
            !value.is_finite() || rounded.is_some_and(|rounded| (rounded.into() - value).abs() <= tolerance)
        })
    })
}

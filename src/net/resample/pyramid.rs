//! Levels of detail: a pyramid of nets of 2^k + 1 rows and columns. The memory is 4/3 of the first
//! level.

use super::interpolate::{Interpolation, resample};
use super::sides::{min_size, require_sides, selected, with_sides};
use crate::alloc;
use crate::error::Result;
use crate::job::Job;
use crate::net::Net;

/// Nets of 2^k + 1 rows and columns. The first has at least the rows and columns of the given net,
/// and each of the others every second row and column of the one before, bit for bit.
///
/// A net of sizes 2^k + 1 is itself the first; others are resampled. Closed rows and columns keep
/// five nodes, others two; between poles three, or five where other sides are poles too, so that
/// the surface stays the same. The nodes of each level are nodes of the finer one, and a host can
/// morph between levels in place. The memory is 4/3 of the first.
///
/// # Errors
/// As for [`resample`].
pub fn pyramid(net: &Net<'_>, interpolation: Interpolation, job: &Job<'_>) -> Result<Vec<Net<'static>>> {
    let sides = require_sides(net)?;
    let (h, w) = (net.shape().rows(), net.shape().columns());
    let [rows, columns] = [h, w].map(|n| (n - 1).next_power_of_two() + 1);
    let mut levels = Vec::new();
    let first =
        if (rows, columns) == (h, w) { net.copied()? } else { resample(net, rows, columns, interpolation, job)? };
    alloc::push(&mut levels, first)?;
    let [min_rows, min_columns] = min_size(sides, 5);
    while let Some(fine) = levels.last() {
        let step = |n: usize, min: usize| if n.div_ceil(2) >= min { 2 } else { 1 };
        let row_step = step(fine.shape().rows(), min_rows);
        let column_step = step(fine.shape().columns(), min_columns);
        if (row_step, column_step) == (1, 1) {
            break;
        }
        let rows = alloc::collect((0..fine.shape().rows()).step_by(row_step))?;
        let columns = alloc::collect((0..fine.shape().columns()).step_by(column_step))?;
        let coarse = with_sides(selected(fine, &rows, &columns, &job.part(1.0, 1.0))?, fine, sides)?;
        alloc::push(&mut levels, coarse)?;
    }
    Ok(levels)
}

//! Levels of detail.

use super::{Interpolation, least, resample, selected, sides, with_sides};
use crate::alloc;
use crate::error::Result;
use crate::job::Job;
use crate::net::Net;

/// Nets of 2^k + 1 rows and columns, the finest first: it has at least the rows and columns of the given net, and each
/// of the others every second row and column of the one before, bit for bit, until none is left to be left out.
///
/// A net whose sizes are 2^k + 1 already is itself the first; others are resampled. Closed rows and columns keep five
/// nodes, the least for a body; others two, but between poles as many as the surface needs to stay what it is: three, or
/// five where other sides are poles too. Thus the coarser nodes of each level are nodes of the finer one, and a host
/// can morph between levels in place. The memory is 4/3 of the first.
///
/// # Errors
/// As for [`resample`].
pub fn pyramid(net: &Net<'_>, interpolation: Interpolation, job: &Job<'_>) -> Result<Vec<Net<'static>>> {
    let sides = sides(net)?;
    let (h, w) = (net.shape().rows(), net.shape().columns());
    let [rows, columns] = [h, w].map(|n| (n - 1).next_power_of_two() + 1);
    let mut levels = Vec::new();
    let first =
        if (rows, columns) == (h, w) { net.copied()? } else { resample(net, rows, columns, interpolation, job)? };
    alloc::push(&mut levels, first)?;
    let [least_rows, least_columns] = least(sides, 5);
    while let Some(fine) = levels.last() {
        let halved = |n: usize, least: usize| if n.div_ceil(2) >= least { 2 } else { 1 };
        let row_step = halved(fine.shape().rows(), least_rows);
        let column_step = halved(fine.shape().columns(), least_columns);
        if (row_step, column_step) == (1, 1) {
            break;
        }
        let rows = alloc::collect((0..fine.shape().rows()).step_by(row_step))?;
        let columns = alloc::collect((0..fine.shape().columns()).step_by(column_step))?;
        let coarse = with_sides(selected(fine, &rows, &columns)?, fine, sides)?;
        alloc::push(&mut levels, coarse)?;
    }
    Ok(levels)
}

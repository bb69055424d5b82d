//! Resampling by bilinear and Catmull-Rom interpolation, a separable filter of four taps, and
//! pyramids of nets. O(nodes of both).

use super::whole_sides::{min_rows_and_columns, net_with_sides, select_lines, sides_or_glued_inside_error};
use crate::chunks::zip3;
use crate::{Coordinates, Net, Real, Shape, XyzMatrices, each};
use gusset_base::alloc;
use gusset_base::choices;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_base::par;

/// Nodes that one thread takes at a time, approximately.
const NODES_PER_BLOCK: usize = 1 << 14;

/// The interpolation between nodes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum Interpolation {
    /// Bilinear patches.
    Bilinear,
    /// Catmull-Rom splines along rows and columns, which interpolate the nodes with continuous
    /// tangents, across the seam where a row or column is closed.
    #[default]
    Bicubic,
}

choices! { for Interpolation:
    Bicubic => "Cubic", "Cubic splines along rows and columns, which pass through all vertices.";
    Bilinear => "Bilinear", "The bilinear patches of the quads.";
}

/// Resamples to another size, with nodes evenly spaced in the parameters of this net. First and
/// last rows and columns stay.
///
/// Nodes that coincide with old ones keep their bits. New nodes that depend on missing ones are
/// missing. O(nodes of both).
///
/// # Errors
/// Variants of [`Error`](gusset_base::Error): `GluedInside`, `NetTooSmall`, `TooLarge`,
/// `OutOfMemory`, `Cancelled`.
pub fn resample(
    net: &Net<'_>,
    rows: usize,
    columns: usize,
    interpolation: Interpolation,
    job: &Job<'_>,
) -> Result<Net<'static>> {
    let (sides, shape) = (sides_or_glued_inside_error(net)?, Shape::new(rows, columns)?);
    let along = interpolation_taps(net.shape().columns(), columns, sides.rows_closed, interpolation)?;
    let across = interpolation_taps(net.shape().rows(), rows, sides.columns_closed, interpolation)?;
    let coordinates = each!(net.coordinates(), planes => Coordinates::from(interpolate_matrices(planes, shape, &along, &across, job)?));
    net_with_sides(coordinates, net, sides)
}

/// Makes a pyramid of nets with 2^k + 1 rows and columns. The first has at least the rows and
/// columns of the given net. Each further net has every second row and column of the previous one,
/// bit for bit.
///
/// If both sizes of the net are 2^k + 1, it is itself the first; otherwise it is resampled. To
/// preserve the surface, closed rows and columns keep five nodes, others two. Between poles three
/// remain, or five if other sides are poles too. The nodes of each level are nodes of the finer
/// one, so a host can morph between levels in place. The memory is 4/3 of the first net's.
///
/// # Errors
/// The errors of [`resample`].
pub fn pyramid(net: &Net<'_>, interpolation: Interpolation, job: &Job<'_>) -> Result<Vec<Net<'static>>> {
    let sides = sides_or_glued_inside_error(net)?;
    let (h, w) = (net.shape().rows(), net.shape().columns());
    let [rows, columns] = [h, w].map(|n| (n - 1).next_power_of_two() + 1);
    let mut levels = Vec::new();
    let first =
        if (rows, columns) == (h, w) { net.copied()? } else { resample(net, rows, columns, interpolation, job)? };
    alloc::push(&mut levels, first)?;
    let [min_rows, min_columns] = min_rows_and_columns(sides, 5);
    while let Some(fine) = levels.last() {
        let step = |n: usize, min: usize| if n.div_ceil(2) >= min { 2 } else { 1 };
        let row_step = step(fine.shape().rows(), min_rows);
        let column_step = step(fine.shape().columns(), min_columns);
        if (row_step, column_step) == (1, 1) {
            break;
        }
        let rows = alloc::collect((0..fine.shape().rows()).step_by(row_step))?;
        let columns = alloc::collect((0..fine.shape().columns()).step_by(column_step))?;
        let coarse = net_with_sides(select_lines(fine, &rows, &columns, &job.sub_job(1.0, 1.0))?, fine, sides)?;
        alloc::push(&mut levels, coarse)?;
    }
    Ok(levels)
}

/// Returns the taps of `new` nodes evenly spaced over `old` ones, along one direction.
fn interpolation_taps(
    old_count: usize,
    new_count: usize,
    closed: bool,
    interpolation: Interpolation,
) -> Result<Vec<InterpolationTap>> {
    alloc::collect((0..new_count).map(|k| {
        // k (old - 1) / (new - 1), exactly.
        let (at, steps) = (k as u64 * (old_count as u64 - 1), new_count as u64 - 1);
        let before = ((at / steps) as usize).min(old_count - 2);
        let t = (at - before as u64 * steps) as f64 / steps as f64;
        match interpolation {
            Interpolation::Bilinear => {
                InterpolationTap { nodes: [before, before, before + 1, before], weights: [0.0, 1.0 - t, t, 0.0] }
            }
            Interpolation::Bicubic => InterpolationTap::catmull_rom(before, old_count, closed, t),
        }
    }))
}

/// The nodes that a new node depends on, along one direction, and their weights.
#[derive(Clone, Copy)]
struct InterpolationTap {
    nodes: [usize; 4],
    weights: [f64; 4],
}

impl InterpolationTap {
    /// Returns the Catmull-Rom spline between nodes `k` and `k + 1` of `count`. An open end is
    /// extrapolated linearly: the missing node is twice the last minus the previous one.
    fn catmull_rom(k: usize, count: usize, closed: bool, t: f64) -> Self {
        let (s, square) = (1.0 - t, t * t);
        let mut weights =
            [-0.5 * t * s * s, 1.0 + square * (1.5 * t - 2.5), 1.0 + s * s * (1.5 * s - 2.5), -0.5 * s * square];
        if k == 0 && !closed {
            let w = std::mem::take(&mut weights[0]);
            (weights[1], weights[2]) = (weights[1] + 2.0 * w, weights[2] - w);
        }
        if k + 2 == count && !closed {
            let w = std::mem::take(&mut weights[3]);
            (weights[1], weights[2]) = (weights[1] - w, weights[2] + 2.0 * w);
        }
        // The last node of a closed row repeats its first; beyond open ends the weight is 0.
        let before = if k == 0 { count - 2 } else { k - 1 };
        let after = if k + 2 == count { 1 } else { k + 2 };
        InterpolationTap { nodes: [before, k, k + 1, after], weights }
    }

    /// Returns the nodes with non-zero weights. A weight of 0 would still spread missing nodes.
    fn nodes_with_weights(&self) -> impl Iterator<Item = (usize, f64)> {
        self.nodes.into_iter().zip(self.weights).filter(|&(_, weight)| weight != 0.0)
    }

    /// Returns the node of weight 1, if all other weights are 0.
    fn single_node(&self) -> Option<usize> {
        let mut parts = self.nodes_with_weights();
        let (node, weight) = parts.next()?;
        (weight == 1.0 && parts.next().is_none()).then_some(node)
    }

    /// The weighted sum of rows.
    fn blend_rows<T: Real>(&self, from: &XyzMatrices<'_, T>, axis: usize, line: &mut [f64]) {
        if let Some(i) = self.single_node() {
            return line.iter_mut().zip(from.row(i)[axis]).for_each(|(to, &from)| *to = from.into());
        }
        line.fill(0.0);
        for (i, weight) in self.nodes_with_weights() {
            line.iter_mut().zip(from.row(i)[axis]).for_each(|(to, &from)| *to += weight * from.into());
        }
    }

    /// Returns the weighted sum of numbers of a row.
    fn blend_line(&self, line: &[f64]) -> f64 {
        let sum = || self.nodes_with_weights().map(|(j, weight)| weight * line[j]).sum();
        self.single_node().map_or_else(sum, |j| line[j])
    }
}

/// Interpolates across rows, a row at a time, then along the row.
fn interpolate_matrices<T: Real>(
    from: &XyzMatrices<'_, T>,
    shape: Shape,
    along: &[InterpolationTap],
    across: &[InterpolationTap],
    job: &Job<'_>,
) -> Result<XyzMatrices<'static, T>> {
    let mut to = XyzMatrices::zeroed(shape)?;
    let lines = (NODES_PER_BLOCK / shape.columns()).max(1);
    let blocks = zip3(to.matrices_mut().map(|matrix| matrix.chunks_mut(lines * shape.columns())));
    let results = par::map_cancellable(job, "resample", blocks.enumerate(), |(block, matrices)| {
        let mut line = alloc::filled(0.0, from.shape().columns())?;
        for (axis, matrix) in matrices.into_iter().enumerate() {
            for (k, row) in matrix.chunks_mut(shape.columns()).enumerate() {
                across[block * lines + k].blend_rows(from, axis, &mut line);
                row.iter_mut().zip(along).for_each(|(to, tap)| *to = T::from_f64(tap.blend_line(&line)));
            }
        }
        Ok(())
    })?;
    results.into_iter().collect::<Result<()>>()?;
    Ok(to)
}

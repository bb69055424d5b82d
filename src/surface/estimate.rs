//! Estimates of interpolation errors, and bounds of flatness and creases.
//!
//! The error of a grid's surface is estimated by the quintic through six nodes in a row, against
//! the scheme's cubic; flatness is bounded by control nets. O(cells), on the job's threads.

use super::axis::{Axis, TAPS};
use super::cells::Cells;
use super::normal::angle;
use super::{Patch, Sheet, each_sheet};
use crate::alloc;
use crate::error::Result;
use crate::job::Job;
use crate::par;
use glam::DVec3;
use std::ops::Range;

/// Rows of cells, or chunks of them, between two reports of progress.
const ROWS_PER_STEP: usize = 64;
/// Cells that a thread takes at a time, where they do not come by rows.
const CELLS_PER_TASK: usize = 1 << 8;

impl Sheet<'_> {
    /// For each cell, row after row, an estimate of how far a grid's surface is from the smooth one
    /// that its nodes were taken from, at equal parameters: what the quintic through six nodes in a
    /// row says of the scheme's cubic, for rows and for columns, together. No bound: nodes do not
    /// tell what is between them. Infinite for fewer than 5 nodes in a direction, which tell
    /// nothing; 0 for sheets whose patches are given.
    ///
    /// O(nodes).
    ///
    /// # Errors
    /// [`Error::OutOfMemory`](crate::Error::OutOfMemory),
    /// [`Error::Cancelled`](crate::Error::Cancelled).
    pub fn interpolation_errors(&self, job: &Job<'_>) -> Result<Vec<f64>> {
        let [rows, columns] = self.cells();
        let Sheet::Grid(grid) = self else {
            return alloc::filled(0.0, rows * columns);
        };
        let defects = grid.axes().map(Defects::of);
        by_row(rows, columns, "estimating errors", job, |i, errors| {
            let along = |row: usize, j: usize| defects[1].along(j, |column| grid.nodes().get(row, column));
            let across = |column: usize| defects[0].along(i, |row| grid.nodes().get(row, column));
            let mut left = across(0);
            for j in 0..columns {
                let right = across(j + 1);
                errors.push(along(i, j).max(along(i + 1, j)) + left.max(right));
                left = right;
            }
        })
    }

    /// Bounds of how far the surface over the cell at (i, j) is from the bilinear patch through its
    /// corners, and from the two triangles that either diagonal makes of them, both at equal
    /// parameters.
    pub fn flatness(&self, i: usize, j: usize) -> [f64; 2] {
        fn of<const N: usize>(patch: &Patch<N>) -> [f64; 2] {
            let [[a, b], [c, d]] = patch.corners();
            let bilinear = patch.deviation();
            [bilinear, bilinear + 0.25 * ((a - b) - (c - d)).length()]
        }
        each_sheet!(self, cells => of(&Cells::patch(cells, i, j)))
    }

    /// Whether the sides u = 0 and u = 1 of the whole sheet, v = 0 and v = 1 are one point each.
    /// O(cells at the sides).
    pub fn poles(&self) -> [[bool; 2]; 2] {
        let [rows, columns] = self.cells();
        let u = |end: bool| (0..columns).all(|j| self.side_is_point(0, if end { rows - 1 } else { 0 }, j, end));
        let v = |end: bool| (0..rows).all(|i| self.side_is_point(1, i, if end { columns - 1 } else { 0 }, end));
        [[u(false), u(true)], [v(false), v(true)]]
    }

    /// [`Sheet::flatness`] for each cell, row after row. O(cells).
    ///
    /// # Errors
    /// [`Error::OutOfMemory`](crate::Error::OutOfMemory),
    /// [`Error::Cancelled`](crate::Error::Cancelled).
    pub fn flatnesses(&self, job: &Job<'_>) -> Result<Vec<[f64; 2]>> {
        let [rows, columns] = self.cells();
        by_row(rows, columns, "bounding deviations", job, |i, bounds| {
            bounds.extend((0..columns).map(|j| self.flatness(i, j)));
        })
    }

    /// The largest angle between the normals on both sides of borders between cells, at the corners
    /// and the middle of each border: 0, or rounding, where the surface is smooth. Places without a
    /// normal do not count. O(cells).
    ///
    /// # Errors
    /// [`Error::OutOfMemory`](crate::Error::OutOfMemory),
    /// [`Error::Cancelled`](crate::Error::Cancelled).
    pub fn crease(&self, job: &Job<'_>) -> Result<f64> {
        each_sheet!(self, cells => crease_of(cells, self.is_closed(), job))
    }
}

/// [`Sheet::crease`]: by consecutive cells, each with the next ones in u and in v.
fn crease_of<const N: usize>(cells: &impl Cells<N>, [closed_u, closed_v]: [bool; 2], job: &Job<'_>) -> Result<f64> {
    let [rows, columns] = cells.counts();
    let in_chunk = |range: Range<usize>| {
        let mut worst = CreaseAngle::default();
        let mut next = None;
        for (i, j) in range.map(|k| (k / columns, k % columns)) {
            let patch = next.take().unwrap_or_else(|| cells.patch(i, j));
            if i + 1 < rows || closed_u {
                let below = cells.patch((i + 1) % rows, j);
                worst.join(patch.normals_at_side(false, true), below.normals_at_side(false, false));
            }
            if j + 1 < columns || closed_v {
                let right = cells.patch(i, (j + 1) % columns);
                worst.join(patch.normals_at_side(true, true), right.normals_at_side(true, false));
                next = (j + 1 < columns).then_some(right);
            }
        }
        worst.angle
    };
    let (count, mut worst) = (rows * columns, 0.0_f64);
    for from in (0..count).step_by(ROWS_PER_STEP * CELLS_PER_TASK) {
        job.step(from as f64 / count as f64, "comparing normals")?;
        let round = (ROWS_PER_STEP * CELLS_PER_TASK).min(count - from);
        let parts =
            par::chunks(job.threads(), round, CELLS_PER_TASK, |range| in_chunk(from + range.start..from + range.end));
        worst = parts.into_iter().fold(worst, f64::max);
    }
    Ok(worst)
}

/// The largest angle so far, and the square of the chord between its unit vectors, which rises with
/// it and costs less.
#[derive(Default)]
struct CreaseAngle {
    chord: f64,
    angle: f64,
}

impl CreaseAngle {
    /// Compares normals on both sides; those that are 0 do not count.
    fn join(&mut self, one: [DVec3; 3], other: [DVec3; 3]) {
        for (a, b) in one.into_iter().zip(other) {
            let chord = a.distance_squared(b);
            if chord > self.chord && a != DVec3::ZERO && b != DVec3::ZERO {
                *self = CreaseAngle { chord, angle: self.angle.max(angle(a, b)) };
            }
        }
    }
}

/// The values that `work` adds for each row of cells, `each` a row.
fn by_row<T: Send>(
    rows: usize,
    each: usize,
    stage: &'static str,
    job: &Job<'_>,
    work: impl Fn(usize, &mut Vec<T>) + Sync,
) -> Result<Vec<T>> {
    let mut all = alloc::with_capacity(rows.saturating_mul(each))?;
    let round = (ROWS_PER_STEP * CELLS_PER_TASK / each.max(1)).clamp(1, ROWS_PER_STEP);
    for from in (0..rows).step_by(round) {
        job.step(from as f64 / rows as f64, stage)?;
        let parts = par::map(job.threads(), from..rows.min(from + round), |i| {
            let mut row = alloc::with_capacity(each)?;
            work(i, &mut row);
            Ok(row)
        });
        for part in parts {
            all.append(&mut part?);
        }
    }
    Ok(all)
}

/// The weights of the difference between the quintic and the scheme's cubic in each interval of an
/// axis, at three parameters.
struct Defects<'a> {
    axis: &'a Axis,
    /// By the place of the interval among its nodes; none if there are too few.
    weights: Option<[[[f64; TAPS]; 3]; TAPS - 1]>,
}

impl<'a> Defects<'a> {
    fn of(axis: &'a Axis) -> Self {
        let nodes = if axis.is_closed() { TAPS } else { TAPS.min(axis.cells() + 1) };
        let mut weights = [[[0.0; TAPS]; 3]; TAPS - 1];
        for (place, at) in weights.iter_mut().enumerate() {
            let Some(points) = axis.weights_at(place) else { continue };
            for (k, weights) in at.iter_mut().enumerate() {
                let t = 0.25 * (k + 1) as f64;
                let s = 1.0 - t;
                let cubic = [s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t];
                let x = place as f64 + t;
                for (node, weight) in weights[..nodes].iter_mut().enumerate() {
                    let others = (0..nodes).filter(|&other| other != node);
                    let high: f64 = others.map(|other| (x - other as f64) / (node as f64 - other as f64)).product();
                    *weight = high - cubic.iter().zip(points).map(|(b, point)| b * point[node]).sum::<f64>();
                }
            }
        }
        Defects { axis, weights: (nodes >= 5).then_some(weights) }
    }

    /// The largest difference in an interval of a line of nodes.
    fn along(&self, cell: usize, node: impl Fn(usize) -> DVec3) -> f64 {
        let Some(all) = &self.weights else { return f64::INFINITY };
        let nodes = self.axis.taps(cell).0.map(node);
        let difference = |weights: &[f64; TAPS]| weights.iter().zip(&nodes).map(|(&w, &node)| w * node).sum::<DVec3>();
        all[self.axis.place(cell)].iter().map(|weights| difference(weights).length()).fold(0.0, f64::max)
    }
}

//! Estimates of interpolation errors, and bounds of flatness and creases.
//!
//! The error of a grid's surface is estimated by comparing the scheme's cubic with the quintic
//! through six nodes in a row. Control nets bound the flatness. O(cells), on the job's threads.

use super::axis::{GridAxis, NODES_PER_CUBIC};
use super::cells::{SheetCells, compute_cell_values, compute_cell_values_by_row};
use super::normal::angle_between_unit_vectors;
use super::{Sheet, each_sheet};
use glam::DVec3;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_base::{alloc, par};
use std::ops::Range;

/// Number of cells whose normals a thread compares in one task.
const CELLS_PER_TASK: usize = 1 << 8;

impl Sheet<'_> {
    /// Estimates the interpolation error of each cell, row by row. The error is the distance, at
    /// equal parameters, between a grid's surface and the smooth surface that its nodes were
    /// sampled from.
    ///
    /// The estimate is the difference between the quintic through six nodes in a row and the
    /// scheme's cubic, added for rows and columns. It is not a bound, because nodes do not
    /// determine the surface between them. It is infinite if a direction has fewer than 5 nodes,
    /// and 0 for sheets of given patches. O(nodes).
    ///
    /// # Errors
    /// [`Error::OutOfMemory`](gusset_base::Error::OutOfMemory),
    /// [`Error::Cancelled`](gusset_base::Error::Cancelled).
    pub fn interpolation_errors(&self, job: &Job<'_>) -> Result<Vec<f64>> {
        let [rows, columns] = self.cells();
        let Sheet::Grid(grid) = self else {
            return alloc::filled(0.0, rows * columns);
        };
        let defects = grid.axes().map(QuinticMinusCubicWeights::new);
        compute_cell_values_by_row(self.cells(), "estimating errors", job, |i, errors: &mut [f64]| {
            let along = |row: usize, j: usize| defects[1].largest_difference(j, |column| grid.nodes().get(row, column));
            let across = |column: usize| defects[0].largest_difference(i, |row| grid.nodes().get(row, column));
            let mut left = across(0);
            for (j, error) in errors.iter_mut().enumerate() {
                let right = across(j + 1);
                *error = along(i, j).max(along(i + 1, j)) + left.max(right);
                left = right;
            }
        })
    }

    /// Bounds the distance between the surface over the cell at (i, j) and two approximations, at
    /// equal parameters. The first is the bilinear patch through the corners, the second either
    /// pair of triangles that a diagonal splits the cell into.
    pub fn flatness_bounds(&self, i: usize, j: usize) -> [f64; 2] {
        each_sheet!(self, cells => {
            let patch = SheetCells::cell_patch(cells, i, j);
            let ([[a, b], [c, d]], bilinear) = (patch.corner_points(), patch.max_distance_from_bilinear_patch());
            [bilinear, bilinear + 0.25 * ((a - b) - (c - d)).length()]
        })
    }

    /// Whether each side of the whole sheet is a single point, in O(cells at the sides). The sides
    /// are u = 0 and u = 1, then v = 0 and v = 1.
    pub fn poles_at_sides(&self) -> [[bool; 2]; 2] {
        let last = self.cells().map(|count| count - 1);
        [0, 1].map(|k| [self.is_node_line_point(k, 0, false), self.is_node_line_point(k, last[k], true)])
    }

    /// Computes [`Sheet::flatness_bounds`] for each cell, row by row. O(cells).
    ///
    /// # Errors
    /// [`Error::OutOfMemory`](gusset_base::Error::OutOfMemory),
    /// [`Error::Cancelled`](gusset_base::Error::Cancelled).
    pub fn flatness_bounds_of_cells(&self, job: &Job<'_>) -> Result<Vec<[f64; 2]>> {
        compute_cell_values(self.cells(), "bounding deviations", job, |[i, j]| self.flatness_bounds(i, j))
    }

    /// The largest angle between the normals on both sides of a border between cells, sampled at
    /// both ends and the middle of each border. It is 0, or rounding, where the surface is smooth.
    /// Places without a normal are skipped. O(cells).
    ///
    /// # Errors
    /// [`Error::OutOfMemory`](gusset_base::Error::OutOfMemory),
    /// [`Error::Cancelled`](gusset_base::Error::Cancelled).
    pub fn largest_crease_angle(&self, job: &Job<'_>) -> Result<f64> {
        each_sheet!(self, cells => largest_crease_angle_of_cells(cells, self.is_closed(), job))
    }
}

/// Computes [`Sheet::largest_crease_angle`]: compares each cell with the next ones in u and in v.
fn largest_crease_angle_of_cells<const N: usize>(
    cells: &impl SheetCells<N>,
    [closed_u, closed_v]: [bool; 2],
    job: &Job<'_>,
) -> Result<f64> {
    let [rows, columns] = cells.cell_counts();
    let in_chunk = |range: Range<usize>| {
        let mut worst = LargestCreaseAngle::default();
        let mut next = None;
        for (i, j) in range.map(|k| (k / columns, k % columns)) {
            let patch = next.take().unwrap_or_else(|| cells.cell_patch(i, j));
            if i + 1 < rows || closed_u {
                let below = cells.cell_patch((i + 1) % rows, j);
                worst.include_normals(
                    patch.unit_normals_along_side(false, true),
                    below.unit_normals_along_side(false, false),
                );
            }
            if j + 1 < columns || closed_v {
                let right = cells.cell_patch(i, (j + 1) % columns);
                worst.include_normals(
                    patch.unit_normals_along_side(true, true),
                    right.unit_normals_along_side(true, false),
                );
                next = (j + 1 < columns).then_some(right);
            }
        }
        worst.angle
    };
    let parts = par::map_cancellable(
        job,
        "comparing normals",
        par::split_into_ranges(rows * columns, CELLS_PER_TASK),
        in_chunk,
    )?;
    Ok(parts.into_iter().fold(0.0, f64::max))
}

/// The largest angle so far. `chord` is the squared chord between its unit vectors; it increases
/// with the angle, and is cheaper to compute.
#[derive(Default)]
struct LargestCreaseAngle {
    chord: f64,
    angle: f64,
}

impl LargestCreaseAngle {
    /// Compares the normals on both sides of a border. Skips zero vectors.
    fn include_normals(&mut self, one: [DVec3; 3], other: [DVec3; 3]) {
        for (a, b) in one.into_iter().zip(other) {
            let chord = a.distance_squared(b);
            if chord > self.chord && a != DVec3::ZERO && b != DVec3::ZERO {
                *self = LargestCreaseAngle { chord, angle: self.angle.max(angle_between_unit_vectors(a, b)) };
            }
        }
    }
}

/// Weights of the difference between the quintic and the scheme's cubic, at three parameters of
/// each interval of an axis.
struct QuinticMinusCubicWeights<'a> {
    axis: &'a GridAxis,
    /// Weights of the nodes, by position of the interval among its nodes, then by parameter (1/4,
    /// 1/2, 3/4). Their sum is quintic minus cubic. `None` with fewer than 5 nodes.
    weights: Option<[[[f64; NODES_PER_CUBIC]; 3]; NODES_PER_CUBIC - 1]>,
}

impl<'a> QuinticMinusCubicWeights<'a> {
    fn new(axis: &'a GridAxis) -> Self {
        let nodes = if axis.is_closed() { NODES_PER_CUBIC } else { NODES_PER_CUBIC.min(axis.interval_count() + 1) };
        let mut weights = [[[0.0; NODES_PER_CUBIC]; 3]; NODES_PER_CUBIC - 1];
        for (place, at) in weights.iter_mut().enumerate() {
            let Some(points) = axis.weights_of_interval_at_index(place) else { continue };
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
        QuinticMinusCubicWeights { axis, weights: (nodes >= 5).then_some(weights) }
    }

    /// The largest difference in an interval of a line of nodes.
    fn largest_difference(&self, cell: usize, node: impl Fn(usize) -> DVec3) -> f64 {
        let Some(all) = &self.weights else { return f64::INFINITY };
        let nodes = self.axis.nodes_and_weights(cell).0.map(node);
        let difference =
            |weights: &[f64; NODES_PER_CUBIC]| weights.iter().zip(&nodes).map(|(&w, &node)| w * node).sum::<DVec3>();
        all[self.axis.index_of_interval_among_its_nodes(cell)]
            .iter()
            .map(|weights| difference(weights).length())
            .fold(0.0, f64::max)
    }
}

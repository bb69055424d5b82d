//! The surface through a grid of nodes, as bicubic Bézier patches that are computed on demand.
//!
//! In each direction the scheme of `axis` computes four Bézier points from six nodes. Their tensor
//! product gives the 16 control points of a patch from 6 x 6 nodes. Invariant: neighbours agree on
//! their common side to the last bit, because the same operations compute it from the same nodes.
//! O(1) for each patch; no memory besides the nodes.

use super::axis::{BezierWeights, GridAxis, NODES_PER_CUBIC};
use super::cells::{CELLS_PER_BLOCK_SIDE, SheetCells};
use super::displacements::compute_displacement_boxes;
use super::nodes::{NodeWindow, Nodes};
use super::subdivision::BernsteinField;
use super::tangents::compute_tangent_boxes;
use super::{Patch, Scheme};
use glam::{DVec2, DVec3};
use gusset_base::error::Result;
use gusset_base::geom::Aabb;
use std::ops::Range;

/// The surface through a grid of nodes. The bicubic patch over each cell depends on the 6 x 6 nodes
/// around the cell.
///
/// u counts rows and v columns: node (i, j) has the parameters (i, j).
#[derive(Debug, Clone)]
pub struct Grid<'a> {
    nodes: Nodes<'a>,
    u: GridAxis,
    v: GridAxis,
}

impl<'a> Grid<'a> {
    /// Creates the surface through `nodes`. `closed` says whether the surface is closed in u (the
    /// last row of nodes repeats the first one) and in v (columns).
    ///
    /// # Errors
    /// [`NotFinite`](gusset_base::Error::NotFinite);
    /// [`NetTooSmall`](gusset_base::Error::NetTooSmall) if a closed direction has fewer than three
    /// nodes and the repeated one; [`SidesApart`](gusset_base::Error::SidesApart) with the place of
    /// the largest gap, if a closed direction does not end where it begins.
    pub fn new(nodes: Nodes<'a>, closed: [bool; 2], scheme: Scheme) -> Result<Self> {
        let [u, v] = GridAxis::new_pair([nodes.rows(), nodes.columns()], closed, scheme)?;
        nodes.check_finite()?;
        nodes.check_closed_directions(closed)?;
        Ok(Grid { nodes, u, v })
    }

    /// The nodes.
    pub fn nodes(&self) -> &Nodes<'a> {
        &self.nodes
    }

    /// The numbers of cells in u and in v.
    pub fn cells(&self) -> [usize; 2] {
        [self.u.interval_count(), self.v.interval_count()]
    }

    /// Whether the grid is closed in u and in v.
    pub fn is_closed(&self) -> [bool; 2] {
        [self.u.is_closed(), self.v.is_closed()]
    }

    /// The two directions, which define how the cubics follow from the nodes.
    pub(crate) fn axes(&self) -> [&GridAxis; 2] {
        [&self.u, &self.v]
    }

    /// The patch over the cell between the nodes (i, j) and (i + 1, j + 1).
    pub fn patch(&self, i: usize, j: usize) -> Patch<4> {
        let ((rows, row_weights), (columns, column_weights)) =
            (self.u.nodes_and_weights(i), self.v.nodes_and_weights(j));
        // First the sums across the rows, for all coordinates of all columns at once, then along
        // them. The outer points are nodes, or sums over one line of nodes. Both cells on that line
        // therefore compute the same bits.
        let direct = rows.map(|row| self.nodes.borrow_window(row, &columns));
        let read = if direct[0].is_none() {
            rows.map(|row| self.nodes.copy_window(row, &columns))
        } else {
            [[0.0; 3 * NODES_PER_CUBIC]; NODES_PER_CUBIC]
        };
        let nodes: [&NodeWindow; NODES_PER_CUBIC] = std::array::from_fn(|k| direct[k].unwrap_or(&read[k]));
        let (row, column) = (self.u.index_of_interval_among_its_nodes(i), self.v.index_of_interval_among_its_nodes(j));
        let inner = [weighted_sum_of_rows(&row_weights[1], &nodes), weighted_sum_of_rows(&row_weights[2], &nodes)];
        let mut points = [[DVec3::ZERO; 4]; 4];
        for (points, line) in points.iter_mut().zip([nodes[row], &inner[0], &inner[1], nodes[row + 1]]) {
            *points = bezier_points_of_line(line, column, column_weights);
        }
        Patch { points }
    }
}

/// Returns the weighted sum of six rows of nodes, node by node.
#[inline(always)]
fn weighted_sum_of_rows(weights: &[f64; NODES_PER_CUBIC], lines: &[&NodeWindow; NODES_PER_CUBIC]) -> NodeWindow {
    let mut sum = [0.0; 3 * NODES_PER_CUBIC];
    for (weight, line) in weights.iter().zip(lines) {
        sum.iter_mut().zip(*line).for_each(|(sum, x)| *sum += weight * x);
    }
    sum
}

/// The Bézier points between the points `position` and `position + 1` of a line.
#[inline(always)]
fn bezier_points_of_line(line: &NodeWindow, position: usize, weights: &BezierWeights) -> [DVec3; 4] {
    let point = |k: usize| DVec3::new(line[3 * k], line[3 * k + 1], line[3 * k + 2]);
    let inner =
        |weights: &[f64; NODES_PER_CUBIC]| (0..NODES_PER_CUBIC).fold(DVec3::ZERO, |sum, k| sum + weights[k] * point(k));
    [point(position), inner(&weights[1]), inner(&weights[2]), point(position + 1)]
}

/// The four Bézier points of the interval after node `position`.
#[inline(always)]
fn bezier_points_of_pairs(nodes: &[DVec2; NODES_PER_CUBIC], position: usize, weights: &BezierWeights) -> [DVec2; 4] {
    let inner = |weights: &[f64; NODES_PER_CUBIC]| {
        (1..NODES_PER_CUBIC).fold(weights[0] * nodes[0], |sum, k| sum + weights[k] * nodes[k])
    };
    [nodes[position], inner(&weights[1]), inner(&weights[2]), nodes[position + 1]]
}

impl SheetCells<4> for Grid<'_> {
    fn cell_counts(&self) -> [usize; 2] {
        self.cells()
    }

    #[inline]
    fn corner_point(&self, i: usize, j: usize) -> DVec3 {
        self.nodes.get(i, j)
    }

    #[inline(always)]
    fn corner_points_of_row(&self, i: usize, j: usize, count: usize) -> [[f64; 3]; CELLS_PER_BLOCK_SIDE + 1] {
        let mut line = [[0.0; 3]; CELLS_PER_BLOCK_SIDE + 1];
        match self.nodes.contiguous_numbers::<{ 3 * (CELLS_PER_BLOCK_SIDE + 1) }>(i, j) {
            Some(packed) if count == CELLS_PER_BLOCK_SIDE => line.as_flattened_mut().copy_from_slice(packed),
            _ => line = std::array::from_fn(|k| self.corner_point(i, j + k.min(count)).to_array()),
        }
        line
    }

    fn cell_patch(&self, i: usize, j: usize) -> Patch<4> {
        Grid::patch(self, i, j)
    }

    /// Computes the sums of [`Grid::patch`] for heights of nodes instead of points. The first and
    /// the last of four Bézier points are nodes.
    fn patch_coordinates_along(&self, i: usize, j: usize, origin: DVec3, across: [DVec3; 2]) -> [BernsteinField<4>; 2] {
        let ((rows, row_weights), (columns, column_weights)) =
            (self.u.nodes_and_weights(i), self.v.nodes_and_weights(j));
        let (from_row, from_column) =
            (self.u.index_of_interval_among_its_nodes(i), self.v.index_of_interval_among_its_nodes(j));
        let mut along = [[DVec2::ZERO; 4]; NODES_PER_CUBIC];
        for (points, &row) in along.iter_mut().zip(&rows) {
            let mut heights = [DVec2::ZERO; NODES_PER_CUBIC];
            for (height, &column) in heights.iter_mut().zip(&columns) {
                let from = self.nodes.get(row, column) - origin;
                *height = DVec2::new(from.dot(across[0]), from.dot(across[1]));
            }
            *points = bezier_points_of_pairs(&heights, from_column, column_weights);
        }
        let mut fields = [BernsteinField { coefficients: [[0.0; 4]; 4] }; 2];
        for b in 0..4 {
            let mut column = [DVec2::ZERO; NODES_PER_CUBIC];
            column.iter_mut().zip(&along).for_each(|(height, row)| *height = row[b]);
            for (a, pair) in bezier_points_of_pairs(&column, from_row, row_weights).into_iter().enumerate() {
                (fields[0].coefficients[a][b], fields[1].coefficients[a][b]) = (pair.x, pair.y);
            }
        }
        fields
    }

    fn are_tangents_continuous_across_sides(&self, i: usize, j: usize) -> bool {
        self.u.is_interval_smooth_at_ends(i) && self.v.is_interval_smooth_at_ends(j)
    }

    fn fill_displacement_boxes(&self, block_rows: Range<usize>, boxes: &mut [Aabb]) -> Result<()> {
        compute_displacement_boxes(&self.nodes, self.axes(), block_rows, boxes)
    }

    fn fill_tangent_boxes(&self, block_rows: Range<usize>, boxes: &mut [[Aabb; 2]]) -> Result<()> {
        compute_tangent_boxes(&self.nodes, self.axes(), block_rows, boxes)
    }
}

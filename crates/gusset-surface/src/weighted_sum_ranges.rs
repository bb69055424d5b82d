//! Ranges of weighted sums of six nodes of a line, along or across all rows of a grid.
//!
//! The sums are Bézier points or their differences; their ranges bound the surface without its
//! patches. Vector instructions, chosen at run time, process whole rows. O(nodes).

use super::axis::{BezierWeights, GridAxis, NODES_PER_CUBIC};
use super::cells::{CELLS_PER_BLOCK_SIDE, cell_range_of_block};
use super::nodes::Nodes;
use super::widen_kernel::{SumWeights, WidenRangesKernel, widen_ranges};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::aabb::Aabb;
use gusset_base::simd;
use std::ops::Range;

/// A grid, and the sums to bound in an interval of given weights.
pub(super) struct WeightedSumRanges<'a, const K: usize> {
    pub(super) nodes: &'a Nodes<'a>,
    pub(super) u: &'a GridAxis,
    pub(super) v: &'a GridAxis,
    pub(super) sums_of_weights: fn(&BezierWeights) -> SumWeights<K>,
}

/// Ranges of coordinates along a row, one for each cell or each column.
pub(super) struct CoordinateRanges {
    low: Vec<f64>,
    high: Vec<f64>,
}

impl CoordinateRanges {
    fn new(count: usize) -> Result<CoordinateRanges> {
        let filled_ranges = |value| alloc::filled(value, 3 * count);
        Ok(CoordinateRanges { low: filled_ranges(f64::INFINITY)?, high: filled_ranges(f64::NEG_INFINITY)? })
    }

    fn clear(&mut self) {
        self.low.fill(f64::INFINITY);
        self.high.fill(f64::NEG_INFINITY);
    }

    /// The bounding box of the ranges of consecutive cells or columns.
    #[inline]
    pub(super) fn box_of_cells_or_columns(&self, places: Range<usize>) -> Aabb {
        let mut bounds = Aabb::EMPTY;
        let parts = self.low[3 * places.start..3 * places.end].chunks_exact(3);
        for (low, high) in parts.zip(self.high[3 * places.start..3 * places.end].chunks_exact(3)) {
            bounds.low = bounds.low.min(DVec3::from_slice(low));
            bounds.high = bounds.high.max(DVec3::from_slice(high));
        }
        bounds
    }
}

/// True if a line is a side of one of the cells.
fn is_side_of_cells(axis: &GridAxis, cells: &Range<usize>, line: usize) -> bool {
    cells.contains(&line) || line == if axis.is_closed() { cells.end % axis.interval_count() } else { cells.end }
}

impl<const K: usize> WeightedSumRanges<'_, K> {
    /// Computes boxes of the sums along the rows that rows of blocks depend on. Each row is swept
    /// once, for all blocks that depend on it. `add` receives the index of the block, the box over
    /// its columns, and whether the row is a side of its cells.
    pub(super) fn sweep_rows(&self, block_rows: Range<usize>, mut add: impl FnMut(usize, Aabb, bool)) -> Result<()> {
        let rows = |r: usize| cell_range_of_block(r, self.u.interval_count());
        let (cells, across) = (self.v.interval_count(), self.v.interval_count().div_ceil(CELLS_PER_BLOCK_SIDE));
        // Closed rows continue at both ends.
        let (mut ranges, mut line) =
            (CoordinateRanges::new(cells)?, alloc::with_capacity(3 * (cells + NODES_PER_CUBIC))?);
        for row in self.u.lines_of_cells(rows(block_rows.start).start..rows(block_rows.end - 1).end) {
            ranges.clear();
            self.widen_along_row(row, &mut line, &mut ranges);
            let needed = block_rows.clone().filter(|&r| self.u.lines_of_cells(rows(r)).any(|line| line == row));
            let needed =
                alloc::gather(needed.map(|r| (r - block_rows.start, is_side_of_cells(self.u, &rows(r), row))))?;
            for c in 0..across {
                let bounds = ranges.box_of_cells_or_columns(cell_range_of_block(c, cells));
                needed.iter().for_each(|&(r, own)| add(r * across + c, bounds, own));
            }
        }
        Ok(())
    }

    /// Computes the ranges, by column, of the sums across the rows of cells in each row of blocks.
    /// `each` receives the index of a block, its columns of cells, and the ranges.
    pub(super) fn sweep_across_rows(
        &self,
        block_rows: Range<usize>,
        mut each: impl FnMut(usize, Range<usize>, &CoordinateRanges),
    ) -> Result<()> {
        let (cells, across) = (self.v.interval_count(), self.v.interval_count().div_ceil(CELLS_PER_BLOCK_SIDE));
        let mut ranges = CoordinateRanges::new(cells + 1)?;
        for (k, r) in block_rows.enumerate() {
            ranges.clear();
            cell_range_of_block(r, self.u.interval_count()).for_each(|i| self.widen_across_rows(i, &mut ranges));
            (0..across).for_each(|c| each(k * across + c, cell_range_of_block(c, cells), &ranges));
        }
        Ok(())
    }

    /// Widens the ranges of cells by the sums along a row.
    fn widen_along_row(&self, row: usize, line: &mut Vec<f64>, ranges: &mut CoordinateRanges) {
        let cells = self.v.interval_count();
        // Inner cells share their weights, so that one pass handles them all. A closed row
        // continues at both ends.
        let inner = if self.v.is_closed() { 0..cells } else { 2.min(cells)..cells.saturating_sub(2).max(2.min(cells)) };
        let node = |j: usize| self.nodes.get(row, j).to_array();
        line.clear();
        if self.v.is_closed() {
            (0..cells + NODES_PER_CUBIC - 1).for_each(|k| line.extend(node((k + 2 * cells - 2) % cells)));
        } else if let Some(packed) = self.nodes.contiguous_row(row) {
            line.extend_from_slice(packed);
        } else {
            (0..=cells).for_each(|j| line.extend(node(j)));
        }
        for j in (0..inner.start).chain(inner.end..cells) {
            let (columns, weights) = self.v.nodes_and_weights(j);
            let nodes = columns.map(node);
            let (low, high) = (&mut ranges.low[3 * j..3 * j + 3], &mut ranges.high[3 * j..3 * j + 3]);
            let lines: [&[f64]; NODES_PER_CUBIC] = std::array::from_fn(|k| &nodes[k][..]);
            widen_ranges(&(self.sums_of_weights)(weights), lines, low, high);
        }
        if !inner.is_empty() {
            let count = 3 * inner.len();
            let lines = std::array::from_fn(|k| &line[3 * k..3 * k + count]);
            let low = &mut ranges.low[3 * inner.start..3 * inner.end];
            let high = &mut ranges.high[3 * inner.start..3 * inner.end];
            simd::run(WidenRangesKernel {
                sums: (self.sums_of_weights)(self.v.nodes_and_weights(inner.start).1),
                lines,
                low,
                high,
            });
        }
    }

    /// Widens the ranges of columns by the sums across the rows of interval i.
    fn widen_across_rows(&self, i: usize, ranges: &mut CoordinateRanges) {
        let (rows, weights) = self.u.nodes_and_weights(i);
        let sums = (self.sums_of_weights)(weights);
        let packed = rows.map(|row| self.nodes.contiguous_row(row));
        if let [Some(a), Some(b), Some(c), Some(d), Some(e), Some(f)] = packed {
            let (low, high) = (&mut ranges.low[..], &mut ranges.high[..]);
            simd::run(WidenRangesKernel { sums, lines: [a, b, c, d, e, f], low, high });
            return;
        }
        for j in 0..self.nodes.columns() {
            let nodes = rows.map(|row| self.nodes.get(row, j).to_array());
            let lines: [&[f64]; NODES_PER_CUBIC] = std::array::from_fn(|k| &nodes[k][..]);
            let (low, high) = (&mut ranges.low[3 * j..3 * j + 3], &mut ranges.high[3 * j..3 * j + 3]);
            widen_ranges(&sums, lines, low, high);
        }
    }
}

//! The corners of a polygon that may lie in an ear, in cells of the plane.

use crate::error::Result;
use crate::sort::Buckets;
use glam::DVec2;
use std::ops::{Range, RangeInclusive};

/// Polygons of fewer corners have one cell.
const MIN_GRID_CORNERS: usize = 64;
/// Widens the cells of a triangle, in cells, against rounding.
const CELL_MARGIN: f64 = 1e-6;

/// The corners that were not clearly convex at first, in rows of cells.
pub(super) struct ReflexGrid {
    low: DVec2,
    cells_per_unit: DVec2,
    /// The number of rows, and of columns.
    rows_and_columns: usize,
    corners: Buckets<u32>,
}

impl ReflexGrid {
    pub(super) fn new(flat: &[DVec2], is_reflex: &[bool]) -> Result<Self> {
        let listed = (0..flat.len()).filter(|&corner| is_reflex[corner]);
        let side = if flat.len() < MIN_GRID_CORNERS {
            1
        } else {
            (listed.clone().count() as f64).sqrt().ceil().max(1.0) as usize
        };
        let low = flat.iter().fold(DVec2::INFINITY, |low, &point| low.min(point));
        let high = flat.iter().fold(DVec2::NEG_INFINITY, |high, &point| high.max(point));
        let cells_per_unit = (DVec2::splat(side as f64) / (high - low)).to_array();
        let cells_per_unit = cells_per_unit.map(|scale| if scale.is_finite() && scale > 0.0 { scale } else { 0.0 });
        let mut grid = Self {
            low,
            cells_per_unit: DVec2::from_array(cells_per_unit),
            rows_and_columns: side,
            corners: Buckets::default(),
        };
        let placed = listed.map(|corner| (grid.cell(flat[corner]), corner as u32));
        grid.corners = Buckets::new(side * side, 0, placed)?;
        Ok(grid)
    }

    /// Returns the rows of cells between two heights.
    pub(super) fn rows_between(&self, low: f64, high: f64) -> RangeInclusive<usize> {
        let row = |y: f64| self.place((y - self.low.y) * self.cells_per_unit.y);
        row(low)..=row(high)
    }

    /// Returns the listed corners in the cells of a row that a triangle meets, and at times in one
    /// cell more at either end.
    pub(super) fn corners_in_row(&self, row: usize, triangle: [DVec2; 3]) -> &[u32] {
        let columns = self.columns_in_row(row, triangle);
        let start = row * self.rows_and_columns;
        // The corners of neighbouring cells follow each other.
        let range = self.corners.range(start + columns.start).start..self.corners.range(start + columns.end - 1).end;
        &self.corners.items()[range]
    }

    fn columns_in_row(&self, row: usize, triangle: [DVec2; 3]) -> Range<usize> {
        if self.rows_and_columns == 1 {
            return 0..1;
        }
        let (bottom, top) = (row as f64 - CELL_MARGIN, row as f64 + 1.0 + CELL_MARGIN);
        let [a, b, c] = triangle.map(|point| (point - self.low) * self.cells_per_unit);
        let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
        for (a, b) in [(a, b), (b, c), (c, a)] {
            let (a, b) = if a.y <= b.y { (a, b) } else { (b, a) };
            if b.y < bottom || a.y > top {
                continue;
            }
            let at = |y: f64| a.x + (b.x - a.x) * ((y - a.y) / (b.y - a.y));
            let ends = if b.y > a.y { [at(a.y.max(bottom)), at(b.y.min(top))] } else { [a.x, b.x] };
            low = low.min(ends[0]).min(ends[1]);
            high = high.max(ends[0]).max(ends[1]);
        }
        let (first, last) = (self.place(low - CELL_MARGIN), self.place(high + CELL_MARGIN));
        first.min(last)..last + 1
    }

    fn cell(&self, point: DVec2) -> usize {
        let scaled = (point - self.low) * self.cells_per_unit;
        self.place(scaled.y) * self.rows_and_columns + self.place(scaled.x)
    }

    /// Returns the column or row of a coordinate in cells. A conversion from NaN gives 0.
    fn place(&self, scaled: f64) -> usize {
        (scaled as usize).min(self.rows_and_columns - 1)
    }
}

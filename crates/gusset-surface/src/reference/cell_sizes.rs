//! Bounds of cells: the largest distance between two points, or angle between two normals.

use super::cell_grid_shape::CellGridShape;
use super::cell_mask::CellMask;
use gusset_base::error::{Error, Result};

/// A bound for each cell, of its diameter or of the angle between its normals, and the largest
/// bound, the paper's d.
///
/// The bound of a cell includes its corners as the neighbours compute them. Consecutive cells of a
/// chain therefore share an element, even where patches meet only approximately. Let a chain of J
/// cells join the cell of an element x to node A. By theorem T1, the distance of x from A is at
/// most the sum of the J bounds: J d, or R_J(A), the sum over k of the largest bound in the k-th
/// ring of cells around A.
#[derive(Debug, Clone, PartialEq)]
pub struct CellSizeBounds {
    lattice: CellGridShape,
    bounds_of_cells: Vec<f64>,
    greatest: f64,
}

/// How bounds of cells are summed over a block of 2 J x 2 J cells.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum CellBoundSum {
    /// J d, as in the paper. O(1).
    #[default]
    Greatest,
    /// R_J, the sum of the largest bound of each ring. Blocks are larger if cells differ in size,
    /// but cost O(J^2).
    Rings,
}

/// Factor that covers the rounding of bounds and of their sums.
pub(super) const BOUND_ROUNDING_FACTOR: f64 = 1.0 + 1e-14;

impl CellSizeBounds {
    /// Creates sizes from one bound for each cell, row by row. Bounds are neither NaN nor negative.
    pub(super) fn new(lattice: CellGridShape, sizes: Vec<f64>) -> Self {
        let greatest = sizes.iter().copied().fold(0.0, f64::max);
        CellSizeBounds { lattice, bounds_of_cells: sizes, greatest }
    }

    /// The lattice of the cells.
    pub fn lattice(&self) -> CellGridShape {
        self.lattice
    }

    /// The bounds, row by row.
    pub fn values(&self) -> &[f64] {
        &self.bounds_of_cells
    }

    /// The bound of a cell.
    pub fn get(&self, cell: [usize; 2]) -> f64 {
        self.bounds_of_cells[self.lattice.index(cell)]
    }

    /// The largest bound, d.
    pub fn largest_bound(&self) -> f64 {
        self.greatest
    }

    /// The largest J for which the block of 2 J x 2 J cells around a node stays closer to the node
    /// than `limit`, and the bound of its reach. J is at most the larger number of rows and
    /// columns, because longer chains are unnecessary (6).
    pub fn max_steps_within_distance(&self, node: [usize; 2], limit: f64, sum: CellBoundSum) -> (usize, f64) {
        let [rows, columns] = self.lattice.cells;
        let most = rows.max(columns);
        match sum {
            CellBoundSum::Greatest => {
                let reach = |steps: usize| steps as f64 * self.greatest * BOUND_ROUNDING_FACTOR;
                if self.greatest == 0.0 {
                    return if limit > 0.0 { (most, 0.0) } else { (0, 0.0) };
                }
                // ceil(limit / d) - 1, except for rounding (erratum E2). A quotient that is NaN or
                // negative gives 0.
                let mut steps = ((limit / self.greatest).ceil() as usize).min(most);
                while steps > 0 && reach(steps) >= limit {
                    steps -= 1;
                }
                (steps, reach(steps))
            }
            CellBoundSum::Rings => {
                let (mut steps, mut reach) = (0, 0.0);
                while steps < most {
                    let next = reach + self.max_bound_in_ring(node, steps + 1) * BOUND_ROUNDING_FACTOR;
                    if next >= limit {
                        break;
                    }
                    (steps, reach) = (steps + 1, next);
                }
                (steps, reach)
            }
        }
    }

    /// R_J: a bound of the distance from a node within the block of 2 J x 2 J cells around it.
    pub fn sum_of_largest_ring_bounds(&self, node: [usize; 2], steps: usize) -> f64 {
        (1..=steps).map(|k| self.max_bound_in_ring(node, k)).sum::<f64>() * BOUND_ROUNDING_FACTOR
    }

    /// The largest bound in the k-th ring of cells around a node: the cells that chains of k cells
    /// reach, but shorter chains do not.
    fn max_bound_in_ring(&self, node: [usize; 2], k: usize) -> f64 {
        let ([rows, columns], inner) =
            (self.lattice.block_around_node(node, k), self.lattice.block_around_node(node, k - 1));
        let own = rows.indices().flat_map(|i| {
            let crosses = inner[0].contains_interval(i);
            columns.indices().filter(move |&j| !(crosses && inner[1].contains_interval(j))).map(move |j| [i, j])
        });
        own.map(|cell| self.get(cell)).fold(0.0, f64::max)
    }

    /// Returns an upper bound of the diameter of a cell region, or of the angle between its
    /// normals: the integer diameter times the largest bound of its cells. This is equation 5 of
    /// the paper.
    ///
    /// # Errors
    /// [`Error::SidesDiffer`] if the region belongs to another sheet.
    pub fn region_bound(&self, region: &CellMask, integer_diameter: usize) -> Result<f64> {
        if region.lattice() != self.lattice {
            let [a, b] = [self.lattice.len(), region.lattice().len()];
            return Err(Error::SidesDiffer { a: a as u32, b: b as u32 });
        }
        let greatest = region.cells().map(|cell| self.get(cell)).fold(0.0, f64::max);
        Ok(integer_diameter as f64 * greatest * BOUND_ROUNDING_FACTOR)
    }
}

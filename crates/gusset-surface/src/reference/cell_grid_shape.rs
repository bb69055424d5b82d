//! The adjacency of the cells of a sheet.

use crate::Sheet;
use gusset_base::error::{Element, Error, Result};

/// Rows and columns of cells, and which directions are closed.
///
/// Node (i, j) is a corner of the cells (i - 1, j - 1) to (i, j) that exist. Cells that share a
/// node are neighbours, also across corners: chains of cells move like the king on a chessboard.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct CellGridShape {
    /// The numbers of cells in u and in v.
    pub cells: [usize; 2],
    /// Whether the last line repeats the first one, in u and in v.
    pub closed: [bool; 2],
}

/// Consecutive intervals of one direction. In a closed direction, the first interval follows the
/// last one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct CyclicSpan {
    pub(crate) first_interval: usize,
    pub(crate) len: usize,
    interval_count_of_direction: usize,
}

impl CyclicSpan {
    /// All intervals of a direction.
    pub(crate) fn all_intervals(count: usize) -> CyclicSpan {
        CyclicSpan { first_interval: 0, len: count, interval_count_of_direction: count }
    }

    /// A span that begins at `first_interval`, which may exceed the number of intervals in a closed
    /// direction.
    pub(crate) fn new(first_interval: usize, len: usize, count: usize) -> CyclicSpan {
        CyclicSpan { first_interval: first_interval % count, len, interval_count_of_direction: count }
    }

    pub(crate) fn indices(self) -> impl Iterator<Item = usize> {
        (self.first_interval..self.first_interval + self.len)
            .map(move |k| if k < self.interval_count_of_direction { k } else { k - self.interval_count_of_direction })
    }

    /// Returns the indices as two ranges: up to the seam of a closed direction, and after it. The
    /// second range is empty if the span does not cross the seam.
    pub(crate) fn ranges_around_seam(self) -> [std::ops::Range<usize>; 2] {
        let end = self.first_interval + self.len;
        [
            self.first_interval..end.min(self.interval_count_of_direction),
            0..end.saturating_sub(self.interval_count_of_direction),
        ]
    }

    pub(crate) fn contains_interval(self, k: usize) -> bool {
        self.ranges_around_seam().iter().any(|part| part.contains(&k))
    }

    /// True if the span contains all intervals of another one.
    pub(crate) fn covers_span(self, other: CyclicSpan) -> bool {
        let from = (other.first_interval + self.interval_count_of_direction - self.first_interval)
            % self.interval_count_of_direction;
        self.len >= self.interval_count_of_direction || other.len == 0 || from + other.len <= self.len
    }
}

impl CellGridShape {
    /// Returns the lattice of a sheet.
    pub fn new(sheet: &Sheet<'_>) -> Self {
        CellGridShape { cells: sheet.cells(), closed: sheet.is_closed() }
    }

    /// The number of cells.
    #[allow(clippy::len_without_is_empty, reason = "there is a cell at least")]
    pub fn len(&self) -> usize {
        self.cells[0] * self.cells[1]
    }

    /// The index of a cell, row by row.
    pub fn index(&self, [i, j]: [usize; 2]) -> usize {
        i * self.cells[1] + j
    }

    /// The cell with the given index.
    pub fn cell(&self, index: usize) -> [usize; 2] {
        [index / self.cells[1], index % self.cells[1]]
    }

    /// The numbers of distinct lines of nodes.
    pub fn lines(&self) -> [usize; 2] {
        [0, 1].map(|k| self.cells[k] + usize::from(!self.closed[k]))
    }

    /// Returns [`Error::NoSuch`] unless the cell exists.
    pub(crate) fn check_cell(&self, [i, j]: [usize; 2]) -> Result<()> {
        let [rows, columns] = self.cells;
        if i < rows && j < columns {
            return Ok(());
        }
        let cell = (i as u64).saturating_mul(columns as u64).saturating_add(j as u64);
        Err(Error::NoSuch { element: Element::Cell, index: cell, count: self.len() as u64 })
    }

    /// The intervals `line - steps .. line + steps - 1` of one direction that exist.
    pub(crate) fn span_around_line(&self, direction: usize, line: usize, steps: usize) -> CyclicSpan {
        let count = self.cells[direction];
        if !self.closed[direction] {
            let first = line.saturating_sub(steps);
            return CyclicSpan {
                first_interval: first,
                len: line.saturating_add(steps).min(count) - first,
                interval_count_of_direction: count,
            };
        }
        if steps >= count.div_ceil(2) {
            return CyclicSpan::all_intervals(count);
        }
        CyclicSpan::new(line + count - steps, 2 * steps, count)
    }

    /// The range of rows and the range of columns of the 2 J x 2 J cells around a node, where J is
    /// `steps`. Chains of J cells from the node, each sharing a node with the next, reach exactly
    /// these cells.
    pub(crate) fn block_around_node(&self, [i, j]: [usize; 2], steps: usize) -> [CyclicSpan; 2] {
        [self.span_around_line(0, i, steps), self.span_around_line(1, j, steps)]
    }

    /// The cells at a node: four, or fewer at the edge.
    pub(crate) fn cells_at_node(&self, node: [usize; 2]) -> impl Iterator<Item = [usize; 2]> {
        let [rows, columns] = self.block_around_node(node, 1);
        rows.indices().flat_map(move |i| columns.indices().map(move |j| [i, j]))
    }

    /// The corners of a cell. In closed directions, the last line is the first one.
    pub(crate) fn corner_nodes(&self, [i, j]: [usize; 2]) -> [[usize; 2]; 4] {
        let next = |k: usize, at: usize| if self.closed[k] && at + 1 == self.cells[k] { 0 } else { at + 1 };
        [[i, j], [i, next(1, j)], [next(0, i), j], [next(0, i), next(1, j)]]
    }

    /// The cells that share a node with a cell, except the cell itself.
    pub fn neighbours(&self, cell: [usize; 2]) -> impl Iterator<Item = [usize; 2]> {
        let around = |k: usize| {
            let (at, count) = (cell[k], self.cells[k]);
            // Closed directions have at least three cells.
            if self.closed[k] {
                return CyclicSpan::new(at + count - 1, 3.min(count), count);
            }
            let first = at.saturating_sub(1);
            CyclicSpan { first_interval: first, len: (at + 2).min(count) - first, interval_count_of_direction: count }
        };
        let (rows, columns) = (around(0), around(1));
        rows.indices().flat_map(move |i| columns.indices().map(move |j| [i, j])).filter(move |&other| other != cell)
    }
}

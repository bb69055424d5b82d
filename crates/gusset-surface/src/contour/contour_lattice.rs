//! Indices of the cells of a sheet and of their sides, also across closed directions.

use crate::Sheet;
use crate::cells::{CELLS_PER_BLOCK_SIDE, cell_range_of_block};
use std::ops::Range;

/// The cells of a sheet in rows and columns.
#[derive(Debug, Clone, Copy)]
pub(super) struct ContourLattice {
    /// The numbers of cells in u and in v.
    pub(super) counts: [usize; 2],
    /// Whether the last line repeats the first one, in u and in v.
    pub(super) closed: [bool; 2],
}

impl ContourLattice {
    /// Returns the lattice of a sheet.
    pub(super) fn new(sheet: &Sheet<'_>) -> Self {
        ContourLattice { counts: sheet.cells(), closed: sheet.has_exact_seams() }
    }

    /// The numbers of blocks in u and in v.
    pub(super) fn block_counts(&self) -> [usize; 2] {
        self.counts.map(|count| count.div_ceil(CELLS_PER_BLOCK_SIDE))
    }

    /// The ranges of rows and columns of a block.
    pub(super) fn cells_of_block(&self, [row, column]: [u32; 2]) -> [Range<usize>; 2] {
        [cell_range_of_block(row as usize, self.counts[0]), cell_range_of_block(column as usize, self.counts[1])]
    }

    /// The index of a side of a cell. Both cells at the side agree on it.
    pub(super) fn side_index(&self, [i, j]: [usize; 2], side: usize) -> u64 {
        let next = |k: usize, d: usize| if self.closed[d] && k + 1 == self.counts[d] { 0 } else { k + 1 };
        let (i, j) = match side {
            1 => (next(i, 0), j),
            2 => (i, next(j, 1)),
            _ => (i, j),
        };
        // Sides 0 and 2 run along u, 1 and 3 along v.
        2 * (i as u64 * (self.counts[1] as u64 + 1) + j as u64) + (side % 2) as u64
    }

    /// The index of the corner at the start of a side, or at its end.
    pub(super) fn corner_index_of_side(&self, side: u64, at_end: bool) -> u64 {
        let width = self.counts[1] as u64 + 1;
        let (node, d) = (side / 2, (side % 2) as usize);
        let mut at = [node / width, node % width];
        if at_end {
            let last = self.closed[d] && at[d] + 1 == self.counts[d] as u64;
            at[d] = if last { 0 } else { at[d] + 1 };
        }
        at[0] * width + at[1]
    }

    /// The cell that owns the side or corner after a cell in the given directions. The last of the
    /// two cells at a side, or of the four at a corner, owns it; at an open edge, the first one.
    /// Also returns whether the side is at the high end of its owner.
    pub(super) fn owner_of_side_or_corner(
        &self,
        [i, j]: [usize; 2],
        [after_u, after_v]: [bool; 2],
    ) -> ([usize; 2], [bool; 2]) {
        let along = |k: usize, after: bool, d: usize| match (after, k + 1 == self.counts[d]) {
            (false, _) => (k, false),
            (true, false) => (k + 1, false),
            (true, true) if self.closed[d] => (0, false),
            (true, true) => (k, true),
        };
        let ((i, high_u), (j, high_v)) = (along(i, after_u, 0), along(j, after_v, 1));
        ([i, j], [high_u, high_v])
    }

    /// True if a place is on an open edge of the sheet.
    pub(super) fn is_place_on_open_edge(&self, cell: [u32; 2], at: [f64; 2]) -> bool {
        (0..2).any(|d| {
            let (first, last) = (cell[d] == 0, cell[d] as usize + 1 == self.counts[d]);
            !self.closed[d] && (first && at[d] <= 1e-9 || last && at[d] >= 1.0 - 1e-9)
        })
    }

    /// True if the side of a cell with the given index is on an open edge.
    pub(super) fn is_side_on_open_edge(&self, [i, j]: [u32; 2], side: u64) -> bool {
        let cell = [i as usize, j as usize];
        (0..4)
            .find(|&which| self.side_index(cell, which) == side)
            .is_some_and(|which| self.is_cell_side_open(cell, which))
    }

    /// True if side 0 to 3 of a cell is on an open edge.
    #[inline]
    pub(super) fn is_cell_side_open(&self, [i, j]: [usize; 2], side: usize) -> bool {
        match side {
            0 => !self.closed[1] && j == 0,
            1 => !self.closed[0] && i + 1 == self.counts[0],
            2 => !self.closed[1] && j + 1 == self.counts[1],
            _ => !self.closed[0] && i == 0,
        }
    }
}

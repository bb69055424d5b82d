//! The division of a sheet's blocks among threads, and between reports of progress.

use crate::surface::cells::BLOCK;

/// Rows of blocks that one thread takes at once: even, as pairs of rows share their child boxes.
pub(super) const BLOCK_ROWS_PER_TASK: usize = 8;

/// Cells between two reports of progress, or those of one task, if these are more.
const CELLS_PER_STEP: usize = 1 << 18;

/// Tasks between two reports of progress, where rows have so many blocks.
pub(super) fn tasks_per_step(columns: usize) -> usize {
    (CELLS_PER_STEP / (BLOCK_ROWS_PER_TASK * columns * BLOCK * BLOCK)).max(1)
}

//! The division of a sheet's blocks among threads.

/// Number of rows of blocks that a thread processes in one task, if rows have `columns` blocks. The
/// number is even, because pairs of rows share their child boxes. It is large enough that a
/// progress report for each task is cheap.
pub(super) fn block_rows_per_task(columns: usize) -> usize {
    8 * 16_usize.div_ceil(columns)
}

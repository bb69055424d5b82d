//! The division of a sheet's blocks among threads.

/// Rows of blocks that one thread takes at once, where rows have so many: even, as pairs of rows
/// share their child boxes, and so many that a report of progress for each task costs nothing.
pub(super) fn block_rows_per_task(columns: usize) -> usize {
    8 * 16_usize.div_ceil(columns)
}

//! Parallel loops over the coordinates of a net in chunks of consecutive nodes that fit in the L1
//! cache.
//!
//! Invariant: chunk boundaries depend on the shape and the stride alone, so that results do not
//! depend on the number of threads.

use super::{Real, XyzMatrices};
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_base::par;

/// The largest number of nodes of a chunk: three rows of `f64` take 24 kB.
pub(crate) const MAX_NODES_PER_CHUNK: usize = 1024;

/// Nodes that one thread takes at a time, approximately.
pub(crate) const NODES_PER_BLOCK: usize = 1 << 15;

/// Returns the lines of a block, of `width` nodes each.
pub(crate) fn lines_per_block(nodes_per_line: usize) -> usize {
    (NODES_PER_BLOCK / nodes_per_line).max(1)
}

/// The layout of blocks: `lines` lines each, of `length` numbers `stride` apart.
struct BlockLineLayout {
    length: usize,
    stride: usize,
    lines: usize,
}

impl BlockLineLayout {
    /// Treats rows without gaps as one long line, which can be divided anywhere.
    fn from_matrices<T: Real>(planes: &XyzMatrices<'_, T>) -> Self {
        let (stride, columns) = (planes.stride(), planes.shape().columns());
        if stride == columns {
            BlockLineLayout { length: NODES_PER_BLOCK, stride: NODES_PER_BLOCK, lines: 1 }
        } else {
            BlockLineLayout { length: columns, stride, lines: lines_per_block(stride) }
        }
    }

    /// Calls `work` for the chunks of consecutive lines, of which line `first` is the first.
    fn for_each_chunk<T: Real>(
        &self,
        matrices: [&mut [T]; 3],
        first: usize,
        max: usize,
        mut work: impl FnMut(usize, [&mut [T]; 3]) -> Result<()>,
    ) -> Result<()> {
        zip3(matrices.map(|matrix| matrix.chunks_mut(self.stride))).zip(first..).try_for_each(|(rows, line)| {
            let (start, length) = (line * self.length, rows[0].len().min(self.length));
            let mut chunks = zip3(rows.map(|row| row[..length].chunks_mut(max))).enumerate();
            chunks.try_for_each(|(k, chunk)| work(start + k * max, chunk))
        })
    }
}

/// Returns the elements of three iterators in step.
pub(crate) fn zip3<I: ExactSizeIterator>([x, y, z]: [I; 3]) -> impl ExactSizeIterator<Item = [I::Item; 3]> {
    x.zip(y).zip(z).map(|((x, y), z)| [x, y, z])
}

/// Calls `work` in parallel with the index of the first node and the coordinates of each chunk of
/// at most `max` nodes. Returns the error of the first chunk that fails; other chunks may have
/// changed.
pub(crate) fn for_each_chunk_mut<T: Real>(
    planes: &mut XyzMatrices<'_, T>,
    threads: usize,
    max: usize,
    work: impl Fn(usize, [&mut [T]; 3]) -> Result<()> + Sync,
) -> Result<()> {
    let layout = BlockLineLayout::from_matrices(planes);
    let blocks = zip3(planes.matrices_mut().map(|matrix| matrix.chunks_mut(layout.lines * layout.stride)));
    let results = par::map(threads, blocks.enumerate(), |(block, matrices)| {
        layout.for_each_chunk(matrices, block * layout.lines, max, &work)
    })?;
    results.into_iter().collect()
}

/// [`for_each_chunk_mut`] in the order of the nodes, on the calling thread. Stops at the first
/// error.
pub(crate) fn for_each_chunk_in_order<T: Real>(
    planes: &mut XyzMatrices<'_, T>,
    work: impl FnMut(usize, [&mut [T]; 3]) -> Result<()>,
) -> Result<()> {
    BlockLineLayout::from_matrices(planes).for_each_chunk(planes.matrices_mut(), 0, 4 * MAX_NODES_PER_CHUNK, work)
}

/// Returns the results of `work` for each row of `width` values, in order, computed in parallel;
/// cancellable between blocks of rows.
pub(crate) fn map_rows<V: Send, R: Send>(
    values: &mut [V],
    values_per_row: usize,
    (job, stage): (&Job<'_>, &'static str),
    work: impl Fn(usize, &mut [V]) -> R + Sync,
) -> Result<impl Iterator<Item = R>> {
    let lines = lines_per_block(values_per_row);
    let blocks =
        par::map_cancellable(job, stage, values.chunks_mut(lines * values_per_row).enumerate(), |(block, values)| {
            let rows = values.chunks_mut(values_per_row).enumerate();
            rows.map(|(line, row)| work(block * lines + line, row)).collect::<Vec<R>>()
        })?;
    Ok(blocks.into_iter().flatten())
}

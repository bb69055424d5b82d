//! Parallel loops over the coordinates of a net in chunks of consecutive nodes that fit in the L1
//! cache.
//!
//! Invariant: chunk boundaries depend on the shape and the stride alone, so that results do not
//! depend on the number of threads.

use super::{Planes, Real};
use crate::error::Result;
use crate::job::Job;
use crate::par;

/// The largest number of nodes of a chunk: three rows of `f64` take 24 kB.
pub(crate) const CHUNK: usize = 1024;

/// Nodes that one thread takes at a time, approximately.
pub(crate) const BLOCK: usize = 1 << 15;

/// The layout of blocks: `lines` lines each, of `length` numbers `stride` apart.
struct ChunkLayout {
    length: usize,
    stride: usize,
    lines: usize,
}

impl ChunkLayout {
    /// Rows without gaps are one long line, divided anywhere.
    fn of<T: Real>(planes: &Planes<'_, T>) -> Self {
        let (stride, columns) = (planes.stride(), planes.shape().columns());
        if stride == columns {
            ChunkLayout { length: BLOCK, stride: BLOCK, lines: 1 }
        } else {
            ChunkLayout { length: columns, stride, lines: (BLOCK / stride).max(1) }
        }
    }

    fn block(&self) -> usize {
        self.lines * self.stride
    }
}

/// Calls `work` with the number of the first node and the coordinates of each chunk of at most
/// `max` nodes, in parallel. The error is that of the first chunk that fails; other chunks may be
/// changed.
pub(crate) fn for_each_chunk_mut<T: Real>(
    planes: &mut Planes<'_, T>,
    threads: usize,
    max: usize,
    work: impl Fn(usize, [&mut [T]; 3]) -> Result<()> + Sync,
) -> Result<()> {
    let layout = ChunkLayout::of(planes);
    let [x, y, z] = planes.matrices_mut().map(|matrix| matrix.chunks_mut(layout.block()));
    let results = par::map(threads, x.zip(y).zip(z).enumerate(), |(block, ((x, y), z))| {
        let [x, y, z] = [x, y, z].map(|matrix| matrix.chunks_mut(layout.stride));
        x.zip(y).zip(z).enumerate().try_for_each(|(line, ((x, y), z))| {
            let first = (block * layout.lines + line) * layout.length;
            let length = x.len().min(layout.length);
            let [x, y, z] = [x, y, z].map(|row| row[..length].chunks_mut(max));
            x.zip(y).zip(z).enumerate().try_for_each(|(k, ((x, y), z))| work(first + k * max, [x, y, z]))
        })
    });
    results.into_iter().collect()
}

/// As [`for_each_chunk_mut`], in the order of the nodes and on this thread. Stops at the first
/// error.
pub(crate) fn for_each_chunk_in_order<T: Real>(
    planes: &mut Planes<'_, T>,
    mut work: impl FnMut(usize, [&mut [T]; 3]) -> Result<()>,
) -> Result<()> {
    let ChunkLayout { length, stride, .. } = ChunkLayout::of(planes);
    let [x, y, z] = planes.matrices_mut().map(|matrix| matrix.chunks_mut(stride));
    x.zip(y).zip(z).enumerate().try_for_each(|(line, ((x, y), z))| {
        let length_here = x.len().min(length);
        let [x, y, z] = [x, y, z].map(|row| row[..length_here].chunks_mut(4 * CHUNK));
        x.zip(y).zip(z).enumerate().try_for_each(|(k, ((x, y), z))| work(line * length + k * 4 * CHUNK, [x, y, z]))
    })
}

/// As [`for_each_chunk_mut`], read-only, [`CHUNK`] nodes at a time.
pub(crate) fn for_each_chunk<T: Real>(
    planes: &Planes<'_, T>,
    threads: usize,
    work: impl Fn(usize, [&[T]; 3]) -> Result<()> + Sync,
) -> Result<()> {
    let layout = ChunkLayout::of(planes);
    let [x, y, z] = planes.matrices().map(|matrix| matrix.chunks(layout.block()));
    let results = par::map(threads, x.zip(y).zip(z).enumerate(), |(block, ((x, y), z))| {
        let [x, y, z] = [x, y, z].map(|matrix| matrix.chunks(layout.stride));
        x.zip(y).zip(z).enumerate().try_for_each(|(line, ((x, y), z))| {
            let first = (block * layout.lines + line) * layout.length;
            let length = x.len().min(layout.length);
            let [x, y, z] = [x, y, z].map(|row| row[..length].chunks(CHUNK));
            x.zip(y).zip(z).enumerate().try_for_each(|(k, ((x, y), z))| work(first + k * CHUNK, [x, y, z]))
        })
    });
    results.into_iter().collect()
}

/// The results of `work` for each row of `width` values, in order, computed in parallel;
/// cancellable between blocks of rows.
pub(crate) fn map_rows<V: Send, R: Send>(
    values: &mut [V],
    width: usize,
    (job, stage): (&Job<'_>, &'static str),
    work: impl Fn(usize, &mut [V]) -> R + Sync,
) -> Result<impl Iterator<Item = R>> {
    let lines = (BLOCK / width).max(1);
    let blocks = par::map_cancellable(job, stage, values.chunks_mut(lines * width).enumerate(), |(block, values)| {
        let rows = values.chunks_mut(width).enumerate();
        rows.map(|(line, row)| work(block * lines + line, row)).collect::<Vec<R>>()
    })?;
    Ok(blocks.into_iter().flatten())
}

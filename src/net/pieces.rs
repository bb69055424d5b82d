//! Coordinates in pieces: consecutive nodes, few enough for the nearest cache, handed out to threads.

use super::{Planes, Real};
use crate::error::Result;
use crate::job::Job;
use crate::par;

/// The most nodes of a piece: three rows of `f64` take 24 kB.
pub(crate) const PIECE: usize = 1024;

/// About so many nodes are one thread's work at a time.
pub(crate) const BLOCK: usize = 1 << 15;

/// How matrices are cut: blocks of `lines` lines, each `length` numbers of `stride`.
struct Cut {
    length: usize,
    stride: usize,
    lines: usize,
}

impl Cut {
    /// Rows without gaps are one long line, cut anywhere.
    fn of<T: Real>(planes: &Planes<'_, T>) -> Self {
        let (stride, columns) = (planes.stride(), planes.shape().columns());
        if stride == columns {
            Cut { length: BLOCK, stride: BLOCK, lines: 1 }
        } else {
            Cut { length: columns, stride, lines: (BLOCK / stride).max(1) }
        }
    }

    fn block(&self) -> usize {
        self.lines * self.stride
    }
}

/// Calls `work` with the number of the first node and the coordinates of each piece of at most `most` nodes, on many
/// threads. The error is that of the first piece that has one; pieces elsewhere are changed nevertheless.
pub(crate) fn change<T: Real>(
    planes: &mut Planes<'_, T>,
    threads: usize,
    most: usize,
    work: impl Fn(usize, [&mut [T]; 3]) -> Result<()> + Sync,
) -> Result<()> {
    let cut = Cut::of(planes);
    let [x, y, z] = planes.matrices_mut().map(|matrix| matrix.chunks_mut(cut.block()));
    let results = par::map(threads, x.zip(y).zip(z).enumerate(), |(block, ((x, y), z))| {
        let [x, y, z] = [x, y, z].map(|matrix| matrix.chunks_mut(cut.stride));
        x.zip(y).zip(z).enumerate().try_for_each(|(line, ((x, y), z))| {
            let first = (block * cut.lines + line) * cut.length;
            let length = x.len().min(cut.length);
            let [x, y, z] = [x, y, z].map(|row| row[..length].chunks_mut(most));
            x.zip(y).zip(z).enumerate().try_for_each(|(k, ((x, y), z))| work(first + k * most, [x, y, z]))
        })
    });
    results.into_iter().collect()
}

/// As [`change`], in the order of the nodes and on this thread, for what may not be called elsewhere. Stops at the
/// first error.
pub(crate) fn change_in_order<T: Real>(
    planes: &mut Planes<'_, T>,
    mut work: impl FnMut(usize, [&mut [T]; 3]) -> Result<()>,
) -> Result<()> {
    let Cut { length, stride, .. } = Cut::of(planes);
    let [x, y, z] = planes.matrices_mut().map(|matrix| matrix.chunks_mut(stride));
    x.zip(y).zip(z).enumerate().try_for_each(|(line, ((x, y), z))| {
        let length_here = x.len().min(length);
        let [x, y, z] = [x, y, z].map(|row| row[..length_here].chunks_mut(4 * PIECE));
        x.zip(y).zip(z).enumerate().try_for_each(|(k, ((x, y), z))| work(line * length + k * 4 * PIECE, [x, y, z]))
    })
}

/// As [`change`], to read only, [`PIECE`] nodes at a time.
pub(crate) fn scan<T: Real>(
    planes: &Planes<'_, T>,
    threads: usize,
    work: impl Fn(usize, [&[T]; 3]) -> Result<()> + Sync,
) -> Result<()> {
    let cut = Cut::of(planes);
    let [x, y, z] = planes.matrices().map(|matrix| matrix.chunks(cut.block()));
    let results = par::map(threads, x.zip(y).zip(z).enumerate(), |(block, ((x, y), z))| {
        let [x, y, z] = [x, y, z].map(|matrix| matrix.chunks(cut.stride));
        x.zip(y).zip(z).enumerate().try_for_each(|(line, ((x, y), z))| {
            let first = (block * cut.lines + line) * cut.length;
            let length = x.len().min(cut.length);
            let [x, y, z] = [x, y, z].map(|row| row[..length].chunks(PIECE));
            x.zip(y).zip(z).enumerate().try_for_each(|(k, ((x, y), z))| work(first + k * PIECE, [x, y, z]))
        })
    });
    results.into_iter().collect()
}

/// Calls `work` with the number and the values of each row of `width` values, on many threads; a small net is one
/// thread's work. The host is heard between blocks of rows.
pub(crate) fn rows<V: Send, R: Send>(
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

//! New coordinate matrices of rearranged nodes, written row by row on many threads.
//!
//! Invariant: coordinates keep their bits, NaN payloads included. O(nodes), bound by memory.

use crate::alloc;
use crate::error::Result;
use crate::job::Job;
use crate::net::{Coordinates, Planes, Real, Shape, each};
use crate::par;
use std::ops::Range;

/// Numbers that one thread writes at a time: enough to outweigh starting it.
const BLOCK: usize = 1 << 16;

/// Allocations of at least this many bytes come zeroed from the system; below, one thread suffices.
const MIN_FRESH_BYTES: usize = 1 << 25;

/// Matrices whose rows `write` fills, a range at a time, of X, Y or Z (0, 1, 2).
pub(crate) fn build_planes<T: Real>(
    shape: Shape,
    job: &Job<'_>,
    write: impl Fn(usize, Range<usize>, &mut [T]) + Sync,
) -> Result<Planes<'static, T>> {
    let columns = shape.columns();
    if 3 * shape.node_count() * size_of::<T>() < MIN_FRESH_BYTES && columns <= BLOCK {
        job.step(0.0, "nodes")?;
        let planes = Planes::from_rows(shape, write)?;
        job.step(1.0, "nodes")?;
        return Ok(planes);
    }
    let mut planes = Planes::zeroed(shape)?;
    let height = (BLOCK / columns).clamp(1, shape.rows());
    let mut blocks = alloc::with_capacity(3 * shape.rows().div_ceil(height))?;
    for (axis, matrix) in planes.matrices_mut().into_iter().enumerate() {
        blocks.extend(matrix.chunks_mut(height * columns).enumerate().map(|(k, block)| (axis, k * height, block)));
    }
    job.step(0.0, "nodes")?;
    par::map(job.threads(), blocks.into_iter(), |(axis, first, block)| {
        write(axis, first..first + block.len() / columns, block);
    });
    job.step(1.0, "nodes")?;
    Ok(planes)
}

/// A map from the nodes of a new matrix to those of an old one.
pub(crate) trait Rearrangement: Sync {
    /// The size of the new matrices.
    fn shape(&self) -> Shape;

    /// Fills rows of the new matrix from the old one, whose rows lie `stride` apart.
    fn write<T: Real>(&self, rows: Range<usize>, from: &[T], stride: usize, to: &mut [T]);
}

/// The three matrices under one rearrangement, bit for bit.
pub(crate) fn rearrange(
    coordinates: &Coordinates<'_>,
    map: &impl Rearrangement,
    job: &Job<'_>,
) -> Result<Coordinates<'static>> {
    each!(coordinates, from => {
        let (matrices, stride) = (from.matrices(), from.stride());
        let write = |axis: usize, rows, to: &mut _| map.write(rows, matrices[axis], stride, to);
        build_planes(map.shape(), job, write).map(Coordinates::from)
    })
}

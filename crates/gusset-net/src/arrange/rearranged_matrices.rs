//! New coordinate matrices of rearranged nodes, written row by row on many threads.
//!
//! Invariant: coordinates keep their bits, NaN payloads included. O(nodes), bound by memory.

use crate::{Coordinates, Direction, Real, Shape, XyzMatrices, each};
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_base::par;
use std::ops::Range;

/// Numbers that one thread writes at a time: enough to outweigh starting it.
const NUMBERS_PER_BLOCK: usize = 1 << 16;

/// Matrices of at least this many bytes together are written in parallel. The system zeroes such
/// allocations.
const MIN_PARALLEL_BYTES: usize = 1 << 25;

/// Creates the matrices X, Y and Z (0, 1, 2), whose rows `write_rows` fills a range at a time.
pub(crate) fn build_matrices<T: Real>(
    shape: Shape,
    job: &Job<'_>,
    write_rows: impl Fn(usize, Range<usize>, &mut [T]) + Sync,
) -> Result<XyzMatrices<'static, T>> {
    let columns = shape.columns();
    if shape.node_count().saturating_mul(3 * size_of::<T>()) < MIN_PARALLEL_BYTES && columns <= NUMBERS_PER_BLOCK {
        job.step(0.0, "nodes")?;
        let planes = XyzMatrices::from_rows(shape, write_rows)?;
        job.step(1.0, "nodes")?;
        return Ok(planes);
    }
    let mut planes = XyzMatrices::zeroed(shape)?;
    let height = (NUMBERS_PER_BLOCK / columns).clamp(1, shape.rows());
    let mut blocks = alloc::with_capacity(3 * shape.rows().div_ceil(height))?;
    for (axis, matrix) in planes.matrices_mut().into_iter().enumerate() {
        blocks.extend(matrix.chunks_mut(height * columns).enumerate().map(|(k, block)| (axis, k * height, block)));
    }
    job.step(0.0, "nodes")?;
    par::map(job.requested_threads(), blocks.into_iter(), |(axis, first, block)| {
        write_rows(axis, first..first + block.len() / columns, block);
    })?;
    job.step(1.0, "nodes")?;
    Ok(planes)
}

/// A map from the nodes of a new matrix to the nodes of an old one.
pub(crate) enum Rearrangement<'a> {
    /// The rectangle that starts at (row, column).
    Part { row: usize, column: usize },
    /// Rows (`Down`) or columns reversed.
    Flipped(Direction),
    /// Rows and columns exchanged.
    Transposed,
    /// New row i is old row `rows[i]`, and likewise columns.
    Selection { rows: &'a [u32], columns: &'a [u32] },
}

/// The side of a square tile that fits in the cache together with its image.
const TRANSPOSE_TILE_SIDE: usize = 16;

impl Rearrangement<'_> {
    /// Fills rows of a new matrix of `shape` from the old one, whose rows lie `stride` apart.
    fn write_rows<T: Real>(&self, shape: Shape, rows: Range<usize>, from: &[T], stride: usize, to: &mut [T]) {
        let columns = shape.columns();
        let first = rows.start;
        let lines = rows.zip(to.chunks_exact_mut(columns));
        match *self {
            Rearrangement::Part { row, column } => {
                lines.for_each(|(i, to)| to.copy_from_slice(&from[(row + i) * stride + column..][..columns]));
            }
            Rearrangement::Flipped(Direction::Down) => {
                lines.for_each(|(i, to)| to.copy_from_slice(&from[(shape.rows() - 1 - i) * stride..][..columns]));
            }
            Rearrangement::Flipped(Direction::Right) => {
                for (i, to) in lines {
                    let from = &from[i * stride..][..columns];
                    to.iter_mut().zip(from.iter().rev()).for_each(|(to, from)| *to = *from);
                }
            }
            Rearrangement::Selection { rows, columns } => {
                lines.for_each(|(i, to)| copy_selected_columns(&from[rows[i] as usize * stride..], columns, to));
            }
            Rearrangement::Transposed => transpose_rows(first, columns, from, stride, to),
        }
    }
}

/// Selected numbers of a row, in runs: all at once where none is dropped or repeated.
fn copy_selected_columns<T: Real>(from: &[T], columns: &[u32], to: &mut [T]) {
    let mut done = 0;
    for run in columns.chunk_by(|a, b| a + 1 == *b) {
        to[done..done + run.len()].copy_from_slice(&from[run[0] as usize..][..run.len()]);
        done += run.len();
    }
}

/// Fills rows of the transposed matrix from row `first` on, tile by tile.
fn transpose_rows<T: Real>(first: usize, columns: usize, from: &[T], stride: usize, to: &mut [T]) {
    for (tile, to) in to.chunks_mut(TRANSPOSE_TILE_SIDE * columns).enumerate() {
        let first = first + tile * TRANSPOSE_TILE_SIDE;
        let height = to.len() / columns;
        for left in (0..columns).step_by(TRANSPOSE_TILE_SIDE) {
            for j in left..columns.min(left + TRANSPOSE_TILE_SIDE) {
                let from = &from[j * stride + first..][..height];
                from.iter().enumerate().for_each(|(i, &value)| to[i * columns + j] = value);
            }
        }
    }
}

/// Returns the three matrices of a new shape under one rearrangement, bit for bit.
pub(crate) fn rearrange_coordinates(
    coordinates: &Coordinates<'_>,
    shape: Shape,
    rearrangement: &Rearrangement<'_>,
    job: &Job<'_>,
) -> Result<Coordinates<'static>> {
    each!(coordinates, from => {
        let (matrices, stride) = (from.matrices(), from.stride());
        let write = |axis: usize, rows, to: &mut _| rearrangement.write_rows(shape, rows, matrices[axis], stride, to);
        build_matrices(shape, job, write).map(Coordinates::from)
    })
}

//! Writing the rows of new matrices, on many threads.

use crate::alloc;
use crate::error::Result;
use crate::job::Job;
use crate::net::{Coordinates, Planes, Real, Shape};
use crate::par;
use std::ops::Range;

/// Numbers that one thread writes at a time: enough for starting it to be worth while.
const BLOCK: usize = 1 << 16;

/// Bytes from which on the system gives out memory that is zero and was not used before; below, one thread is enough too.
const FRESH: usize = 1 << 25;

/// New matrices of one type: `write` fills the rows of a range, one after the other, of matrix X, Y or Z (0, 1, 2).
pub(crate) fn planes<T: Real>(
    shape: Shape,
    job: &Job<'_>,
    write: impl Fn(usize, Range<usize>, &mut [T]) + Sync,
) -> Result<Planes<'static, T>> {
    let columns = shape.columns();
    if 3 * shape.node_count() * size_of::<T>() < FRESH && columns <= BLOCK {
        job.step(0.0, "nodes")?;
        let planes = Planes::written(shape, write)?;
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

/// Which nodes of a matrix become a new one.
pub(crate) trait Rearrange: Sync {
    /// The size of the new matrices.
    fn shape(&self) -> Shape;

    /// Fills rows of the new matrix from the old one, whose rows lie `stride` apart.
    fn write<T: Real>(&self, rows: Range<usize>, from: &[T], stride: usize, to: &mut [T]);
}

/// The three matrices rearranged alike, bit for bit.
pub(crate) fn rearranged(
    coordinates: &Coordinates<'_>,
    how: &impl Rearrange,
    job: &Job<'_>,
) -> Result<Coordinates<'static>> {
    fn all<T: Real>(from: &Planes<'_, T>, how: &impl Rearrange, job: &Job<'_>) -> Result<Planes<'static, T>> {
        let (matrices, stride) = (from.matrices(), from.stride());
        planes(how.shape(), job, |axis, rows, to| how.write(rows, matrices[axis], stride, to))
    }
    Ok(match coordinates {
        Coordinates::F32(from) => Coordinates::F32(all(from, how, job)?),
        Coordinates::F64(from) => Coordinates::F64(all(from, how, job)?),
    })
}

impl<'a> From<Planes<'a, f32>> for Coordinates<'a> {
    fn from(planes: Planes<'a, f32>) -> Self {
        Coordinates::F32(planes)
    }
}

impl<'a> From<Planes<'a, f64>> for Coordinates<'a> {
    fn from(planes: Planes<'a, f64>) -> Self {
        Coordinates::F64(planes)
    }
}

//! The three coordinate matrices X, Y, Z of a net (Deryagin, "Model"), owned or borrowed from the
//! host.
//!
//! Structure of arrays: every owned matrix starts at a cache line, and loops over its rows
//! vectorise. 12 or 24 bytes a node.

use super::Real;
use super::shape::{Shape, rows_and_columns_of_corners};
use bytemuck::Zeroable;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use std::ops::Range;

/// Numbers in the buffer of [`XyzMatrices::from_rows`].
const ROW_BUFFER_LENGTH: usize = 1 << 13;

/// The unit of storage. The system returns memory of this alignment zeroed and untouched. At the
/// alignment of a cache line the allocator would clear it itself.
#[derive(Debug, Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C, align(16))]
struct AlignedChunk([u8; 16]);

/// Bytes of a cache line.
const CACHE_LINE_BYTES: usize = 64;
const CHUNKS_PER_CACHE_LINE: usize = CACHE_LINE_BYTES / size_of::<AlignedChunk>();

/// X, Y, Z: three matrices of `rows x columns` numbers, row after row, each row `stride` numbers
/// after the one before.
#[derive(Debug)]
pub struct XyzMatrices<'a, T> {
    shape: Shape,
    stride: usize,
    store: MatrixStorage<'a, T>,
}

#[derive(Debug)]
enum MatrixStorage<'a, T> {
    /// One allocation: X starts at chunk `start`, a cache line, and X, Y and Z take `each` chunks.
    Own { chunks: Vec<AlignedChunk>, start: usize, each: usize },
    /// The host's memory.
    Borrowed([&'a mut [T]; 3]),
}

/// Returns the first chunk at the start of a cache line.
fn first_aligned_chunk(chunks: &[AlignedChunk]) -> usize {
    chunks.as_ptr().align_offset(CACHE_LINE_BYTES).min(CHUNKS_PER_CACHE_LINE - 1)
}

impl<'a, T: Real> XyzMatrices<'a, T> {
    /// Creates owned matrices of zeros, without gaps between rows.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`].
    #[inline]
    pub fn zeroed(shape: Shape) -> Result<Self> {
        let each = shape.node_count().saturating_mul(size_of::<T>()).div_ceil(CACHE_LINE_BYTES) * CHUNKS_PER_CACHE_LINE;
        let chunks: Vec<AlignedChunk> = alloc::zeroed(CHUNKS_PER_CACHE_LINE - 1 + 3 * each)?;
        let start = first_aligned_chunk(&chunks);
        Ok(XyzMatrices { shape, stride: shape.columns(), store: MatrixStorage::Own { chunks, start, each } })
    }

    /// Creates owned matrices in a single write: `write` fills X, Y and Z (0, 1, 2) in order, some
    /// rows at a time.
    ///
    /// [`XyzMatrices::zeroed`] would have to clear recycled memory, which takes as long as copying
    /// to it. Here rows pass through a buffer that stays in the cache.
    pub(crate) fn from_rows(shape: Shape, mut write_rows: impl FnMut(usize, Range<usize>, &mut [T])) -> Result<Self> {
        let (rows, columns, per_chunk) = (shape.rows(), shape.columns(), size_of::<AlignedChunk>() / size_of::<T>());
        let each = shape.node_count().div_ceil(CHUNKS_PER_CACHE_LINE * per_chunk) * CHUNKS_PER_CACHE_LINE;
        let height = (ROW_BUFFER_LENGTH / columns).clamp(1, rows);
        let mut chunks: Vec<AlignedChunk> = alloc::with_capacity(CHUNKS_PER_CACHE_LINE - 1 + 3 * each)?;
        let start = first_aligned_chunk(&chunks);
        let mut buffer: Vec<AlignedChunk> = alloc::zeroed((height * columns + per_chunk - 1).div_ceil(per_chunk))?;
        for axis in 0..3 {
            chunks.resize(start + axis * each, AlignedChunk::zeroed());
            // Numbers at the start of the buffer that do not fill a chunk yet.
            let mut held = 0;
            for first in (0..rows).step_by(height) {
                let range = first..rows.min(first + height);
                let end = held + range.len() * columns;
                write_rows(axis, range, &mut bytemuck::cast_slice_mut(&mut buffer)[held..end]);
                let full = end / per_chunk;
                chunks.extend_from_slice(&buffer[..full]);
                held = end % per_chunk;
                if held > 0 {
                    buffer[0] = buffer[full];
                }
            }
            if held > 0 {
                chunks.push(buffer[0]);
            }
        }
        chunks.resize(start + 3 * each, AlignedChunk::zeroed());
        Ok(XyzMatrices { shape, stride: columns, store: MatrixStorage::Own { chunks, start, each } })
    }

    /// Creates borrowed matrices, which are read and written in place. `stride` is the distance
    /// between rows in numbers; 0 means rows without gaps. The last row needs only its own numbers.
    ///
    /// # Errors
    /// [`Error::StrideTooSmall`], [`Error::SizeOverflow`], [`Error::ArrayTooShort`].
    pub fn borrowed(shape: Shape, stride: usize, matrices: [&'a mut [T]; 3]) -> Result<Self> {
        let needed = Self::matrix_length(shape, stride)?;
        if let Some(short) = matrices.iter().find(|matrix| matrix.len() < needed) {
            let (needed, given) = ((needed * size_of::<T>()) as u64, size_of_val::<[T]>(*short) as u64);
            return Err(Error::ArrayTooShort { what: "coordinates", needed, given });
        }
        let stride = if stride == 0 { shape.columns() } else { stride };
        let store = MatrixStorage::Borrowed(matrices.map(|matrix| &mut matrix[..needed]));
        Ok(XyzMatrices { shape, stride, store })
    }

    /// Returns the numbers that one matrix spans.
    ///
    /// # Errors
    /// [`Error::StrideTooSmall`], [`Error::SizeOverflow`].
    pub fn matrix_length(shape: Shape, stride: usize) -> Result<usize> {
        let columns = shape.columns();
        if stride != 0 && stride < columns {
            return Err(Error::StrideTooSmall { what: "rows", stride: stride as u64, min: columns as u64 });
        }
        let stride = if stride == 0 { columns } else { stride };
        let length = (shape.rows() - 1).checked_mul(stride).and_then(|n| n.checked_add(columns));
        length
            .filter(|&n| n <= isize::MAX as usize / size_of::<T>())
            .ok_or(Error::SizeOverflow { what: "coordinates", count: shape.node_count() as u64 })
    }

    /// Returns the size of the matrices.
    #[inline]
    pub fn shape(&self) -> Shape {
        self.shape
    }

    /// Numbers from row to row.
    #[inline]
    pub fn stride(&self) -> usize {
        self.stride
    }

    /// Returns true for borrowed memory.
    #[inline]
    pub fn is_borrowed(&self) -> bool {
        matches!(self.store, MatrixStorage::Borrowed(_))
    }

    /// Returns the matrices X, Y, Z, with the gaps between their rows.
    pub fn matrices(&self) -> [&[T]; 3] {
        let length = (self.shape.rows() - 1) * self.stride + self.shape.columns();
        match &self.store {
            MatrixStorage::Own { chunks, start, each } => [0, 1, 2].map(|axis| {
                let from = start + axis * each;
                &bytemuck::cast_slice(&chunks[from..from + each])[..length]
            }),
            MatrixStorage::Borrowed(matrices) => [0, 1, 2].map(|axis| &matrices[axis][..]),
        }
    }

    /// [`XyzMatrices::matrices`], mutable.
    pub fn matrices_mut(&mut self) -> [&mut [T]; 3] {
        let length = (self.shape.rows() - 1) * self.stride + self.shape.columns();
        match &mut self.store {
            MatrixStorage::Own { chunks, start, each } => {
                let (x, rest) = chunks[*start..].split_at_mut(*each);
                let (y, z) = rest.split_at_mut(*each);
                [x, y, &mut z[..*each]].map(|chunks| &mut bytemuck::cast_slice_mut(chunks)[..length])
            }
            MatrixStorage::Borrowed([x, y, z]) => [x, y, z].map(|matrix| &mut matrix[..]),
        }
    }

    /// Row i of X, Y and Z.
    #[inline]
    pub fn row(&self, i: usize) -> [&[T]; 3] {
        let start = i * self.stride;
        self.matrices().map(|matrix| &matrix[start..start + self.shape.columns()])
    }

    /// [`XyzMatrices::row`], mutable.
    #[inline]
    pub fn row_mut(&mut self, i: usize) -> [&mut [T]; 3] {
        let (start, columns) = (i * self.stride, self.shape.columns());
        self.matrices_mut().map(|matrix| &mut matrix[start..start + columns])
    }

    /// Node (i, j) in double precision, which is exact.
    #[inline]
    pub fn get(&self, i: usize, j: usize) -> DVec3 {
        let [x, y, z] = self.matrices().map(|matrix| matrix[i * self.stride + j].into());
        DVec3::new(x, y, z)
    }

    /// Returns the corners of cell (i, j), in the order of [`Shape::corners_of_cell`].
    #[inline]
    pub(crate) fn cell_corners(&self, i: usize, j: usize) -> [DVec3; 4] {
        rows_and_columns_of_corners(i, j).map(|(i, j)| self.get(i, j))
    }

    /// Moves node (i, j), rounding to the type of the coordinates.
    #[inline]
    pub fn set(&mut self, i: usize, j: usize, position: DVec3) {
        let at = i * self.stride + j;
        for (matrix, value) in self.matrices_mut().into_iter().zip(position.to_array()) {
            matrix[at] = T::from_f64(value);
        }
    }

    /// Returns an owned copy, bit for bit.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`].
    #[inline]
    pub fn copied(&self) -> Result<XyzMatrices<'static, T>> {
        self.converted(<[T]>::copy_from_slice)
    }

    /// Returns a copy in another type; `convert` writes a row of one coordinate.
    pub(crate) fn converted<B: Real>(&self, convert_row: impl Fn(&mut [B], &[T])) -> Result<XyzMatrices<'static, B>> {
        let mut copy = XyzMatrices::zeroed(self.shape)?;
        for i in 0..self.shape.rows() {
            copy.row_mut(i).into_iter().zip(self.row(i)).for_each(|(to, from)| convert_row(to, from));
        }
        Ok(copy)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn owned_matrices_start_at_cache_lines() {
        for (rows, columns) in [(2, 2), (3, 5), (17, 33), (300, 301)] {
            let shape = Shape::new(rows, columns).unwrap();
            let number = |axis: usize, at: usize| (100_000 * axis + at) as f32;
            let written = XyzMatrices::from_rows(shape, |axis, range, to: &mut [f32]| {
                to.iter_mut().zip(range.start * columns..).for_each(|(to, at)| *to = number(axis, at));
            });
            let written = written.unwrap();
            for (axis, matrix) in written.matrices().into_iter().enumerate() {
                assert_eq!(matrix.as_ptr().align_offset(CACHE_LINE_BYTES), 0);
                assert!(matrix.len() == rows * columns && (0..).zip(matrix).all(|(at, &x)| x == number(axis, at)));
            }
            let zeroed = XyzMatrices::<f64>::zeroed(shape).unwrap();
            for matrix in zeroed.matrices() {
                assert_eq!(matrix.as_ptr().align_offset(CACHE_LINE_BYTES), 0);
                assert!(matrix.len() == rows * columns && matrix.iter().all(|&x| x == 0.0));
            }
        }
    }
}

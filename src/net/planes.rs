//! The three coordinate matrices of a net, in memory of ours or of the host's.

use super::{Real, Shape};
use crate::alloc;
use crate::error::{Error, Result};
use bytemuck::Zeroable;
use glam::DVec3;
use std::ops::Range;

/// Numbers that are written at a time by [`Planes::written`].
const WRITTEN: usize = 1 << 13;

/// A quarter of a cache line. Whole ones, aligned, the allocator would clear by hand; memory of this alignment comes cleared from the
/// system, and is touched only when it is used.
#[derive(Debug, Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C, align(16))]
struct Quarter([u8; 16]);

const LINE: usize = 64;
/// Quarters in a line.
const QUARTERS: usize = LINE / size_of::<Quarter>();

/// X, Y, Z: three matrices of `rows x columns` numbers, row after row, each row `stride` numbers after the one before.
#[derive(Debug)]
pub struct Planes<'a, T> {
    shape: Shape,
    stride: usize,
    store: Store<'a, T>,
}

#[derive(Debug)]
enum Store<'a, T> {
    /// One allocation, of which X begins at `start` and takes `each` quarters, as Y and Z do: each begins on a line.
    Own { quarters: Vec<Quarter>, start: usize, each: usize },
    /// The host's.
    Borrowed([&'a mut [T]; 3]),
}

/// The quarter that the first line begins with.
fn first_of_line(quarters: &[Quarter]) -> usize {
    quarters.as_ptr().align_offset(LINE).min(QUARTERS - 1)
}

impl<'a, T: Real> Planes<'a, T> {
    /// Zeros, in memory of ours, without gaps between rows.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`].
    pub fn zeroed(shape: Shape) -> Result<Self> {
        let each = (shape.node_count() * size_of::<T>()).div_ceil(LINE) * QUARTERS;
        let quarters: Vec<Quarter> = alloc::zeroed(QUARTERS - 1 + 3 * each)?;
        let start = first_of_line(&quarters);
        Ok(Planes { shape, stride: shape.columns(), store: Store::Own { quarters, start, each } })
    }

    /// Matrices in memory of ours, of which each number is written once: X, Y and Z (0, 1, 2) in turn, some rows at a time.
    ///
    /// Memory that was used before and is given out again would have to be zeroed for [`Planes::zeroed`], which takes as long
    /// as copying to it. Here rows go through a buffer that stays in the cache.
    pub(crate) fn written(shape: Shape, mut write: impl FnMut(usize, Range<usize>, &mut [T])) -> Result<Self> {
        let (rows, columns, per_quarter) = (shape.rows(), shape.columns(), size_of::<Quarter>() / size_of::<T>());
        let each = shape.node_count().div_ceil(QUARTERS * per_quarter) * QUARTERS;
        let height = (WRITTEN / columns).clamp(1, rows);
        let mut quarters: Vec<Quarter> = alloc::with_capacity(QUARTERS - 1 + 3 * each)?;
        let start = first_of_line(&quarters);
        let mut buffer: Vec<Quarter> = alloc::zeroed((height * columns + per_quarter - 1).div_ceil(per_quarter))?;
        for axis in 0..3 {
            quarters.resize(start + axis * each, Quarter::zeroed());
            // The numbers at the start of the buffer that do not fill a quarter yet.
            let mut held = 0;
            for first in (0..rows).step_by(height) {
                let range = first..rows.min(first + height);
                let end = held + range.len() * columns;
                write(axis, range, &mut bytemuck::cast_slice_mut(&mut buffer)[held..end]);
                let full = end / per_quarter;
                quarters.extend_from_slice(&buffer[..full]);
                held = end % per_quarter;
                if held > 0 {
                    buffer[0] = buffer[full];
                }
            }
            if held > 0 {
                quarters.push(buffer[0]);
            }
        }
        quarters.resize(start + 3 * each, Quarter::zeroed());
        Ok(Planes { shape, stride: columns, store: Store::Own { quarters, start, each } })
    }

    /// Matrices of the host's, read and written in place. `stride`: numbers from row to row, 0 for rows without gaps. The last
    /// row needs its own numbers only.
    ///
    /// # Errors
    /// [`Error::StrideTooSmall`], [`Error::SizeOverflow`], [`Error::ArrayTooShort`].
    pub fn borrowed(shape: Shape, stride: usize, matrices: [&'a mut [T]; 3]) -> Result<Self> {
        let needed = Self::length(shape, stride)?;
        if let Some(short) = matrices.iter().find(|matrix| matrix.len() < needed) {
            let (needed, given) = ((needed * size_of::<T>()) as u64, size_of_val::<[T]>(*short) as u64);
            return Err(Error::ArrayTooShort { what: "coordinates", needed, given });
        }
        let stride = if stride == 0 { shape.columns() } else { stride };
        let store = Store::Borrowed(matrices.map(|matrix| &mut matrix[..needed]));
        Ok(Planes { shape, stride, store })
    }

    /// The numbers that one matrix spans.
    ///
    /// # Errors
    /// [`Error::StrideTooSmall`], [`Error::SizeOverflow`].
    pub fn length(shape: Shape, stride: usize) -> Result<usize> {
        let columns = shape.columns();
        if stride != 0 && stride < columns {
            return Err(Error::StrideTooSmall { stride: stride as u64, min: columns as u64 });
        }
        let stride = if stride == 0 { columns } else { stride };
        let length = (shape.rows() - 1).checked_mul(stride).and_then(|n| n.checked_add(columns));
        length
            .filter(|&n| n <= isize::MAX as usize / size_of::<T>())
            .ok_or(Error::SizeOverflow { what: "coordinates", count: shape.node_count() as u64 })
    }

    /// The size of the matrices.
    pub fn shape(&self) -> Shape {
        self.shape
    }

    /// Numbers from row to row.
    pub fn stride(&self) -> usize {
        self.stride
    }

    /// True for memory of the host's.
    pub fn is_borrowed(&self) -> bool {
        matches!(self.store, Store::Borrowed(_))
    }

    /// The matrices X, Y, Z, with the gaps between their rows.
    pub fn matrices(&self) -> [&[T]; 3] {
        let length = (self.shape.rows() - 1) * self.stride + self.shape.columns();
        match &self.store {
            Store::Own { quarters, start, each } => [0, 1, 2].map(|axis| {
                let from = start + axis * each;
                &bytemuck::cast_slice(&quarters[from..from + each])[..length]
            }),
            Store::Borrowed(matrices) => [0, 1, 2].map(|axis| &matrices[axis][..]),
        }
    }

    /// The same, to be written to.
    pub fn matrices_mut(&mut self) -> [&mut [T]; 3] {
        let length = (self.shape.rows() - 1) * self.stride + self.shape.columns();
        match &mut self.store {
            Store::Own { quarters, start, each } => {
                let (x, rest) = quarters[*start..].split_at_mut(*each);
                let (y, z) = rest.split_at_mut(*each);
                [x, y, &mut z[..*each]].map(|quarters| &mut bytemuck::cast_slice_mut(quarters)[..length])
            }
            Store::Borrowed([x, y, z]) => [x, y, z].map(|matrix| &mut matrix[..]),
        }
    }

    /// Row i of X, Y and Z.
    pub fn row(&self, i: usize) -> [&[T]; 3] {
        let start = i * self.stride;
        self.matrices().map(|matrix| &matrix[start..start + self.shape.columns()])
    }

    /// The same, to be written to.
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

    /// Moves node (i, j), rounding to the type of the coordinates.
    #[inline]
    pub fn set(&mut self, i: usize, j: usize, position: DVec3) {
        let at = i * self.stride + j;
        for (matrix, value) in self.matrices_mut().into_iter().zip(position.to_array()) {
            matrix[at] = T::of(value);
        }
    }

    /// A copy in memory of ours, bit for bit.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`].
    pub fn copied(&self) -> Result<Planes<'static, T>> {
        let mut copy = Planes::zeroed(self.shape)?;
        for i in 0..self.shape.rows() {
            for (to, from) in copy.row_mut(i).into_iter().zip(self.row(i)) {
                to.copy_from_slice(from);
            }
        }
        Ok(copy)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn own_matrices_begin_on_lines() {
        for (rows, columns) in [(2, 2), (3, 5), (17, 33), (300, 301)] {
            let shape = Shape::new(rows, columns).unwrap();
            let number = |axis: usize, at: usize| (100_000 * axis + at) as f32;
            let written = Planes::written(shape, |axis, range, to: &mut [f32]| {
                to.iter_mut().zip(range.start * columns..).for_each(|(to, at)| *to = number(axis, at));
            });
            let written = written.unwrap();
            for (axis, matrix) in written.matrices().into_iter().enumerate() {
                assert_eq!(matrix.as_ptr().align_offset(LINE), 0);
                assert!(matrix.len() == rows * columns && (0..).zip(matrix).all(|(at, &x)| x == number(axis, at)));
            }
            let zeroed = Planes::<f64>::zeroed(shape).unwrap();
            for matrix in zeroed.matrices() {
                assert_eq!(matrix.as_ptr().align_offset(LINE), 0);
                assert!(matrix.len() == rows * columns && matrix.iter().all(|&x| x == 0.0));
            }
        }
    }
}

//! Uncompressed blocks: the rows of X, then of Y, then of Z, without gaps, in little-endian. Each
//! of the three starts at a multiple of 64 bytes from the start of the block. O(nodes).

use super::bytes::ByteReader;
use super::header::{RAW_BLOCK_ALIGNMENT, StreamInfo};
use super::levels::CoordinateBits;
use crate::XyzMatrices;
use gusset_base::alloc;
use gusset_base::error::Result;

/// Bytes of the rows of one matrix in a block, without and with padding.
fn matrix_bytes_and_padded<T: CoordinateBits>(info: &StreamInfo, block: usize) -> [usize; 2] {
    let size = info.block_rows(block).len() * info.shape.columns() * T::SIZE;
    [size, size.next_multiple_of(RAW_BLOCK_ALIGNMENT)]
}

/// # Errors
/// [`Error::OutOfMemory`](gusset_base::Error::OutOfMemory).
pub(super) fn encode_raw_block<T: CoordinateBits>(
    info: &StreamInfo,
    planes: &XyzMatrices<'_, T>,
    block: usize,
) -> Result<Vec<u8>> {
    let [size, aligned] = matrix_bytes_and_padded::<T>(info, block);
    let mut bytes: Vec<u8> = alloc::zeroed(3 * aligned)?;
    let row_size = info.shape.columns() * T::SIZE;
    for (axis, matrix) in bytes.chunks_exact_mut(aligned).enumerate() {
        for (i, row) in info.block_rows(block).zip(matrix[..size].chunks_exact_mut(row_size)) {
            let numbers = planes.row(i)[axis];
            row.chunks_exact_mut(T::SIZE).zip(numbers).for_each(|(to, number)| number.write_bytes(to));
        }
    }
    Ok(bytes)
}

/// # Errors
/// [`Error::BadStream`](gusset_base::Error::BadStream).
pub(super) fn decode_raw_block<T: CoordinateBits>(
    info: &StreamInfo,
    block: usize,
    mut from: ByteReader<'_>,
    to: [&mut [T]; 3],
) -> Result<()> {
    let [size, aligned] = matrix_bytes_and_padded::<T>(info, block);
    for matrix in to {
        let numbers = from.read_bytes(size)?;
        matrix.iter_mut().zip(numbers.chunks_exact(T::SIZE)).for_each(|(to, bytes)| *to = T::read_bytes(bytes));
        if from.read_bytes(aligned - size)?.iter().any(|&byte| byte != 0) {
            return Err(from.error_here("the padding of a block is not zero"));
        }
    }
    from.require_end()
}

//! Elements in a host's memory: each occupies some bytes at the start of a stride, at any
//! alignment.

use crate::error::{Error, Result};
use bytemuck::{AnyBitPattern, NoUninit};

/// `count` elements of `size` bytes, `stride` bytes apart.
#[derive(Debug, Clone, Copy)]
pub struct Strided<'a> {
    bytes: &'a [u8],
    stride: usize,
    size: usize,
    count: usize,
}

impl<'a> Strided<'a> {
    /// `bytes` begins with the first element. A stride of 0 means elements without gaps. `what`
    /// names the elements in errors.
    ///
    /// # Errors
    /// [`Error::ArrayTooShort`], and the errors of [`Strided::byte_span`].
    pub fn new(bytes: &'a [u8], count: usize, stride: usize, size: usize, what: &'static str) -> Result<Self> {
        let needed = Self::byte_span(count, stride, size, what)?;
        let stride = if stride == 0 { size } else { stride };
        match bytes.get(..needed) {
            Some(bytes) => Ok(Strided { bytes, stride, size, count }),
            None => Err(Error::ArrayTooShort { what, needed: needed as u64, given: bytes.len() as u64 }),
        }
    }

    pub fn packed<T: NoUninit>(elements: &'a [T]) -> Self {
        let size = size_of::<T>();
        Strided { bytes: bytemuck::cast_slice(elements), stride: size, size, count: elements.len() }
    }

    /// Returns the number of bytes from the start of the first element to the end of the last,
    /// which need not fill its stride.
    ///
    /// # Errors
    /// [`Error::StrideTooSmall`], [`Error::SizeOverflow`].
    pub fn byte_span(count: usize, stride: usize, size: usize, what: &'static str) -> Result<usize> {
        if stride != 0 && stride < size {
            return Err(Error::StrideTooSmall { what, stride: stride as u64, min: size as u64 });
        }
        let Some(gaps) = count.checked_sub(1) else {
            return Ok(0);
        };
        let bytes = gaps.checked_mul(stride.max(size)).and_then(|bytes| bytes.checked_add(size));
        bytes.filter(|&n| n <= isize::MAX as usize).ok_or(Error::SizeOverflow { what, count: count as u64 })
    }

    /// Returns the number of elements.
    #[inline]
    pub fn count(&self) -> usize {
        self.count
    }

    #[inline]
    pub fn bytes(&self, k: usize) -> &'a [u8] {
        &self.bytes[k * self.stride..][..self.size]
    }

    /// Reads element `k`. The type must have the size of the elements.
    #[inline]
    pub fn get<T: AnyBitPattern>(&self, k: usize) -> T {
        let at = k * self.stride;
        bytemuck::pod_read_unaligned(&self.bytes[at..at + size_of::<T>()])
    }

    /// Returns all bytes, if the elements are contiguous.
    #[inline]
    pub fn contiguous_bytes(&self) -> Option<&'a [u8]> {
        (self.stride == self.size).then_some(self.bytes)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn elements_are_read_at_any_stride_and_alignment() {
        for (stride, offset) in [(0, 0), (4, 1), (5, 2), (11, 3)] {
            let step = if stride == 0 { 4 } else { stride };
            let mut memory = vec![0xff; offset + 3 * step + 4];
            for k in 0..4u32 {
                memory[offset + k as usize * step..][..4].copy_from_slice(&(1000 + k).to_ne_bytes());
            }
            let all = Strided::new(&memory[offset..], 4, stride, 4, "numbers").unwrap();
            assert_eq!((0..4).map(|k| all.get::<u32>(k)).collect::<Vec<_>>(), [1000, 1001, 1002, 1003]);
            assert_eq!((all.count(), all.bytes(2)), (4, &1002u32.to_ne_bytes()[..]));
            assert_eq!(all.contiguous_bytes().is_some(), step == 4);
            assert_eq!(Strided::byte_span(4, stride, 4, "numbers"), Ok(3 * step + 4));
            // One byte too few.
            let short = Strided::new(&memory[offset + 1..], 4, stride, 4, "numbers");
            assert_eq!(
                short.err(),
                Some(Error::ArrayTooShort {
                    what: "numbers",
                    needed: (3 * step + 4) as u64,
                    given: (3 * step + 3) as u64,
                })
            );
        }
        assert_eq!(Strided::packed(&[7u32, 8]).get::<u32>(1), 8);
        assert_eq!(Strided::byte_span(0, 9, 4, "numbers"), Ok(0));
        assert_eq!(Strided::byte_span(1, 9, 4, "numbers"), Ok(4));
        assert_eq!(
            Strided::byte_span(2, 3, 4, "numbers"),
            Err(Error::StrideTooSmall { what: "numbers", stride: 3, min: 4 })
        );
        let overflow = Err(Error::SizeOverflow { what: "numbers", count: 3 });
        assert_eq!(Strided::byte_span(3, usize::MAX / 2, 4, "numbers"), overflow);
        assert_eq!(Strided::byte_span(3, isize::MAX as usize / 2, 4, "numbers"), overflow);
    }
}

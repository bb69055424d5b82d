//! Reading and writing little-endian numbers in byte buffers; every read is bounds-checked.

use gusset_base::alloc;
use gusset_base::error::{Error, Result};

/// Appends numbers to bytes.
#[derive(Debug, Default)]
pub(crate) struct ByteWriter {
    pub(crate) bytes: Vec<u8>,
}

impl ByteWriter {
    pub(crate) fn write_bytes(&mut self, bytes: &[u8]) -> Result<()> {
        alloc::append(&mut self.bytes, bytes)
    }

    pub(crate) fn write_u8(&mut self, value: u8) -> Result<()> {
        self.write_bytes(&[value])
    }

    pub(crate) fn write_u32(&mut self, value: u32) -> Result<()> {
        self.write_bytes(&value.to_le_bytes())
    }

    pub(crate) fn write_u64(&mut self, value: u64) -> Result<()> {
        self.write_bytes(&value.to_le_bytes())
    }

    pub(crate) fn write_f64(&mut self, value: f64) -> Result<()> {
        self.write_u64(value.to_bits())
    }

    /// LEB128: seven bits a byte, the low ones first; all but the last byte have their eighth bit
    /// set.
    pub(crate) fn write_varint(&mut self, mut value: u64) -> Result<()> {
        while value >= 0x80 {
            self.write_u8(value as u8 | 0x80)?;
            value >>= 7;
        }
        self.write_u8(value as u8)
    }

    /// Zigzag and LEB128: small numbers of either sign take few bytes.
    pub(crate) fn write_signed_varint(&mut self, value: i64) -> Result<()> {
        self.write_varint((value << 1 ^ value >> 63) as u64)
    }

    /// Zeros up to a multiple of `alignment`.
    pub(crate) fn pad_to_multiple(&mut self, alignment: usize) -> Result<()> {
        let missing = self.bytes.len().next_multiple_of(alignment) - self.bytes.len();
        self.write_zeros(missing)
    }

    pub(crate) fn write_zeros(&mut self, count: usize) -> Result<()> {
        alloc::reserve(&mut self.bytes, count)?;
        self.bytes.resize(self.bytes.len() + count, 0);
        Ok(())
    }
}

/// [`Error::BadStream`] at a byte of the stream.
pub(crate) fn bad_stream_error(what: &'static str, byte: u64) -> Error {
    Error::BadStream { what, byte }
}

/// Reads numbers from bytes; [`Error::BadStream`] where they end.
#[derive(Debug, Clone)]
pub(crate) struct ByteReader<'a> {
    bytes: &'a [u8],
    position: usize,
    /// The position of `bytes` in the stream.
    offset: u64,
}

impl<'a> ByteReader<'a> {
    pub(crate) fn new(bytes: &'a [u8], offset: u64) -> Self {
        ByteReader { bytes, position: 0, offset }
    }

    /// Returns the error at the current byte.
    pub(crate) fn error_here(&self, what: &'static str) -> Error {
        bad_stream_error(what, self.offset + self.position as u64)
    }

    /// Returns the position in the stream.
    pub(crate) fn position(&self) -> u64 {
        self.offset + self.position as u64
    }

    pub(crate) fn remaining_bytes(&self) -> usize {
        self.bytes.len() - self.position
    }

    pub(crate) fn read_bytes(&mut self, count: usize) -> Result<&'a [u8]> {
        if count > self.remaining_bytes() {
            return Err(bad_stream_error("it is cut off", self.offset + self.bytes.len() as u64));
        }
        let bytes = &self.bytes[self.position..self.position + count];
        self.position += count;
        Ok(bytes)
    }

    fn read_array<const N: usize>(&mut self) -> Result<[u8; N]> {
        let mut array = [0; N];
        array.copy_from_slice(self.read_bytes(N)?);
        Ok(array)
    }

    pub(crate) fn read_u8(&mut self) -> Result<u8> {
        Ok(self.read_array::<1>()?[0])
    }

    /// 0 or 1; `None` for another byte.
    pub(crate) fn read_flag(&mut self) -> Result<Option<bool>> {
        let byte = self.read_u8()?;
        Ok((byte <= 1).then_some(byte == 1))
    }

    pub(crate) fn read_u32(&mut self) -> Result<u32> {
        Ok(u32::from_le_bytes(self.read_array()?))
    }

    pub(crate) fn read_u64(&mut self) -> Result<u64> {
        Ok(u64::from_le_bytes(self.read_array()?))
    }

    pub(crate) fn read_f64(&mut self) -> Result<f64> {
        Ok(f64::from_bits(self.read_u64()?))
    }

    pub(crate) fn read_varint(&mut self) -> Result<u64> {
        let mut value = 0;
        for shift in (0..64).step_by(7) {
            let byte = self.read_u8()?;
            value |= u64::from(byte & 0x7f) << shift;
            // Each number has one encoding: without trailing zeros and without bits beyond the
            // 64th.
            if byte < 0x80 {
                let good = (byte > 0 || shift == 0) && (shift < 63 || byte == 1);
                return if good {
                    Ok(value)
                } else {
                    Err(self.error_here("the encoding of a number is not the shortest"))
                };
            }
        }
        Err(self.error_here("a number is too long"))
    }

    pub(crate) fn read_signed_varint(&mut self) -> Result<i64> {
        let value = self.read_varint()?;
        Ok((value >> 1) as i64 ^ -((value & 1) as i64))
    }

    pub(crate) fn read_varint_u32(&mut self) -> Result<u32> {
        let value = self.read_varint()?;
        u32::try_from(value).map_err(|_| self.error_here("a number is too large"))
    }

    pub(crate) fn read_signed_i32(&mut self) -> Result<i32> {
        let value = self.read_signed_varint()?;
        i32::try_from(value).map_err(|_| self.error_here("a number is too large"))
    }

    /// Requires that all bytes were read.
    pub(crate) fn require_end(self) -> Result<()> {
        if self.remaining_bytes() == 0 { Ok(()) } else { Err(self.error_here("there are bytes after the end")) }
    }
}

/// Returns the checksum of blocks and headers.
pub(crate) fn checksum(bytes: &[u8]) -> u32 {
    crc32fast::hash(bytes)
}

//! The header of a stream: 128 bytes, checked field by field.

use super::bytes::{ByteReader, ByteWriter, bad_stream_error, checksum};
use crate::Shape;
use gusset_base::error::Result;
use gusset_mesh::Scalar;

/// The bytes of a header.
pub const HEADER_SIZE: usize = 128;
/// A non-text byte, a name, and line ends that a transfer as text would alter.
const MAGIC: [u8; 8] = *b"\x8bTRN\r\n\x1a\n";
/// The version of the format.
const FORMAT_VERSION: u32 = 1;
/// The largest number of nodes per byte. Encoders pad shorter streams, so that a short stream
/// cannot demand much memory.
pub(super) const MAX_NODES_PER_BYTE: u64 = 4096;
/// The alignment of blocks in a raw stream.
pub(super) const RAW_BLOCK_ALIGNMENT: usize = 64;

/// The storage of coordinates.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum StreamMode {
    /// Uncompressed, aligned to 64 bytes.
    Raw,
    /// Compressed, bit for bit.
    Lossless,
    /// Compressed, rounded to the levels `origin + k * step` of each axis.
    Quantised {
        /// Levels go from 0 to 2^bits - 1.
        bits: u32,
    },
}

/// The contents of the header.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StreamInfo {
    /// The size of the net.
    pub shape: Shape,
    /// The type of its coordinates.
    pub scalar: Scalar,
    /// Their storage.
    pub mode: StreamMode,
    /// Rows in each block; the last one may have fewer.
    pub rows_per_block: usize,
    /// For [`StreamMode::Quantised`], the coordinates of level 0.
    pub origin: [f64; 3],
    /// For [`StreamMode::Quantised`], the distance of levels. The error of a coordinate is at most
    /// half of it and half a unit in the last place.
    pub step: [f64; 3],
    /// Bytes before the first block.
    pub prelude_size: u64,
    /// Whether only the first node of each class of glued nodes is stored.
    pub(super) stores_one_node_per_class: bool,
    /// For [`StreamMode::Lossless`], the bits of the coordinates of missing nodes.
    pub(super) bits_of_missing_node: [u64; 3],
    /// The order of coordinates, one of six.
    pub(super) coordinate_order: u8,
    /// Bytes of topology and bridges, and the checksum of these and the table of blocks.
    pub(super) structure_size: u64,
    pub(super) checksum: u32,
}

impl StreamInfo {
    /// Returns the header of an empty stream.
    pub(super) fn new(shape: Shape, scalar: Scalar, mode: StreamMode, rows_per_block: usize) -> Self {
        StreamInfo {
            shape,
            scalar,
            mode,
            rows_per_block,
            origin: [0.0; 3],
            step: [0.0; 3],
            prelude_size: 0,
            stores_one_node_per_class: false,
            bits_of_missing_node: [0; 3],
            coordinate_order: 0,
            structure_size: 0,
            checksum: 0,
        }
    }

    /// Reads the first [`HEADER_SIZE`] bytes of a stream. O(1).
    ///
    /// # Errors
    /// [`Error::BadStream`](gusset_base::Error::BadStream).
    pub fn read(bytes: &[u8]) -> Result<Self> {
        // Reports other bytes first, before any other fault.
        if bytes.iter().zip(&MAGIC).any(|(byte, own)| byte != own) {
            return Err(bad_stream_error("it does not begin as a stream of a net does", 0));
        }
        let header = bytes.get(..HEADER_SIZE).ok_or(bad_stream_error("it is cut off", bytes.len() as u64))?;
        let mut from = ByteReader::new(header, 0);
        from.read_bytes(MAGIC.len())?;
        let last = HEADER_SIZE - 4;
        if header[last..] != checksum(&header[..last]).to_le_bytes() {
            return Err(bad_stream_error("the checksum of the header is wrong", last as u64));
        }
        if from.read_u32()? != FORMAT_VERSION {
            return Err(from.error_here("another version of the library wrote it"));
        }
        Self::read_fields(&mut from)
    }

    fn read_fields(from: &mut ByteReader<'_>) -> Result<Self> {
        let (mode, scalar, bits, flags) = (from.read_u8()?, from.read_u8()?, from.read_u8()?, from.read_u8()?);
        let (rows, columns, rows_per_block) = (from.read_u32()?, from.read_u32()?, from.read_u32()?);
        let order = from.read_u8()?;
        let reserved = from.read_bytes(3)?;
        let structure_size = from.read_u64()?;
        let checksum = from.read_u32()?;
        let zero = from.read_u32()?;
        let mode = match (mode, bits) {
            (0, 0) => StreamMode::Raw,
            (1, 0) => StreamMode::Lossless,
            (2, 8..=24) => StreamMode::Quantised { bits: bits.into() },
            _ => return Err(from.error_here("the mode is unknown")),
        };
        let scalar = match scalar {
            0 => Scalar::F32,
            1 => Scalar::F64,
            _ => return Err(from.error_here("the type of the coordinates is unknown")),
        };
        let shape = Shape::new(rows as usize, columns as usize)
            .map_err(|_| from.error_here("the size is impossible for a net"))?;
        if flags > 1 || order > 5 || reserved != [0; 3] || zero != 0 || !(1..=rows).contains(&rows_per_block) {
            return Err(from.error_here("a field has an unknown value"));
        }
        let numbers = [from.read_u64()?, from.read_u64()?, from.read_u64()?];
        let step = [from.read_f64()?, from.read_f64()?, from.read_f64()?];
        let quantised = matches!(mode, StreamMode::Quantised { .. });
        let (origin, missing) = if quantised { (numbers.map(f64::from_bits), [0; 3]) } else { ([0.0; 3], numbers) };
        let is_grid = |axis: usize| step[axis] > 0.0 && step[axis].is_finite() && origin[axis].abs() <= f64::MAX / 4.0;
        if quantised && !(0..3).all(is_grid) {
            return Err(from.error_here("a step or an origin is out of range"));
        }
        if !quantised && step != [0.0; 3] {
            return Err(from.error_here("a field has an unknown value"));
        }
        let plain = StreamInfo::new(shape, scalar, mode, rows_per_block as usize);
        let mut info = StreamInfo {
            origin,
            step,
            stores_one_node_per_class: flags == 1,
            bits_of_missing_node: missing,
            coordinate_order: order,
            structure_size,
            checksum,
            ..plain
        };
        info.prelude_size = info.bytes_before_first_block().ok_or_else(|| from.error_here("a size is too large"))?;
        Ok(info)
    }

    /// The bytes of the header.
    pub(super) fn write(&self, to: &mut ByteWriter) -> Result<()> {
        let start = to.bytes.len();
        to.write_bytes(&MAGIC)?;
        to.write_u32(FORMAT_VERSION)?;
        let (mode, bits) = match self.mode {
            StreamMode::Raw => (0, 0),
            StreamMode::Lossless => (1, 0),
            StreamMode::Quantised { bits } => (2, bits as u8),
        };
        to.write_bytes(&[mode, u8::from(self.scalar == Scalar::F64), bits, u8::from(self.stores_one_node_per_class)])?;
        to.write_u32(self.shape.rows() as u32)?;
        to.write_u32(self.shape.columns() as u32)?;
        to.write_u32(self.rows_per_block as u32)?;
        to.write_bytes(&[self.coordinate_order, 0, 0, 0])?;
        to.write_u64(self.structure_size)?;
        to.write_u32(self.checksum)?;
        to.write_u32(0)?;
        let quantised = matches!(self.mode, StreamMode::Quantised { .. });
        (0..3).try_for_each(|k| {
            to.write_u64(if quantised { self.origin[k].to_bits() } else { self.bits_of_missing_node[k] })
        })?;
        self.step.iter().try_for_each(|&step| to.write_f64(step))?;
        to.write_zeros(start + HEADER_SIZE - 4 - to.bytes.len())?;
        to.write_u32(checksum(&to.bytes[start..]))
    }

    /// Returns the number of blocks.
    pub fn block_count(&self) -> usize {
        self.shape.rows().div_ceil(self.rows_per_block)
    }

    /// Returns the rows of a block.
    pub fn block_rows(&self, block: usize) -> std::ops::Range<usize> {
        let start = block * self.rows_per_block;
        start..self.shape.rows().min(start + self.rows_per_block)
    }

    /// Bytes of the table of blocks, which has the size and checksum of each.
    pub(super) fn block_table_bytes(&self) -> u64 {
        12 * self.block_count() as u64
    }

    /// Bytes of header, structure, table and padding before the first block.
    pub(super) fn bytes_before_first_block(&self) -> Option<u64> {
        let size = self.structure_size.checked_add(HEADER_SIZE as u64 + self.block_table_bytes())?;
        if self.mode == StreamMode::Raw {
            size.checked_next_multiple_of(RAW_BLOCK_ALIGNMENT as u64)
        } else {
            Some(size)
        }
    }
}

//! Decoding of streams, whole or as they arrive.
//!
//! Invariant: bytes that an encoder cannot have written are rejected. Memory is allocated only
//! within the bound that the length of the stream implies. O(nodes), blocks in parallel.

use super::block::{self, DuplicateNodes};
use super::bytes::{ByteReader, bad_stream_error, checksum};
use super::header::{HEADER_SIZE, MAX_NODES_PER_BYTE, StreamInfo, StreamMode};
use super::levels::{CoordinateBits, LosslessLevels, UniformLevels};
use super::{raw_block, stream_structure};
use crate::arrange::{Rearrangement, rearrange_coordinates};
use crate::chunks::zip3;
use crate::{Bridge, Coordinates, Net, Shape, Sides, Topology, XyzMatrices, each};
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::job::Job;
use gusset_base::par;
use std::ops::Range;

/// An entry of the table of blocks: where a block's bytes are, and their checksum.
#[derive(Debug, Clone, Copy)]
pub(super) struct BlockTableEntry {
    pub(super) offset: u64,
    pub(super) byte_size: u64,
    checksum: u32,
}

/// The parts of a stream before the first block.
#[derive(Debug)]
pub(super) struct StreamPrelude {
    pub(super) info: StreamInfo,
    pub(super) topology: Topology,
    pub(super) bridges: Vec<Bridge>,
    duplicates: DuplicateNodes,
    pub(super) entries: Vec<BlockTableEntry>,
}

impl StreamPrelude {
    /// Reads the prelude. `bytes` is the stream, at least up to the first block, and `total` the
    /// length of the stream, if known.
    pub(super) fn read(info: StreamInfo, bytes: &[u8], total: Option<u64>) -> Result<Self> {
        let mut from = ByteReader::new(&bytes[HEADER_SIZE..], HEADER_SIZE as u64);
        let too_long = from.error_here("a size is too large");
        let size = usize::try_from(info.structure_size).map_err(|_| too_long)?;
        let table_at = HEADER_SIZE as u64 + info.structure_size;
        let structure = from.read_bytes(size)?;
        let table = from.read_bytes(usize::try_from(info.block_table_bytes()).unwrap_or(usize::MAX))?;
        let checked = &bytes[HEADER_SIZE..HEADER_SIZE + size + table.len()];
        if checksum(checked) != info.checksum {
            return Err(bad_stream_error("the checksum of gluing and table is wrong", HEADER_SIZE as u64));
        }
        let padding = info.prelude_size - table_at - info.block_table_bytes();
        if from.read_bytes(usize::try_from(padding).unwrap_or(usize::MAX))?.iter().any(|&byte| byte != 0) {
            return Err(from.error_here("the padding before the first block is not zero"));
        }
        let (entries, end) = read_block_table(&info, ByteReader::new(table, table_at))?;
        if let Some(total) = total.filter(|&total| total != end) {
            return Err(bad_stream_error("the length of its blocks differs from the table", end.min(total)));
        }
        let limit = end.saturating_mul(MAX_NODES_PER_BYTE);
        let from = ByteReader::new(structure, HEADER_SIZE as u64);
        let (topology, bridges) = stream_structure::read_structure(info.shape, limit, from)?;
        let duplicates = if info.stores_one_node_per_class {
            DuplicateNodes::from_topology(&topology)?
        } else {
            DuplicateNodes::without_duplicates(info.shape)
        };
        Ok(StreamPrelude { info, topology, bridges, duplicates, entries })
    }

    /// Decodes a block into its rows of the three matrices, except duplicates.
    fn decode_block<T: CoordinateBits>(&self, block: usize, bytes: &[u8], to: [&mut [T]; 3]) -> Result<()> {
        let BlockTableEntry { offset, checksum: expected, .. } = self.entries[block];
        if checksum(bytes) != expected {
            return Err(bad_stream_error("the checksum of a block is wrong", offset));
        }
        let from = ByteReader::new(bytes, offset);
        let (info, duplicates) = (&self.info, &self.duplicates);
        match info.mode {
            StreamMode::Raw => raw_block::decode_raw_block(info, block, from, to),
            StreamMode::Lossless => {
                let bad = from.error_here("the numbers of missing nodes are out of range");
                let number = |bits: u64| T::from_ordered_bits(bits as i64);
                let [Some(x), Some(y), Some(z)] = info.bits_of_missing_node.map(number) else { return Err(bad) };
                block::decode_block(info, duplicates, &LosslessLevels { missing: [x, y, z] }, block, from, to)
            }
            StreamMode::Quantised { bits } => {
                let levels = UniformLevels { origin: info.origin, step: info.step, last_level: (1 << bits) - 1 };
                block::decode_block(info, duplicates, &levels, block, from, to)
            }
        }
    }

    /// Gives duplicates in some rows the coordinates of the nodes that they repeat.
    fn restore_duplicates(&self, coordinates: &mut Coordinates<'_>, rows: Range<usize>) {
        each!(coordinates, planes => self.duplicates.restore_rows(planes, rows));
    }

    fn into_net(self, coordinates: Coordinates<'static>) -> Net<'static> {
        let mut net = Net::new(coordinates, self.topology);
        *net.bridges_mut() = self.bridges;
        net
    }
}

/// Returns the table of blocks, and the end of the last one.
fn read_block_table(info: &StreamInfo, mut from: ByteReader<'_>) -> Result<(Vec<BlockTableEntry>, u64)> {
    let mut entries = alloc::with_capacity(info.block_count())?;
    let mut offset = info.prelude_size;
    for _ in 0..info.block_count() {
        let too_large = from.error_here("a block is too large");
        let (size, checksum) = (from.read_u64()?, from.read_u32()?);
        entries.push(BlockTableEntry { offset, byte_size: size, checksum });
        offset = offset.checked_add(size).filter(|&end| end <= i64::MAX as u64).ok_or(too_large)?;
    }
    Ok((entries, offset))
}

/// Decodes the net of a stream.
///
/// O(nodes); blocks are decoded in parallel. Bytes that an encoder cannot have written are
/// rejected, and damaged ones fail their checksums. Streams of more than 4096 nodes per byte are
/// rejected, so that a short stream cannot demand much memory.
///
/// # Errors
/// [`Error::BadStream`], [`Error::OutOfMemory`], [`Error::Cancelled`].
pub fn decode(bytes: &[u8], job: &Job<'_>) -> Result<Net<'static>> {
    decode_within(bytes, u64::MAX, job)
}

/// [`decode`] for streams that may be hostile. A net of more than `node_limit` nodes is rejected
/// before memory is allocated.
///
/// # Errors
/// The errors of [`decode`]; [`Error::TooLarge`].
pub fn decode_within(bytes: &[u8], node_limit: u64, job: &Job<'_>) -> Result<Net<'static>> {
    let info = StreamInfo::read(bytes)?;
    Error::check_count("nodes", info.shape.node_count() as u64, node_limit)?;
    if info.prelude_size > bytes.len() as u64 {
        return Err(bad_stream_error("it is cut off", bytes.len() as u64));
    }
    let prelude = StreamPrelude::read(info, bytes, Some(bytes.len() as u64))?;
    let mut coordinates = Coordinates::zeroed(info.shape, info.scalar)?;
    each!(&mut coordinates, planes => decode_blocks(&prelude, bytes, planes, job))?;
    prelude.restore_duplicates(&mut coordinates, 0..info.shape.rows());
    Ok(prelude.into_net(coordinates))
}

/// Decodes all blocks, some at a time so that the host can cancel.
fn decode_blocks<T: CoordinateBits>(
    prelude: &StreamPrelude,
    bytes: &[u8],
    planes: &mut XyzMatrices<'_, T>,
    job: &Job<'_>,
) -> Result<()> {
    let info = &prelude.info;
    let at_once = 2 * par::resolve_thread_count(info.block_count(), job.requested_threads());
    let (block, mut start) = (info.rows_per_block * info.shape.columns(), 0);
    for matrices in zip3(planes.matrices_mut().map(|matrix| matrix.chunks_mut(at_once * block))) {
        job.step(start as f64 / info.block_count() as f64, "decoding")?;
        let parts = zip3(matrices.map(|matrix| matrix.chunks_mut(block))).enumerate();
        let done = par::map(job.requested_threads(), parts, |(k, part)| {
            let BlockTableEntry { offset, byte_size: size, .. } = prelude.entries[start + k];
            prelude.decode_block(start + k, &bytes[offset as usize..(offset + size) as usize], part)
        })?;
        start += done.len();
        done.into_iter().collect::<Result<()>>()?;
    }
    Ok(())
}

/// An incremental decoder: rows are available as soon as their block is complete.
#[derive(Debug)]
pub struct StreamDecoder {
    /// Unused bytes, and their position in the stream.
    unread_bytes: Vec<u8>,
    offset: u64,
    node_limit: u64,
    state: Option<(StreamPrelude, Coordinates<'static>)>,
    next_row_or_block: usize,
    failed: Option<Error>,
}

impl StreamDecoder {
    /// Creates a decoder. A net of more than `node_limit` nodes is rejected, because its memory is
    /// allocated before the stream is complete.
    pub fn new(node_limit: u64) -> Self {
        StreamDecoder {
            unread_bytes: Vec::new(),
            offset: 0,
            node_limit,
            state: None,
            next_row_or_block: 0,
            failed: None,
        }
    }

    /// Takes the next bytes of the stream and decodes all blocks that they complete. Returns the
    /// number of complete rows. An error is final and returned again, except a lack of memory,
    /// which leaves the decoder unchanged.
    ///
    /// # Errors
    /// [`Error::BadStream`], [`Error::TooLarge`], [`Error::OutOfMemory`].
    pub fn decode_next_bytes(&mut self, bytes: &[u8]) -> Result<usize> {
        if let Some(error) = self.failed {
            return Err(error);
        }
        let (pending, next, begun) = (self.unread_bytes.len(), self.next_row_or_block, self.state.is_some());
        let done = self.append_and_decode(bytes);
        if let Err(Error::OutOfMemory { .. }) = done {
            // Rows that were already decoded are decoded again.
            self.unread_bytes.truncate(pending);
            self.next_row_or_block = next;
            self.state.take_if(|_| !begun);
        } else {
            self.failed = done.err();
        }
        done.map(|()| self.complete_row_count())
    }

    fn append_and_decode(&mut self, bytes: &[u8]) -> Result<()> {
        alloc::append(&mut self.unread_bytes, bytes)?;
        let mut used = if self.state.is_none() { self.read_prelude()? } else { 0 };
        let Some((prelude, coordinates)) = &mut self.state else { return Ok(()) };
        while let Some(entry) = prelude.entries.get(self.next_row_or_block) {
            let rest = &self.unread_bytes[used..];
            let Some(bytes) = usize::try_from(entry.byte_size).ok().and_then(|size| rest.get(..size)) else { break };
            let rows = prelude.info.block_rows(self.next_row_or_block);
            let w = prelude.info.shape.columns();
            each!(&mut *coordinates, planes => {
                let parts = planes.matrices_mut().map(|matrix| &mut matrix[rows.start * w..rows.end * w]);
                prelude.decode_block(self.next_row_or_block, bytes, parts)?;
            });
            prelude.restore_duplicates(coordinates, rows);
            used += bytes.len();
            self.next_row_or_block += 1;
        }
        self.unread_bytes.drain(..used);
        self.offset += used as u64;
        if self.next_row_or_block == prelude.entries.len() && !self.unread_bytes.is_empty() {
            return Err(bad_stream_error("there are bytes after the end", self.offset));
        }
        Ok(())
    }

    /// Reads the prelude once it is complete. Returns the number of its bytes.
    fn read_prelude(&mut self) -> Result<usize> {
        if self.unread_bytes.len() < HEADER_SIZE {
            return Ok(0);
        }
        let info = StreamInfo::read(&self.unread_bytes)?;
        let count = info.shape.node_count() as u64;
        Error::check_count("nodes", count, self.node_limit)?;
        let Some(size) = usize::try_from(info.prelude_size).ok().filter(|&size| size <= self.unread_bytes.len()) else {
            return Ok(0);
        };
        let prelude = StreamPrelude::read(info, &self.unread_bytes[..size], None)?;
        self.state = Some((prelude, Coordinates::zeroed(info.shape, info.scalar)?));
        Ok(size)
    }

    /// Returns the header, once the prelude is complete.
    pub fn info(&self) -> Option<&StreamInfo> {
        self.state.as_ref().map(|(prelude, _)| &prelude.info)
    }

    /// Returns the number of complete rows.
    pub fn complete_row_count(&self) -> usize {
        let last = self.next_row_or_block.checked_sub(1);
        self.info().zip(last).map_or(0, |(info, last)| info.block_rows(last).end)
    }

    /// Returns the complete rows as a net: a sheet without bridges.
    ///
    /// # Errors
    /// [`Error::NetTooSmall`] for fewer than two rows, [`Error::OutOfMemory`],
    /// [`Error::Cancelled`].
    pub fn net_of_complete_rows(&self, job: &Job<'_>) -> Result<Net<'static>> {
        let Some((prelude, coordinates)) = &self.state else {
            return Err(Error::NetTooSmall { rows: 0, columns: 0 });
        };
        let shape = Shape::new(self.complete_row_count(), prelude.info.shape.columns())?;
        let whole = Rearrangement::Part { row: 0, column: 0 };
        let part = rearrange_coordinates(coordinates, shape, &whole, job)?;
        Ok(Net::new(part, Topology::from_sides(shape, Sides::SHEET)))
    }

    /// Returns the net once the stream is complete, and resets the decoder.
    ///
    /// # Errors
    /// [`Error::BadStream`] if it is not complete, or the error of [`StreamDecoder::decode_next_bytes`].
    pub fn finish(&mut self) -> Result<Net<'static>> {
        if let Some(error) = self.failed {
            return Err(error);
        }
        let end = self.offset + self.unread_bytes.len() as u64;
        let whole = self.state.take_if(|(prelude, _)| self.next_row_or_block == prelude.entries.len());
        let (prelude, coordinates) = whole.ok_or(bad_stream_error("it is cut off", end))?;
        *self = StreamDecoder::new(self.node_limit);
        Ok(prelude.into_net(coordinates))
    }
}

//! Encoding of nets to streams. O(nodes), blocks in parallel; the same bytes for any number of
//! threads.

use super::block::{BlockCoding, DuplicateNodes};
use super::bytes::{ByteWriter, checksum};
use super::header::{HEADER_SIZE, MAX_NODES_PER_BYTE, StreamInfo, StreamMode};
use super::levels::{CoordinateBits, LevelMap, LosslessLevels};
use super::quantise::{self, LevelBox};
use super::{raw_block, stream_structure};
use crate::{Net, XyzMatrices, each};
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::job::Job;
use gusset_base::par;

const SAMPLING_STAGE: &str = "sampling the net";

/// Options of [`encode`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StreamOptions {
    /// The storage of coordinates.
    pub mode: StreamMode,
    /// For [`StreamMode::Quantised`]: a step for each axis from its own extent, instead of a common
    /// one.
    pub per_axis: bool,
    /// Rows in a block, which is coded independently; 0 for one block of a raw stream, and about
    /// 2^17 nodes a block otherwise.
    pub rows_per_block: usize,
    /// For [`StreamMode::Quantised`]: the levels. `None` takes the bounding box of the net.
    pub levels: Option<LevelBox>,
}

impl StreamOptions {
    /// Returns the defaults of a mode.
    pub fn new(mode: StreamMode) -> Self {
        StreamOptions { mode, per_axis: false, rows_per_block: 0, levels: None }
    }

    fn rows_per_block(&self, rows: usize, columns: usize) -> usize {
        match (self.rows_per_block, self.mode) {
            (0, StreamMode::Raw) => rows,
            (0, _) => ((1 << 17) / columns).max(8).min(rows),
            (given, _) => given.min(rows),
        }
    }
}

/// Encodes a net as a stream; see the module.
///
/// O(nodes); blocks are coded in parallel. Extra memory: the stream, and the memory of
/// [`NodeClasses`](crate::NodeClasses).
///
/// # Errors
/// [`Error::OptionOutOfRange`] (bits; coordinates above a quarter of the largest number, if
/// quantised; a box or step that is empty or out of range), [`Error::NodeOutsideBox`],
/// [`Error::OutOfMemory`], [`Error::Cancelled`].
pub fn encode(net: &Net<'_>, options: &StreamOptions, job: &Job<'_>) -> Result<Vec<u8>> {
    if let StreamMode::Quantised { bits } = options.mode {
        Error::require((8..=24).contains(&bits), "bits", bits.into(), 8.0..=24.0)?;
    }
    each!(net.coordinates(), planes => encode_coordinates(net, planes, options, job))
}

fn encode_coordinates<T: CoordinateBits>(
    net: &Net<'_>,
    planes: &XyzMatrices<'_, T>,
    options: &StreamOptions,
    job: &Job<'_>,
) -> Result<Vec<u8>> {
    let shape = net.shape();
    let rows_per_block = options.rows_per_block(shape.rows(), shape.columns());
    let mut info = StreamInfo::new(shape, T::SCALAR, options.mode, rows_per_block);
    job.step(0.0, SAMPLING_STAGE)?;
    if info.mode == StreamMode::Raw {
        let blocks =
            encode_blocks_in_parallel(&info, job, |info, block| raw_block::encode_raw_block(info, planes, block))?;
        return assemble_stream(net, info, blocks);
    }
    let all = DuplicateNodes::from_topology(net.topology())?;
    job.step(0.05, SAMPLING_STAGE)?;
    let rest = job.sub_job(0.1, 1.0);
    let blocks = match info.mode {
        StreamMode::Quantised { bits } => {
            let (levels, bits) = match &options.levels {
                None => (quantise::choose_levels_for_nodes(planes, bits, options.per_axis)?, bits),
                Some(given) => quantise::divide_box_into_levels(planes, bits, options.per_axis, given)?,
            };
            info.mode = StreamMode::Quantised { bits };
            (info.stores_one_node_per_class, info.origin, info.step) = (true, levels.origin, levels.step);
            compress_blocks(&mut info, planes, &all, levels, &rest)?
        }
        _ => {
            info.stores_one_node_per_class = all.are_bit_identical(planes);
            let none = DuplicateNodes::without_duplicates(shape);
            let duplicates = if info.stores_one_node_per_class { &all } else { &none };
            let levels = LosslessLevels { missing: coordinates_of_first_missing(planes) };
            info.bits_of_missing_node = levels.missing.map(|number| number.to_ordered_bits() as u64);
            compress_blocks(&mut info, planes, duplicates, levels, &rest)?
        }
    };
    assemble_stream(net, info, blocks)
}

fn compress_blocks<T: CoordinateBits, L: LevelMap<T> + Copy>(
    info: &mut StreamInfo,
    planes: &XyzMatrices<'_, T>,
    duplicates: &DuplicateNodes,
    levels: L,
    job: &Job<'_>,
) -> Result<Vec<Vec<u8>>> {
    job.step(0.0, SAMPLING_STAGE)?;
    info.coordinate_order = BlockCoding { info, planes, duplicates, levels }.best_coordinate_order_of_net()? as u8;
    encode_blocks_in_parallel(info, &job.sub_job(0.1, 1.0), |info, block| {
        BlockCoding { info, planes, duplicates, levels }.encode_block(block)
    })
}

/// Returns the coordinates of the first missing node; NaN if there is none.
fn coordinates_of_first_missing<T: CoordinateBits>(planes: &XyzMatrices<'_, T>) -> [T; 3] {
    let (h, w) = (planes.shape().rows(), planes.shape().columns());
    let mut nodes = (0..h).flat_map(|i| (0..w).map(move |j| (i, j)));
    let gap = nodes.find(|&(i, j)| !planes.row(i).iter().all(|row| Into::<f64>::into(row[j]).is_finite()));
    gap.map_or([T::MISSING; 3], |(i, j)| planes.row(i).map(|row| row[j]))
}

/// Encodes all blocks in parallel, cancellable between them.
fn encode_blocks_in_parallel(
    info: &StreamInfo,
    job: &Job<'_>,
    encode: impl Fn(&StreamInfo, usize) -> Result<Vec<u8>> + Sync,
) -> Result<Vec<Vec<u8>>> {
    alloc::try_collect(par::map_cancellable(job, "coding", 0..info.block_count(), |block| encode(info, block))?)
}

/// Header, structure, table, blocks.
fn assemble_stream(net: &Net<'_>, mut info: StreamInfo, mut blocks: Vec<Vec<u8>>) -> Result<Vec<u8>> {
    let mut body = ByteWriter::default();
    let work = stream_structure::write_structure(net, &mut body)?;
    info.structure_size = body.bytes.len() as u64;
    let overflow = Error::SizeOverflow { what: "bytes of a stream", count: info.shape.node_count() as u64 };
    let prelude = info.bytes_before_first_block().and_then(|size| usize::try_from(size).ok()).ok_or(overflow)?;
    // Padded to the bound of MAX_NODES_PER_BYTE.
    let size = prelude + blocks.iter().map(Vec::len).sum::<usize>();
    let min_size = work.div_ceil(MAX_NODES_PER_BYTE) as usize;
    if let Some(last) = blocks.last_mut()
        && size < min_size
    {
        alloc::reserve(last, min_size - size)?;
        last.resize(last.len() + min_size - size, 0);
    }
    for block in &blocks {
        body.write_u64(block.len() as u64)?;
        body.write_u32(checksum(block))?;
    }
    info.checksum = checksum(&body.bytes);
    let mut to = ByteWriter { bytes: alloc::with_capacity(size.max(min_size))? };
    info.write(&mut to)?;
    to.write_bytes(&body.bytes)?;
    if info.mode == StreamMode::Raw {
        to.pad_to_multiple(super::header::RAW_BLOCK_ALIGNMENT)?;
    }
    debug_assert!(to.bytes.len() == prelude && to.bytes.len() >= HEADER_SIZE);
    blocks.iter().try_for_each(|block| to.write_bytes(block))?;
    Ok(to.bytes)
}

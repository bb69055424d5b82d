//! Encoding of nets to streams. O(nodes), blocks in parallel; the same bytes for any number of
//! threads.

use super::block::{Blocks, Duplicates};
use super::bytes::{Writer, checksum};
use super::header::{HEADER_SIZE, MAX_NODES_PER_BYTE, Mode, StreamInfo};
use super::levels::{Bits, Levels, LosslessLevels};
use super::{quantise, raw, stream_structure};
use crate::{Net, Planes, each};
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::job::Job;
use gusset_base::par;

const SAMPLING: &str = "sampling the net";

/// Options of [`encode`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StreamOptions {
    /// The storage of coordinates.
    pub mode: Mode,
    /// For [`Mode::Quantised`]: a step for each axis from its own extent, instead of a common one.
    pub per_axis: bool,
    /// Rows in a block, which is coded independently; 0 for one block of a raw stream, and about
    /// 2^17 nodes a block otherwise.
    pub rows_per_block: usize,
}

impl StreamOptions {
    /// Returns the defaults of a mode.
    pub fn new(mode: Mode) -> Self {
        StreamOptions { mode, per_axis: false, rows_per_block: 0 }
    }

    fn rows_per_block(&self, rows: usize, columns: usize) -> usize {
        match (self.rows_per_block, self.mode) {
            (0, Mode::Raw) => rows,
            (0, _) => ((1 << 17) / columns).max(8).min(rows),
            (given, _) => given.min(rows),
        }
    }
}

/// Encodes a net as a stream; see the module.
///
/// O(nodes); blocks are coded in parallel. Extra memory: the stream, and the memory of
/// [`Classes`](crate::Classes).
///
/// # Errors
/// [`Error::OptionOutOfRange`] (bits; coordinates above a quarter of the largest number, if
/// quantised), [`Error::OutOfMemory`], [`Error::Cancelled`].
pub fn encode(net: &Net<'_>, options: &StreamOptions, job: &Job<'_>) -> Result<Vec<u8>> {
    if let Mode::Quantised { bits } = options.mode {
        Error::require((8..=24).contains(&bits), "bits", bits.into())?;
    }
    each!(net.coordinates(), planes => encode_coordinates(net, planes, options, job))
}

fn encode_coordinates<T: Bits>(
    net: &Net<'_>,
    planes: &Planes<'_, T>,
    options: &StreamOptions,
    job: &Job<'_>,
) -> Result<Vec<u8>> {
    let shape = net.shape();
    let rows_per_block = options.rows_per_block(shape.rows(), shape.columns());
    let mut info = StreamInfo::new(shape, T::SCALAR, options.mode, rows_per_block);
    job.step(0.0, SAMPLING)?;
    if info.mode == Mode::Raw {
        let blocks = in_parallel(&info, job, |info, block| raw::encode(info, planes, block))?;
        return assemble(net, info, blocks);
    }
    let all = Duplicates::from_topology(net.topology())?;
    job.step(0.05, SAMPLING)?;
    let rest = job.part(0.1, 1.0);
    let blocks = match info.mode {
        Mode::Quantised { bits } => {
            let levels = quantise::levels(planes, bits, options.per_axis)?;
            (info.folded, info.origin, info.step) = (true, levels.origin, levels.step);
            compress(&mut info, planes, &all, levels, &rest)?
        }
        _ => {
            info.folded = all.are_exact(planes);
            let none = Duplicates::none(shape);
            let duplicates = if info.folded { &all } else { &none };
            let levels = LosslessLevels { missing: first_gap(planes) };
            info.missing = levels.missing.map(|number| number.level() as u64);
            compress(&mut info, planes, duplicates, levels, &rest)?
        }
    };
    assemble(net, info, blocks)
}

fn compress<T: Bits, L: Levels<T> + Copy>(
    info: &mut StreamInfo,
    planes: &Planes<'_, T>,
    duplicates: &Duplicates,
    levels: L,
    job: &Job<'_>,
) -> Result<Vec<Vec<u8>>> {
    job.step(0.0, SAMPLING)?;
    info.order = Blocks { info, planes, duplicates, levels }.best_order()? as u8;
    in_parallel(info, &job.part(0.1, 1.0), |info, block| Blocks { info, planes, duplicates, levels }.encode(block))
}

/// Returns the coordinates of the first missing node; NaN if there is none.
fn first_gap<T: Bits>(planes: &Planes<'_, T>) -> [T; 3] {
    let (h, w) = (planes.shape().rows(), planes.shape().columns());
    let mut nodes = (0..h).flat_map(|i| (0..w).map(move |j| (i, j)));
    let gap = nodes.find(|&(i, j)| !planes.row(i).iter().all(|row| Into::<f64>::into(row[j]).is_finite()));
    gap.map_or([T::MISSING; 3], |(i, j)| planes.row(i).map(|row| row[j]))
}

/// Encodes all blocks in parallel, cancellable between them.
fn in_parallel(
    info: &StreamInfo,
    job: &Job<'_>,
    encode: impl Fn(&StreamInfo, usize) -> Result<Vec<u8>> + Sync,
) -> Result<Vec<Vec<u8>>> {
    alloc::try_collect(par::map_cancellable(job, "coding", 0..info.block_count(), |block| encode(info, block))?)
}

/// Header, structure, table, blocks.
fn assemble(net: &Net<'_>, mut info: StreamInfo, mut blocks: Vec<Vec<u8>>) -> Result<Vec<u8>> {
    let mut body = Writer::default();
    let work = stream_structure::write(net, &mut body)?;
    info.structure_size = body.bytes.len() as u64;
    let overflow = Error::SizeOverflow { what: "bytes of a stream", count: info.shape.node_count() as u64 };
    let prelude = info.prelude().and_then(|size| usize::try_from(size).ok()).ok_or(overflow)?;
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
        body.u64(block.len() as u64)?;
        body.u32(checksum(block))?;
    }
    info.checksum = checksum(&body.bytes);
    let mut to = Writer { bytes: alloc::with_capacity(size.max(min_size))? };
    info.write(&mut to)?;
    to.raw(&body.bytes)?;
    if info.mode == Mode::Raw {
        to.pad(super::header::ALIGNMENT)?;
    }
    debug_assert!(to.bytes.len() == prelude && to.bytes.len() >= HEADER_SIZE);
    blocks.iter().try_for_each(|block| to.raw(block))?;
    Ok(to.bytes)
}

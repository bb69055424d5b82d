//! Scenes as bytes: a table of entries, and a stream for each distinct net.
//!
//! All numbers are little-endian; "varint" is LEB128.
//!
//! | part | bytes | content |
//! |---|---|---|
//! | header | 40 | magic (8), version, number of entries, number of nets, 0 (4 each), size of the table (8), CRC-32 of the table, CRC-32 of the header so far (4 each) |
//! | table | as in the header | the size of each net's stream as a varint, then the entries in order |
//! | nets | as in the table | the stream of each net, padded with zeros to a multiple of 64 bytes of the whole stream |
//!
//! An entry begins with a byte of flags: 1 it exists, 2 it is a group, 4 it is visible, 8 it has a
//! transform. Indices of removed entries have the byte 0. Twelve doubles of the transform follow,
//! column by column, unless it is the identity. A net continues with the number of its stream. A
//! group continues with its number of children and their indices. Nets that entries share have one
//! stream. They are numbered in the order of the entries, so that a scene has one encoding.

use super::arena::{EntryContent, Scene, SceneEntry};
use crate::Net;
use crate::stream::bytes::{ByteReader, ByteWriter, bad_stream_error, checksum};
use crate::stream::{StreamInfo, StreamOptions, decode_within, encode};
use glam::DAffine3;
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::job::Job;
use gusset_base::sort;
use std::sync::Arc;

const HEADER_SIZE: usize = 40;
const MAGIC: [u8; 8] = *b"\x8bTRS\r\n\x1a\n";
const FORMAT_VERSION: u32 = 1;
/// The streams of nets begin at multiples of this, so that raw matrices are aligned.
const NET_ALIGNMENT: usize = 64;

const EXISTS: u8 = 1;
const IS_GROUP: u8 = 2;
const IS_VISIBLE: u8 = 4;
const HAS_TRANSFORM: u8 = 8;

const ENTRIES_PER_REPORT: usize = 1 << 14;

/// Encodes a scene: its entries with their indices, groups, transforms and visibility, and each
/// distinct net once, as by [`encode`].
///
/// O(nodes + entries + children); blocks of nets are coded in parallel. Extra memory: the stream
/// and the stream of one net.
///
/// # Errors
/// The errors of [`encode`]; the index of a node counts within its net.
pub fn encode_scene(scene: &Scene, options: &StreamOptions, job: &Job<'_>) -> Result<Vec<u8>> {
    let entries = scene.slots();
    let (nets, net_numbers) = number_distinct_nets(entries)?;
    let mut body = ByteWriter::default();
    let mut sizes = alloc::with_capacity(nets.len())?;
    for (k, net) in nets.iter().enumerate() {
        let bytes = encode(net, options, &job.sub_job(0.0, 0.9).sub_job_of_item(k, nets.len()))?;
        sizes.push(bytes.len() as u64);
        body.write_bytes(&bytes)?;
        body.pad_to_multiple(NET_ALIGNMENT)?;
    }
    let mut table = ByteWriter::default();
    sizes.into_iter().try_for_each(|size| table.write_varint(size))?;
    for (index, entry) in entries.iter().enumerate() {
        job.step_every(ENTRIES_PER_REPORT, index, entries.len(), "writing entries")?;
        write_entry(entry.as_ref(), net_numbers[index], &mut table)?;
    }
    let mut stream = ByteWriter::default();
    stream.write_bytes(&MAGIC)?;
    for number in [FORMAT_VERSION, entries.len() as u32, nets.len() as u32, 0] {
        stream.write_u32(number)?;
    }
    stream.write_u64(table.bytes.len() as u64)?;
    stream.write_u32(checksum(&table.bytes))?;
    stream.write_u32(checksum(&stream.bytes))?;
    stream.write_bytes(&table.bytes)?;
    stream.pad_to_multiple(NET_ALIGNMENT)?;
    stream.write_bytes(&body.bytes)?;
    job.finish()?;
    Ok(stream.bytes)
}

/// Returns the distinct nets in the order of the entries, and the number of each entry's net.
fn number_distinct_nets(entries: &[Option<SceneEntry>]) -> Result<(Vec<&Net<'static>>, Vec<u32>)> {
    let net = |index: usize| match &entries[index].as_ref()?.content {
        EntryContent::Net(net) => Some(net),
        EntryContent::Group(_) => None,
    };
    let address = |index: usize| net(index).map_or(0, |net| Arc::as_ptr(net) as usize);
    let mut by_address = alloc::gather((0..entries.len()).filter(|&index| net(index).is_some()))?;
    sort::sort_stable(&mut by_address, &|&a, &b| address(a).cmp(&address(b)));
    // The first entry of each net.
    let mut first_entries = alloc::filled(0, entries.len())?;
    for of_one_net in by_address.chunk_by(|&a, &b| address(a) == address(b)) {
        of_one_net.iter().for_each(|&index| first_entries[index] = of_one_net[0]);
    }
    let (mut nets, mut numbers) = (Vec::new(), alloc::filled(0, entries.len())?);
    for index in 0..entries.len() {
        let Some(own) = net(index) else { continue };
        if first_entries[index] == index {
            numbers[index] = nets.len() as u32;
            alloc::push(&mut nets, &**own)?;
        } else {
            numbers[index] = numbers[first_entries[index]];
        }
    }
    Ok((nets, numbers))
}

fn is_identity(transform: &DAffine3) -> bool {
    transform.to_cols_array().map(f64::to_bits) == DAffine3::IDENTITY.to_cols_array().map(f64::to_bits)
}

fn write_entry(entry: Option<&SceneEntry>, net_number: u32, to: &mut ByteWriter) -> Result<()> {
    let Some(SceneEntry { content, local, visible, .. }) = entry else { return to.write_u8(0) };
    let flag = |is_set: bool, flag: u8| if is_set { flag } else { 0 };
    let is_group = matches!(content, EntryContent::Group(_));
    to.write_u8(
        EXISTS | flag(is_group, IS_GROUP) | flag(*visible, IS_VISIBLE) | flag(!is_identity(local), HAS_TRANSFORM),
    )?;
    if !is_identity(local) {
        local.to_cols_array().into_iter().try_for_each(|number| to.write_f64(number))?;
    }
    match content {
        EntryContent::Net(_) => to.write_varint(net_number.into()),
        EntryContent::Group(children) => {
            to.write_varint(children.len() as u64)?;
            children.iter().try_for_each(|&child| to.write_varint(child.into()))
        }
    }
}

/// Decodes the stream of a scene. Entries keep their indices, and shared nets stay shared.
///
/// A damaged or malicious stream does no harm; see [`decode_within`]. All nets together may have
/// `node_limit` nodes, checked before memory is allocated.
///
/// O(nodes + entries + children), parallel by blocks of nets.
///
/// # Errors
/// [`Error::BadStream`], [`Error::TooLarge`], [`Error::OutOfMemory`], [`Error::Cancelled`].
pub fn decode_scene_within(bytes: &[u8], node_limit: u64, job: &Job<'_>) -> Result<Scene> {
    let header = SceneHeader::read(bytes)?;
    let table = &bytes[HEADER_SIZE..HEADER_SIZE + header.table_size];
    let mut from = ByteReader::new(table, HEADER_SIZE as u64);
    // Each net has a size in the table, and each entry a byte.
    if (header.nets as usize).saturating_add(header.entries as usize) > table.len() {
        return Err(from.error_here("the table is too short for its nets and entries"));
    }
    let mut sizes = alloc::with_capacity(header.nets as usize)?;
    for _ in 0..header.nets {
        sizes.push(from.read_varint()?);
    }
    let nets = decode_nets(bytes, HEADER_SIZE + header.table_size, &sizes, node_limit, &job.sub_job(0.0, 0.9))?;
    let (mut entries, mut places) = (alloc::with_capacity(header.entries as usize)?, Vec::new());
    alloc::reserve(&mut places, header.entries as usize)?;
    let mut known_nets = 0;
    for index in 0..header.entries as usize {
        job.step_every(ENTRIES_PER_REPORT, index, header.entries as usize, "reading entries")?;
        places.push(from.position());
        entries.push(read_entry(&nets, &mut known_nets, header.entries, &mut from)?);
    }
    if known_nets != nets.len() {
        return Err(from.error_here("a net belongs to no entry"));
    }
    from.require_end()?;
    let scene = Scene::from_entries(entries)?.map_err(|entry| {
        bad_stream_error("a group contains itself or an entry that does not exist", places[entry as usize])
    })?;
    job.finish()?;
    Ok(scene)
}

struct SceneHeader {
    entries: u32,
    nets: u32,
    table_size: usize,
}

impl SceneHeader {
    /// Reads the header, and checks the table.
    fn read(bytes: &[u8]) -> Result<SceneHeader> {
        // Reports other bytes first, before any other fault.
        if bytes.iter().zip(&MAGIC).any(|(byte, own)| byte != own) {
            return Err(bad_stream_error("it does not begin as a stream of a scene does", 0));
        }
        let cut_off = bad_stream_error("it is cut off", bytes.len() as u64);
        let header = bytes.get(..HEADER_SIZE).ok_or(cut_off)?;
        let last = HEADER_SIZE - 4;
        if header[last..] != checksum(&header[..last]).to_le_bytes() {
            return Err(bad_stream_error("the checksum of the header is wrong", last as u64));
        }
        let mut from = ByteReader::new(header, 0);
        from.read_bytes(MAGIC.len())?;
        if from.read_u32()? != FORMAT_VERSION {
            return Err(from.error_here("another version of the library wrote it"));
        }
        let (entries, nets, zero) = (from.read_u32()?, from.read_u32()?, from.read_u32()?);
        if zero != 0 || entries == u32::MAX {
            return Err(from.error_here("a field has an unknown value"));
        }
        let (table_size, table_checksum) = (from.read_u64()?, from.read_u32()?);
        let table_size = usize::try_from(table_size).map_err(|_| cut_off)?;
        let table = bytes[HEADER_SIZE..].get(..table_size).ok_or(cut_off)?;
        if checksum(table) != table_checksum {
            return Err(bad_stream_error("the checksum of the table is wrong", HEADER_SIZE as u64));
        }
        Ok(SceneHeader { entries, nets, table_size })
    }
}

/// Decodes the nets after the table.
fn decode_nets(
    bytes: &[u8],
    table_end: usize,
    sizes: &[u64],
    node_limit: u64,
    job: &Job<'_>,
) -> Result<Vec<Arc<Net<'static>>>> {
    let (mut nets, mut at, mut nodes_left) = (alloc::with_capacity(sizes.len())?, table_end, node_limit);
    for (k, &size) in sizes.iter().enumerate() {
        at = skip_padding(bytes, at)?;
        let cut_off = bad_stream_error("it is cut off", bytes.len() as u64);
        let size = usize::try_from(size).map_err(|_| cut_off)?;
        let own = bytes[at..].get(..size).ok_or(cut_off)?;
        let within_scene = |error| match error {
            Error::BadStream { what, byte } => bad_stream_error(what, at as u64 + byte),
            // The limit holds for all nets together.
            Error::TooLarge { what, count, limit } => {
                Error::TooLarge { what, count: count.saturating_add(node_limit - limit), limit: node_limit }
            }
            error => error,
        };
        let nodes = StreamInfo::read(own).map_err(within_scene)?.shape.node_count() as u64;
        let net = decode_within(own, nodes_left, &job.sub_job_of_item(k, sizes.len())).map_err(within_scene)?;
        nets.push(Arc::new(net));
        nodes_left -= nodes;
        at += size;
    }
    at = skip_padding(bytes, at)?;
    if at == bytes.len() { Ok(nets) } else { Err(bad_stream_error("there are bytes after the end", at as u64)) }
}

/// Returns the next multiple of the alignment, after zeros.
fn skip_padding(bytes: &[u8], at: usize) -> Result<usize> {
    let end = at.next_multiple_of(NET_ALIGNMENT);
    let padding = bytes.get(at..end).ok_or(bad_stream_error("it is cut off", bytes.len() as u64))?;
    match padding.iter().position(|&byte| byte != 0) {
        Some(k) => Err(bad_stream_error("the padding before a net is not zero", (at + k) as u64)),
        None => Ok(end),
    }
}

fn read_entry(
    nets: &[Arc<Net<'static>>],
    known_nets: &mut usize,
    entry_count: u32,
    from: &mut ByteReader<'_>,
) -> Result<Option<SceneEntry>> {
    let flags = from.read_u8()?;
    if flags == 0 {
        return Ok(None);
    }
    if flags & EXISTS == 0 || flags > (EXISTS | IS_GROUP | IS_VISIBLE | HAS_TRANSFORM) {
        return Err(from.error_here("the flags of an entry are unknown"));
    }
    let mut local = DAffine3::IDENTITY;
    if flags & HAS_TRANSFORM != 0 {
        let mut numbers = [0.0; 12];
        for number in &mut numbers {
            *number = from.read_f64()?;
        }
        local = DAffine3::from_cols_array(&numbers);
        if !local.is_finite() || is_identity(&local) {
            return Err(from.error_here("a transform is not finite, or is the identity"));
        }
    }
    let content = if flags & IS_GROUP == 0 {
        let number = from.read_varint_u32()? as usize;
        // Nets are numbered in the order of the entries.
        if number > *known_nets || number >= nets.len() {
            return Err(from.error_here("the number of a net is out of range"));
        }
        *known_nets = (*known_nets).max(number + 1);
        EntryContent::Net(Arc::clone(&nets[number]))
    } else {
        let count = from.read_varint()?;
        if count > from.remaining_bytes() as u64 {
            return Err(from.error_here("a group has more children than the table has bytes"));
        }
        let mut children = alloc::with_capacity(count as usize)?;
        for _ in 0..count {
            let child = from.read_varint_u32()?;
            if child >= entry_count {
                return Err(from.error_here("a child does not exist"));
            }
            children.push(child);
        }
        EntryContent::Group(children)
    };
    Ok(Some(SceneEntry { content, local, visible: flags & IS_VISIBLE != 0, parents: Vec::new() }))
}

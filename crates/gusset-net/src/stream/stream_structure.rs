//! The structure of a stream: topology, adaptations and bridges. O(contracted links + seams +
//! bridges).

use super::bytes::{ByteReader, ByteWriter};
use crate::bridge::NetAdaptation;
use crate::topology::{ContractedLinks, LinkMatrix, SeamRun};
use crate::{Bridge, BridgeKind, BridgeMode, BridgeProperties, Direction, Net, Seam, Shape, Sides, Topology};
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use std::collections::HashMap;
use std::sync::Arc;

/// The flag of a byte of sides that a matrix follows instead.
const MATRIX_FLAG: u8 = 64;
/// The flag of a byte of sides that faces are reversed.
const REVERSED_FLAG: u8 = 128;

/// Kinds and modes of bridges by their numbers in a stream.
const BRIDGE_KINDS: [BridgeKind; 3] = [BridgeKind::Ribbon, BridgeKind::Tube, BridgeKind::Thread];
const BRIDGE_MODES: [BridgeMode; 3] = [BridgeMode::Keep, BridgeMode::Hide, BridgeMode::Weld];

/// Writes everything of a net except its coordinates. Returns the number of nodes and pairs of
/// seams of all topologies.
pub(super) fn write_structure(net: &Net<'_>, to: &mut ByteWriter) -> Result<u64> {
    write_topology(net.topology(), to)?;
    let adaptations = AdaptationList::new(net.bridges())?;
    adaptations.write(to)?;
    write_bridges(net.bridges(), &adaptations.position_of_adaptation, to)?;
    let adapted = adaptations.adaptations.iter().map(|adaptation| count_nodes_and_pairs(&adaptation.topology));
    Ok(adapted.fold(count_nodes_and_pairs(net.topology()), u64::saturating_add))
}

/// Reads a topology and its bridges. `limit` is the maximum number of nodes and pairs of seams.
///
/// # Errors
/// [`Error::BadStream`], [`Error::OutOfMemory`].
pub(super) fn read_structure(
    shape: Shape,
    mut max_nodes_and_pairs: u64,
    mut from: ByteReader<'_>,
) -> Result<(Topology, Vec<Bridge>)> {
    let topology = read_topology(shape, &mut max_nodes_and_pairs, &mut from)?;
    let mut adaptations = Vec::new();
    let count = from.read_varint()?;
    for _ in 0..count {
        let adaptation = read_adaptation(&adaptations, &mut max_nodes_and_pairs, &mut from)?;
        alloc::push(&mut adaptations, Arc::new(adaptation))?;
    }
    let bridges = read_list(&mut from, |from| read_bridge(shape, &adaptations, from))?;
    from.require_end()?;
    Ok((topology, bridges))
}

/// Returns the number of nodes and pairs of seams, which bounds the time to read a topology.
fn count_nodes_and_pairs(topology: &Topology) -> u64 {
    topology.shape().node_count() as u64 + topology.seams().iter().map(|seam| u64::from(seam.count)).sum::<u64>()
}

fn write_topology(topology: &Topology, to: &mut ByteWriter) -> Result<()> {
    let reversed = if topology.is_reversed() { REVERSED_FLAG } else { 0 };
    match topology.contracted_link_set() {
        ContractedLinks::Sides(sides) => to.write_u8(sides_to_bits(*sides) | reversed)?,
        ContractedLinks::Matrix(matrix) => {
            to.write_u8(MATRIX_FLAG | reversed)?;
            write_matrix(matrix, to)?;
        }
    }
    to.write_varint(topology.seams().len() as u64)?;
    topology.seams().iter().try_for_each(|seam| write_seam(seam, to))
}

/// Subtracts the work of the topology from `limit` before memory is allocated.
fn read_topology(shape: Shape, limit: &mut u64, from: &mut ByteReader<'_>) -> Result<Topology> {
    let too_much = from.error_here("it is too short for its content");
    *limit = limit.checked_sub(shape.node_count() as u64).ok_or(too_much)?;
    let bits = from.read_u8()?;
    let links = match bits & !REVERSED_FLAG {
        MATRIX_FLAG => ContractedLinks::Matrix(read_matrix(shape, from)?),
        sides if sides < MATRIX_FLAG => ContractedLinks::Sides(sides_from_bits(sides)),
        _ => return Err(from.error_here("the kind of gluing is unknown")),
    };
    let seams = read_list(from, read_seam)?;
    let pairs = seams.iter().fold(0u64, |sum, seam| sum.saturating_add(seam.count.into()));
    *limit = limit.checked_sub(pairs).ok_or(too_much)?;
    let bad = from.error_here("the gluing is impossible for a net");
    let topology = match Topology::from_canonical_parts(shape, links, seams) {
        Err(Error::OutOfMemory { bytes }) => return Err(Error::OutOfMemory { bytes }),
        topology => topology.ok().flatten().ok_or(bad)?,
    };
    Ok(topology.with_reversed(bits & REVERSED_FLAG != 0))
}

/// The adaptations of joined nets, each once, in topological order: those referred to come first.
struct AdaptationList<'a> {
    adaptations: Vec<&'a NetAdaptation>,
    /// The position of each in the list, from 1 on.
    position_of_adaptation: HashMap<*const NetAdaptation, u64>,
}

impl<'a> AdaptationList<'a> {
    fn new(bridges: &'a [Bridge]) -> Result<Self> {
        let mut adaptations = AdaptationList { adaptations: Vec::new(), position_of_adaptation: HashMap::new() };
        let mut open = Vec::new();
        push_adaptations_of_bridges(bridges, &mut open)?;
        // A record follows those within it.
        while let Some((adaptation, opened)) = open.pop() {
            if adaptations.position_of_adaptation.contains_key(&std::ptr::from_ref(adaptation)) {
                continue;
            }
            if opened {
                alloc::push(&mut adaptations.adaptations, adaptation)?;
                let bytes = 16 * adaptations.adaptations.len() as u64;
                adaptations.position_of_adaptation.try_reserve(1).map_err(|_| Error::OutOfMemory { bytes })?;
                adaptations
                    .position_of_adaptation
                    .insert(std::ptr::from_ref(adaptation), adaptations.adaptations.len() as u64);
            } else {
                alloc::push(&mut open, (adaptation, true))?;
                push_adaptations_of_bridges(&adaptation.bridges, &mut open)?;
            }
        }
        Ok(adaptations)
    }

    fn write(&self, to: &mut ByteWriter) -> Result<()> {
        to.write_varint(self.adaptations.len() as u64)?;
        for adaptation in &self.adaptations {
            write_shape(adaptation.joined_shape, to)?;
            to.write_u8(adaptation.flipped.into())?;
            to.write_varint(adaptation.twist.into())?;
            to.write_varint(adaptation.copies.len() as u64)?;
            let mut end = 0;
            for &copy in &adaptation.copies {
                to.write_varint(u64::from(copy) - end)?;
                end = u64::from(copy) + 1;
            }
            write_shape(adaptation.topology.shape(), to)?;
            write_topology(&adaptation.topology, to)?;
            write_bridges(&adaptation.bridges, &self.position_of_adaptation, to)?;
        }
        Ok(())
    }
}

fn push_adaptations_of_bridges<'a>(bridges: &'a [Bridge], open: &mut Vec<(&'a NetAdaptation, bool)>) -> Result<()> {
    let adaptations = bridges.iter().flat_map(|bridge| &bridge.adaptations).flatten();
    adaptations.into_iter().try_for_each(|adaptation| alloc::push(open, (&**adaptation, false)))
}

fn read_adaptation(
    adaptations: &[Arc<NetAdaptation>],
    limit: &mut u64,
    from: &mut ByteReader<'_>,
) -> Result<NetAdaptation> {
    let joined = read_shape(from)?;
    let flipped = from.read_flag()?.ok_or_else(|| from.error_here("a field has an unknown value"))?;
    let twist = from.read_varint_u32()?;
    let mut end = 0u64;
    let copies = read_list(from, |from| {
        let copy = end.saturating_add(from.read_varint()?);
        end = copy.saturating_add(1);
        u32::try_from(copy).map_err(|_| from.error_here("a number is too large"))
    })?;
    let shape = read_shape(from)?;
    let topology = read_topology(shape, limit, from)?;
    let bridges = read_list(from, |from| read_bridge(shape, adaptations, from))?;
    Ok(NetAdaptation { joined_shape: joined, flipped, copies, twist, topology, bridges })
}

/// Returns true if the adaptation is possible for a net joined in that direction.
fn is_adaptation_possible(adaptation: &NetAdaptation, direction: Direction) -> bool {
    let [(across, along), (old_across, old_along)] =
        [adaptation.joined_shape, adaptation.topology.shape()].map(|shape| direction.line_count_and_length(shape));
    let inside = |&copy: &u32| copy > 0 && (copy as usize) < along;
    across == old_across
        && along - adaptation.copies.len().min(along) == old_along
        && adaptation.copies.iter().all(inside)
}

fn write_shape(shape: Shape, to: &mut ByteWriter) -> Result<()> {
    to.write_varint(shape.rows() as u64)?;
    to.write_varint(shape.columns() as u64)
}

fn read_shape(from: &mut ByteReader<'_>) -> Result<Shape> {
    let [rows, columns] = [from.read_varint_u32()?, from.read_varint_u32()?];
    Shape::new(rows as usize, columns as usize).map_err(|_| from.error_here("the size is impossible for a net"))
}

/// Reads a list preceded by its length.
fn read_list<T>(from: &mut ByteReader<'_>, mut read: impl FnMut(&mut ByteReader<'_>) -> Result<T>) -> Result<Vec<T>> {
    let count = from.read_varint()?;
    // Every entry takes at least a byte.
    if count > from.remaining_bytes() as u64 {
        return Err(from.error_here("a list is longer than the stream"));
    }
    let mut items = Vec::new();
    for _ in 0..count {
        alloc::push(&mut items, read(from)?)?;
    }
    Ok(items)
}

fn sides_to_bits(sides: Sides) -> u8 {
    let Sides { rows_closed, columns_closed, pole_top, pole_bottom, pole_left, pole_right } = sides;
    let bits = [rows_closed, columns_closed, pole_top, pole_bottom, pole_left, pole_right];
    bits.into_iter().enumerate().map(|(k, bit)| u8::from(bit) << k).sum()
}

fn sides_from_bits(bits: u8) -> Sides {
    let [rows_closed, columns_closed, pole_top, pole_bottom, pole_left, pole_right] =
        std::array::from_fn(|k| bits >> k & 1 == 1);
    Sides { rows_closed, columns_closed, pole_top, pole_bottom, pole_left, pole_right }
}

/// Writes contracted links in runs of equal distance: the gap before the run, its length, the
/// distance.
fn write_matrix(matrix: &LinkMatrix, to: &mut ByteWriter) -> Result<()> {
    let mut links = matrix.links().peekable();
    let mut end = 0;
    while let Some(first) = links.next() {
        let distance = links.peek().map_or(0, |next| next - first);
        let (mut last, mut count) = (first, 1u64);
        while let Some(next) = links.next_if(|&next| next - last == distance) {
            (last, count) = (next, count + 1);
        }
        // Plus 1, as 0 ends the list.
        to.write_varint(u64::from(first) - end + 1)?;
        to.write_varint(count)?;
        if count > 1 {
            to.write_varint(distance.into())?;
        }
        end = u64::from(last) + 1;
    }
    to.write_varint(0)
}

fn read_matrix(shape: Shape, from: &mut ByteReader<'_>) -> Result<LinkMatrix> {
    let mut matrix = LinkMatrix::empty(shape)?;
    let limit = shape.link_count() as u64;
    let mut end = 0u64;
    loop {
        let first = match from.read_varint()? {
            0 => return Ok(matrix),
            n => end.saturating_add(n - 1),
        };
        let count = from.read_varint()?;
        let distance = if count > 1 { from.read_varint()? } else { 1 };
        let last = distance.checked_mul(count.saturating_sub(1)).and_then(|span| span.checked_add(first));
        let Some(last) = last.filter(|&last| count > 0 && distance > 0 && last < limit) else {
            return Err(from.error_here("a contracted link is beyond the net"));
        };
        (0..count).for_each(|k| matrix.set_contracted((first + k * distance) as u32, true));
        end = last + 1;
    }
}

fn write_seam(seam: &Seam, to: &mut ByteWriter) -> Result<()> {
    for run in [seam.a, seam.b] {
        to.write_varint(run.row.into())?;
        to.write_varint(run.column.into())?;
        to.write_signed_varint(run.row_step.into())?;
        to.write_signed_varint(run.column_step.into())?;
    }
    to.write_varint(seam.count.into())
}

fn read_seam(from: &mut ByteReader<'_>) -> Result<Seam> {
    let mut run = || -> Result<SeamRun> {
        Ok(SeamRun {
            row: from.read_varint_u32()?,
            column: from.read_varint_u32()?,
            row_step: from.read_signed_i32()?,
            column_step: from.read_signed_i32()?,
        })
    };
    let (a, b) = (run()?, run()?);
    Ok(Seam { a, b, count: from.read_varint_u32()? })
}

fn write_bridges(
    bridges: &[Bridge],
    adaptations: &HashMap<*const NetAdaptation, u64>,
    to: &mut ByteWriter,
) -> Result<()> {
    to.write_varint(bridges.len() as u64)?;
    bridges.iter().try_for_each(|bridge| write_bridge(bridge, adaptations, to))
}

/// Writes a bridge: direction, kind and mode in a byte, the place, the extent and the nesting. The
/// inner rows follow if there are any, then the adaptations of the nets on both sides, then the
/// properties unless all are zero.
fn write_bridge(bridge: &Bridge, adaptations: &HashMap<*const NetAdaptation, u64>, to: &mut ByteWriter) -> Result<()> {
    let direction = u8::from(bridge.direction == Direction::Down);
    let kind = BRIDGE_KINDS.iter().position(|&kind| kind == bridge.kind).unwrap_or(0) as u8;
    let mode = BRIDGE_MODES.iter().position(|&mode| mode == bridge.mode).unwrap_or(0) as u8;
    let BridgeProperties { tension, elasticity, stiffness, user } = bridge.properties;
    let bits = [tension.to_bits(), elasticity.to_bits(), stiffness.to_bits(), user];
    let plain = bits == [0; 4];
    to.write_u8(direction | kind << 1 | mode << 3 | u8::from(!plain) << 5 | u8::from(bridge.rows > 0) << 6)?;
    let numbers = [bridge.at, bridge.start, bridge.end, bridge.nesting];
    numbers.into_iter().try_for_each(|number| to.write_varint(number.into()))?;
    if bridge.rows > 0 {
        to.write_varint(bridge.rows.into())?;
    }
    for adaptation in &bridge.adaptations {
        let number = adaptation.as_ref().and_then(|adaptation| adaptations.get(&Arc::as_ptr(adaptation)));
        to.write_varint(number.copied().unwrap_or(0))?;
    }
    if plain { Ok(()) } else { bits.into_iter().try_for_each(|number| to.write_u64(number)) }
}

fn read_bridge(shape: Shape, adaptations: &[Arc<NetAdaptation>], from: &mut ByteReader<'_>) -> Result<Bridge> {
    let byte = from.read_u8()?;
    let direction = if byte & 1 == 0 { Direction::Right } else { Direction::Down };
    let entry = |shift: u8| usize::from(byte >> shift & 3);
    let kind = *BRIDGE_KINDS.get(entry(1)).ok_or_else(|| from.error_here("the kind of a bridge is unknown"))?;
    let mode = *BRIDGE_MODES.get(entry(3)).ok_or_else(|| from.error_here("the mode of a bridge is unknown"))?;
    let [at, start, end, nesting] =
        [from.read_varint_u32()?, from.read_varint_u32()?, from.read_varint_u32()?, from.read_varint_u32()?];
    let rows = if byte & 64 == 0 { 0 } else { from.read_varint_u32()? };
    let (across, along) = direction.line_count_and_length(shape);
    let inside = (1..across).contains(&(at as usize)) && end.saturating_sub(start) > 1 && end as usize <= along;
    // Inner rows are written only if there are any, and never in a welded bridge.
    let is_possible_width = rows < at && (byte & 64 == 0) == (rows == 0) && (rows == 0 || mode != BridgeMode::Weld);
    if byte >= 128 || !inside || !is_possible_width {
        return Err(from.error_here("a bridge is impossible for the net"));
    }
    let mut bridge = Bridge { start, nesting, rows, ..Bridge::new(direction, at, end, kind, mode) };
    for adaptation in &mut bridge.adaptations {
        let number = from.read_varint()?;
        if number > 0 {
            let place = usize::try_from(number - 1).unwrap_or(usize::MAX);
            let found = adaptations.get(place).filter(|adaptation| is_adaptation_possible(adaptation, direction));
            *adaptation =
                Some(Arc::clone(found.ok_or_else(|| from.error_here("the adaptation of a net is impossible"))?));
        }
    }
    if byte & 32 != 0 {
        let [tension, elasticity, stiffness] = [from.read_f64()?, from.read_f64()?, from.read_f64()?];
        bridge.properties = BridgeProperties { tension, elasticity, stiffness, user: from.read_u64()? };
    }
    Ok(bridge)
}

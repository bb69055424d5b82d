//! The structure of a stream: topology, adaptations and bridges. O(contracted links + seams +
//! bridges).

use super::bytes::{Reader, Writer};
use crate::bridge::Adaptation;
use crate::topology::{Links, Matrix, Run};
use crate::{Bridge, BridgeKind, BridgeMode, BridgeProperties, Direction, Net, Seam, Shape, Sides, Topology};
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use std::collections::HashMap;
use std::sync::Arc;

/// The flag of a byte of sides that a matrix follows instead.
const MATRIX: u8 = 64;
/// The flag of a byte of sides that faces are reversed.
const REVERSED: u8 = 128;

/// Kinds and modes of bridges by their numbers in a stream.
const KINDS: [BridgeKind; 3] = [BridgeKind::Ribbon, BridgeKind::Tube, BridgeKind::Thread];
const MODES: [BridgeMode; 3] = [BridgeMode::Keep, BridgeMode::Hide, BridgeMode::Weld];

/// Writes everything of a net except its coordinates. Returns the number of nodes and pairs of
/// seams of all topologies.
pub(super) fn write(net: &Net<'_>, to: &mut Writer) -> Result<u64> {
    write_topology(net.topology(), to)?;
    let adaptations = Adaptations::new(net.bridges())?;
    adaptations.write(to)?;
    write_bridges(net.bridges(), &adaptations.numbers, to)?;
    let adapted = adaptations.list.iter().map(|adaptation| work(&adaptation.topology));
    Ok(adapted.fold(work(net.topology()), u64::saturating_add))
}

/// Reads a topology and its bridges. `limit` is the maximum number of nodes and pairs of seams.
///
/// # Errors
/// [`Error::BadStream`], [`Error::OutOfMemory`].
pub(super) fn read(shape: Shape, mut limit: u64, mut from: Reader<'_>) -> Result<(Topology, Vec<Bridge>)> {
    let topology = read_topology(shape, &mut limit, &mut from)?;
    let mut adaptations = Vec::new();
    let count = from.varint()?;
    for _ in 0..count {
        let adaptation = read_adaptation(&adaptations, &mut limit, &mut from)?;
        alloc::push(&mut adaptations, Arc::new(adaptation))?;
    }
    let bridges = read_list(&mut from, |from| read_bridge(shape, &adaptations, from))?;
    from.finish()?;
    Ok((topology, bridges))
}

/// Returns the number of nodes and pairs of seams, which bounds the time to read a topology.
fn work(topology: &Topology) -> u64 {
    topology.shape().node_count() as u64 + topology.seams().iter().map(|seam| u64::from(seam.count)).sum::<u64>()
}

fn write_topology(topology: &Topology, to: &mut Writer) -> Result<()> {
    let reversed = if topology.is_reversed() { REVERSED } else { 0 };
    match topology.links() {
        Links::Sides(sides) => to.u8(sides_bits(*sides) | reversed)?,
        Links::Matrix(matrix) => {
            to.u8(MATRIX | reversed)?;
            write_matrix(matrix, to)?;
        }
    }
    to.varint(topology.seams().len() as u64)?;
    topology.seams().iter().try_for_each(|seam| write_seam(seam, to))
}

/// Subtracts the work of the topology from `limit` before memory is allocated.
fn read_topology(shape: Shape, limit: &mut u64, from: &mut Reader<'_>) -> Result<Topology> {
    let too_much = from.bad("it is too short for its content");
    *limit = limit.checked_sub(shape.node_count() as u64).ok_or(too_much)?;
    let bits = from.u8()?;
    let links = match bits & !REVERSED {
        MATRIX => Links::Matrix(read_matrix(shape, from)?),
        sides if sides < MATRIX => Links::Sides(sides_from_bits(sides)),
        _ => return Err(from.bad("the kind of gluing is unknown")),
    };
    let seams = read_list(from, read_seam)?;
    let pairs = seams.iter().fold(0u64, |sum, seam| sum.saturating_add(seam.count.into()));
    *limit = limit.checked_sub(pairs).ok_or(too_much)?;
    let bad = from.bad("the gluing is impossible for a net");
    let topology = match Topology::canonical(shape, links, seams) {
        Err(Error::OutOfMemory { bytes }) => return Err(Error::OutOfMemory { bytes }),
        topology => topology.ok().flatten().ok_or(bad)?,
    };
    Ok(topology.with_reversed(bits & REVERSED != 0))
}

/// The adaptations of joined nets, each once, in topological order: those referred to come first.
struct Adaptations<'a> {
    list: Vec<&'a Adaptation>,
    /// The position of each in the list, from 1 on.
    numbers: HashMap<*const Adaptation, u64>,
}

impl<'a> Adaptations<'a> {
    fn new(bridges: &'a [Bridge]) -> Result<Self> {
        let mut adaptations = Adaptations { list: Vec::new(), numbers: HashMap::new() };
        let mut open = Vec::new();
        push_adaptations(bridges, &mut open)?;
        // A record follows those within it.
        while let Some((adaptation, opened)) = open.pop() {
            if adaptations.numbers.contains_key(&std::ptr::from_ref(adaptation)) {
                continue;
            }
            if opened {
                alloc::push(&mut adaptations.list, adaptation)?;
                let bytes = 16 * adaptations.list.len() as u64;
                adaptations.numbers.try_reserve(1).map_err(|_| Error::OutOfMemory { bytes })?;
                adaptations.numbers.insert(std::ptr::from_ref(adaptation), adaptations.list.len() as u64);
            } else {
                alloc::push(&mut open, (adaptation, true))?;
                push_adaptations(&adaptation.bridges, &mut open)?;
            }
        }
        Ok(adaptations)
    }

    fn write(&self, to: &mut Writer) -> Result<()> {
        to.varint(self.list.len() as u64)?;
        for adaptation in &self.list {
            write_shape(adaptation.joined, to)?;
            to.u8(adaptation.flipped.into())?;
            to.varint(adaptation.twist.into())?;
            to.varint(adaptation.copies.len() as u64)?;
            let mut end = 0;
            for &copy in &adaptation.copies {
                to.varint(u64::from(copy) - end)?;
                end = u64::from(copy) + 1;
            }
            write_shape(adaptation.topology.shape(), to)?;
            write_topology(&adaptation.topology, to)?;
            write_bridges(&adaptation.bridges, &self.numbers, to)?;
        }
        Ok(())
    }
}

fn push_adaptations<'a>(bridges: &'a [Bridge], open: &mut Vec<(&'a Adaptation, bool)>) -> Result<()> {
    let adaptations = bridges.iter().flat_map(|bridge| &bridge.adaptations).flatten();
    adaptations.into_iter().try_for_each(|adaptation| alloc::push(open, (&**adaptation, false)))
}

fn read_adaptation(adaptations: &[Arc<Adaptation>], limit: &mut u64, from: &mut Reader<'_>) -> Result<Adaptation> {
    let joined = read_shape(from)?;
    let flipped = from.flag()?.ok_or_else(|| from.bad("a field has an unknown value"))?;
    let twist = from.varint_u32()?;
    let mut end = 0u64;
    let copies = read_list(from, |from| {
        let copy = end.saturating_add(from.varint()?);
        end = copy.saturating_add(1);
        u32::try_from(copy).map_err(|_| from.bad("a number is too large"))
    })?;
    let shape = read_shape(from)?;
    let topology = read_topology(shape, limit, from)?;
    let bridges = read_list(from, |from| read_bridge(shape, adaptations, from))?;
    Ok(Adaptation { joined, flipped, copies, twist, topology, bridges })
}

/// Returns true if the adaptation is possible for a net joined in that direction.
fn is_possible(adaptation: &Adaptation, direction: Direction) -> bool {
    let [(across, along), (old_across, old_along)] =
        [adaptation.joined, adaptation.topology.shape()].map(|shape| direction.extent(shape));
    let inside = |&copy: &u32| copy > 0 && (copy as usize) < along;
    across == old_across
        && along - adaptation.copies.len().min(along) == old_along
        && adaptation.copies.iter().all(inside)
}

fn write_shape(shape: Shape, to: &mut Writer) -> Result<()> {
    to.varint(shape.rows() as u64)?;
    to.varint(shape.columns() as u64)
}

fn read_shape(from: &mut Reader<'_>) -> Result<Shape> {
    let [rows, columns] = [from.varint_u32()?, from.varint_u32()?];
    Shape::new(rows as usize, columns as usize).map_err(|_| from.bad("the size is impossible for a net"))
}

/// Reads a list preceded by its length.
fn read_list<T>(from: &mut Reader<'_>, mut read: impl FnMut(&mut Reader<'_>) -> Result<T>) -> Result<Vec<T>> {
    let count = from.varint()?;
    // Every entry takes at least a byte.
    if count > from.remaining() as u64 {
        return Err(from.bad("a list is longer than the stream"));
    }
    let mut items = Vec::new();
    for _ in 0..count {
        alloc::push(&mut items, read(from)?)?;
    }
    Ok(items)
}

fn sides_bits(sides: Sides) -> u8 {
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
fn write_matrix(matrix: &Matrix, to: &mut Writer) -> Result<()> {
    let mut links = matrix.links().peekable();
    let mut end = 0;
    while let Some(first) = links.next() {
        let distance = links.peek().map_or(0, |next| next - first);
        let (mut last, mut count) = (first, 1u64);
        while let Some(next) = links.next_if(|&next| next - last == distance) {
            (last, count) = (next, count + 1);
        }
        // Plus 1, as 0 ends the list.
        to.varint(u64::from(first) - end + 1)?;
        to.varint(count)?;
        if count > 1 {
            to.varint(distance.into())?;
        }
        end = u64::from(last) + 1;
    }
    to.varint(0)
}

fn read_matrix(shape: Shape, from: &mut Reader<'_>) -> Result<Matrix> {
    let mut matrix = Matrix::empty(shape)?;
    let limit = 2 * shape.node_count() as u64;
    let mut end = 0u64;
    loop {
        let first = match from.varint()? {
            0 => return Ok(matrix),
            n => end.saturating_add(n - 1),
        };
        let count = from.varint()?;
        let distance = if count > 1 { from.varint()? } else { 1 };
        let last = distance.checked_mul(count.saturating_sub(1)).and_then(|span| span.checked_add(first));
        let Some(last) = last.filter(|&last| count > 0 && distance > 0 && last < limit) else {
            return Err(from.bad("a contracted link is beyond the net"));
        };
        (0..count).for_each(|k| matrix.set((first + k * distance) as u32, true));
        end = last + 1;
    }
}

fn write_seam(seam: &Seam, to: &mut Writer) -> Result<()> {
    for run in [seam.a, seam.b] {
        to.varint(run.row.into())?;
        to.varint(run.column.into())?;
        to.signed(run.row_step.into())?;
        to.signed(run.column_step.into())?;
    }
    to.varint(seam.count.into())
}

fn read_seam(from: &mut Reader<'_>) -> Result<Seam> {
    let mut run = || -> Result<Run> {
        Ok(Run {
            row: from.varint_u32()?,
            column: from.varint_u32()?,
            row_step: from.signed_i32()?,
            column_step: from.signed_i32()?,
        })
    };
    let (a, b) = (run()?, run()?);
    Ok(Seam { a, b, count: from.varint_u32()? })
}

fn write_bridges(bridges: &[Bridge], adaptations: &HashMap<*const Adaptation, u64>, to: &mut Writer) -> Result<()> {
    to.varint(bridges.len() as u64)?;
    bridges.iter().try_for_each(|bridge| write_bridge(bridge, adaptations, to))
}

/// Writes a bridge: direction, kind and mode in a byte, the place, the extent and the nesting. The
/// inner rows follow if there are any, then the adaptations of the nets on both sides, then the
/// properties unless all are zero.
fn write_bridge(bridge: &Bridge, adaptations: &HashMap<*const Adaptation, u64>, to: &mut Writer) -> Result<()> {
    let direction = u8::from(bridge.direction == Direction::Down);
    let kind = KINDS.iter().position(|&kind| kind == bridge.kind).unwrap_or(0) as u8;
    let mode = MODES.iter().position(|&mode| mode == bridge.mode).unwrap_or(0) as u8;
    let BridgeProperties { tension, elasticity, stiffness, user } = bridge.properties;
    let bits = [tension.to_bits(), elasticity.to_bits(), stiffness.to_bits(), user];
    let plain = bits == [0; 4];
    to.u8(direction | kind << 1 | mode << 3 | u8::from(!plain) << 5 | u8::from(bridge.rows > 0) << 6)?;
    let numbers = [bridge.at, bridge.start, bridge.end, bridge.nesting];
    numbers.into_iter().try_for_each(|number| to.varint(number.into()))?;
    if bridge.rows > 0 {
        to.varint(bridge.rows.into())?;
    }
    for adaptation in &bridge.adaptations {
        let number = adaptation.as_ref().and_then(|adaptation| adaptations.get(&Arc::as_ptr(adaptation)));
        to.varint(number.copied().unwrap_or(0))?;
    }
    if plain { Ok(()) } else { bits.into_iter().try_for_each(|number| to.u64(number)) }
}

fn read_bridge(shape: Shape, adaptations: &[Arc<Adaptation>], from: &mut Reader<'_>) -> Result<Bridge> {
    let byte = from.u8()?;
    let direction = if byte & 1 == 0 { Direction::Right } else { Direction::Down };
    let entry = |shift: u8| usize::from(byte >> shift & 3);
    let kind = *KINDS.get(entry(1)).ok_or_else(|| from.bad("the kind of a bridge is unknown"))?;
    let mode = *MODES.get(entry(3)).ok_or_else(|| from.bad("the mode of a bridge is unknown"))?;
    let [at, start, end, nesting] = [from.varint_u32()?, from.varint_u32()?, from.varint_u32()?, from.varint_u32()?];
    let rows = if byte & 64 == 0 { 0 } else { from.varint_u32()? };
    let (across, along) = direction.extent(shape);
    let inside = (1..across).contains(&(at as usize)) && end.saturating_sub(start) > 1 && end as usize <= along;
    // Inner rows are written only if there are any, and never in a welded bridge.
    let is_possible_width = rows < at && (byte & 64 == 0) == (rows == 0) && (rows == 0 || mode != BridgeMode::Weld);
    if byte >= 128 || !inside || !is_possible_width {
        return Err(from.bad("a bridge is impossible for the net"));
    }
    let mut bridge = Bridge { start, nesting, rows, ..Bridge::new(direction, at, end, kind, mode) };
    for adaptation in &mut bridge.adaptations {
        let number = from.varint()?;
        if number > 0 {
            let place = usize::try_from(number - 1).unwrap_or(usize::MAX);
            let found = adaptations.get(place).filter(|adaptation| is_possible(adaptation, direction));
            *adaptation = Some(Arc::clone(found.ok_or_else(|| from.bad("the adaptation of a net is impossible"))?));
        }
    }
    if byte & 32 != 0 {
        let [tension, elasticity, stiffness] = [from.f64()?, from.f64()?, from.f64()?];
        bridge.properties = BridgeProperties { tension, elasticity, stiffness, user: from.u64()? };
    }
    Ok(bridge)
}

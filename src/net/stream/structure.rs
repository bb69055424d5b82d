//! Topology and bridges to bytes and back.

use super::bytes::{Reader, Writer};
use crate::alloc;
use crate::error::{Error, Result};
use crate::net::topology::{Links, Matrix, Run};
use crate::net::{Bridge, BridgeKind, BridgeMode, BridgeProperties, Direction, Net, Seam, Shape, Sides, Topology};

/// The bit of a byte of sides that says that a matrix follows, and the one that says that faces are reversed.
const MATRIX: u8 = 64;
const REVERSED: u8 = 128;

/// Nodes and pairs of seams: what reading a topology takes time for.
pub(super) fn work(topology: &Topology) -> u64 {
    topology.shape().node_count() as u64 + topology.seams().iter().map(|seam| u64::from(seam.count)).sum::<u64>()
}

pub(super) fn write(net: &Net<'_>, to: &mut Writer) -> Result<()> {
    let topology = net.topology();
    let reversed = if topology.is_reversed() { REVERSED } else { 0 };
    match topology.links() {
        Links::Sides(sides) => to.u8(sides_bits(*sides) | reversed)?,
        Links::Matrix(matrix) => {
            to.u8(MATRIX | reversed)?;
            write_matrix(matrix, to)?;
        }
    }
    to.varint(topology.seams().len() as u64)?;
    topology.seams().iter().try_for_each(|seam| write_seam(seam, to))?;
    to.varint(net.bridges().len() as u64)?;
    net.bridges().iter().try_for_each(|bridge| write_bridge(bridge, to))
}

/// `limit`: nodes and pairs of seams that there may be together.
///
/// # Errors
/// [`Error::BadStream`], [`Error::OutOfMemory`].
pub(super) fn read(shape: Shape, limit: u64, mut from: Reader<'_>) -> Result<(Topology, Vec<Bridge>)> {
    let bits = from.u8()?;
    let links = match bits & !REVERSED {
        MATRIX => Links::Matrix(read_matrix(shape, &mut from)?),
        sides if sides < MATRIX => Links::Sides(sides_of(sides)),
        _ => return Err(from.bad("the kind of gluing is unknown")),
    };
    let seams = list(&mut from, read_seam)?;
    let bridges = list(&mut from, |from| read_bridge(shape, from))?;
    let end = from.bad("the gluing is none that a net has");
    from.finish()?;
    let pairs = seams.iter().fold(shape.node_count() as u64, |sum, seam| sum.saturating_add(seam.count.into()));
    if pairs > limit {
        return Err(end);
    }
    let topology = match Topology::canonical(shape, links, seams) {
        Err(Error::OutOfMemory { bytes }) => return Err(Error::OutOfMemory { bytes }),
        topology => topology.ok().flatten().ok_or(end)?,
    };
    Ok((topology.with_reversed(bits & REVERSED != 0), bridges))
}

/// A list that says how long it is.
fn list<T>(from: &mut Reader<'_>, mut read: impl FnMut(&mut Reader<'_>) -> Result<T>) -> Result<Vec<T>> {
    let count = from.varint()?;
    // Every entry takes a byte at least.
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

fn sides_of(bits: u8) -> Sides {
    let on = |k: u32| bits >> k & 1 == 1;
    Sides {
        rows_closed: on(0),
        columns_closed: on(1),
        pole_top: on(2),
        pole_bottom: on(3),
        pole_left: on(4),
        pole_right: on(5),
    }
}

/// Contracted links in runs of equal distance: how far each run begins after the link before, the distance, how many.
fn write_matrix(matrix: &Matrix, to: &mut Writer) -> Result<()> {
    let mut links = matrix.links().peekable();
    let mut end = 0;
    while let Some(first) = links.next() {
        let distance = links.peek().map_or(0, |next| next - first);
        let (mut last, mut count) = (first, 1u64);
        while let Some(next) = links.next_if(|&next| next - last == distance) {
            (last, count) = (next, count + 1);
        }
        // One more than what it is: 0 ends the list.
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

/// Direction, kind and mode in a byte, the place, and the host's numbers if they are not all zero.
fn write_bridge(bridge: &Bridge, to: &mut Writer) -> Result<()> {
    let Bridge { direction, at, kind, mode, properties } = bridge;
    let direction = u8::from(*direction == Direction::Down);
    let kind = match kind {
        BridgeKind::Ribbon => 0,
        BridgeKind::Tube => 1,
        BridgeKind::Thread => 2,
    };
    let mode = match mode {
        BridgeMode::Keep => 0,
        BridgeMode::Hide => 1,
        BridgeMode::Weld => 2,
    };
    let BridgeProperties { tension, elasticity, stiffness, user } = *properties;
    let bits = [tension.to_bits(), elasticity.to_bits(), stiffness.to_bits(), user];
    let plain = bits == [0; 4];
    to.u8(direction | kind << 1 | mode << 3 | u8::from(!plain) << 5)?;
    to.varint((*at).into())?;
    if plain { Ok(()) } else { bits.into_iter().try_for_each(|number| to.u64(number)) }
}

fn read_bridge(shape: Shape, from: &mut Reader<'_>) -> Result<Bridge> {
    let byte = from.u8()?;
    let at = from.varint_u32()?;
    let (direction, lines) = match byte & 1 {
        0 => (Direction::Right, shape.columns()),
        _ => (Direction::Down, shape.rows()),
    };
    let kind = match byte >> 1 & 3 {
        0 => BridgeKind::Ribbon,
        1 => BridgeKind::Tube,
        2 => BridgeKind::Thread,
        _ => return Err(from.bad("the kind of a bridge is unknown")),
    };
    let mode = match byte >> 3 & 3 {
        0 => BridgeMode::Keep,
        1 => BridgeMode::Hide,
        2 => BridgeMode::Weld,
        _ => return Err(from.bad("the mode of a bridge is unknown")),
    };
    if byte >= 64 || !(1..lines).contains(&(at as usize)) {
        return Err(from.bad("a bridge is none that a net has"));
    }
    let mut properties = BridgeProperties::default();
    if byte & 32 != 0 {
        let [tension, elasticity, stiffness] = [from.f64()?, from.f64()?, from.f64()?];
        properties = BridgeProperties { tension, elasticity, stiffness, user: from.u64()? };
    }
    Ok(Bridge { direction, at, kind, mode, properties })
}

//! Making a net fit for being joined, and undoing that.

use super::JoinOptions;
use crate::alloc;
use crate::error::{Error, Result};
use crate::job::Job;
use crate::net::arrange::{carried, closing_rows, joined, rearranged};
use crate::net::bridge::Origin;
use crate::net::reformat::{Picked, copies, starts_for, starts_of_copies};
use crate::net::topology::{Links, Matrix};
use crate::net::{Bridge, Direction, Net, Planes, Real, Replication, Topology, each};
use std::sync::Arc;

/// A net as it is joined: itself, or a copy of another size, turned or flipped.
pub(super) enum Prepared<'n, 'a> {
    Given(&'n Net<'a>),
    Made(Box<(Net<'static>, Arc<Origin>)>),
}

impl<'n, 'a> Prepared<'n, 'a> {
    /// `flipped`: its faces would be taken the other way round than those of the others. `along`: the nodes of the side.
    pub(super) fn new(
        net: &'n Net<'a>,
        flipped: bool,
        along: usize,
        twist: u32,
        options: &JoinOptions,
    ) -> Result<Self> {
        let (direction, job) = (options.direction, Job::default());
        let nodes = direction.extent(net.shape()).1;
        if flipped && !options.turn {
            return Err(Error::NetsOpposed);
        }
        if !flipped && nodes == along && twist == 0 {
            return Ok(Prepared::Given(net));
        }
        let mut made = if flipped { flipped_along(net, direction, &job)? } else { net.copied()? };
        let mut added = Vec::new();
        if nodes != along {
            let how = options.equalise.unwrap_or_default();
            let axis = direction.transposed();
            added = copies(&starts_for(made.topology(), axis, along, how)?)?;
            let none = Replication::Last;
            let shape = made.shape();
            made = match direction {
                Direction::Right => made.reformatted(along, shape.columns(), [how, none], &job)?,
                Direction::Down => made.reformatted(shape.rows(), along, [none, how], &job)?,
            };
        }
        if twist > 0 {
            made = twisted(&made, direction, twist, &job)?;
        }
        let bridges = alloc::collect(net.bridges().iter().cloned())?;
        let (joined, topology) = (made.shape(), net.topology().clone());
        let origin = Arc::new(Origin { joined, flipped, copies: added, twist, topology, bridges });
        Ok(Prepared::Made(Box::new((made, origin))))
    }

    pub(super) fn net(&self) -> &Net<'a> {
        match self {
            Prepared::Given(net) => net,
            Prepared::Made(made) => &made.0,
        }
    }

    pub(super) fn origin(&self) -> Option<Arc<Origin>> {
        match self {
            Prepared::Given(_) => None,
            Prepared::Made(made) => Some(Arc::clone(&made.1)),
        }
    }
}

/// Turned over along the side that is joined, so that what is first in the direction stays so.
fn flipped_along(net: &Net<'_>, direction: Direction, job: &Job<'_>) -> Result<Net<'static>> {
    match direction {
        Direction::Right => net.flipped_rows(job),
        Direction::Down => net.flipped_columns(job),
    }
}

/// Undoes what was done before the net was joined, if it still has the size that it was joined with.
///
/// If nobody has glued anything since, the topology is the very one that was kept; else the way back of what is there now.
pub(super) fn restored(net: Net<'static>, origin: Option<&Origin>, direction: Direction) -> Result<Net<'static>> {
    let Some(origin) = origin.filter(|origin| origin.joined == net.shape()) else { return Ok(net) };
    let (axis, job) = (direction.transposed(), Job::default());
    // A net that was mirrored since is the same gluing, seen from the other side.
    let prepared = origin.prepared(direction)?;
    let untouched = net.topology().clone().with_reversed(prepared.is_reversed()) == prepared;
    let mut bridges = alloc::collect(net.bridges().iter().cloned())?;
    let mut net = net;
    if origin.twist > 0 {
        let around = axis.extent(net.shape()).0 as u32 - 1;
        net = twisted(&net, direction, around - origin.twist % around, &job)?;
    }
    net = net.without(axis, &origin.copies, &job)?;
    if origin.flipped {
        net = flipped_along(&net, direction, &job)?;
    }
    if untouched {
        let reversed = net.topology().is_reversed();
        net.set_topology(origin.topology.clone().with_reversed(reversed));
    }
    if bridges.len() == origin.bridges.len() {
        for (bridge, old) in bridges.iter_mut().zip(&origin.bridges) {
            *bridge = Bridge { mode: bridge.mode, properties: bridge.properties, ..old.clone() };
        }
        *net.bridges_mut() = bridges;
    }
    Ok(net)
}

impl Origin {
    /// The topology that the net was joined with.
    fn prepared(&self, direction: Direction) -> Result<Topology> {
        // As if the side were a row and columns were replicated: the rows of the transposed.
        let mut topology = match direction {
            Direction::Right => self.topology.clone(),
            Direction::Down => self.topology.transposed()?,
        };
        if self.flipped {
            topology = topology.flipped_rows()?;
        }
        let along = direction.extent(self.joined).1;
        topology = topology.rows_replicated(&starts_of_copies(along, &self.copies)?)?;
        if self.twist > 0 {
            topology = rows_turned(&topology, self.twist as usize % (along - 1))?;
        }
        match direction {
            Direction::Right => Ok(topology),
            Direction::Down => topology.transposed(),
        }
    }
}

impl Drop for Origin {
    /// Accounts within accounts, however deep, are freed one after the other.
    fn drop(&mut self) {
        let mut open: Vec<Bridge> = std::mem::take(&mut self.bridges);
        while let Some(mut bridge) = open.pop() {
            for mut origin in bridge.origins.iter_mut().filter_map(|origin| Arc::into_inner(origin.take()?)) {
                open.append(&mut origin.bridges);
            }
        }
    }
}

/// The net turned by `twist` places along its closed side.
fn twisted(net: &Net<'_>, direction: Direction, twist: u32, job: &Job<'_>) -> Result<Net<'static>> {
    let axis = direction.transposed();
    let (count, _) = axis.extent(net.shape());
    let place = twist as usize % (count - 1);
    let transposed = direction == Direction::Down;
    let topology = if transposed { net.topology().transposed()? } else { net.topology().clone() };
    let shape = topology.shape();
    let closed = |k: usize| topology.contracts(2 * shape.node(count - 1, k) + 1);
    if !(0..shape.columns()).all(closed) {
        return Err(Error::OptionOutOfRange { option: "twist", value: f64::from(twist) });
    }
    each!(net.coordinates(), planes => check_closed(planes, axis))?;
    let topology = rows_turned(&topology, place)?;
    let topology = if transposed { topology.transposed()? } else { topology };
    let turned = alloc::collect((0..count).map(|i| ((i + place) % (count - 1)) as u32))?;
    let all = alloc::collect((0..direction.extent(net.shape()).0).map(|i| i as u32))?;
    let (rows, columns) = if transposed { (all, turned) } else { (turned, all) };
    let picked = Picked { shape: net.shape(), rows, columns };
    let mut made = Net::new(rearranged(net.coordinates(), &picked, job)?, topology);
    // Bridges across the side go round with it as long as they are not cut.
    for bridge in net.bridges() {
        if bridge.direction == direction {
            alloc::push(made.bridges_mut(), bridge.clone())?;
        } else {
            return Err(Error::OptionOutOfRange { option: "twist", value: f64::from(twist) });
        }
    }
    Ok(made)
}

/// [`Error::SidesApart`] unless the last row (`Down`) or column has the bits of the first: one of the two is lost by turning.
fn check_closed<T: Real>(planes: &Planes<'_, T>, axis: Direction) -> Result<()> {
    let (count, along) = axis.extent(planes.shape());
    for k in 0..along {
        let at = |i: usize| if axis == Direction::Down { (i, k) } else { (k, i) };
        let [(p, q), (r, s)] = [at(0), at(count - 1)];
        let stride = planes.stride();
        let same =
            |matrix: &[T]| bytemuck::bytes_of(&matrix[p * stride + q]) == bytemuck::bytes_of(&matrix[r * stride + s]);
        if !planes.matrices().into_iter().all(same) {
            let distance = planes.get(p, q).distance(planes.get(r, s));
            return Err(Error::SidesApart { place: k as u32, distance });
        }
    }
    Ok(())
}

/// The topology of a net with closed columns whose row `by` has become the first.
fn rows_turned(topology: &Topology, by: usize) -> Result<Topology> {
    let shape = topology.shape();
    let around = shape.rows() - 1;
    let place = |i: usize| (i % around + around - by) % around;
    let mut matrix = Matrix::empty(shape)?;
    topology.each_contracted(|link| {
        let (i, j) = shape.place(link / 2);
        match (link % 2, i == around) {
            // The last row is the first: a link along either is one along the row that both become.
            (0, _) => {
                let i = i % around;
                matrix.set(2 * shape.node(place(i), j), true);
                if i == by {
                    matrix.set(2 * shape.node(around, j), true);
                }
            }
            (_, true) => matrix.set(link, true),
            (_, false) => matrix.set(2 * shape.node(place(i), j) + 1, true),
        }
    });
    let mut seams = Vec::new();
    for &seam in topology.seams() {
        carried(seam, |(i, j)| Some((place(i as usize) as i64, j)), &mut seams)?;
    }
    let mut seams = joined(&seams)?;
    // What was a seam for naming the last row here and the first there may now close rows, which links say when the net is
    // cut out again.
    seams.retain(|&seam| match closing_rows(shape, seam) {
        Some(rows) => {
            rows.for_each(|i| matrix.set(2 * shape.node(i, shape.columns() - 1), true));
            false
        }
        None => true,
    });
    Topology::assembled(shape, Links::Matrix(matrix), seams, topology.is_reversed())
}

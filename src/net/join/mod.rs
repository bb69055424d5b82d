//! Joining nets side by side, and taking them apart again (paper, "Concatenation", Figs. 8 and 9).
//!
//! The columns, or rows, of one net follow those of another; between them lies a row of new cells, the bridge. Nets of
//! different sizes are reformatted first. A net whose rows are closed, joined to another on its right, is closed no more by
//! the links that lead back, as these now start from the other net's last column: they become a seam, so that every net stays
//! what it was. Everything that is done can be undone: [`Net::split`] gives the nets back bit for bit.
//!
//! `prepare` makes nets fit, `gluing` joins topologies, `nodes` coordinates, `split` takes apart.

mod gluing;
mod nodes;
mod prepare;
mod split;

use super::{Bridge, BridgeMode, BridgeProperties, Direction, Net, Replication, Shape};
use crate::alloc;
use crate::error::{Element, Error, Result};
use crate::geom::scale::distance;
use crate::job::Job;
use glam::DVec3;
use prepare::Prepared;

/// How nets are joined.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct JoinOptions {
    /// On which side of the first net the second one lies.
    pub direction: Direction,
    /// What becomes of the cells between them.
    pub mode: BridgeMode,
    /// How far nodes that are welded may be apart, at least 0.
    pub tolerance: f64,
    /// How the smaller net is enlarged if the sides have different numbers of nodes; `None` refuses.
    pub equalise: Option<Replication>,
    /// The side of the second net is closed, and it is turned by so many places: its node `twist` comes first.
    pub twist: u32,
    /// Nets whose faces are taken the other way round than those of the first are flipped along the side; else refused.
    pub turn: bool,
    /// For the host's use.
    pub properties: BridgeProperties,
}

impl JoinOptions {
    /// The second net in a direction from the first, sizes equalised, the bridge kept.
    pub fn new(direction: Direction) -> Self {
        JoinOptions {
            direction,
            mode: BridgeMode::Keep,
            tolerance: 0.0,
            equalise: Some(Replication::Uniform),
            twist: 0,
            turn: false,
            properties: BridgeProperties::default(),
        }
    }
}

/// Joins two nets. O(nodes).
///
/// # Errors
/// [`Error::MixedScalars`], [`Error::NetsOpposed`], [`Error::SidesDiffer`], [`Error::OptionOutOfRange`] for the tolerance and
/// for a twist of an open side, [`Error::SidesApart`] if nodes to be welded, or the ends of a side that is turned, do not lie on
/// each other, [`Error::CrossingCell`], [`Error::TooLarge`], [`Error::OutOfMemory`], [`Error::Cancelled`].
pub fn concatenate(a: &Net<'_>, b: &Net<'_>, options: &JoinOptions, job: &Job<'_>) -> Result<Net<'static>> {
    join_mirrored(&[a, b], &[false; 2], options, job)
}

/// Joins any number of nets in one pass; a twist turns each but the first. O(nodes).
///
/// # Errors
/// As [`concatenate`], and [`Error::EmptyScene`] for none; places of sides that are apart count along the side.
pub fn concatenate_all(nets: &[&Net<'_>], options: &JoinOptions, job: &Job<'_>) -> Result<Net<'static>> {
    let mirrored = alloc::filled(false, nets.len())?;
    join_mirrored(nets, &mirrored, options, job)
}

/// Joins nets whose coordinates are to be changed afterwards; `mirrored` says which of them in a way that turns faces over.
pub(crate) fn join_mirrored(
    nets: &[&Net<'_>],
    mirrored: &[bool],
    options: &JoinOptions,
    job: &Job<'_>,
) -> Result<Net<'static>> {
    let Some(first) = nets.first() else { return Err(Error::EmptyScene) };
    check_tolerance(options.tolerance)?;
    let mut along = 0;
    for net in nets {
        if net.coordinates().scalar() != first.coordinates().scalar() {
            return Err(Error::MixedScalars);
        }
        let [a, b] = [first, net].map(|net| options.direction.extent(net.shape()).1);
        if a != b && options.equalise.is_none() {
            return Err(Error::SidesDiffer { a: a as u32, b: b as u32 });
        }
        along = along.max(b);
    }
    joined_shape(nets.iter().map(|net| net.shape()), options.direction, along)?;
    let mut prepared = alloc::with_capacity(nets.len())?;
    let reversed = first.topology().is_reversed() != mirrored[0];
    for (k, (net, &mirrored)) in nets.iter().zip(mirrored).enumerate() {
        if k % 256 == 0 {
            job.step(0.3 * k as f64 / nets.len() as f64, "fitting nets")?;
        }
        let flip = (net.topology().is_reversed() != mirrored) != reversed;
        prepared.push(Prepared::new(net, flip, along, if k == 0 { 0 } else { options.twist }, options)?);
    }
    if options.mode == BridgeMode::Weld {
        prepared
            .windows(2)
            .try_for_each(|pair| check_together(pair[0].net(), pair[1].net(), options.direction, options.tolerance))?;
    }
    let nets: Vec<&Net<'_>> = alloc::collect(prepared.iter().map(Prepared::net))?;
    let topology = gluing::joined(&nets, options.direction, options.mode == BridgeMode::Weld)?;
    let coordinates = nodes::joined(&nets, options.direction, topology.shape(), &job.part(0.3, 1.0))?;
    let mut net = Net::new(coordinates, topology.with_reversed(reversed));
    add_bridges(&mut net, &prepared, options)?;
    Ok(net)
}

/// The size of nets that are joined by sides of `along` nodes.
fn joined_shape(shapes: impl Iterator<Item = Shape>, direction: Direction, along: usize) -> Result<Shape> {
    let across = shapes.map(|shape| direction.extent(shape).0).fold(0, usize::saturating_add);
    match direction {
        Direction::Right => Shape::new(along, across),
        Direction::Down => Shape::new(across, along),
    }
}

/// The nets' own bridges and those between them, in the order in which joining them one by one would make them.
fn add_bridges(net: &mut Net<'_>, prepared: &[Prepared<'_, '_>], options: &JoinOptions) -> Result<()> {
    let direction = options.direction;
    let along = direction.extent(net.shape()).1 as u32;
    let own: usize = prepared.iter().map(|part| part.net().bridges().len()).sum();
    alloc::reserve(net.bridges_mut(), own + prepared.len() - 1)?;
    let mut at = 0;
    for (k, part) in prepared.iter().enumerate() {
        for bridge in part.net().bridges() {
            let bridge = bridge.shifted(direction, at);
            alloc::push(net.bridges_mut(), Bridge { nesting: bridge.nesting.saturating_add(1), ..bridge })?;
        }
        if let Some(before) = k.checked_sub(1).and_then(|k| prepared.get(k)) {
            let kind = gluing::kind(before.net().topology(), part.net().topology(), direction)?;
            // The account of a net is with the bridge before it; that of the first net with the one behind it.
            let first = if k == 1 { before.origin() } else { None };
            let mut bridge = Bridge::new(direction, at, along, kind, options.mode);
            bridge.properties = options.properties;
            bridge.origins = [first, part.origin()];
            alloc::push(net.bridges_mut(), bridge)?;
        }
        at += direction.extent(part.net().shape()).0 as u32;
    }
    Ok(())
}

impl Bridge {
    /// Where it is when its net starts `by` nodes further on.
    pub(crate) fn shifted(&self, direction: Direction, by: u32) -> Bridge {
        let bridge = self.clone();
        if self.direction == direction {
            Bridge { at: self.at + by, ..bridge }
        } else {
            Bridge { start: self.start + by, end: self.end + by, ..bridge }
        }
    }
}

/// [`Error::SidesApart`] unless each node of the last side of one net is within the tolerance of that of the first side of the
/// other, or both are missing.
fn check_together(a: &Net<'_>, b: &Net<'_>, direction: Direction, tolerance: f64) -> Result<()> {
    let (across, along) = direction.extent(a.shape());
    for k in 0..along {
        let [p, q] = match direction {
            Direction::Right => [a.get(k, across - 1), b.get(k, 0)],
            Direction::Down => [a.get(across - 1, k), b.get(0, k)],
        };
        check_pair(p, q, k as u32, tolerance)?;
    }
    Ok(())
}

/// [`Error::SidesApart`] unless two nodes are within the tolerance, or both are missing.
fn check_pair(p: DVec3, q: DVec3, place: u32, tolerance: f64) -> Result<()> {
    let distance = distance(p, q);
    let together = distance <= tolerance || !(p.is_finite() || q.is_finite());
    if together { Ok(()) } else { Err(Error::SidesApart { place, distance }) }
}

fn check_tolerance(value: f64) -> Result<()> {
    if value >= 0.0 { Ok(()) } else { Err(Error::OptionOutOfRange { option: "tolerance", value }) }
}

impl Net<'_> {
    /// Does something else with the cells of a bridge. `tolerance`: how far the two nodes of a link that becomes a point may be
    /// apart, where nets are welded. O(nodes) if welding begins or ends, else O(1).
    ///
    /// # Errors
    /// [`Error::NoSuch`], [`Error::SidesApart`], [`Error::OptionOutOfRange`] for the tolerance, [`Error::CrossingCell`],
    /// [`Error::OutOfMemory`]; the net is then as it was.
    pub fn set_bridge_mode(&mut self, index: usize, mode: BridgeMode, tolerance: f64) -> Result<()> {
        let no_such = Error::NoSuch { element: Element::Bridge, index: index as u64 };
        let bridge = self.bridges().get(index).ok_or(no_such)?.clone();
        check_tolerance(tolerance)?;
        let (welded, weld) = (bridge.mode == BridgeMode::Weld, mode == BridgeMode::Weld);
        if weld && !welded {
            for k in bridge.start as usize..bridge.end as usize {
                let [p, q] = self.shape().ends(bridge.link(self.shape(), k)).map(|node| {
                    let (i, j) = self.shape().place(node);
                    self.get(i, j)
                });
                check_pair(p, q, k as u32 - bridge.start, tolerance)?;
            }
        }
        if weld != welded {
            let topology = gluing::welded(self.topology(), &bridge, weld)?;
            self.set_topology(topology);
        }
        self.bridges_mut()[index].mode = mode;
        Ok(())
    }
}

impl Bridge {
    /// The link across it at place k of the side.
    fn link(&self, shape: Shape, k: usize) -> u32 {
        let before = self.at as usize - 1;
        match self.direction {
            Direction::Right => 2 * shape.node(k, before),
            Direction::Down => 2 * shape.node(before, k) + 1,
        }
    }
}

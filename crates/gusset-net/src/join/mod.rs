//! Joining nets side by side, and splitting them again (Deryagin, "Concatenation", Figs. 8 and 9).
//!
//! The columns, or rows, of one net follow the columns, or rows, of another. Between them lies a
//! row of new cells, the bridge. Nets of different sizes are reformatted first. Invariant:
//! [`Net::split`] restores the nets bit for bit. O(nodes).
//!
//! The characteristic matrix is not closed under concatenation: the closing links of a net with
//! closed rows would start at the other net's last column. They become a seam, so that the gluing
//! of every net is preserved. A bridge may have inner rows of nodes, evenly spaced on straight
//! lines between its sides.
//!
//! `adapt` fits nets to each other, `joined_topology` joins gluings, `joined_matrices` joins
//! coordinates, and `inner_rows` lays inner rows.

mod adapt;
mod inner_rows;
mod join_options;
mod joined_matrices;
mod joined_topology;
mod split;

pub(crate) use inner_rows::interpolate_inner_rows;
pub use join_options::JoinOptions;
pub(crate) use joined_matrices::first_lines_of_nets;

use super::{Bridge, BridgeMode, Direction, Net, Shape};
use adapt::{AdaptedNet, adapt_net_to_first};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::{Element, Error, Result};
use gusset_base::geom::scale::overflow_safe_distance;
use gusset_base::job::Job;
use std::sync::Arc;

/// Joins two nets. O(nodes).
///
/// # Errors
/// - [`Error::MixedScalars`], [`Error::NetsOpposed`], [`Error::SidesDiffer`].
/// - [`Error::OptionOutOfRange`]: the tolerance, a twist of an open side, or inner rows that would
///   be welded.
/// - [`Error::SidesApart`]: welded nodes, or the ends of a rotated side, do not coincide.
/// - [`Error::CrossingCell`], [`Error::TooLarge`], [`Error::OutOfMemory`], [`Error::Cancelled`].
pub fn concatenate(a: &Net<'_>, b: &Net<'_>, options: &JoinOptions, job: &Job<'_>) -> Result<Net<'static>> {
    join_nets_to_be_transformed(&[a, b], &[false; 2], options, job)
}

/// Joins any number of nets in one pass. A twist rotates every net except the first. O(nodes).
///
/// # Errors
/// The errors of [`concatenate`], and [`Error::EmptyScene`] without nets. Places of sides that are
/// apart count along the side.
pub fn concatenate_all(nets: &[&Net<'_>], options: &JoinOptions, job: &Job<'_>) -> Result<Net<'static>> {
    let mirrored = alloc::filled(false, nets.len())?;
    join_nets_to_be_transformed(nets, &mirrored, options, job)
}

/// Joins nets that the caller transforms afterwards. `mirrored` tells which of these transforms
/// mirror.
pub(crate) fn join_nets_to_be_transformed(
    nets: &[&Net<'_>],
    mirrored: &[bool],
    options: &JoinOptions,
    job: &Job<'_>,
) -> Result<Net<'static>> {
    let Some(first) = nets.first() else { return Err(Error::EmptyScene) };
    Error::require(options.tolerance >= 0.0, "tolerance", options.tolerance, "at least 0")?;
    let mut along = 0;
    for net in nets {
        if net.coordinates().scalar() != first.coordinates().scalar() {
            return Err(Error::MixedScalars);
        }
        let [a, b] = [first, net].map(|net| options.direction.line_count_and_length(net.shape()).1);
        if a != b && options.equalise.is_none() {
            return Err(Error::SidesDiffer { a: a as u32, b: b as u32 });
        }
        along = along.max(b);
    }
    Error::require(
        options.mode != BridgeMode::Weld || options.rows == 0,
        "rows",
        options.rows.into(),
        "0 if the sides are welded",
    )?;
    joined_shape(nets, options, along)?;
    let (mut copies, fitting) = (alloc::with_capacity(nets.len())?, job.sub_job(0.0, 0.3));
    let reversed = first.topology().is_reversed() != mirrored[0];
    for (k, (net, &mirrored)) in nets.iter().zip(mirrored).enumerate() {
        let part = fitting.sub_job_of_item(k, nets.len());
        if k % 256 == 0 {
            part.step(0.0, "fitting nets")?;
        }
        let flip = (net.topology().is_reversed() != mirrored) != reversed;
        let twist = if k == 0 { 0 } else { options.twist };
        copies.push(adapt_net_to_first(net, flip, along, twist, options, &part)?);
    }
    let fitted = nets.iter().zip(&copies).map(|(&net, copy)| copy.as_ref().map_or(net, |(copy, _)| copy));
    let nets: Vec<&Net<'_>> = alloc::collect(fitted)?;
    if options.mode == BridgeMode::Weld {
        nets.windows(2)
            .try_for_each(|pair| check_sides_coincident(pair[0], pair[1], options.direction, options.tolerance))?;
    }
    let topology =
        joined_topology::join_topologies(&nets, options.direction, options.mode == BridgeMode::Weld, options.rows)?;
    let (sides, joining) = ((options.direction, options.rows), job.sub_job(0.3, 0.9));
    let coordinates = joined_matrices::join_matrices(&nets, sides, topology.shape(), &joining)?;
    let mut net = Net::new(coordinates, topology.with_reversed(reversed));
    add_bridges(&mut net, &nets, &copies, options)?;
    interpolate_inner_rows(&mut net, &job.sub_job(0.9, 1.0))?;
    Ok(net)
}

/// Returns the shape of nets joined along sides of `along` nodes.
fn joined_shape(nets: &[&Net<'_>], options: &JoinOptions, side_nodes: usize) -> Result<Shape> {
    let inner = (options.rows as usize).saturating_mul(nets.len() - 1);
    let across = nets
        .iter()
        .map(|net| options.direction.line_count_and_length(net.shape()).0)
        .fold(inner, usize::saturating_add);
    let (rows, columns) = options.direction.swap_unless_down(across, side_nodes);
    Shape::new(rows, columns)
}

/// The nets' own bridges and the new ones between them, in the order in which joining them one by
/// one would create them. `copies` are the nets that were adapted.
fn add_bridges(
    net: &mut Net<'_>,
    nets: &[&Net<'_>],
    copies: &[Option<AdaptedNet>],
    options: &JoinOptions,
) -> Result<()> {
    let direction = options.direction;
    let along = direction.line_count_and_length(net.shape()).1 as u32;
    let record = |k: usize| copies[k].as_ref().map(|(_, record)| Arc::clone(record));
    let mut at = 0;
    for (k, part) in nets.iter().enumerate() {
        let first = if k > 0 { at + options.rows } else { at };
        for bridge in part.bridges() {
            let bridge = bridge.moved_by_lines(direction, first);
            alloc::push(net.bridges_mut(), Bridge { nesting: bridge.nesting.saturating_add(1), ..bridge })?;
        }
        if k > 0 {
            let kind = joined_topology::bridge_kind(nets[k - 1].topology(), part.topology(), direction);
            at += options.rows;
            let mut bridge = Bridge::new(direction, at, along, kind, options.mode);
            (bridge.properties, bridge.rows) = (options.properties, options.rows);
            // The record of a net belongs to the bridge before it; the first net's record belongs
            // to the bridge after it.
            bridge.adaptations = [if k == 1 { record(0) } else { None }, record(k)];
            alloc::push(net.bridges_mut(), bridge)?;
        }
        at += direction.line_count_and_length(part.shape()).0 as u32;
    }
    Ok(())
}

impl Bridge {
    /// The bridge after its net has moved by `by` nodes.
    pub(crate) fn moved_by_lines(&self, direction: Direction, by: u32) -> Bridge {
        let bridge = self.clone();
        if self.direction == direction {
            Bridge { at: self.at + by, ..bridge }
        } else {
            Bridge { start: self.start + by, end: self.end + by, ..bridge }
        }
    }
}

/// Returns [`Error::SidesApart`] unless the last side of one net and the first of the other
/// coincide. Each pair of nodes must be within the tolerance, or both missing.
fn check_sides_coincident(a: &Net<'_>, b: &Net<'_>, direction: Direction, tolerance: f64) -> Result<()> {
    let (across, along) = direction.line_count_and_length(a.shape());
    for k in 0..along {
        let node = |net: &Net<'_>, i: usize| {
            let (i, j) = direction.swap_unless_down(i, k);
            net.get(i, j)
        };
        check_nodes_coincident(node(a, across - 1), node(b, 0), k as u32, tolerance)?;
    }
    Ok(())
}

/// Returns [`Error::SidesApart`] unless two nodes are within the tolerance, or both are missing.
fn check_nodes_coincident(p: DVec3, q: DVec3, place: u32, tolerance: f64) -> Result<()> {
    let distance = overflow_safe_distance(p, q);
    let coincident = distance <= tolerance || !(p.is_finite() || q.is_finite());
    if coincident { Ok(()) } else { Err(Error::SidesApart { place, distance }) }
}

impl Net<'_> {
    /// Changes the treatment of the cells of a bridge. A bridge with inner rows cannot be welded.
    /// `tolerance` is the largest distance between nodes that are welded. O(nodes) if welding
    /// begins or ends, otherwise O(1).
    ///
    /// # Errors
    /// [`Error::NoSuch`], [`Error::SidesApart`], [`Error::OptionOutOfRange`] for the tolerance and
    /// for inner rows, [`Error::CrossingCell`], [`Error::OutOfMemory`]; the net is then unchanged.
    pub fn set_bridge_mode(&mut self, index: usize, mode: BridgeMode, tolerance: f64) -> Result<()> {
        let no_such =
            Error::NoSuch { element: Element::Bridge, index: index as u64, count: self.bridges().len() as u64 };
        let bridge = self.bridges().get(index).ok_or(no_such)?.clone();
        Error::require(tolerance >= 0.0, "tolerance", tolerance, "at least 0")?;
        Error::require(
            mode != BridgeMode::Weld || bridge.rows == 0,
            "rows",
            bridge.rows.into(),
            "0 if the sides are welded",
        )?;
        let (welded, weld) = (bridge.mode == BridgeMode::Weld, mode == BridgeMode::Weld);
        if weld && !welded {
            for k in bridge.start as usize..bridge.end as usize {
                let [p, q] =
                    self.shape().ends_of_link(bridge.link_across(self.shape(), k)).map(|node| self.position(node));
                check_nodes_coincident(p, q, k as u32 - bridge.start, tolerance)?;
            }
        }
        if weld != welded {
            let topology = joined_topology::with_bridge_links_contracted(self.topology(), &bridge, weld)?;
            self.set_topology(topology);
        }
        self.bridges_mut()[index].mode = mode;
        Ok(())
    }
}

impl Bridge {
    /// Returns the link across it at place `k` of the side.
    fn link_across(&self, shape: Shape, k: usize) -> u32 {
        self.direction.link_to_next_line(shape, self.at as usize - 1, k)
    }
}

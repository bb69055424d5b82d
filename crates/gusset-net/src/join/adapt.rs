//! Adapting a net before it is joined: flipping, replicating and rotating in this order, and
//! undoing these steps.
//!
//! Invariant: [`undo_adaptation`] inverts [`adapt_net_to_first`] bit for bit. Unless the gluing was edited
//! since, the topology is the recorded one. O(nodes).

use super::JoinOptions;
use crate::arrange::{map_seam, merge_seams, rows_closed_by_seam};
use crate::bridge::NetAdaptation;
use crate::reformat::{copied_rows_from_starts, row_starts_from_copies, starts_of_replicated_lines};
use crate::topology::{ContractedLinks, LinkMatrix};
use crate::{Bridge, Direction, Net, Real, Replication, Topology, XyzMatrices, each};
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::job::Job;
use std::sync::Arc;

/// An adapted copy of a net, and the record of its adaptation.
pub(super) type AdaptedNet = (Net<'static>, Arc<NetAdaptation>);

/// Adapts a net for joining. Returns an adapted copy, or `None` if the net fits unchanged.
/// `flipped` means that its face orientation is opposite to the others'. `along` is the number of
/// nodes on the side.
pub(super) fn adapt_net_to_first(
    net: &Net<'_>,
    flipped: bool,
    side_nodes: usize,
    twist: u32,
    options: &JoinOptions,
    job: &Job<'_>,
) -> Result<Option<AdaptedNet>> {
    let (direction, axis) = (options.direction, options.direction.transposed());
    if flipped && !options.turn {
        return Err(Error::NetsOpposed);
    }
    let (across, nodes) = direction.line_count_and_length(net.shape());
    if !flipped && nodes == side_nodes && twist == 0 {
        return Ok(None);
    }
    // Flips along the side, so that the order in the direction stays.
    let mut made = if flipped { net.flipped(axis, &job.sub_job_of_item(0, 3))? } else { net.copied()? };
    let mut added = Vec::new();
    if nodes != side_nodes {
        let replication = options.equalise.unwrap_or_default();
        added = copied_rows_from_starts(&starts_of_replicated_lines(
            made.topology(),
            axis,
            side_nodes,
            replication,
            "nodes of a side",
        )?)?;
        let (rows, columns) = axis.swap_unless_down(side_nodes, across);
        let replications = axis.swap_unless_down(replication, Replication::Last);
        made = made.enlarged_to(rows, columns, replications.into(), &job.sub_job_of_item(1, 3))?;
    }
    if twist > 0 {
        made = rotate_net(&made, direction, twist, &job.sub_job_of_item(2, 3))?;
    }
    let bridges = alloc::collect(net.bridges().iter().cloned())?;
    let (joined, topology) = (made.shape(), net.topology().clone());
    let adaptation = NetAdaptation { joined_shape: joined, flipped, copies: added, twist, topology, bridges };
    Ok(Some((made, Arc::new(adaptation))))
}

/// Undoes the adaptation of a net, if it still has the size that it was joined with. An unedited
/// topology becomes the recorded one; an edited one is mapped back.
pub(super) fn undo_adaptation(
    net: Net<'static>,
    adaptation: Option<&NetAdaptation>,
    direction: Direction,
    job: &Job<'_>,
) -> Result<Net<'static>> {
    let Some(adaptation) = adaptation.filter(|adaptation| adaptation.joined_shape == net.shape()) else {
        return Ok(net);
    };
    let axis = direction.transposed();
    // A net that was mirrored since has the same gluing in the opposite orientation.
    let adapted = adaptation.adapted_topology(direction)?;
    let unedited = net.topology().clone().with_reversed(adapted.is_reversed()) == adapted;
    let mut bridges = alloc::collect(net.bridges().iter().cloned())?;
    let mut net = net;
    if adaptation.twist > 0 {
        let around = axis.line_count_and_length(net.shape()).0 as u32 - 1;
        net = rotate_net(&net, direction, around - adaptation.twist % around, &job.sub_job_of_item(0, 3))?;
    }
    net = net.without_lines(axis, &adaptation.copies, &job.sub_job_of_item(1, 3))?;
    if adaptation.flipped {
        net = net.flipped(axis, &job.sub_job_of_item(2, 3))?;
    }
    if unedited {
        let reversed = net.topology().is_reversed();
        net.set_topology(adaptation.topology.clone().with_reversed(reversed));
    }
    if bridges.len() == adaptation.bridges.len() {
        for (bridge, old) in bridges.iter_mut().zip(&adaptation.bridges) {
            *bridge = Bridge { mode: bridge.mode, properties: bridge.properties, ..old.clone() };
        }
        *net.bridges_mut() = bridges;
    }
    Ok(net)
}

impl NetAdaptation {
    /// Returns the topology that the net was joined with.
    fn adapted_topology(&self, direction: Direction) -> Result<Topology> {
        self.topology.map_rows_or_columns(direction.transposed(), |topology| {
            let flipped = if self.flipped { topology.flipped_rows()? } else { topology.clone() };
            let along = direction.line_count_and_length(self.joined_shape).1;
            let replicated = flipped.replicate_rows(&row_starts_from_copies(along, &self.copies)?)?;
            let twist = self.twist as usize;
            if twist > 0 { rotate_rows(&replicated, twist % (along - 1)) } else { Ok(replicated) }
        })
    }
}

/// Returns the net rotated by `twist` places along its closed side.
fn rotate_net(net: &Net<'_>, direction: Direction, twist: u32, job: &Job<'_>) -> Result<Net<'static>> {
    let (axis, shape) = (direction.transposed(), net.shape());
    let (count, along) = axis.line_count_and_length(shape);
    let place = twist as usize % (count - 1);
    let closed = |k: usize| net.topology().is_contracted(axis.link_to_next_line(shape, count - 1, k));
    Error::require((0..along).all(closed), "twist", twist.into(), "0, because the side is not closed")?;
    each!(net.coordinates(), planes => check_axis_closed(planes, axis))?;
    let topology = net.topology().map_rows_or_columns(axis, |topology| rotate_rows(topology, place))?;
    let lines = alloc::collect((0..count).map(|i| ((i + place) % (count - 1)) as u32))?;
    let mut made = net.with_selected_lines(axis, &lines, topology, job)?;
    // Bridges along the side rotate with it; others would be cut.
    for bridge in net.bridges() {
        Error::require(
            bridge.direction == direction,
            "twist",
            twist.into(),
            "0, because the net has bridges in the other direction",
        )?;
        alloc::push(made.bridges_mut(), bridge.clone())?;
    }
    Ok(made)
}

/// Returns [`Error::SidesApart`] unless the last row (`Down`) or column equals the first bit for
/// bit, because a rotation drops one of the two.
fn check_axis_closed<T: Real>(planes: &XyzMatrices<'_, T>, axis: Direction) -> Result<()> {
    let (count, along) = axis.line_count_and_length(planes.shape());
    for k in 0..along {
        let [(p, q), (r, s)] = [axis.swap_unless_down(0, k), axis.swap_unless_down(count - 1, k)];
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

/// Returns the topology of a net with closed columns whose row `by` becomes the first.
fn rotate_rows(topology: &Topology, first_row: usize) -> Result<Topology> {
    let shape = topology.shape();
    let around = shape.rows() - 1;
    let place = |i: usize| (i % around + around - first_row) % around;
    let mut matrix = LinkMatrix::empty(shape)?;
    topology.contracted_links().for_each(|link| {
        let (i, j) = shape.row_and_column(link / 2);
        match (link % 2, i == around) {
            // The last row equals the first: a link along either is a link along their common
            // image.
            (0, _) => {
                let i = i % around;
                matrix.set_contracted(shape.horizontal_link(place(i), j), true);
                if i == first_row {
                    matrix.set_contracted(shape.horizontal_link(around, j), true);
                }
            }
            (_, true) => matrix.set_contracted(link, true),
            (_, false) => matrix.set_contracted(shape.vertical_link(place(i), j), true),
        }
    });
    let mut seams = Vec::new();
    for &seam in topology.seams() {
        map_seam(seam, |(i, j)| Some((place(i as usize) as i64, j)), &mut seams)?;
    }
    let mut seams = merge_seams(&seams)?;
    // A seam between the last row and the first may now close rows. Links express the closure once
    // the net is cut out again.
    seams.retain(|&seam| match rows_closed_by_seam(shape, seam) {
        Some(rows) => {
            rows.for_each(|i| matrix.set_contracted(shape.horizontal_link(i, shape.columns() - 1), true));
            false
        }
        None => true,
    });
    Ok(Topology::assemble_unchecked(shape, ContractedLinks::Matrix(matrix), seams, topology.is_reversed()))
}

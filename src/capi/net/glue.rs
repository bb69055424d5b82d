//! C interface: gluing and ungluing nets, and the classes of nodes that are one point.

use crate::capi::context::{answer, create, guard, guard_change, gusset_context};
use crate::capi::glue::fixed;
use crate::capi::handle::{self, handle};
use crate::capi::input::{self, fill, flag};
use crate::capi::mesh::gusset_indices;
use crate::capi::net::gluing::{gusset_seam, seam};
use crate::capi::net::{edit, gusset_net, read, reglue};
use crate::capi::status::{Failure, gusset_status};
use crate::error::Error;
use crate::net::topology::{CellDiagonal, Gluing, GluingType, Groups, Occurrence, occurrences};
use crate::net::{Classes, MAX_NODES};
use gusset_base::alloc;
use std::ptr;

/// What a gusset_gluing glues.
pub type gusset_gluing_kind = u32;
/// The two ends of link `element`. Links are numbered by nodes: 2 * node is that to the next node
/// of the row (of the last one to the first), 2 * node + 1 that to the next of the column; node (i,
/// j) is i * columns + j.
pub const GUSSET_GLUING_LINK: gusset_gluing_kind = 0;
/// Node `element` and its neighbours in the directions of the mask: east 1, south 2, west 4, north
/// 8, round the sides of the net.
pub const GUSSET_GLUING_STAR: gusset_gluing_kind = 1;
/// The ends of the links of cell `element` that are in the mask: top 1, right 2, bottom 4, left 8.
/// Cell (i, j) is i * (columns - 1) + j.
pub const GUSSET_GLUING_CELL: gusset_gluing_kind = 2;
/// Opposite corners of cell `element`: mask 1 for the first and the third, 2 for the second and the
/// fourth.
pub const GUSSET_GLUING_DIAGONAL: gusset_gluing_kind = 3;
/// The two runs of nodes of the seam.
pub const GUSSET_GLUING_SEAM: gusset_gluing_kind = 4;
/// The local gluing of type `mask`, one of GUSSET_TYPE_..., at node `element`; at cell `element`
/// from GUSSET_TYPE_TOP_BOTTOM on.
pub const GUSSET_GLUING_TYPE: gusset_gluing_kind = 5;

/// Nodes to be glued, or no longer to be.
#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
pub struct gusset_gluing {
    /// One of GUSSET_GLUING_...
    pub kind: gusset_gluing_kind,
    /// The link, node or cell; 0 for a seam.
    pub element: u32,
    /// See the kinds; 0 where none is said to have one.
    pub mask: u32,
    /// 0.
    pub reserved: u32,
    /// Read for GUSSET_GLUING_SEAM only.
    pub seam: gusset_seam,
}

const _: () = assert!(size_of::<gusset_gluing>() == 56);

/// One of the 18 local gluings (the paper's Fig. 4), or GUSSET_TYPE_NONE.
pub type gusset_gluing_type = u32;
/// Nothing is glued here.
pub const GUSSET_TYPE_NONE: gusset_gluing_type = 0xffff_ffff;
/// n(1): one horizontal link.
pub const GUSSET_TYPE_HORIZONTAL: gusset_gluing_type = 0;
/// n(1): one vertical link.
pub const GUSSET_TYPE_VERTICAL: gusset_gluing_type = 1;
/// n(2,1): the links of a node to the east and the south.
pub const GUSSET_TYPE_EAST_SOUTH: gusset_gluing_type = 2;
/// n(2,1): south and west.
pub const GUSSET_TYPE_SOUTH_WEST: gusset_gluing_type = 3;
/// n(2,1): west and north.
pub const GUSSET_TYPE_WEST_NORTH: gusset_gluing_type = 4;
/// n(2,1): north and east.
pub const GUSSET_TYPE_NORTH_EAST: gusset_gluing_type = 5;
/// n(2,2): east and west.
pub const GUSSET_TYPE_EAST_WEST: gusset_gluing_type = 6;
/// n(2,2): north and south.
pub const GUSSET_TYPE_NORTH_SOUTH: gusset_gluing_type = 7;
/// n(3): all but north.
pub const GUSSET_TYPE_BUT_NORTH: gusset_gluing_type = 8;
/// n(3): all but east.
pub const GUSSET_TYPE_BUT_EAST: gusset_gluing_type = 9;
/// n(3): all but south.
pub const GUSSET_TYPE_BUT_SOUTH: gusset_gluing_type = 10;
/// n(3): all but west.
pub const GUSSET_TYPE_BUT_WEST: gusset_gluing_type = 11;
/// n(4): all four links of a node.
pub const GUSSET_TYPE_ALL: gusset_gluing_type = 12;
/// c(2,1): top and bottom of a cell.
pub const GUSSET_TYPE_TOP_BOTTOM: gusset_gluing_type = 13;
/// c(2,1): right and left of a cell.
pub const GUSSET_TYPE_RIGHT_LEFT: gusset_gluing_type = 14;
/// c(3): a cell is one point.
pub const GUSSET_TYPE_POINT: gusset_gluing_type = 15;
/// c(1,2): the first and the third corner of a cell.
pub const GUSSET_TYPE_FALLING: gusset_gluing_type = 16;
/// c(1,2): the second and the fourth corner of a cell.
pub const GUSSET_TYPE_RISING: gusset_gluing_type = 17;

impl gusset_gluing {
    fn checked(self) -> Result<Gluing, Failure> {
        let has_mask = !matches!(self.kind, GUSSET_GLUING_LINK | GUSSET_GLUING_SEAM);
        if self.reserved != 0 || (!has_mask && self.mask != 0) {
            let (name, value) = if self.reserved != 0 { ("reserved", self.reserved) } else { ("mask", self.mask) };
            return Err(Failure::unknown(name, value.into()));
        }
        let unknown = || Failure::unknown("mask", self.mask.into());
        let mask = u8::try_from(self.mask).map_err(|_| unknown())?;
        Ok(match self.kind {
            GUSSET_GLUING_LINK => Gluing::Link(self.element),
            GUSSET_GLUING_STAR => Gluing::Star { node: self.element, mask },
            GUSSET_GLUING_CELL => Gluing::Cell { cell: self.element, mask },
            GUSSET_GLUING_DIAGONAL => {
                let diagonal =
                    [CellDiagonal::Falling, CellDiagonal::Rising].get(usize::from(mask).wrapping_sub(1)).copied();
                Gluing::CellDiagonal { cell: self.element, diagonal: diagonal.ok_or_else(unknown)? }
            }
            GUSSET_GLUING_SEAM => Gluing::Seam(seam(&self.seam)?),
            GUSSET_GLUING_TYPE => {
                Gluing::of_type(GluingType::from_number(self.mask).ok_or_else(unknown)?, self.element)
            }
            other => return Err(Failure::unknown("kind", other.into())),
        })
    }
}

/// The caller's, at any alignment.
fn gluings(data: *const gusset_gluing, count: usize) -> Result<Vec<Gluing>, Failure> {
    Error::check_count("gluings", count as u64, MAX_NODES)?;
    let given = input::items(data, count, "gluings")?.enumerate();
    alloc::try_collect(given.map(|(k, gluing)| gluing.checked().map_err(|failure| failure.of_item(k))))
}

/// The number of a type for the caller.
fn number(found: Option<GluingType>) -> gusset_gluing_type {
    found.map_or(GUSSET_TYPE_NONE, |kind| kind.number() as u32)
}

/// Glues nodes of a net; positions stay what they are.
///
/// On failure the net is as it was.
///
/// @param context threads, progress, cancellation and error report; NULL for the defaults.
/// @param[in,out] net the net.
/// @param gluings count of them, done as a whole or not at all; at any alignment.
/// @param count see gluings.
/// @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, UNKNOWN_VALUE (kind, mask,
///     reserved), OUT_OF_RANGE (a mask above 15), NO_SUCH_ELEMENT (the link, node or cell),
///     BAD_SEAM (its place among the gluings), CROSSING_CELL with the cell (both pairs of opposite
///     corners would be glued: the nineteenth local gluing, which no surface allows),
///     OUT_OF_MEMORY.
/// @complexity O(nodes + glued pairs).
/// @source Deryagin, "Local gluings of nodes".
/// @since 0.1
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_net_glue(
    context: *const gusset_context,
    net: *mut gusset_net,
    gluings: *const gusset_gluing,
    count: usize,
) -> gusset_status {
    reglue(context, net, |net, job| {
        let gluings = self::gluings(gluings, count)?;
        Ok(net.topology().glued_cancellable(&gluings, job, "gluing")?)
    })
}

/// Unglues pairs of nodes: their links are free, and seams that have them are cut there.
///
/// Nodes that are still glued by way of others stay one point; pairs that are not glued are left
/// alone.
///
/// On failure the net is as it was.
///
/// @param context threads, progress, cancellation and error report; NULL for the defaults.
/// @param[in,out] net the net.
/// @param gluings as for gusset_net_glue.
/// @param count as for gusset_net_glue.
/// @param separation 0, or how far apart what becomes separate is moved, in the unit of the
///     coordinates: each piece of a point that falls apart moves by half of it towards the mean of
///     its neighbours (of those that do not fall apart themselves, if there are any); one without
///     neighbours, or in the middle of them, stays.
/// @param[out] moved receives the number of pieces that moved; NULL if it is not wanted.
/// @return GUSSET_OK, or an error: as gusset_net_glue, OUT_OF_RANGE (a separation that is no finite
///     number from 0 on).
/// @complexity O(nodes), and a sort of the pairs.
/// @since 0.1
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_net_unglue(
    context: *const gusset_context,
    net: *mut gusset_net,
    gluings: *const gusset_gluing,
    count: usize,
    separation: f64,
    moved: *mut usize,
) -> gusset_status {
    let moved = input::optional_output(moved, 0, "moved");
    guard_change(context, |job| {
        let (moved, gluings) = (moved?, self::gluings(gluings, count)?);
        input::set(moved, edit(net, job)?.unglue(&gluings, separation)?);
        Ok(())
    })
}

/// Contracts every link whose ends are one point already, by way of others, and drops seams that
/// links then say: the canonical form, in which nets that glue the same neighbours have the same
/// matrix.
///
/// @param context threads, progress, cancellation and error report; NULL for the defaults.
/// @param[in,out] net the net.
/// @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, OUT_OF_MEMORY, CANCELLED.
/// @complexity O(nodes).
/// @since 0.1
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_net_saturate(context: *const gusset_context, net: *mut gusset_net) -> gusset_status {
    reglue(context, net, |net, job| Ok(net.topology().saturated_cancellable(job, "saturating")?))
}

/// Writes for each node the smallest node that is the same point.
///
/// @param context threads, progress, cancellation and error report; NULL for the defaults.
/// @param net the net.
/// @param[out] classes room for capacity numbers, of which rows * columns are written.
/// @param capacity see classes.
/// @param[out] written receives that number. NULL and 0 ask for it.
/// @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BUFFER_TOO_SMALL (nothing is
///     written but the number), OUT_OF_MEMORY, CANCELLED.
/// @complexity O(nodes); 4 bytes a node.
/// @since 0.1
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_net_classes(
    context: *const gusset_context,
    net: *const gusset_net,
    classes: *mut u32,
    capacity: usize,
    written: *mut usize,
) -> gusset_status {
    let written = input::output(written, 0, "written");
    guard_change(context, |job| {
        let net = read(net)?;
        fill((classes, capacity, "classes"), net.shape().node_count(), written?, job, || {
            let classes = Classes::of_cancellable(net.topology(), &job.part(0.0, 0.8), "classes")?;
            Ok(classes.table_cancellable(&job.part(0.8, 1.0), "classes")?)
        })
    })
}

/// The points that are several nodes. Opaque and immutable; it keeps nothing of the net.
pub struct gusset_net_groups(Groups);

handle! { gusset_net_groups }

/// Finds the points that are several nodes.
///
/// @param context threads, progress, cancellation and error report; NULL for the defaults.
/// @param net the net.
/// @param[out] groups receives the result, for gusset_net_groups_destroy; NULL on failure.
/// @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, OUT_OF_MEMORY, CANCELLED.
/// @complexity O(rows + columns) for a net that its sides describe, else O(nodes); and a sort of
///     the glued nodes.
/// @since 0.1
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_net_groups_create(
    context: *const gusset_context,
    net: *const gusset_net,
    groups: *mut *mut gusset_net_groups,
) -> gusset_status {
    create(context, groups, "groups", |job| {
        Ok(gusset_net_groups(Classes::of_cancellable(read(net)?.topology(), job, "groups")?.groups()?))
    })
}

/// Lends the groups: group k is members[offsets[k]] up to members[offsets[k + 1]], without the
/// latter; its nodes are in order, and groups are in the order of their first nodes.
///
/// offsets.count is one more than the number of groups. Valid until the groups are destroyed.
///
/// @param groups the groups.
/// @param[out] offsets receives the offsets.
/// @param[out] members receives the members.
/// @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT.
/// @complexity O(1).
/// @since 0.1
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_net_groups_get_view(
    groups: *const gusset_net_groups,
    offsets: *mut gusset_indices,
    members: *mut gusset_indices,
) -> gusset_status {
    guard(ptr::null(), |_| {
        let offsets = input::output(offsets, gusset_indices::lend(&[]), "offsets");
        let members = input::output(members, gusset_indices::lend(&[]), "members");
        let (offsets, members) = (offsets?, members?);
        let groups = &handle::get(groups, "groups")?.0;
        (*offsets, *members) = (gusset_indices::lend(groups.offsets()), gusset_indices::lend(groups.members()));
        Ok(())
    })
}

/// Destroys groups; NULL is allowed.
///
/// @param[in,out] groups the handle; NULL is allowed.
/// @since 0.1
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gusset_net_groups_destroy(groups: *mut gusset_net_groups) {
    handle::destroy(groups);
}

/// The local gluing at a node: which of its links have become a point.
///
/// @param context threads, progress, cancellation and error report; NULL for the defaults.
/// @param net the net.
/// @param node its number, row * columns + column.
/// @param cyclic 0, or 1 to count links that lead back to the first row or column too.
/// @param[out] found receives one of GUSSET_TYPE_..., at most GUSSET_TYPE_ALL, or GUSSET_TYPE_NONE.
/// @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, UNKNOWN_VALUE,
///     NO_SUCH_ELEMENT, OUT_OF_MEMORY, CANCELLED.
/// @complexity O(1) for a net that its sides describe, else O(nodes): see gusset_net_histogram for
///     all.
/// @source Deryagin, Fig. 4.
/// @since 0.1
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_net_classify_node(
    context: *const gusset_context,
    net: *const gusset_net,
    node: u32,
    cyclic: u32,
    found: *mut gusset_gluing_type,
) -> gusset_status {
    answer(context, (found, "found"), GUSSET_TYPE_NONE, |job| {
        Ok(number(read(net)?.topology().node_type(node, flag(cyclic, "cyclic")?, job)?))
    })
}

/// What a cell has become.
///
/// @param context threads, progress, cancellation and error report; NULL for the defaults.
/// @param net the net.
/// @param cell its number, row * (columns - 1) + column.
/// @param[out] found receives one of GUSSET_TYPE_..., or GUSSET_TYPE_NONE for a quad.
/// @return GUSSET_OK, or an error: as gusset_net_classify_node.
/// @complexity O(1) for a net that its sides describe, else O(nodes).
/// @since 0.1
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_net_classify_cell(
    context: *const gusset_context,
    net: *const gusset_net,
    cell: u32,
    found: *mut gusset_gluing_type,
) -> gusset_status {
    answer(context, (found, "found"), GUSSET_TYPE_NONE, |job| Ok(number(read(net)?.topology().cell_type(cell, job)?)))
}

/// Counts the local gluings of a net by type.
///
/// @param context threads, progress, cancellation and error report; NULL for the defaults.
/// @param net the net.
/// @param[out] nodes receive 18 numbers each, how many nodes (without links that lead back) and how
///     many cells have each type; NULL for what is not wanted.
/// @param[out] cells see nodes.
/// @return GUSSET_OK, or an error: NULL_ARGUMENT (net), MISALIGNED_ARGUMENT, OUT_OF_MEMORY,
///     CANCELLED.
/// @complexity O(nodes); 4 bytes a node.
/// @since 0.1
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_net_histogram(
    context: *const gusset_context,
    net: *const gusset_net,
    nodes: *mut u64,
    cells: *mut u64,
) -> gusset_status {
    let outputs = [(nodes, "nodes"), (cells, "cells")].map(|(out, name)| counts(out, name));
    guard_change(context, |job| {
        let [nodes, cells] = outputs;
        let (nodes, cells) = (nodes?, cells?);
        let histogram = crate::net::topology::histogram(read(net)?.topology(), job)?;
        job.memory()?;
        nodes.copy_from_slice(&histogram.nodes[..nodes.len()]);
        cells.copy_from_slice(&histogram.cells[..cells.len()]);
        Ok(())
    })
}

/// Room for the counts, cleared; none if they are not wanted.
fn counts<'a>(out: *mut u64, name: &'static str) -> Result<&'a mut [u64], Failure> {
    input::cleared(out, if out.is_null() { 0 } else { GluingType::COUNT }, name)
}

/// A local gluing of a net: where it is, and what it is in the letters of the paper's Fig. 4.
#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
pub struct gusset_gluing_occurrence {
    /// 0: at the node `element`, a type n(a, b); 1: of the cell `element`, a type c(a, b).
    pub on_cell: u32,
    /// The node, row * columns + column, or the cell, row * (columns - 1) + column.
    pub element: u32,
    /// One of GUSSET_TYPE_...
    pub kind: gusset_gluing_type,
    /// Of a node, how many nodes are glued to it; of a cell, how many of its links are glued, three
    /// for all; 1 for a diagonal.
    pub a: u32,
    /// Of a node with two glued links, 1 if they are adjacent and 2 if they are opposite; of a cell
    /// with two, how many of the other links lie between them, 0 or 1; 2 for a diagonal; UINT32_MAX
    /// for types that have one letter.
    pub b: u32,
    /// How many nodes the gluing makes one.
    pub node_order: u32,
    /// How many links it makes one; 1 if none.
    pub link_order: u32,
    /// How many nodes of the net are one point there: more than node_order where gluings meet, as
    /// at a pole.
    pub class_size: u32,
}

fixed! { gusset_gluing_occurrence: 32 }

impl From<&Occurrence> for gusset_gluing_occurrence {
    fn from(found: &Occurrence) -> Self {
        gusset_gluing_occurrence {
            on_cell: found.on_cell.into(),
            element: found.element,
            kind: number(Some(found.kind)),
            a: found.signature.a.into(),
            b: found.signature.b.map_or(u32::MAX, u32::from),
            node_order: found.signature.node_order.into(),
            link_order: found.signature.link_order.into(),
            class_size: found.class_size,
        }
    }
}

/// Writes all local gluings of a net with their types and orders: those at its nodes, in order, then
/// those of its cells.
///
/// @param context threads, progress, cancellation and error report; NULL for the defaults.
/// @param net the net.
/// @param cyclic 0, or 1 to count links that lead back to the first row or column too.
/// @param[out] found room for capacity of them.
/// @param capacity see found.
/// @param[out] written receives their number. NULL and 0 ask for it.
/// @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, UNKNOWN_VALUE (cyclic),
///     BUFFER_TOO_SMALL (nothing is written but the number), OUT_OF_MEMORY, CANCELLED.
/// @complexity O(nodes); 4 bytes a node, and as much as is written.
/// @source Deryagin, Fig. 4.
/// @since 0.1
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_net_gluing_occurrences(
    context: *const gusset_context,
    net: *const gusset_net,
    cyclic: u32,
    found: *mut gusset_gluing_occurrence,
    capacity: usize,
    written: *mut usize,
) -> gusset_status {
    let written = input::output(written, 0, "written");
    guard_change(context, |job| {
        let written = written?;
        let all = occurrences(read(net)?.topology(), flag(cyclic, "cyclic")?, job)?;
        fill((found, capacity, "found"), all.len(), written, job, || Ok(all.iter().map(gusset_gluing_occurrence::from)))
    })
}

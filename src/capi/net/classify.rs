//! Local gluings: How nodes and cells are glued at a place.

use crate::capi::context::{answer, create, guard_change, gusset_context, lend};
use crate::capi::glue::{fixed, versioned};
use crate::capi::handle::{self, handle};
use crate::capi::input::{self, fill, flag};
use crate::capi::mesh::gusset_indices;
use crate::capi::net::glue::{GUSSET_TYPE_NONE, gusset_gluing_type};
use crate::capi::net::{gusset_net, read};
use crate::capi::status::{Failure, gusset_status};
use crate::net::Classes;
use crate::net::topology::{GluingType, Groups, Occurrence, occurrences};

/// The number of a type for the caller.
fn number(found: Option<GluingType>) -> gusset_gluing_type {
    found.map_or(GUSSET_TYPE_NONE, |kind| kind.number() as u32)
}

/// Writes for each node the smallest node that is the same point.
///
/// @param classes room for capacity numbers, of which rows * columns are written.
/// @param capacity see classes.
/// @param written receives that number. NULL and 0 ask for it.
/// @errors BUFFER_TOO_SMALL (nothing is written but the number)
/// @complexity O(nodes); 4 bytes a node.
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
/// @complexity O(rows + columns) for a net that its sides describe, else O(nodes); and a sort of
///     the glued nodes.
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

/// The groups of a net, lent: valid until gusset_net_groups_destroy.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_net_groups_view {
    /// sizeof(gusset_net_groups_view), set by the caller.
    pub struct_size: usize,
    /// One more than the number of groups: group k is members[offsets[k]] up to
    /// members[offsets[k + 1]], without the latter. Groups are in the order of their first nodes.
    pub offsets: gusset_indices,
    /// The nodes of all groups, each group's in order.
    pub members: gusset_indices,
}

versioned! { gusset_net_groups_view: 40 }

/// Lends the groups.
///
/// @complexity O(1).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_net_groups_get_view(
    groups: *const gusset_net_groups,
    view: *mut gusset_net_groups_view,
) -> gusset_status {
    lend!(groups, view, |gusset_net_groups(groups)| gusset_net_groups_view {
        struct_size: 0,
        offsets: gusset_indices::lend(groups.offsets()),
        members: gusset_indices::lend(groups.members()),
    })
}

/// Destroys groups; NULL is allowed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gusset_net_groups_destroy(groups: *mut gusset_net_groups) {
    handle::destroy(groups);
}

/// The element that has a local gluing.
pub type gusset_gluing_place = u32;
/// A node; the gluing says which of its links are glued.
pub const GUSSET_GLUING_PLACE_NODE: gusset_gluing_place = 0;
/// A cell; the gluing says which of its corners are one point.
pub const GUSSET_GLUING_PLACE_CELL: gusset_gluing_place = 1;

/// Finds the local gluing at a node or of a cell.
///
/// @param place GUSSET_GLUING_PLACE_NODE or GUSSET_GLUING_PLACE_CELL.
/// @param element the node, row * columns + column, or the cell, row * (columns - 1) + column.
/// @param cyclic 0, or 1 to count links of a node that lead back to the first row or column too.
/// @param found receives one of GUSSET_TYPE_..., at most GUSSET_TYPE_ALL for a node; GUSSET_TYPE_NONE for a node without glued links and for a quad.
/// @errors NO_SUCH_ELEMENT
/// @complexity O(1) for a net that its sides describe, else O(nodes): see gusset_net_histogram for
///     all.
/// @source Deryagin, Fig. 4.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_net_classify(
    context: *const gusset_context,
    net: *const gusset_net,
    place: gusset_gluing_place,
    element: u32,
    cyclic: u32,
    found: *mut gusset_gluing_type,
) -> gusset_status {
    answer(context, (found, "found"), GUSSET_TYPE_NONE, |job| {
        let (topology, cyclic) = (read(net)?.topology(), flag(cyclic, "cyclic")?);
        Ok(number(match place {
            GUSSET_GLUING_PLACE_NODE => topology.node_type(element, cyclic, job)?,
            GUSSET_GLUING_PLACE_CELL => topology.cell_type(element, job)?,
            other => return Err(Failure::unknown("place", other.into())),
        }))
    })
}

/// Counts the local gluings of a net by type.
///
/// @param nodes receive 18 numbers each, how many nodes (without links that lead back) and how many
///     cells have each type; NULL for what is not wanted.
/// @param cells see nodes.
/// @errors NULL_ARGUMENT (net)
/// @complexity O(nodes); 4 bytes a node.
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
    /// GUSSET_GLUING_PLACE_NODE: at the node `element`, a type n(a, b); GUSSET_GLUING_PLACE_CELL: of
    /// the cell `element`, a type c(a, b).
    pub place: gusset_gluing_place,
    /// The node, row * columns + column, or the cell, row * (columns - 1) + column.
    pub element: u32,
    /// One of the 18 local gluings (the paper's Fig. 4), or GUSSET_TYPE_NONE.
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
            place: if found.on_cell { GUSSET_GLUING_PLACE_CELL } else { GUSSET_GLUING_PLACE_NODE },
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
/// @param cyclic 0, or 1 to count links that lead back to the first row or column too.
/// @param found room for capacity of them.
/// @param capacity see found.
/// @param written receives their number. NULL and 0 ask for it.
/// @errors UNKNOWN_VALUE (cyclic), BUFFER_TOO_SMALL (nothing is written but the number)
/// @complexity O(nodes); 4 bytes a node, and as much as is written.
/// @source Deryagin, Fig. 4.
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

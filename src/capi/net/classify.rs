//! Local gluings: How nodes and cells are glued.

use crate::capi::context::{answer_into_output, create_handle, guard_changing_call, gusset_context, lend};
use crate::capi::glue::{constants, fixed, versioned};
use crate::capi::handle::{self, handle};
use crate::capi::input::{self, fill_buffer, read_flag};
use crate::capi::mesh::gusset_indices;
use crate::capi::net::glue::{GUSSET_TYPE_NONE, gusset_gluing_type};
use crate::capi::net::{gusset_net, net_of_handle};
use crate::capi::status::{Failure, gusset_status};
use crate::net::NodeClasses;
use crate::net::topology::{GluingOccurrence, GluingType, NodeGroups, find_gluing_occurrences};

/// Returns the caller's number of a type.
fn gluing_type_code(found: Option<GluingType>) -> gusset_gluing_type {
    found.map_or(GUSSET_TYPE_NONE, |kind| kind.number() as u32)
}

/// Writes for each node the first node of its point.
///
/// @param classes receives rows * columns nodes.
/// @errors BUFFER_TOO_SMALL
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
    let written = input::cleared_output(written, 0, "written");
    guard_changing_call(context, |job| {
        let net = net_of_handle(net)?;
        fill_buffer((classes, capacity, "classes"), net.shape().node_count(), written?, job, || {
            let classes = NodeClasses::new_cancellable(net.topology(), &job.sub_job(0.0, 0.8), "classes")?;
            Ok(classes.representatives_cancellable(&job.sub_job(0.8, 1.0), "classes")?)
        })
    })
}

/// Points of several glued nodes.
pub struct gusset_net_groups(NodeGroups);

handle! { gusset_net_groups }

/// Finds the points of several glued nodes.
///
/// @complexity O(rows + columns) if only sides are glued, else O(nodes), plus a sort of glued
///     nodes.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_net_groups_create(
    context: *const gusset_context,
    net: *const gusset_net,
    groups: *mut *mut gusset_net_groups,
) -> gusset_status {
    create_handle(context, groups, "groups", |job| {
        Ok(gusset_net_groups(
            NodeClasses::new_cancellable(net_of_handle(net)?.topology(), job, "groups")?.glued_classes()?,
        ))
    })
}

/// Groups of glued nodes, in the order of their first nodes.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_net_groups_view {
    /// sizeof(gusset_net_groups_view).
    pub struct_size: usize,
    /// Offsets into members, by group.
    pub offsets: gusset_indices,
    /// Nodes of all groups, in order within each.
    pub members: gusset_indices,
}

versioned! { gusset_net_groups_view: 40 }

/// Lends the groups.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_net_groups_get_view(
    groups: *const gusset_net_groups,
    view: *mut gusset_net_groups_view,
) -> gusset_status {
    lend!(groups, view, |gusset_net_groups(groups)| gusset_net_groups_view {
        struct_size: 0,
        offsets: gusset_indices::lend_indices(groups.offsets()),
        members: gusset_indices::lend_indices(groups.nodes()),
    })
}

/// Destroys groups.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gusset_net_groups_destroy(groups: *mut gusset_net_groups) {
    handle::destroy(groups);
}

/// Element that has a local gluing.
pub type gusset_gluing_place = u32;
/// Node with glued links.
pub const GUSSET_GLUING_PLACE_NODE: gusset_gluing_place = 0;
/// Cell with glued corners.
pub const GUSSET_GLUING_PLACE_CELL: gusset_gluing_place = 1;

/// Finds the local gluing at a node or cell.
///
/// @param element node or cell.
/// @param cyclic 1: links back to the first row or column count.
/// @param found receives the type; GUSSET_TYPE_NONE for a node without glued links, or a quad.
/// @errors NO_SUCH_ELEMENT
/// @complexity O(1) if only sides are glued, else O(nodes).
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
    answer_into_output(context, (found, "found"), GUSSET_TYPE_NONE, |job| {
        let (topology, cyclic) = (net_of_handle(net)?.topology(), read_flag(cyclic, "cyclic")?);
        Ok(gluing_type_code(match place {
            GUSSET_GLUING_PLACE_NODE => topology.gluing_type_at_node(element, cyclic, job)?,
            GUSSET_GLUING_PLACE_CELL => topology.gluing_type_at_cell(element, job)?,
            other => {
                return Err(Failure::unknown_choice(
                    "place",
                    other,
                    &constants![GUSSET_GLUING_PLACE_NODE, GUSSET_GLUING_PLACE_CELL],
                ));
            }
        }))
    })
}

/// Counts the local gluings by type.
///
/// @param nodes receives 18 counts, as for cyclic 0, or NULL.
/// @param cells receives 18 counts, or NULL.
/// @complexity O(nodes); 4 bytes a node.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_net_histogram(
    context: *const gusset_context,
    net: *const gusset_net,
    nodes: *mut u64,
    cells: *mut u64,
) -> gusset_status {
    let outputs = [(nodes, "nodes"), (cells, "cells")].map(|(out, name)| count_buffer(out, name));
    guard_changing_call(context, |job| {
        let [nodes, cells] = outputs;
        let (nodes, cells) = (nodes?, cells?);
        let histogram = crate::net::topology::gluing_histogram(net_of_handle(net)?.topology(), job)?;
        job.finish()?;
        nodes.copy_from_slice(&histogram.nodes[..nodes.len()]);
        cells.copy_from_slice(&histogram.cells[..cells.len()]);
        Ok(())
    })
}

/// Returns the cleared buffer for the counts; empty if the caller omits it.
fn count_buffer<'a>(out: *mut u64, name: &'static str) -> Result<&'a mut [u64], Failure> {
    input::cleared_result_buffer(out, if out.is_null() { 0 } else { GluingType::TYPE_COUNT }, name)
}

/// Local gluing: n(a,b) at a node or c(a,b) at a cell.
#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
pub struct gusset_gluing_occurrence {
    /// Element that has a local gluing.
    pub place: gusset_gluing_place,
    /// Node or cell.
    pub element: u32,
    /// Local gluing of Deryagin's figure 4.
    pub kind: gusset_gluing_type,
    /// Node: nodes glued to it. Cell: glued links, at most 3; 1 for a diagonal.
    pub a: u32,
    /// Node with two glued links: 1 if adjacent, 2 if opposite. Cell with two: other links between
    /// them, 0 or 1. Diagonal: 2. Else UINT32_MAX.
    pub b: u32,
    /// United nodes.
    pub node_order: u32,
    /// United links; 1 if none.
    pub link_order: u32,
    /// Nodes of the point, above node_order where gluings meet.
    pub class_size: u32,
}

fixed! { gusset_gluing_occurrence: 32 }

impl From<&GluingOccurrence> for gusset_gluing_occurrence {
    fn from(found: &GluingOccurrence) -> Self {
        gusset_gluing_occurrence {
            place: if found.on_cell { GUSSET_GLUING_PLACE_CELL } else { GUSSET_GLUING_PLACE_NODE },
            element: found.element,
            kind: gluing_type_code(Some(found.kind)),
            a: found.signature.a.into(),
            b: found.signature.b.map_or(u32::MAX, u32::from),
            node_order: found.signature.node_order.into(),
            link_order: found.signature.link_order.into(),
            class_size: found.class_size,
        }
    }
}

/// Writes all local gluings: of nodes, then of cells.
///
/// @param cyclic as for gusset_net_classify.
/// @param found receives the gluings.
/// @errors BUFFER_TOO_SMALL
/// @complexity O(nodes); 4 bytes a node, and the result.
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
    let written = input::cleared_output(written, 0, "written");
    guard_changing_call(context, |job| {
        let written = written?;
        let all = find_gluing_occurrences(net_of_handle(net)?.topology(), read_flag(cyclic, "cyclic")?, job)?;
        fill_buffer((found, capacity, "found"), all.len(), written, job, || {
            Ok(all.iter().map(gusset_gluing_occurrence::from))
        })
    })
}

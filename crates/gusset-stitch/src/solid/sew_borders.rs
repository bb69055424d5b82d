//! The first stage: borders are sewn.

use super::repair_request::{DropReason, DroppedFace, Options};
use super::repair_state::RepairState;
use crate::repair::sew::{Sew, sew};
use crate::repair::weld::{self, Vertices};
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_mesh::{MeshView, NONE, Opposite, Topology};

/// The counts of sewing.
#[derive(Clone, Copy, Default)]
pub(super) struct SewCounts {
    pub(super) welded_vertices: u32,
    pub(super) sewn_edges: u32,
    pub(super) split_faces: u32,
    pub(super) tolerance: f64,
}

/// Sews the borders of a mesh edge to edge. If a border still coincides with another, all
/// coincident vertices are merged where this leaves fewer free edges.
pub(super) fn sew_borders(mesh: &MeshView<'_>, options: &Options, job: &Job<'_>) -> Result<(RepairState, SewCounts)> {
    let how = weld::Options {
        vertices: Vertices::Boundary,
        tolerance: options.tolerance,
        collapse: true,
        remove_unused: false,
    };
    let edge_to_edge = sew(mesh, &how, &job.part(0.0, 0.4))?;
    if edge_to_edge.left_vertices.is_empty() {
        return state_from_sewn(edge_to_edge);
    }
    let all = sew(mesh, &weld::Options { vertices: Vertices::All, ..how }, &job.part(0.4, 0.8))?;
    let is_better = free_edges(&all, &job.part(0.8, 0.9))? < free_edges(&edge_to_edge, &job.part(0.9, 1.0))?;
    state_from_sewn(if is_better { all } else { edge_to_edge })
}

fn free_edges(sewn: &Sew, job: &Job<'_>) -> Result<usize> {
    let view = sewn.mesh.view(&job.part(0.0, 0.3))?;
    let topology = Topology::new(&view, &job.part(0.3, 0.9))?;
    let border = topology.border_half_edges(&job.part(0.9, 1.0))?;
    Ok(border.iter().filter(|&&h| topology.opposite(h) == Opposite::Free).count())
}

/// Returns the state after sewing.
fn state_from_sewn(sewn: Sew) -> Result<(RepairState, SewCounts)> {
    let mut vertex_origin = alloc::filled(NONE, sewn.mesh.positions.len())?;
    for (old, &new) in sewn.vertex_map.iter().enumerate().rev() {
        vertex_origin[new as usize] = old as u32;
    }
    let is_dropped = |&(_, new): &(u32, &u32)| *new == NONE;
    let dropped = (0..).zip(&sewn.face_map).filter(is_dropped);
    let dropped = alloc::gather(dropped.map(|(face, _)| DroppedFace { face, reason: DropReason::Degenerate }))?;
    let counts = SewCounts {
        welded_vertices: sewn.welded_vertices,
        sewn_edges: sewn.sewn_edges,
        split_faces: sewn.split_faces,
        tolerance: if sewn.welded_vertices > 0 { sewn.tolerance } else { 0.0 },
    };
    let mut state = RepairState::unchanged(sewn.mesh)?;
    if let Some(origins) = sewn.corner_origins {
        let corners = 0..state.mesh.face_corners.len() as u32;
        state.corner_origins = alloc::collect(corners.map(|corner| origins.origin_of_corner(corner)))?;
    }
    let old = vertex_origin.len() - sewn.new_vertices.len();
    let new = (old as u32..).zip(&sewn.new_vertices);
    state.new_vertices = alloc::gather(new.map(|(v, &([a, b], at))| (v, [a, b, b], [1.0 - at, at, 0.0])))?;
    (state.face_origin, state.vertex_origin, state.dropped) = (sewn.face_origin, vertex_origin, dropped);
    Ok((state, counts))
}

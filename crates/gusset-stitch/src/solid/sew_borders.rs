//! Sewing of borders that coincide, also of borders that other stages leave.

use super::corner_place::CornerPlace;
use super::repair_request::DropReason;
use super::repair_state::RepairState;
use crate::repair::sew::{Sew, sew};
use crate::repair::weld::{self, Vertices};
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_mesh::{NONE, Opposite, Topology};

/// The counts of sewing.
#[derive(Clone, Copy, Default)]
pub(super) struct SewCounts {
    pub(super) welded_vertices: u32,
    pub(super) sewn_edges: u32,
    pub(super) split_faces: u32,
}

impl SewCounts {
    /// Adds the counts of another sewing.
    pub(super) fn add(&mut self, other: &SewCounts) {
        self.welded_vertices += other.welded_vertices;
        self.sewn_edges += other.sewn_edges;
        self.split_faces += other.split_faces;
    }
}

/// Sews the borders of a mesh edge to edge. If vertices of coincident borders stay apart, merges
/// coincident vertices off the borders too, provided that fewer border edges remain. Unless
/// `is_first`, edges of three or more faces count as border edges, so that separated sheets stay
/// apart.
pub(super) fn sew_borders(
    state: &mut RepairState,
    tolerance: Option<f64>,
    is_first: bool,
    job: &Job<'_>,
) -> Result<SewCounts> {
    let how = weld::Options { vertices: Vertices::Boundary, tolerance, collapse: false, remove_unused: false };
    let mesh = state.mesh.view(&job.sub_job(0.0, 0.1))?;
    let mut sewn = sew(&mesh, &how, &job.sub_job(0.1, 0.4))?;
    if !sewn.left_vertices.is_empty() {
        let all = sew(&mesh, &weld::Options { vertices: Vertices::All, ..how }, &job.sub_job(0.4, 0.8))?;
        let count = |sewn: &Sew, job: &Job<'_>| border_edges(sewn, is_first, job);
        if count(&all, &job.sub_job(0.8, 0.9))? < count(&sewn, &job.sub_job(0.9, 1.0))? {
            sewn = all;
        }
    }
    let counts =
        SewCounts { welded_vertices: sewn.welded_vertices, sewn_edges: sewn.sewn_edges, split_faces: sewn.split_faces };
    if counts.welded_vertices > 0 || counts.split_faces > 0 || sewn.dropped_faces > 0 {
        state.follow_sewing(sewn)?;
    }
    Ok(counts)
}

/// Returns the number of half-edges of free edges, or also of edges with three or more faces.
fn border_edges(sewn: &Sew, only_free: bool, job: &Job<'_>) -> Result<usize> {
    let view = sewn.mesh.view(&job.sub_job(0.0, 0.3))?;
    let topology = Topology::new(&view, &job.sub_job(0.3, 0.9))?;
    let border = topology.border_half_edges(&job.sub_job(0.9, 1.0))?;
    Ok(border.iter().filter(|&&h| !only_free || topology.opposite(h) == Opposite::Free).count())
}

impl RepairState {
    /// Replaces the mesh by the sewn one.
    fn follow_sewing(&mut self, sewn: Sew) -> Result<()> {
        self.changes += 1;
        for (f, _) in sewn.face_map.iter().enumerate().filter(|&(_, &new)| new == NONE) {
            self.list_dropped(f, DropReason::Degenerate)?;
        }
        let count = sewn.mesh.positions.len();
        let mut vertex_origin = alloc::filled(NONE, count)?;
        for (old, &new) in sewn.vertex_map.iter().enumerate().rev().filter(|&(_, &new)| new != NONE) {
            let origin = self.vertex_origin[old];
            if origin != NONE {
                vertex_origin[new as usize] = origin;
            }
        }
        if let Some(origins) = &sewn.corner_origins {
            let corners = 0..sewn.mesh.face_corners.len() as u32;
            let place_of = |h: u32| self.corner_places[h as usize];
            let composed = corners.map(|corner| CornerPlace::between(origins.origin_of_corner(corner), place_of));
            self.corner_places = alloc::collect(composed)?;
        }
        let map = |v: u32| sewn.vertex_map[v as usize];
        self.new_vertices.iter_mut().for_each(|(v, parents, _)| (*v, *parents) = (map(*v), parents.map(map)));
        self.new_vertices.retain(|&(v, ..)| v != NONE && vertex_origin[v as usize] == NONE);
        let first = (count - sewn.new_vertices.len()) as u32;
        let new = (first..).zip(&sewn.new_vertices);
        alloc::extend(&mut self.new_vertices, new.map(|(v, &([a, b], at))| (v, [a, b, b], [1.0 - at, at, 0.0])))?;
        self.new_vertices.sort_unstable_by_key(|&(v, ..)| v);
        self.new_vertices.dedup_by_key(|&mut (v, ..)| v);
        self.face_origin = alloc::collect(sewn.face_origin.iter().map(|&f| self.face_origin[f as usize]))?;
        self.turned = alloc::collect(sewn.face_origin.iter().map(|&f| self.turned[f as usize]))?;
        self.vertex_origin = vertex_origin;
        self.mesh = sewn.mesh;
        Ok(())
    }
}

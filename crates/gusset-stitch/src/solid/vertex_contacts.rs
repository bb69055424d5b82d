//! Components that share vertices, but no edges.
//!
//! Each component gets its own copy of such a vertex before holes are filled. The outline of a fin at a
//! vertex then is the outline of a sheet, not a hole of its host.

use super::repair_state::RepairState;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::disjoint_sets::DisjointSets;
use gusset_base::job::Job;
use gusset_base::sort::sort;
use gusset_mesh::{MeshView, NONE, half_edges, unordered};

const STAGE: &str = "separating components at vertices";

/// The vertices that components share.
#[derive(Default)]
pub(super) struct VertexContacts {
    /// The number of copies of vertices.
    pub(super) copies: u32,
    /// A face of each of two components that shared a vertex.
    pub(super) faces: Vec<[u32; 2]>,
}

/// Gives each component its own vertices: the component of a vertex's first face keeps the vertex.
/// O(H log H) for H half-edges.
pub(super) fn separate_vertex_contacts(state: &mut RepairState, job: &Job<'_>) -> Result<VertexContacts> {
    let mut contacts = VertexContacts::default();
    let components = edge_components(&state.mesh.view(&job.sub_job(0.0, 0.1))?, &job.sub_job(0.1, 0.8))?;
    let mut owners = alloc::filled(NONE, state.mesh.positions.len())?;
    let mut shared = Vec::new();
    for (f, face) in state.mesh.faces().enumerate() {
        job.sub_job(0.8, 0.9).step_within_list(f, STAGE)?;
        let first = state.mesh.face_offsets[f];
        for (corner, &v) in (first..).zip(face) {
            let owner = &mut owners[v as usize];
            if *owner == NONE {
                *owner = f as u32;
            } else if components[*owner as usize] != components[f] {
                alloc::push(&mut shared, (v, components[f], corner, f as u32))?;
            }
        }
    }
    sort(&mut shared, Ord::cmp, &job.sub_job(0.9, 1.0), STAGE)?;
    let (old, mut copies) = (state.mesh.positions.len() as u32, Vec::new());
    for group in shared.chunk_by(|a, b| (a.0, a.1) == (b.0, b.1)) {
        let (v, _, _, face) = group[0];
        let copy = old + copies.len() as u32;
        alloc::push(&mut copies, v)?;
        let before = std::mem::replace(&mut owners[v as usize], face);
        alloc::push(&mut contacts.faces, [face, before])?;
        group.iter().for_each(|&(_, _, corner, _)| state.mesh.face_corners[corner as usize] = copy);
    }
    contacts.copies = copies.len() as u32;
    state.copy_vertices(&copies)?;
    Ok(contacts)
}

/// Returns for each face the smallest face that is connected to it across edges.
fn edge_components(mesh: &MeshView<'_>, job: &Job<'_>) -> Result<Vec<u32>> {
    let faces = mesh.faces();
    let mut edges = alloc::with_capacity(faces.half_edge_count())?;
    for f in 0..faces.len() {
        job.sub_job(0.0, 0.3).step_within_list(f, STAGE)?;
        edges.extend(half_edges(mesh, f).map(|(_, u, v)| (unordered([u, v]), f as u32)));
    }
    sort(&mut edges, Ord::cmp, &job.sub_job(0.3, 0.8), STAGE)?;
    let mut sets = DisjointSets::new(faces.len())?;
    for pair in edges.windows(2).filter(|pair| pair[0].0 == pair[1].0) {
        sets.union(pair[0].1, pair[1].1);
    }
    sets.into_roots(&job.sub_job(0.8, 1.0), STAGE)
}

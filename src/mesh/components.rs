//! Connected components of a mesh.

use super::view::MeshView;
use crate::error::Result;
use crate::geom::disjoint_sets::DisjointSets;

/// Sets of vertices, in which all vertices of a face are in one. O(V + H), 4 bytes a vertex.
pub(crate) fn vertex_components(mesh: &MeshView<'_>) -> Result<DisjointSets> {
    let mut sets = DisjointSets::new(mesh.positions().len())?;
    for f in 0..mesh.faces().len() {
        let mut corners = mesh.face(f);
        if let Some(first) = corners.next() {
            corners.for_each(|v| {
                sets.union(first, v);
            });
        }
    }
    Ok(sets)
}

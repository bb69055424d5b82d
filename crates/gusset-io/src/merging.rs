//! Meshes whose split vertices become one.

use crate::mesh::{Domain, Mesh, Positions, Property, Values};
use std::borrow::Cow;

/// A mesh without split vertices.
pub(crate) struct Merged<'a> {
    pub(crate) mesh: Cow<'a, Mesh>,
    /// Whether vertices that became one had different colours.
    pub(crate) lost_colours: bool,
    /// Names of the properties that vertices which became one had different values of.
    pub(crate) lost_properties: Vec<String>,
}

/// Merges vertices by [`Mesh::merge`]. Normals and texture coordinates that differ at a merged vertex move to its corners. The merged
/// vertex keeps the colour and the properties of the representative.
pub(crate) fn merge_vertices(mesh: &Mesh) -> Merged<'_> {
    let vertex_count = mesh.positions.len() as u32;
    let mut merged = Merged { mesh: Cow::Borrowed(mesh), lost_colours: false, lost_properties: Vec::new() };
    if (0..vertex_count).all(|vertex| mesh.representative(vertex) == vertex) {
        return merged;
    }
    let kept: Vec<u32> = (0..vertex_count).filter(|&vertex| mesh.representative(vertex) == vertex).collect();
    let mut indices = vec![0; mesh.positions.len()];
    for (index, &vertex) in kept.iter().enumerate() {
        indices[vertex as usize] = index as u32;
    }
    let corners: Vec<u32> = mesh.corners.iter().map(|&vertex| indices[mesh.representative(vertex) as usize]).collect();
    merged.lost_colours = differs(mesh, &mesh.vertex_colours);
    merged.lost_properties = mesh
        .properties
        .iter()
        .filter(|property| property.domain == Domain::Vertices && differs(mesh, &property.values))
        .map(|property| property.name.clone())
        .collect();
    merged.mesh = Cow::Owned(Mesh {
        name: mesh.name.clone(),
        positions: match &mesh.positions {
            Positions::F32(points) => Positions::F32(selected(points, &kept)),
            Positions::F64(points) => Positions::F64(selected(points, &kept)),
        },
        face_offsets: mesh.face_offsets.clone(),
        merge: Vec::new(),
        normals: merged_values(mesh, &mesh.normals, &corners, &kept),
        texcoords: merged_values(mesh, &mesh.texcoords, &corners, &kept),
        corners,
        vertex_colours: selected(&mesh.vertex_colours, &kept),
        face_colours: mesh.face_colours.clone(),
        face_materials: mesh.face_materials.clone(),
        properties: mesh
            .properties
            .iter()
            .map(|property| match property.domain {
                Domain::Vertices => Property { values: selected(&property.values, &kept), ..property.clone() },
                Domain::Faces => property.clone(),
            })
            .collect(),
    });
    merged
}

/// Returns the values of the kept vertices; none if `values` is empty.
fn selected<T: Copy>(values: &[T], kept: &[u32]) -> Vec<T> {
    if values.is_empty() { Vec::new() } else { kept.iter().map(|&vertex| values[vertex as usize]).collect() }
}

/// Returns whether a vertex has another value than its representative.
fn differs<T: PartialEq>(mesh: &Mesh, values: &[T]) -> bool {
    values.iter().zip(0..).any(|(value, vertex)| *value != values[mesh.representative(vertex) as usize])
}

fn merged_values<const N: usize>(mesh: &Mesh, values: &Values<N>, corners: &[u32], kept: &[u32]) -> Values<N> {
    let at_corners = match values {
        Values::Absent => return Values::Absent,
        Values::Vertices(values) => {
            let bits = |vertex: u32| values[vertex as usize].map(f64::to_bits);
            if (0..values.len() as u32).all(|vertex| bits(vertex) == bits(mesh.representative(vertex))) {
                return Values::Vertices(selected(values, kept));
            }
            mesh.corners.iter().map(|&vertex| values[vertex as usize]).collect()
        }
        Values::Corners(values) => values.clone(),
    };
    Values::Corners(at_corners).simplified(corners, kept.len())
}

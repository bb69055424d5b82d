//! Meshes whose split vertices become one.

use crate::error::ReadError;
use crate::mesh::{Domain, Mesh, Positions, Property, Values};
use gusset_base::alloc;
use std::borrow::Cow;

/// A mesh without split vertices.
pub(crate) struct Merged<'a> {
    pub(crate) mesh: Cow<'a, Mesh>,
    /// Whether vertices that became one had different colours.
    pub(crate) loses_colours: bool,
    /// Names of the properties that vertices which became one had different values of.
    pub(crate) lost_properties: Vec<String>,
}

/// Merges vertices by [`Mesh::merge`]. Normals and texture coordinates that differ at a merged vertex move to its corners. The merged
/// vertex keeps the colour and the properties of the representative.
pub(crate) fn merge_vertices(mesh: &Mesh) -> Result<Merged<'_>, ReadError> {
    let vertex_count = mesh.positions.len() as u32;
    let mut merged = Merged { mesh: Cow::Borrowed(mesh), loses_colours: false, lost_properties: Vec::new() };
    if (0..vertex_count).all(|vertex| mesh.representative(vertex) == vertex) {
        return Ok(merged);
    }
    let kept = alloc::gather((0..vertex_count).filter(|&vertex| mesh.representative(vertex) == vertex))?;
    let mut indices = alloc::filled(0, mesh.positions.len())?;
    for (index, &vertex) in kept.iter().enumerate() {
        indices[vertex as usize] = index as u32;
    }
    let corners = alloc::collect(mesh.corners.iter().map(|&vertex| indices[mesh.representative(vertex) as usize]))?;
    merged.loses_colours = differs(mesh, &mesh.vertex_colours);
    let mut properties = alloc::with_capacity(mesh.properties.len())?;
    for property in &mesh.properties {
        let is_of_vertices = property.domain == Domain::Vertices;
        if is_of_vertices && differs(mesh, &property.values) {
            alloc::push(&mut merged.lost_properties, property.name.clone())?;
        }
        let values =
            if is_of_vertices { select_values(&property.values, &kept)? } else { alloc::copied(&property.values)? };
        properties.push(Property { name: property.name.clone(), values, ..*property });
        alloc::check_reserve()?;
    }
    merged.mesh = Cow::Owned(Mesh {
        name: mesh.name.clone(),
        positions: match &mesh.positions {
            Positions::F32(points) => Positions::F32(select_values(points, &kept)?),
            Positions::F64(points) => Positions::F64(select_values(points, &kept)?),
        },
        face_offsets: alloc::copied(&mesh.face_offsets)?,
        merge: Vec::new(),
        normals: merged_values(mesh, &mesh.normals, &corners, &kept)?,
        texcoords: merged_values(mesh, &mesh.texcoords, &corners, &kept)?,
        corners,
        vertex_colours: select_values(&mesh.vertex_colours, &kept)?,
        face_colours: alloc::copied(&mesh.face_colours)?,
        face_materials: alloc::copied(&mesh.face_materials)?,
        properties,
    });
    Ok(merged)
}

/// Returns the values of the kept vertices; none if `values` is empty.
fn select_values<T: Copy>(values: &[T], kept: &[u32]) -> Result<Vec<T>, ReadError> {
    if values.is_empty() {
        return Ok(Vec::new());
    }
    Ok(alloc::collect(kept.iter().map(|&vertex| values[vertex as usize]))?)
}

/// Returns whether a vertex has another value than its representative.
fn differs<T: PartialEq>(mesh: &Mesh, values: &[T]) -> bool {
    values.iter().zip(0..).any(|(value, vertex)| *value != values[mesh.representative(vertex) as usize])
}

fn merged_values<const N: usize>(
    mesh: &Mesh,
    values: &Values<N>,
    corners: &[u32],
    kept: &[u32],
) -> Result<Values<N>, ReadError> {
    let at_corners = match values {
        Values::Absent => return Ok(Values::Absent),
        Values::Vertices(values) => {
            let bits = |vertex: u32| values[vertex as usize].map(f64::to_bits);
            if (0..values.len() as u32).all(|vertex| bits(vertex) == bits(mesh.representative(vertex))) {
                return Ok(Values::Vertices(select_values(values, kept)?));
            }
            select_values(values, &mesh.corners)?
        }
        Values::Corners(values) => alloc::copied(values)?,
    };
    Values::Corners(at_corners).simplified(corners, kept.len())
}

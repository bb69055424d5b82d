//! Polygons as triangles.

use crate::mesh::Mesh;

/// Splits a face into triangles of its own corners. Returns places of corners in the face, three for each triangle, whose orientation is
/// the face's; nothing for faces of fewer than three corners.
pub(crate) fn triangulate_face(mesh: &Mesh, face: usize, triangles: &mut Vec<[u32; 3]>) {
    triangles.clear();
    let count = mesh.face_range(face).len() as u32;
    triangles.extend((1..count.saturating_sub(1)).map(|place| [0, place, place + 1]));
}

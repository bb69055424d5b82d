//! Faces as triangles.

use crate::error::ReadError;
use crate::mesh::Mesh;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::geom::polygon::triangulate_polygon;
use gusset_base::job::Job;

/// Splits a face into triangles of its own corners. Returns places of corners in the face, three for each triangle, whose orientation is
/// the face's; nothing for faces of fewer than three corners. See [`gusset_base::geom::polygon`].
pub(crate) fn triangulate_face(mesh: &Mesh, face: usize, triangles: &mut Vec<[u32; 3]>) -> Result<(), ReadError> {
    let point = |&vertex: &u32| DVec3::from_array(mesh.positions.get(vertex as usize));
    match mesh.face(face) {
        [a, b, c, d] => triangulate_polygon(&[a, b, c, d].map(point), triangles, &Job::default())?,
        vertices => triangulate_polygon(&alloc::collect(vertices.iter().map(point))?, triangles, &Job::default())?,
    }
    Ok(())
}

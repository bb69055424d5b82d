//! Faces as triangles.

use crate::mesh::Mesh;
use glam::DVec3;
use gusset_base::geom::polygon::triangulate_polygon;
use gusset_base::job::Job;
use std::io::{self, ErrorKind};

/// Splits a face into triangles of its own corners. Returns places of corners in the face, three for each triangle, whose orientation is
/// the face's; nothing for faces of fewer than three corners. See [`gusset_base::geom::polygon`].
pub(crate) fn triangulate_face(mesh: &Mesh, face: usize, triangles: &mut Vec<[u32; 3]>) -> io::Result<()> {
    let point = |&vertex: &u32| DVec3::from_array(mesh.positions.get(vertex as usize));
    let out_of_memory = |_| io::Error::from(ErrorKind::OutOfMemory);
    let split =
        |points: &[DVec3], triangles| triangulate_polygon(points, triangles, &Job::default()).map_err(out_of_memory);
    match mesh.face(face) {
        [a, b, c, d] => split(&[a, b, c, d].map(point), triangles),
        vertices => {
            let mut points = Vec::new();
            points.try_reserve_exact(vertices.len())?;
            points.extend(vertices.iter().map(point));
            split(&points, triangles)
        }
    }
}

//! The faces of a mesh without the numbers of its vertices.

use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_mesh::{Mesh, NONE};

/// The faces of a mesh. Vertices are numbered in the order of their first corners, so that shapes are equal if their
/// meshes differ in numbers of vertices only.
#[derive(PartialEq)]
pub(super) struct MeshShape {
    face_offsets: Vec<u32>,
    face_corners: Vec<u32>,
    points: Vec<DVec3>,
}

impl MeshShape {
    /// Returns the shape of a mesh. O(H) for H half-edges.
    pub(super) fn from_mesh(mesh: &Mesh) -> Result<Self> {
        let mut numbers = alloc::filled(NONE, mesh.positions.len())?;
        let (mut face_corners, mut points) = (alloc::with_capacity(mesh.face_corners.len())?, Vec::new());
        for &v in &mesh.face_corners {
            let number = &mut numbers[v as usize];
            if *number == NONE {
                *number = points.len() as u32;
                alloc::push(&mut points, mesh.positions.get(v))?;
            }
            face_corners.push(*number);
        }
        Ok(MeshShape { face_offsets: alloc::copied(&mesh.face_offsets)?, face_corners, points })
    }
}

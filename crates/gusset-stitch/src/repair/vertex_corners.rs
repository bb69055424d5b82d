//! The corners at each vertex, and the face of each corner.

use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_base::sort::Buckets;
use gusset_mesh::MeshView;

/// The corners at each vertex, ascending, and the face of each corner, in constant time; 8 bytes
/// per corner and 4 per vertex.
pub(super) struct VertexCorners {
    face: Vec<u32>,
    corners: Buckets<u32>,
}

impl VertexCorners {
    /// Builds the table by a counting sort, O(V + H).
    pub(super) fn new(mesh: &MeshView<'_>, job: &Job<'_>) -> Result<Self> {
        let (faces, vertices) = (mesh.faces(), mesh.positions().len());
        let count = faces.half_edge_count();
        let corners = Buckets::new(vertices, 0, (0..count as u32).map(|h| (faces.corner(h) as usize, h)))?;
        let mut face = alloc::with_capacity(count)?;
        job.work_in_ranges("corners", faces.len(), |range| {
            range.for_each(|f| face.extend(faces.corner_range(f).map(|_| f as u32)));
            Ok(())
        })?;
        Ok(VertexCorners { face, corners })
    }

    pub(super) fn face_of_corner(&self, h: u32) -> usize {
        self.face[h as usize] as usize
    }

    pub(super) fn corners_at_vertex(&self, v: u32) -> &[u32] {
        self.corners.get(v as usize)
    }
}

//! The faces' corners at each vertex, and the face of each corner.

use crate::alloc;
use crate::error::Result;
use crate::mesh::MeshView;

/// For each vertex the corners that name it, ascending, and for each corner its face, found without a search; 8 bytes a
/// corner and 4 a vertex.
pub(super) struct Corners {
    face: Vec<u32>,
    start: Vec<u32>,
    corners: Vec<u32>,
}

impl Corners {
    /// By a counting sort, O(V + H).
    pub(super) fn of(mesh: &MeshView<'_>) -> Result<Self> {
        let (faces, vertices) = (mesh.faces(), mesh.positions().len());
        let count = faces.half_edge_count();
        let mut start = alloc::filled(0u32, vertices + 1)?;
        for v in faces.corners(0..count) {
            start[v as usize + 1] += 1;
        }
        for v in 0..vertices {
            start[v + 1] += start[v];
        }
        // Filled from behind: afterwards start[v + 1] is where v begins, so the list is read one entry on.
        let mut corners = alloc::filled(0u32, count)?;
        for h in (0..count as u32).rev() {
            let place = &mut start[faces.corner(h) as usize + 1];
            *place -= 1;
            corners[*place as usize] = h;
        }
        start.remove(0);
        alloc::push(&mut start, count as u32)?;
        let mut face = alloc::with_capacity(count)?;
        for f in 0..faces.len() {
            face.extend(faces.range(f).map(|_| f as u32));
        }
        Ok(Corners { face, start, corners })
    }

    /// The face of corner `h`.
    pub(super) fn face(&self, h: u32) -> usize {
        self.face[h as usize] as usize
    }

    /// The corners at vertex `v`.
    pub(super) fn at(&self, v: u32) -> &[u32] {
        &self.corners[self.start[v as usize] as usize..self.start[v as usize + 1] as usize]
    }
}

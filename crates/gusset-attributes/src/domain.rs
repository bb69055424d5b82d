//! Kinds of elements, and how many of each an input has.

use gusset_mesh::MeshView;

/// What elements are counted.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Domain {
    /// Vertices; nodes of a net or a sheet.
    #[default]
    Vertices,
    /// Corners of faces, face after face.
    Corners,
    /// Faces; cells of a net or a sheet.
    Faces,
}

/// How many elements an input has, by [`Domain`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Counts {
    /// Vertices.
    pub vertices: usize,
    /// Corners.
    pub corners: usize,
    /// Faces.
    pub faces: usize,
}

impl Counts {
    /// Those of a mesh.
    pub(super) fn of_mesh(mesh: &MeshView<'_>) -> Self {
        let faces = mesh.faces();
        Counts { vertices: mesh.positions().len(), corners: faces.half_edge_count(), faces: faces.len() }
    }

    /// Those of a domain.
    pub fn of(&self, domain: Domain) -> usize {
        match domain {
            Domain::Vertices => self.vertices,
            Domain::Corners => self.corners,
            Domain::Faces => self.faces,
        }
    }
}

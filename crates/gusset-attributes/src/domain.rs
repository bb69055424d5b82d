//! Kinds of elements, and their numbers in an input.

use gusset_mesh::MeshView;

/// A kind of elements.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Domain {
    /// Vertices; nodes of a net or a sheet.
    #[default]
    Vertices,
    /// Corners of faces, face by face.
    Corners,
    /// Faces; cells of a net or a sheet.
    Faces,
}

/// The number of elements of each [`Domain`] in an input.
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
    /// Counts the elements of a mesh.
    pub fn from_mesh(mesh: &MeshView<'_>) -> Self {
        let faces = mesh.faces();
        Counts { vertices: mesh.positions().len(), corners: faces.half_edge_count(), faces: faces.len() }
    }

    /// The number of elements of a domain.
    pub fn count(&self, domain: Domain) -> usize {
        match domain {
            Domain::Vertices => self.vertices,
            Domain::Corners => self.corners,
            Domain::Faces => self.faces,
        }
    }
}

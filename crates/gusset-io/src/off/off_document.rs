//! Documents of OFF files.

use crate::document::{Document, PointCloud};
use crate::error::Note;
use crate::mesh::{Mesh, Values};

/// Makes a document of a mesh, or of points without faces.
pub(super) fn document_from_mesh(mesh: Mesh, notes: Vec<Note>) -> Document {
    if mesh.face_count() > 0 || mesh.positions.is_empty() {
        return Document { notes, ..Document::from_mesh(mesh) };
    }
    let normals = if let Values::Vertices(normals) = mesh.normals { normals } else { Vec::new() };
    let points = PointCloud { positions: mesh.positions, normals, colours: mesh.vertex_colours };
    Document { points, notes, ..Document::default() }
}

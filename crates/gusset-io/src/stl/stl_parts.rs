//! Sizes of binary files, and parts of meshes, that readers and writers share.

use crate::error::{Note, ReadError};
use crate::mesh::{Mesh, Positions};
use crate::parallel_fill::make_vector;

/// Bytes before the count of a binary file.
pub(super) const HEADER_BYTES: usize = 80;
/// Bytes before the first facet of a binary file.
pub(super) const FACETS_START: usize = HEADER_BYTES + 4;
/// Bytes of a facet in a binary file.
pub(super) const FACET_BYTES: usize = 50;

pub(super) type MeshAndNotes = (Mesh, Vec<Note>);

/// Makes the corners of a mesh whose corners all have vertices of their own.
pub(super) fn number_corners(count: usize) -> Result<Vec<u32>, ReadError> {
    if u32::try_from(count).is_err() {
        return Err(ReadError::new(
            crate::ReadErrorKind::TooLarge,
            format!("the file has {count} corners; the limit is 2^32 - 1, so split it"),
        ));
    }
    make_vector(count, |corner| corner as u32)
}

pub(super) fn mesh_from_parts(positions: Positions, corners: Vec<u32>, face_offsets: Vec<u32>) -> Mesh {
    Mesh { positions, corners, face_offsets, ..Mesh::default() }
}

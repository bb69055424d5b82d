//! STL, stereolithography files: triangles by the positions of their corners.
//!
//! The source is the "StereoLithography Interface Specification" of 3D Systems (1989). Binary files have a header of 80 bytes, a count,
//! and 50 bytes for each facet in little-endian order. Text files have words. Both repeat positions for each facet, so the reader merges
//! vertices at equal positions, unless [`ReadOptions::merge_repeated`](crate::ReadOptions::merge_repeated) is off. Positions of binary
//! files have single precision, and text files are read in double precision. Normals follow from the corners and are ignored.
//!
//! The reader also accepts:
//! - Binary files whose header begins with `solid`: the size, or what follows the first line, decides.
//! - Binary files with bytes behind the last facet, and with a count below the facets that the file holds.
//! - Colours of facets in their attribute bytes, in the ways of VisCAM and of Materialise Magics.
//! - Text in capitals, with blanks, a byte order mark or comments before `solid`, on one line, with several solids, with loops of more
//!   than three corners, without normals, or without `endsolid`.
//!
//! Reading takes 52 bytes of memory for each binary facet without merging. Merging looks up each corner in a table.

mod read_binary_stl;
mod read_text_stl;
#[cfg(test)]
mod stl_tests;
mod write_stl;

pub(crate) use write_stl::write_stl;

use crate::document::Document;
use crate::error::{Note, ReadError};
use crate::foreign_files::refuse_foreign_file;
use crate::mesh::{Mesh, Positions};
use crate::options::ReadOptions;
use crate::parallel_fill::make_vector;
use crate::text_encoding::decode_text;
use read_binary_stl::{is_whole_binary_stl, read_binary_stl};
use read_text_stl::{is_text_stl, read_text_stl};

/// Bytes before the count of a binary file.
const HEADER_BYTES: usize = 80;
/// Bytes before the first facet of a binary file.
const FACETS_START: usize = HEADER_BYTES + 4;
/// Bytes of a facet in a binary file.
const FACET_BYTES: usize = 50;

pub(crate) fn read_stl(bytes: &[u8], options: &ReadOptions) -> Result<Document, ReadError> {
    if bytes.is_empty() {
        return Err(ReadError::new(crate::ReadErrorKind::Malformed, "the file is empty"));
    }
    let (mesh, notes) = if is_whole_binary_stl(bytes) {
        read_binary_stl(bytes, options)?
    } else {
        let text = decode_text(bytes)?;
        if is_text_stl(&text) {
            read_text_stl(&text, options)?
        } else if let Some(error) = refuse_foreign_file(bytes) {
            return Err(error);
        } else {
            read_binary_stl(bytes, options)?
        }
    };
    Ok(Document { notes, ..Document::from_mesh(mesh) })
}

type MeshAndNotes = (Mesh, Vec<Note>);

/// Makes the corners of a mesh whose corners all have vertices of their own.
fn number_corners(count: usize) -> Result<Vec<u32>, ReadError> {
    if u32::try_from(count).is_err() {
        return Err(ReadError::new(crate::ReadErrorKind::TooLarge, format!("the file has {count} corners")));
    }
    make_vector(count, |corner| corner as u32)
}

fn mesh_from_parts(positions: Positions, corners: Vec<u32>, face_offsets: Vec<u32>) -> Mesh {
    Mesh { positions, corners, face_offsets, ..Mesh::default() }
}

//! Concatenation of meshes: vertices and faces in the order of the pieces, positions bit for bit.

use super::owned::{Mesh, PositionBuffer};
use super::positions::{Scalar, check_size};
use super::view::MeshView;
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::job::Job;

const STAGE: &str = "putting the pieces together";

/// The place of a piece in the concatenated mesh. Its vertex v becomes `first_vertex + v` and its
/// face f becomes `first_face + f`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct PieceOffsets {
    /// The new index of the piece's first vertex.
    pub first_vertex: u32,
    /// The new index of the piece's first face.
    pub first_face: u32,
}

/// Concatenates pieces into one mesh without joining them. Positions keep their bits, in the scalar
/// type of the first piece. O(size); the only memory is the result.
///
/// # Errors
/// [`Error::EmptyMesh`] without pieces, [`Error::MixedScalars`] if the first piece has `f32` and a
/// later one `f64` positions, [`Error::TooLarge`], [`Error::OutOfMemory`], [`Error::Cancelled`].
pub fn concatenate(pieces: &[MeshView<'_>], job: &Job<'_>) -> Result<(Mesh, Vec<PieceOffsets>)> {
    let mut whole = empty_mesh_with_room(pieces.iter(), [0; 3])?;
    let mut places = alloc::with_capacity(pieces.len())?;
    for piece in pieces {
        places.push(append_piece(&mut whole, piece, job, |_| false)?);
    }
    Ok((whole, places))
}

/// Creates an empty mesh in the scalar type of the first piece. It has room for `pieces`, and for
/// `extra` vertices, faces and corners in addition.
///
/// # Errors
/// The errors of [`concatenate`].
pub fn empty_mesh_with_room<'m, 'a: 'm>(
    pieces: impl Iterator<Item = &'m MeshView<'a>> + Clone,
    extra: [usize; 3],
) -> Result<Mesh> {
    let scalar = pieces.clone().next().ok_or(Error::EmptyMesh { what: "pieces" })?.positions().scalar();
    if scalar == Scalar::F32 && pieces.clone().any(|p| p.positions().scalar() == Scalar::F64) {
        return Err(Error::MixedScalars);
    }
    let mut counts = extra.map(|count| count as u64);
    for piece in pieces {
        counts[0] += piece.positions().len() as u64;
        counts[1] += piece.faces().len() as u64;
        counts[2] += piece.faces().half_edge_count() as u64;
    }
    check_size(counts[0], counts[2])?;
    let mut face_offsets = alloc::with_capacity(counts[1] as usize + 1)?;
    face_offsets.push(0);
    let positions = PositionBuffer::with_capacity(scalar, counts[0] as usize)?;
    Ok(Mesh::new(positions, face_offsets, alloc::with_capacity(counts[2] as usize)?))
}

/// Appends a piece to a mesh that has room for it. `must_flip` selects the faces to flip; a flipped
/// face keeps its first corner.
pub fn append_piece(
    whole: &mut Mesh,
    piece: &MeshView<'_>,
    job: &Job<'_>,
    mut must_flip: impl FnMut(usize) -> bool,
) -> Result<PieceOffsets> {
    let place = PieceOffsets { first_vertex: whole.positions.len() as u32, first_face: whole.face_count() as u32 };
    let (positions, place_them) = (piece.positions(), job.sub_job(0.0, 0.0));
    place_them.work_in_ranges(STAGE, positions.len(), |range| whole.positions.append(positions, range))?;
    job.step(0.0, STAGE)?;
    for f in 0..piece.faces().len() {
        job.step_within_list(f, STAGE)?;
        let start = whole.face_corners.len();
        whole.face_corners.extend(piece.face(f).map(|v| v + place.first_vertex));
        if must_flip(f) {
            whole.face_corners[start + 1..].reverse();
        }
        whole.face_offsets.push(whole.face_corners.len() as u32);
    }
    Ok(place)
}

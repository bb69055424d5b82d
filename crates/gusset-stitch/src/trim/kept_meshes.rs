//! The kept faces of all pieces as one mesh, and their origins.

use super::trim_request::KeptFacesOfPieces;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::bit_set::BitSet;
use gusset_base::job::Job;
use gusset_mesh::{Mesh, MeshView, NONE, PieceOffsets, concatenate};

const STAGE: &str = "putting the pieces together";

/// The kept faces of the pieces, side by side.
#[derive(Debug, Clone, PartialEq)]
pub struct TrimmedPieces {
    /// The kept faces and the vertices that they use, in the order of the pieces. Positions keep
    /// their bits, in the scalar type of the first piece.
    pub mesh: Mesh,
    /// The first vertex and the first face of each piece in the maps.
    pub piece_offsets: Vec<PieceOffsets>,
    /// For each vertex of all pieces, the new vertex, or [`NONE`].
    pub vertex_map: Vec<u32>,
    /// For each face of all pieces, the new face, or [`NONE`].
    pub face_map: Vec<u32>,
    /// For each kept face, the old face, counted through all pieces.
    pub faces: Vec<u32>,
    /// For each kept corner, the old corner, counted through all pieces.
    pub corners: Vec<u32>,
}

impl TrimmedPieces {
    /// Builds the mesh of the kept faces of `trimmed`. Vertices that were merged with others are
    /// kept if a kept face has them. O(size).
    ///
    /// # Errors
    /// [`Error::EmptyMesh`](gusset_base::Error::EmptyMesh) without pieces,
    /// [`Error::MixedScalars`](gusset_base::Error::MixedScalars),
    /// [`Error::TooLarge`](gusset_base::Error::TooLarge),
    /// [`Error::OutOfMemory`](gusset_base::Error::OutOfMemory),
    /// [`Error::Cancelled`](gusset_base::Error::Cancelled).
    pub fn new(pieces: &[MeshView<'_>], trimmed: &KeptFacesOfPieces, job: &Job<'_>) -> Result<TrimmedPieces> {
        let job = &job.sub_job(0.0, 0.0);
        let (whole, places) = concatenate(pieces, job)?;
        let count = trimmed.kept.iter().map(Vec::len).sum();
        let mut face_map = alloc::filled(NONE, whole.face_count())?;
        let mut is_used = BitSet::new(whole.positions.len())?;
        let (mut faces, mut corners) = (alloc::with_capacity(count)?, Vec::new());
        let mut face_offsets = alloc::with_capacity(count + 1)?;
        face_offsets.push(0);
        for ((piece, place), kept) in pieces.iter().zip(&places).zip(&trimmed.kept) {
            for &f in kept {
                job.step_within_list(faces.len(), STAGE)?;
                let old = place.first_face + f;
                face_map[old as usize] = faces.len() as u32;
                faces.push(old);
                let range = whole.face_offsets[old as usize]..whole.face_offsets[old as usize + 1];
                for (corner, h) in range.clone().zip(piece.faces().corner_range(f as usize)) {
                    is_used.insert(whole.face_corners[corner as usize]);
                    is_used.insert(place.first_vertex + piece.faces().corner_vertex_before_merging(h as u32));
                }
                alloc::extend(&mut corners, range)?;
                face_offsets.push(corners.len() as u32);
            }
        }
        let vertices = alloc::gather((0..whole.positions.len() as u32).filter(|&v| is_used.contains(v)))?;
        let mut vertex_map = alloc::filled(NONE, whole.positions.len())?;
        vertices.iter().zip(0..).for_each(|(&v, name)| vertex_map[v as usize] = name);
        let names = corners.iter().map(|&corner| vertex_map[whole.face_corners[corner as usize] as usize]);
        let mesh = Mesh::new(whole.positions.select_vertices(&vertices)?, face_offsets, alloc::collect(names)?);
        Ok(TrimmedPieces { mesh, piece_offsets: places, vertex_map, face_map, faces, corners })
    }
}

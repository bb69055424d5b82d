//! What trimming leaves of the pieces, put together, and where it comes from.

use super::history::History;
use crate::alloc;
use crate::error::Result;
use crate::geom::bit_set::BitSet;
use crate::job::Job;
use crate::mesh::{Mesh, NONE, Piece};
use crate::repair::corner_origins::CornerOrigins;
use crate::trim::Trimmed;

/// What is left of the pieces side by side.
pub(super) struct Remains {
    /// Of the vertices and faces of all pieces what they became, or [`NONE`].
    pub(super) vertex_map: Vec<u32>,
    /// See above.
    pub(super) face_map: Vec<u32>,
    /// Of the faces and corners that are left what they were, counted through all pieces.
    faces: Vec<u32>,
    corners: Vec<u32>,
}

impl Remains {
    /// The mesh of the faces that are kept and the vertices that they use, and what it was. O(size).
    pub(super) fn of(whole: &Mesh, trimmed: &Trimmed, places: &[Piece], job: &Job<'_>) -> Result<(Mesh, Remains)> {
        let count = trimmed.kept.iter().map(Vec::len).sum();
        let mut faces = alloc::with_capacity(count)?;
        for (kept, place) in trimmed.kept.iter().zip(places) {
            faces.extend(kept.iter().map(|&f| f + place.first_face));
        }
        let mut face_map = alloc::filled(NONE, whole.face_count())?;
        let mut is_used = BitSet::new(whole.positions.len())?;
        let (mut face_offsets, mut corners) = (alloc::with_capacity(count + 1)?, Vec::new());
        face_offsets.push(0);
        for (&f, name) in faces.iter().zip(0..) {
            job.step_within(name as usize, "putting the pieces together")?;
            face_map[f as usize] = name;
            let range = whole.face_offsets[f as usize]..whole.face_offsets[f as usize + 1];
            for corner in range.clone() {
                is_used.insert(whole.face_corners[corner as usize]);
            }
            alloc::extend(&mut corners, range)?;
            face_offsets.push(corners.len() as u32);
        }
        let vertices = alloc::gather((0..whole.positions.len() as u32).filter(|&v| is_used.contains(v)))?;
        let mut vertex_map = alloc::filled(NONE, whole.positions.len())?;
        vertices.iter().zip(0..).for_each(|(&v, name)| vertex_map[v as usize] = name);
        let names = corners.iter().map(|&corner| vertex_map[whole.face_corners[corner as usize] as usize]);
        let mesh = Mesh::new(whole.positions.select(&vertices)?, face_offsets, alloc::collect(names)?);
        Ok((mesh, Remains { vertex_map, face_map, faces, corners }))
    }

    /// Makes a history of what is left one of the pieces.
    pub(super) fn enter(self, history: &mut History) -> Result<()> {
        match &mut history.face_origin {
            Some(faces) => faces.iter_mut().for_each(|f| *f = self.faces[*f as usize]),
            None => history.face_origin = Some(self.faces),
        }
        history.corner_origins = Some(match history.corner_origins.take() {
            Some(origins) => origins.after(Some(&self.corners)),
            None => CornerOrigins { corners: self.corners, on_edges: Vec::new() },
        });
        Ok(())
    }
}

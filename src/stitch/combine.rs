//! One mesh of both pieces and the strip.
//!
//! Vertices: those of A, then those of B, then the new ones. Faces: those of A, then those of B, then the strip. Positions keep their bits.

use super::grid::FaceList;
use crate::alloc;
use crate::error::Result;
use crate::mesh::{Mesh, MeshView, concat};
use glam::DVec3;
use std::ops::Range;

/// Old indices to new ones.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct IndexMap {
    /// Per old vertex, the new one.
    pub vertices: Vec<u32>,
    /// Per old face, the new one.
    pub faces: Vec<u32>,
}

/// A mesh under construction.
pub(super) struct Combination {
    pub(super) mesh: Mesh,
}

impl Combination {
    /// Room for all of `pieces`, `extra` vertices and the strip's faces.
    ///
    /// # Errors
    /// Those of [`concat::empty`].
    pub(super) fn new(pieces: &[&MeshView<'_>], extra: usize, strip: &FaceList) -> Result<Self> {
        let room = [extra, strip.offsets.len(), strip.corners.len()];
        Ok(Combination { mesh: concat::empty(pieces.iter().copied(), room)? })
    }

    /// Appends a piece; the faces that `turn` names are turned over, each from its own first corner.
    pub(super) fn append(&mut self, piece: &MeshView<'_>, turn: impl FnMut(usize) -> bool) -> Result<IndexMap> {
        let place = concat::append(&mut self.mesh, piece, turn)?;
        Ok(IndexMap {
            vertices: alloc::collect((0..piece.positions().len()).map(|v| v as u32 + place.first_vertex))?,
            faces: alloc::collect((0..piece.faces().len()).map(|f| f as u32 + place.first_face))?,
        })
    }

    /// Appends new vertices; returns their indices.
    pub(super) fn append_vertices(&mut self, points: impl Iterator<Item = DVec3>) -> Result<Range<u32>> {
        let first = self.mesh.positions.len() as u32;
        self.mesh.positions.extend(points)?;
        Ok(first..self.mesh.positions.len() as u32)
    }

    /// Appends the strip, whose vertex v is `names[v]` here; returns its faces.
    pub(super) fn append_strip(&mut self, faces: &FaceList, names: &[u32]) -> Range<u32> {
        let first = self.mesh.face_count() as u32;
        for face in faces.iter() {
            self.mesh.face_corners.extend(face.iter().map(|&v| names[v as usize]));
            self.mesh.face_offsets.push(self.mesh.face_corners.len() as u32);
        }
        first..self.mesh.face_count() as u32
    }
}

/// The strip as a mesh of its own; its vertex v is `names[v]` of the whole.
pub(super) fn strip_alone(whole: &Mesh, faces: FaceList, names: &[u32]) -> Result<Mesh> {
    Ok(Mesh { positions: whole.positions.select(names)?, face_offsets: faces.offsets, face_corners: faces.corners })
}

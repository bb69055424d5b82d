//! One mesh of both pieces and the strip.
//!
//! Vertices: those of A, then those of B, then the new ones. Faces: those of A, then those of B, then the strip. Positions keep their bits.

use super::grid::FaceList;
use crate::alloc;
use crate::error::{Error, Result};
use crate::mesh::{MAX_ELEMENTS, Mesh, MeshView, PositionBuffer, Scalar};
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
pub(crate) struct Combination {
    pub(crate) mesh: Mesh,
}

impl Combination {
    /// Room for all of `pieces`, `extra` vertices and the strip's faces.
    ///
    /// # Errors
    /// [`Error::TooLarge`], [`Error::MixedScalars`], [`Error::OutOfMemory`].
    pub(crate) fn new(pieces: &[&MeshView<'_>], extra: usize, strip: &FaceList) -> Result<Self> {
        let scalar = pieces[0].positions().scalar();
        if scalar == Scalar::F32 && pieces.iter().any(|p| p.positions().scalar() == Scalar::F64) {
            return Err(Error::MixedScalars);
        }
        let total = |count: fn(&MeshView<'_>) -> usize| pieces.iter().map(|p| count(p)).sum::<usize>();
        let vertices = total(|p| p.positions().len()) + extra;
        let corners = total(|p| p.faces().half_edge_count()) + strip.corners.len();
        for (what, count) in [("vertices", vertices as u64), ("half-edges", corners as u64)] {
            if count > MAX_ELEMENTS {
                return Err(Error::TooLarge { what, count, limit: MAX_ELEMENTS });
            }
        }
        let mut face_offsets = alloc::with_capacity(total(|p| p.faces().len()) + strip.offsets.len())?;
        face_offsets.push(0);
        Ok(Combination {
            mesh: Mesh {
                positions: PositionBuffer::with_capacity(scalar, vertices)?,
                face_offsets,
                face_corners: alloc::with_capacity(corners)?,
            },
        })
    }

    /// Appends a piece; the faces that `turn` names are turned over, each from its own first corner.
    pub(crate) fn append(&mut self, piece: &MeshView<'_>, mut turn: impl FnMut(usize) -> bool) -> Result<IndexMap> {
        let (first_vertex, first_face) = (self.mesh.positions.len() as u32, self.mesh.face_count() as u32);
        self.mesh.positions.append(piece.positions())?;
        for f in 0..piece.faces().len() {
            let start = self.mesh.face_corners.len();
            self.mesh.face_corners.extend(piece.face(f).map(|v| v + first_vertex));
            if turn(f) {
                self.mesh.face_corners[start + 1..].reverse();
            }
            self.mesh.face_offsets.push(self.mesh.face_corners.len() as u32);
        }
        Ok(IndexMap {
            vertices: alloc::collect((0..piece.positions().len()).map(|v| v as u32 + first_vertex))?,
            faces: alloc::collect((0..piece.faces().len()).map(|f| f as u32 + first_face))?,
        })
    }

    /// Appends new vertices; returns their indices.
    pub(crate) fn append_vertices(&mut self, points: impl Iterator<Item = DVec3>) -> Result<Range<u32>> {
        let first = self.mesh.positions.len() as u32;
        self.mesh.positions.extend(points)?;
        Ok(first..self.mesh.positions.len() as u32)
    }

    /// Appends faces over the vertices that are here already.
    pub(crate) fn append_faces(&mut self, faces: &FaceList) {
        for face in faces.iter() {
            self.mesh.face_corners.extend_from_slice(face);
            self.mesh.face_offsets.push(self.mesh.face_corners.len() as u32);
        }
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

/// The faces of a mesh from `first` on as a mesh of their own, with the vertices that they use in ascending order.
pub(crate) fn part_alone(whole: &Mesh, first: usize) -> Result<Mesh> {
    let start = whole.face_offsets[first];
    let corners = &whole.face_corners[start as usize..];
    let mut names = alloc::copied(corners)?;
    names.sort_unstable();
    names.dedup();
    Ok(Mesh {
        positions: whole.positions.select(&names)?,
        face_offsets: alloc::collect(whole.face_offsets[first..].iter().map(|offset| offset - start))?,
        face_corners: alloc::collect(corners.iter().map(|v| names.partition_point(|name| name < v) as u32))?,
    })
}

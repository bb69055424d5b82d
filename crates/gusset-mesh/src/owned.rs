//! The mesh that the library returns: positions in the input's scalar type, faces as offsets
//! and corners.

use super::positions::{Positions, Scalar};
use super::view::{Faces, MeshView};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::scale::overflow_safe_distance;
use gusset_base::job::Job;
use std::ops::Range;

/// Packed positions of one scalar type.
#[derive(Debug, Clone, PartialEq)]
pub enum PositionBuffer {
    /// 32-bit coordinates.
    F32(Vec<[f32; 3]>),
    /// 64-bit coordinates.
    F64(Vec<[f64; 3]>),
}

impl PositionBuffer {
    /// Creates an empty buffer with room for `capacity` positions.
    #[inline]
    pub fn with_capacity(scalar: Scalar, capacity: usize) -> Result<Self> {
        Ok(match scalar {
            Scalar::F32 => PositionBuffer::F32(alloc::with_capacity(capacity)?),
            Scalar::F64 => PositionBuffer::F64(alloc::with_capacity(capacity)?),
        })
    }

    /// Appends the positions `range` of `from`. They keep their bits if the types agree; `f32`
    /// converts exactly to `f64`.
    #[inline]
    pub fn append(&mut self, from: &Positions<'_>, range: Range<usize>) -> Result<()> {
        match self {
            PositionBuffer::F32(out) if from.scalar() == Scalar::F32 => append_position_bits(out, from, range),
            PositionBuffer::F64(out) if from.scalar() == Scalar::F64 => append_position_bits(out, from, range),
            _ => self.extend(range.map(|v| from.get(v as u32))),
        }
    }

    /// Appends points, rounded to the buffer's type.
    pub fn extend(&mut self, points: impl Iterator<Item = DVec3>) -> Result<()> {
        match self {
            PositionBuffer::F32(out) => alloc::extend(out, points.map(|p| p.as_vec3().to_array())),
            PositionBuffer::F64(out) => alloc::extend(out, points.map(|p| p.to_array())),
        }
    }

    /// Copies the positions `vertices` of this buffer, bit for bit.
    pub fn select_vertices(&self, vertices: &[u32]) -> Result<PositionBuffer> {
        Self::gather(&self.view(), vertices)
    }

    /// Copies the positions `vertices` of `from`, bit for bit.
    pub fn gather(from: &Positions<'_>, vertices: &[u32]) -> Result<PositionBuffer> {
        Ok(match from.scalar() {
            Scalar::F32 => PositionBuffer::F32(gather_position_bits(from, vertices)?),
            Scalar::F64 => PositionBuffer::F64(gather_position_bits(from, vertices)?),
        })
    }

    /// Returns the number of positions.
    #[inline]
    pub fn len(&self) -> usize {
        self.view().len()
    }

    /// Returns true if the list of positions is empty.
    #[inline]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Borrows the positions.
    #[inline]
    pub fn view(&self) -> Positions<'_> {
        match self {
            PositionBuffer::F32(p) => Positions::from(p.as_slice()),
            PositionBuffer::F64(p) => Positions::from(p.as_slice()),
        }
    }

    /// Position `v` in double precision.
    #[inline]
    pub fn get(&self, v: u32) -> DVec3 {
        self.view().get(v)
    }
}

fn append_position_bits<T: bytemuck::Pod>(out: &mut Vec<T>, from: &Positions<'_>, range: Range<usize>) -> Result<()> {
    alloc::reserve(out, range.len())?;
    match from.packed_bytes() {
        Some(bytes) => {
            let bytes = &bytes[range.start * size_of::<T>()..range.end * size_of::<T>()];
            out.extend(bytes.chunks_exact(size_of::<T>()).map(bytemuck::pod_read_unaligned::<T>));
        }
        None => out.extend(range.map(|v| bytemuck::pod_read_unaligned::<T>(from.position_bytes(v)))),
    }
    Ok(())
}

fn gather_position_bits<T: bytemuck::Pod>(from: &Positions<'_>, vertices: &[u32]) -> Result<Vec<T>> {
    alloc::collect(vertices.iter().map(|&v| bytemuck::pod_read_unaligned(from.position_bytes(v as usize))))
}

/// An owned polygon mesh.
#[derive(Debug, Clone, PartialEq)]
pub struct Mesh {
    /// The positions.
    pub positions: PositionBuffer,
    /// The start of each face's corners, then the number of corners.
    pub face_offsets: Vec<u32>,
    /// Vertex indices, face after face.
    pub face_corners: Vec<u32>,
    /// The merge map: for each vertex the vertex that it is merged into, see [`MeshView::merged`].
    /// Vertices are kept apart in the faces for the values that they carry. Empty if no vertices
    /// are merged.
    pub merge: Vec<u32>,
}

impl Mesh {
    /// Creates a mesh without merged vertices.
    #[inline]
    pub fn new(positions: PositionBuffer, face_offsets: Vec<u32>, face_corners: Vec<u32>) -> Mesh {
        Mesh { positions, face_offsets, face_corners, merge: Vec::new() }
    }

    /// Returns the vertex at a corner after merging.
    #[inline]
    pub fn corner(&self, corner: usize) -> u32 {
        let v = self.face_corners[corner];
        self.merge.get(v as usize).copied().unwrap_or(v)
    }

    /// Returns the face that a corner belongs to, by bisection.
    #[inline]
    pub fn face_of_corner(&self, corner: u32) -> usize {
        self.face_offsets.partition_point(|&start| start <= corner) - 1
    }

    /// Returns the number of faces.
    #[inline]
    pub fn face_count(&self) -> usize {
        self.face_offsets.len() - 1
    }

    /// Returns the corners of each face.
    pub fn faces(&self) -> impl ExactSizeIterator<Item = &[u32]> {
        self.face_offsets.windows(2).map(|w| &self.face_corners[w[0] as usize..w[1] as usize])
    }

    /// Flips face `f`: keeps its first corner and reverses the order of the others.
    pub fn turn_face(&mut self, f: usize) {
        let [first, end] = [f, f + 1].map(|k| self.face_offsets[k] as usize);
        self.face_corners[first + 1..end].reverse();
    }

    /// Returns the mean length of the faces' sides; infinite if all lengths are 0.
    pub fn mean_side_length(&self) -> f64 {
        let (mut sum, mut count) = (0.0, 0.0);
        for face in self.faces() {
            for (k, &u) in face.iter().enumerate() {
                sum += overflow_safe_distance(self.positions.get(u), self.positions.get(face[(k + 1) % face.len()]));
                count += 1.0;
            }
        }
        if sum > 0.0 { sum / count } else { f64::INFINITY }
    }

    /// Returns a validated view that ignores the merge map; see [`MeshView::new`] for the errors.
    #[inline]
    pub fn view(&self, job: &Job<'_>) -> Result<MeshView<'_>> {
        MeshView::new(self.positions.view(), Faces::polygons(&self.face_offsets, &self.face_corners)?, job)
    }
}

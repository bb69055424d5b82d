//! Polygon meshes with attributes, as files hold them: nothing is welded, reversed or left out.

use crate::error::ReadError;
use gusset_base::alloc;
use std::borrow::Cow;

/// Coordinates x, y, z of points, in the precision of the file.
#[derive(Clone, Debug, PartialEq)]
pub enum Positions {
    /// Single precision.
    F32(Vec<[f32; 3]>),
    /// Double precision.
    F64(Vec<[f64; 3]>),
}

impl Default for Positions {
    fn default() -> Self {
        Self::F64(Vec::new())
    }
}

impl Positions {
    /// Returns the number of points.
    #[must_use]
    pub fn len(&self) -> usize {
        match self {
            Self::F32(points) => points.len(),
            Self::F64(points) => points.len(),
        }
    }

    /// Returns whether the list is empty.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Returns point `index` in double precision.
    #[must_use]
    pub fn get(&self, index: usize) -> [f64; 3] {
        match self {
            Self::F32(points) => points[index].map(f64::from),
            Self::F64(points) => points[index],
        }
    }

    /// Copies the points.
    pub(crate) fn try_clone(&self) -> Result<Self, ReadError> {
        Ok(match self {
            Self::F32(points) => Self::F32(alloc::copied(points)?),
            Self::F64(points) => Self::F64(alloc::copied(points)?),
        })
    }

    /// Converts the points to double precision.
    pub(crate) fn make_double(&mut self) -> Result<(), ReadError> {
        if let Self::F32(points) = self {
            *self = Self::F64(alloc::collect(points.iter().map(|point| point.map(f64::from)))?);
        }
        Ok(())
    }

    /// Iterates over the points in double precision.
    pub fn iter(&self) -> impl Iterator<Item = [f64; 3]> + '_ {
        (0..self.len()).map(|index| self.get(index))
    }
}

/// Vectors of `N` numbers at vertices or corners. A vector whose first number is NaN is missing.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Values<const N: usize> {
    /// The mesh lacks this attribute.
    #[default]
    Absent,
    /// One vector for each vertex.
    Vertices(Vec<[f64; N]>),
    /// One vector for each corner, face by face.
    Corners(Vec<[f64; N]>),
}

impl<const N: usize> Values<N> {
    /// A missing vector.
    pub const MISSING: [f64; N] = [f64::NAN; N];

    /// Returns whether the mesh lacks this attribute.
    #[must_use]
    pub fn is_absent(&self) -> bool {
        matches!(self, Self::Absent)
    }

    /// Returns the vector at a corner, which belongs to `vertex`; `None` if it is missing.
    #[must_use]
    pub fn at_corner(&self, corner: usize, vertex: u32) -> Option<[f64; N]> {
        let value = match self {
            Self::Absent => return None,
            Self::Vertices(values) => values[vertex as usize],
            Self::Corners(values) => values[corner],
        };
        (!value[0].is_nan()).then_some(value)
    }

    /// Moves values from corners to vertices if all corners of each vertex agree. Otherwise keeps them.
    ///
    /// # Errors
    /// `OutOfMemory`.
    pub fn simplified(self, corners: &[u32], vertex_count: usize) -> Result<Self, ReadError> {
        if let Self::Corners(_) = self
            && let Some(Cow::Owned(values)) = self.at_vertices(corners, vertex_count)?
        {
            return Ok(Self::Vertices(values));
        }
        Ok(self)
    }

    /// Returns a vector for each vertex; `None` if the attribute is absent, a corner lacks it, or the corners of a vertex differ.
    pub(crate) fn at_vertices(
        &self,
        corners: &[u32],
        vertex_count: usize,
    ) -> Result<Option<Cow<'_, [[f64; N]]>>, ReadError> {
        let at_corners = match self {
            Self::Absent => return Ok(None),
            Self::Vertices(values) => return Ok(Some(Cow::Borrowed(values))),
            Self::Corners(values) => values,
        };
        let mut values = alloc::filled(Self::MISSING, vertex_count)?;
        let mut seen = alloc::filled(false, vertex_count)?;
        for (&vertex, value) in corners.iter().zip(at_corners) {
            let vertex = vertex as usize;
            if value[0].is_nan() || (seen[vertex] && values[vertex].map(f64::to_bits) != value.map(f64::to_bits)) {
                return Ok(None);
            }
            values[vertex] = *value;
            seen[vertex] = true;
        }
        Ok(Some(Cow::Owned(values)))
    }
}

/// Type of a property's numbers in a PLY file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NumberKind {
    /// 8-bit signed integer.
    I8,
    /// 8-bit unsigned integer.
    U8,
    /// 16-bit signed integer.
    I16,
    /// 16-bit unsigned integer.
    U16,
    /// 32-bit signed integer.
    I32,
    /// 32-bit unsigned integer.
    U32,
    /// Single precision.
    F32,
    /// Double precision.
    F64,
}

impl NumberKind {
    /// Returns whether the numbers are integers.
    #[must_use]
    pub fn is_integer(self) -> bool {
        !matches!(self, Self::F32 | Self::F64)
    }
}

/// Elements that carry a property.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Domain {
    /// Vertices.
    Vertices,
    /// Faces.
    Faces,
}

/// A named number for each vertex or face.
#[derive(Clone, Debug, PartialEq)]
pub struct Property {
    /// Name in the file.
    pub name: String,
    /// Type in the file.
    pub kind: NumberKind,
    /// Vertices or faces.
    pub domain: Domain,
    /// One number for each element.
    pub values: Vec<f64>,
}

/// A polygon mesh. Face `f` has corners `face_offsets[f]` to `face_offsets[f + 1] - 1`.
#[derive(Clone, Debug, PartialEq)]
pub struct Mesh {
    /// Name of the object; may be empty.
    pub name: String,
    /// Points.
    pub positions: Positions,
    /// `face_count + 1` entries from 0.
    pub face_offsets: Vec<u32>,
    /// Vertex of each corner, face by face. Each is below the number of points.
    pub corners: Vec<u32>,
    /// Representative of each vertex, for formats that split vertices at seams; empty: all vertices are separate. A representative
    /// represents itself.
    pub merge: Vec<u32>,
    /// Normals.
    pub normals: Values<3>,
    /// Texture coordinates, with the origin at the lower left of the image.
    pub texcoords: Values<2>,
    /// sRGB and opacity of each vertex, 0 to 1; may be empty.
    pub vertex_colours: Vec<[f32; 4]>,
    /// sRGB and opacity of each face, 0 to 1; may be empty.
    pub face_colours: Vec<[f32; 4]>,
    /// Material of each face, an index into the document's materials or [`NO_MATERIAL`](crate::NO_MATERIAL); may be empty.
    pub face_materials: Vec<u32>,
    /// Further numbers of vertices and faces.
    pub properties: Vec<Property>,
}

impl Default for Mesh {
    fn default() -> Self {
        Self {
            name: String::new(),
            positions: Positions::default(),
            face_offsets: vec![0],
            corners: Vec::new(),
            merge: Vec::new(),
            normals: Values::Absent,
            texcoords: Values::Absent,
            vertex_colours: Vec::new(),
            face_colours: Vec::new(),
            face_materials: Vec::new(),
            properties: Vec::new(),
        }
    }
}

impl Mesh {
    /// Returns the number of faces.
    #[must_use]
    pub fn face_count(&self) -> usize {
        self.face_offsets.len() - 1
    }

    /// Returns the vertices of a face.
    #[must_use]
    pub fn face(&self, face: usize) -> &[u32] {
        &self.corners[self.face_range(face)]
    }

    /// Returns the corners of a face.
    #[must_use]
    pub fn face_range(&self, face: usize) -> std::ops::Range<usize> {
        self.face_offsets[face] as usize..self.face_offsets[face + 1] as usize
    }

    /// Returns the vertices of all faces; `None` if a face is not a triangle.
    pub(crate) fn triangles(&self) -> Option<&[[u32; 3]]> {
        let is_triangle = |(face, &end): (usize, &u32)| end as usize == 3 * face;
        self.face_offsets.iter().enumerate().all(is_triangle).then(|| self.corners.as_chunks().0)
    }

    /// Returns the representative of a vertex.
    #[must_use]
    pub fn representative(&self, vertex: u32) -> u32 {
        self.merge.get(vertex as usize).copied().unwrap_or(vertex)
    }
}

//! The borrowed, validated view of a polygon mesh.

use super::positions::{MAX_ELEMENTS, Positions, check_size};
use gusset_base::alloc;
use gusset_base::error::{Element, Error, Result};
use gusset_base::job::Job;
use gusset_base::par;
use std::ops::Range;

/// Elements in one work item of the checks.
const ELEMENTS_PER_TASK: usize = 1 << 16;

/// Packed 32-bit indices at any alignment.
#[derive(Debug, Clone, Copy)]
struct PackedIndices<'a>(&'a [u8]);

impl<'a> PackedIndices<'a> {
    #[inline]
    fn get(&self, i: usize) -> u32 {
        bytemuck::pod_read_unaligned(&self.0[4 * i..4 * i + 4])
    }

    fn slice(&self, range: Range<usize>) -> impl ExactSizeIterator<Item = u32> + Clone + 'a {
        self.0[4 * range.start..4 * range.end].chunks_exact(4).map(bytemuck::pod_read_unaligned)
    }

    #[inline]
    fn len(&self) -> usize {
        self.0.len() / 4
    }

    /// Checks the indices as face offsets: they start at 0, and each is at least 3 more than the
    /// previous one.
    fn check_face_offsets(self, job: &Job<'_>) -> Result<()> {
        if self.get(0) != 0 {
            return Err(Error::BadOffsets { entry: 0, value: self.get(0) });
        }
        let check = |mut faces: Range<usize>| {
            faces.try_for_each(|f| match self.get(f + 1).checked_sub(self.get(f)) {
                None => Err(Error::BadOffsets { entry: f as u32 + 1, value: self.get(f + 1) }),
                Some(corners) if corners < 3 => Err(Error::FaceTooSmall { face: f as u32, corners }),
                Some(_) => Ok(()),
            })
        };
        par::map(job.requested_threads(), par::split_into_ranges(self.len() - 1, ELEMENTS_PER_TASK), check)?
            .into_iter()
            .collect()
    }
}

#[derive(Debug, Clone, Copy)]
enum FaceLayout<'a> {
    /// Every face has this many corners.
    Uniform(u32),
    /// Face f has the corners offsets\[f\] .. offsets\[f + 1\].
    Offsets(PackedIndices<'a>),
}

/// The receiver of [`Faces::visit_faces`].
pub trait FaceVisitor {
    /// Receives a face as its first half-edge and its vertices. Inline it: triangles and quads are
    /// passed as arrays, whose length the compiler then knows.
    fn visit_face(&mut self, first: u32, corners: &[u32]) -> Result<()>;
}

/// Faces in a host's memory: vertex indices, face after face.
#[derive(Debug, Clone, Copy)]
pub struct Faces<'a> {
    corners: PackedIndices<'a>,
    layout: FaceLayout<'a>,
    face_count: usize,
    /// The merge map and the corners before merging, if the faces are merged.
    corners_before_merging: Option<CornersBeforeMerging<'a>>,
}

/// The corners of faces before vertices were merged, and the vertex that each vertex is merged
/// into.
#[derive(Debug, Clone, Copy)]
struct CornersBeforeMerging<'a> {
    /// For each vertex the vertex that it is merged into.
    merge: PackedIndices<'a>,
    corners: PackedIndices<'a>,
}

impl<'a> Faces<'a> {
    /// Creates faces of `face_size` corners each. `corners` holds `count * face_size` native-endian
    /// `u32`.
    ///
    /// # Errors
    /// [`Error::FaceTooSmall`], [`Error::TooLarge`], [`Error::ArrayTooShort`].
    pub fn with_uniform_size(corners: &'a [u8], face_size: u32, count: usize) -> Result<Self> {
        let needed = Self::corner_count(face_size, count)? * 4;
        Ok(Faces {
            corners: read_packed_indices(corners, needed, "corners")?,
            layout: FaceLayout::Uniform(face_size),
            face_count: count,
            corners_before_merging: None,
        })
    }

    /// Creates polygons. Face `f` has the corners `offsets[f] .. offsets[f + 1]` of `corners`. Both
    /// are native-endian `u32`, and `offsets` has `count + 1` entries.
    ///
    /// # Errors
    /// [`Error::TooLarge`], [`Error::ArrayTooShort`]. [`MeshView::new`] checks the offsets
    /// themselves.
    pub fn with_offsets(offsets: &'a [u8], corners: &'a [u8], count: usize) -> Result<Self> {
        let offsets = read_packed_indices(offsets, Self::offset_count(count)? * 4, "face offsets")?;
        let needed = offsets.get(count) as usize * 4;
        Ok(Faces {
            corners: read_packed_indices(corners, needed, "corners")?,
            layout: FaceLayout::Offsets(offsets),
            face_count: count,
            corners_before_merging: None,
        })
    }

    /// Returns true if the faces have a merge map.
    #[inline]
    pub fn is_merged(&self) -> bool {
        self.corners_before_merging.is_some()
    }

    /// Returns the vertex that `v` is merged into; `v` itself if the map does not cover it.
    #[inline]
    pub fn merged_vertex(&self, v: u32) -> u32 {
        match self.corners_before_merging {
            Some(split) if (v as usize) < split.merge.len() => split.merge.get(v as usize),
            _ => v,
        }
    }

    /// Returns the vertex at corner `h` before merging.
    #[inline]
    pub fn corner_vertex_before_merging(&self, h: u32) -> u32 {
        self.corners_before_merging.map_or(self.corners, |split| split.corners).get(h as usize)
    }

    /// Returns the number of corners of `face_count` faces with `face_size` corners each.
    ///
    /// # Errors
    /// [`Error::FaceTooSmall`], [`Error::TooLarge`].
    pub fn corner_count(face_size: u32, face_count: usize) -> Result<usize> {
        if face_size < 3 {
            return Err(Error::FaceTooSmall { face: 0, corners: face_size });
        }
        let total = (face_count as u64).saturating_mul(u64::from(face_size));
        check_size(0, total)?;
        Ok(total as usize)
    }

    /// Returns the number of offsets for `face_count` faces.
    ///
    /// # Errors
    /// [`Error::TooLarge`].
    #[inline]
    pub fn offset_count(face_count: usize) -> Result<usize> {
        Error::check_count("faces", face_count as u64, MAX_ELEMENTS)?;
        Ok(face_count + 1)
    }

    /// Validates the offsets of `face_count` faces without the corners, and returns the required number
    /// of corners. It serves callers that learn the length of the corner array from the offsets
    /// alone.
    ///
    /// # Errors
    /// [`Error::TooLarge`], [`Error::ArrayTooShort`], [`Error::BadOffsets`],
    /// [`Error::FaceTooSmall`].
    #[inline]
    pub fn check_offsets(offsets: &[u8], face_count: usize, job: &Job<'_>) -> Result<usize> {
        let offsets = read_packed_indices(offsets, Self::offset_count(face_count)? * 4, "face offsets")?;
        offsets.check_face_offsets(job)?;
        let corners = offsets.get(face_count);
        check_size(0, corners.into())?;
        Ok(corners as usize)
    }

    /// Creates triangles.
    ///
    /// # Errors
    /// [`Error::TooLarge`].
    #[inline]
    pub fn triangles(corners: &'a [[u32; 3]]) -> Result<Self> {
        Self::with_uniform_size(bytemuck::cast_slice(corners), 3, corners.len())
    }

    /// Creates quads.
    ///
    /// # Errors
    /// [`Error::TooLarge`].
    #[inline]
    pub fn quads(corners: &'a [[u32; 4]]) -> Result<Self> {
        Self::with_uniform_size(bytemuck::cast_slice(corners), 4, corners.len())
    }

    /// Creates polygons; see [`Faces::with_offsets`].
    ///
    /// # Errors
    /// [`Error::BadOffsets`] for empty offsets, and the errors of [`Faces::with_offsets`].
    #[inline]
    pub fn polygons(offsets: &'a [u32], corners: &'a [u32]) -> Result<Self> {
        let count = offsets.len().checked_sub(1).ok_or(Error::BadOffsets { entry: 0, value: 0 })?;
        Self::with_offsets(bytemuck::cast_slice(offsets), bytemuck::cast_slice(corners), count)
    }

    /// Returns the number of faces.
    #[inline]
    pub fn len(&self) -> usize {
        self.face_count
    }

    /// Returns true if the list of faces is empty.
    #[inline]
    pub fn is_empty(&self) -> bool {
        self.face_count == 0
    }

    /// Returns the range of corners (half-edges) of face `f`.
    #[inline]
    pub fn corner_range(&self, f: usize) -> Range<usize> {
        match self.layout {
            FaceLayout::Uniform(n) => f * n as usize..(f + 1) * n as usize,
            FaceLayout::Offsets(offsets) => offsets.get(f) as usize..offsets.get(f + 1) as usize,
        }
    }

    /// Returns the face that corner (half-edge) `h` belongs to. O(1) for uniform faces, otherwise
    /// by bisection.
    #[inline]
    pub fn face_of_half_edge(&self, h: u32) -> u32 {
        match self.layout {
            FaceLayout::Uniform(n) => h / n,
            FaceLayout::Offsets(offsets) => {
                let (mut low, mut high) = (0, self.face_count);
                while high - low > 1 {
                    let middle = usize::midpoint(low, high);
                    if offsets.get(middle) <= h { low = middle } else { high = middle }
                }
                low as u32
            }
        }
    }

    /// Returns the next half-edge of the face.
    #[inline]
    pub fn next(&self, h: u32) -> u32 {
        let range = self.corner_range(self.face_of_half_edge(h) as usize);
        if h as usize + 1 == range.end { range.start as u32 } else { h + 1 }
    }

    /// Returns the vertex at corner `h`, where half-edge `h` starts.
    #[inline]
    pub fn corner(&self, h: u32) -> u32 {
        self.corners.get(h as usize)
    }

    /// Returns the vertices of the corners in `range`.
    pub fn corners(&self, range: Range<usize>) -> impl ExactSizeIterator<Item = u32> + Clone + 'a {
        self.corners.slice(range)
    }

    /// Calls `visitor` with each face of `faces` in turn. Extra memory: the largest face that has
    /// more than four corners.
    #[doc(hidden)]
    pub fn visit_faces(&self, faces: Range<usize>, visitor: &mut impl FaceVisitor) -> Result<()> {
        if let FaceLayout::Uniform(3) = self.layout {
            let corners = self.corners.0[12 * faces.start..12 * faces.end].chunks_exact(12);
            for (f, triangle) in faces.zip(corners) {
                visitor.visit_face(3 * f as u32, &bytemuck::pod_read_unaligned::<[u32; 3]>(triangle))?;
            }
            return Ok(());
        }
        let mut polygon = Vec::new();
        for f in faces {
            let range = self.corner_range(f);
            let first = range.start as u32;
            let corner = |i: u32| self.corner(first + i);
            match range.len() {
                3 => visitor.visit_face(first, &[corner(0), corner(1), corner(2)])?,
                4 => visitor.visit_face(first, &[corner(0), corner(1), corner(2), corner(3)])?,
                n => {
                    polygon.clear();
                    alloc::reserve(&mut polygon, n)?;
                    polygon.extend(self.corners(range));
                    visitor.visit_face(first, &polygon)?;
                }
            }
        }
        Ok(())
    }

    /// Returns the number of corners, which is the number of half-edges.
    #[inline]
    pub fn half_edge_count(&self) -> usize {
        self.corners.len()
    }
}

fn read_packed_indices<'a>(bytes: &'a [u8], needed: usize, what: &'static str) -> Result<PackedIndices<'a>> {
    match bytes.get(..needed) {
        Some(bytes) => Ok(PackedIndices(bytes)),
        None => Err(Error::ArrayTooShort { what, needed: needed as u64, given: bytes.len() as u64 }),
    }
}

/// A validated polygon mesh in the host's memory. It has at least one vertex and one face, monotone
/// offsets, at least three corners a face, and indices in range. Coordinates are finite at every
/// vertex that a face uses.
///
/// Vertices that no face uses may hold any values, like the empty cells of a range scan. The
/// algorithms copy them unchanged.
#[derive(Debug, Clone, Copy)]
pub struct MeshView<'a> {
    positions: Positions<'a>,
    faces: Faces<'a>,
}

impl<'a> MeshView<'a> {
    /// Validates the arrays, in O(vertices + corners), on the job's threads.
    ///
    /// # Errors
    /// [`Error::EmptyMesh`], [`Error::BadOffsets`], [`Error::FaceTooSmall`],
    /// [`Error::IndexOutOfRange`], [`Error::NotFinite`], each with the first offending element;
    /// [`Error::Cancelled`].
    pub fn new(positions: Positions<'a>, faces: Faces<'a>, job: &Job<'_>) -> Result<Self> {
        let mesh = MeshView { positions, faces };
        if positions.is_empty() {
            return Err(Error::EmptyMesh { what: "vertices" });
        }
        if faces.is_empty() {
            return Err(Error::EmptyMesh { what: "faces" });
        }
        job.step(0.0, "checking the mesh")?;
        if let FaceLayout::Offsets(offsets) = faces.layout {
            offsets.check_face_offsets(job)?;
        }
        job.step(0.3, "checking the mesh")?;
        // Divides both arrays into the same number of parts, so that the threads start once.
        let (corners, vertices) = (faces.half_edge_count(), positions.len());
        let count = corners.max(vertices).div_ceil(ELEMENTS_PER_TASK);
        let part = |len: usize, i: usize| {
            let length = len.div_ceil(count);
            len.min(i * length)..len.min((i + 1) * length)
        };
        let checked = par::map(job.requested_threads(), 0..count, |i| {
            (mesh.check_corners(part(corners, i)), positions.are_finite(part(vertices, i)))
        })?;
        checked.iter().try_for_each(|&(corners, _)| corners)?;
        if !checked.iter().all(|&(_, finite)| finite) {
            // Rare: check whether a face uses such a vertex.
            let bad = |h: &usize| !positions.get(faces.corner(*h as u32)).is_finite();
            let firsts =
                par::map(job.requested_threads(), par::split_into_ranges(corners, ELEMENTS_PER_TASK), |mut range| {
                    range.find(bad)
                })?;
            if let Some(&h) = firsts.iter().flatten().next() {
                let vertex = faces.corner(h as u32);
                Error::check_finite(Element::Vertex, vertex.into(), positions.get(vertex))?;
            }
        }
        job.step(1.0, "checking the mesh")?;
        Ok(mesh)
    }

    /// Returns the positions.
    #[inline]
    pub fn positions(&self) -> &Positions<'a> {
        &self.positions
    }

    /// Returns the faces.
    #[inline]
    pub fn faces(&self) -> &Faces<'a> {
        &self.faces
    }

    /// Applies a merge map to the corners, for [`MeshView::merged`]. `merge` holds for each vertex
    /// a native-endian `u32`: the vertex that it is merged into. A vertex that others are merged
    /// into must map to itself. O(V + H).
    ///
    /// # Errors
    /// [`Error::ArrayTooShort`], [`Error::BadMerge`], [`Error::OutOfMemory`], [`Error::Cancelled`].
    pub fn merged_corners(&self, merge: &[u8], job: &Job<'_>) -> Result<Vec<u32>> {
        const STAGE: &str = "merging vertices";
        let count = self.positions.len();
        let merge = read_packed_indices(merge, 4 * count, "merged vertices")?;
        let is_bad = |&v: &usize| {
            let of = merge.get(v);
            of as usize >= count || merge.get(of as usize) != of
        };
        job.sub_job(0.0, 0.3).work_in_ranges(STAGE, count, |mut range| match range.find(is_bad) {
            Some(v) => Err(Error::BadMerge { vertex: v as u32, value: merge.get(v) }),
            None => Ok(()),
        })?;
        let mut corners = alloc::with_capacity(self.faces.half_edge_count())?;
        job.sub_job(0.3, 1.0).work_in_ranges(STAGE, self.faces.half_edge_count(), |range| {
            corners.extend(self.faces.corners(range).map(|v| merge.get(v as usize)));
            Ok(())
        })?;
        Ok(corners)
    }

    /// Returns the mesh with merged corners, from [`merged_corners`](MeshView::merged_corners) for
    /// the same `merge`. The original corners remain accessible.
    #[must_use]
    #[inline]
    pub fn merged<'b>(&self, merge: &'b [u8], corners: &'b [u32]) -> MeshView<'b>
    where
        'a: 'b,
    {
        let split = CornersBeforeMerging {
            merge: PackedIndices(&merge[..4 * self.positions.len()]),
            corners: self.faces.corners,
        };
        let corners = PackedIndices(bytemuck::cast_slice(corners));
        MeshView {
            positions: self.positions,
            faces: Faces { corners, corners_before_merging: Some(split), ..self.faces },
        }
    }

    /// Returns the vertices of face `f`, in order.
    #[inline]
    pub fn face(&self, f: usize) -> impl ExactSizeIterator<Item = u32> + Clone + 'a {
        self.faces.corners(self.faces.corner_range(f))
    }

    fn check_corners(&self, range: Range<usize>) -> Result<()> {
        let count = self.positions.len();
        // First test all corners without locating an error: a loop without an exit runs several
        // times as fast.
        let beyond = |any, v: u32| any | u32::from(v >= count as u32);
        if self.faces.corners(range.clone()).fold(0, beyond) == 0 {
            return Ok(());
        }
        let corner = self.faces.corners(range.clone()).position(|v| v as usize >= count).unwrap_or(0);
        let corner = (range.start + corner) as u32;
        Err(Error::IndexOutOfRange {
            face: self.faces.face_of_half_edge(corner),
            corner,
            vertex: self.faces.corner(corner),
            count: count as u32,
        })
    }
}

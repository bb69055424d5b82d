//! Faces as triangles.

use super::owned::{Mesh, PositionBuffer};
use super::view::MeshView;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::polygon::triangulate_polygon;
use gusset_base::job::Job;

const STAGE: &str = "triangulating";
/// Number of faces between two progress reports.
const FACES_PER_REPORT: usize = 1 << 16;

/// Triangles, and the face of each. A face of n corners has n - 2 triangles, split as
/// [`triangulate_polygon`] does.
#[derive(Debug, Default)]
pub struct FaceTriangles {
    /// The corners of each triangle, as numbers given by the caller.
    pub corners: Vec<[u32; 3]>,
    /// The face of each triangle.
    pub faces: Vec<u32>,
    points: Vec<DVec3>,
    corner_places: Vec<[u32; 3]>,
}

impl FaceTriangles {
    /// Splits all faces of a mesh. The corners are vertices.
    ///
    /// O(H), and O(n log n) for a face of n corners that is not convex.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`](gusset_base::Error::OutOfMemory),
    /// [`Error::Cancelled`](gusset_base::Error::Cancelled).
    pub fn from_mesh(mesh: &MeshView<'_>, job: &Job<'_>) -> Result<Self> {
        Self::from_corners(mesh, |h| mesh.faces().corner(h), job)
    }

    /// Splits all faces of a mesh. The corners are half-edges.
    ///
    /// # Errors
    /// The errors of [`FaceTriangles::from_mesh`].
    pub fn with_half_edges(mesh: &MeshView<'_>, job: &Job<'_>) -> Result<Self> {
        Self::from_corners(mesh, |h| h, job)
    }

    /// Splits all faces of a mesh. `name` gives the number of each half-edge.
    fn from_corners(mesh: &MeshView<'_>, name: impl Fn(u32) -> u32, job: &Job<'_>) -> Result<Self> {
        let faces = mesh.faces();
        let count = faces.half_edge_count().saturating_sub(2 * faces.len());
        let mut split = FaceTriangles {
            corners: alloc::with_capacity(count)?,
            faces: alloc::with_capacity(count)?,
            ..FaceTriangles::default()
        };
        for f in 0..faces.len() {
            job.step_every(FACES_PER_REPORT, f, faces.len(), STAGE)?;
            let range = faces.corner_range(f);
            let half_edge = |k: usize| (range.start + k) as u32;
            let at = |k: usize| mesh.positions().get(faces.corner(half_edge(k)));
            split.append_face(
                range.len(),
                at,
                |k| name(half_edge(k)),
                f as u32,
                &job.sub_job_of_item(f, faces.len()),
            )?;
        }
        Ok(split)
    }

    /// Appends the triangles of a face. Corner k < `count` lies `at(k)` and has the number
    /// `name(k)`.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`](gusset_base::Error::OutOfMemory),
    /// [`Error::Cancelled`](gusset_base::Error::Cancelled).
    pub fn append_face(
        &mut self,
        count: usize,
        at: impl Fn(usize) -> DVec3,
        name: impl Fn(usize) -> u32,
        face: u32,
        job: &Job<'_>,
    ) -> Result<()> {
        if count == 3 {
            alloc::push(&mut self.corners, [0, 1, 2].map(name))?;
            return alloc::push(&mut self.faces, face);
        }
        self.points.clear();
        alloc::extend(&mut self.points, (0..count).map(at))?;
        triangulate_polygon(&self.points, &mut self.corner_places, job)?;
        alloc::extend(&mut self.corners, self.corner_places.iter().map(|triangle| triangle.map(|k| name(k as usize))))?;
        alloc::extend(&mut self.faces, self.corner_places.iter().map(|_| face))
    }
}

/// A mesh whose faces were split into triangles.
#[derive(Debug)]
pub struct TriangulatedMesh {
    /// The triangles; vertices as before.
    pub mesh: Mesh,
    /// For each corner of a triangle, the old corner.
    pub corners: Vec<u32>,
    /// For each triangle, the old face.
    pub faces: Vec<u32>,
}

/// Splits all faces of a mesh into triangles of their own corners, in the order of the faces.
/// Vertices keep their indices and bits. A merge map is kept.
///
/// O(H), and O(n log n) for a face of n corners that is not convex.
///
/// # Errors
/// [`Error::OutOfMemory`](gusset_base::Error::OutOfMemory),
/// [`Error::Cancelled`](gusset_base::Error::Cancelled).
pub fn triangulate(mesh: &MeshView<'_>, job: &Job<'_>) -> Result<TriangulatedMesh> {
    let split = FaceTriangles::with_half_edges(mesh, &job.sub_job(0.0, 0.8))?;
    job.step(0.8, STAGE)?;
    let (faces, count) = (mesh.faces(), mesh.positions().len());
    let mut positions = PositionBuffer::with_capacity(mesh.positions().scalar(), count)?;
    positions.append(mesh.positions(), 0..count)?;
    let corners = split.corners.as_flattened();
    let vertices = alloc::collect(corners.iter().map(|&h| faces.corner_vertex_before_merging(h)))?;
    let offsets = alloc::collect((0..split.corners.len() + 1).map(|t| 3 * t as u32))?;
    job.step(1.0, STAGE)?;
    let mut made = Mesh::new(positions, offsets, vertices);
    if faces.is_merged() {
        made.merge = alloc::collect((0..count).map(|v| faces.merged_vertex(v as u32)))?;
    }
    Ok(TriangulatedMesh { mesh: made, corners: alloc::copied(corners)?, faces: split.faces })
}

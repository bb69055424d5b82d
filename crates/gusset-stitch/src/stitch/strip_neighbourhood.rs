//! A strip and the old faces around it, for fairing and for intersection tests.

use super::strip::Strip;
use crate::intersect::{TriangleSoup, intersecting_pairs};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::{Aabb, bit_set::BitSet};
use gusset_base::job::Job;
use gusset_base::sort::sort_distinct;
use gusset_mesh::{FaceTriangles, Mesh, Scalar};

const STAGE: &str = "looking for intersections";

/// The strip and its surroundings, numbered as in the result: old vertices and faces, then new
/// ones.
pub(super) struct StripNeighbourhood<'a> {
    pub(super) combined_mesh: &'a Mesh,
    unit: f64,
    /// The number of old vertices.
    pub(super) old_vertex_count: u32,
    /// The corners of the strip's faces.
    strip: Vec<u32>,
    offsets: &'a [u32],
    /// The set of the rims' vertices.
    pub(super) rim: BitSet,
    /// The vertices at the ends of an open strip, in ascending order; they stay on their meridians.
    pub(super) end_vertices: Vec<u32>,
    /// The positions of the new vertices.
    pub(super) points: Vec<DVec3>,
}

impl<'a> StripNeighbourhood<'a> {
    pub(super) fn new(whole: &'a Mesh, strip: &'a Strip, unit: f64, points: Vec<DVec3>) -> Result<Self> {
        let base = whole.positions.len() as u32;
        let (a, b) = (&strip.a.vertices, &strip.b.vertices);
        let (n, rims) = (a.len(), a.len() + b.len());
        let name = |&k: &u32| match k as usize {
            k if k < n => a[k],
            k if k < rims => b[k - n],
            k => base + (k - rims) as u32,
        };
        let mut rim = BitSet::new(whole.positions.len())?;
        a.iter().chain(b).for_each(|&v| rim.insert(v));
        let mut ends = Vec::new();
        if !strip.a.closed {
            let columns = strip.meridians.len();
            let rows = strip.grid.matrix.chunks(columns);
            ends = alloc::gather(rows.flat_map(|row| [row[0], row[columns - 1]]).map(|k| name(&k)))?;
            ends.sort_unstable();
        }
        let corners = alloc::collect(strip.faces.corners.iter().map(name))?;
        Ok(StripNeighbourhood {
            combined_mesh: whole,
            unit,
            old_vertex_count: base,
            strip: corners,
            offsets: &strip.faces.offsets,
            rim,
            end_vertices: ends,
            points,
        })
    }

    /// Rounds the new vertices to the scalar type of the result.
    pub(super) fn round_new_vertices(&mut self) {
        if self.combined_mesh.positions.view().scalar() == Scalar::F32 {
            let unit = self.unit;
            self.points.iter_mut().for_each(|p| *p = (*p * unit).as_vec3().as_dvec3() / unit);
        }
    }

    pub(super) fn position(&self, v: u32) -> DVec3 {
        match v.checked_sub(self.old_vertex_count) {
            Some(k) => self.points[k as usize],
            None => self.combined_mesh.positions.get(v) / self.unit,
        }
    }

    /// Adds the triangles of a face.
    pub(super) fn append_face_triangles(
        &self,
        face: &[u32],
        number: u32,
        into: &mut FaceTriangles,
        job: &Job<'_>,
    ) -> Result<()> {
        into.append_face(face.len(), |k| self.position(face[k]), |k| face[k], number, job)
    }

    pub(super) fn strip_triangles(&self, job: &Job<'_>) -> Result<FaceTriangles> {
        let mut triangles = FaceTriangles::default();
        for (face, number) in self.offsets.windows(2).zip(self.combined_mesh.face_count() as u32..) {
            self.append_face_triangles(&self.strip[face[0] as usize..face[1] as usize], number, &mut triangles, job)?;
        }
        Ok(triangles)
    }

    /// Returns the old faces that `wanted` selects, as triangles.
    pub(super) fn old_triangles(&self, wanted: impl Fn(&[u32]) -> bool, job: &Job<'_>) -> Result<FaceTriangles> {
        let mut triangles = FaceTriangles::default();
        for (face, number) in self.combined_mesh.faces().zip(0..) {
            job.step_within_list(number as usize, STAGE)?;
            if wanted(face) {
                self.append_face_triangles(face, number, &mut triangles, &job.sub_job(0.0, 0.0))?;
            }
        }
        Ok(triangles)
    }

    /// Returns the old triangles whose boxes overlap the box of the strip, faired and `straight`.
    pub(super) fn old_triangles_nearby(&self, straight: &[DVec3], job: &Job<'_>) -> Result<FaceTriangles> {
        let rims = self.strip.iter().filter(|&&v| v < self.old_vertex_count).map(|&v| self.position(v));
        let new = self.points.iter().chain(straight).copied();
        let Aabb { low, high } = Aabb::from_points(rims.chain(new));
        // Enlarge the box in mesh coordinates: scaling by the unit, a power of two, may round tiny
        // coordinates to 0.
        let around = Aabb { low: low * self.unit, high: high * self.unit }.grown_by(f64::MIN_POSITIVE * self.unit);
        self.old_triangles(
            |face| Aabb::from_points(face.iter().map(|&v| self.combined_mesh.positions.get(v))).overlaps(&around),
            job,
        )
    }

    /// Returns the pairs of intersecting triangles, and the strip's triangles that they index.
    pub(super) fn find_intersections(&self, old: &FaceTriangles, job: &Job<'_>) -> Result<IntersectingTriangles> {
        let strip = self.strip_triangles(&job.sub_job(0.0, 0.0))?;
        let soup = TriangleSoup {
            position_of_vertex: |v| self.position(v),
            new_triangles: &strip.corners,
            old_triangles: &old.corners,
        };
        Ok(IntersectingTriangles { pairs: intersecting_pairs(&soup, job)?, strip })
    }

    /// Converts pairs of triangles to distinct pairs of faces. The face with the larger index comes
    /// first; faces of the strip have larger indices than old ones.
    pub(super) fn pairs_of_faces(&self, old: &FaceTriangles, found: &IntersectingTriangles) -> Result<Vec<[u32; 2]>> {
        let face = |k: u32| match (k as usize).checked_sub(found.strip.faces.len()) {
            Some(k) => old.faces[k],
            None => found.strip.faces[k as usize],
        };
        let mut faces = alloc::collect(found.pairs.iter().map(|&[p, q]| {
            let (f, g) = (face(p), face(q));
            [f.max(g), f.min(g)]
        }))?;
        // The two triangles of a quad may fold onto each other.
        sort_distinct(&mut faces);
        Ok(faces)
    }
}

pub(super) struct IntersectingTriangles {
    /// Numbers below the count of the strip's triangles belong to the strip, the others to the old
    /// triangles.
    pub(super) pairs: Vec<[u32; 2]>,
    pub(super) strip: FaceTriangles,
}

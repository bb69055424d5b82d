//! The polylines of a section.

use super::section_request::STAGE;
use crate::MAX_ELEMENTS;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::job::Job;
use std::ops::Range;

/// One polyline of a section.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SectionPath {
    /// The index of the plane.
    pub plane: u32,
    /// True if the polyline returns to its first point, which is not repeated.
    pub is_closed: bool,
    /// The smallest closed path of the same plane around this closed path, or [`NONE`](crate::NONE).
    pub parent: u32,
    /// The number of closed paths around this closed path; 0 for an open one.
    pub depth: u32,
    /// The length before simplification.
    pub length: f64,
    /// The area inside a closed path before simplification, positive if the path is
    /// counter-clockwise seen against the normal of the plane; 0 for an open path.
    pub area: f64,
}

/// The polylines in which planes meet a mesh. They are sorted by plane, then by their lowest face.
/// A path runs along the cross product of the plane's normal and the face's normal: the outer loop
/// of a solid is counter-clockwise seen against the normal of the plane.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Sections {
    pub(super) plane_count: usize,
    pub(super) paths: Vec<SectionPath>,
    /// Path k has the points `starts[k]` to `starts[k + 1]`.
    pub(super) starts: Vec<u32>,
    pub(super) points: Vec<DVec3>,
    pub(super) edges: Vec<[u32; 2]>,
    pub(super) parameters: Vec<f64>,
    pub(super) faces: Vec<u32>,
}

impl Sections {
    /// Returns the number of planes.
    pub fn plane_count(&self) -> usize {
        self.plane_count
    }

    /// Returns the polylines.
    pub fn paths(&self) -> &[SectionPath] {
        &self.paths
    }

    /// Returns the first point of each path, and the number of points at the end.
    pub fn starts(&self) -> &[u32] {
        &self.starts
    }

    /// Returns the range of a path's points.
    pub fn range(&self, path: usize) -> Range<usize> {
        self.starts[path] as usize..self.starts[path + 1] as usize
    }

    /// Returns all points, path by path.
    pub fn points(&self) -> &[DVec3] {
        &self.points
    }

    /// Returns for each point the two ends of its edge. Both are the same vertex if the vertex is
    /// in the plane.
    pub fn edges(&self) -> &[[u32; 2]] {
        &self.edges
    }

    /// Returns for each point its parameter on its edge: 0 at the first end, 1 at the second. It is
    /// 0 at a vertex.
    pub fn parameters(&self) -> &[f64] {
        &self.parameters
    }

    /// Returns for each point the face of the segment to the next point; [`NONE`](crate::NONE) at
    /// the end of an open path. A segment of a simplified path has the face of its first part.
    pub fn faces(&self) -> &[u32] {
        &self.faces
    }

    pub(super) fn empty(plane_count: usize) -> Result<Sections> {
        Ok(Sections { plane_count, starts: alloc::filled(0, 1)?, ..Sections::default() })
    }

    /// Appends the sections of the planes from `first_plane` on.
    fn append_sections(&mut self, first_plane: usize, part: &Sections) -> Result<()> {
        let (first_path, first_point) = (self.paths.len() as u32, self.points.len() as u64);
        Error::check_count("points of sections", first_point + part.points.len() as u64, MAX_ELEMENTS)?;
        alloc::extend(
            &mut self.paths,
            part.paths.iter().map(|path| SectionPath {
                plane: path.plane + first_plane as u32,
                parent: if path.parent == crate::NONE { path.parent } else { path.parent + first_path },
                ..*path
            }),
        )?;
        alloc::extend(&mut self.starts, part.starts[1..].iter().map(|start| start + first_point as u32))?;
        alloc::append(&mut self.points, &part.points)?;
        alloc::append(&mut self.edges, &part.edges)?;
        alloc::append(&mut self.parameters, &part.parameters)?;
        alloc::append(&mut self.faces, &part.faces)
    }

    /// Joins the sections of consecutive ranges of planes, which all have `planes_per_part` planes
    /// except the last.
    pub(super) fn from_parts(
        plane_count: usize,
        planes_per_part: usize,
        parts: &[Sections],
        job: &Job<'_>,
    ) -> Result<Sections> {
        let mut all = Sections::empty(plane_count)?;
        for (k, part) in parts.iter().enumerate() {
            job.step_within_heavy_list(64, k, STAGE)?;
            all.append_sections(k * planes_per_part, part)?;
        }
        Ok(all)
    }
}

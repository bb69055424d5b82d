//! Sections of polygon meshes by planes: ordered polylines with their nesting and their sources.
//!
//! - `cutting_planes`: planes, stacks of parallel planes, planes about an axis, planes across a
//!   polyline. `exact_plane`: the side of a point, decided exactly.
//! - `cut_stack`: the vertices sorted between the planes of a stack, and the faces that each plane
//!   crosses, found by a counting sort.
//! - `face_crossings`: the segments of a plane in its faces. `crossing_nodes`: the points where
//!   segments meet, and the pairs of segments that continue each other. `section_tracer`: the
//!   segments linked to polylines.
//! - `nesting_levels`: the loops around a loop. `simplify_polyline`: fewer points within a
//!   tolerance.
//!
//! **The rule for vertices in a plane.** A vertex in the plane counts as above it, or as below it
//! if the caller says so ([`InPlane`]). Every edge thus crosses the plane or does not, and every
//! face has an even number of crossings. A closed manifold therefore gives closed loops only. The
//! section is the limit of the sections below the plane (or above it):
//!
//! - A face in the plane gives nothing itself. Its edges appear where the neighbouring face lies
//!   below (above).
//! - A ridge in the plane, with both faces below, gives a loop that runs there and back.
//! - A peak in the plane gives nothing, because its loop is a single point.

mod cut_stack;
mod cutting_planes;
mod exact_plane;
mod face_crossings;
mod crossing_nodes;
mod nesting_levels;
mod section_tracer;
mod simplify_polyline;
#[cfg(test)]
mod section_tests;

use crate::{MAX_ELEMENTS, MeshView};
use cut_stack::StackCut;
pub use cutting_planes::{Plane, PlaneStack, planes_about_axis, planes_across_polyline};
use exact_plane::ExactPlane;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::job::Job;
use gusset_base::par;
use std::ops::Range;

/// The stage that progress reports name.
const STAGE: &str = "cutting by planes";

/// The side of a plane to which vertices in the plane belong.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum InPlane {
    /// They count as above: the section is the limit of sections below the plane.
    #[default]
    Above,
    /// They count as below: the section is the limit of sections above the plane.
    Below,
}

gusset_base::choices! { for InPlane:
    Above => "Above", "Vertices in a plane count as above it: the section is the limit of sections just below the plane.";
    Below => "Below", "Vertices in a plane count as below it: the section is the limit of sections just above the plane.";
}

/// The options of a section.
#[derive(Debug, Clone, Copy, Default)]
pub struct Options {
    /// The side of vertices in a plane.
    pub in_plane: InPlane,
    /// Points are left out while the polyline stays within this distance of them. 0 keeps all
    /// points.
    pub tolerance: f64,
}

impl Options {
    fn check(&self) -> Result<()> {
        Error::require(self.tolerance >= 0.0 && self.tolerance.is_finite(), "tolerance", self.tolerance)
    }
}

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
    plane_count: usize,
    paths: Vec<SectionPath>,
    /// Path k has the points `starts[k]` to `starts[k + 1]`.
    starts: Vec<u32>,
    points: Vec<DVec3>,
    edges: Vec<[u32; 2]>,
    parameters: Vec<f64>,
    faces: Vec<u32>,
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

    fn empty(plane_count: usize) -> Result<Sections> {
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
    fn from_parts(plane_count: usize, planes_per_part: usize, parts: &[Sections], job: &Job<'_>) -> Result<Sections> {
        let mut all = Sections::empty(plane_count)?;
        for (k, part) in parts.iter().enumerate() {
            job.step_within_heavy_list(64, k, STAGE)?;
            all.append_sections(k * planes_per_part, part)?;
        }
        Ok(all)
    }
}

/// Cuts a mesh by a stack of parallel planes. Takes O(V log n + H + s log s) for n planes and s
/// segments, on the job's threads.
///
/// # Errors
/// [`Error::OptionOutOfRange`] if the normal is 0, the offsets do not ascend, or a number is out of
/// range; [`Error::CoordinateTooLarge`] for a vertex beyond 1e150; [`Error::TooLarge`],
/// [`Error::OutOfMemory`], [`Error::Cancelled`].
pub fn cut_by_stack(mesh: &MeshView<'_>, stack: &PlaneStack<'_>, options: &Options, job: &Job<'_>) -> Result<Sections> {
    options.check()?;
    cutting_planes::check_stack(stack)?;
    let plane = ExactPlane::new(stack.point, stack.normal)?;
    let levels = alloc::collect(stack.offsets.iter().map(|offset| plane.scaled_level(*offset)))?;
    let cut = StackCut::new(mesh, &plane, &levels, options.in_plane, &job.sub_job(0.0, 0.5))?;
    // Many planes of few faces share one work item.
    let planes_per_part = levels.len().div_ceil(256).max(1);
    let ranges = par::split_into_ranges(levels.len(), planes_per_part);
    let trace = |planes: Range<usize>, job: &Job<'_>| section_tracer::trace_planes(mesh, &cut, planes, options, job);
    let parts = par::map_jobs(&job.sub_job(0.5, 0.95), STAGE, ranges, trace)?;
    Sections::from_parts(levels.len(), planes_per_part, &parts, &job.sub_job(0.95, 1.0))
}

/// Cuts a mesh by planes in any positions. Takes O(n (V + H) + s log s) for n planes and s segments,
/// on the job's threads.
///
/// # Errors
/// [`Error::OptionOutOfRange`] if a plane lacks a normal or is not finite; else the errors of
/// [`cut_by_stack`].
pub fn cut_by_planes(mesh: &MeshView<'_>, planes: &[Plane], options: &Options, job: &Job<'_>) -> Result<Sections> {
    options.check()?;
    Error::check_count("planes", planes.len() as u64, cut_stack::MAX_PLANES)?;
    planes.iter().try_for_each(Plane::check)?;
    let cut = |plane: &Plane, job: &Job<'_>| {
        let stack = PlaneStack { point: plane.point, normal: plane.normal, offsets: &[0.0] };
        cut_by_stack(mesh, &stack, options, job)
    };
    let parts = match planes {
        // A single plane uses all threads.
        [plane] => vec![cut(plane, &job.sub_job(0.0, 0.95))?],
        planes => par::map_jobs(&job.sub_job(0.0, 0.95), STAGE, planes.iter(), cut)?,
    };
    Sections::from_parts(planes.len(), 1, &parts, &job.sub_job(0.95, 1.0))
}

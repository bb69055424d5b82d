//! The cuts of a mesh by one plane or many.

use super::cut_stack::{MAX_PLANES, StackCut};
use super::cutting_planes::{Plane, PlaneStack, check_stack};
use super::exact_plane::ExactPlane;
use super::section_request::{Options, STAGE};
use super::section_tracer;
use super::sections::Sections;
use crate::MeshView;
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::job::Job;
use gusset_base::par;
use std::ops::Range;

/// Cuts a mesh by a stack of parallel planes. Takes O(V log n + H + s log s) for n planes and s
/// segments, on the job's threads.
///
/// # Errors
/// [`Error::OptionOutOfRange`] if the normal is 0, the offsets do not ascend, or a number is out of
/// range; [`Error::CoordinateTooLarge`] for a vertex beyond 1e150; [`Error::TooLarge`],
/// [`Error::OutOfMemory`], [`Error::Cancelled`].
pub fn cut_by_stack(mesh: &MeshView<'_>, stack: &PlaneStack<'_>, options: &Options, job: &Job<'_>) -> Result<Sections> {
    options.check()?;
    check_stack(stack)?;
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
    Error::check_count("planes", planes.len() as u64, MAX_PLANES)?;
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

//! The segments of each plane, linked to polylines.

use super::crossing_nodes::CrossingNodes;
use super::cut_stack::StackCut;
use super::face_crossings::FaceCrossings;
use super::nesting_levels::nest_loops;
use super::section_request::{Options, STAGE};
use super::sections::{SectionPath, Sections};
use super::simplify_polyline::PolylineSimplifier;
use crate::{MAX_ELEMENTS, MeshView, NONE};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::job::Job;
use std::ops::Range;

/// Traces the polylines of consecutive planes. The planes of the result count from the first.
pub(super) fn trace_planes(
    mesh: &MeshView<'_>,
    cut: &StackCut<'_>,
    planes: Range<usize>,
    options: &Options,
    job: &Job<'_>,
) -> Result<Sections> {
    let mut sections = Sections::empty(planes.len())?;
    let (mut segments, mut nodes) = (FaceCrossings::default(), CrossingNodes::default());
    let mut simplifier = PolylineSimplifier::new(options.tolerance);
    for plane in planes.clone() {
        let job = job.sub_job_of_item(plane - planes.start, planes.len());
        job.step(0.0, STAGE)?;
        segments.find_segments(mesh, cut, plane, &job)?;
        nodes.link_ends(mesh, cut, plane, &mut segments, &job)?;
        let first_path = sections.paths.len();
        sections.trace_paths(&segments, &nodes, (plane - planes.start) as u32, &job)?;
        nest_loops(&mut sections, first_path, cut.plane.unit_normal(), &job)?;
        if options.tolerance > 0.0 {
            simplifier.simplify_paths(&mut sections, first_path, &job)?;
        }
    }
    Ok(sections)
}

impl Sections {
    /// Appends the paths of one plane, in the order of their first segments.
    fn trace_paths(
        &mut self,
        segments: &FaceCrossings,
        nodes: &CrossingNodes,
        plane: u32,
        job: &Job<'_>,
    ) -> Result<()> {
        let count = segments.faces.len();
        let mut is_traced = alloc::filled(false, count)?;
        for segment in 0..count {
            job.step_within_heavy_list(4, segment, STAGE)?;
            if is_traced[segment] {
                continue;
            }
            let (start, is_closed) = find_path_start(nodes, 2 * segment as u32, job)?;
            self.append_path(segments, nodes, start, &mut is_traced, job)?;
            self.close_path(plane, is_closed)?;
        }
        Ok(())
    }

    /// Appends the points of the path that begins at the end `start` of a segment. Points at one
    /// vertex follow each other where the path turns round a vertex in the plane: only the first
    /// one is kept.
    fn append_path(
        &mut self,
        segments: &FaceCrossings,
        nodes: &CrossingNodes,
        start: u32,
        is_traced: &mut [bool],
        job: &Job<'_>,
    ) -> Result<()> {
        let mut end = start;
        let mut last_vertex = None;
        for k in 0.. {
            job.step_within_heavy_list(4, k, STAGE)?;
            let (segment, node) = ((end / 2) as usize, nodes.node_of_end[end as usize]);
            is_traced[segment] = true;
            self.append_point(nodes, node, segments.faces[segment], &mut last_vertex)?;
            let far = end ^ 1;
            match nodes.partner_of_end[far as usize] {
                NONE => return self.append_point(nodes, nodes.node_of_end[far as usize], NONE, &mut last_vertex),
                next if next == start => return Ok(()),
                next => end = next,
            }
        }
        Ok(())
    }

    /// Appends a point and the face after it, or only replaces the face if the last point is at the
    /// same vertex.
    fn append_point(
        &mut self,
        nodes: &CrossingNodes,
        node: u32,
        face: u32,
        last_vertex: &mut Option<u32>,
    ) -> Result<()> {
        let placed = nodes.points[node as usize];
        if placed.vertex().is_some() && placed.vertex() == *last_vertex {
            if let Some(last) = self.faces.last_mut() {
                *last = face;
            }
            return Ok(());
        }
        *last_vertex = placed.vertex();
        alloc::push(&mut self.points, placed.point)?;
        alloc::push(&mut self.edges, placed.edge)?;
        alloc::push(&mut self.parameters, placed.parameter)?;
        alloc::push(&mut self.faces, face)
    }

    /// Ends the path of the points after the last path. Drops a path of a single point: there the
    /// plane touches the mesh.
    fn close_path(&mut self, plane: u32, is_closed: bool) -> Result<()> {
        let first = self.starts.last().map_or(0, |&start| start as usize);
        let last = self.points.len() - 1;
        let is_at_vertex = self.edges[last][0] == self.edges[last][1];
        if is_closed && last > first && is_at_vertex && self.edges[last] == self.edges[first] {
            self.truncate_points(last);
        }
        if self.points.len() - first < 2 {
            self.truncate_points(first);
            return Ok(());
        }
        Error::check_count("points of sections", self.points.len() as u64, MAX_ELEMENTS)?;
        let length = measure_length(&self.points[first..], is_closed);
        let path = SectionPath { plane, is_closed, parent: NONE, depth: 0, length, area: 0.0 };
        alloc::push(&mut self.paths, path)?;
        alloc::push(&mut self.starts, self.points.len() as u32)
    }

    pub(super) fn truncate_points(&mut self, count: usize) {
        self.points.truncate(count);
        self.edges.truncate(count);
        self.parameters.truncate(count);
        self.faces.truncate(count);
    }
}

/// Returns the end at which the path through a segment begins, and true if the path is closed. A
/// closed path begins at the given end.
fn find_path_start(nodes: &CrossingNodes, given: u32, job: &Job<'_>) -> Result<(u32, bool)> {
    let mut end = given;
    for k in 0.. {
        job.step_within_heavy_list(4, k, STAGE)?;
        match nodes.partner_of_end[end as usize] {
            NONE => return Ok((end, false)),
            before if before ^ 1 == given => return Ok((given, true)),
            before => end = before ^ 1,
        }
    }
    Ok((given, true))
}

fn measure_length(points: &[DVec3], is_closed: bool) -> f64 {
    let open: f64 = points.windows(2).map(|pair| pair[0].distance(pair[1])).sum();
    match points {
        [first, .., last] if is_closed => open + last.distance(*first),
        _ => open,
    }
}

//! The segments of a plane in its faces.
//!
//! A segment begins where the face's border passes from above to below, and ends where it passes
//! from below to above. It then runs along the cross product of the plane's normal and the face's
//! normal. Segment s has the ends 2 s and 2 s + 1.

use super::cut_stack::StackCut;
use super::section_request::STAGE;
use crate::MeshView;
use crate::topology::{half_edges, unordered};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;

/// The segments of one plane. The memory serves plane after plane.
#[derive(Default)]
pub(super) struct FaceCrossings {
    /// By segment: its face.
    pub(super) faces: Vec<u32>,
    /// By end: the edge, packed as [`unordered`], and the number of the end.
    pub(super) edge_of_end: Vec<(u64, u32)>,
    /// The crossings of one face.
    crossings: Vec<Crossing>,
}

/// A place where the border of a face crosses the plane.
#[derive(Clone, Copy)]
struct Crossing {
    edge: u64,
    /// True if the border passes from above to below.
    begins_segment: bool,
    /// The place along the line in which the plane meets the face.
    place_along_line: f64,
}

impl FaceCrossings {
    /// Finds the segments of a plane.
    pub(super) fn find_segments(
        &mut self,
        mesh: &MeshView<'_>,
        cut: &StackCut<'_>,
        plane: usize,
        job: &Job<'_>,
    ) -> Result<()> {
        let faces = cut.faces_across_plane(plane);
        self.faces.clear();
        self.edge_of_end.clear();
        alloc::reserve(&mut self.faces, faces.len())?;
        alloc::reserve(&mut self.edge_of_end, 2 * faces.len())?;
        for (k, &face) in faces.iter().enumerate() {
            job.step_within_heavy_list(4, k, STAGE)?;
            self.crossings.clear();
            for (_, u, v) in half_edges(mesh, face as usize) {
                let begins_segment = cut.is_above(u, plane);
                if begins_segment != cut.is_above(v, plane) {
                    let crossing = Crossing { edge: unordered([u, v]), begins_segment, place_along_line: 0.0 };
                    alloc::push(&mut self.crossings, crossing)?;
                }
            }
            if self.crossings.len() > 2 {
                self.sort_crossings_along_face(mesh, cut, plane, face);
            }
            for k in (0..self.crossings.len()).step_by(2) {
                let [first, second] = [self.crossings[k], self.crossings[k + 1]];
                let is_turned = !first.begins_segment && second.begins_segment;
                let [from, to] = if is_turned { [second, first] } else { [first, second] };
                let end = 2 * self.faces.len() as u32;
                alloc::push(&mut self.faces, face)?;
                alloc::push(&mut self.edge_of_end, (from.edge, end))?;
                alloc::push(&mut self.edge_of_end, (to.edge, end + 1))?;
            }
        }
        Ok(())
    }

    /// Sorts the crossings of a face that is not convex along the line in which the plane meets it,
    /// so that consecutive pairs bound segments inside the face.
    #[cold]
    fn sort_crossings_along_face(&mut self, mesh: &MeshView<'_>, cut: &StackCut<'_>, plane: usize, face: u32) {
        let position = |v: u32| mesh.positions().get(v);
        // Newell's normal, relative to the first corner.
        let first = half_edges(mesh, face as usize).next().map_or(DVec3::ZERO, |(_, u, _)| position(u));
        let normal: DVec3 =
            half_edges(mesh, face as usize).map(|(_, u, v)| (position(u) - first).cross(position(v) - first)).sum();
        let along = cut.plane.unit_normal().cross(normal);
        let scale = along.abs().max_element();
        // A face parallel to the plane has no line.
        let along = if scale > 0.0 { along / scale } else { along };
        for crossing in &mut self.crossings {
            crossing.place_along_line = cut.place_point(mesh, plane, crossing.edge).point.dot(along);
        }
        gusset_base::sort::sort_stable(&mut self.crossings, &|a, b| a.place_along_line.total_cmp(&b.place_along_line));
    }
}

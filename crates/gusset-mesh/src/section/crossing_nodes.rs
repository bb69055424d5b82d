//! The points where segments meet, and the pairs of segments that continue each other.
//!
//! A node is a crossed edge. Two segments at a node continue each other. One segment ends there: the
//! edge is on a border. At an edge with more faces, segments are paired around the node so that
//! paths touch but do not cross: the inside of a solid is to the left of its segments, and the two
//! segments that bound one sector of the inside continue each other.

use super::cut_stack::StackCut;
use super::face_crossings::FaceCrossings;
use super::section_request::STAGE;
use crate::{MeshView, NONE};
use glam::{DVec2, DVec3};
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_base::sort::sort;

/// A point of a section.
#[derive(Clone, Copy)]
pub(super) struct SectionPoint {
    pub(super) point: DVec3,
    /// The ends of its edge, or a vertex in the plane twice.
    pub(super) edge: [u32; 2],
    pub(super) parameter: f64,
}

impl SectionPoint {
    /// Returns the vertex of a point at a vertex.
    pub(super) fn vertex(&self) -> Option<u32> {
        (self.edge[0] == self.edge[1]).then_some(self.edge[0])
    }
}

impl StackCut<'_> {
    /// Returns the point in which a plane meets an edge that it crosses.
    pub(super) fn place_point(&self, mesh: &MeshView<'_>, plane: usize, edge: u64) -> SectionPoint {
        let edge = [(edge >> 32) as u32, edge as u32];
        if let Some(v) = edge.into_iter().find(|&v| self.is_in_plane(v, plane)) {
            return SectionPoint { point: mesh.positions().get(v), edge: [v, v], parameter: 0.0 };
        }
        let [a, b] = edge.map(|v| mesh.positions().get(v));
        let [da, db] = [a, b].map(|p| self.plane.distance(p, self.levels[plane]));
        // The distances have opposite signs, unless they underflow. Each share is accurate where it is
        // small.
        let [to_b, to_a] = if da == db { [0.5, 0.5] } else { [da / (da - db), db / (db - da)] };
        let point = if to_b <= 0.5 { a + (b - a) * to_b } else { b + (a - b) * to_a };
        SectionPoint { point, edge, parameter: to_b.clamp(0.0, 1.0) }
    }
}

/// The nodes of one plane. The memory serves plane after plane.
#[derive(Default)]
pub(super) struct CrossingNodes {
    /// By node.
    pub(super) points: Vec<SectionPoint>,
    /// By end of a segment: its node.
    pub(super) node_of_end: Vec<u32>,
    /// By end: the end of the segment that continues it, or [`NONE`].
    pub(super) partner_of_end: Vec<u32>,
}

impl CrossingNodes {
    /// Finds the nodes and partners of all ends. Sorts the ends of `segments` by edge.
    pub(super) fn link_ends(
        &mut self,
        mesh: &MeshView<'_>,
        cut: &StackCut<'_>,
        plane: usize,
        segments: &mut FaceCrossings,
        job: &Job<'_>,
    ) -> Result<()> {
        let ends = &mut segments.edge_of_end;
        sort(ends, Ord::cmp, job, STAGE)?;
        self.points.clear();
        alloc::reserve(&mut self.points, ends.len() / 2)?;
        alloc::reset(&mut self.node_of_end, ends.len(), 0)?;
        alloc::reset(&mut self.partner_of_end, ends.len(), NONE)?;
        let mut crowded: Vec<(usize, usize)> = Vec::new();
        let mut start = 0;
        for at_node in ends.chunk_by(|(e, _), (f, _)| e == f) {
            let node = self.points.len() as u32;
            job.step_within_heavy_list(4, node as usize, STAGE)?;
            alloc::push(&mut self.points, cut.place_point(mesh, plane, at_node[0].0))?;
            at_node.iter().for_each(|&(_, end)| self.node_of_end[end as usize] = node);
            match *at_node {
                [_] => {}
                [(_, e), (_, f)] => self.join_ends(e, f),
                _ => alloc::push(&mut crowded, (start, start + at_node.len()))?,
            }
            start += at_node.len();
        }
        let (u, v) = cut.plane.unit_normal().any_orthonormal_pair();
        for (k, &(first, end)) in crowded.iter().enumerate() {
            job.step_within_heavy_list(64, k, STAGE)?;
            let around = alloc::collect(
                segments.edge_of_end[first..end].iter().map(|&(_, end)| self.find_ray_of_end(end, u, v)),
            )?;
            self.pair_around_node(around)?;
        }
        Ok(())
    }

    fn join_ends(&mut self, e: u32, f: u32) {
        self.partner_of_end[e as usize] = f;
        self.partner_of_end[f as usize] = e;
    }

    /// Returns the direction of a segment seen from its end: an angle about the normal.
    fn find_ray_of_end(&self, end: u32, u: DVec3, v: DVec3) -> (f64, u32) {
        let [here, there] = [end, end ^ 1].map(|end| self.points[self.node_of_end[end as usize] as usize].point);
        let along = DVec2::new((there - here).dot(u), (there - here).dot(v));
        (libm::atan2(along.y, along.x), end)
    }

    /// Pairs the segments at an edge with more than two faces. A segment that leaves the node and
    /// the next one counter-clockwise that arrives there bound a sector of the inside.
    fn pair_around_node(&mut self, mut around: Vec<(f64, u32)>) -> Result<()> {
        let arrives = |end: u32| end % 2 == 1;
        // The segment that arrives comes first in a direction: it closes the sector before.
        around.sort_unstable_by(|(a, e), (b, f)| a.total_cmp(b).then(arrives(*f).cmp(&arrives(*e))).then(e.cmp(f)));
        let mut leaving: Vec<u32> = alloc::with_capacity(around.len())?;
        for &(_, end) in &around {
            if !arrives(end) {
                leaving.push(end);
            } else if let Some(open) = leaving.pop() {
                self.join_ends(open, end);
            }
        }
        // The second round closes the sectors that contain the direction of angle 0.
        for &(_, end) in &around {
            if arrives(end)
                && self.partner_of_end[end as usize] == NONE
                && let Some(open) = leaving.pop()
            {
                self.join_ends(open, end);
            }
        }
        // Faces that disagree in orientation leave ends of one kind: neighbours continue each
        // other.
        around.retain(|&(_, end)| self.partner_of_end[end as usize] == NONE);
        around.chunks_exact(2).for_each(|pair| self.join_ends(pair[0].1, pair[1].1));
        Ok(())
    }
}

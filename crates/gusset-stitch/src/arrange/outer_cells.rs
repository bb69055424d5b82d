//! The cell outside each connected component of an arrangement, and the winding number there.

use super::exact_arrangement::ExactArrangement;
use super::exact_points::{ExactPoints, Plane, orientation_along};
use super::face_groups::{EdgeOrder, FaceGroups, HalfPlane};
use super::wide_int::dot;
use glam::DVec3;
use gusset_base::NONE;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::Aabb;
use gusset_base::geom::box_tree::{BoxTree, spatial_order};
use gusset_base::geom::disjoint_sets::DisjointSets;
use gusset_base::job::Job;

const STAGE: &str = "computing winding numbers";
/// Number of triangles in a leaf of the tree.
const MAX_LEAF_TRIANGLES: usize = 4;
const RAYS_PER_REPORT: usize = 1 << 6;

/// The components of an arrangement: distinct triangles that are connected by common edges.
pub(super) struct OuterCells<'a> {
    arrangement: &'a ExactArrangement,
    groups: &'a FaceGroups,
    triangles: &'a [[u32; 3]],
    /// The component of each distinct triangle.
    components: Vec<u32>,
}

/// An edge of a component with nothing of the component on one side of a plane through it, and the
/// side of a triangle there.
struct OuterEdge {
    ends: [u32; 2],
    side: u32,
    component: u32,
}

impl<'a> OuterCells<'a> {
    pub(super) fn new(
        arrangement: &'a ExactArrangement,
        groups: &'a FaceGroups,
        triangles: &'a [[u32; 3]],
    ) -> Result<Self> {
        let mut sets = DisjointSets::new(groups.corners.len())?;
        for edge in groups.edges() {
            edge.windows(2).for_each(|pair| _ = sets.union(pair[0][2] / 3, pair[1][2] / 3));
        }
        let components = sets.into_roots(&Job::default(), STAGE)?;
        Ok(OuterCells { arrangement, groups, triangles, components })
    }

    /// Returns for each component a side in the cell outside it, and the winding number there.
    pub(super) fn find(&self, job: &Job<'_>) -> Result<Vec<(u32, i32)>> {
        let points = &self.arrangement.points;
        let count = self.groups.corners.len();
        let component = |half_edge: u32| self.components[half_edge as usize / 3] as usize;
        // The last vertex of each component in the order of points.
        let mut last = alloc::filled(NONE, count)?;
        for (group, corners) in self.groups.corners.iter().enumerate() {
            for &p in corners {
                let held = &mut last[self.components[group] as usize];
                if *held == NONE || (*held != p && points.compare(p, *held).is_gt()) {
                    *held = p;
                }
            }
        }
        // The edge at it whose projection along z is the first clockwise. The vertical plane through
        // it has all triangles at the vertex on its left or on it, so its right is outside.
        let mut ends = alloc::filled(NONE, count)?;
        let mut edges = alloc::filled([0usize; 2], count)?;
        let mut place = 0;
        for edge in self.groups.edges() {
            let [p, q, half_edge] = edge[0];
            let range = [place, place + edge.len()];
            place = range[1];
            let apex = last[component(half_edge)];
            let end = if p == apex { q } else { p };
            if (p != apex && q != apex)
                || (points.compare_along(0, p, q).is_eq() && points.compare_along(1, p, q).is_eq())
            {
                continue;
            }
            let held = &mut ends[component(half_edge)];
            if *held == NONE || points.orientation(2, [apex, *held, end]) < 0 {
                *held = end;
                edges[component(half_edge)] = range;
            }
        }
        let mut outer = Vec::new();
        for k in (0..count).filter(|&k| ends[k] != NONE) {
            let [start, stop] = edges[k];
            let side = self.outer_side(last[k], ends[k], &self.groups.half_edges[start..stop]);
            alloc::push(&mut outer, OuterEdge { ends: [last[k], ends[k]], side, component: k as u32 })?;
        }
        let numbers = self.windings_of_others(&outer, job)?;
        alloc::collect(outer.iter().zip(numbers).map(|(edge, number)| (edge.side, number)))
    }

    /// Returns the side that faces outside at an edge that [`find`](Self::find) chose.
    fn outer_side(&self, apex: u32, end: u32, edge: &[[u32; 3]]) -> u32 {
        let order = EdgeOrder::new(self.arrangement, apex, end);
        let points = &self.arrangement.points;
        // The direction d of the edge, and the horizontal direction m = (d_y, -d_x) to its right.
        let [dx, dy] = [0, 1].map(|k| points.compare_along(k, end, apex) as i32);
        let is_opposed = |u: &HalfPlane| {
            let along = if dy != 0 { u.normal[0].sign() * dy } else { -u.normal[1].sign() * dx };
            along < 0
        };
        let mut first: Option<HalfPlane> = None;
        for &[_, _, h] in edge {
            let plane = EdgeOrder::half_plane(self.arrangement, self.groups, h, apex, self.triangles);
            // All half-planes are from a quarter turn to three quarters of a turn after m.
            let is_first = first.as_ref().is_none_or(|held| match order.turn(&plane, held) {
                0 => dot(&plane.normal, &held.normal).sign() < 0 && is_opposed(&plane),
                turn => turn > 0,
            });
            if is_first {
                first = Some(plane);
            }
        }
        first.map_or(0, |plane| self.groups.sides(plane.half_edge, apex)[1])
    }

    /// Returns the winding number of all other components at the midpoint of each edge, which lies on
    /// none of them. Rays are moved sideways by an infinitesimal.
    fn windings_of_others(&self, outer: &[OuterEdge], job: &Job<'_>) -> Result<Vec<i32>> {
        let mut numbers = alloc::filled(0, outer.len())?;
        if outer.len() < 2 {
            return Ok(numbers);
        }
        // Given triangles with their components.
        let mut owners = alloc::filled(NONE, self.triangles.len())?;
        for (group, &component) in self.components.iter().enumerate() {
            for &part in self.groups.parts_of_group.get(group) {
                owners[self.arrangement.parts[part as usize].1 as usize] = component;
            }
        }
        let solid = alloc::gather((0..self.triangles.len()).filter(|&t| owners[t] != NONE))?;
        let vertices = |t: usize| self.triangles[t].map(|v| self.arrangement.first_vertex_at_position[v as usize]);
        let corners = |t: usize| vertices(t).map(|v| self.arrangement.points.rounded(v));
        let boxes = alloc::collect(solid.iter().map(|&t| Aabb::from_points(corners(t))))?;
        let order = spatial_order(&boxes, MAX_LEAF_TRIANGLES, &job.sub_job(0.0, 0.5), STAGE)?;
        let leaves = order.chunks(MAX_LEAF_TRIANGLES);
        let around = |leaf: &[u32]| leaf.iter().fold(Aabb::EMPTY, |whole, &k| whole.union(boxes[k as usize]));
        let tree = BoxTree::new_cancellable(leaves.map(around), &job.sub_job(0.5, 0.5), STAGE)?;
        let size = boxes.iter().fold(Aabb::EMPTY, |whole, b| whole.union(*b)).size();
        let axis = (0..3).min_by(|&j, &k| size[j].total_cmp(&size[k])).unwrap_or(0);
        let mut points = ExactPoints::extending(&self.arrangement.points);
        for (k, (edge, number)) in outer.iter().zip(&mut numbers).enumerate() {
            job.sub_job(0.5, 1.0).step_every(RAYS_PER_REPORT, k, outer.len(), STAGE)?;
            let [p, q] = edge.ends;
            let from = points.push(&self.arrangement.points.midpoint(p, q))?;
            // The point lies within half a unit in the last place.
            let near = points.rounded(from).to_array();
            let mut ray = Aabb {
                low: DVec3::from_array(near.map(f64::next_down)),
                high: DVec3::from_array(near.map(f64::next_up)),
            };
            ray.high[axis] = f64::INFINITY;
            tree.visit_overlapping(&ray, 0.0, |leaf| {
                for &place in order[MAX_LEAF_TRIANGLES * leaf..].iter().take(MAX_LEAF_TRIANGLES) {
                    let t = solid[place as usize];
                    if owners[t] != edge.component && boxes[place as usize].overlaps(&ray) {
                        *number += crossing(&points, from, axis, vertices(t));
                    }
                }
                Ok(())
            })?;
        }
        Ok(numbers)
    }
}

/// Returns the change of the winding number where a ray from a point in the positive direction of an
/// axis crosses a triangle from above to below: 1, -1, or 0 if it does not cross. The ray is moved
/// sideways by an infinitesimal.
fn crossing(points: &ExactPoints<'_>, from: u32, axis: usize, [a, b, c]: [u32; 3]) -> i32 {
    let up = (axis + 2) % 3;
    let has_on_left = |p: u32, q: u32| {
        let [low, high] = if points.compare_along(up, p, q).is_le() { [p, q] } else { [q, p] };
        points.compare_along(up, low, from).is_le()
            && points.compare_along(up, from, high).is_lt()
            && points.orientation(axis, [low, high, from]) > 0
    };
    if !(has_on_left(a, b) ^ has_on_left(b, c) ^ has_on_left(c, a)) {
        return 0;
    }
    let corners = [a, b, c].map(|v| points.rounded(v));
    let [p, q, r] = corners;
    let area = orientation_along(axis, p, q, r);
    // The point is below if it lies on the side opposite to the axis.
    if points.side_of(&Plane::from_triangle(corners), from) * area < 0 { area } else { 0 }
}

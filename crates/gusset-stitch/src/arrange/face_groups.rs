//! The distinct triangles of an arrangement, their edges, and the order of triangles around an edge.

use super::exact_arrangement::ExactArrangement;
use super::exact_points::Plane;
use super::wide_int::{WideInt, WideVec, cross_component, dot};
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_base::sort::{Buckets, sort, sort_by_bucket};
use std::cmp::Ordering;

const STAGE: &str = "computing winding numbers";

/// The distinct triangles of an arrangement.
pub(super) struct FaceGroups {
    /// The corners of each distinct triangle, as its first part passes them.
    pub(super) corners: Vec<[u32; 3]>,
    /// The number of parts that are oriented like the corners, less the number of others.
    pub(super) multiplicities: Vec<i32>,
    /// The parts of each distinct triangle, in ascending order.
    pub(super) parts_of_group: Buckets<u32>,
    /// The sides of the distinct triangles: the smaller and the larger end, and the half-edge. Half-edge
    /// 3 g + k leads from corner k of triangle g to the next. In ascending order.
    pub(super) half_edges: Vec<[u32; 3]>,
}

fn sorted(mut t: [u32; 3]) -> [u32; 3] {
    t.sort_unstable();
    t
}

/// Returns true if the triangles pass their common corners in the same direction.
pub(super) fn are_oriented_alike(s: [u32; 3], t: [u32; 3]) -> bool {
    (0..3).any(|k| s == [t[k], t[(k + 1) % 3], t[(k + 2) % 3]])
}

impl FaceGroups {
    pub(super) fn new(arrangement: &ExactArrangement, job: &Job<'_>) -> Result<FaceGroups> {
        let parts = &arrangement.parts;
        let part = |i: u32| parts[i as usize].0;
        let mut keys = alloc::collect_cancellable(
            parts.iter().enumerate().map(|(i, &(t, _))| (sorted(t), i as u32)),
            &job.sub_job(0.0, 0.1),
            STAGE,
        )?;
        sort(&mut keys, Ord::cmp, &job.sub_job(0.1, 0.4), STAGE)?;
        // Groups in the order of their first parts.
        let mut firsts = alloc::filled(0u32, parts.len())?;
        for same in keys.chunk_by(|a, b| a.0 == b.0) {
            same.iter().for_each(|&(_, i)| firsts[i as usize] = same[0].1);
        }
        let mut numbers = alloc::filled(0u32, parts.len())?;
        let mut corners = Vec::new();
        for (i, &first) in (0..).zip(&firsts) {
            if i == first {
                numbers[i as usize] = corners.len() as u32;
                alloc::push(&mut corners, part(i))?;
            } else {
                numbers[i as usize] = numbers[first as usize];
            }
        }
        let mut multiplicities = alloc::filled(0, corners.len())?;
        for (&(t, _), &group) in parts.iter().zip(&numbers) {
            multiplicities[group as usize] += if are_oriented_alike(t, corners[group as usize]) { 1 } else { -1 };
        }
        let grouped = numbers.iter().map(|&group| group as usize).zip(0..);
        let members = Buckets::new_cancellable(corners.len(), 0, grouped, &job.sub_job(0.4, 0.5), STAGE)?;
        let sides = corners.iter().flat_map(|t| [[t[0], t[1]], [t[1], t[2]], [t[2], t[0]]]);
        let mut half_edges = alloc::gather(sides.zip(0..).map(|([p, q], h)| [p.min(q), p.max(q), h]))?;
        job.step(0.5, STAGE)?;
        sort_by_bucket(&mut half_edges, arrangement.points.end() as usize, |edge| edge[0])?;
        Ok(FaceGroups { corners, multiplicities, parts_of_group: members, half_edges })
    }

    /// Returns the half-edges of each edge.
    pub(super) fn edges(&self) -> impl Iterator<Item = &[[u32; 3]]> {
        self.half_edges.chunk_by(|a, b| a[..2] == b[..2])
    }

    /// Returns true if a half-edge begins at a point.
    pub(super) fn begins_at(&self, h: u32, p: u32) -> bool {
        self.corners[h as usize / 3][h as usize % 3] == p
    }

    /// Returns the two sides of a half-edge's triangle: the one that follows its half-plane
    /// counter-clockwise around the edge from a point on, and the one that precedes it. Side 2 g is the
    /// front of triangle g, to which its normal points, and 2 g + 1 its back.
    pub(super) fn sides(&self, half_edge: u32, from: u32) -> [u32; 2] {
        let front = 2 * (half_edge / 3);
        if self.begins_at(half_edge, from) { [front, front + 1] } else { [front + 1, front] }
    }

    /// Returns the given triangle of the first part of a group.
    fn origin(&self, arrangement: &ExactArrangement, group: u32) -> u32 {
        let first = self.parts_of_group.get(group as usize).first();
        first.map_or(0, |&part| arrangement.parts[part as usize].1)
    }
}

/// The half-planes of triangles around the line from a point to another.
///
/// The half-plane of a triangle is h = u x d, where d is the direction of the line and u the normal of
/// the triangle, if its half-edge has the direction d, or else the opposite. Beside the half-plane,
/// counter-clockwise around d, is the side of the triangle to which u points.
pub(super) struct EdgeOrder {
    /// A coordinate in which the two points differ.
    axis: usize,
    /// The sign of d along this coordinate.
    direction: i32,
}

/// A half-edge with the vector u of its half-plane.
pub(super) struct HalfPlane {
    pub(super) half_edge: u32,
    pub(super) normal: WideVec,
}

impl EdgeOrder {
    pub(super) fn new(arrangement: &ExactArrangement, from: u32, to: u32) -> EdgeOrder {
        let along = (0..3).map(|k| (k, arrangement.points.compare_along(k, to, from)));
        let (axis, order) = along.into_iter().find(|(_, order)| order.is_ne()).unwrap_or((0, Ordering::Greater));
        EdgeOrder { axis, direction: order as i32 }
    }

    /// Returns 1 if the half-plane of v is less than a half turn counter-clockwise from u, and 0 if
    /// the angle is 0 or a half turn.
    pub(super) fn turn(&self, u: &HalfPlane, v: &HalfPlane) -> i32 {
        self.direction * cross_component(&u.normal, &v.normal, self.axis).sign()
    }

    /// Returns the half-plane of a half-edge of an edge that starts at `from`.
    pub(super) fn half_plane(
        arrangement: &ExactArrangement,
        groups: &FaceGroups,
        half_edge: u32,
        from: u32,
        triangles: &[[u32; 3]],
    ) -> HalfPlane {
        let origin = groups.origin(arrangement, half_edge / 3);
        let at = |v: u32| arrangement.points.rounded(arrangement.first_vertex_at_position[v as usize]);
        let mut normal = Plane::from_triangle(triangles[origin as usize].map(at)).normal;
        if !groups.begins_at(half_edge, from) {
            normal = normal.map(WideInt::negated);
        }
        HalfPlane { half_edge, normal }
    }

    /// Sorts half-planes counter-clockwise, from the first on.
    pub(super) fn sort(&self, half_planes: &mut [HalfPlane]) {
        let Some((first, others)) = half_planes.split_first_mut() else { return };
        let half = |v: &HalfPlane| match self.turn(first, v) {
            1 => 1,
            0 if dot(&first.normal, &v.normal).sign() > 0 => 0,
            0 => 2,
            _ => 3,
        };
        let compare = |u: &HalfPlane, v: &HalfPlane| {
            half(u).cmp(&half(v)).then_with(|| 0.cmp(&self.turn(u, v))).then(u.half_edge.cmp(&v.half_edge))
        };
        others.sort_unstable_by(compare);
    }
}

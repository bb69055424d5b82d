//! Splits the triangles of one plane along their common points and segments.
//!
//! A cluster is a triangle, or several that overlap in one plane. Triangles of a cluster are split
//! together, so that their parts coincide where they overlap.

use super::contacts::projection_axis;
use super::exact_points::{ExactPoints, Plane};
use super::planar_mesh::PlanarMesh;
use glam::DVec3;
use gusset_base::NONE;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::Aabb;
use gusset_base::job::Job;
use gusset_base::sort::sort_distinct;

/// A segment in the plane of a cluster, and a triangle that meets the plane in the segment's line.
pub(super) type Segment = ([u32; 2], u32);

/// A part of a triangle, and the triangle.
pub(super) type TrianglePart = ([u32; 3], u32);

/// The triangles of one plane and all points and segments that split them.
pub(super) struct Cluster<'c> {
    /// Triangles by number.
    pub(super) triangles: &'c [u32],
    /// Points, with repetitions.
    pub(super) points: &'c [u32],
    pub(super) segments: &'c [Segment],
}

/// The parts into which a cluster's triangles were split.
pub(super) struct SplitCluster {
    /// New points, numbered from the end of the base on.
    pub(super) points: ExactPoints<'static>,
    pub(super) parts: Vec<TrianglePart>,
    /// False if the triangles could not be split, and are returned whole.
    pub(super) is_complete: bool,
}

/// The plane that carries a segment.
enum Carrier {
    Triangle(u32),
    Edge([u32; 2]),
}

impl Cluster<'_> {
    /// Splits the triangles. `corners` returns the points of a triangle.
    pub(super) fn split(
        &self,
        base: &ExactPoints<'_>,
        corners: &impl Fn(u32) -> [u32; 3],
        job: &Job<'_>,
    ) -> Result<SplitCluster> {
        let mut points = ExactPoints::extending(base);
        let parts = match self.try_split(base, &mut points, corners, job)? {
            Some(parts) => return Ok(SplitCluster { points: points.into_own(), parts, is_complete: true }),
            None => alloc::collect(self.triangles.iter().map(|&t| (corners(t), t)))?,
        };
        Ok(SplitCluster { points: ExactPoints::extending(base).into_own(), parts, is_complete: false })
    }

    fn try_split(
        &self,
        base: &ExactPoints<'_>,
        points: &mut ExactPoints<'_>,
        corners: &impl Fn(u32) -> [u32; 3],
        job: &Job<'_>,
    ) -> Result<Option<Vec<TrianglePart>>> {
        let Some(&first) = self.triangles.first() else { return Ok(Some(Vec::new())) };
        let sorted = |mut t: [u32; 3]| {
            t.sort_unstable();
            t
        };
        let border = corners(first);
        let is_uniform = self.triangles.iter().all(|&t| sorted(corners(t)) == sorted(border));
        let is_corner = |p: &u32| border.contains(p);
        if is_uniform
            && self.points.iter().all(is_corner)
            && self.segments.iter().all(|(ends, _)| ends.iter().all(is_corner))
        {
            return Ok(Some(alloc::collect(self.triangles.iter().map(|&t| (corners(t), t)))?));
        }
        let place = |p: u32| base.rounded(p);
        let Some(axis) = projection_axis(border.map(place)) else { return Ok(None) };
        let support = Plane::from_triangle(border.map(place));
        // All points and segments, and carriers by number.
        let mut inner = alloc::copied(self.points)?;
        alloc::extend(&mut inner, self.segments.iter().flat_map(|(ends, _)| *ends))?;
        let mut carriers = alloc::collect(self.segments.iter().map(|&(_, t)| Carrier::Triangle(t)))?;
        let mut segments = alloc::collect(self.segments.iter().map(|&(ends, _)| ends))?;
        let outer = if is_uniform { border } else { self.enclosing_triangle(points, axis, corners)? };
        if !is_uniform {
            let mut edges = alloc::with_capacity(3 * self.triangles.len())?;
            for &t in self.triangles {
                let t = corners(t);
                alloc::append(&mut inner, &t)?;
                edges.extend([0, 1, 2].map(|k| [t[k].min(t[(k + 1) % 3]), t[k].max(t[(k + 1) % 3])]));
            }
            sort_distinct(&mut edges);
            alloc::extend(&mut carriers, edges.iter().map(|&ends| Carrier::Edge(ends)))?;
            alloc::append(&mut segments, &edges)?;
        }
        sort_distinct(&mut inner);
        inner.retain(|p| !outer.contains(p));
        let plane_of = |carrier: u32| match carriers[carrier as usize] {
            Carrier::Triangle(t) => Plane::from_triangle(corners(t).map(place)),
            Carrier::Edge(ends) => Plane::from_edge(ends.map(place), axis),
        };
        let mut mesh = PlanarMesh::new(points, axis, outer)?;
        let mut vertices = Vec::new();
        if !mesh.insert_points(&inner, &mut vertices, job)? {
            return Ok(None);
        }
        let vertex_of = |p: u32| match outer.iter().position(|&q| q == p) {
            Some(k) => k as u32,
            None => inner.binary_search(&p).map_or(NONE, |k| vertices[k]),
        };
        for (k, &ends) in segments.iter().enumerate() {
            job.sub_job(0.0, 0.0).step_every(1 << 8, k + 1, segments.len() + 1, "arranging triangles")?;
            if !mesh.insert_segment(ends.map(vertex_of), k as u32, &support, &plane_of)? {
                return Ok(None);
            }
        }
        mesh.restore_delaunay_everywhere()?;
        if is_uniform {
            let mut parts = Vec::new();
            for &t in self.triangles {
                let is_turned = mesh.named_orientation(corners(t)) < 0;
                alloc::extend(&mut parts, mesh.named_triangles().map(|part| (oriented(part, is_turned), t)))?;
            }
            return Ok(Some(parts));
        }
        self.parts_by_owner(&mesh, corners, vertex_of, job)
    }

    /// Adds three points whose projection is a triangle around all triangles.
    fn enclosing_triangle(
        &self,
        points: &mut ExactPoints<'_>,
        axis: usize,
        corners: &impl Fn(u32) -> [u32; 3],
    ) -> Result<[u32; 3]> {
        let all = self.triangles.iter().flat_map(|&t| corners(t)).map(|p| points.rounded(p));
        let around = Aabb::from_points(all);
        // Corners are small multiples of a power of two, so that they are exact.
        let step = 4.0 * gusset_base::geom::scale::floor_to_power_of_two(around.size().max_element().max(1.0));
        let middle = DVec3::from_array(around.centre().to_array().map(|x| libm::rint(x / step) * step));
        let mut made = [0; 3];
        for (place, (along, up)) in made.iter_mut().zip([(-2.0, -2.0), (6.0, -2.0), (-2.0, 6.0)]) {
            let mut corner = DVec3::ZERO;
            corner[(axis + 1) % 3] = middle[(axis + 1) % 3] + along * step;
            corner[(axis + 2) % 3] = middle[(axis + 2) % 3] + up * step;
            *place = points.push_integral(corner)?;
        }
        Ok(made)
    }

    /// Returns the parts of each triangle, by spreading from a corner over the parts inside.
    fn parts_by_owner(
        &self,
        mesh: &PlanarMesh<'_, '_>,
        corners: &impl Fn(u32) -> [u32; 3],
        vertex_of: impl Fn(u32) -> u32,
        job: &Job<'_>,
    ) -> Result<Option<Vec<TrianglePart>>> {
        let triangles = alloc::collect(mesh.named_triangles())?;
        let mut owner = alloc::filled(NONE, triangles.len())?;
        let (mut parts, mut stack) = (Vec::new(), Vec::new());
        for (k, &t) in self.triangles.iter().enumerate() {
            job.sub_job(0.0, 0.0).step_every(1 << 8, k + 1, self.triangles.len() + 1, "arranging triangles")?;
            let border = corners(t);
            let turn = mesh.named_orientation(border);
            let is_inside = |p: u32| {
                (0..3).all(|k| {
                    let [a, b] = [border[k], border[(k + 1) % 3]];
                    p == a || p == b || turn * mesh.named_orientation([a, b, p]) >= 0
                })
            };
            let is_part = |s: u32| triangles[s as usize].iter().all(|&p| is_inside(p));
            let Some(start) = mesh.find_at_vertex(vertex_of(border[0]), is_part)? else { return Ok(None) };
            alloc::push(&mut stack, start)?;
            owner[start as usize] = t;
            while let Some(s) = stack.pop() {
                alloc::push(&mut parts, (oriented(triangles[s as usize], turn < 0), t))?;
                for next in mesh.neighbours(s) {
                    if next != NONE && owner[next as usize] != t && is_part(next) {
                        owner[next as usize] = t;
                        alloc::push(&mut stack, next)?;
                    }
                }
            }
        }
        Ok(Some(parts))
    }
}

/// Returns a triangle, turned if asked.
fn oriented([a, b, c]: [u32; 3], is_turned: bool) -> [u32; 3] {
    if is_turned { [a, c, b] } else { [a, b, c] }
}

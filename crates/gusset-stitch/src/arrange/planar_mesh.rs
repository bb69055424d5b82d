//! A triangulation of points and segments in one plane, with exact orientations.
//!
//! Points are inserted first, each followed by the flips of Lawson. Segments are then forced by the
//! flips of Sloan. A segment that crosses an earlier one is split there, in a new point. Orientations
//! are exact. Flips for the shape of triangles use rounded coordinates, and are made only where the
//! exact orientations allow them.
//!
//! * C. L. Lawson, Software for C1 surface interpolation, in: Mathematical Software III, 1977.
//! * S. W. Sloan, A fast algorithm for generating constrained Delaunay triangulations, Computers &
//!   Structures 47, 1993.

use super::exact_points::{ExactPoints, Plane};
use gusset_base::NONE;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;
use std::cmp::Ordering;

/// Number of points or segments between two progress reports.
const ELEMENTS_PER_REPORT: usize = 1 << 8;

/// A triangulation whose local vertices are numbered from 0.
pub(super) struct PlanarMesh<'p, 'b> {
    points: &'p mut ExactPoints<'b>,
    /// The axis of the projection.
    axis: usize,
    /// The orientation of the first triangle in the projection.
    orientation_sign: i32,
    /// The point of each vertex.
    point_of_vertex: Vec<u32>,
    triangles: Vec<[u32; 3]>,
    /// The triangle beyond each edge k, from corner k to the next; `NONE` on the border.
    neighbours: Vec<[u32; 3]>,
    /// The carrier of the segment on each edge, or `NONE`.
    walls: Vec<[u32; 3]>,
    /// A triangle at each vertex.
    stars: Vec<u32>,
    /// The triangle where the next search begins.
    start_triangle_of_search: u32,
}

/// The place of a point in the triangulation.
enum Place {
    Inside(u32),
    OnEdge(u32, usize),
}

impl<'p, 'b> PlanarMesh<'p, 'b> {
    /// Creates the triangulation of one triangle that is not degenerate in the projection.
    pub(super) fn new(points: &'p mut ExactPoints<'b>, axis: usize, corners: [u32; 3]) -> Result<Self> {
        let turn = points.orientation(axis, corners);
        Ok(PlanarMesh {
            points,
            axis,
            orientation_sign: turn,
            point_of_vertex: alloc::copied(&corners)?,
            triangles: alloc::filled([0, 1, 2], 1)?,
            neighbours: alloc::filled([NONE; 3], 1)?,
            walls: alloc::filled([NONE; 3], 1)?,
            stars: alloc::filled(0, 3)?,
            start_triangle_of_search: 0,
        })
    }

    /// Returns the points of all triangles.
    pub(super) fn named_triangles(&self) -> impl ExactSizeIterator<Item = [u32; 3]> {
        self.triangles.iter().map(|t| t.map(|v| self.point_of_vertex[v as usize]))
    }

    /// Returns the neighbours of a triangle.
    pub(super) fn neighbours(&self, t: u32) -> [u32; 3] {
        self.neighbours[t as usize]
    }

    /// Returns a triangle at a vertex for which `is_wanted` returns true.
    pub(super) fn find_at_vertex(&self, v: u32, is_wanted: impl Fn(u32) -> bool) -> Result<Option<u32>> {
        self.visit_star(v, |_, t, _| Ok(is_wanted(t).then_some(t)))
    }

    fn orientation(&self, vertices: [u32; 3]) -> i32 {
        self.orientation_sign * self.points.orientation(self.axis, vertices.map(|v| self.point_of_vertex[v as usize]))
    }

    /// Returns 1 if three points turn like the first triangle.
    pub(super) fn named_orientation(&self, points: [u32; 3]) -> i32 {
        self.orientation_sign * self.points.orientation(self.axis, points)
    }

    fn corner(&self, t: u32, k: usize) -> u32 {
        self.triangles[t as usize][k % 3]
    }

    fn add_vertex(&mut self, point: u32) -> Result<u32> {
        alloc::push(&mut self.point_of_vertex, point)?;
        alloc::push(&mut self.stars, 0)?;
        Ok(self.point_of_vertex.len() as u32 - 1)
    }

    fn add_triangle(&mut self) -> Result<u32> {
        alloc::push(&mut self.triangles, [0; 3])?;
        alloc::push(&mut self.neighbours, [NONE; 3])?;
        alloc::push(&mut self.walls, [NONE; 3])?;
        Ok(self.triangles.len() as u32 - 1)
    }

    /// Sets a triangle. Each edge has a neighbour and a wall.
    fn set_triangle(&mut self, t: u32, corners: [u32; 3], edges: [(u32, u32); 3]) {
        self.triangles[t as usize] = corners;
        self.neighbours[t as usize] = edges.map(|(neighbour, _)| neighbour);
        self.walls[t as usize] = edges.map(|(_, wall)| wall);
        corners.iter().for_each(|&v| self.stars[v as usize] = t);
    }

    fn relink(&mut self, t: u32, from: u32, to: u32) {
        if let Some(beside) = self.neighbours.get_mut(t as usize) {
            beside.iter_mut().filter(|n| **n == from).for_each(|n| *n = to);
        }
    }

    /// Returns the corners from corner k on, and neighbour and wall of each edge.
    fn rotated(&self, t: u32, k: usize) -> ([u32; 3], [(u32, u32); 3]) {
        let places = [k % 3, (k + 1) % 3, (k + 2) % 3];
        let i = t as usize;
        (places.map(|j| self.triangles[i][j]), places.map(|j| (self.neighbours[i][j], self.walls[i][j])))
    }

    fn edge_towards(&self, t: u32, neighbour: u32) -> Option<usize> {
        self.neighbours[t as usize].iter().position(|&n| n == neighbour)
    }

    fn split_triangle(&mut self, t: u32, v: u32) -> Result<()> {
        let ([a, b, c], [ab, bc, ca]) = self.rotated(t, 0);
        let (t1, t2) = (self.add_triangle()?, self.add_triangle()?);
        self.set_triangle(t1, [b, c, v], [bc, (t2, NONE), (t, NONE)]);
        self.set_triangle(t2, [c, a, v], [ca, (t, NONE), (t1, NONE)]);
        self.set_triangle(t, [a, b, v], [ab, (t1, NONE), (t2, NONE)]);
        self.relink(bc.0, t, t1);
        self.relink(ca.0, t, t2);
        Ok(())
    }

    fn split_edge(&mut self, t: u32, k: usize, v: u32) -> Result<()> {
        let ([a, b, c], [ab, bc, ca]) = self.rotated(t, k);
        let (u, wall) = ab;
        let t1 = self.add_triangle()?;
        let other = if u == NONE { None } else { self.edge_towards(u, t) };
        let u1 = if other.is_some() { self.add_triangle()? } else { NONE };
        self.set_triangle(t1, [v, b, c], [(u1, wall), bc, (t, NONE)]);
        self.set_triangle(t, [a, v, c], [(u, wall), (t1, NONE), ca]);
        self.relink(bc.0, t, t1);
        if let Some(j) = other {
            let ([_, _, d], [_, ad, db]) = self.rotated(u, j);
            self.set_triangle(u1, [b, v, d], [(t1, wall), (u, NONE), db]);
            self.set_triangle(u, [v, a, d], [(t, wall), ad, (u1, NONE)]);
            self.relink(db.0, u, u1);
        }
        Ok(())
    }

    /// Replaces an edge by the other diagonal of its two triangles, if these form a strictly convex
    /// quad.
    fn flip(&mut self, t: u32, k: usize, is_wanted: impl FnOnce(&Self, [u32; 4]) -> bool) -> bool {
        let ([a, b, c], [(u, wall), bc, ca]) = self.rotated(t, k);
        if u == NONE || wall != NONE {
            return false;
        }
        let Some(j) = self.edge_towards(u, t) else { return false };
        let ([_, _, d], [_, ad, db]) = self.rotated(u, j);
        if !is_wanted(self, [a, b, c, d]) || self.orientation([a, d, c]) <= 0 || self.orientation([d, b, c]) <= 0 {
            return false;
        }
        self.set_triangle(u, [d, b, c], [db, bc, (t, NONE)]);
        self.set_triangle(t, [a, d, c], [ad, (u, NONE), ca]);
        self.relink(ad.0, u, t);
        self.relink(bc.0, t, u);
        true
    }

    /// Returns true if d lies clearly in the circle through a, b and c.
    fn is_in_circle(&self, [a, b, c, d]: [u32; 4]) -> bool {
        let (x, y) = [(1, 2), (2, 0), (0, 1)][self.axis];
        let at = |v: u32| self.points.rounded(self.point_of_vertex[v as usize]);
        let last = at(d);
        let [p, q, r] = [a, b, c].map(|v| {
            let (x, y) = (at(v)[x] - last[x], at(v)[y] - last[y]);
            (x, y, x * x + y * y)
        });
        let parts = [p.2 * (q.0 * r.1 - q.1 * r.0), q.2 * (r.0 * p.1 - r.1 * p.0), r.2 * (p.0 * q.1 - p.1 * q.0)];
        let size = p.2 * (q.2 * r.2).sqrt() + q.2 * (r.2 * p.2).sqrt() + r.2 * (p.2 * q.2).sqrt();
        f64::from(self.orientation_sign) * parts.iter().sum::<f64>() > 1e-12 * size
    }

    /// Flips edges of the triangles in the stack, and of those that flips change.
    fn restore_delaunay(&mut self, mut stack: Vec<u32>) -> Result<()> {
        let mut left = 4 * self.triangles.len() + 64;
        while let Some(t) = stack.pop() {
            for k in 0..3 {
                let u = self.neighbours[t as usize][k];
                if left > 0 && self.flip(t, k, Self::is_in_circle) {
                    left -= 1;
                    alloc::extend(&mut stack, [t, u])?;
                    break;
                }
            }
        }
        Ok(())
    }

    /// Makes all triangles well shaped, as far as the segments allow it.
    pub(super) fn restore_delaunay_everywhere(&mut self) -> Result<()> {
        let all = alloc::collect((0..self.triangles.len()).map(|t| t as u32))?;
        self.restore_delaunay(all)
    }

    fn locate(&self, v: u32) -> Option<Place> {
        let mut t = self.start_triangle_of_search;
        for step in 0..3 * self.triangles.len() + 9 {
            match self.step_towards(t, step, v) {
                Ok(place) => return place,
                Err(NONE) => return None,
                Err(next) => t = next,
            }
        }
        // The walk went round: tries all triangles.
        (0..self.triangles.len() as u32).find_map(|t| self.step_towards(t, 0, v).ok()?)
    }

    /// Returns the place of a vertex in a triangle, or else the next triangle of a walk. The place
    /// is `None` if the vertex coincides with another.
    fn step_towards(&self, t: u32, step: usize, v: u32) -> Result<Option<Place>, u32> {
        let mut touched = [false; 3];
        for k in [step % 3, (step + 1) % 3, (step + 2) % 3] {
            match self.orientation([self.corner(t, k), self.corner(t, k + 1), v]) {
                -1 => return Err(self.neighbours[t as usize][k]),
                side => touched[k] = side == 0,
            }
        }
        Ok(match touched.iter().filter(|&&edge| edge).count() {
            0 => Some(Place::Inside(t)),
            1 => touched.iter().position(|&edge| edge).map(|k| Place::OnEdge(t, k)),
            _ => None,
        })
    }

    /// Inserts a point. Returns its vertex, or `None` if it lies outside or on another vertex.
    fn insert_point(&mut self, point: u32) -> Result<Option<u32>> {
        let v = self.add_vertex(point)?;
        match self.locate(v) {
            Some(Place::Inside(t)) => self.split_triangle(t, v)?,
            Some(Place::OnEdge(t, k)) => self.split_edge(t, k, v)?,
            None => return Ok(None),
        }
        let mut stack = Vec::new();
        self.visit_star(v, |_, t, _| alloc::push(&mut stack, t).map(|()| None::<()>))?;
        self.restore_delaunay(stack)?;
        self.start_triangle_of_search = self.stars[v as usize];
        Ok(Some(v))
    }

    /// Inserts points in an order that keeps walks short. Appends the vertex of each to `vertices`.
    /// Returns false if a point lies outside.
    pub(super) fn insert_points(&mut self, given: &[u32], vertices: &mut Vec<u32>, job: &Job<'_>) -> Result<bool> {
        let start = vertices.len();
        alloc::grow(vertices, start + given.len(), NONE)?;
        for (k, place) in self.short_tour(given)?.into_iter().enumerate() {
            job.sub_job(0.0, 0.0).step_every(ELEMENTS_PER_REPORT, k + 1, given.len() + 1, "arranging triangles")?;
            match self.insert_point(given[place as usize])? {
                Some(v) => vertices[start + place as usize] = v,
                None => return Ok(false),
            }
        }
        Ok(true)
    }

    /// Returns the places of points in strips, up and down by turns.
    fn short_tour(&self, given: &[u32]) -> Result<Vec<u32>> {
        let mut order = alloc::collect((0..given.len()).map(|k| k as u32))?;
        let (x, y) = [(1, 2), (2, 0), (0, 1)][self.axis];
        let at = |k: u32| self.points.rounded(given[k as usize]);
        let range = gusset_base::geom::aabb::range_of_values(given.iter().map(|&p| self.points.rounded(p)[x]));
        let strips = (given.len() as f64 / 2.0).sqrt().max(1.0);
        let strip = |k: u32| ((at(k)[x] - range[0]) / (range[1] - range[0]) * strips) as u32;
        order.sort_unstable_by(|&i, &j| {
            let along = at(i)[y].total_cmp(&at(j)[y]);
            let along = if strip(i) % 2 == 0 { along } else { along.reverse() };
            strip(i).cmp(&strip(j)).then(along).then(i.cmp(&j))
        });
        Ok(order)
    }

    /// Calls `visit` with each triangle at a vertex, and its corner there, until it returns a value.
    fn visit_star<T>(
        &self,
        v: u32,
        mut visit: impl FnMut(&Self, u32, usize) -> Result<Option<T>>,
    ) -> Result<Option<T>> {
        let first = self.stars[v as usize];
        for backwards in [false, true] {
            let mut t = first;
            loop {
                let k = self.triangles[t as usize].iter().position(|&w| w == v).unwrap_or(0);
                if !(backwards && t == first)
                    && let Some(found) = visit(self, t, k)?
                {
                    return Ok(Some(found));
                }
                t = self.neighbours[t as usize][if backwards { k } else { (k + 2) % 3 }];
                if t == first {
                    return Ok(None);
                }
                if t == NONE {
                    break;
                }
            }
        }
        Ok(None)
    }

    fn find_edge(&self, a: u32, b: u32) -> Result<Option<(u32, usize)>> {
        self.visit_star(a, |mesh, t, k| {
            let is_end = |j: usize| mesh.corner(t, j) == b;
            Ok(if is_end(k + 1) { Some((t, k)) } else { is_end(k + 2).then_some((t, (k + 2) % 3)) })
        })
    }

    fn set_wall(&mut self, t: u32, k: usize, wall: u32) {
        if self.walls[t as usize][k] != NONE {
            return;
        }
        self.walls[t as usize][k] = wall;
        let u = self.neighbours[t as usize][k];
        if u != NONE
            && let Some(j) = self.edge_towards(u, t)
        {
            self.walls[u as usize][j] = wall;
        }
    }

    /// Returns true if p lies on the ray from a through b, where the three are collinear.
    fn is_ahead(&self, [a, b, p]: [u32; 3]) -> bool {
        let [a, b, p] = [a, b, p].map(|v| self.point_of_vertex[v as usize]);
        let along =
            (0..3).map(|k| (k, self.points.compare_along(k, a, b))).find(|&(_, order)| order != Ordering::Equal);
        along.is_some_and(|(k, order)| self.points.compare_along(k, a, p) == order)
    }

    /// Inserts a segment. `plane_of` returns the plane of a carrier, which meets the plane of the
    /// triangulation, `support`, in the segment's line. Returns false if the triangulation is
    /// inconsistent.
    pub(super) fn insert_segment(
        &mut self,
        [a, b]: [u32; 2],
        carrier: u32,
        support: &Plane,
        plane_of: &impl Fn(u32) -> Plane,
    ) -> Result<bool> {
        let mut from = a;
        while from != b {
            let start = self.visit_star(from, |mesh, t, k| {
                let (p, q) = (mesh.corner(t, k + 1), mesh.corner(t, k + 2));
                let sides = [p, q].map(|v| if v == b { 0 } else { mesh.orientation([from, b, v]) });
                let is_met = |j: usize, v: u32| sides[j] == 0 && (v == b || mesh.is_ahead([from, b, v]));
                Ok(if is_met(0, p) {
                    Some((t, k, Some(p)))
                } else if is_met(1, q) {
                    Some((t, (k + 2) % 3, Some(q)))
                } else {
                    (sides == [-1, 1]).then_some((t, (k + 1) % 3, None))
                })
            })?;
            match start {
                Some((t, k, Some(next))) => {
                    self.set_wall(t, k, carrier);
                    from = next;
                }
                Some((t, k, None)) => {
                    let Some(next) = self.cut_through([from, b], (t, k), carrier, support, plane_of)? else {
                        return Ok(false);
                    };
                    from = next;
                }
                None => return Ok(false),
            }
        }
        Ok(true)
    }

    /// Forces the segment from a vertex to the next vertex on it, which may be a new one on another
    /// segment. `first` is the first edge that it crosses. Returns the next vertex.
    fn cut_through(
        &mut self,
        [from, b]: [u32; 2],
        first: (u32, usize),
        carrier: u32,
        support: &Plane,
        plane_of: &impl Fn(u32) -> Plane,
    ) -> Result<Option<u32>> {
        let (mut t, mut k) = first;
        let mut crossed = Vec::new();
        let next = loop {
            let wall = self.walls[t as usize][k];
            if wall != NONE {
                let point = support.meet_planes(&plane_of(carrier), &plane_of(wall));
                if point[3].sign() == 0 {
                    return Ok(None);
                }
                let point = self.points.push(&point)?;
                let v = self.add_vertex(point)?;
                self.split_edge(t, k, v)?;
                break v;
            }
            alloc::push(&mut crossed, [self.corner(t, k), self.corner(t, k + 1)])?;
            let u = self.neighbours[t as usize][k];
            if u == NONE {
                return Ok(None);
            }
            let Some(j) = self.edge_towards(u, t) else { return Ok(None) };
            let beyond = self.corner(u, j + 2);
            let side = if beyond == b { 0 } else { self.orientation([from, b, beyond]) };
            (t, k) = match side {
                0 => break beyond,
                1 => (u, (j + 1) % 3),
                _ => (u, (j + 2) % 3),
            };
        };
        if !self.flip_away(&mut crossed, [from, next], b)? {
            return Ok(None);
        }
        let Some((t, k)) = self.find_edge(from, next)? else { return Ok(None) };
        self.set_wall(t, k, carrier);
        Ok(Some(next))
    }

    /// Flips the edges that cross a segment, which lies on the line to `b`.
    fn flip_away(&mut self, crossed: &mut Vec<[u32; 2]>, ends: [u32; 2], b: u32) -> Result<bool> {
        let limit = 64 + 16 * crossed.len() * crossed.len();
        let mut k = 0;
        while k < crossed.len() {
            if k > limit {
                return Ok(false);
            }
            let [p, q] = crossed[k];
            k += 1;
            let Some((t, edge)) = self.find_edge(p, q)? else { return Ok(false) };
            let mut diagonal = [p, q];
            if !self.flip(t, edge, |_, [_, _, c, d]| {
                diagonal = [c, d];
                true
            }) {
                alloc::push(crossed, [p, q])?;
                continue;
            }
            let crosses = !diagonal.iter().any(|v| ends.contains(v)) && {
                let [c, d] = diagonal.map(|v| self.orientation([ends[0], b, v]));
                c * d < 0
            };
            if crosses {
                alloc::push(crossed, diagonal)?;
            }
        }
        Ok(true)
    }
}

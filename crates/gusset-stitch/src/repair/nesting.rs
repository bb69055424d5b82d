//! Nesting of closed components: the components that enclose each one.
//!
//! Component D encloses component C if a vertex of C lies inside D, and their surfaces meet at most
//! in common vertices and edges. Components that cross, or touch elsewhere, do not nest. Vertices
//! of C on the surface of D do not count. If all vertices lie there, points on the edges and faces
//! of C decide. If D consists of several closed sheets of faces, a point lies inside where a ray
//! from it meets an odd number of faces.
//!
//! Rays run along the shortest side of the box around all enclosing components. They are moved
//! sideways by an infinitesimal, so that they meet no edge. All signs are exact.

use crate::intersect::{TriangleSoup, intersecting_pairs_where, is_on_triangle, ray_meets_triangle};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::Aabb;
use gusset_base::geom::box_tree::{BoxTree, spatial_order};
use gusset_base::geom::scale::common_unit;
use gusset_base::job::Job;
use gusset_base::sort::sort_distinct;
use gusset_mesh::MeshView;
use std::ops::Range;

/// Number of triangles, or components, in a leaf of a tree.
const MAX_LEAF_BOXES: usize = 4;
/// Number of rays or triangles between two progress reports.
const RAYS_PER_REPORT: usize = 1 << 8;
const TRIANGLES_PER_REPORT: usize = 1 << 16;

const STAGE: &str = "nesting components";

/// Closed components as sets of faces.
#[derive(Default)]
pub(super) struct ClosedComponents {
    faces: Vec<u32>,
    /// The end of each component in `faces`.
    component_ends: Vec<usize>,
}

impl ClosedComponents {
    pub(super) fn push(&mut self, faces: &[u32]) -> Result<()> {
        alloc::append(&mut self.faces, faces)?;
        alloc::push(&mut self.component_ends, self.faces.len())
    }

    pub(super) fn faces(&self, component: usize) -> &[u32] {
        let start = if component == 0 { 0 } else { self.component_ends[component - 1] };
        &self.faces[start..self.component_ends[component]]
    }

    /// Returns the number of other components that enclose each component.
    ///
    /// O(n log n) for n faces, plus the faces that one ray from each component meets and the
    /// overlapping boxes of faces of nested components. Linear extra memory; none of it unless the
    /// box of one component contains the box of another.
    pub(super) fn depths(&self, mesh: &MeshView<'_>, job: &Job<'_>) -> Result<Vec<u32>> {
        let count = self.component_ends.len();
        let mut depths = alloc::filled(0, count)?;
        if count < 2 {
            return Ok(depths);
        }
        let pairs = NestingSearch::new(self, mesh, &job.sub_job(0.0, 0.2))?.enclosing_pairs(&job.sub_job(0.2, 1.0))?;
        pairs.iter().for_each(|&[inner, _]| depths[inner as usize] += 1);
        Ok(depths)
    }
}

/// The components whose boxes are nested, as triangles.
struct NestingSearch<'m> {
    mesh: &'m MeshView<'m>,
    unit: f64,
    /// The box of each component, in the unit.
    boxes: Vec<Aabb>,
    /// The triangles of all components that take part.
    triangles: Vec<[u32; 3]>,
    /// The component of each triangle.
    component_of_triangle: Vec<u32>,
    /// The triangles of each component.
    triangles_of_component: Vec<Range<usize>>,
    /// True for each component whose box contains another box.
    is_outer: Vec<bool>,
    /// True for each component whose box lies in another box.
    is_inner: Vec<bool>,
}

impl<'m> NestingSearch<'m> {
    fn new(components: &ClosedComponents, mesh: &'m MeshView<'m>, job: &Job<'_>) -> Result<Self> {
        let count = components.component_ends.len();
        let point = |v: u32| mesh.positions().get(v);
        let corners = |k: usize| components.faces(k).iter().flat_map(|&f| mesh.face(f as usize)).map(point);
        let mut boxes = alloc::with_capacity(count)?;
        for k in 0..count {
            job.step_every(RAYS_PER_REPORT, k, count, STAGE)?;
            boxes.push(Aabb::from_points(corners(k)));
        }
        let unit = common_unit(&alloc::gather(boxes.iter().flat_map(|b| [b.low, b.high]))?);
        boxes.iter_mut().for_each(|b| (b.low, b.high) = (b.low / unit, b.high / unit));
        let (mut is_outer, mut is_inner) = (alloc::filled(false, count)?, alloc::filled(false, count)?);
        visit_leaf_boxes(&boxes, job, |tree, order| {
            for inner in 0..count {
                job.step_every(RAYS_PER_REPORT, inner, count, STAGE)?;
                let contains = |b: &Aabb| contains_box(b, &boxes[inner]);
                tree.visit_accepted(
                    |_, b| contains(b),
                    |leaf| {
                        for &outer in order.chunks(MAX_LEAF_BOXES).nth(leaf).unwrap_or_default() {
                            if outer as usize != inner && contains(&boxes[outer as usize]) {
                                (is_outer[outer as usize], is_inner[inner]) = (true, true);
                            }
                        }
                        Ok(())
                    },
                )?;
            }
            Ok(())
        })?;
        let (mut triangles, mut owners, mut ranges) = (Vec::new(), Vec::new(), alloc::with_capacity(count)?);
        let mut face = Vec::new();
        for k in 0..count {
            let start = triangles.len();
            for &f in components.faces(k).iter().filter(|_| is_outer[k] || is_inner[k]) {
                job.step_every(TRIANGLES_PER_REPORT, triangles.len(), usize::MAX, STAGE)?;
                face.clear();
                alloc::extend(&mut face, mesh.face(f as usize))?;
                for pair in face[1..].windows(2) {
                    alloc::push(&mut triangles, [face[0], pair[0], pair[1]])?;
                    alloc::push(&mut owners, k as u32)?;
                }
            }
            ranges.push(start..triangles.len());
        }
        Ok(NestingSearch {
            mesh,
            unit,
            boxes,
            triangles,
            component_of_triangle: owners,
            triangles_of_component: ranges,
            is_outer,
            is_inner,
        })
    }

    fn scaled_position(&self, v: u32) -> DVec3 {
        self.mesh.positions().get(v) / self.unit
    }

    /// Returns the pairs (enclosed, enclosing), ascending.
    fn enclosing_pairs(&self, job: &Job<'_>) -> Result<Vec<[u32; 2]>> {
        let mut pairs = self.pairs_by_rays(&job.sub_job(0.0, 0.5))?;
        if pairs.is_empty() {
            return Ok(pairs);
        }
        let pair_of = |s: u32, t: u32| [s, t].map(|t| self.component_of_triangle[t as usize]);
        let is_listed = |pair: [u32; 2]| pairs.binary_search(&pair).is_ok();
        let wanted = |s: u32, t: u32| {
            let [a, b] = pair_of(s, t);
            a != b && (is_listed([a, b]) || is_listed([b, a]))
        };
        let soup = TriangleSoup {
            position_of_vertex: |v| self.scaled_position(v),
            new_triangles: &self.triangles,
            old_triangles: &[],
        };
        let meeting = intersecting_pairs_where(&soup, &wanted, &|_, _| true, &job.sub_job(0.5, 1.0))?;
        let mut meeting = alloc::collect(meeting.iter().map(|&[s, t]| pair_of(s, t)))?;
        meeting.iter_mut().for_each(|pair| pair.sort_unstable());
        sort_distinct(&mut meeting);
        pairs.retain(|&[a, b]| meeting.binary_search(&[a.min(b), a.max(b)]).is_err());
        Ok(pairs)
    }

    /// Returns the pairs (enclosed, enclosing) by one ray from each component; ascending. The
    /// surfaces may cross.
    fn pairs_by_rays(&self, job: &Job<'_>) -> Result<Vec<[u32; 2]>> {
        let outer = |&t: &usize| self.is_outer[self.component_of_triangle[t] as usize];
        let places = alloc::gather((0..self.triangles.len()).filter(outer))?;
        let boxes = alloc::collect(
            places.iter().map(|&t| Aabb::from_points(self.triangles[t].map(|v| self.scaled_position(v)))),
        )?;
        let size = boxes.iter().fold(Aabb::EMPTY, |whole, b| whole.union(*b)).size();
        let axis = (0..3).min_by(|&j, &k| size[j].total_cmp(&size[k])).unwrap_or(0);
        let mut pairs = Vec::new();
        visit_leaf_boxes(&boxes, job, |tree, order| {
            for inner in (0..self.boxes.len()).filter(|&k| self.is_inner[k]) {
                job.step_every(RAYS_PER_REPORT, inner, self.boxes.len(), STAGE)?;
                // The components whose surfaces contain all vertices so far; at first, any.
                let mut undecided: Option<Vec<u32>> = None;
                let triangles = &self.triangles[self.triangles_of_component[inner].clone()];
                let vertices = triangles.as_flattened().iter().map(|&v| (self.scaled_position(v), 0.0));
                let inner_points = triangles.iter().flat_map(|t| inner_points(t.map(|v| self.scaled_position(v))));
                for (from, slack) in vertices.chain(inner_points) {
                    let mut ray = Aabb { low: from, high: from };
                    ray.high[axis] = f64::INFINITY;
                    (ray.low, ray.high) = (ray.low - slack, ray.high + slack);
                    let (mut met, mut touched) = (Vec::new(), Vec::new());
                    tree.visit_overlapping(&ray, 0.0, |leaf| {
                        for &place in order.chunks(MAX_LEAF_BOXES).nth(leaf).unwrap_or_default() {
                            let t = places[place as usize];
                            let outer = self.component_of_triangle[t];
                            let is_asked = undecided.as_ref().is_none_or(|list| list.binary_search(&outer).is_ok());
                            if !is_asked
                                || !boxes[place as usize].overlaps(&ray)
                                || !contains_box(&self.boxes[outer as usize], &self.boxes[inner])
                                || outer as usize == inner
                            {
                                continue;
                            }
                            let corners = self.triangles[t].map(|v| self.scaled_position(v));
                            if is_on_triangle(from, corners) || is_within(from, corners, slack) {
                                alloc::push(&mut touched, outer)?;
                            } else if ray_meets_triangle(from, axis, corners) {
                                alloc::push(&mut met, outer)?;
                            }
                        }
                        Ok(())
                    })?;
                    sort_distinct(&mut touched);
                    met.retain(|outer| touched.binary_search(outer).is_err());
                    met.sort_unstable();
                    let odd = met.chunk_by(|x, y| x == y).filter(|same| same.len() % 2 == 1);
                    alloc::extend(&mut pairs, odd.map(|same| [inner as u32, same[0]]))?;
                    if touched.is_empty() {
                        break;
                    }
                    undecided = Some(touched);
                }
            }
            Ok(())
        })?;
        pairs.sort_unstable();
        Ok(pairs)
    }
}

/// Returns points on the sides and in the middle of a triangle, with bounds of their rounding errors.
fn inner_points([a, b, c]: [DVec3; 3]) -> [(DVec3, f64); 4] {
    let slack = 4.0 * f64::EPSILON * a.abs().max(b.abs()).max(c.abs()).max_element();
    [(a + b) / 2.0, (b + c) / 2.0, (c + a) / 2.0, (a + b + c) / 3.0].map(|p| (p, slack))
}

/// Returns true if a point may lie within a positive distance of a triangle.
fn is_within(p: DVec3, [a, b, c]: [DVec3; 3], distance: f64) -> bool {
    let (u, v, w) = (b - a, c - a, p - a);
    let normal = u.cross(v);
    let rounding = 8.0 * f64::EPSILON * u.length() * v.length() * w.length();
    let around = Aabb { low: p - distance, high: p + distance };
    distance > 0.0
        && Aabb::from_points([a, b, c]).overlaps(&around)
        && normal.dot(w).abs() <= distance * normal.length() + rounding
}

fn contains_box(outer: &Aabb, inner: &Aabb) -> bool {
    outer.low.cmple(inner.low).all() && inner.high.cmple(outer.high).all()
}

/// Hands over a tree over the boxes, with the order of the boxes in its leaves.
fn visit_leaf_boxes(boxes: &[Aabb], job: &Job<'_>, visit: impl FnOnce(&BoxTree, &[u32]) -> Result<()>) -> Result<()> {
    let order = spatial_order(boxes, MAX_LEAF_BOXES, &job.sub_job(0.0, 0.0), STAGE)?;
    let around = |leaf: &[u32]| leaf.iter().fold(Aabb::EMPTY, |whole, &k| whole.union(boxes[k as usize]));
    visit(&BoxTree::new_cancellable(order.chunks(MAX_LEAF_BOXES).map(around), &job.sub_job(0.0, 0.0), STAGE)?, &order)
}

//! The vertices sorted between the planes of a stack, and the faces that each plane crosses.
//!
//! The class of a vertex is 2 k + 1 in plane k, and 2 k between plane k - 1 and plane k. A plane k
//! therefore separates the classes below a bound: 2 k + 1 if vertices in the plane count as above,
//! 2 k + 2 if they count as below. A face is crossed by the planes whose bounds are above its
//! smallest class and not above its largest.

use super::exact_plane::{ExactPlane, MAX_COORDINATE};
use super::section_request::{InPlane, STAGE};
use crate::view::FaceVisitor;
use crate::{MAX_ELEMENTS, MeshView};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::{Component, Element, Error, Result};
use gusset_base::job::Job;
use gusset_base::par;
use gusset_base::sort::Buckets;

/// The largest number of planes: twice as many classes have 32-bit numbers.
pub(super) const MAX_PLANES: u64 = 1 << 30;

/// Vertices or faces in one work item.
const ELEMENTS_PER_TASK: usize = 1 << 15;

/// The class of vertices that no section may use: a coordinate is not finite or too large.
const UNUSABLE_VERTEX_CLASS: u32 = u32::MAX;

/// A mesh cut by a stack of planes.
pub(super) struct StackCut<'a> {
    pub(super) plane: &'a ExactPlane,
    /// The levels of the planes, ascending.
    pub(super) levels: &'a [f64],
    in_plane: InPlane,
    classes: Vec<u32>,
    /// The faces that each plane crosses, ascending.
    faces: Buckets<u32>,
}

/// A face and the planes that cross it.
#[derive(Clone, Copy)]
struct CrossedFace {
    face: u32,
    /// The first plane.
    first_plane: u32,
    /// The plane after the last.
    end_plane: u32,
}

impl<'a> StackCut<'a> {
    pub(super) fn new(
        mesh: &MeshView<'_>,
        plane: &'a ExactPlane,
        levels: &'a [f64],
        in_plane: InPlane,
        job: &Job<'_>,
    ) -> Result<Self> {
        let positions = mesh.positions();
        let mut classes = alloc::zeroed(positions.len())?;
        let parts = classes.chunks_mut(ELEMENTS_PER_TASK).enumerate();
        par::map_cancellable(&job.sub_job(0.0, 0.4), STAGE, parts, |(part, classes)| {
            for (class, v) in classes.iter_mut().zip((part * ELEMENTS_PER_TASK) as u32..) {
                *class = find_class(plane, levels, positions.get(v));
            }
        })?;
        let ranges = par::split_into_ranges(mesh.faces().len(), ELEMENTS_PER_TASK);
        let found = par::map_cancellable(&job.sub_job(0.4, 0.8), STAGE, ranges, |range| {
            let mut visitor = CrossedFaceFinder { mesh, classes: &classes, in_plane, crossed_faces: Vec::new() };
            mesh.faces().visit_faces(range, &mut visitor).map(|()| visitor.crossed_faces)
        })?;
        let mut crossed: Vec<CrossedFace> = Vec::new();
        alloc::append_all(&mut crossed, found)?;
        let segments = crossed.iter().map(|c| u64::from(c.end_plane - c.first_plane)).sum();
        Error::check_count("crossings of faces and planes", segments, MAX_ELEMENTS / 4)?;
        let by_plane = crossed.iter().flat_map(|c| (c.first_plane..c.end_plane).map(|k| (k as usize, c.face)));
        let faces = Buckets::new_cancellable(levels.len(), 0, by_plane, &job.sub_job(0.8, 1.0), STAGE)?;
        Ok(StackCut { plane, levels, in_plane, classes, faces })
    }

    /// Returns the faces that a plane crosses.
    pub(super) fn faces_across_plane(&self, plane: usize) -> &[u32] {
        self.faces.get(plane)
    }

    /// Returns true if a vertex counts as above a plane.
    #[inline]
    pub(super) fn is_above(&self, v: u32, plane: usize) -> bool {
        count_planes_below(self.classes[v as usize], self.in_plane) as usize > plane
    }

    /// Returns true if a vertex is exactly in a plane.
    #[inline]
    pub(super) fn is_in_plane(&self, v: u32, plane: usize) -> bool {
        self.classes[v as usize] as usize == 2 * plane + 1
    }
}

/// Returns the number of planes below a vertex of a class.
#[inline]
fn count_planes_below(class: u32, in_plane: InPlane) -> u32 {
    match in_plane {
        InPlane::Above => class.div_ceil(2),
        InPlane::Below => class / 2,
    }
}

/// Returns the class of a point.
#[inline]
fn find_class(plane: &ExactPlane, levels: &[f64], p: DVec3) -> u32 {
    // NaN fails the comparison too.
    if !(p.abs().max_element() <= MAX_COORDINATE && p.is_finite()) {
        return UNUSABLE_VERTEX_CLASS;
    }
    let bounded = plane.bounded_value(p);
    let (low, high) = (bounded.value - bounded.error_bound, bounded.value + bounded.error_bound);
    let below = levels.partition_point(|&level| level < low);
    match levels.get(below) {
        Some(&level) if level <= high => find_class_exactly(plane, levels, p, below, high),
        _ => 2 * below as u32,
    }
}

/// Returns the class of a point that may lie in a plane: `below` planes are certainly below it, and
/// planes above the level `high` certainly above.
#[cold]
fn find_class_exactly(plane: &ExactPlane, levels: &[f64], p: DVec3, below: usize, high: f64) -> u32 {
    let unsure = levels[below..].partition_point(|&level| level <= high);
    let distance = |k: usize| plane.exact_distance(p, levels[k]);
    let k = below + levels[below..below + unsure].partition_point(|&level| plane.exact_distance(p, level) > 0.0);
    let is_in_plane = k < below + unsure && distance(k) == 0.0;
    2 * k as u32 + u32::from(is_in_plane)
}

/// Collects the faces that planes cross.
struct CrossedFaceFinder<'a> {
    mesh: &'a MeshView<'a>,
    classes: &'a [u32],
    in_plane: InPlane,
    crossed_faces: Vec<CrossedFace>,
}

impl FaceVisitor for CrossedFaceFinder<'_> {
    #[inline(always)]
    fn visit_face(&mut self, first_corner: u32, corners: &[u32]) -> Result<()> {
        let (mut lowest, mut highest) = (u32::MAX, 0);
        for &v in corners {
            let class = self.classes[v as usize];
            (lowest, highest) = (lowest.min(class), highest.max(class));
        }
        if highest == UNUSABLE_VERTEX_CLASS {
            return Err(self.describe_unusable_vertex(corners));
        }
        let [first, end] = [lowest, highest].map(|class| count_planes_below(class, self.in_plane));
        if first < end && has_three_sides(corners) {
            let face = self.mesh.faces().face_of_half_edge(first_corner);
            alloc::push(&mut self.crossed_faces, CrossedFace { face, first_plane: first, end_plane: end })?;
        }
        Ok(())
    }
}

impl CrossedFaceFinder<'_> {
    #[cold]
    fn describe_unusable_vertex(&self, corners: &[u32]) -> Error {
        let vertex = corners.iter().copied().find(|&v| self.classes[v as usize] == UNUSABLE_VERTEX_CLASS).unwrap_or(0);
        let p = self.mesh.positions().get(vertex);
        let too_large = Component::find(p, |x| x.abs() > MAX_COORDINATE);
        let (component, value) = too_large.unwrap_or((Component::X, p.x));
        Error::CoordinateTooLarge { element: Element::Vertex, index: vertex.into(), component, value }
    }
}

/// Returns true if at least three sides of a face have different ends. Other faces have no inside,
/// and their neighbours count as adjacent.
#[inline(always)]
fn has_three_sides(corners: &[u32]) -> bool {
    let next = |i: usize| corners[if i + 1 < corners.len() { i + 1 } else { 0 }];
    (0..corners.len()).filter(|&i| corners[i] != next(i)).count() >= 3
}

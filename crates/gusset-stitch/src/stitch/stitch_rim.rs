//! A rim: a validated boundary loop, or an arc of one, to which a strip can be attached.

use super::facing::{Arc, centre};
use crate::boundary::{Boundary, EdgeFlags, Loop, LoopFlags};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::{Error, Result, Side};
use gusset_base::geom::kd_tree::KdTree;
use gusset_base::job::Job;
use gusset_mesh::MeshView;

/// A closed loop of free edges that passes each vertex once, with the surface on the left, or an
/// arc of such a loop.
pub struct Rim {
    /// True for a whole loop; false for an arc.
    pub(super) closed: bool,
    /// True if the caller gave the loop in the opposite direction.
    backwards: bool,
    pub(crate) vertices: Vec<u32>,
    /// The positions of the vertices, in a unit common to all rims of one stitch.
    pub(crate) points: Vec<DVec3>,
    /// For each edge from one place to the next, the unit normal of the face along it; 0 for a
    /// degenerate face.
    pub(crate) normals: Vec<DVec3>,
    /// A face on the rim.
    pub(super) face: u32,
    /// The mean over the rim of the unit vectors that lead off the surface, perpendicular to the
    /// rim. It is near 0 for a flat piece, whose rim leads off it on all sides. Its length is near
    /// 1 at the end of a tube.
    pub(super) outward: DVec3,
}

/// Loops with any of these flags cannot carry a strip.
const UNUSABLE_LOOP_FLAGS: u32 = LoopFlags::OPEN | LoopFlags::NON_MANIFOLD | LoopFlags::NOT_ORIENTED;

/// Returns true if `candidate` can carry a strip.
pub fn is_usable(candidate: &Loop<'_>) -> bool {
    !candidate.flags.any(UNUSABLE_LOOP_FLAGS) && candidate.vertices.len() >= 3
}

impl Rim {
    /// Creates a rim from a usable boundary loop.
    pub(crate) fn from_loop(mesh: &MeshView<'_>, found: &Loop<'_>) -> Result<Rim> {
        Rim::new(mesh, alloc::copied(found.vertices)?, found.faces, false)
    }

    /// Creates a rim from a loop given by the caller, in either direction.
    pub(super) fn from_vertices(mesh: &MeshView<'_>, edges: &FreeEdges, vertices: &[u32], side: Side) -> Result<Rim> {
        check_loop_indices(mesh, side as u32, vertices)?;
        let count = vertices.len();
        if count < 3 {
            return Err(Error::LoopTooShort { side, count: count as u32 });
        }
        let mut sorted = alloc::copied(vertices)?;
        sorted.sort_unstable();
        if let Some(pair) = sorted.windows(2).find(|pair| pair[0] == pair[1]) {
            return Err(Error::LoopRepeatsVertex { side, vertex: pair[0] });
        }

        // A face that runs an edge along the loop, and a face that runs one against it.
        let mut faces = [None, None];
        let mut along = alloc::with_capacity(count)?;
        for place in 0..count {
            let (u, v) = (vertices[place], vertices[(place + 1) % count]);
            let (way, face) = match (edges.face_along(u, v), edges.face_along(v, u)) {
                (Some(face), _) => (0, face),
                (None, Some(face)) => (1, face),
                (None, None) => return Err(Error::LoopEdgeNotFree { side, place: place as u32, vertex: u }),
            };
            faces[way] = Some(face);
            along.push(face);
        }
        let mut vertices = alloc::copied(vertices)?;
        match faces {
            [Some(_), Some(face)] => return Err(Error::LoopNotOriented { side, face }),
            [Some(_), None] => {}
            [None, _] => {
                vertices.reverse();
                // Edge i of the reversed loop is edge n - 2 - i of the given loop.
                along[..count - 1].reverse();
            }
        }
        Rim::new(mesh, vertices, &along, faces[1].is_some())
    }

    /// Creates a closed rim. `faces` has the face along each edge.
    fn new(mesh: &MeshView<'_>, vertices: Vec<u32>, faces: &[u32], backwards: bool) -> Result<Rim> {
        let points = alloc::collect(vertices.iter().map(|&v| mesh.positions().get(v)))?;
        let n = points.len();
        let outward = (0..n).map(|i| outward_direction(mesh, faces[i], points[i], points[(i + 1) % n])).sum::<DVec3>();
        let normals = alloc::collect(faces.iter().map(|&f| unit_normal(mesh, f)))?;
        Ok(Rim { closed: true, backwards, vertices, points, normals, face: faces[0], outward: outward / n as f64 })
    }

    /// Creates a rim from a polyline without a mesh. Its vertices are its places.
    pub(super) fn from_points(points: Vec<DVec3>, closed: bool) -> Result<Rim> {
        let edges = points.len() - usize::from(!closed);
        Ok(Rim {
            closed,
            backwards: false,
            vertices: alloc::collect((0..points.len()).map(|i| i as u32))?,
            normals: alloc::filled(DVec3::ZERO, edges)?,
            points,
            face: 0,
            outward: DVec3::ZERO,
        })
    }

    pub(crate) fn try_clone(&self) -> Result<Rim> {
        Ok(Rim {
            vertices: alloc::copied(&self.vertices)?,
            points: alloc::copied(&self.points)?,
            normals: alloc::copied(&self.normals)?,
            ..*self
        })
    }

    /// Returns the mean distance of the vertices from their centre.
    pub(crate) fn mean_radius(&self) -> f64 {
        let middle = centre(&self.points);
        self.points.iter().map(|p| p.distance(middle)).sum::<f64>() / self.points.len() as f64
    }

    pub(super) fn segment_count(&self) -> u32 {
        self.vertices.len() as u32 - u32::from(!self.closed)
    }

    /// Returns the position at place `i`. On a loop with N places, place N is place 0 again.
    pub(super) fn point(&self, i: u32) -> DVec3 {
        self.points[i as usize % self.points.len()]
    }

    /// Returns the sum of the edge lengths.
    pub(super) fn length(&self) -> f64 {
        (0..self.segment_count()).map(|k| self.point(k).distance(self.point(k + 1))).sum()
    }

    /// Returns the positions of all places, and for a loop the first again at the end.
    pub(super) fn closed_points(&self) -> Result<Vec<DVec3>> {
        alloc::collect((0..self.segment_count() as usize + 1).map(|i| self.point(i as u32)))
    }

    /// Cuts the rim to `arc`, whose places count along the loop as the caller gave it.
    pub(crate) fn cut_to_arc(&mut self, arc: Arc) -> Result<()> {
        let n = self.vertices.len();
        let last = (arc.first + arc.count - 1) % n;
        let arc = if self.backwards { Arc { first: n - 1 - last, ..arc } } else { arc };
        self.vertices = alloc::collect(arc.places(n).map(|i| self.vertices[i]))?;
        self.points = alloc::collect(arc.places(n).map(|i| self.points[i]))?;
        self.normals = alloc::collect(arc.places(n).map(|i| self.normals[i]))?;
        self.normals.truncate(arc.count - 1);
        self.closed = false;
        Ok(())
    }

    /// Returns the run of `count` vertices from place `first` on. `count` may exceed the number of
    /// vertices by one; the first vertex then comes last again.
    pub(crate) fn arc_of_run(&self, first: usize, count: usize) -> Result<Rim> {
        let n = self.vertices.len();
        let place = |k: usize| (first + k) % n;
        Ok(Rim {
            closed: false,
            vertices: alloc::collect((0..count).map(|k| self.vertices[place(k)]))?,
            points: alloc::collect((0..count).map(|k| self.points[place(k)]))?,
            normals: alloc::collect((0..count.saturating_sub(1)).map(|k| self.normals[place(k)]))?,
            ..*self
        })
    }

    pub(crate) fn reverse(&mut self) {
        self.vertices.reverse();
        self.points.reverse();
        self.normals.reverse();
        if self.closed {
            // Edge k now leads from old place n - 1 - k to n - 2 - k: it was edge n - 2 - k.
            self.normals.rotate_left(1);
        }
    }

    /// Adapts the rim to a surface that has been turned over: reverses it, so that the surface is
    /// on the left again.
    pub(crate) fn adapt_to_turned_surface(&mut self) {
        self.reverse();
        self.normals.iter_mut().for_each(|normal| *normal = -*normal);
    }

    /// Makes place `first` the new place 0.
    pub(super) fn rotate_to_start_at(&mut self, first: usize) {
        self.vertices.rotate_left(first);
        self.points.rotate_left(first);
        self.normals.rotate_left(first);
    }
}

/// Returns the unit vector that leads off face `f` across its edge from `p` to `q`, perpendicular
/// to the edge; 0 for a degenerate face.
fn outward_direction(mesh: &MeshView<'_>, f: u32, p: DVec3, q: DVec3) -> DVec3 {
    let corners = mesh.face(f as usize).map(|v| mesh.positions().get(v));
    // Scale by the face's own size, to avoid overflow.
    let reach = corners.clone().map(|c| (c - p).abs().max_element()).fold(0.0, f64::max);
    let count = corners.len() as f64;
    let inwards = corners.map(|c| (c - p) / reach).sum::<DVec3>() / count;
    let along = ((q - p) / reach).normalize_or_zero();
    -(inwards - along * inwards.dot(along)).normalize_or_zero()
}

/// Returns the unit normal of face `f` by its vector area; 0 for a degenerate face.
fn unit_normal(mesh: &MeshView<'_>, f: u32) -> DVec3 {
    let mut corners = mesh.face(f as usize).map(|v| mesh.positions().get(v));
    let Some(first) = corners.next() else {
        return DVec3::ZERO;
    };
    let reach = corners.clone().map(|c| (c - first).abs().max_element()).fold(0.0, f64::max);
    let arms = corners.map(|c| (c - first) / reach);
    let area = arms.clone().zip(arms.skip(1)).map(|(p, q)| p.cross(q)).sum::<DVec3>();
    // If all corners coincide, the arms are 0 / 0.
    if area.is_finite() { area.normalize_or_zero() } else { DVec3::ZERO }
}

/// Returns a vertex that both rims of one mesh pass.
pub fn shared_vertex(a: &Rim, b: &Rim) -> Result<Option<u32>> {
    let mut sorted = alloc::copied(&a.vertices)?;
    sorted.sort_unstable();
    Ok(b.vertices.iter().copied().filter(|v| sorted.binary_search(v).is_ok()).min())
}

/// Returns true if a vertex of `a` is at most `tolerance` from a vertex of `b`. O((n + m) log m).
pub(crate) fn have_coincident_vertices(a: &Rim, b: &Rim, tolerance: f64, job: &Job<'_>) -> Result<bool> {
    const STAGE: &str = "comparing loops";
    let tree = KdTree::new(&b.points, &job.sub_job(0.0, 0.5), STAGE)?;
    let job = job.sub_job(0.5, 1.0);
    for (k, &p) in a.points.iter().enumerate() {
        job.step_within_list(k, STAGE)?;
        if tree.nearest(p, f64::INFINITY, |_| true).is_some_and(|(squared, _)| squared.sqrt() <= tolerance) {
            return Ok(true);
        }
    }
    Ok(false)
}

/// Checks that a mesh has all vertices of the caller's loop `number`. Fails with
/// [`Error::LoopIndexOutOfRange`].
pub(crate) fn check_loop_indices(mesh: &MeshView<'_>, number: u32, vertices: &[u32]) -> Result<()> {
    let count = mesh.positions().len() as u32;
    match (0..).zip(vertices).find(|&(_, &vertex)| vertex >= count) {
        Some((place, &vertex)) => Err(Error::LoopIndexOutOfRange { number, place, vertex, count }),
        None => Ok(()),
    }
}

/// The edges with exactly one face, sorted by their ends in the direction of that face.
pub(crate) struct FreeEdges(Vec<(u32, u32, u32)>);

impl FreeEdges {
    pub(crate) fn from_boundary(boundary: &Boundary) -> Result<Self> {
        let mut edges = alloc::with_capacity(boundary.edge_count())?;
        for found in boundary.iter() {
            for (i, (&face, &flags)) in found.faces.iter().zip(found.edge_flags).enumerate() {
                let (u, v) = (found.vertices[i], found.vertices[(i + 1) % found.vertices.len()]);
                if flags & EdgeFlags::NON_MANIFOLD == 0 {
                    edges.push(if flags & EdgeFlags::REVERSED == 0 { (u, v, face) } else { (v, u, face) });
                }
            }
        }
        edges.sort_unstable();
        Ok(FreeEdges(edges))
    }

    /// Returns the face that runs the free edge from `u` to `v` in this direction.
    pub(crate) fn face_along(&self, u: u32, v: u32) -> Option<u32> {
        let at = self.0.partition_point(|&(a, b, _)| (a, b) < (u, v));
        self.0.get(at).filter(|&&(a, b, _)| (a, b) == (u, v)).map(|&(_, _, face)| face)
    }
}

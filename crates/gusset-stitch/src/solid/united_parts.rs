//! Faces that intersect: the closed components are replaced by their union.
//!
//! Faces that no other meets stay as they are, also faces with more than three corners.

use super::corner_place::CornerPlace;
use super::repair_request::DropReason;
use super::repair_state::RepairState;
use crate::arrange::{Options, Union, unite, unite_with_suspects};
use crate::check::find_intersecting_faces;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::geom::bit_set::BitSet;
use gusset_base::geom::disjoint_sets::DisjointSets;
use gusset_base::job::Job;
use gusset_base::sort::{Buckets, sort, sort_distinct};
use gusset_mesh::{FaceTriangles, Mesh, MeshView, NONE, Opposite, Topology};

const STAGE: &str = "uniting parts";

/// Unites the closed components if faces of them intersect. Returns the pairs of faces that intersect if nothing
/// changes, and `None` otherwise. A component that would lose most of its faces by itself stays: a folded sheet that
/// was closed, for example. All stay if rounding makes at least as many intersections as the union removes.
pub(super) fn unite_parts(state: &mut RepairState, job: &Job<'_>) -> Result<Option<Vec<[u32; 2]>>> {
    let (closed, union) = {
        let view = state.mesh.view(&job.sub_job(0.0, 0.05))?;
        let pairs = find_intersecting_faces(&view, &job.sub_job(0.05, 0.2))?;
        if pairs.is_empty() {
            return Ok(Some(pairs));
        }
        let (is_closed, components) = closed_faces(&view, &job.sub_job(0.2, 0.3))?;
        let meets = BitSet::new(view.faces().len())?;
        let mut parts = ClosedParts { mesh: &state.mesh, components, is_closed, meets_others: meets };
        if parts.count_closed(&pairs) == 0 {
            return Ok(Some(pairs));
        }
        pairs.as_flattened().iter().for_each(|&f| parts.meets_others.insert(f));
        // Triangles of one face may overlap.
        let polygons = (0..view.faces().len()).filter(|&f| view.faces().corner_range(f).len() > 3);
        polygons.for_each(|f| parts.meets_others.insert(f as u32));
        let Some((mut closed, mut union)) = parts.unite_all(&job.sub_job(0.3, 0.5))? else { return Ok(Some(pairs)) };
        let lost = parts.components_to_drop(&pairs, &closed, &union, &job.sub_job(0.5, 0.7))?;
        if !lost.is_empty() {
            let is_lost = |f: usize| lost.binary_search(&parts.components[f]).is_ok();
            (0..parts.is_closed.len()).filter(|&f| is_lost(f)).for_each(|f| parts.is_closed[f] = false);
            if parts.count_closed(&pairs) == 0 {
                return Ok(Some(pairs));
            }
            let Some(united) = parts.unite_all(&job.sub_job(0.7, 0.9))? else { return Ok(Some(pairs)) };
            (closed, union) = united;
        }
        if union.intersections.len() >= parts.count_closed(&pairs) {
            return Ok(Some(pairs));
        }
        (closed, union)
    };
    UnitedParts::new(&state.mesh, &closed, &union, &job.sub_job(0.9, 0.92))?
        .put_into(state, &job.sub_job(0.92, 1.0))?;
    Ok(None)
}

/// Replaces all faces by their union.
///
/// # Errors
/// [`Error::MeshNotClosed`](gusset_base::Error::MeshNotClosed) with a face of the whole mesh.
pub(super) fn unite_all_faces(state: &mut RepairState, job: &Job<'_>) -> Result<()> {
    let union = unite(&state.mesh.view(&job.sub_job(0.0, 0.05))?, &Options::default(), &job.sub_job(0.05, 0.9))?;
    let all = alloc::collect((0..state.mesh.face_count()).map(|f| f as u32))?;
    UnitedParts::new(&state.mesh, &all, &union, &job.sub_job(0.9, 0.92))?.put_into(state, &job.sub_job(0.92, 1.0))
}

/// The closed components of a mesh.
struct ClosedParts<'m> {
    mesh: &'m Mesh,
    /// The smallest face of each face's component.
    components: Vec<u32>,
    /// Whether the component of each face is closed.
    is_closed: Vec<bool>,
    /// The faces that may intersect others.
    meets_others: BitSet,
}

impl ClosedParts<'_> {
    /// Returns the number of pairs of closed faces.
    fn count_closed(&self, pairs: &[[u32; 2]]) -> usize {
        pairs.iter().filter(|pair| pair.iter().all(|&f| self.is_closed[f as usize])).count()
    }

    /// Returns the closed faces, and their union if it exists.
    fn unite_all(&self, job: &Job<'_>) -> Result<Option<(Vec<u32>, Union)>> {
        let closed = alloc::gather((0..).zip(&self.is_closed).filter(|&(_, &is_closed)| is_closed).map(|(f, _)| f))?;
        let union = self.unite(&closed, job)?;
        Ok(union.map(|union| (closed, union)))
    }

    /// Returns the union of some faces, whose vertices originate from the whole mesh. Returns `None` if the faces
    /// with an area are not closed: the gaps between them are narrower than rounding.
    fn unite(&self, faces: &[u32], job: &Job<'_>) -> Result<Option<Union>> {
        let (part, vertices) = select_faces(self.mesh, faces, &job.sub_job(0.0, 0.1))?;
        let mut meets = BitSet::new(faces.len())?;
        (0..).zip(faces).filter(|&(_, &f)| self.meets_others.contains(f)).for_each(|(k, _)| meets.insert(k));
        let part = part.view(&job.sub_job(0.1, 0.15))?;
        let mut union = match unite_with_suspects(&part, Some(&meets), &Options::default(), &job.sub_job(0.15, 1.0)) {
            Err(Error::MeshNotClosed { .. }) => return Ok(None),
            union => union?,
        };
        union.vertex_origins.iter_mut().filter(|v| **v != NONE).for_each(|v| *v = vertices[*v as usize]);
        Ok(Some(union))
    }

    /// Returns the components that intersect themselves and lose more than half of their faces, both in the union of
    /// `closed` and by themselves, in ascending order.
    fn components_to_drop(&self, pairs: &[[u32; 2]], closed: &[u32], union: &Union, job: &Job<'_>) -> Result<Vec<u32>> {
        let root = |f: u32| self.components[f as usize];
        let dropped = alloc::collect(union.dropped_faces.iter().map(|&k| root(closed[k as usize])))?;
        let mut losers = components_that_lose_most(&self.components, dropped)?;
        let mut folded = alloc::gather(pairs.iter().filter(|[f, g]| root(*f) == root(*g)).map(|[f, _]| root(*f)))?;
        sort_distinct(&mut folded);
        losers.retain(|loser| folded.binary_search(loser).is_ok());
        let own = (0..).zip(&self.components).filter_map(|(f, root)| Some((losers.binary_search(root).ok()?, f)));
        let own = Buckets::new(losers.len(), 0u32, own)?;
        let mut lost = Vec::new();
        for (k, &loser) in losers.iter().enumerate() {
            let faces = own.get(k);
            let union = self.unite(faces, &job.sub_job_of_item(k, losers.len()))?;
            if union.is_none_or(|union| 2 * union.dropped_faces.len() > faces.len()) {
                alloc::push(&mut lost, loser)?;
            }
        }
        Ok(lost)
    }
}

/// Returns the components that have lost more than half of their faces. `dropped` are the components
/// of the dropped faces.
fn components_that_lose_most(components: &[u32], mut dropped: Vec<u32>) -> Result<Vec<u32>> {
    let mut counts = alloc::filled(0u32, components.len())?;
    components.iter().for_each(|&root| counts[root as usize] += 1);
    dropped.sort_unstable();
    let most = dropped.chunk_by(|a, b| a == b).filter(|group| 2 * group.len() > counts[group[0] as usize] as usize);
    alloc::gather(most.map(|group| group[0]))
}

/// Returns for each face whether its component is closed, manifold along edges and oriented, and the
/// smallest face of its component.
fn closed_faces(mesh: &MeshView<'_>, job: &Job<'_>) -> Result<(Vec<bool>, Vec<u32>)> {
    let topology = Topology::new(mesh, &job.sub_job(0.0, 0.5))?;
    let faces = mesh.faces();
    let mut sets = DisjointSets::new(faces.len())?;
    let mut is_closed = alloc::filled(true, faces.len())?;
    for h in 0..faces.half_edge_count() as u32 {
        job.sub_job(0.5, 0.8).step_within_list(h as usize, STAGE)?;
        let f = faces.face_of_half_edge(h);
        match topology.opposite(h) {
            Opposite::Mate(mate) if mate != h && faces.corner(h) != faces.corner(mate) => {
                sets.union(f, faces.face_of_half_edge(mate));
            }
            _ => is_closed[f as usize] = false,
        }
    }
    let components = sets.into_roots(&job.sub_job(0.8, 1.0), STAGE)?;
    for f in 0..faces.len() {
        is_closed[components[f] as usize] &= is_closed[f];
    }
    let of_faces = alloc::collect(components.iter().map(|&root| is_closed[root as usize]))?;
    Ok((of_faces, components))
}

/// Returns a mesh of some faces, and its vertices in the whole mesh.
fn select_faces(mesh: &Mesh, faces: &[u32], job: &Job<'_>) -> Result<(Mesh, Vec<u32>)> {
    let (mut offsets, mut corners) = (vec![0], Vec::new());
    for &f in faces {
        alloc::append(&mut corners, face_corners(mesh, f))?;
        alloc::push(&mut offsets, corners.len() as u32)?;
    }
    let mut vertices = alloc::copied(&corners)?;
    sort(&mut vertices, Ord::cmp, &job.sub_job(0.0, 0.7), STAGE)?;
    vertices.dedup();
    for (k, v) in corners.iter_mut().enumerate() {
        job.sub_job(0.7, 1.0).step_within_list(k, STAGE)?;
        *v = vertices.partition_point(|&other| other < *v) as u32;
    }
    Ok((Mesh::new(mesh.positions.select_vertices(&vertices)?, offsets, corners), vertices))
}

fn face_corners(mesh: &Mesh, f: u32) -> &[u32] {
    &mesh.face_corners[mesh.face_offsets[f as usize] as usize..mesh.face_offsets[f as usize + 1] as usize]
}

/// The closed faces of a mesh, and their union.
struct UnitedParts<'a> {
    closed: &'a [u32],
    union: &'a Union,
    /// The corners of the triangles of all faces, by half-edges.
    triangles: Vec<[u32; 3]>,
}

/// Faces in the making, each with the old face and the origins of its corners.
#[derive(Default)]
struct FaceList {
    offsets: Vec<u32>,
    corners: Vec<u32>,
    corner_places: Vec<CornerPlace>,
    faces: Vec<u32>,
}

impl FaceList {
    fn push(&mut self, face: u32, corners: impl Iterator<Item = (u32, CornerPlace)>) -> Result<()> {
        for (v, place) in corners {
            alloc::push(&mut self.corners, v)?;
            alloc::push(&mut self.corner_places, place)?;
        }
        alloc::push(&mut self.offsets, self.corners.len() as u32)?;
        alloc::push(&mut self.faces, face)
    }
}

impl<'a> UnitedParts<'a> {
    fn new(mesh: &Mesh, closed: &'a [u32], union: &'a Union, job: &Job<'_>) -> Result<Self> {
        let triangles =
            FaceTriangles::with_half_edges(&mesh.view(&job.sub_job(0.0, 0.2))?, &job.sub_job(0.2, 1.0))?.corners;
        Ok(UnitedParts { closed, union, triangles })
    }

    /// Replaces the closed faces of the state by their union.
    fn put_into(&self, state: &mut RepairState, job: &Job<'_>) -> Result<()> {
        let vertices = self.number_vertices(state)?;
        let mesh = &state.mesh;
        // The triangles of the union from each closed face.
        let triangles = self.union.face_origins.iter().enumerate().map(|(t, &k)| (k as usize, t as u32));
        let triangles = Buckets::new_cancellable(self.closed.len(), 0u32, triangles, &job.sub_job(0.0, 0.3), STAGE)?;
        let mut list = FaceList { offsets: vec![0], ..FaceList::default() };
        let (mut next, mut scratch) = (0, Vec::new());
        for f in 0..mesh.face_count() as u32 {
            job.sub_job(0.3, 1.0).step_within_list(f as usize, STAGE)?;
            let first = mesh.face_offsets[f as usize];
            let old = face_corners(mesh, f);
            let place = |k: usize| state.corner_places[first as usize + k];
            if self.closed.get(next) != Some(&f) {
                list.push(f, old.iter().enumerate().map(|(k, &v)| (v, place(k))))?;
                continue;
            }
            let parts = triangles.get(next);
            next += 1;
            if self.is_unchanged(mesh, f, parts, &vertices, &mut scratch)? {
                list.push(f, old.iter().enumerate().map(|(k, _)| (scratch[k], place(k))))?;
                continue;
            }
            for &t in parts {
                let corners = self.union.mesh.face_corners[3 * t as usize..3 * t as usize + 3].iter();
                let source = |v: u32| {
                    let old_vertex = self.union.vertex_origins[v as usize];
                    old.iter().position(|&u| u == old_vertex).map_or_else(
                        || {
                            let (corners, weights) = self.coordinates_on_face(mesh, f, v);
                            CornerPlace::mean([0, 1, 2].map(|k| (place(corners[k]), weights[k])))
                        },
                        place,
                    )
                };
                list.push(f, corners.map(|&v| (vertices[v as usize], source(v))))?;
            }
        }
        let mut remains = alloc::filled(false, state.mesh.face_count())?;
        list.faces.iter().for_each(|&f| remains[f as usize] = true);
        for f in (0..remains.len()).filter(|&f| !remains[f]) {
            state.list_dropped(f, DropReason::Overlap)?;
        }
        state.changes += 1;
        state.face_origin = alloc::collect(list.faces.iter().map(|&f| state.face_origin[f as usize]))?;
        state.turned = alloc::collect(list.faces.iter().map(|&f| state.turned[f as usize]))?;
        state.corner_places = list.corner_places;
        (state.mesh.face_offsets, state.mesh.face_corners) = (list.offsets, list.corners);
        Ok(())
    }

    /// Returns the vertex of the state for each vertex of the union. The first of several copies of
    /// a vertex keeps its number; new vertices are appended.
    fn number_vertices(&self, state: &mut RepairState) -> Result<Vec<u32>> {
        let mut is_taken = alloc::filled(false, state.mesh.positions.len())?;
        let mut numbers = alloc::with_capacity(self.union.vertex_origins.len())?;
        let mut parents = alloc::filled(NONE, self.union.vertex_origins.len())?;
        for (t, triangle) in self.union.mesh.face_corners.chunks_exact(3).enumerate() {
            let face = self.closed[self.union.face_origins[t] as usize];
            triangle.iter().for_each(|&v| parents[v as usize] = parents[v as usize].min(face));
        }
        let (mut copies, mut new) = (Vec::new(), Vec::new());
        let old = state.mesh.positions.len() as u32;
        for (v, &origin) in self.union.vertex_origins.iter().enumerate() {
            if origin == NONE {
                numbers.push(NONE);
                alloc::push(&mut new, v as u32)?;
            } else if std::mem::replace(&mut is_taken[origin as usize], true) {
                numbers.push(old + copies.len() as u32);
                alloc::push(&mut copies, origin)?;
            } else {
                numbers.push(origin);
            }
        }
        state.copy_vertices(&copies)?;
        let first = state.mesh.positions.len() as u32;
        let points = new.iter().map(|&v| self.union.mesh.positions.get(v));
        state.mesh.positions.extend(points)?;
        alloc::grow(&mut state.vertex_origin, first as usize + new.len(), NONE)?;
        for (number, &v) in (first..).zip(&new) {
            numbers[v as usize] = number;
            let face = parents[v as usize];
            let (corners, weights) = self.coordinates_on_face(&state.mesh, face, v);
            let parents = corners.map(|k| face_corners(&state.mesh, face)[k]);
            alloc::push(&mut state.new_vertices, (number, parents, weights))?;
        }
        Ok(numbers)
    }

    /// Returns three corners of a face of the mesh, and the barycentric coordinates of a vertex of
    /// the union on them, not negative. They are the corners of the triangle of the face in which the vertex lies, or
    /// of the nearest one.
    fn coordinates_on_face(&self, mesh: &Mesh, face: u32, v: u32) -> ([usize; 3], [f64; 3]) {
        let (corners, x) = (face_corners(mesh, face), self.union.mesh.positions.get(v));
        let first = mesh.face_offsets[face as usize];
        // A face of n corners has n - 2 triangles.
        let triangles = &self.triangles[first as usize - 2 * face as usize..][..corners.len() - 2];
        let coordinates = |triangle: &[u32; 3]| {
            let [p, q, r] = triangle.map(|h| mesh.positions.get(mesh.face_corners[h as usize]));
            let normal = (q - p).cross(r - p);
            let area = |u: DVec3, w: DVec3| (u - x).cross(w - x).dot(normal) / normal.length_squared();
            let distance = (x - p).dot(normal) / normal.length();
            ([area(q, r), area(r, p), area(p, q)], distance.abs())
        };
        let size = 1.0 + x.abs().max_element();
        // The vertex lies on the plane of its triangle, up to rounding, and inside.
        let misfit = |(weights, distance): &([f64; 3], f64)| {
            weights.iter().fold(distance / size, |misfit: f64, weight| misfit.max(-weight))
        };
        let fits = triangles.iter().map(|triangle| (triangle, coordinates(triangle)));
        let best = fits.min_by(|(_, a), (_, b)| misfit(a).total_cmp(&misfit(b)));
        let (triangle, weights) = best.map_or(([first; 3], [1.0, 0.0, 0.0]), |(&t, (weights, _))| (t, weights));
        let weights = weights.map(|weight| weight.max(0.0));
        let sum: f64 = weights.iter().sum();
        let is_normal = sum > 0.0 && sum.is_finite();
        let weights = if is_normal { weights.map(|weight| weight / sum) } else { [1.0, 0.0, 0.0] };
        (triangle.map(|h| (h - first) as usize), weights)
    }

    /// Returns true if the union has exactly the triangles of the face's own corners. `corners`
    /// receives the vertex of each corner.
    fn is_unchanged(
        &self,
        mesh: &Mesh,
        f: u32,
        parts: &[u32],
        vertices: &[u32],
        corners: &mut Vec<u32>,
    ) -> Result<bool> {
        let old = face_corners(mesh, f);
        corners.clear();
        if parts.len() + 2 != old.len() {
            return Ok(false);
        }
        let found = || parts.iter().flat_map(|&t| &self.union.mesh.face_corners[3 * t as usize..3 * t as usize + 3]);
        for &v in old {
            let mut own = found().filter(|&&u| self.union.vertex_origins[u as usize] == v);
            let Some(&first) = own.next() else { return Ok(false) };
            if own.any(|&other| other != first) {
                return Ok(false);
            }
            alloc::push(corners, vertices[first as usize])?;
        }
        Ok(found().all(|&u| old.contains(&self.union.vertex_origins[u as usize])))
    }
}

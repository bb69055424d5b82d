//! The kept faces of a piece, made a surface to which strips can be attached. It is without parts
//! thinner than two faces, small islands, and faces that meet only in a vertex.

use super::STAGE;
use super::trim_request::SPARE_ISLAND_FACTOR;
use crate::align::CentredPiece;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::bit_set::BitSet;
use gusset_base::geom::disjoint_sets::DisjointSets;
use gusset_base::job::Job;
use gusset_base::sort::sort;
use gusset_mesh::{MeshView, NONE, Opposite, Topology, half_edges};

/// Small components with this many times fewer faces than the largest component are islands too.
const MIN_DEBRIS_SIZE_RATIO: u32 = 10;
/// Largest number of rounds that remove faces attached by one side, or meeting others only in a
/// vertex.
const MAX_CLEANING_ROUNDS: usize = 20;

/// The rims of the kept faces: vertices, and the midpoints of edges.
#[derive(Default)]
pub(super) struct KeptFaceRims {
    pub(super) points: Vec<DVec3>,
    /// The normals at these points, not normalised.
    pub(super) normals: Vec<DVec3>,
}

/// A subset of a piece's faces.
pub(super) struct KeptFaces<'m, 'a> {
    mesh: &'m MeshView<'a>,
    /// For each half-edge, the face on its other side, or [`NONE`].
    face_across_half_edge: Vec<u32>,
    pub(super) is_kept_face: Vec<bool>,
    /// True for faces that are removed for good.
    pub(super) is_lost_face: Vec<bool>,
    /// True for removed faces that are not restored, and for restored ones that are not spared.
    is_settled_face: Vec<bool>,
    /// For each face, the number of faces of its component in the piece. `largest_component` is their
    /// maximum.
    component_of_face: Vec<u32>,
    largest_component: u32,
}

impl<'m, 'a> KeptFaces<'m, 'a> {
    /// Starts with all faces. O(H log d).
    pub(super) fn new(mesh: &'m MeshView<'a>, job: &Job<'_>) -> Result<KeptFaces<'m, 'a>> {
        let topology = Topology::new(mesh, &job.sub_job(0.0, 0.5))?;
        let count = mesh.faces().len();
        let mut face_of = alloc::filled(NONE, mesh.faces().half_edge_count())?;
        for f in 0..count {
            job.sub_job(0.5, 0.5).step_within_list(f, STAGE)?;
            face_of[mesh.faces().corner_range(f)].fill(f as u32);
        }
        let beyond = |h| match topology.opposite(h) {
            Opposite::Mate(mate) => face_of[mate as usize],
            _ => NONE,
        };
        let halves = 0..face_of.len() as u32;
        let across = alloc::collect_cancellable(halves.map(beyond), &job.sub_job(0.5, 0.5), STAGE)?;
        let mut region = KeptFaces {
            mesh,
            face_across_half_edge: across,
            is_kept_face: alloc::filled(true, count)?,
            is_lost_face: alloc::filled(false, count)?,
            is_settled_face: alloc::filled(false, count)?,
            component_of_face: Vec::new(),
            largest_component: 0,
        };
        let sizes =
            region.component_sizes_within(&region.is_kept_face, &region.is_kept_face, &job.sub_job(0.5, 1.0))?;
        region.component_of_face = alloc::collect(sizes.iter().map(|size| size[0]))?;
        region.largest_component = region.component_of_face.iter().copied().max().unwrap_or(0);
        Ok(region)
    }

    /// Returns the faces across the sides of a face; [`NONE`] for missing ones.
    fn faces_across_sides(&self, f: usize) -> &[u32] {
        &self.face_across_half_edge[self.mesh.faces().corner_range(f)]
    }

    fn is_kept(&self, f: u32) -> bool {
        f != NONE && self.is_kept_face[f as usize]
    }

    /// Keeps the faces whose vertices are all wanted, except removed faces and faces with a barred
    /// vertex. Small holes are filled, and small islands are removed for good. Returns true if
    /// there were any.
    ///
    /// `shown` marks vertices that later pieces show as well. Fewer than `min_faces` faces are
    /// small. O(rounds * H).
    pub(super) fn keep_faces_where(
        &mut self,
        wanted: &[bool],
        barred: &[bool],
        shown: &[bool],
        min_faces: u32,
        job: &Job<'_>,
    ) -> Result<bool> {
        let may_keep = |f: usize| !self.is_lost_face[f] && !self.mesh.face(f).any(|v| barred[v as usize]);
        let may =
            alloc::collect_cancellable((0..self.is_kept_face.len()).map(may_keep), &job.sub_job(0.0, 0.0), STAGE)?;
        for (f, keeps) in self.is_kept_face.iter_mut().enumerate() {
            job.step_within_list(f, STAGE)?;
            *keeps = may[f] && !self.mesh.face(f).all(|v| wanted[v as usize]);
        }
        job.step(0.1, STAGE)?;
        let holes = self.component_sizes_within(&self.is_kept_face, &self.is_kept_face, job)?;
        for f in 0..self.is_kept_face.len() {
            // A gap larger than half a component is not a hole in it.
            let is_hole = 2 * holes[f][0] < self.component_of_face[f];
            let is_small_hole =
                self.is_kept_face[f] && is_hole && holes[f][0] < SPARE_ISLAND_FACTOR.saturating_mul(min_faces);
            self.is_kept_face[f] = may[f] && (!self.is_kept_face[f] || is_small_hole);
        }
        job.step(0.3, STAGE)?;
        self.remove_thin_parts(job)?;
        for _ in 0..MAX_CLEANING_ROUNDS {
            job.step(0.5, STAGE)?;
            if !self.remove_faces_attached_by_one_side(job)? & !self.remove_smaller_fans_at_pinches(job)? {
                break;
            }
        }
        // Count the faces of each island that no other piece shows.
        let is_needed = |f: usize| self.is_settled_face[f] || !self.mesh.face(f).all(|v| shown[v as usize]);
        let needed =
            alloc::collect_cancellable((0..self.is_kept_face.len()).map(is_needed), &job.sub_job(0.8, 0.8), STAGE)?;
        let islands = self.component_sizes_within(&self.is_kept_face, &needed, job)?;
        let mut any = false;
        for (f, &[size, needed]) in islands.iter().enumerate() {
            // Islands that other pieces show too can be spared.
            let least = if 2 * needed < size { SPARE_ISLAND_FACTOR.saturating_mul(min_faces) } else { min_faces };
            // The only component of a small piece is not an island; beside large components it is
            // debris.
            let is_own = size == self.component_of_face[f]
                && size.saturating_mul(MIN_DEBRIS_SIZE_RATIO) >= self.largest_component;
            let is_island = self.is_kept_face[f] && size < least && !is_own;
            self.is_kept_face[f] &= !is_island;
            self.is_lost_face[f] |= is_island;
            any |= is_island;
        }
        Ok(any)
    }

    /// Visits the rim edges of the kept faces, with their faces.
    pub(super) fn visit_rim_edges(&self, mut visit: impl FnMut(u32, [u32; 2]) -> Result<()>) -> Result<()> {
        for f in (0..self.is_kept_face.len()).filter(|&f| self.is_kept_face[f]) {
            for ((_, u, v), &g) in half_edges(self.mesh, f).zip(self.faces_across_sides(f)) {
                if !self.is_kept(g) {
                    visit(f as u32, [u, v])?;
                }
            }
        }
        Ok(())
    }

    /// Adds the rim of the kept faces: cut edges, beyond which a face was removed, and border
    /// edges.
    pub(super) fn add_rim_points(
        &self,
        scan: &CentredPiece,
        [cut, border]: &mut [KeptFaceRims; 2],
        job: &Job<'_>,
    ) -> Result<()> {
        for f in (0..self.is_kept_face.len()).filter(|&f| self.is_kept_face[f]) {
            job.step_within_list(f, STAGE)?;
            for ((_, u, v), &g) in half_edges(self.mesh, f).zip(self.faces_across_sides(f)) {
                if !self.is_kept(g) {
                    let [p, q] = [u, v].map(|v| scan.points[v as usize]);
                    let [m, n] = [u, v].map(|v| scan.normals[v as usize]);
                    let out = if g == NONE { &mut *border } else { &mut *cut };
                    // Add both ends, because the next edge may be of the other kind.
                    alloc::append(&mut out.points, &[p, p.midpoint(q), q])?;
                    alloc::append(&mut out.normals, &[m, m + n, n])?;
                }
            }
        }
        Ok(())
    }

    /// Smooths values at vertices over faces, in `passes` passes.
    pub(super) fn smooth_vertex_values(&self, values: &mut [f64], passes: usize, job: &Job<'_>) -> Result<()> {
        let mut sums = alloc::filled((0.0, 0.0), values.len())?;
        for pass in 0..passes {
            job.step(pass as f64 / passes as f64, STAGE)?;
            sums.fill((0.0, 0.0));
            for f in 0..self.is_kept_face.len() {
                job.sub_job(1.0, 1.0).step_within_list(f, STAGE)?;
                let face = self.mesh.face(f);
                let count = face.len() as f64;
                let sum: f64 = face.clone().map(|v| values[v as usize]).sum();
                face.for_each(|v| {
                    let (total, weight) = sums[v as usize];
                    sums[v as usize] = (total + sum, weight + count);
                });
            }
            for (value, &(total, weight)) in values.iter_mut().zip(&sums) {
                if weight > 0.0 {
                    *value = total / weight;
                }
            }
        }
        Ok(())
    }

    /// Restores removed islands where no other face is kept now; whole islands if that is a large
    /// part of them. Returns true if there are any.
    ///
    /// `on` marks vertices that lie on kept faces of other pieces. Fewer than `min_faces` faces are
    /// small.
    pub(super) fn restore_islands(&mut self, on: &[bool], min_faces: u32, job: &Job<'_>) -> Result<bool> {
        let count = self.is_kept_face.len();
        let spared = alloc::collect((0..count).map(|f| self.is_lost_face[f] && !self.is_settled_face[f]))?;
        let is_bare = |f: usize| spared[f] && !self.mesh.face(f).any(|v| on[v as usize]);
        let bare = alloc::collect_cancellable((0..count).map(is_bare), &job.sub_job(0.0, 0.0), STAGE)?;
        let islands = self.component_sizes_within(&spared, &bare, job)?;
        let places = self.component_sizes_within(&bare, &bare, job)?;
        let mut any = false;
        for f in (0..count).filter(|&f| spared[f]) {
            let ([all, without], [place, _]) = (islands[f], places[f]);
            if 3 * without > all || place >= min_faces {
                (self.is_lost_face[f], self.is_settled_face[f], any) = (false, true, true);
            }
        }
        Ok(any)
    }

    /// Returns for each face of `among` the size of its component in `among`, and the number of
    /// `counted` faces in it; zeros for other faces.
    fn component_sizes_within(&self, among: &[bool], counted: &[bool], job: &Job<'_>) -> Result<Vec<[u32; 2]>> {
        let count = among.len();
        let mut sets = DisjointSets::new(count)?;
        for f in (0..count).filter(|&f| among[f]) {
            job.step_within_list(f, STAGE)?;
            for &g in self.faces_across_sides(f).iter().filter(|&&g| g != NONE && among[g as usize]) {
                sets.union(f as u32, g);
            }
        }
        let roots = sets.into_roots(job, STAGE)?;
        let mut sums = alloc::filled([0u32; 2], count)?;
        for f in (0..count).filter(|&f| among[f]) {
            job.sub_job(1.0, 1.0).step_within_list(f, STAGE)?;
            let sum = &mut sums[roots[f] as usize];
            *sum = [sum[0] + 1, sum[1] + u32::from(counted[f])];
        }
        let of = |f: usize| if among[f] { sums[roots[f] as usize] } else { [0; 2] };
        alloc::collect_cancellable((0..count).map(of), &job.sub_job(1.0, 1.0), STAGE)
    }

    /// Removes faces for good, and all faces that share a vertex with them.
    pub(super) fn remove_with_neighbours_for_good(&mut self, faces: &[u32]) -> Result<()> {
        let mut gone = BitSet::new(self.mesh.positions().len())?;
        faces.iter().for_each(|&f| self.mesh.face(f as usize).for_each(|v| gone.insert(v)));
        for f in 0..self.is_kept_face.len() {
            if self.mesh.face(f).any(|v| gone.contains(v)) {
                (self.is_kept_face[f], self.is_lost_face[f], self.is_settled_face[f]) = (false, true, true);
            }
        }
        Ok(())
    }

    /// Removes parts thinner than two faces: keeps only the faces around inner vertices.
    fn remove_thin_parts(&mut self, job: &Job<'_>) -> Result<()> {
        let count = self.mesh.positions().len();
        // A vertex is inside if all faces around it are kept.
        let mut inside = alloc::filled(true, count)?;
        for f in (0..self.is_kept_face.len()).filter(|&f| !self.is_kept_face[f]) {
            job.sub_job(0.4, 0.4).step_within_list(f, STAGE)?;
            self.mesh.face(f).for_each(|v| inside[v as usize] = false);
        }
        job.step(0.4, STAGE)?;
        for f in 0..self.is_kept_face.len() {
            job.sub_job(0.4, 0.4).step_within_list(f, STAGE)?;
            self.is_kept_face[f] = self.is_kept_face[f] && self.mesh.face(f).any(|v| inside[v as usize]);
        }
        Ok(())
    }

    /// Removes faces with at most one side at a kept face and at least one side at a removed face.
    /// Returns true if there were any.
    fn remove_faces_attached_by_one_side(&mut self, job: &Job<'_>) -> Result<bool> {
        let mut ears = Vec::new();
        for f in (0..self.is_kept_face.len()).filter(|&f| self.is_kept_face[f]) {
            job.sub_job(0.5, 0.5).step_within_list(f, STAGE)?;
            let (mut held, mut cut) = (0, 0);
            for &g in self.faces_across_sides(f) {
                held += usize::from(self.is_kept(g));
                cut += usize::from(g != NONE && !self.is_kept(g));
            }
            if held <= 1 && cut > 0 {
                alloc::push(&mut ears, f)?;
            }
        }
        ears.iter().for_each(|&f| self.is_kept_face[f] = false);
        Ok(!ears.is_empty())
    }

    /// At vertices with several fans of faces beside a removed face, removes all fans except the
    /// largest. Returns true if there were any.
    fn remove_smaller_fans_at_pinches(&mut self, job: &Job<'_>) -> Result<bool> {
        let mut touched = BitSet::new(self.mesh.positions().len())?;
        for f in (0..self.is_kept_face.len()).filter(|&f| !self.is_kept_face[f]) {
            job.sub_job(0.0, 0.0).step_within_list(f, STAGE)?;
            self.mesh.face(f).for_each(|v| touched.insert(v));
        }
        job.step(0.5, STAGE)?;
        // The faces at each of these vertices, and the faces across their two edges there.
        let mut corners: Vec<(u32, u32, [u32; 2])> = Vec::new();
        for f in (0..self.is_kept_face.len()).filter(|&f| self.is_kept_face[f]) {
            job.sub_job(0.0, 0.0).step_within_list(f, STAGE)?;
            let beside = self.faces_across_sides(f);
            for (k, v) in self.mesh.face(f).enumerate().filter(|&(_, v)| touched.contains(v)) {
                let before = beside[(k + beside.len() - 1) % beside.len()];
                alloc::push(&mut corners, (v, f as u32, [before, beside[k]]))?;
            }
        }
        sort(&mut corners, Ord::cmp, &job.sub_job(0.0, 0.5), STAGE)?;
        let (mut any, mut fans, mut sizes) = (false, DisjointSets::new(0)?, Vec::new());
        for round in corners.chunk_by(|x, y| x.0 == y.0) {
            fans.reset(round.len())?;
            for (k, (_, _, beside)) in round.iter().enumerate() {
                job.sub_job(0.5, 0.5).step_within_list(k, STAGE)?;
                for g in beside {
                    if let Ok(j) = round.binary_search_by_key(g, |corner| corner.1) {
                        fans.union(k as u32, j as u32);
                    }
                }
            }
            alloc::reset(&mut sizes, round.len(), 0u32)?;
            (0..round.len() as u32).for_each(|k| sizes[fans.find(k) as usize] += 1);
            let largest = (0..round.len()).fold(0, |best, k| if sizes[k] > sizes[best] { k } else { best });
            for (k, &(_, f, _)) in round.iter().enumerate() {
                job.sub_job(0.5, 0.5).step_within_list(k, STAGE)?;
                if fans.find(k as u32) as usize != largest {
                    any |= self.is_kept_face[f as usize];
                    self.is_kept_face[f as usize] = false;
                }
            }
        }
        Ok(any)
    }
}

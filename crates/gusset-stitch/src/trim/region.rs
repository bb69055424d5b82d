//! The faces of a piece that are kept, made a surface that strips can hang on: nothing thinner than
//! two faces, no small islands, no faces that meet in one vertex only.

use super::STAGE;
use super::trim_request::SPARE;
use crate::align::Scan;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::bit_set::BitSet;
use gusset_base::geom::disjoint_sets::DisjointSets;
use gusset_base::job::Job;
use gusset_base::sort::sort;
use gusset_mesh::{MeshView, NONE, Opposite, Topology, half_edges};

/// Components of a piece that have so many times fewer faces than its largest are islands, too, if
/// they are small.
const DEBRIS: u32 = 10;
/// Rounds in which faces go that hang by one side, or meet others in a vertex only.
const MAX_ROUNDS: usize = 20;

/// The rims of what is kept: vertices and the middles of edges between them.
#[derive(Default)]
pub(super) struct Rims {
    pub(super) points: Vec<DVec3>,
    /// In their directions.
    pub(super) normals: Vec<DVec3>,
}

/// A set of a piece's faces.
pub(super) struct Region<'m, 'a> {
    mesh: &'m MeshView<'a>,
    /// Of each half-edge the face on its other side, or [`NONE`].
    across: Vec<u32>,
    pub(super) keeps: Vec<bool>,
    /// Those that cannot be kept, whatever lies on them.
    pub(super) lost: Vec<bool>,
    /// Those that are not given back, once lost, and not spared, as nothing else is kept there.
    settled: Vec<bool>,
    /// For each face the number of faces of its component in the piece, and the largest of all.
    component: Vec<u32>,
    largest: u32,
}

impl<'m, 'a> Region<'m, 'a> {
    /// All faces. O(H log d).
    pub(super) fn new(mesh: &'m MeshView<'a>, job: &Job<'_>) -> Result<Region<'m, 'a>> {
        let topology = Topology::new(mesh, &job.part(0.0, 0.5))?;
        let count = mesh.faces().len();
        let mut face_of = alloc::filled(NONE, mesh.faces().half_edge_count())?;
        for f in 0..count {
            job.part(0.5, 0.5).step_within(f, STAGE)?;
            face_of[mesh.faces().range(f)].fill(f as u32);
        }
        let beyond = |h| match topology.opposite(h) {
            Opposite::Mate(mate) => face_of[mate as usize],
            _ => NONE,
        };
        let halves = 0..face_of.len() as u32;
        let across = alloc::collect_cancellable(halves.map(beyond), &job.part(0.5, 0.5), STAGE)?;
        let mut region = Region {
            mesh,
            across,
            keeps: alloc::filled(true, count)?,
            lost: alloc::filled(false, count)?,
            settled: alloc::filled(false, count)?,
            component: Vec::new(),
            largest: 0,
        };
        let sizes = region.sizes_within(&region.keeps, &region.keeps, &job.part(0.5, 1.0))?;
        region.component = alloc::collect(sizes.iter().map(|size| size[0]))?;
        region.largest = region.component.iter().copied().max().unwrap_or(0);
        Ok(region)
    }

    /// The faces beside the sides of a face; [`NONE`] where there is none.
    fn beside(&self, f: usize) -> &[u32] {
        &self.across[self.mesh.faces().range(f)]
    }

    fn is_kept(&self, f: u32) -> bool {
        f != NONE && self.keeps[f as usize]
    }

    /// Keeps the faces all of whose vertices are wanted, without those that are lost or have a
    /// vertex that is barred, and makes them a surface: small holes are kept after all, and small
    /// islands are lost; true if there are any. `shown`: vertices that later pieces show as well.
    /// `min_faces`: what has fewer is small. O(rounds * H).
    pub(super) fn keep_where(
        &mut self,
        wanted: &[bool],
        barred: &[bool],
        shown: &[bool],
        min_faces: u32,
        job: &Job<'_>,
    ) -> Result<bool> {
        let may_keep = |f: usize| !self.lost[f] && !self.mesh.face(f).any(|v| barred[v as usize]);
        let may = alloc::collect_cancellable((0..self.keeps.len()).map(may_keep), &job.part(0.0, 0.0), STAGE)?;
        for (f, keeps) in self.keeps.iter_mut().enumerate() {
            job.step_within(f, STAGE)?;
            *keeps = may[f] && !self.mesh.face(f).all(|v| wanted[v as usize]);
        }
        job.step(0.1, STAGE)?;
        let holes = self.sizes_within(&self.keeps, &self.keeps, job)?;
        for f in 0..self.keeps.len() {
            // What is most of a component is no hole in it.
            let is_hole = 2 * holes[f][0] < self.component[f];
            let is_small_hole = self.keeps[f] && is_hole && holes[f][0] < SPARE.saturating_mul(min_faces);
            self.keeps[f] = may[f] && (!self.keeps[f] || is_small_hole);
        }
        job.step(0.3, STAGE)?;
        self.open(job)?;
        for _ in 0..MAX_ROUNDS {
            job.step(0.5, STAGE)?;
            if !self.take_out_ears(job)? & !self.take_out_pinches(job)? {
                break;
            }
        }
        // How many of each island no other piece shows.
        let is_needed = |f: usize| self.settled[f] || !self.mesh.face(f).all(|v| shown[v as usize]);
        let needed = alloc::collect_cancellable((0..self.keeps.len()).map(is_needed), &job.part(0.8, 0.8), STAGE)?;
        let islands = self.sizes_within(&self.keeps, &needed, job)?;
        let mut any = false;
        for (f, &[size, needed]) in islands.iter().enumerate() {
            // What others show as well can be spared.
            let least = if 2 * needed < size { SPARE.saturating_mul(min_faces) } else { min_faces };
            // Small pieces may have nothing larger; beside large components they are debris.
            let is_own = size == self.component[f] && size.saturating_mul(DEBRIS) >= self.largest;
            let is_island = self.keeps[f] && size < least && !is_own;
            self.keeps[f] &= !is_island;
            self.lost[f] |= is_island;
            any |= is_island;
        }
        Ok(any)
    }

    /// Visits the edges of the rim of what is kept, with their faces.
    pub(super) fn each_rim_edge(&self, mut visit: impl FnMut(u32, [u32; 2]) -> Result<()>) -> Result<()> {
        for f in (0..self.keeps.len()).filter(|&f| self.keeps[f]) {
            for ((_, u, v), &g) in half_edges(self.mesh, f).zip(self.beside(f)) {
                if !self.is_kept(g) {
                    visit(f as u32, [u, v])?;
                }
            }
        }
        Ok(())
    }

    /// Enters the rim of what is kept: where something was taken out beyond, and where nothing was.
    pub(super) fn rim(&self, scan: &Scan, [cut, border]: &mut [Rims; 2], job: &Job<'_>) -> Result<()> {
        for f in (0..self.keeps.len()).filter(|&f| self.keeps[f]) {
            job.step_within(f, STAGE)?;
            for ((_, u, v), &g) in half_edges(self.mesh, f).zip(self.beside(f)) {
                if !self.is_kept(g) {
                    let [p, q] = [u, v].map(|v| scan.points[v as usize]);
                    let [m, n] = [u, v].map(|v| scan.normals[v as usize]);
                    let out = if g == NONE { &mut *border } else { &mut *cut };
                    // Both ends: the next edge may be of the other kind.
                    alloc::append(&mut out.points, &[p, p.midpoint(q), q])?;
                    alloc::append(&mut out.normals, &[m, m + n, n])?;
                }
            }
        }
        Ok(())
    }

    /// Smooths values of vertices over faces, so many times.
    pub(super) fn smooth(&self, values: &mut [f64], passes: usize, job: &Job<'_>) -> Result<()> {
        let mut sums = alloc::filled((0.0, 0.0), values.len())?;
        for pass in 0..passes {
            job.step(pass as f64 / passes as f64, STAGE)?;
            sums.fill((0.0, 0.0));
            for f in 0..self.keeps.len() {
                job.part(1.0, 1.0).step_within(f, STAGE)?;
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

    /// Gives back islands that were spared where nothing else is kept now, whole if that is much
    /// of them; true if there are any. `on`: vertices that lie on what is kept of other pieces;
    /// `min_faces`: what has fewer is small.
    pub(super) fn give_back(&mut self, on: &[bool], min_faces: u32, job: &Job<'_>) -> Result<bool> {
        let count = self.keeps.len();
        let spared = alloc::collect((0..count).map(|f| self.lost[f] && !self.settled[f]))?;
        let is_bare = |f: usize| spared[f] && !self.mesh.face(f).any(|v| on[v as usize]);
        let bare = alloc::collect_cancellable((0..count).map(is_bare), &job.part(0.0, 0.0), STAGE)?;
        let islands = self.sizes_within(&spared, &bare, job)?;
        let places = self.sizes_within(&bare, &bare, job)?;
        let mut any = false;
        for f in (0..count).filter(|&f| spared[f]) {
            let ([all, without], [place, _]) = (islands[f], places[f]);
            if 3 * without > all || place >= min_faces {
                (self.lost[f], self.settled[f], any) = (false, true, true);
            }
        }
        Ok(any)
    }

    /// For each face of `among` the number of those that hang together with it across sides, and
    /// how many of them are `counted`; zeros for other faces.
    fn sizes_within(&self, among: &[bool], counted: &[bool], job: &Job<'_>) -> Result<Vec<[u32; 2]>> {
        let count = among.len();
        let mut sets = DisjointSets::new(count)?;
        for f in (0..count).filter(|&f| among[f]) {
            job.step_within(f, STAGE)?;
            for &g in self.beside(f).iter().filter(|&&g| g != NONE && among[g as usize]) {
                sets.union(f as u32, g);
            }
        }
        let roots = sets.into_roots(job, STAGE)?;
        let mut sums = alloc::filled([0u32; 2], count)?;
        for f in (0..count).filter(|&f| among[f]) {
            job.part(1.0, 1.0).step_within(f, STAGE)?;
            let sum = &mut sums[roots[f] as usize];
            *sum = [sum[0] + 1, sum[1] + u32::from(counted[f])];
        }
        let of = |f: usize| if among[f] { sums[roots[f] as usize] } else { [0; 2] };
        alloc::collect_cancellable((0..count).map(of), &job.part(1.0, 1.0), STAGE)
    }

    /// Loses faces for good, and all that have a vertex in common with them.
    pub(super) fn lose(&mut self, faces: &[u32]) -> Result<()> {
        let mut gone = BitSet::new(self.mesh.positions().len())?;
        faces.iter().for_each(|&f| self.mesh.face(f as usize).for_each(|v| gone.insert(v)));
        for f in 0..self.keeps.len() {
            if self.mesh.face(f).any(|v| gone.contains(v)) {
                (self.keeps[f], self.lost[f], self.settled[f]) = (false, true, true);
            }
        }
        Ok(())
    }

    /// Takes out what is thinner than two faces: keeps the faces round vertices inside.
    fn open(&mut self, job: &Job<'_>) -> Result<()> {
        let count = self.mesh.positions().len();
        // A vertex is inside if no face round it is gone.
        let mut inside = alloc::filled(true, count)?;
        for f in (0..self.keeps.len()).filter(|&f| !self.keeps[f]) {
            job.part(0.4, 0.4).step_within(f, STAGE)?;
            self.mesh.face(f).for_each(|v| inside[v as usize] = false);
        }
        job.step(0.4, STAGE)?;
        for f in 0..self.keeps.len() {
            job.part(0.4, 0.4).step_within(f, STAGE)?;
            self.keeps[f] = self.keeps[f] && self.mesh.face(f).any(|v| inside[v as usize]);
        }
        Ok(())
    }

    /// Takes out faces of which all sides but one are free where something was taken out beside
    /// them; true if there were any.
    fn take_out_ears(&mut self, job: &Job<'_>) -> Result<bool> {
        let mut ears = Vec::new();
        for f in (0..self.keeps.len()).filter(|&f| self.keeps[f]) {
            job.part(0.5, 0.5).step_within(f, STAGE)?;
            let (mut held, mut cut) = (0, 0);
            for &g in self.beside(f) {
                held += usize::from(self.is_kept(g));
                cut += usize::from(g != NONE && !self.is_kept(g));
            }
            if held <= 1 && cut > 0 {
                alloc::push(&mut ears, f)?;
            }
        }
        ears.iter().for_each(|&f| self.keeps[f] = false);
        Ok(!ears.is_empty())
    }

    /// Takes out all but the largest of several fans of faces round a vertex where something was
    /// taken out; true if there were any.
    fn take_out_pinches(&mut self, job: &Job<'_>) -> Result<bool> {
        let mut touched = BitSet::new(self.mesh.positions().len())?;
        for f in (0..self.keeps.len()).filter(|&f| !self.keeps[f]) {
            job.part(0.0, 0.0).step_within(f, STAGE)?;
            self.mesh.face(f).for_each(|v| touched.insert(v));
        }
        job.step(0.5, STAGE)?;
        // The faces at each such vertex, and those beside them across the edges that end there.
        let mut corners: Vec<(u32, u32, [u32; 2])> = Vec::new();
        for f in (0..self.keeps.len()).filter(|&f| self.keeps[f]) {
            job.part(0.0, 0.0).step_within(f, STAGE)?;
            let beside = self.beside(f);
            for (k, v) in self.mesh.face(f).enumerate().filter(|&(_, v)| touched.contains(v)) {
                let before = beside[(k + beside.len() - 1) % beside.len()];
                alloc::push(&mut corners, (v, f as u32, [before, beside[k]]))?;
            }
        }
        sort(&mut corners, Ord::cmp, &job.part(0.0, 0.5), STAGE)?;
        let (mut any, mut fans, mut sizes) = (false, DisjointSets::new(0)?, Vec::new());
        for round in corners.chunk_by(|x, y| x.0 == y.0) {
            fans.reset(round.len())?;
            for (k, (_, _, beside)) in round.iter().enumerate() {
                job.part(0.5, 0.5).step_within(k, STAGE)?;
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
                job.part(0.5, 0.5).step_within(k, STAGE)?;
                if fans.find(k as u32) as usize != largest {
                    any |= self.keeps[f as usize];
                    self.keeps[f as usize] = false;
                }
            }
        }
        Ok(any)
    }
}

//! Seams: pairs of coincident free edges that become one edge.
//!
//! Free edges are compared by the clusters of their ends, in either direction, because orientation
//! is handled elsewhere. If exactly two edges coincide they form a pair; if more coincide, none is
//! preferred. Pairs are sewn in the order of the half-edges: both pairs of ends are merged. A pair
//! is skipped if sewing it would
//!
//! * merge two corners of a face, which would collapse (unless the caller allows that), or
//! * merge two edges that together have more than two faces.
//!
//! So coincident vertices without a common edge stay apart, as at a point that two holes share. Two
//! solids that touch along an edge stay separate, each sewn to itself. A manifold stays a manifold:
//! a sewn edge joins two fans into one.
//!
//! Each union visits the smaller of two sets of vertices, and an edge's faces are counted at the
//! end with fewer corners: O(B log B) for B corners at border vertices of bounded degree.

use super::vertex_corners::VertexCorners;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_base::sort::sort;
use gusset_mesh::{MeshView, NONE, Opposite, Topology, half_edges, unordered};
use std::iter;

/// Number of pairs between two progress reports.
const PAIRS_PER_REPORT: usize = 1 << 14;

const STAGE: &str = "sewing edges";

/// Returns true if the half-edge's face is the only one at its edge.
pub(super) fn is_free(topology: &Topology, h: u32) -> bool {
    !topology.is_ignored(h) && topology.opposite(h) == Opposite::Free
}

/// Returns the half-edges of free edges, with their ends.
pub(crate) fn free_edges(mesh: &MeshView<'_>, topology: &Topology) -> impl Iterator<Item = (u32, [u32; 2])> {
    let all = (0..mesh.faces().len()).flat_map(|f| half_edges(mesh, f));
    all.filter(|&(h, ..)| is_free(topology, h)).map(|(h, u, v)| (h, [u, v]))
}

/// Returns the ends of free edges, ascending.
pub(crate) fn free_vertices(mesh: &MeshView<'_>, topology: &Topology) -> Result<Vec<u32>> {
    let mut is_free = alloc::filled(false, mesh.positions().len())?;
    free_edges(mesh, topology).flat_map(|(_, ends)| ends).for_each(|v| is_free[v as usize] = true);
    alloc::gather((0..).zip(&is_free).filter(|&(_, &free)| free).map(|(v, _)| v))
}

/// Sews all possible pairs. Returns for each vertex the smallest vertex of its merged set.
pub(super) fn sew_coincident_edges(
    mesh: &MeshView<'_>,
    topology: &Topology,
    clusters: &[u32],
    collapse: bool,
    job: &Job<'_>,
) -> Result<Vec<u32>> {
    let pairs = pairs_to_sew(mesh, topology, clusters, &job.sub_job(0.0, 0.3))?;
    let job = job.sub_job(0.3, 1.0);
    let mut sets = MergedVertexSets::new(mesh, topology, collapse, &job.sub_job(0.0, 0.0))?;
    for (i, &[g, h]) in pairs.iter().enumerate() {
        job.step_every(PAIRS_PER_REPORT, i, pairs.len(), STAGE)?;
        let ([u, v], [a, b]) = (sets.end_sets(g), sets.end_sets(h));
        let [a, b] = if clusters[u as usize] == clusters[a as usize] { [a, b] } else { [b, a] };
        let of = |v: u32| sets.set_label[v as usize];
        let seam = Seam([[of(u), of(a)], [of(v), of(b)]]);
        if sets.can_sew_without_harm(&seam) {
            seam.0.iter().for_each(|&[a, b]| sets.merge_sets(a, b));
        }
    }
    sets.smallest_vertices()
}

/// Two pairs of coincident vertices: the ends of two runs of border edges.
pub(crate) type RunEnds = [[u32; 2]; 2];

/// Merges the pairs of each entry of `runs` in order, unless that would do harm. Returns for each
/// entry whether it was merged, and for each vertex the smallest vertex of its merged set.
pub(crate) fn merge_run_ends(
    mesh: &MeshView<'_>,
    topology: &Topology,
    runs: &[RunEnds],
    job: &Job<'_>,
) -> Result<(Vec<bool>, Vec<u32>)> {
    let mut sets = MergedVertexSets::new(mesh, topology, false, &job.sub_job(0.0, 0.5))?;
    let mut merged = alloc::with_capacity(runs.len())?;
    for (i, pairs) in runs.iter().enumerate() {
        job.sub_job(0.5, 1.0).step_every(PAIRS_PER_REPORT, i, runs.len(), STAGE)?;
        let seam = Seam(pairs.map(|pair| pair.map(|v| sets.set_label[v as usize])));
        let harmless = sets.can_sew_without_harm(&seam);
        if harmless {
            pairs.iter().for_each(|&[a, b]| sets.merge_sets(sets.set_label[a as usize], sets.set_label[b as usize]));
        }
        merged.push(harmless);
    }
    Ok((merged, sets.smallest_vertices()?))
}

/// Returns the pairs of free edges that coincide with each other and with no third edge, by their
/// smaller half-edges. Edges with coincident ends are skipped: their neighbours decide.
fn pairs_to_sew(mesh: &MeshView<'_>, topology: &Topology, clusters: &[u32], job: &Job<'_>) -> Result<Vec<[u32; 2]>> {
    job.step(0.0, STAGE)?;
    let clustered = free_edges(mesh, topology).map(|(h, ends)| (ends.map(|v| clusters[v as usize]), h));
    let mut free = alloc::gather(clustered.filter(|([u, v], _)| u != v).map(|(ends, h)| (unordered(ends), h)))?;
    sort(&mut free, Ord::cmp, &job.sub_job(0.0, 0.6), STAGE)?;
    let mut pairs = alloc::gather(free.chunk_by(|a, b| a.0 == b.0).filter_map(|together| match *together {
        [(_, g), (_, h)] => Some([g, h]),
        _ => None,
    }))?;
    sort(&mut pairs, Ord::cmp, &job.sub_job(0.6, 1.0), STAGE)?;
    job.step(1.0, STAGE)?;
    Ok(pairs)
}

/// Two edges to be sewn: the sets of vertices at either end, which are equal if they are merged
/// already. The sets at different ends are disjoint, because the ends are apart.
struct Seam([[u32; 2]; 2]);

impl Seam {
    /// Returns the label of a set after sewing.
    fn label_after_sewing(&self, label: u32) -> u32 {
        self.0.iter().find(|&&[_, b]| b == label).map_or(label, |&[a, _]| a)
    }

    /// Returns the sets that get this label.
    fn sets_with_label(&self, name: u32) -> impl Iterator<Item = u32> + use<> {
        let other = self.0.iter().find(|&&[a, b]| a == name && b != name).map(|&[_, b]| b);
        iter::once(name).chain(other)
    }
}

/// The sets of vertices merged so far.
struct MergedVertexSets<'m> {
    mesh: &'m MeshView<'m>,
    topology: &'m Topology,
    corners: VertexCorners,
    collapse: bool,
    /// For each vertex, the label of its set: one of its vertices.
    set_label: Vec<u32>,
    /// For each vertex, the next vertex of its set in a cyclic list.
    next_in_set: Vec<u32>,
    /// For each label, the number of face corners at all vertices of its set.
    degree: Vec<u32>,
}

impl<'m> MergedVertexSets<'m> {
    /// Creates sets of one vertex each.
    fn new(mesh: &'m MeshView<'m>, topology: &'m Topology, collapse: bool, job: &Job<'_>) -> Result<Self> {
        let corners = VertexCorners::new(mesh, job)?;
        job.step(1.0, STAGE)?;
        let count = mesh.positions().len();
        let degree = alloc::collect((0..count).map(|v| corners.corners_at_vertex(v as u32).len() as u32))?;
        let identity = || alloc::collect((0..count).map(|v| v as u32));
        Ok(MergedVertexSets {
            mesh,
            topology,
            corners,
            collapse,
            set_label: identity()?,
            next_in_set: identity()?,
            degree,
        })
    }

    fn end_sets(&self, h: u32) -> [u32; 2] {
        let range = self.mesh.faces().corner_range(self.corners.face_of_corner(h));
        let after = if h as usize + 1 == range.end { range.start as u32 } else { h + 1 };
        [h, after].map(|h| self.mesh.faces().corner(h))
    }

    fn vertices_of_set(&self, label: u32) -> impl Iterator<Item = u32> {
        iter::successors(Some(label), move |&v| Some(self.next_in_set[v as usize]).filter(|&v| v != label))
    }

    fn corners_of_set(&self, label: u32) -> impl Iterator<Item = u32> {
        self.vertices_of_set(label).flat_map(|v| self.corners.corners_at_vertex(v).iter().copied())
    }

    /// Returns the sets at the other ends of the half-edges that leave and reach corner `h`.
    fn neighbour_sets(&self, h: u32) -> impl Iterator<Item = u32> {
        let faces = self.mesh.faces();
        let range = faces.corner_range(self.corners.face_of_corner(h));
        let (start, end) = (range.start as u32, range.end as u32 - 1);
        let before = if h == start { end } else { h - 1 };
        let after = if h == end { start } else { h + 1 };
        let far = [(h, after), (before, before)].into_iter().filter(|&(edge, _)| !self.topology.is_ignored(edge));
        far.map(move |(_, corner)| self.set_label[faces.corner(corner) as usize])
    }

    /// Returns true if the face of corner `h` has a corner in a set.
    fn face_has_corner_in_set(&self, h: u32, label: u32) -> bool {
        let range = self.mesh.faces().corner_range(self.corners.face_of_corner(h));
        if range.len() <= self.degree[label as usize] as usize {
            return self.sets_at_face(h).any(|other| other == label);
        }
        self.corners_of_set(label).any(|corner| range.contains(&(corner as usize)))
    }

    /// Returns the sets at the corners of the face of corner `h`.
    fn sets_at_face(&self, h: u32) -> impl Iterator<Item = u32> {
        self.mesh.face(self.corners.face_of_corner(h)).map(|v| self.set_label[v as usize])
    }

    /// Returns true if sewing the seam makes no edge non-manifold. Unless `collapse` is set, sewing
    /// must not merge two corners of a face either.
    fn can_sew_without_harm(&self, seam: &Seam) -> bool {
        seam.0.iter().filter(|&[a, b]| a != b).all(|&[a, b]| {
            let [small, large] = if self.degree[a as usize] <= self.degree[b as usize] { [a, b] } else { [b, a] };
            self.corners_of_set(small).all(|h| {
                (self.collapse || !self.face_has_corner_in_set(h, large))
                    && self.neighbour_sets(h).all(|far| {
                        seam.label_after_sewing(far) == a
                            || !self.makes_edge_non_manifold(seam, a, seam.label_after_sewing(far))
                    })
            })
        })
    }

    /// Returns true if the seam would merge several edges between vertex sets `end_a` and `end_b` into one
    /// edge with more than two faces. Sets are named by their labels after sewing.
    fn makes_edge_non_manifold(&self, seam: &Seam, end_a: u32, end_b: u32) -> bool {
        let weight = |name| seam.sets_with_label(name).map(|label| u64::from(self.degree[label as usize])).sum::<u64>();
        let [from, to] = if weight(end_a) <= weight(end_b) { [end_a, end_b] } else { [end_b, end_a] };
        let (mut faces, mut first, mut several) = (0, None, false);
        for label in seam.sets_with_label(from) {
            for h in self.corners_of_set(label).filter(|&h| self.face_keeps_three_corners(seam, h)) {
                for far in self.neighbour_sets(h).filter(|&far| seam.label_after_sewing(far) == to) {
                    faces += 1;
                    several |= *first.get_or_insert((label, far)) != (label, far);
                }
            }
        }
        several && faces > 2
    }

    /// Returns true if the face of corner `h` keeps three different corners.
    fn face_keeps_three_corners(&self, seam: &Seam, h: u32) -> bool {
        if !self.collapse {
            return true;
        }
        let mut names = [NONE; 3];
        for name in self.sets_at_face(h).map(|label| seam.label_after_sewing(label)) {
            match names.iter().position(|&known| known == name || known == NONE) {
                Some(2) => return true,
                Some(place) => names[place] = name,
                None => {}
            }
        }
        false
    }

    /// Merges two sets. The smaller one gets the label of the larger.
    fn merge_sets(&mut self, a: u32, b: u32) {
        if a == b {
            return;
        }
        let [small, large] = if self.degree[a as usize] <= self.degree[b as usize] { [a, b] } else { [b, a] };
        let mut v = small;
        loop {
            self.set_label[v as usize] = large;
            v = self.next_in_set[v as usize];
            if v == small {
                break;
            }
        }
        self.degree[large as usize] += self.degree[small as usize];
        self.next_in_set.swap(small as usize, large as usize);
    }

    /// Returns for each vertex the smallest vertex of its set.
    fn smallest_vertices(self) -> Result<Vec<u32>> {
        let mut smallest = alloc::filled(NONE, self.set_label.len())?;
        for (v, &label) in self.set_label.iter().enumerate() {
            smallest[label as usize] = smallest[label as usize].min(v as u32);
        }
        alloc::collect(self.set_label.iter().map(|&label| smallest[label as usize]))
    }
}

//! Which half-edges share an edge.

use super::defect::Defect;
use super::half_edge_pairing::{FREE_EDGE_MARK, NON_MANIFOLD_EDGE_MARK, Topology};
use super::view::MeshView;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::disjoint_sets::DisjointSets;
use gusset_base::job::Job;
use gusset_base::par;

/// Half-edges in one work item.
const HALF_EDGES_PER_TASK: usize = 1 << 18;

/// The opposite of a half-edge, across its edge.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Opposite {
    /// None: the edge is free.
    Free,
    /// Two or more faces.
    Singular,
    /// A single half-edge, of the edge's other face.
    Mate(u32),
}

impl Topology {
    /// Returns the opposite of half-edge `h`, which must not be an ignored one.
    #[inline]
    pub fn opposite(&self, h: u32) -> Opposite {
        match self.mate[h as usize] {
            FREE_EDGE_MARK => Opposite::Free,
            NON_MANIFOLD_EDGE_MARK => Opposite::Singular,
            mate => Opposite::Mate(mate),
        }
    }

    /// Returns true if `h` is ignored, because its length is 0 or its face is degenerate.
    #[inline]
    pub fn is_ignored(&self, h: u32) -> bool {
        self.mate[h as usize] == h
    }

    /// Returns the half-edges of free edges and of edges with three or more faces, in ascending
    /// order.
    pub fn border_half_edges(&self, job: &Job<'_>) -> Result<Vec<u32>> {
        let found =
            par::map(job.requested_threads(), par::split_into_ranges(self.mate.len(), HALF_EDGES_PER_TASK), |range| {
                let half_edges = (range.start as u32..).zip(&self.mate[range]);
                alloc::gather(half_edges.filter(|&(_, &mate)| mate >= NON_MANIFOLD_EDGE_MARK).map(|(h, _)| h))
            })?;
        let mut border = Vec::new();
        alloc::append_all(&mut border, found)?;
        Ok(border)
    }

    /// Returns the number of faces' corners at vertex `v`, without ignored half-edges.
    #[inline]
    pub fn corner_count(&self, v: u32) -> u32 {
        self.corner_count[v as usize]
    }

    /// Returns the degenerate faces, orientation conflicts and non-manifold edges, in this order.
    #[inline]
    pub fn defects(&self) -> &[Defect] {
        &self.defects
    }

    /// Returns the next half-edge of the same face, skipping half-edges without length.
    #[inline]
    pub fn next(&self, mesh: &MeshView<'_>, h: u32) -> u32 {
        let range = mesh.faces().corner_range(mesh.faces().face_of_half_edge(h) as usize);
        let (before, after) = (range.start as u32..h, h + 1..range.end as u32);
        after.chain(before).find(|&n| !self.is_ignored(n)).unwrap_or(h)
    }

    /// Returns the previous half-edge of the same face, skipping half-edges without length.
    #[inline]
    pub fn previous(&self, mesh: &MeshView<'_>, h: u32) -> u32 {
        let range = mesh.faces().corner_range(mesh.faces().face_of_half_edge(h) as usize);
        let (before, after) = (range.start as u32..h, h + 1..range.end as u32);
        before.rev().chain(after.rev()).find(|&n| !self.is_ignored(n)).unwrap_or(h)
    }
}

/// Packs the ends of an edge into one word, independently of their order.
#[inline]
pub fn unordered([u, v]: [u32; 2]) -> u64 {
    u64::from(u.min(v)) << 32 | u64::from(u.max(v))
}

/// Returns the half-edges of face `f` as (index, start vertex, end vertex).
#[inline]
pub fn half_edges<'m>(mesh: &'m MeshView<'_>, f: usize) -> impl Iterator<Item = (u32, u32, u32)> + Clone + 'm {
    let faces = mesh.faces();
    let range = faces.corner_range(f);
    let (start, end) = (range.start as u32, range.end as u32);
    (start..end).map(move |h| (h, faces.corner(h), faces.corner(if h + 1 == end { start } else { h + 1 })))
}

/// Returns sets of vertices in which all vertices of a face belong to one set. O(V + H), 4 bytes a
/// vertex.
pub fn vertex_components(mesh: &MeshView<'_>) -> Result<DisjointSets> {
    let mut sets = DisjointSets::new(mesh.positions().len())?;
    for f in 0..mesh.faces().len() {
        let mut corners = mesh.face(f);
        if let Some(first) = corners.next() {
            corners.for_each(|v| _ = sets.union(first, v));
        }
    }
    Ok(sets)
}

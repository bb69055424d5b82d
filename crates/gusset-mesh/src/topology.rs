//! Which half-edges share an edge.

use super::defect::Defect;
use super::half_edge_pairing::{FREE, SINGULAR, Topology};
use super::view::MeshView;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::disjoint_sets::DisjointSets;
use gusset_base::job::Job;
use gusset_base::par;

/// Half-edges that one thread looks at at a time.
const CHUNK: usize = 1 << 18;

/// What lies across a half-edge.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Across {
    /// Nothing: a free edge.
    Free,
    /// Two or more other faces.
    Singular,
    /// This half-edge of the one other face.
    Mate(u32),
}

impl Topology {
    /// What lies across half-edge `h`, which must not be an ignored one.
    #[inline]
    pub fn across(&self, h: u32) -> Across {
        match self.mate[h as usize] {
            FREE => Across::Free,
            SINGULAR => Across::Singular,
            mate => Across::Mate(mate),
        }
    }

    /// True if `h` takes no part: it has no length, or its face is degenerate.
    #[inline]
    pub fn is_ignored(&self, h: u32) -> bool {
        self.mate[h as usize] == h
    }

    /// The half-edges of free edges and those of edges with three or more faces, in ascending
    /// order.
    pub fn border(&self, job: &Job<'_>) -> Result<Vec<u32>> {
        let found = par::map(job.threads(), par::ranges(self.mate.len(), CHUNK), |range| {
            let half_edges = (range.start as u32..).zip(&self.mate[range]);
            alloc::gather(half_edges.filter(|&(_, &mate)| mate >= SINGULAR).map(|(h, _)| h))
        })?;
        let mut border = Vec::new();
        alloc::append_all(&mut border, found)?;
        Ok(border)
    }

    /// The number of faces' corners at vertex `v`, ignored half-edges apart.
    #[inline]
    pub fn corner_count(&self, v: u32) -> u32 {
        self.corner_count[v as usize]
    }

    /// The degenerate faces, orientation conflicts and non-manifold edges, in this order.
    #[inline]
    pub fn defects(&self) -> &[Defect] {
        &self.defects
    }

    /// The half-edge of the same face that follows `h`, those without length left out.
    #[inline]
    pub fn next(&self, mesh: &MeshView<'_>, h: u32) -> u32 {
        let range = mesh.faces().range(mesh.faces().face_of(h) as usize);
        let (before, after) = (range.start as u32..h, h + 1..range.end as u32);
        after.chain(before).find(|&n| !self.is_ignored(n)).unwrap_or(h)
    }

    /// The half-edge of the same face that precedes `h`, those without length left out.
    #[inline]
    pub fn previous(&self, mesh: &MeshView<'_>, h: u32) -> u32 {
        let range = mesh.faces().range(mesh.faces().face_of(h) as usize);
        let (before, after) = (range.start as u32..h, h + 1..range.end as u32);
        before.rev().chain(after.rev()).find(|&n| !self.is_ignored(n)).unwrap_or(h)
    }
}

/// The ends of an edge in one word, whatever their order.
#[inline]
pub fn unordered([u, v]: [u32; 2]) -> u64 {
    u64::from(u.min(v)) << 32 | u64::from(u.max(v))
}

/// The half-edges of face `f` as (number, start vertex, end vertex).
#[inline]
pub fn half_edges<'m>(mesh: &'m MeshView<'_>, f: usize) -> impl Iterator<Item = (u32, u32, u32)> + Clone + 'm {
    let faces = mesh.faces();
    let range = faces.range(f);
    let (start, end) = (range.start as u32, range.end as u32);
    (start..end).map(move |h| (h, faces.corner(h), faces.corner(if h + 1 == end { start } else { h + 1 })))
}

/// Sets of vertices, in which all vertices of a face are in one. O(V + H), 4 bytes a vertex.
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

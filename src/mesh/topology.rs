//! Which half-edges share an edge: the exact bucket method.
//!
//! Half-edges are put into buckets by the smaller of their two vertices (a counting sort), and each bucket is sorted by the
//! larger one: half-edges of the same edge become neighbours. Two passes over the corners and one over the buckets, no
//! hashing, and the same answer for any order of the faces but for the numbers of the half-edges.

use super::view::MeshView;
use crate::alloc;
use crate::error::Result;
use crate::job::Job;

/// Something wrong or unusual about a mesh's connectivity.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Defect {
    /// A face that repeats a vertex. If fewer than three distinct consecutive corners remain, the face has no border and
    /// its neighbours are taken to touch each other.
    DegenerateFace {
        /// The face.
        face: u32,
        /// The repeated vertex.
        vertex: u32,
    },
    /// An edge whose two faces run it in the same direction: one of them is wrongly oriented.
    OrientationConflict {
        /// The two half-edges, the smaller number first.
        half_edges: [u32; 2],
    },
    /// An edge with three or more faces.
    NonManifoldEdge {
        /// The first of its half-edges.
        half_edge: u32,
        /// How many half-edges it has.
        faces: u32,
    },
    /// A vertex where the surface touches itself: its faces form more than one fan.
    BowTie {
        /// The vertex.
        vertex: u32,
    },
}

/// The pairing of half-edges.
pub struct Topology {
    /// Per half-edge: its partner, or one of the marks below, or itself if it is ignored (zero length, degenerate face).
    mate: Vec<u32>,
    /// Per vertex: the number of corners whose half-edge is not ignored.
    corner_count: Vec<u32>,
    defects: Vec<Defect>,
}

/// The edge has this one face only.
const FREE: u32 = u32::MAX;
/// The edge has three or more faces.
const SINGULAR: u32 = u32::MAX - 1;

/// What lies across a half-edge.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Across {
    /// Nothing: a free edge.
    Free,
    /// Two or more other faces.
    Singular,
    /// This half-edge of the one other face.
    Mate(u32),
}

/// Faces between two progress reports.
const STEP: usize = 1 << 16;

impl Topology {
    /// Pairs the half-edges of `mesh`. O(H log d) for H half-edges and vertices of degree d; extra memory: 12 bytes a
    /// half-edge and 8 a vertex, of which 4 and 4 remain.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`](crate::Error::OutOfMemory), [`Error::Cancelled`](crate::Error::Cancelled).
    pub fn new(mesh: &MeshView<'_>, job: &Job<'_>) -> Result<Self> {
        let faces = mesh.faces();
        let vertices = mesh.positions().len();
        let mut topology = Topology {
            mate: alloc::filled(0, faces.half_edge_count())?,
            corner_count: alloc::filled(0, vertices)?,
            defects: Vec::new(),
        };

        // Count: bucket v, in entry v + 1, gets the half-edges whose smaller vertex is v.
        let mut start = alloc::filled(0u32, vertices + 1)?;
        for f in 0..faces.len() {
            if f % STEP == 0 {
                job.step(0.3 * f as f64 / faces.len() as f64, "pairing half-edges")?;
            }
            topology.enter_face(mesh, f, &mut start)?;
        }
        for v in 0..vertices {
            start[v + 1] += start[v];
        }

        // Distribute: (larger vertex, half-edge) in one word, in the order of the half-edges.
        let mut entries = alloc::filled(0u64, start[vertices] as usize)?;
        for f in 0..faces.len() {
            if f % STEP == 0 {
                job.step(0.3 + 0.3 * f as f64 / faces.len() as f64, "pairing half-edges")?;
            }
            for (h, u, v) in half_edges(mesh, f) {
                if topology.mate[h as usize] != h {
                    let place = &mut start[u.min(v) as usize];
                    entries[*place as usize] = u64::from(u.max(v)) << 32 | u64::from(h);
                    *place += 1;
                }
            }
        }

        // Group. After the distribution, start[v] is the end of bucket v.
        let mut begin = 0;
        for (v, &end) in start[..vertices].iter().enumerate() {
            if v % STEP == 0 {
                job.step(0.6 + 0.4 * v as f64 / vertices as f64, "pairing half-edges")?;
            }
            let bucket = &mut entries[begin..end as usize];
            begin = end as usize;
            bucket.sort_unstable();
            for edge in bucket.chunk_by(|a, b| a >> 32 == b >> 32) {
                topology.join(mesh, edge)?;
            }
        }
        topology.defects.sort_unstable();
        Ok(topology)
    }

    /// Counts the half-edges of a face into the buckets; marks those that are ignored.
    fn enter_face(&mut self, mesh: &MeshView<'_>, f: usize, bucket: &mut [u32]) -> Result<()> {
        let edges = half_edges(mesh, f);
        let proper = edges.clone().filter(|&(_, u, v)| u != v).count();
        if let Some(vertex) = repeated_vertex(mesh, f)? {
            alloc::push(&mut self.defects, Defect::DegenerateFace { face: f as u32, vertex })?;
        }
        for (h, u, v) in edges {
            if u == v || proper < 3 {
                self.mate[h as usize] = h;
            } else {
                // Never equal to h, and replaced by join().
                self.mate[h as usize] = FREE;
                bucket[u.min(v) as usize + 1] += 1;
                self.corner_count[u as usize] += 1;
            }
        }
        Ok(())
    }

    /// Enters what the half-edges of one edge are to each other.
    fn join(&mut self, mesh: &MeshView<'_>, edge: &[u64]) -> Result<()> {
        let half_edge = |i: usize| edge[i] as u32;
        match edge.len() {
            1 => {}
            2 => {
                let (g, h) = (half_edge(0), half_edge(1));
                self.mate[g as usize] = h;
                self.mate[h as usize] = g;
                if mesh.faces().corner(g) == mesh.faces().corner(h) {
                    alloc::push(&mut self.defects, Defect::OrientationConflict { half_edges: [g, h] })?;
                }
            }
            n => {
                edge.iter().for_each(|&entry| self.mate[entry as u32 as usize] = SINGULAR);
                let defect = Defect::NonManifoldEdge { half_edge: half_edge(0), faces: n as u32 };
                alloc::push(&mut self.defects, defect)?;
            }
        }
        Ok(())
    }

    /// What lies across half-edge `h`, which must not be an ignored one.
    pub(crate) fn across(&self, h: u32) -> Across {
        match self.mate[h as usize] {
            FREE => Across::Free,
            SINGULAR => Across::Singular,
            mate => Across::Mate(mate),
        }
    }

    /// True if `h` takes no part: it has no length, or its face is degenerate.
    pub(crate) fn is_ignored(&self, h: u32) -> bool {
        self.mate[h as usize] == h
    }

    /// The half-edges of free edges and those of edges with three or more faces, in ascending order.
    pub(crate) fn border(&self) -> Result<Vec<u32>> {
        let mut border = Vec::new();
        for (h, &mate) in self.mate.iter().enumerate() {
            if mate >= SINGULAR {
                alloc::push(&mut border, h as u32)?;
            }
        }
        Ok(border)
    }

    /// The number of faces' corners at vertex `v`, ignored half-edges apart.
    pub(crate) fn corner_count(&self, v: u32) -> u32 {
        self.corner_count[v as usize]
    }

    /// The degenerate faces, orientation conflicts and non-manifold edges, in this order.
    pub fn defects(&self) -> &[Defect] {
        &self.defects
    }

    /// The half-edge of the same face that follows `h`, those without length left out.
    pub(crate) fn next(&self, mesh: &MeshView<'_>, h: u32) -> u32 {
        let range = mesh.faces().range(mesh.faces().face_of(h) as usize);
        let mut n = h;
        loop {
            n = if n as usize + 1 == range.end { range.start as u32 } else { n + 1 };
            if !self.is_ignored(n) {
                return n;
            }
        }
    }

    /// The half-edge of the same face that precedes `h`, those without length left out.
    pub(crate) fn previous(&self, mesh: &MeshView<'_>, h: u32) -> u32 {
        let range = mesh.faces().range(mesh.faces().face_of(h) as usize);
        let mut n = h;
        loop {
            n = if n as usize == range.start { range.end as u32 - 1 } else { n - 1 };
            if !self.is_ignored(n) {
                return n;
            }
        }
    }
}

/// The half-edges of face `f` as (number, start vertex, end vertex).
pub(crate) fn half_edges<'m>(mesh: &'m MeshView<'_>, f: usize) -> impl Iterator<Item = (u32, u32, u32)> + Clone + 'm {
    let faces = mesh.faces();
    let range = faces.range(f);
    let (start, end) = (range.start as u32, range.end as u32);
    (start..end).map(move |h| (h, faces.corner(h), faces.corner(if h + 1 == end { start } else { h + 1 })))
}

/// A vertex that face `f` names twice.
fn repeated_vertex(mesh: &MeshView<'_>, f: usize) -> Result<Option<u32>> {
    let corners = mesh.face(f);
    if corners.len() <= 8 {
        let twice = |(i, v): &(usize, u32)| corners.clone().take(*i).any(|u| u == *v);
        return Ok(corners.clone().enumerate().find(twice).map(|(_, v)| v));
    }
    let mut sorted = alloc::collect(corners)?;
    sorted.sort_unstable();
    Ok(sorted.windows(2).find(|pair| pair[0] == pair[1]).map(|pair| pair[0]))
}

//! The tables, filled from the pairing of half-edges. Linear time and memory.

use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_mesh::{MeshView, NONE, Opposite, Topology};

/// How the faces of the mesh run, seen from outside.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Winding {
    /// Counter-clockwise, as modern libraries have it. The tables take each face's cycle backwards,
    /// so that they keep Baumgart's convention, and L is on the left of somebody who walks on the
    /// outside from M to N.
    #[default]
    CounterClockwise,
    /// Clockwise, as Baumgart has it.
    Clockwise,
}

/// One edge, equation 2; [`NONE`] is NULL. It runs from the vertex M to N; the face L runs N to M,
/// and R runs M to N. In R the edge after this one is b, which leaves N, and the one before it d,
/// which arrives at M; in L the one before it is c, which arrives at N, and the one after it e,
/// which leaves M.
#[allow(missing_docs, reason = "the paper's letters, explained above")]
#[repr(C)]
#[derive(Debug, Clone, Copy, PartialEq, Eq, bytemuck::Pod, bytemuck::Zeroable)]
pub struct WingedEdge {
    pub m: u32,
    pub n: u32,
    pub b: u32,
    pub c: u32,
    pub d: u32,
    pub e: u32,
    pub left: u32,
    pub right: u32,
    /// [`EdgeMarks`].
    pub marks: u32,
}

/// What is unusual about an edge; a set of bits.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct EdgeMarks(pub u32);

impl EdgeMarks {
    /// One of several records of an edge with three or more faces; each has one face.
    pub const NON_MANIFOLD: u32 = 1;
    /// One of two records of an edge whose faces run it in the same direction; each has one face.
    pub const NOT_ORIENTED: u32 = 2;
    /// It has no length in the connectivity (M = N), or belongs to a face of fewer than three
    /// proper edges.
    pub const DEGENERATE: u32 = 4;
}

/// The edge table of a mesh, and ways into it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct WingedEdges {
    edges: Vec<WingedEdge>,
    of_half_edge: Vec<u32>,
    of_face: Vec<u32>,
    of_vertex: Vec<u32>,
}

/// Faces between two progress reports.
const REPORT_INTERVAL: usize = 1 << 16;

impl WingedEdges {
    /// Fills the tables. O(H log d) for H half-edges and vertices of degree d; extra memory: that
    /// of [`Topology`].
    ///
    /// # Errors
    /// [`Error::OutOfMemory`](gusset_base::Error::OutOfMemory),
    /// [`Error::Cancelled`](gusset_base::Error::Cancelled).
    pub fn new(mesh: &MeshView<'_>, winding: Winding, job: &Job<'_>) -> Result<Self> {
        let topology = Topology::new(mesh, &job.part(0.0, 0.6))?;
        let faces = mesh.faces();
        let mut tables = WingedEdges {
            edges: alloc::with_capacity(faces.half_edge_count() / 2 + 1)?,
            of_half_edge: alloc::filled(NONE, faces.half_edge_count())?,
            of_face: alloc::with_capacity(faces.len())?,
            of_vertex: alloc::filled(NONE, mesh.positions().len())?,
        };
        let (numbering, filling) = (job.part(0.6, 0.8), job.part(0.8, 1.0));
        for f in 0..faces.len() {
            numbering.step_every(REPORT_INTERVAL, f, faces.len(), "numbering edges")?;
            tables.number_edges(mesh, f, &topology)?;
        }
        for f in 0..faces.len() {
            filling.step_every(REPORT_INTERVAL, f, faces.len(), "filling wings")?;
            tables.fill_wings(mesh, f, winding);
        }
        job.step(1.0, "filling wings")?;
        Ok(tables)
    }

    /// The edges in the order of their first half-edges; M is the vertex where that half-edge
    /// starts.
    pub fn edges(&self) -> &[WingedEdge] {
        &self.edges
    }

    /// Per half-edge (corner), its edge.
    pub fn edge_of_half_edge(&self) -> &[u32] {
        &self.of_half_edge
    }

    /// Per face, its first edge.
    pub fn edge_of_face(&self) -> &[u32] {
        &self.of_face
    }

    /// Per vertex, an edge at it, or [`NONE`].
    pub fn edge_of_vertex(&self) -> &[u32] {
        &self.of_vertex
    }

    /// Gives every half-edge of face `f` its edge, a new one where its mate has none yet.
    fn number_edges(&mut self, mesh: &MeshView<'_>, f: usize, topology: &Topology) -> Result<()> {
        let range = mesh.faces().range(f);
        let mut ends = mesh.face(f).cycle();
        let mut m = ends.next().unwrap_or(NONE);
        for h in range.clone() {
            let n = ends.next().unwrap_or(NONE);
            if self.of_half_edge[h] == NONE {
                let (mate, marks) = mate(mesh, topology, h as u32);
                let edge = self.edges.len() as u32;
                let none = NONE;
                alloc::push(
                    &mut self.edges,
                    WingedEdge { m, n, b: none, c: none, d: none, e: none, left: none, right: none, marks },
                )?;
                self.of_half_edge[h] = edge;
                if let Some(mate) = mate {
                    self.of_half_edge[mate as usize] = edge;
                }
                for v in [m, n] {
                    let at = &mut self.of_vertex[v as usize];
                    *at = edge.min(*at);
                }
            }
            m = n;
        }
        self.of_face.push(self.of_half_edge[range.start]);
        Ok(())
    }

    /// Enters face `f` into the edges along it.
    fn fill_wings(&mut self, mesh: &MeshView<'_>, f: usize, winding: Winding) {
        let range = mesh.faces().range(f);
        let cycle = &self.of_half_edge[range.clone()];
        for (i, v) in mesh.face(f).enumerate() {
            let before = cycle[(i + cycle.len() - 1) % cycle.len()];
            let after = cycle[(i + 1) % cycle.len()];
            let edge = &mut self.edges[cycle[i] as usize];
            // The face as it is stored runs M to N: a mate runs the edge the other way and starts
            // elsewhere.
            let forward = v == edge.m;
            let f = f as u32;
            match (winding, forward) {
                (Winding::Clockwise, true) => (edge.right, edge.d, edge.b) = (f, before, after),
                (Winding::Clockwise, false) => (edge.left, edge.c, edge.e) = (f, before, after),
                // Taken backwards: what comes after in the mesh comes before in the tables.
                (Winding::CounterClockwise, true) => (edge.left, edge.e, edge.c) = (f, before, after),
                (Winding::CounterClockwise, false) => (edge.right, edge.b, edge.d) = (f, before, after),
            }
        }
    }
}

/// The half-edge that shares the record of `h`, and the record's marks.
fn mate(mesh: &MeshView<'_>, topology: &Topology, h: u32) -> (Option<u32>, u32) {
    if topology.is_ignored(h) {
        return (None, EdgeMarks::DEGENERATE);
    }
    match topology.opposite(h) {
        Opposite::Free => (None, 0),
        Opposite::Singular => (None, EdgeMarks::NON_MANIFOLD),
        Opposite::Mate(mate) if mesh.faces().corner(mate) == mesh.faces().corner(h) => (None, EdgeMarks::NOT_ORIENTED),
        Opposite::Mate(mate) => (Some(mate), 0),
    }
}

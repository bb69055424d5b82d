//! The tables, built from paired half-edges. Linear time and memory.

use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_mesh::{MeshView, NONE, Opposite, Topology};

/// The orientation of the mesh's faces, seen from outside.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Winding {
    /// Counter-clockwise, the modern convention. The tables reverse each face's cycle to keep
    /// Baumgart's convention. L is then on the left of an observer who walks on the outside from M
    /// to N.
    #[default]
    CounterClockwise,
    /// Clockwise, Baumgart's convention.
    Clockwise,
}

/// One edge, equation 2; [`NONE`] is NULL.
///
/// The edge runs from vertex M to N. Face R runs it from M to N: in R, b follows it and leaves N,
/// and d precedes it and arrives at M. Face L runs it from N to M: in L, c precedes it and arrives
/// at N, and e follows it and leaves M.
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
    /// The [`EdgeMarks`] of the edge.
    pub marks: u32,
}

/// Properties of an edge, as a set of bits.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct EdgeMarks(pub u32);

impl EdgeMarks {
    /// One of several records of an edge with three or more faces; each has one face.
    pub const NON_MANIFOLD: u32 = 1;
    /// One of two records of an edge whose faces run it in the same direction; each has one face.
    pub const NOT_ORIENTED: u32 = 2;
    /// The edge has equal ends (M = N), or belongs to a face with fewer than three proper edges.
    pub const DEGENERATE: u32 = 4;
}

/// The edge table of a mesh, and its index tables.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct WingedEdges {
    edges: Vec<WingedEdge>,
    of_half_edge: Vec<u32>,
    of_face: Vec<u32>,
    of_vertex: Vec<u32>,
}

/// Number of faces between two progress reports.
const FACES_PER_REPORT: usize = 1 << 16;

impl WingedEdges {
    /// Builds the tables. O(H log d) for H half-edges and vertices of degree d; extra memory as for
    /// [`Topology`].
    ///
    /// # Errors
    /// [`Error::OutOfMemory`](gusset_base::Error::OutOfMemory),
    /// [`Error::Cancelled`](gusset_base::Error::Cancelled).
    pub fn new(mesh: &MeshView<'_>, winding: Winding, job: &Job<'_>) -> Result<Self> {
        let topology = Topology::new(mesh, &job.sub_job(0.0, 0.6))?;
        let faces = mesh.faces();
        let mut tables = WingedEdges {
            edges: alloc::with_capacity(faces.half_edge_count() / 2 + 1)?,
            of_half_edge: alloc::filled(NONE, faces.half_edge_count())?,
            of_face: alloc::with_capacity(faces.len())?,
            of_vertex: alloc::filled(NONE, mesh.positions().len())?,
        };
        let (numbering, filling) = (job.sub_job(0.6, 0.8), job.sub_job(0.8, 1.0));
        for f in 0..faces.len() {
            numbering.step_every(FACES_PER_REPORT, f, faces.len(), "numbering edges")?;
            tables.number_edges_of_face(mesh, f, &topology)?;
        }
        for f in 0..faces.len() {
            filling.step_every(FACES_PER_REPORT, f, faces.len(), "filling wings")?;
            tables.fill_wings_of_face(mesh, f, winding);
        }
        job.step(1.0, "filling wings")?;
        Ok(tables)
    }

    /// Returns the edges in the order of their first half-edges, which start at M.
    pub fn edges(&self) -> &[WingedEdge] {
        &self.edges
    }

    /// Returns the edge of each half-edge (corner).
    pub fn edge_of_half_edge(&self) -> &[u32] {
        &self.of_half_edge
    }

    /// Returns the first edge of each face.
    pub fn edge_of_face(&self) -> &[u32] {
        &self.of_face
    }

    /// Returns an edge at each vertex, or [`NONE`].
    pub fn edge_of_vertex(&self) -> &[u32] {
        &self.of_vertex
    }

    /// Assigns an edge to every half-edge of face `f`, a new one if the mate has none yet.
    fn number_edges_of_face(&mut self, mesh: &MeshView<'_>, f: usize, topology: &Topology) -> Result<()> {
        let range = mesh.faces().corner_range(f);
        let mut ends = mesh.face(f).cycle();
        let mut m = ends.next().unwrap_or(NONE);
        for h in range.clone() {
            let n = ends.next().unwrap_or(NONE);
            if self.of_half_edge[h] == NONE {
                let (mate, marks) = mate_in_record(mesh, topology, h as u32);
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

    /// Adds face `f` to the edges along it.
    fn fill_wings_of_face(&mut self, mesh: &MeshView<'_>, f: usize, winding: Winding) {
        let range = mesh.faces().corner_range(f);
        let cycle = &self.of_half_edge[range.clone()];
        for (i, v) in mesh.face(f).enumerate() {
            let before = cycle[(i + cycle.len() - 1) % cycle.len()];
            let after = cycle[(i + 1) % cycle.len()];
            let edge = &mut self.edges[cycle[i] as usize];
            // The stored face runs from M to N. A mate runs the edge in the opposite direction, and
            // starts at N.
            let forward = v == edge.m;
            let f = f as u32;
            match (winding, forward) {
                (Winding::Clockwise, true) => (edge.right, edge.d, edge.b) = (f, before, after),
                (Winding::Clockwise, false) => (edge.left, edge.c, edge.e) = (f, before, after),
                // Reversed: the next edge in the mesh precedes in the tables.
                (Winding::CounterClockwise, true) => (edge.left, edge.e, edge.c) = (f, before, after),
                (Winding::CounterClockwise, false) => (edge.right, edge.b, edge.d) = (f, before, after),
            }
        }
    }
}

/// Returns the half-edge that shares the record of `h`, and the record's marks.
fn mate_in_record(mesh: &MeshView<'_>, topology: &Topology, h: u32) -> (Option<u32>, u32) {
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

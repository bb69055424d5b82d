//! The quotient complex of a net: what surface it is once glued nodes are one.
//!
//! Vertices are classes of nodes. Edges are pairs of vertices that links join: links with the same ends are one edge.
//! Faces are what is left of cells, quads and triangles; cells with less left (digons, points, folds) are no faces. An
//! edge of no face is a wire, such as the thread between two closed nets; of one face, boundary; of more than two, a
//! branch.
//!
//! Everything takes time linear in the nodes, but for sorting what belongs to glued nodes.

mod boundary;
mod connect;
mod edges;
mod group;
mod presence;
mod scan;

pub use boundary::Boundary;

use super::Net;
use super::topology::{Classes, Topology};
use crate::error::Result;
use crate::job::Job;
use presence::Presence;
use scan::Scan;

/// Two vertices, each by its smallest node.
pub type Edge = [u32; 2];

/// Which cells count.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum Cells {
    /// All.
    #[default]
    All,
    /// Those that [`Net::is_present`].
    Present,
}

/// The quotient complex: its numbers, and whatever keeps it from being a closed oriented surface.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
#[non_exhaustive]
pub struct Complex {
    /// V.
    pub vertices: u64,
    /// E.
    pub edges: u64,
    /// Faces of four corners.
    pub quads: u64,
    /// Faces of three.
    pub triangles: u64,
    /// Cells that have become an edge.
    pub digons: u64,
    /// Cells that have become a point.
    pub points: u64,
    /// Cells that are folded along a diagonal to two edges.
    pub folds: u64,
    /// Edges of one face.
    pub boundary_edges: u64,
    /// Pieces that do not hang together.
    pub components: u64,
    /// Whether the faces can be turned so that no edge is a conflict.
    pub orientable: bool,
    /// The edges of one face, in chains.
    pub boundary: Boundary,
    /// Edges of no face, in order.
    pub wires: Vec<Edge>,
    /// Edges of three faces and more, in order.
    pub branches: Vec<Edge>,
    /// Vertices whose faces are several fans that meet nowhere else, in order.
    pub pinches: Vec<u32>,
    /// Edges that two faces run along the same way, in order.
    pub conflicts: Vec<Edge>,
}

impl Complex {
    /// The complex of all cells of a topology.
    ///
    /// # Errors
    /// [`Error::TooLarge`](crate::Error::TooLarge) (more than 2^31 edges of one face),
    /// [`Error::OutOfMemory`](crate::Error::OutOfMemory), [`Error::Cancelled`](crate::Error::Cancelled).
    pub fn of_topology(topology: &Topology, job: &Job<'_>) -> Result<Self> {
        Complex::new(topology, &Presence::ALL, job)
    }

    /// The complex of a net.
    ///
    /// # Errors
    /// [`Error::TooLarge`](crate::Error::TooLarge) (more than 2^31 edges of one face),
    /// [`Error::OutOfMemory`](crate::Error::OutOfMemory), [`Error::Cancelled`](crate::Error::Cancelled).
    pub fn of(net: &Net<'_>, cells: Cells, job: &Job<'_>) -> Result<Self> {
        let presence = match cells {
            Cells::All => Presence::ALL,
            Cells::Present => Presence::of(net)?,
        };
        Complex::new(net.topology(), &presence, job)
    }

    fn new(topology: &Topology, presence: &Presence, job: &Job<'_>) -> Result<Self> {
        let classes = Classes::of(topology)?;
        let mut complex = Complex::default();
        let mut scan = Scan::new(&classes, presence, &mut complex, &job.part(0.0, 0.5))?;
        edges::edges(&mut scan, &mut complex)?;
        job.step(0.7, "complex")?;
        edges::fans(&mut scan, &mut complex)?;
        complex.components = connect::components(&classes, presence)?;
        complex.orientable = complex.conflicts.is_empty() || connect::is_orientable(&scan, &classes, presence)?;
        complex.boundary_edges = scan.rim.len() as u64;
        let (count, reversed) = (scan.node_count(), topology.is_reversed());
        complex.boundary = Boundary::of(&scan.rim, &mut scan.fan_ends, count, reversed)?;
        job.step(1.0, "complex")?;
        Ok(complex)
    }

    /// F.
    pub fn faces(&self) -> u64 {
        self.quads + self.triangles
    }

    /// Euler's characteristic, V - E + F.
    pub fn euler_characteristic(&self) -> i64 {
        self.vertices as i64 - self.edges as i64 + self.faces() as i64
    }

    /// True if no edge has only one face.
    pub fn is_closed(&self) -> bool {
        self.boundary_edges == 0
    }

    /// True if it is a surface, with or without boundary: no wires, branches and pinches.
    pub fn is_manifold(&self) -> bool {
        self.wires.is_empty() && self.branches.is_empty() && self.pinches.is_empty()
    }

    /// The genus of a surface, summed over its pieces: handles if it is orientable, else crosscaps. `None` if it is no
    /// surface.
    pub fn genus(&self) -> Option<u64> {
        // chi = sum of (2 - 2 g - b), or of (2 - k - b), over the pieces.
        let excess = 2 * self.components as i64 - self.euler_characteristic() - self.boundary.len() as i64;
        let genus = if self.orientable { excess / 2 } else { excess };
        self.is_manifold().then_some(genus.max(0) as u64)
    }
}

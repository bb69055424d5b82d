//! The quotient complex: its counts, and the elements that keep it from being a closed oriented
//! surface.

use super::boundary::{BoundaryChains, Edge};

/// The quotient complex: its counts, and the elements that keep it from being a closed oriented
/// surface.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
#[non_exhaustive]
pub struct Complex {
    /// The number of vertices, V.
    pub vertices: u64,
    /// The number of edges, E.
    pub edges: u64,
    /// The number of faces with four corners.
    pub quads: u64,
    /// The number of faces with three corners.
    pub triangles: u64,
    /// The number of cells reduced to an edge.
    pub digons: u64,
    /// The number of cells reduced to a point.
    pub points: u64,
    /// The number of cells folded along a diagonal to two edges.
    pub folds: u64,
    /// The number of edges of one face.
    pub boundary_edges: u64,
    /// The number of connected components.
    pub components: u64,
    /// Whether the faces can be oriented without conflicting edges.
    pub orientable: bool,
    /// The edges of one face, in chains.
    pub boundary: BoundaryChains,
    /// Edges without a face, in order.
    pub wires: Vec<Edge>,
    /// Edges of three or more faces, in order.
    pub branches: Vec<Edge>,
    /// Vertices whose faces form several fans that meet only there, in order.
    pub pinches: Vec<u32>,
    /// Edges that two faces traverse in the same direction, in order.
    pub conflicts: Vec<Edge>,
}

impl Complex {
    /// Returns the number of faces, F.
    pub fn faces(&self) -> u64 {
        self.quads + self.triangles
    }

    /// Returns the Euler characteristic, V - E + F.
    pub fn euler_characteristic(&self) -> i64 {
        self.vertices as i64 - self.edges as i64 + self.faces() as i64
    }

    /// Returns true if every edge has two or more faces, apart from wires.
    pub fn is_closed(&self) -> bool {
        self.boundary_edges == 0
    }

    /// Returns true for a manifold, with or without boundary: without wires, branches and pinches.
    pub fn is_manifold(&self) -> bool {
        self.wires.is_empty() && self.branches.is_empty() && self.pinches.is_empty()
    }

    /// Returns the genus of a manifold, summed over its components: handles if it is orientable,
    /// otherwise crosscaps. Returns `None` if it is not a manifold.
    pub fn genus(&self) -> Option<u64> {
        // chi = sum of (2 - 2 g - b), or of (2 - k - b), over the components.
        let excess = 2 * self.components as i64 - self.euler_characteristic() - self.boundary.len() as i64;
        let genus = if self.orientable { excess / 2 } else { excess };
        self.is_manifold().then_some(genus.max(0) as u64)
    }
}

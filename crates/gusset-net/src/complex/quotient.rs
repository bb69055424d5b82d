//! The quotient complex: its counts, and the elements that keep it from being a closed oriented
//! surface.

use super::boundary::{Boundary, Edge};

/// The quotient complex: its counts, and the elements that keep it from being a closed oriented
/// surface.
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
    /// Cells reduced to an edge.
    pub digons: u64,
    /// Cells reduced to a point.
    pub points: u64,
    /// Cells that are folded along a diagonal to two edges.
    pub folds: u64,
    /// Edges of one face.
    pub boundary_edges: u64,
    /// Connected components.
    pub components: u64,
    /// True if the faces can be oriented so that no edge is a conflict.
    pub orientable: bool,
    /// The edges of one face, in chains.
    pub boundary: Boundary,
    /// Edges of no face, in order.
    pub wires: Vec<Edge>,
    /// Edges of three faces and more, in order.
    pub branches: Vec<Edge>,
    /// Vertices whose faces are several fans that meet nowhere else, in order.
    pub pinches: Vec<u32>,
    /// Edges that two faces traverse in the same direction, in order.
    pub conflicts: Vec<Edge>,
}

impl Complex {
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

    /// True if it is a manifold, with or without boundary: no wires, branches or pinches.
    pub fn is_manifold(&self) -> bool {
        self.wires.is_empty() && self.branches.is_empty() && self.pinches.is_empty()
    }

    /// The genus of a manifold, summed over its components: handles if it is orientable, else
    /// crosscaps. `None` otherwise.
    pub fn genus(&self) -> Option<u64> {
        // chi = sum of (2 - 2 g - b), or of (2 - k - b), over the components.
        let excess = 2 * self.components as i64 - self.euler_characteristic() - self.boundary.len() as i64;
        let genus = if self.orientable { excess / 2 } else { excess };
        self.is_manifold().then_some(genus.max(0) as u64)
    }
}

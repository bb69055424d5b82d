//! Defects of connectivity, each with the element at fault.

/// A defect or peculiarity of a mesh's connectivity.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Defect {
    /// A face repeats a vertex. If fewer than three distinct consecutive corners remain, the face
    /// is ignored and its neighbours count as adjacent.
    DegenerateFace {
        /// The face.
        face: u32,
        /// The repeated vertex.
        vertex: u32,
    },
    /// The two faces of an edge traverse it in the same direction: one face has the wrong
    /// orientation.
    OrientationConflict {
        /// The two half-edges, the smaller index first.
        half_edges: [u32; 2],
    },
    /// An edge has three or more faces.
    NonManifoldEdge {
        /// The first of the edge's half-edges.
        half_edge: u32,
        /// The number of half-edges of the edge.
        faces: u32,
    },
    /// The surface touches itself at a vertex: the vertex's faces form more than one fan.
    BowTie {
        /// The vertex.
        vertex: u32,
    },
}

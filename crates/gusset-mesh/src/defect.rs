//! Defects of connectivity, each with the element that it is about.

/// Something wrong or unusual about a mesh's connectivity.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Defect {
    /// A face that repeats a vertex. If fewer than three distinct consecutive corners remain, the
    /// face has no border and its neighbours are taken to touch each other.
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

//! The subject of an error: one of two inputs, a kind of element, or a pair of loops.

use std::fmt;

/// One of two pieces.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Side {
    /// The first piece.
    A,
    /// The second piece.
    B,
}

impl fmt::Display for Side {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Side::A => "A",
            Side::B => "B",
        })
    }
}

/// A kind of element that several causes of failure share. Indices count the caller's elements from
/// 0.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Element {
    /// A vertex of a mesh.
    Vertex,
    /// A point of a given loop.
    LoopPoint(Side),
    /// A point of an outline or curve, counted over all of them.
    Point,
    /// A constraint on an outline.
    Constraint,
    /// A query point.
    Query,
    /// A place on a surface.
    Place,
    /// A node of a net.
    Node,
    /// A link of a net.
    Link,
    /// A corner of a mesh's face.
    Corner,
    /// A face of a mesh.
    Face,
    /// A cell of a net.
    Cell,
    /// A bridge of a net.
    Bridge,
    /// An entry of a scene.
    Entry,
}

impl fmt::Display for Element {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Element::Vertex => "vertex",
            Element::LoopPoint(Side::A) => "loop A, point",
            Element::LoopPoint(Side::B) => "loop B, point",
            Element::Point => "point",
            Element::Constraint => "constraint",
            Element::Query => "query",
            Element::Place => "place",
            Element::Node => "node",
            Element::Link => "link",
            Element::Corner => "corner",
            Element::Face => "face",
            Element::Cell => "cell",
            Element::Bridge => "bridge",
            Element::Entry => "entry",
        })
    }
}

/// The reason why a pair of loops is unusable.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum LoopPairFault {
    /// The piece does not exist.
    NoPiece,
    /// The vertex does not exist in the piece.
    NoVertex,
    /// The pair must name a vertex, and names none.
    VertexMissing,
    /// No loop that can be joined passes the vertex.
    NoLoop,
    /// Several loops pass the vertex.
    SeveralLoops,
    /// The pair names one loop twice.
    SameLoop,
    /// A previous pair names the loop.
    LoopTaken,
}

impl LoopPairFault {
    pub(crate) fn describe_fault(self, piece: u32, vertex: u32) -> String {
        match self {
            LoopPairFault::NoPiece => format!("piece {piece} does not exist"),
            LoopPairFault::NoVertex => format!("vertex {vertex} of piece {piece} does not exist"),
            LoopPairFault::VertexMissing => format!("it names piece {piece} but none of its vertices"),
            LoopPairFault::NoLoop => format!("no loop that can be joined passes vertex {vertex} of piece {piece}"),
            LoopPairFault::SeveralLoops => format!("several loops pass vertex {vertex} of piece {piece}"),
            LoopPairFault::SameLoop => format!("vertex {vertex} of piece {piece} is on the pair's other loop"),
            LoopPairFault::LoopTaken => {
                format!("the loop through vertex {vertex} of piece {piece} is in a previous pair")
            }
        }
    }
}

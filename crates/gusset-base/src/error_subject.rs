//! The subject of an error: one of two inputs, a kind of element, or a pair of loops. Also the
//! values that an option takes.

use std::fmt;
use std::ops::RangeInclusive;

/// Formats a number for a message, with an exponent if it is at least 1e9 or below 1e-4.
pub(crate) struct NumberInMessage<'a>(pub(crate) &'a f64);

impl fmt::Display for NumberInMessage<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let value = *self.0;
        if value == 0.0 || !value.is_finite() || (1e-4..1e9).contains(&value.abs()) {
            write!(f, "{value}")
        } else {
            write!(f, "{value:e}")
        }
    }
}

/// The values that an option takes, for a message.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Allowed {
    /// The words after "it must be".
    Phrase(&'static str),
    /// This number and larger ones.
    AtLeast(f64),
    /// This number and smaller ones.
    AtMost(f64),
    /// The numbers from the first to the second, including both.
    Between(f64, f64),
    /// The whole numbers from the first to the second, including both.
    Whole(f64, f64),
    /// The indices of this number of elements.
    IndexBelow(u64),
}

impl From<&'static str> for Allowed {
    fn from(phrase: &'static str) -> Self {
        Allowed::Phrase(phrase)
    }
}

impl From<RangeInclusive<f64>> for Allowed {
    fn from(range: RangeInclusive<f64>) -> Self {
        Allowed::Between(*range.start(), *range.end())
    }
}

impl fmt::Display for Allowed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Allowed::Phrase(phrase) => f.write_str(phrase),
            Allowed::AtLeast(low) => write!(f, "at least {}", NumberInMessage(low)),
            Allowed::AtMost(high) => write!(f, "at most {}", NumberInMessage(high)),
            Allowed::Between(low, high) if low == high => write!(f, "{}", NumberInMessage(low)),
            Allowed::Between(low, high) => write!(f, "from {} to {}", NumberInMessage(low), NumberInMessage(high)),
            Allowed::Whole(low, high) => {
                write!(f, "a whole number from {} to {}", NumberInMessage(low), NumberInMessage(high))
            }
            Allowed::IndexBelow(count) => write!(f, "an index below {count}"),
        }
    }
}

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

impl Element {
    /// Returns the end of the message about an element that a call cannot find among `count`.
    pub(crate) fn describe_absence(self, index: u64, count: u64) -> String {
        let exists = index < count;
        match self {
            Element::Place => {
                format!("is not on the surface: its sheet (of {count}), its cell or its parameters are out of range")
            }
            Element::Entry if exists => "was removed or is of a different kind; name one that the call takes".into(),
            Element::Bridge if exists => "overlaps another bridge, or does not run from side to side of the net".into(),
            Element::Cell if exists => "is not in the region; name a cell of the region".into(),
            _ => format!("does not exist; the index must be below {count}"),
        }
    }
}

/// A number of an element: a coordinate or its value.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Component {
    /// The first coordinate.
    X,
    /// The second coordinate.
    Y,
    /// The third coordinate.
    Z,
    /// The value at an element.
    Value,
}

impl Component {
    /// Returns the first coordinate that satisfies a condition.
    pub fn find(p: glam::DVec3, is_found: impl Fn(f64) -> bool) -> Option<(Self, f64)> {
        [Component::X, Component::Y, Component::Z].into_iter().zip(p.to_array()).find(|&(_, x)| is_found(x))
    }
}

impl fmt::Display for Component {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Component::X => "x",
            Component::Y => "y",
            Component::Z => "z",
            Component::Value => "the value",
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

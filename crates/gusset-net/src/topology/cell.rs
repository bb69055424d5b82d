//! The polygon to which a cell reduces when glued corners are identified (Deryagin, Fig. 4):
//! consecutive equal corners are merged. O(1).

/// A cell after identifying glued corners. Corners are the representatives of their classes, in the
/// cell's order.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ReducedCell {
    /// Four corners.
    Quad([u32; 4]),
    /// One side is contracted.
    Triangle([u32; 3]),
    /// Two sides are contracted, and the other two form one edge.
    Digon([u32; 2]),
    /// One point.
    Point(u32),
    /// Opposite corners coincide, in the first of the three. The sides are the two edges from it to
    /// the others (type c(1,2)).
    Fold([u32; 3]),
    /// Both pairs of opposite corners coincide, which is impossible on a surface. A
    /// [`Topology`](super::Topology) never has such a cell.
    Crossing([u32; 2]),
}

impl ReducedCell {
    /// Reduces a cell, given the classes of its four corners in order.
    pub fn new(corners: [u32; 4]) -> Self {
        let [a, b, c, d] = corners;
        match ([a == b, b == c, c == d, d == a], a == c, b == d) {
            ([false, false, false, false], false, false) => ReducedCell::Quad(corners),
            ([false, false, false, false], true, false) => ReducedCell::Fold([a, b, d]),
            ([false, false, false, false], false, true) => ReducedCell::Fold([b, c, a]),
            ([false, false, false, false], true, true) => ReducedCell::Crossing([a, b]),
            ([true, false, false, false], ..) | ([false, true, false, false], ..) => ReducedCell::Triangle([a, c, d]),
            ([false, false, true, false], ..) => ReducedCell::Triangle([a, b, d]),
            ([false, false, false, true], ..) => ReducedCell::Triangle([a, b, c]),
            // At most two classes, each of consecutive corners.
            _ => match [b, c, d].into_iter().find(|&corner| corner != a) {
                Some(other) => ReducedCell::Digon([a, other]),
                None => ReducedCell::Point(a),
            },
        }
    }

    /// Returns the corners of the polygon, if it has at least three.
    pub fn polygon(&self) -> Option<&[u32]> {
        match self {
            ReducedCell::Quad(corners) => Some(corners),
            ReducedCell::Triangle(corners) => Some(corners),
            _ => None,
        }
    }
}

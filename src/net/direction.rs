//! The two directions of a net.

use super::Shape;

/// The direction in which nets are joined, or the axis of rows or columns.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Direction {
    /// The second net is right of the first: columns are appended.
    Right,
    /// The second net is below the first: rows are appended.
    Down,
}

impl Direction {
    /// Rows and columns exchanged.
    #[must_use]
    pub fn transposed(self) -> Self {
        match self {
            Direction::Right => Direction::Down,
            Direction::Down => Direction::Right,
        }
    }

    /// The number of nodes in this direction, and across it: along a side that is joined.
    pub(crate) fn extent(self, shape: Shape) -> (usize, usize) {
        match self {
            Direction::Right => (shape.columns(), shape.rows()),
            Direction::Down => (shape.rows(), shape.columns()),
        }
    }

    /// Row and column of node `k` of line `i`: row i (`Down`) or column i.
    pub(crate) fn place(self, i: usize, k: usize) -> (usize, usize) {
        match self {
            Direction::Right => (k, i),
            Direction::Down => (i, k),
        }
    }

    /// The link in this direction from node `k` of line `i` to the next line.
    pub(crate) fn link_across(self, shape: Shape, i: usize, k: usize) -> u32 {
        match self {
            Direction::Right => shape.horizontal_link(k, i),
            Direction::Down => shape.vertical_link(i, k),
        }
    }

    /// The link along line `i` from its node `k` to the next.
    pub(crate) fn link_along(self, shape: Shape, i: usize, k: usize) -> u32 {
        match self {
            Direction::Right => shape.vertical_link(k, i),
            Direction::Down => shape.horizontal_link(i, k),
        }
    }
}

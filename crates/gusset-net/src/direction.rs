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
    #[inline]
    pub fn transposed(self) -> Self {
        match self {
            Direction::Right => Direction::Down,
            Direction::Down => Direction::Right,
        }
    }

    /// Orders a row and a column: the coordinate in this direction comes first, so `Right`
    /// exchanges them. It also converts back: node k of line i has row and column
    /// `swap_unless_down(i, k)`, where line i is row i (`Down`) or column i.
    pub(crate) fn swap_unless_down<T>(self, row: T, column: T) -> (T, T) {
        match self {
            Direction::Right => (column, row),
            Direction::Down => (row, column),
        }
    }

    /// Returns the number of nodes in this direction, and across it along a joined side.
    pub(crate) fn line_count_and_length(self, shape: Shape) -> (usize, usize) {
        self.swap_unless_down(shape.rows(), shape.columns())
    }

    /// Returns the link in this direction from node `k` of line `i` to the next line.
    pub(crate) fn link_to_next_line(self, shape: Shape, i: usize, k: usize) -> u32 {
        match self {
            Direction::Right => shape.horizontal_link(k, i),
            Direction::Down => shape.vertical_link(i, k),
        }
    }

    /// Returns the link along line `i` from its node `k` to the next.
    pub(crate) fn link_within_line(self, shape: Shape, i: usize, k: usize) -> u32 {
        match self {
            Direction::Right => shape.vertical_link(k, i),
            Direction::Down => shape.horizontal_link(i, k),
        }
    }
}

//! The size of a net and the numbering of its nodes, links and cells (Deryagin, "Model": H rows, W
//! columns, and the characteristic matrix, whose elements are numbered as links are here).
//!
//! Connectivity is implicit: every question is answered by arithmetic on indices, in O(1).

use gusset_base::error::{Element, Error, Result};

/// The largest number of nodes of a net: links, of which there are two a node, are counted in 32
/// bits.
pub const MAX_NODES: u64 = (1 << 31) - 1;

/// `rows` x `columns` nodes (the paper's H and W), joined by links to cells.
///
/// Indices start at 0, row by row. Node (i, j) is `i * columns + j`. Cell (i, j) is
/// `i * (columns - 1) + j` and has the corners (i, j), (i, j + 1), (i + 1, j + 1), (i + 1, j).
/// Every node has two links: link `2 * node` is horizontal and leads to the next node of its row,
/// `2 * node + 1` is vertical and leads to the next node of its column. Links of the last column
/// and row lead back to the first. These closing links exist only where they are contracted.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Shape {
    rows: u32,
    columns: u32,
}

impl Shape {
    /// Creates a size of `rows` x `columns` nodes.
    ///
    /// # Errors
    /// [`Error::NetTooSmall`] below 2 x 2, [`Error::TooLarge`] above [`MAX_NODES`].
    pub fn new(rows: usize, columns: usize) -> Result<Self> {
        let (h, w) = (rows as u64, columns as u64);
        if h < 2 || w < 2 {
            return Err(Error::NetTooSmall { rows: h, columns: w });
        }
        let count = h.saturating_mul(w);
        Error::check_count("nodes", count, MAX_NODES)?;
        Ok(Shape { rows: h as u32, columns: w as u32 })
    }

    /// Returns the number of rows, H.
    #[inline]
    pub fn rows(self) -> usize {
        self.rows as usize
    }

    /// Returns the number of columns, W.
    #[inline]
    pub fn columns(self) -> usize {
        self.columns as usize
    }

    /// Returns the number of nodes, H x W.
    #[inline]
    pub fn node_count(self) -> usize {
        self.rows() * self.columns()
    }

    /// Returns the number of links, 2 H W: one to the right and one down from each node.
    #[inline]
    pub fn link_count(self) -> usize {
        2 * self.node_count()
    }

    /// Returns the number of cells, (H - 1) x (W - 1).
    #[inline]
    pub fn cell_count(self) -> usize {
        (self.rows() - 1) * (self.columns() - 1)
    }

    /// Node (i, j).
    #[inline]
    pub fn node(self, i: usize, j: usize) -> u32 {
        (i * self.columns() + j) as u32
    }

    /// Returns row and column of a node.
    #[inline]
    pub fn row_and_column(self, node: u32) -> (usize, usize) {
        ((node / self.columns) as usize, (node % self.columns) as usize)
    }

    /// Cell (i, j).
    #[inline]
    pub fn cell(self, i: usize, j: usize) -> u32 {
        (i * (self.columns() - 1) + j) as u32
    }

    /// Returns row and column of the first corner of a cell.
    #[inline]
    pub fn row_and_column_of_cell(self, cell: u32) -> (usize, usize) {
        let columns = self.columns - 1;
        ((cell / columns) as usize, (cell % columns) as usize)
    }

    /// Returns the corners of the cell at (i, j): the nodes (i, j), (i, j + 1), (i + 1, j + 1),
    /// (i + 1, j).
    #[inline]
    pub fn corners_of_cell(self, i: usize, j: usize) -> [u32; 4] {
        let a = self.node(i, j);
        [a, a + 1, a + self.columns + 1, a + self.columns]
    }

    /// Returns the link from node (i, j) to the next node of its row.
    #[inline]
    pub fn horizontal_link(self, i: usize, j: usize) -> u32 {
        2 * self.node(i, j)
    }

    /// Returns the link from node (i, j) to the next node of its column.
    #[inline]
    pub fn vertical_link(self, i: usize, j: usize) -> u32 {
        2 * self.node(i, j) + 1
    }

    /// Returns the two nodes of a link; closing links end in the first column or row.
    pub fn ends_of_link(self, link: u32) -> [u32; 2] {
        let node = link / 2;
        let (i, j) = self.row_and_column(node);
        let end = match (link & 1 == 0, j + 1 == self.columns(), i + 1 == self.rows()) {
            (true, true, _) => self.node(i, 0),
            (true, false, _) => node + 1,
            (false, _, true) => j as u32,
            (false, _, false) => node + self.columns,
        };
        [node, end]
    }

    /// Returns the links between two nodes: at most one, or two in a net of two rows or columns.
    pub(crate) fn links_between(self, [a, b]: [u32; 2]) -> impl Iterator<Item = u32> {
        [2 * a, 2 * a + 1, 2 * b, 2 * b + 1].into_iter().filter(move |&link| {
            let ends = self.ends_of_link(link);
            ends == [a, b] || ends == [b, a]
        })
    }

    /// Returns true for a link between neighbours, false for a closing link.
    #[inline]
    pub fn joins_neighbours(self, link: u32) -> bool {
        let (i, j) = self.row_and_column(link / 2);
        if link & 1 == 0 { j + 1 < self.columns() } else { i + 1 < self.rows() }
    }

    /// Returns the size with rows and columns exchanged.
    #[must_use]
    #[inline]
    pub fn transposed(self) -> Self {
        Shape { rows: self.columns, columns: self.rows }
    }

    /// Returns [`Error::NoSuch`] unless the node exists.
    pub(crate) fn check_node(self, node: u32) -> Result<()> {
        let exists = (node as usize) < self.node_count();
        exists.then_some(()).ok_or(Error::NoSuch {
            element: Element::Node,
            index: node.into(),
            count: self.node_count() as u64,
        })
    }

    /// [`Shape::row_and_column_of_cell`], or [`Error::NoSuch`].
    pub(crate) fn checked_row_and_column_of_cell(self, cell: u32) -> Result<(usize, usize)> {
        let exists = (cell as usize) < self.cell_count();
        exists.then(|| self.row_and_column_of_cell(cell)).ok_or(Error::NoSuch {
            element: Element::Cell,
            index: cell.into(),
            count: self.cell_count() as u64,
        })
    }
}

/// Returns row and column of the corners of the cell at (i, j), in the order of [`Shape::corners_of_cell`].
#[inline]
pub(crate) fn rows_and_columns_of_corners(i: usize, j: usize) -> [(usize, usize); 4] {
    [(i, j), (i, j + 1), (i + 1, j + 1), (i + 1, j)]
}

/// Returns a pair of nodes or classes without regard to order: the smaller first.
pub(crate) fn sorted_pair([a, b]: [u32; 2]) -> [u32; 2] {
    [a.min(b), a.max(b)]
}

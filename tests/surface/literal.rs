//! The paper's search to the letter, with a bit for each NODE. It loses answers: it is here to show
//! that it does.
//!
//! At a node with r > d: J = floor(r / d), and all nodes of the block of 2 J x 2 J cells are
//! zeroed. Four errata apply. A node on the border of the block is also a corner of cells outside
//! (E1). The block may touch the object (E2). The nearest node excludes itself if it is farther
//! than d (E3). Lines dropped in the middle leave two surfaces that count as one (E5). Use
//! `reference::search`, or the index of `Surface`.

use gusset::surface::reference::CellGridShape;

/// The nodes that the literal rule leaves, of an open surface.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct LiteralMask {
    columns: usize,
    nodes: Vec<bool>,
    /// How many nodes were looked at.
    pub(crate) evaluations: u64,
}

impl LiteralMask {
    /// True if a node is left.
    pub(crate) fn has_node(&self, [i, j]: [usize; 2]) -> bool {
        self.nodes[i * self.columns + j]
    }

    /// True if a corner of a cell is left: otherwise nothing will be looked for in the cell.
    pub(crate) fn has_cell(&self, [i, j]: [usize; 2]) -> bool {
        [[i, j], [i, j + 1], [i + 1, j], [i + 1, j + 1]].into_iter().any(|node| self.has_node(node))
    }
}

/// The rule to the letter, node after node. `d`: the greatest diameter of a cell. `drop_lines`: "if
/// 2 J exceeds a dimension, the lines within the ball are left out altogether, as the rest is a
/// surface too, only smaller". Lines of a closed direction are treated as in an open one.
pub(crate) fn literal(
    lattice: CellGridShape,
    d: f64,
    mut measure: impl FnMut([usize; 2]) -> f64,
    drop_lines: bool,
) -> LiteralMask {
    let [m, n] = lattice.cells;
    let mut left = LiteralMask { columns: n + 1, nodes: vec![true; (m + 1) * (n + 1)], evaluations: 0 };
    // The lines that have not been dropped, of which the rule takes neighbours in the list for
    // neighbours on the surface.
    let (mut rows, columns): (Vec<usize>, Vec<usize>) = ((0..=m).collect(), (0..=n).collect());
    let mut place = 0;
    while place < rows.len() * columns.len() {
        let (p, q) = (place / columns.len(), place % columns.len());
        place += 1;
        let node = [rows[p], columns[q]];
        if !left.has_node(node) {
            continue;
        }
        left.evaluations += 1;
        let steps = ((measure(node) / d).floor() as usize).min(m + n);
        if steps == 0 {
            continue;
        }
        let range = |at: usize, count: usize| at.saturating_sub(steps)..(at + steps + 1).min(count);
        let (block_rows, block_columns) = (range(p, rows.len()), range(q, columns.len()));
        for &i in &rows[block_rows.clone()] {
            for &j in &columns[block_columns.clone()] {
                left.nodes[i * (n + 1) + j] = false;
            }
        }
        if drop_lines && 2 * steps > columns.len() - 1 {
            for i in rows.drain(block_rows) {
                left.nodes[i * (n + 1)..(i + 1) * (n + 1)].fill(false);
            }
            // Restarts from the first remaining node: visited nodes are visited again.
            place = 0;
        }
    }
    left
}

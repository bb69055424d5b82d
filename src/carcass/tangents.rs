//! Boxes of the tangents S_u and S_v of the surface through a grid: from the nodes alone, without building patches.
//!
//! Over a cell S = sum w_l(v) C_l(u), C_l the cubics along six lines, so S_u = sum w_l(v) C_l'(u), and C_l' is within the hull of its three control
//! vectors 3 (b_k+1 - b_k), sums of six nodes each. Let those of the block's own lines be in a box B, and those of the lines beside it, on which
//! its cells depend too, no farther than e from B. The weights w_l sum to 1, their absolute values to L at most, and those of the lines
//! that are not the cell's own two to O at most. So S_u is in B, grown by (L - 1) / 2 of its size at both ends, and by O e.

use super::axis::{Axis, TAPS, Weights};
use super::cells::BLOCK;
use super::displacements::grown;
use super::grid::Nodes;
use super::index::Bounds;
use super::sweep::{Ranges, Sums, Sweep};
use std::ops::Range;

/// A grid as seen here.
pub(super) struct Tangents<'a> {
    pub(super) nodes: &'a Nodes<'a>,
    pub(super) u: &'a Axis,
    pub(super) v: &'a Axis,
}

/// Weights that give the control vectors of the derivative.
fn steps(weights: &Weights) -> Sums<3> {
    std::array::from_fn(|b| std::array::from_fn::<_, TAPS, _>(|k| 3.0 * (weights[b + 1][k] - weights[b][k])))
}

/// Boxes of control vectors: on a block's own lines, and on all that its cells depend on.
#[derive(Clone, Copy)]
struct Spread {
    own: Bounds,
    all: Bounds,
}

impl Spread {
    const EMPTY: Spread = Spread { own: Bounds::EMPTY, all: Bounds::EMPTY };

    fn add(&mut self, bounds: Bounds, own: bool) {
        self.all = self.all.joined(bounds);
        if own {
            self.own = self.own.joined(bounds);
        }
    }

    /// Round the sums of lines that lie along `axis`.
    fn sums(&self, axis: &Axis) -> Bounds {
        let beside = (self.own.low - self.all.low).max(self.all.high - self.own.high) * axis.outside();
        let grown = grown(self.own, axis.lebesgue());
        Bounds { low: grown.low - beside, high: grown.high + beside }
    }
}

/// True if a line is a side of one of some cells.
fn is_own(axis: &Axis, cells: &Range<usize>, line: usize) -> bool {
    cells.contains(&line) || line == if axis.is_closed() { cells.end % axis.cells() } else { cells.end }
}

impl Tangents<'_> {
    /// The boxes of S_u and S_v over the blocks of some rows of blocks, row after row.
    pub(super) fn of_blocks(&self, block_rows: Range<usize>, boxes: &mut [[Bounds; 2]]) {
        let Tangents { nodes, u, v } = *self;
        let sweep = Sweep { nodes, u, v, sums: steps };
        let across = v.cells().div_ceil(BLOCK);
        let rows = |r: usize| r * BLOCK..u.cells().min((r + 1) * BLOCK);
        let columns = |c: usize| c * BLOCK..v.cells().min((c + 1) * BLOCK);
        // S_v: along each row once, and then for all blocks that depend on it.
        let mut along = vec![Spread::EMPTY; boxes.len()];
        let mut ranges = Ranges::new(v.cells());
        let mut line = Vec::new();
        for row in u.lines_of(rows(block_rows.start).start..rows(block_rows.end - 1).end) {
            ranges.clear();
            sweep.along(row, &mut line, &mut ranges);
            let needed = block_rows.clone().filter(|&r| u.lines_of(rows(r)).any(|line| line == row));
            let needed: Vec<_> = needed.map(|r| (r, is_own(u, &rows(r), row))).collect();
            for c in 0..across {
                let found = ranges.over(columns(c));
                for &(r, own) in &needed {
                    along[(r - block_rows.start) * across + c].add(found, own);
                }
            }
        }
        let mut ranges = Ranges::new(nodes.columns());
        for (r, (boxes, along)) in block_rows.zip(boxes.chunks_mut(across).zip(along.chunks(across))) {
            ranges.clear();
            for i in rows(r) {
                sweep.across(i, &mut ranges);
            }
            for (c, (bounds, along)) in boxes.iter_mut().zip(along).enumerate() {
                let mut across = Spread::EMPTY;
                across.add(ranges.over(columns(c).start..columns(c).end + 1), true);
                for j in v.lines_of(columns(c)) {
                    across.add(ranges.over(j..j + 1), false);
                }
                *bounds = [across.sums(v), along.sums(u)];
            }
        }
    }
}

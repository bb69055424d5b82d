//! The searched part of the lattice: for each row i the columns from `low[i]` to `high[i]`, both
//! non-decreasing.

use super::rim_pair::MeridianEnds;
use gusset_base::alloc;
use gusset_base::error::Result;
use std::ops::{Range, RangeInclusive};

/// A band of the lattice from (0, 0) to (N, M).
pub(super) struct LatticeBand {
    first_columns: Vec<u32>,
    last_columns: Vec<u32>,
}

impl LatticeBand {
    pub(super) fn whole_lattice(n: usize, m: usize) -> Result<Self> {
        Ok(LatticeBand { first_columns: alloc::filled(0, n + 1)?, last_columns: alloc::filled(m as u32, n + 1)? })
    }

    /// Creates the band of nodes within `width` rows and columns of a path from (0, 0) to (n, m).
    /// The path may omit nodes: it fills the rectangle between two consecutive nodes.
    pub(super) fn around_path(path: &[MeridianEnds], n: usize, m: usize, width: usize) -> Result<Self> {
        let (mut low, mut high) = (alloc::filled(u32::MAX, n + 1)?, alloc::filled(0u32, n + 1)?);
        for step in path.windows(2) {
            let ([i, j], [i2, j2]) = (step[0], step[1]);
            for row in i as usize..=i2 as usize {
                low[row] = low[row].min(j);
                high[row] = high[row].max(j2);
            }
        }
        // Both bounds are monotone: the least column within `width` rows belongs to the first of
        // these rows.
        Ok(LatticeBand {
            first_columns: alloc::collect(
                (0..n + 1).map(|i| low[i.saturating_sub(width)].saturating_sub(width as u32)),
            )?,
            last_columns: alloc::collect((0..n + 1).map(|i| (high[n.min(i + width)] as usize + width).min(m) as u32))?,
        })
    }

    pub(super) fn last_row(&self) -> usize {
        self.first_columns.len() - 1
    }

    pub(super) fn last_column(&self) -> usize {
        self.last_columns[self.last_row()] as usize
    }

    pub(super) fn columns_of_row(&self, i: usize) -> RangeInclusive<usize> {
        self.first_columns[i] as usize..=self.last_columns[i] as usize
    }

    /// Returns the path's nodes on the border of the band, except those on the border of the
    /// lattice.
    pub(super) fn border_nodes(&self, path: &[MeridianEnds]) -> Result<Vec<MeridianEnds>> {
        let (n, m) = (self.last_row(), self.last_column());
        let touching = |&[i, j]: &MeridianEnds| {
            let i = i as usize;
            let below = j > 0 && j <= self.first_columns[i] || i < n && j < self.first_columns[i + 1];
            let above = (j as usize) < m && j >= self.last_columns[i] || i > 0 && j > self.last_columns[i - 1];
            below || above
        };
        alloc::gather(path.iter().filter(|node| touching(node)).copied())
    }

    /// Adds all nodes within `width` rows and columns of the given nodes.
    pub(super) fn widen_at_nodes(&mut self, nodes: &[MeridianEnds], width: usize) {
        let (n, m, w) = (self.last_row(), self.last_column(), width as u32);
        for &[i, j] in nodes {
            let rows = (i as usize).saturating_sub(width)..=n.min(i as usize + width);
            self.first_columns[rows.clone()].iter_mut().for_each(|low| *low = (*low).min(j.saturating_sub(w)));
            self.last_columns[rows].iter_mut().for_each(|high| *high = (*high).max(j.saturating_add(w).min(m as u32)));
        }
        // Restore monotonicity: every row includes the low columns of later rows and the high
        // columns of earlier rows.
        for i in (0..n).rev() {
            self.first_columns[i] = self.first_columns[i].min(self.first_columns[i + 1]);
        }
        for i in 1..=n {
            self.last_columns[i] = self.last_columns[i].max(self.last_columns[i - 1]);
        }
    }

    /// Returns the number of nodes in row `i`.
    pub(super) fn row_width(&self, i: usize) -> usize {
        (self.last_columns[i] - self.first_columns[i]) as usize + 1
    }

    /// Divides the rows 1..=N into blocks with at most `nodes` nodes, or with one row.
    pub(super) fn blocks_of_rows(&self, nodes: usize) -> Result<Vec<Range<usize>>> {
        let mut blocks: Vec<Range<usize>> = Vec::new();
        let mut room = 0;
        for i in 1..=self.last_row() {
            match blocks.last_mut() {
                Some(block) if self.row_width(i) <= room => {
                    block.end = i + 1;
                    room -= self.row_width(i);
                }
                _ => {
                    alloc::push(&mut blocks, i..i + 1)?;
                    room = nodes.saturating_sub(self.row_width(i));
                }
            }
        }
        Ok(blocks)
    }

    pub(super) fn node_count(&self, rows: Range<usize>) -> usize {
        rows.map(|i| self.row_width(i)).sum()
    }
}

//! The cells of hidden bridges, sorted by row.
//!
//! [`Net::is_hidden`] asks every bridge for every cell; this asks every bridge once. Built in
//! O(rows + cells of hidden bridges).

use crate::alloc;
use crate::error::Result;
use crate::net::{Bridge, Direction, Net};
use std::ops::Range;

/// Ranges of hidden cells in each row of cells.
pub(crate) struct HiddenCells {
    offsets: Vec<u32>,
    /// The first column of cells and one past the last.
    ranges: Vec<[u32; 2]>,
    /// Cells in a row.
    columns: usize,
}

impl HiddenCells {
    /// O(rows + cells of hidden bridges).
    pub(crate) fn of(net: &Net<'_>) -> Result<Self> {
        let rows = net.shape().rows() - 1;
        let mut offsets: Vec<u32> = alloc::filled(0, rows + 2)?;
        let hidden = || net.bridges().iter().filter(|bridge| bridge.is_hidden());
        // Counts are kept two rows ahead, so that entry row + 1 is the insertion point of a row and
        // ends as its end.
        hidden().flat_map(ranges).for_each(|(row, _)| offsets[row as usize + 2] += 1);
        for row in 0..rows {
            offsets[row + 2] += offsets[row + 1];
        }
        let mut sorted = alloc::filled([0; 2], offsets[rows + 1] as usize)?;
        for (row, range) in hidden().flat_map(ranges) {
            let at = &mut offsets[row as usize + 1];
            sorted[*at as usize] = range;
            *at += 1;
        }
        offsets.truncate(rows + 1);
        for row in 0..rows {
            sorted[offsets[row] as usize..offsets[row + 1] as usize].sort_unstable();
        }
        Ok(HiddenCells { offsets, ranges: sorted, columns: net.shape().columns() - 1 })
    }

    /// True if no cell is hidden.
    pub(crate) fn is_empty(&self) -> bool {
        self.ranges.is_empty()
    }

    /// The ranges of a row of cells, in order; they may overlap.
    pub(crate) fn row(&self, i: usize) -> &[[u32; 2]] {
        &self.ranges[self.offsets[i] as usize..self.offsets[i + 1] as usize]
    }

    /// True if the cell at (i, j) is hidden.
    pub(crate) fn contains(&self, i: usize, j: usize) -> bool {
        !self.is_empty() && self.row(i).iter().any(|&[from, to]| (from as usize..to as usize).contains(&j))
    }

    /// The runs of cells of row i that are not hidden, in order.
    pub(crate) fn runs(&self, i: usize) -> impl Iterator<Item = Range<usize>> {
        let end = [self.columns as u32, self.columns as u32];
        let mut next = 0;
        self.row(i).iter().copied().chain([end]).filter_map(move |[from, to]| {
            let run = next..from as usize;
            next = next.max(to as usize);
            (!run.is_empty()).then_some(run)
        })
    }
}

/// The rows of cells of a bridge, and its range of columns in each.
fn ranges(bridge: &Bridge) -> impl Iterator<Item = (u32, [u32; 2])> {
    let (before, start, end) = (bridge.at - 1, bridge.start, bridge.end - 1);
    let (rows, range) = match bridge.direction {
        Direction::Right => (start..end, [before, before + 1]),
        Direction::Down => (before..before + 1, [start, end]),
    };
    rows.map(move |row| (row, range))
}

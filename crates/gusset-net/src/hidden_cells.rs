//! The cells of hidden bridges, sorted by row.

use crate::{Bridge, Net};
use gusset_base::error::Result;
use gusset_base::sort::Buckets;
use std::ops::Range;

/// Ranges of hidden cells in each row of cells.
pub(crate) struct HiddenCells {
    /// By row: the first column of cells and one past the last.
    rows: Buckets<[u32; 2]>,
    /// Cells in a row.
    columns: usize,
}

impl HiddenCells {
    /// Collects the cells of hidden bridges. O(rows + cells of hidden bridges).
    pub(crate) fn new(net: &Net<'_>) -> Result<Self> {
        let rows = net.shape().rows() - 1;
        let hidden = net.bridges().iter().filter(|bridge| bridge.is_hidden());
        let mut sorted = Buckets::new(rows, [0; 2], hidden.flat_map(cell_ranges_of_bridge))?;
        (0..rows).for_each(|row| sorted.get_mut(row).sort_unstable());
        Ok(HiddenCells { rows: sorted, columns: net.shape().columns() - 1 })
    }

    /// Returns true if all cells are visible.
    pub(crate) fn is_empty(&self) -> bool {
        self.rows.items().is_empty()
    }

    /// Returns the ranges of a row of cells, in order; they may overlap.
    pub(crate) fn hidden_ranges(&self, i: usize) -> &[[u32; 2]] {
        self.rows.get(i)
    }

    /// Returns true if the cell at (i, j) is hidden.
    pub(crate) fn contains(&self, i: usize, j: usize) -> bool {
        !self.is_empty() && self.hidden_ranges(i).iter().any(|&[from, to]| (from as usize..to as usize).contains(&j))
    }

    /// Returns the runs of cells of row i that are not hidden, in order.
    pub(crate) fn visible_runs(&self, i: usize) -> impl Iterator<Item = Range<usize>> {
        let end = [self.columns as u32, self.columns as u32];
        let mut next = 0;
        self.hidden_ranges(i).iter().copied().chain([end]).filter_map(move |[from, to]| {
            let run = next..from as usize;
            next = next.max(to as usize);
            (!run.is_empty()).then_some(run)
        })
    }
}

/// Returns the rows of cells of a bridge, and its range of columns in each.
fn cell_ranges_of_bridge(bridge: &Bridge) -> impl Iterator<Item = (usize, [u32; 2])> + Clone {
    let (rows, columns) =
        bridge.direction.swap_unless_down(bridge.last_line_of_first_net()..bridge.at, bridge.start..bridge.end - 1);
    rows.map(move |row| (row as usize, [columns.start, columns.end]))
}

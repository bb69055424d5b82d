//! The cells of hidden bridges, row by row.

use crate::alloc;
use crate::error::Result;
use crate::net::{Bridge, Direction, Net};

/// Ranges of hidden cells, sorted into the rows of cells that they are in. [`Net::is_hidden`] asks every bridge for every cell;
/// this asks every bridge once.
pub(crate) struct Hidden {
    offsets: Vec<u32>,
    /// The first column of cells and one past the last.
    ranges: Vec<[u32; 2]>,
}

impl Hidden {
    /// O(rows + cells of hidden bridges).
    pub(crate) fn of(net: &Net<'_>) -> Result<Self> {
        let rows = net.shape().rows() - 1;
        let mut offsets: Vec<u32> = alloc::filled(0, rows + 2)?;
        let hidden = || net.bridges().iter().filter(|bridge| bridge.is_hidden());
        // Counted two rows further on, so that the sums are the starts of rows one further on while they are filled.
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
        Ok(Hidden { offsets, ranges: sorted })
    }

    /// Those of a row of cells, in no order; they may overlap.
    pub(crate) fn row(&self, i: usize) -> &[[u32; 2]] {
        &self.ranges[self.offsets[i] as usize..self.offsets[i + 1] as usize]
    }
}

/// The rows of cells of a bridge, and its cells in each.
fn ranges(bridge: &Bridge) -> impl Iterator<Item = (u32, [u32; 2])> {
    let (before, start, end) = (bridge.at - 1, bridge.start, bridge.end - 1);
    let (rows, range) = match bridge.direction {
        Direction::Right => (start..end, [before, before + 1]),
        Direction::Down => (before..before + 1, [start, end]),
    };
    rows.map(move |row| (row, range))
}

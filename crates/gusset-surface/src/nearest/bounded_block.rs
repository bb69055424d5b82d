//! Blocks of the index with lower bounds of their distances.
//!
//! The bound of a block is the larger of two distances: to its axis-aligned box, and to its
//! oriented box. Both boxes contain the block.

use crate::cells::{CELLS_PER_BLOCK_SIDE, SheetCells, cells_of_block};
use crate::index::BoxPyramid;
use glam::DVec3;

/// A block of any level, with a lower bound of its distance.
#[derive(Debug, Clone, Copy)]
pub(super) struct BlockWithDistanceBound {
    pub(super) distance_bound: f64,
    pub(super) level: usize,
    pub(super) row: usize,
    pub(super) column: usize,
}

impl BlockWithDistanceBound {
    /// The whole sheet.
    pub(super) fn whole_sheet(index: &BoxPyramid) -> BlockWithDistanceBound {
        BlockWithDistanceBound { distance_bound: 0.0, level: index.levels().len(), row: 0, column: 0 }
    }

    /// The four child blocks, with their bounds; `None` for children beyond the edge of the sheet.
    pub(super) fn child_blocks(&self, index: &BoxPyramid, query: DVec3) -> [Option<BlockWithDistanceBound>; 4] {
        let (level, local) = (&index.levels()[self.level - 1], query - index.origin());
        let distances = level.child_boxes(self.row, self.column).distances_squared(local);
        std::array::from_fn(|child| {
            let (row, column) = (2 * self.row + child / 2, 2 * self.column + child % 2);
            let boxed = distances[child];
            let exists = boxed < f64::INFINITY;
            exists.then(|| {
                let oriented = level.oriented_box(row, column).map_or(0.0, |oriented| oriented.distance_squared(local));
                BlockWithDistanceBound {
                    distance_bound: boxed.max(oriented).sqrt(),
                    level: self.level - 1,
                    row,
                    column,
                }
            })
        })
    }

    /// A cell in the middle of the block.
    pub(super) fn middle_cell<const N: usize>(&self, cells: &impl SheetCells<N>) -> [usize; 2] {
        let at = |k: usize, count: usize| ((((2 * k + 1) * CELLS_PER_BLOCK_SIDE) << self.level) / 2).min(count - 1);
        let [rows, columns] = cells.cell_counts();
        [at(self.row, rows), at(self.column, columns)]
    }

    /// The cells of a block of the lowest level.
    pub(super) fn cells_of_block<const N: usize, C: SheetCells<N>>(
        &self,
        cells: &C,
    ) -> impl Iterator<Item = [usize; 2]> + use<N, C> {
        cells_of_block([self.row, self.column], cells.cell_counts())
    }
}

/// The blocks of the lowest level whose bounds are within a fixed limit, depth first.
pub(super) fn lowest_blocks_within(
    index: &BoxPyramid,
    query: DVec3,
    limit: f64,
) -> impl Iterator<Item = BlockWithDistanceBound> {
    let mut stack = vec![BlockWithDistanceBound::whole_sheet(index)];
    std::iter::from_fn(move || {
        while let Some(block) = stack.pop() {
            if block.level == 0 {
                return Some(block);
            }
            stack.extend(
                block.child_blocks(index, query).into_iter().flatten().filter(|child| child.distance_bound <= limit),
            );
        }
        None
    })
}

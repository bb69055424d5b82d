//! Finds the blocks that a stack of parallel planes crosses, in one descent for all planes. Uses
//! the ranges of the planes' function over boxes.

use super::contour_source::levels_between;
use crate::index::BoxPyramid;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;

/// Parallel planes.
#[derive(Debug, Clone, Copy)]
pub struct Planes<'a> {
    /// A point of the plane of level 0.
    pub point: DVec3,
    /// The normal: nonzero, of any length.
    pub normal: DVec3,
    /// Signed distances of the planes from the point along the normal, ascending.
    pub levels: &'a [f64],
}

/// The blocks (row, column) that planes at `offsets` from `point` may cross. `counts` are the
/// numbers of blocks in u and in v.
pub(super) fn blocks_crossed_by_planes(
    index: &BoxPyramid,
    counts: [usize; 2],
    point: DVec3,
    normal: DVec3,
    offsets: &[f64],
    slack: f64,
) -> Result<Vec<[u32; 2]>> {
    // Boxes are relative to the index's origin.
    let shift = (index.origin() - point).dot(normal);
    let crossed = |[low, high]: [f64; 2]| !levels_between(offsets, [low + shift, high + shift], slack).is_empty();
    let levels = index.levels();
    let mut crossed_blocks = Vec::new();
    let mut waiting = vec![(levels.len(), 0, 0)];
    while let Some((level, row, column)) = waiting.pop() {
        if level == 0 {
            alloc::push(&mut crossed_blocks, [row as u32, column as u32])?;
            continue;
        }
        let below = &levels[level - 1];
        let ranges = below.child_boxes(row, column).product_ranges_with_direction(normal);
        // Pushed in reverse, so that blocks are popped in their order.
        for (child, range) in ranges.into_iter().enumerate().rev() {
            let (row, column) = (2 * row + child / 2, 2 * column + child % 2);
            let there = (row << (level - 1)) < counts[0] && (column << (level - 1)) < counts[1];
            if there
                && crossed(range)
                && below
                    .oriented_box(row, column)
                    .is_none_or(|oriented| crossed(oriented.product_range_with_direction(normal)))
            {
                waiting.push((level - 1, row, column));
            }
        }
    }
    Ok(crossed_blocks)
}

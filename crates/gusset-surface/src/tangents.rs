//! Boxes of the tangents S_u and S_v of a grid's surface, computed from the nodes, without patches.
//!
//! Over a cell, S = sum w_l(v) C_l(u), where C_l are the cubics along six lines, so S_u = sum
//! w_l(v) C_l'(u). C_l' lies in the hull of its three control vectors 3 (b_k+1 - b_k), each a sum
//! of six nodes. Let a box B contain the control vectors on the block's own lines. Let the control
//! vectors on the adjacent lines that its cells depend on be at most e outside B. The weights w_l
//! sum to 1, and their absolute values to at most L; without the two lines of the cell itself, to
//! at most O. S_u therefore lies in B, enlarged by (L - 1) / 2 of its size at both ends, and by O
//! e.

use super::axis::{BezierWeights, GridAxis, NODES_PER_CUBIC};
use super::displacements::box_of_weighted_sums;
use super::nodes::Nodes;
use super::weighted_sum_ranges::WeightedSumRanges;
use super::widen_kernel::SumWeights;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::aabb::Aabb;
use std::ops::Range;

/// Weights that compute the control vectors of the derivative.
fn weights_of_control_vectors(weights: &BezierWeights) -> SumWeights<3> {
    std::array::from_fn(|b| std::array::from_fn::<_, NODES_PER_CUBIC, _>(|k| 3.0 * (weights[b + 1][k] - weights[b][k])))
}

/// Boxes of the control vectors on the grid lines of a block of cells. One box covers the lines that
/// pass through the block. The second also covers the adjacent lines that its cells depend on.
#[derive(Clone, Copy)]
struct ControlVectorBoxes {
    box_of_own_lines: Aabb,
    box_of_all_lines: Aabb,
}

impl ControlVectorBoxes {
    const EMPTY: ControlVectorBoxes =
        ControlVectorBoxes { box_of_own_lines: Aabb::EMPTY, box_of_all_lines: Aabb::EMPTY };

    fn add_box(&mut self, bounds: Aabb, own: bool) {
        self.box_of_all_lines = self.box_of_all_lines.union(bounds);
        if own {
            self.box_of_own_lines = self.box_of_own_lines.union(bounds);
        }
    }

    /// A box of the weighted sums of lines along `axis`.
    fn box_of_weighted_line_sums(&self, axis: &GridAxis) -> Aabb {
        let beside = (self.box_of_own_lines.low - self.box_of_all_lines.low)
            .max(self.box_of_all_lines.high - self.box_of_own_lines.high)
            * axis.max_weight_sum_without_end_nodes();
        let grown = box_of_weighted_sums(self.box_of_own_lines, axis.lebesgue_constant());
        Aabb { low: grown.low - beside, high: grown.high + beside }
    }
}

/// Computes the boxes of S_u and S_v over the blocks in some rows of blocks, row by row.
pub(super) fn compute_tangent_boxes(
    nodes: &Nodes<'_>,
    [u, v]: [&GridAxis; 2],
    block_rows: Range<usize>,
    boxes: &mut [[Aabb; 2]],
) -> Result<()> {
    let sweep = WeightedSumRanges { nodes, u, v, sums_of_weights: weights_of_control_vectors };
    // S_v.
    let mut along = alloc::filled(ControlVectorBoxes::EMPTY, boxes.len())?;
    sweep.sweep_rows(block_rows.clone(), |k, found, own| along[k].add_box(found, own))?;
    sweep.sweep_across_rows(block_rows, |k, columns, ranges| {
        let mut across = ControlVectorBoxes::EMPTY;
        across.add_box(ranges.box_of_cells_or_columns(columns.start..columns.end + 1), true);
        v.lines_of_cells(columns).for_each(|j| across.add_box(ranges.box_of_cells_or_columns(j..j + 1), false));
        boxes[k] = [across.box_of_weighted_line_sums(v), along[k].box_of_weighted_line_sums(u)];
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cells::{CELLS_PER_BLOCK_SIDE, SheetCells};
    use crate::{Grid, Patch, Scheme};
    use glam::DVec3;
    use gusset_base::testing::case_count;

    /// Random nodes: tangents lie in their boxes for all weights, and come close to a side of them,
    /// so that the boxes are not too large.
    #[test]
    fn tangents_lie_in_tight_boxes() {
        let mut random = fastrand::Rng::with_seed(7);
        let mut nearest = f64::INFINITY;
        for round in 0..case_count(400) as usize {
            let cells = [[9, 6], [5, 5], [2, 9], [13, 4], [3, 3]][round % 5];
            let closed = [round / 5 % 2 == 1, round / 10 % 2 == 1].map(|closed| closed && cells.iter().all(|&n| n > 2));
            let scheme = if round / 20 % 2 == 0 { Scheme::SixTap } else { Scheme::FourPoint };
            let [h, w] = cells;
            let mut data = vec![0.0; 3 * (h + 1) * (w + 1)];
            for (i, j) in (0..=h).flat_map(|i| (0..=w).map(move |j| (i, j))) {
                let (a, b) = (if closed[0] { i % h } else { i }, if closed[1] { j % w } else { j });
                for k in 0..3 {
                    let again = data[3 * (a * (w + 1) + b) + k];
                    data[3 * (i * (w + 1) + j) + k] = if (a, b) == (i, j) { random.f64() - 0.5 } else { again };
                }
            }
            let grid = Grid::new(Nodes::strided(data, h + 1, w + 1, 0, 0).unwrap(), closed, scheme).unwrap();
            let [rows, columns] = cells.map(|count| count.div_ceil(CELLS_PER_BLOCK_SIDE));
            let mut boxes = vec![[Aabb::EMPTY; 2]; rows * columns];
            grid.fill_tangent_boxes(0..rows, &mut boxes).unwrap();
            for (i, j) in (0..h).flat_map(|i| (0..w).map(move |j| (i, j))) {
                let patch: Patch<4> = Grid::patch(&grid, i, j);
                let bounds = &boxes[i / CELLS_PER_BLOCK_SIDE * columns + j / CELLS_PER_BLOCK_SIDE];
                for k in 0..121 {
                    let jet = patch.jet(f64::from(k / 11) / 10.0, f64::from(k % 11) / 10.0);
                    for (tangent, bounds) in [jet.u, jet.v].into_iter().zip(bounds) {
                        let size = bounds.high - bounds.low;
                        let within = (tangent - bounds.low).min(bounds.high - tangent) / size;
                        nearest = nearest.min(within.min_element());
                        assert!(
                            within.cmpge(DVec3::splat(-1e-13)).all(),
                            "{cells:?} {closed:?} {scheme:?}, cell {i} {j}: {within}"
                        );
                    }
                }
            }
        }
        assert!(nearest < 0.05, "{nearest}");
    }
}

//! Boxes of the displacements of a grid's surface from the bilinear patches of its cells. They are
//! computed from the nodes, without patches (study, 3.2).
//!
//! Over a cell, S = sum w_k(u) C_k(v), where C_k are the cubics along six rows. The bilinear patch
//! is B = (1 - u) L_i(v) + u L_i+1(v), where L_k is the chord of C_k. Therefore S - B = sum w_k
//! (C_k - L_k) + (sum w_k L_k - B).
//!
//! - C_k - L_k = b_1 d_1 + b_2 d_2. Here d are the differences of the inner Bézier points from the
//!   thirds of the chord. The factors b are two Bernstein polynomials of degree 3, whose sum is at
//!   most 3/4. If a box contains all d, then 3/4 of the box, joined with 0, contains C_k - L_k.
//!   Consider weights with sum w_k = 1 and sum |w_k| <= L. The weighted sum of such vectors lies in
//!   this smaller box, enlarged by (L - 1) / 2 of its size at both ends.
//! - The second term is linear in v. At the two columns of the cell, it is the difference between
//!   cubic and chord across the rows.
//!
//! O(nodes), by the vector instructions of `weighted_sum_ranges`.

use super::axis::{BezierWeights, GridAxis, NODES_PER_CUBIC};
use super::nodes::Nodes;
use super::weighted_sum_ranges::WeightedSumRanges;
use super::widen_kernel::SumWeights;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::aabb::Aabb;
use std::ops::Range;

/// Weights that compute the differences of the inner Bézier points from the thirds of the chord.
fn chord_deviation_weights(weights: &BezierWeights) -> SumWeights<2> {
    let [start, first, second, end] = weights;
    let mut deviation = [[0.0; NODES_PER_CUBIC]; 2];
    for k in 0..NODES_PER_CUBIC {
        let third = (end[k] - start[k]) / 3.0;
        deviation[0][k] = first[k] - start[k] - third;
        deviation[1][k] = second[k] - end[k] + third;
    }
    deviation
}

/// Computes the displacement boxes of the blocks in some rows of blocks, row by row.
pub(super) fn compute_displacement_boxes(
    nodes: &Nodes<'_>,
    [u, v]: [&GridAxis; 2],
    block_rows: Range<usize>,
    boxes: &mut [Aabb],
) -> Result<()> {
    let sweep = WeightedSumRanges { nodes, u, v, sums_of_weights: chord_deviation_weights };
    let mut along = alloc::filled(Aabb::EMPTY, boxes.len())?;
    sweep.sweep_rows(block_rows.clone(), |k, found, _| along[k] = along[k].union(found))?;
    sweep.sweep_across_rows(block_rows, |k, columns, ranges| {
        let across = ranges.box_of_cells_or_columns(columns.start..columns.end + 1);
        boxes[k] = box_of_weighted_sums(three_quarters_of_box_with_origin(along[k]), u.lebesgue_constant())
            .minkowski_sum(three_quarters_of_box_with_origin(across));
    })
}

/// A box that contains every weighted sum of points of `bounds` whose weights sum to 1 and whose
/// absolute weights sum to at most `lebesgue`.
pub(super) fn box_of_weighted_sums(bounds: Aabb, lebesgue: f64) -> Aabb {
    let more = 0.5 * (lebesgue - 1.0) * (bounds.high - bounds.low);
    Aabb { low: bounds.low - more, high: bounds.high + more }
}

/// 3/4 of a box, joined with 0.
fn three_quarters_of_box_with_origin(bounds: Aabb) -> Aabb {
    Aabb { low: (0.75 * bounds.low).min(DVec3::ZERO), high: (0.75 * bounds.high).max(DVec3::ZERO) }
}

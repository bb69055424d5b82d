//! Linear prediction of coordinates from decoded neighbours.
//!
//! A coordinate is predicted as a linear combination of its causal neighbours N, NW, NE, NEE, NWW,
//! WW and NN (N is the row above), all relative to W on its left, and of the prediction errors of
//! the node's earlier coordinates. The errors are correlated: a depth camera's x is z times a
//! linear function of the column. Their weights are therefore linear functions of column and row.
//! Invariant: weights are multiples of 2^-fraction, and all operations have a fixed order, so that
//! encoder and decoder predict the same bits. O(1) a node.

use super::bytes::{ByteReader, ByteWriter};
use gusset_base::error::Result;

/// Neighbours other than W.
pub(super) const NEIGHBOUR_COUNT: usize = 7;
/// Weights for the error of each earlier coordinate: constant, times the column, times the row.
pub(super) const WEIGHTS_PER_ERROR: usize = 3;
pub(super) const WEIGHT_COUNT: usize = NEIGHBOUR_COUNT + 2 * WEIGHTS_PER_ERROR;

/// Number of extrapolated nodes before the first node of a row, for neighbours beyond the ends.
pub(super) const MARGIN_NODES_BEFORE: usize = 2;
/// Number of extrapolated nodes after the last node of a row.
pub(super) const MARGIN_NODES_AFTER: usize = 2;

/// The largest magnitude of a weight.
const MAX_WEIGHT_MAGNITUDE: f64 = 64.0;

/// The weights of one coordinate, in units of 2^-fraction. First the weights of N, NW, NE, WW, NN,
/// NEE, NWW, then three for the error of each earlier coordinate: constant, times the column, times
/// the row.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Predictor {
    weights: [i32; WEIGHT_COUNT],
    fraction: u32,
}

impl Predictor {
    /// The fourth corner of a parallelogram, W + N - NW.
    pub(super) const PARALLELOGRAM_WEIGHTS: [f64; WEIGHT_COUNT] =
        [1.0, -1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0];

    /// Weights rounded to `fraction` bits after the binary point, at most 24; those above
    /// [`MAX_WEIGHT_MAGNITUDE`] or not finite become 0.
    pub(super) fn new(weights: &[f64; WEIGHT_COUNT], fraction: u32) -> Self {
        let one = f64::from(1u32 << fraction);
        let whole =
            |weight: f64| if weight.abs() <= MAX_WEIGHT_MAGNITUDE { libm::rint(weight * one) as i32 } else { 0 };
        Predictor { weights: weights.map(whole), fraction }
    }

    pub(super) fn weight(&self, k: usize) -> f64 {
        f64::from(self.weights[k]) / f64::from(1u32 << self.fraction)
    }

    /// Writes the weights; `before` is the number of earlier coordinates.
    pub(super) fn write(&self, before: usize, to: &mut ByteWriter) -> Result<()> {
        self.weights[..NEIGHBOUR_COUNT + WEIGHTS_PER_ERROR * before]
            .iter()
            .try_for_each(|&weight| to.write_signed_varint(weight.into()))
    }

    pub(super) fn read(before: usize, fraction: u32, from: &mut ByteReader<'_>) -> Result<Self> {
        let mut predictor = Predictor { weights: [0; WEIGHT_COUNT], fraction };
        for k in 0..NEIGHBOUR_COUNT + WEIGHTS_PER_ERROR * before {
            predictor.weights[k] = from.read_signed_i32()?;
            if predictor.weight(k).abs() > MAX_WEIGHT_MAGNITUDE {
                return Err(from.error_here("a predictor's weight is too large"));
            }
        }
        Ok(predictor)
    }
}

/// Returns a column or row normalised to -1 to 1.
pub(super) fn normalise_index(k: usize, count: usize) -> f64 {
    2.0 * k as f64 / count as f64 - 1.0
}

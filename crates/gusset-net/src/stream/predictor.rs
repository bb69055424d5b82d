//! Linear prediction of coordinates from decoded neighbours.
//!
//! A coordinate is predicted as a linear combination of its causal neighbours N, NW, NE, NEE, NWW,
//! WW and NN (N is the row above), all relative to W on its left, and of the prediction errors of
//! the node's earlier coordinates. The errors are correlated: a depth camera's x is z times a
//! linear function of the column. Their weights are therefore linear functions of column and row.
//! Invariant: weights are multiples of 2^-fraction, and all operations have a fixed order, so that
//! encoder and decoder predict the same bits. O(1) a node.

use super::bytes::{ByteReader, ByteWriter};
use gusset_base::alloc;
use gusset_base::error::Result;

/// Neighbours other than W.
pub(super) const NEIGHBOUR_COUNT: usize = 7;
/// Weights for the error of each earlier coordinate: constant, times the column, times the row.
pub(super) const WEIGHTS_PER_ERROR: usize = 3;
pub(super) const WEIGHT_COUNT: usize = NEIGHBOUR_COUNT + 2 * WEIGHTS_PER_ERROR;

/// Extrapolated entries before the first node of a row and after its last, for neighbours beyond
/// the ends.
pub(super) const MARGIN_NODES_BEFORE: usize = 2;
const MARGIN_NODES_AFTER: usize = 2;

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
    pub(super) const PARALLELOGRAM: [f64; WEIGHT_COUNT] =
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

/// The values of one coordinate in the current row and the two above, with margins.
#[derive(Debug)]
pub(super) struct CoordinateRows {
    pub(super) here: Vec<f64>,
    pub(super) north: Vec<f64>,
    north2: Vec<f64>,
}

impl CoordinateRows {
    /// # Errors
    /// [`Error::OutOfMemory`](gusset_base::Error::OutOfMemory).
    pub(super) fn new(columns: usize) -> Result<Self> {
        let row = || alloc::zeroed(MARGIN_NODES_BEFORE + columns + MARGIN_NODES_AFTER);
        Ok(CoordinateRows { here: row()?, north: row()?, north2: row()? })
    }

    /// Advances to row `i` of a block. Margins are extrapolated linearly along rows, the left one
    /// of the new row from the two above, so that planes are predicted exactly.
    pub(super) fn advance_to_row(&mut self, i: usize) {
        if i == 0 {
            return;
        }
        std::mem::swap(&mut self.north, &mut self.north2);
        std::mem::swap(&mut self.here, &mut self.north);
        let end = self.north.len() - MARGIN_NODES_AFTER;
        for k in (0..MARGIN_NODES_BEFORE).rev() {
            self.north[k] = extrapolate(self.north[k + 1], self.north[k + 2]);
        }
        for k in end..end + MARGIN_NODES_AFTER {
            self.north[k] = extrapolate(self.north[k - 1], self.north[k - 2]);
        }
        if i == 1 {
            self.north2.copy_from_slice(&self.north);
        }
        for k in 0..MARGIN_NODES_BEFORE {
            self.here[k] =
                sum_or_first(self.north[k], self.north[MARGIN_NODES_BEFORE] - self.north2[MARGIN_NODES_BEFORE]);
        }
    }

    /// The part of the predictions of the row that does not depend on the row itself.
    pub(super) fn predict_from_rows_above(&self, i: usize, predictor: &Predictor, base: &mut [f64]) {
        if i == 0 {
            return base.fill(0.0);
        }
        let [n, nw, ne, _, nn, nee, nww] = Self::neighbour_weights(i, predictor);
        let columns = base.len();
        let north = |k: isize| &self.north[MARGIN_NODES_BEFORE.wrapping_add_signed(k)..][..columns];
        let [a, b, c, e, f] = [0, -1, 1, 2, -2].map(north);
        let d = &self.north2[MARGIN_NODES_BEFORE..][..columns];
        for j in 0..columns {
            base[j] = ((n * a[j] + nw * b[j]) + (ne * c[j] + nee * e[j])) + (nww * f[j] + nn * d[j]);
        }
    }

    /// Returns the weights of the neighbours. The second row lacks NN and is predicted by
    /// parallelograms.
    fn neighbour_weights(i: usize, predictor: &Predictor) -> [f64; NEIGHBOUR_COUNT] {
        std::array::from_fn(|k| if i == 1 { Predictor::PARALLELOGRAM[k] } else { predictor.weight(k) })
    }

    /// Returns the neighbours of node `j` in the order of their weights, relative to W.
    pub(super) fn neighbours(&self, j: usize) -> [f64; NEIGHBOUR_COUNT] {
        let (at, north) = (MARGIN_NODES_BEFORE + j, &self.north);
        let all =
            [north[at], north[at - 1], north[at + 1], self.here[at - 2], self.north2[at], north[at + 2], north[at - 2]];
        all.map(|value| value - self.here[at - 1])
    }

    /// Returns the weights of W and WW in row `i`. The first row of a block is extrapolated
    /// linearly.
    pub(super) fn west_weights(i: usize, predictor: &Predictor) -> [f64; 2] {
        if i == 0 {
            return [2.0, -1.0];
        }
        let weights = Self::neighbour_weights(i, predictor);
        [1.0 - weights.iter().sum::<f64>(), weights[3]]
    }

    /// Fills nodes without coordinates once the row is complete, from their neighbours in the row
    /// or from the row above, as context for the next row.
    pub(super) fn fill_missing_nodes(&mut self, known: &[bool]) {
        let mut start = 0;
        for run in known.chunk_by(|a, b| a == b) {
            let (is_gap, end) = (!run[0], start + run.len());
            if is_gap {
                self.fill_missing_run(start, end, known.len());
            }
            start = end;
        }
    }

    /// Fills nodes `start..end` of a row of `columns`: linearly between known nodes, constant at
    /// the ends, from the row above in an empty row.
    fn fill_missing_run(&mut self, start: usize, end: usize, columns: usize) {
        let row = &mut self.here[MARGIN_NODES_BEFORE..];
        if start == 0 && end == columns {
            return row[..end].copy_from_slice(&self.north[MARGIN_NODES_BEFORE..MARGIN_NODES_BEFORE + columns]);
        }
        let from = if start > 0 { row[start - 1] } else { row[end] };
        let to = if end < columns { row[end] } else { from };
        let slope = (to - from) / (end - start + 1) as f64;
        let slope = if slope.is_finite() { slope } else { 0.0 };
        row[start..end].iter_mut().enumerate().for_each(|(k, x)| *x = from + slope * (k + 1) as f64);
    }
}

/// Linear extrapolation beyond `last`.
fn extrapolate(last: f64, before: f64) -> f64 {
    sum_or_first(last, last - before)
}

/// Returns the sum, or its first term if the sum is not finite.
fn sum_or_first(a: f64, b: f64) -> f64 {
    if (a + b).is_finite() { a + b } else { a }
}

/// Returns a column or row normalised to -1 to 1.
pub(super) fn normalised_place(k: usize, count: usize) -> f64 {
    2.0 * k as f64 / count as f64 - 1.0
}

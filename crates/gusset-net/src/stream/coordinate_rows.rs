//! The rows of one coordinate that prediction reads.

use super::predictor::{MARGIN_NODES_AFTER, MARGIN_NODES_BEFORE, NEIGHBOUR_COUNT, Predictor};
use gusset_base::alloc;
use gusset_base::error::Result;

/// The values of one coordinate in the current row and the two above, with margins.
#[derive(Debug)]
pub(super) struct CoordinateRows {
    pub(super) current_row: Vec<f64>,
    pub(super) north: Vec<f64>,
    north2: Vec<f64>,
}

impl CoordinateRows {
    /// Creates rows of zeros for nets with `columns` columns.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`](gusset_base::Error::OutOfMemory).
    pub(super) fn with_columns(columns: usize) -> Result<Self> {
        let row = || alloc::zeroed(MARGIN_NODES_BEFORE + columns + MARGIN_NODES_AFTER);
        Ok(CoordinateRows { current_row: row()?, north: row()?, north2: row()? })
    }

    /// Advances to row `i` of a block. Margins are extrapolated linearly along rows, the left one
    /// of the new row from the two above, so that planes are predicted exactly.
    pub(super) fn shift_rows_and_extrapolate_margins(&mut self, i: usize) {
        if i == 0 {
            return;
        }
        std::mem::swap(&mut self.north, &mut self.north2);
        std::mem::swap(&mut self.current_row, &mut self.north);
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
            self.current_row[k] = sum_or_first_if_overflow(
                self.north[k],
                self.north[MARGIN_NODES_BEFORE] - self.north2[MARGIN_NODES_BEFORE],
            );
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
        std::array::from_fn(|k| if i == 1 { Predictor::PARALLELOGRAM_WEIGHTS[k] } else { predictor.weight(k) })
    }

    /// Returns the neighbours of node `j` in the order of their weights, relative to W.
    pub(super) fn neighbour_differences_from_west(&self, j: usize) -> [f64; NEIGHBOUR_COUNT] {
        let (at, north) = (MARGIN_NODES_BEFORE + j, &self.north);
        let all = [
            north[at],
            north[at - 1],
            north[at + 1],
            self.current_row[at - 2],
            self.north2[at],
            north[at + 2],
            north[at - 2],
        ];
        all.map(|value| value - self.current_row[at - 1])
    }

    /// Returns the weights of W and WW in row `i`. The first row of a block is extrapolated
    /// linearly.
    pub(super) fn weights_of_two_west_neighbours(i: usize, predictor: &Predictor) -> [f64; 2] {
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
        let row = &mut self.current_row[MARGIN_NODES_BEFORE..];
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
    sum_or_first_if_overflow(last, last - before)
}

/// Returns the sum, or its first term if the sum is not finite.
fn sum_or_first_if_overflow(a: f64, b: f64) -> f64 {
    if (a + b).is_finite() { a + b } else { a }
}

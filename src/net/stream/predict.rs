//! What a coordinate is likely to be, from nodes that are known already.
//!
//! A coordinate is predicted as a linear combination of those of the nodes around it that come before it, all relative to the one
//! on its left (W): N, NW, NE, NEE, NWW, WW and NN, where N is the row above; and of how wrong the predictions of the
//! coordinates before it were for the same node, as such errors go together: a depth camera's x is z times a linear function of
//! the column, and so these weights are linear functions of column and row.

use super::bytes::{Reader, Writer};
use crate::alloc;
use crate::error::Result;

/// Neighbours other than W, and weights for each coordinate that comes before.
pub(super) const NEIGHBOURS: usize = 7;
pub(super) const EACH: usize = 3;
pub(super) const WEIGHTS: usize = NEIGHBOURS + 2 * EACH;

/// What a row of coordinates has before its first node and after its last, for its neighbours' sake.
pub(super) const BEFORE: usize = 2;
const AFTER: usize = 2;

/// The largest weight.
const LARGEST: f64 = 64.0;

/// The weights of one coordinate: of N, NW, NE, WW, NN, NEE, NWW, then for the error of each coordinate before it its own, times
/// the column, times the row. Whole numbers of 2^-fraction, so that they are the same for everybody.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Predictor {
    weights: [i32; WEIGHTS],
    fraction: u32,
}

impl Predictor {
    /// The fourth corner of a parallelogram, W + N - NW.
    pub(super) const PARALLELOGRAM: [f64; WEIGHTS] = [1.0, -1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0];

    /// Weights rounded to `fraction` bits behind the point, 24 at most; those that are too large or no numbers become 0.
    pub(super) fn new(weights: &[f64; WEIGHTS], fraction: u32) -> Self {
        let one = f64::from(1u32 << fraction);
        let whole = |weight: f64| if weight.abs() <= LARGEST { libm::rint(weight * one) as i32 } else { 0 };
        Predictor { weights: weights.map(whole), fraction }
    }

    pub(super) fn weight(&self, k: usize) -> f64 {
        f64::from(self.weights[k]) / f64::from(1u32 << self.fraction)
    }

    /// `before`: coordinates that come before this one.
    pub(super) fn write(&self, before: usize, to: &mut Writer) -> Result<()> {
        self.weights[..NEIGHBOURS + EACH * before].iter().try_for_each(|&weight| to.signed(weight.into()))
    }

    pub(super) fn read(before: usize, fraction: u32, from: &mut Reader<'_>) -> Result<Self> {
        let mut predictor = Predictor { weights: [0; WEIGHTS], fraction };
        for k in 0..NEIGHBOURS + EACH * before {
            predictor.weights[k] = from.signed_i32()?;
            if predictor.weight(k).abs() > LARGEST {
                return Err(from.bad("a predictor's weight is too large"));
            }
        }
        Ok(predictor)
    }
}

/// What is known of one coordinate in the row at hand and the two above: values, with a margin.
#[derive(Debug)]
pub(super) struct Line {
    pub(super) here: Vec<f64>,
    pub(super) north: Vec<f64>,
    north2: Vec<f64>,
}

impl Line {
    /// # Errors
    /// [`Error::OutOfMemory`](crate::Error::OutOfMemory).
    pub(super) fn new(columns: usize) -> Result<Self> {
        let row = || alloc::zeroed(BEFORE + columns + AFTER);
        Ok(Line { here: row()?, north: row()?, north2: row()? })
    }

    /// Goes on to row `i` of a block. Margins go on as rows begin and end; that on the left of the new row is as far from the one
    /// above as that is from the one before, so that whatever is plane is predicted exactly.
    pub(super) fn advance(&mut self, i: usize) {
        if i == 0 {
            return;
        }
        std::mem::swap(&mut self.north, &mut self.north2);
        std::mem::swap(&mut self.here, &mut self.north);
        let end = self.north.len() - AFTER;
        for k in (0..BEFORE).rev() {
            self.north[k] = beyond(self.north[k + 1], self.north[k + 2]);
        }
        for k in end..end + AFTER {
            self.north[k] = beyond(self.north[k - 1], self.north[k - 2]);
        }
        if i == 1 {
            self.north2.copy_from_slice(&self.north);
        }
        for k in 0..BEFORE {
            self.here[k] = sum(self.north[k], self.north[BEFORE] - self.north2[BEFORE]);
        }
    }

    /// The part of the predictions of the row that does not depend on the row itself.
    pub(super) fn base(&self, i: usize, predictor: &Predictor, base: &mut [f64]) {
        if i == 0 {
            return base.fill(0.0);
        }
        let [n, nw, ne, _, nn, nee, nww] = Self::weights(i, predictor);
        let columns = base.len();
        let (north, north2) = (&self.north[..], &self.north2[..]);
        let (a, b, c) = (&north[BEFORE..][..columns], &north[BEFORE - 1..][..columns], &north[BEFORE + 1..][..columns]);
        let (d, e, f) =
            (&north2[BEFORE..][..columns], &north[BEFORE + 2..][..columns], &north[BEFORE - 2..][..columns]);
        for j in 0..columns {
            base[j] = ((n * a[j] + nw * b[j]) + (ne * c[j] + nee * e[j])) + (nww * f[j] + nn * d[j]);
        }
    }

    /// The weights of the neighbours. In the second row there is no NN, and it is predicted by parallelograms.
    fn weights(i: usize, predictor: &Predictor) -> [f64; NEIGHBOURS] {
        std::array::from_fn(|k| if i == 1 { Predictor::PARALLELOGRAM[k] } else { predictor.weight(k) })
    }

    /// The neighbours of node `j` in the order of their weights, relative to W.
    pub(super) fn neighbours(&self, j: usize) -> [f64; NEIGHBOURS] {
        let (at, north) = (BEFORE + j, &self.north);
        let all =
            [north[at], north[at - 1], north[at + 1], self.here[at - 2], self.north2[at], north[at + 2], north[at - 2]];
        all.map(|value| value - self.here[at - 1])
    }

    /// The weights of W and WW in row `i`. In the first row of a block there is nothing else, and coordinates go on as they began.
    pub(super) fn west(i: usize, predictor: &Predictor) -> [f64; 2] {
        if i == 0 {
            return [2.0, -1.0];
        }
        let weights = Self::weights(i, predictor);
        [1.0 - weights.iter().sum::<f64>(), weights[3]]
    }

    /// Once the row is known: nodes without coordinates get them from those beside them in the row, or from the row above, so
    /// that the row below has something to go by.
    pub(super) fn bridge_gaps(&mut self, known: &[bool]) {
        let mut start = 0;
        for run in known.chunk_by(|a, b| a == b) {
            let (gap, end) = (!run[0], start + run.len());
            if gap {
                self.bridge(start, end, known.len());
            }
            start = end;
        }
    }

    /// Nodes `start..end` of a row of `columns`: in between along a line, at the ends level, in an empty row as above.
    fn bridge(&mut self, start: usize, end: usize, columns: usize) {
        let row = &mut self.here[BEFORE..];
        if start == 0 && end == columns {
            return row[..end].copy_from_slice(&self.north[BEFORE..BEFORE + columns]);
        }
        let from = if start > 0 { row[start - 1] } else { row[end] };
        let to = if end < columns { row[end] } else { from };
        let slope = (to - from) / (end - start + 1) as f64;
        let slope = if slope.is_finite() { slope } else { 0.0 };
        row[start..end].iter_mut().enumerate().for_each(|(k, x)| *x = from + slope * (k + 1) as f64);
    }
}

/// What follows on `last`, as far from it as that from the one before.
fn beyond(last: f64, before: f64) -> f64 {
    sum(last, last - before)
}

/// A sum, or its first part if the whole is too large.
fn sum(a: f64, b: f64) -> f64 {
    if (a + b).is_finite() { a + b } else { a }
}

/// Column or row as predictors' weights see it: -1 to 1.
pub(super) fn place(k: usize, count: usize) -> f64 {
    2.0 * k as f64 / count as f64 - 1.0
}

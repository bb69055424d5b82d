//! Fitting of a block's predictors to a sample of its nodes, by iteratively reweighted least
//! squares.
//!
//! The code length grows with the logarithm of the residual, so observations have Cauchy weights. A
//! few nodes at discontinuities then cannot spoil the fit of the others. O(sample) per round; a few
//! rounds.

use super::coordinate_rows::CoordinateRows;
use super::levels::LevelMap;
use super::predictor::{
    MARGIN_NODES_BEFORE, NEIGHBOUR_COUNT, Predictor, WEIGHT_COUNT, WEIGHTS_PER_ERROR, normalise_index,
};
use super::row_coder::{NodeRow, NodeState};
use gusset_base::alloc;
use gusset_base::error::Result;

/// All orders of three coordinates.
pub(super) const COORDINATE_ORDERS: [[usize; 3]; 6] =
    [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]];
/// The cost of a predictor's weight in a stream, in bits.
const BITS_PER_STORED_WEIGHT: f64 = 14.0;

/// A node of the sample.
#[derive(Clone, Copy)]
struct SampleNode {
    /// For each coordinate the neighbours' differences from W, in the order of the weights, and the
    /// node's own.
    neighbours: [[f64; NEIGHBOUR_COUNT]; 3],
    coordinates: [f64; 3],
    /// Column and row, -1 to 1.
    column: f64,
    row: f64,
}

/// Nodes of some rows of a block.
pub(super) struct NodeSample {
    points: Vec<SampleNode>,
    /// Nodes of the block per node of the sample.
    nodes_per_point: f64,
}

/// A predictor, the cost of the sample with it in bits, and its errors.
struct PredictorFit {
    weights: [f64; WEIGHT_COUNT],
    cost_bits: f64,
    errors: Vec<f64>,
}

impl NodeSample {
    /// About `count` nodes in rows spread over `rows`. `load` reads a row.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`](gusset_base::Error::OutOfMemory).
    pub(super) fn new<T, L: LevelMap<T>>(
        rows: std::ops::Range<usize>,
        height: usize,
        columns: usize,
        count: usize,
        levels: &L,
        load: impl Fn(usize, &mut NodeRow),
    ) -> Result<Self> {
        // Every `step`-th node of few rows, as three rows are read for one.
        let lines = (count / 64).clamp(1, rows.len().max(3) - 2);
        let step = (columns * lines / count).max(1);
        let mut points = alloc::with_capacity(lines * columns.div_ceil(step))?;
        let (mut row, mut known) = (NodeRow::new(columns)?, alloc::filled(true, columns)?);
        let mut state = [
            CoordinateRows::with_columns(columns)?,
            CoordinateRows::with_columns(columns)?,
            CoordinateRows::with_columns(columns)?,
        ];
        for line in 0..if rows.len() > 2 { lines } else { 0 } {
            let at = rows.start + 2 + line * (rows.len() - 2) / lines;
            let first = at - 2;
            for i in first..=at {
                load(i, &mut row);
                known.iter_mut().zip(&row.nodes).for_each(|(known, &node)| *known = node == NodeState::Coded);
                for (line, from) in state.iter_mut().zip(&row.levels) {
                    fill_row_of_coordinate(line, i - first, from, &known, levels);
                }
            }
            for j in (0..columns).step_by(step).filter(|&j| known[j]) {
                let neighbours = std::array::from_fn(|axis| state[axis].neighbour_differences_from_west(j));
                let own = std::array::from_fn(|axis| {
                    state[axis].current_row[MARGIN_NODES_BEFORE + j]
                        - state[axis].current_row[MARGIN_NODES_BEFORE + j - 1]
                });
                points.push(SampleNode {
                    neighbours,
                    coordinates: own,
                    column: normalise_index(j, columns),
                    row: normalise_index(at, height),
                });
            }
        }
        scale_differences(&mut points, state.map(|line| levels.value_spacing(max_magnitude_in_row(&line))));
        let nodes_per_point = (rows.len() * columns) as f64 / points.len().max(1) as f64;
        Ok(NodeSample { points, nodes_per_point })
    }

    /// Returns the order of coordinates of least cost.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`](gusset_base::Error::OutOfMemory).
    pub(super) fn best_coordinate_order(&self, fraction: u32) -> Result<usize> {
        let mut best = (f64::INFINITY, 0);
        for (k, order) in COORDINATE_ORDERS.into_iter().enumerate() {
            let cost = self.fit_predictors(order, fraction, 1)?.1;
            if cost < best.0 {
                best = (cost, k);
            }
        }
        Ok(best.1)
    }

    /// Predictors for the coordinates in an order, and the cost of the sample with them.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`](gusset_base::Error::OutOfMemory).
    pub(super) fn fit_predictors(
        &self,
        order: [usize; 3],
        fraction: u32,
        rounds: usize,
    ) -> Result<([Predictor; 3], f64)> {
        let mut fits: Vec<PredictorFit> = alloc::with_capacity(3)?;
        for axis in order {
            let fit = self.fit_predictor_of_axis(axis, &fits, rounds)?;
            fits.push(fit);
        }
        let cost = fits.iter().map(|fit| fit.cost_bits).sum();
        Ok((std::array::from_fn(|k| Predictor::new(&fits[k].weights, fraction)), cost))
    }

    /// Returns the best of three predictors: the parallelogram, with added errors of the
    /// coordinates before, and with all weights free.
    fn fit_predictor_of_axis(&self, axis: usize, before: &[PredictorFit], rounds: usize) -> Result<PredictorFit> {
        let mut best = self.evaluate_weights(axis, before, Predictor::PARALLELOGRAM_WEIGHTS)?;
        for free in [NEIGHBOUR_COUNT, 0] {
            if free == NEIGHBOUR_COUNT && before.is_empty() {
                continue;
            }
            let mut fit = self.evaluate_weights(axis, before, Predictor::PARALLELOGRAM_WEIGHTS)?;
            for _ in 0..rounds {
                let weights = self.refit_weights(axis, before, &fit, free)?;
                fit = self.evaluate_weights(axis, before, weights)?;
            }
            if fit.cost_bits < best.cost_bits {
                best = fit;
            }
        }
        Ok(best)
    }

    /// Returns the features of a point: its neighbours, and the errors of the coordinates before.
    fn features_of_node(&self, axis: usize, before: &[PredictorFit], at: usize) -> [f64; WEIGHT_COUNT] {
        let point = &self.points[at];
        let mut features = [0.0; WEIGHT_COUNT];
        features[..NEIGHBOUR_COUNT].copy_from_slice(&point.neighbours[axis]);
        for (fit, to) in before.iter().zip(features[NEIGHBOUR_COUNT..].chunks_exact_mut(WEIGHTS_PER_ERROR)) {
            let error = fit.errors[at];
            to.copy_from_slice(&[error, error * point.column, error * point.row]);
        }
        features
    }

    /// Returns the cost and errors of given weights.
    fn evaluate_weights(
        &self,
        axis: usize,
        before: &[PredictorFit],
        weights: [f64; WEIGHT_COUNT],
    ) -> Result<PredictorFit> {
        let used = weights.iter().filter(|&&weight| weight != 0.0).count();
        let mut fit = PredictorFit { weights, cost_bits: 0.0, errors: alloc::with_capacity(self.points.len())? };
        // The logarithm of a product, taken before it leaves the range.
        let mut product = 1.0;
        for at in 0..self.points.len() {
            let features = self.features_of_node(axis, before, at);
            let guess: f64 = features.iter().zip(&weights).map(|(x, weight)| x * weight).sum();
            let error = self.points[at].coordinates[axis] - guess;
            let error = if error.is_finite() { error } else { 0.0 };
            fit.errors.push(error);
            product *= 0.5 + (error.abs() + 0.5).floor().min(1e18);
            if !(1e-200..1e200).contains(&product) {
                fit.cost_bits += libm::log2(product);
                product = 1.0;
            }
        }
        fit.cost_bits += libm::log2(product);
        fit.cost_bits += BITS_PER_STORED_WEIGHT * used as f64 / self.nodes_per_point;
        Ok(fit)
    }

    /// Weighted least squares about the weights of `fit`, with Cauchy weights from its errors;
    /// weights before `first` stay. Normal equations with a regularised diagonal, so that
    /// undetermined weights stay.
    fn refit_weights(
        &self,
        axis: usize,
        before: &[PredictorFit],
        fit: &PredictorFit,
        first: usize,
    ) -> Result<[f64; WEIGHT_COUNT]> {
        let count = NEIGHBOUR_COUNT + WEIGHTS_PER_ERROR * before.len();
        let scale = 2.0 * median(&fit.errors)? + 1.0;
        let mut normal = [[0.0; WEIGHT_COUNT]; WEIGHT_COUNT];
        let mut right = [0.0; WEIGHT_COUNT];
        for at in 0..self.points.len() {
            let error = fit.errors[at];
            let relative = error / scale;
            let weight = 1.0 / (1.0 + relative * relative);
            let features = self.features_of_node(axis, before, at);
            for a in first..count {
                let weighted = weight * features[a];
                right[a] += weighted * error;
                for b in first..=a {
                    normal[a][b] += weighted * features[b];
                }
            }
        }
        let mut weights = fit.weights;
        let change = solve_by_cholesky(normal, right, first..count);
        weights.iter_mut().zip(change).for_each(|(weight, change)| *weight += change);
        Ok(weights)
    }
}

/// Returns the largest absolute value in the current row of a coordinate.
fn max_magnitude_in_row(rows: &CoordinateRows) -> f64 {
    rows.current_row[MARGIN_NODES_BEFORE..].iter().fold(0.0, |largest: f64, value| largest.max(value.abs()))
}

/// Scales differences to units of the resolution.
fn scale_differences(points: &mut [SampleNode], resolution: [f64; 3]) {
    for point in points {
        for ((neighbours, own), unit) in point.neighbours.iter_mut().zip(&mut point.coordinates).zip(resolution) {
            neighbours.iter_mut().chain([own]).for_each(|x| *x /= unit);
        }
    }
}

/// Enters a row into the state of a coordinate.
fn fill_row_of_coordinate<T, L: LevelMap<T>>(
    line: &mut CoordinateRows,
    i: usize,
    row: &[i64],
    known: &[bool],
    levels: &L,
) {
    line.shift_rows_and_extrapolate_margins(i);
    let mut last = 0.0;
    for ((to, &level), &known) in line.current_row[MARGIN_NODES_BEFORE..].iter_mut().zip(row).zip(known) {
        let value = levels.predictor_value(level);
        if known && value.is_finite() {
            last = value;
        }
        *to = last;
    }
    line.fill_missing_nodes(known);
    if i == 0 {
        let first = line.current_row[MARGIN_NODES_BEFORE];
        line.current_row[..MARGIN_NODES_BEFORE].fill(first);
    }
}

/// Returns the median of magnitudes.
fn median(errors: &[f64]) -> Result<f64> {
    if errors.is_empty() {
        return Ok(0.0);
    }
    let mut magnitudes = alloc::collect(errors.iter().map(|error| error.abs()))?;
    let middle = magnitudes.len() / 2;
    Ok(*magnitudes.select_nth_unstable_by(middle, f64::total_cmp).1)
}

/// Solves the symmetric equations of some rows, given by their lower triangle, by Cholesky
/// factorisation. Zeros elsewhere, and if the solution is not finite.
fn solve_by_cholesky(
    mut normal: [[f64; WEIGHT_COUNT]; WEIGHT_COUNT],
    mut right: [f64; WEIGHT_COUNT],
    rows: std::ops::Range<usize>,
) -> [f64; WEIGHT_COUNT] {
    let largest = rows.clone().map(|k| normal[k][k]).fold(0.0, f64::max);
    for a in rows.clone() {
        normal[a][a] += 1e-9 * largest + f64::MIN_POSITIVE;
        for b in rows.start..=a {
            let dot: f64 = (rows.start..b).map(|k| normal[a][k] * normal[b][k]).sum();
            let rest = normal[a][b] - dot;
            normal[a][b] = if a == b { rest.max(0.0).sqrt() } else { rest / normal[b][b] };
        }
    }
    for a in rows.clone() {
        let dot: f64 = (rows.start..a).map(|k| normal[a][k] * right[k]).sum();
        right[a] = (right[a] - dot) / normal[a][a];
    }
    for a in rows.clone().rev() {
        let dot: f64 = (a + 1..rows.end).map(|k| normal[k][a] * right[k]).sum();
        right[a] = (right[a] - dot) / normal[a][a];
    }
    let solved = rows.clone().all(|k| right[k].is_finite());
    std::array::from_fn(|k| if solved && rows.contains(&k) { right[k] } else { 0.0 })
}

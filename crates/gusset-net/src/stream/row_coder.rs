//! Coding of rows of levels, the routine that encoder and decoder share: gaps, predictions,
//! residuals. O(1) a node.

use super::coder::EntropyCoder;
use super::coordinate_rows::CoordinateRows;
use super::levels::LevelMap;
use super::predictor::{MARGIN_NODES_BEFORE, NEIGHBOUR_COUNT, Predictor, WEIGHTS_PER_ERROR, normalise_index};
use super::residuals::ResidualCoder;
use super::symbol_model::SymbolModel;
use gusset_base::alloc;
use gusset_base::error::Result;

/// The bound on magnitudes in sums of ten, which must not overflow.
const MAX_SUMMED_MAGNITUDE: u64 = 1 << 56;

/// The treatment of a node.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum NodeState {
    /// Its coordinates are coded.
    Coded,
    /// It repeats an earlier node.
    Duplicate,
    /// It lacks coordinates.
    Missing,
}

/// A row of nodes, and the levels of those that are coded.
#[derive(Debug)]
pub(super) struct NodeRow {
    pub(super) nodes: Vec<NodeState>,
    pub(super) levels: [Vec<i64>; 3],
}

impl NodeRow {
    /// # Errors
    /// [`Error::OutOfMemory`](gusset_base::Error::OutOfMemory).
    pub(super) fn new(columns: usize) -> Result<Self> {
        let levels = || alloc::zeroed(columns);
        Ok(NodeRow { nodes: alloc::filled(NodeState::Coded, columns)?, levels: [levels()?, levels()?, levels()?] })
    }
}

/// One coordinate of the rows of a block.
struct CoordinateChannel {
    axis: usize,
    predictor: Predictor,
    residuals: ResidualCoder,
    rows: CoordinateRows,
    /// Magnitudes of residuals in this row and the one above, with margins, and the expected ones.
    magnitudes: [Vec<u64>; 2],
    expected: Vec<u64>,
    /// The parts of predictions known before the row, and the prediction errors.
    base_predictions: Vec<f64>,
    errors: Vec<f64>,
}

/// Codes the rows of a block in order.
pub(super) struct RowCoder {
    channels: Vec<CoordinateChannel>,
    known: Vec<bool>,
    gaps: [Vec<bool>; 3],
    gap_models: Vec<SymbolModel<2>>,
    ratio_classes: Vec<u8>,
    columns: Vec<f64>,
    next: usize,
}

impl RowCoder {
    /// Creates a coder. `order` has the coordinates in the order of coding, each with its
    /// predictor.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`](gusset_base::Error::OutOfMemory).
    pub(super) fn new(columns: usize, order: [(usize, Predictor); 3]) -> Result<Self> {
        let channels =
            alloc::try_collect(order.map(|(axis, predictor)| CoordinateChannel::new(axis, predictor, columns)))?;
        let gaps = || alloc::filled(false, columns + 2 * MARGIN_NODES_BEFORE);
        Ok(RowCoder {
            channels,
            known: alloc::filled(true, columns)?,
            gaps: [gaps()?, gaps()?, gaps()?],
            gap_models: alloc::filled(SymbolModel::new([1.0; 2]), 128)?,
            ratio_classes: alloc::zeroed(columns)?,
            columns: alloc::collect((0..columns).map(|j| normalise_index(j, columns)))?,
            next: 0,
        })
    }

    /// Codes the next row, at `vertical` between -1 and 1. If `may_miss`, gaps among nodes that are
    /// not duplicates are coded first.
    pub(super) fn code_row<C: EntropyCoder, T, L: LevelMap<T>>(
        &mut self,
        coder: &mut C,
        row: &mut NodeRow,
        levels: &L,
        may_miss: bool,
        vertical: f64,
    ) {
        if may_miss {
            self.code_missing_nodes(coder, &mut row.nodes);
        }
        self.known.iter_mut().zip(&row.nodes).for_each(|(known, &node)| *known = node == NodeState::Coded);
        self.ratio_classes.fill(0);
        for k in 0..3 {
            let (before, rest) = self.channels.split_at_mut(k);
            let channel = &mut rest[0];
            channel.prepare_predictions(self.next, before, &self.columns, vertical);
            classify_ratios(before, &mut self.ratio_classes);
            channel.code_coordinates(
                coder,
                self.next,
                &mut row.levels[channel.axis],
                levels,
                &self.known,
                &self.ratio_classes,
            );
        }
        self.next += 1;
    }

    /// Codes which nodes are missing, in the context of the neighbours' gaps.
    fn code_missing_nodes<C: EntropyCoder>(&mut self, coder: &mut C, nodes: &mut [NodeState]) {
        self.gaps.rotate_right(1);
        let [here, north, north2] = &mut self.gaps;
        for (j, node) in nodes.iter_mut().enumerate() {
            let at = j + MARGIN_NODES_BEFORE;
            let bits = [here[at - 1], here[at - 2], north[at - 1], north[at], north[at + 1], north[at + 2], north2[at]];
            let context = bits.iter().fold(0, |context, &bit| 2 * context + usize::from(bit));
            here[at] = *node != NodeState::Duplicate
                && coder.code_symbol(&mut self.gap_models[context], usize::from(*node == NodeState::Missing)) == 1;
            if *node != NodeState::Duplicate {
                *node = if here[at] { NodeState::Missing } else { NodeState::Coded };
            }
        }
    }
}

/// The ratio of observed to expected magnitudes in the earlier coordinates, in four classes.
fn classify_ratios(before: &[CoordinateChannel], classes: &mut [u8]) {
    let class = |found: u64, expected: u64| {
        // In tenths, with half a unit added.
        let (found, expected) = (10 * found + 5, expected + 5);
        u8::from(2 * found >= expected) + u8::from(4 * found >= 5 * expected) + u8::from(2 * found >= 5 * expected)
    };
    match before {
        [] => {}
        [a] => {
            let pairs = a.magnitudes[0][MARGIN_NODES_BEFORE..].iter().zip(&a.expected);
            classes.iter_mut().zip(pairs).for_each(|(to, (&found, &expected))| *to = class(found, expected));
        }
        [a, b, ..] => {
            let found = a.magnitudes[0][MARGIN_NODES_BEFORE..].iter().zip(&b.magnitudes[0][MARGIN_NODES_BEFORE..]);
            let expected = a.expected.iter().zip(&b.expected);
            for (to, (found, expected)) in classes.iter_mut().zip(found.zip(expected)) {
                *to = class(found.0 + found.1, expected.0 + expected.1);
            }
        }
    }
}

impl CoordinateChannel {
    fn new(axis: usize, predictor: Predictor, columns: usize) -> Result<Self> {
        let magnitudes = || alloc::zeroed(columns + 2 * MARGIN_NODES_BEFORE);
        Ok(CoordinateChannel {
            axis,
            predictor,
            residuals: ResidualCoder::new()?,
            rows: CoordinateRows::with_columns(columns)?,
            magnitudes: [magnitudes()?, magnitudes()?],
            expected: alloc::zeroed(columns)?,
            base_predictions: alloc::zeroed(columns)?,
            errors: alloc::zeroed(columns)?,
        })
    }

    /// Computes the parts of predictions that do not depend on the row, vectorised.
    fn prepare_predictions(&mut self, i: usize, before: &[CoordinateChannel], columns: &[f64], vertical: f64) {
        self.rows.shift_rows_and_extrapolate_margins(i);
        self.rows.predict_from_rows_above(i, &self.predictor, &mut self.base_predictions);
        for (p, other) in before.iter().enumerate() {
            let [own, column, row] =
                std::array::from_fn(|m| self.predictor.weight(NEIGHBOUR_COUNT + WEIGHTS_PER_ERROR * p + m));
            let constant = own + row * vertical;
            for ((base, &error), &u) in self.base_predictions.iter_mut().zip(&other.errors).zip(columns) {
                *base += (constant + column * u) * error;
            }
        }
        self.magnitudes.swap(0, 1);
        let [here, north] = &mut self.magnitudes;
        here[..MARGIN_NODES_BEFORE].fill(north[MARGIN_NODES_BEFORE]);
        let (n, nw, ne) =
            (&north[MARGIN_NODES_BEFORE..], &north[MARGIN_NODES_BEFORE - 1..], &north[MARGIN_NODES_BEFORE + 1..]);
        for (j, expected) in self.expected.iter_mut().enumerate() {
            *expected = 3 * n[j] + 2 * nw[j] + ne[j];
        }
    }

    /// Codes the row node by node.
    fn code_coordinates<C: EntropyCoder, T, L: LevelMap<T>>(
        &mut self,
        coder: &mut C,
        i: usize,
        row: &mut [i64],
        levels: &L,
        known: &[bool],
        ratio_classes: &[u8],
    ) {
        let [west, west2] = CoordinateRows::weights_of_two_west_neighbours(i, &self.predictor);
        // Without a row above, the nodes on the left take its weight.
        let [near, far] = if i == 0 { [8, 2] } else { [3, 1] };
        let columns = row.len();
        let (base, expected, errors) =
            (&self.base_predictions[..columns], &mut self.expected[..columns], &mut self.errors[..columns]);
        let (known, ratio_classes) = (&known[..columns], &ratio_classes[..columns]);
        let (here, north) = (
            &mut self.rows.current_row[..columns + MARGIN_NODES_BEFORE],
            &self.rows.north[..columns + MARGIN_NODES_BEFORE],
        );
        let magnitudes = &mut self.magnitudes[0][..columns + MARGIN_NODES_BEFORE];
        for j in 0..columns {
            let at = j + MARGIN_NODES_BEFORE;
            let (w, ww) = (here[at - 1], here[at - 2]);
            let (m, mm) = (magnitudes[at - 1], magnitudes[at - 2]);
            let expectation = expected[j] + near * m + far * mm;
            expected[j] = expectation;
            if !known[j] {
                let guess = w + (north[at] - north[at - 1]);
                here[at] = if guess.is_finite() { guess } else { w };
                magnitudes[at] = expectation / 10;
                errors[j] = 0.0;
                continue;
            }
            let guess = base[j] + (west * w + west2 * ww);
            let guess = if guess.is_finite() { guess } else { w };
            let nearest = levels.nearest_level(self.axis, guess);
            let residual =
                self.residuals.code_residual(coder, row[j].wrapping_sub(nearest), expectation, ratio_classes[j].into());
            row[j] = nearest.wrapping_add(residual);
            let value = levels.predictor_value(row[j]);
            let value = if value.is_finite() { value } else { guess };
            here[at] = value;
            errors[j] = value - guess;
            magnitudes[at] = residual.unsigned_abs().min(MAX_SUMMED_MAGNITUDE);
            if j == 0 && i == 0 {
                here[..MARGIN_NODES_BEFORE].fill(value);
            }
        }
        if known.contains(&false) {
            self.rows.fill_missing_nodes(known);
        }
    }
}

//! Coding rows of levels: the part that encoder and decoder share.

use super::coder::Coder;
use super::levels::Levels;
use super::model::{Model, Residuals};
use super::predict::{BEFORE, EACH, Line, NEIGHBOURS, Predictor, place};
use crate::alloc;
use crate::error::Result;

/// Magnitudes beyond this are as good as this; so that ten of them can be added.
const ENOUGH: u64 = 1 << 56;

/// What a node of a row is to the coder.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Node {
    /// Its coordinates are coded.
    Coded,
    /// It has those of a node that came before.
    Duplicate,
    /// It has none.
    Missing,
}

/// A row of nodes: what each is, and the levels of those that are coded.
#[derive(Debug)]
pub(super) struct Row {
    pub(super) nodes: Vec<Node>,
    pub(super) levels: [Vec<i64>; 3],
}

impl Row {
    /// # Errors
    /// [`Error::OutOfMemory`](crate::Error::OutOfMemory).
    pub(super) fn new(columns: usize) -> Result<Self> {
        let levels = || alloc::zeroed(columns);
        Ok(Row { nodes: alloc::filled(Node::Coded, columns)?, levels: [levels()?, levels()?, levels()?] })
    }
}

/// One coordinate of the rows of a block.
struct Channel {
    axis: usize,
    predictor: Predictor,
    residuals: Residuals,
    line: Line,
    /// Magnitudes of residuals in this row and the one above, with a margin, and what was expected of them.
    magnitudes: [Vec<u64>; 2],
    expected: Vec<u64>,
    /// The parts of predictions that are known before the row, and later how wrong predictions were.
    base: Vec<f64>,
    errors: Vec<f64>,
}

/// Codes the rows of a block in turn.
pub(super) struct Rows {
    channels: Vec<Channel>,
    known: Vec<bool>,
    gaps: [Vec<bool>; 3],
    gap_models: Vec<Model<2>>,
    surprises: Vec<u8>,
    columns: Vec<f64>,
    next: usize,
}

impl Rows {
    /// `order`: the coordinates in the order of coding, each with its predictor.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`](crate::Error::OutOfMemory).
    pub(super) fn new(columns: usize, order: [(usize, Predictor); 3]) -> Result<Self> {
        let mut channels = alloc::with_capacity(3)?;
        for (axis, predictor) in order {
            channels.push(Channel::new(axis, predictor, columns)?);
        }
        let gaps = || alloc::filled(false, columns + 2 * BEFORE);
        Ok(Rows {
            channels,
            known: alloc::filled(true, columns)?,
            gaps: [gaps()?, gaps()?, gaps()?],
            gap_models: alloc::filled(Model::new([1.0; 2]), 128)?,
            surprises: alloc::zeroed(columns)?,
            columns: alloc::collect((0..columns).map(|j| place(j, columns)))?,
            next: 0,
        })
    }

    /// The next row, the `vertical`-th place of -1 to 1. Nodes that are no duplicates are said to be coded or missing first, if
    /// any may be missing.
    pub(super) fn code<C: Coder, T, L: Levels<T>>(
        &mut self,
        coder: &mut C,
        row: &mut Row,
        levels: &L,
        may_miss: bool,
        vertical: f64,
    ) {
        if may_miss {
            self.code_gaps(coder, &mut row.nodes);
        }
        self.known.iter_mut().zip(&row.nodes).for_each(|(known, &node)| *known = node == Node::Coded);
        self.surprises.fill(0);
        for k in 0..3 {
            let (before, rest) = self.channels.split_at_mut(k);
            let channel = &mut rest[0];
            channel.prepare(self.next, before, &self.columns, vertical);
            surprise(before, &mut self.surprises);
            channel.code(coder, self.next, &mut row.levels[channel.axis], levels, &self.known, &self.surprises);
        }
        self.next += 1;
    }

    /// Which nodes are missing: the more likely the more of those around are.
    fn code_gaps<C: Coder>(&mut self, coder: &mut C, nodes: &mut [Node]) {
        self.gaps.rotate_right(1);
        let [here, north, north2] = &mut self.gaps;
        for (j, node) in nodes.iter_mut().enumerate() {
            let at = j + BEFORE;
            let bits = [here[at - 1], here[at - 2], north[at - 1], north[at], north[at + 1], north[at + 2], north2[at]];
            let context = bits.iter().fold(0, |context, &bit| 2 * context + usize::from(bit));
            here[at] = *node != Node::Duplicate
                && coder.symbol(&mut self.gap_models[context], usize::from(*node == Node::Missing)) == 1;
            if *node != Node::Duplicate {
                *node = if here[at] { Node::Missing } else { Node::Coded };
            }
        }
    }
}

/// How much larger residuals of the coordinates before were than expected, in four classes.
fn surprise(before: &[Channel], surprises: &mut [u8]) {
    let class = |found: u64, expected: u64| {
        // In tenths; half a unit is nothing.
        let (found, expected) = (10 * found + 5, expected + 5);
        u8::from(2 * found >= expected) + u8::from(4 * found >= 5 * expected) + u8::from(2 * found >= 5 * expected)
    };
    match before {
        [] => {}
        [a] => {
            let pairs = a.magnitudes[0][BEFORE..].iter().zip(&a.expected);
            surprises.iter_mut().zip(pairs).for_each(|(to, (&found, &expected))| *to = class(found, expected));
        }
        [a, b, ..] => {
            let found = a.magnitudes[0][BEFORE..].iter().zip(&b.magnitudes[0][BEFORE..]);
            let expected = a.expected.iter().zip(&b.expected);
            for (to, (found, expected)) in surprises.iter_mut().zip(found.zip(expected)) {
                *to = class(found.0 + found.1, expected.0 + expected.1);
            }
        }
    }
}

impl Channel {
    fn new(axis: usize, predictor: Predictor, columns: usize) -> Result<Self> {
        let magnitudes = || alloc::zeroed(columns + 2 * BEFORE);
        Ok(Channel {
            axis,
            predictor,
            residuals: Residuals::new()?,
            line: Line::new(columns)?,
            magnitudes: [magnitudes()?, magnitudes()?],
            expected: alloc::zeroed(columns)?,
            base: alloc::zeroed(columns)?,
            errors: alloc::zeroed(columns)?,
        })
    }

    /// All that can be computed for the whole row at once.
    fn prepare(&mut self, i: usize, before: &[Channel], columns: &[f64], vertical: f64) {
        self.line.advance(i);
        self.line.base(i, &self.predictor, &mut self.base);
        for (p, other) in before.iter().enumerate() {
            let [own, column, row] = std::array::from_fn(|m| self.predictor.weight(NEIGHBOURS + EACH * p + m));
            let constant = own + row * vertical;
            for ((base, &error), &u) in self.base.iter_mut().zip(&other.errors).zip(columns) {
                *base += (constant + column * u) * error;
            }
        }
        self.magnitudes.swap(0, 1);
        let [here, north] = &mut self.magnitudes;
        here[..BEFORE].fill(north[BEFORE]);
        let (n, nw, ne) = (&north[BEFORE..], &north[BEFORE - 1..], &north[BEFORE + 1..]);
        for (j, expected) in self.expected.iter_mut().enumerate() {
            *expected = 3 * n[j] + 2 * nw[j] + ne[j];
        }
    }

    /// The row, node after node.
    fn code<C: Coder, T, L: Levels<T>>(
        &mut self,
        coder: &mut C,
        i: usize,
        row: &mut [i64],
        levels: &L,
        known: &[bool],
        surprises: &[u8],
    ) {
        let [west, west2] = Line::west(i, &self.predictor);
        // Where there is no row above, the nodes on the left count for it.
        let [near, far] = if i == 0 { [8, 2] } else { [3, 1] };
        let columns = row.len();
        let (base, expected, errors) =
            (&self.base[..columns], &mut self.expected[..columns], &mut self.errors[..columns]);
        let (known, surprises) = (&known[..columns], &surprises[..columns]);
        let (here, north) = (&mut self.line.here[..columns + BEFORE], &self.line.north[..columns + BEFORE]);
        let magnitudes = &mut self.magnitudes[0][..columns + BEFORE];
        for j in 0..columns {
            let at = j + BEFORE;
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
            let nearest = levels.nearest(self.axis, guess);
            let residual = self.residuals.code(coder, row[j].wrapping_sub(nearest), expectation, surprises[j].into());
            row[j] = nearest.wrapping_add(residual);
            let value = levels.value(row[j]);
            let value = if value.is_finite() { value } else { guess };
            here[at] = value;
            errors[j] = value - guess;
            magnitudes[at] = residual.unsigned_abs().min(ENOUGH);
            if j == 0 && i == 0 {
                here[..BEFORE].fill(value);
            }
        }
        if known.contains(&false) {
            self.line.bridge_gaps(known);
        }
    }
}

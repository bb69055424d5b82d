//! Compressed blocks: ranges of rows that are coded independently of each other. O(nodes).

use super::bytes::{Reader, Writer};
use super::coder::{Decoder, Encoder};
use super::fit::{ORDERS, Sample};
use super::header::{Mode, StreamInfo};
use super::levels::{Bits, Levels};
use super::predict::{Predictor, place};
use super::rows::{NodeState, Row, RowCoder};
use crate::{Classes, Planes, Shape, Topology};
use gusset_base::alloc;
use gusset_base::error::Result;
use std::ops::Range;

/// Nodes in the sample for the predictors of a block.
const SAMPLE: usize = 2048;
/// Nodes in the sample for the order of coordinates.
const ORDER_SAMPLE: usize = 512;

/// Nodes that are not stored, because they repeat an earlier one.
#[derive(Debug)]
pub(super) struct Duplicates {
    shape: Shape,
    /// Each with the node that it repeats, in order.
    pairs: Vec<[u32; 2]>,
}

impl Duplicates {
    pub(super) fn none(shape: Shape) -> Self {
        Duplicates { shape, pairs: Vec::new() }
    }

    /// All nodes except the first of each class.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`](gusset_base::Error::OutOfMemory).
    pub(super) fn from_topology(topology: &Topology) -> Result<Self> {
        let mut duplicates = Duplicates::none(topology.shape());
        let pairs = &mut duplicates.pairs;
        Classes::new(topology)?.each_glued(|node, first| alloc::push(pairs, [node, first]))?;
        Ok(duplicates)
    }

    /// Calls `visit` with the column of each duplicate of row `i` and the node that it repeats.
    pub(super) fn for_each_in_row(&self, i: usize, mut visit: impl FnMut(usize, u32)) {
        let start = self.shape.node(i, 0);
        let end = start + self.shape.columns() as u32;
        let from = self.pairs.partition_point(|pair| pair[0] < start);
        let row = self.pairs[from..].iter().take_while(|pair| pair[0] < end);
        row.for_each(|&[node, first]| visit((node - start) as usize, first));
    }

    /// Returns true if duplicates equal the nodes that they repeat bit for bit.
    pub(super) fn are_exact<T: Bits>(&self, planes: &Planes<'_, T>) -> bool {
        let levels = |node: u32| {
            let (i, j) = self.shape.place(node);
            planes.row(i).map(|row| row[j].level())
        };
        self.pairs.iter().all(|&[node, first]| levels(node) == levels(first))
    }

    /// Gives the duplicates of some rows the coordinates of the nodes that they repeat.
    pub(super) fn restore<T: Bits>(&self, planes: &mut Planes<'_, T>, rows: Range<usize>) {
        let w = self.shape.columns();
        for matrix in planes.matrices_mut() {
            rows.clone().for_each(|i| self.for_each_in_row(i, |j, first| matrix[i * w + j] = matrix[first as usize]));
        }
    }
}

/// The data for coding the blocks of a net.
pub(super) struct Blocks<'a, T, L> {
    pub(super) info: &'a StreamInfo,
    pub(super) planes: &'a Planes<'a, T>,
    pub(super) duplicates: &'a Duplicates,
    pub(super) levels: L,
}

impl<T: Bits, L: Levels<T>> Blocks<'_, T, L> {
    /// Loads row `i`: the states of its nodes, and their levels.
    fn load_row(&self, i: usize, row: &mut Row) {
        let numbers = self.planes.row(i);
        for (axis, (to, from)) in row.levels.iter_mut().zip(numbers).enumerate() {
            to.iter_mut().zip(from).for_each(|(level, &number)| *level = self.levels.level(axis, number));
        }
        row.nodes.fill(NodeState::Coded);
        if has_non_finite(numbers) {
            for (j, node) in row.nodes.iter_mut().enumerate() {
                if self.levels.is_missing(numbers.map(|row| row[j])) {
                    *node = NodeState::Missing;
                }
            }
        }
        self.duplicates.for_each_in_row(i, |j, _| row.nodes[j] = NodeState::Duplicate);
    }

    fn sample(&self, rows: Range<usize>, count: usize) -> Result<Sample> {
        let shape = self.info.shape;
        Sample::new(rows, shape.rows(), shape.columns(), count, &self.levels, |i, row| self.load_row(i, row))
    }

    /// Returns the best order of coordinates for the whole net.
    pub(super) fn best_order(&self) -> Result<usize> {
        self.sample(0..self.info.shape.rows(), ORDER_SAMPLE)?.best_order(fraction(self.info))
    }

    /// Returns the bytes of a block.
    pub(super) fn encode(&self, block: usize) -> Result<Vec<u8>> {
        let (info, rows) = (self.info, self.info.block_rows(block));
        let order = ORDERS[info.order as usize];
        let (predictors, _) = self.sample(rows.clone(), SAMPLE)?.predictors(order, fraction(info), 3)?;
        let may_miss = rows.clone().any(|i| has_non_finite(self.planes.row(i)));
        let mut coder = Encoder::new();
        let mut state = RowCoder::new(info.shape.columns(), std::array::from_fn(|k| (order[k], predictors[k])))?;
        let mut row = Row::new(info.shape.columns())?;
        for i in rows {
            self.load_row(i, &mut row);
            state.code(&mut coder, &mut row, &self.levels, may_miss, place(i, info.shape.rows()));
        }
        let (words, bits) = coder.finish()?;
        let mut to = Writer::default();
        to.u8(may_miss.into())?;
        predictors.iter().enumerate().try_for_each(|(before, predictor)| predictor.write(before, &mut to))?;
        to.varint(words.len() as u64)?;
        words.iter().try_for_each(|&word| to.u32(word))?;
        to.varint(bits.len() as u64)?;
        to.raw(&bits)?;
        Ok(to.bytes)
    }
}

/// Decodes a block into its rows of the three matrices, except duplicates.
///
/// # Errors
/// [`Error::BadStream`](gusset_base::Error::BadStream),
/// [`Error::OutOfMemory`](gusset_base::Error::OutOfMemory).
pub(super) fn decode<T: Bits>(
    info: &StreamInfo,
    duplicates: &Duplicates,
    levels: &impl Levels<T>,
    block: usize,
    mut from: Reader<'_>,
    mut to: [&mut [T]; 3],
) -> Result<()> {
    let (columns, order) = (info.shape.columns(), ORDERS[info.order as usize]);
    let start = from.bad("the coded data do not describe a net");
    let may_miss = from.flag()?.ok_or(start)?;
    let mut predictors = [(0, Predictor::new(&Predictor::PARALLELOGRAM, 1)); 3];
    for (before, predictor) in predictors.iter_mut().enumerate() {
        *predictor = (order[before], Predictor::read(before, fraction(info), &mut from)?);
    }
    let words = from.varint()?.min(u64::MAX / 4) * 4;
    let words = from.raw(usize::try_from(words).unwrap_or(usize::MAX))?;
    let bits = from.varint()?;
    let bits = from.raw(usize::try_from(bits).unwrap_or(usize::MAX))?;
    // Padding that the encoder adds to streams that are short for their content.
    let rest = from.raw(from.remaining())?;
    if rest.iter().any(|&byte| byte != 0) || (block + 1 < info.block_count() && !rest.is_empty()) {
        return Err(from.bad("there are bytes after the end"));
    }
    let mut coder = Decoder::new(words, bits)?;
    let mut state = RowCoder::new(columns, predictors)?;
    let mut row = Row::new(columns)?;
    for (k, i) in info.block_rows(block).enumerate() {
        row.nodes.fill(NodeState::Coded);
        duplicates.for_each_in_row(i, |j, _| row.nodes[j] = NodeState::Duplicate);
        state.code(&mut coder, &mut row, levels, may_miss, place(i, info.shape.rows()));
        let mut to = to.each_mut().map(|matrix| &mut matrix[k * columns..(k + 1) * columns]);
        if !store(&row, levels, &mut to) {
            return Err(start);
        }
    }
    if coder.is_sound() { Ok(()) } else { Err(start) }
}

/// Stores the numbers of a row. Returns false if a level is out of range.
fn store<T: Bits>(row: &Row, levels: &impl Levels<T>, to: &mut [&mut [T]; 3]) -> bool {
    let mut sound = true;
    for (axis, (to, from)) in to.iter_mut().zip(&row.levels).enumerate() {
        let missing = levels.missing()[axis];
        for ((to, &level), &node) in to.iter_mut().zip(from).zip(&row.nodes) {
            *to = match node {
                NodeState::Coded => levels.number(axis, level).unwrap_or_else(|| {
                    sound = false;
                    missing
                }),
                _ => missing,
            };
        }
    }
    sound
}

/// Bits after the binary point of predictors' weights: fewer for quantised levels, which are small.
fn fraction(info: &StreamInfo) -> u32 {
    match info.mode {
        Mode::Quantised { .. } => 11,
        _ => 24,
    }
}

/// Returns true if a coordinate of a row is not finite.
fn has_non_finite<T: Bits>(row: [&[T]; 3]) -> bool {
    // Counts instead of searching, so that the loop vectorises.
    row.into_iter()
        .any(|numbers| numbers.iter().map(|&x| u32::from(!Into::<f64>::into(x).is_finite())).sum::<u32>() > 0)
}

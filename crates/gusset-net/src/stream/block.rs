//! Compressed blocks: ranges of rows that are coded independently of each other. O(nodes).

use super::bytes::{ByteReader, ByteWriter};
use super::coder::{RangeDecoder, RangeEncoder};
use super::header::{StreamInfo, StreamMode};
use super::levels::{CoordinateBits, LevelMap};
use super::predictor::{Predictor, normalise_index};
use super::predictor_fit::{COORDINATE_ORDERS, NodeSample};
use super::row_coder::{NodeRow, NodeState, RowCoder};
use crate::{NodeClasses, Shape, Topology, XyzMatrices};
use gusset_base::alloc;
use gusset_base::error::Result;
use std::ops::Range;

/// Nodes in the sample for the predictors of a block.
const PREDICTOR_SAMPLE_NODES: usize = 2048;
/// Nodes in the sample for the order of coordinates.
const ORDER_SAMPLE_NODES: usize = 512;

/// Nodes that are not stored, because they repeat an earlier one.
#[derive(Debug)]
pub(super) struct DuplicateNodes {
    shape: Shape,
    /// Each with the node that it repeats, in order.
    pairs: Vec<[u32; 2]>,
}

impl DuplicateNodes {
    pub(super) fn without_duplicates(shape: Shape) -> Self {
        DuplicateNodes { shape, pairs: Vec::new() }
    }

    /// All nodes except the first of each class.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`](gusset_base::Error::OutOfMemory).
    pub(super) fn from_topology(topology: &Topology) -> Result<Self> {
        let mut duplicates = DuplicateNodes::without_duplicates(topology.shape());
        let pairs = &mut duplicates.pairs;
        NodeClasses::new(topology)?.for_each_glued_node(|node, first| alloc::push(pairs, [node, first]))?;
        Ok(duplicates)
    }

    /// Calls `visit` with the column of each duplicate of row `i` and the node that it repeats.
    pub(super) fn for_each_duplicate_in_row(&self, i: usize, mut visit: impl FnMut(usize, u32)) {
        let start = self.shape.node(i, 0);
        let end = start + self.shape.columns() as u32;
        let from = self.pairs.partition_point(|pair| pair[0] < start);
        let row = self.pairs[from..].iter().take_while(|pair| pair[0] < end);
        row.for_each(|&[node, first]| visit((node - start) as usize, first));
    }

    /// Returns true if duplicates equal the nodes that they repeat bit for bit.
    pub(super) fn are_bit_identical<T: CoordinateBits>(&self, planes: &XyzMatrices<'_, T>) -> bool {
        let levels = |node: u32| {
            let (i, j) = self.shape.row_and_column(node);
            planes.row(i).map(|row| row[j].to_ordered_bits())
        };
        self.pairs.iter().all(|&[node, first]| levels(node) == levels(first))
    }

    /// Gives the duplicates of some rows the coordinates of the nodes that they repeat.
    pub(super) fn restore_rows<T: CoordinateBits>(&self, planes: &mut XyzMatrices<'_, T>, rows: Range<usize>) {
        let w = self.shape.columns();
        for matrix in planes.matrices_mut() {
            rows.clone()
                .for_each(|i| self.for_each_duplicate_in_row(i, |j, first| matrix[i * w + j] = matrix[first as usize]));
        }
    }
}

/// The data for coding the blocks of a net.
pub(super) struct BlockCoding<'a, T, L> {
    pub(super) info: &'a StreamInfo,
    pub(super) planes: &'a XyzMatrices<'a, T>,
    pub(super) duplicates: &'a DuplicateNodes,
    pub(super) levels: L,
}

impl<T: CoordinateBits, L: LevelMap<T>> BlockCoding<'_, T, L> {
    /// Loads row `i`: the states of its nodes, and their levels.
    fn read_states_and_levels(&self, i: usize, row: &mut NodeRow) {
        let numbers = self.planes.row(i);
        for (axis, (to, from)) in row.levels.iter_mut().zip(numbers).enumerate() {
            to.iter_mut().zip(from).for_each(|(level, &number)| *level = self.levels.level_of_number(axis, number));
        }
        row.nodes.fill(NodeState::Coded);
        if has_non_finite(numbers) {
            for (j, node) in row.nodes.iter_mut().enumerate() {
                if self.levels.is_missing(numbers.map(|row| row[j])) {
                    *node = NodeState::Missing;
                }
            }
        }
        self.duplicates.for_each_duplicate_in_row(i, |j, _| row.nodes[j] = NodeState::Duplicate);
    }

    fn sample_nodes_of_rows(&self, rows: Range<usize>, count: usize) -> Result<NodeSample> {
        let shape = self.info.shape;
        NodeSample::new(rows, shape.rows(), shape.columns(), count, &self.levels, |i, row| {
            self.read_states_and_levels(i, row);
        })
    }

    /// Returns the best order of coordinates for the whole net.
    pub(super) fn best_coordinate_order_of_net(&self) -> Result<usize> {
        self.sample_nodes_of_rows(0..self.info.shape.rows(), ORDER_SAMPLE_NODES)?
            .best_coordinate_order(fraction_bits_of_weights(self.info))
    }

    /// Returns the bytes of a block.
    pub(super) fn encode_block(&self, block: usize) -> Result<Vec<u8>> {
        let (info, rows) = (self.info, self.info.block_rows(block));
        let order = COORDINATE_ORDERS[info.coordinate_order as usize];
        let (predictors, _) = self.sample_nodes_of_rows(rows.clone(), PREDICTOR_SAMPLE_NODES)?.fit_predictors(
            order,
            fraction_bits_of_weights(info),
            3,
        )?;
        let may_miss = rows.clone().any(|i| has_non_finite(self.planes.row(i)));
        let mut coder = RangeEncoder::new();
        let mut state = RowCoder::new(info.shape.columns(), std::array::from_fn(|k| (order[k], predictors[k])))?;
        let mut row = NodeRow::new(info.shape.columns())?;
        for i in rows {
            self.read_states_and_levels(i, &mut row);
            state.code_row(&mut coder, &mut row, &self.levels, may_miss, normalise_index(i, info.shape.rows()));
        }
        let (words, bits) = coder.finish()?;
        let mut to = ByteWriter::default();
        to.write_u8(may_miss.into())?;
        predictors.iter().enumerate().try_for_each(|(before, predictor)| predictor.write(before, &mut to))?;
        to.write_varint(words.len() as u64)?;
        words.iter().try_for_each(|&word| to.write_u32(word))?;
        to.write_varint(bits.len() as u64)?;
        to.write_bytes(&bits)?;
        Ok(to.bytes)
    }
}

/// Decodes a block into its rows of the three matrices, except duplicates.
///
/// # Errors
/// [`Error::BadStream`](gusset_base::Error::BadStream),
/// [`Error::OutOfMemory`](gusset_base::Error::OutOfMemory).
pub(super) fn decode_block<T: CoordinateBits>(
    info: &StreamInfo,
    duplicates: &DuplicateNodes,
    levels: &impl LevelMap<T>,
    block: usize,
    mut from: ByteReader<'_>,
    mut to: [&mut [T]; 3],
) -> Result<()> {
    let (columns, order) = (info.shape.columns(), COORDINATE_ORDERS[info.coordinate_order as usize]);
    let start = from.error_here("the coded data do not describe a net");
    let may_miss = from.read_flag()?.ok_or(start)?;
    let mut predictors = [(0, Predictor::new(&Predictor::PARALLELOGRAM_WEIGHTS, 1)); 3];
    for (before, predictor) in predictors.iter_mut().enumerate() {
        *predictor = (order[before], Predictor::read(before, fraction_bits_of_weights(info), &mut from)?);
    }
    let words = from.read_varint()?.min(u64::MAX / 4) * 4;
    let words = from.read_bytes(usize::try_from(words).unwrap_or(usize::MAX))?;
    let bits = from.read_varint()?;
    let bits = from.read_bytes(usize::try_from(bits).unwrap_or(usize::MAX))?;
    // Padding that the encoder adds to streams that are short for their content.
    let rest = from.read_bytes(from.remaining_bytes())?;
    if rest.iter().any(|&byte| byte != 0) || (block + 1 < info.block_count() && !rest.is_empty()) {
        return Err(from.error_here("there are bytes after the end"));
    }
    let mut coder = RangeDecoder::new(words, bits)?;
    let mut state = RowCoder::new(columns, predictors)?;
    let mut row = NodeRow::new(columns)?;
    for (k, i) in info.block_rows(block).enumerate() {
        row.nodes.fill(NodeState::Coded);
        duplicates.for_each_duplicate_in_row(i, |j, _| row.nodes[j] = NodeState::Duplicate);
        state.code_row(&mut coder, &mut row, levels, may_miss, normalise_index(i, info.shape.rows()));
        let mut to = to.each_mut().map(|matrix| &mut matrix[k * columns..(k + 1) * columns]);
        if !write_coordinates_of_row(&row, levels, &mut to) {
            return Err(start);
        }
    }
    if coder.has_read_all_input() { Ok(()) } else { Err(start) }
}

/// Stores the numbers of a row. Returns false if a level is out of range.
fn write_coordinates_of_row<T: CoordinateBits>(
    row: &NodeRow,
    levels: &impl LevelMap<T>,
    to: &mut [&mut [T]; 3],
) -> bool {
    let mut sound = true;
    for (axis, (to, from)) in to.iter_mut().zip(&row.levels).enumerate() {
        let missing = levels.missing_node()[axis];
        for ((to, &level), &node) in to.iter_mut().zip(from).zip(&row.nodes) {
            *to = match node {
                NodeState::Coded => levels.number_of_level(axis, level).unwrap_or_else(|| {
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
fn fraction_bits_of_weights(info: &StreamInfo) -> u32 {
    match info.mode {
        StreamMode::Quantised { .. } => 11,
        _ => 24,
    }
}

/// Returns true if a coordinate of a row is not finite.
fn has_non_finite<T: CoordinateBits>(row: [&[T]; 3]) -> bool {
    // Counts instead of searching, so that the loop vectorises.
    row.into_iter()
        .any(|numbers| numbers.iter().map(|&x| u32::from(!Into::<f64>::into(x).is_finite())).sum::<u32>() > 0)
}

//! Masks of cells, the paper's logical scale: one bit for each cell, 1 as long as the cell may
//! contain the object.

use super::cell_grid_shape::{CellGridShape, CyclicSpan};
use gusset_base::alloc;
use gusset_base::error::{Error, Result};

/// A set of cells: a *cell region* of the paper. The bit of cell k = row * columns + column is bit
/// k % 64 of word k / 64.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct CellMask {
    lattice: CellGridShape,
    words: Vec<u64>,
}

impl CellMask {
    /// Creates a mask with all bits 1, with which every search begins.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`].
    pub fn full(lattice: CellGridShape) -> Result<Self> {
        let mut words = alloc::filled(u64::MAX, lattice.len().div_ceil(64))?;
        if let (Some(last), used @ 1..) = (words.last_mut(), lattice.len() % 64) {
            *last = (1 << used) - 1;
        }
        Ok(CellMask { lattice, words })
    }

    /// Creates a mask from words. Ignores bits beyond the last cell.
    ///
    /// # Errors
    /// [`Error::ArrayTooShort`], [`Error::OutOfMemory`].
    pub fn from_words(lattice: CellGridShape, words: &[u64]) -> Result<Self> {
        let mut mask = CellMask::full(lattice)?;
        if words.len() < mask.words.len() {
            let (needed, given) = (8 * mask.words.len() as u64, 8 * words.len() as u64);
            return Err(Error::ArrayTooShort { what: "words", needed, given });
        }
        mask.words.iter_mut().zip(words).for_each(|(own, given)| *own &= given);
        Ok(mask)
    }

    /// The lattice of the cells.
    pub fn lattice(&self) -> CellGridShape {
        self.lattice
    }

    /// The words.
    pub fn words(&self) -> &[u64] {
        &self.words
    }

    /// The bit of a cell.
    pub fn get(&self, cell: [usize; 2]) -> bool {
        let k = self.lattice.index(cell);
        self.words[k / 64] >> (k % 64) & 1 == 1
    }

    /// Sets the bit of a cell.
    pub fn set(&mut self, cell: [usize; 2], on: bool) {
        let k = self.lattice.index(cell);
        let bit = 1 << (k % 64);
        if on {
            self.words[k / 64] |= bit;
        } else {
            self.words[k / 64] &= !bit;
        }
    }

    /// The number of bits that are 1.
    pub fn count(&self) -> usize {
        self.words.iter().map(|word| word.count_ones() as usize).sum()
    }

    /// The cells whose bits are 1, row by row.
    pub fn cells(&self) -> impl Iterator<Item = [usize; 2]> {
        let mut words = self.words.iter().enumerate();
        let (mut first, mut left) = (0, 0u64);
        std::iter::from_fn(move || {
            while left == 0 {
                let (w, &word) = words.next()?;
                (first, left) = (64 * w, word);
            }
            let cell = self.lattice.cell(first + left.trailing_zeros() as usize);
            left &= left - 1;
            Some(cell)
        })
    }

    /// The corners of these cells, each once, row by row. In closed directions, the last line is
    /// the first one.
    pub fn nodes(&self) -> impl Iterator<Item = [usize; 2]> {
        let lattice = self.lattice;
        let [rows, columns] = lattice.lines();
        let nodes = (0..rows).flat_map(move |i| (0..columns).map(move |j| [i, j]));
        nodes.filter(move |&node| lattice.cells_at_node(node).any(|cell| self.get(cell)))
    }

    /// Clears the bits of a block.
    pub(crate) fn clear_block(&mut self, [rows, columns]: [CyclicSpan; 2]) {
        let width = self.lattice.cells[1];
        for i in rows.indices() {
            for part in columns.ranges_around_seam() {
                self.clear_bits(i * width + part.start, i * width + part.end);
            }
        }
    }

    /// Clears the bits from..to.
    fn clear_bits(&mut self, from: usize, to: usize) {
        words_and_bit_masks(from, to).for_each(|(word, ones)| self.words[word] &= !ones);
    }

    /// True if the bits from..to are all 0.
    pub(crate) fn are_bits_clear(&self, from: usize, to: usize) -> bool {
        words_and_bit_masks(from, to).all(|(word, ones)| self.words[word] & ones == 0)
    }
}

/// The words that contain the bits from..to, each with a mask of these bits.
fn words_and_bit_masks(from: usize, to: usize) -> impl Iterator<Item = (usize, u64)> {
    (from / 64..to.div_ceil(64)).map(move |word| {
        let low = if word == from / 64 { u64::MAX << (from % 64) } else { u64::MAX };
        let high = if 64 * (word + 1) > to { u64::MAX >> (64 * (word + 1) - to) } else { u64::MAX };
        (word, low & high)
    })
}

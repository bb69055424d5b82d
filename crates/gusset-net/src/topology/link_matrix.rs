//! The characteristic matrix C (Deryagin, "Non-spatial operations"): one bit for each link, 1 for a
//! contracted one. It takes 2 bits a node. Many links are tested or set in whole words at a time.

use super::Sides;
use crate::Shape;
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use std::ops::Range;

const BITS_PER_WORD: usize = u64::BITS as usize;

/// The paper's matrix C of 2H x W bits. Its element (2i, j) is the horizontal link of node (i, j),
/// its element (2i + 1, j) the vertical one (rows and columns from 0). The two bits of a node are
/// adjacent.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct LinkMatrix {
    words: Vec<u64>,
}

impl LinkMatrix {
    /// Creates a matrix without contracted links.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`].
    pub fn empty(shape: Shape) -> Result<Self> {
        Ok(LinkMatrix { words: alloc::zeroed(shape.link_count().div_ceil(BITS_PER_WORD))? })
    }

    /// Creates a matrix of the links that [`Sides`] contract.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`].
    pub fn from_sides(shape: Shape, sides: Sides) -> Result<Self> {
        LinkMatrix::from_links(shape, sides.contracted_links(shape))
    }

    /// Creates a matrix of the given contracted links.
    pub(crate) fn from_links(shape: Shape, links: impl Iterator<Item = u32>) -> Result<Self> {
        let mut matrix = LinkMatrix::empty(shape)?;
        links.for_each(|link| matrix.set_contracted(link, true));
        Ok(matrix)
    }

    /// Reads the paper's layout: 2H rows of W bytes, 0 or 1, row after row.
    ///
    /// # Errors
    /// [`Error::ArrayTooShort`], [`Error::OptionOutOfRange`] for a byte other than 0 and 1,
    /// [`Error::OutOfMemory`].
    pub fn from_bytes(shape: Shape, bytes: &[u8]) -> Result<Self> {
        let (w, needed) = (shape.columns(), shape.link_count());
        let Some(bytes) = bytes.get(..needed) else {
            let (needed, given) = (needed as u64, bytes.len() as u64);
            return Err(Error::ArrayTooShort { what: "the characteristic matrix", needed, given });
        };
        let mut matrix = LinkMatrix::empty(shape)?;
        for (at, &byte) in bytes.iter().enumerate() {
            let (row, j) = (at / w, at % w);
            Error::require(byte <= 1, "matrix", byte.into(), "0 or 1")?;
            if byte == 1 {
                matrix.set_contracted(2 * shape.node(row / 2, j) + (row % 2) as u32, true);
            }
        }
        Ok(matrix)
    }

    /// Returns true if the link is contracted.
    pub fn is_contracted(&self, link: u32) -> bool {
        self.words[link as usize / BITS_PER_WORD] >> (link as usize % BITS_PER_WORD) & 1 != 0
    }

    /// Contracts a link, or frees it.
    pub fn set_contracted(&mut self, link: u32, contracted: bool) {
        let (word, bit) = (&mut self.words[link as usize / BITS_PER_WORD], 1 << (link as usize % BITS_PER_WORD));
        if contracted { *word |= bit } else { *word &= !bit }
    }

    /// Returns the contracted links, in order.
    pub fn links(&self) -> impl Iterator<Item = u32> {
        indices_of_set_bits(&self.words, 0)
    }

    /// Contracts the links from row i to the next.
    pub(crate) fn contract_links_below_row(&mut self, shape: Shape, i: usize) {
        const VERTICAL_LINK_BITS: u64 = 0xAAAA_AAAA_AAAA_AAAA;
        let [start, end] = [i, i + 1].map(|i| 2 * i * shape.columns());
        for at in start / BITS_PER_WORD..end.div_ceil(BITS_PER_WORD) {
            let from = u64::MAX << start.saturating_sub(at * BITS_PER_WORD).min(BITS_PER_WORD - 1);
            let to = u64::MAX >> ((at + 1) * BITS_PER_WORD).saturating_sub(end).min(BITS_PER_WORD - 1);
            self.words[at] |= VERTICAL_LINK_BITS & from & to;
        }
    }

    /// Returns the contracted links in a range, in order.
    pub(crate) fn contracted_links_in(&self, range: Range<u32>) -> impl Iterator<Item = u32> {
        let words = range.start as usize / BITS_PER_WORD..(range.end as usize).div_ceil(BITS_PER_WORD);
        let first = words.start;
        indices_of_set_bits(&self.words[words], first)
            .skip_while(move |&link| link < range.start)
            .take_while(move |&l| l < range.end)
    }

    /// Returns the two bits of a node: 1 for its horizontal link, 2 for its vertical one.
    pub(super) fn contracted_bits_of_node(&self, node: usize) -> usize {
        (self.words[2 * node / BITS_PER_WORD] >> (2 * node % BITS_PER_WORD)) as usize & 3
    }

    /// Returns the 64 bits from `from` on; zeros after the end.
    pub(super) fn next_64_bits_from(&self, from: usize) -> u64 {
        let (word, shift) = (from / BITS_PER_WORD, from % BITS_PER_WORD);
        let next = self.words.get(word + 1).map_or(0, |&next| next << 1 << (BITS_PER_WORD - 1 - shift));
        self.words[word] >> shift | next
    }

    /// Contracts every link whose ends have the same entry in a table of nodes. O(nodes).
    ///
    /// # Errors
    /// [`Error::OutOfMemory`].
    pub(super) fn from_representatives(shape: Shape, table: &[u32]) -> Result<Self> {
        let mut matrix = LinkMatrix::empty(shape)?;
        let (h, w) = (shape.rows(), shape.columns());
        for i in 0..h {
            let row = &table[i * w..(i + 1) * w];
            let below = &table[(i + 1) % h * w..][..w];
            for j in (0..w).step_by(BITS_PER_WORD / 2) {
                let count = (w - j).min(BITS_PER_WORD / 2);
                let pairs = row[j..j + count].iter().zip(&below[j..j + count]);
                let bits = pairs.enumerate().fold(0, |bits, (k, (here, below))| {
                    let east = if j + k + 1 < w { row[j + k + 1] } else { row[0] };
                    bits | u64::from(*here == east) << (2 * k) | u64::from(here == below) << (2 * k + 1)
                });
                matrix.or_64_bits_from(2 * (i * w + j), bits);
            }
        }
        Ok(matrix)
    }

    /// Or-combines 64 bits into the matrix from `from` on.
    fn or_64_bits_from(&mut self, from: usize, bits: u64) {
        let (word, shift) = (from / BITS_PER_WORD, from % BITS_PER_WORD);
        self.words[word] |= bits << shift;
        if let Some(next) = self.words.get_mut(word + 1) {
            *next |= bits >> 1 >> (BITS_PER_WORD - 1 - shift);
        }
    }

    /// Returns a copy.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`].
    pub(super) fn copied(&self) -> Result<Self> {
        Ok(LinkMatrix { words: alloc::copied(&self.words)? })
    }

    /// Returns the sides that contract the same links, if they exist.
    pub(super) fn to_equal_sides(&self, shape: Shape) -> Option<Sides> {
        let (h, w) = (shape.rows(), shape.columns());
        let sides = Sides {
            rows_closed: self.is_contracted(shape.horizontal_link(0, w - 1)),
            columns_closed: self.is_contracted(shape.vertical_link(h - 1, 0)),
            pole_top: self.is_contracted(shape.horizontal_link(0, 0)),
            pole_bottom: self.is_contracted(shape.horizontal_link(h - 1, 0)),
            pole_left: self.is_contracted(shape.vertical_link(0, 0)),
            pole_right: self.is_contracted(shape.vertical_link(0, w - 1)),
        };
        // All of the sides' links are set, and no others, so a second matrix is unnecessary.
        let ones: usize = self.words.iter().map(|word| word.count_ones() as usize).sum();
        let mut expected = 0;
        let all = sides.contracted_links(shape).all(|link| {
            expected += 1;
            self.is_contracted(link)
        });
        (all && expected == ones).then_some(sides)
    }

    /// Returns the bytes of [`LinkMatrix::from_bytes`].
    ///
    /// # Errors
    /// [`Error::OutOfMemory`].
    pub fn to_bytes(&self, shape: Shape) -> Result<Vec<u8>> {
        let (h, w) = (shape.rows(), shape.columns());
        let element =
            |row: usize, j: usize| u8::from(self.is_contracted(2 * shape.node(row / 2, j) + (row % 2) as u32));
        alloc::collect((0..2 * h * w).map(|at| element(at / w, at % w)))
    }
}

/// Returns the set bits of words, the first of which is word number `first`.
fn indices_of_set_bits(words: &[u64], first: usize) -> impl Iterator<Item = u32> {
    words.iter().zip(first..).flat_map(|(&word, at)| {
        std::iter::successors((word != 0).then_some(word), |&w| Some(w & (w - 1)).filter(|&rest| rest != 0))
            .map(move |w| (at * BITS_PER_WORD) as u32 + w.trailing_zeros())
    })
}

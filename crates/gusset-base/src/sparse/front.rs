//! Dense fronts: eliminate the first columns of a symmetric matrix and update the rest.
//!
//! The lower triangle is stored in blocks of [`LANES`] rows, column after column within a block.
//! Products of two blocks then read memory in order and fill vector registers. Columns are
//! eliminated in panels of [`PANEL`], first within the panel, then in all remaining columns at
//! once, where most operations are. Every entry receives its products in the order of the columns,
//! for any vector width.

use crate::alloc;
use crate::error::Result;
use crate::simd::{self, Kernel};

/// Rows of a block.
pub(super) const LANES: usize = 8;
/// The entries of a block's rows in one column.
pub(super) type Lanes = [f64; LANES];
/// Columns eliminated at a time; a multiple of [`LANES`].
const PANEL: usize = 32;
/// Columns whose sums are in registers together.
const SUMS: usize = 4;
/// A pivot up to this fraction of its diagonal entry counts as rounding.
const MIN_RELATIVE_PIVOT: f64 = 4.0 * f64::EPSILON;
const ZEROS: Lanes = [0.0; LANES];

/// The lower triangle of a symmetric matrix, and workspace for the elimination of columns.
#[derive(Default)]
pub(super) struct Front {
    size: usize,
    /// Block `b` has rows `8 b` to `8 b + 7` and columns up to `8 b + 7`. Entries above the
    /// diagonal and below the last row are unused.
    entries: Vec<Lanes>,
    /// The columns of a panel before division by their pivots, block by block.
    undivided: Vec<Lanes>,
    own: Vec<f64>,
}

/// Returns the start of block `b`.
fn start(b: usize) -> usize {
    LANES * b * (b + 1) / 2
}

impl Front {
    /// Resets to `size` rows of zeros. Calls `spend` with the number of entries set.
    pub(super) fn reset(&mut self, size: usize, mut spend: impl FnMut(usize) -> Result<()>) -> Result<()> {
        self.size = size;
        let blocks = size.div_ceil(LANES);
        self.own.resize(PANEL * PANEL, 0.0);
        alloc::grow(&mut self.undivided, PANEL * blocks, ZEROS)?;
        self.entries.clear();
        alloc::reserve(&mut self.entries, start(blocks))?;
        for b in 0..blocks {
            self.entries.resize(start(b + 1), ZEROS);
            spend(LANES * LANES * (b + 1))?;
        }
        Ok(())
    }

    /// Returns an entry on the diagonal or below it.
    #[inline]
    pub(super) fn entry(&mut self, row: usize, column: usize) -> &mut f64 {
        &mut self.entries[start(row / LANES) + column][row % LANES]
    }

    /// Adds a lower triangle, given row by row. `places` has the positions of its rows, ascending.
    /// Calls `spend` with the number of entries added.
    pub(super) fn add(
        &mut self,
        places: &[u32],
        triangle: &[f64],
        mut spend: impl FnMut(usize) -> Result<()>,
    ) -> Result<()> {
        let mut rest = triangle;
        for (i, &row) in places.iter().enumerate() {
            let (values, after) = rest.split_at(i + 1);
            rest = after;
            let (b, lane) = (row as usize / LANES, row as usize % LANES);
            let block = &mut self.entries[start(b)..start(b + 1)];
            for (&column, &value) in places.iter().zip(values) {
                block[column as usize][lane] += value;
            }
            spend(i + 1)?;
        }
        Ok(())
    }

    /// Appends the lower triangle of the rows from `first` on, row by row, to `triangle`. Calls
    /// `spend` with the number of entries appended.
    pub(super) fn append_rest(
        &self,
        first: usize,
        triangle: &mut Vec<f64>,
        mut spend: impl FnMut(usize) -> Result<()>,
    ) -> Result<()> {
        let rows = self.size - first;
        alloc::reserve(triangle, rows * (rows + 1) / 2)?;
        for row in first..self.size {
            let (b, lane) = (row / LANES, row % LANES);
            triangle.extend(self.block(b)[first..=row].iter().map(|lanes| lanes[lane]));
            spend(row + 1 - first)?;
        }
        Ok(())
    }

    /// Returns the number of blocks of rows.
    fn blocks(&self) -> usize {
        self.size.div_ceil(LANES)
    }

    /// Returns the columns of a block of rows.
    pub(super) fn block(&self, b: usize) -> &[Lanes] {
        &self.entries[start(b)..start(b + 1)]
    }

    /// Eliminates as many columns as `inverse` has entries. The columns become columns of L, and
    /// `inverse` receives the inverses of their pivots. A pivot that is not positive relative to
    /// the original entry on the `diagonal` counts as infinite, which removes its row and column.
    /// Calls `spend` with the number of multiplications.
    pub(super) fn eliminate(
        &mut self,
        diagonal: &[f64],
        inverse: &mut [f64],
        mut spend: impl FnMut(usize) -> Result<()>,
    ) -> Result<()> {
        let count = inverse.len();
        for first in (0..count).step_by(PANEL) {
            let panel = first..count.min(first + PANEL);
            let width = panel.len();
            for b in first / LANES..self.blocks() {
                simd::run(Divide {
                    row: b * LANES,
                    first,
                    block: &mut self.entries[start(b)..start(b + 1)],
                    own: &mut self.own,
                    undivided: &mut self.undivided[PANEL * b..][..width],
                    diagonal: &diagonal[panel.clone()],
                    inverse: &mut inverse[panel.clone()],
                });
                spend(width * width * LANES / 2)?;
            }
            // The panel ends in this block, whose panel columns must stay.
            let next = panel.end / LANES;
            if panel.end % LANES > 0 {
                let own = &mut self.undivided[PANEL * next..][..width];
                own.iter_mut().for_each(|lanes| lanes[..panel.end % LANES].fill(0.0));
            }
            for b in next..self.blocks() {
                simd::run(Subtract {
                    block: &mut self.entries[start(b)..start(b + 1)],
                    first,
                    width,
                    next,
                    undivided: &self.undivided,
                });
                spend(LANES * LANES * (b + 1 - next) * width)?;
            }
        }
        Ok(())
    }
}

/// Eliminates the columns of a panel in one block of rows.
struct Divide<'a> {
    row: usize,
    /// The panel's first column.
    first: usize,
    block: &'a mut [Lanes],
    own: &'a mut [f64],
    undivided: &'a mut [Lanes],
    diagonal: &'a [f64],
    inverse: &'a mut [f64],
}

impl Kernel for Divide<'_> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let Divide { row, first, block, own, undivided, diagonal, inverse } = self;
        let width = undivided.len();
        // The number of panel columns that the block has, and the first of its rows among them.
        let columns = width.min(row + LANES - first);
        let block = &mut block[first..first + columns];
        let row = row - first;
        for group in (0..columns).step_by(SUMS) {
            let (known, rest) = block.split_at_mut(group);
            let rest = &mut rest[..SUMS.min(columns - group)];
            // A fixed-size copy, padded with unused columns, lets the loops over it become vectors.
            let mut column = [ZEROS; SUMS];
            column[..rest.len()].copy_from_slice(rest);
            subtract(&mut column, known.iter().zip(own.chunks_exact(PANEL).map(|own| &own[group..group + SUMS])));
            for j in 0..SUMS {
                let k = group + j;
                if k >= columns {
                    break;
                }
                if k >= row {
                    let pivot = column[j][k - row];
                    let divided = 1.0 / pivot;
                    // Not `<=`, so that a NaN pivot is left out too.
                    let is_positive = pivot > MIN_RELATIVE_PIVOT * diagonal[k] && divided.is_finite();
                    inverse[k] = if is_positive { divided } else { 0.0 };
                }
                if inverse[k] == 0.0 {
                    column[j] = ZEROS;
                }
                let own = &mut own[PANEL * k..PANEL * (k + 1)];
                if row < width {
                    let end = width.min(row + LANES);
                    own[row..end].copy_from_slice(&column[j][..end - row]);
                }
                undivided[k] = column[j];
                column[j].iter_mut().for_each(|entry| *entry *= inverse[k]);
                let (divided, factors) = (column[j], &own[group..group + SUMS]);
                for later in j + 1..SUMS {
                    for i in 0..LANES {
                        column[later][i] -= divided[i] * factors[later];
                    }
                }
            }
            let count = rest.len();
            rest.copy_from_slice(&column[..count]);
        }
    }
}

/// Subtracts a panel's products from one block of rows.
struct Subtract<'a> {
    block: &'a mut [Lanes],
    first: usize,
    width: usize,
    /// The first block of columns.
    next: usize,
    undivided: &'a [Lanes],
}

impl Kernel for Subtract<'_> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let Subtract { block, first, width, next, undivided } = self;
        let mut divided = [ZEROS; PANEL];
        divided[..width].copy_from_slice(&block[first..first + width]);
        let divided = &divided[..width];
        let columns = block[LANES * next..].chunks_exact_mut(LANES);
        for (columns, undivided) in columns.zip(undivided[PANEL * next..].chunks_exact(PANEL)) {
            let (low, high) = columns.split_at_mut(SUMS);
            let undivided = &undivided[..width];
            let [low, high] = [low, high].map(|half| half.try_into().expect("half of the columns of a block"));
            subtract(low, divided.iter().zip(undivided.iter().map(|rows| &rows[..SUMS])));
            subtract(high, divided.iter().zip(undivided.iter().map(|rows| &rows[SUMS..])));
        }
    }
}

/// Subtracts the products of other columns, each with its factors, from these columns.
#[inline(always)]
fn subtract<'a>(columns: &mut [Lanes; SUMS], products: impl Iterator<Item = (&'a Lanes, &'a [f64])>) {
    let mut sums = [ZEROS; SUMS];
    for (lanes, factors) in products {
        let factors: &[f64; SUMS] = factors.try_into().expect("as many factors as columns");
        add_products(&mut sums, lanes, factors);
    }
    for (column, sum) in columns.iter_mut().zip(&sums) {
        for i in 0..LANES {
            column[i] -= sum[i];
        }
    }
}

/// Adds the products of a column with each factor. The arguments do not overlap, so the compiler
/// can use vectors wherever it inlines this function.
#[inline(always)]
fn add_products(sums: &mut [Lanes; SUMS], lanes: &Lanes, factors: &[f64; SUMS]) {
    for (sum, factor) in sums.iter_mut().zip(factors) {
        for (sum, entry) in sum.iter_mut().zip(lanes) {
            *sum += entry * factor;
        }
    }
}

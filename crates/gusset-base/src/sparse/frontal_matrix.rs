//! Dense fronts: eliminate the first columns of a symmetric matrix and update the rest.
//!
//! The lower triangle is stored in blocks of [`ROWS_PER_BLOCK`] rows, column after column within a
//! block. Products of two blocks then read memory in order and fill vector registers. Columns are
//! eliminated in panels of [`COLUMNS_PER_PANEL`], first within the panel, then in all remaining
//! columns at once, where most operations are. Every entry receives its products in the order of
//! the columns, for any vector width.

use crate::alloc;
use crate::error::Result;
use crate::simd::{self, Kernel};

/// Rows of a block.
pub(super) const ROWS_PER_BLOCK: usize = 8;
/// The entries of a block's rows in one column.
pub(super) type BlockColumn = [f64; ROWS_PER_BLOCK];
/// Columns eliminated at a time; a multiple of [`ROWS_PER_BLOCK`].
const COLUMNS_PER_PANEL: usize = 32;
/// Columns whose sums are in registers together.
const COLUMNS_SUMMED_TOGETHER: usize = 4;
/// A pivot up to this fraction of its diagonal entry counts as rounding.
const MIN_RELATIVE_PIVOT: f64 = 4.0 * f64::EPSILON;
const ZERO_COLUMN: BlockColumn = [0.0; ROWS_PER_BLOCK];

/// The lower triangle of a symmetric matrix, and workspace for the elimination of columns.
#[derive(Default)]
pub(super) struct FrontalMatrix {
    size: usize,
    /// Block `b` has rows `8 b` to `8 b + 7` and columns up to `8 b + 7`. Entries above the
    /// diagonal and below the last row are unused.
    entries: Vec<BlockColumn>,
    /// The columns of a panel before division by their pivots, block by block.
    columns_before_division: Vec<BlockColumn>,
    own: Vec<f64>,
}

/// Returns the start of block `b`.
fn block_start(b: usize) -> usize {
    ROWS_PER_BLOCK * b * (b + 1) / 2
}

impl FrontalMatrix {
    /// Resets to `size` rows of zeros. Calls `spend` with the number of entries set.
    pub(super) fn reset(&mut self, size: usize, mut spend: impl FnMut(usize) -> Result<()>) -> Result<()> {
        self.size = size;
        let blocks = size.div_ceil(ROWS_PER_BLOCK);
        self.own.resize(COLUMNS_PER_PANEL * COLUMNS_PER_PANEL, 0.0);
        alloc::grow(&mut self.columns_before_division, COLUMNS_PER_PANEL * blocks, ZERO_COLUMN)?;
        self.entries.clear();
        alloc::reserve(&mut self.entries, block_start(blocks))?;
        for b in 0..blocks {
            self.entries.resize(block_start(b + 1), ZERO_COLUMN);
            spend(ROWS_PER_BLOCK * ROWS_PER_BLOCK * (b + 1))?;
        }
        Ok(())
    }

    /// Returns an entry on the diagonal or below it.
    #[inline]
    pub(super) fn entry_mut(&mut self, row: usize, column: usize) -> &mut f64 {
        &mut self.entries[block_start(row / ROWS_PER_BLOCK) + column][row % ROWS_PER_BLOCK]
    }

    /// Adds a lower triangle, given row by row. `places` has the positions of its rows, ascending.
    /// Calls `spend` with the number of entries added.
    pub(super) fn add_lower_triangle(
        &mut self,
        places: &[u32],
        triangle: &[f64],
        mut spend: impl FnMut(usize) -> Result<()>,
    ) -> Result<()> {
        let mut rest = triangle;
        for (i, &row) in places.iter().enumerate() {
            let (values, after) = rest.split_at(i + 1);
            rest = after;
            let (b, lane) = (row as usize / ROWS_PER_BLOCK, row as usize % ROWS_PER_BLOCK);
            let block = &mut self.entries[block_start(b)..block_start(b + 1)];
            for (&column, &value) in places.iter().zip(values) {
                block[column as usize][lane] += value;
            }
            spend(i + 1)?;
        }
        Ok(())
    }

    /// Appends the lower triangle of the rows from `first` on, row by row, to `triangle`. Calls
    /// `spend` with the number of entries appended.
    pub(super) fn append_lower_triangle_from_row(
        &self,
        first: usize,
        triangle: &mut Vec<f64>,
        mut spend: impl FnMut(usize) -> Result<()>,
    ) -> Result<()> {
        let rows = self.size - first;
        alloc::reserve(triangle, rows * (rows + 1) / 2)?;
        for row in first..self.size {
            let (b, lane) = (row / ROWS_PER_BLOCK, row % ROWS_PER_BLOCK);
            triangle.extend(self.block_columns(b)[first..=row].iter().map(|lanes| lanes[lane]));
            spend(row + 1 - first)?;
        }
        Ok(())
    }

    /// Returns the number of blocks of rows.
    fn block_count(&self) -> usize {
        self.size.div_ceil(ROWS_PER_BLOCK)
    }

    /// Returns the columns of a block of rows.
    pub(super) fn block_columns(&self, b: usize) -> &[BlockColumn] {
        &self.entries[block_start(b)..block_start(b + 1)]
    }

    /// Eliminates as many columns as `inverse` has entries. The columns become columns of L, and
    /// `inverse` receives the inverses of their pivots. A pivot that is not positive relative to
    /// the original entry on the `diagonal` counts as infinite, which removes its row and column.
    /// Calls `spend` with the number of multiplications.
    pub(super) fn eliminate_columns(
        &mut self,
        diagonal: &[f64],
        inverse: &mut [f64],
        mut spend: impl FnMut(usize) -> Result<()>,
    ) -> Result<()> {
        let count = inverse.len();
        for first in (0..count).step_by(COLUMNS_PER_PANEL) {
            let panel = first..count.min(first + COLUMNS_PER_PANEL);
            let width = panel.len();
            for b in first / ROWS_PER_BLOCK..self.block_count() {
                simd::run(EliminatePanel {
                    row: b * ROWS_PER_BLOCK,
                    first,
                    block: &mut self.entries[block_start(b)..block_start(b + 1)],
                    own: &mut self.own,
                    undivided: &mut self.columns_before_division[COLUMNS_PER_PANEL * b..][..width],
                    diagonal: &diagonal[panel.clone()],
                    inverse: &mut inverse[panel.clone()],
                });
                spend(width * width * ROWS_PER_BLOCK / 2)?;
            }
            // The panel ends in this block, whose panel columns must stay.
            let next = panel.end / ROWS_PER_BLOCK;
            if panel.end % ROWS_PER_BLOCK > 0 {
                let own = &mut self.columns_before_division[COLUMNS_PER_PANEL * next..][..width];
                own.iter_mut().for_each(|lanes| lanes[..panel.end % ROWS_PER_BLOCK].fill(0.0));
            }
            for b in next..self.block_count() {
                simd::run(SubtractPanel {
                    block: &mut self.entries[block_start(b)..block_start(b + 1)],
                    first,
                    width,
                    first_block: next,
                    undivided: &self.columns_before_division,
                });
                spend(ROWS_PER_BLOCK * ROWS_PER_BLOCK * (b + 1 - next) * width)?;
            }
        }
        Ok(())
    }
}

/// Eliminates the columns of a panel in one block of rows.
struct EliminatePanel<'a> {
    row: usize,
    /// The panel's first column.
    first: usize,
    block: &'a mut [BlockColumn],
    own: &'a mut [f64],
    undivided: &'a mut [BlockColumn],
    diagonal: &'a [f64],
    inverse: &'a mut [f64],
}

impl Kernel for EliminatePanel<'_> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let EliminatePanel { row, first, block, own, undivided, diagonal, inverse } = self;
        let width = undivided.len();
        // The number of panel columns that the block has, and the first of its rows among them.
        let columns = width.min(row + ROWS_PER_BLOCK - first);
        let block = &mut block[first..first + columns];
        let row = row - first;
        for group in (0..columns).step_by(COLUMNS_SUMMED_TOGETHER) {
            let (known, rest) = block.split_at_mut(group);
            let rest = &mut rest[..COLUMNS_SUMMED_TOGETHER.min(columns - group)];
            // A fixed-size copy, padded with unused columns, lets the loops over it become vectors.
            let mut column = [ZERO_COLUMN; COLUMNS_SUMMED_TOGETHER];
            column[..rest.len()].copy_from_slice(rest);
            subtract_column_products(
                &mut column,
                known
                    .iter()
                    .zip(own.chunks_exact(COLUMNS_PER_PANEL).map(|own| &own[group..group + COLUMNS_SUMMED_TOGETHER])),
            );
            for j in 0..COLUMNS_SUMMED_TOGETHER {
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
                    column[j] = ZERO_COLUMN;
                }
                let own = &mut own[COLUMNS_PER_PANEL * k..COLUMNS_PER_PANEL * (k + 1)];
                if row < width {
                    let end = width.min(row + ROWS_PER_BLOCK);
                    own[row..end].copy_from_slice(&column[j][..end - row]);
                }
                undivided[k] = column[j];
                column[j].iter_mut().for_each(|entry| *entry *= inverse[k]);
                let (divided, factors) = (column[j], &own[group..group + COLUMNS_SUMMED_TOGETHER]);
                for later in j + 1..COLUMNS_SUMMED_TOGETHER {
                    for i in 0..ROWS_PER_BLOCK {
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
struct SubtractPanel<'a> {
    block: &'a mut [BlockColumn],
    first: usize,
    width: usize,
    /// The first block of columns.
    first_block: usize,
    undivided: &'a [BlockColumn],
}

impl Kernel for SubtractPanel<'_> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let SubtractPanel { block, first, width, first_block: next, undivided } = self;
        let mut divided = [ZERO_COLUMN; COLUMNS_PER_PANEL];
        divided[..width].copy_from_slice(&block[first..first + width]);
        let divided = &divided[..width];
        let columns = block[ROWS_PER_BLOCK * next..].chunks_exact_mut(ROWS_PER_BLOCK);
        for (columns, undivided) in columns.zip(undivided[COLUMNS_PER_PANEL * next..].chunks_exact(COLUMNS_PER_PANEL)) {
            let (low, high) = columns.split_at_mut(COLUMNS_SUMMED_TOGETHER);
            let undivided = &undivided[..width];
            let [low, high] = [low, high].map(|half| half.try_into().expect("half of the columns of a block"));
            subtract_column_products(
                low,
                divided.iter().zip(undivided.iter().map(|rows| &rows[..COLUMNS_SUMMED_TOGETHER])),
            );
            subtract_column_products(
                high,
                divided.iter().zip(undivided.iter().map(|rows| &rows[COLUMNS_SUMMED_TOGETHER..])),
            );
        }
    }
}

/// Subtracts the products of other columns, each with its factors, from these columns.
#[inline(always)]
fn subtract_column_products<'a>(
    columns: &mut [BlockColumn; COLUMNS_SUMMED_TOGETHER],
    products: impl Iterator<Item = (&'a BlockColumn, &'a [f64])>,
) {
    let mut sums = [ZERO_COLUMN; COLUMNS_SUMMED_TOGETHER];
    for (lanes, factors) in products {
        let factors: &[f64; COLUMNS_SUMMED_TOGETHER] = factors.try_into().expect("as many factors as columns");
        add_products(&mut sums, lanes, factors);
    }
    for (column, sum) in columns.iter_mut().zip(&sums) {
        for i in 0..ROWS_PER_BLOCK {
            column[i] -= sum[i];
        }
    }
}

/// Adds the products of a column with each factor. The arguments do not overlap, so the compiler
/// can use vectors wherever it inlines this function.
#[inline(always)]
fn add_products(
    sums: &mut [BlockColumn; COLUMNS_SUMMED_TOGETHER],
    lanes: &BlockColumn,
    factors: &[f64; COLUMNS_SUMMED_TOGETHER],
) {
    for (sum, factor) in sums.iter_mut().zip(factors) {
        for (sum, entry) in sum.iter_mut().zip(lanes) {
            *sum += entry * factor;
        }
    }
}

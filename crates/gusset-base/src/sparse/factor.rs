//! The factor L D L^T of a sparse symmetric matrix by the multifrontal method. The matrix must be
//! positive definite, apart from unknowns that the factorisation leaves out.
//!
//! Source: I. S. Duff, J. K. Reid, *The multifrontal solution of indefinite sparse symmetric linear
//! equations* (1983). Each [supernode](super::supernodes) assembles its columns of the matrix and
//! its children's updates in one dense [front](super::front). It eliminates its columns and pushes
//! the remaining update on a stack for its parent. All sums have one fixed order on every machine.

use super::frontal_matrix::{BlockColumn, FrontalMatrix, ROWS_PER_BLOCK};
use super::supernodes::Supernodes;
use super::symmetric::SparseSymmetric;
use crate::alloc;
use crate::error::Result;
use crate::job::Job;
use crate::sort::Buckets;

/// Multiplications between two progress reports, which take a few milliseconds.
const MULTIPLICATIONS_PER_REPORT: f64 = 16e6;
/// The cost of moving an entry, in multiplications.
const MOVE_COST_IN_MULTIPLICATIONS: usize = 8;

/// The factor: for each supernode its columns of L below the diagonal, in blocks of rows.
pub struct CholeskyFactor {
    pub supernodes: Supernodes,
    /// The columns of each block in turn. Entries not below the diagonal are 0.
    pub entries: Vec<BlockColumn>,
    /// The inverse of D; 0 for unknowns that are left out.
    pub inverse_pivots: Vec<f64>,
}

const STAGE: &str = "solving";

impl SparseSymmetric {
    /// Factors the matrix. An unknown whose pivot is not positive is left out: its solution will be
    /// 0, and the other unknowns solve the system without its row and column.
    ///
    /// O(sum of the squares of the columns' lengths). Memory: about 10 bytes an entry of L, less
    /// than that on the stack, and 100 bytes a row.
    pub fn factorise(&self, job: &Job<'_>) -> Result<CholeskyFactor> {
        job.step(0.0, STAGE)?;
        let below = self.entries_below_diagonal(&job.sub_job(0.0, 0.0))?;
        let supernodes = Supernodes::new(self, &below, &job.sub_job(0.0, 0.1))?;
        job.step(0.1, STAGE)?;
        let costs = FactorCosts::predict_from_supernodes(&supernodes);
        let mut elimination = SupernodeElimination {
            matrix: self,
            entries_below_diagonal: &below,
            front: FrontalMatrix::default(),
            updates: alloc::with_capacity(costs.stack)?,
            front_position_of_row: alloc::filled(0, self.row_count())?,
            places: Vec::new(),
            diagonal: Vec::new(),
            progress: FactorProgress {
                job: job.sub_job(0.1, 1.0),
                total_multiplications: costs.multiplications,
                multiplications_done: 0.0,
                multiplications_reported: 0.0,
            },
        };
        let (entries, inverse) = (alloc::with_capacity(costs.factor_blocks)?, alloc::filled(0.0, self.row_count())?);
        let mut factor = CholeskyFactor { supernodes, entries, inverse_pivots: inverse };
        job.step(0.1, STAGE)?;
        for s in 0..factor.supernodes.len() {
            elimination.eliminate_supernode(s, &mut factor)?;
        }
        Ok(factor)
    }
}

impl CholeskyFactor {
    /// Returns the number of columns in each block of rows of a supernode.
    pub fn column_counts_of_row_blocks(
        &self,
        s: usize,
    ) -> impl ExactSizeIterator<Item = usize> + DoubleEndedIterator + use<> {
        columns_of_blocks(self.supernodes.columns(s).len(), self.supernodes.rows_below(s).len())
    }
}

/// Returns the number of columns in each block of rows, of a supernode with the given numbers of
/// columns and of rows below them.
fn columns_of_blocks(columns: usize, rows: usize) -> impl ExactSizeIterator<Item = usize> + DoubleEndedIterator {
    (0..(columns + rows).div_ceil(ROWS_PER_BLOCK)).map(move |b| columns.min(ROWS_PER_BLOCK * (b + 1)))
}

/// Returns the number of entries in a triangle with its diagonal.
fn triangle_entry_count(rows: usize) -> usize {
    rows * (rows + 1) / 2
}

/// The predicted cost of the elimination.
struct FactorCosts {
    /// Blocks of entries in the factor.
    factor_blocks: usize,
    /// The greatest height of the stack.
    stack: usize,
    /// Multiplications.
    multiplications: f64,
}

impl FactorCosts {
    fn predict_from_supernodes(supernodes: &Supernodes) -> Self {
        let mut costs = FactorCosts { factor_blocks: 0, stack: 0, multiplications: 0.0 };
        let mut height = 0;
        for s in 0..supernodes.len() {
            let (columns, rows) = (supernodes.columns(s).len(), supernodes.rows_below(s).len());
            costs.factor_blocks += columns_of_blocks(columns, rows).sum::<usize>();
            let [size, rest] = [columns + rows, rows].map(|rows| rows as f64);
            // All entries are set, the columns' entries are copied out, and the rest is pushed to
            // the stack and popped.
            let moved = size * size + rest * rest / 2.0;
            costs.multiplications +=
                (size * size * size - rest * rest * rest) / 6.0 + MOVE_COST_IN_MULTIPLICATIONS as f64 * moved;
            height -= supernodes
                .children(s)
                .map(|child| triangle_entry_count(supernodes.rows_below(child).len()))
                .sum::<usize>();
            height += triangle_entry_count(rows);
            costs.stack = costs.stack.max(height);
        }
        costs
    }
}

/// The progress of the elimination.
struct FactorProgress<'a> {
    job: Job<'a>,
    total_multiplications: f64,
    multiplications_done: f64,
    multiplications_reported: f64,
}

impl FactorProgress<'_> {
    #[inline]
    fn count_multiplications(&mut self, multiplications: usize) -> Result<()> {
        if self.multiplications_done >= self.multiplications_reported + MULTIPLICATIONS_PER_REPORT {
            self.job.step(self.multiplications_done / self.total_multiplications, STAGE)?;
            self.multiplications_reported = self.multiplications_done;
        }
        self.multiplications_done += multiplications as f64;
        Ok(())
    }

    #[inline]
    fn count_moved_entries(&mut self, entries: usize) -> Result<()> {
        self.count_multiplications(MOVE_COST_IN_MULTIPLICATIONS * entries)
    }
}

/// Eliminates the supernodes in order.
struct SupernodeElimination<'a> {
    matrix: &'a SparseSymmetric,
    entries_below_diagonal: &'a Buckets<(u32, f64)>,
    front: FrontalMatrix,
    /// The stack: updates for parents that are not yet eliminated, as lower triangles, row by row.
    updates: Vec<f64>,
    /// The position in the front of each row below the front's columns.
    front_position_of_row: Vec<u32>,
    places: Vec<u32>,
    diagonal: Vec<f64>,
    progress: FactorProgress<'a>,
}

impl SupernodeElimination<'_> {
    fn eliminate_supernode(&mut self, s: usize, factor: &mut CholeskyFactor) -> Result<()> {
        let supernodes = &factor.supernodes;
        let (columns, rows) = (supernodes.columns(s), supernodes.rows_below(s));
        let (first, width) = (columns.start, columns.len());
        let work = &mut self.progress;
        self.front.reset(width + rows.len(), |count| work.count_moved_entries(count))?;
        rows.iter().zip(width as u32..).for_each(|(&row, to)| self.front_position_of_row[row as usize] = to);
        let local = &self.front_position_of_row;
        let place = |row: u32| if (row as usize) < columns.end { row - first as u32 } else { local[row as usize] };

        self.diagonal.clear();
        for (k, &column) in supernodes.order[columns.clone()].iter().enumerate() {
            let diagonal = self.matrix.diagonal[column as usize];
            alloc::push(&mut self.diagonal, diagonal)?;
            *self.front.entry_mut(k, k) = diagonal;
            for &(row, value) in self.entries_below_diagonal.get(column as usize) {
                let row = place(supernodes.new_number_of_column[row as usize]);
                *self.front.entry_mut(row as usize, k) = value;
            }
        }
        for child in supernodes.children(s) {
            let rows = supernodes.rows_below(child);
            self.places.clear();
            alloc::extend(&mut self.places, rows.iter().map(|&row| place(row)))?;
            let left = self.updates.len() - triangle_entry_count(rows.len());
            self.front
                .add_lower_triangle(&self.places, &self.updates[left..], |count| work.count_moved_entries(count))?;
            self.updates.truncate(left);
        }
        let inverse = &mut factor.inverse_pivots[columns];
        self.front.eliminate_columns(&self.diagonal, inverse, |count| work.count_multiplications(count))?;
        for (b, columns) in columns_of_blocks(width, rows.len()).enumerate() {
            let below_diagonal = |(k, lanes): (usize, &BlockColumn)| {
                let above = (k + 1).saturating_sub(ROWS_PER_BLOCK * b).min(ROWS_PER_BLOCK);
                std::array::from_fn(|i| if i < above { 0.0 } else { lanes[i] })
            };
            factor.entries.extend(self.front.block_columns(b)[..columns].iter().enumerate().map(below_diagonal));
            work.count_moved_entries(ROWS_PER_BLOCK * columns)?;
        }
        self.front.append_lower_triangle_from_row(width, &mut self.updates, |count| work.count_moved_entries(count))
    }
}

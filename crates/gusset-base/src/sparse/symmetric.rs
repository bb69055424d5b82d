//! Sparse symmetric matrices.

use crate::error::Result;
use crate::job::Job;
use crate::sort::Buckets;

/// A symmetric matrix: its diagonal, and the entries above it, column by column as (row, value).
pub struct SparseSymmetric {
    pub column_starts: Vec<usize>,
    pub entries: Vec<(u32, f64)>,
    pub diagonal: Vec<f64>,
}

impl SparseSymmetric {
    /// Returns the number of rows.
    #[inline]
    pub fn row_count(&self) -> usize {
        self.diagonal.len()
    }

    /// Returns the entries of column `k` above the diagonal, which are the entries of row `k`
    /// before it.
    #[inline]
    pub fn entries_above_diagonal(&self, k: usize) -> &[(u32, f64)] {
        &self.entries[self.column_starts[k]..self.column_starts[k + 1]]
    }

    /// Returns the entries below the diagonal, column by column. Takes 16 bytes an entry.
    #[inline]
    pub fn entries_below_diagonal(&self, job: &Job<'_>) -> Result<Buckets<(u32, f64)>> {
        let columns = (0..self.row_count())
            .flat_map(|k| self.entries_above_diagonal(k).iter().map(move |&(i, value)| (k, i, value)));
        let items = columns.map(|(k, i, value)| (i as usize, (k as u32, value)));
        Buckets::new_cancellable(self.row_count(), (0, 0.0), items, job, "solving")
    }
}

//! The factor L D L^T of a sparse symmetric matrix that is positive definite but for some of its
//! unknowns.
//!
//! Source: T. A. Davis, *Algorithm 849: a concise sparse Cholesky factorization package* (2005).
//! Row k of L solves a triangular system with the rows above it; which columns it has follows from
//! the elimination tree alone. All sums run in one fixed order, on any machine.

use crate::alloc;
use crate::error::Result;
use crate::job::Job;
use glam::DVec3;

/// A triangle without its diagonal, column by column as (row, value), and a diagonal: the upper
/// triangle of a symmetric matrix; or of its factor L, with the inverse of D as the diagonal.
pub(super) struct Triangle {
    pub(super) start: Vec<usize>,
    pub(super) entries: Vec<(u32, f64)>,
    pub(super) diagonal: Vec<f64>,
}

/// The root of a tree.
const NONE: u32 = u32::MAX;
/// Pivots up to this share of their diagonal entries are rounding.
const MIN_RELATIVE_PIVOT: f64 = 4.0 * f64::EPSILON;
/// Products between two progress reports, some milliseconds.
const REPORT_INTERVAL: usize = 1 << 22;

impl Triangle {
    /// The factor of a symmetric matrix. An unknown whose pivot is not positive is left out: its
    /// solution will be 0, and the others are found as if its row and column did not exist.
    ///
    /// O(sum of the squares of the columns' lengths); memory: 16 bytes an entry of L, and 36 a row.
    pub(super) fn factor(&self, job: &Job<'_>) -> Result<Self> {
        let n = self.diagonal.len();
        let mut tree =
            Tree { parent: alloc::filled(NONE, n)?, mark: alloc::filled(NONE, n)?, path: alloc::filled(0, n)? };
        let start = tree.grow(self)?;
        let (entries, diagonal) = (alloc::filled((0, 0.0), start[n])?, alloc::filled(0.0, n)?);
        let mut factor = Triangle { start, entries, diagonal };
        let mut end = alloc::copied(&factor.start[..n])?;
        let mut row = alloc::filled(0.0, n)?;
        tree.mark.fill(NONE);
        let mut products = REPORT_INTERVAL;
        for k in 0..n {
            if products >= REPORT_INTERVAL {
                job.step(k as f64 / n as f64, "fairing")?;
                products = 0;
            }
            for &(i, value) in self.column(k) {
                row[i as usize] = value;
            }
            let mut pivot = self.diagonal[k];
            for &i in tree.reach(self, k) {
                let i = i as usize;
                let value = std::mem::take(&mut row[i]);
                products += end[i] - factor.start[i] + 1;
                for &(j, l) in &factor.entries[factor.start[i]..end[i]] {
                    row[j as usize] -= l * value;
                }
                let l = value * factor.diagonal[i];
                pivot -= l * value;
                factor.entries[end[i]] = (k as u32, l);
                end[i] += 1;
            }
            // Not `<=`: a pivot that is no number is left out as well.
            if pivot > MIN_RELATIVE_PIVOT * self.diagonal[k] {
                factor.diagonal[k] = 1.0 / pivot;
            }
        }
        Ok(factor)
    }

    /// Solves by the factor for three right-hand sides at once, in place.
    pub(super) fn solve(&self, x: &mut [DVec3]) {
        for k in 0..x.len() {
            let value = x[k];
            for &(i, l) in self.column(k) {
                x[i as usize] -= l * value;
            }
        }
        for k in (0..x.len()).rev() {
            let sum = self.column(k).iter().fold(x[k] * self.diagonal[k], |sum, &(i, l)| sum - l * x[i as usize]);
            x[k] = sum;
        }
    }

    fn column(&self, k: usize) -> &[(u32, f64)] {
        &self.entries[self.start[k]..self.start[k + 1]]
    }
}

/// The elimination tree: the parent of column i is the first row below i in which it has an entry.
struct Tree {
    parent: Vec<u32>,
    mark: Vec<u32>,
    path: Vec<u32>,
}

impl Tree {
    /// Finds the tree and where each column of L starts.
    fn grow(&mut self, matrix: &Triangle) -> Result<Vec<usize>> {
        let n = self.parent.len();
        let mut start = alloc::filled(0usize, n + 1)?;
        for k in 0..n as u32 {
            self.mark[k as usize] = k;
            for &(entry, _) in matrix.column(k as usize) {
                let mut i = entry as usize;
                while self.mark[i] != k {
                    if self.parent[i] == NONE {
                        self.parent[i] = k;
                    }
                    start[i + 1] += 1;
                    self.mark[i] = k;
                    i = self.parent[i] as usize;
                }
            }
        }
        for k in 0..n {
            start[k + 1] += start[k];
        }
        Ok(start)
    }

    /// The columns in which row `k` of L has entries, each before its ancestors.
    fn reach(&mut self, matrix: &Triangle, k: usize) -> &[u32] {
        let n = self.path.len();
        let mut top = n;
        self.mark[k] = k as u32;
        for &(entry, _) in matrix.column(k) {
            let mut length = 0;
            let mut i = entry as usize;
            while self.mark[i] != k as u32 {
                self.path[length] = i as u32;
                self.mark[i] = k as u32;
                i = self.parent[i] as usize;
                length += 1;
            }
            // Paths fill the array from its end.
            self.path.copy_within(..length, top - length);
            top -= length;
        }
        &self.path[top..]
    }
}

//! Small dense systems of linear equations: Gaussian elimination with partial pivoting. O(n^3) for
//! the factor, O(n^2) for each right side.

use crate::alloc;
use crate::error::Result;
use glam::DVec3;

/// A square matrix, row by row, which elimination replaces by its factors.
#[derive(Default)]
pub struct DenseMatrix {
    entries: Vec<f64>,
    /// The row exchanged with each row.
    pivots: Vec<usize>,
    size: usize,
}

impl DenseMatrix {
    /// Resizes to a matrix of `n` rows of zeros.
    #[inline]
    pub fn resize(&mut self, n: usize) -> Result<()> {
        self.size = n;
        alloc::reset(&mut self.entries, n * n, 0.0)?;
        alloc::reset(&mut self.pivots, n, 0)
    }

    #[inline]
    pub fn row(&mut self, r: usize) -> &mut [f64] {
        &mut self.entries[r * self.size..(r + 1) * self.size]
    }

    /// Factors the matrix with partial pivoting. Returns false if it is singular.
    pub fn factorise(&mut self) -> bool {
        let n = self.size;
        for k in 0..n {
            let mut best = k;
            for r in k + 1..n {
                if self.entries[r * n + k].abs() > self.entries[best * n + k].abs() {
                    best = r;
                }
            }
            let pivot = self.entries[best * n + k];
            if !(pivot.abs() > f64::MIN_POSITIVE && pivot.is_finite()) {
                return false;
            }
            self.pivots[k] = best;
            for c in 0..n {
                self.entries.swap(k * n + c, best * n + c);
            }
            for r in k + 1..n {
                let factor = self.entries[r * n + k] / pivot;
                self.entries[r * n + k] = factor;
                for c in k + 1..n {
                    self.entries[r * n + c] -= factor * self.entries[k * n + c];
                }
            }
        }
        true
    }

    /// Solves for a right side in place. Call [`DenseMatrix::factorise`] first.
    pub fn solve(&self, right: &mut [DVec3]) {
        let n = self.size;
        // The factor's rows were exchanged as a whole, so exchange the right side likewise.
        for k in 0..n {
            right.swap(k, self.pivots[k]);
        }
        for k in 0..n {
            for r in k + 1..n {
                let (known, rest) = (right[k], &mut right[r]);
                *rest -= known * self.entries[r * n + k];
            }
        }
        for k in (0..n).rev() {
            for c in k + 1..n {
                let (known, rest) = (right[c], &mut right[k]);
                *rest -= known * self.entries[k * n + c];
            }
            right[k] /= self.entries[k * n + k];
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn systems_that_need_exchanges_are_solved() {
        // Rows in an order that forces an exchange for every pivot, and a row that depends on
        // another.
        let rows = [[0.0, 2.0, 1.0, 0.1], [0.1, 1.0, 0.0, 3.0], [2.0, 0.3, 1.0, 0.0], [1.0, 0.5, 4.0, 0.2]];
        let wanted = [1.0, -2.0, 3.0, 0.5].map(|x| DVec3::new(x, -x, 1.0));
        let mut dense = DenseMatrix::default();
        dense.resize(4).unwrap();
        let mut right = [DVec3::ZERO; 4];
        for (r, row) in rows.iter().enumerate() {
            dense.row(r).copy_from_slice(row);
            right[r] = row.iter().zip(wanted).map(|(a, x)| x * *a).sum();
        }
        assert!(dense.factorise());
        dense.solve(&mut right);
        for (x, wanted) in right.iter().zip(wanted) {
            assert!(x.distance(wanted) < 1e-14, "{x} {wanted}");
        }
        dense.resize(2).unwrap();
        assert!(!dense.factorise());
    }
}

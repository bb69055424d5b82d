//! Small dense systems of linear equations: those of single curves, 64 rows at the most.

use crate::alloc;
use crate::error::Result;
use glam::DVec3;

/// A square matrix, row by row, and what elimination makes of it.
#[derive(Default)]
pub(super) struct Dense {
    entries: Vec<f64>,
    /// The row exchanged with each row.
    pivots: Vec<usize>,
    size: usize,
}

impl Dense {
    /// Zeros in `n` rows.
    pub(super) fn resize(&mut self, n: usize) -> Result<()> {
        self.size = n;
        self.entries.clear();
        self.pivots.clear();
        alloc::reserve(&mut self.entries, n * n)?;
        alloc::reserve(&mut self.pivots, n)?;
        self.entries.resize(n * n, 0.0);
        self.pivots.resize(n, 0);
        Ok(())
    }

    /// Row `r`.
    pub(super) fn row(&mut self, r: usize) -> &mut [f64] {
        &mut self.entries[r * self.size..(r + 1) * self.size]
    }

    /// Eliminates with the largest pivot of each column. False if there is none.
    pub(super) fn factor(&mut self) -> bool {
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

    /// Solves for a right side after [`Dense::factor`].
    pub(super) fn solve(&self, right: &mut [DVec3]) {
        let n = self.size;
        for k in 0..n {
            right.swap(k, self.pivots[k]);
            for r in k + 1..n {
                right[r] = right[r] - right[k] * self.entries[r * n + k];
            }
        }
        for k in (0..n).rev() {
            for c in k + 1..n {
                right[k] = right[k] - right[c] * self.entries[k * n + c];
            }
            right[k] = right[k] / self.entries[k * n + k];
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_system_that_needs_exchanges() {
        let mut dense = Dense::default();
        dense.resize(3).unwrap();
        for (r, row) in [[0.0, 2.0, 1.0], [1.0, 1.0, 0.0], [2.0, 0.0, -1.0]].iter().enumerate() {
            dense.row(r).copy_from_slice(row);
        }
        // x = 1, y = 2, z = 3, and minus that, and 0.
        let mut right = [7.0, 3.0, -1.0].map(|x| DVec3::new(x, -x, 0.0));
        // The rows depend on each other: 2 * second - first = third.
        assert!(!dense.factor() || { dense.solve(&mut right); right.iter().any(|x| !x.is_finite() || x.length() > 1e10) });
        dense.resize(3).unwrap();
        for (r, row) in [[0.0, 2.0, 1.0], [1.0, 1.0, 0.0], [2.0, 0.0, 1.0]].iter().enumerate() {
            dense.row(r).copy_from_slice(row);
        }
        let mut right = [7.0, 3.0, 5.0].map(|x| DVec3::new(x, -x, 0.0));
        assert!(dense.factor());
        dense.solve(&mut right);
        for (x, wanted) in right.iter().zip([1.0, 2.0, 3.0]) {
            assert!((*x - DVec3::new(wanted, -wanted, 0.0)).length() < 1e-14, "{x} {wanted}");
        }
    }
}

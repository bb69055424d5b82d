//! Symmetric positive definite banded systems by Cholesky's method. Each row is factored as soon as
//! it is known. O(n W^2) time and O(n W) memory for n rows.

use crate::alloc;
use crate::error::Result;

/// A pivot below this fraction of its diagonal entry counts as rounding. Its row depends on earlier
/// rows, and its unknown is set to 0.
const MIN_RELATIVE_PIVOT: f64 = 1e-13;

/// The Cholesky factor of a matrix with entries at most W - 1 from the diagonal, and the
/// forward-solved right side.
#[derive(Default)]
pub struct BandedCholesky<const W: usize> {
    /// The rows of the factor. The diagonal entry is last.
    rows: Vec<[f64; W]>,
    right_side: Vec<f64>,
}

impl<const W: usize> BandedCholesky<W> {
    /// Clears the system and reserves room for `count` rows.
    #[inline]
    pub fn clear_and_reserve(&mut self, count: usize) -> Result<()> {
        self.rows.clear();
        self.right_side.clear();
        alloc::reserve(&mut self.rows, count)?;
        alloc::reserve(&mut self.right_side, count)
    }

    /// Appends a row and its right side. `row` has the entries up to the diagonal, which is last.
    /// [`BandedCholesky::clear_and_reserve`] must have reserved room.
    pub fn push(&mut self, mut row: [f64; W], mut right: f64) {
        let r = self.rows.len();
        let diagonal = row[W - 1];
        for d in (1..W.min(r + 1)).rev() {
            // Row r - d has W - 1 - d columns in common with row r before column r - d.
            let other = &self.rows[r - d];
            let known: f64 = row[..W - 1 - d].iter().zip(&other[d..W - 1]).map(|(a, b)| a * b).sum();
            row[W - 1 - d] = (row[W - 1 - d] - known) / other[W - 1];
        }
        let pivot = diagonal - row[..W - 1].iter().map(|a| a * a).sum::<f64>();
        for d in 1..W.min(r + 1) {
            right -= row[W - 1 - d] * self.right_side[r - d];
        }
        if pivot > MIN_RELATIVE_PIVOT * diagonal {
            row[W - 1] = pivot.sqrt();
            self.right_side.push(right / row[W - 1]);
        } else {
            row = [0.0; W];
            row[W - 1] = 1.0;
            self.right_side.push(0.0);
        }
        self.rows.push(row);
    }

    /// Solves for the unknowns.
    pub fn solve(&mut self) -> &[f64] {
        for r in (0..self.rows.len()).rev() {
            let row = &self.rows[r];
            let known = self.right_side[r] / row[W - 1];
            self.right_side[r] = known;
            for d in 1..W.min(r + 1) {
                self.right_side[r - d] -= row[W - 1 - d] * known;
            }
        }
        &self.right_side
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn banded_systems_are_solved() {
        // 4 on the diagonal, -1 and 0.5 beside it.
        let entry = |d: usize| [4.0, -1.0, 0.5][d];
        let wanted: Vec<f64> = (0..9).map(|i| f64::from(i * i % 7) - 2.0).collect();
        let mut banded = BandedCholesky::<3>::default();
        banded.clear_and_reserve(9).unwrap();
        for r in 0..9usize {
            let right = (0..9usize).filter(|c| c.abs_diff(r) < 3).map(|c| entry(c.abs_diff(r)) * wanted[c]).sum();
            let row = [2, 1, 0].map(|d| if d <= r { entry(d) } else { 0.0 });
            banded.push(row, right);
        }
        for (x, wanted) in banded.solve().iter().zip(&wanted) {
            assert!((x - wanted).abs() < 1e-14, "{x} {wanted}");
        }
        // A row that repeats the previous one does not change the solution.
        banded.clear_and_reserve(2).unwrap();
        banded.push([0.0, 0.0, 4.0], 8.0);
        banded.push([0.0, 4.0, 4.0], 8.0);
        assert_eq!(banded.solve(), [2.0, 0.0]);
    }
}

//! Solutions by the factor L D L^T, for three right sides at once.

use super::factor::CholeskyFactor;
use super::frontal_matrix::{BlockColumn, ROWS_PER_BLOCK};
use crate::alloc;
use crate::error::Result;
use crate::job::Job;
use glam::DVec3;
use std::ops::Range;

/// Blocks of entries between two progress reports.
const ENTRIES_PER_REPORT: usize = 1 << 17;
/// The entries of three right sides in a block of rows.
type RightSides = [BlockColumn; 3];

impl CholeskyFactor {
    /// Solves L D L^T x = b in place: `x` holds b before the call and the solution after it.
    ///
    /// O(entries of L); extra memory: 24 bytes a row.
    pub fn solve(&self, x: &mut [DVec3], job: &Job<'_>) -> Result<()> {
        let order = &self.supernodes.order;
        let mut y = alloc::collect(order.iter().map(|&k| x[k as usize]))?;
        let mut local = Vec::new();
        let (mut used, mut unreported) = (0, 0);
        let whole = 2.0 * self.entries.len() as f64;
        let mut step = |done: usize, count: usize| {
            unreported += count;
            if unreported >= ENTRIES_PER_REPORT {
                unreported = 0;
                return job.step(done as f64 / whole, "solving");
            }
            Ok(())
        };
        for s in 0..self.supernodes.len() {
            let count = self.column_counts_of_row_blocks(s).sum::<usize>();
            step(used, count)?;
            self.gather_right_sides(s, &y, &mut local)?;
            self.solve_forward(s, used, &mut local);
            self.scatter_right_sides(s, &local, &mut y);
            used += count;
        }
        for (y, &inverse) in y.iter_mut().zip(&self.inverse_pivots) {
            *y = if inverse == 0.0 { DVec3::ZERO } else { *y * inverse };
        }
        for s in (0..self.supernodes.len()).rev() {
            let count = self.column_counts_of_row_blocks(s).sum::<usize>();
            step(2 * self.entries.len() - used, count)?;
            self.gather_right_sides(s, &y, &mut local)?;
            self.solve_backward(s, used, &mut local);
            self.scatter_right_sides(s, &local, &mut y);
            used -= count;
        }
        order.iter().zip(y).for_each(|(&k, y)| x[k as usize] = y);
        Ok(())
    }

    fn unknowns_of_supernode(&self, s: usize) -> impl Iterator<Item = usize> + '_ {
        let columns: Range<usize> = self.supernodes.columns(s);
        columns.chain(self.supernodes.rows_below(s).iter().map(|&row| row as usize))
    }

    /// Copies the entries of `y` in the rows of a supernode to `local`.
    fn gather_right_sides(&self, s: usize, y: &[DVec3], local: &mut Vec<RightSides>) -> Result<()> {
        alloc::reset(local, self.column_counts_of_row_blocks(s).count(), [[0.0; ROWS_PER_BLOCK]; 3])?;
        for (i, place) in self.unknowns_of_supernode(s).enumerate() {
            set_right_side(local, i, y[place]);
        }
        Ok(())
    }

    fn scatter_right_sides(&self, s: usize, local: &[RightSides], y: &mut [DVec3]) {
        for (i, place) in self.unknowns_of_supernode(s).enumerate() {
            y[place] = right_side_at(local, i);
        }
    }

    /// Solves L y = b for the columns of a supernode, whose entries begin at `first_entry`.
    fn solve_forward(&self, supernode: usize, mut first_entry: usize, right_sides: &mut [RightSides]) {
        for (b, columns) in self.column_counts_of_row_blocks(supernode).enumerate() {
            for (k, lanes) in self.entries[first_entry..first_entry + columns].iter().enumerate() {
                let value = right_side_at(right_sides, k);
                for (side, value) in right_sides[b].iter_mut().zip(value.to_array()) {
                    for i in 0..ROWS_PER_BLOCK {
                        side[i] -= lanes[i] * value;
                    }
                }
            }
            first_entry += columns;
        }
    }

    /// Solves L^T x = y for the columns of a supernode, whose entries end at `entries_end`. Blocks
    /// and columns run backwards, so that a row is known before it is used.
    fn solve_backward(&self, supernode: usize, mut entries_end: usize, right_sides: &mut [RightSides]) {
        for (b, columns) in self.column_counts_of_row_blocks(supernode).enumerate().rev() {
            entries_end -= columns;
            for (k, lanes) in self.entries[entries_end..entries_end + columns].iter().enumerate().rev() {
                let sums = right_sides[b].map(|side| sum_pairwise(std::array::from_fn(|i| lanes[i] * side[i])));
                let value = right_side_at(right_sides, k) - DVec3::from_array(sums);
                set_right_side(right_sides, k, value);
            }
        }
    }
}

fn right_side_at(local: &[RightSides], i: usize) -> DVec3 {
    let lane = i % ROWS_PER_BLOCK;
    DVec3::from_array(local[i / ROWS_PER_BLOCK].map(|side| side[lane]))
}

fn set_right_side(local: &mut [RightSides], i: usize, value: DVec3) {
    for (side, value) in local[i / ROWS_PER_BLOCK].iter_mut().zip(value.to_array()) {
        side[i % ROWS_PER_BLOCK] = value;
    }
}

/// Sums eight numbers pairwise.
fn sum_pairwise([a, b, c, d, e, f, g, h]: BlockColumn) -> f64 {
    ((a + e) + (c + g)) + ((b + f) + (d + h))
}

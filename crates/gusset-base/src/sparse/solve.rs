//! Solutions by the factor L D L^T, for three right sides at once.

use super::factor::Factor;
use super::front::{LANES, Lanes};
use crate::alloc;
use crate::error::Result;
use crate::job::Job;
use glam::DVec3;
use std::ops::Range;

/// Blocks of entries between two progress reports.
const REPORT_INTERVAL: usize = 1 << 17;
/// The entries of three right sides in a block of rows.
type Sides = [Lanes; 3];

impl Factor {
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
            if unreported >= REPORT_INTERVAL {
                unreported = 0;
                return job.step(done as f64 / whole, "solving");
            }
            Ok(())
        };
        for s in 0..self.supernodes.len() {
            let count = self.blocks(s).sum::<usize>();
            step(used, count)?;
            self.gather(s, &y, &mut local)?;
            self.forward(s, used, &mut local);
            self.scatter(s, &local, &mut y);
            used += count;
        }
        for (y, &inverse) in y.iter_mut().zip(&self.inverse) {
            *y = if inverse == 0.0 { DVec3::ZERO } else { *y * inverse };
        }
        for s in (0..self.supernodes.len()).rev() {
            let count = self.blocks(s).sum::<usize>();
            step(2 * self.entries.len() - used, count)?;
            self.gather(s, &y, &mut local)?;
            self.backward(s, used, &mut local);
            self.scatter(s, &local, &mut y);
            used -= count;
        }
        order.iter().zip(y).for_each(|(&k, y)| x[k as usize] = y);
        Ok(())
    }

    fn places(&self, s: usize) -> impl Iterator<Item = usize> + '_ {
        let columns: Range<usize> = self.supernodes.columns(s);
        columns.chain(self.supernodes.rows(s).iter().map(|&row| row as usize))
    }

    /// Copies the entries of `y` in the rows of a supernode to `local`.
    fn gather(&self, s: usize, y: &[DVec3], local: &mut Vec<Sides>) -> Result<()> {
        alloc::reset(local, self.blocks(s).count(), [[0.0; LANES]; 3])?;
        for (i, place) in self.places(s).enumerate() {
            put(local, i, y[place]);
        }
        Ok(())
    }

    fn scatter(&self, s: usize, local: &[Sides], y: &mut [DVec3]) {
        for (i, place) in self.places(s).enumerate() {
            y[place] = get(local, i);
        }
    }

    /// Solves L y = b for the columns of a supernode, whose entries begin at `used`.
    fn forward(&self, s: usize, mut used: usize, local: &mut [Sides]) {
        for (b, columns) in self.blocks(s).enumerate() {
            for (k, lanes) in self.entries[used..used + columns].iter().enumerate() {
                let value = get(local, k);
                for (side, value) in local[b].iter_mut().zip(value.to_array()) {
                    for i in 0..LANES {
                        side[i] -= lanes[i] * value;
                    }
                }
            }
            used += columns;
        }
    }

    /// Solves L^T x = y for the columns of a supernode, whose entries end at `used`. Blocks and
    /// columns run backwards, so that a row is known before it is used.
    fn backward(&self, s: usize, mut used: usize, local: &mut [Sides]) {
        for (b, columns) in self.blocks(s).enumerate().rev() {
            used -= columns;
            for (k, lanes) in self.entries[used..used + columns].iter().enumerate().rev() {
                let sums = local[b].map(|side| sum(std::array::from_fn(|i| lanes[i] * side[i])));
                let value = get(local, k) - DVec3::from_array(sums);
                put(local, k, value);
            }
        }
    }
}

fn get(local: &[Sides], i: usize) -> DVec3 {
    let lane = i % LANES;
    DVec3::from_array(local[i / LANES].map(|side| side[lane]))
}

fn put(local: &mut [Sides], i: usize, value: DVec3) {
    for (side, value) in local[i / LANES].iter_mut().zip(value.to_array()) {
        side[i % LANES] = value;
    }
}

/// Sums eight numbers pairwise.
fn sum([a, b, c, d, e, f, g, h]: Lanes) -> f64 {
    ((a + e) + (c + g)) + ((b + f) + (d + h))
}

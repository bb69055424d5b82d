//! The search of the index for the nearest point: near children first, and whatever cannot be nearer is dropped.

use super::hunt::Hunt;
use super::leaf::{KEPT, Leaf, decide};
use super::wait::{Waiting, What};
use crate::surface::cells::{BLOCK, Cells};
use crate::surface::index::{Oriented, Pyramid};
use glam::DVec3;

/// A block to be looked at: a lower bound of the square of its distance, in single precision (see [`Sight`]), and where it is.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Entry {
    bound: f32,
    level: u32,
    row: u32,
    column: u32,
}

/// The query as boxes see it, in single precision.
struct Sight {
    /// Relative to the index's origin.
    local: DVec3,
    single: [f32; 3],
    /// How far a bound may be above the distance, by the rounding of the query.
    play: f64,
}

impl Sight {
    fn new(index: &Pyramid, query: DVec3) -> Sight {
        let local = query - index.origin();
        let play = 2.0 * f64::from(f32::EPSILON) * local.abs().max_element();
        Sight { local, single: local.to_array().map(|x| x as f32), play }
    }

    /// What squares of bounds are compared with: greater ones are farther than `limit`. Sums of three squares are right to 2^-22.
    #[inline(always)]
    fn threshold(&self, limit: f64) -> f32 {
        let most = (limit + self.play) * (1.0 + 2e-6);
        (most * most) as f32
    }

    /// The distance that the square of a bound proves.
    fn distance(&self, bound: f32) -> f64 {
        (f64::from(bound).sqrt() * (1.0 - 2e-6) - self.play).max(0.0)
    }
}

/// Looks for a nearer point in a sheet, number `sheet` of its surface; in a long search, what is left of it waits.
pub(super) fn search<const N: usize>(cells: &impl Cells<N>, index: &Pyramid, sheet: u32, hunt: &mut Hunt) {
    let sight = Sight::new(index, hunt.query);
    let levels = index.levels();
    let mut stack = std::mem::take(&mut hunt.stack);
    stack.clear();
    stack.push(Entry { level: levels.len() as u32, ..Entry::default() });
    while let Some(entry) = stack.pop() {
        if entry.bound > sight.threshold(hunt.limit()) {
            continue;
        }
        if hunt.is_long() {
            let Entry { level, row, column, .. } = entry;
            let bound = sight.distance(entry.bound);
            hunt.wait(Waiting { bound, sheet, what: What::Block { level, row, column } });
            continue;
        }
        let (row, column) = (entry.row as usize, entry.column as usize);
        if entry.level == 0 {
            let extent = Leaf { cells, index, row, column }.search(hunt);
            // From afar, what is known of the first ones, the direction above all, rules out most of the others.
            let afar = hunt.direction() == DVec3::ZERO && hunt.limit() > 4.0 * extent;
            if afar || hunt.candidates.len() >= KEPT {
                decide(cells, sheet, hunt);
            }
            continue;
        }
        let level = &levels[entry.level as usize - 1];
        let distances = level.group(row, column).single_distances_squared(sight.single);
        let threshold = sight.threshold(hunt.limit());
        let first = stack.len();
        for (child, &boxed) in distances.iter().enumerate() {
            let (row, column) = (2 * row + child / 2, 2 * column + child % 2);
            if !level.has(row, column) {
                continue;
            }
            let bound = if boxed > threshold {
                boxed
            } else {
                let oriented = |oriented: &Oriented| oriented.distance_squared(sight.local) as f32;
                level.oriented(row, column).map_or(0.0, oriented).max(boxed)
            };
            if bound > threshold {
                continue;
            }
            // Sorted as they come: the nearest is taken first, being last.
            let mut at = stack.len();
            stack.push(Entry { bound, level: entry.level - 1, row: row as u32, column: column as u32 });
            while at > first && stack[at - 1].bound < bound {
                stack.swap(at, at - 1);
                at -= 1;
            }
        }
    }
    hunt.stack = stack;
    decide(cells, sheet, hunt);
}

/// A block of any level, with a lower bound of its distance.
#[derive(Debug, Clone, Copy)]
pub(super) struct Block {
    pub(super) bound: f64,
    pub(super) level: usize,
    pub(super) row: usize,
    pub(super) column: usize,
}

impl Block {
    /// The whole sheet.
    pub(super) fn root(index: &Pyramid) -> Block {
        Block { bound: 0.0, level: index.levels().len(), row: 0, column: 0 }
    }

    /// The blocks that it consists of, with their bounds.
    pub(super) fn children(&self, index: &Pyramid, query: DVec3) -> [Option<Block>; 4] {
        let (level, local) = (&index.levels()[self.level - 1], query - index.origin());
        let distances = level.group(self.row, self.column).distances_squared(local);
        std::array::from_fn(|child| {
            let (row, column) = (2 * self.row + child / 2, 2 * self.column + child % 2);
            let boxed = distances[child];
            let exists = boxed < f64::INFINITY;
            exists.then(|| {
                let oriented = level.oriented(row, column).map_or(0.0, |oriented| oriented.distance_squared(local));
                Block { bound: boxed.max(oriented).sqrt(), level: self.level - 1, row, column }
            })
        })
    }

    /// A cell in the middle.
    pub(super) fn middle<const N: usize>(&self, cells: &impl Cells<N>) -> [usize; 2] {
        let at = |k: usize, count: usize| ((((2 * k + 1) * BLOCK) << self.level) / 2).min(count - 1);
        let [rows, columns] = cells.counts();
        [at(self.row, rows), at(self.column, columns)]
    }

    /// The cells of a block of the lowest level.
    pub(super) fn cells<const N: usize, C: Cells<N>>(
        &self,
        cells: &C,
    ) -> impl Iterator<Item = (usize, usize)> + use<N, C> {
        let [rows, columns] = cells.counts();
        let (top, left) = (self.row * BLOCK, self.column * BLOCK);
        let (bottom, right) = (rows.min(top + BLOCK), columns.min(left + BLOCK));
        (top..bottom).flat_map(move |i| (left..right).map(move |j| (i, j)))
    }
}

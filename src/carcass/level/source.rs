//! Where fields over cells come from, one for each question.

use crate::carcass::axis::{Axis, TAPS};
use crate::carcass::cells::{BLOCK, Cells};
use crate::carcass::solve::Field;
use glam::{DVec2, DVec3};
use std::ops::Range;

/// How the fields of two cells fit along their common side.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Sides {
    /// To the bit.
    Same,
    /// But for rounding.
    Alike,
    /// They may jump.
    Apart,
}

/// A field over each cell, for a number of levels.
pub(super) trait Source<const M: usize>: Sync {
    /// What the cells of a block have in common.
    type Block;
    /// What the levels of a cell have in common.
    type Base;

    /// A block of cells; `None` if no level crosses it.
    fn block(&self, cells: [Range<usize>; 2]) -> Option<Self::Block>;

    /// False if it is plain that no level crosses a cell.
    fn may_cross(&self, _block: &Self::Block, _cell: [usize; 2]) -> bool {
        true
    }

    /// A cell, whether or not a level crosses it.
    fn base(&self, block: &Self::Block, cell: [usize; 2]) -> Self::Base;

    /// The levels that may cross it.
    fn levels(&self, base: &Self::Base) -> Range<usize>;

    /// The field whose zero set is one level's.
    fn field(&self, base: &Self::Base, level: usize) -> Field<M>;

    /// False if an arc of the zero set of a cell's field, three places of which are given, is not of the level; `None` if it is in part only.
    fn keeps(&self, _cell: [usize; 2], _level: usize, _places: impl FnOnce() -> [DVec2; 3]) -> Option<bool> {
        Some(true)
    }

    /// How far the surface over a cell of the block, and the field too, may be from the bilinear ones through the cell's corners.
    fn deviation(&self, _block: &Self::Block) -> f64 {
        f64::INFINITY
    }

    /// How cells fit.
    fn sides(&self) -> Sides;

    /// Values up to that may be 0.
    fn noise(&self, base: &Self::Base) -> f64;
}

/// The levels, which rise, from `low` to `high`, with some play.
#[inline]
pub(super) fn between(levels: &[f64], [low, high]: [f64; 2], play: f64) -> Range<usize> {
    if let &[level] = levels {
        return 0..usize::from(low - play <= level && level <= high + play);
    }
    let first = levels.partition_point(|&level| level < low - play);
    let count = levels[first..].partition_point(|&level| level <= high + play);
    first..first + count
}

/// Nodes in one direction that the cells of a block depend on.
const WINDOW: usize = BLOCK + TAPS - 1;

/// The scalars that the cells of a block depend on, and the weights.
pub(super) struct Window {
    start: [usize; 2],
    values: [[f64; WINDOW]; WINDOW],
    /// Where the first cell's first corner is.
    corner: [usize; 2],
    /// How far the field over a cell may be from the corners' range.
    deviation: f64,
    /// By direction and cell: where its nodes begin.
    first: [[usize; BLOCK]; 2],
    rows: [[[f64; TAPS]; 4]; BLOCK],
    /// By cell, node and coefficient.
    columns: [[[f64; 4]; TAPS]; BLOCK],
}

impl Window {
    fn new(axes: [&Axis; 2], cells: &[Range<usize>; 2], deviation: f64, value: impl Fn(usize, usize) -> f64) -> Self {
        let mut window = Window {
            start: [cells[0].start, cells[1].start],
            values: [[0.0; WINDOW]; WINDOW],
            corner: [0; 2],
            deviation,
            first: [[0; BLOCK]; 2],
            rows: [[[0.0; TAPS]; 4]; BLOCK],
            columns: [[[0.0; 4]; TAPS]; BLOCK],
        };
        let mut lines = [[0; WINDOW]; 2];
        let mut counts = [0; 2];
        for (d, (axis, range)) in axes.into_iter().zip(cells).enumerate() {
            let ([origin, ..], _) = axis.taps(range.start);
            window.corner[d] = if axis.is_closed() { 2 } else { range.start - origin };
            for (k, cell) in range.clone().enumerate() {
                let (taps, weights) = axis.taps(cell);
                let first = if axis.is_closed() { k } else { taps[0] - origin };
                lines[d][first..first + TAPS].copy_from_slice(&taps);
                counts[d] = first + TAPS;
                window.first[d][k] = first;
                if d == 0 {
                    window.rows[k] = *weights;
                } else {
                    window.columns[k] = std::array::from_fn(|node| std::array::from_fn(|b| weights[b][node]));
                }
            }
        }
        for (values, &i) in window.values.iter_mut().zip(&lines[0][..counts[0]]) {
            for (at, &j) in values.iter_mut().zip(&lines[1][..counts[1]]) {
                *at = value(i, j);
            }
        }
        // What is not there repeats what is.
        for values in &mut window.values[..counts[0]] {
            let last = values[counts[1] - 1];
            values[counts[1]..].fill(last);
        }
        let last = window.values[counts[0] - 1];
        window.values[counts[0]..].fill(last);
        window
    }

    /// A range of the field over a cell, from its corners.
    #[inline]
    fn near(&self, [i, j]: [usize; 2]) -> [f64; 2] {
        let (r, c) = (self.corner[0] + i - self.start[0], self.corner[1] + j - self.start[1]);
        let [a, b] = [self.values[r][c], self.values[r][c + 1]];
        let [d, e] = [self.values[r + 1][c], self.values[r + 1][c + 1]];
        [a.min(b).min(d.min(e)) - self.deviation, a.max(b).max(d.max(e)) + self.deviation]
    }

    /// The least and the greatest scalar.
    fn range(&self) -> [f64; 2] {
        let all = self.values.as_flattened();
        all.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], &x| [low.min(x), high.max(x)])
    }

    /// The field over a cell. Along the rows first, then across: the coefficients of a common side have the same bits in both cells.
    #[inline]
    fn field(&self, [i, j]: [usize; 2]) -> Field<4> {
        let (r, c) = (i - self.start[0], j - self.start[1]);
        let (row, column) = (self.first[0][r], self.first[1][c]);
        let mut along = [[0.0; 4]; TAPS];
        for (sums, values) in along.iter_mut().zip(&self.values[row..]) {
            for (weights, value) in self.columns[c].iter().zip(&values[column..]) {
                for (sum, weight) in sums.iter_mut().zip(weights) {
                    *sum += weight * value;
                }
            }
        }
        let mut field = Field { c: [[0.0; 4]; 4] };
        for (sums, weights) in field.c.iter_mut().zip(&self.rows[r]) {
            for (weight, values) in weights.iter().zip(&along) {
                for (sum, value) in sums.iter_mut().zip(values) {
                    *sum += weight * value;
                }
            }
        }
        field
    }
}

/// The same interpolation of scalars as of nodes.
pub(super) struct Nodal<'a, F, D> {
    pub(super) axes: [&'a Axis; 2],
    pub(super) value: F,
    pub(super) levels: &'a [f64],
    pub(super) noise: f64,
    /// How far values of cells may be outside those of their nodes, in parts of the half range: |w| sums to at most 1 + `excess`.
    pub(super) excess: f64,
    /// By the first cell of a block: how far the field over its cells may be from the ranges of their corners.
    pub(super) deviation: D,
}

impl<F, D> Source<4> for Nodal<'_, F, D>
where
    F: Fn(usize, usize) -> f64 + Sync,
    D: Fn(usize, usize) -> f64 + Sync,
{
    type Block = Window;
    type Base = Field<4>;

    #[inline]
    fn block(&self, cells: [Range<usize>; 2]) -> Option<Window> {
        let deviation = (self.deviation)(cells[0].start, cells[1].start);
        let window = Window::new(self.axes, &cells, deviation, &self.value);
        if deviation.is_finite() {
            return Some(window);
        }
        let [low, high] = window.range();
        let play = 0.5 * self.excess * (high - low) + self.noise;
        (!between(self.levels, [low, high], play).is_empty()).then_some(window)
    }

    #[inline]
    fn may_cross(&self, block: &Window, cell: [usize; 2]) -> bool {
        !between(self.levels, block.near(cell), self.noise).is_empty()
    }

    #[inline]
    fn base(&self, block: &Window, cell: [usize; 2]) -> Field<4> {
        block.field(cell)
    }

    #[inline]
    fn levels(&self, base: &Field<4>) -> Range<usize> {
        between(self.levels, base.range(), self.noise)
    }

    #[inline]
    fn field(&self, base: &Field<4>, level: usize) -> Field<4> {
        shifted(base, self.levels[level])
    }

    #[inline]
    fn deviation(&self, block: &Window) -> f64 {
        block.deviation
    }

    fn sides(&self) -> Sides {
        Sides::Same
    }

    fn noise(&self, _: &Self::Base) -> f64 {
        self.noise
    }
}

/// Less a number.
#[inline]
fn shifted<const M: usize>(base: &Field<M>, level: f64) -> Field<M> {
    Field { c: base.c.map(|row| row.map(|x| x - level)) }
}

/// A plane's function on patches.
pub(super) struct Plane<'a, C, const N: usize> {
    pub(super) cells: &'a C,
    pub(super) normal: DVec3,
    pub(super) origin: DVec3,
    pub(super) levels: &'a [f64],
    pub(super) noise: f64,
}

impl<C: Cells<N>, const N: usize> Source<N> for Plane<'_, C, N> {
    type Block = ();
    type Base = Field<N>;

    fn block(&self, _: [Range<usize>; 2]) -> Option<()> {
        Some(())
    }

    fn base(&self, (): &(), [i, j]: [usize; 2]) -> Field<N> {
        let patch = self.cells.patch(i, j);
        Field { c: patch.points.map(|row| row.map(|point| (point - self.origin).dot(self.normal))) }
    }

    fn levels(&self, base: &Field<N>) -> Range<usize> {
        between(self.levels, base.range(), self.noise)
    }

    fn field(&self, base: &Field<N>, level: usize) -> Field<N> {
        shifted(base, self.levels[level])
    }

    fn sides(&self) -> Sides {
        Sides::Apart
    }

    fn noise(&self, _: &Self::Base) -> f64 {
        self.noise
    }
}

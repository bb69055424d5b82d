//! How far the surface through a grid may be from the bilinear patches of its cells, and to which side: from the nodes alone, without
//! building patches.
//!
//! Over a cell S = sum w_k(u) C_k(v), C_k the cubics along six rows; B = (1 - u) L_i(v) + u L_i+1(v), L_k the chord of C_k. So
//! S - B = sum w_k (C_k - L_k) + (sum w_k L_k - B).
//!
//! * C_k - L_k is b_1 d_1 + b_2 d_2: d the inner Bézier points from the thirds of the chord, b two Bernstein polynomials of degree 3, which sum to
//!   3/4 at most. If all d are in a box, it is in 3/4 of the box, joined with 0. The sum of such with sum w_k = 1, sum |w_k| <= L is in that
//!   box grown by (L - 1) / 2 of its size at both ends.
//! * The second term is linear in v, and at the cell's two columns the same of the cubics across the rows.

use super::axis::{Axis, TAPS, Weights};
use super::cells::BLOCK;
use super::grid::Nodes;
use super::index::Bounds;
use crate::simd::{self, Kernel};
use glam::DVec3;
use std::ops::Range;

/// A grid as seen here.
pub(super) struct Displacements<'a> {
    pub(super) nodes: &'a Nodes<'a>,
    pub(super) u: &'a Axis,
    pub(super) v: &'a Axis,
}

/// Weights that give the inner Bézier points from the thirds of the chord.
type Bend = [[f64; TAPS]; 2];

fn bend(weights: &Weights) -> Bend {
    let [start, first, second, end] = weights;
    let mut bend = [[0.0; TAPS]; 2];
    for k in 0..TAPS {
        let third = (end[k] - start[k]) / 3.0;
        bend[0][k] = first[k] - start[k] - third;
        bend[1][k] = second[k] - end[k] + third;
    }
    bend
}

/// Lowers and raises ranges to take in two sums of six lines each, coordinate by coordinate.
struct Widen<'a> {
    bend: Bend,
    lines: [&'a [f64]; TAPS],
    low: &'a mut [f64],
    high: &'a mut [f64],
}

impl Kernel for Widen<'_> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let Widen { bend: [first, second], lines, low, high } = self;
        widen(&first, &second, lines, low, high);
    }
}

#[inline(always)]
fn widen(first: &[f64; TAPS], second: &[f64; TAPS], lines: [&[f64]; TAPS], low: &mut [f64], high: &mut [f64]) {
    let count = low.len();
    let high = &mut high[..count];
    let [a, b, c, d, e, f] = lines.map(|line| &line[..count]);
    for k in 0..count {
        let taps = [a[k], b[k], c[k], d[k], e[k], f[k]];
        let sum = |w: &[f64; TAPS]| {
            ((w[0] * taps[0] + w[1] * taps[1]) + (w[2] * taps[2] + w[3] * taps[3])) + (w[4] * taps[4] + w[5] * taps[5])
        };
        let (x, y) = (sum(first), sum(second));
        let (less, more) = if x < y { (x, y) } else { (y, x) };
        low[k] = if less < low[k] { less } else { low[k] };
        high[k] = if more > high[k] { more } else { high[k] };
    }
}

/// Ranges of coordinates along a row: of cells or of columns.
struct Ranges {
    low: Vec<f64>,
    high: Vec<f64>,
}

impl Ranges {
    fn new(count: usize) -> Ranges {
        Ranges { low: vec![f64::INFINITY; 3 * count], high: vec![f64::NEG_INFINITY; 3 * count] }
    }

    fn clear(&mut self) {
        self.low.fill(f64::INFINITY);
        self.high.fill(f64::NEG_INFINITY);
    }

    /// The box of the ranges of some places.
    #[inline]
    fn over(&self, places: Range<usize>) -> Bounds {
        let mut bounds = Bounds::EMPTY;
        let parts = self.low[3 * places.start..3 * places.end].chunks_exact(3);
        for (low, high) in parts.zip(self.high[3 * places.start..3 * places.end].chunks_exact(3)) {
            bounds.low = bounds.low.min(DVec3::from_slice(low));
            bounds.high = bounds.high.max(DVec3::from_slice(high));
        }
        bounds
    }
}

impl Displacements<'_> {
    /// The boxes of the blocks of some rows of blocks, row after row.
    pub(super) fn of_blocks(&self, block_rows: Range<usize>, boxes: &mut [Bounds]) {
        let (cells, across) = (self.v.cells(), self.v.cells().div_ceil(BLOCK));
        let rows = |r: usize| r * BLOCK..self.u.cells().min((r + 1) * BLOCK);
        // Along each row once, and then for all blocks that depend on it.
        let mut along = vec![Bounds::EMPTY; boxes.len()];
        let mut ranges = Ranges::new(cells);
        let mut line = Vec::new();
        let whole = rows(block_rows.start).start..rows(block_rows.end - 1).end;
        for row in self.u.lines_of(whole) {
            ranges.clear();
            self.along(row, &mut line, &mut ranges);
            let needed: Vec<usize> =
                block_rows.clone().filter(|&r| self.u.lines_of(rows(r)).any(|line| line == row)).collect();
            for c in 0..across {
                let found = ranges.over(c * BLOCK..cells.min((c + 1) * BLOCK));
                for r in &needed {
                    let bounds = &mut along[(r - block_rows.start) * across + c];
                    *bounds = bounds.joined(found);
                }
            }
        }
        let mut columns = Ranges::new(cells + 1);
        for (r, (boxes, along)) in block_rows.zip(boxes.chunks_mut(across).zip(along.chunks(across))) {
            columns.clear();
            for i in rows(r) {
                self.across(i, &mut columns);
            }
            for (c, (bounds, along)) in boxes.iter_mut().zip(along).enumerate() {
                let across = columns.over(c * BLOCK..cells.min((c + 1) * BLOCK) + 1);
                *bounds = grown(along.shrunk(), self.u.lebesgue()).plus(across.shrunk());
            }
        }
    }

    /// Widens the ranges of cells by the cubics along a row.
    fn along(&self, row: usize, line: &mut Vec<f64>, ranges: &mut Ranges) {
        let cells = self.v.cells();
        // All that have the same weights, six nodes from their place on; the row goes on at both ends if it is closed.
        let inner = if self.v.is_closed() { 0..cells } else { 2.min(cells)..cells.saturating_sub(2).max(2.min(cells)) };
        let node = |j: usize| self.nodes.get(row, j).to_array();
        line.clear();
        if self.v.is_closed() {
            (0..cells + TAPS - 1).for_each(|k| line.extend(node((k + 2 * cells - 2) % cells)));
        } else if let Some(packed) = self.nodes.packed_row(row) {
            line.extend_from_slice(packed);
        } else {
            (0..=cells).for_each(|j| line.extend(node(j)));
        }
        for j in (0..inner.start).chain(inner.end..cells) {
            let (columns, weights) = self.v.taps(j);
            let nodes = columns.map(node);
            let (low, high) = (&mut ranges.low[3 * j..3 * j + 3], &mut ranges.high[3 * j..3 * j + 3]);
            let lines: [&[f64]; TAPS] = std::array::from_fn(|k| &nodes[k][..]);
            let [first, second] = bend(weights);
            widen(&first, &second, lines, low, high);
        }
        if !inner.is_empty() {
            let count = 3 * inner.len();
            let lines = std::array::from_fn(|k| &line[3 * k..3 * k + count]);
            let low = &mut ranges.low[3 * inner.start..3 * inner.end];
            let high = &mut ranges.high[3 * inner.start..3 * inner.end];
            simd::run(Widen { bend: bend(self.v.taps(inner.start).1), lines, low, high });
        }
    }

    /// Widens the ranges of columns by the cubics from row i to the next.
    fn across(&self, i: usize, ranges: &mut Ranges) {
        let (rows, weights) = self.u.taps(i);
        let packed = rows.map(|row| self.nodes.packed_row(row));
        if let [Some(a), Some(b), Some(c), Some(d), Some(e), Some(f)] = packed {
            let (low, high) = (&mut ranges.low[..], &mut ranges.high[..]);
            simd::run(Widen { bend: bend(weights), lines: [a, b, c, d, e, f], low, high });
            return;
        }
        let [first, second] = bend(weights);
        for j in 0..self.nodes.columns() {
            let nodes = rows.map(|row| self.nodes.get(row, j).to_array());
            let lines: [&[f64]; TAPS] = std::array::from_fn(|k| &nodes[k][..]);
            let (low, high) = (&mut ranges.low[3 * j..3 * j + 3], &mut ranges.high[3 * j..3 * j + 3]);
            widen(&first, &second, lines, low, high);
        }
    }
}

/// What sums with weights that sum to 1, and whose absolute values sum to `lebesgue` at most, make of a box.
fn grown(bounds: Bounds, lebesgue: f64) -> Bounds {
    let more = 0.5 * (lebesgue - 1.0) * (bounds.high - bounds.low);
    Bounds { low: bounds.low - more, high: bounds.high + more }
}

impl Bounds {
    /// 3/4 of the box, joined with 0.
    fn shrunk(self) -> Bounds {
        Bounds { low: (0.75 * self.low).min(DVec3::ZERO), high: (0.75 * self.high).max(DVec3::ZERO) }
    }
}

//! Tensor-product B-splines.
//!
//! Over each span of knots the spline is a Bézier patch, whose control points are values of the
//! blossom: the symmetric multiaffine function that gives the spline when all its arguments are
//! equal. Point k of the span [a, b] takes p - k arguments a and k arguments b. The same holds of
//! any part [a, b] of a span.

use crate::MAX_DEGREE;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use std::ops::{Add, Mul};

/// One direction of a spline.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SplineAxis<'a> {
    /// The degree, 1 to 7.
    pub degree: usize,
    /// Open: as many as control points and degree and 1, clamped or not; the spline is defined from
    /// knot `degree` to the `degree`-th from the end. Closed: one more than control points, one
    /// period of them; span k, between knots k and k + 1, is made by the control points k - degree
    /// to k, counted round. Not decreasing; inner knots may be repeated `degree` times.
    pub knots: &'a [f64],
    /// The control points, which are not repeated, follow each other round.
    pub closed: bool,
}

/// A spline, rational if it has weights that differ. Cells are its spans, in both directions, that
/// are not empty: knots become whole numbers, in order. Spans of rational splines may be cut into
/// several cells; [`Sheet::knots`](crate::Sheet::knots) has the parameters of their borders.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spline<'a> {
    /// Row by row: rows follow each other in u. Points of space, not multiplied by weights.
    pub points: &'a [DVec3],
    /// The weights of the control points, in the same order; `None` for 1.
    pub weights: Option<&'a [f64]>,
    /// Control points in u and in v.
    pub counts: [usize; 2],
    /// The directions.
    pub axes: [SplineAxis<'a>; 2],
}

/// How rational splines become polynomial patches.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct SplineOptions {
    /// How far the sheet may be from the rational spline at equal parameters, a length; `None`:
    /// 1e-12 of the diagonal of the box of the control points, or what rounding allows.
    pub tolerance: Option<f64>,
    /// The most cells; `None`: 2^20.
    pub max_cells: Option<usize>,
}

/// A part of a span, or all of it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Interval {
    /// The knot that the span begins with.
    pub(super) knot: usize,
    /// The parameters at both ends.
    pub(super) ends: [f64; 2],
}

/// The control points of the Bézier piece over an interval, from the spline's own.
pub(super) struct Piece {
    /// The first control point; `degree` more follow it, round a closed direction.
    pub(super) first: usize,
    /// `weights[k][i]`: what control point `first + i` gives to point k of the piece.
    pub(super) weights: [[f64; MAX_DEGREE + 1]; MAX_DEGREE + 1],
}

/// A net of control points of one piece, as many as its degrees need.
pub(super) type Net<T> = [[T; MAX_DEGREE + 1]; MAX_DEGREE + 1];

impl Spline<'_> {
    /// The pieces over intervals, in u and in v.
    pub(super) fn pieces(&self, intervals: &[Vec<Interval>; 2]) -> Result<[Vec<Piece>; 2]> {
        Ok([self.axes[0].pieces(&intervals[0], self.counts[0])?, self.axes[1].pieces(&intervals[1], self.counts[1])?])
    }

    /// The place among the control points of the one that is a-th in u and b-th in v of a piece's.
    pub(super) fn place(&self, rows: &Piece, columns: &Piece, a: usize, b: usize) -> usize {
        (rows.first + a) % self.counts[0] * self.counts[1] + (columns.first + b) % self.counts[1]
    }

    /// The control points of a piece, of the spline with these control points.
    pub(super) fn net<T: Copy + Default + Add<Output = T> + Mul<f64, Output = T>>(
        &self,
        points: &[T],
        rows: &Piece,
        columns: &Piece,
    ) -> Net<T> {
        let [p, q] = [0, 1].map(|k| self.axes[k].degree);
        // First along the rows, then across them.
        let (mut along, mut net) = (Net::default(), Net::default());
        for (a, row) in along[..=p].iter_mut().enumerate() {
            for (point, weights) in row[..=q].iter_mut().zip(&columns.weights) {
                let terms = (0..=q).map(|b| points[self.place(rows, columns, a, b)] * weights[b]);
                *point = terms.fold(T::default(), |sum, term| sum + term);
            }
        }
        for (row, weights) in net[..=p].iter_mut().zip(&rows.weights) {
            for (b, point) in row[..=q].iter_mut().enumerate() {
                *point = (0..=p).map(|a| along[a][b] * weights[a]).fold(T::default(), |sum, term| sum + term);
            }
        }
        net
    }
}

/// The parameters of the borders of cells.
pub(super) fn knots_of(intervals: &[Vec<Interval>; 2]) -> Result<[Vec<f64>; 2]> {
    let of = |intervals: &[Interval]| {
        let mut knots = alloc::with_capacity(intervals.len() + 1)?;
        knots.extend(intervals.first().map(|first| first.ends[0]));
        knots.extend(intervals.iter().map(|interval| interval.ends[1]));
        Ok(knots)
    };
    Ok([of(&intervals[0])?, of(&intervals[1])?])
}

impl SplineAxis<'_> {
    /// The spans that are not empty. `direction`: 0 or 1, for errors.
    pub(super) fn intervals(&self, count: usize, direction: u32) -> Result<Vec<Interval>> {
        let needed = if self.closed { count + 1 } else { count + self.degree + 1 };
        if self.knots.len() != needed {
            let given = self.knots.len() as u64;
            return Err(Error::WrongKnotCount { direction, given, needed: needed as u64 });
        }
        self.check(count, direction)?;
        let spans = if self.closed { 0..count } else { self.degree..count };
        let ends = |k: usize| [self.knots[k], self.knots[k + 1]];
        let mut intervals = alloc::with_capacity(spans.len())?;
        intervals.extend(spans.map(|knot| Interval { knot, ends: ends(knot) }).filter(|i| i.ends[0] < i.ends[1]));
        Ok(intervals)
    }

    /// The pieces over intervals that follow each other, from the first to the last span.
    fn pieces(&self, intervals: &[Interval], count: usize) -> Result<Vec<Piece>> {
        let mut pieces: Vec<Piece> = alloc::with_capacity(intervals.len())?;
        let mut before = 0;
        for interval in intervals {
            let mut piece = self.piece(interval, count);
            // Pieces share their ends to the bit: what lies before this piece's first point is the
            // last one's last.
            if let Some(last) = pieces.last() {
                piece.weights[0] = self.shared(&last.weights[self.degree], interval.knot - before);
            }
            before = interval.knot;
            pieces.push(piece);
        }
        if let (true, [first, .., last]) = (self.closed, &mut pieces[..]) {
            let passed = (first.first + count - last.first) % count;
            // Of the first control points only those that the last piece has too count.
            for i in 0..=self.degree {
                last.weights[self.degree][i] = if i >= passed { first.weights[0][i - passed] } else { 0.0 };
            }
        }
        Ok(pieces)
    }

    /// The weights of a point by the control points that begin `passed` later.
    fn shared(&self, weights: &[f64; MAX_DEGREE + 1], passed: usize) -> [f64; MAX_DEGREE + 1] {
        std::array::from_fn(|i| if i + passed <= self.degree { weights[i + passed] } else { 0.0 })
    }

    /// Knot k, of a closed direction round and round.
    fn knot(&self, k: isize, count: usize) -> f64 {
        if !self.closed {
            return self.knots[k as usize];
        }
        if k == count as isize {
            return self.knots[count];
        }
        let (rounds, at) = (k.div_euclid(count as isize), k.rem_euclid(count as isize));
        self.knots[at as usize] + rounds as f64 * (self.knots[count] - self.knots[0])
    }

    fn check(&self, count: usize, direction: u32) -> Result<()> {
        let bad = |knot: usize| Err(Error::BadKnot { direction, knot: knot as u32, value: self.knots[knot] });
        for (k, &knot) in self.knots.iter().enumerate() {
            if !knot.is_finite() || (k > 0 && knot < self.knots[k - 1]) {
                return bad(k);
            }
        }
        // The spline must have a range, of finite length, and no knot within it that is repeated
        // more than the degree allows.
        let (from, to) = if self.closed { (0, count) } else { (self.degree, count) };
        let length = self.knots[to] - self.knots[from];
        if !(length > 0.0 && length.is_finite() && (self.knots[self.knots.len() - 1] - self.knots[0]).is_finite()) {
            return bad(to);
        }
        let inner = if self.closed { 0..count } else { from + 1..to };
        for k in inner {
            let (here, far) = (k as isize, (k + self.degree) as isize);
            let (from, to) = (self.knot(here, count), self.knot(far, count));
            let within = self.closed || (from > self.knots[self.degree] && from < self.knots[count]);
            if within && from == to {
                return bad((k + self.degree) % self.knots.len());
            }
        }
        Ok(())
    }

    /// The piece over [a, b]: the blossom at p - i arguments a and i arguments b, as weights. They
    /// are not negative, and right to a few units in the last place each, however small.
    fn piece(&self, interval: &Interval, count: usize) -> Piece {
        let (p, k, [a, b]) = (self.degree, interval.knot, interval.ends);
        let knot = |i: usize| self.knot(k as isize + 1 + i as isize - p as isize, count);
        // The knots round the span that its control points depend on: p before it, itself included,
        // and p after.
        let around: [f64; 2 * MAX_DEGREE] = std::array::from_fn(|i| if i < 2 * p { knot(i) } else { 0.0 });
        let mut weights = [[0.0; MAX_DEGREE + 1]; MAX_DEGREE + 1];
        for (point, weights) in weights[..=p].iter_mut().enumerate() {
            for (i, weight) in weights[..=p].iter_mut().enumerate() {
                let mut values = [0.0; MAX_DEGREE + 1];
                values[i] = 1.0;
                for step in 0..p {
                    let at = if step < p - point { a } else { b };
                    for m in 0..p - step {
                        let (low, high) = (around[m + step], around[m + p]);
                        // The lesser part is exact but for rounding, and so is 1 less it.
                        let (below, above) = ((at - low) / (high - low), (high - at) / (high - low));
                        let (left, right) = if below <= 0.5 { (1.0 - below, below) } else { (above, 1.0 - above) };
                        values[m] = left * values[m] + right * values[m + 1];
                    }
                }
                *weight = values[0];
            }
        }
        let first = if self.closed { (k + count * p - p) % count } else { k - p };
        Piece { first, weights }
    }
}

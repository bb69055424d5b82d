//! Tensor-product B-splines.
//!
//! Over each span of knots, the spline is a Bézier patch. Its control points are values of the
//! blossom: the symmetric multiaffine function that equals the spline if all its arguments are
//! equal. Point k over the span [a, b] has p - k arguments a and k arguments b. The same applies to
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
    /// The knots, not decreasing. Inner knots may be repeated `degree` times.
    ///
    /// In an open direction, their number is the number of control points plus `degree` + 1. They
    /// may be clamped or not. The spline is defined from knot `degree` to the `degree`-th knot from
    /// the end. In a closed direction, their number is the number of control points plus 1, which
    /// is one period. Span k, between knots k and k + 1, depends on the control points k - degree
    /// to k, which wrap around.
    pub knots: &'a [f64],
    /// Whether the direction is closed. The control points wrap around, and are not repeated.
    pub closed: bool,
}

/// A spline, which is rational if its weights differ. Each span that is not empty becomes a cell,
/// so knots become consecutive integers. Spans of rational splines may become several cells;
/// [`Sheet::knots`](crate::Sheet::knots) returns the parameters of their borders.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spline<'a> {
    /// The control points in space, row by row; rows are in order of u. They are not multiplied by
    /// weights.
    pub points: &'a [DVec3],
    /// The weights of the control points, in the same order; `None` for weights 1.
    pub weights: Option<&'a [f64]>,
    /// Numbers of control points in u and in v.
    pub counts: [usize; 2],
    /// The degrees and knots in u and in v.
    pub axes: [SplineAxis<'a>; 2],
}

/// Options for converting rational splines to polynomial patches.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct SplineOptions {
    /// Largest distance between the sheet and the rational spline at equal parameters. `None` means
    /// 1e-12 times the diagonal of the bounding box of the control points, or more if rounding
    /// requires it.
    pub tolerance: Option<f64>,
    /// Largest number of cells. `None` means 2^20.
    pub max_cells: Option<usize>,
}

/// A span, or a part of it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct SplineInterval {
    /// The index of the knot at which the span begins.
    pub(super) knot: usize,
    /// The parameters at both ends.
    pub(super) end_parameters: [f64; 2],
}

/// The control points of the Bézier piece over an interval, as weights of the spline's control
/// points.
pub(super) struct SplinePiece {
    /// The first control point. The next `degree` points follow; they wrap around in a closed
    /// direction.
    pub(super) first_control_point: usize,
    /// `weights[k][i]` is the weight of control point `first + i` in point k of the piece.
    pub(super) weights: [[f64; MAX_DEGREE + 1]; MAX_DEGREE + 1],
}

/// A control net of one piece; degrees determine how much of it is used.
pub(super) type PieceNet<T> = [[T; MAX_DEGREE + 1]; MAX_DEGREE + 1];

impl Spline<'_> {
    /// The pieces over intervals, in u and in v.
    pub(super) fn bezier_pieces_by_direction(
        &self,
        intervals: &[Vec<SplineInterval>; 2],
    ) -> Result<[Vec<SplinePiece>; 2]> {
        Ok([
            self.axes[0].bezier_pieces(&intervals[0], self.counts[0])?,
            self.axes[1].bezier_pieces(&intervals[1], self.counts[1])?,
        ])
    }

    /// The index, among the spline's control points, of point (a, b) of a piece's control net.
    pub(super) fn control_point_index(&self, rows: &SplinePiece, columns: &SplinePiece, a: usize, b: usize) -> usize {
        (rows.first_control_point + a) % self.counts[0] * self.counts[1]
            + (columns.first_control_point + b) % self.counts[1]
    }

    /// The control net of a piece, from control points of the spline in any representation.
    pub(super) fn piece_control_net<T: Copy + Default + Add<Output = T> + Mul<f64, Output = T>>(
        &self,
        points: &[T],
        rows: &SplinePiece,
        columns: &SplinePiece,
    ) -> PieceNet<T> {
        let [p, q] = [0, 1].map(|k| self.axes[k].degree);
        // First along the rows, then across them.
        let (mut along, mut net) = (PieceNet::default(), PieceNet::default());
        for (a, row) in along[..=p].iter_mut().enumerate() {
            for (point, weights) in row[..=q].iter_mut().zip(&columns.weights) {
                let terms = (0..=q).map(|b| points[self.control_point_index(rows, columns, a, b)] * weights[b]);
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
pub(super) fn knots_at_cell_borders(intervals: &[Vec<SplineInterval>; 2]) -> Result<[Vec<f64>; 2]> {
    let of = |intervals: &[SplineInterval]| {
        let mut knots = alloc::with_capacity(intervals.len() + 1)?;
        knots.extend(intervals.first().map(|first| first.end_parameters[0]));
        knots.extend(intervals.iter().map(|interval| interval.end_parameters[1]));
        Ok(knots)
    };
    Ok([of(&intervals[0])?, of(&intervals[1])?])
}

impl SplineAxis<'_> {
    /// The spans that are not empty. `direction` is 0 or 1, for errors.
    pub(super) fn nonempty_spans(&self, count: usize, direction: u32) -> Result<Vec<SplineInterval>> {
        let needed = if self.closed { count + 1 } else { count + self.degree + 1 };
        if self.knots.len() != needed {
            let given = self.knots.len() as u64;
            return Err(Error::WrongKnotCount { direction, given, needed: needed as u64 });
        }
        self.check_knots(count, direction)?;
        let spans = if self.closed { 0..count } else { self.degree..count };
        let ends = |k: usize| [self.knots[k], self.knots[k + 1]];
        let mut intervals = alloc::with_capacity(spans.len())?;
        intervals.extend(
            spans
                .map(|knot| SplineInterval { knot, end_parameters: ends(knot) })
                .filter(|i| i.end_parameters[0] < i.end_parameters[1]),
        );
        Ok(intervals)
    }

    /// The pieces over successive intervals, from the first to the last span.
    fn bezier_pieces(&self, intervals: &[SplineInterval], count: usize) -> Result<Vec<SplinePiece>> {
        let mut pieces: Vec<SplinePiece> = alloc::with_capacity(intervals.len())?;
        let mut before = 0;
        for interval in intervals {
            let mut piece = self.bezier_piece(interval, count);
            // Neighbouring pieces share their ends exactly: the first point of this piece is the
            // last point of the previous one.
            if let Some(last) = pieces.last() {
                piece.weights[0] = self.reindexed_weights(&last.weights[self.degree], interval.knot - before);
            }
            before = interval.knot;
            pieces.push(piece);
        }
        if let (true, [first, .., last]) = (self.closed, &mut pieces[..]) {
            let passed = (first.first_control_point + count - last.first_control_point) % count;
            // Only control points that both the first and the last piece depend on have a weight.
            for i in 0..=self.degree {
                last.weights[self.degree][i] = if i >= passed { first.weights[0][i - passed] } else { 0.0 };
            }
        }
        Ok(pieces)
    }

    /// Re-indexes the weights of a point for a list of control points that begins `passed` later.
    fn reindexed_weights(&self, weights: &[f64; MAX_DEGREE + 1], passed: usize) -> [f64; MAX_DEGREE + 1] {
        std::array::from_fn(|i| if i + passed <= self.degree { weights[i + passed] } else { 0.0 })
    }

    /// Knot k. In a closed direction, knots continue periodically.
    fn periodic_knot(&self, k: isize, count: usize) -> f64 {
        if !self.closed {
            return self.knots[k as usize];
        }
        if k == count as isize {
            return self.knots[count];
        }
        let (rounds, at) = (k.div_euclid(count as isize), k.rem_euclid(count as isize));
        self.knots[at as usize] + rounds as f64 * (self.knots[count] - self.knots[0])
    }

    fn check_knots(&self, count: usize, direction: u32) -> Result<()> {
        let bad = |knot: usize| Err(Error::BadKnot { direction, knot: knot as u32, value: self.knots[knot] });
        for (k, &knot) in self.knots.iter().enumerate() {
            if !knot.is_finite() || (k > 0 && knot < self.knots[k - 1]) {
                return bad(k);
            }
        }
        // The spline must have a range of positive finite length. Inner knots must not be repeated
        // more often than the degree allows.
        let (from, to) = if self.closed { (0, count) } else { (self.degree, count) };
        let length = self.knots[to] - self.knots[from];
        if !(length > 0.0 && length.is_finite() && (self.knots[self.knots.len() - 1] - self.knots[0]).is_finite()) {
            return bad(to);
        }
        let inner = if self.closed { 0..count } else { from + 1..to };
        for k in inner {
            let (here, far) = (k as isize, (k + self.degree) as isize);
            let (from, to) = (self.periodic_knot(here, count), self.periodic_knot(far, count));
            let within = self.closed || (from > self.knots[self.degree] && from < self.knots[count]);
            if within && from == to {
                return bad((k + self.degree) % self.knots.len());
            }
        }
        Ok(())
    }

    /// The piece over [a, b]: the blossom at p - i arguments a and i arguments b, as weights.
    /// Weights are not negative, and each is accurate to a few units in the last place, however
    /// small.
    fn bezier_piece(&self, interval: &SplineInterval, count: usize) -> SplinePiece {
        let (p, k, [a, b]) = (self.degree, interval.knot, interval.end_parameters);
        let knot = |i: usize| self.periodic_knot(k as isize + 1 + i as isize - p as isize, count);
        // The 2 p knots around the span that its control points depend on: p up to its start, and p
        // after it.
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
                        // The smaller part is exact within rounding, and so is 1 minus it.
                        let (below, above) = ((at - low) / (high - low), (high - at) / (high - low));
                        let (left, right) = if below <= 0.5 { (1.0 - below, below) } else { (above, 1.0 - above) };
                        values[m] = left * values[m] + right * values[m + 1];
                    }
                }
                *weight = values[0];
            }
        }
        let first = if self.closed { (k + count * p - p) % count } else { k - p };
        SplinePiece { first_control_point: first, weights }
    }
}

//! Tensor-product B-splines.
//!
//! Over each span of knots the spline is a Bézier patch, whose control points are values of the
//! blossom: the symmetric multiaffine function that gives the spline when all its arguments are
//! equal. Point k of the span [a, b] takes p - k arguments a and k arguments b.

use crate::surface::checks::finite_points;
use crate::surface::prelude::*;
use crate::surface::{MAX_DEGREE, MAX_NODES, Patch, Patches, Sheet};

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

/// A spline. Cells are its spans, in both directions, that are not empty: knots become whole
/// numbers, in order.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spline<'a> {
    /// Row by row: rows follow each other in u.
    pub points: &'a [DVec3],
    /// Control points in u and in v.
    pub counts: [usize; 2],
    /// The directions.
    pub axes: [SplineAxis<'a>; 2],
}

/// The control points of the Bézier piece over one span, from the spline's own.
struct Span {
    /// The first control point; `degree` more follow it, round a closed direction.
    first: usize,
    /// `weights[k][i]`: what control point `first + i` gives to point k of the piece.
    weights: [[f64; MAX_DEGREE + 1]; MAX_DEGREE + 1],
}

impl Sheet<'static> {
    /// The Bézier patches of a spline: exact but for rounding, of the greater of the two degrees or
    /// 3.
    ///
    /// O(spans x degree^3); 384 bytes a cell up to degree 3, else 1536.
    ///
    /// # Errors
    /// [`Error::OptionOutOfRange`] for a degree of 0 or above 7; [`Error::NetTooSmall`] for fewer
    /// control points than degree + 1; [`Error::WrongKnotCount`]; [`Error::BadKnot`] with the first
    /// knot that is not finite, that is less than the one before, or that is repeated too often;
    /// [`Error::ArrayTooShort`], [`Error::TooLarge`], [`Error::NotFinite`] with the control point,
    /// [`Error::OutOfMemory`], [`Error::Cancelled`].
    pub fn from_spline(spline: &Spline<'_>, job: &Job<'_>) -> Result<Self> {
        let [rows, columns] = spline.counts;
        for (axis, count) in spline.axes.iter().zip(spline.counts) {
            Error::require((1..=MAX_DEGREE).contains(&axis.degree), "degree", axis.degree as f64)?;
            if count <= axis.degree || (axis.closed && count < 3) {
                return Err(Error::NetTooSmall { rows: rows as u64, columns: columns as u64 });
            }
        }
        let count = (rows as u64).saturating_mul(columns as u64);
        Error::check_count("control points", count, MAX_NODES)?;
        finite_points(spline.points, count, "control points")?;
        let [u, v] = [spline.axes[0].spans(rows, 0)?, spline.axes[1].spans(columns, 1)?];
        if spline.axes.iter().all(|axis| axis.degree <= 3) {
            Ok(Sheet::Cubic(spline.patches(&u, &v, job)?))
        } else {
            Ok(Sheet::High(spline.patches(&u, &v, job)?))
        }
    }
}

impl Spline<'_> {
    fn patches<const N: usize>(&self, u: &[Span], v: &[Span], job: &Job<'_>) -> Result<Patches<N>> {
        let [p, q] = [0, 1].map(|k| self.axes[k].degree);
        let mut patches = alloc::with_capacity(u.len().saturating_mul(v.len()))?;
        for (i, rows) in u.iter().enumerate() {
            job.step(i as f64 / u.len() as f64, "making patches")?;
            for columns in v {
                let mut net = [DVec3::ZERO; (MAX_DEGREE + 1) * (MAX_DEGREE + 1)];
                let control = |a: usize, b: usize| {
                    let (i, j) = ((rows.first + a) % self.counts[0], (columns.first + b) % self.counts[1]);
                    self.points[i * self.counts[1] + j]
                };
                // First along the rows, then across them.
                let mut along = [[DVec3::ZERO; MAX_DEGREE + 1]; MAX_DEGREE + 1];
                for (a, row) in along[..=p].iter_mut().enumerate() {
                    for (point, weights) in row[..=q].iter_mut().zip(&columns.weights) {
                        *point = (0..=q).map(|b| weights[b] * control(a, b)).sum();
                    }
                }
                for (k, point) in net[..(p + 1) * (q + 1)].iter_mut().enumerate() {
                    let weights = &rows.weights[k / (q + 1)];
                    *point = (0..=p).map(|a| weights[a] * along[a][k % (q + 1)]).sum();
                }
                patches.push(Patch::raised(&net[..(p + 1) * (q + 1)], [p, q]));
            }
        }
        Ok(Patches::of(patches, u.len(), v.len()))
    }
}

impl SplineAxis<'_> {
    /// The spans that are not empty. `direction`: 0 or 1, for errors.
    fn spans(&self, count: usize, direction: u32) -> Result<Vec<Span>> {
        let needed = if self.closed { count + 1 } else { count + self.degree + 1 };
        if self.knots.len() != needed {
            let given = self.knots.len() as u64;
            return Err(Error::WrongKnotCount { direction, given, needed: needed as u64 });
        }
        self.check(count, direction)?;
        let knots = if self.closed { 0..count } else { self.degree..count };
        let mut spans: Vec<Span> = alloc::with_capacity(knots.len())?;
        let mut before = 0;
        for k in knots.filter(|&k| self.knots[k] < self.knots[k + 1]) {
            let mut span = self.span(k, count);
            // Pieces share their ends to the bit: what lies before this piece's first point is the
            // last one's last.
            if let Some(last) = spans.last() {
                span.weights[0] = self.shared(&last.weights[self.degree], k - before);
            }
            before = k;
            spans.push(span);
        }
        if let (true, [first, .., last]) = (self.closed, &mut spans[..]) {
            let passed = (first.first + count - last.first) % count;
            // Of the first control points only those that the last piece has too count.
            for i in 0..=self.degree {
                last.weights[self.degree][i] = if i >= passed { first.weights[0][i - passed] } else { 0.0 };
            }
        }
        Ok(spans)
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

    /// The piece over the span from knot k to the next: the blossom at p - i arguments a and i
    /// arguments b, as weights.
    fn span(&self, k: usize, count: usize) -> Span {
        let p = self.degree;
        let knot = |i: usize| self.knot(k as isize + 1 + i as isize - p as isize, count);
        // The knots round the span that its control points depend on: p before it, itself included,
        // and p after.
        let around: [f64; 2 * MAX_DEGREE] = std::array::from_fn(|i| if i < 2 * p { knot(i) } else { 0.0 });
        let (a, b) = (around[p - 1], around[p]);
        let mut weights = [[0.0; MAX_DEGREE + 1]; MAX_DEGREE + 1];
        for (point, weights) in weights[..=p].iter_mut().enumerate() {
            for (i, weight) in weights[..=p].iter_mut().enumerate() {
                let mut values = [0.0; MAX_DEGREE + 1];
                values[i] = 1.0;
                for step in 0..p {
                    let at = if step < p - point { a } else { b };
                    for m in 0..p - step {
                        let (low, high) = (around[m + step], around[m + p]);
                        let t = (at - low) / (high - low);
                        values[m] = (1.0 - t) * values[m] + t * values[m + 1];
                    }
                }
                *weight = values[0];
            }
        }
        let first = if self.closed { (k + count * p - p) % count } else { k - p };
        Span { first, weights }
    }
}

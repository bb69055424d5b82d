//! One direction of a grid: the cubic over each interval as sums of six nodes.
//!
//! Hermite cubics with slopes by finite differences of fourth order, one-sided at open ends, or the
//! paper's cubics through four nodes (study, 3.1). Weights are stored once for each place of an
//! interval among its nodes; they sum to 1, and [`Axis::lebesgue`] bounds the sum of their absolute
//! values, which all bounds of the index rest on.

use gusset_base::choices;
use gusset_base::error::{Error, Result};
use std::ops::Range;

/// Nodes that a cubic may depend on.
pub(crate) const TAPS: usize = 6;

/// How cubics are drawn through nodes that are one apart in the parameter.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum Scheme {
    /// Cubic Hermite with slopes from five nodes: continuous tangents, fourth order with the
    /// constant 1/384, and third order in the slopes. Slopes near an open end are taken from the
    /// five nodes there.
    #[default]
    SixTap,
    /// The cubic through the four nodes round the interval, as the paper has it ("crossings with
    /// the neighbouring curves"): continuous, fourth order with the constant 3/128; tangents jump
    /// at nodes.
    FourPoint,
}

choices! { for Scheme:
    SixTap => "Smooth", "Bicubic patches from 6 x 6 vertices each, with continuous tangents.";
    FourPoint => "Four points", "Bicubic patches through 4 x 4 vertices each, with discontinuous tangents.";
}

/// The weights that make the four Bézier points of an interval from the nodes round it.
pub(crate) type Weights = [[f64; TAPS]; 4];

/// One direction of a grid.
#[derive(Debug, Clone)]
pub(crate) struct Axis {
    /// Lines of nodes, the repeated one of a closed direction included.
    lines: usize,
    closed: bool,
    scheme: Scheme,
    /// By the place of the interval among the nodes that it depends on.
    weights: Box<[Weights; TAPS - 1]>,
    lebesgue: f64,
    outside: f64,
}

impl Axis {
    /// Lines that a direction needs: two, or if it is closed three and the first one again.
    pub(crate) const fn least_lines(closed: bool) -> usize {
        if closed { 4 } else { 2 }
    }

    /// `lines`: at least [`Axis::least_lines`]; of a closed direction the last one is the first one
    /// again.
    pub(crate) fn new(lines: usize, closed: bool, scheme: Scheme) -> Self {
        let mut axis = Axis {
            lines,
            closed,
            scheme,
            weights: Box::new([[[0.0; TAPS]; 4]; TAPS - 1]),
            lebesgue: 1.0,
            outside: 0.0,
        };
        if closed {
            // All intervals are like those in the middle of a long row.
            let slopes = if lines > 5 { 5 } else { 3 };
            axis.weights[2] = weights(2, TAPS, slopes, 4, scheme);
        } else {
            let nodes = lines.min(TAPS);
            for place in 0..nodes - 1 {
                axis.weights[place] = weights(place, nodes, nodes.min(5), nodes.min(4), scheme);
            }
        }
        axis.lebesgue = axis.weights.iter().map(|of| most(of, |_| true)).fold(1.0, f64::max);
        let others = |(place, of)| most(of, |node| node != place && node != place + 1);
        axis.outside = axis.weights.iter().enumerate().map(others).fold(0.0, f64::max);
        axis
    }

    /// The directions of rows and of columns of nodes.
    ///
    /// # Errors
    /// [`Error::NetTooSmall`] below [`Axis::least_lines`].
    pub(crate) fn pair([rows, columns]: [usize; 2], closed: [bool; 2], scheme: Scheme) -> Result<[Axis; 2]> {
        if rows < Axis::least_lines(closed[0]) || columns < Axis::least_lines(closed[1]) {
            return Err(Error::NetTooSmall { rows: rows as u64, columns: columns as u64 });
        }
        Ok([Axis::new(rows, closed[0], scheme), Axis::new(columns, closed[1], scheme)])
    }

    /// The number of intervals.
    pub(crate) fn cells(&self) -> usize {
        self.lines - 1
    }

    /// True if the last line is the first one again.
    pub(crate) fn is_closed(&self) -> bool {
        self.closed
    }

    /// True if the surface goes on with continuous tangents at both ends of interval `cell`.
    pub(crate) fn is_smooth_around(&self, cell: usize) -> bool {
        self.is_smooth() && (self.closed || (cell > 0 && cell + 1 < self.cells()))
    }

    /// The lines that interval `cell` depends on, and their weights; lines of weight 0 may repeat
    /// others.
    pub(crate) fn taps(&self, cell: usize) -> ([usize; TAPS], &Weights) {
        let mut lines = [0; TAPS];
        if self.closed {
            let distinct = self.lines - 1;
            let mut next = if cell < 2 { cell + distinct - 2 } else { cell - 2 };
            for line in &mut lines {
                *line = next;
                next = if next + 1 == distinct { 0 } else { next + 1 };
            }
            return (lines, &self.weights[2]);
        }
        let first = cell.saturating_sub(2).min(self.lines.saturating_sub(TAPS));
        for (k, line) in lines.iter_mut().enumerate() {
            *line = (first + k).min(self.lines - 1);
        }
        (lines, &self.weights[cell - first])
    }

    /// Where interval `cell` is among the nodes that it depends on.
    pub(crate) fn place(&self, cell: usize) -> usize {
        let first = cell.saturating_sub(2).min(self.lines.saturating_sub(TAPS));
        if self.closed { 2 } else { cell - first }
    }

    /// The weights of intervals that are at `place` among their nodes; `None` if there are no such.
    pub(crate) fn weights_at(&self, place: usize) -> Option<&Weights> {
        let exists = if self.closed { place == 2 } else { place + 1 < self.lines.min(TAPS) };
        exists.then(|| &self.weights[place])
    }

    /// The weights that make the slope at a line from the lines that they are of.
    pub(crate) fn slope(&self, line: usize) -> ([usize; TAPS], [f64; TAPS]) {
        let cell = if self.closed { line % self.cells() } else { line.min(self.cells() - 1) };
        let (lines, points) = self.taps(cell);
        let first = if cell == line || self.closed { 0 } else { 2 };
        (lines, std::array::from_fn(|k| 3.0 * (points[first + 1][k] - points[first][k])))
    }

    /// True if the slopes of neighbouring intervals agree at their common node.
    pub(crate) fn is_smooth(&self) -> bool {
        self.scheme == Scheme::SixTap
    }

    /// All lines that a range of intervals depends on, each once.
    pub(crate) fn lines_of(&self, cells: Range<usize>) -> impl Iterator<Item = usize> {
        let (before, count) = if self.closed {
            let distinct = self.lines - 1;
            (cells.start + 2 * distinct - 2, (cells.len() + TAPS - 1).min(distinct))
        } else {
            let first = cells.start.saturating_sub(2).min(self.lines.saturating_sub(TAPS));
            let end = (cells.end + TAPS - 3).max(first + TAPS).min(self.lines);
            (first, end - first)
        };
        let modulus = if self.closed { self.lines - 1 } else { usize::MAX };
        (before..before + count).map(move |line| line % modulus)
    }

    /// The largest sum of the absolute values of the weights that an interval gives its nodes.
    pub(crate) fn lebesgue(&self) -> f64 {
        self.lebesgue
    }

    /// The largest sum of the absolute values of those that it gives to others than the two at its
    /// ends.
    pub(crate) fn outside(&self) -> f64 {
        self.outside
    }
}

/// The largest sum over some nodes of |w_k(t)|, 0 <= t <= 1, rounded up: over the sixteenths of the
/// interval, each piece bounded by its Bézier points.
fn most(weights: &Weights, of: impl Fn(usize) -> bool) -> f64 {
    let mut worst = 0.0_f64;
    for piece in 0..16 {
        let (from, to) = (f64::from(piece) / 16.0, f64::from(piece + 1) / 16.0);
        let sum: f64 = (0..TAPS)
            .filter(|&k| of(k))
            .map(|k| {
                let points = [0, 1, 2, 3].map(|b| weights[b][k]);
                let blossom = |s: f64, t: f64, r: f64| {
                    let mix = |x: f64, y: f64, at: f64| x + (y - x) * at;
                    let [a, b, c] = [0, 1, 2].map(|k| mix(points[k], points[k + 1], s));
                    mix(mix(a, b, t), mix(b, c, t), r)
                };
                let inner = [(from, from, from), (from, from, to), (from, to, to), (to, to, to)];
                inner.map(|(s, t, r)| blossom(s, t, r).abs()).into_iter().fold(0.0, f64::max)
            })
            .sum();
        worst = worst.max(sum);
    }
    worst * (1.0 + 1e-12)
}

/// The weights of the interval from node `place` to `place + 1` of `nodes` nodes in a row: slopes
/// from `five` nodes each, or the cubic through `four`, or as many as there are.
fn weights(place: usize, nodes: usize, five: usize, four: usize, scheme: Scheme) -> Weights {
    // The slope at node `at` of the polynomial through the nodes from `first` on.
    let slope = |at: usize, first: usize, count: usize| {
        let mut slope = [0.0; TAPS];
        let (by, rows) = differences(count);
        slope[first..].iter_mut().zip(rows[at - first]).for_each(|(slope, weight)| *slope = weight / by);
        slope
    };
    let (start, end) = match scheme {
        Scheme::SixTap => {
            // As far in the middle of its nodes as the ends allow.
            let central = |at: usize| slope(at, at.saturating_sub(five / 2).min(nodes - five), five);
            (central(place), central(place + 1))
        }
        Scheme::FourPoint => {
            let first = place.saturating_sub(1).min(nodes - four);
            (slope(place, first, four), slope(place + 1, first, four))
        }
    };
    // Bézier points of a cubic Hermite: P0, P0 + S0 / 3, P1 - S1 / 3, P1.
    let mut points = [[0.0; TAPS]; 4];
    (points[0][place], points[1][place]) = (1.0, 1.0);
    (points[2][place + 1], points[3][place + 1]) = (1.0, 1.0);
    for k in 0..TAPS {
        points[1][k] += start[k] / 3.0;
        points[2][k] -= end[k] / 3.0;
    }
    points
}

/// Row k: the slope at node k of the polynomial through `count` nodes, times the number that is
/// given with the rows.
fn differences(count: usize) -> (f64, &'static [&'static [f64]]) {
    match count {
        2 => (1.0, &[&[-1.0, 1.0], &[-1.0, 1.0]]),
        3 => (2.0, &[&[-3.0, 4.0, -1.0], &[-1.0, 0.0, 1.0], &[1.0, -4.0, 3.0]]),
        4 => (
            6.0,
            &[&[-11.0, 18.0, -9.0, 2.0], &[-2.0, -3.0, 6.0, -1.0], &[1.0, -6.0, 3.0, 2.0], &[-2.0, 9.0, -18.0, 11.0]],
        ),
        _ => (
            12.0,
            &[
                &[-25.0, 48.0, -36.0, 16.0, -3.0],
                &[-3.0, -10.0, 18.0, -6.0, 1.0],
                &[1.0, -8.0, 0.0, 8.0, -1.0],
                &[-1.0, 6.0, -18.0, 10.0, 3.0],
                &[3.0, -16.0, 36.0, -48.0, 25.0],
            ],
        ),
    }
}

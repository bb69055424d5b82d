//! One direction of a grid: the cubic over each interval as weighted sums of six nodes.
//!
//! The cubics are Hermite cubics whose slopes are finite differences of fourth order, one-sided at
//! open ends; or the paper's cubics through four nodes (study, 3.1). Weights are stored once for
//! each position of an interval among its nodes, and sum to 1. [`GridAxis::lebesgue_constant`] bounds the
//! sum of their absolute values. All bounds of the index use it.

use gusset_base::choices;
use gusset_base::error::{Error, Result};
use std::ops::Range;

/// Number of nodes that a cubic may depend on.
pub(crate) const NODES_PER_CUBIC: usize = 6;

/// How a cubic interpolates nodes whose parameters are one apart.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum Scheme {
    /// Cubic Hermite with slopes from five nodes. Tangents are continuous; the surface has fourth
    /// order with the constant 1/384, and the slopes have third order. Slopes near an open end use
    /// the five nodes at that end.
    #[default]
    SixTap,
    /// The cubic through the four nodes around the interval, as in the paper ("crossings with the
    /// neighbouring curves"). It is continuous and of fourth order with the constant 3/128, but
    /// tangents jump at nodes.
    FourPoint,
}

choices! { for Scheme:
    SixTap => "Smooth", "Bicubic patches from 6 x 6 vertices each, with continuous tangents.";
    FourPoint => "Four points", "Bicubic patches through 4 x 4 vertices each, with discontinuous tangents.";
}

/// Weights that compute the four Bézier points of an interval from the nodes around it.
pub(crate) type BezierWeights = [[f64; NODES_PER_CUBIC]; 4];

/// One direction of a grid.
#[derive(Debug, Clone)]
pub(crate) struct GridAxis {
    /// Number of lines of nodes, including the repeated line of a closed direction.
    line_count: usize,
    closed: bool,
    scheme: Scheme,
    /// Indexed by the position of the interval among the nodes that it depends on.
    weights: Box<[BezierWeights; NODES_PER_CUBIC - 1]>,
    lebesgue_constant: f64,
    max_sum_without_end_nodes: f64,
}

impl GridAxis {
    /// The smallest number of lines in a direction: two, or four if it is closed (three and the
    /// repeated one).
    pub(crate) const fn min_line_count(closed: bool) -> usize {
        if closed { 4 } else { 2 }
    }

    /// Creates an axis of at least [`GridAxis::min_line_count`] lines. In a closed direction the last line repeats
    /// the first one.
    pub(crate) fn new(line_count: usize, closed: bool, scheme: Scheme) -> Self {
        let mut axis = GridAxis {
            line_count,
            closed,
            scheme,
            weights: Box::new([[[0.0; NODES_PER_CUBIC]; 4]; NODES_PER_CUBIC - 1]),
            lebesgue_constant: 1.0,
            max_sum_without_end_nodes: 0.0,
        };
        if closed {
            // Every interval has the weights of an interval in the middle of a long row.
            let slopes = if line_count > 5 { 5 } else { 3 };
            axis.weights[2] = interval_weights(2, NODES_PER_CUBIC, slopes, 4, scheme);
        } else {
            let nodes = line_count.min(NODES_PER_CUBIC);
            for place in 0..nodes - 1 {
                axis.weights[place] = interval_weights(place, nodes, nodes.min(5), nodes.min(4), scheme);
            }
        }
        axis.lebesgue_constant =
            axis.weights.iter().map(|of| max_absolute_weight_sum(of, |_| true)).fold(1.0, f64::max);
        let others = |(place, of)| max_absolute_weight_sum(of, |node| node != place && node != place + 1);
        axis.max_sum_without_end_nodes = axis.weights.iter().enumerate().map(others).fold(0.0, f64::max);
        axis
    }

    /// The axes in the directions of rows and of columns of nodes.
    ///
    /// # Errors
    /// [`Error::NetTooSmall`] below [`GridAxis::min_line_count`].
    pub(crate) fn new_pair([rows, columns]: [usize; 2], closed: [bool; 2], scheme: Scheme) -> Result<[GridAxis; 2]> {
        if rows < GridAxis::min_line_count(closed[0]) || columns < GridAxis::min_line_count(closed[1]) {
            return Err(Error::NetTooSmall { rows: rows as u64, columns: columns as u64 });
        }
        Ok([GridAxis::new(rows, closed[0], scheme), GridAxis::new(columns, closed[1], scheme)])
    }

    /// The number of intervals.
    pub(crate) fn interval_count(&self) -> usize {
        self.line_count - 1
    }

    /// True if the direction is closed: the last line repeats the first one.
    pub(crate) fn is_closed(&self) -> bool {
        self.closed
    }

    /// True if tangents are continuous at both ends of interval `cell`.
    pub(crate) fn is_interval_smooth_at_ends(&self, cell: usize) -> bool {
        self.has_continuous_slopes() && (self.closed || (cell > 0 && cell + 1 < self.interval_count()))
    }

    /// The lines that interval `cell` depends on, and their weights. Lines of weight 0 may repeat
    /// other lines.
    pub(crate) fn nodes_and_weights(&self, cell: usize) -> ([usize; NODES_PER_CUBIC], &BezierWeights) {
        let mut lines = [0; NODES_PER_CUBIC];
        if self.closed {
            let distinct = self.line_count - 1;
            let mut next = if cell < 2 { cell + distinct - 2 } else { cell - 2 };
            for line in &mut lines {
                *line = next;
                next = if next + 1 == distinct { 0 } else { next + 1 };
            }
            return (lines, &self.weights[2]);
        }
        let first = cell.saturating_sub(2).min(self.line_count.saturating_sub(NODES_PER_CUBIC));
        for (k, line) in lines.iter_mut().enumerate() {
            *line = (first + k).min(self.line_count - 1);
        }
        (lines, &self.weights[cell - first])
    }

    /// The position of interval `cell` among the nodes that it depends on.
    pub(crate) fn index_of_interval_among_its_nodes(&self, cell: usize) -> usize {
        let first = cell.saturating_sub(2).min(self.line_count.saturating_sub(NODES_PER_CUBIC));
        if self.closed { 2 } else { cell - first }
    }

    /// The weights of intervals at `position` among their nodes; `None` if no interval has
    /// this position.
    pub(crate) fn weights_of_interval_at_index(&self, position: usize) -> Option<&BezierWeights> {
        let exists = if self.closed { position == 2 } else { position + 1 < self.line_count.min(NODES_PER_CUBIC) };
        exists.then(|| &self.weights[position])
    }

    /// The lines that the slope at a line depends on, and their weights.
    pub(crate) fn slope_nodes_and_weights(&self, line: usize) -> ([usize; NODES_PER_CUBIC], [f64; NODES_PER_CUBIC]) {
        let cell = if self.closed { line % self.interval_count() } else { line.min(self.interval_count() - 1) };
        let (lines, points) = self.nodes_and_weights(cell);
        let first = if cell == line || self.closed { 0 } else { 2 };
        (lines, std::array::from_fn(|k| 3.0 * (points[first + 1][k] - points[first][k])))
    }

    /// True if the slopes of neighbouring intervals agree at their common node.
    pub(crate) fn has_continuous_slopes(&self) -> bool {
        self.scheme == Scheme::SixTap
    }

    /// All lines that a range of intervals depends on, each line once.
    pub(crate) fn lines_of_cells(&self, cells: Range<usize>) -> impl Iterator<Item = usize> {
        let (before, count) = if self.closed {
            let distinct = self.line_count - 1;
            (cells.start + 2 * distinct - 2, (cells.len() + NODES_PER_CUBIC - 1).min(distinct))
        } else {
            let first = cells.start.saturating_sub(2).min(self.line_count.saturating_sub(NODES_PER_CUBIC));
            let end = (cells.end + NODES_PER_CUBIC - 3).max(first + NODES_PER_CUBIC).min(self.line_count);
            (first, end - first)
        };
        let modulus = if self.closed { self.line_count - 1 } else { usize::MAX };
        (before..before + count).map(move |line| line % modulus)
    }

    /// The largest sum of the absolute weights of an interval's nodes.
    pub(crate) fn lebesgue_constant(&self) -> f64 {
        self.lebesgue_constant
    }

    /// The largest sum of the absolute weights of an interval's nodes, without the two at its ends.
    pub(crate) fn max_weight_sum_without_end_nodes(&self) -> f64 {
        self.max_sum_without_end_nodes
    }
}

/// Upper bound of the sum of |w_k(t)| over selected nodes k, for 0 <= t <= 1. Bounds each sixteenth
/// of the interval by its Bézier points.
fn max_absolute_weight_sum(weights: &BezierWeights, is_selected: impl Fn(usize) -> bool) -> f64 {
    let mut worst = 0.0_f64;
    for piece in 0..16 {
        let (from, to) = (f64::from(piece) / 16.0, f64::from(piece + 1) / 16.0);
        let sum: f64 = (0..NODES_PER_CUBIC)
            .filter(|&k| is_selected(k))
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

/// The weights of the interval from node `interval` to the next node in a row of `node_count` nodes.
/// Slopes use `nodes_per_slope` nodes each, the cubic `nodes_per_cubic` nodes.
fn interval_weights(
    interval: usize,
    node_count: usize,
    nodes_per_slope: usize,
    nodes_per_cubic: usize,
    scheme: Scheme,
) -> BezierWeights {
    // The slope at node `at` of the polynomial through `count` nodes, beginning with node `first`.
    let slope = |at: usize, first: usize, count: usize| {
        let mut slope = [0.0; NODES_PER_CUBIC];
        let (by, rows) = slope_formulas_at_nodes(count);
        slope[first..].iter_mut().zip(rows[at - first]).for_each(|(slope, weight)| *slope = weight / by);
        slope
    };
    let (start, end) = match scheme {
        Scheme::SixTap => {
            // The stencil is as central as the ends of the row allow.
            let central = |at: usize| {
                slope(at, at.saturating_sub(nodes_per_slope / 2).min(node_count - nodes_per_slope), nodes_per_slope)
            };
            (central(interval), central(interval + 1))
        }
        Scheme::FourPoint => {
            let first = interval.saturating_sub(1).min(node_count - nodes_per_cubic);
            (slope(interval, first, nodes_per_cubic), slope(interval + 1, first, nodes_per_cubic))
        }
    };
    // Bézier points of a cubic Hermite: P0, P0 + S0 / 3, P1 - S1 / 3, P1.
    let mut points = [[0.0; NODES_PER_CUBIC]; 4];
    (points[0][interval], points[1][interval]) = (1.0, 1.0);
    (points[2][interval + 1], points[3][interval + 1]) = (1.0, 1.0);
    for k in 0..NODES_PER_CUBIC {
        points[1][k] += start[k] / 3.0;
        points[2][k] -= end[k] / 3.0;
    }
    points
}

/// Row k gives the slope at node k of the polynomial through `node_count` nodes, multiplied by the
/// returned factor.
fn slope_formulas_at_nodes(node_count: usize) -> (f64, &'static [&'static [f64]]) {
    match node_count {
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

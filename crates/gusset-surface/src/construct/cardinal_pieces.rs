//! Cardinal functions that blend curves. Each line of a net has a function that is 1 on it and 0 on
//! all other lines.
//!
//! The functions are piecewise cubic and C1. The slope at a line is the slope of the polynomial
//! through the five nearest lines. This is the grid's six-tap scheme, generalised to uneven
//! spacing.

use crate::axis::NODES_PER_CUBIC;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::aabb::range_of_values;
use gusset_base::geom::bernstein::{blossom, elevate};

/// Largest ratio of intervals among five lines. If it is exceeded, slopes are computed from three
/// lines.
const MAX_INTERVAL_LENGTH_RATIO: f64 = 8.0;

/// The functions between two lines: the Bézier points of the functions that do not vanish there.
pub(super) struct CardinalPiece {
    /// The lines that the functions belong to. Lines of weight 0 may repeat other lines.
    pub(super) lines: [usize; NODES_PER_CUBIC],
    pub(super) points: [[f64; 4]; NODES_PER_CUBIC],
}

/// The cardinal functions between successive lines. `interval_lengths` are the lengths of the
/// intervals, which are positive. In a closed direction, the last interval leads back to the first
/// line.
pub(super) fn cardinal_pieces(interval_lengths: &[f64], closed: bool) -> Result<Vec<CardinalPiece>> {
    let row = IntervalRow { lengths: interval_lengths, closed };
    alloc::collect((0..interval_lengths.len()).map(|interval| row.cardinal_piece(interval)))
}

impl CardinalPiece {
    /// Restricts the functions to a part of the interval. For each Bernstein coefficient of degree
    /// N - 1, returns the weights of the lines.
    pub(super) fn bernstein_weights<const N: usize>(&self, [from, to]: [f64; 2]) -> [[f64; NODES_PER_CUBIC]; N] {
        let mut weights = [[0.0; NODES_PER_CUBIC]; N];
        for (k, points) in self.points.iter().enumerate() {
            let ends = [[from, from, from], [from, from, to], [from, to, to], [to, to, to]];
            let mut c = [0.0; N];
            c[..4].copy_from_slice(&ends.map(|at| blossom(points, at)));
            elevate(&mut c, 3);
            weights.iter_mut().zip(c).for_each(|(weights, c)| weights[k] = c);
        }
        weights
    }
}

struct IntervalRow<'a> {
    lengths: &'a [f64],
    closed: bool,
}

impl IntervalRow<'_> {
    fn line_count(&self) -> usize {
        self.lengths.len() + usize::from(!self.closed)
    }

    /// The length of an interval. Indices wrap around in closed directions.
    fn interval_length(&self, interval: isize) -> f64 {
        self.lengths[interval.rem_euclid(self.lengths.len() as isize) as usize]
    }

    /// The first of `count` lines around a line, as central as the ends allow.
    fn first_of_central_lines(&self, line: usize, count: usize) -> isize {
        let middle = line as isize - (count / 2) as isize;
        if self.closed { middle } else { middle.clamp(0, (self.line_count() - count) as isize) }
    }

    /// The slope at a line: the first line that it depends on, and the weights of the lines from
    /// there.
    fn slope_weights(&self, line: usize) -> (isize, [f64; 5]) {
        let max_count = self.line_count().min(if self.closed && self.line_count() < 5 { 3 } else { 5 });
        let mut count = max_count;
        if max_count > 3 {
            let first = self.first_of_central_lines(line, max_count);
            let [min, max] = range_of_values((first..first + max_count as isize - 1).map(|k| self.interval_length(k)));
            if max > MAX_INTERVAL_LENGTH_RATIO * min {
                count = 3;
            }
        }
        let first = self.first_of_central_lines(line, count);
        // Positions of the lines relative to this one.
        let mut at = [0.0; 5];
        let own = (line as isize - first) as usize;
        for k in own + 1..count {
            at[k] = at[k - 1] + self.interval_length(first + k as isize - 1);
        }
        for k in (0..own).rev() {
            at[k] = at[k + 1] - self.interval_length(first + k as isize);
        }
        let mut weights = [0.0; 5];
        for k in (0..count).filter(|&k| k != own) {
            let others = (0..count).filter(|&i| i != k && i != own);
            weights[k] = others.map(|i| at[i] / (at[i] - at[k])).product::<f64>() / at[k];
            weights[own] -= 1.0 / at[k];
        }
        (first, weights)
    }

    fn cardinal_piece(&self, interval: usize) -> CardinalPiece {
        let lines = self.line_count();
        let before = interval as isize - 2;
        let first = if self.closed { before } else { before.clamp(0, lines.saturating_sub(NODES_PER_CUBIC) as isize) };
        let length = self.lengths[interval];
        let mut points = [[0.0; 4]; NODES_PER_CUBIC];
        for (end, line) in [interval, interval + 1].into_iter().enumerate() {
            let own = (line as isize - first) as usize;
            let (inner, inwards) = if end == 0 { (1, length / 3.0) } else { (2, -length / 3.0) };
            points[own][3 * end] = 1.0;
            points[own][inner] += 1.0;
            let (start, weights) = self.slope_weights(line);
            for (k, weight) in weights.into_iter().enumerate().filter(|&(_, weight)| weight != 0.0) {
                points[(start + k as isize - first) as usize][inner] += inwards * weight;
            }
        }
        let place = |k: isize| {
            if self.closed { k.rem_euclid(lines as isize) as usize } else { (k as usize).min(lines - 1) }
        };
        CardinalPiece { lines: std::array::from_fn(|k| place(first + k as isize)), points }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A quartic sampled at uneven lines has its own slopes at them, and a constant stays constant.
    #[test]
    fn quartics_keep_their_slopes_at_uneven_lines() {
        let lengths = [1.0, 0.7, 1.9, 1.2, 0.6, 1.4, 1.0];
        let at: Vec<f64> = (0..=lengths.len()).map(|k| lengths[..k].iter().sum()).collect();
        let f = |x: f64| 2.0 - x + 0.3 * x * x - 0.1 * x.powi(3) + 0.01 * x.powi(4);
        let slope = |x: f64| -1.0 + 0.6 * x - 0.3 * x * x + 0.04 * x.powi(3);
        let blend = cardinal_pieces(&lengths, false).unwrap();
        for (k, (&length, piece)) in lengths.iter().zip(&blend).enumerate() {
            let weights = piece.bernstein_weights::<4>([0.0, 1.0]);
            let c =
                weights.map(|weights| weights.iter().zip(piece.lines).map(|(w, line)| w * f(at[line])).sum::<f64>());
            assert_eq!([c[0], c[3]], [f(at[k]), f(at[k + 1])]);
            assert!((3.0 * (c[1] - c[0]) / length - slope(at[k])).abs() < 1e-12);
            assert!((3.0 * (c[3] - c[2]) / length - slope(at[k + 1])).abs() < 1e-12);
            let high = piece.bernstein_weights::<8>([0.25, 1.0]);
            for weights in high {
                assert!((weights.iter().sum::<f64>() - 1.0).abs() < 1e-13);
            }
        }
    }

    #[test]
    fn cardinal_functions_sum_to_one_for_few_and_closed_lines() {
        for (count, closed) in [(1, false), (2, false), (3, false), (3, true), (4, true), (5, true), (9, true)] {
            let lengths: Vec<f64> = (0..count).map(|k| 1.0 + 0.3 * f64::from(k % 3)).collect();
            for piece in cardinal_pieces(&lengths, closed).unwrap() {
                let weights = piece.bernstein_weights::<4>([0.0, 1.0]);
                assert!(weights.iter().all(|w| (w.iter().sum::<f64>() - 1.0).abs() < 1e-13));
            }
        }
    }
}

//! A proven bound of the distance between a polynomial piece and a rational one.
//!
//! Let the rational piece be S = P / w with weight polynomial w and numerator P, and let A be the
//! polynomial piece. N = w A - P is a polynomial of degree p + 7, q + 7, and A - S = N / w. Raised
//! to the same degree, w has control values W > 0. With the Bernstein polynomials B,
//! ```text
//! N / w = sum B N_ij / sum B W_ij = sum (B W_ij / sum B W_kl) N_ij / W_ij,
//! ```
//!
//! This is an average of N_ij / W_ij, so |A - S| is at most the largest |N_ij| / W_ij. Halves give
//! a closer bound, because de Casteljau's algorithm averages their control values.

use super::super::spline::PieceNet;
use crate::MAX_DEGREE;
use glam::{DVec3, DVec4};
use gusset_base::geom::bernstein::{binomial_row, halve};

/// Largest number of control values in a direction: the degrees of weights and piece, plus 1.
const MAX_CONTROL_VALUES_PER_DIRECTION: usize = 2 * MAX_DEGREE + 1;

/// Number of times that pieces are quartered for a closer bound.
const MAX_QUARTERINGS: usize = 3;

/// If the bound exceeds this multiple of the tolerance, quarters would exceed the tolerance too.
const MAX_IMPROVABLE_BOUND_IN_TOLERANCES: f64 = 4096.0;

/// N and, as the fourth coordinate, w raised to the same degree, in Bernstein form.
#[derive(Clone, Copy)]
pub(super) struct HomogeneousDifference {
    net: [[DVec4; MAX_CONTROL_VALUES_PER_DIRECTION]; MAX_CONTROL_VALUES_PER_DIRECTION],
    counts: [usize; 2],
}

impl HomogeneousDifference {
    /// Computes N from the control points of A and the homogeneous control points of S, which has
    /// the given degrees. The error of N_ij, relative to W_ij (|A| + |S|), is at most 2^-53 times
    /// (p + 1) (q + 1) + 5.
    pub(super) fn new(fitted_net: &PieceNet<DVec3>, homogeneous: &PieceNet<DVec4>, [p, q]: [usize; 2]) -> Self {
        let [sevenths, ps, qs] = [MAX_DEGREE, p, q].map(binomial_row::<{ MAX_DEGREE + 1 }>);
        let counts = [p + MAX_DEGREE + 1, q + MAX_DEGREE + 1];
        let mut net = [[DVec4::ZERO; MAX_CONTROL_VALUES_PER_DIRECTION]; MAX_CONTROL_VALUES_PER_DIRECTION];
        for (a, b) in (0..=p).flat_map(|a| (0..=q).map(move |b| (a, b))) {
            let (given, weight) = (homogeneous[a][b], ps[a] * qs[b]);
            let (numerator, w) = (given.truncate(), given.w);
            for (c, row) in fitted_net.iter().enumerate() {
                let across = weight * sevenths[c];
                for (d, &point) in row.iter().enumerate() {
                    // All these factors are integers, and exact.
                    net[a + c][b + d] += (w * point - numerator).extend(w) * (across * sevenths[d]);
                }
            }
        }
        let [us, vs] = counts.map(|count| binomial_row::<MAX_CONTROL_VALUES_PER_DIRECTION>(count - 1));
        for (row, u) in net[..counts[0]].iter_mut().zip(us) {
            row[..counts[1]].iter_mut().zip(vs).for_each(|(x, v)| *x /= u * v);
        }
        HomogeneousDifference { net, counts }
    }

    /// A bound of |N| / w, close enough to decide whether |N| / w is within the target.
    pub(super) fn distance_bound(&self, target: f64) -> f64 {
        let rough = self.max_ratio_of_control_vectors_to_weights();
        // Rounding in quarters and divisions is far below this relative margin.
        (1.0 + 1e-12)
            * if rough > MAX_IMPROVABLE_BOUND_IN_TOLERANCES * target {
                rough
            } else {
                self.tighten_bound_by_quartering(rough, target, MAX_QUARTERINGS)
            }
    }

    /// The largest |N_ij| / W_ij.
    fn max_ratio_of_control_vectors_to_weights(&self) -> f64 {
        let values = self.net[..self.counts[0]].iter().flat_map(|row| &row[..self.counts[1]]);
        let ratios = values.map(|value| value.truncate().length() / value.w);
        // NaN proves nothing.
        ratios.map(|ratio| if ratio.is_nan() { f64::INFINITY } else { ratio }).fold(0.0, f64::max)
    }

    fn tighten_bound_by_quartering(&self, bound: f64, target: f64, depth: usize) -> f64 {
        if bound <= target || depth == 0 {
            return bound;
        }
        let [low, high] = self.halves();
        let quarters = [low, high].map(|half| half.transposed().halves());
        quarters
            .as_flattened()
            .iter()
            .map(|part| {
                part.tighten_bound_by_quartering(part.max_ratio_of_control_vectors_to_weights(), target, depth - 1)
            })
            .fold(0.0, f64::max)
    }

    fn halves(&self) -> [Self; 2] {
        let (mut before, mut after) = (*self, *self);
        halve(&mut after.net[..self.counts[0]], &mut before.net[..self.counts[0]]);
        [before, after]
    }

    /// The difference with u and v exchanged.
    fn transposed(&self) -> Self {
        let net = std::array::from_fn(|i| std::array::from_fn(|j| self.net[j][i]));
        HomogeneousDifference { net, counts: [self.counts[1], self.counts[0]] }
    }
}

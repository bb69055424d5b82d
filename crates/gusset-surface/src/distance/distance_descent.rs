//! The distance between points of two nets: descent to a local minimum, and proofs of lower bounds.
//!
//! The function is f = |A(u, v) - B(s, t)|^2 / 2 over all parameters of the nets, from 0 to 1. The
//! descent takes projected Newton steps as in `nearest::foot_point`. If the Hessian of f is
//! positive definite everywhere, f is convex, and nowhere below its tangent plane at any place.
//! Descent then leads to the nearest points. Products of balls bound the Hessian. O(1).

use super::control_net::{ControlNet, DerivativeBalls, VectorBall};
use crate::Jet;
use glam::DVec3;

/// Parameters of A and of B.
pub(super) type PairParameters = [f64; 4];
type MatrixOfParameters = [[f64; 4]; 4];

/// A step shorter than this, in parameters, is the last one.
const LAST_STEP_PARAMETER_LENGTH: f64 = 1e-13;
/// The smallest fraction of a step that is tried.
const MIN_STEP_FRACTION: f64 = 1e-4;
/// Smallest pivot of a matrix with unit diagonal that counts as positive.
const MIN_POSITIVE_PIVOT: f64 = 1e-10;

/// The function and its derivatives at a place.
#[derive(Debug, Clone, Copy)]
pub(super) struct DistanceJet {
    pub(super) parameters: PairParameters,
    pub(super) distance: f64,
    difference: DVec3,
    jet_of_a: Jet,
    jet_of_b: Jet,
}

/// Two nets.
#[derive(Debug, Clone, Copy)]
pub(super) struct NetPair<'a> {
    pub(super) net_of_a: ControlNet<'a>,
    pub(super) net_of_b: ControlNet<'a>,
}

impl NetPair<'_> {
    /// Which parameters exist.
    fn which_parameters_vary(&self) -> [bool; 4] {
        let [a, b] = [self.net_of_a.shape, self.net_of_b.shape].map(|shape| shape.map(|count| count > 1));
        [a[0], a[1], b[0], b[1]]
    }

    pub(super) fn distance_jet_at(&self, at: PairParameters) -> DistanceJet {
        let [u, v, s, t] = at;
        let (a, b) = (self.net_of_a.jet_at([u, v]), self.net_of_b.jet_at([s, t]));
        let difference = a.point - b.point;
        DistanceJet { parameters: at, distance: difference.length(), difference, jet_of_a: a, jet_of_b: b }
    }

    /// Descends to a local minimum in at most `max_steps` steps.
    pub(super) fn minimise_distance(&self, start: DistanceJet, max_steps: usize) -> DistanceJet {
        let exist = self.which_parameters_vary();
        let mut best = start;
        for _ in 0..max_steps {
            let gradient = best.gradient();
            let free: [bool; 4] =
                std::array::from_fn(|k| exist[k] && !does_step_leave_box(best.parameters[k], gradient[k]));
            let Some(step) = best.descent_step(&gradient, free) else { break };
            let slope = best.squared_projected_gradient(exist);
            let mut length = 1.0;
            let next = loop {
                let at = std::array::from_fn(|k| (best.parameters[k] - length * step[k]).clamp(0.0, 1.0));
                let next = self.distance_jet_at(at);
                let levels_off = next.distance <= best.distance * (1.0 + 4.0 * f64::EPSILON);
                if next.distance < best.distance || (levels_off && next.squared_projected_gradient(exist) < slope) {
                    break Some(next);
                }
                length *= 0.25;
                if length < MIN_STEP_FRACTION {
                    break None;
                }
            };
            let Some(next) = next else { break };
            let moved = (0..4).map(|k| (next.parameters[k] - best.parameters[k]).abs()).fold(0.0, f64::max);
            best = next;
            if moved <= LAST_STEP_PARAMETER_LENGTH {
                break;
            }
        }
        best
    }

    /// True if f is proven to be convex.
    pub(super) fn is_distance_convex(&self, balls: [&DerivativeBalls; 2]) -> bool {
        is_hessian_positive_definite(self.which_parameters_vary(), balls)
    }
}

impl DistanceJet {
    /// The derivatives of the difference.
    fn tangents_of_difference(&self) -> [DVec3; 4] {
        [self.jet_of_a.u, self.jet_of_a.v, -self.jet_of_b.u, -self.jet_of_b.v]
    }

    /// A lower bound of the distance, if f is convex.
    pub(super) fn min_distance_if_convex(&self) -> f64 {
        let gradient = self.gradient();
        // The smallest value of the tangent plane over the box.
        let fall: f64 =
            gradient.iter().zip(self.parameters).map(|(&slope, at)| (slope * at).max(slope * (at - 1.0))).sum();
        (self.distance * self.distance - 2.0 * fall).max(0.0).sqrt()
    }

    fn gradient(&self) -> PairParameters {
        self.tangents_of_difference().map(|tangent| tangent.dot(self.difference))
    }

    /// Returns the squared length of the gradient in the parameters that exist, without components
    /// that lead out of the box.
    fn squared_projected_gradient(&self, exist: [bool; 4]) -> f64 {
        let gradient = self.gradient();
        let free = (0..4).filter(|&k| exist[k] && !does_step_leave_box(self.parameters[k], gradient[k]));
        free.map(|k| gradient[k] * gradient[k]).sum::<f64>()
    }

    /// The Newton step in the free parameters, or a Gauss-Newton step if Newton's would not go
    /// down.
    fn descent_step(&self, gradient: &PairParameters, free: [bool; 4]) -> Option<PairParameters> {
        let tangents = self.tangents_of_difference();
        let mut first: MatrixOfParameters =
            std::array::from_fn(|i| std::array::from_fn(|k| tangents[i].dot(tangents[k])));
        let mut hessian = first;
        for (offset, jet, sign) in [(0, &self.jet_of_a, 1.0), (2, &self.jet_of_b, -1.0)] {
            let [uu, uv, vv] = [jet.uu, jet.uv, jet.vv].map(|second| sign * second.dot(self.difference));
            hessian[offset][offset] += uu;
            hessian[offset][offset + 1] += uv;
            hessian[offset + 1][offset] += uv;
            hessian[offset + 1][offset + 1] += vv;
        }
        (0..4).for_each(|k| first[k][k] *= 1.0 + 1e-3);
        let newton_step = solve_for_free_parameters(&hessian, gradient, free)
            .or_else(|| solve_for_free_parameters(&first, gradient, free));
        newton_step.filter(|step| step.iter().all(|x| x.is_finite()) && step.iter().any(|&x| x != 0.0))
    }
}

/// True if the descent would leave the box.
fn does_step_leave_box(at: f64, slope: f64) -> bool {
    (at <= 0.0 && slope > 0.0) || (at >= 1.0 && slope < 0.0)
}

/// Solves the equations of the free parameters by Cholesky factorisation. Returns `None` unless the
/// matrix is clearly positive definite. The other parameters are 0.
fn solve_for_free_parameters(
    matrix: &MatrixOfParameters,
    right: &PairParameters,
    free: [bool; 4],
) -> Option<PairParameters> {
    let scale: PairParameters = std::array::from_fn(|k| matrix[k][k].max(0.0).sqrt().recip());
    if (0..4).any(|k| free[k] && !scale[k].is_finite()) {
        return None;
    }
    let scaled: MatrixOfParameters = std::array::from_fn(|i| {
        std::array::from_fn(|k| match (free[i] && free[k], i == k) {
            (true, _) => matrix[i][k] * scale[i] * scale[k],
            (false, same) => f64::from(u8::from(same)),
        })
    });
    let factor = cholesky_factor(&scaled)?;
    let mut x: PairParameters = std::array::from_fn(|k| if free[k] { right[k] * scale[k] } else { 0.0 });
    for i in 0..4 {
        x[i] = (x[i] - (0..i).map(|k| factor[i][k] * x[k]).sum::<f64>()) / factor[i][i];
    }
    for i in (0..4).rev() {
        x[i] = (x[i] - (i + 1..4).map(|k| factor[k][i] * x[k]).sum::<f64>()) / factor[i][i];
    }
    Some(std::array::from_fn(|k| if free[k] { x[k] * scale[k] } else { 0.0 }))
}

/// The lower Cholesky factor of a matrix whose diagonal elements are 1; `None` unless the matrix is
/// clearly positive definite.
fn cholesky_factor(matrix: &MatrixOfParameters) -> Option<MatrixOfParameters> {
    let mut factor = [[0.0; 4]; 4];
    for i in 0..4 {
        for k in 0..=i {
            let rest = matrix[i][k] - (0..k).map(|j| factor[i][j] * factor[k][j]).sum::<f64>();
            factor[i][k] = match i == k {
                true if rest > MIN_POSITIVE_PIVOT => rest.sqrt(),
                true => return None,
                false => rest / factor[k][k],
            };
        }
    }
    Some(factor)
}

/// True if the Hessian is positive definite for all vectors in the balls. Subtracts the norm of the
/// possible deviation from the matrix of the centres, after scaling it to a unit diagonal.
fn is_hessian_positive_definite(exist: [bool; 4], [a, b]: [&DerivativeBalls; 2]) -> bool {
    let product = |p: &VectorBall, q: &VectorBall| {
        let [x, y] = [p, q].map(|ball| ball.centre.length());
        (p.centre.dot(q.centre), x * q.radius + y * p.radius + p.radius * q.radius)
    };
    let difference = VectorBall { centre: a.point.centre - b.point.centre, radius: a.point.radius + b.point.radius };
    let first = [&a.first[0], &a.first[1], &b.first[0], &b.first[1]];
    let (mut middle, mut off) = ([[0.0; 4]; 4], [[0.0; 4]; 4]);
    for i in 0..4 {
        for k in 0..4 {
            let (mut value, radius) = product(first[i], first[k]);
            if i / 2 != k / 2 {
                value = -value;
            }
            (middle[i][k], off[i][k]) = (value, radius);
            if i / 2 == k / 2 {
                let second = if i < 2 { &a.second } else { &b.second };
                let (value, radius) = product(&difference, &second[i % 2 + k % 2]);
                middle[i][k] += if i < 2 { value } else { -value };
                off[i][k] += radius;
            }
        }
    }
    let mut scale = [0.0; 4];
    for k in (0..4).filter(|&k| exist[k]) {
        if middle[k][k] <= off[k][k] {
            return false;
        }
        scale[k] = middle[k][k].sqrt().recip();
    }
    let norm = (0..4).map(|i| (0..4).map(|k| off[i][k] * scale[i] * scale[k]).sum::<f64>()).fold(0.0, f64::max);
    let least: MatrixOfParameters = std::array::from_fn(|i| {
        std::array::from_fn(|k| match (exist[i] && exist[k], i == k) {
            (true, same) => middle[i][k] * scale[i] * scale[k] - if same { norm } else { 0.0 },
            (false, same) => f64::from(u8::from(same)),
        })
    });
    cholesky_factor(&least).is_some()
}

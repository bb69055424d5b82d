//! Rigid bodies: the rotations that lower the energy.

use super::energy_model::EnergyModel;
use super::motion::{RigidMotion, outer_product};
use super::parts::{BODY_SLOT_FLAG, NO_BODY};
use super::quadratic_term::QuadraticTerm;
use glam::{DMat3, DVec3};
use gusset_base::geom::rotation::rotation_maximising_trace;

/// The fraction of a body's inertia that resists its rotation, so that rotations without effect are
/// 0.
const RELATIVE_INERTIA_DAMPING: f64 = 1e-9;

/// The rotation of a body about a pivot, as determined by its terms.
#[derive(Clone, Copy, Default)]
struct RotationSums {
    /// Sums of w c^2 and w c A.
    weighted_square_sum: f64,
    moment: DVec3,
    /// The sum of w (r - B) A^T, which determines the best rotation.
    covariance: DMat3,
    inertia: f64,
}

/// Returns the share of one body in a term: its coefficient c, and A, the sum of c_j x_j.
fn coefficient_and_sum_of_body(model: &EnergyModel, term: &QuadraticTerm, x: &[DVec3], body: u32) -> (f64, DVec3) {
    let mut share = (0.0, DVec3::ZERO);
    for (&point, &c) in term.points.iter().zip(&term.factors) {
        if c != 0.0 && model.unknown_or_body_of_point[point as usize] == BODY_SLOT_FLAG + body {
            share = (share.0 + c, share.1 + c * x[point as usize]);
        }
    }
    share
}

/// Rotates each free body, with the others fixed, to the minimum of the sum of terms.
pub(super) fn rotate_bodies(
    model: &EnergyModel,
    terms: &[QuadraticTerm],
    x: &mut [DVec3],
    motions: &mut [RigidMotion],
) {
    for body in 0..motions.len() as u32 {
        if model.translation_unknown_of_body[body as usize] == NO_BODY {
            continue;
        }
        let own = || {
            terms.iter().filter(|term| {
                (0..3).any(|j| model.unknown_or_body_of_point[term.points[j] as usize] == BODY_SLOT_FLAG + body)
            })
        };
        let mut lever = RotationSums::default();
        for term in own() {
            let (c, a) = coefficient_and_sum_of_body(model, term, x, body);
            lever.weighted_square_sum += term.weight * c * c;
            lever.moment += term.weight * c * a;
        }
        let about =
            if lever.weighted_square_sum > 0.0 { lever.moment / lever.weighted_square_sum } else { DVec3::ZERO };
        for term in own() {
            let (c, a) = coefficient_and_sum_of_body(model, term, x, body);
            let a = a - c * about;
            let rest = a - term.residual(x);
            lever.covariance += outer_product(term.weight * rest, a);
            lever.inertia += term.weight.abs() * a.length_squared();
        }
        if lever.inertia > 0.0 {
            let turn = rotation_maximising_trace(
                lever.covariance + DMat3::from_diagonal(DVec3::splat(RELATIVE_INERTIA_DAMPING * lever.inertia)),
            );
            motions[body as usize] = motions[body as usize].then_rotate(turn, about);
        }
    }
    model.place_moving_bodies(motions, x);
}

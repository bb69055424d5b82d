//! Descent to a local minimum of the distance on a patch.
//!
//! Minimises |S - q|^2 / 2 over 0 <= u, v <= 1 with projected Newton steps (Bertsekas 1982,
//! "Projected Newton methods for optimization problems with simple constraints"). Uses Gauss-Newton
//! steps where the Hessian is not positive definite, steepest descent where those overshoot, and
//! backtracking. Invariant: the distance decreases with each step. The result is not proven; see
//! `patch_bounds`. At most [`MAX_NEWTON_STEPS_ON_PATCH`] steps.

use crate::{Jet, Patch};
use glam::{DMat2, DVec2, DVec3};

/// Largest number of Newton steps on a patch.
pub(super) const MAX_NEWTON_STEPS_ON_PATCH: usize = 24;
/// Largest number of Newton steps on a part of a patch. If more are needed, splitting is more
/// effective.
pub(super) const MAX_NEWTON_STEPS_ON_PART: usize = 6;
/// A full step shorter than this, in parameters, is the last one, because the next one would be its
/// square.
const LAST_STEP_PARAMETER_LENGTH: f64 = 1e-7;
/// A parameter within this distance of a border counts as on it.
const MAX_DISTANCE_ON_BORDER: f64 = 1e-13;

/// A point of a patch, with its derivatives and its distance from the query.
#[derive(Debug, Clone, Copy)]
pub(super) struct FootPoint {
    pub(super) parameters: DVec2,
    pub(super) jet: Jet,
    pub(super) distance: f64,
}

impl FootPoint {
    pub(super) fn from_place<const N: usize>(patch: &Patch<N>, query: DVec3, place: DVec2) -> FootPoint {
        let jet = patch.jet(place.x, place.y);
        FootPoint { parameters: place, jet, distance: jet.point.distance(query) }
    }

    /// The gradient of |S - q|^2 / 2. Components that point out of the patch are set to 0.
    pub(super) fn projected_gradient(&self, query: DVec3) -> DVec2 {
        let (gradient, _) = gradient_and_hessian(&self.jet, query);
        DVec2::from_array(
            [0, 1].map(|k| if is_step_blocked_by_border(self.parameters[k], gradient[k]) { 0.0 } else { gradient[k] }),
        )
    }
}

/// Descends from `start` to a place from which no permitted step goes down, within rounding.
pub(super) fn descend_to_foot<const N: usize>(
    patch: &Patch<N>,
    query: DVec3,
    start: DVec2,
    max_steps: usize,
) -> FootPoint {
    let mut foot = FootPoint::from_place(patch, query, start.clamp(DVec2::ZERO, DVec2::ONE));
    for _ in 0..max_steps {
        let (gradient, hessian) = gradient_and_hessian(&foot.jet, query);
        let free = [0, 1].map(|k| !is_step_blocked_by_border(foot.parameters[k], gradient[k]));
        let Some(step) = newton_step(gradient, hessian, &foot.jet, free) else { break };
        let (next, done) = match try_shorter_steps(patch, query, &foot, step) {
            StepOutcome::Down { next, whole } => {
                (next, whole && (next.parameters - foot.parameters).abs().max_element() < LAST_STEP_PARAMETER_LENGTH)
            }
            StepOutcome::Ended => break,
            StepOutcome::Overshot => {
                // Steepest descent, with each parameter scaled separately.
                let squares = DVec2::new(foot.jet.u.length_squared(), foot.jet.v.length_squared());
                let slope = gradient / squares.max(DVec2::splat(f64::MIN_POSITIVE));
                let slope = DVec2::from_array([0, 1].map(|k| if free[k] { slope[k] } else { 0.0 }));
                match try_shorter_steps(patch, query, &foot, slope) {
                    StepOutcome::Down { next, .. } => (next, false),
                    _ => break,
                }
            }
        };
        foot = next;
        if done {
            break;
        }
    }
    foot
}

/// The outcome of a step.
enum StepOutcome {
    /// The first of successively shorter steps that decreases the distance. `whole`: it was the
    /// full step.
    Down { next: FootPoint, whole: bool },
    /// The steps became so short that rounding decides.
    Ended,
    /// No step decreases the distance.
    Overshot,
}

/// Tries a step, then shorter ones, beginning with the size of the patch.
fn try_shorter_steps<const N: usize>(patch: &Patch<N>, query: DVec3, foot: &FootPoint, step: DVec2) -> StepOutcome {
    let bounded = step.abs().max_element().max(1.0).recip();
    let mut length = 1.0;
    while length > 1e-3 * bounded {
        let place = (foot.parameters - length * step).clamp(DVec2::ZERO, DVec2::ONE);
        let moved = (place - foot.parameters).abs().max_element();
        if moved <= 1e-14 {
            return StepOutcome::Ended;
        }
        let next = FootPoint::from_place(patch, query, place);
        if next.distance < foot.distance {
            return StepOutcome::Down { next, whole: length == 1.0 };
        }
        // This close to the minimum, rounding decides.
        if moved < LAST_STEP_PARAMETER_LENGTH {
            return StepOutcome::Ended;
        }
        length = 0.25 * length.min(bounded);
    }
    StepOutcome::Overshot
}

/// True if the place is on a border or next to it, and the descent would cross that border.
fn is_step_blocked_by_border(at: f64, slope: f64) -> bool {
    (at <= MAX_DISTANCE_ON_BORDER && slope > 0.0) || (at >= 1.0 - MAX_DISTANCE_ON_BORDER && slope < 0.0)
}

/// The gradient and the Hessian of |S - q|^2 / 2.
pub(super) fn gradient_and_hessian(jet: &Jet, query: DVec3) -> (DVec2, DMat2) {
    let from = jet.point - query;
    let mixed = jet.u.dot(jet.v) + from.dot(jet.uv);
    let uu = jet.u.length_squared() + from.dot(jet.uu);
    let vv = jet.v.length_squared() + from.dot(jet.vv);
    (DVec2::new(from.dot(jet.u), from.dot(jet.v)), DMat2::from_cols(DVec2::new(uu, mixed), DVec2::new(mixed, vv)))
}

/// The Newton step in the free directions, or the Gauss-Newton step if Newton's would not go down.
/// If the tangents are parallel or zero, the better step along a single parameter.
fn newton_step(gradient: DVec2, hessian: DMat2, jet: &Jet, free: [bool; 2]) -> Option<DVec2> {
    let solve = |m: DMat2| match free {
        [true, true] => {
            let is_definite = m.x_axis.x > 0.0 && m.determinant() > 1e-12 * m.x_axis.x * m.y_axis.y;
            is_definite.then(|| m.inverse() * gradient)
        }
        [true, false] => (m.x_axis.x > 0.0).then(|| DVec2::new(gradient.x / m.x_axis.x, 0.0)),
        [false, true] => (m.y_axis.y > 0.0).then(|| DVec2::new(0.0, gradient.y / m.y_axis.y)),
        [false, false] => None,
    };
    let gauss = || {
        let mixed = jet.u.dot(jet.v);
        DMat2::from_cols(DVec2::new(jet.u.length_squared(), mixed), DVec2::new(mixed, jet.v.length_squared()))
    };
    let single = || {
        let of = |k: usize, along: DVec3| {
            let (slope, square) = (gradient[k], along.length_squared());
            // The predicted decrease within the patch. Rounding in place of a tangent predicts
            // none.
            let step = slope / square;
            (free[k] && square > 0.0).then_some((slope.abs() * step.abs().min(1.0), step.clamp(-1.0, 1.0)))
        };
        match (of(0, jet.u), of(1, jet.v)) {
            (Some((a, u)), Some((b, _))) if a >= b => Some(DVec2::new(u, 0.0)),
            (_, Some((_, v))) => Some(DVec2::new(0.0, v)),
            (Some((_, u)), None) => Some(DVec2::new(u, 0.0)),
            (None, None) => None,
        }
    };
    solve(hessian).or_else(|| solve(gauss())).or_else(single).filter(|step| step.is_finite())
}

//! Descent to a place of a patch where the distance is locally least.
//!
//! Minimises |S - q|^2 / 2 over 0 <= u, v <= 1 by projected Newton steps (Bertsekas 1982,
//! "Projected Newton methods for optimization problems with simple constraints"), Gauss-Newton
//! steps where the Hessian is not positive definite, and backtracking. Invariant: the distance
//! falls with each step. Nothing is proved: `bounds` does that. At most [`MAX_STEPS`] steps.

use crate::surface::{Jet, Patch};
use glam::{DMat2, DVec2, DVec3};

/// Newton steps on a patch.
pub(super) const MAX_STEPS: usize = 24;
/// Newton steps on a part of a patch: if these do not suffice, splitting it does more.
pub(super) const MAX_STEPS_ON_PART: usize = 6;
/// Length in the parameters below which a full step is the last: the next one would be its square.
const QUADRATIC_STEP: f64 = 1e-7;

/// A point of a patch, with its derivatives there and its distance from the query.
#[derive(Debug, Clone, Copy)]
pub(super) struct Foot {
    pub(super) place: DVec2,
    pub(super) jet: Jet,
    pub(super) distance: f64,
}

impl Foot {
    pub(super) fn at<const N: usize>(patch: &Patch<N>, query: DVec3, place: DVec2) -> Foot {
        let jet = patch.jet(place.x, place.y);
        Foot { place, jet, distance: jet.point.distance(query) }
    }

    /// The gradient of |S - q|^2 / 2, its components out of the patch set to 0.
    pub(super) fn projected_gradient(&self, query: DVec3) -> DVec2 {
        let (gradient, _) = gradient_and_hessian(&self.jet, query);
        DVec2::from_array([0, 1].map(|k| if is_blocked(self.place[k], gradient[k]) { 0.0 } else { gradient[k] }))
    }
}

/// The place that descent from `start` leads to: from there no permitted step goes down, or nearly.
pub(super) fn minimise<const N: usize>(patch: &Patch<N>, query: DVec3, start: DVec2, steps: usize) -> Foot {
    let mut foot = Foot::at(patch, query, start.clamp(DVec2::ZERO, DVec2::ONE));
    for _ in 0..steps {
        let (gradient, hessian) = gradient_and_hessian(&foot.jet, query);
        let free = [0, 1].map(|k| !is_blocked(foot.place[k], gradient[k]));
        let Some(step) = newton_step(gradient, hessian, &foot.jet, free) else { break };
        let Some((next, length)) = backtrack(patch, query, &foot, step) else { break };
        let done = length == 1.0 && (next.place - foot.place).abs().max_element() < QUADRATIC_STEP;
        foot = next;
        if done {
            break;
        }
    }
    foot
}

/// The first of ever shorter steps that goes down, and its share of the whole step.
fn backtrack<const N: usize>(patch: &Patch<N>, query: DVec3, foot: &Foot, step: DVec2) -> Option<(Foot, f64)> {
    let mut length = 1.0;
    while length > 1e-3 {
        let place = (foot.place - length * step).clamp(DVec2::ZERO, DVec2::ONE);
        if (place - foot.place).abs().max_element() <= 1e-14 {
            return None;
        }
        let next = Foot::at(patch, query, place);
        if next.distance < foot.distance {
            return Some((next, length));
        }
        // So near the minimum rounding decides.
        if (place - foot.place).abs().max_element() < QUADRATIC_STEP {
            return None;
        }
        length *= 0.25;
    }
    None
}

/// True at a border that the descent would cross.
fn is_blocked(at: f64, slope: f64) -> bool {
    (at <= 0.0 && slope > 0.0) || (at >= 1.0 && slope < 0.0)
}

/// Gradient and Hessian of |S - q|^2 / 2.
pub(super) fn gradient_and_hessian(jet: &Jet, query: DVec3) -> (DVec2, DMat2) {
    let from = jet.point - query;
    let mixed = jet.u.dot(jet.v) + from.dot(jet.uv);
    let uu = jet.u.length_squared() + from.dot(jet.uu);
    let vv = jet.v.length_squared() + from.dot(jet.vv);
    (DVec2::new(from.dot(jet.u), from.dot(jet.v)), DMat2::from_cols(DVec2::new(uu, mixed), DVec2::new(mixed, vv)))
}

/// Newton's step in the free directions, or the Gauss-Newton step where Newton's would not go down;
/// where tangents are parallel or 0, the better one along a single parameter.
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
            // The descent it promises, within the patch: rounding in place of a tangent promises
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

//! Newton's way down to a nearest point.

use crate::surface::{Jet, Patch};
use glam::{DMat2, DVec2, DVec3};

/// Newton steps for a patch, and for a part of one: if those do not do, cutting it does more.
pub(super) const STEPS: usize = 24;
pub(super) const FEW_STEPS: usize = 6;
/// A full step below this is the last: the next one would be its square.
const LAST: f64 = 1e-7;

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

    /// The gradient of |S - q|^2 / 2, without what leads out of the patch.
    pub(super) fn free_gradient(&self, query: DVec3) -> DVec2 {
        let (gradient, _) = slopes(&self.jet, query);
        DVec2::from_array([0, 1].map(|k| if held(self.place[k], gradient[k]) { 0.0 } else { gradient[k] }))
    }
}

/// A point from which no permitted step goes down, or nearly: projected Newton steps on half the square of the distance.
pub(super) fn descend<const N: usize>(patch: &Patch<N>, query: DVec3, start: DVec2, steps: usize) -> Foot {
    let mut foot = Foot::at(patch, query, start.clamp(DVec2::ZERO, DVec2::ONE));
    for _ in 0..steps {
        let (gradient, hessian) = slopes(&foot.jet, query);
        let free = [0, 1].map(|k| !held(foot.place[k], gradient[k]));
        let Some(step) = step(gradient, hessian, &foot.jet, free) else { break };
        let Some((next, length)) = shortened(patch, query, &foot, step) else { break };
        let done = length == 1.0 && (next.place - foot.place).abs().max_element() < LAST;
        foot = next;
        if done {
            break;
        }
    }
    foot
}

/// The first of ever shorter steps that goes down, and how much of the step it is.
fn shortened<const N: usize>(patch: &Patch<N>, query: DVec3, foot: &Foot, step: DVec2) -> Option<(Foot, f64)> {
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
        // Next to the bottom: rounding decides.
        if (place - foot.place).abs().max_element() < LAST {
            return None;
        }
        length *= 0.25;
    }
    None
}

/// True at a border that the descent would leave.
fn held(at: f64, slope: f64) -> bool {
    (at <= 0.0 && slope > 0.0) || (at >= 1.0 && slope < 0.0)
}

/// Gradient and Hessian of |S - q|^2 / 2.
pub(super) fn slopes(jet: &Jet, query: DVec3) -> (DVec2, DMat2) {
    let from = jet.point - query;
    let mixed = jet.u.dot(jet.v) + from.dot(jet.uv);
    let uu = jet.u.length_squared() + from.dot(jet.uu);
    let vv = jet.v.length_squared() + from.dot(jet.vv);
    (DVec2::new(from.dot(jet.u), from.dot(jet.v)), DMat2::from_cols(DVec2::new(uu, mixed), DVec2::new(mixed, vv)))
}

/// Newton's step in the free directions, or that of Gauss and Newton where Newton's would not go down; where tangents are parallel or 0, the
/// better one along a single parameter.
fn step(gradient: DVec2, hessian: DMat2, jet: &Jet, free: [bool; 2]) -> Option<DVec2> {
    let solve = |m: DMat2| match free {
        [true, true] => {
            let sound = m.x_axis.x > 0.0 && m.determinant() > 1e-12 * m.x_axis.x * m.y_axis.y;
            sound.then(|| m.inverse() * gradient)
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
            // How far down it goes at most, within the patch: noise of a tangent that is 0 promises nothing.
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

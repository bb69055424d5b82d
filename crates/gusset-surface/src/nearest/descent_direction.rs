//! Descent directions of the distance at a place of a patch. They follow from the slopes in
//! permitted directions, and from second derivatives where slopes vanish. A numerical descent would
//! not be a test: it may stop short, or step over into the basin of another minimum.

use super::foot_point::{FootPoint, MAX_NEWTON_STEPS_ON_PATCH, descend_to_foot, gradient_and_hessian};
use super::patch_minima::max_slope_rounding;
use crate::Patch;
use glam::DMat2;
use glam::{DVec2, DVec3};

/// A place within this distance of a side, in parameters, counts as on the side.
pub(super) const MAX_DISTANCE_ON_SIDE: f64 = 1e-9;
/// Second derivatives below this fraction of the squared tangents count as zero. So do sines of the
/// angle between tangents.
const MAX_RELATIVE_ROUNDING: f64 = 1e-9;

/// True if the distance from a query decreases in some permitted direction from a place of a patch.
/// Where the parametrisation is singular, true if a descent ends farther than `moved` from the
/// place.
pub(super) fn has_descent_direction<const N: usize>(patch: &Patch<N>, query: DVec3, place: DVec2, moved: f64) -> bool {
    let snapped = |x: f64| {
        let near_high = if x >= 1.0 - MAX_DISTANCE_ON_SIDE { 1.0 } else { x };
        if x <= MAX_DISTANCE_ON_SIDE { 0.0 } else { near_high }
    };
    let foot = FootPoint::from_place(patch, query, DVec2::new(snapped(place.x), snapped(place.y)));
    let (u, v) = (foot.jet.u, foot.jet.v);
    // On a fold, a point hardly determines its parameters.
    let is_fold =
        |along: DVec3, bend: DVec3| along.length_squared() <= patch.derivative_noise().powi(2) + moved * bend.length();
    let are_parallel = u.cross(v).length() <= MAX_RELATIVE_ROUNDING * u.length() * v.length();
    if is_fold(u, foot.jet.uu) || is_fold(v, foot.jet.vv) || are_parallel {
        let lowest = descend_to_foot(patch, query, foot.parameters, MAX_NEWTON_STEPS_ON_PATCH);
        return lowest.distance < foot.distance && lowest.jet.point.distance(foot.jet.point) > moved;
    }
    let (gradient, hessian) = gradient_and_hessian(&foot.jet, query);
    let slack = max_slope_rounding(patch, &foot, query, MAX_DISTANCE_ON_SIDE);
    // Steps in both directions that stay in the patch.
    let ways = |k: usize| [-1.0, 1.0].into_iter().filter(move |way| foot.parameters[k] != 0.5 * (way + 1.0));
    if (0..2).any(|k| ways(k).any(|way| way * gradient[k] < -slack[k])) {
        return true;
    }
    let is_flat = |k: usize| gradient[k].abs() <= slack[k];
    let bends_down =
        |step: DVec2| is_form_negative_in_quadrant(hessian, step, [u.length_squared(), v.length_squared()]);
    match [is_flat(0), is_flat(1)] {
        [false, false] => false,
        [true, false] => bends_down(DVec2::X),
        [false, true] => bends_down(DVec2::Y),
        [true, true] => ways(0).any(|a| ways(1).any(|b| bends_down(DVec2::new(a, b)))),
    }
}

/// True if a quadratic form is negative in a direction in the quadrant of `step`, or along the axis
/// of `step` if it lies on one. Values up to a small fraction of `squares` count as zero.
fn is_form_negative_in_quadrant(form: DMat2, step: DVec2, squares: [f64; 2]) -> bool {
    let (uu, vv) =
        (form.x_axis.x + MAX_RELATIVE_ROUNDING * squares[0], form.y_axis.y + MAX_RELATIVE_ROUNDING * squares[1]);
    let mixed = step.x * step.y * form.x_axis.y;
    (step.x != 0.0 && uu < 0.0) || (step.y != 0.0 && vv < 0.0) || (mixed < 0.0 && mixed * mixed > uu * vv)
}

//! Local minima of the distance on one patch: stationary places inside, and minima along its sides.
//!
//! A part of the patch is settled in one of these cases, and otherwise split:
//! - *no root*: (S - q) . S_u or (S - q) . S_v is nonzero everywhere;
//! - *no minimum*: the Hessian is nowhere positive definite;
//! - *at most one minimum*: the Hessian is positive definite everywhere, and Newton's method finds
//!   the minimum, if it exists. This is the termination criterion of Hanniel and Elber (2007,
//!   "Subdivision termination criteria in subdivision multivariate solvers") for a gradient field;
//! - *undecided*: the distance varies by at most the tolerance, or the limit of parts is reached.
//!   One place represents all undecided parts.
//!
//! All tests use bounds from control points, so no minimum is missed. At most
//! [`MAX_PARTS_PER_PATCH`] parts.

use super::foot_point::{FootPoint, MAX_NEWTON_STEPS_ON_PATCH, descend_to_foot, gradient_and_hessian};
use super::patch_part::{MAX_PARTS_PER_PATCH, PatchPart};
use crate::Patch;
use glam::{DVec2, DVec3};
use gusset_base::geom::aabb::range_of_values;
use gusset_base::geom::bernstein::halves;

/// Number of parts examined of a patch without area. The Hessian of a line is never definite, so
/// splitting can only exclude parts.
const MAX_PARTS_OF_PATCH_WITHOUT_AREA: usize = 12;
/// Number of parts of a side examined before the rest is accepted unsplit.
const MAX_PARTS_OF_SIDE: usize = 4 * MAX_PARTS_PER_PATCH;
/// Largest distance, in parameters, between the end of a descent and the minimum, caused by
/// rounding.
const MAX_DESCENT_PARAMETER_ERROR: f64 = 1e-6;
/// Smallest size of a part of a side.
const MIN_SIDE_PART_SIZE: f64 = 1e-7;

/// A local minimum of the distance, or a place that may be one.
#[derive(Debug, Clone, Copy)]
pub(super) struct LocalMinimum {
    pub(super) parameters: DVec2,
    pub(super) point: DVec3,
    pub(super) distance: f64,
    /// A lower bound of the distance of the part that was examined.
    pub(super) distance_bound: f64,
    pub(super) proven: bool,
}

impl LocalMinimum {
    fn new(foot: &FootPoint, bound: f64, proven: bool) -> Self {
        let FootPoint { parameters: place, jet, distance } = *foot;
        LocalMinimum { parameters: place, point: jet.point, distance, distance_bound: bound.min(distance), proven }
    }
}

/// Finds the minima inside a patch, including those on its border where the slope across it
/// vanishes. Adds one unproven place for all undecided parts.
pub(super) fn find_interior_minima<const N: usize>(
    patch: &Patch<N>,
    query: DVec3,
    tolerance: f64,
    mut add: impl FnMut(LocalMinimum),
) {
    if !may_have_stationary_point(patch, query) {
        return;
    }
    let mut parts = vec![PatchPart::whole_patch(patch)];
    let mut examined = 0;
    let most = if patch.has_zero_area() { MAX_PARTS_OF_PATCH_WITHOUT_AREA } else { MAX_PARTS_PER_PATCH };
    let mut undecided: Option<LocalMinimum> = None;
    while let Some(part) = parts.pop() {
        if !may_have_stationary_point(&part.patch, query) {
            continue;
        }
        examined += 1;
        let foot = descend_to_foot(&part.patch, query, DVec2::splat(0.5), MAX_NEWTON_STEPS_ON_PATCH);
        let hessian = part.patch.hessian_entry_ranges(query, &foot);
        let noise = part.patch.derivative_noise();
        let speed = foot.jet.u.length() + foot.jet.v.length();
        if hessian.is_nowhere_definite(noise * (foot.distance + speed + noise)) {
            continue;
        }
        let on_whole = || FootPoint::from_place(patch, query, part.place_in_patch(foot.parameters));
        if hessian.min_eigenvalue().is_some() && has_descent_converged(&part.patch, &foot, query) {
            if is_foot_stationary(&part.patch, &foot, query) {
                add(LocalMinimum::new(&on_whole(), part.patch.distance_bound_by_convexity(query, &foot), true));
            }
            continue;
        }
        let direction = (query - foot.jet.point).normalize_or_zero();
        let bound =
            part.patch.distance_bound_by_half_space(query, direction).max(part.patch.distance_bound_by_box(query));
        if part.is_too_small_to_split()
            || examined >= most
            || part.patch.max_control_distance(query) - bound <= tolerance
        {
            let candidate = LocalMinimum::new(&on_whole(), bound, false);
            undecided = Some(match undecided {
                Some(other) if other.distance <= candidate.distance => {
                    LocalMinimum { distance_bound: other.distance_bound.min(bound), ..other }
                }
                Some(other) => {
                    LocalMinimum { distance_bound: other.distance_bound.min(candidate.distance_bound), ..candidate }
                }
                None => candidate,
            });
            continue;
        }
        part.split_part(|part| parts.push(part));
    }
    undecided.into_iter().for_each(add);
}

/// True if a descent stopped because no permitted step goes down, and not short of the minimum.
fn has_descent_converged<const N: usize>(patch: &Patch<N>, foot: &FootPoint, query: DVec3) -> bool {
    foot.projected_gradient(query)
        .abs()
        .cmple(max_slope_rounding(patch, foot, query, MAX_DESCENT_PARAMETER_ERROR))
        .all()
}

/// True if the slopes across borders of the part vanish within rounding, at the end of a descent.
fn is_foot_stationary<const N: usize>(patch: &Patch<N>, foot: &FootPoint, query: DVec3) -> bool {
    let (gradient, _) = gradient_and_hessian(&foot.jet, query);
    let (permitted, slack) = (foot.projected_gradient(query), max_slope_rounding(patch, foot, query, 1e-12));
    (0..2).all(|k| permitted[k] != 0.0 || gradient[k].abs() <= slack[k])
}

/// Bounds of the computed slopes of |S - q|^2 / 2 where the true slopes vanish and the place is off
/// by `step`.
///
/// The error of the slope (S - q) . S_u is |S_u| times the rounding of S - q, plus |S - q| times
/// the rounding of S_u. The latter is not small relative to S_u where S_u vanishes, as on a fold.
/// Over a step, the slope grows by the second derivative, |S_u|^2 + (S - q) . S_uu, whose first
/// term vanishes there too.
pub(super) fn max_slope_rounding<const N: usize>(patch: &Patch<N>, foot: &FootPoint, query: DVec3, step: f64) -> DVec2 {
    let size = foot.jet.point.abs().max(query.abs()).max_element();
    let noise = patch.derivative_noise();
    let of = |along: DVec3, bend: DVec3| {
        let rounding = 64.0 * f64::EPSILON * size * along.length() + foot.distance * noise;
        rounding + step * (along.length_squared() + (foot.jet.point - query).dot(bend).abs())
    };
    DVec2::new(of(foot.jet.u, foot.jet.uu), of(foot.jet.v, foot.jet.vv))
}

/// False if a slope of the distance is nonzero everywhere in a patch.
///
/// If S is within r of the middle c, then (S - q) . S_u is within r max |S_u| of (c - q) . S_u.
fn may_have_stationary_point<const N: usize>(patch: &Patch<N>, query: DVec3) -> bool {
    let p = &patch.points;
    let count = (N * N) as f64;
    let middle = p.as_flattened().iter().sum::<DVec3>() / count;
    let (from, radius) = (middle - query, patch.max_control_distance(middle));
    let mut ranges = [[f64::INFINITY, f64::NEG_INFINITY]; 2];
    let mut longest = [0.0_f64; 2];
    let mut add = |k: usize, along: DVec3| {
        let slope = from.dot(along);
        ranges[k] = [ranges[k][0].min(slope), ranges[k][1].max(slope)];
        longest[k] = longest[k].max(along.length_squared());
    };
    for (row, next) in p.iter().zip(&p[1..]) {
        row.iter().zip(next).for_each(|(from, to)| add(0, *to - *from));
    }
    p.iter().flat_map(|row| row.windows(2)).for_each(|pair| add(1, pair[1] - pair[0]));
    let noise = from.length() * patch.derivative_noise();
    (0..2).all(|k| {
        let slack = radius * longest[k].sqrt() * (1.0 + 1e-9) + noise + f64::MIN_POSITIVE;
        ranges[k][0] <= slack && ranges[k][1] >= -slack
    })
}

/// Finds the minima of the distance along each side of a patch, including corners, from which no
/// permitted step into the patch goes down.
pub(super) fn find_side_minima<const N: usize>(patch: &Patch<N>, query: DVec3, mut add: impl FnMut(LocalMinimum)) {
    let turned = patch.transposed();
    for (side, at) in [(0, 0.0), (N - 1, 1.0)] {
        find_minima_along_curve(&patch.points[side], query, |t| {
            add_if_minimum(patch, query, DVec2::new(at, t), &mut add);
        });
        find_minima_along_curve(&turned.points[side], query, |t| {
            add_if_minimum(patch, query, DVec2::new(t, at), &mut add);
        });
    }
}

/// Passes a place on the border to `add` if no permitted step from it goes down.
fn add_if_minimum<const N: usize>(patch: &Patch<N>, query: DVec3, place: DVec2, add: &mut impl FnMut(LocalMinimum)) {
    let foot = FootPoint::from_place(patch, query, place);
    let slope = foot.projected_gradient(query);
    if slope.abs().cmple(max_slope_rounding(patch, &foot, query, 1e-9)).all() {
        add(LocalMinimum::new(&foot, foot.distance, true));
    }
}

/// Finds parameters close to all minima of the distance along a curve, including its ends.
fn find_minima_along_curve<const N: usize>(points: &[DVec3; N], query: DVec3, mut add: impl FnMut(f64)) {
    let degree = (N - 1) as f64;
    let mut parts = vec![(*points, 0.0, 1.0)];
    let mut examined = 0;
    add(0.0);
    add(1.0);
    while let Some((points, from, size)) = parts.pop() {
        examined += 1;
        let middle = points.iter().sum::<DVec3>() / N as f64;
        let radius = points.iter().map(|point| point.distance(middle)).fold(0.0, f64::max);
        let from_query = middle - query;
        let steps = || points.windows(2).map(|pair| degree * (pair[1] - pair[0]));
        let longest = steps().map(DVec3::length).fold(0.0, f64::max);
        let [low, high] = range_of_values(steps().map(|step| from_query.dot(step)));
        if low > radius * longest || high < -radius * longest {
            continue;
        }
        let bends = || points.windows(3).map(|p| degree * (degree - 1.0) * (p[2] - 2.0 * p[1] + p[0]));
        let bend = bends().map(DVec3::length).fold(0.0, f64::max);
        let along = bends().map(|bend| from_query.dot(bend)).fold(f64::INFINITY, f64::min);
        // All tangents are within `bend` of their mean.
        let least = (degree.recip() * steps().sum::<DVec3>().length() - bend).max(0.0);
        if least * least + along - radius * bend > 0.0 || size < MIN_SIDE_PART_SIZE || examined > MAX_PARTS_OF_SIDE {
            add(from + size * minimum_along_convex_curve(&points, query));
            continue;
        }
        let [low, high] = halves(&points);
        parts.push((low, from, 0.5 * size));
        parts.push((high, from + 0.5 * size, 0.5 * size));
    }
}

/// The parameter of the smallest distance along a curve whose distance is convex. Newton's method
/// on the slope, with bisection if a step leaves the bracket.
fn minimum_along_convex_curve<const N: usize>(points: &[DVec3; N], query: DVec3) -> f64 {
    let (mut low, mut high, mut t) = (0.0, 1.0, 0.5);
    let line = Patch { points: [*points; N] };
    for _ in 0..60 {
        let jet = line.jet(0.5, t);
        let from = jet.point - query;
        let (slope, second) = (from.dot(jet.v), jet.v.length_squared() + from.dot(jet.vv));
        if slope > 0.0 {
            high = t;
        } else {
            low = t;
        }
        let next = t - slope / second;
        let next = if next > low && next < high { next } else { 0.5 * (low + high) };
        if (next - t).abs() < 1e-15 {
            break;
        }
        t = next;
    }
    if t < 1e-12 {
        0.0
    } else if t > 1.0 - 1e-12 {
        1.0
    } else {
        t
    }
}

//! Where in one patch the distance is locally least.
//!
//! A part is done when one of these holds, else it is cut:
//! * *no root*: (S - q) . S_u or (S - q) . S_v is not 0 anywhere;
//! * *no minimum*: the Hessian is nowhere positive definite;
//! * *one at most*: it is positive definite everywhere: then Newton's method finds the minimum, if there is one;
//! * *flat*: the distance varies by no more than the tolerance; then it is open whether there is one, as it is where all takes too long.

use super::cell::Part;
use super::descend::{Foot, STEPS, descend, slopes};
use crate::surface::Patch;
use glam::{DVec2, DVec3};

/// How often a side may be halved.
const DEPTH: i32 = 26;
/// Parts of one patch that are looked at before it is given up.
const PARTS: usize = 192;
/// The same of a patch that has no area.
const PARTS_OF_LINE: usize = 12;

/// A place where the distance is locally least, or may be.
#[derive(Debug, Clone, Copy)]
pub(super) struct Least {
    pub(super) place: DVec2,
    pub(super) point: DVec3,
    pub(super) distance: f64,
    /// No point of the part that was looked at is nearer.
    pub(super) bound: f64,
    pub(super) proven: bool,
}

impl Least {
    pub(super) fn new(foot: &Foot, bound: f64, proven: bool) -> Least {
        let Foot { place, jet, distance } = *foot;
        Least { place, point: jet.point, distance, bound: bound.min(distance), proven }
    }
}

/// The minima inside a patch, those on its border with no slope across it included, and one that is not proven for all that is left open.
pub(super) fn minima<const N: usize>(patch: &Patch<N>, query: DVec3, tolerance: f64, mut add: impl FnMut(Least)) {
    if !may_be_flat(patch, query) {
        return;
    }
    let mut parts = vec![Part { patch: *patch, from: DVec2::ZERO, size: DVec2::ONE, bound: 0.0 }];
    let mut looked_at = 0;
    // No part of a line has a definite Hessian: cutting it up only tells where there is nothing.
    let most = if patch.has_no_area() { PARTS_OF_LINE } else { PARTS };
    let mut open: Option<Least> = None;
    while let Some(part) = parts.pop() {
        if !may_be_flat(&part.patch, query) {
            continue;
        }
        looked_at += 1;
        let foot = descend(&part.patch, query, DVec2::splat(0.5), STEPS);
        let hessian = part.patch.hessian(query, &foot);
        let noise = part.patch.noise();
        let speed = foot.jet.u.length() + foot.jet.v.length();
        if hessian.is_nowhere_definite(noise * (foot.distance + speed + noise)) {
            continue;
        }
        let whole = || Foot::at(patch, query, part.from + part.size * foot.place);
        if part.patch.least_curvature(query, &foot).is_some() {
            if is_flat(&part.patch, &foot, query) {
                add(Least::new(&whole(), part.patch.convex(query, &foot), true));
            }
            continue;
        }
        let direction = (query - foot.jet.point).normalize_or_zero();
        let bound = part.patch.half_space(query, direction).max(part.patch.box_distance(query));
        let small = part.size.min_element() <= 0.5_f64.powi(DEPTH);
        if small || looked_at >= most || part.patch.farthest(query) - bound <= tolerance {
            let found = Least::new(&whole(), bound, false);
            open = Some(match open {
                Some(other) if other.distance <= found.distance => Least { bound: other.bound.min(bound), ..other },
                Some(other) => Least { bound: other.bound.min(found.bound), ..found },
                None => found,
            });
            continue;
        }
        part.divide(|part| parts.push(part));
    }
    open.into_iter().for_each(add);
}

/// True if the slopes across borders of the part are no more than what rounding makes of 0; inside they are 0 where the descent ends.
fn is_flat<const N: usize>(patch: &Patch<N>, foot: &Foot, query: DVec3) -> bool {
    let (gradient, _) = slopes(&foot.jet, query);
    let play = play(patch, foot, query, 1e-12);
    (0..2).all(|k| (foot.place[k] > 0.0 && foot.place[k] < 1.0) || gradient[k].abs() <= play[k])
}

/// What slopes of |S - q|^2 / 2 may be where they are 0, if the place is off by `step`.
///
/// The slope (S - q) . S_u is off by |S_u| times the rounding of S - q, and by |S - q| times that of S_u, which is not small beside S_u where this
/// vanishes, as on a fold. Over a step it grows by the second derivative, |S_u|^2 + (S - q) . S_uu, of which only the last part is left
/// there.
fn play<const N: usize>(patch: &Patch<N>, foot: &Foot, query: DVec3, step: f64) -> DVec2 {
    let size = foot.jet.point.abs().max(query.abs()).max_element();
    let noise = patch.noise();
    let of = |along: DVec3, bend: DVec3| {
        let rounding = 64.0 * f64::EPSILON * size * along.length() + foot.distance * noise;
        rounding + step * (along.length_squared() + (foot.jet.point - query).dot(bend).abs())
    };
    DVec2::new(of(foot.jet.u, foot.jet.uu), of(foot.jet.v, foot.jet.vv))
}

/// False if a slope of the distance is not 0 anywhere in a patch.
///
/// (S - q) . S_u with S within r of c, the middle: it is within r max |S_u| of (c - q) . S_u.
fn may_be_flat<const N: usize>(patch: &Patch<N>, query: DVec3) -> bool {
    let p = &patch.points;
    let count = (N * N) as f64;
    let middle = p.as_flattened().iter().sum::<DVec3>() / count;
    let (from, reach) = (middle - query, patch.farthest(middle));
    let mut ranges = [[f64::INFINITY, f64::NEG_INFINITY]; 2];
    let mut most = [0.0_f64; 2];
    let mut add = |k: usize, along: DVec3| {
        let slope = from.dot(along);
        ranges[k] = [ranges[k][0].min(slope), ranges[k][1].max(slope)];
        most[k] = most[k].max(along.length_squared());
    };
    for (row, next) in p.iter().zip(&p[1..]) {
        row.iter().zip(next).for_each(|(from, to)| add(0, *to - *from));
    }
    p.iter().flat_map(|row| row.windows(2)).for_each(|pair| add(1, pair[1] - pair[0]));
    let noise = from.length() * patch.noise();
    (0..2).all(|k| {
        let play = reach * most[k].sqrt() * (1.0 + 1e-9) + noise + f64::MIN_POSITIVE;
        ranges[k][0] <= play && ranges[k][1] >= -play
    })
}

/// The minima of the distance along each side of a patch, its corners included, from which no permitted step into the patch goes down.
pub(super) fn side_minima<const N: usize>(patch: &Patch<N>, query: DVec3, mut add: impl FnMut(Least)) {
    let turned = patch.transposed();
    for (side, at) in [(0, 0.0), (N - 1, 1.0)] {
        curve_minima(&patch.points[side], query, |t| judge(patch, query, DVec2::new(at, t), &mut add));
        curve_minima(&turned.points[side], query, |t| judge(patch, query, DVec2::new(t, at), &mut add));
    }
}

/// Gives a place on the border to `add` if no permitted step from there goes down.
fn judge<const N: usize>(patch: &Patch<N>, query: DVec3, place: DVec2, add: &mut impl FnMut(Least)) {
    let foot = Foot::at(patch, query, place);
    let slope = foot.free_gradient(query);
    if slope.abs().cmple(play(patch, &foot, query, 1e-9)).all() {
        add(Least::new(&foot, foot.distance, true));
    }
}

/// Parameters near all minima of the distance along a curve, its ends included.
fn curve_minima<const N: usize>(points: &[DVec3; N], query: DVec3, mut add: impl FnMut(f64)) {
    let degree = (N - 1) as f64;
    let mut parts = vec![(*points, 0.0, 1.0)];
    let mut looked_at = 0;
    add(0.0);
    add(1.0);
    while let Some((points, from, size)) = parts.pop() {
        looked_at += 1;
        let middle = points.iter().sum::<DVec3>() / N as f64;
        let reach = points.iter().map(|point| point.distance(middle)).fold(0.0, f64::max);
        let from_query = middle - query;
        let steps = || points.windows(2).map(|pair| degree * (pair[1] - pair[0]));
        let most = steps().map(DVec3::length).fold(0.0, f64::max);
        let slopes = steps().map(|step| from_query.dot(step));
        let [low, high] = slopes.fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], x| [a.min(x), b.max(x)]);
        if low > reach * most || high < -reach * most {
            continue;
        }
        let bends = || points.windows(3).map(|p| degree * (degree - 1.0) * (p[2] - 2.0 * p[1] + p[0]));
        let bend = bends().map(DVec3::length).fold(0.0, f64::max);
        let along = bends().map(|bend| from_query.dot(bend)).fold(f64::INFINITY, f64::min);
        // All tangents are within `bend` of their mean.
        let least = (degree.recip() * steps().sum::<DVec3>().length() - bend).max(0.0);
        if least * least + along - reach * bend > 0.0 || size < 1e-7 || looked_at > 4 * PARTS {
            add(from + size * least_of(&points, query));
            continue;
        }
        let mut low = points;
        let mut high = points;
        for (k, low) in low.iter_mut().enumerate().skip(1) {
            (0..N - k).for_each(|a| high[a] = 0.5 * (high[a] + high[a + 1]));
            *low = high[0];
        }
        parts.push((low, from, 0.5 * size));
        parts.push((high, from + 0.5 * size, 0.5 * size));
    }
}

/// The parameter of the least distance along a curve whose distance is convex: by its slope, with bisection where Newton's steps leave.
fn least_of<const N: usize>(points: &[DVec3; N], query: DVec3) -> f64 {
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

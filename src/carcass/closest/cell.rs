//! The nearest point of one patch, with proof.
//!
//! A patch is done when either proof holds, else it is cut into four:
//! * *half-space*: with d the direction from the best point found to the query q, every point S of the patch has
//!   |q - S| >= (q - S) . d >= min over the control points of (q - P) . d;
//! * *convexity*: the Hessian of |S - q|^2 / 2 is positive definite over the whole patch, so that a point where no permitted step goes down
//!   is the only one, and the remaining gradient bounds what is left to gain.

use crate::carcass::{Jet, Patch};
use glam::{DMat2, DVec2, DVec3};

/// The nearest point found on a patch.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Found {
    pub(crate) distance: f64,
    pub(crate) place: DVec2,
    pub(crate) point: DVec3,
    /// No point of the patch is nearer than this.
    pub(crate) bound: f64,
}

/// Part of a patch: its control net, and where it is.
struct Part<const N: usize> {
    patch: Patch<N>,
    from: DVec2,
    size: f64,
}

/// How often a patch may be halved.
const DEPTH: i32 = 24;
/// Newton steps for one part.
const STEPS: usize = 24;

/// What a search of patches needs again and again.
pub(crate) struct Scratch<const N: usize> {
    parts: Vec<Part<N>>,
}

impl<const N: usize> Default for Scratch<N> {
    fn default() -> Self {
        // Four for each halving, less the one that is looked at.
        Scratch { parts: Vec::with_capacity(3 * DEPTH as usize + 1) }
    }
}

/// The nearest point of a patch to `query`, looked for from `start`, if it is no farther than `limit`; else some point. No point is nearer
/// than `bound`, which is the distance or the limit, or less by `tolerance`, or by more if there is no proof within [`DEPTH`] halvings.
pub(crate) fn nearest<const N: usize>(
    patch: &Patch<N>,
    query: DVec3,
    start: DVec2,
    limit: f64,
    tolerance: f64,
    scratch: &mut Scratch<N>,
) -> Found {
    let mut best = descend(patch, query, start);
    let mut local = best;
    let mut bound = f64::INFINITY;
    scratch.parts.clear();
    let mut part = Part { patch: *patch, from: DVec2::ZERO, size: 1.0 };
    loop {
        let goal = best.distance.min(limit);
        let proven = half_space(&part.patch, query, local.point).max(convex(&part.patch, query, &local));
        if proven >= goal - tolerance {
            bound = bound.min(proven);
        } else if part.size <= 0.5_f64.powi(DEPTH) {
            bound = bound.min(proven.max(part.patch.hull_distance(query)));
        } else {
            let half = 0.5 * part.size;
            let corners = [DVec2::ZERO, DVec2::Y, DVec2::X, DVec2::ONE];
            for (patch, corner) in part.patch.quarters().into_iter().zip(corners) {
                scratch.parts.push(Part { patch, from: part.from + half * corner, size: half });
            }
        }
        // The next part that may have something nearer.
        loop {
            let Some(next) = scratch.parts.pop() else {
                return Found { bound: bound.min(best.distance), ..best };
            };
            let distance = next.patch.hull_distance(query);
            if distance <= best.distance.min(limit) {
                part = next;
                break;
            }
            bound = bound.min(distance);
        }
        local = descend(&part.patch, query, DVec2::splat(0.5));
        if local.distance < best.distance {
            // As the whole patch has it: the part's control points are rounded.
            let place = part.from + part.size * local.place;
            let point = patch.point(place.x, place.y);
            best = Found { place, point, distance: point.distance(query), ..local };
        }
    }
}

impl<const N: usize> Patch<N> {
    /// A lower bound of the distance: that of the box of the control points.
    fn hull_distance(&self, query: DVec3) -> f64 {
        let (mut low, mut high) = (self.points[0][0], self.points[0][0]);
        for &point in self.points.as_flattened() {
            low = low.min(point);
            high = high.max(point);
        }
        (low - query).max(query - high).max(DVec3::ZERO).length()
    }
}

/// A point from which no permitted step goes down, or nearly: projected Newton steps on half the square of the distance.
fn descend<const N: usize>(patch: &Patch<N>, query: DVec3, start: DVec2) -> Found {
    let mut place = start.clamp(DVec2::ZERO, DVec2::ONE);
    let mut jet = patch.jet(place.x, place.y);
    let mut value = 0.5 * (jet.point - query).length_squared();
    for _ in 0..STEPS {
        let (gradient, hessian) = slopes(&jet, query);
        let free = [0, 1].map(|k| !held(place[k], gradient[k]));
        let Some(step) = step(gradient, hessian, &jet, free) else { break };
        let mut length = 1.0;
        let next = loop {
            let there = (place - length * step).clamp(DVec2::ZERO, DVec2::ONE);
            if there == place {
                break None;
            }
            let jet = patch.jet(there.x, there.y);
            let reached = 0.5 * (jet.point - query).length_squared();
            if reached < value {
                break Some((there, jet, reached));
            }
            length *= 0.25;
            if length < 1e-3 {
                break None;
            }
        };
        let Some((there, reached_jet, reached)) = next else { break };
        let small = (there - place).abs().max_element() < 1e-9;
        (place, jet, value) = (there, reached_jet, reached);
        if small {
            break;
        }
    }
    Found { distance: jet.point.distance(query), place, point: jet.point, bound: 0.0 }
}

/// True at a border that the descent would leave.
fn held(at: f64, slope: f64) -> bool {
    (at <= 0.0 && slope > 0.0) || (at >= 1.0 && slope < 0.0)
}

/// Gradient and Hessian of |S - q|^2 / 2.
fn slopes(jet: &Jet, query: DVec3) -> (DVec2, DMat2) {
    let from = jet.point - query;
    let mixed = jet.u.dot(jet.v) + from.dot(jet.uv);
    let uu = jet.u.length_squared() + from.dot(jet.uu);
    let vv = jet.v.length_squared() + from.dot(jet.vv);
    (DVec2::new(from.dot(jet.u), from.dot(jet.v)), DMat2::from_cols(DVec2::new(uu, mixed), DVec2::new(mixed, vv)))
}

/// Newton's step in the free directions, or that of Gauss and Newton where Newton's would not go down.
fn step(gradient: DVec2, hessian: DMat2, jet: &Jet, free: [bool; 2]) -> Option<DVec2> {
    let mixed = jet.u.dot(jet.v);
    let gauss = DMat2::from_cols(DVec2::new(jet.u.length_squared(), mixed), DVec2::new(mixed, jet.v.length_squared()));
    let solve = |m: DMat2| match free {
        [true, true] => {
            let sound = m.x_axis.x > 0.0 && m.determinant() > 1e-12 * m.x_axis.x * m.y_axis.y;
            sound.then(|| m.inverse() * gradient)
        }
        [true, false] => (m.x_axis.x > 0.0).then(|| DVec2::new(gradient.x / m.x_axis.x, 0.0)),
        [false, true] => (m.y_axis.y > 0.0).then(|| DVec2::new(0.0, gradient.y / m.y_axis.y)),
        [false, false] => None,
    };
    solve(hessian).or_else(|| solve(gauss)).filter(|step| step.is_finite())
}

/// A lower bound by the half-space beyond the found point.
fn half_space<const N: usize>(patch: &Patch<N>, query: DVec3, found: DVec3) -> f64 {
    let Some(direction) = (query - found).try_normalize() else { return 0.0 };
    let along = patch.points.as_flattened().iter().map(|&point| (query - point).dot(direction));
    along.fold(f64::INFINITY, f64::min).max(0.0)
}

/// The mean of vectors, and how far they are from it.
struct Bundle {
    mean: DVec3,
    radius: f64,
}

impl Bundle {
    fn of(vectors: impl Iterator<Item = DVec3> + Clone) -> Bundle {
        let (sum, count) = vectors.clone().fold((DVec3::ZERO, 0.0), |(sum, count), v| (sum + v, count + 1.0));
        let mean = sum / count;
        let radius = vectors.map(|v| v.distance_squared(mean)).fold(0.0, f64::max).sqrt();
        Bundle { mean, radius }
    }

    /// How far products of vectors of two bundles are from the product of their means.
    fn product_radius(&self, other: &Bundle) -> f64 {
        self.mean.length() * other.radius + other.mean.length() * self.radius + self.radius * other.radius
    }
}

/// A lower bound of the distance by convexity; 0 if the Hessian may not be positive definite everywhere.
fn convex<const N: usize>(patch: &Patch<N>, query: DVec3, found: &Found) -> f64 {
    let points = &patch.points;
    let degree = (N - 1) as f64;
    let all = |rows: usize, columns: usize| (0..rows).flat_map(move |a| (0..columns).map(move |b| (a, b)));
    let (second, mixed) = (degree * (degree - 1.0), degree * degree);
    let u = Bundle::of(all(N - 1, N).map(|(a, b)| degree * (points[a + 1][b] - points[a][b])));
    let v = Bundle::of(all(N, N - 1).map(|(a, b)| degree * (points[a][b + 1] - points[a][b])));
    let uu =
        Bundle::of(all(N - 2, N).map(|(a, b)| second * (points[a + 2][b] - 2.0 * points[a + 1][b] + points[a][b])));
    let vv =
        Bundle::of(all(N, N - 2).map(|(a, b)| second * (points[a][b + 2] - 2.0 * points[a][b + 1] + points[a][b])));
    let uv = Bundle::of(
        all(N - 1, N - 1)
            .map(|(a, b)| mixed * (points[a + 1][b + 1] - points[a + 1][b] - points[a][b + 1] + points[a][b])),
    );
    let from = {
        let bundle = Bundle::of(points.as_flattened().iter().copied());
        Bundle { mean: bundle.mean - query, radius: bundle.radius }
    };
    let middle = DMat2::from_cols(
        DVec2::new(u.mean.length_squared() + from.mean.dot(uu.mean), u.mean.dot(v.mean) + from.mean.dot(uv.mean)),
        DVec2::new(u.mean.dot(v.mean) + from.mean.dot(uv.mean), v.mean.length_squared() + from.mean.dot(vv.mean)),
    );
    let (a, b, c) = (middle.x_axis.x, middle.x_axis.y, middle.y_axis.y);
    let off = [
        u.product_radius(&u) + from.product_radius(&uu),
        u.product_radius(&v) + from.product_radius(&uv),
        v.product_radius(&v) + from.product_radius(&vv),
    ];
    // The smallest eigenvalue of the middle, less the largest that the rest can take away.
    let least = 0.5 * (a + c) - (0.25 * (a - c) * (a - c) + b * b).sqrt();
    let lost = 0.5 * (off[0] + off[2]) + (0.25 * (off[0] - off[2]) * (off[0] - off[2]) + off[1] * off[1]).sqrt();
    let eigenvalue = least - lost;
    if eigenvalue <= 0.0 {
        return 0.0;
    }
    let (gradient, _) = slopes(&patch.jet(found.place.x, found.place.y), query);
    let left = DVec2::from_array([0, 1].map(|k| {
        let permitted = !held(found.place[k], gradient[k]);
        if permitted { gradient[k] } else { 0.0 }
    }));
    // f >= f(x) - |g|^2 / (2 m) for a function whose Hessian is at least m.
    (found.distance * found.distance - left.length_squared() / eigenvalue).max(0.0).sqrt()
}

//! Bounds of the distance between two segments, and descents to its minima, for
//! [`near_misses`](super::near_misses).

use super::segment_part::{SegmentPart, axis_separates_hulls, chord_direction};
use crate::curve::segment::point_and_derivatives;
use glam::{DVec2, DVec3};
use gusset_base::geom::Aabb;

/// The end of a descent.
pub(super) struct DescentResult {
    pub(super) parameters: DVec2,
    /// The vector from the second point to the first.
    pub(super) gap: DVec3,
    pub(super) gradient: DVec2,
}

/// Bounds a derivative over a part by a ball: the centre and the radius.
///
/// The first derivative has the control points n (B_i+1 - B_i), the second n (n - 1) (B_i+2 - 2
/// B_i+1 + B_i).
pub(super) fn derivative_middle_and_radius(part: &SegmentPart, order: usize) -> (DVec3, f64) {
    let mut derived = part.controls;
    (0..order).for_each(|_| derived.differentiate());
    if derived.is_empty() {
        return (DVec3::ZERO, 0.0);
    }
    let mean = derived.iter().sum::<DVec3>() / derived.len() as f64;
    (mean, derived.iter().map(|v| v.distance(mean)).fold(0.0, f64::max))
}

/// Returns true if the hulls are proven to be farther apart than `within`.
pub(super) fn are_hulls_apart(a: &[DVec3], b: &[DVec3], within: f64) -> bool {
    if !Aabb::from_points(a).is_within(&Aabb::from_points(b), within) {
        return true;
    }
    let (u, v) = (chord_direction(a), chord_direction(b));
    let normal = u.cross(v).normalize_or_zero();
    let between = a[0] - b[0];
    let across = (between - between.dot(u) * u).normalize_or_zero();
    // The directions have length 1 up to rounding.
    let slack = within * (1.0 + 1e-12) + 1e-15;
    let axes = [normal, u, v, normal.cross(u), normal.cross(v), across];
    axes.into_iter().any(|axis| axis != DVec3::ZERO && axis_separates_hulls(axis, a, b, slack))
}

/// Returns the number of minima of |A(s) - B(t)|^2 / 2 in a pair, 0 or 1, proven by bounds of its
/// slopes and Hessian. Returns `None` if they prove neither.
pub(super) fn proven_minimum_count(p: &SegmentPart, q: &SegmentPart) -> Option<usize> {
    let [(here, r), (there, rr)] = [p, q].map(|part| derivative_middle_and_radius(part, 0));
    let [(a, ra), (b, rb)] = [p, q].map(|part| derivative_middle_and_radius(part, 1));
    let [(aa, raa), (bb, rbb)] = [p, q].map(|part| derivative_middle_and_radius(part, 2));
    let (gap, spread) = (here - there, r + rr);
    // Bounds the deviation of a product from the product of the means.
    let slack = |x: DVec3, rx: f64, y: DVec3, ry: f64| x.length() * ry + y.length() * rx + rx * ry;
    let sign = |slope: f64, slack: f64| if slope > slack { 1 } else { -i32::from(slope < -slack) };
    let signs = [sign(gap.dot(a), slack(gap, spread, a, ra)), sign(-gap.dot(b), slack(gap, spread, b, rb))];
    // The function falls towards an end of the part that is also an end of the segment.
    let held = |k: usize, part: &SegmentPart| {
        (signs[k] > 0 && part.start_parameter == 0.0) || (signs[k] < 0 && part.end_parameter == 1.0)
    };
    let held = [held(0, p), held(1, q)];
    if (0..2).any(|k| signs[k] != 0 && !held[k]) {
        return Some(0);
    }
    let x = a.length_squared() + gap.dot(aa) - slack(a, ra, a, ra) - slack(gap, spread, aa, raa);
    let y = b.length_squared() - gap.dot(bb) - slack(b, rb, b, rb) - slack(gap, spread, bb, rbb);
    let z = a.dot(b).abs() + slack(a, ra, b, rb);
    // If the Hessian is indefinite, minima lie only at ends of segments.
    let inner = [p, q].iter().all(|part| part.start_parameter > 0.0 && part.end_parameter < 1.0);
    let [max_x, max_y] = [
        a.length_squared() + gap.dot(aa) + slack(a, ra, a, ra) + slack(gap, spread, aa, raa),
        b.length_squared() - gap.dot(bb) + slack(b, rb, b, rb) + slack(gap, spread, bb, rbb),
    ];
    let min_z = (a.dot(b).abs() - slack(a, ra, b, rb)).max(0.0);
    if inner && (max_x < 0.0 || max_y < 0.0 || max_x * max_y < min_z * min_z) {
        return Some(0);
    }
    let convex = x > 0.0 && y > 0.0 && x * y > z * z * (1.0 + 1e-9);
    let at_end = (held[0] && (y > 0.0 || held[1])) || (held[1] && x > 0.0);
    (convex || at_end).then_some(1)
}

/// Minimises |A - B|^2 / 2 within a box by Newton and Gauss-Newton steps.
pub(super) fn minimise_distance(whole: [&[DVec3]; 2], start: DVec2, low: DVec2, high: DVec2) -> DescentResult {
    let jets = |at: DVec2| (point_and_derivatives::<3>(whole[0], at.x), point_and_derivatives::<3>(whole[1], at.y));
    let mut at = start.clamp(low, high);
    let (mut a, mut b) = jets(at);
    let slope = |a: &[DVec3; 3], b: &[DVec3; 3]| {
        let gap = a[0] - b[0];
        DVec2::new(gap.dot(a[1]), -gap.dot(b[1]))
    };
    for _ in 0..50 {
        let (gap, gradient) = (a[0] - b[0], slope(&a, &b));
        let held = |k: usize| (at[k] <= low[k] && gradient[k] > 0.0) || (at[k] >= high[k] && gradient[k] < 0.0);
        let (mixed, gauss) = (-a[1].dot(b[1]), [a[1].length_squared(), b[1].length_squared()]);
        let full = [gauss[0] + gap.dot(a[2]), gauss[1] - gap.dot(b[2])];
        let solve = |[x, y]: [f64; 2]| match (held(0), held(1)) {
            (false, false) => {
                let determinant = x * y - mixed * mixed;
                (x > 0.0 && determinant > 1e-14 * x * y).then(|| {
                    DVec2::new(gradient.x * y - gradient.y * mixed, gradient.y * x - gradient.x * mixed) / determinant
                })
            }
            (false, true) => (x > 0.0).then(|| DVec2::new(gradient.x / x, 0.0)),
            (true, false) => (y > 0.0).then(|| DVec2::new(0.0, gradient.y / y)),
            (true, true) => None,
        };
        // A Newton step; if it does not descend, a damped Gauss-Newton step, which suits valleys.
        let shorter = |step: DVec2| {
            let lengths = [1.0, 0.25, 0.0625, 0.015_625, 0.004];
            lengths.into_iter().map(move |length| (at - length * step).clamp(low, high))
        };
        // A step that leaves the box ends on the side that it crosses, where its model is least. If
        // a narrow valley continues outside, its intersection with the side is better than the
        // nearest point of the box.
        let along_sides = |step: DVec2, [x, y]: [f64; 2]| {
            let ahead = at - step;
            let end = ahead.clamp(low, high);
            let moved = end - at;
            let sides = [
                DVec2::new(end.x, at.y - (gradient.y + mixed * moved.x) / y),
                DVec2::new(at.x - (gradient.x + mixed * moved.y) / x, end.y),
            ];
            (0..2).filter(move |&k| end[k] != ahead[k]).map(move |k| sides[k].clamp(low, high))
        };
        let free = !held(0) && !held(1);
        let models = [full, gauss.map(|x| 1.000_001 * x), gauss.map(|x| 1.2 * x)];
        let steps = models.into_iter().filter_map(|model| Some((solve(model)?, model)));
        let places = steps.flat_map(|(step, model)| along_sides(step, model).filter(|_| free).chain(shorter(step)));
        let next = places.filter(|there| there.is_finite()).find_map(|there| {
            let (p, q) = jets(there);
            let down = there != at && p[0].distance_squared(q[0]) < gap.length_squared();
            down.then_some((there, p, q))
        });
        let Some((there, p, q)) = next else { break };
        (at, a, b) = (there, p, q);
    }
    DescentResult { parameters: at, gap: a[0] - b[0], gradient: slope(&a, &b) }
}

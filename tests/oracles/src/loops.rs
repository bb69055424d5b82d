//! Loops of curves by dense samples: all pairs of chords.

use glam::DVec2;

/// A chord reaches beyond another chord's line by more than this, in lengths of the chords.
const MIN_DEPTH: f64 = 1e-7;

/// The length of the largest loop where a chord of `a` crosses a chord of `b`: from there to the end of `a`,
/// and from the start of `b`. If both are one span, the length between the chords.
pub fn largest_loop(a: &[DVec2], b: &[DVec2], is_one_span: bool) -> Option<f64> {
    let (own, other) = (distances_along(a), distances_along(b));
    let total = own[own.len() - 1];
    let mut largest: Option<f64> = None;
    for i in 0..a.len() - 1 {
        for j in if is_one_span { i + 2 } else { 0 }..b.len() - 1 {
            if do_chords_cross([a[i], a[i + 1]], [b[j], b[j + 1]]) {
                let length = if is_one_span { own[j] - own[i + 1] } else { total - own[i + 1] + other[j] };
                largest = Some(largest.map_or(length, |largest| largest.max(length)));
            }
        }
    }
    largest
}

/// The length of the polyline up to each point.
pub fn distances_along(points: &[DVec2]) -> Vec<f64> {
    let mut sum = 0.0;
    let mut before = points[0];
    points
        .iter()
        .map(|&p| {
            sum += p.distance(before);
            before = p;
            sum
        })
        .collect()
}

fn do_chords_cross([p, q]: [DVec2; 2], [r, s]: [DVec2; 2]) -> bool {
    let (own, other) = (q - p, s - r);
    let least = MIN_DEPTH * own.length() * other.length();
    let changes_sides = |x: f64, y: f64| x.min(y) < -least && x.max(y) > least;
    changes_sides(own.perp_dot(r - p), own.perp_dot(s - p))
        && changes_sides(other.perp_dot(p - r), other.perp_dot(q - r))
}

/// Whether lines between points turn by a half turn or more at two points together, or reverse at one, up
/// to a tolerance.
pub fn turn_back(legs: [DVec2; 3], tolerance: f64) -> bool {
    let turn = |u: DVec2, v: DVec2| u.perp_dot(v).atan2(u.dot(v));
    let turns = [turn(legs[0], legs[1]), turn(legs[1], legs[2])];
    let half = std::f64::consts::PI - tolerance;
    turns.iter().any(|turn| turn.abs() >= half) || (turns[0] + turns[1]).abs() >= half
}

/// The point at a parameter of the segment with some control points, by de Casteljau's scheme.
pub fn point_of_segment(controls: &[DVec2], t: f64) -> DVec2 {
    let mut points = controls.to_vec();
    while points.len() > 1 {
        for i in 0..points.len() - 1 {
            points[i] = points[i].lerp(points[i + 1], t);
        }
        points.pop();
    }
    points[0]
}

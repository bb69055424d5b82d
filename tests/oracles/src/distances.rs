//! Distances of points from triangles and segments.

use glam::DVec3;

/// The corners of a triangle.
pub type Triangle = [DVec3; 3];

/// The nearest point of a segment.
pub fn nearest_on_segment(u: DVec3, v: DVec3, p: DVec3) -> DVec3 {
    let along = v - u;
    let t = if along == DVec3::ZERO { 0.0 } else { ((p - u).dot(along) / along.length_squared()).clamp(0.0, 1.0) };
    u + along * t
}

/// The nearest point of a triangle.
fn nearest_on([a, b, c]: Triangle, p: DVec3) -> DVec3 {
    let normal = (b - a).cross(c - a);
    let inside = [(a, b), (b, c), (c, a)].iter().all(|&(u, v)| (v - u).cross(p - u).dot(normal) >= 0.0);
    if inside && normal.length_squared() > 0.0 {
        return p - normal * ((p - a).dot(normal) / normal.length_squared());
    }
    let ends = [(a, b), (b, c), (c, a)].map(|(u, v)| nearest_on_segment(u, v, p));
    ends.into_iter().min_by(|q, r| q.distance(p).total_cmp(&r.distance(p))).unwrap_or(a)
}

/// The nearest point of some triangles, at least one.
pub fn nearest_on_any(triangles: &[Triangle], p: DVec3) -> DVec3 {
    let nearest = triangles.iter().map(|&triangle| nearest_on(triangle, p));
    nearest.min_by(|q, r| q.distance(p).total_cmp(&r.distance(p))).expect("there is no triangle")
}

/// Points all over some triangles, no further apart than `step`.
pub fn samples(triangles: &[Triangle], step: f64) -> Vec<DVec3> {
    let mut found = Vec::new();
    for &[a, b, c] in triangles {
        let n = (a.distance(b).max(b.distance(c)).max(c.distance(a)) / step).ceil().max(1.0) as u32;
        for (i, j) in (0..=n).flat_map(|i| (0..=n - i).map(move |j| (i, j))) {
            found.push(a + (b - a) * (f64::from(i) / f64::from(n)) + (c - a) * (f64::from(j) / f64::from(n)));
        }
    }
    found
}

/// The distance of each point from some triangles.
pub fn distances(points: &[DVec3], triangles: &[Triangle]) -> Vec<f64> {
    points.iter().map(|&p| p.distance(nearest_on_any(triangles, p))).collect()
}

/// The greatest of the [`distances`].
pub fn farthest(points: &[DVec3], triangles: &[Triangle]) -> f64 {
    distances(points, triangles).into_iter().fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn distances_from_a_right_triangle() {
        let triangle = [DVec3::ZERO, DVec3::X, DVec3::Y];
        for (p, expected) in [
            (DVec3::new(0.2, 0.3, 0.7), 0.7),
            (DVec3::new(0.5, -2.0, 0.0), 2.0),
            (DVec3::new(-3.0, -4.0, 0.0), 5.0),
            (DVec3::new(1.0, 1.0, 0.0), 0.5f64.sqrt()),
        ] {
            assert!((farthest(&[p], &[triangle]) - expected).abs() < 1e-15, "{p}");
        }
        assert_eq!(samples(&[triangle], 0.75).len(), 6);
    }
}

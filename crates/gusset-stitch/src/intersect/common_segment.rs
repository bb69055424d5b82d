//! The segment that two triangles have in common.

use glam::DVec3;

/// Returns the length of the segment in which two triangles intersect; 0 if they lie in one plane,
/// or have no more than a point in common.
///
/// Both triangles are cut by the plane of the other. The two cuts lie on the line of both planes, and
/// their overlap is the common segment (Möller 1997). Computed in floating point.
pub(crate) fn common_segment_length(t: [DVec3; 3], u: [DVec3; 3]) -> f64 {
    let normal = |[p, q, r]: [DVec3; 3]| (q - p).cross(r - p).normalize_or_zero();
    let (n, m) = (normal(t), normal(u));
    let along = n.cross(m).normalize_or_zero();
    let cuts = (cut_by_plane(t, [u[0], m], [t[0], along]), cut_by_plane(u, [t[0], n], [t[0], along]));
    let (Some([a, b]), Some([c, d])) = cuts else { return 0.0 };
    (b.min(d) - a.max(c)).max(0.0)
}

/// Returns the places along a line, in ascending order, where the sides of a triangle cross a plane
/// that contains the line. The plane has a point and a normal, and the line an origin and a
/// direction.
fn cut_by_plane(triangle: [DVec3; 3], [on_plane, normal]: [DVec3; 2], line: [DVec3; 2]) -> Option<[f64; 2]> {
    let [origin, along] = line;
    let heights = triangle.map(|p| (p - on_plane).dot(normal));
    let mut range: Option<[f64; 2]> = None;
    for k in 0..3 {
        let (h, g) = (heights[k], heights[(k + 1) % 3]);
        if (h < 0.0) == (g < 0.0) {
            continue;
        }
        let place = triangle[k].lerp(triangle[(k + 1) % 3], h / (h - g));
        let s = (place - origin).dot(along);
        range = Some(range.map_or([s, s], |[low, high]| [low.min(s), high.max(s)]));
    }
    range
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns the length of the common segment by samples: the cut of `t` by the plane of `u` is
    /// walked along, and the places inside `u` are counted.
    fn sampled_length(t: [DVec3; 3], u: [DVec3; 3]) -> f64 {
        let normal = (u[1] - u[0]).cross(u[2] - u[0]);
        let side = |p: DVec3| (p - u[0]).dot(normal);
        let mut ends = Vec::new();
        for k in 0..3 {
            let (p, q) = (t[k], t[(k + 1) % 3]);
            if (side(p) < 0.0) != (side(q) < 0.0) {
                ends.push(p + (q - p) * (side(p) / (side(p) - side(q))));
            }
        }
        let [from, to] = ends[..] else { return 0.0 };
        let is_inside = |p: DVec3| (0..3).all(|k| (u[(k + 1) % 3] - u[k]).cross(p - u[k]).dot(normal) >= 0.0);
        let steps = 20_000;
        let inside = (0..steps).filter(|&i| is_inside(from.lerp(to, (f64::from(i) + 0.5) / f64::from(steps)))).count();
        from.distance(to) * inside as f64 / f64::from(steps)
    }

    #[test]
    fn lengths_agree_with_samples() {
        let mut random = fastrand::Rng::with_seed(7);
        let mut crossing = 0;
        for _ in 0..300 {
            let mut triangle = || [(); 3].map(|()| DVec3::new(random.f64(), random.f64(), random.f64()));
            let (t, u) = (triangle(), triangle());
            let (length, expected) = (common_segment_length(t, u), sampled_length(t, u));
            assert!((length - expected).abs() < 2e-4, "{length} {expected}");
            assert!((common_segment_length(u, t) - length).abs() < 1e-12);
            crossing += usize::from(length > 0.0);
        }
        assert!(crossing > 50, "{crossing}");
    }
}

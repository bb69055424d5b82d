//! Measures of one triangle.

use glam::DVec3;

/// Returns twice the area of the triangle a, b, c: |(b - a) x (c - a)|.
#[inline]
pub fn double_area(a: DVec3, b: DVec3, c: DVec3) -> f64 {
    (b - a).cross(c - a).length()
}

/// Returns the smallest interior angle, in radians; 0 for a degenerate triangle.
///
/// The arc tangent of (cross, dot) is accurate for any angle, and `libm`'s version returns the same
/// bits on every machine.
pub fn min_angle(a: DVec3, b: DVec3, c: DVec3) -> f64 {
    smallest_corner(a, b, c).map_or(0.0, |[cross, dot]| libm::atan2(cross, dot))
}

/// Returns the tangent of the smallest interior angle; 0 for a degenerate triangle. It compares
/// triangles as [`min_angle`] does, and takes less time.
pub fn tangent_of_min_angle(a: DVec3, b: DVec3, c: DVec3) -> f64 {
    smallest_corner(a, b, c).map_or(0.0, |[cross, dot]| cross / dot)
}

/// Returns the length of the cross product, and the dot product, of the sides at the smallest
/// angle, which is opposite the shortest side; `None` if that side has no length.
fn smallest_corner(a: DVec3, b: DVec3, c: DVec3) -> Option<[f64; 2]> {
    let corner = |p: DVec3, q: DVec3, r: DVec3| {
        let (u, v) = (q - p, r - p);
        Some([u.cross(v).length(), u.dot(v)])
    };
    let (ab, bc, ca) = ((b - a).length_squared(), (c - b).length_squared(), (a - c).length_squared());
    if ab.min(bc).min(ca) == 0.0 {
        None
    } else if bc <= ab && bc <= ca {
        corner(a, b, c)
    } else if ca <= ab {
        corner(b, c, a)
    } else {
        corner(c, a, b)
    }
}

/// Returns the aspect ratio: the longest side over 2 sqrt(3) times the inradius. It is 1 for the
/// equilateral triangle and infinite for a degenerate one.
pub fn aspect_ratio(a: DVec3, b: DVec3, c: DVec3) -> f64 {
    let sides = [(b - a).length(), (c - b).length(), (a - c).length()];
    let longest = sides[0].max(sides[1]).max(sides[2]);
    let perimeter: f64 = sides.iter().sum();
    // r = 2 area / perimeter, hence longest / (2 sqrt(3) r) = longest * perimeter / (2 sqrt(3) *
    // double area).
    let area2 = double_area(a, b, c);
    if area2 == 0.0 { f64::INFINITY } else { longest * perimeter / (2.0 * 3f64.sqrt() * area2) }
}

/// Returns the barycentric coordinates of the triangle's point nearest to `p`. They are at least 0
/// and their sum is 1 up to round-off.
///
/// Source: C. Ericson, *Real-time collision detection* (2005), section 5.1.5. The signs of products
/// tell which corner, side or face has `p` in its Voronoi region.
pub fn weights_of_nearest_point([a, b, c]: [DVec3; 3], p: DVec3) -> [f64; 3] {
    let (ab, ac, ap) = (b - a, c - a, p - a);
    let (d1, d2) = (ab.dot(ap), ac.dot(ap));
    if d1 <= 0.0 && d2 <= 0.0 {
        return [1.0, 0.0, 0.0];
    }
    let bp = p - b;
    let (d3, d4) = (ab.dot(bp), ac.dot(bp));
    if d3 >= 0.0 && d4 <= d3 {
        return [0.0, 1.0, 0.0];
    }
    let cp = p - c;
    let (d5, d6) = (ab.dot(cp), ac.dot(cp));
    if d6 >= 0.0 && d5 <= d6 {
        return [0.0, 0.0, 1.0];
    }
    let (of_a, of_b, of_c) = (d3 * d6 - d5 * d4, d5 * d2 - d1 * d6, d1 * d4 - d3 * d2);
    // Keep the share from 0 to 1 even if both numbers are round-off.
    let share = |part: f64, whole: f64| if whole > 0.0 { part / whole } else { 0.0 };
    if of_c <= 0.0 && d1 >= 0.0 && d3 <= 0.0 {
        let t = share(d1, d1 - d3);
        return [1.0 - t, t, 0.0];
    }
    if of_b <= 0.0 && d2 >= 0.0 && d6 <= 0.0 {
        let t = share(d2, d2 - d6);
        return [1.0 - t, 0.0, t];
    }
    if of_a <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0 {
        let t = share(d4 - d3, (d4 - d3) + (d5 - d6));
        return [0.0, 1.0 - t, t];
    }
    let parts = [of_a, of_b, of_c].map(|part| part.max(0.0));
    let sum = parts.iter().sum::<f64>();
    if sum > 0.0 { parts.map(|part| part / sum) } else { [1.0, 0.0, 0.0] }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    #[test]
    fn the_nearest_point_is_nearer_than_a_grid_of_others() {
        let mut random = fastrand::Rng::with_seed(5);
        let mut point = || DVec3::new(random.f64(), random.f64(), random.f64());
        for _ in 0..200 {
            let corners = [point(), point(), point()];
            let p = 2.0 * point() - 0.5;
            let place =
                |weights: [f64; 3]| corners.into_iter().zip(weights).map(|(corner, w)| corner * w).sum::<DVec3>();
            let found = weights_of_nearest_point(corners, p);
            assert!(found.iter().all(|&w| w >= 0.0) && (found.iter().sum::<f64>() - 1.0).abs() < 1e-12);
            let steps = (0..=40).flat_map(|i| (0..=40 - i).map(move |j| [i, j, 40 - i - j]));
            let grid =
                steps.map(|ijk| place(ijk.map(|k| f64::from(k) / 40.0)).distance(p)).fold(f64::INFINITY, f64::min);
            let here = place(found).distance(p);
            assert!(here <= grid + 1e-12 && here >= grid - 0.05, "{here} {grid}");
        }
    }

    #[test]
    fn measures_of_known_triangles_are_exact() {
        let (o, x, y) = (DVec3::ZERO, DVec3::X, DVec3::Y);
        assert_eq!(double_area(o, x, y), 1.0);
        assert!((min_angle(o, x, y) - PI / 4.0).abs() < 1e-15);
        let top = DVec3::new(0.5, 3f64.sqrt() / 2.0, 0.0);
        for (a, b, c) in [(o, x, top), (x, top, o), (top, o, x)] {
            assert!((min_angle(a, b, c) - PI / 3.0).abs() < 1e-15);
            assert!((aspect_ratio(a, b, c) - 1.0).abs() < 1e-14);
        }
        // A needle: the far angle is about 1e-9, which an arc cosine would lose.
        assert!((min_angle(DVec3::X * 1e9, o, y) - 1e-9).abs() < 1e-20);
        assert_eq!(min_angle(o, o, x), 0.0);
        assert_eq!(aspect_ratio(o, x, 2.0 * x), f64::INFINITY);
    }
}

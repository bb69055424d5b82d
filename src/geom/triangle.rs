//! Measures of one triangle.

use glam::DVec3;

/// Twice the area of the triangle a, b, c: |(b - a) x (c - a)|.
pub(crate) fn double_area(a: DVec3, b: DVec3, c: DVec3) -> f64 {
    (b - a).cross(c - a).length()
}

/// The smallest interior angle, in radians; 0 for a degenerate triangle.
///
/// The smallest angle lies opposite the shortest side; the arc tangent of (cross, dot) is accurate
/// for any angle, and `libm`'s gives the same bits on every machine.
pub(crate) fn min_angle(a: DVec3, b: DVec3, c: DVec3) -> f64 {
    let corner = |p: DVec3, q: DVec3, r: DVec3| {
        let (u, v) = (q - p, r - p);
        libm::atan2(u.cross(v).length(), u.dot(v))
    };
    let (ab, bc, ca) = ((b - a).length_squared(), (c - b).length_squared(), (a - c).length_squared());
    if ab.min(bc).min(ca) == 0.0 {
        0.0
    } else if bc <= ab && bc <= ca {
        corner(a, b, c)
    } else if ca <= ab {
        corner(b, c, a)
    } else {
        corner(c, a, b)
    }
}

/// The longest side over 2 sqrt(3) times the radius of the inscribed circle: 1 for the equilateral
/// triangle, infinite for a degenerate one.
pub(crate) fn aspect(a: DVec3, b: DVec3, c: DVec3) -> f64 {
    let sides = [(b - a).length(), (c - b).length(), (a - c).length()];
    let longest = sides[0].max(sides[1]).max(sides[2]);
    let perimeter: f64 = sides.iter().sum();
    // r = 2 area / perimeter, hence longest / (2 sqrt(3) r) = longest * perimeter / (2 sqrt(3) *
    // double area).
    let area2 = double_area(a, b, c);
    if area2 == 0.0 { f64::INFINITY } else { longest * perimeter / (2.0 * 3f64.sqrt() * area2) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    #[test]
    fn known_triangles() {
        let (o, x, y) = (DVec3::ZERO, DVec3::X, DVec3::Y);
        assert_eq!(double_area(o, x, y), 1.0);
        assert!((min_angle(o, x, y) - PI / 4.0).abs() < 1e-15);
        let top = DVec3::new(0.5, 3f64.sqrt() / 2.0, 0.0);
        for (a, b, c) in [(o, x, top), (x, top, o), (top, o, x)] {
            assert!((min_angle(a, b, c) - PI / 3.0).abs() < 1e-15);
            assert!((aspect(a, b, c) - 1.0).abs() < 1e-14);
        }
        // A needle: the angle at the far end is about 1e-9, which an arc cosine would lose.
        assert!((min_angle(DVec3::X * 1e9, o, y) - 1e-9).abs() < 1e-20);
        assert_eq!(min_angle(o, o, x), 0.0);
        assert_eq!(aspect(o, x, 2.0 * x), f64::INFINITY);
    }
}

//! Guides: the lines through the points of an outline on which the control points lie.
//!
//! The guide of a point depends on its triangle with the two neighbours. It is the bisector, the
//! median, the normal of the chord, or in general the line to the foot that divides the chord as
//! t^2 to (1 - t)^2. Guides need a plane; an outline uses the plane through its farthest points.
//!
//! Source: Nadopta, the methods of the normal, bisector and median. O(1) for a guide, O(n) for the
//! plane.

use super::method::Method;
use super::report::PointStatus;
use super::subcurve::Subcurve;
use glam::DVec3;

/// The sine of the largest angle by which an outline may leave its plane.
const MAX_PLANE_SINE: f64 = 1e-9;

/// Returns the unit normal of the plane of a subcurve and its tangents; `None` if they do not lie in
/// one plane.
pub(super) fn subcurve_plane_normal(sub: &Subcurve<'_>) -> Option<DVec3> {
    let tangents = || sub.tangents.into_iter().flatten();
    if sub.points.iter().all(|p| p.z == 0.0) && tangents().all(|tangent| tangent.z == 0.0) {
        return Some(DVec3::Z);
    }
    let origin = sub.points[0];
    let farthest = |measure: &dyn Fn(DVec3) -> f64| {
        let mut best = (0.0, DVec3::ZERO);
        for v in sub.points.iter().map(|&p| p - origin) {
            let length = measure(v);
            if length > best.0 {
                best = (length, v);
            }
        }
        best.1
    };
    let axis = farthest(&|v| v.length_squared()).normalize_or_zero();
    let aside = farthest(&|v| v.cross(axis).length_squared());
    let normal = axis.cross(aside);
    // A straight subcurve lies in every plane that contains it.
    let normal = match normal.length() > MAX_PLANE_SINE * sub.outline_size {
        true => normal.normalize(),
        false => {
            let aside = tangents().map(|tangent| axis.cross(tangent)).max_by(|a, b| a.length().total_cmp(&b.length()));
            aside
                .filter(|across| across.length() > MAX_PLANE_SINE)
                .map_or(axis.any_orthonormal_vector(), DVec3::normalize)
        }
    };
    let are_tangents_in_plane = tangents().all(|tangent| normal.dot(tangent).abs() <= MAX_PLANE_SINE);
    are_tangents_in_plane.then_some(())?;
    sub.points.iter().all(|&p| normal.dot(p - origin).abs() <= MAX_PLANE_SINE * sub.outline_size).then_some(normal)
}

/// Returns the direction of the guide of a triangle in a plane, from the foot to the point. The
/// corners `u` and `w` precede and follow the point.
///
/// The bisector is also perpendicular to the difference of the legs' directions, which is more
/// accurate if the triangle is flat.
pub(super) fn guide_direction(method: Method, u: DVec3, w: DVec3, normal: DVec3) -> Result<DVec3, PointStatus> {
    let chord = w - u;
    let t = method.section_parameter(u, DVec3::ZERO, w)?;
    let (first, last) = (u.normalize_or_zero(), w.normalize_or_zero());
    let (along, sum) = (last - first, first + last);
    let direction = match method.chord_exponent() {
        Some(0.5) if along.length_squared() >= sum.length_squared() => normal.cross(along),
        Some(0.5) => -sum,
        None => normal.cross(chord),
        Some(_) => {
            let (before, after) = ((1.0 - t) * (1.0 - t), t * t);
            let from_foot = -(u * before + w * after) / (before + after);
            if from_foot.length() <= 1e-12 * chord.length() { normal.cross(chord) } else { from_foot }
        }
    };
    direction.try_normalize().ok_or(PointStatus::Collinear)
}

#[cfg(test)]
mod tests {
    use super::super::identify_options::Options;
    use super::*;

    #[test]
    fn plane_normals_are_found() {
        let options = Options::default();
        let normal = |points: &[DVec3]| {
            subcurve_plane_normal(&Subcurve {
                points,
                closed: false,
                tangents: [None, None],
                outline_size: 4.0,
                options: &options,
            })
        };
        assert_eq!(normal(&[DVec3::ZERO, DVec3::X, DVec3::Y]), Some(DVec3::Z));
        let tilted = [DVec3::ZERO, DVec3::new(1.0, 0.0, 1.0), DVec3::Y, DVec3::new(-2.0, 1.0, -2.0)];
        let across = normal(&tilted).unwrap();
        assert!(across.cross(DVec3::new(1.0, 0.0, -1.0)).length() < 1e-15, "{across}");
        // A straight run lies in a plane; four corners of a box do not.
        let straight = normal(&[DVec3::ZERO, DVec3::ONE, DVec3::ONE * 3.0]).unwrap();
        assert!(straight.dot(DVec3::ONE).abs() < 1e-15);
        assert_eq!(normal(&[DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z]), None);
        // Tangents determine the plane of a straight run, or leave the plane of the points.
        let with_tangent = |points: &[DVec3], tangent: DVec3| {
            let tangents = [Some(tangent), None];
            subcurve_plane_normal(&Subcurve { points, closed: false, tangents, outline_size: 4.0, options: &options })
        };
        let across = with_tangent(&[DVec3::ZERO, DVec3::ONE, DVec3::ONE * 3.0], DVec3::Y).unwrap();
        assert!(across.dot(DVec3::ONE).abs() < 1e-15 && across.y.abs() < 1e-15, "{across}");
        assert_eq!(with_tangent(&[DVec3::ZERO, DVec3::X, DVec3::Y], DVec3::Z), None);
        assert_eq!(with_tangent(&[DVec3::ZERO, DVec3::X, DVec3::Y], DVec3::X), Some(DVec3::Z));
    }

    #[test]
    fn guides_follow_the_method() {
        let (u, w) = (DVec3::new(-3.0, -4.0, 0.0), DVec3::new(7.0, -4.0, 0.0));
        // The errata's triangle: the foot of the bisector of (0, 0), (3, 4), (10, 0) is at 3.83,
        // not at 6.20 as printed.
        let bisector = guide_direction(Method::Bisector, u, w, DVec3::Z).unwrap();
        let foot = 3.0 - 4.0 * bisector.x / bisector.y;
        assert!((foot - 10.0 * 5.0 / (5.0 + 65f64.sqrt())).abs() < 1e-14, "{foot}");
        let normal = guide_direction(Method::Normal, u, w, DVec3::Z).unwrap();
        assert!(normal.x.abs() < 1e-15);
        let median = guide_direction(Method::Median, u, w, DVec3::Z).unwrap();
        assert!((3.0 - 4.0 * median.x / median.y - 5.0).abs() < 1e-14);
        // A flat triangle: across the chord. A reversal: along it.
        assert!(guide_direction(Method::Bisector, -DVec3::X, DVec3::X, DVec3::Z).unwrap().x.abs() < 1e-15);
        assert!(guide_direction(Method::Bisector, DVec3::X, DVec3::X, DVec3::Z).unwrap().y.abs() < 1e-15);
    }
}

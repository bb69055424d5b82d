//! Sections by themselves: the closed forms of the methods and of tangents, against their geometry.

use crate::plane::{METHODS, casteljau, data, lift};
use glam::DVec3;
use gusset::Job;
use gusset::curve::{Constraint, Method, Options, Outlines, PointConstraint, PointStatus, Points, sections};
use proptest::prelude::*;

#[test]
fn the_bisector_halves_the_angle() {
    // The triangle that tells the foot K / (1 + K) from the printed K: 48.56 degrees on both sides,
    // not 75.5 and 21.6.
    let [a, p, c] = [[0.0, 0.0], [3.0, 4.0], [10.0, 0.0]].map(lift);
    let section = Method::Bisector.compute_section(a, p, c).unwrap();
    let guide = p - section.control;
    for corner in [a, c] {
        let angle = guide.angle_between(corner - p).to_degrees();
        assert!((angle - 48.56).abs() < 0.005, "{angle}");
    }
    assert!(casteljau(&[a, section.control, c], section.t).distance(p) < 1e-15);
}

/// The part of the chord at which a guide through P and B meets it.
fn foot(a: DVec3, p: DVec3, c: DVec3, b: DVec3) -> f64 {
    let (chord, guide) = (c - a, b - p);
    (p - a).cross(guide).z / chord.cross(guide).z
}

proptest! {
    #[test]
    fn sections_have_their_control_points_on_their_guides(
        points in prop::array::uniform6(-1.0f64..1.0),
    ) {
        let [a, p, c] = [0, 2, 4].map(|k| DVec3::new(points[k], points[k + 1], 0.0));
        let area = (p - a).cross(c - a).z;
        prop_assume!(area.abs() > 0.05);
        for method in METHODS {
            let Ok(section) = method.compute_section(a, p, c) else {
                prop_assert_eq!(method, Method::Normal);
                let (u, v) = ((p - a).dot(c - a), (c - p).dot(c - a));
                prop_assert!(u <= 0.0 || v <= 0.0);
                continue;
            };
            prop_assert!(casteljau(&[a, section.control, c], section.t).distance(p) < 1e-13);
            // P is between the chord and B.
            prop_assert!((section.control - a).cross(c - a).z * area > area * area);
            let s = foot(a, p, c, section.control);
            let (x, y) = (a.distance(p), p.distance(c));
            let expected = match method {
                Method::Bisector => x / (x + y),
                Method::Median => 0.5,
                Method::Symmedian => x * x / (x * x + y * y),
                Method::Alpha(alpha) => x.powf(2.0 * alpha) / (x.powf(2.0 * alpha) + y.powf(2.0 * alpha)),
                Method::Normal => (p - a).dot(c - a) / (c - a).length_squared(),
            };
            prop_assert!((s - expected).abs() < 1e-9, "{method:?} {s} {expected}");
        }
    }
}

#[test]
fn tangent_sections_and_why_there_is_none() {
    use gusset::curve::{section_by_end_tangent, section_by_start_tangent, section_by_tangent};
    let [a, p, c] = [[0.0, 0.0], [1.0, 1.0], [3.0, 0.0]].map(lift);
    let along = |x, y| DVec3::new(x, y, 0.0);
    let start = section_by_start_tangent(a, p, c, along(1.0, 2.0)).unwrap();
    assert!(casteljau(&[a, start.control, c], start.t).distance(p) < 1e-15);
    assert!((start.control - a).angle_between(along(1.0, 2.0)) < 1e-7);
    let end = section_by_end_tangent(a, p, c, along(1.0, -2.0)).unwrap();
    assert!(casteljau(&[a, end.control, c], end.t).distance(p) < 1e-15);
    assert!((c - end.control).angle_between(along(1.0, -2.0)) < 1e-7);
    let middle = section_by_tangent(a, p, c, along(1.0, 0.2)).unwrap();
    assert!(casteljau(&[a, middle.control, c], middle.t).distance(p) < 1e-15);
    let direction = (middle.control - a) * (1.0 - middle.t) + (c - middle.control) * middle.t;
    assert!(direction.angle_between(along(1.0, 0.2)) < 1e-7);
    // Between P and C; backwards; P farther from the tangent than C; no direction; out of the
    // plane.
    assert_eq!(section_by_start_tangent(a, p, c, along(2.0, 1.0)), Err(PointStatus::TangentSeparates));
    assert_eq!(section_by_start_tangent(a, p, c, along(-1.0, -2.0)), Err(PointStatus::TangentBackward));
    assert_eq!(section_by_start_tangent(a, p, c, along(1.0, -0.01)), Err(PointStatus::TangentBeyond));
    assert_eq!(section_by_start_tangent(a, p, c, DVec3::ZERO), Err(PointStatus::NoTangent));
    assert_eq!(section_by_start_tangent(a, p, c, along(1.0, 2.0) + DVec3::Z), Err(PointStatus::OutOfPlane));
    assert_eq!(section_by_tangent(a, p, c, along(0.0, 1.0)), Err(PointStatus::TangentSeparates));
    assert_eq!(section_by_tangent(a, p, c, along(-1.0, 0.0)), Err(PointStatus::TangentBackward));
    assert_eq!(section_by_tangent(a, p, c, along(1.0, 0.0) + DVec3::Z * 0.1), Err(PointStatus::OutOfPlane));
}

#[test]
fn sections_of_outlines() {
    for (name, points, closed) in data() {
        for method in METHODS {
            let outlines = Outlines { points: Points::from(&points[..]), offsets: None, closed, constraints: &[] };
            let found = sections(&outlines, &Options { method, ..Options::default() }, &Job::default()).unwrap();
            let n = points.len();
            for i in 0..n {
                if !closed && (i == 0 || i == n - 1) {
                    assert_eq!(found.controls[i], lift(points[i]));
                    continue;
                }
                let [a, p, c] = [(i + n - 1) % n, i, (i + 1) % n].map(|i| lift(points[i]));
                let reach = a.distance(p) + p.distance(c) + p.length();
                let miss = casteljau(&[a, found.controls[i], c], found.parameters[i]).distance(p);
                assert!(miss <= 1e-14 * reach, "{name} {i} {miss:e}");
            }
        }
    }
    let points = [[0.0, 0.0], [1.0, 1.0], [3.0, 0.0]];
    let tangent = DVec3::new(1.0, 2.0, 0.0);
    for (point, expected) in [
        (0, gusset::curve::section_by_start_tangent(lift(points[0]), lift(points[1]), lift(points[2]), tangent)),
        (1, gusset::curve::section_by_tangent(lift(points[0]), lift(points[1]), lift(points[2]), DVec3::X)),
    ] {
        let tangent = if point == 0 { tangent } else { DVec3::X };
        let constraints = [Constraint { point, kind: PointConstraint::Tangent(tangent) }];
        let outlines =
            Outlines { points: Points::from(&points[..]), offsets: None, closed: false, constraints: &constraints };
        let found = sections(&outlines, &Options::default(), &Job::default()).unwrap();
        assert!(found.controls[1].distance(expected.unwrap().control) < 1e-15);
    }
}

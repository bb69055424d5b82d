//! Outlines: the curves pass their points, are smooth where they should be, and move with their
//! points.

use crate::common::Silent;
use crate::plane::{METHODS, casteljau, data, lift};
use glam::DVec3;
use gusset::Job;
use gusset::curve::{
    Constraint, CurveKind, CurveView, Ends, Fit, FitStatus, JointParameter, Method, Options, Outlines, Place,
    PointConstraint, PointStatus, Points, fit,
};
use proptest::prelude::*;
use std::f64::consts::{PI, TAU};

pub(crate) const CURVE_KINDS: [CurveKind; 4] =
    [CurveKind::Composite, CurveKind::BlendC1, CurveKind::BlendC2, CurveKind::CubicC2];

/// The tangent of an angle, in radians counter-clockwise from the x-axis, in the plane z = 0.
pub(crate) fn tangent_of_angle(angle: f64) -> DVec3 {
    DVec3::new(angle.cos(), angle.sin(), 0.0)
}

pub(crate) fn at(curve: CurveView<'_>, place: Place) -> DVec3 {
    casteljau(curve.segment(place.segment as usize), place.t)
}

pub(crate) fn one(points: &[[f64; 2]], closed: bool, constraints: &[Constraint], options: &Options) -> Fit {
    let outlines = Outlines { points: Points::from(points), offsets: None, closed, constraints };
    fit(&outlines, options, &Job::default()).unwrap()
}

pub(crate) fn size_of(points: &[[f64; 2]]) -> f64 {
    let span = |k: usize| {
        let values = points.iter().map(|p| p[k]);
        values.clone().fold(f64::MIN, f64::max) - values.fold(f64::MAX, f64::min)
    };
    span(0).max(span(1))
}

/// The curve interpolates each point unless its status says otherwise. No number is NaN, and joints
/// except corners are smooth.
pub(crate) fn assert_passes(points: &[[f64; 2]], done: &Fit, name: &str) {
    let (curve, size) = (done.curve(0), size_of(points));
    assert_eq!(done.statuses().len(), points.len());
    assert!(curve.points().iter().all(|p| p.is_finite()), "{name}");
    let far = points.iter().flatten().fold(0.0f64, |m, x| m.max(x.abs()));
    for (i, &p) in points.iter().enumerate() {
        if done.statuses()[i] == PointStatus::Missed {
            continue;
        }
        let scale = 1.0 / (size + far);
        let miss = (at(curve, done.place(i)) * scale).distance(lift(p) * scale) * (size + far);
        // Merged points may be off by the tolerance; other errors are rounding, also of the
        // coordinates.
        let merged = if done.statuses()[i] == PointStatus::Merged { 2e-12 * size } else { 0.0 };
        assert!(miss <= 4.0 * f64::EPSILON * (size + far) + merged, "{name}: point {i} {miss:e} of {size}");
    }
    let report = done.reports()[0];
    assert!(report.max_residual <= 4.0 * f64::EPSILON, "{name}: {:e}", report.max_residual);
    assert!(report.max_joint_sine.is_finite() && report.size.is_finite());
}

/// |sin| at the smooth joints, against the size over the length of the shorter leg.
pub(crate) fn assert_smooth(done: &Fit, size: f64, name: &str) {
    let curve = done.curve(0);
    let n = curve.len();
    for k in 0..if curve.is_closed() { n } else { n - 1 } {
        let (a, b) = (curve.segment(k), curve.segment((k + 1) % n));
        let (u, v) = (a[a.len() - 1] - a[a.len() - 2], b[1] - b[0]);
        let shorter = u.length().min(v.length());
        if shorter > 1e-9 * size {
            let sine = u.cross(v).length() / (u.length() * v.length());
            assert!(
                sine <= 1e-14 * (size / shorter).max(1.0),
                "{name}: joint {k} of {n}: {sine:e}, {shorter:e} of {size}"
            );
        }
    }
}

#[test]
fn real_outlines_in_all_modes_by_all_methods() {
    for (name, points, closed) in data() {
        let size = size_of(&points);
        for curve_kind in CURVE_KINDS {
            for method in METHODS {
                let name = format!("{name} {curve_kind:?} {method:?}");
                let done = one(&points, closed, &[], &Options { curve: curve_kind, method, ..Options::default() });
                assert_passes(&points, &done, &name);
                assert_smooth(&done, size, &name);
                let few = done.statuses().iter().filter(|&&s| s == PointStatus::Missed).count();
                assert_eq!(few, 0, "{name}");
                if curve_kind == CurveKind::Composite {
                    let distinct = done.statuses().iter().filter(|&&s| s != PointStatus::Merged).count();
                    assert_eq!(done.curve(0).len(), if closed { distinct } else { distinct - 2 }, "{name}");
                }
            }
        }
    }
}

/// The largest distance of the points of a dense polygon from a curve, by the nearest of many
/// points of the curve and their chords.
fn deviation(curve: CurveView<'_>, truth: &[[f64; 2]]) -> f64 {
    let mut polyline = Vec::new();
    for segment in curve.segments() {
        polyline.extend((0..40).map(|k| casteljau(segment, f64::from(k) / 40.0)));
    }
    polyline.push(polyline[0]);
    let to_chord = |p: DVec3, a: DVec3, b: DVec3| {
        let t = ((p - a).dot(b - a) / (b - a).length_squared()).clamp(0.0, 1.0);
        p.distance(a.lerp(b, t))
    };
    let nearest = |p: DVec3| polyline.windows(2).map(|c| to_chord(p, c[0], c[1])).fold(f64::MAX, f64::min);
    truth.iter().map(|&p| nearest(lift(p))).fold(0.0, f64::max)
}

#[test]
fn curves_are_near_what_the_points_were_taken_from() {
    let all = data();
    let dense = |name: &str| all.iter().find(|outline| outline.0 == name.replace(".csv", "_dense.csv"));
    let median = |curve_kind, method| {
        let mut deviations: Vec<f64> = Vec::new();
        for (name, points, _) in all.iter().filter(|outline| outline.0.starts_with("footlike")) {
            if let Some((_, truth, _)) = dense(name) {
                let done = one(points, true, &[], &Options { curve: curve_kind, method, ..Options::default() });
                deviations.push(deviation(done.curve(0), truth) / size_of(truth));
            }
        }
        deviations.sort_by(f64::total_cmp);
        let middle = deviations.len() / 2;
        (middle > 0).then(|| (deviations[middle - 1] + deviations[middle]) / 2.0)
    };
    for (curve_kind, method, bar) in [
        (CurveKind::Composite, Method::Bisector, 1.85e-3),
        (CurveKind::Composite, Method::Median, 1.85e-3),
        (CurveKind::CubicC2, Method::Bisector, 1.40e-3),
    ] {
        if let Some(found) = median(curve_kind, method) {
            println!("{curve_kind:?} {method:?}: median of the largest deviations {found:.3e} of the size");
            assert!(found <= bar, "{curve_kind:?} {method:?} {found:e}");
        }
    }
}

proptest! {
    /// Wild points: repeats, straight lines, spikes, few points; all modes, open and closed.
    #[test]
    fn wild_outlines_do_no_harm(
        points in prop::collection::vec((-3i8..4, -3i8..4, 0u8..12), 0..14),
        closed: bool,
        curve_kind in prop::sample::select(CURVE_KINDS.to_vec()),
        method in prop::sample::select(METHODS.to_vec()),
        joint in prop::sample::select(vec![JointParameter::Half, JointParameter::Knot]),
        corner in prop::sample::select(vec![PI, 1.0, 0.1]),
        ends in prop::sample::select(vec![Ends::Free, Ends::Perpendicular]),
        scale in prop::sample::select(vec![1.0, 1e-150, 1e150, 1e300]),
    ) {
        let points: Vec<[f64; 2]> = points
            .iter()
            // Some are a million times nearer to each other than others.
            .map(|&(x, y, near)| {
                let small = if near < 3 { 1e-6 } else { 1.0 };
                [scale * small * f64::from(x), scale * small * f64::from(y)]
            })
            .collect();
        let options = Options { curve: curve_kind, method, joint, ends, corner_angle: corner, ..Options::default() };
        let done = one(&points, closed, &[], &options);
        assert_passes(&points, &done, "wild");
        let report = done.reports()[0];
        let missed = done.statuses().contains(&PointStatus::Missed);
        prop_assert_eq!(missed, report.status == FitStatus::TooFewPoints && missed);
        prop_assert_eq!(report.not_ok as usize, done.statuses().iter().filter(|&&s| s != PointStatus::Ok).count());
    }

    /// The curve moves with its points: turned, moved, enlarged, run through backwards, begun
    /// elsewhere.
    #[test]
    fn curves_move_with_their_points(
        radii in prop::collection::vec(0.7f64..1.3, 5..40),
        angle in 0.0..TAU,
        shift in 1usize..4,
        curve_kind in prop::sample::select(CURVE_KINDS.to_vec()),
        method in prop::sample::select(vec![Method::Bisector, Method::Median, Method::Symmedian]),
    ) {
        let n = radii.len();
        let points: Vec<[f64; 2]> = radii
            .iter()
            .enumerate()
            .map(|(i, r)| { let t = TAU * i as f64 / n as f64; [r * t.cos(), r * t.sin()] })
            .collect();
        let options = Options { curve: curve_kind, method, ..Options::default() };
        let plain = one(&points, true, &[], &options);
        let curve = plain.curve(0);
        let (sin, cos) = angle.sin_cos();
        let moves: [&dyn Fn(DVec3) -> DVec3; 3] = [
            &|p| DVec3::new(cos * p.x - sin * p.y, sin * p.x + cos * p.y, 0.0),
            &|p| p + DVec3::new(0.25, -0.5, 0.0),
            &|p| p * 3.7,
        ];
        for (k, moved) in moves.iter().enumerate() {
            let other: Vec<[f64; 2]> = points.iter().map(|&p| { let q = moved(lift(p)); [q.x, q.y] }).collect();
            let done = one(&other, true, &[], &options);
            for (p, q) in curve.points().iter().zip(done.curve(0).points()) {
                prop_assert!(moved(*p).distance(*q) < 1e-13 * 4.0, "move {k}: {p} {q}");
            }
        }
        let ring = &curve.points()[..curve.points().len() - 1];
        let near = |p: DVec3, list: &[DVec3]| list.iter().any(|q| p.distance(*q) < 1e-13);
        let shifted: Vec<[f64; 2]> = (0..n).map(|i| points[(i + shift) % n]).collect();
        let mut backwards = points.clone();
        backwards.reverse();
        for other in [shifted, backwards] {
            let done = one(&other, true, &[], &options);
            prop_assert_eq!(done.curve(0).points().len(), curve.points().len());
            prop_assert!(done.curve(0).points().iter().all(|&p| near(p, ring)));
        }
    }

    /// One call for many outlines is many calls for one, with any number of threads.
    #[test]
    fn batches_and_threads_change_nothing(
        sizes in prop::collection::vec(0usize..9, 1..40),
        closed: bool,
        curve_kind in prop::sample::select(CURVE_KINDS.to_vec()),
    ) {
        let mut points: Vec<[f64; 2]> = Vec::new();
        let mut offsets = vec![0u32];
        let mut constraints = Vec::new();
        for (k, &size) in sizes.iter().enumerate() {
            for i in 0..size * 300 {
                let t = i as f64 * 0.7 + k as f64;
                if i % 97 == 5 {
                    let kind = if i % 2 == 0 { PointConstraint::Corner } else { PointConstraint::Tangent(tangent_of_angle(t)) };
                    constraints.push(Constraint { point: points.len() as u32, kind });
                }
                points.push([t.cos() + 0.01 * t, (1.3 * t).sin()]);
            }
            offsets.push(points.len() as u32);
        }
        let outlines =
            Outlines { points: Points::from(&points[..]), offsets: Some(&offsets), closed, constraints: &constraints };
        let options = Options { curve: curve_kind, ..Options::default() };
        let all = [1, 2, 3].map(|threads| fit(&outlines, &options, &Job::new(threads, &Silent)).unwrap());
        prop_assert!(all[0] == all[1] && all[1] == all[2]);
        for k in 0..sizes.len() {
            let span = offsets[k] as usize..offsets[k + 1] as usize;
            let own: Vec<Constraint> = constraints
                .iter()
                .filter(|c| span.contains(&(c.point as usize)))
                .map(|c| Constraint { point: c.point - offsets[k], ..*c })
                .collect();
            let single = one(&points[span.clone()], closed, &own, &options);
            prop_assert_eq!(single.curve(0).points(), all[0].curve(k).points());
            prop_assert_eq!(single.curve(0).ends(), all[0].curve(k).ends());
            prop_assert_eq!(single.statuses(), &all[0].statuses()[span]);
            prop_assert_eq!(single.reports()[0], all[0].reports()[k]);
        }
    }
}

#[test]
fn tangents_and_corners_are_kept() {
    let ring: Vec<[f64; 2]> = (0..9).map(|i| (TAU * f64::from(i) / 9.0).sin_cos()).map(|(y, x)| [2.0 * x, y]).collect();
    for closed in [true, false] {
        for curve_kind in CURVE_KINDS {
            let options = Options { curve: curve_kind, ..Options::default() };
            let tau = tangent_of_angle(2.0);
            let constraints = [
                Constraint { point: 0, kind: PointConstraint::Tangent(tau) },
                Constraint { point: 3, kind: PointConstraint::Tangent(DVec3::new(-7.0, 0.5, 0.0)) },
                Constraint { point: 4, kind: PointConstraint::Tangent(DVec3::new(-1.0, 0.0, 0.0)) },
                Constraint { point: 6, kind: PointConstraint::Corner },
                Constraint { point: 8, kind: PointConstraint::Tangent(DVec3::Y) },
            ];
            let done = one(&ring, closed, &constraints, &options);
            assert_passes(&ring, &done, "ring");
            let curve = done.curve(0);
            for constraint in &constraints {
                let PointConstraint::Tangent(tangent) = constraint.kind else { continue };
                let place = done.place(constraint.point as usize);
                let joint = place.segment as usize + usize::from(place.t == 1.0);
                let n = curve.len();
                assert!(place.t == 0.0 || place.t == 1.0);
                for (segment, leg) in [(joint, 0), (joint + n - 1, 1)] {
                    // An open curve has nothing beyond its ends.
                    if !closed && joint == if leg == 0 { n } else { 0 } {
                        continue;
                    }
                    let s = curve.segment(segment % n);
                    let leg = if leg == 0 { s[1] - s[0] } else { s[s.len() - 1] - s[s.len() - 2] };
                    assert!(
                        leg.cross(tangent).length() < 1e-12 && leg.dot(tangent) > 0.0,
                        "{curve_kind:?} {closed} {constraint:?} {leg}"
                    );
                }
            }
            // Smooth everywhere but at the corner, where it turns.
            assert!(done.reports()[0].max_joint_sine < 1e-12, "{curve_kind:?} {closed} {:?}", done.reports()[0]);
            let corner = done.place(6);
            let (a, b) = (curve.segment(corner.segment as usize - 1), curve.segment(corner.segment as usize));
            let (u, v) = (a[a.len() - 1] - a[a.len() - 2], b[1] - b[0]);
            assert!(u.cross(v).length() > 1e-6 * u.length() * v.length(), "{curve_kind:?}");
        }
    }
}

#[test]
fn perpendicular_ends_are_perpendicular() {
    let points = [[0.0, 0.0], [0.5, 1.0], [2.0, 1.2], [3.0, 0.9], [4.0, 0.0]];
    for curve_kind in CURVE_KINDS {
        let done =
            one(&points, false, &[], &Options { curve: curve_kind, ends: Ends::Perpendicular, ..Options::default() });
        assert_passes(&points, &done, "perpendicular");
        let curve = done.curve(0);
        let (first, last) = (curve.segment(0), curve.segment(curve.len() - 1));
        let start = first[1] - first[0];
        let end = last[last.len() - 1] - last[last.len() - 2];
        let p = points.map(lift);
        assert!(start.normalize().dot((p[2] - p[0]).normalize()).abs() < 1e-14);
        assert!(end.normalize().dot((p[4] - p[2]).normalize()).abs() < 1e-14);
        assert!(start.dot(p[1] - p[0]) > 0.0 && end.dot(p[4] - p[3]) > 0.0);
    }
    // A straight beginning lacks a perpendicular, and reports it.
    let done = one(
        &[[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [3.0, 1.0]],
        false,
        &[],
        &Options { ends: Ends::Perpendicular, ..Options::default() },
    );
    assert_eq!(done.statuses()[0], PointStatus::Collinear);
}

#[test]
fn corners_are_found_by_their_angle() {
    let square: Vec<[f64; 2]> = (0..12)
        .map(|i| {
            let s = f64::from(i % 3) / 3.0;
            match i / 3 {
                0 => [s, 0.0],
                1 => [1.0, s],
                2 => [1.0 - s, 1.0],
                _ => [0.0, 1.0 - s],
            }
        })
        .collect();
    for curve_kind in CURVE_KINDS {
        let done = one(&square, true, &[], &Options { curve: curve_kind, corner_angle: 1.0, ..Options::default() });
        // A square comes out as a square.
        for k in 0..50 {
            for segment in done.curve(0).segments() {
                let p = casteljau(segment, f64::from(k) / 50.0);
                let edge = p.x.abs().min((1.0 - p.x).abs()).min(p.y.abs()).min((1.0 - p.y).abs());
                assert!(edge < 1e-14, "{curve_kind:?} {p}");
            }
        }
        assert_eq!(done.reports()[0].status, FitStatus::Ok);
    }
}

#[test]
fn closed_composites_of_a_regular_polygon_are_regular() {
    for method in METHODS {
        let ring: Vec<[f64; 2]> = (0..12).map(|i| (TAU * f64::from(i) / 12.0).sin_cos()).map(|(y, x)| [x, y]).collect();
        let done = one(&ring, true, &[], &Options { method, ..Options::default() });
        let curve = done.curve(0);
        assert!(curve.is_closed() && curve.len() == 12);
        // All control points are alike, the seam's too: (1/4) J + (1/2) B + (1/4) J' = P with J
        // half-way gives B = P / cos^2(15 degrees).
        let radius = 2.0 / (1.0 + (TAU / 24.0).cos().powi(2));
        for segment in curve.segments() {
            assert!((segment[1].length() - radius).abs() < 1e-14, "{method:?} {}", segment[1].length());
        }
    }
}

#[test]
fn plane_outlines_stay_in_their_plane() {
    let there_and_back = [[0.0, 0.0], [1.0, 1.0], [2.0, 2.0], [3.0, 3.0], [1.0, 1.0]];
    for curve_kind in
        [CurveKind::Composite, CurveKind::BlendC1, CurveKind::BlendC2, CurveKind::CubicC2, CurveKind::Single]
    {
        let done = one(&there_and_back, true, &[], &Options { curve: curve_kind, ..Options::default() });
        assert!(done.curve(0).points().iter().all(|p| p.z == 0.0), "{curve_kind:?}");
    }
}

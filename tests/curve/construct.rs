//! Results made of curves: samples, texts, contours, splines, offsets. They are compared with
//! formulas and with the original curves.

use crate::curves::*;
use glam::DVec3;
use gusset::curve::ops::{OffsetOptions, SampleSpacing};
use gusset::curve::{CurveView, Place};
use gusset::{Error, Job};
use proptest::prelude::*;

#[test]
fn samples_of_a_circle() {
    let given = circle(1.0, 8);
    let curve = given.view();
    let samples = curve.sample_points(SampleSpacing::Count(12), &Job::default()).unwrap();
    for k in 0..12 {
        let gap = samples.points[k].distance(samples.points[(k + 1) % 12]);
        assert!((gap - 2.0 * (std::f64::consts::PI / 12.0).sin()).abs() < 1e-5, "{gap}");
    }
    let step = curve.length().unwrap() / 10.0;
    assert_eq!(curve.sample_points(SampleSpacing::Step(step), &Job::default()).unwrap().points.len(), 10);
    assert_eq!(curve.sample_points(SampleSpacing::Step(step * 1.01), &Job::default()).unwrap().points.len(), 10);
    assert_eq!(curve.sample_points(SampleSpacing::Step(100.0), &Job::default()).unwrap().points.len(), 1);
    let endless = curve.sample_points(SampleSpacing::Step(f64::INFINITY), &Job::default()).unwrap_err();
    assert!(matches!(endless, Error::OptionOutOfRange { option: "step", value: f64::INFINITY, .. }));
    let open = parabola(0.0, 1.0);
    assert_eq!(open.view().sample_points(SampleSpacing::Count(5), &Job::default()).unwrap().places[4], at(0, 1.0));
    let length = open.view().length().unwrap();
    assert_eq!(open.view().sample_points(SampleSpacing::Step(length / 4.0), &Job::default()).unwrap().points.len(), 5);
    assert_eq!(open.view().sample_points(SampleSpacing::Step(length / 3.5), &Job::default()).unwrap().points.len(), 5);
    assert!(
        open.view().sample_points(SampleSpacing::Count(1), &Job::default()).is_err()
            && open.view().sample_points(SampleSpacing::Step(0.0), &Job::default()).is_err()
    );
    assert!(matches!(
        open.view().sample_points(SampleSpacing::Step(1e-300), &Job::default()),
        Err(Error::TooLarge { .. })
    ));
    for tolerance in [0.5, 1e-2, 1e-4, 1e-6] {
        let samples = curve.sample_points(SampleSpacing::Chord(tolerance), &Job::default()).unwrap();
        let polygon = |k: usize| (samples.points[k], samples.points[(k + 1) % samples.points.len()]);
        let worst = (0..2000)
            .map(|k| {
                let p = given.point(f64::from(k) * 8.0 / 2000.0);
                (0..samples.points.len())
                    .map(|k| {
                        let (a, b) = polygon(k);
                        let t = ((p - a).dot(b - a) / (b - a).length_squared()).clamp(0.0, 1.0);
                        p.distance(a + (b - a) * t)
                    })
                    .fold(f64::INFINITY, f64::min)
            })
            .fold(0.0, f64::max);
        assert!(worst <= tolerance, "{tolerance} {worst}");
        // A chord of n has the height 1 - cos(pi / n), about 5 / n^2: not many more than needed.
        assert!((samples.points.len() as f64) < 9.0 + 2.5 * (5.0 / tolerance).sqrt());
    }
}

#[test]
fn texts_and_contours_and_splines() {
    let given = Given {
        points: vec![
            v(0.0, 0.0, 0.0),
            v(0.1, -0.0, 0.0),
            v(1e-7, 1.5e300, 0.0),
            v(1.0, 2.0, 0.0),
            v(3.0, 4.0, 0.0),
            v(5.0, 6.0, 0.0),
            v(0.0, 0.0, 0.0),
        ],
        ends: vec![0, 1, 3, 6],
        closed: true,
    };
    assert_eq!(given.view().to_svg_path(&Job::default()).unwrap(), "M 0 0 L 0.1 0 Q 1e-7 1.5e300 1 2 C 3 4 5 6 0 0 Z");
    assert!(
        given.view().to_truetype_contour(0.0, &Job::default()).is_err()
            && given.view().to_clamped_spline(&Job::default()).is_err()
    );
    let quartic = Given::one(&[v(0.0, 0.0, 0.0); 5]);
    assert!(matches!(quartic.view().to_svg_path(&Job::default()), Err(Error::OptionOutOfRange { .. })));
    // Round control points with joints in the middle: all points off the curve; with a line, two on
    // it.
    let controls = [v(1.0, 0.3, 0.0), v(3.1, 0.7, 0.0), v(3.0, 2.0, 0.0), v(0.2, 1.9, 0.0)];
    let mut points = vec![controls[3].midpoint(controls[0])];
    for k in 0..4 {
        points.extend([controls[k], controls[k].midpoint(controls[(k + 1) % 4])]);
    }
    let round = Given { points: points.clone(), ends: vec![0, 2, 4, 6, 8], closed: true };
    let contour = round.view().to_truetype_contour(0.0, &Job::default()).unwrap();
    assert_eq!((contour.points, contour.on_curve), (controls.to_vec(), vec![0; 4]));
    let spline = round.view().to_clamped_spline(&Job::default()).unwrap();
    assert_eq!((spline.degree, spline.controls.len(), spline.knots.len()), (2, 6, 9));
    for (k, t) in [(0, 0.3), (1, 0.5), (2, 0.9), (3, 1.0)] {
        // Knots with equal intervals, 0 to 4 except at the ends.
        let knot = |k: usize| spline.knots[k + 2];
        let x = knot(k) + t * (knot(k + 1) - knot(k));
        assert!(de_boor(&spline, x).distance(round.view().point(at(k as u32, t)).unwrap()) < 1e-14);
    }
    points.splice(1..2, []);
    let mixed = Given { points, ends: vec![0, 1, 3, 5, 7], closed: true };
    assert_eq!(mixed.view().to_truetype_contour(0.0, &Job::default()).unwrap().on_curve, [1, 1, 0, 0, 0]);
    assert!(Given { closed: false, ..mixed }.view().to_truetype_contour(0.0, &Job::default()).is_err());
}

/// The point of a B-spline by de Boor's scheme.
fn de_boor(spline: &gusset::curve::ops::ClampedSpline, x: f64) -> DVec3 {
    let (n, knots) = (spline.degree, &spline.knots);
    let mut k = n;
    while k + 1 < spline.controls.len() && knots[k + 1] <= x {
        k += 1;
    }
    let mut d: Vec<DVec3> = (0..=n).map(|i| spline.controls[k - n + i]).collect();
    for r in 1..=n {
        for i in (r..=n).rev() {
            let j = k - n + i;
            let a = (x - knots[j]) / (knots[j + n + 1 - r] - knots[j]);
            d[i] = d[i - 1] * (1.0 - a) + d[i] * a;
        }
    }
    d[n]
}

proptest! {
    #[test]
    fn higher_degrees_keep_the_curve_and_come_down_again(given in curves(false), by in 0usize..5) {
        let curve = given.view();
        let unit = size(&given);
        let raised = curve.with_degree_elevated_by(by, &Job::default()).unwrap();
        prop_assert!(apart(&curve, &raised.view()) <= 1e-14 * unit);
        prop_assert!(curve.with_degree_elevated_by(64, &Job::default()).is_err());
        let seventh = curve.with_degree_elevated_to(7, &Job::default()).unwrap();
        prop_assert!(seventh.view().segments().all(|c| c.len() == 8));
        prop_assert!(apart(&curve, &seventh.view()) <= 1e-14 * unit);
        // Raising the degree and reducing it again gives the original curve.
        let back = seventh.view().with_reduced_degree(6, 1e-10 * unit, &Job::default()).unwrap();
        prop_assert!(back.kept.is_empty());
        prop_assert!(apart(&curve, &back.curve.view()) <= 1e-11 * unit);
        // The bound holds, and segments beyond the tolerance are kept.
        let low = curve.with_reduced_degree(2, f64::INFINITY, &Job::default()).unwrap();
        for k in 0..curve.len() as u32 {
            for i in 0..=10 {
                let place = at(k, f64::from(i) / 10.0);
                let off = (low.curve.view().point(place).unwrap() - curve.point(place).unwrap()) / unit;
                prop_assert!(off.length() <= low.deviations[k as usize] / unit + 1e-14);
            }
        }
        let kept = curve.with_reduced_degree(2, 0.0, &Job::default()).unwrap();
        prop_assert!(kept.curve.view().segments().zip(curve.segments()).zip(&kept.deviations).all(|((a, b), &d)| d == 0.0 || a == b));
    }

    #[test]
    fn splines_are_the_curve(given in curves(false), degree in 6usize..8) {
        let uniform = given.view().with_degree_elevated_to(degree, &Job::default()).unwrap();
        let spline = uniform.view().to_clamped_spline(&Job::default()).unwrap();
        prop_assert_eq!(spline.knots.len(), spline.controls.len() + degree + 1);
        let mut distinct = spline.knots.clone();
        distinct.dedup();
        prop_assert_eq!(distinct.len(), uniform.view().len() + 1);
        for k in 0..uniform.view().len() {
            for t in [0.0, 0.25, 0.5, 0.99] {
                let x = distinct[k] + t * (distinct[k + 1] - distinct[k]);
                let q = uniform.view().point(at(k as u32, t)).unwrap();
                prop_assert!((de_boor(&spline, x) - q).abs().max_element() <= 1e-8 * size(&given), "{} {} {:?}", k, t, spline.knots);
            }
        }
    }

    #[test]
    fn paths_read_back_as_the_same_bits(given in curves(true)) {
        let curve = given.view();
        if curve.segments().any(|c| c.len() > 4) {
            prop_assert!(curve.to_svg_path(&Job::default()).is_err());
            return Ok(());
        }
        let text = curve.to_svg_path(&Job::default()).unwrap();
        let numbers: Vec<f64> = text.split(' ').filter_map(|word| word.parse().ok()).collect();
        let coordinates: Vec<f64> = given.points.iter().flat_map(|p| [p.x, p.y]).collect();
        prop_assert_eq!(numbers, coordinates);
        prop_assert_eq!(text.ends_with('Z'), given.closed);
    }
}

fn offset_options(degree: usize, tolerance: f64) -> OffsetOptions {
    OffsetOptions { degree, tolerance, max_segments: 10_000 }
}

/// The largest difference of the distance from `given` of points of `offset`, and `distance`.
fn off_by(given: &CurveView<'_>, offset: &CurveView<'_>, distance: f64) -> f64 {
    let places: Vec<Place> =
        (0..offset.len() as u32).flat_map(|k| (0..=20).map(move |i| at(k, f64::from(i) / 20.0))).collect();
    let found =
        given.nearest_to_each_query(&offset.points_at(&places, &Job::default()).unwrap(), &Job::default()).unwrap();
    found.iter().fold(0.0, |m, n| f64::max(m, (n.distance - distance.abs()).abs()))
}

#[test]
fn offsets_of_circles_and_parabolas() {
    for scale in [1.0, 1e200, 1e-200] {
        let given = circle(scale, 8);
        for (degree, tolerance) in [(2, 1e-3), (2, 1e-6), (3, 1e-6), (3, 1e-10)] {
            for d in [0.5, -0.5, 0.9] {
                let done = given
                    .view()
                    .offset(d * scale, &offset_options(degree, tolerance * scale), &Job::default())
                    .unwrap();
                let curve = done.curve.view();
                assert!(curve.is_closed() && done.reached && !done.tight && done.corners == 0);
                assert!(done.deviation <= tolerance * scale);
                assert!(curve.segments().all(|c| c.len() == degree + 1));
                // Both curves are circles within 1e-5.
                let points: Vec<f64> = curve
                    .points_at(&[at(0, 0.3), at(1, 0.7)], &Job::default())
                    .unwrap()
                    .iter()
                    .map(|p| (*p / scale).length())
                    .collect();
                assert!(points.iter().all(|r| (r - (1.0 - d)).abs() < 2e-5 + tolerance), "{points:?}");
                assert!(off_by(&given.view(), &curve, d * scale) / scale <= 1.01 * tolerance + 1e-14);
                // One tangent at the joints.
                for k in 1..curve.len() as u32 {
                    let t = curve.tangents_at(&[at(k - 1, 1.0), at(k, 0.0)], &Job::default()).unwrap();
                    assert!((t[0] - t[1]).length() < 1e-7, "{k} {} {}", t[0], t[1]);
                }
            }
        }
    }
    let given = parabola(-1.0, 1.0);
    // The radius at the top is 1/2.
    let inside = given.view().offset(0.4, &offset_options(3, 1e-8), &Job::default()).unwrap();
    assert!(!inside.tight && inside.reached && off_by(&given.view(), &inside.curve.view(), 0.4) < 1.1e-8);
    let beyond = given.view().offset(0.6, &offset_options(3, 1e-8), &Job::default()).unwrap();
    assert!(beyond.tight && beyond.deviation.is_finite());
    assert!(!given.view().offset(-5.0, &offset_options(2, 1e-6), &Job::default()).unwrap().tight);
    let few = given
        .view()
        .offset(-0.4, &OffsetOptions { max_segments: 1, ..offset_options(2, 1e-12) }, &Job::default())
        .unwrap();
    assert!(!few.reached && few.deviation > 1e-3 && few.curve.view().len() < 20);
    // A square: four corners outside.
    let square = Given {
        points: [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [0.0, 0.0]].map(|[x, y]| v(x, y, 0.0)).to_vec(),
        ends: (0..5).collect(),
        closed: true,
    };
    let done = square.view().offset(-1.0, &offset_options(2, 1e-9), &Job::default()).unwrap();
    assert_eq!((done.corners, done.curve.view().len()), (4, 8));
    assert!((done.curve.view().area_vector(&Job::default()).unwrap().z - 7.0).abs() < 1e-12);
    assert!(square.view().offset(f64::NAN, &offset_options(2, 1.0), &Job::default()).is_err());
    assert!(square.view().offset(1.0, &offset_options(4, 1.0), &Job::default()).is_err());
}

proptest! {
    #[test]
    fn offsets_of_anything_come_to_an_end(given in curves(true), d in -0.5..0.5f64, degree in 2usize..4) {
        let unit = size(&given);
        let options = OffsetOptions { max_segments: 300, ..offset_options(degree, 1e-4 * unit) };
        match given.view().offset(d * unit, &options, &Job::default()) {
            Ok(done) => {
                prop_assert!(done.curve.view().points().iter().all(|p| p.is_finite()));
                prop_assert!(done.curve.view().len() < 1000);
                let view = done.curve.view();
                prop_assert!(CurveView::new(view.points(), view.ends(), view.is_closed()).is_ok());
            }
            Err(error) => prop_assert_eq!(error, Error::EmptyCurve),
        }
    }
}

#[test]
fn reducing_high_degrees_gives_numbers_or_keeps_them() {
    for degree in 24..64u32 {
        let points: Vec<DVec3> = (0..=degree).map(|i| v(f64::from(i), f64::from(i).sin(), 0.0)).collect();
        let ends = [0, degree];
        let raised =
            CurveView::new(&points, &ends, false).unwrap().with_degree_elevated_by(1, &Job::default()).unwrap();
        for tolerance in [1e-3, f64::INFINITY] {
            let back = raised.view().with_reduced_degree(degree as usize, tolerance, &Job::default()).unwrap();
            assert!(back.curve.view().points().iter().all(|p| p.is_finite()), "{degree}");
            assert!(!back.kept.is_empty() || back.deviations[0] <= tolerance, "{degree}");
        }
    }
}

#[test]
fn lengths_of_curves_whose_speed_is_noise_end() {
    // Points far apart that cancel: a single curve through points on a line, there and back.
    let points: Vec<[f64; 2]> = (0..18).map(|i| [f64::from(i), 0.0]).collect();
    let outlines = gusset::curve::Outlines { points: points[..].into(), offsets: None, closed: true, constraints: &[] };
    let options = gusset::curve::Options {
        curve: gusset::curve::CurveKind::Single,
        method: gusset::curve::Method::Symmedian,
        ..Default::default()
    };
    let done = gusset::curve::fit(&outlines, &options, &Job::default()).unwrap();
    assert!(done.curve(0).length().unwrap() >= 34.0);
}

//! Points of curves whose tangents make an angle with a direction, compared with dense samples of
//! the tangent, and with known solutions.

use glam::{DMat3, DVec3};
use gusset::curve::ops::TangentAngles;
use gusset::curve::{Curve, CurveView, Place};
use gusset::{Error, Job};
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI, TAU};

fn curve(points: &[DVec3], ends: &[u32], closed: bool) -> Curve {
    CurveView::new(points, ends, closed).unwrap().to_owned().unwrap()
}

fn at(curve: &Curve, direction: DVec3, angle: f64) -> TangentAngles {
    curve.view().tangents_at_angle(direction, angle, &Job::default()).unwrap()
}

fn numbers(places: &[Place]) -> Vec<f64> {
    places.iter().map(|place| f64::from(place.segment) + place.t).collect()
}

fn assert_near(found: &[f64], truth: &[f64]) {
    assert_eq!(found.len(), truth.len(), "{found:?} {truth:?}");
    for (a, b) in found.iter().zip(truth) {
        assert!((a - b).abs() < 1e-7, "{found:?} {truth:?}");
    }
}

/// A parabola (t, t^2), whose tangent is (1, 2 t).
#[test]
fn angles_of_a_parabola_are_known() {
    let parabola = curve(&[DVec3::ZERO, DVec3::X * 0.5, DVec3::new(1.0, 1.0, 0.0)], &[0, 2], false);
    for t in [0.0, 1e-5, 0.25, 0.5, 0.9, 1.0] {
        let angle = f64::atan2(2.0 * t, 1.0);
        assert_near(&numbers(&at(&parabola, DVec3::X, angle).places), &[t]);
        assert_near(&numbers(&at(&parabola, DVec3::NEG_X, PI - angle).places), &[t]);
        assert_near(&numbers(&at(&parabola, 7.0 * DVec3::Y, FRAC_PI_2 - angle).places), &[t]);
        // The other sign of the square is not a solution.
        assert!(at(&parabola, DVec3::X, PI - angle).places.is_empty() || angle == FRAC_PI_2, "{t}");
    }
    // Along and across, at any size.
    let along = DVec3::new(1.0, 1.0, 0.0);
    for size in [1e-200, 1.0, 1e200] {
        let points = [DVec3::ZERO, DVec3::X * 0.5, DVec3::new(1.0, 1.0, 0.0)].map(|p| p * size);
        let parabola = curve(&points, &[0, 2], false);
        assert_near(&numbers(&at(&parabola, along, 0.0).places), &[0.5]);
        assert_near(&numbers(&at(&parabola, -along, PI).places), &[0.5]);
        assert!(at(&parabola, along, PI).places.is_empty());
        assert_near(&numbers(&at(&parabola, DVec3::new(-1.0, 1.0, 0.0), FRAC_PI_2).places), &[0.5]);
        assert!(at(&parabola, DVec3::Z, 0.0) == TangentAngles::default());
        let all = at(&parabola, DVec3::Z, FRAC_PI_2).intervals;
        assert_eq!(all, [[Place { segment: 0, t: 0.0 }, Place { segment: 0, t: 1.0 }]]);
    }
}

/// At a cusp the tangent jumps to its opposite: both sides count, and nothing between.
#[test]
fn cusps_count_by_their_sides() {
    // (t^2, t^3) from t = -1 to 1: it arrives along -x and leaves along x.
    let f = |t: f64| DVec3::new(t * t, t * t * t, 0.0);
    let fit = |p: [DVec3; 4]| {
        // Bezier points of the cubic with these values at -1, -1/3, 1/3, 1.
        let third = |a: DVec3, b: DVec3, c: DVec3, d: DVec3| (-5.0 * a + 18.0 * b - 9.0 * c + 2.0 * d) / 6.0;
        [p[0], third(p[0], p[1], p[2], p[3]), third(p[3], p[2], p[1], p[0]), p[3]]
    };
    let cusp = curve(&fit([-1.0, -1.0 / 3.0, 1.0 / 3.0, 1.0].map(f)), &[0, 3], false);
    assert_near(&numbers(&at(&cusp, DVec3::X, 0.0).places), &[0.5]);
    assert_near(&numbers(&at(&cusp, DVec3::X, PI).places), &[0.5]);
    // (2 t, 3 t^2): angle atan(3 t / 2) to x after it; the cusp itself is across to nothing else.
    assert_near(&numbers(&at(&cusp, DVec3::X, f64::atan(0.75)).places), &[0.75]);
    assert_near(&numbers(&at(&cusp, DVec3::X, PI - f64::atan(0.75)).places), &[0.25]);
    assert!(at(&cusp, DVec3::Y, 0.1).places.is_empty());
}

/// Straight segments are parts, joined where they go on; those that turn back are in two.
#[test]
fn straight_parts_are_intervals() {
    let square = [DVec3::ZERO, DVec3::X, DVec3::new(1.0, 1.0, 0.0), DVec3::Y, DVec3::ZERO];
    let square = curve(&square, &[0, 1, 2, 3, 4], true);
    for (direction, angle, segments) in
        [(DVec3::X, 0.0, vec![0]), (DVec3::X, PI, vec![2]), (DVec3::X, FRAC_PI_2, vec![1, 3])]
    {
        let found = at(&square, direction, angle);
        let parts: Vec<u32> = found.intervals.iter().map(|part| part[0].segment).collect();
        assert!(parts == segments && found.places.is_empty(), "{found:?}");
        assert!(found.intervals.iter().all(|[from, to]| from.t == 0.0 && to.t == 1.0));
    }
    let diagonal = at(&square, DVec3::new(1.0, 1.0, 0.0), FRAC_PI_4);
    assert_eq!(diagonal.intervals, [[Place { segment: 0, t: 0.0 }, Place { segment: 1, t: 1.0 }]]);
    // To 1 and back to 1/2: x' = 0 at t = 2/3.
    let back = curve(&[0.0, 1.0, 0.5].map(|x| DVec3::X * x), &[0, 2], false);
    let (there, again) = (at(&back, DVec3::X, 0.0).intervals, at(&back, DVec3::X, PI).intervals);
    assert!(there.len() == 1 && (there[0][1].t - 2.0 / 3.0).abs() < 1e-12, "{there:?}");
    assert!(again.len() == 1 && (again[0][0].t - 2.0 / 3.0).abs() < 1e-12 && again[0][1].t == 1.0, "{again:?}");
    // A point lacks a tangent.
    assert!(at(&curve(&[DVec3::ONE; 3], &[0, 2], true), DVec3::X, 0.3) == TangentAngles::default());
}

/// A closed curve, cut anywhere: each place once, at joints and at the start too.
#[test]
fn joints_and_the_start_count_once() {
    let ring = |turn: f64| {
        let nodes: Vec<DVec3> = (0..=24)
            .map(|k| {
                let a = TAU * f64::from(k % 24) / 24.0 + turn;
                DVec3::new(a.cos(), a.sin(), 0.0)
            })
            .collect();
        gusset::surface::curve_through(&nodes, true, gusset::surface::Scheme::SixTap, &Job::default()).unwrap()
    };
    for turn in (0..48).map(|k| f64::from(k) * TAU / 48.0) {
        for (direction, angle, count) in [(DVec3::X, FRAC_PI_2, 2), (DVec3::Y, 0.0, 1), (DVec3::X, 1.0, 2)] {
            let found = at(&ring(turn), direction, angle);
            assert_eq!((found.places.len(), found.intervals.len()), (count, 0), "{turn} {angle}: {found:?}");
        }
    }
}

/// Random curves in space: wherever the deviation from the angle changes its sign between samples
/// there is a place, and at each place the tangent makes the angle.
#[test]
fn every_change_of_sign_is_found() {
    let mut random = fastrand::Rng::with_seed(5);
    let (mut found_all, mut changes) = (0, 0);
    for case in 0..600 {
        let degree = 1 + case % 9;
        let mut point = || DVec3::from_array([0; 3].map(|_| 2.0 * random.f64() - 1.0));
        let flat = if case % 3 == 0 { DMat3::from_diagonal(DVec3::new(1.0, 1.0, 0.0)) } else { DMat3::IDENTITY };
        let controls: Vec<DVec3> = (0..=2 * degree).map(|_| flat * point()).collect();
        let (direction, angle) = (flat * point(), [0.3, 1.2, 2.0, FRAC_PI_2, 1.57, 2.9, 1.5679, 0.83][case % 8]);
        let made = curve(&controls, &[0, degree as u32, 2 * degree as u32], false);
        let found = at(&made, direction, angle);
        let unit = direction.normalize();
        let off = |place: Place| {
            let tangent = made.view().tangents_at(&[place], &Job::default()).unwrap()[0];
            tangent.dot(unit).clamp(-1.0, 1.0).acos() - angle
        };
        for &place in &found.places {
            assert!(off(place).abs() < 1e-6, "{case}: {place:?} {}", off(place));
        }
        found_all += found.places.len();
        // Each once, in order.
        let along = |place: &Place| f64::from(place.segment) + place.t;
        assert!(found.places.windows(2).all(|pair| along(&pair[0]) + 1e-9 < along(&pair[1])), "{case}: {found:?}");
        for segment in 0..2 {
            const N: usize = 1500;
            let at = |k: usize| Place { segment, t: k as f64 / N as f64 };
            for k in 0..N {
                let [a, b] = [off(at(k)), off(at(k + 1))];
                if a * b < 0.0 && a.abs() + b.abs() < 0.3 {
                    changes += 1;
                    let near = |place: &Place| {
                        let t = f64::from(place.segment) + place.t - f64::from(segment);
                        t >= at(k).t - 1e-6 && t <= at(k + 1).t + 1e-6
                    };
                    assert!(found.places.iter().any(near), "{case}: {segment} {}", at(k).t);
                }
            }
        }
    }
    assert!(changes > 500 && found_all >= changes, "{changes} {found_all}");
}

#[test]
fn angles_and_directions_are_checked() {
    let line = curve(&[DVec3::ZERO, DVec3::X], &[0, 1], false);
    let ask = |direction, angle| line.view().tangents_at_angle(direction, angle, &Job::default()).unwrap_err();
    assert!(matches!(ask(DVec3::ZERO, 1.0), Error::OptionOutOfRange { option: "direction", .. }));
    assert!(matches!(ask(DVec3::NAN, 1.0), Error::NotFinite { .. }));
    for angle in [-0.1, 3.2, f64::NAN] {
        assert!(matches!(ask(DVec3::X, angle), Error::OptionOutOfRange { option: "angle", .. }));
    }
}

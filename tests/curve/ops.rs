//! Operations on curves, against formulas, brute force and identities.

use crate::curves::*;
use glam::DVec3;
use gusset::curve::{Curve, CurveView, Place};
use gusset::{Error, Job};
use proptest::prelude::*;

#[test]
fn derivatives_tangents_and_curvatures_of_a_parabola() {
    let given = parabola(-1.0, 2.0);
    let curve = given.view();
    let places: Vec<Place> = (0..=30).map(|k| at(0, f64::from(k) / 30.0)).collect();
    let derived = curve.derivatives_at(&places, 3, &Job::default()).unwrap();
    for (k, place) in places.iter().enumerate() {
        let x = -1.0 + 3.0 * place.t;
        let expected = [v(x, x * x, 0.0), v(3.0, 6.0 * x, 0.0), v(0.0, 18.0, 0.0), DVec3::ZERO];
        for (a, b) in derived[4 * k..4 * k + 4].iter().zip(expected) {
            assert!((*a - b).length() < 1e-13, "{a} {b}");
        }
        let slope = 2.0 * x;
        let tangent = curve.tangents_at(&[*place], &Job::default()).unwrap()[0];
        assert!((tangent - v(1.0, slope, 0.0).normalize()).length() < 1e-14);
        let curvature = curve.curvatures_at(&[*place], &Job::default()).unwrap()[0];
        assert!((curvature - 2.0 / (1.0 + slope * slope).powf(1.5)).abs() < 1e-14);
    }
    let back = curve.reversed(&Job::default()).unwrap();
    assert!(back.view().curvatures_at(&[at(0, 0.5)], &Job::default()).unwrap()[0] < 0.0);
    let tiny = Given::one(&given.points.iter().map(|&p| p * 1e-200).collect::<Vec<_>>());
    let bend = tiny.view().curvatures_at(&[at(0, 1.0 / 3.0)], &Job::default()).unwrap()[0];
    assert!((bend / 2e200 - 1.0).abs() < 1e-13);
    // A cusp: forward and backward.
    let cusp = Given::one(&[v(0.0, 0.0, 0.0), v(1.0, 1.0, 0.0), v(0.0, 1.0, 0.0), v(1.0, 0.0, 0.0)]);
    assert!(cusp.view().tangents_at(&[at(0, 0.5)], &Job::default()).unwrap()[0].length() > 0.99);
    let stuck = Given::one(&[DVec3::ZERO, DVec3::ZERO, v(1.0, 0.0, 0.0), v(1.0, 1.0, 0.0)]);
    assert_eq!(stuck.view().curvatures_at(&[at(0, 0.0)], &Job::default()).unwrap(), [f64::INFINITY]);
    assert_eq!(stuck.view().tangents_at(&[at(0, 0.0)], &Job::default()).unwrap(), [DVec3::X]);
    let line = Given::one(&[DVec3::ZERO, DVec3::ZERO, v(1.0, 2.0, 0.0)]);
    assert_eq!(line.view().curvatures_at(&[at(0, 0.0)], &Job::default()).unwrap(), [0.0]);
    assert_eq!(curve.point(at(1, 0.5)).unwrap_err(), Error::NoSuchPlace { index: 0, segment: 1, t: 0.5 });
    assert!(curve.points_at(&[at(0, 0.5), at(0, f64::NAN)], &Job::default()).is_err());
    assert!(curve.derivatives_at(&[], 65, &Job::default()).is_err());
}

#[test]
fn the_length_of_a_parabola() {
    for (a, b) in [(0.0, 1.0), (-1.0, 2.0), (3.0, 4.0), (-5.0, -1.0), (0.0, 1e-6), (100.0, 100.001), (-1e-8, 1e-8)] {
        let given = parabola(a, b);
        let length = given.view().length().unwrap();
        let expected = if b - a < 0.01 && a.abs() < 1.0 {
            // The formula itself cancels: the series of sqrt(1 + 4 x^2).
            b - a + 2.0 / 3.0 * (b * b * b - a * a * a)
        } else if b - a < 0.01 {
            let (m, d) = ((a + b) / 2.0, b - a);
            let speed = (1.0 + 4.0 * m * m).sqrt();
            speed * d + d * d * d / 24.0 * 4.0 / (speed * speed * speed)
        } else {
            parabola_length(b) - parabola_length(a)
        };
        // The control points of the short ones carry 1e-16 of 10000 themselves.
        let error = if a == 100.0 { 1e-10 } else { 2e-15 };
        assert!((length / expected - 1.0).abs() < error, "{a} {b}: {length} {expected}");
        // By the other way: as a cubic.
        let [p, q, r] = [given.points[0], given.points[1], given.points[2]];
        let cubic = Given::one(&[p, p + (q - p) * (2.0 / 3.0), r + (q - r) * (2.0 / 3.0), r]);
        assert!((cubic.view().length().unwrap() / expected - 1.0).abs() < error.max(1e-13));
    }
    // Nearly straight, to the last digits.
    for bend in [1e-3, 1e-6, 1e-9, 1e-12, 1e-15, 1e-18, 0.0] {
        let given = Given::one(&[v(0.0, 0.0, 0.0), v(0.5 + bend, bend, 0.0), v(1.0, 0.0, 0.0)]);
        let length = given.view().length().unwrap();
        assert!(
            (length - (1.0 + 2.0 / 3.0 * bend * bend)).abs() < 1e-15 + 20.0 * bend * bend * bend,
            "{bend}: {length}"
        );
    }
    // There and back again: 0 to 1/2 and back.
    let back = Given::one(&[DVec3::ZERO, DVec3::X, DVec3::ZERO]);
    assert!((back.view().length().unwrap() - 1.0).abs() < 1e-15);
    // A cusp: |C'| = 3 |t - 1/2| ..., by a dense polygon.
    let cusp = Given::one(&[v(0.0, 0.0, 0.0), v(1.0, 1.0, 0.0), v(0.0, 1.0, 0.0), v(1.0, 0.0, 0.0)]);
    let n = 200_000;
    let polygon: f64 = (0..n)
        .map(|k| cusp.point(f64::from(k) / f64::from(n)).distance(cusp.point(f64::from(k + 1) / f64::from(n))))
        .sum();
    assert!((cusp.view().length().unwrap() / polygon - 1.0).abs() < 1e-9);
}

#[test]
fn circles() {
    for radius in [1.0, 1e200, 1e-200] {
        for n in [4, 16, 64] {
            let given = circle(radius, n);
            let curve = given.view();
            let error = 3e-4 * (4.0 / f64::from(n)).powi(6) + 1e-13;
            let length = curve.length().unwrap() / radius;
            assert!((length / std::f64::consts::TAU - 1.0).abs() < error, "{n}: {length}");
            let bounds = curve.bounding_box(&Job::default()).unwrap();
            assert!((bounds.high / radius - v(1.0, 1.0, 0.0)).length() < 1e-14);
            let found = curve
                .nearest_to_each_query(&[v(2.0, 1.0, 0.0) * radius, v(0.0, 0.3, 0.4) * radius], &Job::default())
                .unwrap();
            assert!((found[0].distance / radius - (5.0f64.sqrt() - 1.0)).abs() < error);
            assert!((found[1].distance / radius - (0.49f64 + 0.16).sqrt()).abs() < error);
            let crossings = curve.intersect_line(v(0.0, 0.6, 0.0) * radius, v(3.0, 0.0, 0.0), &Job::default()).unwrap();
            assert_eq!((crossings.places.len(), crossings.inside.len()), (2, 0));
            for p in curve.points_at(&crossings.places, &Job::default()).unwrap() {
                assert!((p.x.abs() / radius - 0.8).abs() < error && (p.y / radius - 0.6).abs() < 1e-14);
            }
            // Tangent at the joint, through the joints, and past it.
            let line = |y: f64| {
                curve.intersect_line(v(0.0, y, 0.0) * radius, v(1.0, 0.0, 0.0), &Job::default()).unwrap().places.len()
            };
            assert_eq!((line(1.0), line(0.0), line(1.001)), (1, 2, 0));
        }
    }
    let given = circle(2.0, 64);
    let moments = given.view().moments(&Job::default()).unwrap();
    let pi = std::f64::consts::PI;
    assert!((moments.area / (4.0 * pi) - 1.0).abs() < 1e-10 && moments.centroid.length() < 1e-12);
    // The integral of x x over a disk of radius r is pi r^4 / 4.
    for (x, expected) in moments.second.iter().zip([4.0 * pi, 0.0, 4.0 * pi]) {
        assert!((x - expected).abs() < 1e-8);
    }
    for bend in given.view().curvatures_at(&[at(0, 0.3), at(5, 0.5), at(63, 1.0)], &Job::default()).unwrap() {
        assert!((bend - 0.5).abs() < 1e-5);
    }
}

#[test]
fn areas_and_moments_of_polygons() {
    let corners = [[0.0, 0.0], [4.0, 1.0], [5.0, 4.0], [1.0, 3.0], [-1.0, 1.5]];
    let mut points: Vec<DVec3> = corners.iter().map(|&[x, y]| v(x + 100.0, y, 0.0)).collect();
    points.push(points[0]);
    let n = points.len() as u32;
    let given = Given { points, ends: (0..n).collect(), closed: true };
    // Shoelace, about (100, 0).
    let (mut area, mut first, mut second) = (0.0, [0.0; 2], [0.0; 3]);
    for k in 0..5 {
        let ([x, y], [u, w]) = (corners[k], corners[(k + 1) % 5]);
        let cross = x * w - y * u;
        area += cross / 2.0;
        first = [first[0] + cross * (x + u) / 6.0, first[1] + cross * (y + w) / 6.0];
        second[0] += cross * (x * x + x * u + u * u) / 12.0;
        second[1] += cross * (2.0 * x * y + x * w + u * y + 2.0 * u * w) / 24.0;
        second[2] += cross * (y * y + y * w + w * w) / 12.0;
    }
    let c = [first[0] / area, first[1] / area];
    let central = [second[0] - area * c[0] * c[0], second[1] - area * c[0] * c[1], second[2] - area * c[1] * c[1]];
    let moments = given.view().moments(&Job::default()).unwrap();
    assert!(
        (moments.area - area).abs() < 1e-13
            && (given.view().area_vector(&Job::default()).unwrap().z - area).abs() < 1e-13
    );
    assert!((moments.centroid - v(100.0 + c[0], c[1], 0.0)).length() < 1e-12);
    for (a, b) in moments.second.iter().zip(central) {
        assert!((a - b).abs() < 1e-12);
    }
    let back = given.view().reversed(&Job::default()).unwrap();
    assert!((back.view().area_vector(&Job::default()).unwrap().z + area).abs() < 1e-13);
    // A parabola over its chord: (b - a)^3 / 6.
    assert!((parabola(-1.0, 2.0).view().area_vector(&Job::default()).unwrap().z - 27.0 / 6.0).abs() < 1e-13);
    // In space: the area vector turns with the curve.
    let turned = Given { points: given.points.iter().map(|p| v(p.y, 7.0, p.x)).collect(), ..given };
    assert!((turned.view().area_vector(&Job::default()).unwrap() - v(0.0, area, 0.0)).length() < 1e-12);
    let refused = Error::CurveNotPlane { point: 0, z: turned.points[0].z };
    assert_eq!(turned.view().moments(&Job::default()).unwrap_err(), refused);
}

#[test]
fn arc_length_there_and_back() {
    let given = circle(3.0, 5);
    let lengths = given.view().arc_lengths(&Job::default()).unwrap();
    for k in 0..=40 {
        let s = lengths.total_length() * f64::from(k) / 40.0;
        let place = lengths.place_at_length(s).unwrap();
        assert!((lengths.length_to(place).unwrap() - s).abs() < 1e-12, "{k}");
    }
    assert_eq!(lengths.place_at_length(-1.0).unwrap(), at(0, 0.0));
    assert_eq!(lengths.place_at_length(f64::INFINITY).unwrap(), at(4, 1.0));
    assert!(lengths.place_at_length(f64::NAN).is_err());
    let parabola = parabola(-1.0, 2.0);
    let lengths = parabola.view().arc_lengths(&Job::default()).unwrap();
    let place = lengths.place_at_length(parabola_length(1.0)).unwrap();
    assert!((place.t - 1.0 / 3.0).abs() < 1e-15);
    let point = Given { points: vec![DVec3::X], ends: vec![0], closed: false };
    assert_eq!(point.view().length().unwrap(), 0.0);
    assert_eq!(point.view().arc_lengths(&Job::default()).unwrap().place_at_length(0.0).unwrap_err(), Error::EmptyCurve);
    assert_eq!(point.view().nearest_to_each_query(&[], &Job::default()).unwrap_err(), Error::EmptyCurve);
    assert_eq!(point.view().bounding_box(&Job::default()).unwrap().low, DVec3::X);
}

#[test]
fn planes_in_space_and_segments_within() {
    // A screw of height 1, cut at half its height.
    let given = Given::one(&[v(1.0, 0.0, 0.0), v(1.0, 1.0, 0.2), v(-1.0, 1.0, 0.8), v(-1.0, 0.0, 1.0)]);
    let found = given.view().intersect_plane(v(9.0, 9.0, 0.5), v(0.0, 0.0, -1e-300), &Job::default()).unwrap();
    assert_eq!(found.places.len(), 1);
    assert!((found.places[0].t - 0.5).abs() < 1e-15);
    assert!(given.view().intersect_line(DVec3::ZERO, DVec3::X, &Job::default()).is_err());
    assert!(given.view().intersect_plane(DVec3::ZERO, DVec3::ZERO, &Job::default()).is_err());
    // A square: the line along one side has that side in it, and nothing else.
    let square = [v(0.0, 0.0, 0.0), v(1.0, 0.0, 0.0), v(1.0, 1.0, 0.0), v(0.0, 1.0, 0.0), v(0.0, 0.0, 0.0)];
    for turn in 0..4usize {
        let mut points: Vec<DVec3> = (0..4).map(|k| square[(k + turn) % 4]).collect();
        points.push(points[0]);
        let square = Given { points, ends: (0..5).collect(), closed: true };
        let found = square.view().intersect_line(v(0.5, 1.0, 0.0), DVec3::X, &Job::default()).unwrap();
        assert_eq!((found.inside.len(), found.places.len()), (1, 0), "{turn}: {found:?}");
        // A diagonal passes two corners.
        let found = square.view().intersect_line(v(0.0, 0.0, 0.0), v(1.0, 1.0, 0.0), &Job::default()).unwrap();
        assert_eq!((found.inside.len(), found.places.len()), (0, 2), "{turn}: {found:?}");
    }
}

#[test]
fn parts_of_a_closed_curve() {
    let given = circle(1.0, 4);
    let curve = given.view();
    let over = curve.sub_curve(at(3, 0.5), at(0, 0.5), &Job::default()).unwrap();
    assert_eq!((over.view().len(), over.view().is_closed()), (2, false));
    assert!((over.view().length().unwrap() / curve.length().unwrap() - 0.25).abs() < 1e-13);
    let round = curve.sub_curve(at(1, 0.25), at(1, 0.25), &Job::default()).unwrap();
    assert!((round.view().length().unwrap() / curve.length().unwrap() - 1.0).abs() < 1e-13);
    let open = parabola(0.0, 1.0);
    assert!(open.view().sub_curve(at(0, 0.5), at(0, 0.5), &Job::default()).unwrap().view().is_empty());
    assert!(open.view().sub_curve(at(0, 0.6), at(0, 0.5), &Job::default()).is_err());
}

fn reversed_twice(curve: &CurveView<'_>) -> Curve {
    curve.reversed(&Job::default()).unwrap().view().reversed(&Job::default()).unwrap()
}

proptest! {
    #[test]
    fn halves_are_the_curve(given in curves(false), cut in 0.0..1.0f64) {
        let curve = given.view();
        let whole = cut * curve.len() as f64;
        let place = at(whole.floor() as u32, whole - whole.floor());
        let [before, after] = curve.split(place, &Job::default()).unwrap();
        let near = |p: DVec3, q: DVec3| (p - q).abs().max_element() <= 1e-13 * size(&given);
        for k in 0..=20 {
            let u = f64::from(k) / 20.0;
            for i in 0..curve.len() {
                let (part, t, n) = if i < place.segment as usize {
                    (&before, u, i)
                } else if i > place.segment as usize {
                    (&after, u, i - place.segment as usize)
                } else if u <= place.t && place.t > 0.0 {
                    (&before, u / place.t, i)
                } else {
                    (&after, (u - place.t) / (1.0 - place.t), 0)
                };
                let p = part.view().point(at(n as u32, t.min(1.0))).unwrap();
                prop_assert!(near(p, curve.point(at(i as u32, u)).unwrap()));
            }
        }
    }

    #[test]
    fn backwards_twice_is_the_curve(given in curves(false)) {
        let curve = given.view();
        let twice = reversed_twice(&curve);
        prop_assert_eq!(twice.view().points(), curve.points());
        prop_assert_eq!(twice.view().ends(), curve.ends());
        let again = curve.reversed(&Job::default()).unwrap();
        let last = curve.len() as u32 - 1;
        let (p, q) = (curve.point(at(0, 0.25)).unwrap(), again.view().point(at(last, 0.75)).unwrap());
        prop_assert!((p - q).abs().max_element() <= 1e-14 * size(&given));
        prop_assert!(apart(&curve, &twice.view()) == 0.0);
    }

    #[test]
    fn boxes_hold_the_curve_and_touch_it(given in curves(false)) {
        let bounds = given.view().bounding_box(&Job::default()).unwrap();
        let (mut low, mut high) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
        let n = 400 * (given.ends.len() - 1);
        for k in 0..=n {
            let p = given.point(k as f64 / 400.0);
            (low, high) = (low.min(p), high.max(p));
        }
        let unit = size(&given);
        // Steps of 1/400 miss an extremum by at most a few times 1/400^2.
        prop_assert!((low - bounds.low).max(bounds.high - high).max_element() <= 2e-4 * unit);
        prop_assert!((bounds.low - low).max(high - bounds.high).max_element() <= 1e-14 * unit);
    }

    #[test]
    fn nearest_beats_brute_force(given in curves(false), q in (-2.0..2.0f64, -2.0..2.0f64, -2.0..2.0f64)) {
        let unit = size(&given);
        let q = v(q.0, q.1, q.2) * unit;
        let found = given.view().nearest_to_each_query(&[q], &Job::default()).unwrap()[0];
        let n = 300 * (given.ends.len() - 1);
        let brute = (0..=n).map(|k| ((given.point(k as f64 / 300.0) - q) / unit).length()).fold(f64::INFINITY, f64::min);
        prop_assert!(found.distance / unit <= brute + 1e-14, "{} {}", found.distance / unit, brute);
        prop_assert!(found.distance / unit >= brute - 0.05);
        let point = given.view().point(found.place).unwrap();
        prop_assert_eq!(point, found.point);
        // At an inner place the connection is square to the curve.
        if found.place.t > 0.0 && found.place.t < 1.0 {
            let slope = given.view().derivatives_at(&[found.place], 1, &Job::default()).unwrap()[1] / unit;
            prop_assert!(((q - point) / unit).dot(slope).abs() < 1e-7);
        }
    }

    #[test]
    fn lengths_are_those_of_dense_polygons(given in curves(false)) {
        let unit = size(&given);
        let n = 2000;
        let total = n * (given.ends.len() - 1);
        let polygon: f64 =
            (0..total).map(|k| ((given.point((k + 1) as f64 / n as f64) - given.point(k as f64 / n as f64)) / unit).length()).sum();
        let length = given.view().length().unwrap() / unit;
        prop_assert!((length - polygon).abs() <= 1e-4 * length + 1e-11 && length >= polygon - 1e-11, "{} {}", length, polygon);
        let lengths = given.view().arc_lengths(&Job::default()).unwrap();
        let middle = lengths.place_at_length(0.5 * lengths.total_length()).unwrap();
        prop_assert!((lengths.length_to(middle).unwrap() - 0.5 * lengths.total_length()).abs() <= 1e-12 * lengths.total_length());
    }

    #[test]
    fn areas_are_those_of_dense_polygons(given in curves(true)) {
        if !(1e-100..1e100).contains(&size(&given)) {
            return Ok(());
        }
        let unit = size(&given);
        let total = 1000 * (given.ends.len() - 1);
        let start = given.points[0];
        let seen = |k: usize| (given.point(k as f64 / 1000.0) - start) / unit;
        let area: f64 = (0..total).map(|k| 0.5 * seen(k).cross(seen(k + 1)).z).sum();
        prop_assert!((given.view().area_vector(&Job::default()).unwrap().z / unit / unit - area).abs() < 1e-4);
        prop_assert!((given.view().moments(&Job::default()).unwrap().area / unit / unit - area).abs() < 1e-4);
    }

    #[test]
    fn lines_cross_where_the_side_changes(given in curves(true), line in (-0.5..0.5f64, -0.5..0.5f64, 0.0..3.1f64)) {
        let unit = size(&given);
        let (point, direction) = (v(line.0, line.1, 0.0) * unit, v(line.2.cos(), line.2.sin(), 0.0));
        let found = given.view().intersect_line(point, direction, &Job::default()).unwrap();
        prop_assert!(found.inside.len() < given.ends.len());
        let normal = v(-direction.y, direction.x, 0.0);
        let side = |at: f64| normal.dot((given.point(at) - point) / unit);
        for place in &found.places {
            prop_assert!(side(f64::from(place.segment) + place.t).abs() < 1e-12);
        }
        // Brute force: every change of side has a crossing.
        for k in 0..200 * (given.ends.len() - 1) {
            let (a, b) = (k as f64 / 200.0, (k + 1) as f64 / 200.0);
            if side(a) * side(b) < 0.0 && side(a).abs().min(side(b).abs()) > 1e-12 {
                let inside = found.places.iter().any(|p| (a..=b).contains(&(f64::from(p.segment) + p.t)));
                prop_assert!(inside, "{} {:?}", a, found);
            }
        }
    }
}

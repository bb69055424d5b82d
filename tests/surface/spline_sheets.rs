//! Sheets of B-splines, against the recursion of their basis functions.

use crate::construct::torus;
use crate::shapes::Random;
use glam::DVec3;
use gusset::surface::Sheet;
use gusset::surface::construct::{Spline, SplineAxis, SplineOptions};
use gusset::{Element, Error, Job};
use std::f64::consts::TAU;

/// The value of a spline by the recursion of Cox and de Boor, in long form.
pub(crate) fn basis(knots: &[f64], degree: usize, i: usize, t: f64) -> f64 {
    if degree == 0 {
        return f64::from(u8::from(knots[i] <= t && t < knots[i + 1]));
    }
    let part = |a: f64, b: f64, c: f64| if b > a { (t - a) / (b - a) * c } else { 0.0 };
    let left = part(knots[i], knots[i + degree], basis(knots, degree - 1, i, t));
    let right = basis(knots, degree - 1, i + 1, t);
    let (a, b) = (knots[i + 1], knots[i + degree + 1]);
    left + if b > a { (b - t) / (b - a) * right } else { 0.0 }
}

#[test]
fn splines_are_what_the_recursion_says() {
    let job = Job::default();
    let mut random = Random(5);
    for (p, q) in [(1, 1), (2, 3), (3, 3), (3, 5), (7, 2), (6, 7)] {
        // Knots at random distances, some repeated as often as may be; clamped in v only.
        let mut knots = |degree: usize, count: usize, clamped: bool| {
            let mut knots = vec![0.0];
            while knots.len() < count + degree + 1 {
                let last = knots[knots.len() - 1];
                let repeated = if random.next() < 0.3 { 1 + (random.next() * degree as f64) as usize } else { 1 };
                let next = last + 0.2 + random.next();
                knots.extend(std::iter::repeat_n(next, repeated.min(degree).min(count + degree + 1 - knots.len())));
            }
            if clamped {
                let end = knots[count] + 0.5;
                let start = knots[0];
                knots[..=degree].fill(start);
                knots[count..].fill(end);
            }
            knots
        };
        let counts = [p + 5, q + 6];
        let (u, v) = (knots(p, counts[0], false), knots(q, counts[1], true));
        let points: Vec<DVec3> = (0..counts[0] * counts[1]).map(|_| random.point(3.0)).collect();
        let axes =
            [SplineAxis { degree: p, knots: &u, closed: false }, SplineAxis { degree: q, knots: &v, closed: false }];
        let sheet = Sheet::from_spline(
            &Spline { points: &points, weights: None, counts, axes },
            &SplineOptions::default(),
            &job,
        )
        .unwrap();
        let distinct = |knots: &[f64], degree: usize, count: usize| {
            let mut own = knots[degree..=count].to_vec();
            own.dedup();
            own
        };
        let (a, b) = (distinct(&u, p, counts[0]), distinct(&v, q, counts[1]));
        assert_eq!(sheet.cells(), [a.len() - 1, b.len() - 1]);
        for i in 0..a.len() - 1 {
            for j in 0..b.len() - 1 {
                for (s, t) in [(0.0, 0.0), (0.3, 0.8), (0.9, 0.1)] {
                    let (x, y) = (a[i] + s * (a[i + 1] - a[i]), b[j] + t * (b[j + 1] - b[j]));
                    let mut truth = DVec3::ZERO;
                    for (k, &point) in points.iter().enumerate() {
                        truth += basis(&u, p, k / counts[1], x) * basis(&v, q, k % counts[1], y) * point;
                    }
                    let found = sheet.jet(i, j, s, t).point;
                    assert!(found.distance(truth) < 1e-12, "{p} {q}: {found} {truth}");
                }
                // Neighbours share sides to the bit.
                if i + 2 < a.len() {
                    assert_eq!(sheet.jet(i, j, 1.0, 0.0).point, sheet.corner(i + 1, j));
                }
            }
        }
    }
}

#[test]
fn closed_splines_close() {
    let job = Job::default();
    for degree in [2, 3, 5] {
        let n = 9;
        let knots: Vec<f64> = (0..=n).map(|k| k as f64 + 0.2 * f64::from(u8::from(k % 2 == 1))).collect();
        let points: Vec<DVec3> =
            (0..n * n).map(|k| torus(TAU * (k / n) as f64 / n as f64, TAU * (k % n) as f64 / n as f64).0).collect();
        let axis = SplineAxis { degree, knots: &knots, closed: true };
        let sheet = Sheet::from_spline(
            &Spline { points: &points, weights: None, counts: [n, n], axes: [axis, axis] },
            &SplineOptions::default(),
            &job,
        )
        .unwrap();
        assert_eq!((sheet.cells(), sheet.is_closed()), ([n, n], [true, true]));
        for k in 0..n {
            assert_eq!(sheet.jet(n - 1, k, 1.0, 0.0).point, sheet.jet(0, k, 0.0, 0.0).point);
            // C1 in the knots: tangents, a unit of the knots each, go on over the seam.
            let (last, first) = (knots[n] - knots[n - 1], knots[1] - knots[0]);
            let (before, after) = (sheet.jet(k, n - 1, 0.4, 1.0).v / last, sheet.jet(k, 0, 0.4, 0.0).v / first);
            assert!(before.distance(after) < 1e-13);
        }
        assert!(sheet.largest_crease_angle(&job).unwrap() < 1e-7);
        // The same, unrolled: an open spline with its points repeated.
        let count = n + degree;
        let open: Vec<f64> = (0..count + degree + 1)
            .map(|k| {
                let k = k as isize - degree as isize;
                knots[k.rem_euclid(n as isize) as usize]
                    + k.div_euclid(n as isize) as f64 * n as f64
                    + k.div_euclid(n as isize) as f64 * (knots[n] - n as f64)
            })
            .collect();
        let wrapped: Vec<DVec3> = (0..count * count)
            .map(|k| points[(k / count + n - degree) % n * n + (k % count + n - degree) % n])
            .collect();
        let axis = SplineAxis { degree, knots: &open, closed: false };
        let spline = Spline { points: &wrapped, weights: None, counts: [count, count], axes: [axis, axis] };
        let unrolled = Sheet::from_spline(&spline, &SplineOptions::default(), &job).unwrap();
        assert_eq!(unrolled.cells(), [n, n]);
        for k in 0..n {
            let (a, b) = (sheet.jet(k, n - 1 - k, 0.3, 0.6).point, unrolled.jet(k, n - 1 - k, 0.3, 0.6).point);
            assert!(a.distance(b) < 1e-14, "{degree} {k}: {a} {b}");
        }
    }
}

#[test]
fn splines_that_are_none() {
    let job = Job::default();
    let points = vec![DVec3::ONE; 16];
    let knots = [0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 1.0];
    let good = SplineAxis { degree: 3, knots: &knots, closed: false };
    let make = |axis: SplineAxis<'_>, points: &[DVec3]| {
        Sheet::from_spline(
            &Spline { points, weights: None, counts: [4, 4], axes: [good, axis] },
            &SplineOptions::default(),
            &job,
        )
        .map(|sheet| sheet.cells())
    };
    assert_eq!(make(good, &points), Ok([1, 1]));
    assert!(matches!(make(SplineAxis { degree: 8, ..good }, &points), Err(Error::OptionOutOfRange { .. })));
    assert!(matches!(make(SplineAxis { degree: 0, ..good }, &points), Err(Error::OptionOutOfRange { .. })));
    assert!(matches!(make(SplineAxis { degree: 4, ..good }, &points), Err(Error::NetTooSmall { .. })));
    let found = make(SplineAxis { knots: &knots[1..], ..good }, &points);
    assert_eq!(found, Err(Error::WrongKnotCount { direction: 1, given: 7, needed: 8 }));
    for (at, value) in [(5, 0.5), (4, f64::NAN), (7, f64::INFINITY), (1, -1.0)] {
        let mut bad = knots;
        bad[at] = value;
        let found = make(SplineAxis { knots: &bad, ..good }, &points);
        assert!(matches!(found, Err(Error::BadKnot { direction: 1, knot, .. }) if knot as usize == at), "{found:?}");
    }
    assert!(matches!(make(SplineAxis { knots: &[1.0; 8], ..good }, &points), Err(Error::BadKnot { .. })));
    // A knot inside that is repeated more than the degree allows.
    let linear = [0.0, 0.0, 1.0, 1.0, 2.0, 2.0];
    let found = make(SplineAxis { degree: 1, knots: &linear, ..good }, &points);
    assert!(matches!(found, Err(Error::BadKnot { knot: 3, .. })), "{found:?}");
    assert!(matches!(make(good, &points[1..]), Err(Error::ArrayTooShort { .. })));
    let mut bad = points.clone();
    bad[7].y = f64::INFINITY;
    assert!(matches!(make(good, &bad), Err(Error::NotFinite { element: Element::Node, index: 7, .. })));
}

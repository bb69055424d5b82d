//! Intersections of curves, against formulas and brute force.

use glam::DVec3;
use gusset::curve::ops::Intersections;
use gusset::curve::{CurveView, Place};
use gusset::{Error, Job};
use proptest::prelude::*;

fn v(x: f64, y: f64) -> DVec3 {
    DVec3::new(x, y, 0.0)
}

fn one(points: &[DVec3]) -> (Vec<DVec3>, Vec<u32>) {
    (points.to_vec(), vec![0, points.len() as u32 - 1])
}

fn meet(a: &[DVec3], b: &[DVec3]) -> Intersections {
    let (a, b) = (one(a), one(b));
    let (a, b) = (CurveView::new(&a.0, &a.1, false).unwrap(), CurveView::new(&b.0, &b.1, false).unwrap());
    let found = a.intersections(&b, &Job::default()).unwrap();
    for m in &found.points {
        assert!(a.point(m.a).unwrap().distance(b.point(m.b).unwrap()) < 1e-11);
    }
    found
}

fn itself(points: &[DVec3], ends: &[u32], closed: bool) -> Intersections {
    let curve = CurveView::new(points, ends, closed).unwrap();
    curve.self_intersections(&Job::default()).unwrap()
}

/// y = x^2 from x = a to b.
fn parabola(a: f64, b: f64) -> [DVec3; 3] {
    [v(a, a * a), v((a + b) / 2.0, a * b), v(b, b * b)]
}

#[test]
fn parabolas_and_lines() {
    // y = x^2 and x = y^2 meet at (0, 0) and (1, 1).
    let turned = parabola(-0.5, 1.25).map(|p| v(p.y, p.x));
    let found = meet(&parabola(-1.0, 2.0), &turned);
    assert_eq!(found.points.len(), 2);
    for (m, x) in found.points.iter().zip([0.0, 1.0]) {
        assert!((m.a.t - (x + 1.0) / 3.0).abs() < 1e-15 && (m.b.t - (x + 0.5) / 1.75).abs() < 1e-15);
    }
    // y = x^2 and the tangent at 0.5: y = x - 1/4.
    let tangent = [v(-1.0, -1.25), v(3.0, 2.75)];
    let found = meet(&parabola(-1.0, 2.0), &tangent);
    assert_eq!((found.points.len(), found.overlaps.len(), found.undecided), (1, 0, false), "{found:?}");
    assert!((found.points[0].a.t - 0.5).abs() < 1e-7);
    // A little higher they cross, a little lower they miss.
    for (lift, count) in [(1e-4, 2), (1e-8, 2), (-1e-4, 0), (-1e-8, 0), (-1e-11, 0)] {
        let found = meet(&parabola(-1.0, 2.0), &tangent.map(|p| p + v(0.0, lift)));
        assert_eq!(found.points.len(), count, "{lift}: {found:?}");
        for (m, sign) in found.points.iter().zip([-1.0, 1.0]) {
            let x = 0.5 + sign * f64::sqrt(lift);
            assert!((m.a.t - (x + 1.0) / 3.0).abs() < 1e-10);
        }
    }
    // y = x^2 and y = 2 x^2 touch at 0; the second continues to (1, 2).
    let steep = parabola(-1.0, 1.0).map(|p| v(p.x, 2.0 * p.y));
    let found = meet(&parabola(-1.5, 1.0), &steep);
    assert_eq!(found.points.len(), 1, "{found:?}");
    assert!((found.points[0].a.t - 0.6).abs() < 1e-6);
    // Two cubics with nine crossings.
    let s = [v(-1.0, -1.0), v(7.0, 15.0), v(-7.0, -15.0), v(1.0, 1.0)];
    let found = meet(&s, &s.map(|p| v(p.y, p.x)));
    assert!(found.points.len() == 9, "{}", found.points.len());
    let lifted = [DVec3::Z, DVec3::X];
    let flat = CurveView::new(&lifted, &[0, 1], false).unwrap();
    assert_eq!(flat.self_intersections(&Job::default()), Err(Error::CurveNotPlane { point: 0, z: 1.0 }));
}

#[test]
fn what_runs_together_is_an_overlap() {
    let found = meet(&parabola(-1.0, 1.0), &parabola(0.0, 2.0));
    assert_eq!((found.points.len(), found.overlaps.len(), found.undecided), (0, 1, false), "{found:?}");
    let o = found.overlaps[0];
    assert!((o.a[0].t - 0.5).abs() < 1e-12 && o.a[1].t == 1.0 && o.b[0].t == 0.0 && (o.b[1].t - 0.5).abs() < 1e-12);
    // Backwards, and as a cubic.
    let [p, q, r] = parabola(2.0, 0.0);
    let found = meet(&parabola(-1.0, 1.0), &[p, p.lerp(q, 2.0 / 3.0), r.lerp(q, 2.0 / 3.0), r]);
    assert_eq!((found.points.len(), found.overlaps.len()), (0, 1), "{found:?}");
    let found = meet(&[v(0.0, 0.0), v(2.0, 1.0)], &[v(1.0, 0.5), v(3.0, 1.5)]);
    assert_eq!((found.points.len(), found.overlaps.len()), (0, 1), "{found:?}");
    // End to end: a point.
    let found = meet(&[v(0.0, 0.0), v(2.0, 1.0)], &[v(2.0, 1.0), v(4.0, 2.0)]);
    assert_eq!((found.points.len(), found.overlaps.len()), (1, 0), "{found:?}");
    let found = meet(&parabola(-1.0, 1.0), &parabola(1.0, 2.0));
    assert_eq!((found.points.len(), found.overlaps.len()), (1, 0), "{found:?}");
    // A point on a curve, beside it, and two points.
    assert_eq!(meet(&parabola(-1.0, 1.0), &[v(0.5, 0.25); 3]).points.len(), 1);
    assert_eq!(meet(&parabola(-1.0, 1.0), &[v(0.5, 0.26); 3]).points.len(), 0);
    assert_eq!(meet(&[v(0.5, 0.25); 4], &[v(0.5, 0.25); 3]).points.len(), 1);
}

#[test]
fn circles_of_cubics() {
    let k = 0.552_284_749_830_793_4;
    let quarter = [v(1.0, 0.0), v(1.0, k), v(k, 1.0), v(0.0, 1.0)];
    let turn = |p: DVec3| v(-p.y, p.x);
    let mut points = vec![quarter[0]];
    let mut q = quarter;
    for _ in 0..4 {
        points.extend(&q[1..]);
        q = q.map(turn);
    }
    for scale in [1.0, 1e200, 1e-200] {
        let ends = [0, 3, 6, 9, 12];
        let a: Vec<DVec3> = points.iter().map(|&p| p * scale).collect();
        let b: Vec<DVec3> = points.iter().map(|&p| (p + v(1.0, 0.0)) * scale).collect();
        let c: Vec<DVec3> = points.iter().map(|&p| (p + v(2.0, 0.0)) * scale).collect();
        let curve = |p| CurveView::new(p, &ends, true).unwrap();
        let found = curve(&a).intersections(&curve(&b), &Job::default()).unwrap();
        assert_eq!(found.points.len(), 2, "{found:?}");
        for m in &found.points {
            let p = curve(&a).point(m.a).unwrap() / scale;
            assert!((p.x - 0.5).abs() < 1e-14 && (p.y.abs() - 0.75f64.sqrt()).abs() < 3e-4);
        }
        // They touch at a joint of both.
        let found = curve(&a).intersections(&curve(&c), &Job::default()).unwrap();
        assert_eq!(found.points.len(), 1, "{found:?}");
        assert_eq!(curve(&a).self_intersections(&Job::default()).unwrap(), Intersections::default());
        assert_eq!(curve(&a).intersections(&curve(&a), &Job::default()).unwrap().overlaps.len(), 4);
    }
}

#[test]
fn loops_cusps_and_eights() {
    // A cubic with a loop, symmetric about x = 0: it crosses itself there.
    let looped = [v(-1.0, 0.0), v(2.0, 2.0), v(-2.0, 2.0), v(1.0, 0.0)];
    let found = itself(&looped, &[0, 3], false);
    assert_eq!(found.points.len(), 1, "{found:?}");
    let m = found.points[0];
    assert!((m.a.t + m.b.t - 1.0).abs() < 1e-14);
    // Where x = 0, other than in the middle.
    let x = |t: f64| {
        let s = 1.0 - t;
        -s * s * s + 6.0 * t * s * s - 6.0 * t * t * s + t * t * t
    };
    assert!(x(m.a.t).abs() < 1e-14 && (m.a.t - 0.5).abs() > 0.1);
    // A cusp, a plain arch and a straight line have none.
    assert_eq!(itself(&[v(0.0, 0.0), v(1.0, 1.0), v(0.0, 1.0), v(1.0, 0.0)], &[0, 3], false).points, []);
    assert_eq!(itself(&[v(0.0, 0.0), v(1.0, 2.0), v(3.0, 0.0)], &[0, 2], false), Intersections::default());
    assert_eq!(itself(&[v(0.0, 0.0), v(1.0, 0.0), v(2.0, 0.0)], &[0, 1, 2], false), Intersections::default());
    // There and back: an overlap.
    assert_eq!(itself(&[v(0.0, 0.0), v(1.0, 0.0), v(0.5, 0.0)], &[0, 1, 2], false).overlaps.len(), 1);
    // An eight of polygons, and a pentagram.
    let eight = [v(0.0, 0.0), v(1.0, 1.0), v(1.0, 0.0), v(0.0, 1.0), v(0.0, 0.0)];
    assert_eq!(itself(&eight, &[0, 1, 2, 3, 4], true).points.len(), 1);
    let star: Vec<DVec3> =
        (0..=5).map(|k| std::f64::consts::TAU * 2.0 * f64::from(k % 5) / 5.0).map(|a| v(a.cos(), a.sin())).collect();
    assert_eq!(itself(&star, &[0, 1, 2, 3, 4, 5], true).points.len(), 5);
    // The start passed once more.
    let rose = [v(0.0, 0.0), v(1.0, 1.0), v(1.0, -1.0), v(0.0, 0.0), v(-1.0, 1.0), v(-1.0, -1.0), v(0.0, 0.0)];
    let found = itself(&rose, &[0, 3, 6], true);
    assert_eq!(found.points.len(), 1, "{found:?}");
}

/// A long straight segment on one of the curves removes no crossing of the cubics, and no loop of a
/// cubic.
#[test]
fn what_goes_far_hides_no_crossing() {
    let mut random = fastrand::Rng::with_seed(9);
    let mut cubic =
        || -> Vec<DVec3> { (0..4).map(|_| v(2.0 * random.f64() - 1.0, 2.0 * random.f64() - 1.0)).collect() };
    let mut crossings = 0;
    for _ in 0..120 {
        let (a, b) = (cubic(), cubic());
        let alone = meet(&a, &b);
        crossings += alone.points.len();
        for far in [1e4, 1e5, 3e5, 1e6, 3e6, 1e8] {
            let longer: Vec<DVec3> = a.iter().copied().chain([v(far, 0.7 * far)]).collect();
            let (eb, b) = ([0, 3], &b);
            let (a, b) = (CurveView::new(&longer, &[0, 3, 4], false).unwrap(), CurveView::new(b, &eb, false).unwrap());
            let found = a.intersections(&b, &Job::default()).unwrap();
            let near: Vec<_> = found.points.iter().filter(|m| m.a.segment == 0).collect();
            assert_eq!((near.len(), found.undecided), (alone.points.len(), false), "{far}: {alone:?} {found:?}");
            for (m, n) in near.iter().zip(&alone.points) {
                let gap = (m.a.t - n.a.t).abs().max((m.b.t - n.b.t).abs());
                assert!(gap < 1e-13 * far, "{far}: {gap:e}");
            }
        }
    }
    assert!(crossings > 80, "{crossings}");
    let looped = [v(0.0, 0.0), v(2.0, 1.0), v(-1.0, 1.0), v(1.0, 0.0)];
    for far in [1e4, 1e5, 1e6, 1e7, 1e8] {
        let points: Vec<DVec3> = looped.into_iter().chain([v(far, -far)]).collect();
        assert_eq!(itself(&points, &[0, 3, 4], false).points.len(), 1, "{far}");
    }
}

/// (s^2, s^3), s = t - 0.3, has a cusp; lines across it beside the cusp meet both branches.
#[test]
fn both_branches_beside_a_cusp_are_crossed() {
    let (p, q) = (0.3, 0.7);
    let square = [p * p, -p * q, q * q];
    let x = [square[0], (square[0] + 2.0 * square[1]) / 3.0, (2.0 * square[1] + square[2]) / 3.0, square[2]];
    let y = [-p * p * p, p * p * q, -p * q * q, q * q * q];
    let cusp: Vec<DVec3> = x.iter().zip(y).map(|(&x, y)| v(x, y)).collect();
    for x in [1e-3f64, 1e-5, 1e-6, 5e-7, 1e-7, 1e-9, 1e-10] {
        let found = meet(&cusp, &[v(x, -1.0), v(x, 1.0)]);
        assert_eq!((found.points.len(), found.undecided), (2, false), "{x}: {found:?}");
        for (m, sign) in found.points.iter().zip([-1.0, 1.0]) {
            assert!((m.a.t - (0.3 + sign * x.sqrt())).abs() < 1e-15 / x.sqrt(), "{x}: {found:?}");
        }
    }
}

/// Crossings of two polygons, as parameters.
fn brute(a: &CurveView<'_>, b: &CurveView<'_>, n: usize) -> Vec<(f64, f64)> {
    let sample = |c: &CurveView<'_>| -> Vec<DVec3> {
        (0..=n).map(|k| c.point(Place { segment: 0, t: k as f64 / n as f64 }).unwrap()).collect()
    };
    let (p, q) = (sample(a), sample(b));
    let mut found = vec![];
    for i in 0..n {
        for j in 0..n {
            let (u, w, d) = (p[i + 1] - p[i], q[j + 1] - q[j], q[j] - p[i]);
            let cross = |a: DVec3, b: DVec3| a.x * b.y - a.y * b.x;
            let (s, t) = (cross(d, w) / cross(u, w), cross(d, u) / cross(u, w));
            // Well inside, and not at a small angle.
            if (0.1..0.9).contains(&s) && (0.1..0.9).contains(&t) && cross(u, w).abs() > 0.1 * u.length() * w.length() {
                found.push(((i as f64 + s) / n as f64, (j as f64 + t) / n as f64));
            }
        }
    }
    found
}

fn points(len: usize) -> impl Strategy<Value = Vec<DVec3>> {
    let raw = proptest::collection::vec((-1.0..1.0f64, -1.0..1.0f64), len);
    (raw, 0..8u32).prop_map(|(raw, kind)| {
        raw.iter()
            .map(|&(x, y)| {
                if kind == 0 {
                    v(x, 0.3 * x)
                } else if kind == 1 {
                    v((x * 2.0).round(), (y * 2.0).round())
                } else {
                    v(x, y)
                }
            })
            .collect()
    })
}

proptest! {
    #[test]
    fn crossings_of_dense_polygons_are_found(
        a in (2usize..6).prop_flat_map(points), b in (2usize..6).prop_flat_map(points), scale in prop_oneof![Just(1.0), Just(1e200), Just(1e-200)]
    ) {
        let bound = (a.len() - 1) * (b.len() - 1);
        let (a, b): (Vec<_>, Vec<_>) = (a.iter().map(|&p| p * scale).collect(), b.iter().map(|&p| p * scale).collect());
        let (ea, eb) = ([0, a.len() as u32 - 1], [0, b.len() as u32 - 1]);
        let (a, b) = (CurveView::new(&a, &ea, false).unwrap(), CurveView::new(&b, &eb, false).unwrap());
        let found = a.intersections(&b, &Job::default()).unwrap();
        if found.overlaps.is_empty() && !found.undecided {
            prop_assert!(found.points.len() <= bound.max(1), "{:?}", found);
        }
        for m in &found.points {
            prop_assert!(((a.point(m.a).unwrap() - b.point(m.b).unwrap()) / scale).length() < 1e-11);
        }
        if scale == 1.0 && found.overlaps.is_empty() {
            for (s, t) in brute(&a, &b, 120) {
                prop_assert!(found.points.iter().any(|m| (m.a.t - s).abs() < 2e-2 && (m.b.t - t).abs() < 2e-2), "{} {} {:?}", s, t, found);
            }
        }
    }

    #[test]
    fn cubics_meet_themselves_once_at_most(a in points(4)) {
        let found = itself(&a, &[0, 3], false);
        if found.overlaps.is_empty() && !found.undecided {
            prop_assert!(found.points.len() <= 1, "{:?}", found);
        }
        let curve = CurveView::new(&a, &[0, 3], false).unwrap();
        for m in &found.points {
            prop_assert!(curve.point(m.a).unwrap().distance(curve.point(m.b).unwrap()) < 1e-11);
        }
        // Far apart in the parameter and crossing: found.
        for (s, t) in brute(&curve, &curve, 120) {
            if (s - t).abs() > 0.05 && found.overlaps.is_empty() {
                prop_assert!(!found.points.is_empty(), "{} {}", s, t);
            }
        }
    }
}

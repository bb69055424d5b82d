//! Composite curves with continuous curvature: the continuity, the distance from the sampled shape,
//! and the lock.
//!
//! Curvatures are computed here from differences of control points, and for ellipses from their
//! equation.

use crate::common::some_of;
use crate::outline_data::{Line, adversarial, check, outlines, random, size, solve, solve_with};
use crate::outline_solvers::within_limits;
use glam::DVec3;
use gusset::curve::{
    Constraint, CurveView, Fit, FitStatus, JointParameter, Lock, Method, Options, Outlines, PointConstraint,
    PointStatus, Points, fit,
};
use gusset::{Error, Job};
use std::f64::consts::TAU;
use std::ops::ControlFlow;

const METHODS: [Method; 4] = [Method::Bisector, Method::Median, Method::Normal, Method::Symmedian];
const LOCKS: [Lock; 3] = [Lock::Parameter, Lock::SelfConsistent, Lock::DataGuide];

fn g2(method: Method, lock: Lock) -> Options {
    Options { method, lock, joint: JointParameter::G2, ..Options::default() }
}

/// First and second derivative of a segment, by differences of its control points and de
/// Casteljau's scheme.
fn derivatives(controls: &[DVec3], t: f64) -> [DVec3; 2] {
    let differences = |points: &[DVec3]| -> Vec<DVec3> {
        points.windows(2).map(|pair| (pair[1] - pair[0]) * (points.len() - 1) as f64).collect()
    };
    let first = differences(controls);
    let second = differences(&first);
    [&first, &second].map(|points| crate::outline_data::casteljau(points, t))
}

/// The curvature, across the plane of the curve.
fn curvature(controls: &[DVec3], t: f64) -> DVec3 {
    if controls.len() < 3 {
        return DVec3::ZERO;
    }
    let [first, second] = derivatives(controls, t);
    first.cross(second) / first.length().powi(3)
}

/// The largest difference of curvatures at a joint, relative to the larger one, or to 1 / size; with
/// the joints where it is too large.
fn gaps(curve: CurveView<'_>, size: f64) -> (f64, Vec<usize>) {
    let (mut largest, mut wide) = (0.0f64, Vec::new());
    for k in 0..curve.len() - usize::from(!curve.is_closed()) {
        let here = curvature(curve.segment(k), 1.0);
        let there = curvature(curve.segment((k + 1) % curve.len()), 0.0);
        let gap = here.distance(there) / here.length().max(there.length()).max(1.0 / size);
        largest = largest.max(gap);
        if gap > 1e-6 {
            wide.push(k);
        }
    }
    (largest, wide)
}

/// Whether a curve has continuous curvature; where it has not, its points must say so.
fn is_even(line: &Line, fit: &Fit, options: &Options, what: &str) -> bool {
    check(line, fit, what);
    let (report, name) = (fit.reports()[0], &line.name);
    assert!(report.iterations <= options.max_sweeps, "{what} {name}: {} iterations", report.iterations);
    let (largest, wide) = gaps(fit.curve(0), size(line));
    assert!((report.max_curvature_gap - largest).abs() <= 1e-6 + 1e-6 * largest, "{what} {name}: {report:?} {largest}");
    for joint in wide.iter().map(|&k| k as u32) {
        let beside = |i: usize| fit.segments()[i] == joint || fit.segments()[i] == joint + 1;
        let said = (0..line.points.len()).any(|i| beside(i) && fit.statuses()[i] != PointStatus::Ok);
        assert!(said, "{what} {name}: joint {joint} has a gap of {largest:e} that no point tells");
    }
    wide.is_empty()
}

#[test]
fn real_outlines_have_continuous_curvature() {
    let all = outlines();
    let lines: Vec<&Line> = some_of(3, all.iter()).collect();
    for method in METHODS {
        for lock in LOCKS {
            let options = g2(method, lock);
            let (mut even, mut converged, mut iterations) = (0, 0, Vec::new());
            for &line in &lines {
                let fit = solve(line, &options);
                even += usize::from(is_even(line, &fit, &options, "real"));
                converged += usize::from(fit.reports()[0].status != FitStatus::NotConverged);
                iterations.push(fit.reports()[0].iterations);
            }
            iterations.sort_unstable();
            let median = iterations.get(iterations.len() / 2);
            println!(
                "{method:?} {lock:?}: {even} of {} even, {converged} converged, {median:?} iterations",
                lines.len()
            );
            assert!(100 * even >= 95 * lines.len(), "{method:?} {lock:?} {even}");
            // The lock by guides lacks a solution on some outlines with medians: see
            // outline_solvers.
            let hard = lock == Lock::DataGuide && method != Method::Bisector;
            assert!(hard || 100 * converged >= 95 * lines.len(), "{method:?} {lock:?} {converged}");
        }
    }
}

/// n points of an ellipse with the half axes a and 1, spaced unevenly by the degree `uneven`.
fn ellipse(n: usize, a: f64, uneven: f64) -> Line {
    let at = |i: usize| {
        let x = TAU * i as f64 / n as f64;
        let (sin, cos) = (x + uneven * x.sin()).sin_cos();
        DVec3::new(a * cos, sin, 0.0)
    };
    Line { name: format!("ellipse {n} {a} {uneven}"), closed: true, points: (0..n).map(at).collect() }
}

#[test]
fn ellipses_have_continuous_curvature() {
    for n in [5, 8, 13, 24, 100, 1000] {
        for (a, uneven) in [(1.0, 0.0), (1.5, 0.4), (2.0, 0.0), (5.0, 0.4)] {
            let line = ellipse(n, a, uneven);
            for method in METHODS {
                for lock in LOCKS {
                    let options = g2(method, lock);
                    let fit = solve(&line, &options);
                    assert!(is_even(&line, &fit, &options, "ellipse"), "{} {method:?} {lock:?}", line.name);
                    let told = fit.reports()[0];
                    // By symmedians the lock itself need not converge on dense points.
                    if (method, lock) != (Method::Symmedian, Lock::SelfConsistent) {
                        assert_ne!(told.status, FitStatus::NotConverged, "{} {method:?} {lock:?} {told:?}", line.name);
                    }
                }
            }
        }
    }
}

/// The largest errors of curvature, relative, and of place, relative to the half axis 1.
fn errors(fit: &Fit, a: f64) -> [f64; 2] {
    let mut worst = [0.0f64; 2];
    for segment in fit.curve(0).segments() {
        for k in 0..=20 {
            let t = f64::from(k) / 20.0;
            let p = crate::outline_data::casteljau(segment, t);
            let (sin, cos) = (p.y * a).atan2(p.x).sin_cos();
            let wanted = a / (a * a * sin * sin + cos * cos).powf(1.5);
            worst[0] = worst[0].max((curvature(segment, t).z / wanted - 1.0).abs());
            worst[1] = worst[1].max(((p.x / a).hypot(p.y) - 1.0).abs());
        }
    }
    worst
}

/// The curve with continuous curvature is not only that: it is nearer than the quadratics.
#[test]
fn curves_are_near_the_ellipse_that_the_points_are_of() {
    for (n, bars) in [(24, [6e-2, 3e-4]), (100, [3e-3, 1e-6]), (1000, [3e-5, 1e-10])] {
        let line = ellipse(n, 2.0, 0.4);
        let [plain, even] = [Options::default(), g2(Method::Bisector, Lock::Parameter)].map(|options| {
            let fit = solve(&line, &options);
            errors(&fit, 2.0)
        });
        println!("{n} points: curvature off {:.1e}, place off {:.1e}; quadratics {plain:?}", even[0], even[1]);
        for k in 0..2 {
            assert!(even[k] <= bars[k] && even[k] < 0.6 * plain[k], "{n}: {even:?}, quadratics {plain:?}");
        }
    }
}

/// Numbers that look random, from -1/2 to 1/2.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1u64 << 53) as f64 - 0.5
    }
}

/// Shapes that nothing was fitted to: sums of waves, spirals, rounded polygons with straight sides,
/// letters with stems, bowls and corners.
fn generated() -> Vec<Line> {
    let mut random = Random(4242);
    let mut lines = Vec::new();
    let mut add = |name: String, closed: bool, points: Vec<(f64, f64)>| {
        let points = points.into_iter().map(|(x, y)| DVec3::new(x, y, 0.0)).collect();
        lines.push(Line { name, closed, points });
    };
    for k in 0..36 {
        let n = [9, 17, 30, 80, 200, 700][k % 6];
        let waves: Vec<[f64; 4]> =
            (0..5).map(|m| [(); 4].map(|()| 0.6 * random.next() / f64::from(1 + m * m))).collect();
        let place = |i: usize, aside: f64| {
            let x = TAU * (i as f64 + [0.0, 0.5, 0.9][k % 3] * aside) / n as f64;
            let mut at = (x.cos(), x.sin());
            for (m, [a, b, c, d]) in waves.iter().enumerate() {
                let (sin, cos) = ((m + 2) as f64 * x).sin_cos();
                at = (at.0 + a * cos + b * sin, at.1 + c * cos + d * sin);
            }
            at
        };
        add(format!("waves {k}"), true, (0..n).map(|i| place(i, random.next())).collect());
    }
    for k in 0..12 {
        let n = 10 + 13 * k;
        let place = |i: usize| {
            let x = 12.0 * i as f64 / n as f64;
            let r = if k % 2 == 0 { (0.2 * x).exp() } else { 0.1 + x };
            (r * x.cos(), r * x.sin())
        };
        add(format!("spiral {n}"), false, (0..n).map(place).collect());
    }
    for k in 0..20 {
        let (sides, arc, straight) = (3 + k % 5, 2 + k % 7, k % 4);
        let r = 0.2 + 0.3 * random.next();
        let on_arc = |side: usize, part: f64| {
            let angle = TAU * side as f64 / sides as f64;
            let turned = angle + TAU / sides as f64 * (part - 0.5);
            ((1.0 - r) * angle.cos() + r * turned.cos(), (1.0 - r) * angle.sin() + r * turned.sin())
        };
        let mut points = Vec::new();
        for side in 0..sides {
            points.extend((0..=arc).map(|i| on_arc(side, i as f64 / arc as f64)));
            let (from, to) = (on_arc(side, 1.0), on_arc(side + 1, 0.0));
            let between = |x: f64| (from.0 + x * (to.0 - from.0), from.1 + x * (to.1 - from.1));
            points.extend((1..=straight).map(|i| between(i as f64 / (straight + 1) as f64)));
        }
        add(format!("rounded {sides} {arc} {straight}"), true, points);
    }
    for k in 0..20 {
        let width = 0.2 + 0.2 * random.next();
        let bowl = 3 + k % 8;
        let mut points = vec![(0.0, 0.0), (width, 0.0)];
        points.extend((k % 2 == 0).then_some((width, 0.3)));
        points.extend((0..=bowl).map(|i| {
            let angle = 2.8 * f64::from(i) / f64::from(bowl) - 1.4;
            (width + 0.4 * angle.cos(), 0.6 + 0.25 * angle.sin())
        }));
        points.extend([(width, 1.0), (0.0, 1.0)]);
        points.extend((k % 3 == 0).then_some((0.02, 0.5)));
        add(format!("letter {k}"), true, points);
    }
    lines
}

#[test]
fn shapes_that_nothing_was_tuned_on_have_continuous_curvature() {
    let lines: Vec<Line> = generated().into_iter().chain(random(20, 31)).collect();
    for method in METHODS {
        for lock in LOCKS {
            let options = g2(method, lock);
            let even = lines.iter().filter(|line| is_even(line, &solve(line, &options), &options, "generated")).count();
            println!("{method:?} {lock:?}: {even} of {}", lines.len());
            assert!(100 * even >= 95 * lines.len(), "{method:?} {lock:?} {even} of {}", lines.len());
        }
    }
    // For any points nothing breaks. If the curvature jumps, or is lost in the rounding of points a
    // millionth of the size apart, the points have a status.
    // (Cubes of lengths of 1e300 overflow here, and far from the origin coordinates are rounded.)
    let far = |line: &Line| line.points.iter().any(|p| p.length() > 1e6 * size(line));
    for line in adversarial().into_iter().filter(|line| (1e-99..1e99).contains(&size(line)) && !far(line)) {
        for max_sweeps in [1, 3, 200] {
            let options = Options { max_sweeps, ..g2(Method::Bisector, Lock::DataGuide) };
            let even = is_even(&line, &solve(&line, &options), &options, "adversarial");
            let hard = line.name.starts_with("space") || line.name.starts_with("geometric");
            assert!(even || max_sweeps < 200 || hard, "{}", line.name);
        }
    }
}

/// Where the tangents at the ends of a segment meet; `None` if it is straight.
fn apex(controls: &[DVec3]) -> Option<DVec3> {
    let n = controls.len() - 1;
    let (u, v) = (controls[1] - controls[0], controls[n] - controls[n - 1]);
    let across = u.cross(v).z;
    let straight = across.abs() <= 1e-4 * u.length() * v.length();
    (!straight).then(|| controls[0] + u * ((controls[n] - controls[0]).cross(v).z / across))
}

#[test]
fn the_locks_hold() {
    for line in [ellipse(24, 2.0, 0.4), ellipse(60, 1.3, 0.7)].into_iter().chain(generated().into_iter().take(6)) {
        let n = line.points.len();
        let root = |a: DVec3, b: DVec3| a.distance(b).sqrt();
        for lock in LOCKS {
            let fit = solve(&line, &g2(Method::Bisector, lock));
            let mut held = 0;
            for i in (0..n).filter(|&i| fit.statuses()[i] == PointStatus::Ok) {
                let [a, p, c] = [(i + n - 1) % n, i, (i + 1) % n].map(|k| line.points[k]);
                let (place, segment) = (fit.place(i), fit.curve(0).segment(i));
                let t = |a: DVec3, c: DVec3| within_limits(root(a, p) / (root(a, p) + root(p, c)), JointParameter::G2);
                assert_eq!(segment.len(), 4);
                let off = match lock {
                    Lock::Parameter => (place.t - t(a, c)).abs(),
                    Lock::SelfConsistent => (place.t - t(segment[0], segment[3])).abs(),
                    Lock::DataGuide => {
                        let Some(apex) = apex(segment) else { continue };
                        let across = (a - p).normalize() - (c - p).normalize();
                        (apex - p).dot(across.normalize()).abs() / size(&line)
                    }
                };
                assert!(off <= 1e-9, "{} {lock:?} {i}: {off:e}", line.name);
                held += 1;
            }
            assert!(2 * held > n, "{} {lock:?}: {held} of {n}", line.name);
        }
    }
}

#[test]
fn ends_tangents_and_corners() {
    let line = Line { closed: false, ..ellipse(20, 2.0, 0.3) };
    for closed in [false, true] {
        let line = Line { closed, ..line.clone() };
        let constraints = [
            Constraint { point: 0, kind: PointConstraint::Tangent(DVec3::Y) },
            Constraint { point: 7, kind: PointConstraint::Corner },
            Constraint { point: 13, kind: PointConstraint::TangentAngle(-2.4) },
        ];
        let options = g2(Method::Bisector, Lock::Parameter);
        let fit = solve_with(&line, &options, &constraints);
        check(&line, &fit, "constraints");
        let report = fit.reports()[0];
        assert_ne!(report.status, FitStatus::NotConverged, "{report:?}");
        let curve = fit.curve(0);
        // Within the parts all joints are even, those with the first and last segments too.
        let joints: Vec<usize> = [0, 7, 13].iter().map(|&i| fit.place(i).segment as usize).collect();
        for k in gaps(curve, size(&line)).1 {
            let next = (k + 1) % curve.len();
            assert!(joints.contains(&next), "{closed}: joint {k} of {}", curve.len());
        }
        let place = fit.place(13);
        let [first, _] = derivatives(curve.segment(place.segment as usize), place.t);
        assert!(first.normalize().distance(DVec3::new((-2.4f64).cos(), (-2.4f64).sin(), 0.0)) < 1e-12);
    }
}

/// A few outliers keep the iteration busy around them, also where the outline begins and ends.
#[test]
fn outliers_of_long_outlines_do_not_disturb_the_rest() {
    let count = 1200;
    let mut random = fastrand::Rng::with_seed(5);
    let mut ring: Vec<[f64; 2]> =
        (0..count).map(|i| TAU * i as f64 / count as f64).map(|t| [t.cos(), t.sin()]).collect();
    for outlier in [3, 40, 310, 700, 701, 1197] {
        ring[outlier] = ring[outlier].map(|x| x * (1.0 + 0.004 * (random.f64() - 0.5)));
    }
    for lock in LOCKS {
        let options = g2(Method::Bisector, lock);
        let mut first: Option<Fit> = None;
        for shift in [0, 1, 305, 1195] {
            let points: Vec<[f64; 2]> = (0..count).map(|i| ring[(i + shift) % count]).collect();
            let outlines = Outlines { points: points[..].into(), offsets: None, closed: true, constraints: &[] };
            let done = fit(&outlines, &options, &Job::default()).unwrap();
            let report = done.reports()[0];
            assert_eq!(report.status, FitStatus::Ok, "{lock:?} {shift}");
            assert!(report.iterations > 2 && report.max_residual < 1e-14, "{lock:?} {shift} {report:?}");
            assert!(gaps(done.curve(0), 2.0).1.is_empty(), "{lock:?} {shift}");
            let first = first.get_or_insert_with(|| done.clone());
            for i in 0..count {
                let (own, same) = (done.curve(0).segment(i), first.curve(0).segment((i + shift) % count));
                let far = own.iter().zip(same).map(|(p, q)| p.distance(*q)).fold(0.0, f64::max);
                assert!(far < 1e-12, "{lock:?} {shift} {i} {far:e}");
            }
        }
    }
}

#[test]
fn curves_in_space_say_that_they_are() {
    let at = |i: usize| DVec3::new((0.4 * i as f64).cos(), (0.4 * i as f64).sin(), 0.1 * i as f64);
    let line = Line { name: "helix".into(), closed: false, points: (0..40).map(at).collect() };
    let options = g2(Method::Bisector, Lock::Parameter);
    let fit = solve(&line, &options);
    assert!(!is_even(&line, &fit, &options, "helix"));
    assert!(fit.statuses()[1..39].iter().all(|&status| status == PointStatus::OutOfPlane), "{:?}", fit.statuses());
    for k in 1..fit.curve(0).len() {
        let [a, b] = [(k - 1, 1.0), (k, 0.0)].map(|(k, t)| curvature(fit.curve(0).segment(k), t).length());
        assert!((a - b).abs() <= 1e-8 * a, "{k}: {a} {b}");
    }
    // A plane outline gives the same curve in any plane.
    let line = ellipse(24, 2.0, 0.4);
    let turn = |p: DVec3| glam::DQuat::from_axis_angle(DVec3::new(1.0, 2.0, -0.5).normalize(), 1.1) * p;
    let tilted = Line { points: line.points.iter().map(|&p| turn(p)).collect(), ..line.clone() };
    let (flat, tilted) = (solve(&line, &options), solve(&tilted, &options));
    assert_eq!(tilted.reports()[0].not_ok, 0);
    for (p, q) in flat.points().iter().zip(tilted.points()) {
        assert!(turn(*p).distance(*q) <= 1e-9, "{p} {q}");
    }
}

/// The host is heard all along, whichever lock and however many threads.
#[test]
fn large_outlines_can_be_cancelled_anywhere() {
    struct Patience(std::cell::Cell<u32>);
    impl gusset::job::Progress for Patience {
        fn step(&self, _: f64, _: &'static str) -> ControlFlow<()> {
            // Threads that have begun may ask once more after a cancel.
            self.0.set(self.0.get().saturating_sub(1));
            if self.0.get() == 0 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        }
    }
    let n = 20_000;
    let points: Vec<[f64; 2]> = (0..2 * n)
        .map(|i| {
            let x = TAU * f64::from(i % n) / f64::from(n);
            let r = 1.0 + 0.1 * (7.0 * x).sin() + 0.01 * (1250.0 * x).sin();
            [r * x.cos(), r * x.sin()]
        })
        .collect();
    let offsets = [0, n as u32, 2 * n as u32];
    let outlines =
        Outlines { points: Points::from(&points[..]), offsets: Some(&offsets), closed: true, constraints: &[] };
    let options = Options { max_sweeps: 12, ..g2(Method::Bisector, Lock::DataGuide) };
    let asked = |patience: u32, threads: usize| {
        let patience = Patience(std::cell::Cell::new(patience));
        let done = fit(&outlines, &options, &Job::new(threads, &patience));
        (done.map(|done| done.reports()[1]), patience.0.get())
    };
    let (done, left) = asked(u32::MAX, 1);
    // Some passes over the points for each iteration, and an answer for every 16,384 at least.
    let answers = u32::MAX - left;
    assert!(answers > 2 * 12 * 6, "{answers} answers, {done:?}");
    for k in [2, answers / 7, answers / 2, answers - 3] {
        assert_eq!(asked(k, 1), (Err(Error::Cancelled), 0));
    }
    for k in [2, answers / 7] {
        assert_eq!(asked(k, 2).0, Err(Error::Cancelled));
    }
    assert_eq!(asked(u32::MAX, 2).0, done);
}

//! The paper's cycles: does the history of an iteration follow the list of steps, and does it
//! contain these cycles only?
//!
//! The tests compute each cycle apart, from the definitions of guides and crossings.

use crate::outline_choices::open;
use crate::outline_data::{Line, arc, blob, random, size, solve};
use glam::DVec3;
use gusset::Job;
use gusset::curve::{
    Constraint, CurveKind, Fit, FitStatus, Lock, Method, Options, Outlines, PointConstraint, PointStatus, Points,
    Solver, sections,
};

const CHORD_METHODS: [Method; 3] = [Method::Normal, Method::Bisector, Method::Median];

/// The unit direction of the guide through P.
fn guide(method: Method, [a, p, c]: [DVec3; 3]) -> DVec3 {
    let chord = c - a;
    let across = DVec3::new(-chord.y, chord.x, 0.0);
    let direction = match method {
        Method::Normal => across,
        Method::Median => p - (a + c) * 0.5,
        _ => -((a - p).normalize() + (c - p).normalize()),
    };
    direction.normalize()
}

/// The parameter of P on the section of its own triangle.
fn section_parameter(method: Method, [a, p, c]: [DVec3; 3]) -> f64 {
    let share = match method {
        Method::Normal => (p - a).dot(c - a) / (c - a).length_squared(),
        Method::Median => 0.5,
        _ => p.distance(a) / (p.distance(a) + p.distance(c)),
    };
    share.sqrt() / (share.sqrt() + (1.0 - share).sqrt())
}

fn bernstein(n: usize, i: usize, t: f64) -> f64 {
    let binomial: f64 = (0..i).map(|k| (n - k) as f64 / (k + 1) as f64).product();
    binomial * t.powi(i as i32) * (1.0 - t).powi((n - i) as i32)
}

fn point_at(controls: &[DVec3], t: f64) -> DVec3 {
    let n = controls.len() - 1;
    (0..=n).map(|i| controls[i] * bernstein(n, i, t)).sum()
}

/// The crossing of the curve with the guide that is nearest to a parameter.
fn nearest_crossing(controls: &[DVec3], p: DVec3, guide: DVec3, from: f64) -> f64 {
    let f = |t: f64| guide.perp_dot_xy(point_at(controls, t) - p);
    let samples = 4000;
    let at = |k: usize| k as f64 / f64::from(samples);
    let roots = (0..samples as usize).filter(|&k| (f(at(k)) > 0.0) != (f(at(k + 1)) > 0.0)).map(|k| {
        let (mut low, mut high) = (at(k), at(k + 1));
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if (f(middle) > 0.0) == (f(low) > 0.0) { low = middle } else { high = middle }
        }
        0.5 * (low + high)
    });
    roots.min_by(|a, b| (a - from).abs().total_cmp(&(b - from).abs())).unwrap_or(from)
}

trait PerpDot {
    fn perp_dot_xy(self, other: DVec3) -> f64;
}

impl PerpDot for DVec3 {
    fn perp_dot_xy(self, other: DVec3) -> f64 {
        self.x * other.y - self.y * other.x
    }
}

/// The paper's search: steps along the guide, a tenth of the step after each change of the flag.
fn step(size: f64, deviation: impl Fn(f64) -> f64) -> f64 {
    let tolerance = 1e-12 * 0.125 * size;
    let (mut x, mut length, mut flag) = (0.0, 0.1 * size, 0.0);
    loop {
        let left = deviation(x);
        if left.abs() <= tolerance || (flag * left < 0.0 && length <= tolerance) {
            return x;
        }
        if flag * left < 0.0 {
            length /= 10.0;
        }
        flag = left.signum();
        x += flag * length;
    }
}

/// The control points of a single curve after each cycle, by the list of steps.
fn literal_cycles(line: &Line, method: Method, cycles: usize) -> Vec<Vec<DVec3>> {
    let (points, n) = (&line.points, line.points.len() - 1);
    let triple = |i: usize| [points[i - 1], points[i], points[i + 1]];
    let (mut t, mut span) = (vec![0.0, 1.0], 1.0);
    for i in 1..n {
        let own = section_parameter(method, triple(i));
        span *= (1.0 - own) / own;
        t.push(t[i] + span);
    }
    let whole = t[n];
    t.iter_mut().for_each(|t| *t /= whole);
    let mut controls = points.clone();
    (0..cycles)
        .map(|_| {
            for i in 1..n {
                let along = guide(method, triple(i));
                t[i] = nearest_crossing(&controls, points[i], along, t[i]);
                let left = points[i] - point_at(&controls, t[i]);
                let slope = bernstein(n, i, t[i]);
                controls[i] += along * step(size(line), |x| along.dot(left) - slope * x);
            }
            controls.clone()
        })
        .collect()
}

/// The control points of outline 0 after each cycle.
fn recorded_cycles(fit: &Fit) -> Vec<&[DVec3]> {
    let (controls, mut from) = (fit.history_controls(0), 0);
    let cycles = fit.history(0).iter().map(|cycle| {
        let own = &controls[from..cycle.control_end as usize];
        from = cycle.control_end as usize;
        own
    });
    cycles.collect()
}

fn literal(method: Method, max_sweeps: u32) -> Options {
    Options {
        curve: CurveKind::Single,
        method,
        lock: Lock::DataGuide,
        solver: Solver::Step,
        max_sweeps,
        history: true,
        ..Options::default()
    }
}

#[test]
fn cycles_of_single_curves_follow_the_list_of_steps() {
    let paper = open(&[(0.0, 0.0), (0.0, 4.0), (3.0, 5.0), (5.0, 1.0)]);
    for line in [paper, arc(4), arc(6), arc(8)] {
        for method in CHORD_METHODS {
            let expected = literal_cycles(&line, method, 6);
            let fit = solve(&line, &literal(method, 6));
            let recorded = recorded_cycles(&fit);
            assert_eq!((recorded.len(), fit.reports()[0].iterations), (6, 6), "{} {method:?}", line.name);
            for (k, (recorded, expected)) in recorded.iter().zip(&expected).enumerate() {
                for (p, q) in recorded.iter().zip(expected) {
                    assert!(p.distance(*q) <= 1e-12 * size(&line), "{} {method:?} {k}: {p} {q}", line.name);
                }
            }
            let moves: Vec<f64> = fit.history(0).iter().map(|cycle| cycle.moved * size(&line)).collect();
            for (k, pair) in expected.windows(2).enumerate() {
                let moved = pair[0].iter().zip(&pair[1]).map(|(p, q)| p.distance(*q)).fold(0.0, f64::max);
                assert!((moved - moves[k + 1]).abs() <= 1e-12 * size(&line), "{} {method:?} {k}", line.name);
            }
        }
    }
}

#[test]
fn the_limit_on_sweeps_is_the_number_of_cycles() {
    let line = arc(8);
    let all = solve(&line, &literal(Method::Bisector, 200));
    for sweeps in [1, 2, 3, 4, 5, 6, 40] {
        let some = solve(&line, &literal(Method::Bisector, sweeps));
        assert_eq!(some.history(0), &all.history(0)[..sweeps as usize]);
        assert_eq!(some.history_controls(0), &all.history_controls(0)[..some.history_controls(0).len()]);
        assert_eq!(some.reports()[0].status, FitStatus::NotConverged);
    }
    // A half circle of degree 7 needs nearly all of the default's 200 sweeps.
    let report = all.reports()[0];
    assert!(report.status == FitStatus::Ok && (150..=200).contains(&report.iterations), "{report:?}");
    assert_eq!(all.history(0).len(), report.iterations as usize);
}

/// Each cycle of a chain, computed from the control points after the one before.
#[test]
fn cycles_of_chains_follow_from_the_previous_control_points() {
    for line in [blob(12, 0.4), blob(30, 1.1)] {
        for method in CHORD_METHODS {
            let options = Options { curve: CurveKind::Chain, ..literal(method, 12) };
            let fit = solve(&line, &options);
            let (recorded, points, n) = (recorded_cycles(&fit), &line.points, line.points.len());
            assert!(recorded.len() == 12 || fit.reports()[0].status == FitStatus::Ok);
            let mut compared = 0;
            for pair in recorded.windows(2) {
                let mut controls = pair[0].to_vec();
                for i in 0..n {
                    let (before, after) = ((i + n - 1) % n, (i + 1) % n);
                    let along = guide(method, [points[before], points[i], points[after]]);
                    let [a, c] = [controls[before], controls[after]].map(|p| p - points[i]);
                    let [across_a, across_c] = [a, c].map(|p| along.perp_dot_xy(p));
                    assert!(across_a * across_c < 0.0, "{} {method:?}: no crossing at {i}", line.name);
                    let t = across_a.abs().sqrt() / (across_a.abs().sqrt() + across_c.abs().sqrt());
                    let (first, last) = (0.5 * (1.0 - t) * (1.0 - t), 0.5 * t * t);
                    controls[i] = points[i] - along * (along.dot(a * first + c * last) / (1.0 - first - last));
                    compared += 1;
                }
                for (p, q) in pair[1].iter().zip(&controls) {
                    assert!(p.distance(*q) <= 1e-12 * size(&line), "{} {method:?}: {p} {q}", line.name);
                }
            }
            assert!(compared >= 2 * n, "{} {method:?}", line.name);
        }
    }
}

/// The replacement of a solver that fails is not part of its history.
#[test]
fn histories_lack_the_cycles_of_replacements() {
    for line in random(30, 9) {
        for curve in [CurveKind::Single, CurveKind::Chain] {
            for solver in [Solver::Fast, Solver::Step] {
                let options = Options { curve, solver, ..literal(Method::Median, 7) };
                let fit = solve(&line, &options);
                let report = fit.reports()[0];
                assert!(report.iterations <= 7);
                assert!(fit.history(0).len() <= report.iterations as usize, "{} {options:?}", line.name);
                assert_eq!(
                    fit.history(0).last().map_or(0, |cycle| cycle.control_end as usize),
                    fit.history_controls(0).len()
                );
            }
        }
    }
}

/// A section with a tangent at its start, its end or its middle, by steps and in closed form.
#[test]
fn sections_with_tangents_are_found_by_steps() {
    let points = [[0.0, 0.0], [1.0, 1.0], [3.0, 0.5]];
    let mut found = 0;
    for place in 0..3 {
        for k in 0..72 {
            let (sine, cosine) = (std::f64::consts::TAU * f64::from(k) / 72.0).sin_cos();
            let tangent = DVec3::new(cosine, sine, 0.0);
            let constraints = [Constraint { point: place, kind: PointConstraint::Tangent(tangent) }];
            let given =
                Outlines { points: Points::from(&points[..]), offsets: None, closed: false, constraints: &constraints };
            let [fast, stepped] = [Solver::Fast, Solver::Step]
                .map(|solver| sections(&given, &Options { solver, ..Options::default() }, &Job::default()).unwrap());
            assert_eq!(fast.statuses, stepped.statuses);
            assert!(fast.steps == 0 && stepped.steps > 0);
            let size = fast.controls[1].length().max(3.0);
            assert!(fast.controls[1].distance(stepped.controls[1]) <= 1e-11 * size, "{place} {k}");
            found += u32::from(fast.statuses[1] == PointStatus::Ok);
        }
    }
    assert!(found > 30, "{found}");
}

//! The iterations that find curves through points: do they solve the equations they should, and
//! what becomes of hard data?
//!
//! Results are checked against the definitions: the tests evaluate curves by de Casteljau's scheme,
//! and compute the method's parameters from angles and lengths.

use crate::outline_data::{Line, adversarial, arc, blob, check, outlines, random, sine, size, solve, solve_with};
use glam::DVec3;
use gusset::Job;
use gusset::curve::{
    Constraint, CurveKind, CurveView, Fit, FitStatus, JointParameter, Lock, Method, Options, Outlines, PointConstraint,
    PointStatus, Points, Solver, fit, step_section,
};
use proptest::prelude::*;

/// The control point, the first and the last point of a point's segment, and its parameter.
pub(crate) fn section<'a>(curve: CurveView<'a>, fit: &Fit, i: usize) -> Option<(&'a [DVec3], f64)> {
    let place = fit.place(i);
    let controls = curve.segment(place.segment as usize);
    (controls.len() == 3 && place.t > 0.0 && place.t < 1.0).then_some((controls, place.t))
}

/// The parameter of the bisector: the roots of the legs.
pub(crate) fn centripetal(a: DVec3, p: DVec3, c: DVec3) -> f64 {
    let (before, after) = ((p - a).length().sqrt(), (c - p).length().sqrt());
    before / (before + after)
}

/// The parameter within the default limits.
pub(crate) fn within_limits(t: f64, joint: JointParameter) -> f64 {
    let limit = if joint == JointParameter::G2 { 1.0 / 12.0 } else { 0.01 };
    t.clamp(limit, 1.0 - limit)
}

#[test]
fn self_consistent_parameters_on_all_outlines() {
    let options = Options { lock: Lock::SelfConsistent, ..Options::default() };
    let mut iterations = Vec::new();
    for line in outlines() {
        let fit = solve(&line, &options);
        check(&line, &fit, "self-consistent");
        let (report, size, curve) = (fit.reports()[0], size(&line), fit.curve(0));
        assert!(report.last_move <= options.tolerance, "{}: {report:?}", line.name);
        iterations.push(report.iterations);
        for i in 0..line.points.len() {
            let status = fit.statuses()[i];
            let Some((controls, t)) = section(curve, &fit, i) else { continue };
            assert!(
                matches!(
                    status,
                    PointStatus::Ok | PointStatus::ClampedParameter | PointStatus::Merged | PointStatus::Looped
                ),
                "{status:?}"
            );
            let wanted = within_limits(centripetal(controls[0], line.points[i], controls[2]), options.joint);
            let error = (t - wanted).abs() * controls[2].distance(controls[0]);
            assert!(error <= 1e-11 * size, "{} {i}: t {t}, not {wanted}", line.name);
        }
    }
    iterations.sort_unstable();
    if let Some(&most) = iterations.last() {
        println!("{} outlines, iterations: median {}, most {most}", iterations.len(), iterations[iterations.len() / 2]);
        assert!(most <= 10);
    }
}

#[test]
fn control_points_lie_on_the_guides_of_the_data() {
    let options = Options { lock: Lock::DataGuide, ..Options::default() };
    for (solver, joint) in [
        (Solver::Fast, JointParameter::Half),
        (Solver::Step, JointParameter::Half),
        (Solver::Fast, JointParameter::Knot),
    ] {
        let (mut kept, mut all) = (0, 0);
        for line in outlines().into_iter().chain([blob(24, 0.0), blob(25, 1.0)]).filter(|line| line.points.len() < 600)
        {
            let n = line.points.len();
            let fit = solve(&line, &Options { solver, joint, ..options });
            check(&line, &fit, "guides");
            let size = size(&line);
            for i in 0..n {
                let Some((controls, t)) = section(fit.curve(0), &fit, i) else { continue };
                let [a, p, c] = [line.points[(i + n - 1) % n], line.points[i], line.points[(i + 1) % n]];
                all += 1;
                let (u, v) = (a - p, c - p);
                match fit.statuses()[i] {
                    PointStatus::Ok if u.length() > 0.0 && v.length() > 0.0 => {
                        kept += 1;
                        // Half of the angle from leg to leg.
                        let (from, to) = (u.y.atan2(u.x), v.y.atan2(v.x));
                        let half = 0.5 * (from + to);
                        let b = controls[1] - p;
                        let across = b.x * half.sin() - b.y * half.cos();
                        let aside = across.abs().min((b.x * half.cos() + b.y * half.sin()).abs());
                        assert!(aside <= 2e-11 * size, "{} {i}: {aside:e} off the guide", line.name);
                    }
                    PointStatus::NoCrossing | PointStatus::FellBack => {
                        assert_eq!(t, within_limits(centripetal(a, p, c), options.joint), "{} {i}", line.name);
                    }
                    _ => {}
                }
            }
        }
        println!("{solver:?} {joint:?}: {kept} of {all} points kept their guides");
        assert!(f64::from(kept) >= 0.99 * f64::from(all));
    }
}

#[test]
fn stepping_agrees_with_closed_forms_on_sections() {
    let mut agreed = 0;
    for line in random(300, 3) {
        let [a, p, c] = [0, 1, 2].map(|k| line.points[k]);
        for method in [Method::Bisector, Method::Median, Method::Normal, Method::Symmedian, Method::Alpha(0.3)] {
            let fast = method.compute_section(a, p, c);
            match (fast, step_section(a, p, c, method, &Options::default(), &Job::default()).unwrap()) {
                (Ok(fast), Ok((stepped, steps))) => {
                    let size = size(&line).max(fast.control.distance(p));
                    assert!(fast.control.distance(stepped.control) <= 1e-11 * size, "{method:?} {fast:?} {stepped:?}");
                    assert!((fast.t - stepped.t).abs() <= 1e-11, "{method:?} {fast:?} {stepped:?}");
                    assert!(steps > 0 && steps < 2000);
                    agreed += 1;
                }
                (fast, stepped) => assert_eq!(fast.err(), stepped.err()),
            }
        }
    }
    assert!(agreed > 1200, "{agreed}");
    // On the chord, at its middle, and there and back.
    let (section, steps) =
        step_section(DVec3::ZERO, DVec3::X, DVec3::X * 2.0, Method::Median, &Options::default(), &Job::default())
            .unwrap()
            .unwrap();
    assert_eq!((section.control, section.t, steps), (DVec3::X, 0.5, 0));
    let back = step_section(DVec3::ZERO, DVec3::X, DVec3::ZERO, Method::Bisector, &Options::default(), &Job::default())
        .unwrap();
    assert!(back.is_err() || back.unwrap().0.control.is_finite());
}

#[test]
fn stepping_agrees_with_fast_solutions_of_outlines() {
    let lines: Vec<Line> =
        outlines().into_iter().filter(|line| line.name.starts_with("foot") && line.points.len() < 300).collect();
    for line in lines.into_iter().chain([blob(24, 0.0), blob(31, 0.7), arc(9)]) {
        for lock in [Lock::Parameter, Lock::SelfConsistent, Lock::DataGuide] {
            let fast = Options { lock, ..Options::default() };
            let (fast, stepped) = (solve(&line, &fast), solve(&line, &Options { solver: Solver::Step, ..fast }));
            assert!(stepped.reports()[0].steps > 10 * line.points.len() as u64, "{}", line.name);
            assert_eq!(fast.statuses(), stepped.statuses(), "{} {lock:?}", line.name);
            near(&line, &fast, &stepped, 1e-11, "stepping");
        }
    }
    for line in [arc(3), arc(5), sine(4), sine(5)] {
        for lock in [Lock::Parameter, Lock::DataGuide] {
            let fast = Options { curve: CurveKind::Single, lock, ..Options::default() };
            let (fast, stepped) = (solve(&line, &fast), solve(&line, &Options { solver: Solver::Step, ..fast }));
            assert_eq!(stepped.reports()[0].status, FitStatus::Ok, "{} {lock:?}", line.name);
            check(&line, &stepped, "single, stepping");
            near(&line, &fast, &stepped, 1e-11, "single, stepping");
        }
    }
}

/// The control points of two curves are within a tolerance, times the size.
pub(crate) fn near(line: &Line, a: &Fit, b: &Fit, tolerance: f64, what: &str) {
    assert_eq!(a.points().len(), b.points().len(), "{what} {}", line.name);
    let far = a.points().iter().zip(b.points()).map(|(p, q)| p.distance(*q)).fold(0.0, f64::max) / size(line);
    assert!(far <= tolerance, "{what} {}: {far:e}", line.name);
}

#[test]
fn nothing_breaks_the_solvers() {
    let mut lines = adversarial();
    lines.extend(random(12, 17));
    // All but straight: guides across, crossings near the ends.
    for n in [6, 10, 16] {
        lines.extend(random(24, n).into_iter().map(|mut line| {
            line.points.iter_mut().for_each(|p| p.y *= 1e-9);
            line
        }));
    }
    let methods = [Method::Bisector, Method::Median, Method::Normal, Method::Symmedian, Method::Alpha(0.25)];
    for line in &lines {
        for method in methods {
            for lock in [Lock::Parameter, Lock::SelfConsistent, Lock::DataGuide] {
                for joint in [JointParameter::Half, JointParameter::Knot, JointParameter::G2] {
                    let options = Options { method, lock, joint, max_sweeps: 60, ..Options::default() };
                    check(line, &solve(line, &options), &format!("{method:?} {lock:?} {joint:?}"));
                }
                let step = Options {
                    method,
                    lock,
                    solver: Solver::Step,
                    max_sweeps: 20,
                    max_steps: 300,
                    ..Options::default()
                };
                check(line, &solve(line, &step), &format!("{method:?} {lock:?} steps"));
                for (joint, max_sweeps) in
                    [(JointParameter::Knot, 1), (JointParameter::Knot, 5), (JointParameter::G2, 5)]
                {
                    let hasty = Options { method, lock, joint, max_sweeps, ..Options::default() };
                    check(line, &solve(line, &hasty), &format!("{method:?} {lock:?} {joint:?}, {max_sweeps} sweeps"));
                }
                let knots = Options { joint: JointParameter::Knot, ..step };
                check(line, &solve(line, &knots), &format!("{method:?} {lock:?} knots, steps"));
                let single = Options { curve: CurveKind::Single, ..step };
                check(line, &solve(line, &single), &format!("single {method:?} {lock:?} steps"));
                let single = Options { solver: Solver::Fast, ..single };
                check(line, &solve(line, &single), &format!("single {method:?} {lock:?}"));
            }
        }
    }
}

#[test]
fn the_bisector_is_self_consistent_for_any_points() {
    let options = Options { lock: Lock::SelfConsistent, ..Options::default() };
    for line in random(60, 40) {
        let fit = solve(&line, &options);
        assert_eq!(fit.reports()[0].status, FitStatus::Ok, "{:?}", fit.reports()[0]);
    }
}

/// Turned, larger, from the other end, and from another point on.
#[test]
fn solutions_move_with_the_points() {
    let options = Options { tolerance: 1e-14, ..Options::default() };
    let locks = [Lock::Parameter, Lock::SelfConsistent, Lock::DataGuide];
    for line in [blob(24, 0.0), blob(37, 1.3)] {
        for lock in locks {
            for joint in [JointParameter::Half, JointParameter::Knot] {
                let options = Options { lock, joint, ..options };
                let plain = solve(&line, &options);
                assert_eq!(plain.reports()[0].not_ok, 0, "{lock:?} {joint:?} {:?}", plain.reports()[0]);
                let (sin, cos) = 0.7f64.sin_cos();
                let turn = |p: DVec3| DVec3::new(cos * p.x - sin * p.y, sin * p.x + cos * p.y, p.z) * 1e5;
                let turned = Line { points: line.points.iter().map(|&p| turn(p)).collect(), ..line.clone() };
                // The joint where a closed curve begins depends on the first point.
                let controls = |fit: &Fit| -> Vec<DVec3> { fit.curve(0).segments().map(|s| s[1]).collect() };
                let far = |a: &[DVec3], b: &[DVec3]| a.iter().zip(b).map(|(p, q)| p.distance(*q)).fold(0.0, f64::max);
                let wanted: Vec<DVec3> = controls(&plain).into_iter().map(turn).collect();
                let found = far(&controls(&solve(&turned, &options)), &wanted) / size(&turned);
                assert!(found <= 1e-12, "{lock:?} {joint:?} turned: {found:e}");
                let mut shifted = line.clone();
                shifted.points.rotate_left(5);
                let mut wanted = controls(&plain);
                wanted.rotate_left(5);
                let found = far(&controls(&solve(&shifted, &options)), &wanted) / size(&line);
                assert!(found <= 1e-12, "{lock:?} {joint:?} shifted: {found:e}");
                let mut backwards = line.clone();
                backwards.points.reverse();
                let mut wanted = controls(&plain);
                wanted.reverse();
                let found = far(&controls(&solve(&backwards, &options)), &wanted) / size(&line);
                assert!(found <= 1e-12, "{lock:?} {joint:?} backwards: {found:e}");
            }
        }
    }
}

/// Exhausted steps differ in status from converged steps.
#[test]
fn too_few_steps_or_sweeps_are_said_to_be() {
    for lock in [Lock::SelfConsistent, Lock::DataGuide] {
        for few in [Options { max_steps: 3, ..Options::default() }, Options { max_sweeps: 1, ..Options::default() }] {
            let options = Options { lock, solver: Solver::Step, ..few };
            let line = blob(24, 0.0);
            let fit = solve(&line, &options);
            check(&line, &fit, "few");
            assert_eq!(fit.reports()[0].status, FitStatus::NotConverged, "{lock:?} {:?}", fit.reports()[0]);
            assert!(fit.statuses().iter().all(|&status| status == PointStatus::FellBack), "{:?}", fit.statuses());
            // The lock by parameters remains.
            near(&line, &fit, &solve(&line, &Options::default()), 1e-15, "few");
        }
    }
}

/// Wild points: a point lies on its guide exactly if its status says so.
#[test]
fn lost_guides_are_told() {
    let (mut kept, mut lost) = (0, 0);
    for curve_kind in [CurveKind::Composite, CurveKind::Single] {
        for line in random(40, 9) {
            let n = line.points.len();
            let fit = solve(&line, &Options { curve: curve_kind, lock: Lock::DataGuide, ..Options::default() });
            check(&line, &fit, "lost");
            let curve = fit.curve(0);
            for i in 1..n - 1 {
                let [a, p, c] = [line.points[i - 1], line.points[i], line.points[i + 1]];
                let place = fit.place(i);
                let controls = curve.segment(place.segment as usize);
                let closed = usize::from(line.closed);
                let b = if controls.len() == 3 { controls[1] } else { controls[i + closed] };
                let across = (a - p).normalize() - (c - p).normalize();
                let aside = (b - p).dot(across.normalize()).abs();
                let on = aside <= 1e-9 * b.distance(p).max(1.0);
                let said = matches!(fit.statuses()[i], PointStatus::Ok | PointStatus::Looped);
                assert_eq!(on, said, "{curve_kind:?} {} {i}: {aside:e} {:?}", line.name, fit.statuses()[i]);
                kept += u32::from(on);
                lost += u32::from(!on);
            }
        }
    }
    assert!(kept > 50 && lost > 50, "{kept} {lost}");
}

/// All but straight, with a tangent out of its plane: with guides, control points go astray with
/// any shares of the joints.
#[test]
fn what_runs_away_with_any_joints_is_solved_by_parameters() {
    let points = [
        (0.697, 7.8),
        (0.335, 4.4),
        (0.025, 6.9),
        (0.488, 2.7),
        (0.676, 4.5),
        (0.157, 9.1),
        (0.276, 0.0),
        (0.239, 7.3),
        (0.275, 0.8),
        (0.309, 1.3),
        (0.44, 8.2),
        (0.271, 1.8),
        (0.182, 6.0),
        (0.871, 1.7),
        (0.066, 3.5),
        (0.861, 0.4),
    ];
    let points = points.map(|(x, y)| DVec3::new(x, y * 1e-10, 0.0)).to_vec();
    let line = Line { name: "astray".into(), closed: false, points };
    let constraints = [Constraint { point: 7, kind: PointConstraint::Tangent(DVec3::new(-0.11, 0.36, 0.15)) }];
    let options = Options { method: Method::Median, lock: Lock::DataGuide, ..Options::default() };
    for (joint, parameter_limit) in
        [(JointParameter::Knot, Some(1e-3)), (JointParameter::Knot, None), (JointParameter::G2, Some(1e-3))]
    {
        let fit = solve_with(&line, &Options { joint, parameter_limit, ..options }, &constraints);
        assert!(fit.reports()[0].max_residual <= 1e-14, "{joint:?} {:?}", fit.reports()[0]);
        let fell_back = |s: &PointStatus| matches!(s, PointStatus::FellBack | PointStatus::JointFellBack);
        assert!(fit.statuses().iter().any(fell_back), "{joint:?} {:?}", fit.statuses());
    }
}

#[test]
fn points_in_space() {
    let helix = |n: usize| {
        let at = |i: usize| (i as f64 * 0.4).sin_cos();
        Line {
            name: "helix".into(),
            closed: false,
            points: (0..n).map(|i| DVec3::new(at(i).0, at(i).1, 0.1 * i as f64)).collect(),
        }
    };
    let line = helix(40);
    let fit = solve(&line, &Options { lock: Lock::SelfConsistent, ..Options::default() });
    check(&line, &fit, "helix");
    assert_eq!(fit.reports()[0].status, FitStatus::Ok);
    for i in 1..39 {
        let (controls, t) = section(fit.curve(0), &fit, i).unwrap();
        assert!((t - centripetal(controls[0], line.points[i], controls[2])).abs() < 1e-11);
    }
    for curve_kind in [CurveKind::Composite, CurveKind::Single] {
        let fit = solve(&helix(8), &Options { curve: curve_kind, lock: Lock::DataGuide, ..Options::default() });
        check(&helix(8), &fit, "helix, guides");
        assert!(fit.statuses()[1..7].iter().all(|&status| status == PointStatus::OutOfPlane), "{:?}", fit.statuses());
    }
    // A plane outline gives the same curve in any plane.
    let (line, turn) =
        (blob(24, 0.0), |p: DVec3| glam::DQuat::from_axis_angle(DVec3::new(1.0, 2.0, -0.5).normalize(), 1.1) * p);
    let tilted = Line { points: line.points.iter().map(|&p| turn(p)).collect(), ..line.clone() };
    for lock in [Lock::SelfConsistent, Lock::DataGuide] {
        let options = Options { lock, tolerance: 1e-14, ..Options::default() };
        let (flat, tilted) = (solve(&line, &options), solve(&tilted, &options));
        assert_eq!(tilted.reports()[0].not_ok, 0);
        for (p, q) in flat.points().iter().zip(tilted.points()) {
            assert!(turn(*p).distance(*q) <= 1e-12 * size(&line), "{lock:?}");
        }
    }
}

/// With joints by knots the speed is continuous: legs at a joint are as the spans of its sections.
#[test]
fn joints_by_knots() {
    let line = blob(30, 0.9);
    let n = line.points.len();
    let fit = solve(&line, &Options { joint: JointParameter::Knot, ..Options::default() });
    assert_eq!(fit.reports()[0].not_ok, 0);
    let chord = |i: usize| line.points[i % n].distance(line.points[(i + 1) % n]).sqrt();
    for i in 0..n {
        let (here, there) = (fit.curve(0).segment(i), fit.curve(0).segment((i + 1) % n));
        let ratio = here[2].distance(here[1]) / there[1].distance(there[0]);
        let spans = (chord(i + n - 1) + chord(i)) / (chord(i) + chord(i + 1));
        assert!((ratio / spans - 1.0).abs() < 1e-9, "{i}: {ratio} {spans}");
    }
    // Spans of 1 and a million.
    let line = Line {
        points: (0..40)
            .map(|i| DVec3::new(f64::from(i / 2) + 1e-6 * f64::from(i % 2), f64::from(i * i % 7), 0.0))
            .collect(),
        ..line
    };
    let fit = solve(&line, &Options { joint: JointParameter::Knot, method: Method::Symmedian, ..Options::default() });
    check(&line, &fit, "knots");
}

/// Where joints by curvatures come to rest, the curvature is the same on both sides.
#[test]
fn joints_by_curvatures() {
    let mut checked = 0;
    for line in [blob(12, 0.3), blob(16, 0.0), arc(9)] {
        let fit = solve(&line, &Options { joint: JointParameter::G2, max_sweeps: 2000, ..Options::default() });
        check(&line, &fit, "curvatures");
        assert_ne!(fit.reports()[0].status, FitStatus::NotConverged, "{} {:?}", line.name, fit.reports()[0]);
        assert!(fit.reports()[0].iterations <= 15, "{} {:?}", line.name, fit.reports()[0]);
        let curve = fit.curve(0);
        let curvature = |a: DVec3, b: DVec3, c: DVec3| (b - a).cross(c - b).z / (b - a).length().powi(3);
        for k in 0..curve.len() - usize::from(!line.closed) {
            let (here, there) = (curve.segment(k), curve.segment((k + 1) % curve.len()));
            if fit.statuses()[k + usize::from(!line.closed)] != PointStatus::Ok {
                continue;
            }
            let [.., p, q, r] = *here else { panic!("{here:?}") };
            let before = -curvature(r, q, p);
            let after = curvature(there[0], there[1], there[2]);
            assert!(
                (before.abs() - after.abs()).abs() <= 1e-8 * before.abs().max(1.0),
                "{} {k}: {before} {after}",
                line.name
            );
            checked += 1;
        }
    }
    assert!(checked > 20, "{checked}");
}

/// The second derivative of a segment in its knots.
fn second_derivative(segment: &[DVec3], interval: f64, t: f64) -> DVec3 {
    let [p, q, r, s] = [segment[0], segment[1], segment[2], segment[3]];
    ((r - q * 2.0 + p) * (1.0 - t) + (s - r * 2.0 + q) * t) * 6.0 / (interval * interval)
}

proptest! {
    #[test]
    fn second_derivatives_of_cubic_splines_are_continuous(
        points in prop::collection::vec((-9i8..9, -9i8..9, -9i8..9), 4..30),
        closed: bool,
        alpha in 0.0f64..1.0,
    ) {
        let points: Vec<[f64; 3]> = points
            .iter()
            .enumerate()
            .map(|(i, &(x, y, z))| [f64::from(x), f64::from(y) + 0.1 * i as f64, f64::from(z)])
            .collect();
        // A closed outline drops a last point that repeats the first.
        prop_assume!(!closed || points[0] != points[points.len() - 1]);
        let outlines = Outlines { points: Points::from(&points[..]), offsets: None, closed, constraints: &[] };
        let options = Options { curve: CurveKind::CubicC2, method: Method::Alpha(alpha), ..Options::default() };
        let done = fit(&outlines, &options, &Job::default()).unwrap();
        let curve = done.curve(0);
        let n = points.len();
        prop_assert_eq!(curve.len(), if closed { n } else { n - 1 });
        let at = |i: usize| DVec3::from_array(points[i % n]);
        let interval = |i: usize| at(i).distance(at(i + 1)).powf(alpha);
        for k in 0..curve.len() - usize::from(!closed) {
            let next = (k + 1) % curve.len();
            let (a, b) = (curve.segment(k), curve.segment(next));
            let slope = |p: DVec3, q: DVec3, i: usize| (q - p) * 3.0 / interval(i);
            let jump = slope(a[2], a[3], k) - slope(b[0], b[1], next);
            prop_assert!(jump.length() < 1e-10 * (1.0 + slope(a[2], a[3], k).length()), "slope {k} {jump}");
            let (left, right) = (second_derivative(a, interval(k), 1.0), second_derivative(b, interval(next), 0.0));
            prop_assert!((left - right).length() < 1e-9 * (10.0 + left.length()), "bend {k} {left} {right}");
        }
    }
}

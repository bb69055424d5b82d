//! Options of outlines beside the kind of curve: control points on guides, tangents by angles,
//! level and upright ends, cycles, stepping of sections; and the statuses of points that do not
//! fulfil them.

use crate::outline_data::{Line, adversarial, arc, blob, check, outlines, random, size, solve, solve_with};
use glam::DVec3;
use gusset::Job;
use gusset::curve::{
    Constraint, CurveKind, Ends, FitStatus, JointParameter, Lock, Method, Options, Outlines, PointConstraint,
    PointStatus, Points, Solver, fit, sections,
};

const METHODS: [Method; 4] = [Method::Bisector, Method::Median, Method::Normal, Method::Symmedian];

pub(crate) fn open(points: &[(f64, f64)]) -> Line {
    let points = points.iter().map(|&(x, y)| DVec3::new(x, y, 0.0)).collect();
    Line { name: "open".into(), closed: false, points }
}

/// How far a control point is from the guide of three points: the line through the middle one and
/// the foot that the method gives.
fn off_guide(method: Method, [a, p, c]: [DVec3; 3], b: DVec3) -> f64 {
    let (before, after, chord) = (a.distance(p), p.distance(c), c - a);
    let part = match method {
        Method::Median => 0.5,
        Method::Symmedian => before * before / (before * before + after * after),
        Method::Normal => (p - a).dot(chord) / chord.length_squared(),
        _ => before / (before + after),
    };
    let to_foot = a + chord * part - p;
    if to_foot.length() <= 1e-9 * chord.length() { 0.0 } else { (b - p).cross(to_foot.normalize()).length() }
}

#[test]
fn chains_have_their_control_points_on_the_guides() {
    let smooth: Vec<Line> = outlines().into_iter().filter(|line| line.name.starts_with("footlike")).collect();
    for method in METHODS {
        let (mut kept, mut all, mut plain_off) = (0, 0, 0.0f64);
        for line in smooth.iter().filter(|line| line.points.len() < 300).chain(&[blob(24, 0.0), blob(31, 0.7)]) {
            let n = line.points.len();
            let chain = solve(line, &Options { curve: CurveKind::Chain, method, ..Options::default() });
            check(line, &chain, "chain");
            let guided = Options { method, lock: Lock::DataGuide, ..Options::default() };
            assert_eq!(chain, solve(line, &guided), "{} {method:?}", line.name);
            let plain = solve(line, &Options { method, ..Options::default() });
            for i in 0..n {
                let triple = [(i + n - 1) % n, i, (i + 1) % n].map(|k| line.points[k]);
                let off = off_guide(method, triple, chain.curve(0).segment(i)[1]) / size(line);
                all += 1;
                if chain.statuses()[i] == PointStatus::Ok {
                    kept += 1;
                    assert!(off <= 2e-11, "{} {method:?} {i}: {off:e}", line.name);
                    plain_off = plain_off.max(off_guide(method, triple, plain.curve(0).segment(i)[1]) / size(line));
                }
            }
        }
        println!("{method:?}: {kept} of {all} on their guides; by parameters up to {plain_off:.1e} of the size off");
        assert!(10 * kept > 9 * all, "{method:?} {kept} {all}");
    }
}

/// If no normal meets the chord, the bisector replaces it, and the point has a status.
#[test]
fn bisectors_stand_in_for_normals() {
    let line = open(&[(0.0, 0.0), (2.0, 1.0), (4.0, 1.2), (3.6, 1.9), (5.0, 3.0), (7.0, 3.2)]);
    let fit = solve(&line, &Options { curve: CurveKind::Chain, method: Method::Normal, ..Options::default() });
    check(&line, &fit, "normals");
    let mut stood_in = 0;
    for i in 1..5 {
        let triple = [i - 1, i, i + 1].map(|k| line.points[k]);
        let b = fit.curve(0).segment(fit.place(i).segment as usize)[1];
        let method = match fit.statuses()[i] {
            PointStatus::Ok => Method::Normal,
            PointStatus::NormalOutside => Method::Bisector,
            _ => continue,
        };
        stood_in += usize::from(method == Method::Bisector);
        assert!(off_guide(method, triple, b) <= 1e-10, "{i} {:?}", fit.statuses()[i]);
    }
    assert!(stood_in > 0, "{:?}", fit.statuses());
}

#[test]
fn tangents_by_angles_are_tangents() {
    let line = arc(9);
    for curve_kind in [CurveKind::Composite, CurveKind::BlendC1, CurveKind::CubicC2, CurveKind::Single] {
        for angle in [0.3, 2.5, -1.1, 7.0] {
            let direction = DVec3::new(f64::cos(angle), f64::sin(angle), 0.0);
            let by = |kind| {
                solve_with(
                    &line,
                    &Options { curve: curve_kind, ..Options::default() },
                    &[Constraint { point: 0, kind }],
                )
            };
            let (angled, given) = (by(PointConstraint::TangentAngle(angle)), by(PointConstraint::Tangent(direction)));
            let far = angled.points().iter().zip(given.points()).map(|(p, q)| p.distance(*q)).fold(0.0, f64::max);
            assert!(far <= 1e-12, "{curve_kind:?} {angle} {far:e}");
            let first = angled.curve(0).segment(0);
            assert!((first[1] - first[0]).normalize().distance(direction) <= 1e-12, "{curve_kind:?} {angle}");
        }
    }
    let points = [[0.0, 0.0], [1.0, 1.0], [2.0, 0.0]];
    let constraints = [Constraint { point: 1, kind: PointConstraint::TangentAngle(f64::INFINITY) }];
    let outlines =
        Outlines { points: Points::from(&points[..]), offsets: None, closed: false, constraints: &constraints };
    assert!(matches!(
        fit(&outlines, &Options::default(), &Job::default()),
        Err(gusset::Error::NotFinite { element: gusset::Element::Constraint, index: 0, .. })
    ));
}

#[test]
fn ends_are_level_and_upright() {
    // From the lower left up and over to the right: the first chord is steep, the last one flat.
    let line = open(&[(0.0, 0.0), (0.2, 1.0), (1.0, 2.0), (2.5, 2.6), (4.0, 2.7)]);
    let legs = |ends: Ends, curve_kind: CurveKind, line: &Line| {
        let fit = solve(line, &Options { curve: curve_kind, ends, ..Options::default() });
        check(line, &fit, "ends");
        let (first, last) = (fit.curve(0).segment(0), fit.curve(0).segment(fit.curve(0).len() - 1));
        [first[1] - first[0], last[last.len() - 1] - last[last.len() - 2]].map(DVec3::normalize)
    };
    for curve_kind in
        [CurveKind::Composite, CurveKind::BlendC1, CurveKind::BlendC2, CurveKind::CubicC2, CurveKind::Single]
    {
        for (ends, wanted) in [
            (Ends::Level, [DVec3::X, DVec3::X]),
            (Ends::Upright, [DVec3::Y, DVec3::Y]),
            // Perpendicular to a steep chord is level, to a flat one upright.
            (Ends::LevelOrUpright, [DVec3::X, DVec3::Y]),
        ] {
            let found = legs(ends, curve_kind, &line);
            for (found, wanted) in found.iter().zip(wanted) {
                assert!(found.distance(wanted) <= 1e-12, "{curve_kind:?} {ends:?} {found}");
            }
        }
    }
    // In the sense of the legs, downwards and to the left.
    let back = Line { points: line.points.iter().map(|&p| -p).collect(), ..line };
    assert!(legs(Ends::Level, CurveKind::Composite, &back)[0].distance(-DVec3::X) <= 1e-12);
    assert!(legs(Ends::Upright, CurveKind::Composite, &back)[1].distance(-DVec3::Y) <= 1e-12);
}

#[test]
fn histories_have_a_move_for_each_cycle() {
    let line = blob(24, 0.7);
    for (lock, joint, solver) in [
        (Lock::DataGuide, JointParameter::Half, Solver::Fast),
        (Lock::DataGuide, JointParameter::Half, Solver::Step),
        (Lock::SelfConsistent, JointParameter::Half, Solver::Fast),
        (Lock::Parameter, JointParameter::G2, Solver::Fast),
    ] {
        let options = Options { lock, joint, solver, history: true, ..Options::default() };
        let fit = solve(&line, &options);
        let (history, report) = (fit.history(0), fit.reports()[0]);
        assert_eq!(history.len(), report.iterations as usize, "{lock:?} {joint:?}");
        assert!(history.len() > 1 && history[0].moved > 1e-6, "{history:?}");
        assert!(history.iter().all(|cycle| cycle.moved.is_finite()));
        assert!(history[history.len() - 1].moved < 1e-3 * history[0].moved, "{history:?}");
        assert!(history.windows(2).all(|pair| pair[0].steps <= pair[1].steps), "{history:?}");
        assert_eq!(history[history.len() - 1].steps, report.steps);
        assert_eq!(report.steps > 0, solver == Solver::Step);
        // All the same without.
        let without = solve(&line, &Options { history: false, ..options });
        assert_eq!((without.points(), without.history(0)), (fit.points(), &[][..]));
    }
    // Each of many outlines has its own choice, on any number of threads.
    let points: Vec<[f64; 2]> = (0..30u32).flat_map(|_| line.points.iter().map(|p| [p.x, p.y])).collect();
    let offsets: Vec<u32> = (0..=30).map(|k| 24 * k).collect();
    let many = Outlines { points: Points::from(&points[..]), offsets: Some(&offsets), closed: true, constraints: &[] };
    let options = Options { lock: Lock::DataGuide, history: true, ..Options::default() };
    let all = fit(&many, &options, &Job::default()).unwrap();
    let one = solve(&line, &options);
    assert!((0..30).all(|k| all.history(k) == one.history(0)));
}

#[test]
fn sections_by_steps_are_those_by_closed_forms() {
    for line in random(40, 12) {
        let points: Vec<[f64; 3]> = line.points.iter().map(DVec3::to_array).collect();
        let given =
            Outlines { points: Points::from(&points[..]), offsets: None, closed: line.closed, constraints: &[] };
        for method in METHODS {
            let options = Options { method, ..Options::default() };
            let fast = sections(&given, &options, &Job::default()).unwrap();
            let stepped = sections(&given, &Options { solver: Solver::Step, ..options }, &Job::default()).unwrap();
            assert_eq!((fast.steps, &fast.statuses), (0, &stepped.statuses));
            assert!(stepped.steps > 10 * points.len() as u64);
            for i in 0..points.len() {
                let size = size(&line).max(fast.controls[i].distance(line.points[i]));
                assert!(fast.controls[i].distance(stepped.controls[i]) <= 1e-11 * size, "{method:?} {i}");
                assert_eq!(fast.parameters[i], stepped.parameters[i]);
            }
        }
    }
    // Steps that are used up.
    let points = [[0.0, 0.0], [1.0, 1.0], [2.0, 0.0]];
    let given = Outlines { points: Points::from(&points[..]), offsets: None, closed: false, constraints: &[] };
    let few = Options { solver: Solver::Step, max_steps: 3, ..Options::default() };
    let found = sections(&given, &few, &Job::default()).unwrap();
    assert_eq!((found.statuses[1], found.controls[1]), (PointStatus::NotConverged, DVec3::new(1.0, 2.0, 0.0)));
}

/// A blend that turns back has a cusp, and its point says so; others have none.
#[test]
fn blends_tell_their_cusps() {
    let back = open(&[(0.0, 0.0), (1.0, 0.2), (3.0, 0.0), (1.5, 0.0), (0.5, 1.0), (0.0, 2.0)]);
    let there = open(&[(0.0, 0.0), (1.0, 1.0), (2.0, 2.0), (1.0, 1.0), (0.0, 3.0)]);
    for (line, reversals) in
        [(back, vec![]), (there, vec![2]), (open(&[(0.0, 0.0), (3.0, 0.0), (1.0, 0.0), (2.0, 1.0)]), vec![1])]
    {
        for curve_kind in [CurveKind::BlendC1, CurveKind::BlendC2] {
            for method in METHODS {
                let fit = solve(&line, &Options { curve: curve_kind, method, ..Options::default() });
                check_cusps(&line, &fit, &reversals, method);
            }
        }
    }
}

fn check_cusps(line: &Line, fit: &gusset::curve::Fit, reversals: &[usize], method: Method) {
    for i in 1..line.points.len() - 1 {
        let said = fit.statuses()[i] == PointStatus::Cusp;
        assert_eq!(said, reversals.contains(&i), "{method:?} {i} {:?}", fit.statuses());
    }
    assert_eq!(fit.reports()[0].status == FitStatus::Partial, fit.statuses().iter().any(|&s| s != PointStatus::Ok));
    if method != Method::Bisector {
        return;
    }
    // By the bisector, segments lack inner cusps (Yuksel, Schaefer and Keyser, 2011): turns of more
    // than a right angle between samples occur only at the points.
    let mut previous: Option<DVec3> = None;
    for (k, segment) in fit.curve(0).segments().enumerate() {
        let at = |j: u32| crate::outline_data::casteljau(segment, f64::from(j) / 256.0);
        for j in 0..256 {
            let step = at(j + 1) - at(j);
            let turns = previous.is_some_and(|before| before.dot(step) < 0.0);
            assert!(!turns || (j <= 1 && reversals.contains(&k)), "{k} {j}");
            previous = Some(step);
        }
    }
}

/// Iterations never pass the most that are allowed, whatever falls back.
#[test]
fn iterations_stay_within_the_limit() {
    let mut tried = 0;
    for line in adversarial().into_iter().chain(random(10, 23)) {
        for curve_kind in [CurveKind::Composite, CurveKind::Single] {
            for lock in [Lock::Parameter, Lock::SelfConsistent, Lock::DataGuide] {
                for joint in [JointParameter::Half, JointParameter::Knot, JointParameter::G2] {
                    for solver in [Solver::Fast, Solver::Step] {
                        for (method, max_sweeps) in [(Method::Bisector, 1), (Method::Median, 7), (Method::Normal, 40)] {
                            let options = Options {
                                curve: curve_kind,
                                lock,
                                joint,
                                solver,
                                method,
                                max_sweeps,
                                max_steps: 200,
                                corner_angle: 2.0,
                                ..Options::default()
                            };
                            let report = solve(&line, &options).reports()[0];
                            assert!(report.iterations <= max_sweeps, "{} {options:?} {report:?}", line.name);
                            tried += 1;
                        }
                    }
                }
            }
        }
    }
    assert!(tried > 2000);
}

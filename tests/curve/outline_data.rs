//! Outlines for the tests: the data directory, known curves, and hard cases; and checks of every
//! solution.

use glam::DVec3;
use gusset::curve::{Constraint, Fit, FitStatus, Options, Outlines, PointStatus, Points, fit};
use gusset::job::Job;
use std::path::PathBuf;

/// Points, one after another.
#[derive(Clone)]
pub(crate) struct Line {
    pub(crate) name: String,
    pub(crate) closed: bool,
    pub(crate) points: Vec<DVec3>,
}

fn directory() -> Option<PathBuf> {
    crate::common::data::path("outlines")
}

/// The outlines of the data directory; none if it is not there.
pub(crate) fn outlines() -> Vec<Line> {
    let Some(data) = directory() else { return Vec::new() };
    let mut names: Vec<String> =
        std::fs::read_dir(&data).unwrap().map(|e| e.unwrap().file_name().into_string().unwrap()).collect();
    names.retain(|name| name.ends_with(".csv") || name.ends_with(".dat"));
    names.sort();
    let mut lines = Vec::new();
    for name in names {
        let mut path = String::new();
        // Columns: perhaps those that tell contours apart, then x and y.
        for row in std::fs::read_to_string(data.join(&name)).unwrap().lines() {
            let fields: Vec<f64> =
                row.split([',', ' ']).filter(|f| !f.is_empty()).map_while(|f| f.parse().ok()).collect();
            if fields.len() < 2 {
                continue;
            }
            let (key, at) = fields.split_at(fields.len() - 2);
            if path != format!("{name} {key:?}") {
                path = format!("{name} {key:?}");
                lines.push(Line { name: path.clone(), closed: !name.contains("open"), points: Vec::new() });
            }
            let last = lines.len() - 1;
            lines[last].points.push(DVec3::new(at[0], at[1], 0.0));
        }
    }
    assert!(lines.len() > 60, "{} outlines", lines.len());
    lines
}

/// n + 1 points of half of a foot-like outline; none without data.
pub(crate) fn foot_half(k: usize, n: usize) -> Option<Line> {
    let name = format!("footlike_{k:02}_dense.csv");
    let text = std::fs::read_to_string(directory()?.join(&name)).unwrap();
    let all: Vec<DVec3> = text
        .lines()
        .filter_map(|row| {
            row.split_once(',').and_then(|(x, y)| Some(DVec3::new(x.parse().ok()?, y.parse().ok()?, 0.0)))
        })
        .collect();
    let points = (0..=n).map(|i| all[i * (all.len() / 2) / n]).collect();
    Some(Line { name, closed: false, points })
}

fn open(name: &str, n: usize, at: impl Fn(f64) -> (f64, f64)) -> Line {
    let place = |i: usize| at(i as f64 / (n - 1) as f64);
    Line { name: name.into(), closed: false, points: (0..n).map(|i| DVec3::new(place(i).0, place(i).1, 0.0)).collect() }
}

/// `n` points of a half circle.
pub(crate) fn arc(n: usize) -> Line {
    open("arc", n, |x| ((std::f64::consts::PI * x).cos(), (std::f64::consts::PI * x).sin()))
}

/// `n` points of a sine.
pub(crate) fn sine(n: usize) -> Line {
    open("sine", n, |x| (6.0 * x, (6.0 * x).sin()))
}

/// `n` points of a smooth closed curve, spaced unevenly by the degree `uneven`.
pub(crate) fn blob(n: usize, uneven: f64) -> Line {
    let at = |i: usize| {
        let x = std::f64::consts::TAU * i as f64 / n as f64;
        let angle = x + 0.3 * uneven * (3.0 * x).sin() / 3.0;
        let radius = 1.0 + 0.2 * (2.0 * angle + 0.4).cos() + 0.05 * (3.0 * angle).sin();
        DVec3::new(radius * angle.cos(), radius * angle.sin(), 0.0)
    };
    Line { name: format!("blob {n} {uneven}"), closed: true, points: (0..n).map(at).collect() }
}

/// The next of a sequence of numbers that look random, from 0 to 1.
fn next(state: &mut u64) -> f64 {
    *state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    (*state >> 11) as f64 / (1u64 << 53) as f64
}

/// `count` lines of `n` random points in a plane, every other one closed.
pub(crate) fn random(count: usize, n: usize) -> Vec<Line> {
    let mut state = 20_080_101 + n as u64;
    let mut line = |k: usize| Line {
        name: format!("random {k}"),
        closed: k.is_multiple_of(2),
        points: (0..n).map(|_| DVec3::new(next(&mut state), next(&mut state), 0.0)).collect(),
    };
    (0..count).map(&mut line).collect()
}

/// Hard cases, open and closed.
pub(crate) fn adversarial() -> Vec<Line> {
    let plane = |points: &[(f64, f64)]| points.iter().map(|&(x, y)| DVec3::new(x, y, 0.0)).collect::<Vec<_>>();
    let many = |n: i32, at: &dyn Fn(f64) -> (f64, f64)| plane(&(0..n).map(|i| at(f64::from(i))).collect::<Vec<_>>());
    let mut state = 7;
    let cases = [
        ("two", plane(&[(0.0, 0.0), (1.0, 1.0)])),
        ("three", plane(&[(0.0, 0.0), (1.0, 1.0), (2.0, 0.0)])),
        ("there and back", plane(&[(0.0, 0.0), (1.0, 0.0), (0.0, 0.0), (1.0, 0.0)])),
        (
            "repeats",
            plane(&[(0.0, 0.0), (0.0, 0.0), (1.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0), (0.0, 1.0), (0.0, 0.0)]),
        ),
        ("straight", many(9, &|x| (x, 2.0 * x))),
        ("straight, uneven", many(9, &|x| (x * x * x, 0.0))),
        ("straight, folded", many(9, &|x| ((x * 2.4).sin(), 0.0))),
        ("zigzag", many(12, &|x| (x, (x % 2.0) * 3.0))),
        ("steep zigzag", many(12, &|x| (x * 1e-3, x % 2.0))),
        (
            "spike",
            plane(&[
                (0.0, 0.0),
                (1.0, 0.0),
                (2.0, 0.0),
                (2.0, 50.0),
                (2.0, 1e-9),
                (3.0, 0.0),
                (4.0, 0.0),
                (4.0, -2.0),
                (0.0, -2.0),
            ]),
        ),
        ("spacing", many(14, &|x| (if x % 2.0 == 0.0 { x } else { x - 1.0 + 1e-6 }, (x * 0.7).sin()))),
        ("geometric", many(20, &|x| (2f64.powf(-x), 3f64.powf(-x)))),
        ("square", plane(&[(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)])),
        (
            "star",
            many(10, &|x| {
                let r = 0.2 + x % 2.0;
                (r * (x * 0.628).cos(), r * (x * 0.628).sin())
            }),
        ),
        ("large", many(8, &|x| (1e300 * (x * 0.8).cos(), 1e300 * (x * 0.8).sin()))),
        ("small", many(8, &|x| (1e-300 * (x * 0.8).cos(), 1e-300 * (x * 0.8).sin()))),
        ("far away", many(8, &|x| (1e9 + (x * 0.8).cos(), 1e9 + (x * 0.8).sin()))),
        ("one ordinate differs", many(11, &|x| (x, if x == 5.0 { 1e-13 } else { 0.0 }))),
    ];
    let mut lines = Vec::new();
    for (name, points) in cases {
        for closed in [false, true] {
            lines.push(Line { name: format!("{name} {closed}"), closed, points: points.clone() });
        }
    }
    let space = (0..15).map(|_| DVec3::new(next(&mut state), next(&mut state), next(&mut state))).collect();
    lines.push(Line { name: "space".into(), closed: true, points: space });
    lines
}

pub(crate) fn solve(line: &Line, options: &Options) -> Fit {
    solve_with(line, options, &[])
}

pub(crate) fn solve_with(line: &Line, options: &Options, constraints: &[Constraint]) -> Fit {
    let points: Vec<[f64; 3]> = line.points.iter().map(DVec3::to_array).collect();
    let outlines = Outlines { points: Points::from(&points[..]), offsets: None, closed: line.closed, constraints };
    fit(&outlines, options, &Job::default()).unwrap()
}

pub(crate) fn casteljau(controls: &[DVec3], t: f64) -> DVec3 {
    let mut points = controls.to_vec();
    while points.len() > 1 {
        points = points.windows(2).map(|pair| pair[0] * (1.0 - t) + pair[1] * t).collect();
    }
    points[0]
}

pub(crate) fn size(line: &Line) -> f64 {
    let (mut low, mut high) = (line.points[0], line.points[0]);
    line.points.iter().for_each(|&p| (low, high) = (low.min(p), high.max(p)));
    (high - low).max_element()
}

/// All coordinates are finite, every point that is not said to be missed lies on the curve, and the
/// joints are smooth.
pub(crate) fn check(line: &Line, fit: &Fit, what: &str) {
    let curve = fit.curve(0);
    assert!(curve.points().iter().all(|p| p.is_finite()), "{what} {}: not finite", line.name);
    let report = fit.reports()[0];
    assert!(report.max_residual.is_finite() && report.last_move.is_finite(), "{what} {}: {report:?}", line.name);
    if curve.is_empty() || report.status == FitStatus::TooFewPoints {
        return;
    }
    let (size, reach) = (size(line), line.points.iter().map(|p| p.abs().max_element()).fold(0.0, f64::max));
    for (i, p) in line.points.iter().enumerate() {
        let place = fit.place(i);
        assert!((0.0..=1.0).contains(&place.t), "{what} {}: {place:?}", line.name);
        let (status, controls) = (fit.statuses()[i], curve.segment(place.segment as usize));
        if matches!(status, PointStatus::NotConverged | PointStatus::Missed) {
            continue;
        }
        let far = casteljau(controls, place.t).distance(*p);
        // Rounding: of the solution, of control points far out, and of coordinates far from the
        // origin.
        let out = controls.iter().map(|b| b.distance(*p)).fold(0.0, f64::max);
        let bound = 4e-15 * size.max(out)
            + 2.0 * controls.len() as f64 * f64::EPSILON * reach
            + 1.1e-12 * size * f64::from(status == PointStatus::Merged);
        assert!(
            far <= bound,
            "{what} {}: point {i} is {far:e} from the curve of size {size:e} ({status:?})",
            line.name
        );
    }
    assert!(report.max_joint_sine < 1e-6, "{what} {}: joint {report:?}", line.name);
}

//! Sweeps over the points of a composite curve: each control point in turn is placed for the others as they are, again and
//! again.
//!
//! This is how the paper goes about it, and how the lock by the data's guides is solved at all. With the neighbours fixed,
//!
//! P_i - Q_i(t_i) = r - (2 t s + s^2 beta_(i-1) + t^2 (1 - beta_i)) (B_i - B_i'),    s = 1 - t,
//!
//! for the deviation r at B_i': either B_i goes there at once, or it steps ([`Solver::Step`]) along the deviation, and for
//! the lock by guides along the guide. Parameters: those of the data; or those of the method on the section's triangle as it
//! is before B_i moves; or the crossing of section and guide. For the crossing let f be affine and 0 on the guide: it is 0
//! at B_i, and B_i has its shares of the joints, but
//!
//! (1 - t)^2 (1 - beta_(i-1)) f(B_(i-1)) + t^2 beta_i f(B_(i+1)) = 0
//!
//! does not contain it, so that t does not depend on where on the guide B_i is. If both neighbours are on one side there is
//! no crossing.

use super::composite;
use super::consistent;
use super::method::Method;
use super::request::{FitStatus, Lock, Options, PointStatus, Report, Solver};
use super::run::{Iteration, Run, Solution, Solved, Workspace, mark};
use super::stepping;
use crate::alloc;
use crate::error::Result;
use glam::DVec3;

/// Crossings nearer than this to an end of the section are none: the equations would be too nearly singular.
const MARGIN: f64 = 0.01;

/// After so many sweeps a point that has lost its guide does not look for it any more.
const PATIENCE: u32 = 24;

/// The sine of the angle by which an outline may leave its plane.
const PLANE: f64 = 1e-9;

/// Rounds in which points that do not come to rest are let fall back, before all are.
const ROUNDS: u32 = 3;

/// Solves by sweeps, from control points that solve the linear equations. False if these have become singular, which takes
/// shares other than 1/2.
pub(super) fn solve(
    run: &Run<'_>,
    options: &Options,
    solved: &mut [Solved],
    workspace: &mut Workspace,
    report: &mut Report,
) -> Result<bool> {
    let Workspace { solution, iteration, .. } = workspace;
    iteration.begin(run, solution)?;
    if run.sections().is_empty() {
        return Ok(true);
    }
    if options.lock == Lock::DataGuide {
        guides(run, options, solved, iteration)?;
        for i in run.sections() {
            if !iteration.held[i] {
                // The nearest place on the guide.
                let (p, guide) = (run.points[i], iteration.guides[i]);
                solution.controls[i] = p + guide * guide.dot(solution.controls[i] - p);
            }
        }
    } else if options.solver == Solver::Step {
        // The paper begins at the points.
        for i in run.sections() {
            solution.controls[i] = run.points[i];
        }
    }
    let mut sound = true;
    for round in 0..=ROUNDS {
        let rests = rest(run, options, solution, iteration, report);
        for i in run.sections() {
            let moves = solution.controls[i].distance(iteration.before[i]) > options.tolerance * run.size;
            let fails = !rests && (moves || round + 1 >= ROUNDS) && options.lock != Lock::Parameter;
            if fails && !iteration.held[i] {
                iteration.held[i] = true;
                mark(&mut solved[i], PointStatus::FellBack);
                report.status = FitStatus::NotConverged;
            }
            if iteration.held[i] {
                solution.t[i] = solution.given[i];
            }
        }
        if rests || options.lock == Lock::Parameter {
            break;
        }
    }
    // With the parameters as they are, the points are passed exactly.
    sound &= composite::solve(run, solution);
    let (low, high) = (options.parameter_limit, 1.0 - options.parameter_limit);
    for i in run.sections() {
        match options.lock {
            _ if iteration.held[i] || iteration.lost[i] => mark(&mut solved[i], PointStatus::NoCrossing),
            Lock::SelfConsistent if !(low < solution.t[i] && solution.t[i] < high) => {
                mark(&mut solved[i], PointStatus::ClampedParameter);
            }
            _ => {}
        }
    }
    Ok(sound)
}

/// Sweeps until nothing moves, nor would on and on: moves that shrink by a ratio r sum up to r / (1 - r) of the last one. The control
/// points before the last sweep remain known.
fn rest(
    run: &Run<'_>,
    options: &Options,
    solution: &mut Solution,
    iteration: &mut Iteration,
    report: &mut Report,
) -> bool {
    let tolerance = options.tolerance.max(f64::EPSILON) * run.size;
    let rounding = 16.0 * f64::EPSILON * run.size;
    let mut last = f64::INFINITY;
    for sweep in 0..options.max_sweeps {
        report.iterations += 1;
        iteration.before.clear();
        iteration.before.extend_from_slice(&solution.controls[..run.points.len()]);
        let (mut farthest, mut arrives) = (0.0f64, true);
        for i in run.sections() {
            let before = solution.controls[i];
            arrives &= place(run, options, solution, iteration, sweep, i, report);
            farthest = farthest.max(solution.controls[i].distance_squared(before));
        }
        let farthest = farthest.sqrt();
        report.last_move = farthest / run.size;
        let ratio = farthest / last;
        last = farthest;
        if arrives && farthest <= tolerance && (farthest <= rounding || farthest * ratio <= tolerance * (1.0 - ratio)) {
            return true;
        }
    }
    false
}

/// Places one control point. False if the steps are used up.
fn place(
    run: &Run<'_>,
    options: &Options,
    solution: &mut Solution,
    iteration: &mut Iteration,
    sweep: u32,
    i: usize,
    report: &mut Report,
) -> bool {
    let [b, u, v] = consistent::legs(run, solution, &iteration.shares, i);
    let p = run.points[i];
    let mut guide = None;
    let t = match options.lock {
        _ if iteration.held[i] => solution.given[i],
        Lock::Parameter => solution.given[i],
        Lock::SelfConsistent => consistent::parameter(options, u, v).0,
        Lock::DataGuide => match crossing(run, solution, iteration, i) {
            Some(t) => {
                guide = Some(iteration.guides[i]);
                iteration.lost[i] = false;
                t
            }
            None => {
                iteration.lost[i] = true;
                iteration.held[i] = sweep >= PATIENCE;
                solution.given[i]
            }
        },
    };
    solution.t[i] = t;
    let s = 1.0 - t;
    let before = iteration.shares[if i == 0 { run.points.len() - 1 } else { i - 1 }];
    let [_, slope, _] = composite::row(t, before, iteration.shares[i]);
    // A point that has come back to its guide is put on it first.
    let start = guide.map_or(b, |guide| guide * guide.dot(b));
    let left = -(u * (s * s) + b * (2.0 * t * s) + v * (t * t)) + (b - start) * slope;
    let target = start + left / slope;
    let placed = match options.solver {
        Solver::Fast => guide.map_or(target, |guide| guide * guide.dot(target)),
        Solver::Step => {
            let direction = guide.unwrap_or_else(|| left.normalize_or_zero());
            let size = run.size;
            let deviation = |x: f64| direction.dot(left) - slope * x;
            match stepping::step(options, size, deviation, &mut report.steps) {
                Some(along) => start + direction * along,
                None => return false,
            }
        }
    };
    if placed.is_finite() {
        solution.controls[i] = p + placed;
    }
    placed.is_finite()
}

/// Where the section crosses the guide of its point; `None` if it does not.
fn crossing(run: &Run<'_>, solution: &Solution, iteration: &Iteration, i: usize) -> Option<f64> {
    let guide = iteration.guides[i];
    let n = run.points.len();
    let (before, after) = (if i == 0 { n - 1 } else { i - 1 }, if i + 1 == n { 0 } else { i + 1 });
    let p = run.points[i];
    let (a, c) = (solution.controls[before] - p, solution.controls[after] - p);
    // What is across the guide; in a plane both are along one line.
    let (a, c) = (a - guide * a.dot(guide), c - guide * c.dot(guide));
    if a.dot(c) >= 0.0 {
        return None;
    }
    let first = ((1.0 - iteration.shares[before]) * a.length()).sqrt();
    let last = (iteration.shares[i] * c.length()).sqrt();
    let t = first / (first + last);
    (MARGIN..=1.0 - MARGIN).contains(&t).then_some(t)
}

/// Finds the guides of the data's own triangles. Points without one, and all points of a run that is not plane, fall back.
fn guides(run: &Run<'_>, options: &Options, solved: &mut [Solved], iteration: &mut Iteration) -> Result<()> {
    let n = run.points.len();
    iteration.guides.clear();
    alloc::reserve(&mut iteration.guides, n)?;
    iteration.guides.resize(n, DVec3::ZERO);
    let normal = plane(run);
    for i in run.sections() {
        let guide = match normal {
            Some(normal) => {
                let [a, p, c] = run.triple(i);
                guide(options.method, a - p, c - p, normal)
            }
            None => Err(PointStatus::OutOfPlane),
        };
        match guide {
            Ok(guide) => iteration.guides[i] = guide,
            Err(status) => {
                iteration.held[i] = true;
                mark(&mut solved[i], status);
            }
        }
    }
    Ok(())
}

/// The normal of the plane of a run, of length 1; `None` if there is none.
pub(super) fn plane(run: &Run<'_>) -> Option<DVec3> {
    if run.points.iter().all(|p| p.z == 0.0) {
        return Some(DVec3::Z);
    }
    let origin = run.points[0];
    let farthest = |measure: &dyn Fn(DVec3) -> f64| {
        let mut best = (0.0, DVec3::ZERO);
        for v in run.points.iter().map(|&p| p - origin) {
            let length = measure(v);
            if length > best.0 {
                best = (length, v);
            }
        }
        best.1
    };
    let axis = farthest(&|v| v.length_squared()).normalize_or_zero();
    let aside = farthest(&|v| v.cross(axis).length_squared());
    let normal = axis.cross(aside);
    // A straight run is in any plane that contains it.
    let normal = match normal.length() > PLANE * run.size {
        true => normal.normalize(),
        false => axis.any_orthonormal_vector(),
    };
    run.points.iter().all(|&p| normal.dot(p - origin).abs() <= PLANE * run.size).then_some(normal)
}

/// The direction of the guide of a triangle in a plane, with the corners `u` and `w` before and after the point: from the
/// foot to the point.
///
/// The bisector is also across the difference of the directions of the legs, which is better known if the triangle is flat.
pub(super) fn guide(method: Method, u: DVec3, w: DVec3, normal: DVec3) -> std::result::Result<DVec3, PointStatus> {
    let chord = w - u;
    let t = method.parameter(u, DVec3::ZERO, w)?;
    let (first, last) = (u.normalize_or_zero(), w.normalize_or_zero());
    let (along, sum) = (last - first, first + last);
    let direction = match method.alpha() {
        Some(0.5) if along.length_squared() >= sum.length_squared() => normal.cross(along),
        Some(0.5) => -sum,
        None => normal.cross(chord),
        Some(_) => {
            let (before, after) = ((1.0 - t) * (1.0 - t), t * t);
            let from_foot = -(u * before + w * after) / (before + after);
            if from_foot.length() <= 1e-12 * chord.length() { normal.cross(chord) } else { from_foot }
        }
    };
    direction.try_normalize().ok_or(PointStatus::Collinear)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn planes() {
        let run = |points: &[DVec3]| plane(&Run { points, closed: false, tangents: [None, None], size: 4.0 });
        assert_eq!(run(&[DVec3::ZERO, DVec3::X, DVec3::Y]), Some(DVec3::Z));
        let tilted = [DVec3::ZERO, DVec3::new(1.0, 0.0, 1.0), DVec3::Y, DVec3::new(-2.0, 1.0, -2.0)];
        let normal = run(&tilted).unwrap();
        assert!(normal.cross(DVec3::new(1.0, 0.0, -1.0)).length() < 1e-15, "{normal}");
        // A straight run lies in a plane; four corners of a box do not.
        let straight = run(&[DVec3::ZERO, DVec3::ONE, DVec3::ONE * 3.0]).unwrap();
        assert!(straight.dot(DVec3::ONE).abs() < 1e-15);
        assert_eq!(run(&[DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z]), None);
    }

    #[test]
    fn guides_of_triangles() {
        let (u, w) = (DVec3::new(-3.0, -4.0, 0.0), DVec3::new(7.0, -4.0, 0.0));
        // The errata's triangle: the foot of the bisector of (0, 0), (3, 4), (10, 0) is at 3.83, not at 6.20 as printed.
        let bisector = guide(Method::Bisector, u, w, DVec3::Z).unwrap();
        let foot = 3.0 - 4.0 * bisector.x / bisector.y;
        assert!((foot - 10.0 * 5.0 / (5.0 + 65f64.sqrt())).abs() < 1e-14, "{foot}");
        let normal = guide(Method::Normal, u, w, DVec3::Z).unwrap();
        assert!(normal.x.abs() < 1e-15);
        let median = guide(Method::Median, u, w, DVec3::Z).unwrap();
        assert!((3.0 - 4.0 * median.x / median.y - 5.0).abs() < 1e-14);
        // Flat: across the chord; there and back: along it.
        assert!(guide(Method::Bisector, -DVec3::X, DVec3::X, DVec3::Z).unwrap().x.abs() < 1e-15);
        assert!(guide(Method::Bisector, DVec3::X, DVec3::X, DVec3::Z).unwrap().y.abs() < 1e-15);
    }
}

//! Composite curves: a quadratic section round each point, joined smoothly.
//!
//! Section i is (J_(i-1), B_i, J_i) with the joints J_i = (1 - beta_i) B_i + beta_i B_(i+1) on the control polygon, and passes
//! its point at t_i:
//!
//! (1 - t)^2 J_(i-1) + 2 t (1 - t) B_i + t^2 J_i = P_i,
//!
//! a tridiagonal system for the B_i. With beta = 1/2 its rows are dominant by 2 t (1 - t) at least, so it has one
//! solution for any points at all, in any dimension, and the norm of its inverse is at most 1 / min 2 t (1 - t): 3.6 for
//! parameters between 1/6 and 5/6.
//!
//! The first section of an open run begins at the first point. Where a tangent is given there, a control point T on it comes
//! before B_1, and a segment (P_0, T, J_0) before the first section; the equations stay the same. So at the end.

use super::curve::Place;
use super::method::{Method, power};
use super::request::{Joint, Lock, Options, PointStatus, Report, Solver};
use super::run::{Room, Run, Sketch, Solution, Solved, mark};
use super::{consistent, curvature, joints, sweeps};
use crate::error::Result;
use glam::DVec3;

/// What a control point of the other end of a closed run still contributes is left out below this.
const FAINT: f64 = 1e-40;

/// Appends the composite curve of a run.
pub(super) fn curve(
    run: &Run<'_>,
    options: &Options,
    solved: &mut [Solved],
    room: &mut Room,
    sketch: &mut Sketch,
    report: &mut Report,
) -> Result<()> {
    let (n, solution) = (run.points.len(), &mut room.solution);
    solution.resize(n)?;
    solution.beta.clear();
    parameters(run, options, solution, solved);
    solve(run, solution);
    if (options.lock, options.joint, options.solver) != (Lock::Parameter, Joint::Half, Solver::Fast) {
        room.solution.given[..n].copy_from_slice(&room.solution.t[..n]);
        match options.joint {
            Joint::Half => lock(run, options, solved, room, report).map(|_| ())?,
            Joint::Knot => joints::knots(run, options, solved, room, report)?,
            Joint::G2 => curvature::curvatures(run, options, solved, room, report)?,
        }
    }
    append(run, &room.solution, solved, sketch)
}

/// Finds parameters and control points for the shares of the joints, from control points that solve the linear equations.
/// False if these are singular.
pub(super) fn lock(
    run: &Run<'_>,
    options: &Options,
    solved: &mut [Solved],
    room: &mut Room,
    report: &mut Report,
) -> Result<bool> {
    match (options.lock, options.solver) {
        (Lock::Parameter, Solver::Fast) => Ok(solve(run, &mut room.solution)),
        (Lock::SelfConsistent, Solver::Fast) => consistent::solve(run, options, solved, room, report),
        _ => sweeps::solve(run, options, solved, room, report),
    }
}

/// The parameters of the points by the method on the data's own triangles, within the limits.
fn parameters(run: &Run<'_>, options: &Options, solution: &mut Solution, solved: &mut [Solved]) {
    let (low, high) = (options.parameter_limit, 1.0 - options.parameter_limit);
    let mut enter = |i: usize, t: f64, solved: &mut [Solved]| {
        solution.t[i] = t.clamp(low, high);
        if options.lock == Lock::Parameter && !(low..=high).contains(&t) {
            mark(&mut solved[i], PointStatus::ClampedParameter);
        }
    };
    let sections = run.sections();
    let Some(alpha) = options.method.alpha() else {
        for i in sections {
            let [a, p, c] = run.triple(i);
            let t = options.method.parameter(a, p, c).or_else(|status| {
                if options.lock == Lock::Parameter {
                    mark(&mut solved[i], status);
                }
                Method::Bisector.parameter(a, p, c)
            });
            enter(i, t.unwrap_or(0.5), solved);
        }
        return;
    };
    // Each chord is the first of one section and the last of the one before.
    let chord = |p: DVec3, q: DVec3| power(p.distance(q), alpha);
    let points = run.points;
    let mut before =
        chord(points[if run.closed { points.len() - 1 } else { 0 }], points[sections.start.min(points.len() - 1)]);
    for i in sections {
        let after = chord(points[i], points[if i + 1 == points.len() { 0 } else { i + 1 }]);
        enter(i, before / (before + after), solved);
        before = after;
    }
}

/// Appends the segments, and says where the points lie on them.
fn append(run: &Run<'_>, solution: &Solution, solved: &mut [Solved], sketch: &mut Sketch) -> Result<()> {
    let n = run.points.len();
    let first = sketch.len() as u32;
    if run.closed {
        let start = solution.joint(run, n - 1);
        sketch.begin(start)?;
        for (i, solved) in solved.iter_mut().enumerate().take(n) {
            let joint = if i + 1 == n { start } else { solution.joint(run, i) };
            sketch.push(&[solution.controls[i], joint])?;
            solved.place = Place { segment: first + i as u32, t: solution.t[i] };
        }
        return Ok(());
    }
    let last = n - 1;
    let ends = run.end_controls();
    sketch.begin(run.points[0])?;
    solved[0].place = Place { segment: first, t: 0.0 };
    match (last, ends) {
        (1, [None, None]) => sketch.push(&[run.points[1]])?,
        (1, [Some(control), None] | [None, Some(control)]) => sketch.push(&[control, run.points[1]])?,
        _ => {
            if let Some(control) = ends[0] {
                sketch.push(&[control, solution.joint(run, 0)])?;
            }
            for i in run.sections() {
                solved[i].place = Place { segment: sketch.len() as u32, t: solution.t[i] };
                sketch.push(&[solution.controls[i], solution.joint(run, i)])?;
            }
            if let Some(control) = ends[1] {
                sketch.push(&[control, run.points[last]])?;
            }
        }
    }
    solved[last].place = Place { segment: sketch.len() as u32 - 1, t: 1.0 };
    Ok(())
}

/// Solves for the control points, given the parameters and the shares beta of the joints (`None`: all 1/2). False if the
/// equations are singular, which takes shares other than 1/2.
pub(super) fn solve(run: &Run<'_>, solution: &mut Solution) -> bool {
    if run.closed { solve_closed(run, solution) } else { solve_open(run, solution) }
}

/// The coefficients of B_(i-1), B_i and B_(i+1) in row i.
#[inline]
pub(super) fn row(t: f64, before: f64, after: f64) -> [f64; 3] {
    let s = 1.0 - t;
    let (first, last) = (s * s, t * t);
    [first * (1.0 - before), 2.0 * t * s + first * before + last * (1.0 - after), last * after]
}

/// Places the control points on the end tangents, then eliminates downwards and substitutes upwards.
fn solve_open(run: &Run<'_>, solution: &mut Solution) -> bool {
    let last = run.points.len() - 1;
    let Solution { t, beta, controls, upper, .. } = solution;
    let [start, end] = run.end_controls();
    let halves = beta.is_empty();
    let share = |i: usize| match (i, start, end) {
        // The section itself begins or ends there.
        (0, None, _) => 0.0,
        (i, _, None) if i + 1 == last => 1.0,
        (i, ..) if halves || i == 0 || i + 1 == last => 0.5,
        (i, ..) => beta[i],
    };
    controls[0] = start.unwrap_or(run.points[0]);
    controls[last] = end.unwrap_or(run.points[last]);
    let mut sound = true;
    for i in 1..last {
        let [lower, mut diagonal, above] = row(t[i], share(i - 1), share(i));
        let mut right = run.points[i] - controls[i - 1] * lower;
        if i > 1 {
            diagonal -= lower * upper[i - 1];
        }
        if i + 1 == last {
            right -= controls[last] * above;
        }
        sound &= diagonal.abs() > 1e-14;
        let scale = 1.0 / diagonal;
        upper[i] = above * scale;
        controls[i] = right * scale;
    }
    for i in (1..last.saturating_sub(1)).rev() {
        controls[i] = controls[i] - controls[i + 1] * upper[i];
    }
    sound
}

/// As for an open run, with the last control point carried along: by `across` in the rows from the first one on, and by
/// `far` in the last row, until both have faded away.
fn solve_closed(run: &Run<'_>, solution: &mut Solution) -> bool {
    let n = run.points.len();
    let Solution { t, beta, controls, upper, across, .. } = solution;
    let share = |i: usize| if beta.is_empty() { 0.5 } else { beta[i] };
    let points = run.points;
    let (t, controls, upper) = (&t[..n], &mut controls[..n], &mut upper[..n]);

    let [mut far_lower, mut far_diagonal, mut far] = row(t[n - 1], share(n - 2), share(n - 1));
    let mut far_right = points[n - 1];
    let [lower, diagonal, above] = row(t[0], share(n - 1), share(0));
    let mut sound = diagonal.abs() > 1e-14;
    let scale = 1.0 / diagonal;
    upper[0] = above * scale;
    across[0] = lower * scale;
    controls[0] = points[0] * scale;
    let mut i = 1;
    while i < n - 1 && (across[i - 1].abs() > FAINT || far.abs() > FAINT) {
        far_diagonal -= far * across[i - 1];
        far_right -= controls[i - 1] * far;
        far *= -upper[i - 1];
        let [lower, diagonal, above] = row(t[i], share(i - 1), share(i));
        let diagonal = diagonal - lower * upper[i - 1];
        sound &= diagonal.abs() > 1e-14;
        let scale = 1.0 / diagonal;
        across[i] = -lower * across[i - 1] * scale;
        upper[i] = above * scale;
        controls[i] = (points[i] - controls[i - 1] * lower) * scale;
        i += 1;
    }
    let carried = i;
    let (mut known, mut ratio) = (controls[i - 1], upper[i - 1]);
    for i in carried..n - 1 {
        let [lower, diagonal, above] = row(t[i], share(i - 1), share(i));
        let diagonal = diagonal - lower * ratio;
        sound &= diagonal.abs() > 1e-14;
        let scale = 1.0 / diagonal;
        ratio = above * scale;
        known = (points[i] - known * lower) * scale;
        upper[i] = ratio;
        controls[i] = known;
    }
    // The last row has B_(n-2), and B_0 through what was carried; if nothing has faded, both are in the same place.
    far_lower += if carried == n - 1 { far } else { 0.0 };
    let behind = if carried == n - 1 { across[n - 2] } else { 0.0 };
    far_diagonal -= far_lower * (upper[n - 2] + behind);
    sound &= far_diagonal.abs() > 1e-14;
    let last = (far_right - controls[n - 2] * far_lower) / far_diagonal;
    controls[n - 1] = last;
    let mut next = last;
    for i in (carried..n - 1).rev() {
        next = controls[i] - next * upper[i];
        controls[i] = next;
    }
    for i in (0..carried).rev() {
        next = controls[i] - next * upper[i] - last * across[i];
        controls[i] = next;
    }
    sound
}

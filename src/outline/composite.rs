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
use super::judge::Smoothness;
use super::method::{Method, power};
use super::request::{Joint, Lock, Options, PointStatus, Report, Solver};
use super::run::{Run, Sketch, Solution, Solved, Workspace, mark};
use super::{consistent, curvature, joints, segment, sweeps};
use crate::error::Result;
use crate::geom::linear::tridiagonal::{self, Cyclic};
use glam::DVec3;

/// Appends the composite curve of a run.
pub(super) fn curve(
    run: &Run<'_>,
    options: &Options,
    solved: &mut [Solved],
    workspace: &mut Workspace,
    sketch: &mut Sketch,
    report: &mut Report,
) -> Result<()> {
    identify(run, options, solved, workspace, report)?;
    if !run.closed {
        return append(run, &workspace.solution, solved, sketch);
    }
    let places = (0..).zip(&workspace.solution.t).map(|(segment, &t)| Place { segment, t });
    solved.iter_mut().zip(places).for_each(|(solved, place)| solved.place = place);
    trace(run, &workspace.solution, |p| p, sketch.closed_quadratics(run.points.len())?, report);
    Ok(())
}

/// Finds the control points of a run.
pub(super) fn identify(
    run: &Run<'_>,
    options: &Options,
    solved: &mut [Solved],
    workspace: &mut Workspace,
    report: &mut Report,
) -> Result<()> {
    let (n, solution) = (run.points.len(), &mut workspace.solution);
    solution.resize(n)?;
    solution.beta.clear();
    parameters(run, options, solution, solved);
    solve(run, solution);
    if (options.lock, options.joint, options.solver) != (Lock::Parameter, Joint::Half, Solver::Fast) {
        workspace.solution.given[..n].copy_from_slice(&workspace.solution.t[..n]);
        match options.joint {
            Joint::Half => lock(run, options, solved, workspace, report).map(|_| ())?,
            Joint::Knot => joints::knots(run, options, solved, workspace, report)?,
            Joint::G2 => curvature::curvatures(run, options, solved, workspace, report)?,
        }
    }
    Ok(())
}

/// Finds parameters and control points for the shares of the joints, from control points that solve the linear equations.
/// False if these are singular.
pub(super) fn lock(
    run: &Run<'_>,
    options: &Options,
    solved: &mut [Solved],
    workspace: &mut Workspace,
    report: &mut Report,
) -> Result<bool> {
    match (options.lock, options.solver) {
        (Lock::Parameter, Solver::Fast) => Ok(solve(run, &mut workspace.solution)),
        (Lock::SelfConsistent, Solver::Fast) => consistent::solve(run, options, solved, workspace, report),
        _ => sweeps::solve(run, options, solved, workspace, report),
    }
}

/// The parameters of the points by the method on the data's own triangles, within the limits.
fn parameters(run: &Run<'_>, options: &Options, solution: &mut Solution, solved: &mut [Solved]) {
    let (low, high) = (options.parameter_limit, 1.0 - options.parameter_limit);
    let enter = |i: usize, t: f64, parameter: &mut f64, solved: &mut [Solved]| {
        *parameter = t.clamp(low, high);
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
            enter(i, t.unwrap_or(0.5), &mut solution.t[i], solved);
        }
        return;
    };
    if alpha == 0.0 {
        solution.t[sections].fill(0.5);
        return;
    }
    // Each chord is the first of one section and the last of the one before: chord i ends at point i.
    let chords = &mut solution.upper[..run.points.len()];
    let points = run.points;
    chords[0] = points[points.len() - 1].distance(points[0]);
    for (chord, pair) in chords[1..].iter_mut().zip(points.windows(2)) {
        *chord = pair[1].distance(pair[0]);
    }
    match alpha {
        0.5 => chords.iter_mut().for_each(|chord| *chord = chord.sqrt()),
        1.0 => {}
        _ => chords.iter_mut().for_each(|chord| *chord = power(*chord, alpha)),
    }
    let chords = &*chords;
    let mut all = true;
    let (first, last) = (sections.start, sections.end);
    for i in first..last {
        let (before, after) = (chords[i], chords[if i + 1 == chords.len() { 0 } else { i + 1 }]);
        let t = before / (before + after);
        all &= (low..=high).contains(&t);
        solution.t[i] = t;
    }
    if !all {
        for i in first..last {
            enter(i, solution.t[i], &mut solution.t[i], solved);
        }
    }
}

/// Appends the segments of an open run, and says where the points lie on them.
fn append(run: &Run<'_>, solution: &Solution, solved: &mut [Solved], sketch: &mut Sketch) -> Result<()> {
    let n = run.points.len();
    let first = sketch.len() as u32;
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

/// Writes the control points of a closed run, each p as `place(p)`, as many as two for each point and one more; section i is
/// segment i. Measures the curve on the way: see [`judge`](super::judge).
pub(super) fn trace(
    run: &Run<'_>,
    solution: &Solution,
    place: impl Fn(DVec3) -> DVec3,
    out: &mut [DVec3],
    report: &mut Report,
) {
    let n = run.points.len();
    let start = solution.joint(run, n - 1);
    let (first, rest) = out.split_at_mut(1);
    first[0] = place(start);
    let controls = &solution.controls[..n];
    let following = controls[1..].iter().chain(&controls[..1]);
    let known = run.points.iter().zip(controls).zip(following).zip(&solution.t);
    let (mut joint, mut smoothness, mut farthest) = (start, Smoothness::default(), 0.0f64);
    for (i, (segment, (((&p, &control), &next), &t))) in rest.as_chunks_mut::<2>().0.iter_mut().zip(known).enumerate() {
        let beta = if solution.beta.is_empty() { 0.5 } else { solution.beta[i] };
        let end = if i + 1 == n { start } else { control + (next - control) * beta };
        *segment = [place(control), place(end)];
        farthest = farthest.max(segment::point(&[joint, control, end], t).distance_squared(p));
        smoothness.joint(end - control, next - end);
        joint = end;
    }
    report.max_residual = farthest.sqrt() / run.size;
    report.max_joint_sine = smoothness.sine();
}

/// Solves for the control points, given the parameters and the shares beta of the joints. False if the equations are singular,
/// which takes shares other than 1/2.
pub(super) fn solve(run: &Run<'_>, solution: &mut Solution) -> bool {
    let Solution { t, beta, controls, upper, across, .. } = solution;
    let n = run.points.len();
    let (t, controls) = (&t[..n], &mut controls[..n]);
    let known = |i: usize| run.points[i];
    if run.closed {
        let system = Cyclic { unknowns: controls, upper, across };
        return if beta.is_empty() {
            system.solve(|i, _| row(t[i], 0.5, 0.5), known)
        } else {
            system.solve(|i, before| row(t[i], beta[before], beta[i]), known)
        };
    }
    let last = n - 1;
    let [start, end] = run.end_controls();
    controls[0] = start.unwrap_or(run.points[0]);
    controls[last] = end.unwrap_or(run.points[last]);
    let share = |i: usize| match (i, start, end) {
        // The section itself begins or ends there.
        (0, None, _) => 0.0,
        (i, _, None) if i + 1 == last => 1.0,
        (i, ..) if beta.is_empty() || i == 0 || i + 1 == last => 0.5,
        (i, ..) => beta[i],
    };
    tridiagonal::solve(controls, upper, |i| row(t[i], share(i - 1), share(i)), known)
}

/// The coefficients of B_(i-1), B_i and B_(i+1) in row i, between the joints with the shares `before` and `after`.
#[inline]
pub(super) fn row(t: f64, before: f64, after: f64) -> [f64; 3] {
    let s = 1.0 - t;
    let (first, last) = (s * s, t * t);
    [first * (1.0 - before), 2.0 * t * s + first * before + last * (1.0 - after), last * after]
}

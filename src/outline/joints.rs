//! The joints of composite curves by knots, and what becomes of joints whose equations run away.
//!
//! By knots: beta_i = h_i / (h_i + h_(i+1)) with the span h_i = (d_(i-1) + d_i) / 2 of section i and d = chord^alpha, which
//! makes the curve a quadratic B-spline. It exists (Schoenberg and Whitney), but the rows are not dominant, and control
//! points may lie far out.

use super::composite;
use super::method::power;
use super::request::{Options, PointStatus, Report};
use super::run::{Run, Solution, Solved, Workspace, mark};
use super::segment;
use crate::alloc;
use crate::error::Result;

/// How far from its point a control point may be, in sizes of the outline. With joints in the middle it cannot be farther,
/// as the inverse of the equations has at most the norm 3.6 and no point is farther than 1/2 from the middle of the box in
/// any coordinate.
const FAR: f64 = 4.0;

/// Nearer than this, in sizes of the outline, a curve passes its points.
const EXACT: f64 = 1e-14;

/// The rounds in which joints are let fall back, before all are.
const ROUNDS: u32 = 3;

/// Finds the curve with joints by knots.
pub(super) fn knots(
    run: &Run<'_>,
    options: &Options,
    solved: &mut [Solved],
    workspace: &mut Workspace,
    report: &mut Report,
) -> Result<()> {
    begin(run, &mut workspace.solution)?;
    let alpha = options.method.alpha().unwrap_or(0.5);
    let n = run.points.len();
    let span = |i: usize| {
        let [a, p, c] = run.triple(i);
        power(a.distance(p), alpha) + power(p.distance(c), alpha)
    };
    for i in 0..n {
        let next = if i + 1 == n { 0 } else { i + 1 };
        let inner = run.closed || (i > 0 && next > 1 && next < n - 1);
        if inner {
            let (here, there) = (span(i), span(next));
            workspace.solution.beta[i] = here / (here + there);
        }
    }
    settle(run, options, solved, workspace, report)
}

/// Finds the curve for the shares there are; where it runs away, they fall back to halves.
pub(super) fn settle(
    run: &Run<'_>,
    options: &Options,
    solved: &mut [Solved],
    workspace: &mut Workspace,
    report: &mut Report,
) -> Result<()> {
    for round in 0..=ROUNDS {
        let sound = composite::solve(run, &mut workspace.solution)
            && !astray(run, &workspace.solution).any(|_| true)
            && composite::lock(run, options, solved, workspace, report)?;
        if sound && !astray(run, &workspace.solution).any(|_| true) {
            return Ok(());
        }
        let n = run.points.len();
        let Workspace { solution, iteration, .. } = workspace;
        iteration.begin(run, solution)?;
        for i in astray(run, solution) {
            iteration.held[i] = true;
        }
        for i in run.sections() {
            if !sound && round + 1 >= ROUNDS || iteration.held[i] {
                mark(&mut solved[i], PointStatus::FellBack);
                solution.beta[i] = 0.5;
                solution.beta[if i == 0 { n - 1 } else { i - 1 }] = 0.5;
            }
        }
        solution.t[..n].copy_from_slice(&solution.given[..n]);
    }
    // Not even with halves does the lock have a solution near by: now all is by parameters.
    composite::solve(run, &mut workspace.solution);
    Ok(())
}

/// Sections whose control points are farther away than they could be with joints in the middle, or that miss their points, as
/// the elimination may lose digits where rows are not dominant.
fn astray<'a>(run: &'a Run<'_>, solution: &'a Solution) -> impl Iterator<Item = usize> + 'a {
    run.sections().filter(|&i| {
        let (p, b) = (run.points[i], solution.controls[i]);
        let before = if i == 0 { run.points.len() - 1 } else { i - 1 };
        let section = [solution.joint(run, before), b, solution.joint(run, i)];
        let (away, miss) = (b.distance(p), segment::point(&section, solution.t[i]).distance(p));
        away.is_nan() || away > FAR * run.size || miss > EXACT * run.size
    })
}

/// All shares 1/2.
pub(super) fn begin(run: &Run<'_>, solution: &mut Solution) -> Result<()> {
    solution.beta.clear();
    alloc::reserve(&mut solution.beta, run.points.len())?;
    solution.beta.resize(run.points.len(), 0.5);
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    #[test]
    fn shares_without_a_solution_fall_back_to_halves() {
        let points: Vec<DVec3> = (0..9).map(|i| DVec3::new(f64::from(i % 3), f64::from(i * i % 7), 0.0)).collect();
        let run = Run { points: &points, closed: true, tangents: [None, None], size: 6.0 };
        let (options, mut workspace, mut report) = (Options::default(), Workspace::default(), Report::default());
        let mut solved = [Solved::default(); 9];
        workspace.solution.resize(9).unwrap();
        workspace.solution.t.fill(0.4);
        workspace.solution.given.fill(0.4);
        composite::solve(&run, &mut workspace.solution);
        let halves = workspace.solution.controls.clone();
        begin(&run, &mut workspace.solution).unwrap();
        workspace.solution.beta[4] = f64::NAN;
        settle(&run, &options, &mut solved, &mut workspace, &mut report).unwrap();
        assert_eq!(workspace.solution.controls, halves);
        assert!(solved.iter().all(|solved| solved.status == PointStatus::FellBack));
        // What is astray only before the equations are solved does no harm.
        let mut solved = [Solved::default(); 9];
        workspace.solution.controls[4] = DVec3::splat(1e3);
        // With it its neighbours miss their points.
        assert_eq!(astray(&run, &workspace.solution).collect::<Vec<_>>(), [3, 4, 5]);
        settle(&run, &options, &mut solved, &mut workspace, &mut report).unwrap();
        assert!(solved.iter().all(|solved| solved.status == PointStatus::Ok));
    }
}

//! The joints of composite curves elsewhere than in the middle.
//!
//! By knots: beta_i = h_i / (h_i + h_(i+1)) with the span h_i = (d_(i-1) + d_i) / 2 of section i and d = chord^alpha, which makes
//! the curve a quadratic B-spline. It exists (Schoenberg and Whitney), but the rows are not dominant, and control points may lie far out.
//!
//! By curvatures: with D_i the area of the triangle of B_(i-1), B_i and B_(i+1), the sections i and i+1 arrive at and leave J_i with the
//! curvatures (1 - beta_(i-1)) D_i / (beta_i^2 L^3) and beta_(i+1) D_(i+1) / ((1 - beta_i)^2 L^3), where L = |B_i B_(i+1)|. They agree if
//!
//! beta_i = sqrt((1 - beta_(i-1)) D_i) / (sqrt((1 - beta_(i-1)) D_i) + sqrt(beta_(i+1) D_(i+1))).
//!
//! The roots of D_i and D_(i+1) alone, as one reads at times, would do for equal shares only. Where the polygon turns the other way behind
//! the joint, the curvatures are as large as each other, but have different signs.
//!
//! Source: Yan, Schiller, Wilensky, Carr and Schaefer, k-Curves, 2017, for the shares by areas.

use super::composite;
use super::method::power;
use super::request::{FitStatus, Options, PointStatus, Report};
use super::run::{Room, Run, Solution, Solved, mark};
use crate::alloc;
use crate::error::Result;
use glam::DVec3;

/// How far from its point a control point may be, in sizes of the outline. With joints in the middle it cannot be farther, as the inverse of
/// the equations has at most the norm 3.6 and no point is farther than 1/2 from the middle of the box in any coordinate.
const FAR: f64 = 4.0;

/// The rounds in which joints are let fall back, before all are.
const ROUNDS: u32 = 3;

/// Shares by curvatures are between this and 1 less this.
const LEAST_SHARE: f64 = 1.0 / 16.0;

/// Finds the curve with joints by knots.
pub(super) fn knots(
    run: &Run<'_>,
    options: &Options,
    solved: &mut [Solved],
    room: &mut Room,
    report: &mut Report,
) -> Result<()> {
    begin(run, &mut room.solution)?;
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
            room.solution.beta[i] = here / (here + there);
        }
    }
    settle(run, options, solved, room, report)
}

/// Finds the curve for the shares there are; where it runs away, they fall back to halves.
fn settle(run: &Run<'_>, options: &Options, solved: &mut [Solved], room: &mut Room, report: &mut Report) -> Result<()> {
    for round in 0..=ROUNDS {
        let sound = composite::solve(run, &mut room.solution)
            && !astray(run, &room.solution).any(|_| true)
            && composite::lock(run, options, solved, room, report)?;
        if sound && !astray(run, &room.solution).any(|_| true) {
            return Ok(());
        }
        let n = run.points.len();
        let Room { solution, iteration, .. } = room;
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
    Ok(())
}

/// Sections whose control points are farther away than they could be with joints in the middle.
fn astray<'a>(run: &'a Run<'_>, solution: &'a Solution) -> impl Iterator<Item = usize> + 'a {
    run.sections().filter(|&i| {
        let away = solution.controls[i].distance(run.points[i]);
        away.is_nan() || away > FAR * run.size
    })
}

/// Finds the curve with joints by curvatures: solves for the control points and shares in turn, until the shares rest. Joints are kept
/// from coming too near a control point.
pub(super) fn curvatures(
    run: &Run<'_>,
    options: &Options,
    solved: &mut [Solved],
    room: &mut Room,
    report: &mut Report,
) -> Result<()> {
    begin(run, &mut room.solution)?;
    let n = run.points.len();
    let tolerance = options.tolerance.max(4.0 * f64::EPSILON);
    settle(run, options, solved, room, report)?;
    let joints = if run.closed { 0..n } else { 1..n.saturating_sub(2).max(1) };
    let next = |i: usize| if i + 1 == n { 0 } else { i + 1 };
    for _ in 0..options.max_sweeps {
        report.iterations += 1;
        let mut moved = 0.0f64;
        for i in joints.clone() {
            if [i, next(i)].iter().any(|&k| solved[k].status == PointStatus::FellBack) {
                continue;
            }
            let share = share_by_curvatures(run, &room.solution, i).clamp(LEAST_SHARE, 1.0 - LEAST_SHARE);
            let beta = &mut room.solution.beta[i];
            moved = moved.max((share - *beta).abs());
            *beta = share;
        }
        settle(run, options, solved, room, report)?;
        report.last_move = report.last_move.max(moved);
        if moved <= tolerance {
            break;
        }
    }
    // The curve is smooth and passes its points with any shares: those that still move keep what they have.
    for i in joints {
        let (share, beta) = (share_by_curvatures(run, &room.solution, i), room.solution.beta[i]);
        if (share.clamp(LEAST_SHARE, 1.0 - LEAST_SHARE) - beta).abs() > 10.0 * tolerance {
            report.status = FitStatus::NotConverged;
            [i, next(i)].iter().for_each(|&k| mark(&mut solved[k], PointStatus::NotConverged));
        } else if share != beta && !(LEAST_SHARE..=1.0 - LEAST_SHARE).contains(&share) {
            [i, next(i)].iter().for_each(|&k| mark(&mut solved[k], PointStatus::FellBack));
        }
    }
    Ok(())
}

/// The share that joint `i` should have for the control points and the other shares as they are.
fn share_by_curvatures(run: &Run<'_>, solution: &Solution, i: usize) -> f64 {
    let n = run.points.len();
    let at = |k: usize| (i + k) % n;
    let [a, b, c, d] = [n - 1, 0, 1, 2].map(|k| solution.controls[at(k)]);
    let (before, after) = (solution.share(run, at(n - 1)), solution.share(run, at(1)));
    let [here, there] = [(b - a).cross(c - b), (c - b).cross(d - c)].map(DVec3::length);
    let [here, there] = [(1.0 - before) * here, after * there].map(f64::sqrt);
    // Straight on both sides.
    if here + there > 0.0 { here / (here + there) } else { 0.5 }
}

/// All shares 1/2.
fn begin(run: &Run<'_>, solution: &mut Solution) -> Result<()> {
    solution.beta.clear();
    alloc::reserve(&mut solution.beta, run.points.len())?;
    solution.beta.resize(run.points.len(), 0.5);
    Ok(())
}

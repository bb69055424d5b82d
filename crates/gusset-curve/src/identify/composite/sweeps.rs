//! Gauss-Seidel sweeps over the points of a composite curve: each control point in turn is placed
//! for the current positions of the others, until none moves.
//!
//! Source: Nadopta. The lock by the data's guides has only this solver. With the neighbours fixed,
//!
//! P_i - Q_i(t_i) = r - (2 t s + s^2 beta_(i-1) + t^2 (1 - beta_i)) (B_i - B_i'),    s = 1 - t,
//!
//! for the deviation r at B_i'. B_i either moves there at once, or steps along the deviation
//! ([`Solver::Step`]), or for the lock by guides along the guide. The parameter is the data's, or
//! the method's on the section's triangle before B_i moves, or the crossing of section and guide.
//!
//! For the crossing, let f be an affine function that is 0 on the guide. It is 0 at B_i, which also
//! has its shares in the joints, so that B_i drops out of
//!
//! (1 - t)^2 (1 - beta_(i-1)) f(B_(i-1)) + t^2 beta_i f(B_(i+1)) = 0.
//!
//! Hence t does not depend on the position of B_i on the guide. If both neighbours are on one side,
//! the section does not cross the guide. O(n) for each sweep.

use super::control_equations;
use super::lock_rounds::{MAX_FALLBACK_ROUNDS, max_iterations_of_round};
use super::self_consistent;
use crate::identify::composite_solution::CompositeSolution;
use crate::identify::guide::{guide_direction, subcurve_plane_normal};
use crate::identify::identify_options::{Lock, Solver};
use crate::identify::method::Method;
use crate::identify::report::{FitStatus, PointStatus, ReportInProgress};
use crate::identify::stepping;
use crate::identify::subcurve::{PointResult, Subcurve, SubcurveOutput};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;

/// Crossings closer than this to an end of the section are ignored, because the equations would be
/// nearly singular.
const MIN_CROSSING_PARAMETER: f64 = 0.01;

/// If the section at a point still does not cross the point's guide line after this many sweeps,
/// the point keeps the parameter of the data's triangle.
const MAX_SWEEPS_WITHOUT_CROSSING: u32 = 24;

/// Points between two progress reports.
const POINTS_PER_REPORT: usize = 1 << 14;

const PROGRESS_STAGE: &str = "placing control points";

/// Solves by sweeps, starting from control points that solve the linear equations. Returns false if
/// the equations become singular, which requires joint parameters other than 1/2.
pub(super) fn solve_by_sweeps(
    sub: &Subcurve<'_>,
    solution: &mut CompositeSolution,
    out: &mut SubcurveOutput<'_>,
) -> Result<bool> {
    move_controls_to_sweep_start(sub, solution, out.results)?;
    let lock = sub.options.lock;
    for round in 0..=MAX_FALLBACK_ROUNDS {
        let rests = sweep_until_converged(sub, solution, out, max_iterations_of_round(sub, round))?;
        // Further rounds replace the lock at some points.
        out.report.is_uncounted = true;
        for i in sub.section_indices() {
            let moves =
                solution.controls[i].distance(solution.previous_controls[i]) > sub.options.tolerance * sub.outline_size;
            let fails = !rests && (moves || round + 1 >= MAX_FALLBACK_ROUNDS) && lock != Lock::Parameter;
            if fails && !solution.has_fallen_back[i] {
                solution.has_fallen_back[i] = true;
                out.results[i].flag_status(PointStatus::FellBack);
                out.report.status = FitStatus::NotConverged;
            }
            if solution.has_fallen_back[i] {
                solution.point_parameters[i] = solution.parameters_by_data_triangles[i];
            }
        }
        if rests || lock == Lock::Parameter {
            break;
        }
    }
    // With the current parameters, the curve passes the points exactly.
    let regular = control_equations::solve_control_points(sub, solution);
    let [low, high] = sub.section_parameter_range();
    for i in sub.section_indices() {
        match lock {
            _ if solution.has_fallen_back[i] || solution.has_missed_guide[i] => {
                out.results[i].flag_status(PointStatus::NoCrossing);
            }
            Lock::SelfConsistent if !(low < solution.point_parameters[i] && solution.point_parameters[i] < high) => {
                out.results[i].flag_status(PointStatus::ClampedParameter);
            }
            _ => {}
        }
    }
    Ok(regular)
}

/// Moves the control points to the start of the sweeps.
fn move_controls_to_sweep_start(
    sub: &Subcurve<'_>,
    solution: &mut CompositeSolution,
    results: &mut [PointResult],
) -> Result<()> {
    if sub.options.lock == Lock::DataGuide {
        find_guide_directions(sub, solution, results)?;
        for i in sub.section_indices() {
            if !solution.has_fallen_back[i] {
                // The nearest place on the guide.
                let (p, guide) = (sub.points[i], solution.guide_directions[i]);
                solution.controls[i] = p + guide * guide.dot(solution.controls[i] - p);
            }
        }
    } else if sub.options.solver == Solver::Step {
        // The paper starts at the points.
        for i in sub.section_indices() {
            solution.controls[i] = sub.points[i];
        }
    }
    Ok(())
}

/// Sweeps until neither the moves nor their predicted sum exceed the tolerance. Moves that shrink
/// by a ratio r sum up to r / (1 - r) of the last one. Keeps the control points before the last
/// sweep.
fn sweep_until_converged(
    sub: &Subcurve<'_>,
    solution: &mut CompositeSolution,
    out: &mut SubcurveOutput<'_>,
    max_sweeps: u32,
) -> Result<bool> {
    let (report, n) = (&mut *out.report, sub.len());
    let tolerance = sub.options.tolerance.max(f64::EPSILON) * sub.outline_size;
    let rounding = 16.0 * f64::EPSILON * sub.outline_size;
    let (mut last, mut placed) = (f64::INFINITY, 0_usize);
    for sweep in 0..max_sweeps {
        report.count_iteration();
        solution.save_controls();
        let (mut farthest, mut all_placed) = (0.0f64, true);
        for i in sub.section_indices() {
            // Counts over all sweeps, because few points may take many sweeps.
            if placed.is_multiple_of(POINTS_PER_REPORT) {
                out.job.step(i as f64 / n as f64, PROGRESS_STAGE)?;
            }
            placed += 1;
            let before = solution.controls[i];
            all_placed &= place_control_point(sub, solution, (sweep, i), report, out.job)?;
            farthest = farthest.max(solution.controls[i].distance_squared(before));
        }
        let farthest = farthest.sqrt();
        report.record_cycle(farthest / sub.outline_size, &solution.controls[..n])?;
        let ratio = farthest / last;
        last = farthest;
        let rests = farthest <= rounding || farthest * ratio <= tolerance * (1.0 - ratio);
        if all_placed && farthest <= tolerance && rests {
            return Ok(true);
        }
    }
    Ok(false)
}

/// Places one control point. Returns false if the steps are used up.
fn place_control_point(
    sub: &Subcurve<'_>,
    solution: &mut CompositeSolution,
    (sweep, i): (u32, usize),
    report: &mut ReportInProgress,
    job: &Job<'_>,
) -> Result<bool> {
    let [b, u, v] = solution.control_and_joints_relative_to_point(sub, i);
    let mut guide = None;
    let t = match sub.options.lock {
        _ if solution.has_fallen_back[i] => solution.parameters_by_data_triangles[i],
        Lock::Parameter => solution.parameters_by_data_triangles[i],
        Lock::SelfConsistent => self_consistent::parameter_and_gradients(sub.options, u, v).0,
        Lock::DataGuide => match parameter_where_section_crosses_guide(sub, solution, i) {
            Some(t) => {
                guide = Some(solution.guide_directions[i]);
                solution.has_missed_guide[i] = false;
                t
            }
            None => {
                solution.has_missed_guide[i] = true;
                solution.has_fallen_back[i] = sweep >= MAX_SWEEPS_WITHOUT_CROSSING;
                solution.parameters_by_data_triangles[i]
            }
        },
    };
    solution.point_parameters[i] = t;
    let s = 1.0 - t;
    let [_, slope, _] = control_equations::control_point_coefficients(
        t,
        solution.joint_parameters_of_iteration[sub.previous_index(i)],
        solution.joint_parameters_of_iteration[i],
    );
    // A point that has returned to its guide is first projected on it.
    let start = guide.map_or(b, |guide| guide * guide.dot(b));
    let left = -(u * (s * s) + b * (2.0 * t * s) + v * (t * t)) + (b - start) * slope;
    let target = start + left / slope;
    let placed = match sub.options.solver {
        Solver::Fast => guide.map_or(target, |guide| guide * guide.dot(target)),
        Solver::Step => {
            let direction = guide.unwrap_or_else(|| left.normalize_or_zero());
            let deviation = |x: f64| direction.dot(left) - slope * x;
            match stepping::step_until_deviation_is_zero(
                sub.options,
                sub.outline_size,
                deviation,
                &mut report.steps,
                job,
            )? {
                Some(along) => start + direction * along,
                None => return Ok(false),
            }
        }
    };
    if placed.is_finite() {
        solution.controls[i] = sub.points[i] + placed;
    }
    Ok(placed.is_finite())
}

/// Returns the parameter at which the section crosses the guide of its point; `None` if it does
/// not.
fn parameter_where_section_crosses_guide(sub: &Subcurve<'_>, solution: &CompositeSolution, i: usize) -> Option<f64> {
    let guide = solution.guide_directions[i];
    let (before, after) = (sub.previous_index(i), sub.next_index(i));
    let p = sub.points[i];
    let (a, c) = (solution.controls[before] - p, solution.controls[after] - p);
    // The components across the guide; in a plane both are collinear.
    let (a, c) = (a - guide * a.dot(guide), c - guide * c.dot(guide));
    if a.dot(c) >= 0.0 {
        return None;
    }
    let first = ((1.0 - solution.joint_parameters_of_iteration[before]) * a.length()).sqrt();
    let last = (solution.joint_parameters_of_iteration[i] * c.length()).sqrt();
    let t = first / (first + last);
    (MIN_CROSSING_PARAMETER..=1.0 - MIN_CROSSING_PARAMETER).contains(&t).then_some(t)
}

/// Finds the guides of the data's own triangles. Points without a guide, and all points of a
/// subcurve that is not plane, fall back.
fn find_guide_directions(
    sub: &Subcurve<'_>,
    solution: &mut CompositeSolution,
    results: &mut [PointResult],
) -> Result<()> {
    alloc::reset(&mut solution.guide_directions, sub.len(), DVec3::ZERO)?;
    let normal = subcurve_plane_normal(sub);
    for i in sub.section_indices() {
        let [a, p, c] = sub.point_and_neighbours(i);
        let found = normal.ok_or(PointStatus::OutOfPlane).and_then(|normal| {
            guide_direction(sub.options.method, a - p, c - p, normal).or_else(|status| {
                // The normal misses the chord, so use the bisector.
                results[i].flag_status(status);
                guide_direction(Method::Bisector, a - p, c - p, normal)
            })
        });
        match found {
            Ok(guide) => solution.guide_directions[i] = guide,
            Err(status) => {
                solution.has_fallen_back[i] = true;
                results[i].flag_status(status);
            }
        }
    }
    Ok(())
}

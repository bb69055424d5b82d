//! Joint parameters by knots, and the fallback of joints whose equations lack a usable solution.
//!
//! By knots, beta_i = h_i / (h_i + h_(i+1)) with the span h_i = (d_(i-1) + d_i) / 2 of section i
//! and d = chord^alpha. The curve is then a quadratic B-spline. It exists (Schoenberg and Whitney,
//! 1953), but the rows are not dominant, and control points may lie far out. Joints next to such
//! points return to 1/2. O(n) for each of at most 4 rounds.

use super::control_equations;
use super::lock::{self, LockWorkspace};
use crate::curve::segment;
use crate::identify::composite_solution::CompositeSolution;
use crate::identify::method::power_by_roots_if_possible;
use crate::identify::report::PointStatus;
use crate::identify::subcurve::{Subcurve, SubcurveOutput};
use gusset_base::alloc;
use gusset_base::error::Result;

/// The distance of a control point from its point, in sizes of the outline, beyond which it has run
/// away. With middle joints it cannot be farther: the inverse of the equations has at most the norm
/// 3.6, and in each coordinate points are at most 1/2 from the middle of the box.
const MAX_CONTROL_TO_POINT_DISTANCE: f64 = 4.0;

/// The largest distance between the curve and a point that it passes, in sizes of the outline.
const MAX_POINT_MISS_DISTANCE: f64 = 1e-14;

/// The rounds in which individual joints fall back, before all joints do.
const MAX_FALLBACK_ROUNDS: u32 = 3;

/// Finds the curve with joints by knots.
pub(super) fn solve_with_knot_joints(
    sub: &Subcurve<'_>,
    workspace: &mut LockWorkspace,
    out: &mut SubcurveOutput<'_>,
) -> Result<()> {
    let n = sub.len();
    workspace.solution.reset_joint_parameters(n)?;
    let alpha = sub.options.method.chord_exponent().unwrap_or(0.5);
    let span = |i: usize| {
        let [a, p, c] = sub.point_and_neighbours(i);
        power_by_roots_if_possible(a.distance(p), alpha) + power_by_roots_if_possible(p.distance(c), alpha)
    };
    for i in 0..n {
        let next = sub.next_index(i);
        let inner = sub.closed || (i > 0 && next > 1 && next < n - 1);
        if inner {
            let (here, there) = (span(i), span(next));
            workspace.solution.betas[i] = here / (here + there);
        }
    }
    solve_and_reset_bad_joints(sub, workspace, out).map(|_| ())
}

/// Finds the curve for the current joint parameters. Where it runs away, they fall back to 1/2.
/// Returns false if only the lock by parameters has a solution.
pub(super) fn solve_and_reset_bad_joints(
    sub: &Subcurve<'_>,
    workspace: &mut LockWorkspace,
    out: &mut SubcurveOutput<'_>,
) -> Result<bool> {
    let none_runs_away = |solution: &CompositeSolution| {
        !sub.section_indices().any(|i| is_control_too_far_or_point_missed(sub, solution, i))
    };
    for round in 0..=MAX_FALLBACK_ROUNDS {
        let regular = control_equations::solve_control_points(sub, &mut workspace.solution)
            && none_runs_away(&workspace.solution)
            && lock::solve_with_lock(sub, workspace, out)?;
        if regular && none_runs_away(&workspace.solution) {
            return Ok(true);
        }
        let solution = &mut workspace.solution;
        let (n, all) = (sub.len(), !regular && round + 1 >= MAX_FALLBACK_ROUNDS);
        let fallen = alloc::gather(
            sub.section_indices().filter(|&i| all || is_control_too_far_or_point_missed(sub, solution, i)),
        )?;
        for i in fallen {
            out.results[i].flag_status(PointStatus::JointFellBack);
            solution.betas[i] = 0.5;
            solution.betas[sub.previous_index(i)] = 0.5;
        }
        solution.point_parameters[..n].copy_from_slice(&solution.parameters_by_data_triangles[..n]);
    }
    // Even with middle joints the lock has no nearby solution, so use the lock by parameters
    // everywhere.
    control_equations::solve_control_points(sub, &mut workspace.solution);
    Ok(false)
}

/// Returns true if the control point of a section is farther away than middle joints allow, or the
/// section misses its point. Elimination may lose digits if rows are not dominant.
fn is_control_too_far_or_point_missed(sub: &Subcurve<'_>, solution: &CompositeSolution, i: usize) -> bool {
    let (p, b) = (sub.points[i], solution.controls[i]);
    let section = [solution.joint_point(sub, sub.previous_index(i)), b, solution.joint_point(sub, i)];
    let (away, miss) = (b.distance(p), segment::point_at(&section, solution.point_parameters[i]).distance(p));
    away.is_nan()
        || away > MAX_CONTROL_TO_POINT_DISTANCE * sub.outline_size
        || miss > MAX_POINT_MISS_DISTANCE * sub.outline_size
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::identify::identify_options::Options;
    use crate::identify::subcurve::PointResult;
    use glam::DVec3;

    #[test]
    fn joints_without_a_solution_fall_back_to_the_middle() {
        let points: Vec<DVec3> = (0..9).map(|i| DVec3::new(f64::from(i % 3), f64::from(i * i % 7), 0.0)).collect();
        let options = Options::default();
        let sub =
            Subcurve { points: &points, closed: true, tangents: [None, None], outline_size: 6.0, options: &options };
        let mut workspace = LockWorkspace::default();
        let (mut report, mut builder, job) = Default::default();
        let mut results = [PointResult::default(); 9];
        workspace.solution.reserve_for_points(9).unwrap();
        workspace.solution.point_parameters.fill(0.4);
        workspace.solution.parameters_by_data_triangles.fill(0.4);
        control_equations::solve_control_points(&sub, &mut workspace.solution);
        let halves = workspace.solution.controls.clone();
        workspace.solution.reset_joint_parameters(9).unwrap();
        workspace.solution.betas[4] = f64::NAN;
        let mut out = SubcurveOutput { results: &mut results, report: &mut report, builder: &mut builder, job: &job };
        solve_and_reset_bad_joints(&sub, &mut workspace, &mut out).unwrap();
        assert_eq!(workspace.solution.controls, halves);
        assert!(results.iter().all(|result| result.status == PointStatus::JointFellBack));
        // A runaway before the equations are solved is harmless.
        let mut results = [PointResult::default(); 9];
        let mut out = SubcurveOutput { results: &mut results, report: &mut report, builder: &mut builder, job: &job };
        workspace.solution.controls[4] = DVec3::splat(1e3);
        // Its neighbours then miss their points.
        assert!(
            (0..9).all(|i| is_control_too_far_or_point_missed(&sub, &workspace.solution, i) == (3..6).contains(&i))
        );
        solve_and_reset_bad_joints(&sub, &mut workspace, &mut out).unwrap();
        assert!(results.iter().all(|result| result.status == PointStatus::Ok));
    }
}

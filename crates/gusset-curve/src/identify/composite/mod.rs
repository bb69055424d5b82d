//! Composite curves: a quadratic section around each point, joined smoothly.
//!
//! - equations: the linear equations of the control points, on which all other files build.
//! - self_consistent, sweeps: parameters that depend on the control points. lock: the choice
//!   between them.
//! - rounds: the limits on iterations.
//! - knot_joints, curvature: joints other than in the middle.
//! - here: parameters by the data's triangles, and the segments of the solution.
//!
//! The first section of an open subcurve begins at the first point. If a tangent is given there, a
//! control point T on the tangent precedes B_1, and a segment (P_0, T, J_0) precedes the first
//! section. The equations stay the same. The last end is treated likewise.
//!
//! Source: Nadopta, for sections and methods; the composite reading of a set of sections is ours.

mod curvature;
mod control_equations;
mod knot_joints;
mod lock;
mod lock_rounds;
mod self_consistent;
mod sweeps;

use super::composite_solution::CompositeSolution;
use super::identify_options::{JointParameter, Lock, Solver};
use super::method::{Method, power_by_roots_if_possible};
use super::report::{PointStatus, Report};
use super::residuals::MaxJointSine;
use super::subcurve::{PointResult, Subcurve, SubcurveOutput};
use crate::curve::{Place, segment};
use curvature::ContinuousCurvatureSolver;
use glam::DVec3;
use gusset_base::error::Result;
use lock::LockWorkspace;

/// The unknowns, and the workspace of the solvers, which subcurves reuse.
#[derive(Default)]
pub(super) struct CompositeWorkspace {
    lock: LockWorkspace,
    joints: ContinuousCurvatureSolver,
}

impl CompositeWorkspace {
    /// Returns the unknowns; other kinds of curves use the lists for their own.
    pub(super) fn solution(&mut self) -> &mut CompositeSolution {
        &mut self.lock.solution
    }
}

/// Appends the composite curve of a subcurve's points.
pub(super) fn append_composite_curve(
    sub: &Subcurve<'_>,
    workspace: &mut CompositeWorkspace,
    out: &mut SubcurveOutput<'_>,
) -> Result<()> {
    solve_composite_curve(sub, workspace, out)?;
    let solution = workspace.solution();
    if !solution.handles.is_empty() {
        return append_cubic_sections(sub, solution, out);
    }
    if !sub.closed {
        return append_open_quadratics(sub, solution, out);
    }
    let places = (0..).zip(&solution.point_parameters).map(|(segment, &t)| Place { segment, t });
    out.results.iter_mut().zip(places).for_each(|(result, place)| result.place = place);
    write_closed_curve(sub, solution, |p| p, out.builder.allocate_closed_quadratics(sub.len())?, out.report);
    Ok(())
}

/// Finds parameters, joint parameters and control points.
pub(super) fn solve_composite_curve(
    sub: &Subcurve<'_>,
    workspace: &mut CompositeWorkspace,
    out: &mut SubcurveOutput<'_>,
) -> Result<()> {
    let CompositeWorkspace { lock: workspace, joints } = workspace;
    let (n, solution, options) = (sub.len(), &mut workspace.solution, sub.options);
    solution.reserve_for_points(n)?;
    solution.betas.clear();
    solution.handles.clear();
    find_section_parameters(sub, solution, out.results);
    control_equations::solve_control_points(sub, solution);
    if (options.lock, options.joint, options.solver) == (Lock::Parameter, JointParameter::Half, Solver::Fast) {
        return Ok(());
    }
    solution.parameters_by_data_triangles[..n].copy_from_slice(&solution.point_parameters[..n]);
    match options.joint {
        JointParameter::Half => lock::solve_with_lock(sub, workspace, out).map(|_| ()),
        JointParameter::Knot => knot_joints::solve_with_knot_joints(sub, workspace, out),
        JointParameter::G2 => curvature::solve_with_continuous_curvature(sub, workspace, joints, out),
    }
}

/// Finds each point's parameter on its section from the triangle of the point and its two
/// neighbours, by the method. Clamps the parameter to the permitted range.
fn find_section_parameters(sub: &Subcurve<'_>, solution: &mut CompositeSolution, results: &mut [PointResult]) {
    let options = sub.options;
    let [low, high] = sub.section_parameter_range();
    let enter = |t: f64, parameter: &mut f64, result: &mut PointResult| {
        *parameter = t.clamp(low, high);
        if options.lock == Lock::Parameter && !(low..=high).contains(&t) {
            result.flag_status(PointStatus::ClampedParameter);
        }
    };
    let sections = sub.section_indices();
    let Some(alpha) = options.method.chord_exponent() else {
        for i in sections {
            let [a, p, c] = sub.point_and_neighbours(i);
            let t = options.method.section_parameter(a, p, c).or_else(|status| {
                if options.lock == Lock::Parameter {
                    results[i].flag_status(status);
                }
                Method::Bisector.section_parameter(a, p, c)
            });
            enter(t.unwrap_or(0.5), &mut solution.point_parameters[i], &mut results[i]);
        }
        return;
    };
    if alpha == 0.0 {
        solution.point_parameters[sections].fill(0.5);
        return;
    }
    // Each chord is the first of one section and the last of the previous one. Chord i ends at
    // point i.
    let chords = &mut solution.elimination_factors[..sub.len()];
    let points = sub.points;
    chords[0] = points[points.len() - 1].distance(points[0]);
    for (chord, pair) in chords[1..].iter_mut().zip(points.windows(2)) {
        *chord = pair[1].distance(pair[0]);
    }
    match alpha {
        0.5 => chords.iter_mut().for_each(|chord| *chord = chord.sqrt()),
        1.0 => {}
        _ => chords.iter_mut().for_each(|chord| *chord = power_by_roots_if_possible(*chord, alpha)),
    }
    let chords = &*chords;
    let mut all_allowed = true;
    let (first, last) = (sections.start, sections.end);
    for i in first..last {
        let (before, after) = (chords[i], chords[sub.next_index(i)]);
        let t = before / (before + after);
        all_allowed &= (low..=high).contains(&t);
        solution.point_parameters[i] = t;
    }
    if !all_allowed {
        for (t, result) in solution.point_parameters[first..last].iter_mut().zip(&mut results[first..last]) {
            enter(*t, t, result);
        }
    }
}

/// Appends the segments of an open subcurve, and stores the places of the points.
fn append_open_quadratics(
    sub: &Subcurve<'_>,
    solution: &CompositeSolution,
    out: &mut SubcurveOutput<'_>,
) -> Result<()> {
    let SubcurveOutput { results, builder, .. } = out;
    let first = builder.len() as u32;
    let last = sub.len() - 1;
    let ends = sub.end_controls();
    builder.begin_at_point(sub.points[0])?;
    results[0].place = Place { segment: first, t: 0.0 };
    match (last, ends) {
        (1, [None, None]) => builder.push_segment(&[sub.points[1]])?,
        (1, [Some(control), None] | [None, Some(control)]) => builder.push_segment(&[control, sub.points[1]])?,
        _ => {
            if let Some(control) = ends[0] {
                builder.push_segment(&[control, solution.joint_point(sub, 0)])?;
            }
            for i in sub.section_indices() {
                results[i].place = Place { segment: builder.len() as u32, t: solution.point_parameters[i] };
                builder.push_segment(&[solution.controls[i], solution.joint_point(sub, i)])?;
            }
            if let Some(control) = ends[1] {
                builder.push_segment(&[control, sub.points[last]])?;
            }
        }
    }
    results[last].place = Place { segment: builder.len() as u32 - 1, t: 1.0 };
    Ok(())
}

/// Appends the segments of a subcurve of cubic sections, and stores the places of the points.
fn append_cubic_sections(sub: &Subcurve<'_>, solution: &CompositeSolution, out: &mut SubcurveOutput<'_>) -> Result<()> {
    let SubcurveOutput { results, builder, .. } = out;
    let (n, ends) = (sub.len(), sub.end_controls());
    let last = n - 1;
    let of_section = |i: usize, first: DVec3, joint: DVec3| {
        let (control, [lambda, mu]) = (solution.controls[i], solution.handles[i]);
        // Handles of 1 end at the control point, bit for bit.
        let on = |from: DVec3, part: f64| if part == 1.0 { control } else { from + (control - from) * part };
        [on(first, lambda), on(joint, mu), joint]
    };
    let mut from = if sub.closed { solution.joint_point(sub, last) } else { sub.points[0] };
    let start = from;
    builder.begin_at_point(from)?;
    if !sub.closed {
        results[0].place = Place { segment: builder.len() as u32, t: 0.0 };
        if ends[0].is_some() {
            let joint = solution.joint_point(sub, 0);
            builder.push_segment(&of_section(0, from, joint))?;
            from = joint;
        }
    }
    for i in sub.section_indices() {
        let joint = if sub.closed && i == last { start } else { solution.joint_point(sub, i) };
        results[i].place = Place { segment: builder.len() as u32, t: solution.point_parameters[i] };
        builder.push_segment(&of_section(i, from, joint))?;
        from = joint;
    }
    if !sub.closed {
        if ends[1].is_some() {
            builder.push_segment(&of_section(last, from, sub.points[last]))?;
        }
        results[last].place = Place { segment: builder.len() as u32 - 1, t: 1.0 };
    }
    Ok(())
}

/// Writes the control points of a closed subcurve, each p as `map_point(p)`: two for each point and
/// one more. Section i is segment i. Measures the curve at the same time; see
/// [`measure_residuals`](super::residuals::measure_residuals).
pub(super) fn write_closed_curve(
    sub: &Subcurve<'_>,
    solution: &CompositeSolution,
    map_point: impl Fn(DVec3) -> DVec3,
    out: &mut [DVec3],
    report: &mut Report,
) {
    let n = sub.len();
    let start = solution.joint_point(sub, n - 1);
    let (first, rest) = out.split_at_mut(1);
    first[0] = map_point(start);
    let controls = &solution.controls[..n];
    let following = controls[1..].iter().chain(&controls[..1]);
    let known = sub.points.iter().zip(controls).zip(following).zip(&solution.point_parameters);
    let (mut joint, mut angle, mut farthest) = (start, MaxJointSine::default(), 0.0f64);
    for (i, (segment, (((&p, &control), &next), &t))) in rest.as_chunks_mut::<2>().0.iter_mut().zip(known).enumerate() {
        let beta = if solution.betas.is_empty() { 0.5 } else { solution.betas[i] };
        let end = if i + 1 == n { start } else { control + (next - control) * beta };
        *segment = [map_point(control), map_point(end)];
        farthest = farthest.max(segment::point_at(&[joint, control, end], t).distance_squared(p));
        angle.add_joint(end - control, next - end);
        joint = end;
    }
    report.max_residual = farthest.sqrt() / sub.outline_size;
    report.max_joint_sine = angle.sine();
}

//! Continuous curvature: cubic sections, joined G2.
//!
//! Section i is the cubic in the triangle (J_(i-1), B_i, J_i) with the handles lambda_i and mu_i,
//! see [`control_equations`]. With E_i = |(B_i - B_(i-1)) x (B_(i+1) - B_i)| and
//! L_i = |B_(i+1) - B_i| it has at its ends the curvatures
//!
//! 2/3 (1 - mu_i) beta_i E_i / (lambda_i^2 (1 - beta_(i-1))^2 L_(i-1)^3) and
//!
//! 2/3 (1 - lambda_i) (1 - beta_(i-1)) E_i / (mu_i^2 beta_i^2 L_i^3).
//!
//! The paper's quadratics do not suffice for two reasons. The curvature of a quadratic keeps its
//! sign and is never 0, so it jumps at every inflection of the polygon. For dense, even points, the
//! joint parameters alone also cannot detect a jump that alternates from joint to joint. With
//! lambda and mu each joint has three unknowns and one equation. Newton's method finds the solution
//! nearest the quadratics (see newton). The points keep their parameters, and the lock holds.
//!
//! At an inflection of the polygon behind a joint, lambda_i = mu_(i+1) = 1 makes the curvature 0 on
//! both sides. Joints next to a straight section are treated likewise. So are joints whose
//! equations have no nearby solution, which finally makes the curvature of every plane outline
//! continuous ([`PointStatus::JointFellBack`]). In space, neighbouring sections lie in different
//! planes, and the curvatures agree in magnitude.
//!
//! O(n) for each iteration, in time and memory. Most of the time goes to the points whose equations do not hold yet.
//!
//! Source: de Boor, Hoellig and Sabin, High accuracy geometric Hermite interpolation, 1987, for
//! cubics by tangents and curvatures; Yan, Schiller, Wilensky, Carr and Schaefer, k-Curves, 2017,
//! for quadratics with continuous curvature.

mod curvature_newton;
mod curvature_system;

use super::control_equations;
use super::knot_joints::solve_and_reset_bad_joints;
use super::lock::LockWorkspace;
use crate::identify::composite_solution::CompositeSolution;
use crate::identify::guide::subcurve_plane_normal;
use crate::identify::identify_options::Lock;
use crate::identify::report::{FitStatus, PointStatus};
use crate::identify::subcurve::{Subcurve, SubcurveOutput};
use curvature_newton::{LeastNormNewton, MAX_STEP_REACH, POINTS_PER_REPORT, PROGRESS_STAGE, PointWindow};
use curvature_system::{
    EQUATIONS_PER_POINT, FixedPointQuantities, LockEquation, POINTS_PER_EQUATION, PointUnknowns, evaluate_equations,
    legs_at_control_point,
};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;
use std::ops::Range;

/// The handles of a quadratic.
const HANDLE_FRACTIONS_OF_QUADRATIC: [f64; 2] = [2.0 / 3.0; 2];

/// The number of iterations after which the worst equations are given up.
const MAX_ITERATIONS_PER_ROUND: u32 = 12;

/// Limits the relative rounding error of the triangle area E_i at a bend of the control polygon.
/// Beyond it, the polygon counts as straight there.
const MAX_RELATIVE_AREA_ROUNDING_OF_BEND: f64 = 1e-2;

/// Limits the relative rounding error of E_i at a bend whose curvature is below
/// [`MIN_SIGNIFICANT_CURVATURE`]. Dense points make all errors large, so errors between both limits
/// do not make a sharper bend straight.
const MAX_RELATIVE_AREA_ROUNDING_OF_FAINT_BEND: f64 = 1e-8;

/// The smallest significant curvature, times the size of the outline.
const MIN_SIGNIFICANT_CURVATURE: f64 = 1e-2;

/// The maximum number of rounds that search for inflections, because each changes the polygon
/// slightly.
const MAX_INFLECTION_ROUNDS: u32 = 8;

/// Gives up the worst failing point within this many neighbours on each side.
const GIVEN_UP_NEIGHBOURS_PER_SIDE: usize = 3;

/// The residual of an equation, in tolerances, that is still accepted once the curve passes its
/// points.
const MAX_RESIDUAL_IN_TOLERANCES: f64 = 100.0;

/// The largest distance between the curve and a point that it passes, in sizes of the outline.
const MAX_POINT_MISS_DISTANCE: f64 = 1e-14;

/// The sine of the largest angle between two planes that count as one.
const MAX_PLANE_SINE: f64 = 1e-7;

/// The unknowns, and the workspace of Newton's method.
#[derive(Default)]
pub(super) struct ContinuousCurvatureSolver {
    nodes: Vec<PointUnknowns>,
    given_quantities: Vec<FixedPointQuantities>,
    equation_values: Vec<[f64; EQUATIONS_PER_POINT]>,
    /// Joints with zero curvature, and those among them whose equations were given up.
    has_zero_curvature: Vec<bool>,
    is_given_up_joint: Vec<bool>,
    /// Points whose equations are in trouble.
    has_unsolved_equations: Vec<bool>,
    /// The points that the next step moves.
    windows_of_next_step: Vec<PointWindow>,
    newton: LeastNormNewton,
}

/// Finds the curve with continuous curvature.
pub(super) fn solve_with_continuous_curvature(
    sub: &Subcurve<'_>,
    workspace: &mut LockWorkspace,
    joints: &mut ContinuousCurvatureSolver,
    out: &mut SubcurveOutput<'_>,
) -> Result<()> {
    workspace.solution.reset_joint_parameters(sub.len())?;
    // The lock is the start of the iteration, not part of it.
    out.report.is_uncounted = true;
    let locked = solve_and_reset_bad_joints(sub, workspace, out)?;
    out.report.is_uncounted = false;
    let solution = &mut workspace.solution;
    if inner_joints(sub).is_empty() {
        return Ok(());
    }
    joints.start_from_quadratics(sub, solution, locked)?;
    joints.find_inflections(sub, solution);
    joints.iterate_until_converged(sub, solution, out)?;
    let sound = joints.solve_control_points_again(sub, solution) && joints.passes_all_points(sub, solution);
    if !sound {
        joints.set_all_curvatures_to_zero(sub, solution);
    }
    joints.evaluate_all_equations(sub, out.job)?;
    joints.set_point_statuses(sub, out);
    Ok(())
}

/// Returns the joints between two segments.
fn inner_joints(sub: &Subcurve<'_>) -> Range<usize> {
    let n = sub.len();
    match (sub.closed, sub.tangents) {
        (true, _) => 0..n,
        (false, [start, end]) => usize::from(start.is_none())..n - if end.is_some() { 1 } else { 2 },
    }
}

impl ContinuousCurvatureSolver {
    /// Starts from the curve with quadratic sections, which passes its points. `locked` tells
    /// whether a lock other than the lock by parameter holds.
    fn start_from_quadratics(
        &mut self,
        sub: &Subcurve<'_>,
        solution: &mut CompositeSolution,
        locked: bool,
    ) -> Result<()> {
        let n = sub.len();
        alloc::reset(&mut solution.handles, n, HANDLE_FRACTIONS_OF_QUADRATIC)?;
        alloc::reset(&mut self.nodes, n, PointUnknowns::default())?;
        alloc::reset(&mut self.equation_values, n, [0.0; EQUATIONS_PER_POINT])?;
        for list in [&mut self.has_zero_curvature, &mut self.is_given_up_joint, &mut self.has_unsolved_equations] {
            alloc::reset(list, n, false)?;
        }
        self.newton.reset_for_points(n)?;
        let by_parameter = !locked || sub.options.lock == Lock::Parameter;
        let plane = if by_parameter { None } else { subcurve_plane_normal(sub) };
        let known = (0..n).map(|i| {
            let inner = sub.section_indices().contains(&i);
            let fallen = by_parameter || !inner || solution.has_fallen_back[i] || solution.has_missed_guide[i];
            let lock_equation = match (sub.options.lock, plane) {
                _ if fallen => LockEquation::GivenParameter,
                (Lock::SelfConsistent, _) => LockEquation::TriangleParameter,
                (Lock::DataGuide, Some(normal)) => LockEquation::OnGuide(normal.cross(solution.guide_directions[i])),
                _ => LockEquation::GivenParameter,
            };
            let [a, p, c] = sub.point_and_neighbours(i);
            let spacing = if inner { 0.5 * (a.distance(p) + p.distance(c)) } else { sub.outline_size };
            FixedPointQuantities {
                lock_equation,
                spacing,
                normal: DVec3::ZERO,
                curved: false,
                is_control_point_given: !inner,
                is_unknown: [false; 3],
            }
        });
        self.given_quantities.clear();
        alloc::extend(&mut self.given_quantities, known)?;
        for (i, node) in self.nodes.iter_mut().enumerate() {
            let beta = CompositeSolution::joint_parameter(sub, &solution.betas, i);
            *node = PointUnknowns {
                control: solution.controls[i],
                t: solution.point_parameters[i],
                beta,
                handles: HANDLE_FRACTIONS_OF_QUADRATIC,
            };
        }
        Ok(())
    }

    /// Sets the curvature to 0 at all joints followed by an inflection or a straight part of the
    /// polygon.
    fn find_inflections(&mut self, sub: &Subcurve<'_>, solution: &mut CompositeSolution) {
        for _ in 0..MAX_INFLECTION_ROUNDS {
            (0..sub.len()).for_each(|i| self.find_turn_normal(sub, i));
            if !self.set_inflections_to_zero_curvature(sub, inner_joints(sub)) {
                break;
            }
            self.solve_control_points_again(sub, solution);
        }
        self.choose_equations_and_unknowns(sub);
    }

    /// Sets the curvature to 0 at joints followed by an inflection or a straight part of
    /// the current polygon. Returns false if there are none left.
    fn set_inflections_to_zero_curvature(&mut self, sub: &Subcurve<'_>, joints: impl Iterator<Item = usize>) -> bool {
        let mut any = false;
        for i in joints {
            let next = sub.next_index(i);
            let turns = self.given_quantities[i].normal.dot(self.given_quantities[next].normal) > 0.0;
            if !self.has_zero_curvature[i]
                && (!turns || self.is_polygon_straight_at(sub, i) || self.is_polygon_straight_at(sub, next))
            {
                self.set_curvature_to_zero(sub, i);
                any = true;
            }
        }
        any
    }

    /// Returns true if the polygon is straight at control point `i`, up to rounding.
    fn is_polygon_straight_at(&self, sub: &Subcurve<'_>, i: usize) -> bool {
        let [before, after] = legs_at_control_point(sub, &self.nodes, i);
        let lengths = before.length() * after.length() * (before + after).length();
        let faint = 2.0 * before.cross(after).length() * sub.outline_size < MIN_SIGNIFICANT_CURVATURE * lengths;
        let error = relative_triangle_area_rounding(sub, &self.nodes, i);
        error.is_nan()
            || error > if faint { MAX_RELATIVE_AREA_ROUNDING_OF_FAINT_BEND } else { MAX_RELATIVE_AREA_ROUNDING_OF_BEND }
    }

    /// Sets the curvature at a joint to 0.
    fn set_curvature_to_zero(&mut self, sub: &Subcurve<'_>, joint: usize) {
        self.has_zero_curvature[joint] = true;
        self.nodes[joint].handles[0] = 1.0;
        self.nodes[sub.next_index(joint)].handles[1] = 1.0;
    }

    /// Sets the curvature at all joints to 0, with middle joints and the parameters of the data.
    /// The equations of the control points are then diagonally dominant.
    fn set_all_curvatures_to_zero(&mut self, sub: &Subcurve<'_>, solution: &mut CompositeSolution) {
        for i in 0..self.nodes.len() {
            self.nodes[i].t = solution.parameters_by_data_triangles[i];
            self.given_quantities[i].lock_equation = LockEquation::GivenParameter;
            if self.given_quantities[i].is_unknown[0] {
                self.nodes[i].beta = 0.5;
            }
        }
        for i in inner_joints(sub) {
            self.is_given_up_joint[i] |= !self.has_zero_curvature[i];
            self.set_curvature_to_zero(sub, i);
        }
        self.choose_equations_and_unknowns(sub);
        self.solve_control_points_again(sub, solution);
    }

    /// Computes the side to which the polygon turns at a point.
    fn find_turn_normal(&mut self, sub: &Subcurve<'_>, i: usize) {
        let [before, after] = legs_at_control_point(sub, &self.nodes, i);
        self.given_quantities[i].normal = before.cross(after).normalize_or_zero();
    }

    /// Determines which joints have equations, and which unknowns they contain.
    fn choose_equations_and_unknowns(&mut self, sub: &Subcurve<'_>) {
        let joints = inner_joints(sub);
        let curved = |joint: usize| joints.contains(&joint) && !self.has_zero_curvature[joint];
        for (i, known) in self.given_quantities.iter_mut().enumerate() {
            let behind = curved(i);
            let beside = behind || ((sub.closed || i > 0) && curved(sub.previous_index(i)));
            let [lambda, mu] = self.nodes[i].handles.map(|handle| beside && handle < 1.0);
            (known.curved, known.is_unknown) = (behind, [behind, lambda, mu]);
        }
    }

    /// Solves for the control points again, so that the curve passes the points. Returns false if
    /// the equations are singular.
    fn solve_control_points_again(&mut self, sub: &Subcurve<'_>, solution: &mut CompositeSolution) -> bool {
        for (i, node) in self.nodes.iter().enumerate() {
            (solution.point_parameters[i], solution.betas[i], solution.handles[i]) = (node.t, node.beta, node.handles);
        }
        let regular = control_equations::solve_control_points(sub, solution);
        self.nodes.iter_mut().zip(&solution.controls).for_each(|(node, &control)| node.control = control);
        regular
    }

    /// Returns true if the curve passes its points.
    fn passes_all_points(&self, sub: &Subcurve<'_>, solution: &CompositeSolution) -> bool {
        sub.section_indices().all(|i| {
            let corners =
                [solution.joint_point(sub, sub.previous_index(i)), solution.controls[i], solution.joint_point(sub, i)];
            let shares = control_equations::cubic_section_weights(solution.point_parameters[i], solution.handles[i]);
            let at: DVec3 = corners.iter().zip(shares).map(|(&corner, share)| (corner - sub.points[i]) * share).sum();
            at.length() <= MAX_POINT_MISS_DISTANCE * sub.outline_size
        })
    }

    /// Iterates until all equations hold.
    fn iterate_until_converged(
        &mut self,
        sub: &Subcurve<'_>,
        solution: &mut CompositeSolution,
        out: &mut SubcurveOutput<'_>,
    ) -> Result<()> {
        let mut in_round = 0;
        let mut do_all_hold = self.evaluate_all_equations(sub, out.job)?;
        while !do_all_hold {
            if out.report.iterations >= sub.options.max_sweeps {
                break;
            }
            self.choose_windows(sub)?;
            if in_round == MAX_ITERATIONS_PER_ROUND {
                in_round = 0;
                self.give_up_worst_equations(sub, solution, out);
            }
            in_round += 1;
            out.report.count_iteration();
            let mut moved = 0.0_f64;
            for &window in &self.windows_of_next_step {
                let newton = &mut self.newton;
                moved = moved.max(newton.take_damped_step(
                    sub,
                    &self.given_quantities,
                    &mut self.nodes,
                    window,
                    out.job,
                )?);
            }
            out.report.record_cycle(moved / sub.outline_size, self.nodes.iter().map(|node| &node.control))?;
            do_all_hold = self.evaluate_equations(sub, out.job)?;
        }
        Ok(())
    }

    /// Makes windows around the points whose equations do not hold.
    fn choose_windows(&mut self, sub: &Subcurve<'_>) -> Result<()> {
        let (n, closed) = (sub.len(), sub.closed);
        let mut windows = std::mem::take(&mut self.windows_of_next_step);
        windows.clear();
        // Windows keep apart, so that the equations of one do not have unknowns of another.
        let are_near = |end: usize, next: usize| next <= end + 2 * MAX_STEP_REACH;
        for i in 0..n {
            if self.residuals_in_tolerances(sub, i).iter().all(|&rest| rest <= 1.0) {
                continue;
            }
            let [first, end] = match closed {
                true => [i + n - MAX_STEP_REACH.min(n), i + n + MAX_STEP_REACH + 1],
                false => [i.saturating_sub(MAX_STEP_REACH), (i + MAX_STEP_REACH + 1).min(n)],
            };
            match windows.last_mut() {
                Some(last) if are_near(last.first_point + last.point_count, first) => {
                    last.point_count = end - last.first_point;
                }
                _ => alloc::push(&mut windows, PointWindow { first_point: first, point_count: end - first })?,
            }
        }
        if let (true, [first, .., last]) = (closed, &mut windows[..])
            && are_near(last.first_point + last.point_count, first.first_point + n)
        {
            *first = PointWindow {
                first_point: last.first_point,
                point_count: first.first_point + n + first.point_count - last.first_point,
            };
            windows.pop();
        }
        let solved = windows.iter().map(|window| window.point_count + 2 * MAX_STEP_REACH).sum::<usize>();
        if solved >= n / 4 * 3 {
            windows.clear();
            alloc::push(&mut windows, PointWindow { first_point: 0, point_count: n })?;
        }
        windows.iter_mut().for_each(|window| window.first_point %= n);
        self.windows_of_next_step = windows;
        Ok(())
    }

    /// Evaluates all equations. Returns true if they hold.
    fn evaluate_all_equations(&mut self, sub: &Subcurve<'_>, job: &Job<'_>) -> Result<bool> {
        self.windows_of_next_step.clear();
        alloc::push(&mut self.windows_of_next_step, PointWindow { first_point: 0, point_count: sub.len() })?;
        self.evaluate_equations(sub, job)
    }

    /// Evaluates the equations that a step in the windows has changed. Returns true if they hold.
    fn evaluate_equations(&mut self, sub: &Subcurve<'_>, job: &Job<'_>) -> Result<bool> {
        let (mut all, mut any_flat, n) = (true, false, self.nodes.len());
        let windows = std::mem::take(&mut self.windows_of_next_step);
        let joints = inner_joints(sub);
        let affected = || windows.iter().flat_map(|window| window.points_with_margin(sub, POINTS_PER_EQUATION));
        affected().for_each(|i| self.find_turn_normal(sub, i));
        any_flat |= self.set_inflections_to_zero_curvature(sub, affected().filter(|i| joints.contains(i)));
        if any_flat {
            self.choose_equations_and_unknowns(sub);
        }
        for i in affected() {
            job.step_every(POINTS_PER_REPORT, i, n, PROGRESS_STAGE)?;
            self.equation_values[i] = evaluate_equations(sub, &self.given_quantities, &self.nodes, i);
            all &= self.residuals_in_tolerances(sub, i).iter().all(|&rest| rest <= 1.0);
        }
        self.windows_of_next_step = windows;
        Ok(all)
    }

    /// Returns the residuals of the equations of point `i`, in tolerances: the point, the lock and
    /// the curvature.
    fn residuals_in_tolerances(&self, sub: &Subcurve<'_>, i: usize) -> [f64; 3] {
        let (values, known) = (&self.equation_values[i], &self.given_quantities[i]);
        let rounding = 64.0 * f64::EPSILON * sub.outline_size / known.spacing;
        let tolerance = sub.options.tolerance.max(rounding);
        let miss = DVec3::new(values[0], values[1], values[2]).length();
        let mut gap = 0.0;
        if known.curved {
            let next = sub.next_index(i);
            let areas = relative_triangle_area_rounding(sub, &self.nodes, i)
                + relative_triangle_area_rounding(sub, &self.nodes, next);
            let handles = 1.0 / (1.0 - self.nodes[i].handles[0]) + 1.0 / (1.0 - self.nodes[next].handles[1]);
            gap = values[4].abs() / sub.options.tolerance.max(32.0 * (areas + f64::EPSILON * handles));
        }
        // A NaN counts as far away.
        [miss / tolerance, values[3].abs() / tolerance, gap]
            .map(|rest| if rest.is_nan() { f64::INFINITY } else { rest })
    }

    /// Gives up the worst equation of each point whose residual exceeds the tolerance and the
    /// residuals of its neighbours. The point keeps its given parameter, or its joints get zero
    /// curvature.
    fn give_up_worst_equations(
        &mut self,
        sub: &Subcurve<'_>,
        solution: &mut CompositeSolution,
        out: &mut SubcurveOutput<'_>,
    ) {
        let n = self.nodes.len();
        for i in 0..n {
            let worst = |k: usize| self.residuals_in_tolerances(sub, k).into_iter().fold(0.0, f64::max);
            let own = worst(i);
            let mut near = (1..=GIVEN_UP_NEIGHBOURS_PER_SIDE.min(n - 1)).flat_map(|d| [(i + d) % n, (i + n - d) % n]);
            self.has_unsolved_equations[i] = own > 1.0 && near.all(|k| worst(k) <= own);
        }
        for i in 0..n {
            if !self.has_unsolved_equations[i] {
                continue;
            }
            let [_, lock, gap] = self.residuals_in_tolerances(sub, i);
            if self.given_quantities[i].lock_equation != LockEquation::GivenParameter && lock >= gap {
                self.given_quantities[i].lock_equation = LockEquation::GivenParameter;
                self.nodes[i].t = solution.parameters_by_data_triangles[i];
                out.results[i].flag_status(PointStatus::FellBack);
                continue;
            }
            for joint in [sub.previous_index(i), i] {
                if self.given_quantities[joint].curved
                    && !self.has_zero_curvature[joint]
                    && (joint == i || !self.given_quantities[i].curved)
                {
                    self.set_curvature_to_zero(sub, joint);
                    self.is_given_up_joint[joint] = true;
                }
            }
        }
        self.choose_equations_and_unknowns(sub);
    }

    /// Sets the statuses of the points next to joints that differ from the requested ones.
    fn set_point_statuses(&self, sub: &Subcurve<'_>, out: &mut SubcurveOutput<'_>) {
        for i in 0..self.nodes.len() {
            let next = sub.next_index(i);
            let [_, lock, gap] = self.residuals_in_tolerances(sub, i);
            if lock > MAX_RESIDUAL_IN_TOLERANCES || gap > MAX_RESIDUAL_IN_TOLERANCES {
                out.report.status = FitStatus::NotConverged;
                out.results[i].flag_status(PointStatus::NotConverged);
            }
            let bent = self.given_quantities[i].curved
                && self.given_quantities[i].normal.cross(self.given_quantities[next].normal).length() > MAX_PLANE_SINE;
            let status = if gap > MAX_RESIDUAL_IN_TOLERANCES {
                PointStatus::NotConverged
            } else if self.is_given_up_joint[i] {
                PointStatus::JointFellBack
            } else if bent {
                PointStatus::OutOfPlane
            } else {
                continue;
            };
            [i, next].iter().for_each(|&k| out.results[k].flag_status(status));
        }
    }
}

/// Returns the relative rounding error of the doubled triangle area E_i = |e_(i-1) x e_i| that the
/// rounding of the control points causes.
fn relative_triangle_area_rounding(sub: &Subcurve<'_>, nodes: &[PointUnknowns], i: usize) -> f64 {
    let [before, after] = legs_at_control_point(sub, nodes, i);
    f64::EPSILON * sub.outline_size * (before.length() + after.length()) / before.cross(after).length()
}

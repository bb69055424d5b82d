//! Continuous curvature: sections that are cubics, joined G2.
//!
//! Section i is the cubic in the triangle (J_(i-1), B_i, J_i) with the handles lambda_i and mu_i,
//! see [`equations`]. With E_i = |(B_i - B_(i-1)) x (B_(i+1) - B_i)| and L_i = |B_(i+1) - B_i| it
//! has at its ends the curvatures
//!
//! 2/3 (1 - mu_i) beta_i E_i / (lambda_i^2 (1 - beta_(i-1))^2 L_(i-1)^3) and
//! 2/3 (1 - lambda_i) (1 - beta_(i-1)) E_i / (mu_i^2 beta_i^2 L_i^3).
//!
//! Why cubics, where the paper has quadratics: those have a curvature of one sign, which is nowhere
//! 0, so that it jumps wherever the polygon turns the other way; and for dense and even points
//! their joint parameters alone do not see a jump that alternates from joint to joint. With lambda
//! and mu there are three unknowns for each joint and one equation, and the solution nearest the
//! quadratics is sought: see newton. The points keep their parameters, and the lock holds.
//!
//! Where the polygon turns the other way behind a joint, lambda_i = mu_(i+1) = 1 make the curvature
//! 0 on both sides, whatever the polygon. So it is beside a straight section; and beside joints
//! whose equations have no solution near by, which makes the curvature of any plane outline
//! continuous in the end ([`PointStatus::JointFellBack`]). In space neighbouring sections are in
//! different planes, and the curvatures agree in magnitude.
//!
//! O(n) for each iteration, in time and memory.
//!
//! Source: de Boor, Hoellig and Sabin, High accuracy geometric Hermite interpolation, 1987, for
//! cubics by tangents and curvatures; Yan, Schiller, Wilensky, Carr and Schaefer, k-Curves, 2017,
//! for quadratics with continuous curvature.

mod newton;
mod system;

use super::equations;
use super::knot_joints::solve_with_fallback;
use super::lock::LockWorkspace;
use crate::identify::guide::plane_normal;
use crate::identify::identify_options::Lock;
use crate::identify::report::{FitStatus, PointStatus};
use crate::identify::solution::Solution;
use crate::identify::subcurve::{Output, Subcurve};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;
use newton::{LeastSteps, POINTS_PER_REPORT, STAGE};
use std::ops::Range;
use system::{EQUATIONS, Known, Node, Tie, evaluate, legs};

/// The handles of a quadratic.
const QUADRATIC: [f64; 2] = [2.0 / 3.0; 2];

/// Iterations after which the equations that hold up the others are given up.
const ITERATIONS_PER_ROUND: u32 = 12;

/// The relative error of E_i by rounding at which a section counts as straight in any case, and if
/// its curvature is below [`MIN_CURVATURE`]. Where points are dense all errors are large, and no
/// section is straight for that.
const MAX_AREA_ERROR: f64 = 1e-2;
const MAX_STRAIGHT_AREA_ERROR: f64 = 1e-8;

/// A curvature, times the size of the outline, that may be none.
const MIN_CURVATURE: f64 = 1e-2;

/// The rounds in which joints where the polygon turns the other way are found, as each changes the
/// polygon a little.
const MAX_INFLECTION_ROUNDS: u32 = 8;

/// Of the points that an equation is in trouble with, the worst of so many on each side gives way.
const TROUBLE_REACH: usize = 3;

/// How much more than the tolerance may be left of an equation once the points are on the curve.
const MAX_REST: f64 = 100.0;

/// The distance at which a curve passes its points, in sizes of the outline.
const MAX_MISS: f64 = 1e-14;

/// The sine of the angle between two planes that are one.
const MAX_PLANE_SINE: f64 = 1e-7;

/// The unknowns, and the memory of Newton's method.
#[derive(Default)]
pub(super) struct CurvatureJoints {
    nodes: Vec<Node>,
    known: Vec<Known>,
    values: Vec<[f64; EQUATIONS]>,
    /// Joints with the curvature 0, and those among them that have it for want of a solution.
    flat: Vec<bool>,
    given_up: Vec<bool>,
    /// Points whose equations are in trouble.
    in_trouble: Vec<bool>,
    newton: LeastSteps,
}

/// Finds the curve with continuous curvature.
pub(super) fn solve_by_curvatures(
    sub: &Subcurve<'_>,
    workspace: &mut LockWorkspace,
    joints: &mut CurvatureJoints,
    out: &mut Output<'_>,
) -> Result<()> {
    workspace.solution.reset_joints(sub.len())?;
    let locked = solve_with_fallback(sub, workspace, out)?;
    let solution = &mut workspace.solution;
    if inner_joints(sub).is_empty() {
        return Ok(());
    }
    joints.begin(sub, solution, locked)?;
    joints.find_inflections(sub, solution);
    joints.iterate(sub, solution, out)?;
    let sound = joints.polish(sub, solution) && joints.passes(sub, solution);
    if !sound {
        joints.flatten_all(sub, solution);
    }
    joints.measure(sub, out.job)?;
    joints.account(sub, out);
    Ok(())
}

/// The joints between two segments.
fn inner_joints(sub: &Subcurve<'_>) -> Range<usize> {
    let n = sub.len();
    match (sub.closed, sub.tangents) {
        (true, _) => 0..n,
        (false, [start, end]) => usize::from(start.is_none())..n - if end.is_some() { 1 } else { 2 },
    }
}

impl CurvatureJoints {
    /// Enters the curve with quadratic sections, whose points are on it; `locked`: whether any lock
    /// but that by parameter holds.
    fn begin(&mut self, sub: &Subcurve<'_>, solution: &mut Solution, locked: bool) -> Result<()> {
        let n = sub.len();
        alloc::reset(&mut solution.handles, n, QUADRATIC)?;
        alloc::reset(&mut self.nodes, n, Node::default())?;
        alloc::reset(&mut self.values, n, [0.0; EQUATIONS])?;
        for list in [&mut self.flat, &mut self.given_up, &mut self.in_trouble] {
            alloc::reset(list, n, false)?;
        }
        self.newton.begin(n)?;
        let by_parameter = !locked || sub.options.lock == Lock::Parameter;
        let plane = if by_parameter { None } else { plane_normal(sub) };
        let known = (0..n).map(|i| {
            let inner = sub.sections().contains(&i);
            let fallen = by_parameter || !inner || solution.fell_back[i] || solution.missed_guide[i];
            let tie = match (sub.options.lock, plane) {
                _ if fallen => Tie::Parameter,
                (Lock::SelfConsistent, _) => Tie::Triangle,
                (Lock::DataGuide, Some(normal)) => Tie::Guide(normal.cross(solution.guides[i])),
                _ => Tie::Parameter,
            };
            let [a, p, c] = sub.triple(i);
            let spacing = if inner { 0.5 * (a.distance(p) + p.distance(c)) } else { sub.size };
            Known { tie, spacing, normal: DVec3::ZERO, curved: false, fixed: !inner, free: [false; 3] }
        });
        self.known.clear();
        alloc::extend(&mut self.known, known)?;
        for (i, node) in self.nodes.iter_mut().enumerate() {
            let beta = Solution::joint_parameter(sub, &solution.beta, i);
            *node = Node { control: solution.controls[i], t: solution.t[i], beta, handles: QUADRATIC };
        }
        Ok(())
    }

    /// Makes the curvature 0 at all joints behind which the polygon turns the other way or not at
    /// all.
    fn find_inflections(&mut self, sub: &Subcurve<'_>, solution: &mut Solution) {
        for _ in 0..MAX_INFLECTION_ROUNDS {
            self.find_normals(sub);
            if !self.flatten_inflections(sub) {
                break;
            }
            self.polish(sub, solution);
        }
        self.find_unknowns(sub);
    }

    /// Makes the curvature 0 at the joints behind which the polygon as it is turns the other way or
    /// not at all. False if there are no more.
    fn flatten_inflections(&mut self, sub: &Subcurve<'_>) -> bool {
        let mut any = false;
        for i in inner_joints(sub) {
            let next = sub.next(i);
            let turns = self.known[i].normal.dot(self.known[next].normal) > 0.0;
            if !self.flat[i] && (!turns || self.is_straight(sub, i) || self.is_straight(sub, next)) {
                self.flatten(sub, i);
                any = true;
            }
        }
        any
    }

    /// Whether the polygon does not turn at control point `i`, but for rounding.
    fn is_straight(&self, sub: &Subcurve<'_>, i: usize) -> bool {
        let [before, after] = legs(sub, &self.nodes, i);
        let lengths = before.length() * after.length() * (before + after).length();
        let faint = 2.0 * before.cross(after).length() * sub.size < MIN_CURVATURE * lengths;
        let error = area_error(sub, &self.nodes, i);
        error.is_nan() || error > if faint { MAX_STRAIGHT_AREA_ERROR } else { MAX_AREA_ERROR }
    }

    /// Makes the curvature at a joint 0.
    fn flatten(&mut self, sub: &Subcurve<'_>, joint: usize) {
        self.flat[joint] = true;
        self.nodes[joint].handles[0] = 1.0;
        self.nodes[sub.next(joint)].handles[1] = 1.0;
    }

    /// Makes the curvature at all joints 0, with the joints in the middle and the parameters of the
    /// data: the equations of the control points have dominant rows then.
    fn flatten_all(&mut self, sub: &Subcurve<'_>, solution: &mut Solution) {
        for i in 0..self.nodes.len() {
            self.nodes[i].t = solution.data_t[i];
            self.known[i].tie = Tie::Parameter;
            if self.known[i].free[0] {
                self.nodes[i].beta = 0.5;
            }
        }
        for i in inner_joints(sub) {
            self.given_up[i] |= !self.flat[i];
            self.flatten(sub, i);
        }
        self.find_unknowns(sub);
        self.polish(sub, solution);
    }

    /// Enters the sides to which the polygon turns.
    fn find_normals(&mut self, sub: &Subcurve<'_>) {
        for i in 0..self.nodes.len() {
            let [before, after] = legs(sub, &self.nodes, i);
            self.known[i].normal = before.cross(after).normalize_or_zero();
        }
    }

    /// Enters the joints that have equations, and the unknowns in them.
    fn find_unknowns(&mut self, sub: &Subcurve<'_>) {
        let joints = inner_joints(sub);
        let curved = |joint: usize| joints.contains(&joint) && !self.flat[joint];
        for (i, known) in self.known.iter_mut().enumerate() {
            let behind = curved(i);
            let beside = behind || ((sub.closed || i > 0) && curved(sub.previous(i)));
            let [lambda, mu] = self.nodes[i].handles.map(|handle| beside && handle < 1.0);
            (known.curved, known.free) = (behind, [behind, lambda, mu]);
        }
    }

    /// Solves for the control points once more, so that the points are on the curve. False if the
    /// equations are singular.
    fn polish(&mut self, sub: &Subcurve<'_>, solution: &mut Solution) -> bool {
        for (i, node) in self.nodes.iter().enumerate() {
            (solution.t[i], solution.beta[i], solution.handles[i]) = (node.t, node.beta, node.handles);
        }
        let regular = equations::solve(sub, solution);
        self.nodes.iter_mut().zip(&solution.controls).for_each(|(node, &control)| node.control = control);
        regular
    }

    /// Whether the curve passes its points.
    fn passes(&self, sub: &Subcurve<'_>, solution: &Solution) -> bool {
        sub.sections().all(|i| {
            let corners = [solution.joint(sub, sub.previous(i)), solution.controls[i], solution.joint(sub, i)];
            let shares = equations::weights(solution.t[i], solution.handles[i]);
            let at: DVec3 = corners.iter().zip(shares).map(|(&corner, share)| (corner - sub.points[i]) * share).sum();
            at.length() <= MAX_MISS * sub.size
        })
    }

    /// Steps until all equations hold.
    fn iterate(&mut self, sub: &Subcurve<'_>, solution: &mut Solution, out: &mut Output<'_>) -> Result<()> {
        let mut in_round = 0;
        while !self.measure(sub, out.job)? {
            if out.report.iterations >= sub.options.max_sweeps {
                break;
            }
            if in_round == ITERATIONS_PER_ROUND {
                in_round = 0;
                self.give_up(sub, solution, out);
            }
            in_round += 1;
            out.report.iterations += 1;
            let moved = self.newton.step(sub, &self.known, &mut self.nodes, out.job)?;
            out.report.end_cycle(moved / sub.size)?;
        }
        Ok(())
    }

    /// Evaluates all equations; whether they hold.
    fn measure(&mut self, sub: &Subcurve<'_>, job: &Job<'_>) -> Result<bool> {
        self.find_normals(sub);
        if self.flatten_inflections(sub) {
            self.find_unknowns(sub);
        }
        let (mut all, n) = (true, self.nodes.len());
        for i in 0..n {
            job.step_every(POINTS_PER_REPORT, i, n, STAGE)?;
            self.values[i] = evaluate(sub, &self.known, &self.nodes, i);
            all &= self.rests(sub, i).iter().all(|&rest| rest <= 1.0);
        }
        Ok(all)
    }

    /// What is left of the equations of point `i`, of the point, the lock and the curvature, in
    /// tolerances.
    fn rests(&self, sub: &Subcurve<'_>, i: usize) -> [f64; 3] {
        let (values, known) = (&self.values[i], &self.known[i]);
        let rounding = 64.0 * f64::EPSILON * sub.size / known.spacing;
        let tolerance = sub.options.tolerance.max(rounding);
        let miss = DVec3::new(values[0], values[1], values[2]).length();
        let mut gap = 0.0;
        if known.curved {
            let next = sub.next(i);
            let areas = area_error(sub, &self.nodes, i) + area_error(sub, &self.nodes, next);
            let handles = 1.0 / (1.0 - self.nodes[i].handles[0]) + 1.0 / (1.0 - self.nodes[next].handles[1]);
            gap = values[4].abs() / sub.options.tolerance.max(32.0 * (areas + f64::EPSILON * handles));
        }
        // What is not a number is far from any.
        [miss / tolerance, values[3].abs() / tolerance, gap]
            .map(|rest| if rest.is_nan() { f64::INFINITY } else { rest })
    }

    /// Gives up the equations that hold up the others: the worst of each neighbourhood.
    fn give_up(&mut self, sub: &Subcurve<'_>, solution: &mut Solution, out: &mut Output<'_>) {
        let n = self.nodes.len();
        for i in 0..n {
            let worst = |k: usize| self.rests(sub, k).into_iter().fold(0.0, f64::max);
            let own = worst(i);
            let mut near = (1..=TROUBLE_REACH.min(n - 1)).flat_map(|d| [(i + d) % n, (i + n - d) % n]);
            self.in_trouble[i] = own > 1.0 && near.all(|k| worst(k) <= own);
        }
        for i in 0..n {
            if !self.in_trouble[i] {
                continue;
            }
            let [_, lock, gap] = self.rests(sub, i);
            if self.known[i].tie != Tie::Parameter && lock >= gap {
                self.known[i].tie = Tie::Parameter;
                self.nodes[i].t = solution.data_t[i];
                out.results[i].flag(PointStatus::FellBack);
                continue;
            }
            for joint in [sub.previous(i), i] {
                if self.known[joint].curved && !self.flat[joint] && (joint == i || !self.known[i].curved) {
                    self.flatten(sub, joint);
                    self.given_up[joint] = true;
                }
            }
        }
        self.find_unknowns(sub);
    }

    /// Enters the statuses of the points beside joints that are not as asked.
    fn account(&self, sub: &Subcurve<'_>, out: &mut Output<'_>) {
        for i in 0..self.nodes.len() {
            let next = sub.next(i);
            let [_, lock, gap] = self.rests(sub, i);
            if lock > MAX_REST || gap > MAX_REST {
                out.report.status = FitStatus::NotConverged;
                out.results[i].flag(PointStatus::NotConverged);
            }
            let bent =
                self.known[i].curved && self.known[i].normal.cross(self.known[next].normal).length() > MAX_PLANE_SINE;
            let status = if gap > MAX_REST {
                PointStatus::NotConverged
            } else if self.given_up[i] {
                PointStatus::JointFellBack
            } else if bent {
                PointStatus::OutOfPlane
            } else {
                continue;
            };
            [i, next].iter().for_each(|&k| out.results[k].flag(status));
        }
    }
}

/// The relative error of E_i by the rounding of the control points.
fn area_error(sub: &Subcurve<'_>, nodes: &[Node], i: usize) -> f64 {
    let [before, after] = legs(sub, nodes, i);
    f64::EPSILON * sub.size * (before.length() + after.length()) / before.cross(after).length()
}

//! Joint parameters by curvatures.
//!
//! With D_i the area of the triangle of B_(i-1), B_i and B_(i+1), the sections i and i+1 arrive at
//! and leave J_i with the curvatures (1 - beta_(i-1)) D_i / (beta_i^2 L^3) and beta_(i+1) D_(i+1) /
//! ((1 - beta_i)^2 L^3), where L = |B_i B_(i+1)|. They agree if
//!
//! beta_i = sqrt((1 - beta_(i-1)) D_i) / (sqrt((1 - beta_(i-1)) D_i) + sqrt(beta_(i+1) D_(i+1))).
//!
//! The roots of D_i and D_(i+1) alone, as one reads at times, would do for equal joint parameters
//! only. Where the polygon turns the other way behind the joint, the curvatures are equal in
//! magnitude and opposite in sign.
//!
//! The right side, for the control points that the joint parameters beta give, is a map w(beta); a
//! fixed point w(beta) = beta is sought. To iterate the map takes hundreds of rounds where the
//! points are dense. Newton's method takes the derivatives of w by differences: a joint parameter
//! has little influence on joints more than [`INFLUENCE`] away, so those 2 INFLUENCE + 1 apart are
//! varied together (Curtis, Powell and Reid, 1974). O(n) for each iteration, in time and memory.
//!
//! No solution is guaranteed. Even and dense points have their parameters near 1/2, and curvatures
//! that are continuous and change steadily along each section, as those of a cubic spline given in
//! the middle of its spans: such a spline does not see an error that alternates in sign. Joint
//! parameters that do not converge are the best found, and the points beside them
//! [`PointStatus::NotConverged`].
//!
//! Source: Yan, Schiller, Wilensky, Carr and Schaefer, k-Curves, 2017, for joint parameters by
//! areas.

use super::equations;
use super::knot_joints::solve_with_fallback;
use super::lock::LockWorkspace;
use crate::alloc;
use crate::error::Result;
use crate::outline::identify::report::{FitStatus, PointStatus};
use crate::outline::identify::solution::Solution;
use crate::outline::identify::subcurve::{Output, PointResult, Subcurve};
use std::ops::Range;

/// Joint parameters are between this and 1 less this.
const MIN_JOINT_PARAMETER: f64 = 1.0 / 16.0;

/// The sine of an angle that counts as none: the area is rounding.
const MIN_TURN_SINE: f64 = 1e-9;

/// The number of joints over which a joint parameter has influence.
const INFLUENCE: usize = 3;

/// The width of the band of derivatives: the diagonal and both sides.
const BAND: usize = 2 * INFLUENCE + 1;

/// The rows of a closed subcurve that are repeated before its first and after its last: the
/// influence of those farther away makes the step inexact, but not the solution.
const OVERLAP: usize = 24;

/// The variation of a joint parameter for the differences.
const VARIATION: f64 = 1e-6;

/// The largest change of a joint parameter in one step of Newton's method.
const MAX_STEP: f64 = 0.2;

/// Rounds without progress after which Newton's method is left.
const MAX_STALE_ROUNDS: u32 = 24;

/// The memory of Newton's method for the joint parameters, one of each for every joint.
#[derive(Default)]
pub(super) struct JointNewton {
    /// The joints whose parameters are free.
    joints: Range<usize>,
    /// w(beta) - beta.
    residual: Vec<f64>,
    previous: Vec<f64>,
    best: Vec<f64>,
    /// The derivatives of residual i by the joint parameters from i - INFLUENCE to i + INFLUENCE.
    rows: Vec<[f64; BAND]>,
    /// The rows with their overlap, while they are eliminated, and the right sides.
    system: Vec<([f64; BAND], f64)>,
}

/// Finds the curve with joints by curvatures.
pub(super) fn solve_by_curvatures(
    sub: &Subcurve<'_>,
    workspace: &mut LockWorkspace,
    newton: &mut JointNewton,
    out: &mut Output<'_>,
) -> Result<()> {
    workspace.solution.reset_joints(sub.len())?;
    solve_with_fallback(sub, workspace, out)?;
    newton.begin(sub)?;
    if newton.joints.is_empty() {
        return Ok(());
    }
    let tolerance = sub.options.tolerance.max(4.0 * f64::EPSILON);
    newton.iterate(sub, workspace, tolerance, out)?;
    // The curve is smooth and passes its points with any joint parameters: those that still move
    // keep the best found.
    if out.report.last_move > tolerance {
        workspace.solution.beta[..sub.len()].copy_from_slice(&newton.best);
        solve_with_fallback(sub, workspace, out)?;
    }
    for i in newton.joints.clone() {
        let (target, beta) = (target(sub, &workspace.solution, i), workspace.solution.beta[i]);
        let status = if (clamped(target) - beta).abs() > 10.0 * tolerance {
            out.report.status = FitStatus::NotConverged;
            PointStatus::NotConverged
        } else if clamped(target) != target {
            PointStatus::FellBack
        } else {
            continue;
        };
        [i, sub.next(i)].iter().for_each(|&k| out.results[k].flag(status));
    }
    Ok(())
}

/// A joint parameter within the limits.
fn clamped(beta: f64) -> f64 {
    beta.clamp(MIN_JOINT_PARAMETER, 1.0 - MIN_JOINT_PARAMETER)
}

/// w(beta) at joint `i`: its parameter by the control points and the other joint parameters as they
/// are.
fn target(sub: &Subcurve<'_>, solution: &Solution, i: usize) -> f64 {
    let n = sub.len();
    let at = |k: usize| (i + k) % n;
    let [a, b, c, d] = [n - 1, 0, 1, 2].map(|k| solution.controls[at(k)]);
    let [before, after] = [n - 1, 1].map(|k| Solution::joint_parameter(sub, &solution.beta, at(k)));
    let [u, v, w] = [b - a, c - b, d - c];
    let [here, there] = [(u, v), (v, w)].map(|(u, v)| u.cross(v).length().max(MIN_TURN_SINE * u.length() * v.length()));
    let [here, there] = [(1.0 - before) * here, after * there].map(f64::sqrt);
    if here + there > 0.0 { here / (here + there) } else { 0.5 }
}

/// w(beta) - beta at joint `i`; 0 where a point has fallen back.
fn residual(sub: &Subcurve<'_>, solution: &Solution, results: &[PointResult], i: usize) -> f64 {
    let beta = solution.beta[i];
    match [i, sub.next(i)].iter().any(|&k| results[k].status == PointStatus::FellBack) {
        // Its joint parameter has no influence on it, but the row must not be empty.
        true => 0.5 - beta,
        false => clamped(target(sub, solution, i)) - beta,
    }
}

impl JointNewton {
    fn begin(&mut self, sub: &Subcurve<'_>) -> Result<()> {
        let n = sub.len();
        self.joints = if sub.closed { 0..n } else { 1..n.saturating_sub(2).max(1) };
        for list in [&mut self.residual, &mut self.previous, &mut self.best] {
            alloc::reset(list, n, 0.0)?;
        }
        alloc::reset(&mut self.rows, n, [0.0; BAND])?;
        self.system.clear();
        alloc::reserve(&mut self.system, n + 2 * OVERLAP)
    }

    /// Iterates until the joint parameters rest; keeps the best on the way.
    fn iterate(
        &mut self,
        sub: &Subcurve<'_>,
        workspace: &mut LockWorkspace,
        tolerance: f64,
        out: &mut Output<'_>,
    ) -> Result<()> {
        let n = sub.len();
        let (mut smallest, mut by_map) = (f64::INFINITY, false);
        let (mut best, mut stale) = (f64::INFINITY, 0);
        for _ in 0..sub.options.max_sweeps {
            let (farthest, sum) = self.measure(sub, &workspace.solution, out.results);
            out.report.last_move = farthest;
            if sum < best {
                stale = if sum < 0.5 * best && stale < MAX_STALE_ROUNDS { 0 } else { stale + 1 };
                best = sum;
                self.best.copy_from_slice(&workspace.solution.beta[..n]);
            } else {
                stale += 1;
            }
            if farthest <= tolerance {
                break;
            }
            out.report.iterations += 1;
            // Newton's method, unless it has just made the sum larger: then the map itself once.
            // Without progress for long the map itself, from the best on.
            let gives_up = stale == MAX_STALE_ROUNDS;
            by_map = stale >= MAX_STALE_ROUNDS || (!by_map && sum > smallest);
            let solution = &mut workspace.solution;
            if gives_up || (by_map && stale < MAX_STALE_ROUNDS) {
                solution.beta[..n].copy_from_slice(if gives_up { &self.best } else { &self.previous });
                equations::solve(sub, solution);
                self.measure(sub, solution, out.results);
            }
            smallest = if by_map { f64::INFINITY } else { sum };
            self.previous.copy_from_slice(&solution.beta[..n]);
            if by_map || !self.step(sub, solution, out.results) {
                self.joints.clone().for_each(|i| solution.beta[i] = self.previous[i] + self.residual[i]);
            }
            solve_with_fallback(sub, workspace, out)?;
        }
        Ok(())
    }

    /// Enters w(beta) - beta; the largest, and the sum of the squares. Joints of points that have
    /// fallen back stay where they are.
    fn measure(&mut self, sub: &Subcurve<'_>, solution: &Solution, results: &[PointResult]) -> (f64, f64) {
        let (mut farthest, mut sum) = (0.0f64, 0.0);
        for i in self.joints.clone() {
            self.residual[i] = residual(sub, solution, results, i);
            farthest = farthest.max(self.residual[i].abs());
            sum += self.residual[i] * self.residual[i];
        }
        (farthest, sum)
    }

    /// One step of Newton's method from the previous joint parameters, with the parameters as they
    /// are. False if the equations are singular.
    fn step(&mut self, sub: &Subcurve<'_>, solution: &mut Solution, results: &[PointResult]) -> bool {
        self.differentiate(sub, solution, results);
        if !self.eliminate(sub) {
            return false;
        }
        let n = sub.len();
        for (k, i) in self.order(sub).enumerate() {
            let inner = !sub.closed || (OVERLAP..OVERLAP + n).contains(&k);
            if inner {
                let step = self.system[k].1.clamp(-MAX_STEP, MAX_STEP);
                solution.beta[i] = clamped(self.previous[i] + step);
            }
        }
        true
    }

    /// Enters the derivatives of the residuals by differences, for all joints of one colour at
    /// once.
    fn differentiate(&mut self, sub: &Subcurve<'_>, solution: &mut Solution, results: &[PointResult]) {
        let n = sub.len();
        let joints = self.joints.clone();
        // Joints of one colour are BAND apart or more, round the end of a closed subcurve too.
        let whole = n - n % BAND;
        let colour_of = |i: usize| if i < whole { i % BAND } else { BAND + i - whole };
        let reach = INFLUENCE.min((n - 1) / 2);
        self.rows.fill([0.0; BAND]);
        for colour in 0..BAND + n - whole {
            let mut any = false;
            for i in joints.clone().filter(|&i| colour_of(i) == colour) {
                solution.beta[i] += VARIATION;
                any = true;
            }
            if !any {
                continue;
            }
            equations::solve(sub, solution);
            for j in joints.clone().filter(|&j| colour_of(j) == colour) {
                for offset in 0..=2 * reach {
                    // Row i = j - reach + offset; joint j is reach - offset from it.
                    let Some(i) = neighbour(sub, j, offset, reach).filter(|i| joints.contains(i)) else { continue };
                    let slope = (residual(sub, solution, results, i) - self.residual[i]) / VARIATION;
                    self.rows[i][INFLUENCE + reach - offset] = slope;
                }
            }
            solution.beta[..n].copy_from_slice(&self.previous);
        }
    }

    /// The joints in their order, those of a closed subcurve with their overlap.
    fn order(&self, sub: &Subcurve<'_>) -> impl Iterator<Item = usize> + use<> {
        let n = sub.len();
        let (from, count) = match sub.closed {
            true => (n * OVERLAP.div_ceil(n) - OVERLAP, n + 2 * OVERLAP),
            false => (self.joints.start, self.joints.len()),
        };
        (from..from + count).map(move |i| i % n)
    }

    /// Solves the banded equations rows * step = -residual. False if they are singular.
    fn eliminate(&mut self, sub: &Subcurve<'_>) -> bool {
        self.system.clear();
        for i in self.order(sub) {
            self.system.push((self.rows[i], -self.residual[i]));
        }
        let count = self.system.len();
        for k in 0..count {
            let (pivot, right) = self.system[k];
            if pivot[INFLUENCE].is_nan() || pivot[INFLUENCE].abs() < 1e-6 {
                return false;
            }
            for down in 1..=INFLUENCE.min(count - 1 - k) {
                let (row, value) = &mut self.system[k + down];
                let factor = row[INFLUENCE - down] / pivot[INFLUENCE];
                for c in 0..=INFLUENCE {
                    row[INFLUENCE - down + c] -= factor * pivot[INFLUENCE + c];
                }
                *value -= factor * right;
            }
        }
        for k in (0..count).rev() {
            let (row, mut value) = self.system[k];
            for up in 1..=INFLUENCE.min(count - 1 - k) {
                value -= row[INFLUENCE + up] * self.system[k + up].1;
            }
            self.system[k].1 = value / row[INFLUENCE];
        }
        self.system.iter().all(|(_, step)| step.is_finite())
    }
}

/// Joint j - reach + offset, if there is one.
fn neighbour(sub: &Subcurve<'_>, j: usize, offset: usize, reach: usize) -> Option<usize> {
    let n = sub.len();
    match sub.closed {
        true => Some((j + n - reach + offset) % n),
        false => (j + offset).checked_sub(reach).filter(|&i| i < n),
    }
}

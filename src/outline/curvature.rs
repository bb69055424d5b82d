//! The joints of composite curves by curvatures.
//!
//! With D_i the area of the triangle of B_(i-1), B_i and B_(i+1), the sections i and i+1 arrive at and leave J_i with the
//! curvatures (1 - beta_(i-1)) D_i / (beta_i^2 L^3) and beta_(i+1) D_(i+1) / ((1 - beta_i)^2 L^3), where L = |B_i B_(i+1)|.
//! They agree if
//!
//! beta_i = sqrt((1 - beta_(i-1)) D_i) / (sqrt((1 - beta_(i-1)) D_i) + sqrt(beta_(i+1) D_(i+1))).
//!
//! The roots of D_i and D_(i+1) alone, as one reads at times, would do for equal shares only. Where the polygon turns the other
//! way behind the joint, the curvatures are as large as each other, but have different signs.
//!
//! The right side, for the control points that the shares beta give, is a map w(beta); we look for w(beta) = beta. To apply
//! the map again and again takes hundreds of rounds where the points are dense. Newton's method takes the derivatives of w by
//! differences: a share has little influence on what is more than REACH joints away, so that the shares of joints 2 REACH + 1
//! apart are varied together.
//!
//! Nothing is said here of whether there is a solution. Even and dense points have their parameters near 1/2, and curvatures
//! that are continuous and change steadily along each section, as those of a cubic spline that is given in the middle of its
//! spans: such a spline does not see an error that changes sign from point to point. Shares that find no rest are the best
//! that were found, and the points beside them [`PointStatus::NotConverged`].
//!
//! Source: Yan, Schiller, Wilensky, Carr and Schaefer, k-Curves, 2017, for the shares by areas.

use super::composite;
use super::joints::{begin, settle};
use super::request::{FitStatus, Options, PointStatus, Report};
use super::run::{Run, Solution, Solved, Workspace, mark};
use crate::alloc;
use crate::error::Result;
use std::ops::Range;

/// Shares are between this and 1 less this.
const LEAST: f64 = 1.0 / 16.0;

/// The sine of an angle that counts as none: the area is rounding.
const FLAT: f64 = 1e-9;

/// How many joints away a share has influence on another.
const REACH: usize = 3;

/// The diagonal and what is beside it.
const BAND: usize = 2 * REACH + 1;

/// The rows of a closed run that are taken once more before its first and after its last: what is left of the influence of
/// those farther away makes the step inexact, but not the solution.
const OVERLAP: usize = 24;

/// By how much shares are varied for the differences.
const VARIATION: f64 = 1e-6;

/// The farthest that Newton's method may move a share at once.
const STRIDE: f64 = 0.2;

/// Rounds without progress after which Newton's method is left.
const PATIENCE: u32 = 24;

/// The workspace of Newton's method for the shares, one of each for every joint.
#[derive(Default)]
pub(super) struct Shares {
    /// w(beta) - beta.
    left: Vec<f64>,
    kept: Vec<f64>,
    best: Vec<f64>,
    /// The derivatives of `left` i by the shares from i - REACH to i + REACH.
    rows: Vec<[f64; BAND]>,
    /// The rows with their overlap, while they are eliminated, and the right sides.
    work: Vec<([f64; BAND], f64)>,
}

/// Finds the curve with joints by curvatures.
pub(super) fn curvatures(
    run: &Run<'_>,
    options: &Options,
    solved: &mut [Solved],
    workspace: &mut Workspace,
    report: &mut Report,
) -> Result<()> {
    begin(run, &mut workspace.solution)?;
    settle(run, options, solved, workspace, report)?;
    let n = run.points.len();
    let joints = if run.closed { 0..n } else { 1..n.saturating_sub(2).max(1) };
    if joints.is_empty() {
        return Ok(());
    }
    workspace.shares.begin(n)?;
    let tolerance = options.tolerance.max(4.0 * f64::EPSILON);
    let (mut least, mut plain) = (f64::INFINITY, false);
    let (mut best, mut stale) = (f64::INFINITY, 0);
    for _ in 0..options.max_sweeps {
        let (farthest, worth) = workspace.shares.measure(run, &workspace.solution, solved, joints.clone());
        report.last_move = farthest;
        if worth < best {
            stale = if worth < 0.5 * best && stale < PATIENCE { 0 } else { stale + 1 };
            best = worth;
            workspace.shares.best.copy_from_slice(&workspace.solution.beta[..n]);
        } else {
            stale += 1;
        }
        if farthest <= tolerance {
            break;
        }
        report.iterations += 1;
        // Newton's method, unless it has just made things worse: then the map itself once. Without progress for long the map
        // itself, from the best on.
        let gives_up = stale == PATIENCE;
        plain = stale >= PATIENCE || (!plain && worth > least);
        let Workspace { shares, solution, .. } = workspace;
        if gives_up || (plain && stale < PATIENCE) {
            solution.beta[..n].copy_from_slice(if gives_up { &shares.best } else { &shares.kept });
            composite::solve(run, solution);
            shares.measure(run, solution, solved, joints.clone());
        }
        least = if plain { f64::INFINITY } else { worth };
        shares.kept.copy_from_slice(&solution.beta[..n]);
        if plain || !shares.newton(run, solution, solved, joints.clone())? {
            joints.clone().for_each(|i| solution.beta[i] = shares.kept[i] + shares.left[i]);
        }
        settle(run, options, solved, workspace, report)?;
    }
    // The curve is smooth and passes its points with any shares: those that still move keep the best that was found.
    if report.last_move > tolerance {
        workspace.solution.beta[..n].copy_from_slice(&workspace.shares.best);
        settle(run, options, solved, workspace, report)?;
    }
    let next = |i: usize| if i + 1 == n { 0 } else { i + 1 };
    for i in joints {
        let (share, beta) = (wanted(run, &workspace.solution, i), workspace.solution.beta[i]);
        if (share.clamp(LEAST, 1.0 - LEAST) - beta).abs() > 10.0 * tolerance {
            report.status = FitStatus::NotConverged;
            [i, next(i)].iter().for_each(|&k| mark(&mut solved[k], PointStatus::NotConverged));
        } else if !(LEAST..=1.0 - LEAST).contains(&share) {
            [i, next(i)].iter().for_each(|&k| mark(&mut solved[k], PointStatus::FellBack));
        }
    }
    Ok(())
}

/// The share that joint `i` should have for the control points and the other shares as they are.
fn wanted(run: &Run<'_>, solution: &Solution, i: usize) -> f64 {
    let n = run.points.len();
    let at = |k: usize| (i + k) % n;
    let [a, b, c, d] = [n - 1, 0, 1, 2].map(|k| solution.controls[at(k)]);
    let (before, after) = (solution.share(run, at(n - 1)), solution.share(run, at(1)));
    let [u, v, w] = [b - a, c - b, d - c];
    let [here, there] = [(u, v), (v, w)].map(|(u, v)| u.cross(v).length().max(FLAT * u.length() * v.length()));
    let [here, there] = [(1.0 - before) * here, after * there].map(f64::sqrt);
    if here + there > 0.0 { here / (here + there) } else { 0.5 }
}

impl Shares {
    fn begin(&mut self, n: usize) -> Result<()> {
        for list in [&mut self.left, &mut self.kept, &mut self.best] {
            list.clear();
            alloc::reserve(list, n)?;
            list.resize(n, 0.0);
        }
        self.rows.clear();
        alloc::reserve(&mut self.rows, n)?;
        self.rows.resize(n, [0.0; BAND]);
        self.work.clear();
        alloc::reserve(&mut self.work, n + 2 * OVERLAP)
    }

    /// Enters w(beta) - beta; the largest, and the sum of the squares. Joints of points that have fallen back stay where they
    /// are.
    fn measure(&mut self, run: &Run<'_>, solution: &Solution, solved: &[Solved], joints: Range<usize>) -> (f64, f64) {
        let (mut farthest, mut sum) = (0.0f64, 0.0);
        for i in joints {
            self.left[i] = left(run, solution, solved, i);
            farthest = farthest.max(self.left[i].abs());
            sum += self.left[i] * self.left[i];
        }
        (farthest, sum)
    }

    /// One step of Newton's method from the shares that are kept, with the parameters as they are. False if the equations are
    /// singular.
    fn newton(
        &mut self,
        run: &Run<'_>,
        solution: &mut Solution,
        solved: &[Solved],
        joints: Range<usize>,
    ) -> Result<bool> {
        let n = run.points.len();
        // Joints of one colour are BAND apart or more, round the end of a closed run too.
        let whole = n - n % BAND;
        let colour = |i: usize| if i < whole { i % BAND } else { BAND + i - whole };
        let reach = REACH.min((n - 1) / 2);
        self.rows.fill([0.0; BAND]);
        for shade in 0..BAND + n - whole {
            let mut any = false;
            for i in joints.clone().filter(|&i| colour(i) == shade) {
                solution.beta[i] += VARIATION;
                any = true;
            }
            if !any {
                continue;
            }
            composite::solve(run, solution);
            for j in joints.clone().filter(|&j| colour(j) == shade) {
                for offset in 0..=2 * reach {
                    // Row i = j - reach + offset; share j is reach - offset from it.
                    let Some(i) = neighbour(run, j, offset, reach).filter(|i| joints.contains(i)) else { continue };
                    let slope = (left(run, solution, solved, i) - self.left[i]) / VARIATION;
                    self.rows[i][REACH + reach - offset] = slope;
                }
            }
            solution.beta[..n].copy_from_slice(&self.kept);
        }
        if !self.eliminate(run, &joints) {
            return Ok(false);
        }
        for (k, i) in self.places(run, &joints).enumerate() {
            let inner = !run.closed || (OVERLAP..OVERLAP + n).contains(&k);
            if inner {
                let step = self.work[k].1.clamp(-STRIDE, STRIDE);
                solution.beta[i] = (self.kept[i] + step).clamp(LEAST, 1.0 - LEAST);
            }
        }
        Ok(true)
    }

    /// The joints in their order, those of a closed run with their overlap.
    fn places(&self, run: &Run<'_>, joints: &Range<usize>) -> impl Iterator<Item = usize> + use<> {
        let n = run.points.len();
        let (from, count) = match run.closed {
            true => (n * OVERLAP.div_ceil(n) - OVERLAP, n + 2 * OVERLAP),
            false => (joints.start, joints.len()),
        };
        (from..from + count).map(move |i| i % n)
    }

    /// Solves the banded equations rows * step = -left. False if they are singular.
    fn eliminate(&mut self, run: &Run<'_>, joints: &Range<usize>) -> bool {
        self.work.clear();
        for i in self.places(run, joints) {
            self.work.push((self.rows[i], -self.left[i]));
        }
        let count = self.work.len();
        for k in 0..count {
            let (pivot, right) = self.work[k];
            if pivot[REACH].is_nan() || pivot[REACH].abs() < 1e-6 {
                return false;
            }
            for down in 1..=REACH.min(count - 1 - k) {
                let (row, value) = &mut self.work[k + down];
                let factor = row[REACH - down] / pivot[REACH];
                for c in 0..=REACH {
                    row[REACH - down + c] -= factor * pivot[REACH + c];
                }
                *value -= factor * right;
            }
        }
        for k in (0..count).rev() {
            let (row, mut value) = self.work[k];
            for up in 1..=REACH.min(count - 1 - k) {
                value -= row[REACH + up] * self.work[k + up].1;
            }
            self.work[k].1 = value / row[REACH];
        }
        self.work.iter().all(|(_, step)| step.is_finite())
    }
}

/// w(beta) - beta at joint `i`; 0 where a point has fallen back.
fn left(run: &Run<'_>, solution: &Solution, solved: &[Solved], i: usize) -> f64 {
    let next = if i + 1 == run.points.len() { 0 } else { i + 1 };
    let beta = solution.beta[i];
    match [i, next].iter().any(|&k| solved[k].status == PointStatus::FellBack) {
        // Its share has no influence on it, but the row must not be empty.
        true => 0.5 - beta,
        false => wanted(run, solution, i).clamp(LEAST, 1.0 - LEAST) - beta,
    }
}

/// Joint j - reach + offset, if there is one.
fn neighbour(run: &Run<'_>, j: usize, offset: usize, reach: usize) -> Option<usize> {
    let n = run.points.len();
    match run.closed {
        true => Some((j + n - reach + offset) % n),
        false => (j + offset).checked_sub(reach).filter(|&i| i < n),
    }
}

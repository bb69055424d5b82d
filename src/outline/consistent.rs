//! The self-consistent lock: the parameter of each point is that of the method on its section's own triangle.
//!
//! With the joints J_(i-1) and J_i on the control polygon, t_i = t(J_(i-1), P_i, J_i) is a function of B_(i-1), B_i and B_(i+1), and
//!
//! F_i = (1 - t_i)^2 J_(i-1) + 2 t_i (1 - t_i) B_i + t_i^2 J_i - P_i = 0
//!
//! are as many equations as unknowns. The derivative of F_i is the row of the linear equations, times the unit matrix, plus the
//! product of Q_i' = 2 ((1 - t) (B_i - J_(i-1)) + t (J_i - B_i)) and the gradient of t_i: a tridiagonal matrix of small blocks, and
//! Newton's step is one elimination. Parameters are kept within the limits, which makes the map of parameters to parameters (solve
//! for the control points, read off the parameters) continuous on a cube, so that it has a fixed point (Brouwer).
//!
//! A step that makes things worse is halved, and if that does not help, replaced by that map itself. Points that do not come
//! to rest keep the parameters of the data's own triangles.

use super::composite;
use super::method::{Method, power};
use super::request::{FitStatus, Options, PointStatus, Report};
use super::run::{Iteration, Room, Run, Solution, Solved, mark};
use crate::alloc;
use crate::error::Result;
use glam::DVec3;

/// Rows of a closed run that are taken before its first and after its last once more: the equations of a cyclic system fade by 0.2 or so
/// from row to row, and what is left of them makes Newton's step inexact, but not the solution.
const OVERLAP: usize = 12;

/// Below a step of this, times the size, Newton's next one would be within the rounding.
const NEAR: f64 = 1e-6;

/// How often a step is halved.
const HALVINGS: u32 = 4;

/// Rounds in which points that do not come to rest are let fall back, before all are.
const ROUNDS: u32 = 3;

/// One row of the linear equations of Newton's step.
#[derive(Clone, Copy)]
pub(super) struct Row<const D: usize> {
    /// Of B_(i-1), B_i and B_(i+1) in F_i with t_i fixed.
    factors: [f64; 3],
    /// The gradients of t_i by them.
    gradients: [[f64; D]; 3],
    /// The derivative of F_i by t_i.
    derivative: [f64; D],
    /// F_i.
    value: [f64; D],
}

/// The room of Newton's step in D dimensions.
pub(super) struct Newton<const D: usize> {
    rows: Vec<Row<D>>,
    upper: Vec<[[f64; D]; D]>,
    right: Vec<[f64; D]>,
    step: Vec<[f64; D]>,
}

impl<const D: usize> Default for Newton<D> {
    fn default() -> Self {
        Newton { rows: Vec::new(), upper: Vec::new(), right: Vec::new(), step: Vec::new() }
    }
}

/// Finds the self-consistent parameters and control points, from control points that solve the linear equations. False if these have
/// become singular, which takes shares other than 1/2.
pub(super) fn solve(
    run: &Run<'_>,
    options: &Options,
    solved: &mut [Solved],
    room: &mut Room,
    report: &mut Report,
) -> Result<bool> {
    let Room { solution, iteration, flat, spatial, .. } = room;
    iteration.begin(run, solution)?;
    // Medians have t = 1/2 in any triangle.
    if options.method.alpha() == Some(0.0) || run.sections().is_empty() {
        return Ok(true);
    }
    let plane = run.points.iter().chain(&solution.controls[..run.points.len()]).all(|p| p.z == 0.0);
    match plane {
        true => flat.solve(run, options, solved, solution, iteration, report),
        false => spatial.solve(run, options, solved, solution, iteration, report),
    }
}

impl<const D: usize> Newton<D> {
    fn solve(
        &mut self,
        run: &Run<'_>,
        options: &Options,
        solved: &mut [Solved],
        solution: &mut Solution,
        iteration: &mut Iteration,
        report: &mut Report,
    ) -> Result<bool> {
        let n = run.points.len();
        let length = n + if run.closed { 2 * OVERLAP } else { 0 };
        resize(
            &mut self.rows,
            n,
            Row { factors: [0.0; 3], gradients: [[0.0; D]; 3], derivative: [0.0; D], value: [0.0; D] },
        )?;
        resize(&mut self.upper, length, [[0.0; D]; D])?;
        resize(&mut self.right, length, [0.0; D])?;
        resize(&mut self.step, n, [0.0; D])?;
        let tolerance = options.tolerance.max(f64::EPSILON) * run.size;
        let sections = run.sections();
        let mut sound = true;
        for round in 0..=ROUNDS {
            if self.rest(run, options, solution, iteration, report, tolerance) {
                break;
            }
            // Which points move still? Those fall back; in the last round all do.
            report.status = FitStatus::NotConverged;
            for i in sections.clone() {
                let t = self.parameter(run, options, solution, iteration, i);
                if round == ROUNDS - 1 || (t - solution.t[i]).abs() > options.tolerance {
                    iteration.held[i] = true;
                    solution.t[i] = solution.given[i];
                    mark(&mut solved[i], PointStatus::FellBack);
                }
            }
            sound = composite::solve(run, solution);
        }
        let (low, high) = (options.parameter_limit, 1.0 - options.parameter_limit);
        for i in sections {
            if !iteration.held[i] && !(low < solution.t[i] && solution.t[i] < high) {
                mark(&mut solved[i], PointStatus::ClampedParameter);
            }
        }
        Ok(sound)
    }

    /// Iterates until the control points rest. At the end they solve the linear equations for the parameters.
    fn rest(
        &mut self,
        run: &Run<'_>,
        options: &Options,
        solution: &mut Solution,
        iteration: &mut Iteration,
        report: &mut Report,
        tolerance: f64,
    ) -> bool {
        let (mut least, mut share, mut halvings) = (f64::INFINITY, 0.0, 0);
        for _ in 0..options.max_sweeps {
            let mut worth = self.evaluate(run, options, solution, iteration);
            while worth > least && halvings < HALVINGS {
                halvings += 1;
                share *= 0.5;
                self.go(run, solution, -share);
                worth = self.evaluate(run, options, solution, iteration);
            }
            report.iterations += 1;
            if worth > least || !self.eliminate(run) {
                // The map itself; it need not make F smaller.
                composite::solve(run, solution);
                least = f64::INFINITY;
                halvings = 0;
                share = 0.0;
                continue;
            }
            least = worth;
            (share, halvings) = (1.0, 0);
            let farthest = self.go(run, solution, 1.0);
            if farthest <= NEAR * run.size {
                let before = &mut iteration.before;
                before.clear();
                before.extend_from_slice(&solution.controls[..run.points.len()]);
                for i in run.sections() {
                    solution.t[i] = self.parameter(run, options, solution, iteration, i);
                }
                composite::solve(run, solution);
                let moves = run.sections().map(|i| solution.controls[i].distance_squared(iteration.before[i]));
                report.last_move = moves.fold(0.0, f64::max).sqrt() / run.size;
                if report.last_move * run.size <= tolerance {
                    return true;
                }
                least = f64::INFINITY;
            }
        }
        for i in run.sections() {
            solution.t[i] = self.parameter(run, options, solution, iteration, i);
        }
        composite::solve(run, solution);
        false
    }

    /// The parameter of point `i` on its section as it is now.
    fn parameter(&self, run: &Run<'_>, options: &Options, solution: &Solution, iteration: &Iteration, i: usize) -> f64 {
        if iteration.held[i] {
            return solution.given[i];
        }
        let [_, u, v] = legs(run, solution, &iteration.shares, i);
        parameter(options, u, v).0
    }

    /// Enters all rows; the sum of the squares of the F_i.
    fn evaluate(&mut self, run: &Run<'_>, options: &Options, solution: &mut Solution, iteration: &Iteration) -> f64 {
        let mut sum = 0.0;
        for i in run.sections() {
            let [b, u, v] = legs(run, solution, &iteration.shares, i);
            let (t, gradients) =
                if iteration.held[i] { (solution.given[i], [DVec3::ZERO; 2]) } else { parameter(options, u, v) };
            solution.t[i] = t;
            let s = 1.0 - t;
            let value = u * (s * s) + b * (2.0 * t * s) + v * (t * t);
            sum += value.length_squared();
            let before = iteration.shares[if i == 0 { run.points.len() - 1 } else { i - 1 }];
            let after = iteration.shares[i];
            self.rows[i] = Row {
                factors: composite::row(t, before, after),
                gradients: [
                    cut(gradients[0] * (1.0 - before)),
                    cut(gradients[0] * before + gradients[1] * (1.0 - after)),
                    cut(gradients[1] * after),
                ],
                derivative: cut(((b - u) * s + (v - b) * t) * 2.0),
                value: cut(value),
            };
        }
        sum
    }

    /// Finds Newton's step. False if the equations are singular.
    fn eliminate(&mut self, run: &Run<'_>) -> bool {
        let n = run.points.len();
        let sections = run.sections();
        // The rows in their order; those of a closed run with its overlap.
        let (count, from) = match run.closed {
            true => (n + 2 * OVERLAP, n * OVERLAP.div_ceil(n) - OVERLAP),
            false => (sections.len(), 1),
        };
        let mut at = from;
        let (mut above, mut right) = ([[0.0; D]; D], [0.0; D]);
        for k in 0..count {
            let row = &self.rows[at];
            at = if at + 1 == n { 0 } else { at + 1 };
            // D_k - L_k U_(k-1), and the right side -F_k - L_k y_(k-1), with L = a + q g^T.
            let [lower, middle, upper] = row.factors;
            let [g, h, l] = &row.gradients;
            let q = &row.derivative;
            let mut block = [[0.0; D]; D];
            let mut value = [0.0; D];
            let along: [f64; D] = std::array::from_fn(|c| (0..D).map(|r| g[r] * above[r][c]).sum::<f64>());
            let across: f64 = (0..D).map(|r| g[r] * right[r]).sum();
            for r in 0..D {
                for c in 0..D {
                    block[r][c] = q[r] * (h[c] - along[c]) - lower * above[r][c];
                }
                block[r][r] += middle;
                value[r] = -row.value[r] - lower * right[r] - q[r] * across;
            }
            let Some(inverse) = inverse(&block) else { return false };
            let coupling: [[f64; D]; D] =
                std::array::from_fn(|r| std::array::from_fn(|c| q[r] * l[c] + if r == c { upper } else { 0.0 }));
            for r in 0..D {
                right[r] = (0..D).map(|c| inverse[r][c] * value[c]).sum();
                for c in 0..D {
                    above[r][c] = (0..D).map(|j| inverse[r][j] * coupling[j][c]).sum();
                }
            }
            self.upper[k] = above;
            self.right[k] = right;
        }
        let mut next = [0.0; D];
        let mut sound = true;
        for k in (0..count).rev() {
            let upper = &self.upper[k];
            let here: [f64; D] =
                std::array::from_fn(|r| self.right[k][r] - (0..D).map(|c| upper[r][c] * next[c]).sum::<f64>());
            next = here;
            match run.closed {
                true if (OVERLAP..OVERLAP + n).contains(&k) => self.step[k - OVERLAP] = next,
                true => {}
                false => self.step[k + 1] = next,
            }
            sound &= next.iter().all(|x| x.is_finite());
        }
        sound
    }

    /// Adds a share of the step to the control points; the farthest move.
    fn go(&self, run: &Run<'_>, solution: &mut Solution, share: f64) -> f64 {
        let mut farthest = 0.0f64;
        for i in run.sections() {
            let mut step = [0.0; 3];
            step[..D].copy_from_slice(&self.step[i]);
            let step = DVec3::from_array(step) * share;
            solution.controls[i] += step;
            farthest = farthest.max(step.length_squared());
        }
        farthest.sqrt()
    }
}

/// The control point of section `i`, and its first and last joint, from its point on.
#[inline]
pub(super) fn legs(run: &Run<'_>, solution: &Solution, shares: &[f64], i: usize) -> [DVec3; 3] {
    let n = run.points.len();
    let (before, after) = (if i == 0 { n - 1 } else { i - 1 }, if i + 1 == n { 0 } else { i + 1 });
    let p = run.points[i];
    let [a, b, c] = [before, i, after].map(|k| solution.controls[k] - p);
    [b, a + (b - a) * shares[before], b + (c - b) * shares[i]]
}

/// The parameter on the section with the joints `u` and `v`, from the point on, and its gradients by them.
///
/// By the chords: t = a^alpha / (a^alpha + b^alpha), dt = alpha t (1 - t) (da / a - db / b). By the normal: t = sqrt(x) / (sqrt(x) + sqrt(y)),
/// dt = t (1 - t) (dx / x - dy / y) / 2 for the parts x = -u.(v - u) and y = v.(v - u) of the chord; a foot outside the chord counts as its
/// nearer end, so that the parameter remains continuous.
#[inline]
pub(super) fn parameter(options: &Options, u: DVec3, v: DVec3) -> (f64, [DVec3; 2]) {
    let (low, high) = (options.parameter_limit, 1.0 - options.parameter_limit);
    let (t, parts, alpha) = match options.method.alpha() {
        Some(alpha) => {
            let parts = [u.length_squared(), v.length_squared()];
            let [before, after] = parts.map(|part| power(part.sqrt(), alpha));
            (before / (before + after), parts, alpha)
        }
        None => {
            let parts = [-u.dot(v - u), v.dot(v - u)].map(|part| part.max(0.0));
            let [before, after] = parts.map(f64::sqrt);
            (before / (before + after), parts, 0.5)
        }
    };
    if !(low < t && t < high) {
        // NaN: no extent at all.
        return (if t.is_nan() { 0.5 } else { t.clamp(low, high) }, [DVec3::ZERO; 2]);
    }
    let factor = alpha * t * (1.0 - t);
    let [x, y] = parts.map(|part| factor / part);
    match options.method {
        Method::Normal => (t, [(u * 2.0 - v) * x + v * y, u * -x - (v * 2.0 - u) * y]),
        _ => (t, [u * x, v * -y]),
    }
}

/// A vector of D dimensions.
#[inline]
fn cut<const D: usize>(v: DVec3) -> [f64; D] {
    let all = v.to_array();
    std::array::from_fn(|k| all[k])
}

/// The inverse of a matrix of 2 or 3 rows, by its adjoint.
#[inline]
fn inverse<const D: usize>(m: &[[f64; D]; D]) -> Option<[[f64; D]; D]> {
    let mut adjoint = [[0.0; D]; D];
    let determinant = if D == 2 {
        adjoint[0][0] = m[1][1];
        adjoint[0][1] = -m[0][1];
        adjoint[1][0] = -m[1][0];
        adjoint[1][1] = m[0][0];
        m[0][0] * m[1][1] - m[0][1] * m[1][0]
    } else {
        for r in 0..D {
            for c in 0..D {
                let ([i, j], [k, l]) = ([(c + 1) % D, (c + 2) % D], [(r + 1) % D, (r + 2) % D]);
                adjoint[r][c] = m[i][k] * m[j][l] - m[i][l] * m[j][k];
            }
        }
        (0..D).map(|c| m[0][c] * adjoint[c][0]).sum()
    };
    let scale = 1.0 / determinant;
    adjoint.iter_mut().flatten().for_each(|x| *x *= scale);
    (determinant.abs() > 1e-14).then_some(adjoint)
}

/// Makes room for `n` items.
fn resize<T: Clone>(list: &mut Vec<T>, n: usize, empty: T) -> Result<()> {
    if list.len() < n {
        alloc::reserve(list, n - list.len())?;
        list.resize(n, empty);
    }
    Ok(())
}

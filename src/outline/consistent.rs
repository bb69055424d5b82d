//! The self-consistent lock: the parameter of each point is that of the method on its section's own triangle.
//!
//! With the joints J_(i-1) and J_i on the control polygon, t_i = t(J_(i-1), P_i, J_i) is a function of B_(i-1), B_i and
//! B_(i+1), and
//!
//! F_i = (1 - t_i)^2 J_(i-1) + 2 t_i (1 - t_i) B_i + t_i^2 J_i - P_i = 0
//!
//! are as many equations as unknowns. The derivative of F_i is the row of the linear equations, times the unit matrix, plus the
//! product of Q_i' = 2 ((1 - t) (B_i - J_(i-1)) + t (J_i - B_i)) and the gradient of t_i: a tridiagonal matrix of small
//! blocks, and Newton's step is one elimination. Parameters are kept within the limits, which makes the map of parameters to
//! parameters (solve for the control points, read off the parameters) continuous on a cube, so that it has a fixed point
//! (Brouwer).
//!
//! A step that makes things worse is halved, and if that does not help, replaced by that map itself. Points that do not come
//! to rest keep the parameters of the data's own triangles.

use super::composite;
use super::method::{Method, power};
use super::request::{FitStatus, Options, PointStatus, Report};
use super::run::{Iteration, Run, Solution, Solved, Workspace, mark};
use crate::alloc;
use crate::error::Result;
use glam::DVec3;

/// Rows of a closed run that are taken before its first and after its last once more: the influence of a row fades by 0.2 or
/// so from one to the next, and what is left of it makes Newton's step inexact, but not the solution. With the symmedian it
/// fades slowly: as many again after every few iterations, up to [`MOST_OVERLAP`].
const OVERLAP: usize = 8;

/// See [`OVERLAP`].
const MOST_OVERLAP: usize = OVERLAP << 6;

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

/// The workspace of Newton's step in D dimensions.
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

/// Finds the self-consistent parameters and control points, from control points that solve the linear equations. False if
/// these have become singular, which takes shares other than 1/2.
pub(super) fn solve(
    run: &Run<'_>,
    options: &Options,
    solved: &mut [Solved],
    workspace: &mut Workspace,
    report: &mut Report,
) -> Result<bool> {
    let Workspace { solution, iteration, flat, spatial, .. } = workspace;
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
        let length = n + if run.closed { 2 * MOST_OVERLAP } else { 0 };
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
            let free = low < solution.t[i] && solution.t[i] < high;
            if !free && !iteration.held[i] {
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
        for sweep in 0..options.max_sweeps {
            let overlap = (OVERLAP << (sweep / 4).min(8)).min(MOST_OVERLAP);
            let mut worth = self.evaluate(run, options, solution, iteration);
            while worth > least && halvings < HALVINGS {
                halvings += 1;
                share *= 0.5;
                self.go(run, solution, -share);
                worth = self.evaluate(run, options, solution, iteration);
            }
            report.iterations += 1;
            if worth > least || !self.eliminate(run, overlap) {
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
    fn eliminate(&mut self, run: &Run<'_>, overlap: usize) -> bool {
        let n = run.points.len();
        let sections = run.sections();
        // The rows in their order; those of a closed run with its overlap.
        let (count, from) = match run.closed {
            true => (n + 2 * overlap, n * overlap.div_ceil(n) - overlap),
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
                true if (overlap..overlap + n).contains(&k) => self.step[k - overlap] = next,
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
#[inline(always)]
pub(super) fn legs(run: &Run<'_>, solution: &Solution, shares: &[f64], i: usize) -> [DVec3; 3] {
    let n = run.points.len();
    let (before, after) = (if i == 0 { n - 1 } else { i - 1 }, if i + 1 == n { 0 } else { i + 1 });
    let p = run.points[i];
    let [a, b, c] = [before, i, after].map(|k| solution.controls[k] - p);
    [b, a + (b - a) * shares[before], b + (c - b) * shares[i]]
}

/// The parameter on the section with the joints `u` and `v`, from the point on, and its gradients by them.
///
/// By the chords: t = a^alpha / (a^alpha + b^alpha), dt = alpha t (1 - t) (da / a - db / b). By the normal: t = sqrt(x) /
/// (sqrt(x) + sqrt(y)), dt = t (1 - t) (dx / x - dy / y) / 2 for the parts x = -u.(v - u) and y = v.(v - u) of the chord; a
/// foot outside the chord counts as its nearer end, so that the parameter remains continuous.
#[inline(always)]
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
#[inline(always)]
fn inverse<const D: usize>(m: &[[f64; D]; D]) -> Option<[[f64; D]; D]> {
    let mut adjoint = [[0.0; D]; D];
    let determinant = if D == 2 {
        adjoint[0][0] = m[1][1];
        adjoint[0][1] = -m[0][1];
        adjoint[1][0] = -m[1][0];
        adjoint[1][1] = m[0][0];
        m[0][0] * m[1][1] - m[0][1] * m[1][0]
    } else {
        let minor = |r: usize, c: usize| {
            let ([i, j], [k, l]) = ([(c + 1) % D, (c + 2) % D], [(r + 1) % D, (r + 2) % D]);
            m[i][k] * m[j][l] - m[i][l] * m[j][k]
        };
        adjoint = std::array::from_fn(|r| std::array::from_fn(|c| minor(r, c)));
        (0..D).map(|c| m[0][c] * adjoint[c][0]).sum()
    };
    let scale = 1.0 / determinant;
    adjoint.iter_mut().flatten().for_each(|x| *x *= scale);
    (determinant.abs() > 1e-14).then_some(adjoint)
}

/// Reserves memory for `n` items.
fn resize<T: Clone>(list: &mut Vec<T>, n: usize, empty: T) -> Result<()> {
    if list.len() < n {
        alloc::reserve(list, n - list.len())?;
        list.resize(n, empty);
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn gradients_are_those_of_the_parameter() {
        let (u, v) = (DVec3::new(-1.0, 0.3, 0.2), DVec3::new(0.7, 0.4, -0.5));
        for method in [Method::Bisector, Method::Symmedian, Method::Alpha(0.3), Method::Normal] {
            let options = Options { method, ..Options::default() };
            let (_, gradients) = parameter(&options, u, v);
            for axis in DVec3::AXES {
                let h = axis * 1e-6;
                let by_u = (parameter(&options, u + h, v).0 - parameter(&options, u - h, v).0) / 2e-6;
                let by_v = (parameter(&options, u, v + h).0 - parameter(&options, u, v - h).0) / 2e-6;
                assert!((gradients[0].dot(axis) - by_u).abs() < 1e-9, "{method:?} {by_u} {:?}", gradients[0]);
                assert!((gradients[1].dot(axis) - by_v).abs() < 1e-9, "{method:?} {by_v} {:?}", gradients[1]);
            }
        }
        // At the limits, and where all is one point.
        let options = Options::default();
        assert_eq!(parameter(&options, DVec3::ZERO, v), (1.0 / 6.0, [DVec3::ZERO; 2]));
        assert_eq!(parameter(&options, DVec3::ZERO, DVec3::ZERO), (0.5, [DVec3::ZERO; 2]));
    }

    #[test]
    fn inverses() {
        let m = [[2.0, 1.0, 0.0], [0.5, 3.0, 1.0], [1.0, 0.0, 1.5]];
        let inverse3 = inverse(&m).unwrap();
        for (r, row) in m.iter().enumerate() {
            let product: [f64; 3] = std::array::from_fn(|c| (0..3).map(|k| row[k] * inverse3[k][c]).sum());
            assert!((0..3).all(|c| (product[c] - f64::from(u8::from(r == c))).abs() < 1e-15), "{product:?}");
        }
        assert_eq!(inverse(&[[2.0, 0.0], [1.0, 4.0]]).unwrap(), [[0.5, 0.0], [-0.125, 0.25]]);
        assert!(inverse(&[[1.0, 2.0], [2.0, 4.0]]).is_none());
    }
}

//! The self-consistent lock: the parameter of each point is the method's parameter on its section's
//! own triangle.
//!
//! With the joints J_(i-1) and J_i on the control polygon, t_i = t(J_(i-1), P_i, J_i) is a function
//! of B_(i-1), B_i and B_(i+1), and
//!
//! F_i = (1 - t_i)^2 J_(i-1) + 2 t_i (1 - t_i) B_i + t_i^2 J_i - P_i = 0
//!
//! are as many equations as unknowns, which Newton's method solves. The derivative of F_i is the
//! row of the linear equations, times the unit matrix, plus the product of Q_i' = 2 ((1 - t) (B_i -
//! J_(i-1)) + t (J_i - B_i)) and the gradient of t_i. The Jacobian is a tridiagonal matrix of small
//! blocks, and Newton's step takes one elimination.
//!
//! Consider the map that solves for the control points and reads off new parameters. Because
//! parameters are kept within the limits, it is continuous on a cube and has a fixed point
//! (Brouwer). A step that increases the sum of squares is halved, and if that does not help,
//! replaced by this map. Points that do not converge keep the parameters of the data's own
//! triangles. O(n) for each iteration, in time and memory.
//!
//! Source: ours.

use super::control_equations;
use super::lock_rounds::{MAX_FALLBACK_ROUNDS, max_iterations_of_round};
use crate::identify::composite_solution::CompositeSolution;
use crate::identify::identify_options::Options;
use crate::identify::method::{Method, power_by_roots_if_possible};
use crate::identify::report::{FitStatus, PointStatus};
use crate::identify::subcurve::{Subcurve, SubcurveOutput};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;

/// The number of rows of a closed subcurve that are repeated before its first and after its last.
/// The influence of a row fades by a factor of about 0.2 from one to the next. The remainder makes
/// Newton's step inexact, but not the solution. With the symmedian it fades slowly, so the overlap
/// doubles every few iterations, up to [`MAX_REPEATED_ROWS_PER_END`].
const MIN_REPEATED_ROWS_PER_END: usize = 8;

const MAX_REPEATED_ROWS_PER_END: usize = MIN_REPEATED_ROWS_PER_END << 6;

/// Below a step of this, times the size, the next Newton step would be within rounding.
const MAX_RELATIVE_LAST_STEP: f64 = 1e-6;

/// The maximum number of times that a step is halved.
const MAX_STEP_HALVINGS: u32 = 4;

/// Points between two progress reports.
const POINTS_PER_REPORT: usize = 1 << 14;

const PROGRESS_STAGE: &str = "making parameters self-consistent";

/// One row of the linear equations of Newton's step.
#[derive(Clone, Copy)]
pub(super) struct NewtonRow<const D: usize> {
    /// The factors of B_(i-1), B_i and B_(i+1) in F_i for a fixed t_i.
    factors: [f64; 3],
    /// The gradients of t_i with respect to B_(i-1), B_i and B_(i+1).
    gradients: [[f64; D]; 3],
    /// The derivative of F_i with respect to t_i.
    derivative: [f64; D],
    /// F_i.
    equation_value: [f64; D],
}

/// The workspace of Newton's method in D dimensions.
#[derive(Default)]
pub(super) struct SelfConsistentNewton<const D: usize> {
    rows: Vec<NewtonRow<D>>,
    upper: Vec<[[f64; D]; D]>,
    right_sides: Vec<[f64; D]>,
    step: Vec<[f64; D]>,
}

/// Returns true if points and control points lie in the plane z = 0.
pub(super) fn is_in_xy_plane(sub: &Subcurve<'_>, solution: &CompositeSolution) -> bool {
    sub.points.iter().chain(&solution.controls[..sub.len()]).all(|p| p.z == 0.0)
}

impl<const D: usize> SelfConsistentNewton<D> {
    /// Finds the self-consistent parameters of the points, and the control points, starting from
    /// control points that solve the linear equations. Points that do not converge fall back.
    /// Returns false if the equations become singular, which can happen only with joint parameters
    /// other than 1/2.
    pub(super) fn solve_with_self_consistent_point_parameters(
        &mut self,
        sub: &Subcurve<'_>,
        solution: &mut CompositeSolution,
        out: &mut SubcurveOutput<'_>,
    ) -> Result<bool> {
        let n = sub.len();
        let length = n + if sub.closed { 2 * MAX_REPEATED_ROWS_PER_END } else { 0 };
        let empty =
            NewtonRow { factors: [0.0; 3], gradients: [[0.0; D]; 3], derivative: [0.0; D], equation_value: [0.0; D] };
        alloc::grow(&mut self.rows, n, empty)?;
        alloc::grow(&mut self.upper, length, [[0.0; D]; D])?;
        alloc::grow(&mut self.right_sides, length, [0.0; D])?;
        alloc::grow(&mut self.step, n, [0.0; D])?;
        let mut regular = true;
        for round in 0..=MAX_FALLBACK_ROUNDS {
            let converges = self.iterate_until_converged(sub, solution, out, max_iterations_of_round(sub, round))?;
            // Further rounds replace the lock at some points.
            out.report.is_uncounted = true;
            if converges {
                break;
            }
            // Points that still move fall back; in the last round all do.
            out.report.status = FitStatus::NotConverged;
            for i in sub.section_indices() {
                let t = parameter_on_section(sub, solution, i);
                if round == MAX_FALLBACK_ROUNDS - 1 || (t - solution.point_parameters[i]).abs() > sub.options.tolerance
                {
                    solution.has_fallen_back[i] = true;
                    solution.point_parameters[i] = solution.parameters_by_data_triangles[i];
                    out.results[i].flag_status(PointStatus::FellBack);
                }
            }
            regular = control_equations::solve_control_points(sub, solution);
        }
        let [low, high] = sub.section_parameter_range();
        for i in sub.section_indices() {
            let free = low < solution.point_parameters[i] && solution.point_parameters[i] < high;
            if !free && !solution.has_fallen_back[i] {
                out.results[i].flag_status(PointStatus::ClampedParameter);
            }
        }
        Ok(regular)
    }

    /// Iterates until the control points converge. They finally solve the linear equations for the
    /// parameters.
    fn iterate_until_converged(
        &mut self,
        sub: &Subcurve<'_>,
        solution: &mut CompositeSolution,
        out: &mut SubcurveOutput<'_>,
        max_iterations: u32,
    ) -> Result<bool> {
        let (report, job) = (&mut *out.report, out.job);
        let tolerance = sub.options.tolerance.max(f64::EPSILON) * sub.outline_size;
        let (mut smallest, mut scale, mut halvings) = (f64::INFINITY, 0.0, 0);
        for sweep in 0..max_iterations {
            let overlap = (MIN_REPEATED_ROWS_PER_END << (sweep / 4).min(8)).min(MAX_REPEATED_ROWS_PER_END);
            let mut sum = self.evaluate_newton_rows(sub, solution, job)?;
            while sum > smallest && halvings < MAX_STEP_HALVINGS {
                halvings += 1;
                scale *= 0.5;
                self.add_scaled_step(sub, solution, -scale);
                sum = self.evaluate_newton_rows(sub, solution, job)?;
            }
            report.count_iteration();
            if sum > smallest || !self.compute_newton_step(sub, overlap, job)? {
                // The fixed-point map itself, which need not make F smaller.
                solution.save_controls();
                control_equations::solve_control_points(sub, solution);
                (smallest, scale, halvings) = (f64::INFINITY, 0.0, 0);
                let moved = solution.largest_move(sub.section_indices());
                report.record_cycle(moved / sub.outline_size, &solution.controls[..sub.len()])?;
                continue;
            }
            (smallest, scale, halvings) = (sum, 1.0, 0);
            let farthest = self.add_scaled_step(sub, solution, 1.0);
            report.record_cycle(farthest / sub.outline_size, &solution.controls[..sub.len()])?;
            if farthest <= MAX_RELATIVE_LAST_STEP * sub.outline_size {
                solution.save_controls();
                update_parameters_and_controls(sub, solution);
                let moved = solution.largest_move(sub.section_indices());
                report.correct_last_move(moved / sub.outline_size);
                if moved <= tolerance {
                    return Ok(true);
                }
                smallest = f64::INFINITY;
            }
        }
        update_parameters_and_controls(sub, solution);
        Ok(false)
    }

    /// Evaluates all rows. Returns the sum of the squares of the F_i.
    fn evaluate_newton_rows(
        &mut self,
        sub: &Subcurve<'_>,
        solution: &mut CompositeSolution,
        job: &Job<'_>,
    ) -> Result<f64> {
        let mut sum = 0.0;
        for i in sub.section_indices() {
            job.step_every(POINTS_PER_REPORT, i, sub.len(), PROGRESS_STAGE)?;
            let [b, u, v] = solution.control_and_joints_relative_to_point(sub, i);
            let (t, gradients) = match solution.has_fallen_back[i] {
                true => (solution.parameters_by_data_triangles[i], [DVec3::ZERO; 2]),
                false => parameter_and_gradients(sub.options, u, v),
            };
            solution.point_parameters[i] = t;
            let s = 1.0 - t;
            let value = u * (s * s) + b * (2.0 * t * s) + v * (t * t);
            sum += value.length_squared();
            let (before, after) = (
                solution.joint_parameters_of_iteration[sub.previous_index(i)],
                solution.joint_parameters_of_iteration[i],
            );
            self.rows[i] = NewtonRow {
                factors: control_equations::control_point_coefficients(t, before, after),
                gradients: [
                    first_coordinates(gradients[0] * (1.0 - before)),
                    first_coordinates(gradients[0] * before + gradients[1] * (1.0 - after)),
                    first_coordinates(gradients[1] * after),
                ],
                derivative: first_coordinates(((b - u) * s + (v - b) * t) * 2.0),
                equation_value: first_coordinates(value),
            };
        }
        Ok(sum)
    }

    /// Computes Newton's step. Returns false if the equations are singular.
    fn compute_newton_step(&mut self, sub: &Subcurve<'_>, repeated_rows: usize, job: &Job<'_>) -> Result<bool> {
        let n = sub.len();
        // The rows in order; for a closed subcurve with its overlap.
        let (count, from) = match sub.closed {
            true => (n + 2 * repeated_rows, n * repeated_rows.div_ceil(n) - repeated_rows),
            false => (sub.section_indices().len(), 1),
        };
        let mut at = from;
        let (mut above, mut right) = ([[0.0; D]; D], [0.0; D]);
        for k in 0..count {
            job.step_every(POINTS_PER_REPORT, k, count, PROGRESS_STAGE)?;
            let row = &self.rows[at];
            at = sub.next_index(at);
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
                value[r] = -row.equation_value[r] - lower * right[r] - q[r] * across;
            }
            let Some(inverse) = inverse_matrix(&block) else { return Ok(false) };
            let coupling: [[f64; D]; D] =
                std::array::from_fn(|r| std::array::from_fn(|c| q[r] * l[c] + if r == c { upper } else { 0.0 }));
            for r in 0..D {
                right[r] = (0..D).map(|c| inverse[r][c] * value[c]).sum();
                for c in 0..D {
                    above[r][c] = (0..D).map(|j| inverse[r][j] * coupling[j][c]).sum();
                }
            }
            self.upper[k] = above;
            self.right_sides[k] = right;
        }
        let mut next = [0.0; D];
        let mut finite = true;
        for k in (0..count).rev() {
            let upper = &self.upper[k];
            let here: [f64; D] =
                std::array::from_fn(|r| self.right_sides[k][r] - (0..D).map(|c| upper[r][c] * next[c]).sum::<f64>());
            next = here;
            match sub.closed {
                true if (repeated_rows..repeated_rows + n).contains(&k) => self.step[k - repeated_rows] = next,
                true => {}
                false => self.step[k + 1] = next,
            }
            finite &= next.iter().all(|x| x.is_finite());
        }
        Ok(finite)
    }

    /// Adds the step, times `scale`, to the control points. Returns the largest move.
    fn add_scaled_step(&self, sub: &Subcurve<'_>, solution: &mut CompositeSolution, scale: f64) -> f64 {
        let mut farthest = 0.0f64;
        for i in sub.section_indices() {
            let mut step = [0.0; 3];
            step[..D].copy_from_slice(&self.step[i]);
            let step = DVec3::from_array(step) * scale;
            solution.controls[i] += step;
            farthest = farthest.max(step.length_squared());
        }
        farthest.sqrt()
    }
}

/// Reads off the parameters and solves for the control points: the fixed-point map.
fn update_parameters_and_controls(sub: &Subcurve<'_>, solution: &mut CompositeSolution) {
    for i in sub.section_indices() {
        solution.point_parameters[i] = parameter_on_section(sub, solution, i);
    }
    control_equations::solve_control_points(sub, solution);
}

/// Returns the parameter of point `i` on its current section.
fn parameter_on_section(sub: &Subcurve<'_>, solution: &CompositeSolution, i: usize) -> f64 {
    if solution.has_fallen_back[i] {
        return solution.parameters_by_data_triangles[i];
    }
    let [_, u, v] = solution.control_and_joints_relative_to_point(sub, i);
    parameter_and_gradients(sub.options, u, v).0
}

/// Returns the parameter on the section with the joints `u` and `v`, relative to the point, and its
/// gradients with respect to both.
///
/// By the chords, t = a^alpha / (a^alpha + b^alpha) and dt = alpha t (1 - t) (da / a - db / b). By
/// the normal, t = sqrt(x) / (sqrt(x) + sqrt(y)) and dt = t (1 - t) (dx / x - dy / y) / 2, for the
/// parts x = -u.(v - u) and y = v.(v - u) of the chord. A foot outside the chord counts as its
/// nearer end, which keeps the parameter continuous.
#[inline(always)]
pub(super) fn parameter_and_gradients(options: &Options, u: DVec3, v: DVec3) -> (f64, [DVec3; 2]) {
    let (low, high) = (options.parameter_limit(), 1.0 - options.parameter_limit());
    let (t, parts, alpha) = match options.method.chord_exponent() {
        Some(alpha) => {
            let parts = [u.length_squared(), v.length_squared()];
            let [before, after] = parts.map(|part| power_by_roots_if_possible(part.sqrt(), alpha));
            (before / (before + after), parts, alpha)
        }
        None => {
            let parts = [-u.dot(v - u), v.dot(v - u)].map(|part| part.max(0.0));
            let [before, after] = parts.map(f64::sqrt);
            (before / (before + after), parts, 0.5)
        }
    };
    if !(low < t && t < high) {
        // NaN: the triangle has no extent.
        return (if t.is_nan() { 0.5 } else { t.clamp(low, high) }, [DVec3::ZERO; 2]);
    }
    let factor = alpha * t * (1.0 - t);
    let [x, y] = parts.map(|part| factor / part);
    match options.method {
        Method::Normal => (t, [(u * 2.0 - v) * x + v * y, u * -x - (v * 2.0 - u) * y]),
        _ => (t, [u * x, v * -y]),
    }
}

#[inline]
fn first_coordinates<const D: usize>(v: DVec3) -> [f64; D] {
    let all = v.to_array();
    std::array::from_fn(|k| all[k])
}

/// Returns the inverse of a matrix of 2 or 3 rows, by its adjugate.
#[inline(always)]
fn inverse_matrix<const D: usize>(m: &[[f64; D]; D]) -> Option<[[f64; D]; D]> {
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn gradients_agree_with_differences() {
        let (u, v) = (DVec3::new(-1.0, 0.3, 0.2), DVec3::new(0.7, 0.4, -0.5));
        for method in [Method::Bisector, Method::Symmedian, Method::Alpha(0.3), Method::Normal] {
            let options = Options { method, ..Options::default() };
            let (_, gradients) = parameter_and_gradients(&options, u, v);
            for axis in DVec3::AXES {
                let h = axis * 1e-6;
                let by_u = (parameter_and_gradients(&options, u + h, v).0
                    - parameter_and_gradients(&options, u - h, v).0)
                    / 2e-6;
                let by_v = (parameter_and_gradients(&options, u, v + h).0
                    - parameter_and_gradients(&options, u, v - h).0)
                    / 2e-6;
                assert!((gradients[0].dot(axis) - by_u).abs() < 1e-9, "{method:?} {by_u} {:?}", gradients[0]);
                assert!((gradients[1].dot(axis) - by_v).abs() < 1e-9, "{method:?} {by_v} {:?}", gradients[1]);
            }
        }
        // At the limits, and where all points coincide.
        let options = Options::default();
        assert_eq!(parameter_and_gradients(&options, DVec3::ZERO, v), (options.parameter_limit(), [DVec3::ZERO; 2]));
        assert_eq!(parameter_and_gradients(&options, DVec3::ZERO, DVec3::ZERO), (0.5, [DVec3::ZERO; 2]));
    }

    #[test]
    fn inverse_times_matrix_is_the_identity() {
        let m = [[2.0, 1.0, 0.0], [0.5, 3.0, 1.0], [1.0, 0.0, 1.5]];
        let inverse3 = inverse_matrix(&m).unwrap();
        for (r, row) in m.iter().enumerate() {
            let product: [f64; 3] = std::array::from_fn(|c| (0..3).map(|k| row[k] * inverse3[k][c]).sum());
            assert!((0..3).all(|c| (product[c] - f64::from(u8::from(r == c))).abs() < 1e-15), "{product:?}");
        }
        assert_eq!(inverse_matrix(&[[2.0, 0.0], [1.0, 4.0]]).unwrap(), [[0.5, 0.0], [-0.125, 0.25]]);
        assert!(inverse_matrix(&[[1.0, 2.0], [2.0, 4.0]]).is_none());
    }
}

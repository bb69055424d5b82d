//! Single curves by iterations: the paper's sweeps, and Newton's method for control points on
//! guides.
//!
//! A sweep finds the crossing t_i of curve and guide, which does not depend on lambda_i, and then
//! adds u_i.(P_i - P(t_i)) / J_i(t_i) to lambda_i. Errors that alternate from point to point fade
//! slowly: the number of sweeps doubles with each degree. After a few sweeps Newton's method takes
//! over. Across the curve, with c_i perpendicular to P'(t_i),
//!
//! sum_j J_j(t_i) (c_i.u_j) dlambda_j = c_i.r_i,
//!
//! dt_i = P'(t_i).(r_i - sum_j J_j(t_i) u_j dlambda_j) / |P'(t_i)|^2,
//!
//! where r_i = P_i - P(t_i).
//!
//! Source: Nadopta for the sweeps. The independence of the crossing from lambda_i, and Newton's
//! method, are ours.

use super::collocation::{Collocation, MAX_POINT_MISS_DISTANCE};
use crate::curve::segment;
use crate::identify::identify_options::Solver;
use crate::identify::report::{FitStatus, PointStatus, ReportInProgress};
use crate::identify::stepping;
use crate::identify::subcurve::{Subcurve, SubcurveOutput};
use glam::DVec3;
use gusset_base::error::Result;
use gusset_base::geom::bernstein;

/// Sweeps before Newton's method.
const MAX_SWEEPS_BEFORE_NEWTON: u32 = 8;

/// The maximum number of Newton iterations.
const MAX_NEWTON_ITERATIONS: u32 = 30;

/// The largest move of a control point in a sweep, in sizes of the outline.
const MAX_CONTROL_POINT_MOVE: f64 = 1e3;

/// Sweeps between two progress reports, over a few points.
const SWEEPS_PER_REPORT: usize = 1 << 8;
const PROGRESS_STAGE: &str = "placing control points";
/// The smallest fraction of a Newton step that is tried.
const MIN_STEP_FRACTION: f64 = 1e-3;

impl Collocation {
    /// Finds the control points for the current parameters.
    pub(super) fn solve_for_parameters(&mut self, sub: &Subcurve<'_>, out: &mut SubcurveOutput<'_>) -> Result<()> {
        if sub.options.solver == Solver::Step {
            self.start_controls_at_points();
            if !self.run_sweeps(sub, None, sub.options.max_sweeps, out)? {
                flag_unconverged(out);
            }
        }
        self.solve_linear_equations()
    }

    /// Finds control points on the guides, which are lines through the points. Returns false if none
    /// are found.
    pub(super) fn solve_on_guides(
        &mut self,
        sub: &Subcurve<'_>,
        normal: DVec3,
        out: &mut SubcurveOutput<'_>,
    ) -> Result<bool> {
        self.start_controls_at_points();
        if sub.options.solver == Solver::Fast {
            // The sweeps are the start of Newton's method, not part of it.
            out.report.is_uncounted = true;
            self.run_sweeps(sub, Some(normal), MAX_SWEEPS_BEFORE_NEWTON.min(sub.options.max_sweeps), out)?;
            out.report.is_uncounted = false;
            return self.iterate_newton(sub, normal, out.report);
        }
        let rests = self.run_sweeps(sub, Some(normal), sub.options.max_sweeps, out)?;
        if !self.are_parameters_increasing() {
            return Ok(false);
        }
        if !rests {
            flag_unconverged(out);
        }
        // Removes the deviations that the steps leave. The control points leave their guides by no
        // more than that.
        self.solve_linear_equations()?;
        Ok(self.max_and_squared_residual().0 <= MAX_POINT_MISS_DISTANCE * sub.outline_size)
    }

    /// Returns true if the parameters increase from 0 to 1.
    fn are_parameters_increasing(&self) -> bool {
        self.t.windows(2).all(|pair| pair[0] < pair[1])
    }

    /// Runs the paper's sweeps. With the normal of the plane, control points move along the
    /// guides; otherwise along the deviations, for the current parameters. Returns true if the
    /// sweeps converge.
    fn run_sweeps(
        &mut self,
        sub: &Subcurve<'_>,
        normal: Option<DVec3>,
        max_sweeps: u32,
        out: &mut SubcurveOutput<'_>,
    ) -> Result<bool> {
        let (report, job) = (&mut *out.report, out.job);
        let tolerance = sub.options.tolerance.max(f64::EPSILON) * sub.outline_size;
        let first = self.inner_control_range().start;
        for sweep in 0..max_sweeps {
            job.step_every(SWEEPS_PER_REPORT, sweep as usize, max_sweeps as usize, PROGRESS_STAGE)?;
            report.count_iteration();
            let mut farthest = 0.0f64;
            for i in 1..=self.inner_point_count() {
                let (own, p) = (first + i - 1, self.points[i]);
                if let Some(normal) = normal {
                    // If the curve does not cross a point's guide, the point keeps its parameter.
                    if let Some(t) = self.line_crossing_parameter(p, normal.cross(self.guides[i]), self.t[i]) {
                        self.t[i] = t;
                    }
                }
                bernstein::bernstein_values(&mut self.basis, self.t[i]);
                let slope = self.basis[own];
                let left = p - segment::point_at(&self.controls, self.t[i]);
                let direction = if normal.is_some() { self.guides[i] } else { left.normalize_or_zero() };
                let along = match sub.options.solver {
                    Solver::Fast => direction.dot(left) / slope,
                    Solver::Step => {
                        let deviation = |x: f64| direction.dot(left) - slope * x;
                        stepping::step_until_deviation_is_zero(
                            sub.options,
                            sub.outline_size,
                            deviation,
                            &mut report.steps,
                            job,
                        )?
                        .unwrap_or(f64::NAN)
                    }
                };
                // The sweeps diverged or the steps are used up. Newton's method or the lock by
                // parameters may do better.
                if along.is_nan() || along.abs() >= MAX_CONTROL_POINT_MOVE * sub.outline_size {
                    return Ok(false);
                }
                self.controls[own] += direction * along;
                farthest = farthest.max(along.abs());
            }
            report.record_cycle(farthest / sub.outline_size, &self.controls)?;
            if farthest <= tolerance {
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// Returns the place nearest `from` where the curve crosses the line through a point with a
    /// given normal.
    fn line_crossing_parameter(&self, p: DVec3, line_normal: DVec3, from: f64) -> Option<f64> {
        let f = |t: f64| line_normal.dot(segment::point_at(&self.controls, t) - p);
        let start = f(from);
        if start == 0.0 {
            return Some(from);
        }
        let step = 0.125 / self.degree() as f64;
        let mut known = [(from, start); 2];
        for _ in 0..8 * self.degree() {
            for (side, sign) in [(0, -1.0), (1, 1.0)] {
                let (t, value) = known[side];
                let next = (t + sign * step).clamp(0.0, 1.0);
                if next == t {
                    continue;
                }
                known[side] = (next, f(next));
                if (known[side].1 > 0.0) != (value > 0.0) {
                    let root = find_root_by_regula_falsi(f, (t, value), known[side]);
                    return (root > 0.0 && root < 1.0).then_some(root);
                }
            }
        }
        None
    }

    /// Newton's method for the positions on the guides and the parameters together.
    fn iterate_newton(&mut self, sub: &Subcurve<'_>, normal: DVec3, report: &mut ReportInProgress) -> Result<bool> {
        let inner = self.inner_point_count();
        let tolerance = sub.options.tolerance.max(2.0 * f64::EPSILON) * sub.outline_size;
        let mut residual = self.max_and_squared_residual();
        let mut near = false;
        for _ in 0..MAX_NEWTON_ITERATIONS.min(sub.options.max_sweeps) {
            if !residual.0.is_finite() {
                return Ok(false);
            }
            report.count_iteration();
            if !self.compute_newton_step(normal)? {
                return Ok(false);
            }
            let Some((next, fraction)) = self.halve_step_until_residual_falls(residual, tolerance) else {
                // The step brings no improvement. It succeeded if the residual is already as small
                // as rounding allows.
                self.controls.copy_from_slice(&self.previous);
                self.t[1..=inner].copy_from_slice(&self.previous_t[..inner]);
                return Ok(near);
            };
            residual = next;
            let moved = (1..=inner).map(|i| self.right[i - 1].x.abs()).fold(0.0, f64::max);
            report.record_cycle(fraction * moved / sub.outline_size, &self.controls)?;
            // Once the points are within the tolerance, one more step removes the rest.
            if near || (residual.0 <= tolerance && moved <= tolerance) {
                return Ok(residual.0 <= tolerance);
            }
            near = residual.0 <= tolerance;
        }
        Ok(false)
    }

    /// Finds the steps along the guides and of the parameters, from the x and y components of
    /// `right`. Returns false if the equations are singular.
    fn compute_newton_step(&mut self, normal: DVec3) -> Result<bool> {
        let (inner, first, degree) = (self.inner_point_count(), self.inner_control_range().start, self.degree());
        self.previous.copy_from_slice(&self.controls);
        self.previous_t[..inner].copy_from_slice(&self.t[1..=inner]);
        for k in 0..degree {
            self.slopes[k] = (self.controls[k + 1] - self.controls[k]) * degree as f64;
        }
        self.matrix.resize(inner)?;
        for i in 1..=inner {
            let slope = segment::point_at(&self.slopes[..degree], self.t[i]);
            let across = normal.cross(slope);
            let left = self.points[i] - segment::point_at(&self.controls, self.t[i]);
            bernstein::bernstein_values(&mut self.basis, self.t[i]);
            let row = self.matrix.row(i - 1);
            for j in 1..=inner {
                row[j - 1] = self.basis[first + j - 1] * across.dot(self.guides[j]);
            }
            self.right[i - 1] = DVec3::new(across.dot(left), 0.0, 0.0);
        }
        if !self.matrix.factorise() {
            return Ok(false);
        }
        self.matrix.solve(&mut self.right[..inner]);
        // The steps of the parameters, with the control points before and after.
        for j in 1..=inner {
            self.controls[first + j - 1] += self.guides[j] * self.right[j - 1].x;
        }
        for i in 1..=inner {
            let slope = segment::point_at(&self.slopes[..degree], self.previous_t[i - 1]);
            let left = self.points[i] - segment::point_at(&self.controls, self.previous_t[i - 1]);
            self.right[i - 1].y = slope.dot(left) / slope.length_squared();
        }
        Ok(true)
    }

    /// Takes the step, or half of it, and so on until the residual falls. Returns the residual and
    /// the fraction, or `None` if no fraction helps.
    fn halve_step_until_residual_falls(&mut self, residual: (f64, f64), tolerance: f64) -> Option<((f64, f64), f64)> {
        let first = self.inner_control_range().start;
        let mut fraction = 1.0;
        while fraction >= MIN_STEP_FRACTION {
            for i in 1..=self.inner_point_count() {
                self.t[i] = self.previous_t[i - 1] + fraction * self.right[i - 1].y;
                let own = first + i - 1;
                self.controls[own] = self.previous[own] + self.guides[i] * (fraction * self.right[i - 1].x);
            }
            let next = self.max_and_squared_residual();
            if (next.1 < residual.1 || next.0 <= tolerance) && self.are_parameters_increasing() {
                return Some((next, fraction));
            }
            fraction *= 0.5;
        }
        None
    }
}

/// Flags that the sweeps ended before they converged.
fn flag_unconverged(out: &mut SubcurveOutput<'_>) {
    out.report.status = FitStatus::NotConverged;
    out.flag_all_points(PointStatus::NotConverged);
}

/// Returns the root of a function between two places where it has opposite signs, to the last bits.
/// Uses regula falsi with the Illinois rule, which halves the value at an end that stays.
fn find_root_by_regula_falsi(f: impl Fn(f64) -> f64, a: (f64, f64), b: (f64, f64)) -> f64 {
    let ((mut x, mut fx), (mut y, mut fy)) = (a, b);
    for _ in 0..100 {
        let mut z = y - fy * (y - x) / (fy - fx);
        if !(x.min(y) <= z && z <= x.max(y)) {
            z = 0.5 * (x + y);
        }
        let fz = f(z);
        if fz == 0.0 || (z - y).abs() <= 1e-16 {
            return z;
        }
        if (fz > 0.0) != (fy > 0.0) {
            (x, fx) = (y, fy);
        } else {
            fx *= 0.5;
        }
        (y, fy) = (z, fz);
    }
    y
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn roots_are_found_to_the_last_bits() {
        for (at, power) in [(0.3, 1), (0.9, 3), (0.123_456, 5)] {
            let f = |t: f64| (t - at) * (1.0 + t).powi(power);
            assert!((find_root_by_regula_falsi(f, (0.0, f(0.0)), (1.0, f(1.0))) - at).abs() <= 4e-16);
        }
    }

    #[test]
    fn basis_functions_are_exact() {
        let mut basis = [0.0; 21];
        for t in [0.0, 0.1, 0.5, 0.97, 1.0] {
            bernstein::bernstein_values(&mut basis, t);
            assert!((basis.iter().sum::<f64>() - 1.0).abs() < 1e-14);
            let wanted = 1140.0 * t * t * t * (1.0f64 - t).powi(17);
            assert!((basis[3] - wanted).abs() < 1e-15, "{t}");
        }
    }
}

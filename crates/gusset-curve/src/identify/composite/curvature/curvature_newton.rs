//! Newton's method for composite curves with continuous curvature. Among all solutions of the
//! linearised equations it takes the smallest step.
//!
//! There are more unknowns than equations. With the Jacobian A, the residuals f and the units D of
//! the unknowns, the smallest step is
//!
//! D^2 A^T y,    (A D) (A D)^T y = -f.
//!
//! The matrix is banded and positive definite, because equations more than 3 points apart have no
//! unknowns in common. A closed subcurve is unrolled: its first and last
//! [`MAX_STEP_REACH`] points are repeated, which affects points farther away only by
//! rounding.
//!
//! Points whose residuals grow with the full step take half of it, then a quarter and so on,
//! together with their neighbours. One point in trouble thus does not slow down the others.
//!
//! Once most equations hold, a step moves only windows around the points whose equations do not. The
//! [`MAX_STEP_REACH`] points on each side take part; the step fades to rounding within them. O(points in
//! windows) for each step; memory O(n), about 1,100 bytes a point.

use super::curvature_system::{
    EQUATIONS_PER_POINT, EquationDerivatives, FixedPointQuantities, LockEquation, POINTS_PER_EQUATION, PointUnknowns,
    UNKNOWNS_PER_POINT, differentiate_equations, evaluate_equations,
};
use crate::identify::subcurve::Subcurve;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::linear::banded::BandedCholesky;
use gusset_base::job::Job;

/// The number of points after which a step has faded to rounding. As many points of a closed subcurve are
/// repeated before its first and after its last.
pub(super) const MAX_STEP_REACH: usize = 24;

/// The entries of a row of the matrix up to its diagonal.
const BAND_WIDTH: usize = POINTS_PER_EQUATION * EQUATIONS_PER_POINT;

/// The unit of a control point's moves, as a fraction of the spacing. The unit of the logit of beta
/// is 1.
const CONTROL_POINT_STEP_UNIT: f64 = 0.3;

/// The unit of the logits of lambda and mu.
const HANDLE_LOGIT_STEP_UNIT: f64 = 0.7;

/// The largest change of a logit in one step.
const MAX_LOGIT_STEP: f64 = 1.5;

/// The largest odds beta / (1 - beta), and their largest reciprocal.
const MAX_BETA_ODDS: f64 = 15.0;

/// The smallest and the largest odds lambda / (1 - lambda) and mu / (1 - mu). A quadratic has odds of 2.
const HANDLE_ODDS_RANGE: [f64; 2] = [0.5, 1e4];

/// Parameters stay between this and 1 minus this.
const MIN_SECTION_PARAMETER: f64 = 0.01;

/// The maximum number of times that a step is halved.
const MAX_STEP_HALVINGS: u32 = 5;

/// A point takes a smaller part of the step if its squared residuals grow by more than this factor.
const MAX_RESIDUAL_GROWTH: f64 = 1.5;

/// Squared residuals below this may grow.
const SMALL_SQUARED_RESIDUAL: f64 = 1e-4;

/// The number of neighbours on each side that also take a smaller part of the step.
const DAMPED_NEIGHBOURS_PER_SIDE: usize = 3;

/// Points between two progress reports.
pub(super) const POINTS_PER_REPORT: usize = 1 << 12;

pub(super) const PROGRESS_STAGE: &str = "making curvatures continuous";

/// Consecutive points that a step moves. In a closed subcurve they may continue with the first point.
#[derive(Clone, Copy, PartialEq)]
pub(super) struct PointWindow {
    pub(super) first_point: usize,
    pub(super) point_count: usize,
}

impl PointWindow {
    /// Returns the points of the window and some more on each side, at most the whole subcurve.
    pub(super) fn points_with_margin(self, sub: &Subcurve<'_>, margin: usize) -> impl Iterator<Item = usize> + use<> {
        let n = sub.len();
        let (first, count) = match sub.closed {
            true => (self.first_point + n - margin.min(n), (self.point_count + 2 * margin).min(n)),
            false => {
                let first = self.first_point.saturating_sub(margin);
                (first, (self.first_point + self.point_count + margin).min(n) - first)
            }
        };
        (first..first + count).map(move |i| i % n)
    }
}

/// The workspace of the method.
#[derive(Default)]
pub(super) struct LeastNormNewton {
    /// The step of each point.
    steps: Vec<[f64; UNKNOWNS_PER_POINT]>,
    /// The fraction of the step that each point takes.
    step_fractions: Vec<f64>,
    previous: Vec<PointUnknowns>,
    /// The squared residuals of each point before the step.
    squared_residuals: Vec<f64>,
    banded: BandedCholesky<BAND_WIDTH>,
}

impl LeastNormNewton {
    pub(super) fn reset_for_points(&mut self, count: usize) -> Result<()> {
        alloc::reset(&mut self.steps, count, [0.0; UNKNOWNS_PER_POINT])?;
        alloc::reset(&mut self.step_fractions, count, 1.0)?;
        alloc::reset(&mut self.squared_residuals, count, 0.0)?;
        alloc::reset(&mut self.previous, count, PointUnknowns::default())
    }

    /// Takes one step in a window. Returns the largest move of a control point.
    pub(super) fn take_damped_step(
        &mut self,
        sub: &Subcurve<'_>,
        known: &[FixedPointQuantities],
        nodes: &mut [PointUnknowns],
        window: PointWindow,
        job: &Job<'_>,
    ) -> Result<f64> {
        self.solve_least_norm_step(sub, known, nodes, window, job)?;
        let n = nodes.len();
        let moved = || window.points_with_margin(sub, 0);
        // Equations have unknowns of the previous point and of the next two.
        let affected = || window.points_with_margin(sub, POINTS_PER_EQUATION - 2);
        moved().for_each(|i| self.previous[i] = nodes[i]);
        for i in affected() {
            job.step_every(POINTS_PER_REPORT, i, n, PROGRESS_STAGE)?;
            self.squared_residuals[i] = sum_of_squares(&evaluate_equations(sub, known, nodes, i));
        }
        moved().for_each(|i| self.step_fractions[i] = 1.0);
        self.apply_fractional_steps(sub, nodes, window);
        for _ in 0..MAX_STEP_HALVINGS {
            let mut trouble = false;
            for i in affected() {
                job.step_every(POINTS_PER_REPORT, i, n, PROGRESS_STAGE)?;
                let square = sum_of_squares(&evaluate_equations(sub, known, nodes, i));
                let grows = square > MAX_RESIDUAL_GROWTH * self.squared_residuals[i] && square > SMALL_SQUARED_RESIDUAL;
                if grows || square.is_nan() {
                    trouble = true;
                    self.mark_for_damping(sub, i);
                }
            }
            if !trouble {
                break;
            }
            for i in moved() {
                let part = self.step_fractions[i];
                self.step_fractions[i] = if part < 0.0 { -0.5 * part } else { part };
                nodes[i] = self.previous[i];
            }
            self.apply_fractional_steps(sub, nodes, window);
        }
        let moves = moved().map(|i| nodes[i].control.distance(self.previous[i].control));
        Ok(moves.fold(0.0, f64::max))
    }

    /// Marks a point and its neighbours by a negative fraction.
    fn mark_for_damping(&mut self, sub: &Subcurve<'_>, i: usize) {
        let n = self.step_fractions.len();
        let last = 2 * DAMPED_NEIGHBOURS_PER_SIDE.min((n - 1) / 2);
        for k in 0..=last {
            let j = i + n + k - last / 2;
            if sub.closed || (n..2 * n).contains(&j) {
                self.step_fractions[j % n] = -self.step_fractions[j % n].abs();
            }
        }
    }

    /// Moves the unknowns of a window by the fractions of their steps.
    fn apply_fractional_steps(&self, sub: &Subcurve<'_>, nodes: &mut [PointUnknowns], window: PointWindow) {
        let [low, high] = sub.section_parameter_range();
        let [low, high] = [low.min(MIN_SECTION_PARAMETER), high.max(1.0 - MIN_SECTION_PARAMETER)];
        for i in window.points_with_margin(sub, 0) {
            let node = &mut nodes[i];
            let by = self.steps[i].map(|x| x * self.step_fractions[i]);
            node.control += glam::DVec3::new(by[0], by[1], by[2]);
            if by[3] != 0.0 {
                node.t = (node.t + by[3]).clamp(low, high);
            }
            node.beta = shift_logit_clamped(node.beta, by[4], [1.0 / MAX_BETA_ODDS, MAX_BETA_ODDS]);
            node.handles = [0, 1].map(|k| shift_logit_clamped(node.handles[k], by[5 + k], HANDLE_ODDS_RANGE));
        }
    }

    /// Computes the smallest step of a window.
    fn solve_least_norm_step(
        &mut self,
        sub: &Subcurve<'_>,
        known: &[FixedPointQuantities],
        nodes: &[PointUnknowns],
        window: PointWindow,
        job: &Job<'_>,
    ) -> Result<()> {
        let n = nodes.len();
        // The points before and after the window.
        let [before, after] = match sub.closed {
            true => [MAX_STEP_REACH; 2],
            false => [window.first_point, n - window.first_point - window.point_count]
                .map(|others| others.min(MAX_STEP_REACH)),
        };
        let (moved, count) = (before..before + window.point_count, before + window.point_count + after);
        let at = |k: usize| (window.first_point + k + n * before.div_ceil(n) - before) % n;
        // The equations of the unrolled point k, in units of the unknowns; empty for points beyond
        // the ends.
        let rows = |k: usize| {
            let mut rows = differentiate_equations(sub, known, nodes, at(k));
            for point in 0..POINTS_PER_EQUATION {
                let inside = k + point > 0 && k + point - 1 < count;
                let units = if inside {
                    unknown_step_units(&known[at(k + point - 1)], &nodes[at(k + point - 1)])
                } else {
                    [0.0; UNKNOWNS_PER_POINT]
                };
                for row in &mut rows {
                    row[point].iter_mut().zip(&units).for_each(|(derivative, unit)| *derivative *= unit);
                }
            }
            rows
        };
        self.banded.clear_and_reserve(EQUATIONS_PER_POINT * count)?;
        // The equations of this point and of the three before it.
        let mut window = [EquationDerivatives::default(); POINTS_PER_EQUATION];
        for k in 0..count {
            job.step_every(POINTS_PER_REPORT, k, 2 * count, PROGRESS_STAGE)?;
            window.rotate_right(1);
            window[0] = rows(k);
            let values = evaluate_equations(sub, known, nodes, at(k));
            for (r, value) in values.iter().enumerate() {
                let mut row = [0.0; BAND_WIDTH];
                for back in 0..POINTS_PER_EQUATION.min(k + 1) {
                    for c in 0..if back == 0 { r + 1 } else { EQUATIONS_PER_POINT } {
                        // The points whose unknowns are in the equations of both points, which are
                        // `back` apart.
                        let shared = (0..POINTS_PER_EQUATION - back)
                            .map(|point| dot(&window[0][r][point], &window[back][c][point + back]))
                            .sum::<f64>();
                        row[BAND_WIDTH - 1 - (EQUATIONS_PER_POINT * back + r - c)] = shared;
                    }
                }
                self.banded.push(row, -value);
            }
        }
        let multipliers = self.banded.solve();
        moved.clone().for_each(|k| self.steps[at(k)] = [0.0; UNKNOWNS_PER_POINT]);
        for k in moved.start.saturating_sub(POINTS_PER_EQUATION)..count.min(moved.end + POINTS_PER_EQUATION) {
            job.step_every(POINTS_PER_REPORT, k, count, PROGRESS_STAGE)?;
            let (rows, own) = (rows(k), &multipliers[EQUATIONS_PER_POINT * k..EQUATIONS_PER_POINT * (k + 1)]);
            for point in 0..POINTS_PER_EQUATION {
                let place = k + point;
                if place == 0 || !moved.contains(&(place - 1)) {
                    continue;
                }
                let step = &mut self.steps[at(place - 1)];
                for (row, y) in rows.iter().zip(own) {
                    step.iter_mut().zip(&row[point]).for_each(|(step, derivative)| *step += derivative * y);
                }
            }
        }
        for i in moved.map(at) {
            let step = &mut self.steps[i];
            step.iter_mut().zip(unknown_step_units(&known[i], &nodes[i])).for_each(|(step, unit)| *step *= unit);
            step[4..].iter_mut().for_each(|step| *step = step.clamp(-MAX_LOGIT_STEP, MAX_LOGIT_STEP));
        }
        Ok(())
    }
}

/// Returns the units of the unknowns of a point; 0 for fixed ones.
fn unknown_step_units(known: &FixedPointQuantities, node: &PointUnknowns) -> [f64; UNKNOWNS_PER_POINT] {
    let control = if known.is_control_point_given { 0.0 } else { CONTROL_POINT_STEP_UNIT * known.spacing };
    let t = if known.lock_equation == LockEquation::GivenParameter { 0.0 } else { 1.0 };
    let [beta, lambda, mu] = known.is_unknown;
    let near_limit = (2.0 * node.beta - 1.0) * (MAX_BETA_ODDS + 1.0) / (MAX_BETA_ODDS - 1.0);
    let beta = if beta { (1.0 - near_limit * near_limit).max(1e-3) } else { 0.0 };
    let handle = |free: bool| if free { HANDLE_LOGIT_STEP_UNIT } else { 0.0 };
    [control, control, control, t, beta, handle(lambda), handle(mu)]
}

/// Moves the logit of a number between 0 and 1, keeping its odds within limits.
fn shift_logit_clamped(x: f64, by: f64, [low, high]: [f64; 2]) -> f64 {
    if by == 0.0 {
        return x;
    }
    let odds = (x / (1.0 - x) * libm::exp(by)).clamp(low, high);
    odds / (1.0 + odds)
}

fn sum_of_squares(values: &[f64; EQUATIONS_PER_POINT]) -> f64 {
    dot(values, values)
}

fn dot<const N: usize>(a: &[f64; N], b: &[f64; N]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

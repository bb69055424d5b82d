//! Newton's method for composite curves with continuous curvature. Among all solutions of the
//! linearised equations it takes the smallest step.
//!
//! There are more unknowns than equations. With the Jacobian A, the residuals f and the units D of
//! the unknowns, the smallest step is
//!
//! D^2 A^T y,    (A D) (A D)^T y = -f.
//!
//! The matrix is banded and positive definite, because equations more than 3 points apart have no
//! unknowns in common. A closed subcurve is unrolled: its first and last [`OVERLAP`] points are
//! repeated, which affects points farther away only by rounding.
//!
//! Points whose residuals grow with the full step take half of it, then a quarter and so on,
//! together with their neighbours. One point in trouble thus does not slow down the others. O(n)
//! for each step, in time and memory: about 1,100 bytes a point.

use super::system::{EQUATIONS, Known, LockEquation, Node, Rows, SPAN, UNKNOWNS, differentiate, evaluate};
use crate::identify::subcurve::Subcurve;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::linear::banded::BandedCholesky;
use gusset_base::job::Job;

/// The number of points of a closed subcurve that are repeated before its first and after its last.
const OVERLAP: usize = 24;

/// The entries of a row of the matrix up to its diagonal.
const BAND: usize = SPAN * EQUATIONS;

/// The unit of a control point's moves, as a fraction of the spacing. The unit of the logit of beta
/// is 1.
const CONTROL_UNIT: f64 = 0.3;

/// The unit of the logits of lambda and mu.
const HANDLE_UNIT: f64 = 0.7;

/// The largest change of a logit in one step.
const MAX_LOGIT_STEP: f64 = 1.5;

/// The largest odds of beta, and of 1 - beta.
const MAX_BETA_ODDS: f64 = 15.0;

/// The smallest and the largest odds of lambda and mu, which are 2 for a quadratic.
const HANDLE_ODDS: [f64; 2] = [0.5, 1e4];

/// Parameters stay between this and 1 minus this.
const MIN_PARAMETER: f64 = 0.01;

/// The maximum number of times that a step is halved.
const MAX_HALVINGS: u32 = 5;

/// A point takes a smaller part of the step if its squared residuals grow by more than this factor.
const MAX_GROWTH: f64 = 1.5;

/// Squared residuals below this may grow.
const SMALL_RESIDUAL: f64 = 1e-4;

/// The number of neighbours on each side that also take a smaller part of the step.
const TROUBLE_REACH: usize = 3;

/// Points between two progress reports.
pub(super) const POINTS_PER_REPORT: usize = 1 << 12;

pub(super) const STAGE: &str = "making curvatures continuous";

/// The workspace of the method.
#[derive(Default)]
pub(super) struct LeastSteps {
    /// The step of each point.
    steps: Vec<[f64; UNKNOWNS]>,
    /// The fraction of the step that each point takes.
    parts: Vec<f64>,
    previous: Vec<Node>,
    /// The squared residuals of each point before the step.
    squares: Vec<f64>,
    banded: BandedCholesky<BAND>,
}

impl LeastSteps {
    pub(super) fn begin(&mut self, n: usize) -> Result<()> {
        alloc::reset(&mut self.steps, n, [0.0; UNKNOWNS])?;
        alloc::reset(&mut self.parts, n, 1.0)?;
        alloc::reset(&mut self.squares, n, 0.0)?;
        alloc::reset(&mut self.previous, n, Node::default())
    }

    /// Takes one step. Returns the largest move of a control point.
    pub(super) fn step(
        &mut self,
        sub: &Subcurve<'_>,
        known: &[Known],
        nodes: &mut [Node],
        job: &Job<'_>,
    ) -> Result<f64> {
        self.solve(sub, known, nodes, job)?;
        let n = nodes.len();
        self.previous.copy_from_slice(nodes);
        for (i, square) in self.squares.iter_mut().enumerate() {
            job.step_every(POINTS_PER_REPORT, i, n, STAGE)?;
            *square = squared(&evaluate(sub, known, nodes, i));
        }
        self.parts.fill(1.0);
        self.take(sub, nodes);
        for _ in 0..MAX_HALVINGS {
            let mut trouble = false;
            for i in 0..n {
                job.step_every(POINTS_PER_REPORT, i, n, STAGE)?;
                let square = squared(&evaluate(sub, known, nodes, i));
                let grows = square > MAX_GROWTH * self.squares[i] && square > SMALL_RESIDUAL;
                if grows || square.is_nan() {
                    trouble = true;
                    self.mark(sub, i);
                }
            }
            if !trouble {
                break;
            }
            self.parts.iter_mut().for_each(|part| *part = if *part < 0.0 { -0.5 * *part } else { *part });
            nodes.copy_from_slice(&self.previous);
            self.take(sub, nodes);
        }
        let moves = nodes.iter().zip(&self.previous).map(|(node, before)| node.control.distance(before.control));
        Ok(moves.fold(0.0, f64::max))
    }

    /// Marks a point and its neighbours by a negative fraction.
    fn mark(&mut self, sub: &Subcurve<'_>, i: usize) {
        let n = self.parts.len();
        let last = 2 * TROUBLE_REACH.min((n - 1) / 2);
        for k in 0..=last {
            let j = i + n + k - last / 2;
            if sub.closed || (n..2 * n).contains(&j) {
                self.parts[j % n] = -self.parts[j % n].abs();
            }
        }
    }

    /// Moves the unknowns by the fractions of their steps.
    fn take(&self, sub: &Subcurve<'_>, nodes: &mut [Node]) {
        let [low, high] = sub.parameter_range();
        let [low, high] = [low.min(MIN_PARAMETER), high.max(1.0 - MIN_PARAMETER)];
        for ((node, step), part) in nodes.iter_mut().zip(&self.steps).zip(&self.parts) {
            let by = step.map(|x| x * part);
            node.control += glam::DVec3::new(by[0], by[1], by[2]);
            if by[3] != 0.0 {
                node.t = (node.t + by[3]).clamp(low, high);
            }
            node.beta = move_logit(node.beta, by[4], [1.0 / MAX_BETA_ODDS, MAX_BETA_ODDS]);
            node.handles = [0, 1].map(|k| move_logit(node.handles[k], by[5 + k], HANDLE_ODDS));
        }
    }

    /// Computes the smallest step.
    fn solve(&mut self, sub: &Subcurve<'_>, known: &[Known], nodes: &[Node], job: &Job<'_>) -> Result<()> {
        let n = nodes.len();
        let overlap = if sub.closed { OVERLAP } else { 0 };
        let count = n + 2 * overlap;
        let at = |k: usize| (k + n * overlap.div_ceil(n) - overlap) % n;
        // The equations of the unrolled point k, in units of the unknowns; empty for points beyond
        // the ends.
        let rows = |k: usize| {
            let mut rows = differentiate(sub, known, nodes, at(k));
            for point in 0..SPAN {
                let inside = k + point > 0 && k + point - 1 < count;
                let units =
                    if inside { units(&known[at(k + point - 1)], &nodes[at(k + point - 1)]) } else { [0.0; UNKNOWNS] };
                for row in &mut rows {
                    row[point].iter_mut().zip(&units).for_each(|(derivative, unit)| *derivative *= unit);
                }
            }
            rows
        };
        self.banded.clear_and_reserve(EQUATIONS * count)?;
        // The equations of this point and of the three before it.
        let mut window = [Rows::default(); SPAN];
        for k in 0..count {
            job.step_every(POINTS_PER_REPORT, k, 2 * count, STAGE)?;
            window.rotate_right(1);
            window[0] = rows(k);
            let values = evaluate(sub, known, nodes, at(k));
            for (r, value) in values.iter().enumerate() {
                let mut row = [0.0; BAND];
                for back in 0..SPAN.min(k + 1) {
                    for c in 0..if back == 0 { r + 1 } else { EQUATIONS } {
                        // The points whose unknowns are in the equations of both points, which are
                        // `back` apart.
                        let shared = (0..SPAN - back)
                            .map(|point| dot(&window[0][r][point], &window[back][c][point + back]))
                            .sum::<f64>();
                        row[BAND - 1 - (EQUATIONS * back + r - c)] = shared;
                    }
                }
                self.banded.push(row, -value);
            }
        }
        let multipliers = self.banded.solve();
        self.steps.fill([0.0; UNKNOWNS]);
        for k in overlap.saturating_sub(SPAN)..count.min(overlap + n + SPAN) {
            job.step_every(POINTS_PER_REPORT, k, count, STAGE)?;
            let (rows, own) = (rows(k), &multipliers[EQUATIONS * k..EQUATIONS * (k + 1)]);
            for point in 0..SPAN {
                let place = k + point;
                if !(overlap + 1..overlap + n + 1).contains(&place) {
                    continue;
                }
                let step = &mut self.steps[at(place - 1)];
                for (row, y) in rows.iter().zip(own) {
                    step.iter_mut().zip(&row[point]).for_each(|(step, derivative)| *step += derivative * y);
                }
            }
        }
        for (i, step) in self.steps.iter_mut().enumerate() {
            step.iter_mut().zip(units(&known[i], &nodes[i])).for_each(|(step, unit)| *step *= unit);
            step[4..].iter_mut().for_each(|step| *step = step.clamp(-MAX_LOGIT_STEP, MAX_LOGIT_STEP));
        }
        Ok(())
    }
}

/// Returns the units of the unknowns of a point; 0 for fixed ones.
fn units(known: &Known, node: &Node) -> [f64; UNKNOWNS] {
    let control = if known.fixed { 0.0 } else { CONTROL_UNIT * known.spacing };
    let t = if known.lock_equation == LockEquation::GivenParameter { 0.0 } else { 1.0 };
    let [beta, lambda, mu] = known.free;
    let near_limit = (2.0 * node.beta - 1.0) * (MAX_BETA_ODDS + 1.0) / (MAX_BETA_ODDS - 1.0);
    let beta = if beta { (1.0 - near_limit * near_limit).max(1e-3) } else { 0.0 };
    let handle = |free: bool| if free { HANDLE_UNIT } else { 0.0 };
    [control, control, control, t, beta, handle(lambda), handle(mu)]
}

/// Moves the logit of a number between 0 and 1, keeping its odds within limits.
fn move_logit(x: f64, by: f64, [low, high]: [f64; 2]) -> f64 {
    if by == 0.0 {
        return x;
    }
    let odds = (x / (1.0 - x) * libm::exp(by)).clamp(low, high);
    odds / (1.0 + odds)
}

fn squared(values: &[f64; EQUATIONS]) -> f64 {
    dot(values, values)
}

fn dot<const N: usize>(a: &[f64; N], b: &[f64; N]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

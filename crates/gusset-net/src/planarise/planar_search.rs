//! The search for the closest net of plane cells: steps with decreasing penalties, then steps of
//! least length that restore the constraints.

use super::constraints::PlanarityConstraints;
use super::planarise_options::STAGE;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;

/// The penalties, and the maximum number of steps with each. With smaller penalties, steps along
/// the curved valley of the sum become too short.
const DECREASING_PENALTIES: [f64; 3] = [1e-1, 1e-2, 1e-3];
const MAX_STEPS_PER_PENALTY: u32 = 4;
/// Keeps the matrix positive definite if constraints depend on each other.
const MATRIX_REGULARISATION: f64 = 1e-13;
/// The maximum number of halvings of a step.
const MAX_STEP_HALVINGS: u32 = 6;
/// Steps end when one is below this fraction of the largest displacement.
const MIN_RELATIVE_STEP: f64 = 1e-3;
/// Improvements end when the sum of squares decreases by less than this fraction.
const MIN_RELATIVE_IMPROVEMENT: f64 = 1e-3;

pub(super) struct PlanarSearch<'a> {
    constraints: &'a PlanarityConstraints,
    /// The given positions.
    given_positions: &'a [DVec3],
    /// The target deviation.
    tolerance: f64,
    /// The maximum number of steps.
    max_steps: u32,
    /// The number of steps so far.
    pub(super) step_count: u32,
    job: Job<'a>,
}

impl<'a> PlanarSearch<'a> {
    pub(super) fn new(
        constraints: &'a PlanarityConstraints,
        start: &'a [DVec3],
        tolerance: f64,
        max_steps: u32,
        job: &Job<'a>,
    ) -> Self {
        PlanarSearch { constraints, given_positions: start, tolerance, max_steps, step_count: 0, job: *job }
    }

    /// Runs the search and returns the positions found.
    pub(super) fn run(&mut self) -> Result<Vec<DVec3>> {
        let mut positions = alloc::copied(self.given_positions)?;
        self.minimise_with_decreasing_penalties(&mut positions)?;
        self.restore_constraints(&mut positions)?;
        self.reduce_displacement(&mut positions)?;
        Ok(positions)
    }

    /// Returns the job of the next step. The number of steps is unknown, so each takes a share of
    /// the remaining progress.
    fn job_of_next_step(&mut self) -> Job<'a> {
        let at = |k: u32| 1.0 - 0.9f64.powi(k as i32);
        self.step_count += 1;
        self.job.sub_job(at(self.step_count - 1), at(self.step_count))
    }

    /// Reports before a pass over all cells.
    fn report_pass(&self) -> Result<()> {
        self.job.step(1.0 - 0.9f64.powi(self.step_count as i32), STAGE)
    }

    /// Minimises the penalised sum |x - x0|^2 + |g|^2 / penalty, for decreasing penalties.
    fn minimise_with_decreasing_penalties(&mut self, positions: &mut Vec<DVec3>) -> Result<()> {
        let (constraints, start) = (self.constraints, self.given_positions);
        for penalty in DECREASING_PENALTIES {
            for _ in 0..MAX_STEPS_PER_PENALTY.min(self.max_steps - self.step_count) {
                let job = self.job_of_next_step();
                let rows = constraints.linearise(positions, &job.sub_job(0.0, 0.0))?;
                let towards = constraints.displacements_from_base(&rows, [start, positions], penalty, &job)?;
                let sum = |at: &[DVec3]| {
                    self.squared_distance_from_start(at) + constraints.sum_of_squares(&rows, at) / penalty
                };
                self.report_pass()?;
                let before = sum(positions);
                let Some(next) = self.halve_until_better(positions, towards, |at| sum(at) < before)? else {
                    break;
                };
                self.report_pass()?;
                let is_small =
                    self.max_displacement(&next, positions) <= MIN_RELATIVE_STEP * self.max_displacement(&next, start);
                *positions = next;
                if is_small {
                    break;
                }
            }
        }
        Ok(())
    }

    /// Moves closer to the given positions along the constraints. Each step goes to x0 - J^T y, the
    /// closest point of the linearised constraints, and is followed by steps that restore the
    /// constraints.
    fn reduce_displacement(&mut self, positions: &mut Vec<DVec3>) -> Result<()> {
        let constraints = self.constraints;
        let (mut part, mut distance) = (1.0, self.squared_distance_from_start(positions));
        while part > 0.01
            && self.step_count < self.max_steps
            && constraints.max_deviation(positions).0 <= self.tolerance
        {
            let job = self.job_of_next_step();
            let rows = constraints.linearise(positions, &job.sub_job(0.0, 0.0))?;
            let mut next = constraints.displacements_from_base(
                &rows,
                [self.given_positions, positions],
                MATRIX_REGULARISATION,
                &job,
            )?;
            drop(rows);
            self.report_pass()?;
            constraints.constrained_vertices().for_each(|v| next[v] = positions[v].lerp(next[v], part));
            self.restore_constraints(&mut next)?;
            self.report_pass()?;
            let is_plane = constraints.max_deviation(&next).0 <= self.tolerance;
            if !(is_plane && self.squared_distance_from_start(&next) < distance) {
                part /= 4.0;
                continue;
            }
            let before = std::mem::replace(&mut distance, self.squared_distance_from_start(&next));
            *positions = next;
            if distance > (1.0 - MIN_RELATIVE_IMPROVEMENT * part) * before {
                break;
            }
        }
        Ok(())
    }

    /// |x - x0|^2.
    fn squared_distance_from_start(&self, at: &[DVec3]) -> f64 {
        self.constraints.constrained_vertices().map(|v| at[v].distance_squared(self.given_positions[v])).sum()
    }

    /// Newton steps of least length that restore the constraints, while they improve.
    fn restore_constraints(&mut self, positions: &mut Vec<DVec3>) -> Result<()> {
        let constraints = self.constraints;
        let (mut deviation, _) = constraints.max_deviation(positions);
        while self.step_count < self.max_steps && deviation > self.tolerance {
            let job = self.job_of_next_step();
            let rows = constraints.linearise(positions, &job.sub_job(0.0, 0.0))?;
            let towards = constraints.displacements_from_base(&rows, [&*positions; 2], MATRIX_REGULARISATION, &job)?;
            drop(rows);
            let Some(next) =
                self.halve_until_better(positions, towards, |at| constraints.max_deviation(at).0 < deviation)?
            else {
                return Ok(());
            };
            *positions = next;
            self.report_pass()?;
            deviation = constraints.max_deviation(positions).0;
        }
        Ok(())
    }

    /// Tries the whole step, a half, a quarter and so on until it improves.
    fn halve_until_better(
        &self,
        from: &[DVec3],
        mut to: Vec<DVec3>,
        is_better: impl Fn(&[DVec3]) -> bool,
    ) -> Result<Option<Vec<DVec3>>> {
        for _ in 0..=MAX_STEP_HALVINGS {
            self.report_pass()?;
            if is_better(&to) {
                return Ok(Some(to));
            }
            self.report_pass()?;
            self.constraints.constrained_vertices().for_each(|v| to[v] = to[v].midpoint(from[v]));
        }
        Ok(None)
    }

    /// Returns the largest distance between corresponding vertices.
    fn max_displacement(&self, a: &[DVec3], b: &[DVec3]) -> f64 {
        self.constraints.constrained_vertices().map(|v| a[v].distance(b[v])).fold(0.0, f64::max)
    }
}

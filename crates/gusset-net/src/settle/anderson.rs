//! Anderson acceleration of steps (D. G. Anderson, *Iterative procedures for nonlinear integral
//! equations*, 1965), as in Y. Peng et al., *Anderson acceleration for geometry optimization and
//! physics simulation* (2018). It combines the last steps so that the displacement becomes
//! smallest. The caller must check that the energy decreases. O(unknowns), for a window of some
//! steps.

use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;

/// The number of steps that are combined.
const MAX_COMBINED_STEPS: usize = 6;
/// The fraction of the diagonal added to the normal equations, so that similar steps do not cancel.
const RELATIVE_REGULARISATION: f64 = 1e-12;

/// The last steps: changes of the displacement and of its end.
#[derive(Default)]
pub(super) struct AndersonAcceleration {
    /// The last step's displacement and start.
    last_displacement_and_start: Option<[Vec<DVec3>; 2]>,
    /// Differences of displacements, and of starts, between consecutive steps.
    changes: Vec<[Vec<DVec3>; 2]>,
}

fn dot(a: &[DVec3], b: &[DVec3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a.dot(*b)).sum()
}

fn differences(a: &[DVec3], b: &[DVec3]) -> Result<Vec<DVec3>> {
    alloc::collect(a.iter().zip(b).map(|(a, b)| *a - *b))
}

impl AndersonAcceleration {
    /// Returns an accelerated displacement for the step from these unknowns; `None` at first.
    pub(super) fn accelerate_step(&mut self, at: &[DVec3], step: &[DVec3]) -> Result<Option<Vec<DVec3>>> {
        if let Some([before, start]) = &self.last_displacement_and_start {
            if self.changes.len() == MAX_COMBINED_STEPS {
                self.changes.remove(0);
            }
            alloc::push(&mut self.changes, [differences(step, before)?, differences(at, start)?])?;
        }
        self.last_displacement_and_start = Some([alloc::copied(step)?, alloc::copied(at)?]);
        let m = self.changes.len();
        if m == 0 {
            return Ok(None);
        }
        let weights = self.mixing_weights(step);
        let mut accelerated = alloc::copied(step)?;
        for (weight, [change, shift]) in weights.iter().zip(&self.changes) {
            for ((to, change), shift) in accelerated.iter_mut().zip(change).zip(shift) {
                *to -= *weight * (*change + *shift);
            }
        }
        Ok(accelerated.iter().all(|p| p.is_finite()).then_some(accelerated))
    }

    /// Returns the weights of the changes whose combination is closest to a step, by elimination of
    /// the normal equations.
    fn mixing_weights(&self, step: &[DVec3]) -> [f64; MAX_COMBINED_STEPS] {
        let m = self.changes.len();
        let (mut matrix, mut weights) = ([[0.0; MAX_COMBINED_STEPS]; MAX_COMBINED_STEPS], [0.0; MAX_COMBINED_STEPS]);
        for i in 0..m {
            weights[i] = dot(&self.changes[i][0], step);
            (0..m).for_each(|k| matrix[i][k] = dot(&self.changes[i][0], &self.changes[k][0]));
        }
        let trace: f64 = (0..m).map(|i| matrix[i][i]).sum();
        (0..m).for_each(|i| matrix[i][i] += RELATIVE_REGULARISATION * trace);
        for i in 0..m {
            for k in i + 1..m {
                let factor = matrix[k][i] / matrix[i][i];
                let row = matrix[i];
                (i..m).for_each(|j| matrix[k][j] -= factor * row[j]);
                weights[k] -= factor * weights[i];
            }
        }
        for i in (0..m).rev() {
            let known: f64 = (i + 1..m).map(|k| matrix[i][k] * weights[k]).sum();
            weights[i] = (weights[i] - known) / matrix[i][i];
        }
        weights
    }
}

//! The locks of composite curves: parameters and control points for given joint parameters.

use super::equations;
use super::iteration::Iteration;
use super::self_consistent::Newton;
use super::{self_consistent, sweeps};
use crate::error::Result;
use crate::outline::identify::options::{Lock, Solver};
use crate::outline::identify::report::Report;
use crate::outline::identify::solution::Solution;
use crate::outline::identify::subcurve::{PointResult, Subcurve};

/// The unknowns, and the memory of the solvers; used again for each subcurve.
#[derive(Default)]
pub(in crate::outline::identify) struct LockWorkspace {
    pub(in crate::outline::identify) solution: Solution,
    pub(super) iteration: Iteration,
    planar: Newton<2>,
    spatial: Newton<3>,
}

/// Finds parameters and control points, from control points that solve the linear equations. False
/// if these are singular.
pub(super) fn solve(
    sub: &Subcurve<'_>,
    results: &mut [PointResult],
    workspace: &mut LockWorkspace,
    report: &mut Report,
) -> Result<bool> {
    let LockWorkspace { solution, iteration, planar, spatial } = workspace;
    if (sub.options.lock, sub.options.solver) == (Lock::Parameter, Solver::Fast) {
        return Ok(equations::solve(sub, solution));
    }
    iteration.begin(sub, solution)?;
    if sub.sections().is_empty() {
        return Ok(true);
    }
    if (sub.options.lock, sub.options.solver) != (Lock::SelfConsistent, Solver::Fast) {
        return sweeps::solve(sub, results, solution, iteration, report);
    }
    // Medians have t = 1/2 in any triangle.
    if sub.options.method.alpha() == Some(0.0) {
        return Ok(true);
    }
    match self_consistent::is_planar(sub, solution) {
        true => planar.solve(sub, results, solution, iteration, report),
        false => spatial.solve(sub, results, solution, iteration, report),
    }
}

//! The locks of composite curves: parameters and control points for given joint parameters.

use super::control_equations;
use super::self_consistent::SelfConsistentNewton;
use super::{self_consistent, sweeps};
use crate::identify::composite_solution::CompositeSolution;
use crate::identify::identify_options::{Lock, Solver};
use crate::identify::subcurve::{Subcurve, SubcurveOutput};
use gusset_base::error::Result;

/// The unknowns, and the workspaces of the solvers, which subcurves reuse.
#[derive(Default)]
pub(in crate::identify) struct LockWorkspace {
    pub(in crate::identify) solution: CompositeSolution,
    planar: SelfConsistentNewton<2>,
    spatial: SelfConsistentNewton<3>,
}

/// Finds parameters and control points, starting from control points that solve the linear
/// equations. Returns false if the equations are singular.
pub(super) fn solve_with_lock(
    sub: &Subcurve<'_>,
    workspace: &mut LockWorkspace,
    out: &mut SubcurveOutput<'_>,
) -> Result<bool> {
    let LockWorkspace { solution, planar, spatial } = workspace;
    if (sub.options.lock, sub.options.solver) == (Lock::Parameter, Solver::Fast) {
        return Ok(control_equations::solve_control_points(sub, solution));
    }
    solution.begin_iteration(sub)?;
    if sub.section_indices().is_empty() {
        return Ok(true);
    }
    if (sub.options.lock, sub.options.solver) != (Lock::SelfConsistent, Solver::Fast) {
        return sweeps::solve_by_sweeps(sub, solution, out);
    }
    // Medians have t = 1/2 in any triangle.
    if sub.options.method.chord_exponent() == Some(0.0) {
        return Ok(true);
    }
    match self_consistent::is_in_xy_plane(sub, solution) {
        true => planar.solve_with_self_consistent_point_parameters(sub, solution, out),
        false => spatial.solve_with_self_consistent_point_parameters(sub, solution, out),
    }
}

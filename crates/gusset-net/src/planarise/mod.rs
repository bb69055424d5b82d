//! Planarisation: moves nodes so that all cells are plane (Deryagin, "Soft deformations": plane
//! trapezoid cells, the facing of smooth surfaces by quadrangular tiles).
//!
//! A cell with corners a, b, c, d is plane if its diagonals meet: g = n . (b - a) = 0, where n is
//! the unit normal of both diagonals. The solver seeks the closest net with plane cells:
//!
//! ```text
//! minimise |x - x0|^2 / 2  subject to  g_k(x) = 0 for each cell k,
//! ```
//!
//! where x are the positions of the vertices (classes of glued nodes). At a stationary point x -
//! x0 = -J^T y, with the Jacobian J of g.
//!
//! The first stage replaces the constraints by the penalty |g|^2 / (2 m). A Gauss-Newton step
//! solves (J J^T + m) y = g + J (x0 - x), a sparse system with one unknown a cell, and moves to
//! x0 - J^T y. The factor m decreases from step to step, and steps are halved until the penalised
//! sum decreases. The second stage removes the rest of g by Newton steps of least length, x - J^T
//! (J J^T)^-1 g, which converge quadratically.
//!
//! The problem is stated by Y. Liu et al., *Geometric modeling with conical meshes and developable
//! surfaces* (2006), section 2; their fairness terms are omitted. A step factors a matrix with nine
//! entries a row: O(n^1.5) operations and O(n log n) memory for n cells. It runs on one thread.

mod constraints;
pub(crate) mod elimination_order;
pub(crate) mod scaled_vertices;
mod planar_search;
mod planarise_options;

use super::Net;
use constraints::PlanarityConstraints;
use gusset_base::error::{Error, Result};
use gusset_base::job::Job;
use gusset_mesh::Scalar;
use planar_search::PlanarSearch;
pub use planarise_options::PlanariseOptions;
use planarise_options::STAGE;
use scaled_vertices::ScaledVertices;

/// The result of [`planarise`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Planarised {
    /// The diagonal of the net's bounding box before the call.
    pub size: f64,
    /// The distance up to which a cell counts as plane: the tolerance times the size.
    pub tolerance: f64,
    /// The largest distance of the corners of a cell from its mean plane before the call.
    pub deviation_before: f64,
    /// The largest distance of the corners of a cell from its mean plane in the stored result.
    pub deviation_after: f64,
    /// The cell with that distance; `None` if the net lacks cells of four corners.
    pub worst_cell: Option<u32>,
    /// The largest displacement of a vertex.
    pub max_displacement: f64,
    /// The root mean square displacement of the vertices of cells with four corners.
    pub rms_displacement: f64,
    /// The number of steps; 0 if all cells were plane.
    pub iterations: u32,
    /// Whether `deviation_after` is within the tolerance.
    pub converged: bool,
}

/// The default limit on steps.
const DEFAULT_ITERATIONS: u32 = 100;

/// Moves the nodes of a net as little as possible so that its cells are plane.
///
/// Cells with three or fewer corners after gluing or missing nodes are plane already, and hidden
/// cells do not count. If all cells are within the tolerance of their planes, no bit changes. If
/// the steps do not converge, the result says so, and the net has the best positions found.
///
/// # Errors
/// [`Error::OptionOutOfRange`] for a tolerance that is negative or not finite,
/// [`Error::ArrayTooShort`] for flags of some nodes only, [`Error::OutOfMemory`],
/// [`Error::Cancelled`]. The net is then unchanged.
pub fn planarise(net: &mut Net<'_>, options: &PlanariseOptions<'_>, job: &Job<'_>) -> Result<Planarised> {
    let relative = relative_tolerance(net, options)?;
    job.step(0.0, STAGE)?;
    let surface = ScaledVertices::new(net, options, &job.sub_job(0.0, 0.05))?;
    let constraints = PlanarityConstraints::new(net, &surface, &job.sub_job(0.05, 0.1))?;
    let (deviation_before, worst_cell) = constraints.max_deviation(&surface.positions);
    let tolerance = relative * surface.box_diagonal;
    let unit = surface.unit;
    let mut report = Planarised {
        size: surface.box_diagonal * unit,
        tolerance: tolerance * unit,
        deviation_before: deviation_before * unit,
        deviation_after: deviation_before * unit,
        worst_cell,
        max_displacement: 0.0,
        rms_displacement: 0.0,
        iterations: 0,
        converged: deviation_before <= tolerance,
    };
    if report.converged {
        return Ok(report);
    }
    let max = if options.max_iterations == 0 { DEFAULT_ITERATIONS } else { options.max_iterations };
    // Rounding to the net's type needs some margin below the tolerance.
    let mut search = PlanarSearch::new(&constraints, &surface.positions, 0.1 * tolerance, max, &job.sub_job(0.1, 0.98));
    let mut stored = search.run()?;
    report.iterations = search.step_count;
    job.step(0.98, STAGE)?;
    surface.round_to_scalar(&mut stored, net.coordinates().scalar());
    let (deviation_after, worst_cell) = constraints.max_deviation(&stored);
    (report.deviation_after, report.worst_cell) = (deviation_after * unit, worst_cell);
    report.converged = deviation_after <= tolerance;
    job.step(1.0, STAGE)?;
    // Nothing below can fail.
    surface.move_nodes(net, &stored);
    let (mut squares, mut count) = (0.0, 0);
    for v in constraints.constrained_vertices() {
        let displacement = stored[v].distance(surface.positions[v]);
        report.max_displacement = report.max_displacement.max(displacement * unit);
        squares += displacement * displacement;
        count += 1;
    }
    report.rms_displacement = (squares / f64::from(count)).sqrt() * unit;
    Ok(report)
}

/// Returns the tolerance relative to the diagonal of the bounding box, after checks of the options.
fn relative_tolerance(net: &Net<'_>, options: &PlanariseOptions<'_>) -> Result<f64> {
    Error::require(
        options.tolerance >= 0.0 && options.tolerance.is_finite(),
        "tolerance",
        options.tolerance,
        "finite and at least 0",
    )?;
    let (needed, given) = (net.shape().node_count() as u64, options.fixed.len() as u64);
    if given != 0 && given < needed {
        return Err(Error::ArrayTooShort { what: "fixed", needed, given });
    }
    Ok(match (options.tolerance, net.coordinates().scalar()) {
        (0.0, Scalar::F64) => 1e-10,
        (0.0, Scalar::F32) => 4e-7,
        (given, _) => given,
    })
}

#[cfg(test)]
mod tests {
    use super::{PlanariseOptions, STAGE, planarise};
    use crate::{Net, Shape, Sides, Topology};
    use glam::DVec3;
    use gusset_base::job::{Job, Progress};
    use gusset_mesh::Scalar;
    use std::cell::RefCell;
    use std::ops::ControlFlow;

    /// The stages of all reports.
    #[derive(Default)]
    struct Stages(RefCell<Vec<&'static str>>);

    impl Progress for Stages {
        fn step(&self, _: f64, stage: &'static str) -> ControlFlow<()> {
            self.0.borrow_mut().push(stage);
            ControlFlow::Continue(())
        }
    }

    #[test]
    fn passes_over_all_cells_report_between_solutions() {
        let topology = Topology::from_sides(Shape::new(9, 9).unwrap(), Sides::SHEET);
        let node = |i: usize, j: usize| DVec3::new(i as f64, j as f64, (3 * i * i + 5 * j * i % 7) as f64 / 9.0);
        let mut net = Net::from_fn(topology, Scalar::F64, node).unwrap();
        let stages = Stages::default();
        let options = PlanariseOptions { tolerance: 0.0, max_iterations: 6, keep_boundary: false, fixed: &[] };
        let report = planarise(&mut net, &options, &Job::new(1, &stages)).unwrap();
        assert!(report.iterations > 3, "{report:?}");
        let stages = stages.0.into_inner();
        let between = stages.split(|&stage| stage != STAGE).filter(|own| !own.is_empty());
        let counts: Vec<_> = between.map(<[_]>::len).collect();
        // The solution, the sums or deviations, the next constraints, and their matrix.
        assert!(counts.len() as u32 > report.iterations && counts.iter().all(|&count| count >= 4), "{counts:?}");
    }
}

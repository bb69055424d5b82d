//! Diameters of cells, from control nets.
//!
//! The paper assumes that d is known. A bare net does not determine it: a cell may contain any
//! bump, and half the perimeter bounds only the edge (erratum E6). Patches determine it:
//! - *Euclidean*: a patch lies in the hull of its control points, whose diameter is the diameter of
//!   the points.
//! - *intrinsic* (1): a straight path in the parameters has the speed |a S_u + b S_v| with |a|, |b|
//!   <= 1, which is convex in a and b. It is at most the larger of |S_u + S_v| and |S_u - S_v|, and
//!   at most |S_u| + |S_v|. Bézier points bound each of these.
//!
//! For distances in space, the Euclidean diameter suffices (erratum E8). The rotation of normals by
//! curvature requires the intrinsic one.

use super::cell_grid_shape::CellGridShape;
use super::cell_sizes::{BOUND_ROUNDING_FACTOR, CellSizeBounds};
use crate::cells::{SheetCells, compute_cell_values};
use crate::{Patch, Sheet, each_sheet};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;

/// Bounds of the diameters of all cells of a sheet.
#[derive(Debug, Clone, PartialEq)]
pub struct Diameters {
    /// Bounds of distances in space.
    pub euclidean: CellSizeBounds,
    /// Bounds of the lengths of shortest curves within the cell.
    pub intrinsic: CellSizeBounds,
}

impl Diameters {
    /// Bounds the diameters of all cells, on the job's threads. O(cells).
    ///
    /// # Errors
    /// [`gusset_base::Error::OutOfMemory`], [`gusset_base::Error::Cancelled`].
    pub fn new(sheet: &Sheet<'_>, job: &Job<'_>) -> Result<Self> {
        let lattice = CellGridShape::new(sheet);
        let both = compute_cell_values(
            lattice.cells,
            "cells",
            job,
            |cell| each_sheet!(sheet, cells => cell_diameters(cells, lattice, cell)),
        )?;
        let part = |k: usize| alloc::collect(both.iter().map(|pair: &[f64; 2]| pair[k]));
        Ok(Diameters {
            euclidean: CellSizeBounds::new(lattice, part(0)?),
            intrinsic: CellSizeBounds::new(lattice, part(1)?),
        })
    }
}

/// The Euclidean and the intrinsic diameter of a cell.
fn cell_diameters<const N: usize>(cells: &impl SheetCells<N>, lattice: CellGridShape, [i, j]: [usize; 2]) -> [f64; 2] {
    let patch = cells.cell_patch(i, j);
    let seen = lattice.corner_nodes([i, j]).map(|[i, j]| cells.corner_point(i, j));
    let [[a, b], [c, d]] = patch.corner_points();
    let gap = [a, b, c, d].into_iter().zip(seen).map(|(own, seen)| own.distance(seen)).fold(0.0, f64::max);
    let intrinsic = patch.intrinsic_diameter();
    [patch.euclidean_diameter(&seen).min(intrinsic + 2.0 * gap), intrinsic].map(|bound| bound * BOUND_ROUNDING_FACTOR)
}

impl<const N: usize> Patch<N> {
    /// A bound of the distance between any two points of the patch and of `others`.
    fn euclidean_diameter(&self, others: &[DVec3]) -> f64 {
        let points = self.points.as_flattened();
        let mut greatest = 0.0_f64;
        for (k, point) in points.iter().enumerate() {
            let rest = points[k + 1..].iter().chain(others);
            greatest = rest.fold(greatest, |greatest, other| greatest.max(point.distance_squared(*other)));
        }
        for (k, point) in others.iter().enumerate() {
            greatest = others[k + 1..].iter().fold(greatest, |most, other| most.max(point.distance_squared(*other)));
        }
        greatest.sqrt()
    }

    /// A bound of the length of the shortest curve on the patch between two of its points.
    fn intrinsic_diameter(&self) -> f64 {
        let [along_u, along_v] =
            [self.u_derivative_of_full_degree(), self.transposed().u_derivative_of_full_degree().transposed()];
        let longest =
            |points: &mut dyn Iterator<Item = DVec3>| points.map(DVec3::length_squared).fold(0.0, f64::max).sqrt();
        let pairs = || along_u.points.as_flattened().iter().zip(along_v.points.as_flattened());
        let sum = longest(&mut pairs().map(|(u, v)| *u + *v));
        let difference = longest(&mut pairs().map(|(u, v)| *u - *v));
        // Without degree elevation, the control vectors of the slopes are longer, but their sum may
        // be smaller.
        let degree = (N - 1) as f64;
        let own = |patch: &Patch<N>| {
            let steps = (1..N).flat_map(|a| (0..N).map(move |b| (a, b)));
            degree * longest(&mut steps.map(|(a, b)| patch.points[a][b] - patch.points[a - 1][b]))
        };
        (own(self) + own(&self.transposed())).min(sum.max(difference))
    }

    /// S_u, raised to the degrees of the patch.
    fn u_derivative_of_full_degree(&self) -> Patch<N> {
        let degree = (N - 1) as f64;
        let step = |a: usize, b: usize| degree * (self.points[a + 1][b] - self.points[a][b]);
        let mut slope = *self;
        for a in 0..N {
            let share = a as f64 / degree;
            for b in 0..N {
                // P'_a = a / n P_a-1 + (1 - a / n) P_a. At both ends, one of the two has weight 0
                // and does not exist.
                let before = if a > 0 { share * step(a - 1, b) } else { DVec3::ZERO };
                let after = if a + 1 < N { (1.0 - share) * step(a, b) } else { DVec3::ZERO };
                slope.points[a][b] = before + after;
            }
        }
        slope
    }
}

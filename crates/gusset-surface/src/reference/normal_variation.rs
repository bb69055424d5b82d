//! Task b) of the paper: places where the normal makes a given angle with a direction.
//!
//! Normals take the place of points, and angles of distances. The deviation psi = |angle(N,
//! direction) - alpha| does not increase faster than N turns (theorem T4; the paper has only alpha
//! = 0, erratum E4). The variation of normals over a cell is the largest angle between two of them.
//! It is bounded
//! - by curvature, as in the paper: K times the intrinsic diameter, where K bounds both principal
//!   curvatures of the whole surface;
//! - or by the cell's normal cone, which is tighter and does not need K.

use super::cell_grid_shape::CellGridShape;
use super::cell_sizes::CellSizeBounds;
use super::diameter::Diameters;
use super::reference_search::{SearchOptions, SearchOutcome, search};
use crate::cells::{SheetCells, compute_cell_values};
use crate::normal::angle_between_unit_vectors;
use crate::{MAX_DEGREE, Patch, Sheet, each_sheet};
use glam::DVec3;
use gusset_base::error::{Error, Result};
use gusset_base::geom::bernstein::binomial_row;
use gusset_base::job::Job;
use std::f64::consts::PI;

/// An upper bound of the rounding of angles.
const MAX_ANGLE_ROUNDING_RADIANS: f64 = 1e-13;

/// Bounds the variation by normal cones. The bound is pi where a cone of less than a quarter turn
/// does not exist, as where the surface is not regular.
///
/// # Errors
/// [`Error::OutOfMemory`], [`Error::Cancelled`].
pub fn normal_variation_by_cones(sheet: &Sheet<'_>, job: &Job<'_>) -> Result<CellSizeBounds> {
    let lattice = CellGridShape::new(sheet);
    let cone = |cell: [usize; 2]| {
        let (axis, half) = each_sheet!(sheet, cells => normal_cone_of_cell(cells, cell))?;
        let reach = |node: DVec3| if node == DVec3::ZERO { PI } else { angle_between_unit_vectors(axis, node) };
        // Corners as the neighbours compute them, where normals may jump.
        let corners =
            lattice.corner_nodes(cell).map(|node| reach(normal_at_node(sheet, node))).into_iter().fold(0.0, f64::max);
        Some(2.0 * half.max(corners) + MAX_ANGLE_ROUNDING_RADIANS)
    };
    Ok(CellSizeBounds::new(
        lattice,
        compute_cell_values(lattice.cells, "cells", job, |cell| cone(cell).map_or(PI, |variation| variation.min(PI)))?,
    ))
}

/// Bounds the variation by curvature: K d plus the jumps of normals at corners. `curvature` is the
/// bound K of the absolute principal curvatures of the surface. The caller is responsible for it;
/// [`super::curvature_bound`] computes a proven one.
///
/// # Errors
/// [`Error::OptionOutOfRange`] if the curvature is NaN or negative, [`Error::OutOfMemory`],
/// [`Error::Cancelled`].
pub fn normal_variation_by_curvature(
    sheet: &Sheet<'_>,
    diameters: &Diameters,
    curvature: f64,
    job: &Job<'_>,
) -> Result<CellSizeBounds> {
    Error::require(curvature >= 0.0, "curvature", curvature, "at least 0")?;
    let lattice = CellGridShape::new(sheet);
    let variation = |cell: [usize; 2]| {
        let own = [[0.0, 0.0], [0.0, 1.0], [1.0, 0.0], [1.0, 1.0]].map(|[u, v]| sheet.normal(cell[0], cell[1], u, v));
        let seen = lattice.corner_nodes(cell).map(|node| normal_at_node(sheet, node));
        let jump = own.into_iter().zip(seen).map(|(a, b)| angle_between_unit_vectors(a, b)).fold(0.0, f64::max);
        let regular = own.into_iter().chain(seen).all(|normal| normal != DVec3::ZERO);
        let turn = curvature * diameters.intrinsic.get(cell) + 2.0 * jump + MAX_ANGLE_ROUNDING_RADIANS;
        if regular { turn.min(PI) } else { PI }
    };
    Ok(CellSizeBounds::new(lattice, compute_cell_values(lattice.cells, "cells", job, variation)?))
}

/// The unit normal at a node, from the cell that begins there, or from the last cell; zero if no
/// normal exists.
fn normal_at_node(sheet: &Sheet<'_>, node: [usize; 2]) -> DVec3 {
    let cells = sheet.cells();
    let of = |k: usize| if node[k] < cells[k] { (node[k], 0.0) } else { (cells[k] - 1, 1.0) };
    let ((i, u), (j, v)) = (of(0), of(1));
    sheet.normal(i, j, u, v)
}

/// Normals at an angle to a direction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AngleTarget {
    /// The direction, of any nonzero length.
    pub direction: DVec3,
    /// The angle, from 0 to pi.
    pub angle: f64,
    /// True if a normal and its opposite are equivalent.
    pub unsigned: bool,
}

impl AngleTarget {
    /// The target with a unit direction.
    ///
    /// # Errors
    /// [`Error::OptionOutOfRange`] if the direction is zero or not finite, or the angle is out of
    /// range.
    pub fn normalized(self) -> Result<Self> {
        Error::require((0.0..=PI).contains(&self.angle), "angle", self.angle, "from 0 to pi")?;
        let direction = Some(self.direction).filter(|direction| direction.is_finite()).and_then(DVec3::try_normalize);
        let value = self.direction.length();
        Ok(AngleTarget {
            direction: direction.ok_or(Error::OptionOutOfRange {
                option: "direction",
                value,
                allowed: "a finite vector other than 0".into(),
            })?,
            ..self
        })
    }

    /// The deviation of a unit normal from the angle; 0 if the normal does not exist, because it
    /// may be any vector.
    pub fn deviation(&self, normal: DVec3) -> f64 {
        if normal == DVec3::ZERO {
            return 0.0;
        }
        let off = |normal: DVec3| (angle_between_unit_vectors(normal, self.direction) - self.angle).abs();
        if self.unsigned { off(normal).min(off(-normal)) } else { off(normal) }
    }
}

/// Finds the cells that may have a normal within a deviation of an angle, or the nearest to it, by
/// the corrected search.
///
/// # Errors
/// The errors of [`AngleTarget::normalized`] and [`search`].
pub fn find_cells_with_angle(
    sheet: &Sheet<'_>,
    variation: &CellSizeBounds,
    target: AngleTarget,
    options: &SearchOptions,
    job: &Job<'_>,
) -> Result<SearchOutcome> {
    let target = target.normalized()?;
    search(variation, |node| target.deviation(normal_at_node(sheet, node)), options, job)
}

/// The axis and the half-angle of a cone that contains all normals of a cell, because it contains
/// the Bézier points of S_u x S_v. Returns `None` for a quarter turn or more. Where a side is a
/// single point, the cone contains the limits of the normals.
fn normal_cone_of_cell<const N: usize>(cells: &impl SheetCells<N>, [i, j]: [usize; 2]) -> Option<(DVec3, f64)> {
    let normals = cells.cell_patch(i, j).bezier_points_of_normals();
    // Where the normal vanishes, rounding is not a direction.
    let noise = 1e-13 * normals.iter().map(|normal| normal.length()).fold(0.0, f64::max);
    let directions = || normals.iter().filter(|normal| normal.length() > noise);
    let axis = directions().map(|normal| normal.normalize_or_zero()).sum::<DVec3>().try_normalize()?;
    let half = directions().map(|&normal| angle_between_unit_vectors(axis, normal)).fold(0.0, f64::max);
    (half < 0.5 * PI).then_some((axis, half))
}

impl<const N: usize> Patch<N> {
    /// The Bézier points of S_u x S_v, of degree 2 N - 3 in u and in v: sums of products, weighted
    /// by binomials.
    fn bezier_points_of_normals(&self) -> Vec<DVec3> {
        let (degree, width) = (N - 1, 2 * N - 2);
        let (lower, full) = (binomial_row::<N>(degree - 1), binomial_row::<N>(degree));
        let product = binomial_row::<{ 2 * MAX_DEGREE }>(width - 1);
        let mut sums = vec![DVec3::ZERO; width * width];
        for (a, b) in (0..degree).flat_map(|a| (0..N).map(move |b| (a, b))) {
            let along_u = (self.points[a + 1][b] - self.points[a][b]) * (lower[a] * full[b]);
            for (c, d) in (0..N).flat_map(|c| (0..degree).map(move |d| (c, d))) {
                let weight = full[c] * lower[d];
                let along_v = (self.points[c][d + 1] - self.points[c][d]) * weight;
                sums[(a + c) * width + b + d] += along_u.cross(along_v);
            }
        }
        for (k, sum) in sums.iter_mut().enumerate() {
            *sum /= product[k / width] * product[k % width];
        }
        sums
    }
}

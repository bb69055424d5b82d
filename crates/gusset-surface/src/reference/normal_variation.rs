//! Task b) of the paper: places where the normal makes a given angle with a direction.
//!
//! The normal plays the part of the point, angles that of distances: the deviation psi = |angle(N,
//! direction) - alpha| does not rise faster than N turns (theorem T4; the paper has alpha = 0 only,
//! erratum E4). The variation of normals over a cell, the greatest angle between two of them, is
//! bounded
//! * by curvature, the paper's way: K times the intrinsic diameter, K a bound of both principal
//!   curvatures on the whole surface,
//! * or by the cell's normal cone, which is tighter and needs no K.

use super::cell_lattice::Lattice;
use super::diameter::Diameters;
use super::reference_search::{SearchOptions, SearchOutcome, search};
use super::sizes::Sizes;
use crate::cells::{Cells, by_cell};
use crate::normal::angle;
use crate::{MAX_DEGREE, Patch, Sheet, each_sheet};
use glam::DVec3;
use gusset_base::error::{Error, Result};
use gusset_base::geom::bernstein::binomial_row;
use gusset_base::job::Job;
use std::f64::consts::PI;

/// An upper bound of the rounding of angles.
const ANGLE_ROUNDING: f64 = 1e-13;

/// The variation by normal cones; pi where there is no cone of less than a quarter turn, as
/// where the surface is not regular.
///
/// # Errors
/// [`Error::OutOfMemory`], [`Error::Cancelled`].
pub fn normal_variation_by_cones(sheet: &Sheet<'_>, job: &Job<'_>) -> Result<Sizes> {
    let lattice = Lattice::of(sheet);
    let cone = |cell: [usize; 2]| {
        let (axis, half) = each_sheet!(sheet, cells => cone(cells, cell))?;
        let reach = |node: DVec3| if node == DVec3::ZERO { PI } else { angle(axis, node) };
        // Corners as the neighbours see them, where normals may jump.
        let corners = lattice.corners(cell).map(|node| reach(normal(sheet, node))).into_iter().fold(0.0, f64::max);
        Some(2.0 * half.max(corners) + ANGLE_ROUNDING)
    };
    Ok(Sizes::new(
        lattice,
        by_cell(lattice.cells, "cells", job, |cell| cone(cell).map_or(PI, |variation| variation.min(PI)))?,
    ))
}

/// The variation by curvature: K d, and the jumps of normals at corners. `curvature`: K, no
/// principal curvature of the surface is greater in absolute terms. That is the caller's promise;
/// [`super::curvature_bound`] proves one.
///
/// # Errors
/// [`Error::OptionOutOfRange`] for a curvature that is no number or negative,
/// [`Error::OutOfMemory`], [`Error::Cancelled`].
pub fn normal_variation_by_curvature(
    sheet: &Sheet<'_>,
    diameters: &Diameters,
    curvature: f64,
    job: &Job<'_>,
) -> Result<Sizes> {
    Error::require(curvature >= 0.0, "curvature", curvature)?;
    let lattice = Lattice::of(sheet);
    let variation = |cell: [usize; 2]| {
        let own = [[0.0, 0.0], [0.0, 1.0], [1.0, 0.0], [1.0, 1.0]].map(|[u, v]| sheet.normal(cell[0], cell[1], u, v));
        let seen = lattice.corners(cell).map(|node| normal(sheet, node));
        let jump = own.into_iter().zip(seen).map(|(a, b)| angle(a, b)).fold(0.0, f64::max);
        let regular = own.into_iter().chain(seen).all(|normal| normal != DVec3::ZERO);
        let turn = curvature * diameters.intrinsic.get(cell) + 2.0 * jump + ANGLE_ROUNDING;
        if regular { turn.min(PI) } else { PI }
    };
    Ok(Sizes::new(lattice, by_cell(lattice.cells, "cells", job, variation)?))
}

/// The unit normal at a node: that of the cell from there on, or of the last one; 0 if there is
/// none.
fn normal(sheet: &Sheet<'_>, node: [usize; 2]) -> DVec3 {
    let cells = sheet.cells();
    let of = |k: usize| if node[k] < cells[k] { (node[k], 0.0) } else { (cells[k] - 1, 1.0) };
    let ((i, u), (j, v)) = (of(0), of(1));
    sheet.normal(i, j, u, v)
}

/// Normals at an angle to a direction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AngleTarget {
    /// Of any length but 0.
    pub direction: DVec3,
    /// From 0 to pi.
    pub angle: f64,
    /// True if the other side's normal will do as well.
    pub unsigned: bool,
}

impl AngleTarget {
    /// The same with a unit direction.
    ///
    /// # Errors
    /// [`Error::OptionOutOfRange`] for no direction, or an angle out of range.
    pub fn normalized(self) -> Result<Self> {
        Error::require((0.0..=PI).contains(&self.angle), "angle", self.angle)?;
        let direction = Some(self.direction).filter(|direction| direction.is_finite()).and_then(DVec3::try_normalize);
        let value = self.direction.length();
        Ok(AngleTarget { direction: direction.ok_or(Error::OptionOutOfRange { option: "direction", value })?, ..self })
    }

    /// How far a unit normal is from the angle; 0 if there is no normal, which may be any.
    pub fn deviation(&self, normal: DVec3) -> f64 {
        if normal == DVec3::ZERO {
            return 0.0;
        }
        let off = |normal: DVec3| (angle(normal, self.direction) - self.angle).abs();
        if self.unsigned { off(normal).min(off(-normal)) } else { off(normal) }
    }
}

/// The cells that may have a normal within a deviation of an angle, or the nearest to it, by the
/// corrected search.
///
/// # Errors
/// Those of [`AngleTarget::normalized`] and [`search`].
pub fn angle_incidence(
    sheet: &Sheet<'_>,
    variation: &Sizes,
    target: AngleTarget,
    options: &SearchOptions,
    job: &Job<'_>,
) -> Result<SearchOutcome> {
    let target = target.normalized()?;
    search(variation, |node| target.deviation(normal(sheet, node)), options, job)
}

/// The axis and the half-angle of a cone that has all normals of a cell, as it has the Bézier
/// points of S_u x S_v. `None` for a quarter turn or more. Where a side is one point, the cone has
/// the limits of the normals there.
fn cone<const N: usize>(cells: &impl Cells<N>, [i, j]: [usize; 2]) -> Option<(DVec3, f64)> {
    let normals = cells.patch(i, j).normal_points();
    // What rounding leaves where the normal is 0 is no direction.
    let noise = 1e-13 * normals.iter().map(|normal| normal.length()).fold(0.0, f64::max);
    let directions = || normals.iter().filter(|normal| normal.length() > noise);
    let axis = directions().map(|normal| normal.normalize_or_zero()).sum::<DVec3>().try_normalize()?;
    let half = directions().map(|&normal| angle(axis, normal)).fold(0.0, f64::max);
    (half < 0.5 * PI).then_some((axis, half))
}

impl<const N: usize> Patch<N> {
    /// The Bézier points of S_u x S_v, of degree 2 N - 3 in u and in v: of products, sums of
    /// products by binomial weights.
    fn normal_points(&self) -> Vec<DVec3> {
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

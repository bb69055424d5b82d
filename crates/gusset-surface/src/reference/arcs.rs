//! The logical scale over the points of a curve, with which the paper ends: "all conclusions hold
//! for curves, too; the points of a curve are its net, and the diameter of a piece is its length".
//!
//! A curve is a lattice of one row, closed across itself. Its cells are arcs, and its nodes the
//! ends of arcs, so the search and its theorems for surfaces apply. The length of a control polygon
//! bounds the length of its arc. Corrections E1 to E3 apply to nodes of arcs too. For angles (task
//! b), the variation of the tangent takes the place of length. It is the largest angle between legs
//! of the control polygon, whose cone contains all tangents, and the tangents at the nodes as the
//! neighbours compute them.

use super::cell_grid_shape::CellGridShape;
use super::cell_sizes::{BOUND_ROUNDING_FACTOR, CellSizeBounds};
use super::figure::Figure;
use super::normal_variation::AngleTarget;
use super::reference_search::{SearchOptions, SearchOutcome, search};
use crate::normal::angle_between_unit_vectors;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::geom::bernstein::restrict;
use gusset_base::job::Job;
use gusset_curve::{CurveView, Place};
use std::f64::consts::PI;

/// Largest number of arcs.
pub const MAX_ARCS: u64 = 1 << 30;
/// An upper bound of the rounding of angles.
const MAX_ANGLE_ROUNDING_RADIANS: f64 = 1e-9;

/// The points of a curve, and bounds of the arcs between them.
#[derive(Debug, Clone, PartialEq)]
pub struct CurveArcs {
    /// Bounds of the lengths of arcs.
    pub lengths: CellSizeBounds,
    /// Bounds of the angles between tangents of an arc; pi if no bound is known.
    pub variation: CellSizeBounds,
    points: Vec<DVec3>,
    tangents: Vec<DVec3>,
}

impl CurveArcs {
    /// Divides each segment of a curve into `parts` arcs of equal length in the parameter. Arc k is
    /// part k % parts of segment k / parts. O(arcs), with O(degree^2) for each.
    ///
    /// # Errors
    /// [`Error::EmptyCurve`]; [`Error::OptionOutOfRange`] if `parts` is 0; [`Error::TooLarge`]
    /// above [`MAX_ARCS`]; [`Error::OutOfMemory`], [`Error::Cancelled`].
    pub fn new(curve: &CurveView<'_>, parts: usize, job: &Job<'_>) -> Result<Self> {
        if curve.is_empty() {
            return Err(Error::EmptyCurve);
        }
        Error::require(parts > 0, "parts", parts as f64, "at least 1")?;
        let count = (curve.len() as u64).saturating_mul(parts as u64);
        Error::check_count("arcs", count, MAX_ARCS)?;
        let count = count as usize;
        let lattice = CellGridShape { cells: [1, count], closed: [true, curve.is_closed()] };
        let place = |k: usize| match k {
            _ if k == count => Place { segment: curve.len() as u32 - 1, t: 1.0 },
            _ => Place { segment: (k / parts) as u32, t: (k % parts) as f64 / parts as f64 },
        };
        let places = alloc::collect((0..count + 1).map(place))?;
        let points = curve.points_at(&places, &job.sub_job(0.0, 0.1))?;
        let (tangents, job) = (curve.tangents_at(&places, &job.sub_job(0.1, 0.3))?, job.sub_job(0.3, 1.0));
        let (mut lengths, mut variation) = (alloc::with_capacity(count)?, alloc::with_capacity(count)?);
        let mut controls = Vec::new();
        for k in 0..count {
            job.step_every(1024, k, count, "arcs")?;
            controls.clear();
            alloc::append(&mut controls, curve.segment(k / parts))?;
            let part = k % parts;
            restrict(&mut controls, [part, part + 1].map(|end| end as f64 / parts as f64));
            // The ends as the neighbours compute them, equal except for rounding.
            let gap = points[k].distance(controls[0]) + points[k + 1].distance(controls[controls.len() - 1]);
            let legs = || controls.windows(2).map(|pair| pair[1] - pair[0]);
            let polygon: f64 = legs().map(DVec3::length).sum();
            lengths.push((polygon + gap) * BOUND_ROUNDING_FACTOR);
            variation.push(max_tangent_turn(&controls, [tangents[k], tangents[(k + 1) % lattice.lines()[1]]]));
        }
        Ok(CurveArcs {
            lengths: CellSizeBounds::new(lattice, lengths),
            variation: CellSizeBounds::new(lattice, variation),
            points,
            tangents,
        })
    }

    /// The lattice of the arcs: a row of cells, whose nodes are the points of the curve.
    pub fn lattice(&self) -> CellGridShape {
        self.lengths.lattice()
    }

    /// Finds the arcs that may have a point within a distance of a figure, or the nearest one, by
    /// the corrected search.
    ///
    /// # Errors
    /// The errors of [`super::find_cells_near_figure`].
    pub fn find_arcs_near_figure(
        &self,
        figure: Figure<'_>,
        options: &SearchOptions,
        job: &Job<'_>,
    ) -> Result<SearchOutcome> {
        figure.search_cells(&self.lengths, &|[_, k]| self.points[k], options, job)
    }

    /// Finds the arcs that may have a tangent within a deviation of an angle, or the nearest to it.
    ///
    /// # Errors
    /// The errors of [`AngleTarget::normalized`] and [`search`].
    pub fn find_cells_with_angle(
        &self,
        target: AngleTarget,
        options: &SearchOptions,
        job: &Job<'_>,
    ) -> Result<SearchOutcome> {
        let target = target.normalized()?;
        search(&self.variation, |[_, k]| target.deviation(self.tangents[k]), options, job)
    }
}

/// Bounds the angles between the tangents of an arc and the tangents at its ends. The bound is
/// twice the half-angle of a cone that contains the legs of its control polygon.
fn max_tangent_turn(controls: &[DVec3], ends: [DVec3; 2]) -> f64 {
    let legs = || controls.windows(2).map(|pair| pair[1] - pair[0]);
    let longest = legs().map(DVec3::length).fold(0.0, f64::max);
    let Some(axis) = legs().sum::<DVec3>().try_normalize() else { return PI };
    // A leg of length zero lacks a direction, because the derivative may vanish there.
    if legs().any(|leg| leg.length() <= 1e-13 * longest) || ends.contains(&DVec3::ZERO) {
        return PI;
    }
    let half = legs().chain(ends).map(|leg| angle_between_unit_vectors(axis, leg)).fold(0.0, f64::max);
    if half < 0.5 * PI { (2.0 * half + MAX_ANGLE_ROUNDING_RADIANS).min(PI) } else { PI }
}

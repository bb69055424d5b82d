//! Figures from which distances are measured: points, planes and lines, curves, and surfaces. The
//! search for the cells of a sheet that are close to a figure (tasks a, c, d and e of the paper).

use super::cell_sizes::CellSizeBounds;
use super::diameter::Diameters;
use super::object::{OrthonormalBox, PointPlaneOrLine};
use super::reference_search::{SearchOptions, SearchOutcome, search_with_node_cost};
use crate::{Sheet, Surface};
use glam::DVec3;
use gusset_base::error::{Error, Result};
use gusset_base::geom::Aabb;
use gusset_base::job::Job;
use gusset_curve::CurveView;
use gusset_curve::ops::CurveSearch;

/// A figure from which distances are measured.
#[derive(Debug, Clone, Copy)]
pub enum Figure<'a> {
    /// A point, plane or line.
    Object(PointPlaneOrLine),
    /// A curve.
    Curve(CurveView<'a>),
    /// A surface.
    Surface(&'a Surface<'a>),
}

/// Bound of the rounding error of the nearest points of a curve, as a fraction of the curve's size
/// and the distance.
const MAX_RELATIVE_CURVE_ROUNDING: f64 = 1e-9;

/// Computes distances from a figure, rounded down.
enum FigureDistance<'a> {
    Object(OrthonormalBox),
    Curve { search: CurveSearch<'a>, size: f64 },
    Surface(&'a Surface<'a>),
}

impl<'a> Figure<'a> {
    /// Prepares the measurement of distances.
    ///
    /// # Errors
    /// The errors of [`PointPlaneOrLine::as_orthonormal_box`]; [`Error::EmptyCurve`], [`Error::OutOfMemory`].
    fn prepare_distance_measure(&self) -> Result<FigureDistance<'a>> {
        Ok(match *self {
            Figure::Object(object) => FigureDistance::Object(object.as_orthonormal_box()?),
            Figure::Curve(curve) if curve.is_empty() => return Err(Error::EmptyCurve),
            Figure::Curve(curve) => FigureDistance::Curve {
                search: CurveSearch::new(&curve)?,
                size: Aabb::from_points(curve.points()).diagonal(),
            },
            Figure::Surface(surface) => FigureDistance::Surface(surface),
        })
    }
}

/// Cost of a distance from a figure, in words of the mask.
const CURVE_DISTANCE_COST_IN_WORDS: usize = 1 << 9;
const SURFACE_DISTANCE_COST_IN_WORDS: usize = 1 << 12;

impl Figure<'_> {
    /// Runs the corrected search, with nodes at the given points.
    pub(super) fn search_cells(
        &self,
        sizes: &CellSizeBounds,
        node: &dyn Fn([usize; 2]) -> DVec3,
        options: &SearchOptions,
        job: &Job<'_>,
    ) -> Result<SearchOutcome> {
        let measure = self.prepare_distance_measure()?;
        let cost = match measure {
            FigureDistance::Object(_) => 0,
            FigureDistance::Curve { .. } => CURVE_DISTANCE_COST_IN_WORDS,
            FigureDistance::Surface(_) => SURFACE_DISTANCE_COST_IN_WORDS,
        };
        search_with_node_cost(sizes, cost, &mut |at| measure.distance_lower_bound(node(at)), options, job)
    }
}

impl FigureDistance<'_> {
    /// A lower bound of the distance of a point from the figure.
    fn distance_lower_bound(&self, from: DVec3) -> f64 {
        match self {
            FigureDistance::Object(target) => target.distance(from),
            FigureDistance::Curve { search, size } => {
                let distance = search.nearest(from, &Job::default()).map_or(0.0, |found| found.distance);
                (distance - MAX_RELATIVE_CURVE_ROUNDING * (size + distance)).max(0.0)
            }
            FigureDistance::Surface(surface) => surface.closest(from, f64::INFINITY).map_or(0.0, |found| found.bound),
        }
    }
}

/// Finds the cells that may have a point within a distance of a figure, or the nearest one, by the
/// corrected search.
///
/// # Errors
/// The errors of [`PointPlaneOrLine::as_orthonormal_box`] and [`super::search`]; [`Error::EmptyCurve`].
pub fn find_cells_near_figure(
    sheet: &Sheet<'_>,
    diameters: &Diameters,
    figure: Figure<'_>,
    options: &SearchOptions,
    job: &Job<'_>,
) -> Result<SearchOutcome> {
    figure.search_cells(&diameters.euclidean, &|[i, j]| sheet.corner(i, j), options, job)
}

//! Objects from which distances are measured: points, planes and lines, as boxes in their own axes.

use super::diameter::Diameters;
use super::reference_search::{SearchOptions, SearchOutcome, search};
use crate::Sheet;
use crate::line_intersection::Line;
use glam::DVec3;
use gusset_base::error::{Error, Result};
use gusset_base::job::Job;

/// A point, a plane or a line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum PointPlaneOrLine {
    /// A point.
    Point(DVec3),
    /// The plane through a point, perpendicular to a direction.
    Plane {
        /// A point of the plane.
        point: DVec3,
        /// The normal, of any nonzero length.
        normal: DVec3,
    },
    /// A line, ray or segment.
    Line(Line),
}

/// An object as a box in orthonormal axes, which may be infinite: all points whose coordinates
/// along the axes are within the intervals.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OrthonormalBox {
    origin: DVec3,
    axes: [DVec3; 3],
    /// The smallest and the largest coordinate along each axis.
    intervals: [[f64; 2]; 3],
    /// The number of axes used. Planes need only the first one.
    used_axis_count: usize,
}

impl PointPlaneOrLine {
    /// Returns the object as a box in its own axes.
    ///
    /// # Errors
    /// [`Error::OptionOutOfRange`] if the object is not finite, or lacks a direction.
    pub fn as_orthonormal_box(&self) -> Result<OrthonormalBox> {
        let bad =
            |option, value, allowed: &'static str| Error::OptionOutOfRange { option, value, allowed: allowed.into() };
        let finite = |x: DVec3, option| {
            if x.is_finite() { Ok(x) } else { Err(bad(option, f64::NAN, "finite in every coordinate")) }
        };
        let unit = |x: DVec3, option| {
            finite(x, option)?.try_normalize().ok_or(bad(option, x.length(), "a vector other than 0"))
        };
        let (origin, axes, along, count) = match *self {
            PointPlaneOrLine::Point(point) => (finite(point, "point")?, [DVec3::X, DVec3::Y, DVec3::Z], [0.0; 2], 3),
            PointPlaneOrLine::Plane { point, normal } => {
                let normal = unit(normal, "normal")?;
                let (u, v) = normal.any_orthonormal_pair();
                (finite(point, "point")?, [normal, u, v], [0.0; 2], 1)
            }
            PointPlaneOrLine::Line(Line { origin, direction, from, to }) => {
                let unit = unit(direction, "direction")?;
                if from.is_nan() || to.is_nan() || from > to {
                    return Err(bad("from", from, "at most `to`"));
                }
                let (u, v) = unit.any_orthonormal_pair();
                (finite(origin, "origin")?, [u, v, unit], [from, to].map(|t| t * direction.length()), 3)
            }
        };
        Ok(OrthonormalBox { origin, axes, intervals: [[0.0; 2], [0.0; 2], along], used_axis_count: count })
    }
}

impl OrthonormalBox {
    /// A lower bound of the squared distance of points with coordinates within `ranges`.
    fn squared_distance_bound(&self, ranges: &[[f64; 2]; 3]) -> f64 {
        let gap = |k: usize| (ranges[k][0] - self.intervals[k][1]).max(self.intervals[k][0] - ranges[k][1]).max(0.0);
        (0..self.used_axis_count).map(|k| gap(k) * gap(k)).sum()
    }

    /// Bound of the rounding error of a point's coordinates. The axes of points are the
    /// coordinate axes: only the last bit is rounded, and the result is 0.
    fn max_coordinate_rounding(&self, from: DVec3) -> f64 {
        if self.axes[0] == DVec3::X && self.used_axis_count == 3 {
            0.0
        } else {
            8.0 * f64::EPSILON * (from - self.origin).length()
        }
    }

    /// The distance of a point, rounded down.
    pub fn distance(&self, from: DVec3) -> f64 {
        let ranges = self.axes.map(|axis| [(from - self.origin).dot(axis); 2]);
        (self.squared_distance_bound(&ranges).sqrt() - self.max_coordinate_rounding(from)).max(0.0)
    }
}

/// Finds the cells that may have a point within a distance of an object, or the nearest one, by the
/// corrected search.
///
/// # Errors
/// The errors of [`PointPlaneOrLine::as_orthonormal_box`] and [`search`].
pub fn find_cells_near_object(
    sheet: &Sheet<'_>,
    diameters: &Diameters,
    object: PointPlaneOrLine,
    options: &SearchOptions,
    job: &Job<'_>,
) -> Result<SearchOutcome> {
    let target = object.as_orthonormal_box()?;
    search(&diameters.euclidean, |[i, j]| target.distance(sheet.corner(i, j)), options, job)
}

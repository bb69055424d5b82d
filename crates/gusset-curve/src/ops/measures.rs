//! Several measures of one curve in one call.

use super::{AreaMoments, Bounds};
use crate::curve::{CurveView, Place};
use glam::DVec3;
use gusset_base::error::{Component, Element, Error, Result};
use gusset_base::geom::scale::common_unit;
use gusset_base::job::Job;

/// The number of chords in a segment that measure its centre.
const CHORDS_PER_SEGMENT: u32 = 16;

/// Segments between two progress reports.
const SEGMENTS_PER_REPORT: usize = 1 << 8;

/// The measures that a caller requests.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct MeasureSelection {
    /// Asks for [`Measures::length`].
    pub length: bool,
    /// Asks for [`Measures::bounds`].
    pub bounds: bool,
    /// Asks for [`Measures::centre`].
    pub centre: bool,
    /// Asks for [`Measures::area_vector`].
    pub area: bool,
    /// Asks for [`Measures::moments`].
    pub moments: bool,
}

impl MeasureSelection {
    /// Asks for every measure.
    pub const ALL: Self = MeasureSelection { length: true, bounds: true, centre: true, area: true, moments: true };
}

/// Measures of a curve. A measure is `None` if the caller does not ask for it, or if the curve
/// lacks it.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Measures {
    /// The arc length.
    pub length: Option<f64>,
    /// The smallest box with sides along the axes. A curve without points lacks it.
    pub bounds: Option<Bounds>,
    /// The mean of the points by arc length; see [`CurveView::centre`]. A curve without points
    /// lacks it.
    pub centre: Option<DVec3>,
    /// Half the integral of r x dr; see [`CurveView::area_vector`].
    pub area_vector: Option<DVec3>,
    /// The moments of the enclosed region. Only a curve in the plane z = 0 with points has them, and
    /// only if they are finite: they are fourth powers of lengths.
    pub moments: Option<AreaMoments>,
}

impl Measures {
    /// Returns the length of the area vector: the area of the largest shadow, never negative. 0
    /// without an area vector.
    pub fn area(&self) -> f64 {
        let vector = self.area_vector.unwrap_or_default();
        let unit = common_unit([&vector]);
        (vector / unit).length() * unit
    }

    /// Returns true if no measure has overflowed.
    fn are_finite(&self) -> bool {
        let [low, high] = self.bounds.map_or([DVec3::ZERO; 2], |bounds| [bounds.low, bounds.high]);
        let points = [low, high, self.centre.unwrap_or_default(), self.area_vector.unwrap_or_default()];
        self.length.unwrap_or_default().is_finite() && self.area().is_finite() && points.iter().all(|p| p.is_finite())
    }
}

impl CurveView<'_> {
    /// Computes the measures that `selection` asks for and the curve has. The cost is the sum of
    /// their costs.
    ///
    /// # Errors
    /// [`CoordinateTooLarge`](gusset_base::Error::CoordinateTooLarge) with the largest coordinate if
    /// a measure other than the moments overflows;
    /// [`OutOfMemory`](gusset_base::Error::OutOfMemory),
    /// [`Cancelled`](gusset_base::Error::Cancelled).
    pub fn measures(&self, selection: MeasureSelection, job: &Job<'_>) -> Result<Measures> {
        let MeasureSelection { length, bounds, centre, area, moments } = selection;
        let has_points = !self.points().is_empty();
        let moments = moments && has_points && self.check_in_xy_plane().is_ok();
        let asked = [length, bounds && has_points, centre && has_points, area, moments];
        let share = |k: usize| {
            let count = asked.iter().filter(|&&asked| asked).count();
            asked[k].then(|| job.sub_job_of_item(asked[..k].iter().filter(|&&asked| asked).count(), count))
        };
        let is_finite = |moments: &AreaMoments| {
            moments.area.is_finite() && moments.centroid.is_finite() && moments.second.iter().all(|x| x.is_finite())
        };
        let measures = Measures {
            length: share(0).map(|job| Ok(self.arc_lengths(&job)?.total_length())).transpose()?,
            bounds: share(1).map(|job| self.bounding_box(&job)).transpose()?,
            centre: share(2).map(|job| self.centre(&job)).transpose()?,
            area_vector: share(3).map(|job| self.area_vector(&job)).transpose()?,
            moments: share(4).map(|job| self.moments(&job)).transpose()?.filter(is_finite),
        };
        if measures.are_finite() { Ok(measures) } else { Err(self.describe_largest_coordinate()) }
    }

    /// Returns the error that names the largest coordinate.
    fn describe_largest_coordinate(&self) -> Error {
        let most = self.points().iter().map(|p| p.abs().max_element()).fold(0.0, f64::max);
        let found =
            (0..).zip(self.points()).find_map(|(index, &p)| Some((index, Component::find(p, |x| x.abs() == most)?)));
        let (index, (component, value)) = found.unwrap_or((0, (Component::X, most)));
        Error::CoordinateTooLarge { element: Element::Point, index, component, value }
    }

    /// Computes the mean of the curve's points by arc length, from 16 chords of each segment at
    /// equal steps of the parameter. A curve without length gets its first point, or the origin if
    /// it is empty.
    ///
    /// # Errors
    /// [`Cancelled`](gusset_base::Error::Cancelled). O(degree) for each chord.
    pub fn centre(&self, job: &Job<'_>) -> Result<DVec3> {
        let mut weighted = DVec3::ZERO;
        let mut weight = 0.0;
        let start = self.points().first().copied().unwrap_or(DVec3::ZERO);
        let unit = common_unit(self.points());
        for k in 0..self.len() {
            job.step_every(SEGMENTS_PER_REPORT, k, self.len(), "centre of a curve")?;
            let mut before = DVec3::ZERO;
            for i in 0..=CHORDS_PER_SEGMENT {
                let p = self.point(Place { segment: k as u32, t: f64::from(i) / f64::from(CHORDS_PER_SEGMENT) })?
                    / unit
                    - start / unit;
                if i > 0 {
                    let length = before.distance(p);
                    weighted += before.midpoint(p) * length;
                    weight += length;
                }
                before = p;
            }
        }
        Ok(if weight > 0.0 { start + weighted / weight * unit } else { start })
    }
}

#[cfg(test)]
mod tests {
    use super::MeasureSelection;
    use crate::curve::CurveView;
    use glam::DVec3;
    use gusset_base::error::{Component, Element, Error};
    use gusset_base::job::Job;

    #[test]
    fn measures_are_finite_or_refused() {
        // A triangle of area 6 and length 12, of straight cubics.
        let corners = [DVec3::ZERO, DVec3::new(4.0, 0.0, 0.0), DVec3::new(4.0, -3.0, 0.0), DVec3::ZERO];
        let ends = [0, 3, 6, 9];
        for size in [1e-300, 1e-100, 1.0, 1e37, 1e70, 1e80, 1e100, 1e150, 1e155, 1e200, 1e307] {
            let points: Vec<_> =
                (0..10).map(|k| size * corners[k / 3].lerp(corners[k.div_ceil(3)], (k % 3) as f64 / 3.0)).collect();
            let curve = CurveView::new(&points, &ends, true).unwrap();
            let found = curve.measures(MeasureSelection::ALL, &Job::default());
            if size > 1e153 {
                let expected = Error::CoordinateTooLarge {
                    element: Element::Point,
                    index: 3,
                    component: Component::X,
                    value: 4.0 * size,
                };
                assert_eq!(found, Err(expected), "{size:e}");
                let length = MeasureSelection { area: false, moments: false, ..MeasureSelection::ALL };
                let found = curve.measures(length, &Job::default()).unwrap();
                assert!((found.length.unwrap() / size / 12.0 - 1.0).abs() < 1e-12, "{size:e}");
                continue;
            }
            let found = found.unwrap();
            assert!((found.length.unwrap() / size / 12.0 - 1.0).abs() < 1e-12, "{size:e}");
            assert!((found.area() - size * 6.0 * size).abs() <= size * 1e-12 * size, "{size:e}: {}", found.area());
            assert_eq!(found.moments.is_some(), size < 1e75, "{size:e}");
        }
    }
}

//! Several measures of one curve in one call.

use super::{AreaMoments, Bounds};
use crate::curve::{CurveView, Place};
use glam::DVec3;
use gusset_base::error::Result;
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
    /// The moments of the enclosed region. Only a curve in the plane z = 0 with points has them.
    pub moments: Option<AreaMoments>,
}

impl Measures {
    /// Returns the length of the area vector: the area of the largest shadow, never negative. 0
    /// without an area vector.
    pub fn area(&self) -> f64 {
        self.area_vector.unwrap_or_default().length()
    }
}

impl CurveView<'_> {
    /// Computes the measures that `selection` asks for and the curve has. The cost is the sum of
    /// their costs.
    ///
    /// # Errors
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
        Ok(Measures {
            length: share(0).map(|job| Ok(self.arc_lengths(&job)?.total_length())).transpose()?,
            bounds: share(1).map(|job| self.bounding_box(&job)).transpose()?,
            centre: share(2).map(|job| self.centre(&job)).transpose()?,
            area_vector: share(3).map(|job| self.area_vector(&job)).transpose()?,
            moments: share(4).map(|job| self.moments(&job)).transpose()?,
        })
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

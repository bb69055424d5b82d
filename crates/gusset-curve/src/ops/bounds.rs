//! The axis-aligned bounding box.

use crate::curve::unit_frame::UnitFrame;
use crate::curve::{CurveView, MAX_DEGREE, segment};
use glam::DVec3;
use gusset_base::error::Result;
use gusset_base::geom::Aabb;
use gusset_base::geom::bernstein::roots;
use gusset_base::job::Job;
use std::iter;

/// Segments between two progress reports.
const SEGMENTS_PER_REPORT: usize = 1 << 12;

/// An axis-aligned box.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bounds {
    /// The smallest coordinates.
    pub low: DVec3,
    /// The largest coordinates.
    pub high: DVec3,
}

impl CurveView<'_> {
    /// Returns the smallest axis-aligned box that contains the curve. Extrema lie at ends of
    /// segments and at roots of the derivative. The result is as exact as the points of the curve,
    /// about 1e-15 of its size. O(points), plus O(degree^2) for segments whose control polygon
    /// leaves the box of their ends.
    ///
    /// # Errors
    /// [`EmptyCurve`](gusset_base::Error::EmptyCurve) if the curve is not even a point,
    /// [`Cancelled`](gusset_base::Error::Cancelled).
    pub fn bounding_box(&self, job: &Job<'_>) -> Result<Bounds> {
        self.check_not_empty()?;
        let ends = self.segments().map(|controls| controls[controls.len() - 1]);
        let Aabb { low, high } = Aabb::from_points(iter::once(self.points()[0]).chain(ends));
        let mut bounds = Bounds { low, high };
        for (k, controls) in self.segments().enumerate() {
            job.step_every(SEGMENTS_PER_REPORT, k, self.len(), "box of a curve")?;
            // The curve can leave the box in a coordinate only if a control point does.
            for axis in 0..3 {
                let outside = |p: &DVec3| p[axis] < bounds.low[axis] || p[axis] > bounds.high[axis];
                if controls.iter().any(outside) {
                    bounds.extend_by_segment_extrema(controls, axis);
                }
            }
        }
        Ok(bounds)
    }
}

impl Bounds {
    /// Extends the box by the extrema of one coordinate of a segment.
    fn extend_by_segment_extrema(&mut self, controls: &[DVec3], axis: usize) {
        let n = controls.len() - 1;
        let frame = UnitFrame::from_points(controls);
        let mut slopes = [0.0; MAX_DEGREE];
        for (slope, pair) in slopes.iter_mut().zip(controls.windows(2)) {
            *slope = frame.point_to_frame(pair[1])[axis] - frame.point_to_frame(pair[0])[axis];
        }
        for &t in roots(&slopes[..n], f64::EPSILON).as_slice() {
            let x = segment::point_at(controls, t)[axis];
            self.low[axis] = self.low[axis].min(x);
            self.high[axis] = self.high[axis].max(x);
        }
    }
}

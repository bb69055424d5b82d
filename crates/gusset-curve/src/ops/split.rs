//! Parts of a curve, and the reversed curve. Exact up to rounding.

use crate::curve::segment::{self, SegmentBuffer};
use crate::curve::{Curve, CurveView, Place};
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::job::Job;

/// Segments between two progress reports.
const SEGMENTS_PER_REPORT: usize = 1 << 12;

const PROGRESS_STAGE: &str = "part of a curve";

impl CurveView<'_> {
    /// Splits the curve at a place. Both parts are open. A part without extent has one control
    /// point and no segments.
    ///
    /// # Errors
    /// [`Error::NoSuchPlace`], [`Error::OutOfMemory`], [`Error::Cancelled`]. O(points).
    pub fn split(&self, at: Place, job: &Job<'_>) -> Result<[Curve; 2]> {
        self.check_place(0, at)?;
        let (first, second) = (job.sub_job(0.0, 0.5), job.sub_job(0.5, 1.0));
        Ok([self.sub_curve_forward(Place::START, at, &first)?, self.sub_curve_forward(at, self.end_place(), &second)?])
    }

    /// Returns the open part from one place to another. On a closed curve it may pass the start.
    /// From a place to itself, it is the whole closed curve, or a single point of an open one.
    ///
    /// # Errors
    /// [`Error::NoSuchPlace`], [`Error::OptionOutOfRange`] (an open curve, and `to` before `from`),
    /// [`Error::TooLarge`], [`Error::OutOfMemory`], [`Error::Cancelled`]. O(points).
    pub fn sub_curve(&self, from: Place, to: Place, job: &Job<'_>) -> Result<Curve> {
        self.check_place(0, from)?;
        self.check_place(1, to)?;
        let order = from.segment.cmp(&to.segment).then(from.t.total_cmp(&to.t));
        if order.is_lt() || (order.is_eq() && !self.is_closed()) {
            return self.sub_curve_forward(from, to, job);
        }
        Error::require(self.is_closed(), "to", to.t, "after `from`, because the curve is open")?;
        let mut curve = self.sub_curve_forward(from, self.end_place(), &job.sub_job(0.0, 0.5))?;
        let rest = self.sub_curve_forward(Place::START, to, &job.sub_job(0.5, 1.0))?;
        rest.view().segments().try_for_each(|segment| curve.push_segment(&segment[1..]))?;
        Ok(curve)
    }

    /// Returns the part from one place to a later one.
    fn sub_curve_forward(&self, from: Place, to: Place, job: &Job<'_>) -> Result<Curve> {
        let mut curve: Option<Curve> = None;
        let count = (to.segment - from.segment) as usize + 1;
        for k in from.segment..=to.segment {
            job.step_every(SEGMENTS_PER_REPORT, (k - from.segment) as usize, count, PROGRESS_STAGE)?;
            let a = if k == from.segment { from.t } else { 0.0 };
            let b = if k == to.segment { to.t } else { 1.0 };
            if a >= b {
                continue;
            }
            let piece = SegmentBuffer::new(self.segment(k as usize)).into_part_between(a, b);
            match &mut curve {
                Some(curve) => curve.push_segment(&piece[1..])?,
                None => curve.insert(Curve::from_point(piece[0])?).push_segment(&piece[1..])?,
            }
        }
        match curve {
            Some(curve) => Ok(curve),
            None => Curve::from_point(segment::point_at(self.segment(from.segment as usize), from.t)),
        }
    }

    /// Reverses the curve. O(points).
    ///
    /// # Errors
    /// [`Error::OutOfMemory`], [`Error::Cancelled`].
    pub fn reversed(&self, job: &Job<'_>) -> Result<Curve> {
        let backwards = self.points().iter().rev().copied();
        let points = alloc::collect_cancellable(backwards, &job.sub_job(0.0, 0.8), "reversing a curve")?;
        let last = self.ends().last().copied().unwrap_or(0);
        let backwards = self.ends().iter().rev().map(|&end| last - end);
        let ends = alloc::collect_cancellable(backwards, &job.sub_job(0.8, 1.0), "reversing a curve")?;
        Ok(Curve { points, ends, closed: self.is_closed() })
    }
}

//! Subcurves: the part of an outline between two of its cuts, or a whole closed outline, as one
//! system of equations.

use super::curve_builder::CurveBuilder;
use super::identify_options::Options;
use super::report::{PointStatus, ReportInProgress};
use crate::curve::Place;
use glam::DVec3;
use gusset_base::error::Result;
use gusset_base::job::Job;
use std::ops::Range;

/// The points that one curve passes, near the origin and of a size near 1, with the conditions on
/// the curve.
#[derive(Clone, Copy)]
pub(super) struct Subcurve<'a> {
    /// No two neighbours coincide. At least 3 points if closed, otherwise at least 2.
    pub(super) points: &'a [DVec3],
    pub(super) closed: bool,
    /// The unit directions in which an open subcurve begins and ends.
    pub(super) tangents: [Option<DVec3>; 2],
    /// The longest side of the outline's bounding box.
    pub(super) outline_size: f64,
    pub(super) options: &'a Options,
}

impl Subcurve<'_> {
    #[inline]
    pub(super) fn len(&self) -> usize {
        self.points.len()
    }

    /// Returns the point before `i`, cyclically.
    #[inline]
    pub(super) fn previous_index(&self, i: usize) -> usize {
        if i == 0 { self.len() - 1 } else { i - 1 }
    }

    /// Returns the point after `i`, cyclically.
    #[inline]
    pub(super) fn next_index(&self, i: usize) -> usize {
        if i + 1 == self.len() { 0 } else { i + 1 }
    }

    /// Returns the sections by the indices of their points: one for each point except the ends.
    pub(super) fn section_indices(&self) -> Range<usize> {
        if self.closed { 0..self.len() } else { 1..self.len() - 1 }
    }

    /// Returns the spans from each point to the next, by the indices of their first points.
    pub(super) fn span_indices(&self) -> Range<usize> {
        if self.closed { 0..self.len() } else { 0..self.len() - 1 }
    }

    #[inline]
    pub(super) fn point_and_neighbours(&self, i: usize) -> [DVec3; 3] {
        [self.points[self.previous_index(i)], self.points[i], self.points[self.next_index(i)]]
    }

    /// Returns the range of parameters on sections: from `parameter_limit` to 1 minus it.
    pub(super) fn section_parameter_range(&self) -> [f64; 2] {
        [self.options.parameter_limit(), 1.0 - self.options.parameter_limit()]
    }

    /// Returns the control points next to ends with a tangent. They lie on the tangent at a third
    /// of the distance to the next point, as on a straight line of uniform speed. If the next point
    /// is the other end, the fraction is a quarter if both ends have tangents, and half if only one
    /// has.
    pub(super) fn end_controls(&self) -> [Option<DVec3>; 2] {
        let last = self.len() - 1;
        let fraction = match (last, self.tangents) {
            (1, [Some(_), Some(_)]) => 0.25,
            (1, _) => 0.5,
            _ => 1.0 / 3.0,
        };
        let [start, end] = self.tangents;
        let lengths = [self.points[1].distance(self.points[0]), self.points[last].distance(self.points[last - 1])];
        [
            start.map(|tangent| self.points[0] + tangent * (fraction * lengths[0])),
            end.map(|tangent| self.points[last] - tangent * (fraction * lengths[1])),
        ]
    }
}

/// The outcome at a point: its place on the curve, and its status.
#[derive(Clone, Copy)]
pub(super) struct PointResult {
    pub(super) place: Place,
    pub(super) status: PointStatus,
}

impl Default for PointResult {
    fn default() -> Self {
        PointResult { place: Place::START, status: PointStatus::Ok }
    }
}

impl PointResult {
    /// Sets the status, unless it is already set: the first cause stays.
    pub(super) fn flag_status(&mut self, status: PointStatus) {
        if self.status == PointStatus::Ok {
            self.status = status;
        }
    }
}

/// The output of the solvers for a subcurve.
pub(super) struct SubcurveOutput<'a> {
    /// The outcome at each of its points.
    pub(super) results: &'a mut [PointResult],
    /// The report of the outline.
    pub(super) report: &'a mut ReportInProgress,
    /// The outline's curve so far.
    pub(super) builder: &'a mut CurveBuilder,
    /// The receiver of progress reports.
    pub(super) job: &'a Job<'a>,
}

impl SubcurveOutput<'_> {
    /// Sets the status of all points that lack one; see [`PointResult::flag_status`].
    pub(super) fn flag_all_points(&mut self, status: PointStatus) {
        self.results.iter_mut().for_each(|result| result.flag_status(status));
    }

    /// Appends a segment over span `i`. `controls_after_first` has its control points except the
    /// first.
    pub(super) fn push_span_segment(
        &mut self,
        sub: &Subcurve<'_>,
        i: usize,
        controls_after_first: &[DVec3],
    ) -> Result<()> {
        let segment = self.builder.len() as u32;
        self.builder.push_segment(controls_after_first)?;
        self.results[i].place = Place { segment, t: 0.0 };
        if i + 2 == sub.len() && !sub.closed {
            self.results[i + 1].place = Place { segment, t: 1.0 };
        }
        Ok(())
    }
}

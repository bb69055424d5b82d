//! Subcurves: the part of an outline between two of its cuts, or a whole closed one, as one system
//! of equations sees it.

use super::curve_builder::CurveBuilder;
use super::identify_options::Options;
use super::report::{Account, PointStatus};
use crate::curve::Place;
use glam::DVec3;
use gusset_base::error::Result;
use gusset_base::job::Job;
use std::ops::Range;

/// The points that one curve is to pass, near the origin and of a size near 1, and how.
#[derive(Clone, Copy)]
pub(super) struct Subcurve<'a> {
    /// No two neighbours are the same. At least 3 if closed, else at least 2.
    pub(super) points: &'a [DVec3],
    pub(super) closed: bool,
    /// Directions, of length 1, in which an open subcurve begins and ends.
    pub(super) tangents: [Option<DVec3>; 2],
    /// The longest side of the outline's box.
    pub(super) size: f64,
    pub(super) options: &'a Options,
}

impl Subcurve<'_> {
    #[inline]
    pub(super) fn len(&self) -> usize {
        self.points.len()
    }

    /// The point before `i`, round the end.
    #[inline]
    pub(super) fn previous(&self, i: usize) -> usize {
        if i == 0 { self.len() - 1 } else { i - 1 }
    }

    /// The point after `i`, round the end.
    #[inline]
    pub(super) fn next(&self, i: usize) -> usize {
        if i + 1 == self.len() { 0 } else { i + 1 }
    }

    /// The sections by the numbers of their points: one for each point that is no end.
    pub(super) fn sections(&self) -> Range<usize> {
        if self.closed { 0..self.len() } else { 1..self.len() - 1 }
    }

    /// The spans from each point to the next, by the numbers of their first points.
    pub(super) fn spans(&self) -> Range<usize> {
        if self.closed { 0..self.len() } else { 0..self.len() - 1 }
    }

    #[inline]
    pub(super) fn triple(&self, i: usize) -> [DVec3; 3] {
        [self.points[self.previous(i)], self.points[i], self.points[self.next(i)]]
    }

    /// The parameters allowed on sections: from `parameter_limit` to 1 less that.
    pub(super) fn parameter_range(&self) -> [f64; 2] {
        [self.options.parameter_limit, 1.0 - self.options.parameter_limit]
    }

    /// The control points next to the ends where tangents are given: a third of the way to the next
    /// point along the tangent, as on a straight line of even speed; a quarter if the next point is
    /// the other end and both have tangents, half if only one has.
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
    /// Sets the status, unless one is set: the first cause stays.
    pub(super) fn flag(&mut self, status: PointStatus) {
        if self.status == PointStatus::Ok {
            self.status = status;
        }
    }
}

/// What becomes of a subcurve.
pub(super) struct Output<'a> {
    /// The outcome at each of its points.
    pub(super) results: &'a mut [PointResult],
    /// The account of the outline.
    pub(super) report: &'a mut Account,
    /// The outline's curve so far.
    pub(super) builder: &'a mut CurveBuilder,
    /// Whom long computations ask whether to go on.
    pub(super) job: &'a Job<'a>,
}

impl Output<'_> {
    /// Sets the status of all points that have none: see [`PointResult::flag`].
    pub(super) fn flag_all(&mut self, status: PointStatus) {
        self.results.iter_mut().for_each(|result| result.flag(status));
    }

    /// Appends a segment over span `i`, by its control points but the first.
    pub(super) fn push_span(&mut self, sub: &Subcurve<'_>, i: usize, rest: &[DVec3]) -> Result<()> {
        let segment = self.builder.len() as u32;
        self.builder.push(rest)?;
        self.results[i].place = Place { segment, t: 0.0 };
        if i + 2 == sub.len() && !sub.closed {
            self.results[i + 1].place = Place { segment, t: 1.0 };
        }
        Ok(())
    }
}

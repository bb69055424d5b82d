//! The result of an identification: the curves of many outlines, and a report on each.

use super::report::{Cycle, History, PointStatus, Report};
use crate::curve::{CurveView, Place};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;

/// The curves of many outlines, and a report on each.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Fit {
    /// The control points of all curves.
    pub(super) points: Vec<DVec3>,
    /// The ends of the segments of all curves, as indices from the curve's first control point.
    pub(super) ends: Vec<u32>,
    /// The start of the control points and the ends of each curve, then the total of both.
    pub(super) starts: Vec<[usize; 2]>,
    pub(super) closed: bool,
    /// The segment and parameter of each point on its curve.
    pub(super) segments: Vec<u32>,
    pub(super) parameters: Vec<f64>,
    pub(super) statuses: Vec<PointStatus>,
    pub(super) reports: Vec<Report>,
    /// The cycles of all outlines with their control points, and the ends of both for each outline.
    pub(super) history: History,
    pub(super) history_ends: Vec<[usize; 2]>,
}

impl Fit {
    /// Returns the number of outlines.
    pub fn len(&self) -> usize {
        self.reports.len()
    }

    /// Returns true if the list of outlines is empty.
    pub fn is_empty(&self) -> bool {
        self.reports.is_empty()
    }

    /// Returns the curve of outline `k`.
    ///
    /// # Panics
    /// If outline `k` does not exist.
    pub fn curve(&self, k: usize) -> CurveView<'_> {
        let [from, to] = [self.starts[k], self.starts[k + 1]];
        CurveView::new_unchecked(
            &self.points[from[0]..to[0]],
            &self.ends[from[1]..to[1]],
            self.closed && to[1] > from[1] + 1,
        )
    }

    /// Returns the place of a point on its curve; points are counted over all outlines.
    ///
    /// # Panics
    /// If the point does not exist.
    pub fn place(&self, point: usize) -> Place {
        Place { segment: self.segments[point], t: self.parameters[point] }
    }

    /// Returns the segment on which each point lies, within its curve.
    pub fn segments(&self) -> &[u32] {
        &self.segments
    }

    /// Returns the parameter of each point on its segment.
    pub fn parameters(&self) -> &[f64] {
        &self.parameters
    }

    /// Returns the outcome at each point.
    pub fn statuses(&self) -> &[PointStatus] {
        &self.statuses
    }

    /// Returns the report on each outline.
    pub fn reports(&self) -> &[Report] {
        &self.reports
    }

    /// Returns the cycles of outline `k`, in order, subcurve by subcurve. The list is empty unless
    /// [`Options::history`](super::Options) is set. Only the solver that the options name
    /// records cycles: neither its start nor its replacement does.
    ///
    /// # Panics
    /// If outline `k` does not exist.
    pub fn history(&self, k: usize) -> &[Cycle] {
        let [from, to] = self.history_range(k);
        &self.history.cycles[from[0]..to[0]]
    }

    /// Returns the control points at the ends of all cycles of outline `k`, cycle after cycle; see
    /// [`Cycle::control_end`]. A single curve has all its control points in each cycle. A composite
    /// curve has one control point for each distinct point of its subcurve; at the ends of an open
    /// subcurve, it is the point itself, or the control point on the end's tangent.
    ///
    /// # Panics
    /// If outline `k` does not exist.
    pub fn history_controls(&self, k: usize) -> &[DVec3] {
        let [from, to] = self.history_range(k);
        &self.history.controls[from[1]..to[1]]
    }

    fn history_range(&self, k: usize) -> [[usize; 2]; 2] {
        [if k == 0 { [0, 0] } else { self.history_ends[k - 1] }, self.history_ends[k]]
    }

    /// Returns the control points of all curves, one curve after another.
    pub fn points(&self) -> &[DVec3] {
        &self.points
    }

    /// Returns the ends of all curves, as indices from each curve's first control point.
    pub fn ends(&self) -> &[u32] {
        &self.ends
    }

    /// Returns the start of each curve's control points and ends in [`Fit::points`] and
    /// [`Fit::ends`], then the total of both.
    pub fn starts(&self) -> &[[usize; 2]] {
        &self.starts
    }

    /// Creates a result without curves.
    pub(super) fn new(closed: bool) -> Self {
        Fit { closed, starts: vec![[0, 0]], ..Fit::default() }
    }

    /// Reserves room for `count` more points.
    pub(super) fn reserve_points(&mut self, count: usize) -> Result<()> {
        alloc::reserve(&mut self.segments, count)?;
        alloc::reserve(&mut self.parameters, count)?;
        alloc::reserve(&mut self.statuses, count)
    }

    /// Moves the curves of another result to the end.
    pub(super) fn append_fit(&mut self, other: &mut Fit) -> Result<()> {
        let [points, ends] = [self.points.len(), self.ends.len()];
        alloc::append(&mut self.points, &other.points)?;
        alloc::append(&mut self.ends, &other.ends)?;
        alloc::reserve(&mut self.starts, other.starts.len())?;
        self.starts.extend(other.starts[1..].iter().map(|start| [start[0] + points, start[1] + ends]));
        alloc::append(&mut self.segments, &other.segments)?;
        alloc::append(&mut self.parameters, &other.parameters)?;
        alloc::append(&mut self.statuses, &other.statuses)?;
        alloc::append(&mut self.reports, &other.reports)?;
        let [cycles, controls] = [self.history.cycles.len(), self.history.controls.len()];
        alloc::append(&mut self.history.cycles, &other.history.cycles)?;
        alloc::append(&mut self.history.controls, &other.history.controls)?;
        let ends = other.history_ends.iter().map(|end| [end[0] + cycles, end[1] + controls]);
        alloc::extend(&mut self.history_ends, ends)?;
        other.points.clear();
        other.ends.clear();
        other.starts.truncate(1);
        other.segments.clear();
        other.parameters.clear();
        other.statuses.clear();
        other.reports.clear();
        other.history.cycles.clear();
        other.history.controls.clear();
        other.history_ends.clear();
        Ok(())
    }
}

//! The result of an identification: the curves of many outlines, and the account of each.

use super::report::{Cycle, PointStatus, Report};
use crate::curve::{CurveView, Place};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;

/// The curves of many outlines, and the account of each.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Fit {
    /// The control points of all curves.
    pub(super) points: Vec<DVec3>,
    /// The ends of the segments of all curves, counted from the curve's first control point.
    pub(super) ends: Vec<u32>,
    /// Where the control points and the ends of each curve begin, and where the last ones end.
    pub(super) starts: Vec<[usize; 2]>,
    pub(super) closed: bool,
    /// Where on its curve each point lies: the segment, and the parameter there.
    pub(super) segments: Vec<u32>,
    pub(super) parameters: Vec<f64>,
    pub(super) statuses: Vec<PointStatus>,
    pub(super) reports: Vec<Report>,
    /// The cycles of all outlines, and where those of each end.
    pub(super) cycles: Vec<Cycle>,
    pub(super) cycle_ends: Vec<usize>,
}

impl Fit {
    /// The number of outlines.
    pub fn len(&self) -> usize {
        self.reports.len()
    }

    /// True if there were none.
    pub fn is_empty(&self) -> bool {
        self.reports.is_empty()
    }

    /// The curve of outline `k`.
    ///
    /// # Panics
    /// If there is no outline `k`.
    pub fn curve(&self, k: usize) -> CurveView<'_> {
        let [from, to] = [self.starts[k], self.starts[k + 1]];
        CurveView::trusted(&self.points[from[0]..to[0]], &self.ends[from[1]..to[1]], self.closed && to[1] > from[1] + 1)
    }

    /// Where on its curve a point lies; points are counted over all outlines.
    ///
    /// # Panics
    /// If there is no such point.
    pub fn place(&self, point: usize) -> Place {
        Place { segment: self.segments[point], t: self.parameters[point] }
    }

    /// The segment of its curve that each point lies on.
    pub fn segments(&self) -> &[u32] {
        &self.segments
    }

    /// The parameter of each point on its segment.
    pub fn parameters(&self) -> &[f64] {
        &self.parameters
    }

    /// The outcome at each point.
    pub fn statuses(&self) -> &[PointStatus] {
        &self.statuses
    }

    /// The account of each outline.
    pub fn reports(&self) -> &[Report] {
        &self.reports
    }

    /// The cycles of outline `k`, in their order and subcurve by subcurve; none unless
    /// [`Options::history`](super::Options) asks for them.
    ///
    /// # Panics
    /// If there is no outline `k`.
    pub fn history(&self, k: usize) -> &[Cycle] {
        let from = if k == 0 { 0 } else { self.cycle_ends[k - 1] };
        &self.cycles[from..self.cycle_ends[k]]
    }

    /// The control points of all curves, one curve after another.
    pub fn points(&self) -> &[DVec3] {
        &self.points
    }

    /// The ends of all curves, each counted from the curve's first control point.
    pub fn ends(&self) -> &[u32] {
        &self.ends
    }

    /// Where the control points and the ends of each curve begin in [`Fit::points`] and
    /// [`Fit::ends`]; one more than there are outlines.
    pub fn starts(&self) -> &[[usize; 2]] {
        &self.starts
    }

    /// No curves yet.
    pub(super) fn new(closed: bool) -> Self {
        Fit { closed, starts: vec![[0, 0]], ..Fit::default() }
    }

    /// Makes room for so many more points.
    pub(super) fn reserve_points(&mut self, count: usize) -> Result<()> {
        alloc::reserve(&mut self.segments, count)?;
        alloc::reserve(&mut self.parameters, count)?;
        alloc::reserve(&mut self.statuses, count)
    }

    /// Moves the curves of another one to the end.
    pub(super) fn append(&mut self, other: &mut Fit) -> Result<()> {
        let [points, ends] = [self.points.len(), self.ends.len()];
        alloc::append(&mut self.points, &other.points)?;
        alloc::append(&mut self.ends, &other.ends)?;
        alloc::reserve(&mut self.starts, other.starts.len())?;
        self.starts.extend(other.starts[1..].iter().map(|start| [start[0] + points, start[1] + ends]));
        alloc::append(&mut self.segments, &other.segments)?;
        alloc::append(&mut self.parameters, &other.parameters)?;
        alloc::append(&mut self.statuses, &other.statuses)?;
        alloc::append(&mut self.reports, &other.reports)?;
        let cycles = self.cycles.len();
        alloc::append(&mut self.cycles, &other.cycles)?;
        alloc::extend(&mut self.cycle_ends, other.cycle_ends.iter().map(|end| end + cycles))?;
        other.points.clear();
        other.ends.clear();
        other.starts.truncate(1);
        other.segments.clear();
        other.parameters.clear();
        other.statuses.clear();
        other.reports.clear();
        other.cycles.clear();
        other.cycle_ends.clear();
        Ok(())
    }
}

//! Identification: outlines one after another, each prepared, cut into runs, solved and judged.

use super::curve::{CurveView, Place, check_finite};
use super::request::{Demand, Options, Outlines, PointStatus, Report};
use super::worker::Worker;
use crate::alloc;
use crate::error::{Error, Result};
use crate::job::Job;
use crate::par;
use glam::DVec3;
use std::ops::Range;
use std::sync::{Mutex, PoisonError};

/// Points that a thread takes at a time.
const CHUNK: usize = 1 << 12;

/// Batches between two reports of progress.
const ROUND: usize = 32;

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

    /// What became of each point.
    pub fn statuses(&self) -> &[PointStatus] {
        &self.statuses
    }

    /// What became of each outline.
    pub fn reports(&self) -> &[Report] {
        &self.reports
    }

    /// The control points of all curves, one curve after another.
    pub fn points(&self) -> &[DVec3] {
        &self.points
    }

    /// The ends of all curves, each counted from the curve's first control point.
    pub fn ends(&self) -> &[u32] {
        &self.ends
    }

    /// Where the control points and the ends of each curve begin in [`Fit::points`] and [`Fit::ends`]; one more than there are
    /// outlines.
    pub fn starts(&self) -> &[[usize; 2]] {
        &self.starts
    }

    /// Nothing yet.
    pub(super) fn new(closed: bool) -> Self {
        Fit { closed, starts: vec![[0, 0]], ..Fit::default() }
    }

    /// Makes room for so many more points.
    pub(super) fn reserve_points(&mut self, count: usize) -> Result<()> {
        alloc::reserve(&mut self.segments, count)?;
        alloc::reserve(&mut self.parameters, count)?;
        alloc::reserve(&mut self.statuses, count)
    }

    /// Takes all that another one has.
    fn append(&mut self, other: &mut Fit) -> Result<()> {
        let [points, ends] = [self.points.len(), self.ends.len()];
        alloc::append(&mut self.points, &other.points)?;
        alloc::append(&mut self.ends, &other.ends)?;
        alloc::reserve(&mut self.starts, other.starts.len())?;
        self.starts.extend(other.starts[1..].iter().map(|start| [start[0] + points, start[1] + ends]));
        alloc::append(&mut self.segments, &other.segments)?;
        alloc::append(&mut self.parameters, &other.parameters)?;
        alloc::append(&mut self.statuses, &other.statuses)?;
        alloc::append(&mut self.reports, &other.reports)?;
        other.points.clear();
        other.ends.clear();
        other.starts.truncate(1);
        other.segments.clear();
        other.parameters.clear();
        other.statuses.clear();
        other.reports.clear();
        Ok(())
    }
}

/// Finds the curves through the points of outlines.
///
/// Each outline is brought near the origin and to a size near 1; neighbours that repeat each other become one point; it is cut
/// into runs at corners and tangents, and each run is solved. Every point lies on the curve, or its status says why not.
///
/// Composite, blended and cubic curves take linear time and memory. No memory is allocated for an outline but for the result.
///
/// # Errors [`Error::BadOffsets`], [`Error::OptionOutOfRange`], [`Error::NotFinite`], [`Error::TooLarge`],
/// [`Error::BadConstraint`] (a constraint names a point that there is not, or is out of order), [`Error::OutOfMemory`],
/// [`Error::Cancelled`].
///
/// Source: Nadopta; the composite and blended readings of the set of sections are ours.
pub fn fit(outlines: &Outlines<'_>, options: &Options, job: &Job<'_>) -> Result<Fit> {
    options.check()?;
    let batches = batches(outlines, check(outlines)?)?;
    let threads = par::at_most(batches.len(), job.threads());
    let mut whole = Worker::new(outlines, options);
    if let (Some(first), Some(last)) = (batches.first(), batches.last()) {
        whole.reserve(first.start..last.end)?;
    }
    if threads == 1 {
        for (k, batch) in batches.iter().enumerate() {
            job.step(k as f64 / batches.len() as f64, STAGE)?;
            whole.outlines(batch.clone())?;
        }
    } else {
        // The workers' room is used again from round to round; between rounds the host is heard.
        let idle = Mutex::new(Vec::new());
        let work = |batch: Range<usize>| -> Result<Worker<'_>> {
            let waiting = idle.lock().unwrap_or_else(PoisonError::into_inner).pop();
            let mut worker = waiting.unwrap_or_else(|| Worker::new(outlines, options));
            worker.outlines(batch)?;
            Ok(worker)
        };
        for (k, round) in batches.chunks(ROUND).enumerate() {
            job.step((k * ROUND) as f64 / batches.len() as f64, STAGE)?;
            for worker in par::map(threads, round.iter().cloned(), work) {
                let mut worker = worker?;
                whole.done.append(&mut worker.done)?;
                idle.lock().unwrap_or_else(PoisonError::into_inner).push(worker);
            }
        }
    }
    job.step(1.0, STAGE)?;
    Ok(whole.done)
}

const STAGE: &str = "identifying outlines";

/// Checks offsets and constraints; the number of outlines.
pub(super) fn check(outlines: &Outlines<'_>) -> Result<usize> {
    let count = outlines.points.len();
    if let Some(offsets) = outlines.offsets {
        let value = |entry: usize| offsets.get(entry).copied().unwrap_or(0);
        let bad = |entry: usize| Error::BadOffsets { entry: entry as u32, value: value(entry) };
        if offsets.first() != Some(&0) {
            return Err(bad(0));
        }
        if let Some(k) = (1..offsets.len()).find(|&k| offsets[k] < offsets[k - 1] || offsets[k] as usize > count) {
            return Err(bad(k));
        }
        if value(offsets.len() - 1) as usize != count {
            return Err(bad(offsets.len() - 1));
        }
    }
    for (k, constraint) in outlines.constraints.iter().enumerate() {
        let follows = k == 0 || constraint.point > outlines.constraints[k - 1].point;
        if constraint.point as usize >= count || !follows {
            return Err(Error::BadConstraint { constraint: k as u32, point: constraint.point });
        }
        if let Demand::Tangent(tangent) = constraint.demand {
            check_finite(constraint.point as usize, tangent)?;
        }
    }
    Ok(outlines.offsets.map_or(1, |offsets| offsets.len() - 1))
}

/// The points of outline `k`.
pub(super) fn span(outlines: &Outlines<'_>, k: usize) -> Range<usize> {
    match outlines.offsets {
        Some(offsets) => offsets[k] as usize..offsets[k + 1] as usize,
        None => 0..outlines.points.len(),
    }
}

/// Outlines of together about [`CHUNK`] points.
fn batches(outlines: &Outlines<'_>, count: usize) -> Result<Vec<Range<usize>>> {
    let mut batches: Vec<Range<usize>> = Vec::new();
    let mut points = 0;
    for k in 0..count {
        let more = span(outlines, k).len();
        match batches.last_mut() {
            Some(batch) if points + more <= CHUNK && batch.len() < CHUNK => batch.end = k + 1,
            _ => {
                alloc::push(&mut batches, k..k + 1)?;
                points = 0;
            }
        }
        points += more;
    }
    Ok(batches)
}

//! The identification of outlines. Each outline is normalised near the origin, cut into subcurves,
//! solved, measured and transformed back.
//!
//! Outlines are independent. Threads take batches of them, and the results are joined in the order
//! of the outlines. They are therefore the same for any number of threads.

use super::composite::{self, CompositeWorkspace};
use super::curve_builder::CurveBuilder;
use super::fit::Fit;
use super::identify_options::{CurveKind, JointParameter, Options};
use super::loops::LoopSearch;
use super::outline_nodes::OutlineNodes;
use super::outlines::{Constraint, Outlines};
use super::report::{FitStatus, History, PointStatus, Report, ReportInProgress};
use super::single::{self, Collocation};
use super::subcurve::{PointResult, Subcurve, SubcurveOutput};
use super::{blended_curve, crowded, cubic_spline, residuals};
use crate::curve::Place;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_base::par;
use gusset_base::threads::lock;
use std::ops::Range;
use std::sync::Mutex;

/// Points in a batch.
const POINTS_PER_BATCH: usize = 1 << 12;

const BATCHES_PER_REPORT: usize = 32;

/// Fits curves through the points of outlines.
///
/// Each outline is moved near the origin and scaled to a size near 1, and repeated neighbours merge
/// into one point. The outline is cut into subcurves at corners and tangents, and each subcurve is
/// solved. Every point lies on the curve, or its status says why not.
///
/// Composite, blended and cubic curves take linear time and memory. Memory beyond the result is
/// allocated once for each thread.
///
/// # Errors
/// Variants of [`Error`](gusset_base::Error): `BadOffsets`, `OptionOutOfRange`, `NotFinite`,
/// `TooLarge`, `BadConstraint` (a constraint names a point that does not exist, or is out of
/// order), `OutOfMemory`, `Cancelled`.
///
/// Source: Nadopta; the composite and blended readings of the set of sections are ours.
pub fn fit(outlines: &Outlines<'_>, options: &Options, job: &Job<'_>) -> Result<Fit> {
    options.check_ranges()?;
    let options = &options.with_chain_replaced();
    let batches = divide_into_batches(outlines, outlines.check_offsets_and_constraints()?)?;
    let threads = par::resolve_thread_count(batches.len(), job.requested_threads());
    let mut whole = OutlineWorker::new(outlines, options);
    if let (Some(first), Some(last)) = (batches.first(), batches.last()) {
        whole.reserve_results(first.start..last.end)?;
    }
    if threads == 1 {
        for (k, batch) in batches.iter().enumerate() {
            let part = job.sub_job_of_item(k, batches.len());
            part.step(0.0, PROGRESS_STAGE)?;
            whole.identify_batch(batch.clone(), &part)?;
        }
    } else {
        // Rounds reuse the workers' memory, and the host can cancel between rounds.
        let idle = Mutex::new(Vec::new());
        let work = |batch: Range<usize>, job: &Job<'_>| -> Result<OutlineWorker<'_>> {
            let free = lock(&idle).pop();
            let mut worker = free.unwrap_or_else(|| OutlineWorker::new(outlines, options));
            worker.identify_batch(batch, job)?;
            Ok(worker)
        };
        for (k, round) in batches.chunks(BATCHES_PER_REPORT).enumerate() {
            let part = |batch: usize| batch.min(batches.len()) as f64 / batches.len() as f64;
            let part = job.sub_job(part(k * BATCHES_PER_REPORT), part((k + 1) * BATCHES_PER_REPORT));
            for mut worker in par::map_jobs(&part, PROGRESS_STAGE, round.iter().cloned(), work)? {
                whole.fit.append_fit(&mut worker.fit)?;
                lock(&idle).push(worker);
            }
        }
    }
    job.step(1.0, PROGRESS_STAGE)?;
    Ok(whole.fit)
}

const PROGRESS_STAGE: &str = "identifying outlines";
/// Outlines of at least this many points report progress between the passes over them.
const POINTS_PER_REPORT: usize = 1 << 17;

/// Divides the outlines into batches of about [`POINTS_PER_BATCH`] points.
fn divide_into_batches(outlines: &Outlines<'_>, count: usize) -> Result<Vec<Range<usize>>> {
    let mut batches: Vec<Range<usize>> = Vec::new();
    let mut points = 0;
    for k in 0..count {
        let more = outlines.point_range(k).len();
        match batches.last_mut() {
            Some(batch) if points + more <= POINTS_PER_BATCH && batch.len() < POINTS_PER_BATCH => batch.end = k + 1,
            _ => {
                alloc::push(&mut batches, k..k + 1)?;
                points = 0;
            }
        }
        points += more;
    }
    Ok(batches)
}

/// One thread's worker, with the memory that it reuses for each outline.
struct OutlineWorker<'a> {
    outlines: &'a Outlines<'a>,
    options: &'a Options,
    /// The constraints of the remaining outlines.
    constraints: &'a [Constraint],
    nodes: OutlineNodes,
    composite: CompositeWorkspace,
    collocation: Collocation,
    builder: CurveBuilder,
    loops: LoopSearch,
    fit: Fit,
}

impl<'a> OutlineWorker<'a> {
    fn new(outlines: &'a Outlines<'a>, options: &'a Options) -> Self {
        OutlineWorker {
            outlines,
            options,
            constraints: &[],
            nodes: OutlineNodes::default(),
            composite: CompositeWorkspace::default(),
            collocation: Collocation::default(),
            builder: CurveBuilder::default(),
            loops: LoopSearch::default(),
            fit: Fit::new(outlines.closed),
        }
    }

    /// Makes room for the results of some outlines.
    fn reserve_results(&mut self, batch: Range<usize>) -> Result<()> {
        let points = self.outlines.point_range(batch.start).start..self.outlines.point_range(batch.end - 1).end;
        let expected = points.len() + 2 * batch.len();
        let per_segment = match self.options.curve {
            CurveKind::Composite | CurveKind::Chain if self.options.joint == JointParameter::G2 => 3,
            CurveKind::Composite | CurveKind::Chain => 2,
            CurveKind::BlendC1 | CurveKind::CubicC2 => 3,
            CurveKind::BlendC2 => 5,
            CurveKind::Single => 1,
        };
        let done = &mut self.fit;
        alloc::reserve(&mut done.points, per_segment * expected)?;
        alloc::reserve(&mut done.ends, expected)?;
        alloc::reserve(&mut done.starts, batch.len())?;
        done.reserve_points(points.len())?;
        alloc::reserve(&mut done.history_ends, batch.len())?;
        alloc::reserve(&mut done.reports, batch.len())
    }

    fn identify_batch(&mut self, batch: Range<usize>, job: &Job<'_>) -> Result<()> {
        let first = self.outlines.point_range(batch.start).start;
        let from = self.outlines.constraints.partition_point(|constraint| (constraint.point as usize) < first);
        self.constraints = &self.outlines.constraints[from..];
        batch.into_iter().try_for_each(|k| self.identify_outline(k, job))
    }

    fn identify_outline(&mut self, k: usize, job: &Job<'_>) -> Result<()> {
        let span = self.outlines.point_range(k);
        let own = self.constraints.partition_point(|constraint| (constraint.point as usize) < span.end);
        let (own, rest) = self.constraints.split_at(own);
        self.constraints = rest;
        // Long outlines report progress between the passes over their points.
        let long = |fraction| if span.len() < POINTS_PER_REPORT { Ok(()) } else { job.step(fraction, PROGRESS_STAGE) };
        self.nodes.normalise_and_divide(self.outlines, &span, own, self.options)?;
        long(0.0)?;
        let (base, first_status) = (self.fit.points.len(), self.fit.statuses.len());
        let placement = self.nodes.placement;
        let size = placement.box_longest_side * placement.unit;
        let report = Report { size, ..Report::default() };
        let mut report =
            ReportInProgress { report, history: self.options.history.then(History::default), is_uncounted: false };
        let quadratic = self.options.curve == CurveKind::Composite && self.options.joint != JointParameter::G2;
        if self.nodes.dividing_nodes.is_empty() && quadratic {
            self.fit_smooth_closed_outline(&span, base, &mut report, job)?;
        } else {
            self.solve_subcurves(&mut report, job)?;
            long(1.0)?;
            residuals::measure_residuals(&self.nodes, &self.builder, &mut report);
            if self.options.curve == CurveKind::Composite && !quadratic && !self.builder.is_empty() {
                residuals::measure_curvature_gaps(&mut self.nodes, &self.builder, &mut report);
            }
            long(1.0)?;
            crowded::flag_crowded_nodes(&mut self.nodes);
            self.append_curve_and_places(&span, base)?;
        }
        long(1.0)?;
        self.replace_overflowing_curve_by_point(&span, base, first_status, &mut report)?;
        let given = (&self.outlines.points, span.start);
        self.loops.flag_points(&mut self.fit, first_status, given, &placement)?;
        long(1.0)?;
        self.append_report(first_status, report)
    }

    /// Finds the curve, near the origin, subcurve by subcurve.
    fn solve_subcurves(&mut self, report: &mut ReportInProgress, job: &Job<'_>) -> Result<()> {
        self.builder.clear();
        let n = self.nodes.points.len();
        if n < 2 || (self.outlines.closed && n < 3) {
            return self.fit_one_or_two_points(report);
        }
        if self.nodes.dividing_nodes.is_empty() {
            let (sub, results) = self.nodes.whole_outline_as_subcurve(self.options);
            let mut out = SubcurveOutput { results, report, builder: &mut self.builder, job };
            return append_subcurve_curve(&sub, &mut self.composite, &mut self.collocation, &mut out);
        }
        for k in 0..self.nodes.dividing_nodes.len() - 1 {
            if k > 0 && self.nodes.dividing_nodes[k].tangent.is_none() {
                self.builder.mark_corner()?;
            }
            let (sub, results) = self.nodes.subcurve_after_cut(k, self.options);
            let mut out = SubcurveOutput { results, report, builder: &mut self.builder, job };
            append_subcurve_curve(&sub, &mut self.composite, &mut self.collocation, &mut out)?;
        }
        if self.nodes.closed && self.nodes.dividing_nodes[0].tangent.is_none() {
            self.builder.mark_corner()?;
        }
        // The first node is repeated at the end: the status of either counts.
        let results = &mut self.nodes.results;
        let (first, last) = (results[0].status, results[results.len() - 1].status);
        if self.nodes.closed && first == PointStatus::Ok {
            results[0].status = last;
        }
        Ok(())
    }

    /// Treats an outline of one or two nodes as a point, or as a line there and back.
    fn fit_one_or_two_points(&mut self, report: &mut Report) -> Result<()> {
        report.status = FitStatus::TooFewPoints;
        let OutlineNodes { points, results, .. } = &mut self.nodes;
        results.iter_mut().for_each(|result| result.status = PointStatus::Missed);
        if let Some(&point) = points.first() {
            self.builder.begin_at_point(point)?;
        }
        if let &[p, q] = points.as_slice() {
            self.builder.push_segment(&[q])?;
            self.builder.push_segment(&[p])?;
            results[0] = PointResult::default();
            results[1] = PointResult { place: Place { segment: 0, t: 1.0 }, ..PointResult::default() };
        }
        Ok(())
    }

    /// Finds the composite curve of a closed outline without cuts, and writes it at the outline's
    /// position.
    fn fit_smooth_closed_outline(
        &mut self,
        span: &Range<usize>,
        base: usize,
        report: &mut ReportInProgress,
        job: &Job<'_>,
    ) -> Result<()> {
        let placement = self.nodes.placement;
        let (sub, results) = self.nodes.whole_outline_as_subcurve(self.options);
        let mut out = SubcurveOutput { results, report, builder: &mut self.builder, job };
        composite::solve_composite_curve(&sub, &mut self.composite, &mut out)?;
        if span.len() >= POINTS_PER_REPORT {
            job.step(1.0, PROGRESS_STAGE)?;
        }
        crowded::flag_crowded_nodes(&mut self.nodes);
        let (sub, _) = self.nodes.whole_outline_as_subcurve(self.options);
        let (n, solution, done) = (sub.len(), &*self.composite.solution(), &mut self.fit);
        alloc::grow(&mut done.points, base + 2 * n + 1, DVec3::ZERO)?;
        let place = |p: DVec3| p * placement.unit + placement.origin;
        composite::write_closed_curve(&sub, solution, place, &mut done.points[base..], report);
        alloc::reserve(&mut done.ends, n + 1)?;
        done.ends.extend((0..=n as u32).map(|k| 2 * k));
        alloc::push(&mut done.starts, [done.points.len(), done.ends.len()])?;
        done.reserve_points(span.len())?;
        if n == span.len() {
            done.segments.extend(0..n as u32);
            done.parameters.extend_from_slice(&solution.point_parameters[..n]);
            done.statuses.extend(self.nodes.results.iter().map(|result| result.status));
        } else {
            let mut taken = 0;
            for (i, &node) in self.nodes.point_nodes.iter().enumerate() {
                // Nodes ascend. A smaller node repeats its neighbour, or at the end the first
                // point.
                let repeats = i > 0 && node < taken;
                taken = taken.max(node + 1);
                let status = self.nodes.results[node as usize].status;
                done.segments.push(node);
                done.parameters.push(solution.point_parameters[node as usize]);
                done.statuses.push(if repeats { PointStatus::Merged } else { status });
            }
        }
        Ok(())
    }

    /// Appends the curve at the outline's position, and the places of its points.
    fn append_curve_and_places(&mut self, span: &Range<usize>, base: usize) -> Result<()> {
        let (done, builder, nodes, placement) = (&mut self.fit, &self.builder, &self.nodes, self.nodes.placement);
        alloc::reserve(&mut done.points, builder.points.len())?;
        done.points.extend(builder.points.iter().map(|&p| p * placement.unit + placement.origin));
        alloc::append(&mut done.ends, &builder.segment_ends)?;
        alloc::push(&mut done.starts, [done.points.len(), done.ends.len()])?;
        done.reserve_points(span.len())?;
        let (mut before, closing) = (u32::MAX, nodes.point_nodes.first().copied().unwrap_or(0));
        for (i, &node) in span.clone().zip(&nodes.point_nodes) {
            let PointResult { place, mut status } = nodes.results[node as usize];
            let repeats = node == before || (node == closing && i > span.start && self.outlines.closed);
            if repeats && status != PointStatus::Missed {
                status = PointStatus::Merged;
            }
            if !repeats && (place.t == 0.0 || place.t == 1.0) && !builder.is_empty() {
                // Joints at points keep their bits.
                let end = builder.segment_ends[place.segment as usize + usize::from(place.t == 1.0)] as usize;
                let p = self.outlines.points.get(i);
                done.points[base + end] = p;
                if self.outlines.closed && end == 0 {
                    let last = done.points.len() - 1;
                    done.points[last] = p;
                }
            }
            before = node;
            done.segments.push(place.segment);
            done.parameters.push(place.t);
            done.statuses.push(status);
        }
        Ok(())
    }

    /// Withdraws a curve whose control points overflow although its points do not. This can happen
    /// at any size, because control points may be far out where points are close together.
    fn replace_overflowing_curve_by_point(
        &mut self,
        span: &Range<usize>,
        base: usize,
        first: usize,
        report: &mut Report,
    ) -> Result<()> {
        let done = &mut self.fit;
        if done.points[base..].iter().all(|p| p.is_finite()) {
            return Ok(());
        }
        done.points.truncate(base);
        alloc::push(&mut done.points, self.outlines.points.get(span.start))?;
        let ends = done.starts[done.starts.len() - 2][1];
        done.ends.truncate(ends);
        alloc::push(&mut done.ends, 0)?;
        let last = done.starts.len() - 1;
        done.starts[last] = [done.points.len(), done.ends.len()];
        done.segments[first..].fill(0);
        done.parameters[first..].fill(0.0);
        done.statuses[first..].fill(PointStatus::Missed);
        (report.status, report.max_residual, report.max_joint_sine) = (FitStatus::Diverged, 0.0, 0.0);
        Ok(())
    }

    /// Counts the statuses from `first` on.
    fn append_report(&mut self, first: usize, mut report: ReportInProgress) -> Result<()> {
        let done = &mut self.fit;
        let mut partial = false;
        for status in &done.statuses[first..] {
            report.not_ok += u32::from(*status != PointStatus::Ok);
            let is_notice = matches!(
                status,
                PointStatus::Merged | PointStatus::ClampedParameter | PointStatus::Crowded | PointStatus::Looped
            );
            partial |= *status != PointStatus::Ok && !is_notice;
        }
        if partial && report.status == FitStatus::Ok {
            report.status = FitStatus::Partial;
        }
        if let Some(history) = &report.history {
            let placement = self.nodes.placement;
            alloc::append(&mut done.history.cycles, &history.cycles)?;
            let controls = history.controls.iter().map(|&p| p * placement.unit + placement.origin);
            alloc::extend(&mut done.history.controls, controls)?;
        }
        alloc::push(&mut done.history_ends, [done.history.cycles.len(), done.history.controls.len()])?;
        alloc::push(&mut done.reports, report.report)
    }
}

/// Appends the curve of a subcurve's points.
fn append_subcurve_curve(
    sub: &Subcurve<'_>,
    composite: &mut CompositeWorkspace,
    single: &mut Collocation,
    out: &mut SubcurveOutput<'_>,
) -> Result<()> {
    // Iterations are counted for each part; the report has the maximum.
    let before = std::mem::take(&mut out.report.iterations);
    out.report.is_uncounted = false;
    match sub.options.curve {
        CurveKind::BlendC1 | CurveKind::BlendC2 => blended_curve::append_blended_curve(sub, composite.solution(), out),
        CurveKind::CubicC2 => cubic_spline::append_cubic_spline(sub, composite.solution(), out),
        CurveKind::Single => single::append_single_curve(sub, single, composite, out),
        CurveKind::Composite | CurveKind::Chain => composite::append_composite_curve(sub, composite, out),
    }?;
    out.report.iterations = out.report.iterations.max(before);
    Ok(())
}

//! One outline after another: brought near the origin, freed of repeats, cut into runs, solved, judged, and brought back.

use super::curve::{Place, check_finite};
use super::fit::{Fit, span};
use super::request::{Constraint, Demand, Ends, FitStatus, Mode, Options, Outlines, PointStatus, Report};
use super::run::{Run, Sketch, Solved, Workspace};
use super::{blend, composite, cubic, judge, single};
use crate::alloc;
use crate::error::Result;
use crate::geom::scale::power_of_two;
use glam::DVec3;
use std::ops::Range;

/// What a thread works with; the workspace is used again for each outline.
pub(super) struct Worker<'a> {
    outlines: &'a Outlines<'a>,
    options: &'a Options,
    /// The constraints that are yet to come.
    constraints: &'a [Constraint],
    /// The points that differ from their neighbours, near the origin. A closed outline that is cut begins at its first cut,
    /// and ends with that point once more.
    nodes: Vec<DVec3>,
    /// For each point of the outline its node.
    node_of: Vec<u32>,
    /// Nodes where the outline is cut, or ends, and the directions there.
    cuts: Vec<Cut>,
    /// What came of each node.
    solved: Vec<Solved>,
    workspace: Workspace,
    sketch: Sketch,
    pub(super) done: Fit,
}

/// Control points of outlines below this size cannot overflow.
const HUGE: f64 = 1e200;

#[derive(Clone, Copy)]
struct Cut {
    node: u32,
    /// Of length 1.
    tangent: Option<DVec3>,
}

/// How an outline lies: point = origin + unit * node.
#[derive(Clone, Copy)]
struct Frame {
    origin: DVec3,
    /// A power of two.
    unit: f64,
    /// The longest side of the box of the nodes: between 1 and 4, but for outlines without extent.
    size: f64,
}

impl<'a> Worker<'a> {
    /// A worker that has done nothing.
    pub(super) fn new(outlines: &'a Outlines<'a>, options: &'a Options) -> Self {
        Worker {
            outlines,
            options,
            constraints: &[],
            nodes: Vec::new(),
            node_of: Vec::new(),
            cuts: Vec::new(),
            solved: Vec::new(),
            workspace: Workspace::default(),
            sketch: Sketch::default(),
            done: Fit::new(outlines.closed),
        }
    }

    /// Reserves memory for the results of some outlines.
    pub(super) fn reserve(&mut self, batch: Range<usize>) -> Result<()> {
        let points = span(self.outlines, batch.start).start..span(self.outlines, batch.end - 1).end;
        let expected = points.len() + 2 * batch.len();
        let per_segment = match self.options.mode {
            Mode::Composite => 2,
            Mode::BlendC1 | Mode::CubicC2 => 3,
            Mode::BlendC2 => 5,
            Mode::Single => 1,
        };
        let done = &mut self.done;
        alloc::reserve(&mut done.points, per_segment * expected)?;
        alloc::reserve(&mut done.ends, expected)?;
        alloc::reserve(&mut done.starts, batch.len())?;
        alloc::reserve(&mut done.segments, points.len())?;
        alloc::reserve(&mut done.parameters, points.len())?;
        alloc::reserve(&mut done.statuses, points.len())?;
        alloc::reserve(&mut done.reports, batch.len())
    }

    /// Identifies some outlines one after another.
    pub(super) fn outlines(&mut self, batch: Range<usize>) -> Result<()> {
        let first = span(self.outlines, batch.start).start;
        let from = self.outlines.constraints.partition_point(|constraint| (constraint.point as usize) < first);
        self.constraints = &self.outlines.constraints[from..];
        batch.into_iter().try_for_each(|k| self.outline(k))
    }

    /// Identifies outline `k`.
    fn outline(&mut self, k: usize) -> Result<()> {
        let points = span(self.outlines, k);
        let first_status = self.done.statuses.len();
        let frame = self.read(&points)?;
        self.cut(&points)?;
        let mut report = Report { size: frame.size * frame.unit, ..Report::default() };
        if self.cuts.is_empty() && self.options.mode == Mode::Composite {
            return self.smooth(&points, frame, first_status, report);
        }
        self.solve(frame.size, &mut report)?;
        judge::judge(&self.nodes, &self.solved, &self.sketch, self.is_closed(), frame.size, &mut report);
        self.deliver(&points, frame, first_status, report)
    }

    /// Reads the nodes, near the origin, and says which points repeat others.
    fn read(&mut self, points: &Range<usize>) -> Result<Frame> {
        let all = &self.outlines.points;
        self.nodes.clear();
        self.node_of.clear();
        alloc::reserve(&mut self.nodes, points.len() + 1)?;
        alloc::reserve(&mut self.node_of, points.len())?;
        all.read(points.clone(), &mut self.nodes);
        let (mut low, mut high) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
        // A sum of zeros, unless there is an infinity or no number.
        let mut nothing = DVec3::ZERO;
        for &p in &self.nodes {
            (low, high) = (low.min(p), high.max(p));
            nothing += p * 0.0;
        }
        if nothing != DVec3::ZERO {
            (points.start..).zip(&self.nodes).try_for_each(|(point, &p)| check_finite(point, p))?;
        }
        let half = (high * 0.5 - low * 0.5).max_element();
        if self.nodes.is_empty() || half == 0.0 {
            let origin = self.nodes.first().copied().unwrap_or(DVec3::ZERO);
            self.nodes.truncate(1);
            self.nodes.iter_mut().for_each(|node| *node = DVec3::ZERO);
            self.node_of.resize(points.len(), 0);
            return Ok(Frame { origin, unit: 1.0, size: 0.0 });
        }
        // Exact: a power of two, far from the ends of the range.
        let unit = power_of_two(half);
        let (origin, scale) = (self.nodes[0], 1.0 / unit);
        let size = half * scale * 2.0;
        let near = (self.options.repeat_tolerance * size).powi(2);
        // From a box far larger than the unit only repeats are left out.
        let shift = origin * scale;
        self.nodes.iter_mut().for_each(|node| *node = *node * scale - shift);
        self.node_of.extend(0..self.nodes.len() as u32);
        let mut count = self.nodes.len();
        if self.nodes.windows(2).any(|pair| pair[0].distance_squared(pair[1]) <= near) {
            count = 1;
            for i in 1..self.nodes.len() {
                if self.nodes[i].distance_squared(self.nodes[count - 1]) > near {
                    self.nodes[count] = self.nodes[i];
                    count += 1;
                }
                self.node_of[i] = count as u32 - 1;
            }
        }
        while self.outlines.closed && count > 1 && self.nodes[count - 1].distance_squared(self.nodes[0]) <= near {
            count -= 1;
        }
        let closing = self.node_of.partition_point(|&node| (node as usize) < count);
        self.node_of[closing..].fill(0);
        self.nodes.truncate(count);
        Ok(Frame { origin, unit, size })
    }

    /// Whether the nodes are a closed outline; two of them are not.
    fn is_closed(&self) -> bool {
        self.outlines.closed && self.nodes.len() > 2
    }

    /// Finds the cuts, and turns a closed outline so that it begins at one.
    fn cut(&mut self, points: &Range<usize>) -> Result<()> {
        self.cuts.clear();
        self.solved.clear();
        alloc::reserve(&mut self.solved, self.nodes.len() + 1)?;
        self.solved.resize(self.nodes.len(), Solved::default());
        let own = self.constraints.partition_point(|constraint| (constraint.point as usize) < points.end);
        let (own, rest) = self.constraints.split_at(own);
        self.constraints = rest;
        for constraint in own {
            let node = self.node_of[constraint.point as usize - points.start];
            let tangent = match constraint.demand {
                Demand::Corner => None,
                Demand::Tangent(tangent) => match direction(tangent) {
                    Some(tangent) => Some(tangent),
                    None => {
                        self.solved[node as usize].status = PointStatus::NoTangent;
                        continue;
                    }
                },
            };
            alloc::push(&mut self.cuts, Cut { node, tangent })?;
        }
        self.cut_corners()?;
        let last = self.nodes.len().saturating_sub(1) as u32;
        if !self.is_closed() {
            alloc::reserve(&mut self.cuts, 2)?;
            self.cuts.push(Cut { node: 0, tangent: None });
            self.cuts.push(Cut { node: last, tangent: None });
        }
        // The demand that comes first holds.
        self.cuts.sort_by_key(|cut| cut.node);
        self.cuts.dedup_by_key(|cut| cut.node);
        if let (true, Some(&first)) = (self.is_closed(), self.cuts.first()) {
            let n = self.nodes.len() as u32;
            self.nodes.rotate_left(first.node as usize);
            self.solved.rotate_left(first.node as usize);
            self.nodes.push(self.nodes[0]);
            self.solved.push(self.solved[0]);
            self.node_of.iter_mut().for_each(|node| *node = (*node + n - first.node) % n);
            self.cuts.iter_mut().for_each(|cut| cut.node -= first.node);
            alloc::push(&mut self.cuts, Cut { node: n, ..first })?;
        }
        Ok(())
    }

    /// Adds the nodes where the polygon turns by more than the angle of the options.
    fn cut_corners(&mut self) -> Result<()> {
        let n = self.nodes.len();
        if self.options.corner_angle >= std::f64::consts::PI || n < 3 {
            return Ok(());
        }
        let least = libm::cos(self.options.corner_angle);
        let inner = if self.is_closed() { 0..n } else { 1..n - 1 };
        for i in inner {
            let [a, p, c] = [self.nodes[(i + n - 1) % n], self.nodes[i], self.nodes[(i + 1) % n]];
            let (u, v) = (p - a, c - p);
            if u.dot(v) < least * u.length() * v.length() {
                alloc::push(&mut self.cuts, Cut { node: i as u32, tangent: None })?;
            }
        }
        Ok(())
    }

    /// Finds the curve, near the origin, run by run.
    fn solve(&mut self, size: f64, report: &mut Report) -> Result<()> {
        self.sketch.clear();
        let n = self.nodes.len();
        if n < 2 || (self.outlines.closed && n < 3) {
            report.status = FitStatus::TooFewPoints;
            self.solved.iter_mut().for_each(|solved| solved.status = PointStatus::Missed);
            if let Some(&point) = self.nodes.first() {
                self.sketch.begin(point)?;
            }
            if let &[p, q] = self.nodes.as_slice() {
                // There and back.
                self.sketch.push(&[q])?;
                self.sketch.push(&[p])?;
                self.solved[0] = Solved::default();
                self.solved[1] = Solved { place: Place { segment: 0, t: 1.0 }, ..Solved::default() };
            }
            return Ok(());
        }
        if self.cuts.is_empty() {
            let run = Run { points: &self.nodes, closed: true, tangents: [None, None], size };
            return curve(&run, self.options, &mut self.solved, &mut self.workspace, &mut self.sketch, report);
        }
        for pair in 0..self.cuts.len() - 1 {
            let [from, to] = [self.cuts[pair], self.cuts[pair + 1]];
            let nodes = from.node as usize..to.node as usize + 1;
            let solved = &mut self.solved[nodes.clone()];
            let mut run = Run { points: &self.nodes[nodes], closed: false, tangents: [from.tangent, to.tangent], size };
            if self.options.ends == Ends::Perpendicular {
                perpendicular_ends(&mut run, solved);
            }
            if pair > 0 && from.tangent.is_none() {
                self.sketch.mark_corner()?;
            }
            curve(&run, self.options, solved, &mut self.workspace, &mut self.sketch, report)?;
        }
        if self.is_closed() && self.cuts[0].tangent.is_none() {
            self.sketch.mark_corner()?;
        }
        // The first node is there twice: what was said of either holds.
        let (first, last) = (self.solved[0].status, self.solved[self.solved.len() - 1].status);
        if self.is_closed() && first == PointStatus::Ok {
            self.solved[0].status = last;
        }
        Ok(())
    }

    /// Finds the composite curve of a closed outline in one run and writes it where the outline is.
    fn smooth(&mut self, points: &Range<usize>, frame: Frame, first: usize, mut report: Report) -> Result<()> {
        let run = Run { points: &self.nodes, closed: true, tangents: [None, None], size: frame.size };
        composite::identify(&run, self.options, &mut self.solved, &mut self.workspace, &mut report)?;
        let (n, solution, done) = (self.nodes.len(), &self.workspace.solution, &mut self.done);
        let base = done.points.len();
        alloc::reserve(&mut done.points, 2 * n + 1)?;
        done.points.resize(base + 2 * n + 1, DVec3::ZERO);
        let place = |p: DVec3| p * frame.unit + frame.origin;
        composite::trace(&run, solution, place, &mut done.points[base..], &mut report);
        alloc::reserve(&mut done.ends, n + 1)?;
        done.ends.extend((0..=n as u32).map(|k| 2 * k));
        alloc::push(&mut done.starts, [done.points.len(), done.ends.len()])?;
        done.reserve_points(points.len())?;
        if n == points.len() {
            done.segments.extend(0..n as u32);
            done.parameters.extend_from_slice(&solution.t[..n]);
            done.statuses.extend(self.solved.iter().map(|solved| solved.status));
        } else {
            let mut taken = 0;
            for (i, &node) in self.node_of.iter().enumerate() {
                // Nodes come in ascending order; what comes again repeats its neighbour, or at the end the first point.
                let repeats = i > 0 && node < taken;
                taken = taken.max(node + 1);
                done.segments.push(node);
                done.parameters.push(solution.t[node as usize]);
                done.statuses.push(if repeats { PointStatus::Merged } else { self.solved[node as usize].status });
            }
        }
        self.check_range(points, base, first, &mut report)?;
        self.account(first, report)
    }

    /// Appends the curve where the outline is, and the account of its points.
    fn deliver(&mut self, points: &Range<usize>, frame: Frame, first: usize, mut report: Report) -> Result<()> {
        let done = &mut self.done;
        let base = done.points.len();
        alloc::reserve(&mut done.points, self.sketch.points.len())?;
        done.points.extend(self.sketch.points.iter().map(|&p| p * frame.unit + frame.origin));
        alloc::append(&mut done.ends, &self.sketch.ends)?;
        alloc::push(&mut done.starts, [done.points.len(), done.ends.len()])?;
        done.reserve_points(points.len())?;
        let (mut before, closing) = (u32::MAX, self.node_of.first().copied().unwrap_or(0));
        for (i, &node) in points.clone().zip(&self.node_of) {
            let Solved { place, mut status } = self.solved[node as usize];
            let repeats = node == before || (node == closing && i > points.start && self.outlines.closed);
            if repeats && status != PointStatus::Missed {
                status = PointStatus::Merged;
            }
            if !repeats && (place.t == 0.0 || place.t == 1.0) && !self.sketch.is_empty() {
                // Joints at points keep their bits.
                let end = self.sketch.ends[place.segment as usize + usize::from(place.t == 1.0)] as usize;
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
        self.check_range(points, base, first, &mut report)?;
        self.account(first, report)
    }

    /// Takes a curve back whose control points are beyond the largest number, though its points are not.
    fn check_range(&mut self, points: &Range<usize>, base: usize, first: usize, report: &mut Report) -> Result<()> {
        let done = &mut self.done;
        if report.size < HUGE || done.points[base..].iter().all(|p| p.is_finite()) {
            return Ok(());
        }
        done.points.truncate(base);
        alloc::push(&mut done.points, self.outlines.points.get(points.start))?;
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

    /// Sums up the statuses from the `first` on.
    fn account(&mut self, first: usize, mut report: Report) -> Result<()> {
        let done = &mut self.done;
        let mut partial = false;
        for status in &done.statuses[first..] {
            report.not_ok += u32::from(*status != PointStatus::Ok);
            partial |= !matches!(status, PointStatus::Ok | PointStatus::Merged | PointStatus::ClampedParameter);
        }
        if partial && report.status == FitStatus::Ok {
            report.status = FitStatus::Partial;
        }
        alloc::push(&mut done.reports, report)
    }
}

/// Appends the curve of a run.
fn curve(
    run: &Run<'_>,
    options: &Options,
    solved: &mut [Solved],
    workspace: &mut Workspace,
    sketch: &mut Sketch,
    report: &mut Report,
) -> Result<()> {
    match options.mode {
        Mode::BlendC1 | Mode::BlendC2 => blend::curve(run, options, solved, workspace, sketch),
        Mode::CubicC2 => cubic::curve(run, options, solved, workspace, sketch),
        Mode::Single => single::curve(run, options, solved, workspace, sketch, report),
        Mode::Composite => composite::curve(run, options, solved, workspace, sketch, report),
    }
}

/// A vector of length 1; `None` for one without direction.
fn direction(tangent: DVec3) -> Option<DVec3> {
    let largest = tangent.abs().max_element();
    (largest > 0.0).then(|| (tangent * (1.0 / largest).min(f64::MAX)).normalize())
}

/// Gives the free ends of a run the directions perpendicular to the first and the last chord, in the planes of the first and
/// the last three points.
fn perpendicular_ends(run: &mut Run<'_>, solved: &mut [Solved]) {
    let last = run.points.len() - 1;
    for (end, sign) in [(0, 1.0), (1, -1.0)] {
        if run.tangents[end].is_some() {
            continue;
        }
        let place = if end == 0 { 0 } else { last };
        let upright = (last >= 2).then(|| {
            let [tip, next, far] = [0, 1, 2].map(|k| run.points[if end == 0 { k } else { last - k }]);
            let (leg, chord) = (next - tip, far - tip);
            let across = leg - chord * (leg.dot(chord) / chord.length_squared());
            (across.length() > 1e-9 * leg.length()).then(|| across.normalize() * sign)
        });
        match upright.flatten() {
            Some(tangent) => run.tangents[end] = Some(tangent),
            None => solved[place].status = PointStatus::Collinear,
        }
    }
}

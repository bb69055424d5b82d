//! Loops that a curve has and its points lack, and crowded points, which cause them.
//!
//! A span is the curve between two consecutive points. A curve has a loop if a span crosses itself or
//! the next one, or if it crosses the next but one although the points turn by less than a half turn
//! there. A curve that advances along a direction everywhere cannot cross itself; this settles
//! nearly all spans by their control points. For the other spans: a cubic with P(s) = P(t) obeys
//! a (s^2 + s t + t^2) + b (s + t) + c = 0 in a plane, whose solution is a closed form. Other spans are
//! sampled. O(n).

use super::fit::Fit;
use super::input_points::Points;
use super::outline_nodes::NormalisationOfOutline;
use super::report::PointStatus;
use super::span_hull::{Hull, box_of, do_boxes_miss, has_cubic_loop};
use crate::curve::{CurveView, segment};
use glam::{DVec2, DVec3};
use gusset_base::alloc;
use gusset_base::error::Result;
use std::f64::consts::PI;
use std::ops::Range;

/// Parts of a span.
const SAMPLES_PER_SPAN: usize = 12;
/// Spans at most this many places apart are compared.
const MAX_SPANS_APART: usize = 2;
/// Spans that are checked together: whether they are crowded, and for a direction in which they advance,
/// besides those that are compared with spans beyond them.
const SPANS_PER_BLOCK: usize = 32;
/// Spans that are checked together if a block does not advance.
const SPANS_PER_PART: usize = 4;
/// In space, a loop whose ends are farther apart than this fraction of its size is a turn of a screw.
const MAX_RELATIVE_RISE: f64 = 0.05;
/// A point is crowded if its distance from a neighbour is below this fraction of the smaller of the
/// distances before and after.
const MAX_CROWDED_TO_SMALLER_DISTANCE: f64 = 0.01;
/// The same for the larger of the distances.
const MAX_CROWDED_TO_LARGER_DISTANCE: f64 = 1e-4;

/// The memory of a search, which outlines reuse.
#[derive(Default)]
pub(super) struct LoopSearch {
    /// The points that the curve passes, by their indices; empty if it passes all.
    stops: Vec<usize>,
    found: Vec<(usize, PointStatus)>,
}

impl LoopSearch {
    /// Flags the points of the last outline of a fit that are crowded, and those at loops. Its points
    /// start at `first` in the fit, and at `given` among `points`.
    pub(super) fn flag_points(
        &mut self,
        done: &mut Fit,
        first: usize,
        (points, given): (&Points<'_>, usize),
        placement: &NormalisationOfOutline,
    ) -> Result<()> {
        self.stops.clear();
        self.found.clear();
        let mut count = done.statuses.len() - first;
        let is_omitted = |status: &PointStatus| matches!(status, PointStatus::Merged | PointStatus::Missed);
        let omitted = done.statuses[first..].iter().map(|status| usize::from(is_omitted(status))).sum::<usize>();
        if omitted > 0 {
            count -= omitted;
            let passed = (first..done.statuses.len()).filter(|&i| !is_omitted(&done.statuses[i]));
            alloc::extend(&mut self.stops, passed)?;
        }
        let curve = done.curve(done.starts.len() - 2);
        if curve.is_empty() || count < 2 {
            return Ok(());
        }
        let (stops, found) = (&self.stops[..], &mut self.found);
        let mut spans = Spans { curve, done, points, first, given, stops, count, placement, first_position: 0.0 };
        spans.first_position = spans.own_position(0);
        spans.find_crowded_points(&mut |k| alloc::push(found, (spans.stop(k), PointStatus::Crowded)))?;
        spans.find_loops(&mut |k| alloc::push(found, (spans.stop(k), PointStatus::Looped)))?;
        for &(point, status) in &self.found {
            let own = &mut done.statuses[point];
            if matches!(own, PointStatus::Ok | PointStatus::ClampedParameter | PointStatus::Crowded) {
                *own = status;
            }
        }
        Ok(())
    }
}

/// The parts of a curve between consecutive points.
struct Spans<'a> {
    curve: CurveView<'a>,
    done: &'a Fit,
    points: &'a Points<'a>,
    /// The outline's first point in the fit, and among the points.
    first: usize,
    given: usize,
    /// The points that the curve passes, by their indices; empty if it passes all.
    stops: &'a [usize],
    /// The number of points that the curve passes.
    count: usize,
    placement: &'a NormalisationOfOutline,
    first_position: f64,
}

/// Samples of a span: positions along the curve, and points in a plane with heights above it.
type SpanSamples = [(DVec2, f64); SAMPLES_PER_SPAN + 1];

impl Spans<'_> {
    fn len(&self) -> usize {
        self.count - usize::from(!self.curve.is_closed())
    }

    #[inline]
    fn near_origin(&self, point: DVec3) -> DVec3 {
        (point - self.placement.origin) * (1.0 / self.placement.unit)
    }

    /// The index in the fit of the point at which span k starts.
    #[inline]
    fn stop(&self, k: usize) -> usize {
        let k = if k < self.count { k } else { k % self.count };
        if self.stops.is_empty() { self.first + k } else { self.stops[k] }
    }

    /// The point at which span k starts, near the origin.
    #[inline]
    fn start(&self, k: usize) -> DVec3 {
        self.near_origin(self.points.get(self.stop(k) - self.first + self.given))
    }

    fn find_crowded_points(&self, found: &mut dyn FnMut(usize) -> Result<()>) -> Result<()> {
        let spans = self.len();
        if spans < 3 {
            return Ok(());
        }
        for block in (0..spans).step_by(SPANS_PER_BLOCK) {
            let end = (block + SPANS_PER_BLOCK).min(spans);
            // The spans of the block and their neighbours.
            let closed = self.curve.is_closed();
            let from = if block > 0 || !closed { block.saturating_sub(1) } else { spans - 1 };
            let last = if end < spans || closed { end + 1 } else { end };
            let count = last - block + usize::from(block > 0 || closed);
            let (mut least, mut most) = (f64::INFINITY, 0.0_f64);
            let mut before = self.start(from);
            for k in from + 1..=from + count {
                let here = self.start(k);
                let squared = here.distance_squared(before);
                (least, most, before) = (least.min(squared), most.max(squared), here);
            }
            if least <= 1.01 * MAX_CROWDED_TO_SMALLER_DISTANCE.powi(2) * most {
                self.find_crowded_points_of(block..end, found)?;
            }
        }
        Ok(())
    }

    fn find_crowded_points_of(&self, block: Range<usize>, found: &mut dyn FnMut(usize) -> Result<()>) -> Result<()> {
        let (spans, closed) = (self.len(), self.curve.is_closed());
        let distance = |k: usize| self.start(k).distance(self.start(k + 1));
        let mut before = match block.start {
            0 if closed => distance(spans - 1),
            0 => f64::INFINITY,
            k => distance(k - 1),
        };
        let (mut here, mut is_previous_crowded) = (distance(block.start), false);
        for k in block {
            let is_last = k + 1 == spans;
            let after = if is_last && !closed { f64::INFINITY } else { distance((k + 1) % spans) };
            // Beyond an end of an open curve, the distances on one side count.
            let [smaller, larger] = match before.max(after) {
                f64::INFINITY => [before.min(after); 2],
                larger => [before.min(after), larger],
            };
            let is_crowded =
                here < MAX_CROWDED_TO_SMALLER_DISTANCE * smaller || here < MAX_CROWDED_TO_LARGER_DISTANCE * larger;
            if is_crowded {
                if !is_previous_crowded {
                    found(k)?;
                }
                found((k + 1) % self.count)?;
            }
            (before, here, is_previous_crowded) = (here, after, is_crowded);
        }
        Ok(())
    }

    fn find_loops(&self, found: &mut dyn FnMut(usize) -> Result<()>) -> Result<()> {
        let (spans, mut recent) = (self.len(), RecentSamples::default());
        for block in (0..spans).step_by(SPANS_PER_BLOCK) {
            let end = (block + SPANS_PER_BLOCK).min(spans);
            if self.advances(block, end + self.spans_after(end - 1) - block) {
                continue;
            }
            for part in (block..end).step_by(SPANS_PER_PART) {
                let part_end = (part + SPANS_PER_PART).min(end);
                if self.advances(part, part_end + self.spans_after(part_end - 1) - part) {
                    continue;
                }
                for k in part..part_end {
                    if !self.advances(k, 1 + self.spans_after(k)) {
                        self.find_loops_of_span(k, &mut recent, found)?;
                    }
                }
            }
        }
        Ok(())
    }

    /// The number of spans after span k that are compared with it.
    #[inline]
    fn spans_after(&self, k: usize) -> usize {
        let spans = self.len();
        let others = if self.curve.is_closed() { spans.saturating_sub(2) } else { spans - 1 - k };
        MAX_SPANS_APART.min(others)
    }

    fn find_loops_of_span(
        &self,
        k: usize,
        recent: &mut RecentSamples,
        found: &mut dyn FnMut(usize) -> Result<()>,
    ) -> Result<()> {
        let after = self.spans_after(k);
        let may_cross = self.may_cross(k, after);
        if may_cross == [false; MAX_SPANS_APART + 1] {
            return Ok(());
        }
        let corners = std::array::from_fn(|i| self.start(k + i.min(after + 1)));
        let Some(mut plane) = Plane::from_points(&corners).or_else(|| self.plane_of_controls(k)) else {
            return Ok(());
        };
        if self.points.is_plane() {
            plane = Plane { axes: [DVec3::X, DVec3::Y], normal: DVec3::Z };
        }
        if may_cross[0] && self.has_loop(k, &plane) {
            found(k)?;
            return found((k + 1) % self.count);
        }
        for by in 1..=after {
            if may_cross[by] && (by == 1 || self.turn_over_next_span(k, &plane).abs() < PI) {
                recent.ensure(k, self, &plane);
                recent.ensure(k + by, self, &plane);
                let (Some(own), Some(other)) = (recent.get(k), recent.get(k + by)) else { continue };
                if do_samples_cross(own, other, by == 1) {
                    (1..=by).try_for_each(|i| found((k + i) % self.count))?;
                }
            }
        }
        Ok(())
    }

    /// Returns whether span k may cross itself, the next one, and the next but one. The control points of plane
    /// spans settle most.
    fn may_cross(&self, k: usize, after: usize) -> [bool; MAX_SPANS_APART + 1] {
        let mut may = std::array::from_fn(|by| by <= after);
        if !self.points.is_plane() {
            return may;
        }
        let Some(own) = self.hull(k) else { return may };
        may[0] = own.may_cross_itself();
        for by in 1..=after {
            may[by] = self.hull(k + by).is_none_or(|other| match by {
                1 => own.may_cross_next(&other),
                _ => own.may_cross_farther(&other),
            });
        }
        may
    }

    /// The control points of a plane span that is a whole segment, or that has parts of two quadratics.
    fn hull(&self, k: usize) -> Option<Hull> {
        let [from, to] = [self.position(k), self.position(k + 1)];
        let segment = |at: usize| {
            let count = self.curve.len();
            self.curve.segment(if at < count { at } else { at % count })
        };
        let near = |p: DVec3| self.near_origin(p).truncate();
        let s = from as usize;
        let t = from - s as f64;
        let mut hull = Hull { points: [DVec2::ZERO; 6], len: 0 };
        if t == 0.0 && to - from == 1.0 {
            let controls = segment(s);
            hull.len = controls.len();
            let to = hull.points.get_mut(..hull.len)?;
            to.iter_mut().zip(controls).for_each(|(to, &p)| *to = near(p));
            return Some(hull);
        }
        let end = to - (s + 1) as f64;
        let ([p, q, r], [_, v, w]) = (segment(s), segment(s + 1)) else { return None };
        if !(end > 0.0 && end <= 1.0) {
            return None;
        }
        let [p, q, r, v, w] = [p, q, r, v, w].map(|&p| near(p));
        let between = |p: DVec2, q: DVec2, t: f64| p + (q - p) * t;
        let (after, before) = (between(q, r, t), between(r, v, end));
        let start = between(between(p, q, t), after, t);
        let stop = between(before, between(v, w, end), end);
        hull.points = [start, after, r, before, stop, stop];
        hull.len = 5;
        Some(hull)
    }

    /// The angle by which the line between points turns from span k to the next but one.
    fn turn_over_next_span(&self, k: usize, plane: &Plane) -> f64 {
        let ends: [DVec2; 4] = std::array::from_fn(|i| plane.project(self.start(k + i)).0);
        let legs: [DVec2; 3] = std::array::from_fn(|i| ends[i + 1] - ends[i]);
        let angle = |u: DVec2, v: DVec2| libm::atan2(u.perp_dot(v), u.dot(v));
        angle(legs[0], legs[1]) + angle(legs[1], legs[2])
    }

    /// The segments of some spans from span k on, counted on beyond the last one of a closed curve.
    fn segments(&self, k: usize, spans: usize) -> Range<usize> {
        let [from, to] = [self.position(k), self.position(k + spans)];
        from as usize..to.ceil() as usize
    }

    #[inline]
    fn own_position(&self, k: usize) -> f64 {
        let point = self.stop(k);
        f64::from(self.done.segments[point]) + self.done.parameters[point]
    }

    /// The position of point k along the curve, counted on beyond the end of a closed curve.
    #[inline]
    fn position(&self, k: usize) -> f64 {
        let at = self.own_position(k);
        if k < self.count && at >= self.first_position {
            return at;
        }
        // A closed curve may begin at any of its points.
        let rounds = (k / self.count) as f64 + if at < self.first_position { 1.0 } else { 0.0 };
        at + rounds * self.curve.len() as f64
    }

    /// Returns whether the control points of some spans advance along one direction.
    #[inline]
    fn advances(&self, k: usize, spans: usize) -> bool {
        let direction = self.start(k + spans) - self.start(k);
        let (points, ends, count) = (self.curve.points(), self.curve.ends(), self.curve.len());
        let do_all = |part: Range<usize>| {
            let controls = &points[ends[part.start] as usize..=ends[part.end] as usize];
            controls.windows(2).all(|leg| (leg[1] - leg[0]).dot(direction) > 0.0)
        };
        let range = self.segments(k, spans);
        let rounds = if range.start < count { 0 } else { count };
        let (from, to) = (range.start - rounds, range.end - rounds);
        do_all(from..to.min(count)) && (to <= count || do_all(0..(to - count).min(count)))
    }

    fn plane_of_controls(&self, k: usize) -> Option<Plane> {
        let mut segments = self.segments(k, 1);
        segments.find_map(|s| {
            let controls = self.curve.segment(s % self.curve.len());
            let last = controls.len() - 1;
            Plane::from_points(&[0, last / 3, last - last / 3, last].map(|i| self.near_origin(controls[i])))
        })
    }

    /// Returns whether a span crosses itself.
    fn has_loop(&self, k: usize, plane: &Plane) -> bool {
        let [from, to] = [self.position(k), self.position(k + 1)];
        if let (true, [p, q, r, s]) =
            (from.fract() == 0.0 && to - from == 1.0, self.curve.segment(from as usize % self.curve.len()))
        {
            return has_cubic_loop([p, q, r, s].map(|&p| plane.project(self.near_origin(p)).0));
        }
        let samples = self.samples(k, plane);
        (0..SAMPLES_PER_SPAN).any(|i| (i + 2..SAMPLES_PER_SPAN).any(|j| do_samples_cross_at(&samples, i, &samples, j)))
    }

    fn samples(&self, k: usize, plane: &Plane) -> SpanSamples {
        let [from, to] = [self.position(k), self.position(k + 1)];
        // The control points of the current segment in the plane, if they fit.
        let mut projected = [DVec3::ZERO; 6];
        let (mut current, mut controls) = (usize::MAX, &[][..]);
        std::array::from_fn(|i| {
            let at = from + (to - from) * (i as f64 / SAMPLES_PER_SPAN as f64);
            let floor = at as usize;
            let whole = floor - usize::from(i == SAMPLES_PER_SPAN && floor as f64 == at && floor > 0);
            if whole != current {
                let count = self.curve.len();
                (current, controls) = (whole, self.curve.segment(if whole < count { whole } else { whole % count }));
                for (to, &p) in projected.iter_mut().zip(controls) {
                    let (p, height) = plane.project(self.near_origin(p));
                    *to = p.extend(height);
                }
            }
            let t = at - whole as f64;
            let u = 1.0 - t;
            let [p, q, r, s, ..] = projected;
            let point = match controls.len() {
                4 => (p * u + q * (3.0 * t)) * (u * u) + (r * (3.0 * u) + s * t) * (t * t),
                count @ ..=6 => segment::point_at(&projected[..count], t),
                _ => {
                    let (point, height) = plane.project(self.near_origin(segment::point_at(controls, t)));
                    point.extend(height)
                }
            };
            (point.truncate(), point.z)
        })
    }
}

/// The samples of the last few spans of a plane outline.
#[derive(Default)]
struct RecentSamples {
    spans: [Option<(usize, SpanSamples)>; MAX_SPANS_APART + 1],
}

impl RecentSamples {
    /// Computes the samples of span k, unless they are known.
    fn ensure(&mut self, k: usize, spans: &Spans<'_>, plane: &Plane) {
        let own = &mut self.spans[k % (MAX_SPANS_APART + 1)];
        if !spans.points.is_plane() || own.as_ref().is_none_or(|(of, _)| *of != k) {
            *own = Some((k, spans.samples(k, plane)));
        }
    }

    fn get(&self, k: usize) -> Option<&SpanSamples> {
        self.spans[k % (MAX_SPANS_APART + 1)].as_ref().map(|(_, samples)| samples)
    }
}

/// A plane by its axes and its unit normal.
struct Plane {
    axes: [DVec3; 2],
    normal: DVec3,
}

impl Plane {
    /// The plane in which four points enclose the largest area.
    fn from_points(points: &[DVec3; 4]) -> Option<Plane> {
        let area: DVec3 = points.windows(2).map(|pair| (pair[0] - points[0]).cross(pair[1] - points[0])).sum();
        // Triangles on both sides of a line may cancel each other.
        let first = (points[1] - points[0]).cross(points[2] - points[1]);
        let largest = if area.length_squared() > first.length_squared() { area } else { first };
        let normal = largest.try_normalize()?;
        let (u, v) = normal.any_orthonormal_pair();
        Some(Plane { axes: [u, v], normal })
    }

    fn project(&self, point: DVec3) -> (DVec2, f64) {
        (DVec2::from_array(self.axes.map(|axis| axis.dot(point))), self.normal.dot(point))
    }
}

/// Returns whether the samples of a span cross the samples of a later span. The last part of the first span and
/// the first part of the next one share a point.
fn do_samples_cross(a: &SpanSamples, b: &SpanSamples, are_adjacent: bool) -> bool {
    let is_shared = |i: usize, j: usize| are_adjacent && i + 1 == SAMPLES_PER_SPAN && j == 0;
    let whole = box_of(b.iter().map(|sample| sample.0));
    (0..SAMPLES_PER_SPAN)
        .filter(|&i| !do_boxes_miss(box_of(a[i..i + 2].iter().map(|sample| sample.0)), whole))
        .any(|i| (0..SAMPLES_PER_SPAN).any(|j| !is_shared(i, j) && do_samples_cross_at(a, i, b, j)))
}

fn do_samples_cross_at(a: &SpanSamples, i: usize, b: &SpanSamples, j: usize) -> bool {
    let [(p, low), (q, _), (r, high), (s, _)] = [a[i], a[i + 1], b[j], b[j + 1]];
    if !do_segments_cross([p, q], [r, s]) {
        return false;
    }
    // The size of the loop, by its farthest sample of either span.
    let size = a[i..].iter().chain(&b[..=j]).map(|(x, _)| x.distance(p)).fold(0.0, f64::max);
    (high - low).abs() <= MAX_RELATIVE_RISE * size
}

/// Returns whether two segments of lines cross in their interiors.
fn do_segments_cross([p, q]: [DVec2; 2], [r, s]: [DVec2; 2]) -> bool {
    let side = |a: DVec2, b: DVec2, c: DVec2| (b - a).perp_dot(c - a);
    side(p, q, r) * side(p, q, s) < 0.0 && side(r, s, p) * side(r, s, q) < 0.0
}

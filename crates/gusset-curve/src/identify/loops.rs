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
/// Spans that are checked together for a direction in which they advance, besides those that are
/// compared with spans beyond them.
const SPANS_PER_BLOCK: usize = 6;
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
    /// The points that the curve passes, by their indices.
    stops: Vec<usize>,
    points: Vec<DVec3>,
    positions: Vec<f64>,
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
        let curve = done.curve(done.starts.len() - 2);
        self.stops.clear();
        self.points.clear();
        self.positions.clear();
        self.found.clear();
        let is_passed = |&i: &usize| !matches!(done.statuses[i], PointStatus::Merged | PointStatus::Missed);
        alloc::extend(&mut self.stops, (first..done.statuses.len()).filter(is_passed))?;
        if curve.is_empty() || self.stops.len() < 2 {
            return Ok(());
        }
        let scale = |point: DVec3| (point - placement.origin) / placement.unit;
        alloc::extend(&mut self.points, self.stops.iter().map(|&i| scale(points.get(given + i - first))))?;
        let position = |i: usize| f64::from(done.segments[i]) + done.parameters[i];
        alloc::extend(&mut self.positions, self.stops.iter().map(|&i| position(i)))?;
        let spans = Spans { curve, points: &self.points, positions: &self.positions, placement };
        let (stops, found) = (&self.stops, &mut self.found);
        spans.find_crowded_points(&mut |k| alloc::push(found, (stops[k], PointStatus::Crowded)))?;
        spans.find_loops(&mut |k| alloc::push(found, (stops[k], PointStatus::Looped)))?;
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
    /// The points, near the origin and of a size near 1.
    points: &'a [DVec3],
    /// Their positions along the curve: the number of the segment plus the parameter.
    positions: &'a [f64],
    placement: &'a NormalisationOfOutline,
}

/// Samples of a span: positions along the curve, and points in a plane with heights above it.
type SpanSamples = [(DVec2, f64); SAMPLES_PER_SPAN + 1];

impl Spans<'_> {
    fn len(&self) -> usize {
        self.points.len() - usize::from(!self.curve.is_closed())
    }

    fn near_origin(&self, point: DVec3) -> DVec3 {
        (point - self.placement.origin) / self.placement.unit
    }

    /// The point at which span k starts.
    fn start(&self, k: usize) -> DVec3 {
        self.points[k % self.points.len()]
    }

    fn find_crowded_points(&self, found: &mut dyn FnMut(usize) -> Result<()>) -> Result<()> {
        let (count, spans) = (self.points.len(), self.len());
        if spans < 3 {
            return Ok(());
        }
        let distance = |k: usize| self.start(k).distance(self.start(k + 1));
        let mut before = if self.curve.is_closed() { distance(spans - 1) } else { f64::INFINITY };
        let (mut here, mut is_previous_crowded) = (distance(0), false);
        for k in 0..spans {
            let is_last = k + 1 == spans;
            let after = if is_last && !self.curve.is_closed() { f64::INFINITY } else { distance((k + 1) % spans) };
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
                found((k + 1) % count)?;
            }
            (before, here, is_previous_crowded) = (here, after, is_crowded);
        }
        Ok(())
    }

    fn find_loops(&self, found: &mut dyn FnMut(usize) -> Result<()>) -> Result<()> {
        let spans = self.len();
        for block in (0..spans).step_by(SPANS_PER_BLOCK) {
            let end = (block + SPANS_PER_BLOCK).min(spans);
            if self.advances(block, end + self.spans_after(end - 1) - block) {
                continue;
            }
            for k in block..end {
                if !self.advances(k, 1 + self.spans_after(k)) {
                    self.find_loops_of_span(k, found)?;
                }
            }
        }
        Ok(())
    }

    /// The number of spans after span k that are compared with it.
    fn spans_after(&self, k: usize) -> usize {
        let spans = self.len();
        let others = if self.curve.is_closed() { spans.saturating_sub(2) } else { spans - 1 - k };
        MAX_SPANS_APART.min(others)
    }

    fn find_loops_of_span(&self, k: usize, found: &mut dyn FnMut(usize) -> Result<()>) -> Result<()> {
        let (count, after) = (self.points.len(), self.spans_after(k));
        let corners = std::array::from_fn(|i| self.start(k + i.min(after + 1)));
        let Some(plane) = Plane::from_points(&corners).or_else(|| self.plane_of_controls(k)) else {
            return Ok(());
        };
        if self.has_loop(k, &plane) {
            found(k)?;
            return found((k + 1) % count);
        }
        let own = self.samples(k, &plane);
        for by in 1..=after {
            if (by == 1 || self.turn_over_next_span(k, &plane).abs() < PI)
                && do_samples_cross(&own, &self.samples(k + by, &plane), by == 1)
            {
                (1..=by).try_for_each(|i| found((k + i) % count))?;
            }
        }
        Ok(())
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

    /// The position of point k along the curve, counted on beyond the end of a closed curve.
    fn position(&self, k: usize) -> f64 {
        let count = self.points.len();
        let (at, first) = (self.positions[k % count], self.positions[0]);
        // A closed curve may begin at any of its points.
        let rounds = (k / count) as f64 + if at < first { 1.0 } else { 0.0 };
        at + rounds * self.curve.len() as f64
    }

    /// Returns whether the control points of some spans advance along one direction.
    fn advances(&self, k: usize, spans: usize) -> bool {
        let direction = self.start(k + spans) - self.start(k);
        self.segments(k, spans).all(|s| {
            let controls = self.curve.segment(s % self.curve.len());
            controls.windows(2).all(|leg| ((leg[1] - leg[0]) / self.placement.unit).dot(direction) > 0.0)
        })
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
        std::array::from_fn(|i| {
            let at = from + (to - from) * (i as f64 / SAMPLES_PER_SPAN as f64);
            let whole = if i == SAMPLES_PER_SPAN { at.ceil() - 1.0 } else { at.floor() };
            let controls = self.curve.segment(whole as usize % self.curve.len());
            plane.project(self.near_origin(segment::point_at(controls, at - whole)))
        })
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

/// Returns whether a plane cubic crosses itself.
fn has_cubic_loop([p, q, r, s]: [DVec2; 4]) -> bool {
    let (a, b, c) = (s - p + 3.0 * (q - r), 3.0 * (p - 2.0 * q + r), 3.0 * (q - p));
    // The sum and the product of both parameters.
    let sum = -c.perp_dot(a) / b.perp_dot(a);
    let product = sum * sum + (b * sum + c).dot(a) / a.length_squared();
    let discriminant = sum * sum - 4.0 * product;
    discriminant > 1e-12 && {
        let half = 0.5 * discriminant.sqrt();
        0.5 * sum - half >= 0.0 && 0.5 * sum + half <= 1.0
    }
}

/// Returns whether the samples of a span cross the samples of a later span. The last part of the first span and
/// the first part of the next one share a point.
fn do_samples_cross(a: &SpanSamples, b: &SpanSamples, are_adjacent: bool) -> bool {
    let is_shared = |i: usize, j: usize| are_adjacent && i + 1 == SAMPLES_PER_SPAN && j == 0;
    (0..SAMPLES_PER_SPAN).any(|i| (0..SAMPLES_PER_SPAN).any(|j| !is_shared(i, j) && do_samples_cross_at(a, i, b, j)))
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

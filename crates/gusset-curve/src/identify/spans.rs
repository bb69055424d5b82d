//! The spans of a curve: its parts between consecutive points.

use super::arc_crossing::{Arc, Crossing};
use super::fit::Fit;
use super::input_points::Points;
use super::outline_nodes::NormalisationOfOutline;
use crate::curve::{CurveView, segment};
use glam::{DVec2, DVec3};
use gusset_base::alloc;
use gusset_base::error::Result;
use std::ops::Range;

/// In space, a loop whose ends are farther apart than this fraction of its size is a turn of a screw.
const MAX_LOOP_END_HEIGHT_TO_SIZE_RATIO: f64 = 0.05;
/// Turns that differ from a half turn by less than this angle count as half turns.
const HALF_TURN_TOLERANCE: f64 = 1e-9;
/// A span of a higher degree than an arc has this many straight arcs.
const STRAIGHT_ARCS_PER_SPAN: usize = 16;
/// Points of a loop that tell its size.
const SAMPLES_PER_LOOP: usize = 16;

/// The parts of a curve between consecutive points.
pub(super) struct Spans<'a> {
    pub(super) curve: CurveView<'a>,
    pub(super) fit: &'a Fit,
    pub(super) points: &'a Points<'a>,
    /// The outline's first point in the fit, and among the points.
    pub(super) first_point_in_fit: usize,
    pub(super) first_given_point: usize,
    /// The points that the curve passes, by their indices; empty if it passes all.
    pub(super) passed_points: &'a [usize],
    /// The number of points that the curve passes.
    pub(super) point_count: usize,
    pub(super) closed: bool,
    pub(super) placement: &'a NormalisationOfOutline,
    /// The first point before which a closed curve begins anew.
    pub(super) first_point_after_seam: usize,
}

/// A part of the curve: its first segment, counted on beyond the end of a closed curve, with a parameter, the number
/// of segments after it that it enters, and the parameter at which it ends.
pub(super) struct SpanPlace {
    pub(super) segment: usize,
    pub(super) start_parameter: f64,
    pub(super) further_segments: usize,
    pub(super) end_parameter: f64,
}

impl Spans<'_> {
    pub(super) fn len(&self) -> usize {
        self.point_count - usize::from(!self.closed)
    }

    #[inline]
    pub(super) fn normalise_point(&self, point: DVec3) -> DVec3 {
        (point - self.placement.origin) * (1.0 / self.placement.unit)
    }

    /// The index in the fit of the point at which span k starts.
    #[inline]
    pub(super) fn index_of_span_start(&self, k: usize) -> usize {
        let k = if k < self.point_count { k } else { k - self.point_count };
        if self.passed_points.is_empty() { self.first_point_in_fit + k } else { self.passed_points[k] }
    }

    /// The point at which span k starts, near the origin.
    #[inline]
    pub(super) fn point_of_span_start(&self, k: usize) -> DVec3 {
        self.normalise_point(
            self.points.get(self.index_of_span_start(k) - self.first_point_in_fit + self.first_given_point),
        )
    }

    /// A closed curve may begin at any of its points. Positions ascend before and after it.
    pub(super) fn find_first_point_after_seam(&self) -> usize {
        let start = self.segment_and_parameter_of_point(0);
        let (mut low, mut high) = (0, self.point_count);
        while low < high {
            let middle = low.midpoint(high);
            let is_before = self.segment_and_parameter_of_point(middle) >= start;
            (low, high) = if is_before { (middle + 1, high) } else { (low, middle) };
        }
        low
    }

    /// The segment and the parameter of point k, counted on beyond the end of a closed curve.
    #[inline]
    pub(super) fn segment_and_parameter_of_point(&self, k: usize) -> (usize, f64) {
        let point = self.index_of_span_start(k);
        let rounds = if k < self.point_count {
            usize::from(k >= self.first_point_after_seam)
        } else {
            1 + usize::from(k - self.point_count >= self.first_point_after_seam)
        };
        let (segment, t) = (self.fit.segments[point], self.fit.parameters[point]);
        (segment as usize + rounds * self.curve.len(), t)
    }

    #[inline]
    pub(super) fn place_of_span(&self, k: usize) -> SpanPlace {
        let ((mut segment, mut from), (mut last, mut to)) =
            (self.segment_and_parameter_of_point(k), self.segment_and_parameter_of_point(k + 1));
        if from == 1.0 {
            (segment, from) = (segment + 1, 0.0);
        }
        if to == 0.0 && last > segment {
            (last, to) = (last - 1, 1.0);
        }
        // Positions ascend unless a fit has failed.
        SpanPlace { segment, start_parameter: from, further_segments: last.saturating_sub(segment), end_parameter: to }
    }

    #[inline]
    pub(super) fn segment_of_span(&self, mut k: usize) -> &[DVec3] {
        while k >= self.curve.len() {
            k -= self.curve.len();
        }
        self.curve.segment(k)
    }

    /// Returns whether the control points of some spans advance along one direction.
    #[inline]
    pub(super) fn do_spans_advance(&self, k: usize, spans: usize) -> bool {
        let direction = self.point_of_span_start(k + spans) - self.point_of_span_start(k);
        let (first, last) = (self.place_of_span(k), self.place_of_span(k + spans - 1));
        let (points, ends, count) = (self.curve.points(), self.curve.ends(), self.curve.len());
        let rounds = if first.segment < count { 0 } else { first.segment / count * count };
        let (from, to) = (first.segment - rounds, last.segment + last.further_segments - rounds);
        let plane = self.points.is_plane();
        let do_all = |part: Range<usize>| {
            let controls = &points[ends[part.start] as usize..=ends[part.end] as usize];
            if plane {
                let (direction, mut before) = (direction.truncate(), controls[0].truncate());
                return controls[1..].iter().all(|p| {
                    let leg = p.truncate() - before;
                    before = p.truncate();
                    leg.dot(direction) > 0.0
                });
            }
            controls.windows(2).all(|leg| (leg[1] - leg[0]).dot(direction) > 0.0)
        };
        match (from <= to, to < count) {
            (false, _) => false,
            (true, true) => do_all(from..to + 1),
            (true, false) => do_all(from..count) && do_all(0..(to + 1 - count).min(count)),
        }
    }

    /// The control points of a span of one segment, or of parts of two, whose common control point is on a line with
    /// its neighbours.
    #[inline]
    pub(super) fn span_controls<const H: usize>(&self, k: usize) -> Option<[DVec2; H]> {
        let SpanPlace { segment, start_parameter: from, further_segments: more, end_parameter: to } =
            self.place_of_span(k);
        let near = |p: DVec3| (p.truncate() - self.placement.origin.truncate()) * (1.0 / self.placement.unit);
        let mut controls = [DVec2::ZERO; H];
        let first = self.segment_of_span(segment);
        if more == 0 && from == 0.0 && to == 1.0 {
            if first.len() != H {
                return None;
            }
            controls.iter_mut().zip(first).for_each(|(to, &p)| *to = near(p));
            return Some(controls);
        }
        if more != 1 {
            return None;
        }
        let second = self.segment_of_span(segment + 1);
        match (H, first, second) {
            (4, &[p, q, r], &[_, v, w]) => {
                let [p, q, r, v, w] = [p, q, r, v, w].map(near);
                let (after, before) = (q.lerp(r, from), r.lerp(v, to));
                let ends = [p.lerp(q, from).lerp(after, from), before.lerp(v.lerp(w, to), to)];
                controls.copy_from_slice(&[ends[0], after, before, ends[1]]);
                ((r - q).dot(v - r) >= 0.0).then_some(controls)
            }
            (6, &[p, q, r, s], &[_, u, v, w]) => {
                let [p, q, r, s, u, v, w] = [p, q, r, s, u, v, w].map(near);
                let split = |[p, q, r, s]: [DVec2; 4], t: f64| {
                    let (a, b, c) = (p.lerp(q, t), q.lerp(r, t), r.lerp(s, t));
                    let (d, e) = (a.lerp(b, t), b.lerp(c, t));
                    [a, d, d.lerp(e, t), e, c]
                };
                let ([.., start, next, after], [before, last, end, ..]) =
                    (split([p, q, r, s], from), split([s, u, v, w], to));
                controls.copy_from_slice(&[start, next, after, before, last, end]);
                ((s - r).dot(u - s) >= 0.0).then_some(controls)
            }
            _ => None,
        }
    }

    /// Appends the arcs of span k. Their positions begin at `offset`.
    pub(super) fn append_arcs(&self, k: usize, offset: f64, plane: &Plane, arcs: &mut Vec<Arc>) -> Result<()> {
        let SpanPlace { segment, start_parameter: from, further_segments: more, end_parameter: to } =
            self.place_of_span(k);
        for i in 0..=more {
            let controls = self.segment_of_span(segment + i);
            let part = [if i == 0 { from } else { 0.0 }, if i == more { to } else { 1.0 }];
            let unit = 1.0 / (more + 1) as f64;
            let range = [offset + i as f64 * unit, offset + (i + 1) as f64 * unit];
            let near = controls.iter().map(|&p| plane.project(self.normalise_point(p)));
            if let Some(arc) = Arc::from_controls(near, range) {
                alloc::push(arcs, arc.part_between(part, range))?;
                continue;
            }
            let at = |x: f64| part[0] + (part[1] - part[0]) * x;
            let point = |x: f64| plane.project(self.normalise_point(segment::point_at(controls, at(x))));
            for j in 0..STRAIGHT_ARCS_PER_SPAN {
                let ends = [j, j + 1].map(|j| j as f64 / STRAIGHT_ARCS_PER_SPAN as f64);
                let range = ends.map(|x| offset + (i as f64 + x) * unit);
                alloc::extend(arcs, Arc::from_controls(ends.map(point).into_iter(), range))?;
            }
        }
        Ok(())
    }

    /// Returns whether the ends of a turn in space are so close to each other that it is a loop. Positions count spans
    /// from span k on.
    pub(super) fn is_turn_closed(&self, k: usize, plane: &Plane, [from, to]: Crossing) -> bool {
        let at = |position: f64| {
            let span = position as usize;
            let SpanPlace { segment, start_parameter: from, further_segments: more, end_parameter: to } =
                self.place_of_span(k + span);
            let along = (position - span as f64) * (more + 1) as f64;
            let i = (along as usize).min(more);
            let part = [if i == 0 { from } else { 0.0 }, if i == more { to } else { 1.0 }];
            let t = part[0] + (part[1] - part[0]) * (along - i as f64);
            self.normalise_point(segment::point_at(self.segment_of_span(segment + i), t))
        };
        let start = at(from);
        let rise = (at(to) - start).dot(plane.axes[2]).abs();
        let sample = |i: usize| at(from + (to - from) * (i as f64 / SAMPLES_PER_LOOP as f64));
        let size = (1..SAMPLES_PER_LOOP).map(|i| plane.project(sample(i) - start).length()).fold(0.0, f64::max);
        rise <= MAX_LOOP_END_HEIGHT_TO_SIZE_RATIO * size
    }

    /// Returns the plane of four ends of span k and later spans.
    pub(super) fn find_plane_near_spans(&self, k: usize, ends: &[DVec3; 4]) -> Option<Plane> {
        if self.points.is_plane() {
            return Some(Plane { axes: [DVec3::X, DVec3::Y, DVec3::Z], is_xy: true });
        }
        let controls = || {
            let controls = self.segment_of_span(self.place_of_span(k).segment);
            let last = controls.len() - 1;
            Plane::from_points(&[0, last / 3, last - last / 3, last].map(|i| self.normalise_point(controls[i])))
        };
        Plane::from_points(ends).or_else(controls)
    }
}

/// Returns whether the lines between four points turn by a half turn or more, or reverse at a point between.
pub(super) fn do_lines_turn_back(ends: &[DVec3; 4]) -> bool {
    let [a, b, c]: [DVec3; 3] = std::array::from_fn(|i| (ends[i + 1] - ends[i]).normalize_or_zero());
    let (first, second, both) = (a.cross(b), b.cross(c), a.cross(c));
    let reverses = |across: DVec3, u: DVec3, v: DVec3| across.length() <= HALF_TURN_TOLERANCE && u.dot(v) < 0.0;
    (first.dot(second) > 0.0 && first.dot(both) <= HALF_TURN_TOLERANCE * first.length())
        || reverses(first, a, b)
        || reverses(second, b, c)
}

/// A plane by its axes and its unit normal.
pub(super) struct Plane {
    axes: [DVec3; 3],
    /// Whether this is the plane z = 0.
    pub(super) is_xy: bool,
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
        Some(Plane { axes: [u, v, normal], is_xy: false })
    }

    /// Returns the coordinates in the plane.
    #[inline]
    pub(super) fn project(&self, point: DVec3) -> DVec2 {
        let [u, v, _] = self.axes;
        if self.is_xy { point.truncate() } else { DVec2::new(u.dot(point), v.dot(point)) }
    }
}

//! Loops that a curve has and its points lack.
//!
//! A span is the curve between two consecutive points. The curve has a loop
//!
//! - at both ends of a span that crosses itself;
//! - at the point between two spans that cross;
//! - at the points k + 1 and k + 2 if spans k and k + 2 cross, unless the lines between the points turn by a
//!   half turn or more over span k + 1, or reverse at one of its ends.
//!
//! Curves that touch or retrace each other do not cross. Loops shorter than a twentieth of a span may be
//! missed. In space, the spans are projected to the plane of their points, and the ends of a loop are at most a
//! twentieth of its size apart.
//!
//! A curve that advances along a direction everywhere cannot cross itself. This settles most spans in
//! blocks, by their control points. For the other spans of a plane outline, lines that separate control
//! points settle most (see span_lanes). The remaining spans are divided (see arc_crossing). O(n).

use super::arc_crossing::{Arc, Crossing, CrossingSearch};
use super::fit::Fit;
use super::input_points::Points;
use super::outline_nodes::NormalisationOfOutline;
use super::report::PointStatus;
use super::span_lanes::{MayCross, SPANS_PER_TEST, SpanLanes};
use crate::curve::{CurveView, segment};
use glam::{DVec2, DVec3};
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::simd;
use std::ops::Range;

/// Spans at most this many places apart are compared.
const MAX_SPANS_APART: usize = 2;
/// Number of spans in a block. The search skips a block if its spans, and the spans after it that they are
/// compared with, all advance along one direction.
const SPANS_PER_BLOCK: usize = 4 * SPANS_PER_TEST;
/// Limits the distance of a loop's ends along the normal of its plane, as a fraction of its size. Beyond it,
/// the loop is a turn of a screw in space.
const MAX_LOOP_END_HEIGHT_TO_SIZE_RATIO: f64 = 0.05;
/// Turns that differ from a half turn by less than this angle count as half turns.
const HALF_TURN_TOLERANCE: f64 = 1e-9;
/// A span of a higher degree than an arc has this many straight arcs.
const STRAIGHT_ARCS_PER_SPAN: usize = 16;
/// Points of a loop that tell its size.
const SAMPLES_PER_LOOP: usize = 16;

/// The memory of a search, which outlines reuse.
#[derive(Default)]
pub(super) struct LoopSearch {
    /// The points that the curve passes, by their indices; empty if it passes all.
    passed_points: Vec<usize>,
    /// The points at loops, by their places among the stops.
    points_at_loops: Vec<usize>,
    /// The arcs of consecutive spans.
    arcs: Vec<Arc>,
}

impl LoopSearch {
    /// Flags the points at loops of the last outline of a fit. Its points start at `first_point_in_fit` in the fit, and at `first_given_point`
    /// among `points`.
    pub(super) fn flag_points(
        &mut self,
        done: &mut Fit,
        first_point_in_fit: usize,
        (points, first_given_point): (&Points<'_>, usize),
        placement: &NormalisationOfOutline,
    ) -> Result<()> {
        let LoopSearch { passed_points: stops, points_at_loops: found, arcs } = self;
        stops.clear();
        found.clear();
        let is_omitted = |status: &PointStatus| matches!(status, PointStatus::Merged | PointStatus::Missed);
        let mut count = done.statuses.len() - first_point_in_fit;
        let omitted =
            done.statuses[first_point_in_fit..].iter().map(|status| usize::from(is_omitted(status))).sum::<usize>();
        if omitted > 0 {
            count -= omitted;
            let passed = (first_point_in_fit..done.statuses.len()).filter(|&i| !is_omitted(&done.statuses[i]));
            alloc::extend(stops, passed)?;
        }
        let curve = done.curve(done.starts.len() - 2);
        if curve.is_empty() || count < 2 {
            return Ok(());
        }
        let closed = done.closed && count > 2;
        let mut spans = Spans {
            curve,
            fit: done,
            points,
            first_point_in_fit,
            first_given_point,
            passed_points: stops,
            point_count: count,
            closed,
            placement,
            first_point_after_seam: count,
        };
        spans.first_point_after_seam = spans.find_first_point_after_seam();
        spans.find_loops(&mut LoopFinds { points_at_loops: found, arc_count: count, arcs })?;
        for &place in &*found {
            let own = &mut done.statuses[if stops.is_empty() { first_point_in_fit + place } else { stops[place] }];
            if matches!(own, PointStatus::Ok | PointStatus::ClampedParameter | PointStatus::Crowded) {
                *own = PointStatus::Looped;
            }
        }
        Ok(())
    }
}

/// The points at loops so far, and the arcs of a few spans.
struct LoopFinds<'a> {
    points_at_loops: &'a mut Vec<usize>,
    arc_count: usize,
    arcs: &'a mut Vec<Arc>,
}

impl LoopFinds<'_> {
    fn push(&mut self, k: usize) -> Result<()> {
        alloc::push(self.points_at_loops, k % self.arc_count)
    }

    /// Returns whether the last spans have found point k.
    fn has_found_point(&self, k: usize) -> bool {
        let k = if k < self.arc_count { k } else { k - self.arc_count };
        self.points_at_loops.iter().rev().take(2 * MAX_SPANS_APART + 2).any(|&place| place == k)
    }
}

/// The parts of a curve between consecutive points.
struct Spans<'a> {
    curve: CurveView<'a>,
    fit: &'a Fit,
    points: &'a Points<'a>,
    /// The outline's first point in the fit, and among the points.
    first_point_in_fit: usize,
    first_given_point: usize,
    /// The points that the curve passes, by their indices; empty if it passes all.
    passed_points: &'a [usize],
    /// The number of points that the curve passes.
    point_count: usize,
    closed: bool,
    placement: &'a NormalisationOfOutline,
    /// The first point before which a closed curve begins anew.
    first_point_after_seam: usize,
}

/// A part of the curve: its first segment, counted on beyond the end of a closed curve, with a parameter, the number
/// of segments after it that it enters, and the parameter at which it ends.
struct SpanPlace {
    segment: usize,
    start_parameter: f64,
    further_segments: usize,
    end_parameter: f64,
}

/// Tests spans with the widest vectors of the processor.
fn test_lanes<const H: usize>(lanes: &SpanLanes<H>) -> MayCross {
    simd::run(lanes)
}

impl Spans<'_> {
    fn len(&self) -> usize {
        self.point_count - usize::from(!self.closed)
    }

    #[inline]
    fn normalise_point(&self, point: DVec3) -> DVec3 {
        (point - self.placement.origin) * (1.0 / self.placement.unit)
    }

    /// The index in the fit of the point at which span k starts.
    #[inline]
    fn index_of_span_start(&self, k: usize) -> usize {
        let k = if k < self.point_count { k } else { k - self.point_count };
        if self.passed_points.is_empty() { self.first_point_in_fit + k } else { self.passed_points[k] }
    }

    /// The point at which span k starts, near the origin.
    #[inline]
    fn point_of_span_start(&self, k: usize) -> DVec3 {
        self.normalise_point(
            self.points.get(self.index_of_span_start(k) - self.first_point_in_fit + self.first_given_point),
        )
    }

    /// The number of spans after span k that are compared with it.
    #[inline]
    fn spans_after(&self, k: usize) -> usize {
        let others = if self.closed { self.len().saturating_sub(2) } else { self.len() - 1 - k };
        MAX_SPANS_APART.min(others)
    }

    /// A closed curve may begin at any of its points. Positions ascend before and after it.
    fn find_first_point_after_seam(&self) -> usize {
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
    fn segment_and_parameter_of_point(&self, k: usize) -> (usize, f64) {
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
    fn place_of_span(&self, k: usize) -> SpanPlace {
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
    fn segment_of_span(&self, mut k: usize) -> &[DVec3] {
        while k >= self.curve.len() {
            k -= self.curve.len();
        }
        self.curve.segment(k)
    }

    fn find_loops(&self, found: &mut LoopFinds<'_>) -> Result<()> {
        // Spans of other kinds are searched one by one.
        let middle = self.place_of_span(self.len() / 2);
        match self.segment_of_span(middle.segment).len() {
            3 | 4 if self.points.is_plane() && (middle.start_parameter == 0.0 || middle.further_segments == 1) => {
                if self.segment_of_span(middle.segment).len() == 4 && middle.start_parameter > 0.0 {
                    self.find_loops_in_blocks::<6>(found)
                } else {
                    self.find_loops_in_blocks::<4>(found)
                }
            }
            6 if self.points.is_plane() => self.find_loops_in_blocks::<6>(found),
            _ => self.find_loops_in_blocks::<0>(found),
        }
    }

    /// Searches block by block. Spans have `H` control points; 0 if lanes cannot hold them.
    fn find_loops_in_blocks<const H: usize>(&self, found: &mut LoopFinds<'_>) -> Result<()> {
        let spans = self.len();
        let mut lanes = SpanLanes::<H>::new();
        for block in (0..spans).step_by(SPANS_PER_BLOCK) {
            let end = (block + SPANS_PER_BLOCK).min(spans);
            if self.do_spans_advance(block, end + self.spans_after(end - 1) - block) {
                continue;
            }
            for part in (block..end).step_by(SPANS_PER_TEST) {
                let part_end = (part + SPANS_PER_TEST).min(end);
                let after = self.spans_after(part_end - 1);
                if self.do_spans_advance(part, part_end + after - part) {
                    continue;
                }
                if H == 0 {
                    for k in part..part_end {
                        if !self.do_spans_advance(k, 1 + self.spans_after(k)) {
                            self.find_loops_of_span(k, [true; MAX_SPANS_APART + 1], found)?;
                        }
                    }
                    continue;
                }
                for k in part..part_end + after {
                    lanes.set_span(k - part, self.span_controls::<H>(k).as_ref());
                }
                let may = test_lanes(&lanes);
                let mut bits = (may.spans_and_themselves | may.spans_and_next | may.spans_and_next_but_one)
                    & ((1 << (part_end - part)) - 1);
                while bits != 0 {
                    let lane = bits.trailing_zeros();
                    bits &= bits - 1;
                    let may = [may.spans_and_themselves, may.spans_and_next, may.spans_and_next_but_one]
                        .map(|bits| bits >> lane & 1 == 1);
                    self.find_loops_of_span(part + lane as usize, may, found)?;
                }
            }
        }
        Ok(())
    }

    /// Returns whether the control points of some spans advance along one direction.
    #[inline]
    fn do_spans_advance(&self, k: usize, spans: usize) -> bool {
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
    fn span_controls<const H: usize>(&self, k: usize) -> Option<[DVec2; H]> {
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

    /// Divides span k and the next ones, and finds their crossings. `may_cross` tells whether span k may cross itself, the
    /// next span, and the next but one.
    fn find_loops_of_span(
        &self,
        k: usize,
        may_cross: [bool; MAX_SPANS_APART + 1],
        found: &mut LoopFinds<'_>,
    ) -> Result<()> {
        let after = self.spans_after(k);
        // A point is flagged once.
        let mut may = may_cross;
        may[1] &= after >= 1 && !found.has_found_point(k + 1);
        may[2] &= after >= 2
            && !(found.has_found_point(k + 1) && found.has_found_point(k + 2))
            && !self.do_spans_turn_back(k);
        if may == [false; MAX_SPANS_APART + 1] {
            return Ok(());
        }
        let Some(plane) = self.find_plane_near_spans(k, after) else { return Ok(()) };
        found.arcs.clear();
        let mut ends = [0; MAX_SPANS_APART + 1];
        for by in 0..=after {
            if by == 0 || may[by] {
                self.append_arcs(k + by, by as f64, &plane, found.arcs)?;
            }
            ends[by] = found.arcs.len();
        }
        let arcs = &found.arcs[..];
        let is_loop = |crossing: Crossing| self.is_turn_closed(k, &plane, crossing);
        let search = CrossingSearch { is_accepted_crossing: if plane.is_xy { None } else { Some(&is_loop) } };
        let own = &arcs[..ends[0]];
        let itself = may[0] && search.do_cross_within(own);
        let next = !itself && may[1] && search.do_cross_between(own, &arcs[ends[0]..ends[1]], true);
        let farther = may[2] && search.do_cross_between(own, &arcs[ends[1]..ends[2]], false);
        let is_found = [itself, itself || next || farther, farther];
        (0..=MAX_SPANS_APART).filter(|&by| is_found[by]).try_for_each(|by| found.push(k + by))
    }

    /// Returns whether the lines between points turn by a half turn or more from span k to the next but one, or reverse
    /// at a point between.
    fn do_spans_turn_back(&self, k: usize) -> bool {
        let ends: [DVec3; 4] = std::array::from_fn(|i| self.point_of_span_start(k + i));
        let [a, b, c]: [DVec3; 3] = std::array::from_fn(|i| (ends[i + 1] - ends[i]).normalize_or_zero());
        let (first, second, both) = (a.cross(b), b.cross(c), a.cross(c));
        let reverses = |across: DVec3, u: DVec3, v: DVec3| across.length() <= HALF_TURN_TOLERANCE && u.dot(v) < 0.0;
        (first.dot(second) > 0.0 && first.dot(both) <= HALF_TURN_TOLERANCE * first.length())
            || reverses(first, a, b)
            || reverses(second, b, c)
    }

    fn find_plane_near_spans(&self, k: usize, after: usize) -> Option<Plane> {
        if self.points.is_plane() {
            return Some(Plane { axes: [DVec3::X, DVec3::Y, DVec3::Z], is_xy: true });
        }
        let corners = std::array::from_fn(|i| self.point_of_span_start(k + i.min(after + 1)));
        let controls = || {
            let controls = self.segment_of_span(self.place_of_span(k).segment);
            let last = controls.len() - 1;
            Plane::from_points(&[0, last / 3, last - last / 3, last].map(|i| self.normalise_point(controls[i])))
        };
        Plane::from_points(&corners).or_else(controls)
    }

    /// Appends the arcs of span k. Their positions begin at `offset`.
    fn append_arcs(&self, k: usize, offset: f64, plane: &Plane, arcs: &mut Vec<Arc>) -> Result<()> {
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
    fn is_turn_closed(&self, k: usize, plane: &Plane, [from, to]: Crossing) -> bool {
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
        let end_height = (at(to) - start).dot(plane.axes[2]).abs();
        let sample = |i: usize| at(from + (to - from) * (i as f64 / SAMPLES_PER_LOOP as f64));
        let size = (1..SAMPLES_PER_LOOP).map(|i| plane.project(sample(i) - start).length()).fold(0.0, f64::max);
        end_height <= MAX_LOOP_END_HEIGHT_TO_SIZE_RATIO * size
    }
}

/// A plane by its axes and its unit normal.
struct Plane {
    axes: [DVec3; 3],
    /// Whether this is the plane z = 0.
    is_xy: bool,
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
    fn project(&self, point: DVec3) -> DVec2 {
        let [u, v, _] = self.axes;
        if self.is_xy { point.truncate() } else { DVec2::new(u.dot(point), v.dot(point)) }
    }
}

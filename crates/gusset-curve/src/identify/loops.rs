//! Loops that a curve has and its points lack.
//!
//! A span is the curve between two consecutive points. The curve has a loop
//!
//! - at both ends of a span that crosses itself;
//! - at the point between two spans that cross;
//! - at the points k + 1 and k + 2 if spans k and k + 2 cross, unless the lines between the points turn by a
//!   half turn or more over span k + 1, or reverse at one of its ends;
//! - at all points of a crowded run if the spans at both of its ends cross (see crowded_runs).
//!
//! Curves that touch or retrace each other do not cross. Loops shorter than a twentieth of a span may be
//! missed. In space, the spans are projected to the plane of their points, and the ends of a loop are at most a
//! twentieth of its size apart.
//!
//! A curve that advances along a direction everywhere cannot cross itself. This settles most spans in
//! blocks, by their control points. For the other spans of a plane outline, lines that separate control
//! points settle most (see span_lanes). The remaining spans are divided (see arc_crossing). O(n).

use super::arc_crossing::{Arc, Crossing, CrossingSearch};
use super::crowded_runs::RunSearch;
use super::fit::Fit;
use super::input_points::Points;
use super::outline_nodes::NormalisationOfOutline;
use super::report::PointStatus;
use super::span_lanes::{MayCross, SPANS_PER_TEST, SpanLanes};
use super::spans::{Spans, do_lines_turn_back};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::simd;

/// Spans at most this many places apart are compared.
const MAX_SPANS_APART: usize = 2;
/// Number of spans in a block. The search skips a block if its spans, and the spans after it that they are
/// compared with, all advance along one direction.
const SPANS_PER_BLOCK: usize = 4 * SPANS_PER_TEST;

/// The memory of a search, which outlines reuse.
#[derive(Default)]
pub(super) struct LoopSearch {
    /// The points that the curve passes, by their indices; empty if it passes all.
    passed_points: Vec<usize>,
    /// The points at loops, by their places among the stops.
    points_at_loops: Vec<usize>,
    /// The arcs of consecutive spans.
    arcs: Vec<Arc>,
    runs: RunSearch,
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
        let LoopSearch { passed_points: stops, points_at_loops: found, arcs, runs } = self;
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
        runs.find_loops(&spans, arcs, found)?;
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

/// Tests spans with the widest vectors of the processor.
fn test_lanes<const H: usize>(lanes: &SpanLanes<H>) -> MayCross {
    simd::run(lanes)
}

impl Spans<'_> {
    /// The number of spans after span k that are compared with it.
    #[inline]
    fn spans_after(&self, k: usize) -> usize {
        let others = if self.closed { self.len().saturating_sub(2) } else { self.len() - 1 - k };
        MAX_SPANS_APART.min(others)
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
        let ends: [DVec3; 4] = std::array::from_fn(|i| self.point_of_span_start(k + i.min(after + 1)));
        let mut may = may_cross;
        may[1] &= after >= 1 && !found.has_found_point(k + 1);
        may[2] &=
            after >= 2 && !(found.has_found_point(k + 1) && found.has_found_point(k + 2)) && !do_lines_turn_back(&ends);
        if may == [false; MAX_SPANS_APART + 1] {
            return Ok(());
        }
        let Some(plane) = self.find_plane_near_spans(k, &ends) else { return Ok(()) };
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
}

//! Loops around runs of points that are close to each other.
//!
//! A curve that overshoots at such points may cross itself beyond them: the span before the run crosses the span
//! after it. A run has two legs or more, the lines between its points. They are together shorter than the control
//! polygons of one of both spans. A run counts as one line where the turn of the lines is asked for. Runs of more
//! than [`MAX_SPANS_ACROSS_RUN`] spans are not searched. O(n).

use super::arc_crossing::{Arc, Crossing, CrossingSearch};
use super::spans::{Spans, do_lines_turn_back};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;

/// A span is compared with spans across a run at least this many places apart. Closer ones are neighbours.
const MIN_SPANS_ACROSS_RUN: usize = 3;
/// A span is compared with spans across a run at most this many places apart.
const MAX_SPANS_ACROSS_RUN: usize = 16;
/// Spans that are skipped together if they and their neighbours advance along one direction.
const SPANS_PER_BLOCK: usize = 32;

/// The memory of a search, which outlines reuse.
#[derive(Default)]
pub(super) struct RunSearch {
    /// The lengths of the lines between the points of the spans.
    leg_lengths: Vec<f64>,
}

impl RunSearch {
    /// Appends the places of the points in runs whose ends cross.
    pub(super) fn find_loops(
        &mut self,
        spans: &Spans<'_>,
        arcs: &mut Vec<Arc>,
        points_at_loops: &mut Vec<usize>,
    ) -> Result<()> {
        self.leg_lengths.clear();
        for block in (0..spans.len()).step_by(SPANS_PER_BLOCK) {
            if do_spans_around_block_advance(spans, block) {
                continue;
            }
            if self.leg_lengths.is_empty() {
                alloc::extend(&mut self.leg_lengths, (0..spans.len()).map(|k| leg_length(spans, k)))?;
            }
            for k in block..(block + SPANS_PER_BLOCK).min(spans.len()) {
                self.find_loops_next_to_span(spans, k, arcs, points_at_loops)?;
            }
        }
        Ok(())
    }

    /// Appends the places of the points in runs after span k and before it.
    fn find_loops_next_to_span(
        &self,
        spans: &Spans<'_>,
        k: usize,
        arcs: &mut Vec<Arc>,
        points_at_loops: &mut Vec<usize>,
    ) -> Result<()> {
        let count = spans.len();
        let mut enter = |k: usize, by: usize| {
            if !do_ends_of_run_cross(spans, k, by, arcs)? {
                return Ok(());
            }
            alloc::extend(points_at_loops, (k + 1..=k + by).map(|place| place % spans.point_count))
        };
        // Both spans at the ends of a run are neighbours from the other side if few spans are left there.
        let most = MAX_SPANS_ACROSS_RUN.min(count.saturating_sub(if spans.closed { MIN_SPANS_ACROSS_RUN } else { 1 }));
        let [most_after, most_before] = if spans.closed { [most; 2] } else { [count - 1 - k, k].map(|n| most.min(n)) };
        let after = |by: usize| if k + by < count { k + by } else { k + by - count };
        let before = |by: usize| if k >= by { k - by } else { k + count - by };
        let reach = reach_of_span(spans, k);
        let mut run = 0.0;
        for by in 2..=most_after {
            run += self.leg_lengths[after(by - 1)];
            if run >= reach {
                break;
            }
            if by >= MIN_SPANS_ACROSS_RUN {
                enter(k, by)?;
            }
        }
        // If the span before the run reaches as far, it finds the run itself.
        let mut run = 0.0;
        for by in 2..=most_before {
            run += self.leg_lengths[before(by - 1)];
            if run >= reach {
                break;
            }
            if by >= MIN_SPANS_ACROSS_RUN && run >= reach_of_span(spans, before(by)) {
                enter(before(by), by)?;
            }
        }
        Ok(())
    }
}

/// Returns whether a block of spans and the spans that it is compared with advance along one direction, so that they
/// do not cross.
fn do_spans_around_block_advance(spans: &Spans<'_>, block: usize) -> bool {
    let (count, window) = (spans.len(), SPANS_PER_BLOCK + 2 * MAX_SPANS_ACROSS_RUN);
    if window >= count {
        return false;
    }
    let start = if block >= MAX_SPANS_ACROSS_RUN { block } else { block + count } - MAX_SPANS_ACROSS_RUN;
    let is_whole = spans.closed || (block >= MAX_SPANS_ACROSS_RUN && start + window <= count);
    is_whole && spans.do_spans_advance(start % count, window)
}

/// The length of the control polygons of span k's segments, which the span does not exceed.
#[inline]
fn reach_of_span(spans: &Spans<'_>, k: usize) -> f64 {
    let place = spans.place_of_span(k);
    let mut length = 0.0;
    for i in place.segment..place.segment + place.further_segments + 1 {
        for leg in spans.segment_of_span(i).windows(2) {
            length += leg[0].distance(leg[1]);
        }
    }
    length / spans.placement.unit
}

/// The length of the line between the points of span k.
#[inline]
fn leg_length(spans: &Spans<'_>, k: usize) -> f64 {
    spans.point_of_span_start(k).distance(spans.point_of_span_start(k + 1))
}

/// Returns the smallest and the largest coordinates of the control points of span k's segments.
#[inline]
fn bounds_of_span(spans: &Spans<'_>, k: usize) -> [DVec3; 2] {
    let place = spans.place_of_span(k);
    let controls = (0..=place.further_segments).flat_map(|i| spans.segment_of_span(place.segment + i));
    controls.fold([DVec3::INFINITY, DVec3::NEG_INFINITY], |[low, high], &p| [low.min(p), high.max(p)])
}

/// Returns whether plane spans may share a point. Spans in space may cross where their ends are apart.
fn may_spans_cross(spans: &Spans<'_>, k: usize, other: usize) -> bool {
    let [a, b] = [k, other].map(|k| bounds_of_span(spans, k));
    !spans.points.is_plane() || (a[0].cmple(b[1]) & b[0].cmple(a[1])).all()
}

/// Returns whether span k crosses the one some places after it.
fn do_ends_of_run_cross(spans: &Spans<'_>, k: usize, by: usize, arcs: &mut Vec<Arc>) -> Result<bool> {
    if !may_spans_cross(spans, k, k + by) {
        return Ok(false);
    }
    let ends: [DVec3; 4] = [k, k + 1, k + by, k + by + 1].map(|i| spans.point_of_span_start(i));
    if do_lines_turn_back(&ends) {
        return Ok(false);
    }
    let Some(plane) = spans.find_plane_near_spans(k, &ends) else { return Ok(false) };
    arcs.clear();
    spans.append_arcs(k, 0.0, &plane, arcs)?;
    let own = arcs.len();
    spans.append_arcs(k + by, by as f64, &plane, arcs)?;
    let is_loop = |crossing: Crossing| spans.is_turn_closed(k, &plane, crossing);
    let search = CrossingSearch { is_accepted_crossing: if plane.is_xy { None } else { Some(&is_loop) } };
    Ok(search.do_cross_between(&arcs[..own], &arcs[own..], false))
}

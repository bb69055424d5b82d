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

/// Appends the places of the points in runs whose ends cross.
pub(super) fn find_loops_across_runs(
    spans: &Spans<'_>,
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
    let last = count.saturating_sub(1);
    // A curve that advances along a direction does not cross itself.
    let is_settled = |block: usize| {
        let window = SPANS_PER_BLOCK + 2 * MAX_SPANS_ACROSS_RUN;
        let start = if block >= MAX_SPANS_ACROSS_RUN { block } else { block + count } - MAX_SPANS_ACROSS_RUN;
        let is_whole = spans.closed || (block >= MAX_SPANS_ACROSS_RUN && start + window <= count);
        window < count && is_whole && spans.do_spans_advance(start % count, window)
    };
    let mut is_block_settled = false;
    for k in 0..count {
        if k % SPANS_PER_BLOCK == 0 {
            is_block_settled = is_settled(k);
        }
        if is_block_settled {
            continue;
        }
        let reach = reach_of_span(spans, k);
        // The run after the span.
        let (mut run, mut by) = (leg_length(spans, k + 1), 2);
        while run < reach && by <= if spans.closed { most } else { most.min(last - k) } {
            if by >= MIN_SPANS_ACROSS_RUN {
                enter(k, by)?;
            }
            run += leg_length(spans, k + by);
            by += 1;
        }
        // The run before it, unless the span before the run reaches as far.
        let before = |by: usize| if k >= by { k - by } else { k + count - by };
        let allowed = if spans.closed { most } else { most.min(k) };
        let (mut run, mut by) = (if allowed > 0 { leg_length(spans, before(1)) } else { 0.0 }, 2);
        while run < reach && by <= allowed {
            let first = before(by);
            if by >= MIN_SPANS_ACROSS_RUN && run >= reach_of_span(spans, first) {
                enter(first, by)?;
            }
            run += leg_length(spans, first);
            by += 1;
        }
    }
    Ok(())
}

/// The length of the control polygons of span k's segments, which the span does not exceed.
#[inline]
fn reach_of_span(spans: &Spans<'_>, k: usize) -> f64 {
    let place = spans.place_of_span(k);
    let polygon =
        |i: usize| spans.segment_of_span(place.segment + i).windows(2).map(|leg| leg[0].distance(leg[1])).sum::<f64>();
    (0..=place.further_segments).map(polygon).sum::<f64>() / spans.placement.unit
}

/// The length of the line between the points of span k.
#[inline]
fn leg_length(spans: &Spans<'_>, k: usize) -> f64 {
    spans.point_of_span_start(k).distance(spans.point_of_span_start(k + 1))
}

/// Returns whether span k crosses the one some places after it.
fn do_ends_of_run_cross(spans: &Spans<'_>, k: usize, by: usize, arcs: &mut Vec<Arc>) -> Result<bool> {
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

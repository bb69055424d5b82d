//! Common points of a curve and the surface.
//!
//! Parts of the curve descend the index together with blocks of cells. The larger of the two is
//! divided, and separated pairs are discarded. `subdivision` finds the common points of a part of
//! the curve and a cell, with proof.

use super::curve_search::{CurvePointInCell, CurveSegmentPart, CurveSheetSearch};
use super::hit_merging::MAX_POINT_HIT_LENGTH_IN_MERGE_DISTANCES;
use super::line::{Hit, HitSelection, Line, MAX_LINE_COORDINATE};
use super::line_search::LineWorkspace;
use crate::{Surface, each_sheet};
use glam::DVec3;
use gusset_base::error::{Allowed, Error, Result};
use gusset_base::geom::bernstein::elevate;
use gusset_base::job::Job;
use gusset_base::sort;
use gusset_base::{alloc, par};
use gusset_curve::{CurveView, Place as CurvePlace};
use std::cmp::Ordering;

/// A common point of a curve and a surface.
pub type CurveHit = Hit<CurvePlace>;

/// Largest degree of a segment.
const MAX_SEGMENT_DEGREE: usize = 7;
/// Number of segments that a thread processes in one task.
const SEGMENTS_PER_TASK: usize = 64;
/// Finds on one curve may be the same point if their parameters differ by at most this.
const MAX_SAME_CURVE_PARAMETER_GAP: f64 = 1e-6;

impl Surface<'_> {
    /// Finds the common points of a curve and the surface, in the order of the curve.
    ///
    /// A point at a joint of segments, on a side between cells or sheets, or at a pole is found
    /// once. No point is missed: each place where contact or coincidence cannot be resolved yields
    /// a hit marked as tangent. Costs about O(log cells) for each cell close to the curve, and a
    /// limited amount for each cell and segment that coincide. The job's threads share the
    /// segments.
    ///
    /// # Errors
    /// [`Error::OptionOutOfRange`] if a segment has a degree above 7 or a coordinate above 1e150,
    /// [`Error::EmptyCurve`], [`Error::OutOfMemory`], [`Error::Cancelled`].
    pub fn curve(&self, curve: &CurveView<'_>, selection: HitSelection, job: &Job<'_>) -> Result<Vec<CurveHit>> {
        if curve.is_empty() {
            return Err(Error::EmptyCurve);
        }
        let mut degrees = curve.segments().map(|segment| segment.len() - 1);
        degrees.try_for_each(|degree| {
            Error::require(
                degree <= MAX_SEGMENT_DEGREE,
                "degree",
                degree as f64,
                Allowed::AtMost(MAX_SEGMENT_DEGREE as f64),
            )
        })?;
        let mut numbers = curve.points().iter().flat_map(DVec3::to_array);
        numbers.try_for_each(|x| {
            Error::require(x.abs() <= MAX_LINE_COORDINATE, "curve", x, "at most 1e150 in every coordinate")
        })?;
        let finds = self.find_on_all_segments(curve, selection, job)?;
        let mut hits = self.merge_and_classify_finds(curve, finds)?;
        if selection == HitSelection::First && hits.first().is_some_and(|hit| hit.tangent) {
            // The unresolved part may continue in later segments.
            hits = self.merge_and_classify_finds(curve, self.find_on_all_segments(curve, HitSelection::All, job)?)?;
        }
        if selection != HitSelection::All {
            hits.truncate(1);
        }
        Ok(hits)
    }

    /// The finds of all segments, or of the first segments that have any.
    fn find_on_all_segments(
        &self,
        curve: &CurveView<'_>,
        selection: HitSelection,
        job: &Job<'_>,
    ) -> Result<Vec<CurvePointInCell>> {
        let mut finds = Vec::new();
        let count = curve.len();
        let round =
            SEGMENTS_PER_TASK * par::resolve_thread_count(count.div_ceil(SEGMENTS_PER_TASK), job.requested_threads());
        for from in (0..count).step_by(round) {
            job.step(from as f64 / count as f64, "curve and surface")?;
            let to = count.min(from + round);
            for part in
                par::map(job.requested_threads(), par::split_into_ranges(to - from, SEGMENTS_PER_TASK), |range| {
                    let mut finder = SegmentSearchWorkspace::default();
                    for k in range {
                        self.find_on_segment(from + k, curve.segment(from + k), &mut finder)?;
                    }
                    Ok(finder.finds)
                })?
            {
                alloc::append(&mut finds, &part?)?;
            }
            if selection != HitSelection::All && !finds.is_empty() {
                break;
            }
        }
        Ok(finds)
    }

    /// Adds the finds of segment k.
    fn find_on_segment(&self, k: usize, controls: &[DVec3], finder: &mut SegmentSearchWorkspace) -> Result<()> {
        if controls.iter().all(|&point| point == controls[0]) {
            // The segment adds nothing to the ends of its neighbours.
            return Ok(());
        }
        match controls.len() {
            2 => self.find_on_line_segment(k, [controls[0], controls[1]], finder),
            3 | 4 => self.find_on_curved_segment::<4>(k, controls, finder),
            _ => self.find_on_curved_segment::<8>(k, controls, finder),
        }
    }

    fn find_on_line_segment(&self, k: usize, [a, b]: [DVec3; 2], finder: &mut SegmentSearchWorkspace) -> Result<()> {
        self.find_hits(&Line::segment(a, b), HitSelection::All, &mut finder.lines)?;
        for hit in &finder.lines.hits {
            let ends = hit.span.map(|t| a.lerp(b, t));
            let find = CurvePointInCell {
                curve_position: k as f64 + hit.at,
                span: hit.span.map(|t| k as f64 + t),
                span_end_points: ends,
                distance_of_span_ends: ends[0].distance(ends[1]),
                place: hit.place,
                point: hit.point,
                gap: a.lerp(b, hit.at).distance(hit.point),
                tangent: hit.tangent,
                runs_inside: false,
                is_touching: hit.tangent && hit.span[0] == hit.span[1],
            };
            alloc::push(&mut finder.finds, find)?;
        }
        Ok(())
    }

    fn find_on_curved_segment<const M: usize>(
        &self,
        k: usize,
        controls: &[DVec3],
        finder: &mut SegmentSearchWorkspace,
    ) -> Result<()> {
        let part = CurveSegmentPart::whole_segment(elevated_segment::<M>(controls));
        for sheet in 0..self.len() {
            let (kind, index) = self.sheet_and_index(sheet);
            each_sheet!(kind, cells => {
                let (sheet, tolerance) = (sheet as u32, self.tolerance());
                let search = CurveSheetSearch { cells, index, sheet, segment: k, tolerance };
                search.find_common_points(&part, &mut finder.finds)
            })?;
        }
        Ok(())
    }

    /// Converts finds to hits: each once, in the order of the curve.
    fn merge_and_classify_finds(
        &self,
        curve: &CurveView<'_>,
        mut finds: Vec<CurvePointInCell>,
    ) -> Result<Vec<CurveHit>> {
        let merge_distance = self.hit_merge_distance();
        merge_overlapping(&mut finds, merge_distance);
        for find in finds.iter_mut().filter(|find| find.tangent) {
            find.runs_inside = find.distance_of_span_ends > self.max_touch_length();
            let point = find.distance_of_span_ends <= MAX_POINT_HIT_LENGTH_IN_MERGE_DISTANCES * merge_distance
                || self.is_crossing_direction(find.place, curve_direction(curve, find.curve_position));
            find.tangent = find.runs_inside || find.is_touching || !point;
        }
        sort::sort_stable(&mut finds, &compare_curve_finds);
        let mut kept: Vec<CurvePointInCell> = alloc::with_capacity(finds.len())?;
        for find in finds {
            let mut near = kept
                .iter()
                .rev()
                .take_while(|other| find.curve_position - other.curve_position <= MAX_SAME_CURVE_PARAMETER_GAP);
            let known = near.any(|other| is_same_crossing(other, &find, merge_distance));
            if !known {
                kept.push(find);
            }
        }
        // The end of a closed curve is its start.
        let round = curve.len() as f64;
        if let [first, .., last] = &kept[..]
            && curve.is_closed()
            && !(first.tangent || last.tangent)
            && last.curve_position - round + MAX_SAME_CURVE_PARAMETER_GAP >= first.curve_position
            && first.point.distance(last.point) <= merge_distance
        {
            kept.pop();
        }
        for find in kept.iter_mut().filter(|find| !find.tangent) {
            find.tangent = self.does_direction_only_touch(
                find.place,
                curve_direction(curve, find.curve_position),
                find.point.abs().max_element(),
            );
        }
        alloc::collect(kept.iter().map(|find| {
            let span = if find.tangent { find.span } else { [find.curve_position; 2] };
            Hit {
                at: curve_place_from_number(curve, find.curve_position),
                span: span.map(|at| curve_place_from_number(curve, at)),
                place: find.place,
                point: find.point,
                normal: self.normal(find.place),
                tangent: find.tangent,
                multiplicity: if find.tangent { 2 * u32::from(!find.runs_inside) } else { 1 },
            }
        }))
    }
}

/// The place of a number that is the sum of segment index and parameter.
fn curve_place_from_number(curve: &CurveView<'_>, global_parameter: f64) -> CurvePlace {
    let segment = (global_parameter as usize).min(curve.len() - 1);
    CurvePlace { segment: segment as u32, t: global_parameter - segment as f64 }
}

/// The unit vector along the curve.
fn curve_direction(curve: &CurveView<'_>, global_parameter: f64) -> DVec3 {
    curve.tangent(curve_place_from_number(curve, global_parameter)).unwrap_or(DVec3::ZERO)
}

/// Orders finds by their place on the curve, then by cells.
fn compare_curve_finds(a: &CurvePointInCell, b: &CurvePointInCell) -> Ordering {
    a.curve_position
        .total_cmp(&b.curve_position)
        .then_with(|| (a.place.sheet, a.place.cell).cmp(&(b.place.sheet, b.place.cell)))
}

/// Merges unresolved finds that overlap along the curve. Keeps the place that is closest to the
/// surface.
fn merge_overlapping(finds: &mut Vec<CurvePointInCell>, merge_distance: f64) {
    let by_span = |a: &CurvePointInCell, b: &CurvePointInCell| {
        a.span[0].total_cmp(&b.span[0]).then_with(|| compare_curve_finds(a, b))
    };
    sort::sort_stable(finds, &|a, b| a.tangent.cmp(&b.tangent).then_with(|| by_span(a, b)));
    finds.dedup_by(|next, all| {
        let joins = all.tangent && next.tangent && begins_within_or_at_end_of(all, next, merge_distance);
        if joins {
            all.distance_of_span_ends += next.distance_of_span_ends;
            if next.span[1] > all.span[1] {
                (all.span[1], all.span_end_points[1]) = (next.span[1], next.span_end_points[1]);
            }
            if next.gap < all.gap {
                (all.curve_position, all.place, all.point, all.gap) =
                    (next.curve_position, next.place, next.point, next.gap);
            }
        }
        joins
    });
}

/// True if an unresolved find begins within another one, or at its end.
fn begins_within_or_at_end_of(first: &CurvePointInCell, next: &CurvePointInCell, merge_distance: f64) -> bool {
    let near = next.span[0] - first.span[1] <= 1e-3
        && first.span_end_points[1].distance(next.span_end_points[0]) <= 2.0 * merge_distance;
    next.span[0] <= first.span[1] || near
}

/// True if two finds are the same crossing: at the same place of the curve and the surface.
fn is_same_crossing(a: &CurvePointInCell, b: &CurvePointInCell, merge_distance: f64) -> bool {
    !a.tangent && !b.tangent && a.point.distance(b.point) <= merge_distance
}

/// The control points of a segment, raised to degree M - 1.
pub(super) fn elevated_segment<const M: usize>(controls: &[DVec3]) -> [DVec3; M] {
    let mut points = [DVec3::ZERO; M];
    points[..controls.len()].copy_from_slice(controls);
    elevate(&mut points, controls.len() - 1);
    points
}

/// The finds of one thread.
#[derive(Default)]
struct SegmentSearchWorkspace {
    lines: LineWorkspace,
    finds: Vec<CurvePointInCell>,
}

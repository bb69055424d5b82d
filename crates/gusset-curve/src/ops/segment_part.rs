//! Tools for subdivision: parts of segments, separation tests of hulls, and the removal of
//! duplicate solutions from neighbours.

use crate::curve::segment::SegmentBuffer;
use glam::DVec3;
use gusset_base::geom::Aabb;
use gusset_base::sort;
use std::cmp::Ordering;

/// A part of a segment between two parameters.
#[derive(Clone, Copy)]
pub(super) struct SegmentPart {
    pub(super) controls: SegmentBuffer,
    pub(super) start_parameter: f64,
    pub(super) end_parameter: f64,
}

impl SegmentPart {
    pub(super) fn from_whole_segment(controls: SegmentBuffer) -> Self {
        SegmentPart { controls, start_parameter: 0.0, end_parameter: 1.0 }
    }

    pub(super) fn middle_parameter(&self) -> f64 {
        0.5 * (self.start_parameter + self.end_parameter)
    }

    /// Returns the longest side of the bounding box of the control points.
    pub(super) fn control_box_size(&self) -> f64 {
        Aabb::from_points(self.controls.iter()).size().max_element()
    }

    pub(super) fn into_halves(mut self) -> [SegmentPart; 2] {
        let middle = self.middle_parameter();
        let before = SegmentPart { controls: self.controls.split_off_part_before(0.5), end_parameter: middle, ..self };
        [before, SegmentPart { start_parameter: middle, ..self }]
    }
}

/// Halves part `number` of a pair.
pub(super) fn halve_one_of_pair([p, q]: [SegmentPart; 2], number: usize) -> [[SegmentPart; 2]; 2] {
    if number == 0 { p.into_halves().map(|half| [half, q]) } else { q.into_halves().map(|half| [p, half]) }
}

/// Returns true if two hulls are farther apart than `slack` along a unit axis.
pub(super) fn axis_separates_hulls(axis: DVec3, a: &[DVec3], b: &[DVec3], slack: f64) -> bool {
    let range = |points: &[DVec3]| {
        let along = points.iter().map(|&p| axis.dot(p - a[0]));
        along.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)))
    };
    let (x, y) = (range(a), range(b));
    x.0 - y.1 > slack || y.0 - x.1 > slack
}

/// Returns the unit direction of the chord of a part; 0 if its ends coincide.
pub(super) fn chord_direction(controls: &[DVec3]) -> DVec3 {
    (controls[controls.len() - 1] - controls[0]).normalize_or_zero()
}

/// Compares pairs of places on two curves, by the first curve first.
pub(super) fn compare_places(x: [f64; 2], y: [f64; 2]) -> Ordering {
    x[0].total_cmp(&y[0]).then(x[1].total_cmp(&y[1]))
}

/// Returns true if two places on a curve with a period coincide within `tolerance`.
pub(super) fn do_places_coincide(x: f64, y: f64, period: f64, tolerance: f64) -> bool {
    let gap = (x - y).abs();
    gap <= tolerance || (period - gap).abs() <= tolerance
}

/// Sorts solutions by their places on two curves, and removes duplicates within `tolerance`, also
/// across the ends of closed curves; see [`CurveView::period`](crate::CurveView). O(n log n) if
/// there are few duplicates.
pub(super) fn sort_and_remove_duplicates<T: Copy>(
    found: &mut Vec<T>,
    places: impl Fn(&T) -> [f64; 2],
    periods: [f64; 2],
    tolerance: f64,
) {
    sort::sort_stable(found, &|x, y| compare_places(places(x), places(y)));
    let mut kept = 0;
    for i in 0..found.len() {
        let at = places(&found[i]);
        let same = |other: &T| (0..2).all(|k| do_places_coincide(at[k], places(other)[k], periods[k], tolerance));
        // Duplicates are close in this order, or at the start of a closed curve.
        let near = found[..kept].iter().rev().take_while(|other| at[0] - places(other)[0] <= tolerance);
        let first = found[..kept].iter().take_while(|other| places(other)[0] <= tolerance);
        if !near.chain(first).any(same) {
            found[kept] = found[i];
            kept += 1;
        }
    }
    found.truncate(kept);
}

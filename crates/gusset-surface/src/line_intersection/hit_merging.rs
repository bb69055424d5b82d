//! Merges the hits of all cells. Each hit counts once, and is classified as a crossing, a contact
//! or a run inside the surface.

use super::line::{Hit, Line};
use super::line_search::line_rounding_error;
use crate::{Place, Surface};
use glam::DVec3;
use gusset_base::sort;
use std::cmp::Ordering;

/// Largest length, in merge distances, of an unresolved hit that is a single point. A contact is
/// longer, because its length is proportional to the square root of the distance. Parameters that
/// are not regular, as at a pole, cause a short unresolved hit.
pub(super) const MAX_POINT_HIT_LENGTH_IN_MERGE_DISTANCES: f64 = 16.0;

/// Sine of the angle between line and surface above which the line crosses the surface.
const MAX_TOUCH_SINE: f64 = 1e-2;

impl Surface<'_> {
    /// Hits in different cells that are closer to each other than this are the same hit.
    pub(super) fn hit_merge_distance(&self) -> f64 {
        self.tolerance().max(1e-12 * self.box_diagonal())
    }

    /// Length above which an unresolved hit is a run inside the surface. A line that touches a
    /// surface with radius of curvature R is within the tolerance e of it for sqrt(8 R e). The
    /// result is several times this length for the size of the whole surface.
    pub(super) fn max_touch_length(&self) -> f64 {
        8.0 * (self.hit_merge_distance() * self.box_diagonal()).sqrt()
    }

    /// True if a direction crosses the surface next to a place, away from the sides of its cell. An
    /// unresolved hit is then not a contact, but a place where parameters are not regular, such as
    /// a pole.
    pub(super) fn is_crossing_direction(&self, place: Place, direction: DVec3) -> bool {
        if !self.is_regular_at(place) {
            return self.normal(place).dot(direction).abs() > 1e-4;
        }
        let inwards = |x: f64| x + 1e-3 * (0.5 - x).signum();
        let near = Place { u: inwards(place.u), v: inwards(place.v), ..place };
        self.normal(near).dot(direction).abs() > MAX_TOUCH_SINE
    }

    /// Merges hits that neighbouring cells found, distinguishes contacts from crossings and runs,
    /// and sorts the hits.
    pub(super) fn merge_hits(&self, line: &Line, hits: &mut Vec<Hit>) {
        for hit in hits.iter_mut().filter(|hit| hit.normal == DVec3::ZERO) {
            hit.normal = self.normal(hit.place);
        }
        if hits.iter().any(|hit| hit.tangent) {
            self.merge_overlapping_hits(line, hits);
        }
        sort::sort_stable(hits, &compare_line_hits);
        let slack = LineRounding::new(self, line);
        // Duplicates, each with the index of the hit that represents it.
        let mut others: Vec<(usize, Hit)> = Vec::new();
        let mut kept: usize = 0;
        for k in 0..hits.len() {
            let hit = hits[k];
            // Duplicates are adjacent along the line.
            let same = hits[..kept]
                .iter()
                .rposition(|other| (hit.at - other.at) * slack.direction_length > slack.max_gap_at_any_angle())
                .map_or(0, |last| last + 1);
            match (same..kept).rev().find(|&other| self.is_same_hit(&hits[other], &hit, &slack)) {
                Some(other) => others.push((other, hit)),
                None => {
                    hits[kept] = hit;
                    kept += 1;
                }
            }
        }
        hits.truncate(kept);
        for (k, hit) in hits.iter_mut().enumerate().filter(|(_, hit)| !hit.tangent) {
            let others = || others.iter().filter(|other| other.0 == k).map(|other| &other.1);
            let tolerance = slack.max_gap_at_sine(
                others().map(|other| slack.sine_to_surface(other)).fold(slack.sine_to_surface(hit), f64::min),
            );
            if slack.may_be_on_side(hit.place, tolerance)
                && let Some(place) = self.snap_to_cell_side(hit.place, tolerance)
            {
                // Other sheets contribute the cells on their side of the point.
                let elsewhere = others().filter_map(|other| self.snap_to_cell_side(other.place, tolerance));
                let places: Vec<Place> = std::iter::once(place).chain(elsewhere).collect();
                if self.does_line_only_touch(&places, slack.unit_direction) {
                    (hit.tangent, hit.multiplicity) = (true, 2);
                }
            }
        }
    }

    /// True if two finds are the same hit: in different cells, at the same point of their sides.
    fn is_same_hit(&self, a: &Hit, b: &Hit, line_rounding: &LineRounding) -> bool {
        if a.tangent || b.tangent || sheet_and_cell(a) == sheet_and_cell(b) {
            return false;
        }
        let sine = line_rounding.sine_to_surface(a).min(line_rounding.sine_to_surface(b)).min(1.0);
        let rounding = line_rounding.max_gap_at_sine(sine);
        // The line enters at one hit, and leaves at the other.
        let turned = a.normal.dot(line_rounding.unit_direction) * b.normal.dot(line_rounding.unit_direction) < 0.0;
        let tolerance = if turned {
            // If the line is practically tangent, there may well be two hits.
            if sine < line_rounding.floor { 0.0 } else { rounding }
        } else {
            rounding.max(line_rounding.merge_distance)
        };
        let near = |place: Place| {
            is_on_cell_side(place)
                || (line_rounding.may_be_on_side(place, rounding) && self.snap_to_cell_side(place, rounding).is_some())
        };
        a.point.distance(b.point) <= tolerance && near(a.place) && near(b.place)
    }

    /// Merges unresolved hits that overlap along the line, and simple hits beside them. Simple hits
    /// come first afterwards.
    fn merge_overlapping_hits(&self, line: &Line, hits: &mut Vec<Hit>) {
        let by_span = |a: &Hit, b: &Hit| a.span[0].total_cmp(&b.span[0]).then_with(|| compare_line_hits(a, b));
        sort::sort_stable(hits, &|a, b| a.tangent.cmp(&b.tangent).then_with(|| by_span(a, b)));
        let (along, length) = line.direction_and_length();
        let slack = 2.0 * self.hit_merge_distance() / length;
        let miss = |hit: &Hit| (hit.point - line.origin).cross(along).length_squared();
        let [low, high] = self.bounds();
        let max_miss = self.tolerance().max(4.0 * line_rounding_error(line, low.midpoint(high), [low, high]));
        let simple = hits.partition_point(|hit| !hit.tangent);
        let (mut kept, mut from) = (simple, simple);
        while from < hits.len() {
            let (mut to, [start, mut end]) = (from + 1, hits[from].span);
            while to < hits.len() && hits[to].span[0] <= end + slack {
                end = end.max(hits[to].span[1]);
                to += 1;
            }
            // A contact beside a side may look like a crossing on the other side of it. A line
            // within a distance m of a surface over a length l has a slope of at most 4 m / l
            // there.
            let steepest = 16.0 * self.hit_merge_distance() / ((end - start) * length);
            for hit in &mut hits[..simple] {
                let is_within = hit.at >= start - slack && hit.at <= end + slack;
                if is_within
                    && is_near_side(hit.place, 1e-3)
                    && hit.normal.dot(along).abs() <= steepest.min(MAX_TOUCH_SINE)
                {
                    hit.multiplicity = 0;
                }
            }
            // A run inside the surface keeps its first hit, any other the hit nearest to the line.
            let first = hits[from];
            let nearest =
                hits[from..to].iter().fold(first, |best, hit| if miss(hit) < miss(&best) { *hit } else { best });
            let is_point = miss(&nearest) <= max_miss * max_miss;
            hits[kept] = if (end - start) * length > self.max_touch_length() {
                Hit { span: [start, end], multiplicity: 0, ..first }
            } else if is_point
                && ((end - start) * length <= MAX_POINT_HIT_LENGTH_IN_MERGE_DISTANCES * self.hit_merge_distance()
                    || self.is_crossing_direction(nearest.place, along))
            {
                Hit { span: [nearest.at; 2], multiplicity: 1, tangent: false, ..nearest }
            } else {
                Hit { span: [start, end], ..nearest }
            };
            kept += 1;
            from = to;
        }
        hits.truncate(kept);
        hits.retain(|hit| hit.tangent || hit.multiplicity > 0);
    }
}

/// Orders hits by parameter, then by cells.
fn compare_line_hits(a: &Hit, b: &Hit) -> Ordering {
    a.at.total_cmp(&b.at).then_with(|| sheet_and_cell(a).cmp(&sheet_and_cell(b)))
}

fn sheet_and_cell(hit: &Hit) -> (u32, [u32; 2]) {
    (hit.place.sheet, hit.place.cell)
}

/// True for a place next to a side of its cell.
fn is_on_cell_side(place: Place) -> bool {
    is_near_side(place, 1e-7)
}

fn is_near_side(place: Place, tolerance: f64) -> bool {
    let near = |x: f64| x <= tolerance || x >= 1.0 - tolerance;
    near(place.u) || near(place.v)
}

/// Bounds of the effect of rounding on hits of a line.
struct LineRounding {
    unit_direction: DVec3,
    /// The length of the line's direction.
    direction_length: f64,
    /// Bound of the rounding error of points, and the size of the surface.
    rounding_error: f64,
    size: f64,
    merge_distance: f64,
    /// Sine of the angle below which rounding decides whether a line meets the surface.
    floor: f64,
}

impl LineRounding {
    fn new(surface: &Surface<'_>, line: &Line) -> LineRounding {
        let ((along, length), [low, high]) = (line.direction_and_length(), surface.bounds());
        let (rounding_error, size) =
            (4.0 * line_rounding_error(line, low.midpoint(high), [low, high]), low.distance(high));
        let floor = (rounding_error / size).sqrt();
        LineRounding {
            unit_direction: along,
            direction_length: length,
            rounding_error,
            size,
            merge_distance: surface.hit_merge_distance(),
            floor,
        }
    }

    /// The sine of the angle between line and surface.
    fn sine_to_surface(&self, hit: &Hit) -> f64 {
        hit.normal.dot(self.unit_direction).abs()
    }

    /// How far apart rounding may place the same point, if the sine of the angle between line and
    /// surface is `sine`.
    fn max_gap_at_sine(&self, sine: f64) -> f64 {
        self.rounding_error / sine.max(self.floor)
    }

    /// How far apart the same point may be placed at any angle.
    fn max_gap_at_any_angle(&self) -> f64 {
        2.0 * self.merge_distance.max(self.rounding_error / self.floor)
    }

    /// False if a place is far from all sides in cells of any size.
    fn may_be_on_side(&self, place: Place, tolerance: f64) -> bool {
        is_near_side(place, (1e4 * tolerance / self.size).max(1e-7))
    }
}

//! Hits of all cells merged: each counts once, and is classified as a passage, a touch or a run
//! inside the surface.

use super::line::{Hit, Line};
use super::line_search::rounding_error;
use crate::{Place, Surface};
use glam::DVec3;
use gusset_base::sort;
use std::cmp::Ordering;

/// An unresolved hit that is no longer than so many times the least distance is no touch, which
/// takes the root of it: there the parameters are not regular, as at a pole.
pub(super) const MAX_POINT_LENGTH: f64 = 16.0;

/// A line at a greater sine of the angle with the surface passes it.
const MAX_TOUCH_SINE: f64 = 1e-2;

impl Surface<'_> {
    /// Hits that are nearer to each other than this, in different cells, are one.
    pub(super) fn merge_distance(&self) -> f64 {
        self.tolerance().max(1e-12 * self.diagonal())
    }

    /// A line that touches a surface is within the tolerance e of it for sqrt(8 R e), with R the
    /// radius of curvature: where it is for longer than several times that for the size of the
    /// whole surface, it runs in it.
    pub(super) fn longest_touch(&self) -> f64 {
        8.0 * (self.merge_distance() * self.diagonal()).sqrt()
    }

    /// True if a direction is not along the surface next to a place, away from the sides of its
    /// cell: what could not be resolved there is no touch but a place where the parameters are not
    /// regular, a pole.
    pub(super) fn passes(&self, place: Place, direction: DVec3) -> bool {
        if !self.is_regular(place) {
            return self.normal(place).dot(direction).abs() > 1e-4;
        }
        let inwards = |x: f64| x + 1e-3 * (0.5 - x).signum();
        let near = Place { u: inwards(place.u), v: inwards(place.v), ..place };
        self.normal(near).dot(direction).abs() > MAX_TOUCH_SINE
    }

    /// Makes one hit of those that neighbouring cells have found, tells touching from passing and
    /// from running in the surface, and sorts.
    pub(super) fn merge_hits(&self, line: &Line, hits: &mut Vec<Hit>) {
        for hit in hits.iter_mut().filter(|hit| hit.normal == DVec3::ZERO) {
            hit.normal = self.normal(hit.place);
        }
        if hits.iter().any(|hit| hit.tangent) {
            self.merge_overlapping(line, hits);
        }
        sort::stable(hits, &in_order);
        let slack = LineRounding::new(self, line);
        // Duplicates, each with the hit that stands for it.
        let mut others: Vec<(usize, Hit)> = Vec::new();
        let mut kept: usize = 0;
        for k in 0..hits.len() {
            let hit = hits[k];
            // Duplicates follow each other along the line.
            let same = hits[..kept]
                .iter()
                .rposition(|other| (hit.at - other.at) * slack.length > slack.farthest())
                .map_or(0, |last| last + 1);
            match (same..kept).rev().find(|&other| self.is_same(&hits[other], &hit, &slack)) {
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
            let tolerance = slack.rounding(others().map(|other| slack.sine(other)).fold(slack.sine(hit), f64::min));
            if slack.may_be_on_side(hit.place, tolerance)
                && let Some(place) = self.on_side(hit.place, tolerance)
            {
                // Other sheets have their part of what is round it.
                let elsewhere = others().filter_map(|other| self.on_side(other.place, tolerance));
                let places: Vec<Place> = std::iter::once(place).chain(elsewhere).collect();
                if self.only_touches(&places, slack.along) {
                    (hit.tangent, hit.multiplicity) = (true, 2);
                }
            }
        }
    }

    /// True for two finds of one hit: in different cells, at the same point of their sides.
    fn is_same(&self, a: &Hit, b: &Hit, slack: &LineRounding) -> bool {
        if a.tangent || b.tangent || cell(a) == cell(b) {
            return false;
        }
        let sine = slack.sine(a).min(slack.sine(b)).min(1.0);
        let rounding = slack.rounding(sine);
        // The line enters at the one what it leaves at the other.
        let turned = a.normal.dot(slack.along) * b.normal.dot(slack.along) < 0.0;
        let tolerance = if turned {
            // Where it is as good as along the surface, it may as well be two.
            if sine < slack.floor { 0.0 } else { rounding }
        } else {
            rounding.max(slack.merge_distance)
        };
        let near = |place: Place| {
            on_side(place) || (slack.may_be_on_side(place, rounding) && self.on_side(place, rounding).is_some())
        };
        a.point.distance(b.point) <= tolerance && near(a.place) && near(b.place)
    }

    /// Merges unresolved hits that overlap along the line, and simple ones beside them. Simple ones
    /// come first then.
    fn merge_overlapping(&self, line: &Line, hits: &mut Vec<Hit>) {
        let by_span = |a: &Hit, b: &Hit| a.span[0].total_cmp(&b.span[0]).then_with(|| in_order(a, b));
        sort::stable(hits, &|a, b| a.tangent.cmp(&b.tangent).then_with(|| by_span(a, b)));
        let (along, length) = line.along();
        let slack = 2.0 * self.merge_distance() / length;
        let miss = |hit: &Hit| (hit.point - line.origin).cross(along).length_squared();
        let [low, high] = self.bounds();
        let max_miss = self.tolerance().max(4.0 * rounding_error(line, low.midpoint(high), [low, high]));
        let simple = hits.partition_point(|hit| !hit.tangent);
        let (mut kept, mut from) = (simple, simple);
        while from < hits.len() {
            let (mut to, [start, mut end]) = (from + 1, hits[from].span);
            while to < hits.len() && hits[to].span[0] <= end + slack {
                end = end.max(hits[to].span[1]);
                to += 1;
            }
            // What touches beside a side may seem to pass on the other side of it: a line that is
            // within a distance m of a surface over a length l is no steeper than 4 m / l there.
            let steepest = 16.0 * self.merge_distance() / ((end - start) * length);
            for hit in &mut hits[..simple] {
                let is_within = hit.at >= start - slack && hit.at <= end + slack;
                if is_within
                    && is_near_side(hit.place, 1e-3)
                    && hit.normal.dot(along).abs() <= steepest.min(MAX_TOUCH_SINE)
                {
                    hit.multiplicity = 0;
                }
            }
            // Where it runs in the surface, the first; else the nearest.
            let first = hits[from];
            let nearest =
                hits[from..to].iter().fold(first, |best, hit| if miss(hit) < miss(&best) { *hit } else { best });
            let is_point = miss(&nearest) <= max_miss * max_miss;
            hits[kept] = if (end - start) * length > self.longest_touch() {
                Hit { span: [start, end], multiplicity: 0, ..first }
            } else if is_point
                && ((end - start) * length <= MAX_POINT_LENGTH * self.merge_distance()
                    || self.passes(nearest.place, along))
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

/// By t, then by cells.
fn in_order(a: &Hit, b: &Hit) -> Ordering {
    a.at.total_cmp(&b.at).then_with(|| cell(a).cmp(&cell(b)))
}

fn cell(hit: &Hit) -> (u32, [u32; 2]) {
    (hit.place.sheet, hit.place.cell)
}

/// True next to a side of the cell.
fn on_side(place: Place) -> bool {
    is_near_side(place, 1e-7)
}

fn is_near_side(place: Place, slack: f64) -> bool {
    let near = |x: f64| x <= slack || x >= 1.0 - slack;
    near(place.u) || near(place.v)
}

/// Bounds of the effect of rounding on hits of a line.
struct LineRounding {
    along: DVec3,
    /// Of the line's direction.
    length: f64,
    /// How far points may be off, and the size of the surface.
    rounding_error: f64,
    size: f64,
    merge_distance: f64,
    /// Lines that are not as steep as that may be off by the rounding error and meet the surface or
    /// not.
    floor: f64,
}

impl LineRounding {
    fn new(surface: &Surface<'_>, line: &Line) -> LineRounding {
        let ((along, length), [low, high]) = (line.along(), surface.bounds());
        let (rounding_error, size) = (4.0 * rounding_error(line, low.midpoint(high), [low, high]), low.distance(high));
        let floor = (rounding_error / size).sqrt();
        LineRounding { along, length, rounding_error, size, merge_distance: surface.merge_distance(), floor }
    }

    /// The sine of the angle between line and surface.
    fn sine(&self, hit: &Hit) -> f64 {
        hit.normal.dot(self.along).abs()
    }

    /// How far apart one point may be found, where the line meets the surface at an angle of this
    /// sine.
    fn rounding(&self, sine: f64) -> f64 {
        self.rounding_error / sine.max(self.floor)
    }

    /// The same at any angle.
    fn farthest(&self) -> f64 {
        2.0 * self.merge_distance.max(self.rounding_error / self.floor)
    }

    /// False if a place is far from all sides, whatever the size of its cell.
    fn may_be_on_side(&self, place: Place, tolerance: f64) -> bool {
        is_near_side(place, (1e4 * tolerance / self.size).max(1e-7))
    }
}

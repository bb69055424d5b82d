//! What becomes of hits when those of all cells are known: each is one, and says what kind it is.

use super::{Hit, Line};
use crate::carcass::{Carcass, Place};
use glam::DVec3;
use std::cmp::Ordering;

/// A spot that is no longer than so many times the least distance is no touch, which takes the root of it: there the parameters are not
/// regular, as at a pole.
pub(super) const POINT: f64 = 16.0;

impl Carcass<'_> {
    /// Hits that are nearer to each other than this, in different cells, are one.
    pub(super) fn apart(&self) -> f64 {
        let [low, high] = self.bounds();
        self.tolerance().max(1e-12 * low.distance(high))
    }

    /// A line that touches a surface is within the tolerance e of it for sqrt(8 R e), with R the radius of curvature: where it is for
    /// longer than several times that for the size of the whole surface, it runs in it.
    pub(super) fn longest_touch(&self) -> f64 {
        let [low, high] = self.bounds();
        8.0 * (self.apart() * low.distance(high)).sqrt()
    }

    /// True if a direction is not along the surface next to a place, away from the sides of its cell: what could not be resolved there is
    /// no touch but a place where the parameters are not regular, a pole.
    pub(super) fn passes(&self, place: Place, direction: DVec3) -> bool {
        if self.jet(place).unit_normal().is_none() {
            return self.normal(place).dot(direction).abs() > 1e-4;
        }
        let inwards = |x: f64| x + 1e-3 * (0.5 - x).signum();
        let near = Place { u: inwards(place.u), v: inwards(place.v), ..place };
        self.normal(near).dot(direction).abs() > 1e-2
    }

    /// Makes one hit of those that neighbouring cells have found, tells touching from running in the surface, and sorts.
    pub(super) fn settle(&self, line: &Line, hits: &mut Vec<Hit>) {
        for hit in hits.iter_mut().filter(|hit| hit.normal == DVec3::ZERO) {
            hit.normal = self.normal(hit.place);
        }
        if hits.iter().any(|hit| hit.tangent) {
            self.join_spots(line, hits);
        }
        hits.sort_unstable_by(in_order);
        let (reach, (_, length)) = (self.apart(), line.along());
        let mut kept: usize = 0;
        for k in 0..hits.len() {
            let hit = hits[k];
            // What is the same is next to each other along the line.
            let mut near = hits[..kept].iter().rev().take_while(|other| (hit.t - other.t) * length <= 2.0 * reach);
            if !near.any(|other| is_same(other, &hit, reach)) {
                hits[kept] = hit;
                kept += 1;
            }
        }
        hits.truncate(kept);
    }

    /// Makes one of the spots that overlap along the line. What is simple comes first then.
    fn join_spots(&self, line: &Line, hits: &mut Vec<Hit>) {
        let by_span = |a: &Hit, b: &Hit| a.span[0].total_cmp(&b.span[0]).then_with(|| in_order(a, b));
        hits.sort_unstable_by(|a, b| a.tangent.cmp(&b.tangent).then_with(|| by_span(a, b)));
        let (along, length) = line.along();
        let play = 2.0 * self.apart() / length;
        let miss = |hit: &Hit| (hit.point - line.origin).cross(along).length_squared();
        let mut kept = hits.partition_point(|hit| !hit.tangent);
        let mut from = kept;
        while from < hits.len() {
            let (mut to, [start, mut end]) = (from + 1, hits[from].span);
            while to < hits.len() && hits[to].span[0] <= end + play {
                end = end.max(hits[to].span[1]);
                to += 1;
            }
            // Where it runs in the surface, the first; else the nearest.
            let first = hits[from];
            let nearest =
                hits[from..to].iter().fold(first, |best, hit| if miss(hit) < miss(&best) { *hit } else { best });
            hits[kept] = if (end - start) * length > self.longest_touch() {
                Hit { span: [start, end], multiplicity: 0, ..first }
            } else if (end - start) * length <= POINT * self.apart() || self.passes(nearest.place, along) {
                Hit { span: [nearest.t; 2], multiplicity: 1, tangent: false, ..nearest }
            } else {
                Hit { span: [start, end], ..nearest }
            };
            kept += 1;
            from = to;
        }
        hits.truncate(kept);
    }
}

/// By t, then by cells.
fn in_order(a: &Hit, b: &Hit) -> Ordering {
    a.t.total_cmp(&b.t).then_with(|| cell(a).cmp(&cell(b)))
}

fn cell(hit: &Hit) -> (u32, [u32; 2]) {
    (hit.place.sheet, hit.place.cell)
}

/// True for two finds of one hit: in different cells, at the same point of their sides.
fn is_same(a: &Hit, b: &Hit, reach: f64) -> bool {
    let simple = !a.tangent && !b.tangent && cell(a) != cell(b);
    simple && on_side(a.place) && on_side(b.place) && a.point.distance(b.point) <= reach
}

/// True next to a side of the cell.
fn on_side(place: Place) -> bool {
    let near = |x: f64| x <= 1e-7 || x >= 1.0 - 1e-7;
    near(place.u) || near(place.v)
}

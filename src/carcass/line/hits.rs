//! What becomes of hits when those of all cells are known: each is one, and says what kind it is.

use super::{Hit, Line};
use crate::carcass::{Carcass, Place};
use glam::DVec3;

impl Carcass<'_> {
    /// Hits that are nearer to each other than this, in different cells, are one.
    pub(super) fn reach(&self) -> f64 {
        let [low, high] = self.bounds();
        self.tolerance().max(1e-12 * low.distance(high))
    }

    /// A line that touches a surface is within the tolerance e of it for sqrt(8 R e), with R the radius of curvature: where it is for
    /// longer than several times that for the size of the whole surface, it runs in it.
    pub(super) fn longest_touch(&self) -> f64 {
        let [low, high] = self.bounds();
        8.0 * (self.reach() * low.distance(high)).sqrt()
    }

    /// Sorts hits, makes one of those that neighbouring cells have found, and tells touching from running in the surface.
    pub(super) fn settle(&self, line: &Line, hits: &mut Vec<Hit>) {
        let order = |a: &Hit, b: &Hit| {
            let by_place = |place: &Place| (place.sheet, place.cell);
            a.t.total_cmp(&b.t).then_with(|| by_place(&a.place).cmp(&by_place(&b.place)))
        };
        if hits.len() > 1 {
            hits.sort_unstable_by(order);
            self.merge(line, hits);
        }
        for hit in hits.iter_mut().filter(|hit| hit.normal == DVec3::ZERO) {
            hit.normal = self.normal(hit.place);
        }
        if hits.iter().any(|hit| hit.tangent) {
            self.classify(line, hits);
            hits.sort_unstable_by(order);
        }
    }

    /// Makes one hit of those on sides of neighbouring cells. What is the same is next to each other along the line.
    fn merge(&self, line: &Line, hits: &mut Vec<Hit>) {
        let reach = self.reach();
        let (_, length) = line.along();
        let mut kept: usize = 0;
        for k in 0..hits.len() {
            let hit = hits[k];
            let near = hits[..kept]
                .iter_mut()
                .rev()
                .take_while(|other| other.tangent || (hit.t - other.t) * length <= 2.0 * reach);
            let mut same = near.filter(|other| is_same(other, &hit, reach, length));
            if let Some(other) = same.next() {
                other.span = [other.span[0].min(hit.span[0]), other.span[1].max(hit.span[1])];
                if (hit.place.sheet, hit.place.cell) < (other.place.sheet, other.place.cell) && !hit.tangent {
                    *other = Hit { span: other.span, ..hit };
                }
            } else {
                hits[kept] = hit;
                kept += 1;
            }
        }
        hits.truncate(kept);
    }

    fn classify(&self, line: &Line, hits: &mut [Hit]) {
        let (along, length) = line.along();
        for hit in hits.iter_mut().filter(|hit| hit.tangent) {
            if (hit.span[1] - hit.span[0]) * length > self.longest_touch() {
                hit.multiplicity = 0;
            } else if self.jet(hit.place).unit_normal().is_none() && hit.normal.dot(along).abs() > 1e-3 {
                // At a pole, and not along the surface: it passes through.
                (hit.multiplicity, hit.tangent, hit.span) = (1, false, [hit.t; 2]);
            }
        }
    }
}

/// True for two finds of one hit: in different cells at the same point of their sides, or spots that run into each other.
fn is_same(a: &Hit, b: &Hit, reach: f64, length: f64) -> bool {
    let cells = |hit: &Hit| (hit.place.sheet, hit.place.cell);
    if a.tangent != b.tangent || (cells(a) == cells(b)) {
        return false;
    }
    if !a.tangent {
        return on_side(a.place) && on_side(b.place) && a.point.distance(b.point) <= reach;
    }
    (b.span[0] - a.span[1]).max(a.span[0] - b.span[1]) * length <= 2.0 * reach
}

/// True next to a side of the cell.
fn on_side(place: Place) -> bool {
    let near = |x: f64| x <= 1e-7 || x >= 1.0 - 1e-7;
    near(place.u) || near(place.v)
}

//! Task a) of the paper: the nearest point.
//!
//! The paper's search by diameters is an incidence test: for the nearest point it must know an upper bound (the study's erratum E3), and
//! that is branch and bound. What is proved here is relative to the surface as declared, the patches through the nodes.

mod batch;
mod bounds;
mod cell;
mod critical;
mod descend;
mod hunt;
mod leaf;
mod minima;
mod region;
mod search;
mod wait;

pub use minima::Minima;
pub use region::Region;

use super::{Place, Surface, each_sheet};
use glam::DVec3;
use hunt::Hunt;
use search::search;
use wait::settle;

/// The nearest point of a surface, or one where the distance is locally least.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Closest {
    /// Where it is.
    pub place: Place,
    /// The point.
    pub point: DVec3,
    /// The unit normal there, or its limit at a pole; 0 if there is none. The side of the surface is the sign of (query - point) . normal,
    /// away from open borders.
    pub normal: DVec3,
    /// Its distance.
    pub distance: f64,
    /// No point of the surface is nearer than this.
    pub bound: f64,
    /// True if the bound is within the tolerance of the distance, or within the rounding of coordinates; false if that would take too
    /// many parts of patches, as it may where the query is a centre of curvature.
    pub proven: bool,
    /// True if there is another point as near, within the tolerance, that is farther from this one than a hundredth of the distance. Not all
    /// such are looked for once a search takes long: if `proven` is false, it may be so without being said.
    pub many: bool,
}

impl Surface<'_> {
    /// The nearest point that is no farther than `limit`; `None` if there is none, or the query has a coordinate that is NaN or beyond 1e150.
    ///
    /// Of several at the same distance: of the first sheet, there of the first cell, by rows.
    pub fn closest(&self, query: DVec3, limit: f64) -> Option<Closest> {
        self.closest_with(query, limit, &mut Hunt::new())
    }

    pub(crate) fn closest_with(&self, query: DVec3, limit: f64, hunt: &mut Hunt) -> Option<Closest> {
        if region::unfit(query).is_some() || limit.is_nan() || limit < 0.0 {
            return None;
        }
        let tolerance = self.tolerance().max(self.rounding(query));
        hunt.begin(query, limit, tolerance);
        for k in self.by_distance(query) {
            let (sheet, index) = self.indexed(k);
            each_sheet!(sheet, cells => search(cells, index, k as u32, hunt));
        }
        while let Some(next) = hunt.next() {
            let (sheet, index) = self.indexed(next.sheet as usize);
            each_sheet!(sheet, cells => next.open(cells, index, hunt));
        }
        if let Some(unproven) = hunt.unproven() {
            let sheet = self.sheet(unproven.sheet as usize);
            each_sheet!(sheet, cells => settle(cells, sheet.is_closed(), hunt));
        }
        let (answer, bound, many) = hunt.end(limit)?;
        let place = answer.place();
        Some(Closest {
            place,
            point: answer.point,
            normal: if answer.normal == DVec3::ZERO { self.normal(place) } else { answer.normal },
            distance: answer.distance,
            bound,
            proven: answer.distance.is_finite() && bound >= answer.distance - tolerance,
            many,
        })
    }

    /// What distances from a point may be off by: a few units in the last place of the greatest coordinate.
    fn rounding(&self, query: DVec3) -> f64 {
        let [low, high] = self.bounds();
        16.0 * f64::EPSILON * low.abs().max(high.abs()).max(query.abs()).max_element()
    }

    /// All sheets, the one whose box is nearest first.
    fn by_distance(&self, query: DVec3) -> impl Iterator<Item = usize> {
        let first = if self.len() == 1 {
            0
        } else {
            let distance = |k: usize| self.indexed(k).1.bounds().distance_squared(query);
            (0..self.len()).map(|k| (distance(k), k)).fold((f64::INFINITY, 0), |a, b| if b.0 < a.0 { b } else { a }).1
        };
        std::iter::once(first).chain((0..self.len()).filter(move |&k| k != first))
    }
}

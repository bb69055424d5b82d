//! Places on both surfaces for parameters of a pair of cells.

use super::cell_pairs::CellPair;
use super::intersection_equation::DifferenceFrame;
use crate::{Place, Surface};
use glam::DVec3;
use glam::DVec4;

/// Largest number of Newton steps to a point of a curve.
const MAX_NEWTON_STEPS: usize = 16;
/// A step shorter than this fraction of the tolerance is the last one.
const LAST_STEP_IN_TOLERANCES: f64 = 1e-3;
/// If clamping moves a parameter by more than this, the other surface's place follows, nearest to
/// the clamped point.
const MAX_CLAMPED_PARAMETER_ROUNDING: f64 = 1e-13;

/// A point of the intersection: parameters of a pair of cells, position, and the direction of the
/// curve.
#[derive(Debug, Clone, Copy)]
pub(super) struct IntersectionCurvePoint {
    pub(super) parameters: DVec4,
    pub(super) point: DVec3,
    pub(super) direction: DVec3,
}

/// Two surfaces and pairs of their cells.
pub(super) struct PairPlaces<'a> {
    pub(super) surfaces: [&'a Surface<'a>; 2],
    pub(super) pairs: &'a [CellPair],
    /// The origin of coordinates.
    pub(super) origin: DVec3,
}

impl PairPlaces<'_> {
    /// The places of parameters. Clamps parameters to the cells.
    pub(super) fn clamped_places(&self, pair: u32, x: DVec4) -> [Place; 2] {
        let CellPair { sheets, cells } = self.pairs[pair as usize];
        let x = x.clamp(DVec4::ZERO, DVec4::ONE);
        [
            Place { sheet: sheets[0], cell: cells[0], u: x.x, v: x.y },
            Place { sheet: sheets[1], cell: cells[1], u: x.z, v: x.w },
        ]
    }

    /// The point of the first surface, relative to the origin.
    pub(super) fn point_of_first_surface(&self, pair: u32, x: DVec4) -> DVec3 {
        self.surfaces[0].jet(self.clamped_places(pair, x)[0]).point - self.origin
    }

    pub(super) fn origin_and_frame_at(&self, pair: u32, x: DVec4) -> (DVec3, DifferenceFrame) {
        let [place, other] = self.clamped_places(pair, x);
        let (a, b) = (self.surfaces[0].jet(place), self.surfaces[1].jet(other));
        (a.point - self.origin, DifferenceFrame { difference: a.point - b.point, derivatives: [a.u, a.v, -b.u, -b.v] })
    }

    /// The places of a solution that may be slightly outside its cells. This happens for a curve
    /// along a side where the surfaces are nearly parallel. Clamps the parameters of one surface,
    /// and moves the other surface's place nearest to the clamped point.
    pub(super) fn places_clamped_into_cells(&self, pair: u32, x: DVec4) -> [Place; 2] {
        let mut inside = x.clamp(DVec4::ZERO, DVec4::ONE);
        let off = (inside - x).abs();
        if off.max_element() > MAX_CLAMPED_PARAMETER_ROUNDING {
            let frame = self.origin_and_frame_at(pair, inside).1;
            let moved = if off.x.max(off.y) >= off.z.max(off.w) { 2 } else { 0 };
            let step = frame.step_to_other_surface(moved);
            if step.is_finite() {
                (inside[moved], inside[moved + 1]) = (inside[moved] + step.x, inside[moved + 1] + step.y);
            }
        }
        self.clamped_places(pair, inside)
    }

    /// The point of a pair's curve that is nearest to the point `to`, starting from nearby
    /// parameters. Its error is far below the tolerance.
    pub(super) fn nearest_curve_point(
        &self,
        pair: u32,
        start: DVec4,
        to: DVec3,
        tolerance: f64,
    ) -> Option<IntersectionCurvePoint> {
        let (mut x, mut last) = (start, f64::INFINITY);
        for _ in 0..MAX_NEWTON_STEPS {
            let (point, frame) = self.origin_and_frame_at(pair, x);
            let step = frame.step_towards_point(to - point);
            if !step.is_finite() {
                return None;
            }
            x = (x + step).clamp(DVec4::ZERO, DVec4::ONE);
            // Measured as lengths, because parameters are noise beside poles. Beside crossings,
            // rounding moves the point by more than the last step may be, so steps stop decreasing.
            let [s, t, u, v] = frame.derivatives;
            let (moved, other) = (s * step.x + t * step.y, u * step.z + v * step.w);
            let length = moved.length().max(other.length());
            if length <= LAST_STEP_IN_TOLERANCES * tolerance || (length <= 0.25 * tolerance && length > 0.25 * last) {
                let (point, frame) = self.origin_and_frame_at(pair, x);
                return Some(IntersectionCurvePoint {
                    parameters: x,
                    point,
                    direction: frame.curve_direction().normalize_or_zero(),
                });
            }
            last = length;
        }
        None
    }
}

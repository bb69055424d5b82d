//! Inserts points between the ends of an arc until its chords are within a tolerance of it.
//!
//! The tangents at two points of the curve define a cubic that predicts the curve between them. Its
//! distance from the chord in space gives the number of pieces. Its parameters are good enough for
//! one or two Newton steps to reach the curve. Near a cusp, a curve may continue beyond an end of
//! its chord and return. Distances are therefore measured from the chord, not from its line.
//!
//! Invariant: every inserted point solves the equation. Cost: one or two Newton steps for each
//! point.

use super::arc_search::ArcEnd;
use super::intersection_equation::IntersectionEquation;
use glam::{DVec3, DVec4};
use gusset_base::alloc;
use gusset_base::error::Result;

/// Largest number of nested cuts.
const MAX_NESTED_CUTS: u32 = 6;
/// Rows of control points of a cubic patch. Up to this degree, the ends of pieces reveal all waves
/// of an arc.
const CONTROL_ROWS_OF_CUBIC: usize = 4;
/// Largest number of pieces of one cut. Pieces may be cut again.
const MAX_PIECES_PER_CUT: f64 = 64.0;

/// A point of the arc, and its derivatives: of the parameters with respect to the free one, and the
/// direction in space.
#[derive(Clone, Copy)]
struct ArcKnot {
    parameters: DVec4,
    parameter_derivatives: DVec4,
    point: DVec3,
    direction: DVec3,
    /// Length of the curve for one unit of the free parameter.
    length_per_free_parameter: f64,
}

/// Refines one arc.
pub(super) struct ArcRefinement<'a, const N: usize, const M: usize> {
    pub(super) equation: &'a IntersectionEquation<N, M>,
    /// The parameter on which the other three depend.
    pub(super) free: usize,
    /// Largest permitted distance of the arc from its chords.
    pub(super) chord_tolerance: f64,
}

impl<const N: usize, const M: usize> ArcRefinement<'_, N, M> {
    /// Inserts the points strictly between the ends. `places` are the ends in space.
    pub(super) fn insert_points(&self, ends: [ArcEnd; 2], places: [DVec3; 2], points: &mut Vec<DVec4>) -> Result<()> {
        if self.chord_tolerance == f64::INFINITY {
            return Ok(());
        }
        let knots = [0, 1].map(|k| {
            let ArcEnd { parameters: x, tangent, direction } = ends[k];
            let rates = tangent / tangent[self.free];
            let speed = self.speed_by_free_parameter(tangent, direction);
            ArcKnot {
                parameters: x,
                parameter_derivatives: rates,
                point: places[k],
                direction: direction.normalize_or_zero(),
                length_per_free_parameter: speed,
            }
        });
        let pieces = self.piece_count(&knots);
        if pieces > 1.0 {
            return self.cut_between_knots(knots, pieces, MAX_NESTED_CUTS, points);
        }
        if self.is_bent(&knots) { self.cut_between_knots(knots, 2.0, MAX_NESTED_CUTS, points) } else { Ok(()) }
    }

    /// Tests whether the middle, or a half, is too far from the chord. This detects bends that the
    /// ends do not show.
    ///
    /// Let the middle be `off` the chord, and let f be the height of the arch of a half. At the
    /// fraction s of the way to the middle, the curve is off s + 4 f s (1 - s) from the chord.
    fn is_bent(&self, knots: &[ArcKnot; 2]) -> bool {
        let Some(middle) = self.knot_between(knots, 0.5) else {
            return false;
        };
        let [first, last] = *knots;
        let (off, chord) = (middle.point - first.point, last.point - first.point);
        let along = chord.normalize_or_zero();
        let off = (off - off.dot(along).clamp(0.0, chord.length()) * along).length();
        let arch = self.height_over_chord(&[first, middle]).max(self.height_over_chord(&[middle, last]));
        let max = if off >= 4.0 * arch { off } else { (off + 4.0 * arch).powi(2) / (16.0 * arch) };
        max > self.chord_tolerance
    }

    /// Inserts the points that cut the arc between two knots into pieces of equal free parameter.
    /// Cuts pieces further if they are still too long.
    fn cut_between_knots(
        &self,
        knots: [ArcKnot; 2],
        piece_count: f64,
        depth: u32,
        points: &mut Vec<DVec4>,
    ) -> Result<()> {
        let mut before = knots[0];
        for k in 1..=piece_count as usize {
            let last = k as f64 == piece_count;
            let next = if last { Some(knots[1]) } else { self.knot_between(&knots, k as f64 / piece_count) };
            let Some(next) = next else { continue };
            let piece = [before, next];
            if depth > 0 {
                let more = self.piece_count(&piece);
                if more > 1.0 {
                    self.cut_between_knots(piece, more, depth - 1, points)?;
                } else if (CONTROL_ROWS_OF_CUBIC < N.max(M) || does_curve_turn_back(&piece)) && self.is_bent(&piece) {
                    self.cut_between_knots(piece, 2.0, depth - 1, points)?;
                }
            }
            if !last {
                alloc::push(points, next.parameters)?;
            }
            before = next;
        }
        Ok(())
    }

    /// The number of pieces after which all chords between two knots are within the tolerance. The
    /// distance decreases with the square of the number.
    fn piece_count(&self, knots: &[ArcKnot; 2]) -> f64 {
        (self.height_over_chord(knots) / self.chord_tolerance).sqrt().ceil().min(MAX_PIECES_PER_CUT)
    }

    /// The distance between the cubic through two knots and their chord. T and U are the components
    /// of the end directions across the chord, L is its length. The distance is the sum of an arch,
    /// L / 8 |T - U|, and a wave, L / (12 sqrt 3) |T + U|. If the cubic starts backwards at an end
    /// by D, the parabola along the chord reaches D^2 / (4 (L + D)) beyond that end.
    fn height_over_chord(&self, [first, last]: &[ArcKnot; 2]) -> f64 {
        let whole = last.point - first.point;
        let length = whole.length();
        let along = whole / length.max(f64::MIN_POSITIVE);
        let across = |direction: DVec3| direction - direction.dot(along) * along;
        let (one, other) = (across(first.direction), across(last.direction));
        let aside = length * (one.distance(other) / 8.0 + (one + other).length() / (12.0 * 3.0_f64.sqrt()));
        let span = (last.parameters[self.free] - first.parameters[self.free]).abs();
        let beyond = |knot: &ArcKnot| {
            let back = (-span * knot.length_per_free_parameter * knot.direction.dot(along)).max(0.0);
            back * back / (4.0 * (length + back)).max(f64::MIN_POSITIVE)
        };
        aside.max(beyond(first)).max(beyond(last))
    }

    fn speed_by_free_parameter(&self, tangent: DVec4, direction: DVec3) -> f64 {
        direction.length() / tangent[self.free].abs()
    }

    /// The knot at fraction t between two knots, measured by the free parameter.
    fn knot_between(&self, [first, last]: &[ArcKnot; 2], t: f64) -> Option<ArcKnot> {
        let (s, whole) = (1.0 - t, last.parameters[self.free] - first.parameters[self.free]);
        let rise = s * first.parameter_derivatives - t * last.parameter_derivatives;
        let line = s * s * (1.0 + 2.0 * t) * first.parameters + t * t * (3.0 - 2.0 * t) * last.parameters;
        let (x, frame) = self.equation.refine_good_guess(line + (s * t * whole) * rise, self.free)?;
        let (tangent, direction) = (frame.parameter_tangent(), frame.curve_direction());
        let (rates, speed) = (tangent / tangent[self.free], self.speed_by_free_parameter(tangent, direction));
        Some(ArcKnot {
            parameters: x,
            parameter_derivatives: rates,
            point: self.equation.point_of_first_patch(x),
            direction: direction.normalize_or_zero(),
            length_per_free_parameter: speed,
        })
    }
}

/// Whether the curve runs in opposite directions at two knots.
fn does_curve_turn_back([first, last]: &[ArcKnot; 2]) -> bool {
    first.direction.dot(last.direction) < 0.0
}

//! Points between the marks of an arc. If the arc is a graph, each point is the root of a
//! polynomial in the other parameter. All points therefore lie on the interpolant, whatever their
//! spacing.
//!
//! Cost: O(M^2) and a few Newton steps for each point; at most 2^12 points for an arc.

use super::cell_arcs::{ArcGraphRange, MarkedArc};
use super::side_sign_changes::find_bracketed_root;
use crate::Patch;
use crate::subdivision::BernsteinField;
use glam::{DVec2, DVec3};
use gusset_base::geom::bernstein::value_and_slope_by_differences as value_and_slope;

/// Largest number of halvings of an arc.
const MAX_ARC_HALVINGS: u32 = 12;
/// Fraction of `chord` that the middle and the quarters of an arc may be off the chord. Between
/// them, a cubic is off by at most 1.1 times as much. Beside a pole, where parameters are very
/// uneven, 1.15 times was observed.
const MAX_SAMPLED_CHORD_FRACTION: f64 = 0.85;

/// An arc over its patch.
struct ArcOverPatch<'a, const N: usize, const M: usize> {
    patch: &'a Patch<N>,
    field: &'a BernsteinField<M>,
    graph: ArcGraphRange,
    chord: f64,
    /// Values up to this may be 0.
    rounding_error: f64,
}

/// A place on the arc.
#[derive(Clone, Copy)]
struct ArcPoint {
    parameters: DVec2,
    point: DVec3,
}

/// True if the deviation of surface and field from bilinear ones proves that an arc stays within
/// `chord_tolerance` of its chord.
///
/// Let the arc be a graph of v over u. Along the straight line between its ends in (u, v), the
/// bilinear parts bend by at most a quarter of their twists. The field on the line is therefore
/// within 2 `deviation` + twist / 4 of 0. Where |F_v| >= m, the arc is within this divided by m of
/// the line. Between arc and line, the surface moves by at most its largest step in v times this,
/// plus 2 `deviation`. The twist of the field is at most the twist of the surface.
pub(super) fn is_arc_near_chord<const M: usize>(
    corners: &[DVec3; 4],
    field: &BernsteinField<M>,
    link: &MarkedArc,
    deviation: f64,
    chord_tolerance: f64,
) -> bool {
    let Some(graph) = link.graph else { return false };
    let [low, high] = field.derivative_ranges()[1 - graph.graph_parameter];
    is_graph_near_chord(corners, graph.graph_parameter, low.max(-high), deviation, chord_tolerance)
}

/// [`is_arc_near_chord`] for an arc that is a graph over u (0) or v (1). `slope` is a lower bound
/// of the field's slope in the other parameter.
#[inline]
pub(super) fn is_graph_near_chord(
    corners: &[DVec3; 4],
    over: usize,
    slope: f64,
    deviation: f64,
    chord_tolerance: f64,
) -> bool {
    let [p00, p01, p10, p11] = corners;
    let twist = *p00 + *p11 - *p01 - *p10;
    let steps = if over == 0 { [*p01 - *p00, *p11 - *p10] } else { [*p10 - *p00, *p11 - *p01] };
    let margin = chord_tolerance - 2.0 * deviation;
    let near = |twist: f64, step: f64| {
        let bend = 2.0 * deviation + 0.25 * twist;
        bend * (slope + step) <= margin * slope
    };
    // Sums of coordinates are upper bounds of lengths, and cheaper.
    let [a, b] = steps.map(|step| step.abs().element_sum());
    let exactly = || near(twist.length(), steps[0].length_squared().max(steps[1].length_squared()).sqrt());
    slope > 0.0 && margin > 0.0 && (near(twist.abs().element_sum(), a.max(b)) || exactly())
}

/// Residual of the field at a root that rounding may cause, in units of the field's rounding error.
const MAX_RESIDUAL_IN_ROUNDINGS: f64 = 16.0;

/// The place of an arc at the middle of the parameter that it is a graph over. Returns `None` if
/// the field does not vanish there, or the arc is not a graph.
pub(super) fn middle_of_arc<const M: usize>(
    field: &BernsteinField<M>,
    link: &MarkedArc,
    rounding_error: f64,
) -> Option<DVec2> {
    middle_of_graph(field, link.graph?, [link.start_mark.parameters, link.end_mark.parameters], rounding_error).ok()
}

/// Adds places between the ends of an arc until its chords are within `chord_tolerance` of it,
/// tested at their middles and quarters. Values up to `rounding_error` may be 0. If the field does
/// not vanish where the arc should be, returns the place instead of adding it.
pub(super) fn insert_arc_points<const N: usize, const M: usize>(
    patch: &Patch<N>,
    field: &BernsteinField<M>,
    link: &MarkedArc,
    chord_tolerance: f64,
    rounding_error: f64,
    places: &mut Vec<DVec2>,
) -> Option<DVec2> {
    let curve = ArcOverPatch { patch, field, graph: link.graph?, chord: chord_tolerance, rounding_error };
    let [from, to] = [link.start_mark.parameters, link.end_mark.parameters]
        .map(|at| ArcPoint { parameters: at, point: patch.point(at.x, at.y) });
    curve.middle_point(from, to).and_then(|middle| curve.halve_arc(from, middle, to, MAX_ARC_HALVINGS, places)).err()
}

/// The place of a graph at the mean of the parameters of two others. Returns the expected place as
/// an error if the field does not vanish there.
fn middle_of_graph<const M: usize>(
    field: &BernsteinField<M>,
    ArcGraphRange { graph_parameter: over, value_range: range }: ArcGraphRange,
    [a, b]: [DVec2; 2],
    rounding_error: f64,
) -> Result<DVec2, DVec2> {
    let along = 0.5 * (a[over] + b[over]);
    let c: [f64; M] = match over {
        0 => std::array::from_fn(|k| value_and_slope(&field.coefficients.map(|row| row[k]), along)[0]),
        _ => field.coefficients.map(|row| value_and_slope(&row, along)[0]),
    };
    let mut at = DVec2::splat(along);
    at[1 - over] = find_bracketed_root(&c, range);
    let [value, slope] = value_and_slope(&c, at[1 - over]);
    // Adds the rounding of the parameter to the rounding of the field.
    if value.abs() <= MAX_RESIDUAL_IN_ROUNDINGS * (rounding_error + f64::EPSILON * slope.abs()) {
        Ok(at)
    } else {
        Err(at)
    }
}

impl<const N: usize, const M: usize> ArcOverPatch<'_, N, M> {
    /// The place at the mean of the parameters of two others.
    fn middle_point(&self, a: ArcPoint, b: ArcPoint) -> Result<ArcPoint, DVec2> {
        let at = middle_of_graph(self.field, self.graph, [a.parameters, b.parameters], self.rounding_error)?;
        Ok(ArcPoint { parameters: at, point: self.patch.point(at.x, at.y) })
    }

    /// Adds the places needed between `from` and `to`, given the place between them.
    fn halve_arc(
        &self,
        from: ArcPoint,
        middle: ArcPoint,
        to: ArcPoint,
        depth: u32,
        places: &mut Vec<DVec2>,
    ) -> Result<(), DVec2> {
        let quarters = [self.middle_point(from, middle)?, self.middle_point(middle, to)?];
        let limit = MAX_SAMPLED_CHORD_FRACTION * self.chord;
        let far = |node: &ArcPoint| squared_distance_from_segment(node.point, from.point, to.point) > limit * limit;
        if depth == 0 || ![quarters[0], middle, quarters[1]].iter().any(far) {
            return Ok(());
        }
        let before = self.halve_arc(from, quarters[0], middle, depth - 1, places);
        places.push(middle.parameters);
        before.and(self.halve_arc(middle, quarters[1], to, depth - 1, places))
    }
}

/// The squared distance of a point from a segment.
fn squared_distance_from_segment(point: DVec3, a: DVec3, b: DVec3) -> f64 {
    let (from, along) = (point - a, b - a);
    let length = along.length_squared();
    let t = if length > 0.0 { (from.dot(along) / length).clamp(0.0, 1.0) } else { 0.0 };
    (from - t * along).length_squared()
}

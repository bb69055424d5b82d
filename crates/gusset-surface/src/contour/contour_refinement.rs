//! Points between the marks of an arc: where the arc is a graph, each is the root of a polynomial
//! in the other parameter, so that they lie on the interpolant whatever their distance.
//!
//! Cost: O(M^2) and a few Newton steps a point; 2^12 points an arc at most.

use super::cell::{Graph, Link};
use super::side::bracketed;
use crate::Patch;
use crate::subdivision::Field;
use glam::{DVec2, DVec3};
use gusset_base::geom::bernstein::value_and_slope_by_differences as value_and_slope;

/// Halvings of an arc.
const DEPTH: u32 = 12;
/// The part of `chord` by which the middle and the quarters of an arc may leave it: between them a
/// cubic leaves it by 1.1 times as much at most, and beside a pole, where parameters run far from
/// evenly, 1.15 times as much was seen.
const SEEN_PART: f64 = 0.85;

/// An arc over its patch.
struct Curve<'a, const N: usize, const M: usize> {
    patch: &'a Patch<N>,
    field: &'a Field<M>,
    graph: Graph,
    chord: f64,
    /// Greater values are not 0.
    rounding_error: f64,
}

/// A place on it.
#[derive(Clone, Copy)]
struct Node {
    at: DVec2,
    point: DVec3,
}

/// True if an arc cannot leave its chord by more than `chord`, as the deviation of surface and
/// field from bilinear ones shows.
///
/// With v over u: along the straight line between the ends in (u, v) the bilinear parts bend by a
/// quarter of their twists at most, so that the field is within 2 `deviation` + twist / 4 of 0
/// there, and the arc, where |F_v| >= m, within that over m of the line. Between the two the
/// surface moves by no more than its greatest step in v takes, and 2 `deviation`. Twists of the
/// field are no greater than those of the surface.
pub(super) fn is_straight<const M: usize>(
    corners: &[DVec3; 4],
    field: &Field<M>,
    link: &Link,
    deviation: f64,
    chord: f64,
) -> bool {
    let Some(graph) = link.graph else { return false };
    let [low, high] = field.slope_ranges()[1 - graph.over];
    stays_near(corners, graph.over, low.max(-high), deviation, chord)
}

/// The same of an arc that is a graph over u (0) or v (1), where the field is no less steep than
/// `slope` in the other parameter.
#[inline]
pub(super) fn stays_near(corners: &[DVec3; 4], over: usize, slope: f64, deviation: f64, chord: f64) -> bool {
    let [p00, p01, p10, p11] = corners;
    let twist = *p00 + *p11 - *p01 - *p10;
    let steps = if over == 0 { [*p01 - *p00, *p11 - *p10] } else { [*p10 - *p00, *p11 - *p01] };
    let margin = chord - 2.0 * deviation;
    let near = |twist: f64, step: f64| {
        let bend = 2.0 * deviation + 0.25 * twist;
        bend * (slope + step) <= margin * slope
    };
    // First with sums of coordinates, which are no less than lengths.
    let [a, b] = steps.map(|step| step.abs().element_sum());
    let exactly = || near(twist.length(), steps[0].length_squared().max(steps[1].length_squared()).sqrt());
    slope > 0.0 && margin > 0.0 && (near(twist.abs().element_sum(), a.max(b)) || exactly())
}

/// The residual of the field at a root that is due to rounding, in units of the field's rounding
/// error.
const RESIDUAL: f64 = 16.0;

/// The place amid an arc in the parameter that it is a graph over; `None` if the field is not 0
/// there, or the arc is no graph.
pub(super) fn middle<const M: usize>(field: &Field<M>, link: &Link, rounding_error: f64) -> Option<DVec2> {
    amid(field, link.graph?, [link.from.at, link.to.at], rounding_error).ok()
}

/// Adds the places between the ends of an arc that keep the chords within `chord` of it, as seen at
/// their middles and quarters. Values up to `rounding_error` may be 0. Returns where the field is
/// not 0 although the arc should be there; no such place is added.
pub(super) fn refine<const N: usize, const M: usize>(
    patch: &Patch<N>,
    field: &Field<M>,
    link: &Link,
    chord: f64,
    rounding_error: f64,
    places: &mut Vec<DVec2>,
) -> Option<DVec2> {
    let curve = Curve { patch, field, graph: link.graph?, chord, rounding_error };
    let [from, to] = [link.from.at, link.to.at].map(|at| Node { at, point: patch.point(at.x, at.y) });
    curve.between(from, to).and_then(|middle| curve.halve(from, middle, to, DEPTH, places)).err()
}

/// The place of a graph whose parameter is amid those of two others, or where it should be if the
/// field is not 0 there.
fn amid<const M: usize>(
    field: &Field<M>,
    Graph { over, range }: Graph,
    [a, b]: [DVec2; 2],
    rounding_error: f64,
) -> Result<DVec2, DVec2> {
    let along = 0.5 * (a[over] + b[over]);
    let c: [f64; M] = match over {
        0 => std::array::from_fn(|k| value_and_slope(&field.c.map(|row| row[k]), along)[0]),
        _ => field.c.map(|row| value_and_slope(&row, along)[0]),
    };
    let mut at = DVec2::splat(along);
    at[1 - over] = bracketed(&c, range);
    let [value, slope] = value_and_slope(&c, at[1 - over]);
    // Beside rounding of the field, that of the parameter.
    if value.abs() <= RESIDUAL * (rounding_error + f64::EPSILON * slope.abs()) { Ok(at) } else { Err(at) }
}

impl<const N: usize, const M: usize> Curve<'_, N, M> {
    /// The place whose parameter is amid two others.
    fn between(&self, a: Node, b: Node) -> Result<Node, DVec2> {
        let at = amid(self.field, self.graph, [a.at, b.at], self.rounding_error)?;
        Ok(Node { at, point: self.patch.point(at.x, at.y) })
    }

    /// Adds what is needed between `from` and `to`, whose middle is known.
    fn halve(&self, from: Node, middle: Node, to: Node, depth: u32, places: &mut Vec<DVec2>) -> Result<(), DVec2> {
        let quarters = [self.between(from, middle)?, self.between(middle, to)?];
        let limit = SEEN_PART * self.chord;
        let far = |node: &Node| distance_squared(node.point, from.point, to.point) > limit * limit;
        if depth == 0 || ![quarters[0], middle, quarters[1]].iter().any(far) {
            return Ok(());
        }
        let before = self.halve(from, quarters[0], middle, depth - 1, places);
        places.push(middle.at);
        before.and(self.halve(middle, quarters[1], to, depth - 1, places))
    }
}

/// The square of the distance of a point from a segment.
fn distance_squared(point: DVec3, a: DVec3, b: DVec3) -> f64 {
    let (from, along) = (point - a, b - a);
    let length = along.length_squared();
    let t = if length > 0.0 { (from.dot(along) / length).clamp(0.0, 1.0) } else { 0.0 };
    (from - t * along).length_squared()
}

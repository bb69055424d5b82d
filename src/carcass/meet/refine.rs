//! Points between the ends of an arc, until its chords are within a tolerance of it.

use super::arc::End;
use super::equation::{Equation, Frame};
use crate::alloc;
use crate::error::Result;
use glam::{DVec3, DVec4};

/// Halvings at most.
const DEPTH: u32 = 12;

/// A point of the arc.
#[derive(Clone, Copy)]
struct Knot {
    x: DVec4,
    point: DVec3,
}

/// Adds the points strictly between the ends.
pub(super) fn refine<const N: usize, const M: usize>(
    equation: &Equation<N, M>,
    ends: [End; 2],
    free: usize,
    chord: f64,
    points: &mut Vec<DVec4>,
) -> Result<()> {
    if chord == f64::INFINITY {
        return Ok(());
    }
    let knots = ends.map(|end| Knot { x: end.x, point: equation.point(end.x) });
    halve(equation, knots, free, chord, DEPTH, points)
}

fn halve<const N: usize, const M: usize>(
    equation: &Equation<N, M>,
    [first, last]: [Knot; 2],
    free: usize,
    chord: f64,
    depth: u32,
    points: &mut Vec<DVec4>,
) -> Result<()> {
    let Some((x, frame)) = equation.solve(0.5 * (first.x + last.x), free) else { return Ok(()) };
    let middle = Knot { x, point: equation.point(x) };
    if depth == 0 || deviation(&first, &middle, &last, &frame) <= chord {
        return Ok(());
    }
    halve(equation, [first, middle], free, chord, depth - 1, points)?;
    alloc::push(points, x)?;
    halve(equation, [middle, last], free, chord, depth - 1, points)
}

/// How far the arc is from its chord, nearly: in the middle, and for arcs that cross their chord, by the slope there.
fn deviation(first: &Knot, middle: &Knot, last: &Knot, frame: &Frame) -> f64 {
    let whole = last.point - first.point;
    let Some(along) = whole.try_normalize() else { return middle.point.distance(first.point) };
    let across = (middle.point - first.point).cross(along).length();
    // A cubic through both ends and the middle of the chord with slope m there is at most |m| / (6 sqrt 3) of the chord off: 0.0962.
    let slope = frame.direction().normalize_or_zero().cross(along).length();
    across.max(0.1 * slope * whole.length())
}

//! Cubic splines: segments from point to point, with continuous first and second derivatives in the
//! knots.
//!
//! Knot intervals are h_i = |P_(i+1) - P_i|^alpha: uniform, centripetal (the bisector's) or by
//! chord length. With the slopes d_i = (P_(i+1) - P_i) / h_i the derivatives D_i at the points
//! satisfy
//!
//! l_i D_(i-1) + 2 D_i + m_i D_(i+1) = 3 (l_i d_(i-1) + m_i d_i),
//!
//! l_i = h_i / (h_(i-1) + h_i), m_i = 1 - l_i.
//!
//! Segment i has the control points P_i, P_i + h_i D_i / 3, P_(i+1) - h_i D_(i+1) / 3, P_(i+1).
//! Free ends have the derivative of the parabola through their three points. A given tangent gets
//! the speed of the chord. O(n).
//!
//! Source: the complete and periodic cubic splines (de Boor, A Practical Guide to Splines, chapter
//! IV; Bessel's end condition).

use super::composite_solution::CompositeSolution;
use super::method::power_by_roots_if_possible;
use super::subcurve::{Subcurve, SubcurveOutput};
use gusset_base::error::Result;
use gusset_base::geom::linear::tridiagonal;

/// Appends the spline of a subcurve's points.
pub(super) fn append_cubic_spline(
    sub: &Subcurve<'_>,
    solution: &mut CompositeSolution,
    out: &mut SubcurveOutput<'_>,
) -> Result<()> {
    let (points, n) = (sub.points, sub.len());
    solution.reserve_for_points(n)?;
    let CompositeSolution {
        point_parameters: intervals,
        controls: derivatives,
        elimination_factors: upper,
        last_unknown_factors: across,
        ..
    } = solution;
    let alpha = sub.options.method.chord_exponent().unwrap_or(0.5);
    let (intervals, derivatives) = (&mut intervals[..n], &mut derivatives[..n]);
    for i in 0..n {
        intervals[i] = power_by_roots_if_possible(points[i].distance(points[sub.next_index(i)]), alpha);
    }
    let intervals = &*intervals;
    let slope = |i: usize| (points[sub.next_index(i)] - points[i]) / intervals[i];
    // l_i, where `before` is the previous interval.
    let ratio = |i: usize, before: usize| intervals[i] / (intervals[before] + intervals[i]);
    let row = |i: usize, before: usize| {
        let ratio = ratio(i, before);
        [ratio, 2.0, 1.0 - ratio]
    };
    let known = |i: usize| {
        let before = sub.previous_index(i);
        let ratio = ratio(i, before);
        (slope(before) * ratio + slope(i) * (1.0 - ratio)) * 3.0
    };
    if sub.closed {
        tridiagonal::solve_cyclic(derivatives, upper, across, row, known);
    } else {
        let last = n - 1;
        let speed = |i: usize| slope(i).length();
        let [start, end] = sub.tangents;
        derivatives[0] = match start {
            Some(tangent) => tangent * speed(0),
            None if last == 1 => slope(0),
            None => slope(0) + (slope(0) - slope(1)) * ratio(0, 1),
        };
        derivatives[last] = match end {
            Some(tangent) => tangent * speed(last - 1),
            None if last == 1 => slope(0),
            None => slope(last - 1) + (slope(last - 1) - slope(last - 2)) * ratio(last - 1, last - 2),
        };
        tridiagonal::solve(derivatives, upper, |i| row(i, i - 1), known);
    }
    out.builder.begin_at_point(points[0])?;
    for i in sub.span_indices() {
        let (p, q, third) = (points[i], points[sub.next_index(i)], intervals[i] / 3.0);
        out.push_span_segment(sub, i, &[p + derivatives[i] * third, q - derivatives[sub.next_index(i)] * third, q])?;
    }
    Ok(())
}

//! Cubic splines: segments from point to point, with continuous first and second derivatives in the knots.
//!
//! Knot intervals are h_i = |P_(i+1) - P_i|^alpha: uniform, centripetal (the bisector's) or by chord length. With the slopes
//! d_i = (P_(i+1) - P_i) / h_i the derivatives D_i at the points obey
//!
//! l_i D_(i-1) + 2 D_i + m_i D_(i+1) = 3 (l_i d_(i-1) + m_i d_i), l_i = h_i / (h_(i-1) + h_i), m_i = 1 - l_i,
//!
//! and segment i has the control points P_i, P_i + h_i D_i / 3, P_(i+1) - h_i D_(i+1) / 3, P_(i+1). Free ends have the
//! derivative of the parabola through their three points; a given tangent is taken at the speed of the chord.
//!
//! Source: the complete and periodic cubic splines (de Boor, A Practical Guide to Splines, chapter IV; Bessel's end condition).

use super::curve::Place;
use super::method::power;
use super::request::Options;
use super::run::{Run, Sketch, Solution, Solved, Workspace};
use crate::error::Result;
use crate::geom::linear::tridiagonal::{self, Cyclic};

/// Appends the spline of a run.
pub(super) fn curve(
    run: &Run<'_>,
    options: &Options,
    solved: &mut [Solved],
    workspace: &mut Workspace,
    sketch: &mut Sketch,
) -> Result<()> {
    let points = run.points;
    let n = points.len();
    workspace.solution.resize(n)?;
    let Solution { t: intervals, controls: derivatives, upper, across, .. } = &mut workspace.solution;
    let alpha = options.method.alpha().unwrap_or(0.5);
    let (intervals, derivatives) = (&mut intervals[..n], &mut derivatives[..n]);
    let next = |i: usize| if i + 1 == n { 0 } else { i + 1 };
    for i in 0..n {
        intervals[i] = power(points[i].distance(points[next(i)]), alpha);
    }
    let intervals = &*intervals;
    let slope = |i: usize| (points[next(i)] - points[i]) / intervals[i];
    let share = |i: usize, before: usize| intervals[i] / (intervals[before] + intervals[i]);
    let row = |i: usize, before: usize| {
        let share = share(i, before);
        [share, 2.0, 1.0 - share]
    };
    let known = |i: usize| {
        let before = if i == 0 { n - 1 } else { i - 1 };
        let share = share(i, before);
        (slope(before) * share + slope(i) * (1.0 - share)) * 3.0
    };
    if run.closed {
        Cyclic { unknowns: derivatives, upper, across }.solve(row, known);
    } else {
        let last = n - 1;
        let speed = |i: usize| slope(i).length();
        let [start, end] = run.tangents;
        derivatives[0] = match start {
            Some(tangent) => tangent * speed(0),
            None if last == 1 => slope(0),
            None => slope(0) + (slope(0) - slope(1)) * share(0, 1),
        };
        derivatives[last] = match end {
            Some(tangent) => tangent * speed(last - 1),
            None if last == 1 => slope(0),
            None => slope(last - 1) + (slope(last - 1) - slope(last - 2)) * share(last - 1, last - 2),
        };
        tridiagonal::solve(derivatives, upper, |i| row(i, i - 1), known);
    }
    sketch.begin(points[0])?;
    for i in 0..if run.closed { n } else { n - 1 } {
        let (p, q, third) = (points[i], points[next(i)], intervals[i] / 3.0);
        let segment = sketch.len() as u32;
        sketch.push(&[p + derivatives[i] * third, q - derivatives[next(i)] * third, q])?;
        solved[i].place = Place { segment, t: 0.0 };
        if !run.closed && i + 2 == n {
            solved[i + 1].place = Place { segment, t: 1.0 };
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Job;
    use crate::outline::{Method, Mode, Outlines, Points, fit};
    use glam::DVec3;
    use proptest::prelude::*;

    /// The second derivative of a segment in its knots.
    fn bend(segment: &[DVec3], interval: f64, t: f64) -> DVec3 {
        let [p, q, r, s] = [segment[0], segment[1], segment[2], segment[3]];
        ((r - q * 2.0 + p) * (1.0 - t) + (s - r * 2.0 + q) * t) * 6.0 / (interval * interval)
    }

    proptest! {
        #[test]
        fn second_derivatives_are_continuous(
            points in prop::collection::vec((-9i8..9, -9i8..9, -9i8..9), 4..30),
            closed: bool,
            alpha in 0.0f64..1.0,
        ) {
            let points: Vec<[f64; 3]> = points
                .iter()
                .enumerate()
                .map(|(i, &(x, y, z))| [f64::from(x), f64::from(y) + 0.1 * i as f64, f64::from(z)])
                .collect();
            let outlines = Outlines { points: Points::from(&points[..]), offsets: None, closed, constraints: &[] };
            let options = Options { mode: Mode::CubicC2, method: Method::Alpha(alpha), ..Options::default() };
            let done = fit(&outlines, &options, &Job::default()).unwrap();
            let curve = done.curve(0);
            let n = points.len();
            prop_assert_eq!(curve.len(), if closed { n } else { n - 1 });
            let at = |i: usize| DVec3::from_array(points[i % n]);
            let interval = |i: usize| at(i).distance(at(i + 1)).powf(alpha);
            for k in 0..curve.len() - usize::from(!closed) {
                let next = (k + 1) % curve.len();
                let (a, b) = (curve.segment(k), curve.segment(next));
                let slope = |p: DVec3, q: DVec3, i: usize| (q - p) * 3.0 / interval(i);
                let jump = slope(a[2], a[3], k) - slope(b[0], b[1], next);
                prop_assert!(jump.length() < 1e-10 * (1.0 + slope(a[2], a[3], k).length()), "slope {k} {jump}");
                let (left, right) = (bend(a, interval(k), 1.0), bend(b, interval(next), 0.0));
                prop_assert!((left - right).length() < 1e-9 * (10.0 + left.length()), "bend {k} {left} {right}");
            }
        }
    }
}

//! Blended sections: from point to point, between the section of the one and the section of the other.
//!
//! From P_i to P_(i+1) run a part of section i, the quadratic (P_i, X, P_(i+1)), and a part of section i + 1, (P_i, Y,
//! P_(i+1)). Blended linearly, (1 - u) F + u G, they are the cubic
//!
//! P_i, (P_i + 2 X) / 3, (2 Y + P_(i+1)) / 3, P_(i+1),
//!
//! which with the bisector is the centripetal Catmull-Rom spline and with the median the uniform one. Blended by w = 3 u^2 -
//! 2 u^3, whose derivative is 0 at both ends, the curve has at each point the first and second derivatives of its section, on
//! both sides: a quintic, C2 in the knots of the method's exponent.
//!
//! At a free end the one section goes on alone; a given tangent is the first leg of the quadratic that takes the place of the
//! missing section.
//!
//! Source: Nadopta, the overlapping sections of figure 2; Barry and Goldman, 1988, for the linear blend; C. Yuksel, 2020, for
//! blends that keep second derivatives, there trigonometric.

use super::curve::Place;
use super::method::{Method, through};
use super::request::{Mode, Options, PointStatus};
use super::run::{Run, Sketch, Solved, Workspace};
use crate::error::Result;

/// Appends the blended curve of a run.
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
    let (controls, parameters) = (&mut workspace.solution.controls, &mut workspace.solution.t);
    for i in run.sections() {
        let [a, p, c] = run.triple(i);
        let t = options.method.parameter(a, p, c).or_else(|status| {
            solved[i].status = status;
            Method::Bisector.parameter(a, p, c)
        });
        let section = t.and_then(|t| through(a, p, c, t)).or_else(|status| {
            // So near its neighbour that only the median will do.
            if solved[i].status == PointStatus::Ok {
                solved[i].status = status;
            }
            through(a, p, c, 0.5)
        });
        if let Ok(section) = section {
            (controls[i], parameters[i]) = (section.control, section.t);
        }
    }
    let pieces = if run.closed { n } else { n - 1 };
    sketch.begin(points[0])?;
    for i in 0..pieces {
        let next = if i + 1 == n { 0 } else { i + 1 };
        let (p, q) = (points[i], points[next]);
        let half = 0.5 * p.distance(q);
        let forth = (run.closed || i > 0).then(|| controls[i].lerp(q, parameters[i]));
        let back = (run.closed || next < n - 1).then(|| p.lerp(controls[next], parameters[next]));
        let x = forth.or_else(|| run.tangents[0].map(|tangent| p + tangent * half));
        let y = back.or_else(|| run.tangents[1].map(|tangent| q - tangent * half));
        let middle = p.midpoint(q);
        let (x, y) = (x.or(y).unwrap_or(middle), y.or(x).unwrap_or(middle));
        let segment = sketch.len() as u32;
        match options.mode {
            Mode::BlendC1 => sketch.push(&[(p + x * 2.0) / 3.0, (y * 2.0 + q) / 3.0, q])?,
            _ => sketch.push(&[
                (p * 3.0 + x * 2.0) / 5.0,
                (p * 3.0 + x * 6.0 + q) / 10.0,
                (p + y * 6.0 + q * 3.0) / 10.0,
                (y * 2.0 + q * 3.0) / 5.0,
                q,
            ])?,
        }
        solved[i].place = Place { segment, t: 0.0 };
        if i + 2 == n && !run.closed {
            solved[i + 1].place = Place { segment, t: 1.0 };
        }
    }
    Ok(())
}

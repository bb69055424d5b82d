//! Blended curves: between two points, the curve blends the sections of both.
//!
//! From P_i to P_(i+1) run a part of section i, the quadratic (P_i, X, P_(i+1)), and a part of
//! section i + 1, the quadratic (P_i, Y, P_(i+1)). The linear blend (1 - u) F + u G is the cubic
//!
//! P_i, (P_i + 2 X) / 3, (2 Y + P_(i+1)) / 3, P_(i+1).
//!
//! With the bisector it is the centripetal Catmull-Rom spline, with the median the uniform one. The
//! smooth blend has the weight w = 3 u^2 - 2 u^3, whose derivative is 0 at both ends. It takes the
//! first and second derivatives of the section at each point, on both sides. The result is a
//! quintic that is C2 in the knots of the method's exponent.
//!
//! Where the outline reverses, with P_(i-1) and P_(i+1) in one direction from P_i, the curve
//! reverses too, on the line or at the point. The status of such a point is a cusp. At a free end a
//! single section continues. A given tangent is the first leg of the quadratic that replaces the
//! missing section. O(n).
//!
//! Source: Nadopta, the overlapping sections of figure 2; Barry and Goldman, 1988, for the linear
//! blend; C. Yuksel, 2020, for blends that keep second derivatives, there trigonometric.

use super::composite_solution::CompositeSolution;
use super::identify_options::CurveKind;
use super::method::{Method, section_at_parameter};
use super::report::PointStatus;
use super::subcurve::{Subcurve, SubcurveOutput};
use gusset_base::error::Result;

/// The sine of the angle between the legs below which the outline counts as reversing.
const MAX_REVERSAL_SINE: f64 = 1e-9;

/// Appends the blended curve of a subcurve's points.
pub(super) fn append_blended_curve(
    sub: &Subcurve<'_>,
    solution: &mut CompositeSolution,
    out: &mut SubcurveOutput<'_>,
) -> Result<()> {
    let (points, n, method) = (sub.points, sub.len(), sub.options.method);
    solution.reserve_for_points(n)?;
    let (controls, parameters) = (&mut solution.controls, &mut solution.point_parameters);
    for i in sub.section_indices() {
        let [a, p, c] = sub.point_and_neighbours(i);
        let (u, w) = (a - p, c - p);
        if u.dot(w) > 0.0 && u.cross(w).length() <= MAX_REVERSAL_SINE * u.length() * w.length() {
            out.results[i].flag_status(PointStatus::Cusp);
        }
        let t = method.section_parameter(a, p, c).or_else(|status| {
            out.results[i].flag_status(status);
            Method::Bisector.section_parameter(a, p, c)
        });
        let section = t.and_then(|t| section_at_parameter(a, p, c, t)).or_else(|status| {
            // The point is so close to its neighbour that only the median works.
            out.results[i].flag_status(status);
            section_at_parameter(a, p, c, 0.5)
        });
        if let Ok(section) = section {
            (controls[i], parameters[i]) = (section.control, section.t);
        }
    }
    out.builder.begin_at_point(points[0])?;
    for i in sub.span_indices() {
        let next = sub.next_index(i);
        let (p, q) = (points[i], points[next]);
        let half = 0.5 * p.distance(q);
        let forward = (sub.closed || i > 0).then(|| controls[i].lerp(q, parameters[i]));
        let backward = (sub.closed || next < n - 1).then(|| p.lerp(controls[next], parameters[next]));
        let x = forward.or_else(|| sub.tangents[0].map(|tangent| p + tangent * half));
        let y = backward.or_else(|| sub.tangents[1].map(|tangent| q - tangent * half));
        let middle = p.midpoint(q);
        let (x, y) = (x.or(y).unwrap_or(middle), y.or(x).unwrap_or(middle));
        if sub.options.curve == CurveKind::BlendC1 {
            out.push_span_segment(sub, i, &[(p + x * 2.0) / 3.0, (y * 2.0 + q) / 3.0, q])?;
            continue;
        }
        let (first, second) = ((p * 3.0 + x * 2.0) / 5.0, (p * 3.0 + x * 6.0 + q) / 10.0);
        let (third, fourth) = ((p + y * 6.0 + q * 3.0) / 10.0, (y * 2.0 + q * 3.0) / 5.0);
        out.push_span_segment(sub, i, &[first, second, third, fourth, q])?;
    }
    Ok(())
}

//! Single curves: one Bézier curve of degree n through n + 1 points.
//!
//! P(t_i) = sum_j B_j J_(N,j)(t_i) = P_i. With the lock by parameter the t_i are given and the
//! equations are linear (collocation). Otherwise each control point is on the guide of its point,
//! B_i = P_i + lambda_i u_i with the guide u_i of the data's own triangle, and the t_i are unknown
//! too. The lock by the section's own triangle is meaningless for a curve without sections, and
//! counts as the lock by guides.
//!
//! - collocation: the unknowns, and the linear equations. guided: control points on guides.
//! - here: the choice between them, and the composite curves that replace them if they fail.
//!
//! Source: Nadopta. O(n^3) time and O(n^2) memory for n points, at most 65.

mod collocation;
mod guided_solver;

use super::composite::{self, CompositeWorkspace};
use super::guide::subcurve_plane_normal;
use super::identify_options::{Lock, Options, Solver};
use super::method::Method;
use super::report::{FitStatus, PointStatus};
use super::subcurve::{Subcurve, SubcurveOutput};
use crate::curve::{MAX_DEGREE, Place};
pub(super) use collocation::Collocation;
use collocation::MAX_POINT_MISS_DISTANCE;
use glam::DVec3;
use gusset_base::error::Result;

/// The distance of a control point from its point, in sizes of the outline, that indicates nearly
/// singular equations.
const MAX_CONTROL_TO_POINT_DISTANCE: f64 = 2.0;

/// The distance from the curve, in sizes, at which rounding has made it miss a point.
const MAX_ROUNDING_MISS: f64 = 1e-14;

/// Appends the single curve of a subcurve's points.
pub(super) fn append_single_curve(
    sub: &Subcurve<'_>,
    collocation: &mut Collocation,
    composite: &mut CompositeWorkspace,
    out: &mut SubcurveOutput<'_>,
) -> Result<()> {
    if let Some(status) = solve_single_curve(sub, collocation, out)? {
        out.report.status = status;
        out.flag_all_points(PointStatus::CompositeInstead);
        let options = Options { lock: Lock::Parameter, solver: Solver::Fast, ..*sub.options };
        return composite::append_composite_curve(&Subcurve { options: &options, ..*sub }, composite, out);
    }
    let segment = out.builder.len() as u32;
    for (i, (result, &t)) in out.results.iter_mut().zip(&collocation.t).enumerate() {
        if collocation.residual_distance(i) > MAX_ROUNDING_MISS * sub.outline_size {
            result.flag_status(PointStatus::NotConverged);
        }
        result.place = Place { segment, t };
    }
    out.builder.begin_at_point(collocation.controls[0])?;
    out.builder.push_segment(&collocation.controls[1..])
}

/// Finds parameters and control points. Returns the reason if the curve does not exist.
fn solve_single_curve(
    sub: &Subcurve<'_>,
    collocation: &mut Collocation,
    out: &mut SubcurveOutput<'_>,
) -> Result<Option<FitStatus>> {
    let tangents = if sub.closed { [Some(seam_tangent(sub)); 2] } else { sub.tangents };
    let inner = sub.len() - if sub.closed { 0 } else { 1 };
    let degree = inner + tangents.iter().flatten().count();
    if degree > MAX_DEGREE {
        return Ok(Some(FitStatus::DegreeTooHigh));
    }
    collocation.reset_for_subcurve(sub, degree)?;
    let normal = if sub.options.lock == Lock::Parameter { None } else { subcurve_plane_normal(sub) };
    if sub.options.lock != Lock::Parameter && normal.is_none() {
        out.flag_all_points(PointStatus::OutOfPlane);
    }
    collocation.find_parameters(sub, out.results);
    collocation.place_end_controls(tangents);
    let mut solved = false;
    if let Some(normal) = normal {
        collocation.find_guide_directions(sub, out.results, normal);
        solved = collocation.solve_on_guides(sub, normal, out)?;
        if !solved {
            out.report.status = FitStatus::NotConverged;
            out.report.is_uncounted = true;
            out.flag_all_points(PointStatus::FellBack);
            collocation.find_parameters(sub, out.results);
            collocation.place_end_controls(tangents);
        }
    }
    if !solved {
        collocation.solve_for_parameters(sub, out)?;
    }
    if collocation.max_control_distance() > MAX_CONTROL_TO_POINT_DISTANCE * sub.outline_size {
        out.report.status = FitStatus::IllConditioned;
    }
    let miss = collocation.max_and_squared_residual().0;
    Ok((miss.is_nan() || miss > MAX_POINT_MISS_DISTANCE * sub.outline_size).then_some(FitStatus::IllConditioned))
}

/// Returns the direction of a closed curve at its seam, which is the direction of the section on
/// the first point's triangle.
fn seam_tangent(sub: &Subcurve<'_>) -> DVec3 {
    let [a, p, c] = sub.point_and_neighbours(0);
    let section = sub.options.method.compute_section(a, p, c).or_else(|_| Method::Bisector.compute_section(a, p, c));
    let direction =
        section.map(|section| (section.control - a) * (1.0 - section.t) + (c - section.control) * section.t);
    // A reversal: use a perpendicular.
    direction.ok().and_then(DVec3::try_normalize).unwrap_or_else(|| perpendicular(c - p))
}

/// Returns a direction perpendicular to a vector, in the plane z = 0 if the vector lies in it.
fn perpendicular(v: DVec3) -> DVec3 {
    let across = if v.z == 0.0 { DVec3::new(-v.y, v.x, 0.0) } else { v.any_orthogonal_vector() };
    across.normalize_or_zero()
}

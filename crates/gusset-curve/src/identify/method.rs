//! The methods: the parameter of a given point on its section, which determines the section's
//! control point.
//!
//! A section is the quadratic (A, B, C) through P. Consider the guide through P and the foot S =
//! A + s (C - A) on the chord. The curve crosses the guide at t = sqrt(s) / (sqrt(s) + sqrt(1 - s))
//! for every position of B on the guide. (Let f be affine and 0 on the guide: f of the curve does
//! not contain B.) Each method is therefore a choice of t, and then
//!
//! B = (P - (1 - t)^2 A - t^2 C) / (2 t (1 - t)).
//!
//! Source: Nadopta, the methods of the normal, tangent, bisector and median, with closed forms
//! instead of stepping, and vectors instead of slopes and angles. The foot of the bisector divides
//! the chord by K / (1 + K), not by K as printed.

use super::report::PointStatus;
use glam::DVec3;
use gusset_base::choices;

/// The rule that finds a section's control point.
///
/// For a single section ([`sections`](super::sections()), [`Method::compute_section`]) the control
/// point lies on the line that the method names. In a composite curve the [`Lock`](super::Lock)
/// names the triangle. With the default, [`Lock::Parameter`](super::Lock), the method determines
/// only the parameter of the point.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum Method {
    /// The bisector of the angle at P. t follows the square roots of the chords (the centripetal
    /// parameter). Works for all points.
    #[default]
    Bisector,
    /// The median of triangle APC: t = 1/2. Works for all points.
    Median,
    /// The normal of the chord AC through P, if its foot lies between A and C. Otherwise the
    /// bisector replaces it. With [`Lock::SelfConsistent`](super::Lock), the foot counts as the
    /// nearer end of the chord instead.
    Normal,
    /// The symmedian: t follows the lengths of the chords. Works for all points.
    Symmedian,
    /// t = a^alpha / (a^alpha + b^alpha) for a = |AP|, b = |PC| and 0 <= alpha <= 1. Alpha 0 is the
    /// median, 1/2 the bisector, and 1 the symmedian.
    Alpha(f64),
}

choices! { for Method:
    Bisector => "Bisector", "The bisector of the angle at the point.";
    Median => "Median", "The median of the triangle with its neighbours.";
    Normal => "Normal", "The normal of the chord, where its foot lies on the chord; else the bisector.";
    Symmedian => "Symmedian", "The symmedian of the triangle.";
}

/// A section: its control point, and the parameter of P.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Section {
    /// The control point B.
    pub control: DVec3,
    /// The parameter of P, strictly between 0 and 1.
    pub t: f64,
}

impl Method {
    /// Returns the exponent of the chords; `None` for the normal.
    pub(super) fn chord_exponent(self) -> Option<f64> {
        match self {
            Method::Bisector => Some(0.5),
            Method::Median => Some(0.0),
            Method::Symmedian => Some(1.0),
            Method::Alpha(alpha) => Some(alpha),
            Method::Normal => None,
        }
    }

    /// Returns the parameter of P on the section from A to C.
    pub(super) fn section_parameter(self, a: DVec3, p: DVec3, c: DVec3) -> Result<f64, PointStatus> {
        let Some(alpha) = self.chord_exponent() else {
            return parameter_of_normal_foot(a, p, c);
        };
        let (before, after) =
            (power_by_roots_if_possible(a.distance(p), alpha), power_by_roots_if_possible(p.distance(c), alpha));
        // Both are 0, so the three points coincide and any parameter works.
        Ok(if before + after > 0.0 { before / (before + after) } else { 0.5 })
    }

    /// Returns the section from A through P to C.
    ///
    /// # Errors
    /// [`PointStatus::NormalOutside`] and [`PointStatus::RightAngle`] for the normal;
    /// [`PointStatus::Repeated`] if P is A or C and the parameter would be 0 or 1.
    pub fn compute_section(self, a: DVec3, p: DVec3, c: DVec3) -> Result<Section, PointStatus> {
        section_at_parameter(a, p, c, self.section_parameter(a, p, c)?)
    }
}

/// x^alpha, by roots where possible instead of the power function.
#[inline]
pub(super) fn power_by_roots_if_possible(x: f64, alpha: f64) -> f64 {
    match alpha {
        0.5 => x.sqrt(),
        0.0 => 1.0,
        1.0 => x,
        _ => libm::pow(x, alpha),
    }
}

/// Returns the section from A through P at parameter `t` to C.
#[inline]
pub(super) fn section_at_parameter(a: DVec3, p: DVec3, c: DVec3, t: f64) -> Result<Section, PointStatus> {
    // Near the ends the control point overflows.
    if !(1e-150..=1.0 - 1e-15).contains(&t) {
        return Err(PointStatus::Repeated);
    }
    let s = 1.0 - t;
    // Relative to P, to keep precision if A, P and C are close together and far from the origin.
    Ok(Section { control: p - (a - p) * (0.5 * s / t) - (c - p) * (0.5 * t / s), t })
}

/// s = (P - A).(C - A) / |C - A|^2 must be within (0, 1).
fn parameter_of_normal_foot(a: DVec3, p: DVec3, c: DVec3) -> Result<f64, PointStatus> {
    let chord = c - a;
    let (before, after) = ((p - a).dot(chord), (c - p).dot(chord));
    if before > 0.0 && after > 0.0 {
        let (before, after) = (before.sqrt(), after.sqrt());
        Ok(before / (before + after))
    } else if before == 0.0 || after == 0.0 {
        Err(PointStatus::RightAngle)
    } else {
        Err(PointStatus::NormalOutside)
    }
}

/// Returns the section from A, with the tangent `tau` there, through P to C: t = sqrt((tau x V) /
/// (tau x W)) for V = P - A and W = C - A, and B = A + mu tau. Everything must lie in one plane.
///
/// # Errors
/// - [`PointStatus::TangentSeparates`]: the tangent runs between P and C.
/// - [`PointStatus::TangentBeyond`]: P is farther from the tangent than C.
/// - [`PointStatus::TangentBackward`]: the curve would have to leave A backwards.
/// - [`PointStatus::OutOfPlane`].
pub fn section_by_start_tangent(a: DVec3, p: DVec3, c: DVec3, tau: DVec3) -> Result<Section, PointStatus> {
    let (v, w) = (p - a, c - a);
    let tau = unit_tangent(tau)?;
    // The components of V and W across the tangent; in a plane both are collinear.
    let (across_v, across_w) = (v - tau * v.dot(tau), w - tau * w.dot(tau));
    let squared = across_w.length_squared();
    if squared == 0.0 {
        return Err(PointStatus::TangentBeyond);
    }
    let ratio = across_v.dot(across_w) / squared;
    if (across_v - across_w * ratio).length() > MAX_PLANE_SINE * (v.length() + w.length()) {
        return Err(PointStatus::OutOfPlane);
    }
    if ratio <= 0.0 {
        return Err(PointStatus::TangentSeparates);
    }
    if ratio >= 1.0 {
        return Err(PointStatus::TangentBeyond);
    }
    let t = ratio.sqrt();
    let mu = (v - w * ratio).dot(tau) / (2.0 * t * (1.0 - t));
    if mu.is_nan() || mu <= 0.0 {
        return Err(PointStatus::TangentBackward);
    }
    Ok(Section { control: a + tau * mu, t })
}

/// Returns the section from A through P to C that arrives at C in the direction `tau`.
///
/// # Errors
/// The errors of [`section_by_start_tangent`], seen from C.
pub fn section_by_end_tangent(a: DVec3, p: DVec3, c: DVec3, tau: DVec3) -> Result<Section, PointStatus> {
    let mirrored = section_by_start_tangent(c, p, a, -tau)?;
    Ok(Section { t: 1.0 - mirrored.t, ..mirrored })
}

/// Returns the section from A to C that passes P in the direction `tau`: with h(X) = tau x (X - P),
/// t = sqrt|h(A)| / (sqrt|h(A)| + sqrt|h(C)|). Everything must lie in one plane.
///
/// # Errors
/// - [`PointStatus::TangentSeparates`]: A and C are on different sides of the tangent, or on it.
/// - [`PointStatus::TangentBackward`]: the curve passes P in the opposite direction.
/// - [`PointStatus::OutOfPlane`].
pub fn section_by_tangent(a: DVec3, p: DVec3, c: DVec3, tau: DVec3) -> Result<Section, PointStatus> {
    let tau = unit_tangent(tau)?;
    let (u, w) = (a - p, c - p);
    let (across_u, across_w) = (u - tau * u.dot(tau), w - tau * w.dot(tau));
    let (before, after) = (across_u.length(), across_w.length());
    if across_u.dot(across_w) <= 0.0 {
        return Err(PointStatus::TangentSeparates);
    }
    if (across_u * after - across_w * before).length() > MAX_PLANE_SINE * before * after {
        return Err(PointStatus::OutOfPlane);
    }
    let t = before.sqrt() / (before.sqrt() + after.sqrt());
    let section = section_at_parameter(a, p, c, t)?;
    // The derivative at P is parallel to the tangent, in either direction.
    let direction = (section.control - a) * (1.0 - t) + (c - section.control) * t;
    if direction.dot(tau) <= 0.0 {
        return Err(PointStatus::TangentBackward);
    }
    Ok(section)
}

fn unit_tangent(tau: DVec3) -> Result<DVec3, PointStatus> {
    let length = tau.length();
    if length > 0.0 { Ok(tau / length) } else { Err(PointStatus::NoTangent) }
}

/// The sine of the largest angle by which a tangent may leave the plane of its section.
const MAX_PLANE_SINE: f64 = 1e-9;

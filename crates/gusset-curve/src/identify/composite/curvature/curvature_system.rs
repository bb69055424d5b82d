//! The equations of a composite curve with continuous curvature, and their derivatives.
//!
//! Point i has the unknowns B_i, t_i, and the logits of beta_i, lambda_i and mu_i. Its equations
//! are:
//!
//! - w_0 J_(i-1) + w_1 B_i + w_2 J_i = P_i: the section passes its point;
//! - the lock: t_i is the method's parameter on the section's triangle, or B_i is on its guide;
//! - log kappa of section i at J_i = log kappa of section i + 1 there.
//!
//! With the legs e_i = B_(i+1) - B_i and E_i = |e_(i-1) x e_i| the last equation is
//!
//! log (1 - lambda_i) - 2 log mu_i + log (1 - beta_(i-1)) - 2 log beta_i + log E_i =
//!
//! log (1 - mu_(i+1)) - 2 log lambda_(i+1) + log beta_(i+1) - 2 log (1 - beta_i) + log E_(i+1),
//!
//! where |e_i|^3 cancels. All equations are dimensionless: lengths are divided by the spacing of
//! the points.

use super::super::{control_equations, self_consistent};
use crate::identify::subcurve::Subcurve;
use glam::DVec3;

/// The number of unknowns of a point: three coordinates, t, beta, lambda, mu.
pub(super) const UNKNOWNS_PER_POINT: usize = 7;

/// The number of equations of a point: three coordinates, the lock, the curvature.
pub(super) const EQUATIONS_PER_POINT: usize = 5;

/// The points whose unknowns are in the equations of a point: the previous one, itself, and two
/// more.
pub(super) const POINTS_PER_EQUATION: usize = 4;

/// The derivatives of the equations of a point.
pub(super) type EquationDerivatives = [[[f64; UNKNOWNS_PER_POINT]; POINTS_PER_EQUATION]; EQUATIONS_PER_POINT];

/// The unknowns of a point.
#[derive(Clone, Copy, Default)]
pub(super) struct PointUnknowns {
    pub(super) control: DVec3,
    pub(super) t: f64,
    pub(super) beta: f64,
    pub(super) handles: [f64; 2],
}

/// The equation of a point that determines its parameter t or its control point.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum LockEquation {
    /// t is given.
    GivenParameter,
    /// t is the method's parameter on the section's own triangle.
    TriangleParameter,
    /// The control point is on the guide with this normal, of length 1.
    OnGuide(DVec3),
}

/// The given quantities of a point.
#[derive(Clone, Copy)]
pub(super) struct FixedPointQuantities {
    pub(super) lock_equation: LockEquation,
    /// The unit of length: the distance between its neighbours.
    pub(super) spacing: f64,
    /// The unit normal about which the polygon turns at its control point.
    pub(super) normal: DVec3,
    /// Whether the joint behind its section has an equation, for curvatures other than 0.
    pub(super) curved: bool,
    /// Whether the control point is given, at an end of an open subcurve.
    pub(super) is_control_point_given: bool,
    /// Whether beta, lambda and mu are unknown.
    pub(super) is_unknown: [bool; 3],
}

/// Returns the legs before and after control point `i`. At the ends of an open subcurve they are
/// the legs from and to its points.
pub(super) fn legs_at_control_point(sub: &Subcurve<'_>, nodes: &[PointUnknowns], i: usize) -> [DVec3; 2] {
    let b = nodes[i].control;
    let first = if sub.closed || i > 0 { nodes[sub.previous_index(i)].control } else { sub.points[0] };
    let last = if sub.closed || i + 1 < sub.len() { nodes[sub.next_index(i)].control } else { sub.points[i] };
    [b - first, last - b]
}

/// Returns the beta before section `i`; 0 for the segment that begins an open subcurve.
fn joint_parameter_before(sub: &Subcurve<'_>, nodes: &[PointUnknowns], i: usize) -> f64 {
    if sub.closed || i > 0 { nodes[sub.previous_index(i)].beta } else { 0.0 }
}

/// Returns the beta behind section `i`; 1 for the segment that ends an open subcurve.
fn joint_parameter_after(sub: &Subcurve<'_>, nodes: &[PointUnknowns], i: usize) -> f64 {
    if sub.closed || i + 1 < sub.len() { nodes[i].beta } else { 1.0 }
}

/// Returns the equations of point `i`; missing ones are 0.
pub(super) fn evaluate_equations(
    sub: &Subcurve<'_>,
    known: &[FixedPointQuantities],
    nodes: &[PointUnknowns],
    i: usize,
) -> [f64; EQUATIONS_PER_POINT] {
    let mut values = [0.0; EQUATIONS_PER_POINT];
    if sub.section_indices().contains(&i) {
        let section = SectionRelativeToPoint::new(sub, nodes, i);
        let miss = section.offset_from_point(&nodes[i]) / known[i].spacing;
        values[..3].copy_from_slice(&miss.to_array());
        values[3] = match known[i].lock_equation {
            LockEquation::GivenParameter => 0.0,
            LockEquation::TriangleParameter => {
                nodes[i].t - self_consistent::parameter_and_gradients(sub.options, section.start, section.end).0
            }
            LockEquation::OnGuide(across) => across.dot(section.control_point) / known[i].spacing,
        };
    }
    if known[i].curved {
        values[4] = log_scaled_curvature_at_end(sub, known, nodes, i)
            - log_scaled_curvature_at_start(sub, known, nodes, sub.next_index(i));
    }
    values
}

/// Returns log (2/3 kappa |e_i|^3) at the end of section `i`; NaN if the polygon has an inflection.
fn log_scaled_curvature_at_end(
    sub: &Subcurve<'_>,
    known: &[FixedPointQuantities],
    nodes: &[PointUnknowns],
    i: usize,
) -> f64 {
    let [lambda, mu] = nodes[i].handles;
    let (before, beta) = (joint_parameter_before(sub, nodes, i), joint_parameter_after(sub, nodes, i));
    libm::log((1.0 - lambda) * (1.0 - before) * doubled_triangle_area(sub, known, nodes, i) / (mu * beta).powi(2))
}

/// Returns the logarithm at the start of section `i`, with |e_(i-1)|^3.
fn log_scaled_curvature_at_start(
    sub: &Subcurve<'_>,
    known: &[FixedPointQuantities],
    nodes: &[PointUnknowns],
    i: usize,
) -> f64 {
    let [lambda, mu] = nodes[i].handles;
    let (before, beta) = (joint_parameter_before(sub, nodes, i), joint_parameter_after(sub, nodes, i));
    libm::log((1.0 - mu) * beta * doubled_triangle_area(sub, known, nodes, i) / (lambda * (1.0 - before)).powi(2))
}

/// E_i; negative if the polygon has an inflection.
fn doubled_triangle_area(sub: &Subcurve<'_>, known: &[FixedPointQuantities], nodes: &[PointUnknowns], i: usize) -> f64 {
    let [before, after] = legs_at_control_point(sub, nodes, i);
    let across = before.cross(after);
    across.length().copysign(across.dot(known[i].normal))
}

/// A section relative to its point.
struct SectionRelativeToPoint {
    /// Its control point, and its ends.
    control_point: DVec3,
    start: DVec3,
    end: DVec3,
    /// The legs that contain its ends.
    legs: [DVec3; 2],
    /// The parameters of its ends on the legs.
    betas: [f64; 2],
}

impl SectionRelativeToPoint {
    fn new(sub: &Subcurve<'_>, nodes: &[PointUnknowns], i: usize) -> Self {
        let b = nodes[i].control - sub.points[i];
        let [before, after] = legs_at_control_point(sub, nodes, i);
        let betas = [joint_parameter_before(sub, nodes, i), nodes[i].beta];
        SectionRelativeToPoint {
            control_point: b,
            start: b - before * (1.0 - betas[0]),
            end: b + after * betas[1],
            legs: [before, after],
            betas,
        }
    }

    fn offset_from_point(&self, node: &PointUnknowns) -> DVec3 {
        let [first, middle, last] = control_equations::cubic_section_weights(node.t, node.handles);
        self.start * first + self.control_point * middle + self.end * last
    }
}

/// Returns the derivatives of the equations of point `i` with respect to the unknowns of four
/// points, beginning with the previous point.
pub(super) fn differentiate_equations(
    sub: &Subcurve<'_>,
    known: &[FixedPointQuantities],
    nodes: &[PointUnknowns],
    i: usize,
) -> EquationDerivatives {
    let mut rows = EquationDerivatives::default();
    if sub.section_indices().contains(&i) {
        differentiate_section_equations(sub, &known[i], nodes, i, &mut rows);
    }
    if known[i].curved {
        // The section before the joint, and the section behind it, one point further.
        differentiate_log_end_curvature(sub, known, nodes, i, 1.0, &mut rows[4]);
        differentiate_log_end_curvature(sub, known, nodes, sub.next_index(i), -1.0, &mut rows[4]);
    }
    rows
}

fn differentiate_section_equations(
    sub: &Subcurve<'_>,
    known: &FixedPointQuantities,
    nodes: &[PointUnknowns],
    i: usize,
    rows: &mut EquationDerivatives,
) {
    let (section, node) = (SectionRelativeToPoint::new(sub, nodes, i), &nodes[i]);
    let (t, s, [lambda, mu]) = (node.t, 1.0 - node.t, node.handles);
    let shares = control_equations::cubic_section_weights(t, node.handles);
    let factors = control_equations::coefficients_from_weights(shares, section.betas[0], section.betas[1]);
    let unit = 1.0 / known.spacing;
    for (axis, row) in rows.iter_mut().take(3).enumerate() {
        row.iter_mut().zip(factors).for_each(|(point, factor)| point[axis] = factor * unit);
    }
    let mut enter = |point: usize, unknown: usize, derivative: DVec3| {
        (0..3).for_each(|axis| rows[axis][point][unknown] = derivative[axis] * unit);
    };
    let SectionRelativeToPoint { control_point: b, start: u, end: v, legs, betas } = section;
    // w_0' + w_1' + w_2' = 0.
    let first = -3.0 * s * s + 3.0 * s * (s - 2.0 * t) * (1.0 - lambda);
    let last = 3.0 * t * t + 3.0 * t * (2.0 * s - t) * (1.0 - mu);
    enter(1, 3, (u - b) * first + (v - b) * last);
    let slope = |x: f64| x * (1.0 - x);
    enter(0, 4, legs[0] * (shares[0] * slope(betas[0])));
    enter(1, 4, legs[1] * (shares[2] * slope(betas[1])));
    enter(1, 5, (b - u) * (3.0 * s * s * t * slope(lambda)));
    enter(1, 6, (b - v) * (3.0 * s * t * t * slope(mu)));
    match known.lock_equation {
        LockEquation::GivenParameter => {}
        LockEquation::OnGuide(across) => rows[3][1][..3].copy_from_slice(&(across * unit).to_array()),
        LockEquation::TriangleParameter => {
            let (_, [by_u, by_v]) = self_consistent::parameter_and_gradients(sub.options, u, v);
            let controls = [by_u * (1.0 - betas[0]), by_u * betas[0] + by_v * (1.0 - betas[1]), by_v * betas[1]];
            for (row, by) in rows[3].iter_mut().zip(controls) {
                row[..3].copy_from_slice(&(-by).to_array());
            }
            rows[3][1][3] = 1.0;
            rows[3][0][4] = -by_u.dot(legs[0]) * slope(betas[0]);
            rows[3][1][4] = -by_v.dot(legs[1]) * slope(betas[1]);
        }
    }
}

/// Adds the derivatives of the logarithm of the curvature of section `i`, times `sign`: at its end
/// if `sign` is 1, otherwise at its start. The row begins at the point before the joint.
fn differentiate_log_end_curvature(
    sub: &Subcurve<'_>,
    known: &[FixedPointQuantities],
    nodes: &[PointUnknowns],
    i: usize,
    sign: f64,
    row: &mut [[f64; UNKNOWNS_PER_POINT]; POINTS_PER_EQUATION],
) {
    let ends = sign > 0.0;
    // The position of the section's point in the row.
    let own = if ends { 1 } else { 2 };
    let [before, after] = legs_at_control_point(sub, nodes, i);
    let factor = sign / doubled_triangle_area(sub, known, nodes, i);
    // dE = dv.(w x n) + dw.(n x v) for E = n.(v x w).
    let normal = known[i].normal;
    let (by_before, by_after) = (after.cross(normal) * factor, normal.cross(before) * factor);
    for (point, by) in [(own - 1, -by_before), (own, by_before - by_after), (own + 1, by_after)] {
        (0..3).for_each(|axis| row[point][axis] += by[axis]);
    }
    let [lambda, mu] = nodes[i].handles;
    let (first, last) = (joint_parameter_before(sub, nodes, i), joint_parameter_after(sub, nodes, i));
    if ends {
        row[own - 1][4] -= sign * first;
        row[own][4] -= sign * 2.0 * (1.0 - last);
        row[own][5] -= sign * lambda;
        row[own][6] -= sign * 2.0 * (1.0 - mu);
    } else {
        row[own - 1][4] += sign * 2.0 * first;
        row[own][4] += sign * (1.0 - last);
        row[own][5] -= sign * 2.0 * (1.0 - lambda);
        row[own][6] -= sign * mu;
    }
}

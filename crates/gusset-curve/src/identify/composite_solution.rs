//! The unknowns of a piecewise curve, one of each kind for every point of a subcurve, and the
//! workspace to solve for them.

use super::subcurve::Subcurve;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use std::ops::Range;

/// The parameters, joint parameters and control points of a composite curve. Other curves use the
/// lists for their own unknowns.
#[derive(Default)]
pub(super) struct CompositeSolution {
    /// The parameter of each point on its section.
    pub(super) point_parameters: Vec<f64>,
    /// The parameter by the data's own triangle, as the fallback.
    pub(super) parameters_by_data_triangles: Vec<f64>,
    /// The joint parameter beta_i behind section i; empty if all are 1/2.
    pub(super) betas: Vec<f64>,
    /// The handles lambda_i and mu_i of each cubic section; empty if all sections are quadratics.
    pub(super) handles: Vec<[f64; 2]>,
    /// The control points B_i.
    pub(super) controls: Vec<DVec3>,
    /// The factors of the elimination.
    pub(super) elimination_factors: Vec<f64>,
    /// The factors of the last unknown in a cyclic system.
    pub(super) last_unknown_factors: Vec<f64>,
    /// During the iteration of a composite curve: the joint parameters, including the ends of an
    /// open subcurve.
    pub(super) joint_parameters_of_iteration: Vec<f64>,
    /// For each point: true if it has fallen back to the parameter by the data's own triangle.
    pub(super) has_fallen_back: Vec<bool>,
    /// For each point: true if its section did not cross the point's guide line when the control
    /// point was last placed.
    pub(super) has_missed_guide: Vec<bool>,
    /// The unit direction of the guide through a point; 0 without a guide.
    pub(super) guide_directions: Vec<DVec3>,
    /// The control points before an iteration.
    pub(super) previous_controls: Vec<DVec3>,
}

impl CompositeSolution {
    pub(super) fn reserve_for_points(&mut self, n: usize) -> Result<()> {
        for list in [
            &mut self.point_parameters,
            &mut self.parameters_by_data_triangles,
            &mut self.elimination_factors,
            &mut self.last_unknown_factors,
        ] {
            alloc::grow(list, n, 0.0)?;
        }
        alloc::grow(&mut self.controls, n, DVec3::ZERO)
    }

    /// Prepares the joint parameters of a subcurve for an iteration. No point has fallen back yet.
    pub(super) fn begin_iteration(&mut self, sub: &Subcurve<'_>) -> Result<()> {
        let n = sub.len();
        self.joint_parameters_of_iteration.clear();
        alloc::extend(
            &mut self.joint_parameters_of_iteration,
            (0..n).map(|i| Self::joint_parameter(sub, &self.betas, i)),
        )?;
        alloc::reset(&mut self.has_fallen_back, n, false)?;
        alloc::reset(&mut self.has_missed_guide, n, false)?;
        alloc::reset(&mut self.previous_controls, n, DVec3::ZERO)
    }

    /// Saves the control points before an iteration.
    pub(super) fn save_controls(&mut self) {
        let n = self.previous_controls.len();
        self.previous_controls.copy_from_slice(&self.controls[..n]);
    }

    /// Returns the largest distance of a control point from its saved place.
    pub(super) fn largest_move(&self, sections: Range<usize>) -> f64 {
        let moves = sections.map(|i| self.controls[i].distance_squared(self.previous_controls[i]));
        moves.fold(0.0, f64::max).sqrt()
    }

    /// Returns the control point of section `i`, and its first and last joint, relative to its
    /// point.
    #[inline(always)]
    pub(super) fn control_and_joints_relative_to_point(&self, sub: &Subcurve<'_>, i: usize) -> [DVec3; 3] {
        let (previous, next) = (sub.previous_index(i), sub.next_index(i));
        let p = sub.points[i];
        let [a, b, c] = [previous, i, next].map(|k| self.controls[k] - p);
        [
            b,
            a + (b - a) * self.joint_parameters_of_iteration[previous],
            b + (c - b) * self.joint_parameters_of_iteration[i],
        ]
    }

    /// Sets all joint parameters to 1/2.
    pub(super) fn reset_joint_parameters(&mut self, n: usize) -> Result<()> {
        alloc::reset(&mut self.betas, n, 0.5)
    }

    /// beta_i, the joint parameter behind section `i`; 0 or 1 where the section itself begins or
    /// ends the subcurve.
    #[inline]
    pub(super) fn joint_parameter(sub: &Subcurve<'_>, beta: &[f64], i: usize) -> f64 {
        let outer = !sub.closed && (i == 0 || i + 2 == sub.len());
        match (outer, sub.tangents) {
            (true, [None, _]) if i == 0 => 0.0,
            (true, [_, None]) if i > 0 || sub.len() == 2 => 1.0,
            _ if beta.is_empty() => 0.5,
            _ => beta[i],
        }
    }

    /// J_i, the joint behind section `i`; the ends of an open subcurve count as joints.
    #[inline]
    pub(super) fn joint_point(&self, sub: &Subcurve<'_>, i: usize) -> DVec3 {
        let (last, next) = (sub.len() - 1, sub.next_index(i));
        if !sub.closed {
            if i == 0 && sub.tangents[0].is_none() {
                return sub.points[0];
            }
            if next == last && sub.tangents[1].is_none() {
                return sub.points[last];
            }
        }
        let beta = if self.betas.is_empty() { 0.5 } else { self.betas[i] };
        self.controls[i] + (self.controls[next] - self.controls[i]) * beta
    }
}

//! The unknowns of a single curve, and its linear equations: control points for given parameters.
//!
//! Each end tangent raises the degree N by one. The control point next to the end lies on the
//! tangent, at the distance |P_0 P_1| / (N t_1) that matches the speed of the parameter. A closed
//! outline begins and ends at its first point, with the tangent of the section on the data's own
//! triangle there. The curve is therefore smooth there too.

use crate::curve::segment;
use crate::identify::guide::guide_direction;
use crate::identify::method::Method;
use crate::identify::subcurve::{PointResult, Subcurve};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::bernstein;
use gusset_base::geom::linear::dense::DenseMatrix;
use std::ops::Range;

/// The distance from its points, in sizes of the outline, beyond which a curve misses them.
pub(super) const MAX_POINT_MISS_DISTANCE: f64 = 1e-12;

/// The unknowns, and the workspace to find them. There is one for each point of the subcurve; a
/// closed one repeats the first at the end.
#[derive(Default)]
pub(in crate::identify) struct Collocation {
    pub(super) points: Vec<DVec3>,
    pub(super) t: Vec<f64>,
    /// The unit guides of the points between the ends.
    pub(super) guides: Vec<DVec3>,
    pub(super) controls: Vec<DVec3>,
    /// The differences of the control points, times the degree, which are the control points of the
    /// derivative.
    pub(super) slopes: Vec<DVec3>,
    pub(super) right: Vec<DVec3>,
    pub(super) previous: Vec<DVec3>,
    pub(super) previous_t: Vec<f64>,
    pub(super) basis: Vec<f64>,
    pub(super) matrix: DenseMatrix,
    /// Whether there are end tangents.
    tangents: [bool; 2],
}

impl Collocation {
    pub(super) fn reset_for_subcurve(&mut self, sub: &Subcurve<'_>, degree: usize) -> Result<()> {
        let count = sub.len() + usize::from(sub.closed);
        self.points.clear();
        alloc::extend(&mut self.points, sub.points.iter().copied().chain(sub.closed.then_some(sub.points[0])))?;
        alloc::reset(&mut self.t, count, 0.0)?;
        for list in [&mut self.controls, &mut self.slopes, &mut self.right, &mut self.guides, &mut self.previous] {
            alloc::reset(list, degree + 1, DVec3::ZERO)?;
        }
        alloc::reset(&mut self.basis, degree + 1, 0.0)?;
        alloc::reset(&mut self.previous_t, degree + 1, 0.0)
    }

    /// Returns the number of points between the ends.
    pub(super) fn inner_point_count(&self) -> usize {
        self.points.len() - 2
    }

    pub(super) fn degree(&self) -> usize {
        self.controls.len() - 1
    }

    /// Returns the indices of the control points that belong to the points between the ends.
    pub(super) fn inner_control_range(&self) -> Range<usize> {
        let first = 1 + usize::from(self.tangents[0]);
        first..first + self.inner_point_count()
    }

    /// The parameters by the data's own triangles: neighbouring spans have the ratio of t_i to 1 -
    /// t_i.
    pub(super) fn find_parameters(&mut self, sub: &Subcurve<'_>, results: &mut [PointResult]) {
        let last = self.points.len() - 1;
        let (mut sum, mut span) = (1.0, 1.0);
        self.t[0] = 0.0;
        for (i, result) in results.iter_mut().enumerate().take(last).skip(1) {
            self.t[i] = sum;
            let [a, p, c] = sub.point_and_neighbours(i);
            let t = sub.options.method.section_parameter(a, p, c).unwrap_or_else(|status| {
                result.flag_status(status);
                Method::Bisector.section_parameter(a, p, c).unwrap_or(0.5)
            });
            span *= (1.0 - t).max(1e-9) / t.max(1e-9);
            sum += span;
        }
        self.t[last] = sum;
        self.t.iter_mut().for_each(|t| *t /= sum);
    }

    /// Places the ends, and the control points next to them on the tangents.
    pub(super) fn place_end_controls(&mut self, tangents: [Option<DVec3>; 2]) {
        let (last, degree) = (self.points.len() - 1, self.degree());
        self.tangents = tangents.map(|tangent| tangent.is_some());
        self.controls[0] = self.points[0];
        self.controls[degree] = self.points[last];
        let length = |from: DVec3, to: DVec3, t: f64| from.distance(to) / (degree as f64 * t).max(1.0 / 64.0);
        if let Some(tangent) = tangents[0] {
            self.controls[1] = self.points[0] + tangent * length(self.points[0], self.points[1], self.t[1]);
        }
        if let Some(tangent) = tangents[1] {
            let length = length(self.points[last], self.points[last - 1], 1.0 - self.t[last - 1]);
            self.controls[degree - 1] = self.points[last] - tangent * length;
        }
    }

    /// Finds the guides of the points between the ends. If the method lacks a guide, the bisector
    /// replaces it.
    pub(super) fn find_guide_directions(&mut self, sub: &Subcurve<'_>, results: &mut [PointResult], normal: DVec3) {
        for (i, result) in results.iter_mut().enumerate().take(self.inner_point_count() + 1).skip(1) {
            let [a, p, c] = sub.point_and_neighbours(i);
            let found = guide_direction(sub.options.method, a - p, c - p, normal).or_else(|status| {
                result.flag_status(status);
                guide_direction(Method::Bisector, a - p, c - p, normal)
            });
            self.guides[i] = found.unwrap_or_else(|_| normal.any_orthonormal_vector());
        }
    }

    /// Puts the control points on their points, where the paper starts.
    pub(super) fn start_controls_at_points(&mut self) {
        let (inner_range, inner) = (self.inner_control_range(), self.inner_point_count());
        self.controls[inner_range].copy_from_slice(&self.points[1..=inner]);
    }

    /// Solves the linear equations for the current parameters.
    pub(super) fn solve_linear_equations(&mut self) -> Result<()> {
        let (inner, inner_range) = (self.inner_point_count(), self.inner_control_range());
        self.controls[inner_range.clone()].fill(DVec3::ZERO);
        self.matrix.resize(inner)?;
        for i in 1..=inner {
            bernstein::bernstein_values(&mut self.basis, self.t[i]);
            self.matrix.row(i - 1).copy_from_slice(&self.basis[inner_range.clone()]);
        }
        if !self.matrix.factorise() {
            self.start_controls_at_points();
            return Ok(());
        }
        // Iterative refinement: the first round leaves rounding errors, and the next removes most
        // of them.
        for _ in 0..3 {
            for i in 1..=inner {
                self.right[i - 1] = self.points[i] - segment::point_at(&self.controls, self.t[i]);
            }
            self.matrix.solve(&mut self.right[..inner]);
            self.controls[inner_range.clone()]
                .iter_mut()
                .zip(&self.right)
                .for_each(|(control, &step)| *control += step);
        }
        Ok(())
    }

    /// Returns the largest distance of a control point from its point.
    pub(super) fn max_control_distance(&self) -> f64 {
        let pairs = self.controls[self.inner_control_range()].iter().zip(&self.points[1..]);
        pairs.map(|(control, &p)| control.distance(p)).fold(0.0, f64::max).min(1e300)
    }

    /// Returns the distance of a point from its place on the curve.
    pub(super) fn residual_distance(&self, i: usize) -> f64 {
        segment::point_at(&self.controls, self.t[i]).distance(self.points[i])
    }

    /// Returns the largest residual, and the sum of squared residuals.
    pub(super) fn max_and_squared_residual(&self) -> (f64, f64) {
        let (mut farthest, mut sum) = (0.0f64, 0.0);
        for i in 1..=self.inner_point_count() {
            let square = self.residual_distance(i).powi(2);
            if square > farthest || square.is_nan() {
                farthest = square;
            }
            sum += square;
        }
        (farthest.sqrt(), sum)
    }
}

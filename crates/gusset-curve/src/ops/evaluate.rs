//! Points, derivatives, tangents and curvatures at places.

use crate::curve::segment::{self, SegmentBuffer};
use crate::curve::unit_frame::UnitFrame;
use crate::curve::{CurveView, MAX_DEGREE, Place};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::{Allowed, Error, Result};
use gusset_base::job::Job;

/// Places between two progress reports.
const PLACES_PER_REPORT: usize = 1 << 10;

const PROGRESS_STAGE: &str = "values at places";

impl CurveView<'_> {
    /// Returns the point at a place. O(degree), like every place below.
    ///
    /// # Errors
    /// [`Error::NoSuchPlace`]: the segment does not exist, or t is outside 0 to 1.
    pub fn point(&self, place: Place) -> Result<DVec3> {
        self.check_place(0, place)?;
        Ok(segment::point_at(self.segment(place.segment as usize), place.t))
    }

    /// Returns the points at many places.
    ///
    /// # Errors
    /// [`Error::NoSuchPlace`], [`Error::OutOfMemory`], [`Error::Cancelled`].
    pub fn points_at(&self, places: &[Place], job: &Job<'_>) -> Result<Vec<DVec3>> {
        self.evaluate_at_each_place(places, segment::point_at, job)
    }

    /// Returns the unit tangent at a place, or 0; see [`tangents_at`](Self::tangents_at).
    ///
    /// # Errors
    /// [`Error::NoSuchPlace`].
    pub fn tangent(&self, place: Place) -> Result<DVec3> {
        self.check_place(0, place)?;
        Ok(unit_tangent(self.segment(place.segment as usize), place.t))
    }

    /// Returns the derivatives at many places with respect to the segment's parameter t. Each place
    /// gets the point, the first derivative, and so on up to `order`, at most [`MAX_DEGREE`].
    /// Derivatives beyond the degree of a segment are 0. O(degree^2) a place.
    ///
    /// # Errors
    /// [`Error::NoSuchPlace`], [`Error::OptionOutOfRange`] (the order), [`Error::OutOfMemory`],
    /// [`Error::Cancelled`].
    pub fn derivatives_at(&self, places: &[Place], order: usize, job: &Job<'_>) -> Result<Vec<DVec3>> {
        Error::require(order <= MAX_DEGREE, "order", order as f64, Allowed::AtMost(MAX_DEGREE as f64))?;
        let mut out = alloc::with_capacity(places.len().saturating_mul(order + 1))?;
        for (index, &place) in places.iter().enumerate() {
            job.step_every(PLACES_PER_REPORT, index, places.len(), PROGRESS_STAGE)?;
            self.check_place(index, place)?;
            let mut derived = SegmentBuffer::new(self.segment(place.segment as usize));
            for _ in 0..=order {
                out.push(segment::point_at(&derived, place.t));
                derived.differentiate();
            }
        }
        Ok(out)
    }

    /// Returns the unit tangents at many places, also where the first derivative is 0. At t = 1 it
    /// is the direction of arrival, elsewhere the direction of departure. A segment without extent
    /// gets 0.
    ///
    /// # Errors
    /// [`Error::NoSuchPlace`], [`Error::OutOfMemory`], [`Error::Cancelled`].
    pub fn tangents_at(&self, places: &[Place], job: &Job<'_>) -> Result<Vec<DVec3>> {
        self.evaluate_at_each_place(places, unit_tangent, job)
    }

    /// Returns the curvatures at many places, 1 over the radius. On a plane segment (z = 0) the
    /// curvature is positive where the segment turns left, from x to y; in space it is never
    /// negative. It is infinite where the first derivative is 0, except on a straight segment,
    /// where it is 0.
    ///
    /// # Errors
    /// [`Error::NoSuchPlace`], [`Error::OutOfMemory`], [`Error::Cancelled`].
    pub fn curvatures_at(&self, places: &[Place], job: &Job<'_>) -> Result<Vec<f64>> {
        self.evaluate_at_each_place(places, signed_curvature, job)
    }

    fn evaluate_at_each_place<T>(
        &self,
        places: &[Place],
        value: impl Fn(&[DVec3], f64) -> T,
        job: &Job<'_>,
    ) -> Result<Vec<T>> {
        alloc::try_collect(places.iter().enumerate().map(|(index, &place)| {
            job.step_every(PLACES_PER_REPORT, index, places.len(), PROGRESS_STAGE)?;
            self.check_place(index, place)?;
            Ok(value(self.segment(place.segment as usize), place.t))
        }))
    }
}

/// Returns the first three derivatives at `t`, in the segment's own frame.
fn first_three_derivatives(controls: &[DVec3], t: f64) -> (UnitFrame, [DVec3; 3]) {
    let frame = UnitFrame::from_points(controls);
    let mut derived = frame.segment_to_frame(controls);
    let values = [(); 3].map(|()| {
        derived.differentiate();
        segment::point_at(&derived, t)
    });
    (frame, values)
}

/// In a curve of size 1 and degree n, a derivative below this times n counts as rounding.
const MIN_RELATIVE_DERIVATIVE: f64 = 1e-13;

/// Returns the unit tangent at `t`, or 0.
pub(super) fn unit_tangent(controls: &[DVec3], t: f64) -> DVec3 {
    let along = match t {
        0.0 => segment::vector_to_next_distinct_control(controls),
        1.0 => segment::vector_from_previous_distinct_control(controls),
        _ => {
            let min = MIN_RELATIVE_DERIVATIVE * controls.len() as f64;
            first_three_derivatives(controls, t).1.into_iter().find(|d| d.length() > min).unwrap_or(DVec3::ZERO)
        }
    };
    let size = along.abs().max_element();
    if size.is_finite() { (along / size).normalize_or_zero() } else { (along * 0.25).normalize_or_zero() }
}

/// |C' x C''| / |C'|^3, with the sign of z for a plane curve.
fn signed_curvature(controls: &[DVec3], t: f64) -> f64 {
    let (frame, [first, second, _]) = first_three_derivatives(controls, t);
    let across = first.cross(second);
    let speed = first.length();
    if speed <= MIN_RELATIVE_DERIVATIVE * controls.len() as f64 {
        let along = segment::vector_to_next_distinct_control(controls);
        let along = along / along.abs().max_element().max(f64::MIN_POSITIVE);
        let straight = controls.iter().all(|&p| {
            let leg = frame.point_to_frame(p) - frame.point_to_frame(controls[0]);
            leg.cross(along).length() <= MIN_RELATIVE_DERIVATIVE * leg.length()
        });
        return if straight { 0.0 } else { f64::INFINITY };
    }
    let signed = if controls.iter().all(|p| p.z == 0.0) { across.z } else { across.length() };
    frame.length_to_frame(signed / (speed * speed * speed))
}

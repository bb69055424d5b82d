//! Task b) of Leus for curves: the points whose tangents make a given angle with a direction.
//!
//! With the derivative T, the unit direction w and the angle a, the condition T . w = cos(a) |T|
//! becomes polynomial when squared: sin^2(a) (T . w)^2 = cos^2(a) |T x w|^2, where T . w has the
//! sign of cos(a). All its roots are isolated in Bernstein form. At a right angle the equation is T
//! . w = 0. Parallel to the direction the roots would be double, so both components of T across it
//! must be 0. O(degree^2) a root.

use crate::curve::unit_frame::UnitFrame;
use crate::curve::{CurveView, MAX_DEGREE, Place, check_finite};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::geom::bernstein::{Roots, add_product, differentiate, roots, value_and_slope};
use gusset_base::job::Job;
use std::f64::consts::{FRAC_PI_2, PI};

/// The points of a curve whose tangents make a given angle with a direction.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct TangentAngles {
    /// Isolated points, once each, in the order of the curve. A joint belongs to the segment that
    /// ends there. The closing point of a closed curve belongs to its start.
    pub places: Vec<Place>,
    /// Intervals of points with such tangents: straight parts, and parts of helices. They contain
    /// none of the places.
    pub intervals: Vec<[Place; 2]>,
}

/// Angles this close to 0, a right angle or pi count as exactly that.
const MAX_SPECIAL_ANGLE_ERROR: f64 = 1e-7;
/// A bound of the rounding error of polynomials with coefficients up to 1.
const MAX_POLYNOMIAL_ROUNDING: f64 = 1.0 / (1_u64 << 46) as f64;
/// The sine of the angle below which a tangent counts as parallel to the direction.
const MAX_PARALLEL_SINE: f64 = 1e-9;
const MAX_CUSP_ANGLE_ERROR: f64 = 1e-6;
/// A derivative below this fraction of its maximum counts as 0.
const MIN_RELATIVE_SPEED: f64 = 1e-7;
/// Parameters this close to a joint count as the joint.
const MAX_SAME_JOINT_PARAMETER_GAP: f64 = 1e-6;
/// Parameters this close to each other count as one root. They are roots of the squared equation
/// that lead to the same root of the original equation, or a double root that was split in two.
const MAX_SAME_ROOT_PARAMETER_GAP: f64 = 1e-8;
/// The maximum number of Newton steps for the equation before squaring.
const MAX_NEWTON_STEPS: usize = 8;

/// Segments between two progress reports.
const SEGMENTS_PER_REPORT: usize = 1 << 8;

/// The components of the derivative of a segment, along the direction and across it.
struct SegmentTangents {
    components: [[f64; MAX_DEGREE]; 3],
    coefficient_count: usize,
}

/// The angle sought.
#[derive(Clone, Copy)]
enum AngleCriterion {
    Right,
    /// Along the direction (1) or against it (-1).
    Parallel(f64),
    /// Another angle, by its cosine and sine.
    Other(f64, f64),
}

impl CurveView<'_> {
    /// Finds all points whose tangents make an angle with a direction. At a cusp, where the
    /// derivative is 0, the tangents before and after it count, to 1e-6. At a joint the tangents of
    /// both segments count, but not the directions between them. Angles within 1e-7 of 0, pi / 2
    /// and pi are taken as exact. A tangent is parallel to the direction to 1e-9.
    ///
    /// # Errors
    /// [`Error::OptionOutOfRange`] (a direction of length 0, an angle outside 0 to pi),
    /// [`Error::NotFinite`] (point 0 is the direction), [`Error::OutOfMemory`],
    /// [`Error::Cancelled`].
    pub fn tangents_at_angle(&self, direction: DVec3, angle: f64, job: &Job<'_>) -> Result<TangentAngles> {
        check_finite(0, direction)?;
        Error::require((0.0..=PI).contains(&angle), "angle", angle, "from 0 to pi")?;
        let largest = direction.abs().max_element();
        Error::require(largest > 0.0, "direction", largest, "a vector other than 0")?;
        let along = (direction / largest).normalize();
        let sought = match angle {
            _ if angle <= MAX_SPECIAL_ANGLE_ERROR => AngleCriterion::Parallel(1.0),
            _ if PI - angle <= MAX_SPECIAL_ANGLE_ERROR => AngleCriterion::Parallel(-1.0),
            _ if (angle - FRAC_PI_2).abs() <= MAX_SPECIAL_ANGLE_ERROR => AngleCriterion::Right,
            _ => AngleCriterion::Other(libm::cos(angle), libm::sin(angle)),
        };
        let (u, v) = along.any_orthonormal_pair();
        let frame = UnitFrame::from_points(self.points());
        let mut found = TangentAngles::default();
        for (k, controls) in self.segments().enumerate() {
            job.step_every(SEGMENTS_PER_REPORT, k, self.len(), "tangents at an angle")?;
            let Some(tangents) = SegmentTangents::new(controls, &frame, [along, u, v]) else { continue };
            let roots = tangents.candidate_roots(sought);
            if roots.everywhere {
                tangents.add_parallel_intervals(sought, k as u32, &mut found.intervals)?;
                continue;
            }
            for &t in roots.as_slice() {
                if let Some(t) = tangents.confirm_root(sought, t, angle) {
                    found.add_place(Place { segment: k as u32, t })?;
                }
            }
        }
        found.remove_repeated_places(self);
        Ok(found)
    }
}

impl SegmentTangents {
    /// Scales the derivative to a size of about 1. Returns `None` for a segment without extent.
    fn new(controls: &[DVec3], frame: &UnitFrame, axes: [DVec3; 3]) -> Option<Self> {
        let count = controls.len() - 1;
        let mut legs = [DVec3::ZERO; MAX_DEGREE];
        for (leg, pair) in legs.iter_mut().zip(controls.windows(2)) {
            *leg = frame.point_to_frame(pair[1]) - frame.point_to_frame(pair[0]);
        }
        let largest = legs[..count].iter().map(|leg| leg.length()).fold(0.0, f64::max);
        (largest > 0.0).then(|| {
            let component = |axis: DVec3| std::array::from_fn(|k| axis.dot(legs[k]) / largest);
            SegmentTangents { components: axes.map(component), coefficient_count: count }
        })
    }

    fn derivative_component(&self, k: usize) -> &[f64] {
        &self.components[k][..self.coefficient_count]
    }

    /// Returns the derivative at a parameter, and its derivative.
    fn derivatives_at(&self, t: f64) -> [DVec3; 2] {
        let [x, y, z] = [0, 1, 2].map(|k| value_and_slope(self.derivative_component(k), t));
        [DVec3::new(x.0, y.0, z.0), DVec3::new(x.1, y.1, z.1)]
    }

    /// Returns the roots of the equation, or of its square, which include all solutions.
    fn candidate_roots(&self, sought: AngleCriterion) -> Roots {
        let [along, u, v] = [0, 1, 2].map(|k| self.derivative_component(k));
        match sought {
            AngleCriterion::Right => roots(along, MAX_POLYNOMIAL_ROUNDING),
            AngleCriterion::Parallel(_) => {
                // Use the component across that is not 0 everywhere.
                let size = |c: &[f64]| c.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
                roots(if size(u) >= size(v) { u } else { v }, MAX_POLYNOMIAL_ROUNDING)
            }
            AngleCriterion::Other(cosine, sine) => {
                let mut squared = [0.0; 2 * MAX_DEGREE];
                add_product(along, along, sine * sine, &mut squared);
                for across in [u, v] {
                    add_product(across, across, -cosine * cosine, &mut squared);
                }
                roots(&squared[..2 * self.coefficient_count - 1], MAX_POLYNOMIAL_ROUNDING)
            }
        }
    }

    /// Returns the solution near a candidate, if the tangent makes the angle there.
    fn confirm_root(&self, sought: AngleCriterion, t: f64, angle: f64) -> Option<f64> {
        let [tangent, _] = self.derivatives_at(t);
        if tangent.length() <= MIN_RELATIVE_SPEED {
            return self.is_cusp_of_angle_at(t, angle).then_some(t);
        }
        match sought {
            AngleCriterion::Right => Some(t),
            AngleCriterion::Parallel(sign) => {
                (libm::hypot(tangent.y, tangent.z) <= MAX_PARALLEL_SINE * tangent.length() && sign * tangent.x > 0.0)
                    .then_some(t)
            }
            // Check the sign that squaring lost, if it is beyond doubt; otherwise solve the
            // original equation.
            AngleCriterion::Other(cosine, _) => {
                let mut at = t;
                for _ in 0..MAX_NEWTON_STEPS {
                    let [tangent, slope] = self.derivatives_at(at);
                    let length = tangent.length();
                    let off = tangent.x - cosine * length;
                    let rise = slope.x - cosine * tangent.dot(slope) / length;
                    let next = (at - off / rise).clamp(0.0, 1.0);
                    if !next.is_finite() || (next - t).abs() > 1e-3 {
                        break;
                    }
                    at = next;
                }
                let off = |t: f64| {
                    let [tangent, _] = self.derivatives_at(t);
                    (tangent.x - cosine * tangent.length()).abs() / tangent.length()
                };
                let best = if off(at) < off(t) { at } else { t };
                // A double root of the square may be off by the square root of the noise.
                (off(best) <= 1e-7).then_some(best)
            }
        }
    }

    /// Returns true if the derivative is 0 and the tangent before or after makes the angle.
    fn is_cusp_of_angle_at(&self, t: f64, angle: f64) -> bool {
        let mut rest = self.components;
        let (mut count, mut sign) = (self.coefficient_count, 1.0);
        // The tangent after the place is the first non-zero derivative. The tangent before it has
        // the opposite sign if an odd number of derivatives is 0.
        while count > 0 {
            let value = DVec3::from_array([0, 1, 2].map(|k| value_and_slope(&rest[k][..count], t).0));
            let size = rest.iter().flat_map(|c| &c[..count]).fold(0.0, |most: f64, x| most.max(x.abs()));
            if value.length() > MIN_RELATIVE_SPEED * size {
                let makes = |x: f64| (libm::acos(x.clamp(-1.0, 1.0)) - angle).abs() <= MAX_CUSP_ANGLE_ERROR;
                let along = value.x / value.length();
                return (t < 1.0 && makes(along)) || (t > 0.0 && makes(sign * along));
            }
            for c in &mut rest {
                differentiate(&mut c[..count]);
            }
            (count, sign) = (count - 1, -sign);
        }
        false
    }

    /// Adds a segment all of whose tangents are parallel, or make the angle or its opposite: the
    /// parts with the right sign.
    fn add_parallel_intervals(
        &self,
        sought: AngleCriterion,
        segment: u32,
        intervals: &mut Vec<[Place; 2]>,
    ) -> Result<()> {
        let sign = match sought {
            AngleCriterion::Right => None,
            AngleCriterion::Parallel(sign) => Some(sign),
            AngleCriterion::Other(cosine, _) => Some(cosine),
        };
        let turns = roots(self.derivative_component(0), MAX_POLYNOMIAL_ROUNDING);
        let ends = turns.as_slice().iter().copied().filter(|_| sign.is_some()).chain([1.0]);
        let mut from = 0.0;
        for to in ends.filter(|&t| t > 0.0) {
            let [tangent, _] = self.derivatives_at(0.5 * (from + to));
            let all_lie = match sought {
                AngleCriterion::Parallel(_) => {
                    libm::hypot(tangent.y, tangent.z) <= MAX_PARALLEL_SINE * tangent.length()
                }
                _ => true,
            };
            if to > from && all_lie && sign.is_none_or(|sign| sign * tangent.x > 0.0) {
                let [from, to] = [from, to].map(|t| Place { segment, t });
                match intervals.last_mut() {
                    Some(last) if is_same_place(last[1], from) => last[1] = to,
                    _ => alloc::push(intervals, [from, to])?,
                }
            }
            from = to;
        }
        Ok(())
    }
}

/// Returns true if two places are equal, or are both sides of a joint.
fn is_same_place(a: Place, b: Place) -> bool {
    let is_joint =
        a.segment + 1 == b.segment && a.t >= 1.0 - MAX_SAME_JOINT_PARAMETER_GAP && b.t <= MAX_SAME_JOINT_PARAMETER_GAP;
    (a.segment == b.segment && (a.t - b.t).abs() <= MAX_SAME_JOINT_PARAMETER_GAP) || is_joint
}

impl TangentAngles {
    /// Adds a place unless the list already has its joint or root.
    fn add_place(&mut self, place: Place) -> Result<()> {
        let mut own = self.places.len();
        while own > 0 && self.places[own - 1].segment == place.segment {
            own -= 1;
        }
        let is_known = |other: &Place| (other.t - place.t).abs() <= MAX_SAME_ROOT_PARAMETER_GAP;
        let is_joint = own.checked_sub(1).is_some_and(|before| is_same_place(self.places[before], place));
        if is_joint || self.places[own..].iter().any(is_known) {
            return Ok(());
        }
        let at = own + self.places[own..].partition_point(|other| other.t < place.t);
        alloc::reserve(&mut self.places, 1)?;
        self.places.insert(at, place);
        Ok(())
    }

    /// Removes the end of a closed curve if its start is listed, and places at the ends of
    /// intervals.
    fn remove_repeated_places(&mut self, curve: &CurveView<'_>) {
        let last = curve.len() as u32;
        let is_start = |place: &Place| place.segment == 0 && place.t <= MAX_SAME_JOINT_PARAMETER_GAP;
        let is_end = |place: &Place| place.segment + 1 == last && place.t >= 1.0 - MAX_SAME_JOINT_PARAMETER_GAP;
        let has_start =
            self.places.first().is_some_and(is_start) || self.intervals.first().is_some_and(|part| is_start(&part[0]));
        let ends_inside = self.intervals.last().is_some_and(|part| is_end(&part[1]));
        let (closed, intervals) = (curve.is_closed(), &self.intervals);
        self.places.retain(|place| {
            let doubled = closed && ((has_start && is_end(place)) || (ends_inside && is_start(place)));
            let at_end =
                |part: &[Place; 2]| part.iter().any(|&end| is_same_place(end, *place) || is_same_place(*place, end));
            !doubled && !intervals.iter().any(at_end)
        });
    }
}

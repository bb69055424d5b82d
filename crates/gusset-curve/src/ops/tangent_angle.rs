//! Task b) of Leus for curves: the points whose tangents make a given angle with a direction.
//!
//! With T the derivative, w the unit direction and a the angle, the condition T . w = cos(a) |T| is
//! polynomial when squared: sin^2(a) (T . w)^2 = cos^2(a) |T x w|^2, T . w of the sign of cos(a).
//! All roots of it are isolated in Bernstein form. At a right angle the square is left out: T . w =
//! 0; along the direction, where the roots are double ones, both components of T across it are 0.
//! O(degree^2) a root.

use crate::curve::unit_frame::UnitFrame;
use crate::curve::{CurveView, MAX_DEGREE, Place, check_finite};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::geom::bernstein::{Roots, add_product, derive, roots, value_and_slope};
use gusset_base::job::Job;
use std::f64::consts::{FRAC_PI_2, PI};

/// The points of a curve whose tangents make an angle with a direction.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct TangentAngles {
    /// Single points, in the order of the curve, each once: a joint belongs to the segment that
    /// ends there, and the joint of a closed curve's end and start to its start.
    pub places: Vec<Place>,
    /// From where to where all points have such tangents: straight parts, and parts of helices.
    /// None of the places is in one of them.
    pub intervals: Vec<[Place; 2]>,
}

/// Angles as near to 0, a right angle, or pi are taken for these.
const SPECIAL_ANGLE: f64 = 1e-7;
/// A bound of the rounding of polynomials whose coefficients are 1 at most.
const NOISE: f64 = 1.0 / (1_u64 << 46) as f64;
/// The sine below which a tangent is along the direction; and the angle within which the tangent
/// before or after a cusp is taken to make the angle.
const PARALLEL: f64 = 1e-9;
const CUSP_ANGLE: f64 = 1e-6;
/// Parts of its greatest size below which a derivative is taken for 0.
const MIN_SPEED: f64 = 1e-7;
/// Parameters at a joint that are as near to it are there.
const SAME_PARAMETER: f64 = 1e-6;
/// Parameters of a segment that are as near to each other are one root: those of the squared
/// equation that lead to one of the other, and double roots in two halves.
const SAME_ROOT: f64 = 1e-8;
/// Steps of Newton's method for the equation that is not squared.
const MAX_STEPS: usize = 8;

/// Segments between two progress reports.
const SEGMENTS_PER_REPORT: usize = 1 << 8;

/// The components of the derivative of a segment: along the direction, and across it.
struct Tangents {
    components: [[f64; MAX_DEGREE]; 3],
    count: usize,
}

/// The angle that is looked for.
#[derive(Clone, Copy)]
enum Sought {
    Right,
    /// Along the direction (1) or against it (-1).
    Parallel(f64),
    /// By its cosine and sine.
    Other(f64, f64),
}

impl CurveView<'_> {
    /// The points whose tangents make an angle with a direction, all of them. At a cusp, where the
    /// derivative is 0, the tangents before and after it count, to 1e-6; at a joint those of both
    /// segments, but not those between. Angles within 1e-7 of 0, pi / 2 and pi are taken for these;
    /// tangents count as along the direction, or against it, to 1e-9.
    ///
    /// # Errors
    /// [`Error::OptionOutOfRange`] (a direction of length 0, an angle outside 0 to pi),
    /// [`Error::NotFinite`] (point 0 is the direction), [`Error::OutOfMemory`], [`Error::Cancelled`].
    pub fn tangents_at_angle(&self, direction: DVec3, angle: f64, job: &Job<'_>) -> Result<TangentAngles> {
        check_finite(0, direction)?;
        Error::require((0.0..=PI).contains(&angle), "angle", angle)?;
        let largest = direction.abs().max_element();
        Error::require(largest > 0.0, "direction", largest)?;
        let along = (direction / largest).normalize();
        let sought = match angle {
            _ if angle <= SPECIAL_ANGLE => Sought::Parallel(1.0),
            _ if PI - angle <= SPECIAL_ANGLE => Sought::Parallel(-1.0),
            _ if (angle - FRAC_PI_2).abs() <= SPECIAL_ANGLE => Sought::Right,
            _ => Sought::Other(libm::cos(angle), libm::sin(angle)),
        };
        let (u, v) = along.any_orthonormal_pair();
        let frame = UnitFrame::of(self.points());
        let mut found = TangentAngles::default();
        for (k, controls) in self.segments().enumerate() {
            job.step_every(SEGMENTS_PER_REPORT, k, self.len(), "tangents at an angle")?;
            let Some(tangents) = Tangents::of(controls, &frame, [along, u, v]) else { continue };
            let roots = tangents.candidates(sought);
            if roots.everywhere {
                tangents.parts(sought, k as u32, &mut found.intervals)?;
                continue;
            }
            for &t in roots.as_slice() {
                if let Some(t) = tangents.confirm(sought, t, angle) {
                    found.add(Place { segment: k as u32, t })?;
                }
            }
        }
        found.close(self);
        Ok(found)
    }
}

impl Tangents {
    /// Of size about 1; `None` for a segment without extent.
    fn of(controls: &[DVec3], frame: &UnitFrame, axes: [DVec3; 3]) -> Option<Self> {
        let count = controls.len() - 1;
        let mut legs = [DVec3::ZERO; MAX_DEGREE];
        for (leg, pair) in legs.iter_mut().zip(controls.windows(2)) {
            *leg = frame.point(pair[1]) - frame.point(pair[0]);
        }
        let largest = legs[..count].iter().map(|leg| leg.length()).fold(0.0, f64::max);
        (largest > 0.0).then(|| {
            let component = |axis: DVec3| std::array::from_fn(|k| axis.dot(legs[k]) / largest);
            Tangents { components: axes.map(component), count }
        })
    }

    fn component(&self, k: usize) -> &[f64] {
        &self.components[k][..self.count]
    }

    /// The derivative at a parameter, and its derivative.
    fn at(&self, t: f64) -> [DVec3; 2] {
        let [x, y, z] = [0, 1, 2].map(|k| value_and_slope(self.component(k), t));
        [DVec3::new(x.0, y.0, z.0), DVec3::new(x.1, y.1, z.1)]
    }

    /// Places among which are all that are sought: of an equation that may be a squared one.
    fn candidates(&self, sought: Sought) -> Roots {
        let [along, u, v] = [0, 1, 2].map(|k| self.component(k));
        match sought {
            Sought::Right => roots(along, NOISE),
            Sought::Parallel(_) => {
                // Of the two components across, that which is not 0 everywhere.
                let size = |c: &[f64]| c.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
                roots(if size(u) >= size(v) { u } else { v }, NOISE)
            }
            Sought::Other(cosine, sine) => {
                let mut squared = [0.0; 2 * MAX_DEGREE];
                add_product(along, along, sine * sine, &mut squared);
                for across in [u, v] {
                    add_product(across, across, -cosine * cosine, &mut squared);
                }
                roots(&squared[..2 * self.count - 1], NOISE)
            }
        }
    }

    /// The place near a candidate, if the tangent makes the angle there.
    fn confirm(&self, sought: Sought, t: f64, angle: f64) -> Option<f64> {
        let [tangent, _] = self.at(t);
        if tangent.length() <= MIN_SPEED {
            return self.is_cusp_at(t, angle).then_some(t);
        }
        match sought {
            Sought::Right => Some(t),
            Sought::Parallel(sign) => (libm::hypot(tangent.y, tangent.z) <= PARALLEL * tangent.length()
                && sign * tangent.x > 0.0)
                .then_some(t),
            // The sign that the square lost, where it is beyond doubt; else by the equation itself.
            Sought::Other(cosine, _) => {
                let mut at = t;
                for _ in 0..MAX_STEPS {
                    let [tangent, slope] = self.at(at);
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
                    let [tangent, _] = self.at(t);
                    (tangent.x - cosine * tangent.length()).abs() / tangent.length()
                };
                let best = if off(at) < off(t) { at } else { t };
                // A double root of the square may be off by the root of the noise.
                (off(best) <= 1e-7).then_some(best)
            }
        }
    }

    /// True if the tangent before a place where the derivative is 0, or after it, makes the angle.
    fn is_cusp_at(&self, t: f64, angle: f64) -> bool {
        let mut rest = self.components;
        let (mut count, mut sign) = (self.count, 1.0);
        // The first derivative that is not 0 is along the tangent after; before, of the other sign
        // if an odd number of them are 0.
        while count > 0 {
            let value = DVec3::from_array([0, 1, 2].map(|k| value_and_slope(&rest[k][..count], t).0));
            let size = rest.iter().flat_map(|c| &c[..count]).fold(0.0, |most: f64, x| most.max(x.abs()));
            if value.length() > MIN_SPEED * size {
                let makes = |x: f64| (libm::acos(x.clamp(-1.0, 1.0)) - angle).abs() <= CUSP_ANGLE;
                let along = value.x / value.length();
                return (t < 1.0 && makes(along)) || (t > 0.0 && makes(sign * along));
            }
            for c in &mut rest {
                derive(&mut c[..count]);
            }
            (count, sign) = (count - 1, -sign);
        }
        false
    }

    /// Adds the parts of a segment all of whose tangents are along the same line, or at the same
    /// angle or its opposite: those of the right sign.
    fn parts(&self, sought: Sought, segment: u32, intervals: &mut Vec<[Place; 2]>) -> Result<()> {
        let sign = match sought {
            Sought::Right => None,
            Sought::Parallel(sign) => Some(sign),
            Sought::Other(cosine, _) => Some(cosine),
        };
        let turns = roots(self.component(0), NOISE);
        let ends = turns.as_slice().iter().copied().filter(|_| sign.is_some()).chain([1.0]);
        let mut from = 0.0;
        for to in ends.filter(|&t| t > 0.0) {
            let [tangent, _] = self.at(0.5 * (from + to));
            let all_lie = match sought {
                Sought::Parallel(_) => libm::hypot(tangent.y, tangent.z) <= PARALLEL * tangent.length(),
                _ => true,
            };
            if to > from && all_lie && sign.is_none_or(|sign| sign * tangent.x > 0.0) {
                let [from, to] = [from, to].map(|t| Place { segment, t });
                match intervals.last_mut() {
                    Some(last) if is_same(last[1], from) => last[1] = to,
                    _ => alloc::push(intervals, [from, to])?,
                }
            }
            from = to;
        }
        Ok(())
    }
}

/// True for the same place, or both sides of a joint.
fn is_same(a: Place, b: Place) -> bool {
    let is_joint = a.segment + 1 == b.segment && a.t >= 1.0 - SAME_PARAMETER && b.t <= SAME_PARAMETER;
    (a.segment == b.segment && (a.t - b.t).abs() <= SAME_PARAMETER) || is_joint
}

impl TangentAngles {
    /// Adds a place, but for a joint or a root that is there already.
    fn add(&mut self, place: Place) -> Result<()> {
        let mut own = self.places.len();
        while own > 0 && self.places[own - 1].segment == place.segment {
            own -= 1;
        }
        let is_known = |other: &Place| (other.t - place.t).abs() <= SAME_ROOT;
        let is_joint = own.checked_sub(1).is_some_and(|before| is_same(self.places[before], place));
        if is_joint || self.places[own..].iter().any(is_known) {
            return Ok(());
        }
        let at = own + self.places[own..].partition_point(|other| other.t < place.t);
        alloc::reserve(&mut self.places, 1)?;
        self.places.insert(at, place);
        Ok(())
    }

    /// Removes the end of a closed curve if its start is there, and places at the ends of intervals.
    fn close(&mut self, curve: &CurveView<'_>) {
        let last = curve.len() as u32;
        let is_start = |place: &Place| place.segment == 0 && place.t <= SAME_PARAMETER;
        let is_end = |place: &Place| place.segment + 1 == last && place.t >= 1.0 - SAME_PARAMETER;
        let has_start =
            self.places.first().is_some_and(is_start) || self.intervals.first().is_some_and(|part| is_start(&part[0]));
        let ends_inside = self.intervals.last().is_some_and(|part| is_end(&part[1]));
        let (closed, intervals) = (curve.is_closed(), &self.intervals);
        self.places.retain(|place| {
            let doubled = closed && ((has_start && is_end(place)) || (ends_inside && is_start(place)));
            let at_end = |part: &[Place; 2]| part.iter().any(|&end| is_same(end, *place) || is_same(*place, end));
            !doubled && !intervals.iter().any(at_end)
        });
    }
}

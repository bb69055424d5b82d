//! Arc length and its inverse.

use crate::curve::segment::{self, SegmentBuffer, SquaredDistanceSlope};
use crate::curve::unit_frame::UnitFrame;
use crate::curve::{CurveView, Place};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::geom::bernstein::{Roots, bracketed_root};
use gusset_base::job::Job;

const SEGMENTS_PER_REPORT: usize = 1 << 8;

/// The arc lengths of a curve up to each joint, for conversions between places and lengths.
#[derive(Debug, Clone)]
pub struct ArcLengths<'a> {
    curve: CurveView<'a>,
    frame: UnitFrame,
    /// The arc length up to the end of each segment, in the frame.
    length_to_segment_end: Vec<f64>,
}

impl<'a> CurveView<'a> {
    /// Returns the arc length of the whole curve; see [`CurveView::arc_lengths`].
    ///
    /// # Errors
    /// [`Error::OutOfMemory`].
    pub fn length(&self) -> Result<f64> {
        Ok(self.arc_lengths(&Job::default())?.total_length())
    }

    /// Measures all segments. Degrees 1 and 2 have a closed form. Higher degrees use adaptive
    /// Gauss-Legendre integration, to 1e-13 of the length of the segment's control polygon.
    /// O(points).
    ///
    /// # Errors
    /// [`Error::OutOfMemory`], [`Error::Cancelled`].
    pub fn arc_lengths(&self, job: &Job<'_>) -> Result<ArcLengths<'a>> {
        let frame = UnitFrame::from_points(self.points());
        let mut ends = alloc::with_capacity(self.len())?;
        let mut sum = 0.0;
        for (k, controls) in self.segments().enumerate() {
            job.step_every(SEGMENTS_PER_REPORT, k, self.len(), "length of a curve")?;
            sum += SegmentSpeed::new(&frame, controls).integrate_speed(0.0, 1.0);
            ends.push(sum);
        }
        Ok(ArcLengths { curve: *self, frame, length_to_segment_end: ends })
    }
}

impl<'a> ArcLengths<'a> {
    /// Returns the curve.
    pub(crate) fn curve(&self) -> &CurveView<'a> {
        &self.curve
    }

    /// Returns the arc length of the whole curve, in the unit of the points.
    pub fn total_length(&self) -> f64 {
        self.frame.length_from_frame(self.length_to_segment_end.last().copied().unwrap_or(0.0))
    }

    /// Returns the arc length from the start to a place.
    ///
    /// # Errors
    /// [`Error::NoSuchPlace`].
    pub fn length_to(&self, place: Place) -> Result<f64> {
        self.curve.check_place(0, place)?;
        let k = place.segment as usize;
        if place.t == 1.0 {
            return Ok(self.frame.length_from_frame(self.length_to_segment_end[k]));
        }
        let arc = SegmentSpeed::new(&self.frame, self.curve.segment(k));
        Ok(self.frame.length_from_frame(self.length_before_segment(k) + arc.integrate_speed(0.0, place.t)))
    }

    /// Returns the place at an arc length from the start. Lengths below 0 and above the total are
    /// clamped. O(log n), plus a few integrations above degree 2.
    ///
    /// # Errors
    /// [`Error::EmptyCurve`], [`Error::OptionOutOfRange`] (NaN).
    pub fn place_at_length(&self, length: f64) -> Result<Place> {
        Error::require(!length.is_nan(), "length", length, "a number")?;
        if self.curve.is_empty() {
            return Err(Error::EmptyCurve);
        }
        Ok(self.place_at_frame_length(self.frame.length_to_frame(length)))
    }

    /// Returns the place at the fraction k / n of the total length.
    pub(super) fn place_at_fraction(&self, numerator: usize, denominator: usize) -> Place {
        let total = self.length_to_segment_end.last().copied().unwrap_or(0.0);
        self.place_at_frame_length(total * (numerator as f64 / denominator as f64))
    }

    fn place_at_frame_length(&self, length: f64) -> Place {
        // The first segment that ends beyond the length.
        let k =
            self.length_to_segment_end.partition_point(|&end| end < length).min(self.length_to_segment_end.len() - 1);
        let (before, after) = (self.length_before_segment(k), self.length_to_segment_end[k]);
        let segment = k as u32;
        if length <= before {
            return Place { segment, t: 0.0 };
        }
        if length >= after {
            return Place { segment, t: 1.0 };
        }
        let arc = SegmentSpeed::new(&self.frame, self.curve.segment(k));
        let t = bracketed_root(0.0, 1.0, -1.0, |t| (arc.integrate_speed(0.0, t) - (length - before), arc.speed(t)));
        Place { segment, t }
    }

    /// Returns the arc length up to the start of segment `k`.
    fn length_before_segment(&self, k: usize) -> f64 {
        if k == 0 { 0.0 } else { self.length_to_segment_end[k - 1] }
    }
}

/// A segment's derivative: n control points of degree n - 1.
struct SegmentSpeed {
    velocity: SegmentBuffer,
    /// The extrema of the speed, from degree 3 on. Intervals of integration end there, because the
    /// speed has a kink at a cusp, and a kink between an end and the first node is invisible to the
    /// quadrature rule.
    speed_extrema: Roots,
}

impl SegmentSpeed {
    fn new(frame: &UnitFrame, controls: &[DVec3]) -> Self {
        let mut velocity = frame.segment_to_frame(controls);
        velocity.differentiate();
        let turns = if velocity.len() > 2 {
            SquaredDistanceSlope::new(&velocity, DVec3::ZERO).slope_roots()
        } else {
            Roots::default()
        };
        SegmentSpeed { velocity, speed_extrema: turns }
    }

    fn speed(&self, t: f64) -> f64 {
        segment::point_at(&self.velocity, t).length()
    }

    /// Returns the length from parameter `a` to `b`.
    fn integrate_speed(&self, a: f64, b: f64) -> f64 {
        match *self.velocity {
            [v] => v.length() * (b - a),
            [u, v] => quadratic_arc_length(u, v - u, a, b),
            _ => {
                // The length of the control polygon: sum of |B_(i+1) - B_i| = |velocity| / n.
                let polygon: f64 = self.velocity.iter().map(|v| v.length()).sum();
                let error = 1e-13 * polygon / self.velocity.len() as f64;
                let inner = self.speed_extrema.as_slice().iter().filter(|&&t| a < t && t < b);
                let (mut from, mut sum, mut halvings) = (a, 0.0, MAX_HALVINGS);
                for &to in inner.chain(&[b]) {
                    sum += self.integrate_speed_adaptively(
                        from,
                        to,
                        self.integrate_speed_by_gauss(from, to),
                        error * (to - from),
                        &mut halvings,
                    );
                    from = to;
                }
                sum
            }
        }
    }

    /// Halves until the halves agree with the whole, or the limit on halvings is reached. If
    /// control points are so far apart that the speed is noise, the halves never agree.
    fn integrate_speed_adaptively(&self, a: f64, b: f64, whole: f64, error: f64, halvings: &mut u32) -> f64 {
        let middle = 0.5 * (a + b);
        let (left, right) = (self.integrate_speed_by_gauss(a, middle), self.integrate_speed_by_gauss(middle, b));
        if (left + right - whole).abs() <= error || *halvings == 0 || !(a < middle && middle < b) {
            return left + right;
        }
        *halvings -= 1;
        self.integrate_speed_adaptively(a, middle, left, 0.5 * error, halvings)
            + self.integrate_speed_adaptively(middle, b, right, 0.5 * error, halvings)
    }

    fn integrate_speed_by_gauss(&self, a: f64, b: f64) -> f64 {
        let (middle, half) = (0.5 * (a + b), 0.5 * (b - a));
        let pair = |&(x, w): &(f64, f64)| w * (self.speed(middle - half * x) + self.speed(middle + half * x));
        half * GAUSS_NODES_AND_WEIGHTS.iter().map(pair).sum::<f64>()
    }
}

/// The maximum number of halvings for one segment.
const MAX_HALVINGS: u32 = 2000;

/// The positive nodes of the 16-point Gauss-Legendre rule on -1 to 1, and their weights. The nodes
/// are roots of the Legendre polynomial P_16; the weights are 2 / ((1 - x^2) P_16'(x)^2).
const GAUSS_NODES_AND_WEIGHTS: [(f64, f64); 8] = [
    (0.989_400_934_991_649_9, 0.027_152_459_411_754_095),
    (0.944_575_023_073_232_6, 0.062_253_523_938_647_89),
    (0.865_631_202_387_831_8, 0.095_158_511_682_492_78),
    (0.755_404_408_355_003, 0.124_628_971_255_533_87),
    (0.617_876_244_402_643_8, 0.149_595_988_816_576_73),
    (0.458_016_777_657_227_37, 0.169_156_519_395_002_54),
    (0.281_603_550_779_258_9, 0.182_603_415_044_923_6),
    (0.095_012_509_837_637_44, 0.189_450_610_455_068_5),
];

/// Returns the integral of |u + w t| from `a` to `b`, in closed form.
///
/// With k = |w|, the component of the velocity along w is y = u . w / k + k t, and across w it is
/// the constant g = |u x w| / k. The length is the integral of sqrt(y^2 + g^2) dy / k. The integral
/// is split at y = 0 and taken over |y|. Every term is then positive and divided by k before any
/// difference, so that nothing cancels, even for nearly straight parabolas and small k.
fn quadratic_arc_length(u: DVec3, w: DVec3, a: f64, b: f64) -> f64 {
    let k = w.length();
    if k == 0.0 {
        return u.length() * (b - a);
    }
    let along = w / k;
    let (start, across) = (u.dot(along), u.cross(along).length());
    // The parameter where y = 0.
    let turn = -start / k;
    let y = |t: f64| if t == 0.0 { start } else { start + k * t };
    if turn <= a {
        integral_of_speed_from_vertex(y(a).max(0.0), k * (b - a), across, k)
    } else if turn >= b {
        integral_of_speed_from_vertex((-y(b)).max(0.0), k * (b - a), across, k)
    } else {
        integral_of_speed_from_vertex(0.0, k * (turn - a), across, k)
            + integral_of_speed_from_vertex(0.0, k * (b - turn), across, k)
    }
}

/// Returns the integral of sqrt(y^2 + g^2) / k from y to y + step, both at least 0. With s =
/// sqrt(y^2 + g^2), and s' at the other end y', it is half of y' s' - y s + g^2 ln((y' + s') / (y +
/// s)). Here s' - s = step (y' + y) / (s' + s).
fn integral_of_speed_from_vertex(y: f64, step: f64, g: f64, k: f64) -> f64 {
    let far = y + step;
    let (s, t) = ((y * y + g * g).sqrt(), (far * far + g * g).sqrt());
    if t == 0.0 {
        return 0.0;
    }
    let growth = (far + y) / (t + s);
    let straight = t + y * growth;
    let bent = if g == 0.0 { 0.0 } else { g * g * libm::log1p(step * (1.0 + growth) / (y + s)) };
    0.5 * (step * straight + bent) / k
}

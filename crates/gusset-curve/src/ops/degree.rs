//! Degree elevation, which preserves the curve, and degree reduction by least squares.
//!
//! Source: degree elevation, and products of Bernstein polynomials (Farouki and Rajan, 1988).

use crate::curve::segment::SegmentBuffer;
use crate::curve::unit_frame::UnitFrame;
use crate::curve::{Curve, CurveView, MAX_DEGREE};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::{Allowed, Error, Result};
use gusset_base::geom::bernstein::binomial_row;
use gusset_base::geom::linear::cholesky;
use gusset_base::job::Job;

/// Segments between two progress reports.
const SEGMENTS_PER_REPORT: usize = 1 << 8;

/// A curve with changed degrees.
#[derive(Debug, Clone, PartialEq)]
pub struct CurveOfReducedDegree {
    /// The curve. Its segments correspond to the original ones, in order.
    pub curve: Curve,
    /// For each segment a bound of the distance between new and original points at equal
    /// parameters. The bound is the largest distance between the control points at equal degree.
    /// For a segment that was kept, it is the rejected fit's deviation. It is 0 for a segment that
    /// needed no reduction.
    pub deviations: Vec<f64>,
    /// The segments that were kept unchanged, because their deviation would exceed the tolerance.
    pub kept: Vec<u32>,
}

fn check_degree(degree: usize) -> Result<()> {
    Error::require((1..=MAX_DEGREE).contains(&degree), "degree", degree as f64, 1.0..=MAX_DEGREE as f64)
}

impl CurveView<'_> {
    /// Elevates the degree of every segment by `by`. The curve stays the same.
    ///
    /// # Errors
    /// [`Error::OptionOutOfRange`] (a degree would exceed [`MAX_DEGREE`]), [`Error::TooLarge`],
    /// [`Error::OutOfMemory`], [`Error::Cancelled`]. O(degree) for each new control point.
    pub fn with_degree_elevated_by(&self, by: usize, job: &Job<'_>) -> Result<Curve> {
        self.elevate_each_segment(|degree| degree.saturating_add(by), job)
    }

    /// Elevates every segment to at least `degree`, 1 to [`MAX_DEGREE`]. Higher degrees stay.
    ///
    /// # Errors
    /// The errors of [`with_degree_elevated_by`](Self::with_degree_elevated_by).
    pub fn with_degree_elevated_to(&self, degree: usize, job: &Job<'_>) -> Result<Curve> {
        check_degree(degree)?;
        self.elevate_each_segment(|old| old.max(degree), job)
    }

    fn elevate_each_segment(&self, degree: impl Fn(usize) -> usize, job: &Job<'_>) -> Result<Curve> {
        let mut curve = self.empty_curve_at_start()?;
        for (k, controls) in self.segments().enumerate() {
            job.step_every(SEGMENTS_PER_REPORT, k, self.len(), "raising degrees")?;
            let to = degree(controls.len() - 1);
            check_degree(to)?;
            curve.push_elevated(controls, to)?;
        }
        Ok(curve)
    }

    /// Reduces every segment to at most `degree`, 1 to [`MAX_DEGREE`]; see
    /// [`with_degrees`](Self::with_degrees).
    ///
    /// # Errors
    /// The errors of [`with_degrees`](Self::with_degrees).
    pub fn with_reduced_degree(&self, degree: usize, tolerance: f64, job: &Job<'_>) -> Result<CurveOfReducedDegree> {
        self.with_degrees([1, degree], tolerance, job)
    }

    /// Brings the degree of every segment into the range `lowest` to `highest`, within 1 to
    /// [`MAX_DEGREE`]. A segment of lower degree is elevated to `lowest`, which preserves it.
    ///
    /// A segment of higher degree is reduced to `highest`: it becomes the segment with the same
    /// ends and the least mean square distance at equal parameters. A segment is kept if it would
    /// deviate by more than `tolerance`, which is at least 0 and in the unit of the points;
    /// infinity is allowed. Joints may become corners within the deviation.
    ///
    /// # Errors
    /// [`Error::OptionOutOfRange`] (a degree, or `tolerance`), [`Error::TooLarge`],
    /// [`Error::OutOfMemory`], [`Error::Cancelled`]. O(degree) for each new control point of an
    /// elevated segment, O(degree^3) for each reduced segment.
    pub fn with_degrees(
        &self,
        [lowest, highest]: [usize; 2],
        tolerance: f64,
        job: &Job<'_>,
    ) -> Result<CurveOfReducedDegree> {
        check_degree(lowest)?;
        check_degree(highest)?;
        Error::require(lowest <= highest, "lowest", lowest as f64, Allowed::AtMost(highest as f64))?;
        Error::require(tolerance >= 0.0, "tolerance", tolerance, "at least 0")?;
        let mut reduced = CurveOfReducedDegree {
            curve: self.empty_curve_at_start()?,
            deviations: alloc::with_capacity(self.len())?,
            kept: vec![],
        };
        for (k, controls) in self.segments().enumerate() {
            job.step_every(SEGMENTS_PER_REPORT, k, self.len(), "changing degrees")?;
            if controls.len() - 1 <= highest {
                reduced.deviations.push(0.0);
                reduced.curve.push_elevated(controls, lowest)?;
                continue;
            }
            let frame = UnitFrame::from_points(controls);
            let local = frame.segment_to_frame(controls);
            let fitted = fit_degree_by_least_squares(&local, highest);
            let deviation = frame.length_from_frame(max_control_point_deviation(&local, fitted));
            reduced.deviations.push(deviation);
            if deviation > tolerance || deviation == f64::INFINITY {
                alloc::push(&mut reduced.kept, k as u32)?;
                reduced.curve.push_segment(&controls[1..])?;
                continue;
            }
            let mut back = SegmentBuffer::from_mapped(&fitted, |p| frame.point_from_frame(p));
            back[highest] = controls[controls.len() - 1];
            reduced.curve.push_segment(&back[1..])?;
        }
        Ok(reduced)
    }

    /// Creates an empty curve at the start of this one.
    fn empty_curve_at_start(&self) -> Result<Curve> {
        let Some(&start) = self.points().first() else {
            return self.to_owned();
        };
        Ok(Curve { closed: self.is_closed(), ..Curve::from_point(start)? })
    }
}

impl Curve {
    /// Appends a segment, elevated to `degree` if its degree is lower.
    fn push_elevated(&mut self, controls: &[DVec3], degree: usize) -> Result<()> {
        if controls.len() > degree {
            return self.push_segment(&controls[1..]);
        }
        let mut elevated = SegmentBuffer::new(controls);
        elevated.elevate(degree);
        self.push_segment(&elevated[1..])
    }
}

/// Returns the largest distance between the control points of two segments, after elevating the
/// second to the first one's degree. By the convex hull property it bounds the distance at equal
/// parameters.
fn max_control_point_deviation(controls: &[DVec3], mut fitted: SegmentBuffer) -> f64 {
    fitted.elevate(controls.len() - 1);
    let distance = |(&p, &q): (&DVec3, &DVec3)| p.distance(q);
    // A fit that is NaN is useless.
    let farther = |most: f64, far: f64| if far.is_nan() { f64::INFINITY } else { most.max(far) };
    controls.iter().zip(&*fitted).map(distance).fold(0.0, farther)
}

/// Returns the segment of degree m with the ends of `controls` and the least integral of the
/// squared distance. It solves the normal equations of the inner control points by Cholesky's
/// method. Their coefficients are integrals of products of Bernstein polynomials of degrees m and
/// n:
///
/// the integral of b_i b_j = C(m, i) C(m, j) / C(m + n, i + j) / (m + n + 1).
fn fit_degree_by_least_squares(controls: &[DVec3], degree: usize) -> SegmentBuffer {
    let n = controls.len() - 1;
    let mut fitted = SegmentBuffer::new(&controls[..=degree]);
    fitted[degree] = controls[n];
    let row = binomial_row::<{ 2 * MAX_DEGREE + 1 }>;
    let (own, given, own_own, own_given) = (row(degree), row(n), row(2 * degree), row(degree + n));
    let product = |i: usize, j: usize| own[i] * own[j] / own_own[i + j] / (2 * degree + 1) as f64;
    let mut lower = [[0.0; MAX_DEGREE]; MAX_DEGREE];
    for i in 1..degree {
        let weight = |k: usize| own[i] * given[k] / own_given[i + k] / (degree + n + 1) as f64;
        let right: DVec3 = controls.iter().enumerate().map(|(k, &p)| p * weight(k)).sum();
        fitted[i] = right - (fitted[0] * product(i, 0) + fitted[degree] * product(i, degree));
        (1..=i).for_each(|j| lower[i - 1][j - 1] = product(i, j));
    }
    // If rounding makes the matrix indefinite (from degree 25 on), the deviation will show it.
    cholesky::solve(&mut lower, &mut fitted[1..degree]);
    fitted
}

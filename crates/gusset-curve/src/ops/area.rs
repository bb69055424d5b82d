//! Area and moments of the region that a curve encloses. The chord closes an open curve.
//!
//! With r measured from the curve's start, the region is swept in triangles (0, r, r + dr) of area
//! r x dr / 2 (Green's theorem). The mean of a triangle's points is 2 r / 3, and the mean of their
//! products is r r^T / 2. With W dt = r x dr,
//!
//! - area = 1/2 of the integral of W,
//! - first moment = 1/3 of the integral of r W,
//! - second moment = 1/4 of the integral of r r^T W.
//!
//! All integrands are polynomials in t, which are integrated exactly. The chord back to the start
//! adds nothing.

use crate::curve::segment::SegmentBuffer;
use crate::curve::unit_frame::UnitFrame;
use crate::curve::{CurveView, MAX_DEGREE};
use glam::DVec3;
use gusset_base::error::Result;
use gusset_base::geom::bernstein::{add_product, integral, integral_of_product};
use gusset_base::job::Job;

/// Segments between two progress reports.
const SEGMENTS_PER_REPORT: usize = 1 << 8;

/// The moments of the region that a plane curve encloses. Parts that the curve traverses clockwise
/// count as negative. Parts that it traverses twice count twice.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AreaMoments {
    /// The area, positive if the curve runs counter-clockwise.
    pub area: f64,
    /// The centre of gravity; the curve's start if the area is 0.
    pub centroid: DVec3,
    /// The integrals of x x, x y and y y about the centroid, with the sign of the area.
    pub second: [f64; 3],
}

/// Returns the components of the control points relative to `start`, in the frame, and of the
/// derivative.
fn control_and_derivative_components(
    frame: &UnitFrame,
    start: DVec3,
    controls: &[DVec3],
) -> [[[f64; MAX_DEGREE + 1]; 3]; 2] {
    let r = SegmentBuffer::from_mapped(controls, |p| frame.point_to_frame(p) - start);
    let mut d = r;
    d.differentiate();
    [r, d].map(|points| {
        let mut components = [[0.0; MAX_DEGREE + 1]; 3];
        for (i, p) in points.iter().enumerate() {
            (0..3).for_each(|axis| components[axis][i] = p[axis]);
        }
        components
    })
}

impl CurveView<'_> {
    /// Returns the area vector: half the integral of r x dr. For a plane curve it is (0, 0, signed
    /// area). In space, its component along a direction is the area of the projection along that
    /// direction. The chord from end to start closes an open curve. Exact up to rounding. O(sum of
    /// degree^2).
    ///
    /// # Errors
    /// [`Cancelled`](gusset_base::Error::Cancelled).
    pub fn area_vector(&self, job: &Job<'_>) -> Result<DVec3> {
        let frame = UnitFrame::from_points(self.points());
        let Some(&start) = self.points().first() else {
            return Ok(DVec3::ZERO);
        };
        let mut doubled = DVec3::ZERO;
        for (k, controls) in self.segments().enumerate() {
            job.step_every(SEGMENTS_PER_REPORT, k, self.len(), "area of a curve")?;
            let n = controls.len() - 1;
            let [r, d] = control_and_derivative_components(&frame, frame.point_to_frame(start), controls);
            let swept = |a: usize, b: usize| {
                integral_of_product(&r[a][..=n], &d[b][..n]) - integral_of_product(&r[b][..=n], &d[a][..n])
            };
            doubled += DVec3::new(swept(1, 2), swept(2, 0), swept(0, 1));
        }
        Ok((doubled * 0.5).map(|x| frame.length_from_frame(frame.length_from_frame(x))))
    }

    /// Returns the area, centroid and second moments of the region that a plane curve encloses.
    /// Exact up to rounding. O(sum of degree^2).
    ///
    /// # Errors
    /// [`CurveNotPlane`](gusset_base::Error::CurveNotPlane),
    /// [`EmptyCurve`](gusset_base::Error::EmptyCurve),
    /// [`Cancelled`](gusset_base::Error::Cancelled).
    pub fn moments(&self, job: &Job<'_>) -> Result<AreaMoments> {
        self.check_not_empty()?;
        self.check_in_xy_plane()?;
        let frame = UnitFrame::from_points(self.points());
        let start = frame.point_to_frame(self.points()[0]);
        let (mut area, mut first, mut second) = (0.0, [0.0; 2], [0.0; 3]);
        for (k, controls) in self.segments().enumerate() {
            job.step_every(SEGMENTS_PER_REPORT, k, self.len(), "moments of a curve")?;
            let n = controls.len() - 1;
            let [r, d] = control_and_derivative_components(&frame, start, controls);
            let (x, y) = (&r[0][..=n], &r[1][..=n]);
            let mut swept = [0.0; 2 * MAX_DEGREE];
            let swept = &mut swept[..2 * n];
            add_product(x, &d[1][..n], 1.0, swept);
            add_product(y, &d[0][..n], -1.0, swept);
            area += integral(swept) / 2.0;
            first[0] += integral_of_product(x, swept) / 3.0;
            first[1] += integral_of_product(y, swept) / 3.0;
            for (sum, (a, b)) in second.iter_mut().zip([(x, x), (x, y), (y, y)]) {
                let mut square = [0.0; 2 * MAX_DEGREE + 1];
                add_product(a, b, 1.0, &mut square[..=2 * n]);
                *sum += integral_of_product(&square[..=2 * n], swept) / 4.0;
            }
        }
        let [x, y] = if area == 0.0 { [0.0; 2] } else { first.map(|f| f / area) };
        // The parallel axis theorem: second about the centroid = second about the start - area c
        // c^T.
        let central = [second[0] - x * first[0], second[1] - x * first[1], second[2] - y * first[1]];
        let back = |x: f64, power: u32| (0..power).fold(x, |x, _| frame.length_from_frame(x));
        Ok(AreaMoments {
            area: back(area, 2),
            centroid: if area == 0.0 {
                self.points()[0]
            } else {
                frame.point_from_frame(start + DVec3::new(x, y, 0.0))
            },
            second: central.map(|x| back(x, 4)),
        })
    }
}

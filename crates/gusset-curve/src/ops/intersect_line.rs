//! Intersections of a curve with a plane, and of a plane curve with a line. They are the roots of
//! the distance, which is a polynomial in Bernstein form on each segment.

use crate::curve::unit_frame::{UnitFrame, power_of_two_to_unit_size};
use crate::curve::{CurveView, MAX_DEGREE, Place, check_finite};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::geom::bernstein::roots;
use gusset_base::job::Job;

/// Segments between two progress reports.
const SEGMENTS_PER_REPORT: usize = 1 << 10;

/// The intersections of a curve with a line or a plane.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct PlaneIntersections {
    /// Places of crossing or touching, once each, in the order of the curve. A joint belongs to the
    /// segment that ends there. The closing point of a closed curve belongs to its start.
    pub places: Vec<Place>,
    /// The segments that lie entirely in the line or plane; their points are not among the places.
    pub inside: Vec<u32>,
}

/// Distances up to this count as 0, relative to the size of the curve.
const MAX_TOUCH_DISTANCE: f64 = 1.0 / (1u64 << 46) as f64;

impl CurveView<'_> {
    /// Intersects the curve with the plane through `point` perpendicular to `normal`, which need
    /// not have length 1. The curve touches the plane where its distance is at most 1.4e-14 of its
    /// size. Roots of the distance have a closed form up to degree 2 and are isolated otherwise.
    /// O(points), plus O(degree^2) for each intersection.
    ///
    /// # Errors
    /// [`Error::OptionOutOfRange`] (a normal of length 0), [`Error::NotFinite`] (point 0 is
    /// `point`, 1 is `normal`), [`Error::OutOfMemory`], [`Error::Cancelled`].
    pub fn intersect_plane(&self, point: DVec3, normal: DVec3, job: &Job<'_>) -> Result<PlaneIntersections> {
        check_finite(0, point)?;
        check_finite(1, normal)?;
        let largest = normal.abs().max_element();
        Error::require(largest > 0.0, "normal", largest, "a vector other than 0")?;
        let frame = UnitFrame::from_points(self.points());
        let level = plane_distance_from_frame_origin(&frame, point, normal);
        let normal = (normal / largest).normalize();
        let mut found = PlaneIntersections::default();
        // The plane is farther away than any point of the curve; NaN if it is too far for the
        // frame.
        if level.abs() > 2.0 || level.is_nan() {
            return Ok(found);
        }
        for (k, controls) in self.segments().enumerate() {
            job.step_every(SEGMENTS_PER_REPORT, k, self.len(), "crossings with a plane")?;
            let mut heights = [0.0; MAX_DEGREE + 1];
            for (height, &p) in heights.iter_mut().zip(controls) {
                *height = normal.dot(frame.point_to_frame(p)) - level;
            }
            let at = roots(&heights[..controls.len()], MAX_TOUCH_DISTANCE);
            if at.everywhere {
                alloc::push(&mut found.inside, k as u32)?;
            }
            for &t in at.as_slice() {
                found.add_root(k as u32, t)?;
            }
        }
        found.remove_repeated_places(self);
        Ok(found)
    }

    /// Intersects a plane curve with the infinite line through `point` along `direction`. See
    /// [`intersect_plane`](Self::intersect_plane).
    ///
    /// # Errors
    /// [`Error::CurveNotPlane`] (the curve, or point or direction as points 0 and 1 of the line,
    /// have z other than 0), and the errors of [`intersect_plane`](Self::intersect_plane).
    pub fn intersect_line(&self, point: DVec3, direction: DVec3, job: &Job<'_>) -> Result<PlaneIntersections> {
        self.check_in_xy_plane()?;
        check_finite(0, point)?;
        check_finite(1, direction)?;
        if let Some((index, z)) = (0..).zip([point.z, direction.z]).find(|&(_, z)| z != 0.0) {
            return Err(Error::CurveNotPlane { point: index, z });
        }
        self.intersect_plane(point, DVec3::new(-direction.y, direction.x, 0.0), job)
    }
}

/// Returns the distance of a plane from the origin of a frame, along its normal. It is exact up to
/// rounding even for a distant point: the terms of normal . (point - origin) may cancel by any
/// number of digits, so they are summed without error (Dekker's products, Shewchuk's expansions,
/// 1997).
fn plane_distance_from_frame_origin(frame: &UnitFrame, point: DVec3, normal: DVec3) -> f64 {
    let normal = normal * power_of_two_to_unit_size(normal.abs().max_element());
    let (mut sum, mut len) = ([0.0; 12], 0);
    for part in frame.point_to_frame_with_rounding_error(point) {
        for axis in 0..3 {
            let product = normal[axis] * part[axis];
            for mut term in [normal[axis].mul_add(part[axis], -product), product] {
                for digits in &mut sum[..len] {
                    let rounded = term + *digits;
                    let back = rounded - term;
                    *digits = (term - (rounded - back)) + (*digits - back);
                    term = rounded;
                }
                sum[len] = term;
                len += 1;
            }
        }
    }
    sum.iter().sum::<f64>() / normal.length()
}

impl PlaneIntersections {
    /// Adds a root. Skips the start of a segment if the previous segment's end is listed or lies
    /// inside.
    fn add_root(&mut self, segment: u32, t: f64) -> Result<()> {
        if t == 0.0 && segment > 0 {
            let before = Place { segment: segment - 1, t: 1.0 };
            if self.places.last() == Some(&before) || self.inside.last() == Some(&before.segment) {
                return Ok(());
            }
        }
        alloc::push(&mut self.places, Place { segment, t })
    }

    /// Removes places that belong to the start of a closed curve, or to a segment inside that
    /// follows.
    fn remove_repeated_places(&mut self, curve: &CurveView<'_>) {
        let last = curve.len() as u32;
        let start = Place::START;
        let has_start = self.places.first() == Some(&start);
        let first_inside = self.inside.first() == Some(&0);
        if curve.is_closed() && has_start && self.inside.last().is_some_and(|&k| k + 1 == last) {
            self.places.remove(0);
        }
        let inside = &self.inside;
        self.places.retain(|place| {
            let at_end = curve.is_closed() && place.segment + 1 == last && place.t == 1.0;
            let next_inside = place.t == 1.0 && inside.binary_search(&(place.segment + 1)).is_ok();
            !(at_end && (has_start || first_inside) || next_inside)
        });
    }
}

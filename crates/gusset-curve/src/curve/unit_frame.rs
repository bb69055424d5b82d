//! The unit frame of a curve: coordinates in which it is near the origin and has a size of about 1.
//!
//! x' = (x 2^a - o) 2^b. The first scaling brings the coordinates below 1, so that the difference
//! from the centre o cannot overflow. The second scaling normalises the extent. Powers of 2 do not
//! change any digits.

use super::segment::SegmentBuffer;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::Aabb;

/// A translation and a scaling by a power of 2.
#[derive(Debug, Clone, Copy)]
pub(crate) struct UnitFrame {
    scale_before_translation: f64,
    origin: DVec3,
    scale_after_translation: f64,
}

/// Returns the power of 2 that scales `x` into 1/2 .. 1, or as close as a normal number can.
pub(crate) fn power_of_two_to_unit_size(x: f64) -> f64 {
    let (_, exponent) = libm::frexp(x);
    libm::ldexp(1.0, (-exponent).clamp(-1022, 1022))
}

impl UnitFrame {
    /// Returns the frame of the bounding box of some finite points.
    pub(crate) fn from_points<'a>(points: impl IntoIterator<Item = &'a DVec3>) -> Self {
        let whole = Aabb::from_points(points);
        let Aabb { low, high } = if whole.low.is_finite() { whole } else { Aabb::from_points([DVec3::ZERO]) };
        let coarse = power_of_two_to_unit_size(low.abs().max(high.abs()).max_element());
        let (low, high) = (low * coarse, high * coarse);
        UnitFrame {
            scale_before_translation: coarse,
            origin: low * 0.5 + high * 0.5,
            scale_after_translation: power_of_two_to_unit_size((high - low).max_element() * 0.5),
        }
    }

    /// Transforms a point into the frame. The components of the points that define the frame become
    /// at most 1.
    pub(crate) fn point_to_frame(&self, p: DVec3) -> DVec3 {
        (p * self.scale_before_translation - self.origin) * self.scale_after_translation
    }

    /// Transforms a point like [`point_to_frame`](Self::point_to_frame), and returns the rounding
    /// error as well.
    pub(crate) fn point_to_frame_with_rounding_error(&self, p: DVec3) -> [DVec3; 2] {
        let (given, origin) = (p * self.scale_before_translation, self.origin);
        let rounded = given - origin;
        // Knuth's TwoSum.
        let back = rounded - given;
        let remainder = (given - (rounded - back)) - (origin + back);
        [rounded * self.scale_after_translation, remainder * self.scale_after_translation]
    }

    pub(crate) fn points_to_frame(&self, points: &[DVec3]) -> Result<Vec<DVec3>> {
        alloc::collect(points.iter().map(|&p| self.point_to_frame(p)))
    }

    /// Transforms the control points of a segment into the frame.
    pub(crate) fn segment_to_frame(&self, controls: &[DVec3]) -> SegmentBuffer {
        SegmentBuffer::from_mapped(controls, |p| self.point_to_frame(p))
    }

    /// Transforms a point from the frame into the host's coordinates.
    pub(crate) fn point_from_frame(&self, p: DVec3) -> DVec3 {
        (p / self.scale_after_translation + self.origin) / self.scale_before_translation
    }

    pub(crate) fn length_to_frame(&self, x: f64) -> f64 {
        x * self.scale_before_translation * self.scale_after_translation
    }

    /// Converts a length from the frame into the host's unit.
    pub(crate) fn length_from_frame(&self, x: f64) -> f64 {
        x / self.scale_after_translation / self.scale_before_translation
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn any_size_becomes_one_and_is_restored() {
        for scale in [1.0, 1e200, 1e-200, 1e308, 1e-310] {
            let points = [DVec3::new(1.0, -1.0, 0.5) * scale, DVec3::new(0.25, 1.5, 0.5) * scale];
            let frame = UnitFrame::from_points(&points);
            for p in points {
                let local = frame.point_to_frame(p);
                assert!(local.abs().max_element() <= 1.0, "{scale}: {local}");
                assert!((frame.point_from_frame(local) - p).abs().max_element() <= 1e-15 * scale, "{scale}");
            }
            let length = frame.length_to_frame(scale);
            assert!((scale < 1e-300 || (0.2..4.0).contains(&length)) && frame.length_from_frame(length) == scale);
        }
        let same = [DVec3::splat(3.0); 2];
        assert_eq!(UnitFrame::from_points(&same).point_to_frame(same[0]), DVec3::ZERO);
    }
}

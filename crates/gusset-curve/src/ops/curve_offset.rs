//! The offset of a plane curve, fitted by Bézier segments.
//!
//! With the unit tangent T and the left normal N, the offset at distance d is O = C + d N. Its
//! derivative is O' = C' + d N', where N' is T' turned by a quarter, and T' = (C'' - T (T . C'')) /
//! |C'|. O' is parallel to T with 1 - k d times the speed of C, for the curvature k. The offset
//! therefore runs backwards where the radius of curvature 1 / k is smaller than d.
//!
//! A cubic piece matches both ends and both derivatives of O, with an error of order h^4. A
//! quadratic piece matches both ends and both directions. Either way, pieces join with a common
//! tangent. Pieces are halved until the measured deviation is small enough.

use super::evaluate::unit_tangent;
use crate::curve::segment::{self, point_and_derivatives};
use crate::curve::unit_frame::UnitFrame;
use crate::curve::{Curve, CurveView};
use glam::DVec3;
use gusset_base::error::{Error, Result};
use gusset_base::job::Job;

/// The options of an offset.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OffsetOptions {
    /// The degree of the result's segments, 2 or 3.
    pub degree: usize,
    /// The target deviation, above 0, in the unit of the points. Deviations below 1e-13 of the size
    /// and the distance cannot be reached.
    pub tolerance: f64,
    /// Halving stops at this number of segments, at least 1. The result has more segments if the
    /// curve itself needs more.
    pub max_segments: usize,
}

/// An offset curve.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Offset {
    /// The curve. It may intersect itself; parts closer to the original than the distance are not
    /// trimmed.
    pub curve: Curve,
    /// The largest deviation from the true offset at 16 places inside each segment, in the unit of
    /// the points.
    pub deviation: f64,
    /// False if the tolerance was not reached; see [`OffsetOptions::max_segments`].
    pub reached: bool,
    /// True if the radius of curvature on the side of the offset is somewhere at most the distance.
    /// The offset then has cusps or runs backwards there.
    pub tight: bool,
    /// The number of corners of the original. A straight segment joins the pieces at each corner.
    pub corners: usize,
}

/// The maximum number of times that a piece is halved.
const MAX_PIECE_HALVINGS: u32 = 16;
const PIECES_PER_REPORT: usize = 1 << 6;
const PROGRESS_STAGE: &str = "offset";
/// The number of places inside a piece where the deviation is measured.
const SAMPLES_PER_PIECE: u32 = 16;

impl CurveView<'_> {
    /// Offsets a plane curve by `distance` to the left, looking along the curve with y to the left
    /// of x. A negative distance offsets to the right. Segments without extent are skipped.
    /// O(degree) for each measured place.
    ///
    /// # Errors
    /// [`Error::CurveNotPlane`], [`Error::EmptyCurve`] (all segments lack an extent),
    /// [`Error::OptionOutOfRange`] (the distance is not finite or beyond 1e100 sizes of the curve;
    /// an option), [`Error::TooLarge`], [`Error::OutOfMemory`], [`Error::Cancelled`].
    pub fn offset(&self, distance: f64, options: &OffsetOptions, job: &Job<'_>) -> Result<Offset> {
        self.check_in_xy_plane()?;
        let frame = UnitFrame::from_points(self.points());
        let d = frame.length_to_frame(distance);
        Error::require(d.abs() <= 1e100, "distance", distance, "at most 1e100 times the curve's size")?;
        Error::require(options.tolerance > 0.0, "tolerance", options.tolerance, "above 0")?;
        Error::require((2..=3).contains(&options.degree), "degree", options.degree as f64, "2 or 3")?;
        Error::require(options.max_segments > 0, "max_segments", options.max_segments as f64, "at least 1")?;
        let mut fit = OffsetFitter {
            job: *job,
            frame,
            d,
            tolerance: frame.length_to_frame(options.tolerance).max(1e-13 * (1.0 + d.abs())),
            options: *options,
            pieces: 0,
            end_of_last_segment: DVec3::ZERO,
            offset: Offset::default(),
        };
        for (k, controls) in self.segments().enumerate() {
            if controls.iter().all(|&p| p == controls[0]) {
                continue;
            }
            fit.job = job.sub_job_of_item(k, self.len());
            fit.offset_segment(&frame.segment_to_frame(controls))?;
        }
        job.step(1.0, PROGRESS_STAGE)?;
        fit.finish(self.is_closed())
    }
}

/// A point of the true offset, with derivatives.
#[derive(Clone, Copy)]
struct OffsetPoint {
    t: f64,
    point: DVec3,
    /// The unit tangent T.
    unit_tangent: DVec3,
    /// The derivative O'.
    speed: DVec3,
}

struct OffsetFitter<'a> {
    /// The current segment's part of the job.
    job: Job<'a>,
    frame: UnitFrame,
    d: f64,
    tolerance: f64,
    options: OffsetOptions,
    /// The number of segments so far, not counting corners.
    pieces: usize,
    /// The end of the last segment, in the frame.
    end_of_last_segment: DVec3,
    /// The result so far; its deviation is in the frame.
    offset: Offset,
}

/// Rotates by a quarter turn to the left.
fn rotate_left_quarter_turn(v: DVec3) -> DVec3 {
    DVec3::new(-v.y, v.x, 0.0)
}

impl OffsetFitter<'_> {
    fn offset_segment(&mut self, controls: &[DVec3]) -> Result<()> {
        let (start, end) = (self.offset_point_at(controls, 0.0), self.offset_point_at(controls, 1.0));
        self.begin_or_bridge_corner(start.point)?;
        self.fit_piece(controls, start, end, MAX_PIECE_HALVINGS)
    }

    /// Begins the curve, or bridges a corner by a straight segment.
    fn begin_or_bridge_corner(&mut self, at: DVec3) -> Result<()> {
        let curve = &mut self.offset.curve;
        if curve.points.is_empty() {
            *curve = Curve::from_point(self.frame.point_from_frame(at))?;
        } else if self.end_of_last_segment.distance(at) > 1e-9 * (1.0 + self.d.abs()) {
            self.offset.corners += 1;
            curve.push_segment(
                &straight_controls(self.end_of_last_segment, at, self.options.degree, &self.frame)
                    [..self.options.degree],
            )?;
        }
        self.end_of_last_segment = at;
        Ok(())
    }

    fn offset_point_at(&mut self, controls: &[DVec3], t: f64) -> OffsetPoint {
        let [point, first, second] = point_and_derivatives(controls, t);
        let along = unit_tangent(controls, t);
        let pace = first.length();
        let speed = if pace > 1e-13 {
            first + rotate_left_quarter_turn((second - along * along.dot(second)) / pace) * self.d
        } else {
            // The curve itself has a cusp here.
            self.offset.tight = true;
            DVec3::ZERO
        };
        self.offset.tight |= speed.dot(along) <= 0.0;
        OffsetPoint { t, point: point + rotate_left_quarter_turn(along) * self.d, unit_tangent: along, speed }
    }

    /// Fits a piece, or its halves if the fit is not close enough.
    fn fit_piece(&mut self, controls: &[DVec3], from: OffsetPoint, to: OffsetPoint, depth: u32) -> Result<()> {
        let degree = self.options.degree;
        let fitted = if degree == 2 { quadratic_between(&from, &to) } else { Some(cubic_between(&from, &to)) };
        let mut measure = |fitted: [DVec3; 4]| self.max_deviation(controls, &from, &to, &fitted[..=degree]);
        let deviation = fitted.map_or(f64::INFINITY, &mut measure);
        if deviation > self.tolerance && depth > 0 && self.pieces + 1 < self.options.max_segments {
            let middle = self.offset_point_at(controls, 0.5 * (from.t + to.t));
            self.fit_piece(controls, from, middle, depth - 1)?;
            return self.fit_piece(controls, middle, to, depth - 1);
        }
        let fitted = fitted.unwrap_or_else(|| [from.point, from.point.midpoint(to.point), to.point, to.point]);
        if self.pieces.is_multiple_of(PIECES_PER_REPORT) {
            self.job.step(from.t, PROGRESS_STAGE)?;
        }
        let deviation = if deviation.is_finite() {
            deviation
        } else {
            self.max_deviation(controls, &from, &to, &fitted[..=degree])
        };
        self.offset.deviation = self.offset.deviation.max(deviation);
        self.pieces += 1;
        self.end_of_last_segment = to.point;
        self.offset.curve.push_segment(&fitted.map(|p| self.frame.point_from_frame(p))[1..=degree])
    }

    /// Returns the largest distance of the piece from the true offset. Each sample is compared with
    /// the offset at the same parameter. It is also compared at the foot point, found by one Newton
    /// step for (C - Q) . C' = 0, and the smaller distance counts.
    fn max_deviation(&mut self, controls: &[DVec3], from: &OffsetPoint, to: &OffsetPoint, fitted: &[DVec3]) -> f64 {
        let mut max = 0.0f64;
        for k in 1..=SAMPLES_PER_PIECE {
            let u = f64::from(k) / f64::from(SAMPLES_PER_PIECE + 1);
            let q = segment::point_at(fitted, u);
            let mut spot = self.offset_point_at(controls, from.t + (to.t - from.t) * u);
            let mut min = spot.point.distance(q);
            for _ in 0..2 {
                let step = (q - spot.point).dot(spot.unit_tangent) / spot.speed.dot(spot.unit_tangent);
                let t = (spot.t + step).clamp(from.t, to.t);
                if !t.is_finite() {
                    break;
                }
                spot = self.offset_point_at(controls, t);
                min = min.min(spot.point.distance(q));
            }
            max = max.max(min);
        }
        max
    }

    fn finish(mut self, closed: bool) -> Result<Offset> {
        let Some(&start) = self.offset.curve.points.first() else {
            return Err(Error::EmptyCurve);
        };
        if closed {
            self.begin_or_bridge_corner(self.frame.point_to_frame(start))?;
            let curve = &mut self.offset.curve;
            curve.closed = true;
            curve.points.pop();
            curve.points.push(start);
        }
        let deviation = self.offset.deviation;
        Ok(Offset {
            deviation: self.frame.length_from_frame(deviation),
            reached: deviation <= self.tolerance,
            ..self.offset
        })
    }
}

/// Returns the control points of a straight segment except the first.
fn straight_controls(a: DVec3, b: DVec3, degree: usize, frame: &UnitFrame) -> [DVec3; 3] {
    [1, 2, 3].map(|k| {
        if k == degree {
            frame.point_from_frame(b)
        } else {
            frame.point_from_frame(a.lerp(b, k as f64 / degree as f64))
        }
    })
}

/// Returns the cubic with the given ends and derivatives.
fn cubic_between(from: &OffsetPoint, to: &OffsetPoint) -> [DVec3; 4] {
    let third = (to.t - from.t) / 3.0;
    [from.point, from.point + from.speed * third, to.point - to.speed * third, to.point]
}

/// Returns the quadratic with the given ends and directions; its last control point is repeated.
/// The inner control point is where the tangents cross, if that is ahead of the first end and
/// behind the last. For a straight piece it is the middle.
fn quadratic_between(from: &OffsetPoint, to: &OffsetPoint) -> Option<[DVec3; 4]> {
    let chord = to.point - from.point;
    let cross = |a: DVec3, b: DVec3| a.x * b.y - a.y * b.x;
    let turn = cross(from.unit_tangent, to.unit_tangent);
    let length = chord.length();
    if turn.abs() < 1e-12 {
        let aligned = cross(from.unit_tangent, chord).abs() <= 1e-12 * length;
        return aligned.then_some([from.point, from.point + chord * 0.5, to.point, to.point]);
    }
    let (ahead, behind) = (cross(chord, to.unit_tangent) / turn, cross(from.unit_tangent, chord) / turn);
    // Both signs must match the direction of the offset, and a far crossing gives a bad fit.
    let good = ahead * behind > 0.0 && ahead.abs().max(behind.abs()) <= length;
    good.then_some([from.point, from.point + from.unit_tangent * ahead, to.point, to.point])
}

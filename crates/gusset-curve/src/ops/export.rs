//! Export formats, in memory: SVG paths, contours of TrueType fonts, B-splines.

use crate::curve::CurveView;
use crate::curve::unit_frame::UnitFrame;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::job::Job;
use std::fmt::{self, Write};
use std::ops::RangeInclusive;

/// A closed contour of a TrueType font (`glyf` table). Between two consecutive off-curve points,
/// their midpoint is an implied on-curve point.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct TrueTypeContour {
    /// The points; the first follows the last.
    pub points: Vec<DVec3>,
    /// For each point 1 if it is on the curve, 0 if it is the control point of a quadratic.
    pub on_curve: Vec<u8>,
}

/// A clamped B-spline.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ClampedSpline {
    /// The degree n of all its pieces.
    pub degree: usize,
    /// The knots, ascending: n + 1 more than there are control points. The first n + 1 are equal,
    /// and so are the last n + 1.
    pub knots: Vec<f64>,
    /// The control points (de Boor points).
    pub controls: Vec<DVec3>,
}

/// The shortest text that reads back as the same number, with an exponent if that is shorter.
struct ShortestNumber(f64);

impl fmt::Display for ShortestNumber {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let size = self.0.abs();
        if size == 0.0 {
            f.write_char('0')
        } else if (1e-5..1e16).contains(&size) {
            write!(f, "{}", self.0)
        } else {
            write!(f, "{:e}", self.0)
        }
    }
}

/// Segments between two progress reports.
const SEGMENTS_PER_REPORT: usize = 1 << 12;

/// The longest number has 24 characters, plus a space.
const MAX_CHARACTERS_PER_NUMBER: usize = 25;

impl CurveView<'_> {
    /// Returns the data of an SVG path: `M`, then `L`, `Q` or `C` for each segment, and `Z` if the
    /// curve is closed. Numbers read back as the same bits. The y axis points up here and down in
    /// SVG, so the caller may have to flip it. A curve without points gives an empty text.
    ///
    /// # Errors
    /// [`Error::CurveNotPlane`], [`Error::OptionOutOfRange`] (a degree above 3, which SVG lacks:
    /// see [`with_reduced_degree`](Self::with_reduced_degree)), [`Error::OutOfMemory`], [`Error::Cancelled`]. O(points).
    pub fn to_svg_path(&self, job: &Job<'_>) -> Result<String> {
        self.check_in_xy_plane()?;
        self.check_degrees(1..=3)?;
        let mut text = String::new();
        let Some(&start) = self.points().first() else {
            return Ok(text);
        };
        let add = |text: &mut String, letter: char, points: &[DVec3]| {
            let bytes = 4 + 2 * MAX_CHARACTERS_PER_NUMBER * points.len();
            text.try_reserve(bytes).map_err(|_| Error::OutOfMemory { bytes: bytes as u64 })?;
            text.push(letter);
            for p in points {
                // Writing to a string does not fail.
                let _ = write!(text, " {} {}", ShortestNumber(p.x), ShortestNumber(p.y));
            }
            Ok::<(), Error>(())
        };
        add(&mut text, 'M', &[start])?;
        for (k, controls) in self.segments().enumerate() {
            job.step_every(SEGMENTS_PER_REPORT, k, self.len(), "writing a path")?;
            text.push(' ');
            add(&mut text, [' ', 'L', 'Q', 'C'][controls.len() - 1], &controls[1..])?;
        }
        if self.is_closed() {
            text.push_str(" Z");
        }
        Ok(text)
    }

    /// Returns the contour of a TrueType font. It has the control points of the quadratics as
    /// off-curve points. A joint becomes an on-curve point unless it is the midpoint of its
    /// neighbours within `tolerance` (at least 0, in the unit of the points) or within rounding. A
    /// composite curve of n points with halved joints thus becomes n off-curve points.
    ///
    /// # Errors
    /// [`Error::CurveNotPlane`], [`Error::CurveNotClosed`] (contours are closed),
    /// [`Error::EmptyCurve`], [`Error::OptionOutOfRange`] (a degree above 2, or the tolerance),
    /// [`Error::OutOfMemory`], [`Error::Cancelled`]. O(points).
    pub fn to_truetype_contour(&self, tolerance: f64, job: &Job<'_>) -> Result<TrueTypeContour> {
        self.check_in_xy_plane()?;
        self.check_degrees(1..=2)?;
        Error::require(tolerance >= 0.0, "tolerance", tolerance, "at least 0")?;
        if self.is_empty() {
            return Err(Error::EmptyCurve);
        }
        if !self.is_closed() {
            return Err(Error::CurveNotClosed);
        }
        let largest = self.points().iter().fold(0.0f64, |m, p| m.max(p.abs().max_element()));
        let tolerance = tolerance.max(4.0 * f64::EPSILON * largest);
        let mut contour = TrueTypeContour::default();
        let mut before = self.segment(self.len() - 1);
        for (k, controls) in self.segments().enumerate() {
            job.step_every(SEGMENTS_PER_REPORT, k, self.len(), "writing a contour")?;
            // The start of this segment, then its control point.
            let implied = before.len() == 3
                && controls.len() == 3
                && ((before[1] * 0.5 + controls[1] * 0.5) - controls[0]).abs().max_element() <= tolerance;
            if !implied {
                contour.add_point(controls[0], 1)?;
            }
            if controls.len() == 3 {
                contour.add_point(controls[1], 0)?;
            }
            before = controls;
        }
        Ok(contour)
    }

    /// Converts the curve to a B-spline; all segments must have the same degree n.
    ///
    /// A joint whose direction is continuous, within an angle of 1e-9, becomes a knot of
    /// multiplicity n - 1 and is not a control point. The lengths of the knot intervals make the
    /// first derivative continuous there: l' / l = |B'_1 - J| / |J - B_(n-1)|. Other joints become
    /// knots of multiplicity n. The first interval has length 1.
    ///
    /// # Errors
    /// [`Error::EmptyCurve`], [`Error::OptionOutOfRange`] (the degree of a segment differs from the
    /// first one's), [`Error::OutOfMemory`], [`Error::Cancelled`]. O(points).
    pub fn to_clamped_spline(&self, job: &Job<'_>) -> Result<ClampedSpline> {
        if self.is_empty() {
            return Err(Error::EmptyCurve);
        }
        let n = self.segment(0).len() - 1;
        self.check_degrees(n..=n)?;
        let mut spline = ClampedSpline { degree: n, ..ClampedSpline::default() };
        let frame = UnitFrame::from_points(self.points());
        let (mut knot, mut interval) = (0.0, 1.0);
        spline.add_knots(knot, n + 1)?;
        alloc::append(&mut spline.controls, self.segment(0))?;
        job.step(0.0, "writing a spline")?;
        for k in 1..self.len() {
            job.step_every(SEGMENTS_PER_REPORT, k, self.len(), "writing a spline")?;
            let (before, after) = (self.segment(k - 1), self.segment(k));
            knot += interval;
            let joint = frame.point_to_frame(after[0]);
            let (arriving, leaving) =
                (joint - frame.point_to_frame(before[n - 1]), frame.point_to_frame(after[1]) - joint);
            match length_ratio_if_parallel(arriving, leaving).map(|ratio| interval * ratio) {
                // Outside this range the knots would coincide.
                Some(next) if n > 1 && (1e-6..1e6).contains(&next) => {
                    interval = next;
                    spline.controls.pop();
                    spline.add_knots(knot, n - 1)?;
                }
                _ => spline.add_knots(knot, n)?,
            }
            alloc::append(&mut spline.controls, &after[1..])?;
        }
        spline.add_knots(knot + interval, n + 1)?;
        Ok(spline)
    }

    fn check_degrees(&self, allowed: RangeInclusive<usize>) -> Result<()> {
        let mut degrees = self.segments().map(|controls| controls.len() - 1);
        degrees.try_for_each(|degree| {
            Error::require(
                allowed.contains(&degree),
                "degree",
                degree as f64,
                (*allowed.start() as f64)..=*allowed.end() as f64,
            )
        })
    }
}

/// |v| / |u| if both vectors have the same direction.
fn length_ratio_if_parallel(u: DVec3, v: DVec3) -> Option<f64> {
    let (a, b) = (u.length(), v.length());
    (u.dot(v) > 0.0 && u.cross(v).length() <= 1e-9 * a * b).then_some(b / a)
}

impl TrueTypeContour {
    fn add_point(&mut self, point: DVec3, on_curve: u8) -> Result<()> {
        alloc::push(&mut self.points, point)?;
        alloc::push(&mut self.on_curve, on_curve)
    }
}

impl ClampedSpline {
    fn add_knots(&mut self, at: f64, times: usize) -> Result<()> {
        (0..times).try_for_each(|_| alloc::push(&mut self.knots, at))
    }
}

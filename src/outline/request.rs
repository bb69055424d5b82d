//! What is asked for, and what is said about it.

use super::method::Method;
use crate::error::{Error, Result};
use glam::DVec3;

/// Points as they lie in memory: 2 or 3 coordinates at the start of every `stride` bytes, at any alignment. Plane points have
/// z = 0.
#[derive(Debug, Clone, Copy)]
pub struct Points<'a> {
    bytes: &'a [u8],
    stride: usize,
    count: usize,
    dimension: usize,
}

impl<'a> Points<'a> {
    /// `dimension`: 2 or 3; `stride`: in bytes, 0 for points without gaps.
    ///
    /// # Errors
    /// [`Error::OptionOutOfRange`] (the dimension), [`Error::TooLarge`], [`Error::StrideTooSmall`], [`Error::SizeOverflow`],
    /// [`Error::ArrayTooShort`].
    pub fn strided(bytes: &'a [u8], stride: usize, count: usize, dimension: usize) -> Result<Self> {
        let needed = Self::bytes_needed(stride, count, dimension)?;
        if bytes.len() < needed {
            let (needed, given) = (needed as u64, bytes.len() as u64);
            return Err(Error::ArrayTooShort { what: "points", needed, given });
        }
        let stride = if stride == 0 { 8 * dimension } else { stride };
        Ok(Points { bytes: &bytes[..needed], stride, count, dimension })
    }

    /// The number of bytes that `count` points span.
    ///
    /// # Errors
    /// Those of [`Points::strided`].
    pub fn bytes_needed(stride: usize, count: usize, dimension: usize) -> Result<usize> {
        if !(2..=3).contains(&dimension) {
            return Err(Error::OptionOutOfRange { option: "dimension", value: dimension as f64 });
        }
        if count > MAX_POINTS {
            return Err(Error::TooLarge { what: "points", count: count as u64, limit: MAX_POINTS as u64 });
        }
        let size = 8 * dimension;
        if stride != 0 && stride < size {
            return Err(Error::StrideTooSmall { stride: stride as u64, min: size as u64 });
        }
        let stride = if stride == 0 { size } else { stride };
        let bytes = count.saturating_sub(1).checked_mul(stride).and_then(|n| n.checked_add(size * count.min(1)));
        bytes.filter(|&n| n <= isize::MAX as usize).ok_or(Error::SizeOverflow { what: "points", count: count as u64 })
    }

    /// The number of points.
    pub fn len(&self) -> usize {
        self.count
    }

    /// True if there are none.
    pub fn is_empty(&self) -> bool {
        self.count == 0
    }

    /// 2 or 3.
    pub fn dimension(&self) -> usize {
        self.dimension
    }

    /// Appends the points of a range to a list that has room for them.
    pub(super) fn read(&self, range: std::ops::Range<usize>, list: &mut Vec<DVec3>) {
        let rows = |size: usize| range.clone().map(move |i| &self.bytes[i * self.stride..][..size]);
        if self.dimension == 2 {
            list.extend(rows(16).map(|row| {
                let [x, y]: [f64; 2] = bytemuck::pod_read_unaligned(row);
                DVec3::new(x, y, 0.0)
            }));
        } else {
            list.extend(rows(24).map(|row| DVec3::from_array(bytemuck::pod_read_unaligned(row))));
        }
    }

    /// Point `i`.
    ///
    /// # Panics
    /// If there is none.
    #[inline]
    pub fn get(&self, i: usize) -> DVec3 {
        let at = i * self.stride;
        if self.dimension == 2 {
            let [x, y]: [f64; 2] = bytemuck::pod_read_unaligned(&self.bytes[at..at + 16]);
            DVec3::new(x, y, 0.0)
        } else {
            DVec3::from_array(bytemuck::pod_read_unaligned(&self.bytes[at..at + 24]))
        }
    }
}

impl<'a> From<&'a [[f64; 2]]> for Points<'a> {
    fn from(points: &'a [[f64; 2]]) -> Self {
        Points { bytes: bytemuck::cast_slice(points), stride: 16, count: points.len(), dimension: 2 }
    }
}

impl<'a> From<&'a [[f64; 3]]> for Points<'a> {
    fn from(points: &'a [[f64; 3]]) -> Self {
        Points { bytes: bytemuck::cast_slice(points), stride: 24, count: points.len(), dimension: 3 }
    }
}

/// The largest number of points in one call: 2^30, so that control points can be counted in 32 bits.
pub const MAX_POINTS: usize = 1 << 30;

/// Outlines: all their points one after another.
#[derive(Debug, Clone, Copy)]
pub struct Outlines<'a> {
    /// The points of all outlines.
    pub points: Points<'a>,
    /// Outline k has the points `offsets[k]..offsets[k + 1]`; `None` for a single outline of all points.
    pub offsets: Option<&'a [u32]>,
    /// Whether they are closed: from the last point back to the first.
    pub closed: bool,
    /// What is demanded at some points, in ascending order of the points, at most once for each. Of points that are merged the first
    /// demand holds.
    pub constraints: &'a [Constraint],
}

/// What is demanded of the curve at a point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Constraint {
    /// The point, counted over all outlines.
    pub point: u32,
    /// What.
    pub demand: Demand,
}

/// What may be demanded.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Demand {
    /// The curve may turn sharply: it is made of two that meet there.
    Corner,
    /// The curve passes in this direction; of any length but 0.
    Tangent(DVec3),
}

/// What kind of curve.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Mode {
    /// Quadratic segments, one control point for each point; smooth (G1) everywhere.
    #[default]
    Composite,
    /// One Bézier curve of degree n through n + 1 points; each tangent at an end raises the degree by one. Closed: begins and
    /// ends at the first point, with the tangent of that point's own section. Beyond degree 10 or so control points may lie
    /// far out ([`FitStatus::IllConditioned`]); beyond [`MAX_DEGREE`](super::MAX_DEGREE) the curve is composite.
    Single,
    /// The sections of neighbouring points blended linearly: cubic segments from point to point, C1 (G1 with the normal).
    BlendC1,
    /// The sections of neighbouring points blended smoothly: quintic segments from point to point, C2 (G2 with the normal).
    BlendC2,
    /// Cubic segments from point to point, C2 in the knots of the method's exponent.
    CubicC2,
}

/// What the section of a point is tied to, in composite and single curves.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Lock {
    /// The parameter of the point is that of the method on the data's own triangle. Always solvable.
    #[default]
    Parameter,
    /// The parameter is that of the method on the section's own triangle (its joints and the point). With the normal there may be
    /// several solutions; which one is found depends on the solver. A foot of the normal
    /// outside the chord counts as the chord's end. Single curves have no sections, and take [`Lock::DataGuide`].
    SelfConsistent,
    /// The control point lies on the guide of the data's triangle; outlines in a plane, any plane, only. Points whose section
    /// does not cross the guide fall back to [`Lock::Parameter`].
    DataGuide,
}

/// Where the joint of two sections divides the line between their control points.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Joint {
    /// In the middle, as the implied points of TrueType contours.
    #[default]
    Half,
    /// By the chords to the power of the method's exponent, as in a quadratic B-spline: C1 in those knots.
    Knot,
    /// So that the curvature is continuous where the control polygon turns one way, and changes its sign only elsewhere.
    /// Slow, and for dense and even points hardly determined ([`PointStatus::NotConverged`]).
    G2,
}

/// How equations are solved.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Solver {
    /// By closed forms and Newton's method.
    #[default]
    Fast,
    /// The paper's: sweeps over the points, with steps along the guide, refined tenfold where the deviation changes its sign.
    /// Where there is no guide to keep, along the deviation.
    Step,
}

/// How an open outline, or a part of one that ends at a corner, begins and ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Ends {
    /// As the first and last sections have it.
    #[default]
    Free,
    /// Perpendicular to the first and the last chord: from the first point to the third, and from the last but two to the last.
    Perpendicular,
}

/// How outlines are identified.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Options {
    /// What kind of curve.
    pub mode: Mode,
    /// How the control point of a section is found.
    pub method: Method,
    /// What sections are tied to.
    pub lock: Lock,
    /// Where they join.
    pub joint: Joint,
    /// How equations are solved.
    pub solver: Solver,
    /// The ends of open outlines; the constraints come first.
    pub ends: Ends,
    /// The parameter of a point is kept within this and 1 less this; 0.001 <= `parameter_limit` < 1/2.
    pub parameter_limit: f64,
    /// Neighbours nearer than this, times the size of the outline, are one point. At least 0.
    pub repeat_tolerance: f64,
    /// Where the polygon of the points turns by more than this angle, in radians, is a corner; pi or more for none.
    pub corner_angle: f64,
    /// Iterations end when nothing moves by more than this, times the size of the outline. What is then left to the solution may be
    /// some times as much where an iteration converges slowly.
    pub tolerance: f64,
    /// The most sweeps or iterations; at least 1.
    pub max_sweeps: u32,
    /// The most steps of the stepping solver at a point, in one sweep; at least 1.
    pub max_steps: u32,
    /// Its first step, times the size of the outline.
    pub first_step: f64,
    /// What a step is divided by where the deviation changes its sign; greater than 1.
    pub step_divisor: f64,
}

impl Default for Options {
    fn default() -> Self {
        Options {
            mode: Mode::default(),
            method: Method::default(),
            lock: Lock::default(),
            joint: Joint::default(),
            solver: Solver::default(),
            ends: Ends::default(),
            parameter_limit: 1.0 / 6.0,
            repeat_tolerance: 1e-12,
            corner_angle: std::f64::consts::PI,
            tolerance: 1e-12,
            max_sweeps: 200,
            max_steps: 20_000,
            first_step: 0.1,
            step_divisor: 10.0,
        }
    }
}

impl Options {
    /// # Errors
    /// [`Error::OptionOutOfRange`].
    pub(super) fn check(&self) -> Result<()> {
        let alpha = self.method.alpha().unwrap_or(0.5);
        let least = |value: f64| value >= 0.0 && value.is_finite();
        let ranges = [
            ("alpha", alpha, (0.0..=1.0).contains(&alpha)),
            ("parameter_limit", self.parameter_limit, (1e-3..0.5).contains(&self.parameter_limit)),
            ("repeat_tolerance", self.repeat_tolerance, least(self.repeat_tolerance) && self.repeat_tolerance < 1.0),
            ("corner_angle", self.corner_angle, self.corner_angle >= 0.0),
            ("tolerance", self.tolerance, least(self.tolerance) && self.tolerance < 1.0),
            ("first_step", self.first_step, self.first_step > 0.0 && self.first_step <= 1.0),
            ("max_sweeps", f64::from(self.max_sweeps), self.max_sweeps > 0),
            ("max_steps", f64::from(self.max_steps), self.max_steps > 0),
            ("step_divisor", self.step_divisor, self.step_divisor > 1.0 && self.step_divisor <= 1e6),
        ];
        match ranges.iter().find(|range| !range.2) {
            Some(&(option, value, _)) => Err(Error::OptionOutOfRange { option, value }),
            None => Ok(()),
        }
    }
}

/// What became of a point. The curve passes all points but those marked so.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[repr(u8)]
pub enum PointStatus {
    /// As asked.
    #[default]
    Ok = 0,
    /// Its parameter was brought within the limits.
    ClampedParameter = 1,
    /// It repeats a point before it (or the first one, at the end of a closed outline), and was left out: the curve passes that
    /// one, which is within the tolerance for repeats.
    Merged = 2,
    /// It repeats the first or last point of its section, which has no control point then.
    Repeated = 3,
    /// Its triangle is flat: it has no guide.
    Collinear = 4,
    /// The foot of the normal is outside the chord.
    NormalOutside = 5,
    /// The foot of the normal is an end of the chord.
    RightAngle = 6,
    /// The curve does not cross the guide.
    NoCrossing = 7,
    /// The tangent runs between the points that should be on one side of it.
    TangentSeparates = 8,
    /// The curve would have to run backwards along the tangent.
    TangentBackward = 9,
    /// The tangent cannot be reached by a quadratic: the point is beyond the section's end.
    TangentBeyond = 10,
    /// The tangent is not in the plane of the section.
    OutOfPlane = 11,
    /// The tangent has no direction.
    NoTangent = 12,
    /// The lock could not be kept; the lock by parameter took its place.
    FellBack = 13,
    /// The iteration ended before it was still.
    NotConverged = 14,
    /// The curve misses it: the outline has too few different points, or its equations have no solution.
    Missed = 15,
}

/// What became of an outline.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[repr(u8)]
pub enum FitStatus {
    /// As asked.
    #[default]
    Ok = 0,
    /// Some points are not as asked: see their status.
    Partial = 1,
    /// The iteration ended before it was still; the points have what it reached, or fell back.
    NotConverged = 2,
    /// The iteration ran away.
    Diverged = 3,
    /// The equations are so nearly singular that control points lie far outside the outline.
    IllConditioned = 4,
    /// Fewer than two different points, or three of a closed outline: there is no curve, or what two points give.
    TooFewPoints = 5,
    /// A single curve of more than [`MAX_DEGREE`](super::MAX_DEGREE).
    DegreeTooHigh = 6,
}

/// The account of one outline. Lengths are relative to its size: the longest side of its box.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Report {
    /// What became of it.
    pub status: FitStatus,
    /// Sweeps or iterations; 0 for what needs none.
    pub iterations: u32,
    /// Steps of the stepping solver.
    pub steps: u64,
    /// The longest side of its box.
    pub size: f64,
    /// The largest distance of a point from its place on the curve.
    pub max_residual: f64,
    /// The largest sine of the angle by which the curve turns at a joint that is to be smooth.
    pub max_joint_sine: f64,
    /// The farthest move of a control point in the last iteration, or the largest change of a share of a joint by curvatures.
    pub last_move: f64,
    /// How many points have a status other than [`PointStatus::Ok`].
    pub not_ok: u32,
}

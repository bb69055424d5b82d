//! The account of an identification: statuses of points and outlines, measured residuals, and the
//! history of the cycles.

use gusset_base::alloc;
use gusset_base::error::Result;
use std::ops::{Deref, DerefMut};

/// The outcome at a point. The curve passes all points but those marked so.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[repr(u8)]
pub enum PointStatus {
    /// As asked.
    #[default]
    Ok = 0,
    /// Its parameter was brought within the limits.
    ClampedParameter = 1,
    /// It repeats a point before it (or the first one, at the end of a closed outline), and was
    /// left out: the curve passes that one, which is within the tolerance for repeats.
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
    /// The tangent is not in the plane of the section; or the lock asks for guides, or the joints for
    /// continuous curvature, and the outline is not plane.
    OutOfPlane = 11,
    /// The tangent has no direction.
    NoTangent = 12,
    /// The lock could not be kept: its parameter is that of [`Lock::Parameter`](super::Lock).
    FellBack = 13,
    /// The iteration ended before it was still.
    NotConverged = 14,
    /// The curve misses it: the outline has too few different points, or its equations have no
    /// solution.
    Missed = 15,
    /// A joint beside it could not be where the option asks for it: it is in the middle between its
    /// control points, or, for continuous curvature, the curvature there is 0.
    JointFellBack = 16,
    /// It is on a composite curve, as the single one failed.
    CompositeInstead = 17,
    /// The curve turns back at it: it stands still there, or leaves the way it came.
    Cusp = 18,
}

/// The outcome of an outline.
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
    /// Fewer than two different points, or three of a closed outline: there is no curve, or what
    /// two points give.
    TooFewPoints = 5,
    /// A single curve of more than [`MAX_DEGREE`](crate::MAX_DEGREE).
    DegreeTooHigh = 6,
}

/// The account of one outline. Lengths are relative to its size: the longest side of its box.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Report {
    /// Its outcome.
    pub status: FitStatus,
    /// Sweeps or iterations, the most of any part between corners; 0 for what needs none. At most
    /// [`Options::max_sweeps`](super::Options).
    pub iterations: u32,
    /// Steps of the stepping solver.
    pub steps: u64,
    /// The longest side of its box.
    pub size: f64,
    /// The largest distance of a point from its place on the curve.
    pub max_residual: f64,
    /// The largest sine of the angle by which the curve turns at a joint that is to be smooth.
    pub max_joint_sine: f64,
    /// The largest difference of the curvatures on both sides of a joint of a composite curve with
    /// [`JointParameter::G2`](super::JointParameter), relative to the larger one, or to 1 / size
    /// where both are less. 0 for other curves.
    pub max_curvature_gap: f64,
    /// The farthest move of a control point in the last iteration.
    pub last_move: f64,
    /// How many points have a status other than [`PointStatus::Ok`].
    pub not_ok: u32,
}

/// One cycle of an iteration: a sweep over the points, or an iteration of Newton's method.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[repr(C)]
pub struct Cycle {
    /// The farthest move of a control point, relative to the size of the outline.
    pub moved: f64,
    /// The steps of the stepping solver up to its end, of all cycles of the outline so far.
    pub steps: u64,
}

/// The report of an outline while it grows, and the history of its cycles if that is asked for.
#[derive(Default)]
pub(super) struct Account {
    pub(super) report: Report,
    pub(super) history: Option<Vec<Cycle>>,
}

impl Account {
    /// Enters the farthest move of a cycle at its end.
    pub(super) fn end_cycle(&mut self, moved: f64) -> Result<()> {
        self.report.last_move = moved;
        let cycle = Cycle { moved, steps: self.report.steps };
        self.history.as_mut().map_or(Ok(()), |history| alloc::push(history, cycle))
    }
}

impl Deref for Account {
    type Target = Report;

    fn deref(&self) -> &Report {
        &self.report
    }
}

impl DerefMut for Account {
    fn deref_mut(&mut self) -> &mut Report {
        &mut self.report
    }
}

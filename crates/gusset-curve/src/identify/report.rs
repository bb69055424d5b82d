//! The report on an identification: statuses of points and outlines, measured residuals, and the
//! history of the cycles.

use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use std::ops::{Deref, DerefMut};

/// The outcome at a point. The curve passes every point unless the status says otherwise.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[repr(u8)]
pub enum PointStatus {
    /// The point is as requested.
    #[default]
    Ok = 0,
    /// The parameter was clamped to the limits.
    ClampedParameter = 1,
    /// The point repeats a previous point, or at the end of a closed outline the first one. It was
    /// omitted, and the curve passes the other point, which is within the tolerance for
    /// repetitions.
    Merged = 2,
    /// The point repeats the first or last point of its section, which then lacks a control point.
    Repeated = 3,
    /// The triangle is flat and lacks a guide.
    Collinear = 4,
    /// The foot of the normal is outside the chord.
    NormalOutside = 5,
    /// The foot of the normal is an end of the chord.
    RightAngle = 6,
    /// The curve does not cross the guide.
    NoCrossing = 7,
    /// The tangent runs between points that must be on one side of it.
    TangentSeparates = 8,
    /// The curve would have to run backwards along the tangent.
    TangentBackward = 9,
    /// A quadratic cannot have the tangent, because the point is beyond the section's end.
    TangentBeyond = 10,
    /// The tangent is not in the plane of the section. Or the lock needs guides, or the joints need
    /// continuous curvature, and the outline is not plane.
    OutOfPlane = 11,
    /// The tangent vector is 0.
    NoTangent = 12,
    /// The lock could not be kept, so the point has the parameter of
    /// [`Lock::Parameter`](super::Lock).
    FellBack = 13,
    /// The iteration ended before it converged.
    NotConverged = 14,
    /// The curve misses the point, because the outline has too few distinct points or the equations
    /// lack a solution.
    Missed = 15,
    /// A joint next to the point could not be placed as the options require. It is in the middle
    /// between its control points, or, for continuous curvature, its curvature is 0.
    JointFellBack = 16,
    /// The point is on a composite curve, because the single one failed.
    CompositeInstead = 17,
    /// The curve reverses at the point: its speed is 0, or it leaves in the direction from which it
    /// came.
    Cusp = 18,
    /// The curve crosses itself here although the points do not. A span, the curve between two
    /// consecutive points, crosses itself (both its ends have this status), the next span (the point
    /// between both), or the next but one (both points between). Or the spans at both ends of a run
    /// of close points cross (all points of the run). The last two cases do not count if the lines
    /// between the points turn by a half turn or more, or reverse. Loops shorter than a twentieth of
    /// a span may be missed. In space, the loop's ends are at most a twentieth of its size apart.
    /// Crowded points and the median are the usual causes. The bisector avoids most loops, and
    /// [`Options::repeat_tolerance`](super::Options) merges close points.
    Looped = 19,
    /// The point is far closer to a neighbour than both are to their other neighbours: below a
    /// hundredth of both distances, or a ten-thousandth of one. The curve may turn there in any way.
    /// [`Options::repeat_tolerance`](super::Options) merges such points.
    Crowded = 20,
}

/// The outcome for an outline.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[repr(u8)]
pub enum FitStatus {
    /// The outline is as requested.
    #[default]
    Ok = 0,
    /// Some points are not as requested; see their status.
    Partial = 1,
    /// The iteration ended before it converged. The points have the last values, or fell back.
    NotConverged = 2,
    /// The iteration diverged.
    Diverged = 3,
    /// The equations are so nearly singular that control points lie far outside the outline.
    IllConditioned = 4,
    /// There are fewer than two distinct points, or fewer than three for a closed outline. The
    /// curve is empty, or a line through two points.
    TooFewPoints = 5,
    /// A single curve would exceed [`MAX_DEGREE`](crate::MAX_DEGREE).
    DegreeTooHigh = 6,
}

/// The report on one outline. Lengths are relative to its size, the longest side of its bounding
/// box.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Report {
    /// The outcome.
    pub status: FitStatus,
    /// The number of sweeps or iterations, the maximum over the parts between corners; 0 if none
    /// were needed. At most [`Options::max_sweeps`](super::Options). If the solver that the options
    /// name fails, the iterations of its replacement do not count.
    pub iterations: u32,
    /// The number of steps of the stepping solver.
    pub steps: u64,
    /// The longest side of the bounding box.
    pub size: f64,
    /// The largest residual: the largest distance of a point from its place on the curve.
    pub max_residual: f64,
    /// The largest sine of an angle by which the curve turns at a joint that should be smooth.
    pub max_joint_sine: f64,
    /// The largest difference of the curvatures on both sides of a joint, for a composite curve
    /// with [`JointParameter::G2`](super::JointParameter). It is relative to the larger curvature,
    /// or to 1 / size if both are smaller. 0 for other curves.
    pub max_curvature_gap: f64,
    /// The largest move of a control point in the last iteration that counts.
    pub last_move: f64,
    /// The number of points with a status other than [`PointStatus::Ok`].
    pub not_ok: u32,
}

/// One cycle of an iteration: a sweep over the points, or an iteration of Newton's method.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[repr(C)]
pub struct Cycle {
    /// The largest move of a control point, relative to the size of the outline.
    pub moved: f64,
    /// The steps of the stepping solver up to the end of this cycle, over all cycles of the
    /// outline.
    pub steps: u64,
    /// The number of control points of this cycle and all earlier ones of the outline.
    pub control_end: u64,
}

/// The cycles of an outline, and the control points at the end of each.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct History {
    pub(super) cycles: Vec<Cycle>,
    pub(super) controls: Vec<DVec3>,
}

/// The report of an outline in progress, and the history of its cycles if requested.
#[derive(Default)]
pub(super) struct ReportInProgress {
    pub(super) report: Report,
    pub(super) history: Option<History>,
    /// Whether iterations belong to a start or a replacement of the solver that the options name.
    pub(super) is_uncounted: bool,
}

impl ReportInProgress {
    /// Counts an iteration at its start.
    pub(super) fn count_iteration(&mut self) {
        self.report.iterations += u32::from(!self.is_uncounted);
    }

    /// Replaces the move of the last cycle, which ended with a further step.
    pub(super) fn correct_last_move(&mut self, largest_move: f64) {
        if self.is_uncounted {
            return;
        }
        self.report.last_move = largest_move;
        if let Some(cycle) = self.history.as_mut().and_then(|history| history.cycles.last_mut()) {
            cycle.moved = largest_move;
        }
    }

    /// Records the largest move of a cycle at its end, and its control points.
    pub(super) fn record_cycle<'a, I>(&mut self, largest_move: f64, controls: I) -> Result<()>
    where
        I: IntoIterator<Item = &'a DVec3, IntoIter: ExactSizeIterator>,
    {
        if self.is_uncounted {
            return Ok(());
        }
        self.report.last_move = largest_move;
        let Some(History { cycles, controls: kept }) = &mut self.history else { return Ok(()) };
        alloc::extend(kept, controls.into_iter().copied())?;
        alloc::push(cycles, Cycle { moved: largest_move, steps: self.report.steps, control_end: kept.len() as u64 })
    }
}

impl Deref for ReportInProgress {
    type Target = Report;

    fn deref(&self) -> &Report {
        &self.report
    }
}

impl DerefMut for ReportInProgress {
    fn deref_mut(&mut self) -> &mut Report {
        &mut self.report
    }
}

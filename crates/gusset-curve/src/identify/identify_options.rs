//! The options of an identification.

use super::method::Method;
use gusset_base::choices;
use gusset_base::error::{Error, Result};

/// The kind of curve.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Mode {
    /// Quadratic segments, one control point for each point; smooth (G1) everywhere.
    #[default]
    Composite,
    /// One Bézier curve of degree n through n + 1 points; each tangent at an end raises the degree
    /// by one. Closed: begins and ends at the first point, with the tangent of that point's own
    /// section. Beyond degree 10 or so control points may lie far out
    /// ([`IllConditioned`](super::FitStatus::IllConditioned)); beyond
    /// [`MAX_DEGREE`](crate::MAX_DEGREE) the curve is composite.
    Single,
    /// The sections of neighbouring points blended linearly: cubic segments from point to point, C1
    /// (G1 with the normal).
    BlendC1,
    /// The sections of neighbouring points blended smoothly: quintic segments from point to point,
    /// C2 (G2 with the normal), but at inner points whose tangent is given: C1 (G1) there.
    BlendC2,
    /// Cubic segments from point to point, C2 in the knots of the method's exponent, but at inner
    /// points whose tangent is given: C1 there.
    CubicC2,
    /// The paper's chain of sections: [`Mode::Composite`] with [`Lock::DataGuide`], whatever the lock
    /// of the options. The control point of each section lies on the guide, the bisector, median or
    /// normal of the data's own triangle, that the method names.
    Chain,
}

choices! { for Mode:
    Composite => "Composite", "Quadratic segments that meet smoothly, one for each point.";
    CubicC2 => "Cubic spline", "Cubic segments with continuous curvature.";
    BlendC1 => "Blend", "Blends of neighbouring sections: each point has local influence only.";
    BlendC2 => "Smooth blend", "Blends of neighbouring sections with continuous curvature.";
    Single => "Single", "One Bezier curve; for few points.";
    Chain => "Chain", "Quadratic segments with control points on the guides of the points, as the paper draws them.";
}

/// The condition that ties the section of a point to the data, in composite and single curves.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Lock {
    /// The parameter of the point is that of the method on the data's own triangle. Always
    /// solvable. The control point is on the line from the point to the foot that divides the
    /// section's chord as t^2 to (1 - t)^2, which is near the guide of the data's triangle but not
    /// on it: for those use [`Lock::DataGuide`].
    #[default]
    Parameter,
    /// The parameter is that of the method on the section's own triangle (its joints and the
    /// point). With the normal there may be several solutions; which one is found depends on the
    /// solver. A foot of the normal outside the chord counts as the chord's end. Single curves have
    /// no sections, and take [`Lock::DataGuide`].
    SelfConsistent,
    /// The control point lies on the guide of the data's triangle, as the paper draws it; outlines
    /// in a plane, any plane, only. Where no normal meets the chord the guide is the bisector, and
    /// the status says so. Points whose section does not cross the guide fall back to
    /// [`Lock::Parameter`].
    DataGuide,
}

choices! { for Lock:
    Parameter => "Parameter", "The parameter of the data's triangle; always solvable.";
    SelfConsistent => "Own triangle", "The section's own triangle.";
    DataGuide => "Guide", "The guide of the data's triangle; plane polylines only.";
}

/// The joint parameter: where the joint of two sections divides the line between their control
/// points.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum JointParameter {
    /// In the middle, as the implied points of TrueType contours.
    #[default]
    Half,
    /// By the chords to the power of the method's exponent, as in a quadratic B-spline: C1 in those
    /// knots.
    Knot,
    /// So that the curvature is continuous (G2). Sections are cubics in the triangles of the
    /// quadratics, as these have no inflections; where the polygon turns the other way the curvature
    /// is 0. Outlines in a plane only: in space curvatures agree in magnitude.
    G2,
}

choices! { for JointParameter:
    Half => "Halves", "Midway between their control points.";
    Knot => "Knots", "In proportion to the lengths of the chords.";
    G2 => "Curvature", "Where the curvature is continuous.";
}

/// How equations are solved.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Solver {
    /// By closed forms and Newton's method.
    #[default]
    Fast,
    /// The paper's: sweeps over the points, with steps along the guide, refined tenfold where the
    /// deviation changes its sign. Where there is no guide to keep, along the deviation.
    Step,
}

/// How an open outline, or a part of one that ends at a corner, begins and ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Ends {
    /// As the first and last sections have it.
    #[default]
    Free,
    /// Perpendicular to the first and the last chord: from the first point to the third, and from
    /// the last but two to the last.
    Perpendicular,
    /// Along the x-axis, in the sense of the first and the last leg.
    Level,
    /// Along the y-axis, in the sense of the first and the last leg.
    Upright,
    /// Level or upright, whichever is nearer the perpendicular of the first or the last chord: the
    /// paper's default.
    LevelOrUpright,
}

choices! { for Ends:
    Free => "Free", "As the end sections give.";
    Perpendicular => "Perpendicular", "Perpendicular to the first and the last chord.";
    Level => "Level", "Along the x-axis.";
    Upright => "Upright", "Along the y-axis.";
    LevelOrUpright => "Level or upright", "The one nearer the perpendicular of the first or the last chord.";
}

/// How outlines are identified.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Options {
    /// The kind of curve.
    pub mode: Mode,
    /// How the control point of a section is found.
    pub method: Method,
    /// The condition that sections obey.
    pub lock: Lock,
    /// Where neighbouring sections join.
    pub joint: JointParameter,
    /// How equations are solved.
    pub solver: Solver,
    /// The ends of open outlines; the constraints come first.
    pub ends: Ends,
    /// The parameter of a point is kept within this and 1 less this; 0.001 <= `parameter_limit` <
    /// 1/2.
    pub parameter_limit: f64,
    /// Neighbours nearer than this, times the size of the outline, are one point. At least 0.
    pub repeat_tolerance: f64,
    /// Where the polygon of the points turns by more than this angle, in radians, is a corner; pi
    /// or more for none.
    pub corner_angle: f64,
    /// Iterations end when nothing moves by more than this, times the size of the outline. What is
    /// then left to the solution may be some times as much where an iteration converges slowly.
    pub tolerance: f64,
    /// The most sweeps or iterations between two corners; at least 1.
    pub max_sweeps: u32,
    /// The most steps of the stepping solver at a point, in one sweep; at least 1.
    pub max_steps: u32,
    /// Its first step, times the size of the outline.
    pub first_step: f64,
    /// The divisor of a step where the deviation changes its sign; greater than 1.
    pub step_divisor: f64,
    /// Whether the moves of each cycle are kept: see [`Fit::history`](super::Fit::history).
    pub history: bool,
}

impl Default for Options {
    fn default() -> Self {
        Options {
            mode: Mode::default(),
            method: Method::default(),
            lock: Lock::default(),
            joint: JointParameter::default(),
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
            history: false,
        }
    }
}

impl Options {
    /// The same, with the chain as what it stands for.
    pub(super) fn resolved(&self) -> Options {
        match self.mode {
            Mode::Chain => Options { mode: Mode::Composite, lock: Lock::DataGuide, ..*self },
            _ => *self,
        }
    }

    /// # Errors
    /// [`Error::OptionOutOfRange`].
    pub(crate) fn check(&self) -> Result<()> {
        let alpha = self.method.alpha().unwrap_or(0.5);
        let fraction = |value: f64| (0.0..1.0).contains(&value);
        let ranges = [
            ("alpha", alpha, (0.0..=1.0).contains(&alpha)),
            ("parameter_limit", self.parameter_limit, (1e-3..0.5).contains(&self.parameter_limit)),
            ("repeat_tolerance", self.repeat_tolerance, fraction(self.repeat_tolerance)),
            ("corner_angle", self.corner_angle, self.corner_angle >= 0.0),
            ("tolerance", self.tolerance, fraction(self.tolerance)),
            ("first_step", self.first_step, self.first_step > 0.0 && self.first_step <= 1.0),
            ("max_sweeps", f64::from(self.max_sweeps), self.max_sweeps > 0),
            ("max_steps", f64::from(self.max_steps), self.max_steps > 0),
            ("step_divisor", self.step_divisor, self.step_divisor > 1.0 && self.step_divisor <= 1e6),
        ];
        ranges.into_iter().try_for_each(|(option, value, allowed)| Error::require(allowed, option, value))
    }
}

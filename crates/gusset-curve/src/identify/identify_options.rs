//! The options of an identification.

use super::method::Method;
use gusset_base::choices;
use gusset_base::error::{Error, Result};

/// The kind of curve.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum CurveKind {
    /// Quadratic segments, with one control point for each point. Smooth (G1) everywhere.
    #[default]
    Composite,
    /// One Bézier curve of degree n through n + 1 points. Each end tangent raises the degree by
    /// one. A closed curve begins and ends at the first point, with the tangent of that point's own
    /// section. Beyond degree 10 or so, control points may lie far out
    /// ([`IllConditioned`](super::FitStatus::IllConditioned)). Beyond
    /// [`MAX_DEGREE`](crate::MAX_DEGREE) the curve is composite.
    Single,
    /// Linear blends of the sections of neighbouring points: cubic segments from point to point, C1
    /// (G1 with the normal).
    BlendC1,
    /// Smooth blends of the sections of neighbouring points: quintic segments from point to point,
    /// C2 (G2 with the normal). At inner points with a given tangent they are C1 (G1).
    BlendC2,
    /// Cubic segments from point to point, C2 in the knots of the method's exponent. At inner
    /// points with a given tangent they are C1.
    CubicC2,
    /// The paper's chain of sections: [`CurveKind::Composite`] with [`Lock::DataGuide`], regardless
    /// of the lock in the options. The control point of each section lies on the guide of the data's
    /// own triangle: the bisector, median or normal, as the method says.
    Chain,
}

choices! { for CurveKind:
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
    /// The parameter of the point is the method's parameter on the data's own triangle. Always
    /// solvable. The control point lies on the line from the point to the foot that divides the
    /// section's chord as t^2 to (1 - t)^2. This line is close to the guide of the data's triangle
    /// but not equal to it; see [`Lock::DataGuide`].
    #[default]
    Parameter,
    /// The parameter is the method's parameter on the section's own triangle (its joints and the
    /// point). With the normal there may be several solutions, and the solver determines which one
    /// is found. A foot of the normal outside the chord counts as the chord's end. Single curves
    /// lack sections and use [`Lock::DataGuide`] instead.
    SelfConsistent,
    /// The control point lies on the guide of the data's triangle, as the paper draws it. Only for
    /// outlines in a plane, which may be any plane. Where the normal misses the chord, the guide is
    /// the bisector, and the status says so. Points whose section does not cross the guide fall
    /// back to [`Lock::Parameter`].
    DataGuide,
}

choices! { for Lock:
    Parameter => "Parameter", "The parameter of the data's triangle; always solvable.";
    SelfConsistent => "Own triangle", "The section's own triangle.";
    DataGuide => "Guide", "The guide of the data's triangle; plane polylines only.";
}

/// The joint parameter: the ratio in which the joint of two sections divides the line between their
/// control points.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum JointParameter {
    /// In the middle, like the implied points of TrueType contours.
    #[default]
    Half,
    /// By the chords to the power of the method's exponent, as in a quadratic B-spline. C1 in those
    /// knots.
    Knot,
    /// By continuous curvature (G2). Sections are cubics in the triangles of the quadratics,
    /// because quadratics lack inflections. At inflections of the polygon the curvature is 0. The
    /// curvature is continuous for plane outlines; in space, curvatures agree in magnitude.
    G2,
}

choices! { for JointParameter:
    Half => "Halves", "Midway between their control points.";
    Knot => "Knots", "In proportion to the lengths of the chords.";
    G2 => "Curvature", "Where the curvature is continuous.";
}

/// The solver of the equations.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Solver {
    /// Closed forms and Newton's method.
    #[default]
    Fast,
    /// The paper's solver: sweeps over the points, with steps along the guide that are refined
    /// tenfold at each change of the deviation's sign. Without a guide, the steps follow the
    /// deviation.
    Step,
}

/// The directions at the ends of an open outline, or of a part that ends at a corner.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Ends {
    /// As the first and last sections give them.
    #[default]
    Free,
    /// Perpendicular to the first and the last chord. The first chord runs from the first point to
    /// the third, the last from the last point but two to the last.
    Perpendicular,
    /// Along the x-axis, in the direction of the first and the last leg.
    Level,
    /// Along the y-axis, in the direction of the first and the last leg.
    Upright,
    /// Level or upright, whichever is closer to the perpendicular of the first or the last chord.
    /// This is the paper's default.
    LevelOrUpright,
}

choices! { for Ends:
    Free => "Free", "As the end sections give.";
    Perpendicular => "Perpendicular", "Perpendicular to the first and the last chord.";
    Level => "Level", "Along the x-axis.";
    Upright => "Upright", "Along the y-axis.";
    LevelOrUpright => "Level or upright", "The one nearer the perpendicular of the first or the last chord.";
}

/// The options of an identification.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Options {
    /// The kind of curve.
    pub curve: CurveKind,
    /// The method that finds the control point of a section.
    pub method: Method,
    /// The condition that sections obey.
    pub lock: Lock,
    /// The joints between neighbouring sections.
    pub joint: JointParameter,
    /// The solver of the equations.
    pub solver: Solver,
    /// The ends of open outlines; constraints take precedence.
    pub ends: Ends,
    /// The parameter of a point stays between this and 1 minus this; 0.001 <= `parameter_limit` <
    /// 1/2. [`None`]: 1/12 for joints of continuous curvature, whose iteration converges more rarely
    /// with a smaller limit; else 0.01. Limits such as 1/6 make loops at points that are close together.
    pub parameter_limit: Option<f64>,
    /// Neighbours closer than this, times the size of the outline, are merged. At least 0.
    pub repeat_tolerance: f64,
    /// A point is a corner if the polygon of the points turns there by more than this angle, in
    /// radians. At pi or more, only constraints make corners.
    pub corner_angle: f64,
    /// Iterations end when all moves are below this, times the size of the outline. The error of
    /// the solution may be a few times larger if an iteration converges slowly.
    pub tolerance: f64,
    /// The maximum number of sweeps or iterations between two corners; at least 1. If they do not
    /// converge, their replacement iterates further.
    pub max_sweeps: u32,
    /// The maximum number of steps of the stepping solver at a point, in one sweep; at least 1.
    pub max_steps: u32,
    /// The first step of the stepping solver, times the size of the outline.
    pub first_step: f64,
    /// The divisor of a step at each change of the deviation's sign; greater than 1.
    pub step_divisor: f64,
    /// Whether to keep the moves and control points of each cycle; see
    /// [`Fit::history`](super::Fit::history) and
    /// [`Fit::history_controls`](super::Fit::history_controls).
    pub history: bool,
}

impl Default for Options {
    fn default() -> Self {
        Options {
            curve: CurveKind::default(),
            method: Method::default(),
            lock: Lock::default(),
            joint: JointParameter::default(),
            solver: Solver::default(),
            ends: Ends::default(),
            parameter_limit: None,
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
    /// Returns the options with [`CurveKind::Chain`] replaced by its equivalent.
    pub(super) fn with_chain_replaced(&self) -> Options {
        match self.curve {
            CurveKind::Chain => Options { curve: CurveKind::Composite, lock: Lock::DataGuide, ..*self },
            _ => *self,
        }
    }

    /// Returns the given or the automatic limit of parameters.
    pub(crate) fn parameter_limit(&self) -> f64 {
        let automatic = if self.joint == JointParameter::G2 { 1.0 / 12.0 } else { 0.01 };
        self.parameter_limit.unwrap_or(automatic)
    }

    /// Checks that all numbers are within their ranges.
    ///
    /// # Errors
    /// [`Error::OptionOutOfRange`].
    pub(crate) fn check_ranges(&self) -> Result<()> {
        let alpha = self.method.chord_exponent().unwrap_or(0.5);
        let fraction = |value: f64| (0.0..1.0).contains(&value);
        let ranges = [
            ("alpha", alpha, (0.0..=1.0).contains(&alpha), "from 0 to 1"),
            (
                "parameter_limit",
                self.parameter_limit(),
                (1e-3..0.5).contains(&self.parameter_limit()),
                "at least 0.001 and below 0.5",
            ),
            ("repeat_tolerance", self.repeat_tolerance, fraction(self.repeat_tolerance), "at least 0 and below 1"),
            ("corner_angle", self.corner_angle, self.corner_angle >= 0.0, "at least 0"),
            ("tolerance", self.tolerance, fraction(self.tolerance), "at least 0 and below 1"),
            ("first_step", self.first_step, self.first_step > 0.0 && self.first_step <= 1.0, "above 0 and at most 1"),
            ("max_sweeps", f64::from(self.max_sweeps), self.max_sweeps > 0, "at least 1"),
            ("max_steps", f64::from(self.max_steps), self.max_steps > 0, "at least 1"),
            (
                "step_divisor",
                self.step_divisor,
                self.step_divisor > 1.0 && self.step_divisor <= 1e6,
                "above 1 and at most 1e6",
            ),
        ];
        ranges
            .into_iter()
            .try_for_each(|(option, value, is_valid, allowed)| Error::require(is_valid, option, value, allowed))
    }
}

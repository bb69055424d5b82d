//! Options of outlines: How curves are chosen, and what became of each point.

use crate::capi::glue::{c_enum, versioned};
use crate::capi::input::choice;
use crate::capi::status::Failure;
use crate::curve::{Ends, JointParameter, Lock, Method, Mode, Options, Solver};

/// The kind of the curve of an outline.
pub type gusset_curve_kind = u32;
/// Quadratic segments, one control point for each point; smooth (G1) everywhere.
pub const GUSSET_CURVE_KIND_COMPOSITE: gusset_curve_kind = 0;
/// One Bezier curve through all points: of degree n through n + 1 points, 1 more for each end
/// tangent, and n + 2 through n points of a closed outline, whose seam is smooth. Above degree 64 a
/// composite curve takes its place. Good for up to some 20 points.
pub const GUSSET_CURVE_KIND_SINGLE: gusset_curve_kind = 1;
/// Neighbouring sections blended linearly: cubic segments from point to point, C1 in the knots of
/// the method's exponent (G1 with the normal). With the bisector the centripetal Catmull-Rom
/// spline.
pub const GUSSET_CURVE_KIND_BLEND_C1: gusset_curve_kind = 2;
/// Neighbouring sections blended smoothly: quintic segments from point to point, C2 (G2 with the
/// normal), but at inner points whose tangent is given: C1 (G1) there.
pub const GUSSET_CURVE_KIND_BLEND_C2: gusset_curve_kind = 3;
/// The cubic spline: cubic segments from point to point, C2 in the knots of the method's exponent,
/// but at inner points whose tangent is given: C1 there.
pub const GUSSET_CURVE_KIND_CUBIC_C2: gusset_curve_kind = 4;
/// The paper's chain: GUSSET_CURVE_KIND_COMPOSITE with GUSSET_LOCK_DATA_GUIDE, whatever lock says. Each
/// control point lies on the guide of its point, the bisector, median or normal that the method
/// names.
pub const GUSSET_CURVE_KIND_CHAIN: gusset_curve_kind = 5;

/// The guide of the control point of a section.
pub type gusset_section_method = u32;
/// The bisector of the angle at the point. For all points. Sections by themselves and
/// GUSSET_LOCK_DATA_GUIDE have their control points on the line that the method names; the other
/// locks take from it the parameter of the point, and control points are near the line.
pub const GUSSET_METHOD_BISECTOR: gusset_section_method = 0;
/// The median. For all points.
pub const GUSSET_METHOD_MEDIAN: gusset_section_method = 1;
/// The normal of the chord; where its foot is outside the chord the bisector takes its place, but
/// for GUSSET_LOCK_SELF_CONSISTENT, where the foot counts as the nearer end of the chord.
pub const GUSSET_METHOD_NORMAL: gusset_section_method = 2;
/// The symmedian. For all points.
pub const GUSSET_METHOD_SYMMEDIAN: gusset_section_method = 3;
/// The parameter of the point is a^alpha / (a^alpha + b^alpha), a and b being the distances from
/// its neighbours: the median at alpha = 0, the bisector at 1/2, the symmedian at 1.
pub const GUSSET_METHOD_ALPHA: gusset_section_method = 4;

/// The rule that fixes the parameters of points.
pub type gusset_parameter_lock = u32;
/// The parameter of a point is that of the method on the triangle of the data. Always solvable. The
/// control point is near the guide of that triangle but not on it.
pub const GUSSET_LOCK_PARAMETER: gusset_parameter_lock = 0;
/// The parameter is that of the method on the section's own triangle. With the normal there may be
/// several solutions; which one is found depends on the solver.
pub const GUSSET_LOCK_SELF_CONSISTENT: gusset_parameter_lock = 1;
/// The control point lies on the guide of the data's triangle, as the paper draws it, where that is
/// possible. Outlines must lie in a plane, any plane; points of others get
/// GUSSET_POINT_OUT_OF_PLANE and the lock by parameter.
pub const GUSSET_LOCK_DATA_GUIDE: gusset_parameter_lock = 2;

/// The parameters of the joints of composite curves.
pub type gusset_joint_parameter = u32;
/// Sections join in the middle between their control points.
pub const GUSSET_JOINT_PARAMETER_HALF: gusset_joint_parameter = 0;
/// By the chords to the power of the method's exponent: the quadratic B-spline in those knots, C1.
pub const GUSSET_JOINT_PARAMETER_KNOT: gusset_joint_parameter = 1;
/// So that the curvature is continuous (G2): cubic segments in the triangles of the quadratics. 0
/// where the control polygon turns the other way. Outlines in a plane; in space curvatures agree in
/// magnitude, and points get GUSSET_POINT_OUT_OF_PLANE.
pub const GUSSET_JOINT_PARAMETER_G2: gusset_joint_parameter = 2;

/// The method that solves for a curve.
pub type gusset_outline_solver = u32;
/// Closed forms and Newton's method.
pub const GUSSET_SOLVER_FAST: gusset_outline_solver = 0;
/// The paper's: steps along the guide, refined where the deviation changes its sign.
pub const GUSSET_SOLVER_STEP: gusset_outline_solver = 1;

/// The ends of open outlines.
pub type gusset_outline_ends = u32;
/// Open outlines begin and end as their first and last sections have it.
pub const GUSSET_ENDS_FREE: gusset_outline_ends = 0;
/// Perpendicular to the first chord, from the first point to the third, and to the last one.
pub const GUSSET_ENDS_PERPENDICULAR: gusset_outline_ends = 1;
/// Along the x-axis, in the sense of the first and the last leg.
pub const GUSSET_ENDS_LEVEL: gusset_outline_ends = 2;
/// Along the y-axis, in the sense of the first and the last leg.
pub const GUSSET_ENDS_UPRIGHT: gusset_outline_ends = 3;
/// Level or upright, whichever is nearer the perpendicular of the first or the last chord.
pub const GUSSET_ENDS_LEVEL_OR_UPRIGHT: gusset_outline_ends = 4;

/// The outcome at a point of an outline.
pub type gusset_point_status = u32;
/// As asked.
pub const GUSSET_POINT_OK: gusset_point_status = 0;
/// Its parameter was brought within the limits.
pub const GUSSET_POINT_CLAMPED_PARAMETER: gusset_point_status = 1;
/// It repeats a point before it (or the first one, at the end of a closed outline), and was left
/// out: the curve passes that one, which is within the tolerance for repeats.
pub const GUSSET_POINT_MERGED: gusset_point_status = 2;
/// It is so near the first or last point of its section that this has no control point by the
/// method; the median took its place.
pub const GUSSET_POINT_REPEATED: gusset_point_status = 3;
/// Its triangle is flat: it has no guide, or no perpendicular.
pub const GUSSET_POINT_COLLINEAR: gusset_point_status = 4;
/// The foot of the normal is outside the chord; the bisector took its place.
pub const GUSSET_POINT_NORMAL_OUTSIDE: gusset_point_status = 5;
/// The foot of the normal is an end of the chord; the bisector took its place.
pub const GUSSET_POINT_RIGHT_ANGLE: gusset_point_status = 6;
/// The curve does not cross the guide.
pub const GUSSET_POINT_NO_CROSSING: gusset_point_status = 7;
/// The tangent runs between points that should be on one side of it.
pub const GUSSET_POINT_TANGENT_SEPARATES: gusset_point_status = 8;
/// The curve would have to run backwards along the tangent.
pub const GUSSET_POINT_TANGENT_BACKWARD: gusset_point_status = 9;
/// The tangent cannot be reached by a quadratic: the point is farther from it than the section's
/// end.
pub const GUSSET_POINT_TANGENT_BEYOND: gusset_point_status = 10;
/// The tangent is not in the plane of the section; or GUSSET_LOCK_DATA_GUIDE or
/// GUSSET_JOINT_PARAMETER_G2 is asked of an outline that is not plane.
pub const GUSSET_POINT_OUT_OF_PLANE: gusset_point_status = 11;
/// The tangent has no direction, and was left out.
pub const GUSSET_POINT_NO_TANGENT: gusset_point_status = 12;
/// The lock could not be kept: its parameter is that of GUSSET_LOCK_PARAMETER.
pub const GUSSET_POINT_FELL_BACK: gusset_point_status = 13;
/// The iteration ended before it was still.
pub const GUSSET_POINT_NOT_CONVERGED: gusset_point_status = 14;
/// The curve misses it: the outline has too few different points, or its equations have no
/// solution.
pub const GUSSET_POINT_MISSED: gusset_point_status = 15;
/// A joint beside it could not be where the option asks for it: it is in the middle between its
/// control points, or, for GUSSET_JOINT_PARAMETER_G2, the curvature there is 0.
pub const GUSSET_POINT_JOINT_FELL_BACK: gusset_point_status = 16;
/// It is on a composite curve, as the single one failed.
pub const GUSSET_POINT_COMPOSITE_INSTEAD: gusset_point_status = 17;
/// A blended curve turns back at it: it stands still there, or leaves the way it came.
pub const GUSSET_POINT_CUSP: gusset_point_status = 18;

/// The outcome of an outline.
pub type gusset_fit_status = u32;
/// As asked.
pub const GUSSET_FIT_OK: gusset_fit_status = 0;
/// Some points are not as asked, in other ways than merged or clamped: see their status.
pub const GUSSET_FIT_PARTIAL: gusset_fit_status = 1;
/// The iteration ended before it was still.
pub const GUSSET_FIT_NOT_CONVERGED: gusset_fit_status = 2;
/// The iteration ran away, or control points are beyond the largest number.
pub const GUSSET_FIT_DIVERGED: gusset_fit_status = 3;
/// The equations are so nearly singular that control points lie far outside the outline.
pub const GUSSET_FIT_ILL_CONDITIONED: gusset_fit_status = 4;
/// Fewer than two different points, or three of a closed outline: there is no curve, or what two
/// points give.
pub const GUSSET_FIT_TOO_FEW_POINTS: gusset_fit_status = 5;
/// A single curve would have a degree above 64; a composite one took its place.
pub const GUSSET_FIT_DEGREE_TOO_HIGH: gusset_fit_status = 6;

/// How outlines are identified; all zero is the default. Lengths are relative to the size of the
/// outline, the longest side of its box.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_outline_options {
    /// sizeof(gusset_outline_options), set by the caller.
    pub struct_size: usize,
    /// The kind of the curve of an outline.
    pub curve: gusset_curve_kind,
    /// The guide of the control point of a section.
    pub method: gusset_section_method,
    /// For composite and single curves; a chain has its own.
    pub lock: gusset_parameter_lock,
    /// For composite curves and chains.
    pub joint: gusset_joint_parameter,
    /// The method that solves for a curve.
    pub solver: gusset_outline_solver,
    /// For open outlines, and parts of them that end at corners; a tangent demanded there
    /// comes first.
    pub ends: gusset_outline_ends,
    /// Read for GUSSET_METHOD_ALPHA; 0 to 1.
    /// @when method GUSSET_METHOD_ALPHA
    pub alpha: f64,
    /// Parameters of composite curves are kept within this and 1 less this: 0.001 to 1/2, or 0 for
    /// 1/6.
    pub parameter_limit: f64,
    /// Neighbours at most so far apart are one point; below 1. 0 for 1e-12. 1e-300 merges equal points
    /// only.
    pub repeat_tolerance: f64,
    /// Points where the polygon turns by more than this angle, in radians, are corners; at least 0,
    /// and 0, pi or more, also INFINITY, for none.
    pub corner_angle: f64,
    /// Iterations end when nothing moves farther, below 1; 0 for 1e-12.
    pub tolerance: f64,
    /// The most sweeps or iterations between two corners; 0 for 200.
    pub max_sweeps: u32,
    /// The most steps at a point in a sweep; 0 for 20,000.
    pub max_steps: u32,
}

versioned! { gusset_outline_options: 80 }

/// The method of the options.
pub(crate) fn method(options: &gusset_outline_options) -> Result<Method, Failure> {
    match options.method {
        GUSSET_METHOD_BISECTOR => Ok(Method::Bisector),
        GUSSET_METHOD_MEDIAN => Ok(Method::Median),
        GUSSET_METHOD_NORMAL => Ok(Method::Normal),
        GUSSET_METHOD_SYMMEDIAN => Ok(Method::Symmedian),
        GUSSET_METHOD_ALPHA => Ok(Method::Alpha(options.alpha)),
        other => Err(Failure::unknown("method", other.into())),
    }
}

c_enum! {
    curve: Mode {
        GUSSET_CURVE_KIND_COMPOSITE => Composite,
        GUSSET_CURVE_KIND_SINGLE => Single,
        GUSSET_CURVE_KIND_BLEND_C1 => BlendC1,
        GUSSET_CURVE_KIND_BLEND_C2 => BlendC2,
        GUSSET_CURVE_KIND_CUBIC_C2 => CubicC2,
        GUSSET_CURVE_KIND_CHAIN => Chain,
    }
    lock: Lock { GUSSET_LOCK_PARAMETER => Parameter, GUSSET_LOCK_SELF_CONSISTENT => SelfConsistent, GUSSET_LOCK_DATA_GUIDE => DataGuide }
    joint: JointParameter { GUSSET_JOINT_PARAMETER_HALF => Half, GUSSET_JOINT_PARAMETER_KNOT => Knot, GUSSET_JOINT_PARAMETER_G2 => G2 }
    solver: Solver { GUSSET_SOLVER_FAST => Fast, GUSSET_SOLVER_STEP => Step }
    ends: Ends {
        GUSSET_ENDS_FREE => Free,
        GUSSET_ENDS_PERPENDICULAR => Perpendicular,
        GUSSET_ENDS_LEVEL => Level,
        GUSSET_ENDS_UPRIGHT => Upright,
        GUSSET_ENDS_LEVEL_OR_UPRIGHT => LevelOrUpright,
    }
}

impl gusset_outline_options {
    pub(crate) fn checked(self) -> Result<Options, Failure> {
        let plain = Options::default();
        let or = |value: f64, default: f64| if value == 0.0 { default } else { value };
        let or_count = |value: u32, default: u32| if value == 0 { default } else { value };
        Ok(Options {
            mode: choice(self.curve)?,
            method: method(&self)?,
            lock: choice(self.lock)?,
            joint: choice(self.joint)?,
            solver: choice(self.solver)?,
            ends: choice(self.ends)?,
            parameter_limit: or(self.parameter_limit, plain.parameter_limit),
            repeat_tolerance: or(self.repeat_tolerance, plain.repeat_tolerance),
            corner_angle: or(self.corner_angle, plain.corner_angle),
            tolerance: or(self.tolerance, plain.tolerance),
            max_sweeps: or_count(self.max_sweeps, plain.max_sweeps),
            max_steps: or_count(self.max_steps, plain.max_steps),
            ..plain
        })
    }
}

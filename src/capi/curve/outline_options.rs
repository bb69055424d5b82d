//! Options of outlines: Kinds of curves, and the outcome at each point.

use crate::capi::glue::{c_enum, constants, versioned};
use crate::capi::input::{read_choice, read_flag};
use crate::capi::status::Failure;
use crate::curve::{CurveKind, Ends, JointParameter, Lock, Method, Options, Solver};

/// Kind of an outline's curve.
pub type gusset_curve_kind = u32;
/// Quadratic segments, G1, one control point for each point.
pub const GUSSET_CURVE_KIND_COMPOSITE: gusset_curve_kind = 0;
/// One Bézier curve, for up to about 20 points. Its degree is n through n + 1 points, plus 1 an end
/// tangent; closed, n + 2 through n points, with a smooth seam. Above degree 64, it is composite.
pub const GUSSET_CURVE_KIND_SINGLE: gusset_curve_kind = 1;
/// Cubic segments that blend adjacent sections linearly: C1 in the knots of the method's exponent,
/// G1 with GUSSET_METHOD_NORMAL. GUSSET_METHOD_BISECTOR gives the centripetal Catmull-Rom spline.
pub const GUSSET_CURVE_KIND_BLEND_C1: gusset_curve_kind = 2;
/// Quintic segments that blend adjacent sections smoothly: C2, G2 with GUSSET_METHOD_NORMAL. At
/// inner points with given tangents only C1 or G1.
pub const GUSSET_CURVE_KIND_BLEND_C2: gusset_curve_kind = 3;
/// Cubic spline, C2 in the knots of the method's exponent. At inner points with given tangents only
/// C1.
pub const GUSSET_CURVE_KIND_CUBIC_C2: gusset_curve_kind = 4;
/// Nadopta's chain: GUSSET_CURVE_KIND_COMPOSITE with GUSSET_LOCK_DATA_GUIDE, regardless of `lock`.
pub const GUSSET_CURVE_KIND_CHAIN: gusset_curve_kind = 5;

/// Guide of a section's control point.
///
/// A section is the quadratic through a point and its neighbours; its guide is a line from the
/// point to their chord. With GUSSET_LOCK_DATA_GUIDE, and for separate sections, the control point
/// lies on the guide. Other locks use only its parameter.
pub type gusset_section_method = u32;
/// The bisector of the angle at the point; always defined.
pub const GUSSET_METHOD_BISECTOR: gusset_section_method = 0;
/// The median; always defined.
pub const GUSSET_METHOD_MEDIAN: gusset_section_method = 1;
/// The normal of the chord. If its foot is outside the chord, the bisector applies
/// (GUSSET_LOCK_SELF_CONSISTENT: the chord's nearer end).
pub const GUSSET_METHOD_NORMAL: gusset_section_method = 2;
/// The symmedian; always defined.
pub const GUSSET_METHOD_SYMMEDIAN: gusset_section_method = 3;
/// Parameter a^alpha / (a^alpha + b^alpha) for the distances a, b from the neighbours: median at
/// alpha = 0, bisector at 1/2, symmedian at 1.
pub const GUSSET_METHOD_ALPHA: gusset_section_method = 4;

/// Rule for the parameters of points.
pub type gusset_parameter_lock = u32;
/// The method's parameter on the triangle of the given points. Always solvable, with control points
/// near the guides.
pub const GUSSET_LOCK_PARAMETER: gusset_parameter_lock = 0;
/// The method's parameter on the section's own triangle. With the normal, solutions depend on the
/// solver.
pub const GUSSET_LOCK_SELF_CONSISTENT: gusset_parameter_lock = 1;
/// Controls on the guides of the given points' triangles, where possible. In outlines that are not
/// planar, points get GUSSET_POINT_OUT_OF_PLANE and GUSSET_LOCK_PARAMETER.
pub const GUSSET_LOCK_DATA_GUIDE: gusset_parameter_lock = 2;

/// Positions of joints of composite curves.
pub type gusset_joint_parameter = u32;
/// Midpoints between control points.
pub const GUSSET_JOINT_PARAMETER_HALF: gusset_joint_parameter = 0;
/// From chords to the power of the method's exponent: the quadratic B-spline in these knots, C1.
pub const GUSSET_JOINT_PARAMETER_KNOT: gusset_joint_parameter = 1;
/// Continuous curvature, by cubic segments in the triangles of the quadratics; 0 at inflections of
/// the control polygon. In outlines that are not planar, only magnitudes agree, and points get
/// GUSSET_POINT_OUT_OF_PLANE.
pub const GUSSET_JOINT_PARAMETER_G2: gusset_joint_parameter = 2;

/// Method of solution.
pub type gusset_outline_solver = u32;
/// Closed forms and Newton's method.
pub const GUSSET_SOLVER_FAST: gusset_outline_solver = 0;
/// Nadopta's steps along the guide, refined where the deviation changes sign.
pub const GUSSET_SOLVER_STEP: gusset_outline_solver = 1;

/// End directions of open outlines.
pub type gusset_outline_ends = u32;
/// From the first and last sections.
pub const GUSSET_ENDS_FREE: gusset_outline_ends = 0;
/// Perpendicular to the first chord (first to third point) and to the last.
pub const GUSSET_ENDS_PERPENDICULAR: gusset_outline_ends = 1;
/// Parallel to the x-axis, in the sense of first and last legs.
pub const GUSSET_ENDS_LEVEL: gusset_outline_ends = 2;
/// Parallel to the y-axis, likewise.
pub const GUSSET_ENDS_UPRIGHT: gusset_outline_ends = 3;
/// Level or upright, whichever is nearer to GUSSET_ENDS_PERPENDICULAR.
pub const GUSSET_ENDS_LEVEL_OR_UPRIGHT: gusset_outline_ends = 4;

/// Outcome at a point of an outline.
pub type gusset_point_status = u32;
/// All demands are met.
pub const GUSSET_POINT_OK: gusset_point_status = 0;
/// The parameter was clamped to its limits.
pub const GUSSET_POINT_CLAMPED_PARAMETER: gusset_point_status = 1;
/// Omitted: it repeats an earlier point (or, at a closed outline's end, the first) within the
/// tolerance.
pub const GUSSET_POINT_MERGED: gusset_point_status = 2;
/// Too near an end of its section for the method; the median was used.
pub const GUSSET_POINT_REPEATED: gusset_point_status = 3;
/// Its triangle is flat and lacks a guide or a perpendicular.
pub const GUSSET_POINT_COLLINEAR: gusset_point_status = 4;
/// The normal's foot is outside the chord; the bisector was used.
pub const GUSSET_POINT_NORMAL_OUTSIDE: gusset_point_status = 5;
/// The normal's foot is an end of the chord; the bisector was used.
pub const GUSSET_POINT_RIGHT_ANGLE: gusset_point_status = 6;
/// The curve does not cross the guide.
pub const GUSSET_POINT_NO_CROSSING: gusset_point_status = 7;
/// The tangent separates points that should be on one side.
pub const GUSSET_POINT_TANGENT_SEPARATES: gusset_point_status = 8;
/// The curve would run backwards along the tangent.
pub const GUSSET_POINT_TANGENT_BACKWARD: gusset_point_status = 9;
/// No quadratic reaches the tangent: the point is farther from it than the section's end.
pub const GUSSET_POINT_TANGENT_BEYOND: gusset_point_status = 10;
/// The tangent is outside the section's plane, or GUSSET_LOCK_DATA_GUIDE or
/// GUSSET_JOINT_PARAMETER_G2 requires a planar outline.
pub const GUSSET_POINT_OUT_OF_PLANE: gusset_point_status = 11;
/// The tangent is zero and was omitted.
pub const GUSSET_POINT_NO_TANGENT: gusset_point_status = 12;
/// The lock failed; GUSSET_LOCK_PARAMETER was used.
pub const GUSSET_POINT_FELL_BACK: gusset_point_status = 13;
/// The iteration did not converge.
pub const GUSSET_POINT_NOT_CONVERGED: gusset_point_status = 14;
/// The curve misses it: too few distinct points, or equations without solution.
pub const GUSSET_POINT_MISSED: gusset_point_status = 15;
/// An adjacent joint has the midpoint of its control points, or curvature 0 with
/// GUSSET_JOINT_PARAMETER_G2.
pub const GUSSET_POINT_JOINT_FELL_BACK: gusset_point_status = 16;
/// The single curve failed; a composite curve was used.
pub const GUSSET_POINT_COMPOSITE_INSTEAD: gusset_point_status = 17;
/// A blended curve has a cusp here.
pub const GUSSET_POINT_CUSP: gusset_point_status = 18;
/// The curve crosses itself here although the points do not. A part between two points crosses
/// itself (status at both), the next part (at the point between), the one after (at both points
/// between), or the parts around a run of close points (at all of these). The last two do not count
/// if the polygon turns by a half turn or more. Loops below a twentieth of a part may be missed. In
/// space, a loop's ends are at most a twentieth of its size apart. The bisector avoids most loops,
/// and repeat_tolerance merges close points.
pub const GUSSET_POINT_LOOPED: gusset_point_status = 19;
/// The distance to the next or previous point is below a hundredth of both distances beside it, or below a
/// ten-thousandth of one. The curve may turn there in any way. `repeat_tolerance` merges such points.
pub const GUSSET_POINT_CROWDED: gusset_point_status = 20;

/// Outcome of an outline.
pub type gusset_fit_status = u32;
/// All demands are met.
pub const GUSSET_FIT_OK: gusset_fit_status = 0;
/// Some points have a status other than OK, merged, clamped, looped or crowded.
pub const GUSSET_FIT_PARTIAL: gusset_fit_status = 1;
/// The iteration did not converge.
pub const GUSSET_FIT_NOT_CONVERGED: gusset_fit_status = 2;
/// The iteration diverged, or control points overflow.
pub const GUSSET_FIT_DIVERGED: gusset_fit_status = 3;
/// The equations are nearly singular; control points lie far outside the outline.
pub const GUSSET_FIT_ILL_CONDITIONED: gusset_fit_status = 4;
/// Fewer than 2 distinct points, or 3 if closed: the curve is empty or fits two points.
pub const GUSSET_FIT_TOO_FEW_POINTS: gusset_fit_status = 5;
/// A single curve would exceed degree 64; a composite curve was used.
pub const GUSSET_FIT_DEGREE_TOO_HIGH: gusset_fit_status = 6;

/// Options of curves through outlines. Lengths are relative to the longest side of the outline's
/// box.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_outline_options {
    /// sizeof(gusset_outline_options).
    pub struct_size: usize,
    /// Kind of an outline's curve.
    pub curve: gusset_curve_kind,
    /// Guide of a section's control point.
    pub method: gusset_section_method,
    /// For composite and single curves.
    pub lock: gusset_parameter_lock,
    /// For composite curves and chains.
    pub joint: gusset_joint_parameter,
    /// Method of solution.
    pub solver: gusset_outline_solver,
    /// For open outlines and parts between corners, without constraints.
    pub ends: gusset_outline_ends,
    /// 0 to 1.
    /// @when method GUSSET_METHOD_ALPHA
    pub alpha: f64,
    /// Composite parameters are clamped to this and 1 - this: at least 0.001, below 1/2; 0: 0.01, or
    /// 1/12 with GUSSET_JOINT_PARAMETER_G2.
    pub parameter_limit: f64,
    /// Largest distance of merged neighbours, below 1; 0: 1e-12. 1e-300 merges equal points only.
    pub repeat_tolerance: f64,
    /// Points where the polygon turns by more are corners; at least 0; 0, or pi and more: none.
    pub corner_angle: f64,
    /// Iterations end when moves are within it; below 1; 0: 1e-12.
    pub tolerance: f64,
    /// Most sweeps or iterations between corners; 0: 200. If they do not converge, their
    /// replacement iterates further.
    pub max_sweeps: u32,
    /// Most steps at a point in a sweep; 0: 20,000.
    pub max_steps: u32,
    /// 1: keeps the cycles for gusset_outline_get_history.
    /// @flag
    pub history: u32,
    /// 0.
    pub reserved: u32,
}

versioned! { gusset_outline_options: 88 reserved }

/// Converts the method in the options.
pub(crate) fn to_section_method(options: &gusset_outline_options) -> Result<Method, Failure> {
    match options.method {
        GUSSET_METHOD_BISECTOR => Ok(Method::Bisector),
        GUSSET_METHOD_MEDIAN => Ok(Method::Median),
        GUSSET_METHOD_NORMAL => Ok(Method::Normal),
        GUSSET_METHOD_SYMMEDIAN => Ok(Method::Symmedian),
        GUSSET_METHOD_ALPHA => Ok(Method::Alpha(options.alpha)),
        other => Err(Failure::unknown_choice(
            "method",
            other,
            &constants![
                GUSSET_METHOD_BISECTOR,
                GUSSET_METHOD_MEDIAN,
                GUSSET_METHOD_NORMAL,
                GUSSET_METHOD_SYMMEDIAN,
                GUSSET_METHOD_ALPHA
            ],
        )),
    }
}

c_enum! {
    curve: CurveKind {
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
            curve: read_choice(self.curve)?,
            method: to_section_method(&self)?,
            lock: read_choice(self.lock)?,
            joint: read_choice(self.joint)?,
            solver: read_choice(self.solver)?,
            ends: read_choice(self.ends)?,
            parameter_limit: (self.parameter_limit != 0.0).then_some(self.parameter_limit),
            repeat_tolerance: or(self.repeat_tolerance, plain.repeat_tolerance),
            corner_angle: or(self.corner_angle, plain.corner_angle),
            tolerance: or(self.tolerance, plain.tolerance),
            max_sweeps: or_count(self.max_sweeps, plain.max_sweeps),
            max_steps: or_count(self.max_steps, plain.max_steps),
            history: read_flag(self.history, "history")?,
            ..plain
        })
    }
}

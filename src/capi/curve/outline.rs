//! Outlines: Passes curves through given points: the inverse problem of Bezier curves.
//!
//! @source Nadopta.

use crate::capi::context::{create, guard, gusset_context, lend};
use crate::capi::curve::outline_options::{gusset_fit_status, gusset_outline_options};
use crate::capi::curve::{gusset_curve, times};
use crate::capi::glue::{fixed, versioned};
use crate::capi::handle::{self, handle};
use crate::capi::input::{self, flag, lent};
use crate::capi::mesh::gusset_indices;
use crate::capi::status::{Failure, gusset_status};
use crate::curve::{
    Constraint, CurveView, Fit, MAX_POINTS, Outlines, PointConstraint, PointStatus, Points, Section, fit,
    visit_sections,
};
use crate::error::Error;
use glam::DVec3;
use gusset_base::alloc;
use std::ffi::c_void;

/// The demand of a constraint.
pub type gusset_constraint_kind = u32;
/// The curve passes the point in the direction of the tangent, of any length but 0.
pub const GUSSET_CONSTRAINT_TANGENT: gusset_constraint_kind = 0;
/// The curve may turn sharply at the point.
pub const GUSSET_CONSTRAINT_CORNER: gusset_constraint_kind = 1;
/// The curve passes the point at the angle tangent[0], in radians counter-clockwise from the
/// x-axis, in the plane of x and y.
pub const GUSSET_CONSTRAINT_TANGENT_ANGLE: gusset_constraint_kind = 2;

/// What is demanded of a curve at a point.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_constraint {
    /// The point, counted over all outlines.
    pub point: u32,
    /// The demand of a constraint.
    pub kind: gusset_constraint_kind,
    /// x, y, z, for GUSSET_CONSTRAINT_TANGENT; z is 0 for plane outlines. For
    /// GUSSET_CONSTRAINT_TANGENT_ANGLE the angle and twice 0.
    pub tangent: [f64; 3],
}

/// Outlines in the caller's memory: all points one after another. Nothing is copied on the way in.
/// The arrays may have any alignment, must be as long as the counts say, and must not change during
/// a call.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_outlines {
    /// sizeof(gusset_outlines), set by the caller.
    pub struct_size: usize,
    /// The coordinates, doubles: x, y or x, y, z at the start of every point_stride bytes; finite.
    pub points: *const c_void,
    /// In bytes; 0 for points without gaps.
    pub point_stride: usize,
    /// The number of points of all outlines, at most 2^30.
    pub point_count: usize,
    /// Where each outline begins, and where the last one ends: outline_count + 1 places, 0 first,
    /// never decreasing. NULL with outline_count 0 for a single outline of all points.
    pub offsets: *const u32,
    /// The number of outlines, or 0.
    pub outline_count: usize,
    /// In ascending order of their points, at most one for each; or NULL. Of points that are merged
    /// the first one's holds.
    pub constraints: *const gusset_constraint,
    /// How many.
    pub constraint_count: usize,
    /// 2 or 3.
    pub dimension: u32,
    /// 1: from the last point of each outline back to its first one; a last point that repeats the
    /// first does no harm. 0: open.
    pub closed: u32,
}

/// The curves of outlines. Opaque and immutable; it keeps nothing of the points.
pub struct gusset_outline(pub(crate) Fit);

handle! { gusset_outline }

impl gusset_outline {
    /// Its curve of that number.
    pub(crate) fn curve(&self, index: usize) -> Result<CurveView<'_>, Failure> {
        if index < self.0.len() { Ok(self.0.curve(index)) } else { Err(Failure::no_such("outline", index)) }
    }
}

/// All curves in one. Pointers are valid until the outline is destroyed.
///
/// Curve k has the control points starts[2 k] to starts[2 k + 2] - 1, x, y, z each (z = 0 for plane
/// outlines), and the ends starts[2 k + 1] to starts[2 k + 3] - 1: segment s of it is the Bezier
/// curve of its control points ends[s] to ends[s + 1], both included, counted from the curve's
/// first one. A closed curve repeats its first control point at its end.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_outline_view {
    /// sizeof(gusset_outline_view), set by the caller.
    pub struct_size: usize,
    /// The number of outlines.
    pub outline_count: usize,
    /// The number of points of all outlines.
    pub point_count: usize,
    /// x, y, z of each control point.
    pub controls: *const f64,
    /// The number of control points.
    pub control_count: usize,
    /// The ends of the segments.
    pub ends: gusset_indices,
    /// Two places for each curve, and two behind the last.
    pub starts: *const usize,
    /// For each point the segment of its curve that it lies on.
    pub segments: gusset_indices,
    /// For each point its parameter there, 0 to 1.
    pub parameters: *const f64,
    /// For each point what became of it: GUSSET_POINT_...
    pub statuses: *const u8,
}

/// The outcome of an outline. All lengths except `size` are relative to `size`.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_outline_report {
    /// sizeof(gusset_outline_report), set by the caller.
    pub struct_size: usize,
    /// The outcome of an outline.
    pub fit: gusset_fit_status,
    /// Sweeps or iterations, the most of any part between corners; 0 for what needs none. At most
    /// max_sweeps of the options.
    pub iterations: u32,
    /// Steps of GUSSET_SOLVER_STEP.
    pub steps: u64,
    /// The longest side of the outline's box, in the unit of the points.
    pub size: f64,
    /// The largest distance of a point from its place on the curve; merged points count as the one
    /// that they repeat.
    pub max_residual: f64,
    /// The largest sine of the angle by which the curve turns at a joint that is to be smooth.
    pub max_joint_sine: f64,
    /// The largest difference of the curvatures on both sides of a joint by
    /// GUSSET_JOINT_PARAMETER_G2, relative to the larger one, or to 1 / size where both are less; 0
    /// for other joints.
    pub max_curvature_gap: f64,
    /// The farthest move of a control point in the last iteration.
    pub last_move: f64,
    /// How many points have another status than GUSSET_POINT_OK.
    pub not_ok_count: u32,
    /// 0.
    pub reserved: u32,
}

versioned! {
    gusset_outlines: 72,
    gusset_outline_view: 96,
    gusset_outline_report: 72,
}
fixed! { gusset_constraint: 32 }

/// The caller's outlines: the points where they are, the rest copied.
pub(crate) struct Given<'a> {
    points: Points<'a>,
    offsets: Option<Vec<u32>>,
    constraints: Vec<Constraint>,
    closed: bool,
}

impl Given<'_> {
    pub(crate) fn read(outlines: *const gusset_outlines) -> Result<Self, Failure> {
        let given = input::read(outlines, false, "outlines")?;
        let closed = flag(given.closed, "closed")?;
        let dimension = given.dimension as usize;
        let size = Points::bytes_needed(given.point_stride, given.point_count, dimension)?;
        let points = input::bytes(given.points, size, 1, "points")?;
        let points = Points::strided(points, given.point_stride, given.point_count, dimension)?;
        Error::check_count("outlines", given.outline_count as u64, MAX_POINTS as u64)?;
        Error::check_count("constraints", given.constraint_count as u64, MAX_POINTS as u64)?;
        let offsets = if given.offsets.is_null() && given.outline_count == 0 {
            None
        } else {
            Some(input::list(given.offsets, given.outline_count + 1, "offsets")?)
        };
        let size = size_of::<gusset_constraint>();
        let bytes = input::bytes(given.constraints.cast(), given.constraint_count, size, "constraints")?;
        let constraints = alloc::try_collect(bytes.chunks_exact(size).map(constraint))?;
        Ok(Given { points, offsets, constraints, closed })
    }

    pub(crate) fn outlines(&self) -> Outlines<'_> {
        let Given { points, offsets, constraints, closed } = self;
        Outlines { points: *points, offsets: offsets.as_deref(), closed: *closed, constraints }
    }
}

fn constraint(bytes: &[u8]) -> Result<Constraint, Failure> {
    let [point, kind]: [u32; 2] = bytemuck::pod_read_unaligned(&bytes[..8]);
    let kind = match kind {
        GUSSET_CONSTRAINT_TANGENT => {
            PointConstraint::Tangent(DVec3::from_array(bytemuck::pod_read_unaligned(&bytes[8..32])))
        }
        GUSSET_CONSTRAINT_CORNER => PointConstraint::Corner,
        GUSSET_CONSTRAINT_TANGENT_ANGLE => PointConstraint::TangentAngle(bytemuck::pod_read_unaligned(&bytes[8..16])),
        other => return Err(Failure::unknown("kind", other.into())),
    };
    Ok(Constraint { point, kind })
}

/// Finds the curves through the points of outlines: control points are sought such that each curve
/// passes the points of its outline.
///
/// A point that cannot be treated as asked is no failure: its status says so, and the curve passes
/// it all the same if that is possible at all.
///
/// @param outlines any number of them.
/// @param options NULL for the defaults: smooth quadratic segments by the bisector, one control
///     point for each point.
/// @errors OUT_OF_RANGE (an option, or the dimension), BAD_STRIDE, BAD_OFFSETS, TOO_LARGE,
///     NOT_FINITE (the report has the point), NO_SUCH_ELEMENT (a constraint whose point does not
///     exist or is not behind the one before; the report has the constraint)
/// @complexity Composite, blended and cubic curves take linear time; linear memory, none for each
///     outline but for its result, and about 1,500 bytes a point of the largest outline with
///     GUSSET_JOINT_PARAMETER_G2.
/// @source Nadopta; the composite and blended readings are ours.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_outline_create(
    context: *const gusset_context,
    outlines: *const gusset_outlines,
    options: *const gusset_outline_options,
    outline: *mut *mut gusset_outline,
) -> gusset_status {
    create(context, outline, "outline", |job| {
        let options = input::read(options, true, "options")?.checked()?;
        let given = Given::read(outlines)?;
        Ok(gusset_outline(fit(&given.outlines(), &options, job)?))
    })
}

/// Destroys what gusset_outline_create made; NULL is allowed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gusset_outline_destroy(outline: *mut gusset_outline) {
    handle::destroy(outline);
}

/// Lends the curves, valid until the outline is destroyed.
///
/// @complexity O(1).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_outline_get_view(
    outline: *const gusset_outline,
    view: *mut gusset_outline_view,
) -> gusset_status {
    lend!(outline, view, |gusset_outline(done)| gusset_outline_view {
        struct_size: size_of::<gusset_outline_view>(),
        outline_count: done.len(),
        point_count: done.parameters().len(),
        controls: lent(done.points()).cast(),
        control_count: done.points().len(),
        ends: gusset_indices::lend(done.ends()),
        starts: lent(done.starts().as_flattened()),
        segments: gusset_indices::lend(done.segments()),
        parameters: lent(done.parameters()),
        statuses: lent(done.statuses()).cast(),
    })
}

/// The account of outline `index`.
///
/// @param index its number, from 0.
/// @errors NO_SUCH_ELEMENT
/// @complexity O(1).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_outline_get_report(
    outline: *const gusset_outline,
    index: usize,
    report: *mut gusset_outline_report,
) -> gusset_status {
    lend!(outline, report, |gusset_outline(done)| {
        let report = done.reports().get(index).ok_or_else(|| Failure::no_such("outline", index))?;
        gusset_outline_report {
            struct_size: size_of::<gusset_outline_report>(),
            fit: report.status as gusset_fit_status,
            iterations: report.iterations,
            steps: report.steps,
            size: report.size,
            max_residual: report.max_residual,
            max_joint_sine: report.max_joint_sine,
            max_curvature_gap: report.max_curvature_gap,
            last_move: report.last_move,
            not_ok_count: report.not_ok,
            reserved: 0,
        }
    })
}

/// Copies the curve of outline `index`. gusset_curve_measure of the copy has girth, area and centre.
///
/// @param index its number, from 0.
/// @errors NO_SUCH_ELEMENT
/// @complexity O(segments).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_outline_curve_create(
    context: *const gusset_context,
    outline: *const gusset_outline,
    index: usize,
    curve: *mut *mut gusset_curve,
) -> gusset_status {
    create(context, curve, "curve", |job| {
        Ok(gusset_curve(handle::get(outline, "outline")?.curve(index)?.to_owned_cancellable(job)?))
    })
}

/// Finds the section of each point with its two neighbours: the quadratic through the three whose
/// control point lies on the guide of the method.
///
/// A tangent demanded at a point makes its section pass in that direction; one at the first or last
/// point of an open outline is that of the neighbour's section there. Where it cannot be had, or
/// the normal, the method (the bisector) takes its place, and the status says so.
///
/// @param outlines the outlines.
/// @param options NULL for the defaults; method, alpha and solver are read, and by
///     GUSSET_SOLVER_STEP tolerance and max_steps; all must be valid.
/// @param controls receives x, y, z of each point's control point; the ends of open outlines, which
///     have no section, have themselves. NULL: not wanted. Unspecified on failure.
/// @param parameters receives the parameter of each point on its section; 0 and 1 at the ends of
///     open outlines. NULL: not wanted. Unspecified on failure.
/// @param statuses receives GUSSET_POINT_... of each point. NULL: not wanted. Unspecified on failure.
/// @param steps receives the steps of GUSSET_SOLVER_STEP, of all sections. NULL: not wanted.
/// @errors as gusset_outline_create
/// @complexity O(n); no memory.
/// @source Nadopta, the methods of the normal, tangent, bisector and median; closed forms: B = P +
///     (P - S) / (2 sqrt(s (1 - s))) for the foot S = A + s (C - A) of the guide.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_outlines_find_sections(
    context: *const gusset_context,
    outlines: *const gusset_outlines,
    options: *const gusset_outline_options,
    controls: *mut f64,
    parameters: *mut f64,
    statuses: *mut u8,
    steps: *mut u64,
) -> gusset_status {
    let steps = input::optional_output(steps, 0, "steps");
    guard(context, |job| {
        let steps = steps?;
        let options = input::read(options, true, "options")?.checked()?;
        let given = Given::read(outlines)?;
        let outlines = given.outlines();
        let count = outlines.points.len();
        let mut controls = room(controls, (count, 3), "controls")?.chunks_exact_mut(3);
        let mut parameters = room(parameters, (count, 1), "parameters")?.iter_mut();
        let mut statuses = room(statuses, (count, 1), "statuses")?.iter_mut();
        let visit = |section: Section, status: PointStatus| {
            controls.next().into_iter().for_each(|to| to.copy_from_slice(&section.control.to_array()));
            parameters.next().into_iter().for_each(|to| *to = section.t);
            statuses.next().into_iter().for_each(|to| *to = status as u8);
        };
        input::set(steps, visit_sections(&outlines, &options, visit, job)?);
        Ok(())
    })
}

/// The caller's buffer for `each` numbers a point; none if it is NULL.
fn room<'a, T: bytemuck::Pod>(
    out: *mut T,
    (count, each): (usize, usize),
    name: &'static str,
) -> Result<&'a mut [T], Failure> {
    input::results(out, if out.is_null() { 0 } else { times(count, each, name)? }, name)
}

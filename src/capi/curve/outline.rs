//! Outlines: Curves through given points.
//!
//! @source Nadopta.

use crate::capi::context::{create_handle, guard_call, gusset_context, lend};
use crate::capi::curve::gusset_curve;
use crate::capi::curve::outline_options::{gusset_fit_status, gusset_outline_options};
use crate::capi::glue::{constants, fixed, versioned};
use crate::capi::handle::{self, handle};
use crate::capi::input::{self, lend_list, read_flag};
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

/// Demand on a curve at a point.
pub type gusset_constraint_kind = u32;
/// Direction `tangent`, not 0.
pub const GUSSET_CONSTRAINT_TANGENT: gusset_constraint_kind = 0;
/// A corner is allowed.
pub const GUSSET_CONSTRAINT_CORNER: gusset_constraint_kind = 1;
/// Direction at the angle tangent[0], counter-clockwise from the x-axis in the xy plane.
pub const GUSSET_CONSTRAINT_TANGENT_ANGLE: gusset_constraint_kind = 2;

/// A constraint at a point.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_constraint {
    /// Point, counted over all outlines.
    pub point: u32,
    /// Demand on a curve at a point.
    pub kind: gusset_constraint_kind,
    /// A vector (z = 0 in plane outlines), or angle, 0, 0.
    pub tangent: [f64; 3],
}

/// Outlines in the caller's arrays.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_outlines {
    /// sizeof(gusset_outlines).
    pub struct_size: usize,
    /// Doubles x, y or x, y, z.
    pub points: *const c_void,
    /// Stride of points.
    pub point_stride: usize,
    /// Points of all outlines, at most 2^30.
    pub point_count: usize,
    /// Offsets into points, by outline. NULL with outline_count 0: one outline.
    pub offsets: *const u32,
    /// Number of outlines.
    pub outline_count: usize,
    /// Ascending by point, at most one each; or NULL. The first of merged points counts.
    pub constraints: *const gusset_constraint,
    /// Number of constraints.
    pub constraint_count: usize,
    /// 2 or 3.
    pub dimension: u32,
    /// 1: outlines return to their first points, which may be repeated at the end.
    pub closed: u32,
}

/// Curves through outlines.
pub struct gusset_outline(pub(crate) Fit);

handle! { gusset_outline }

impl gusset_outline {
    /// Returns the curve of an outline.
    pub(crate) fn curve_through_outline(&self, outline: usize) -> Result<CurveView<'_>, Failure> {
        if outline < self.0.len() {
            Ok(self.0.curve(outline))
        } else {
            Err(Failure::no_such_element("outline", outline, self.0.len()))
        }
    }
}

/// Lent curves.
///
/// Curve k has the controls starts[2k] to starts[2k + 2] - 1, and the ends starts[2k + 1] to
/// starts[2k + 3] - 1. Its segment s has controls ends[s] to ends[s + 1], counted from the curve's
/// first. A closed curve repeats its first control at the end.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_outline_view {
    /// sizeof(gusset_outline_view).
    pub struct_size: usize,
    /// Number of outlines.
    pub outline_count: usize,
    /// Number of points.
    pub point_count: usize,
    /// Control points; z = 0 for plane outlines.
    /// @shape control_count 3
    pub controls: *const f64,
    /// Number of control points.
    pub control_count: usize,
    /// Ends of segments.
    pub ends: gusset_indices,
    /// Two offsets a curve, and two more.
    /// @shape outline_count+1 2
    pub starts: *const usize,
    /// Segment of each point.
    pub segments: gusset_indices,
    /// Parameter of each point, 0 to 1.
    /// @shape point_count
    pub parameters: *const f64,
    /// gusset_point_status of each point.
    /// @shape point_count
    /// @choice gusset_point_status
    pub statuses: *const u8,
}

/// Outcome and accuracy of an outline. Lengths except `size` are relative to `size`.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_outline_report {
    /// sizeof(gusset_outline_report).
    pub struct_size: usize,
    /// Outcome of an outline.
    pub fit: gusset_fit_status,
    /// Most sweeps or iterations between corners, at most max_sweeps. A replacement of a solver that
    /// fails does not count.
    pub iterations: u32,
    /// Steps of GUSSET_SOLVER_STEP.
    pub steps: u64,
    /// Longest side of the outline's box.
    pub size: f64,
    /// Largest distance of a point from the curve at its parameter; merged points count as their
    /// originals.
    pub max_residual: f64,
    /// Largest sine of the angle between tangents at a smooth joint.
    pub max_joint_sine: f64,
    /// GUSSET_JOINT_PARAMETER_G2: largest difference of curvatures at a joint, relative to the
    /// larger, at least to 1 / size. Else 0.
    pub max_curvature_gap: f64,
    /// Largest move of a control point in the last iteration.
    pub last_move: f64,
    /// Points that are not GUSSET_POINT_OK.
    pub not_ok_count: u32,
    /// 0.
    pub reserved: u32,
}

/// A cycle of an iteration: a sweep over the points, or an iteration of Newton's method.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_outline_cycle {
    /// Largest move of a control point, relative to the size of the outline.
    pub moved: f64,
    /// Steps of GUSSET_SOLVER_STEP up to the end of this cycle.
    pub steps: u64,
    /// Number of control points of this cycle and all earlier ones.
    pub control_end: u64,
}

/// Lent cycles of an outline, in order, from corner to corner. Cycles of a start or a replacement
/// of the solver are left out.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_outline_history {
    /// sizeof(gusset_outline_history).
    pub struct_size: usize,
    /// The cycles.
    /// @shape cycle_count
    pub cycles: *const gusset_outline_cycle,
    /// Number of cycles; 0 unless the option history was 1. Without corners, at most the iterations
    /// of the report: an iteration that fails has no cycle.
    pub cycle_count: usize,
    /// Control points after each cycle. A single curve has all its own, also if a composite curve
    /// replaces it. A composite curve has one for each distinct point; at open ends, the point or
    /// the control point on the end's tangent.
    /// @shape control_count 3
    pub controls: *const f64,
    /// Number of control points.
    pub control_count: usize,
}

versioned! {
    gusset_outlines: 72,
    gusset_outline_view: 96,
    gusset_outline_report: 72,
    gusset_outline_history: 40,
}
fixed! {
    gusset_constraint: 32,
    gusset_outline_cycle: 24,
}

/// The caller's outlines: the points in place, everything else copied.
pub(crate) struct GivenOutlines<'a> {
    points: Points<'a>,
    offsets: Option<Vec<u32>>,
    constraints: Vec<Constraint>,
    closed: bool,
}

impl GivenOutlines<'_> {
    pub(crate) fn read_outlines(outlines: *const gusset_outlines) -> Result<Self, Failure> {
        let given = input::read_versioned_struct(outlines, false, "outlines")?;
        let closed = read_flag(given.closed, "closed")?;
        let dimension = given.dimension as usize;
        let size = Points::bytes_needed(given.point_stride, given.point_count, dimension)?;
        let points = input::input_bytes(given.points, size, 1, "points")?;
        let points = Points::strided(points, given.point_stride, given.point_count, dimension)?;
        Error::check_count("outlines", given.outline_count as u64, MAX_POINTS as u64)?;
        Error::check_count("constraints", given.constraint_count as u64, MAX_POINTS as u64)?;
        let offsets = if given.offsets.is_null() && given.outline_count == 0 {
            None
        } else {
            Some(input::copy_input_items(given.offsets, given.outline_count + 1, "offsets")?)
        };
        let size = size_of::<gusset_constraint>();
        let bytes = input::input_bytes(given.constraints.cast(), given.constraint_count, size, "constraints")?;
        let constraints = alloc::try_collect(bytes.chunks_exact(size).map(constraint_from_struct_bytes))?;
        Ok(GivenOutlines { points, offsets, constraints, closed })
    }

    pub(crate) fn as_outlines(&self) -> Outlines<'_> {
        let GivenOutlines { points, offsets, constraints, closed } = self;
        Outlines { points: *points, offsets: offsets.as_deref(), closed: *closed, constraints }
    }
}

fn constraint_from_struct_bytes(bytes: &[u8]) -> Result<Constraint, Failure> {
    let [point, kind]: [u32; 2] = bytemuck::pod_read_unaligned(&bytes[..8]);
    let kind = match kind {
        GUSSET_CONSTRAINT_TANGENT => {
            PointConstraint::Tangent(DVec3::from_array(bytemuck::pod_read_unaligned(&bytes[8..32])))
        }
        GUSSET_CONSTRAINT_CORNER => PointConstraint::Corner,
        GUSSET_CONSTRAINT_TANGENT_ANGLE => PointConstraint::TangentAngle(bytemuck::pod_read_unaligned(&bytes[8..16])),
        other => {
            return Err(Failure::unknown_choice(
                "kind",
                other,
                &constants![GUSSET_CONSTRAINT_TANGENT, GUSSET_CONSTRAINT_CORNER, GUSSET_CONSTRAINT_TANGENT_ANGLE],
            ));
        }
    };
    Ok(Constraint { point, kind })
}

/// Fits a Bézier curve through the points of each outline.
///
/// Constraints that cannot be met show in statuses; the curve still passes through the point if
/// possible.
///
/// @errors OUT_OF_RANGE (option, dimension), BAD_STRIDE, BAD_OFFSETS, TOO_LARGE, NOT_FINITE
///     (point), NO_SUCH_ELEMENT (constraint: no such point, or out of order)
/// @complexity O(points) for composite, blended and cubic curves. GUSSET_JOINT_PARAMETER_G2: about
///     1,500 bytes a point of the largest outline.
/// @source T. Nadopta.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_outline_create(
    context: *const gusset_context,
    outlines: *const gusset_outlines,
    options: *const gusset_outline_options,
    outline: *mut *mut gusset_outline,
) -> gusset_status {
    create_handle(context, outline, "outline", |job| {
        let options = input::read_versioned_struct(options, true, "options")?.checked()?;
        let given = GivenOutlines::read_outlines(outlines)?;
        Ok(gusset_outline(fit(&given.as_outlines(), &options, job)?))
    })
}

/// Frees curves of outlines.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gusset_outline_destroy(outline: *mut gusset_outline) {
    handle::destroy(outline);
}

/// Lends the curves.
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
        controls: lend_list(done.points()).cast(),
        control_count: done.points().len(),
        ends: gusset_indices::lend_indices(done.ends()),
        starts: lend_list(done.starts().as_flattened()),
        segments: gusset_indices::lend_indices(done.segments()),
        parameters: lend_list(done.parameters()),
        statuses: lend_list(done.statuses()).cast(),
    })
}

/// Reports on one outline.
///
/// @errors NO_SUCH_ELEMENT
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_outline_get_report(
    outline: *const gusset_outline,
    index: usize,
    report: *mut gusset_outline_report,
) -> gusset_status {
    lend!(outline, report, |gusset_outline(done)| {
        let no_such = || Failure::no_such_element("outline", index, done.len());
        let report = done.reports().get(index).ok_or_else(no_such)?;
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

/// Lends the cycles of one outline.
///
/// @errors NO_SUCH_ELEMENT
/// @complexity O(1).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_outline_get_history(
    outline: *const gusset_outline,
    index: usize,
    history: *mut gusset_outline_history,
) -> gusset_status {
    lend!(outline, history, |done| {
        done.curve_through_outline(index)?;
        let (cycles, controls) = (done.0.history(index), done.0.history_controls(index));
        gusset_outline_history {
            struct_size: size_of::<gusset_outline_history>(),
            cycles: lend_list(cycles).cast(),
            cycle_count: cycles.len(),
            controls: lend_list(controls).cast(),
            control_count: controls.len(),
        }
    })
}

/// Copies the curve of one outline.
///
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
    create_handle(context, curve, "curve", |job| {
        Ok(gusset_curve(
            handle::get_object(outline, "outline")?.curve_through_outline(index)?.to_owned_cancellable(job)?,
        ))
    })
}

/// Finds the section of each point, with its control point on the method's guide.
///
/// A tangent constraint sets the section's direction at its point; at an open end, the neighbour's
/// section there. If it fails, the method applies; if the normal fails, the bisector. The status
/// says so. Outputs may be NULL.
///
/// @param options all valid; only method, alpha and solver are read, with GUSSET_SOLVER_STEP also
///     tolerance and max_steps.
/// @param controls receives the control points; at open ends, the points.
/// @param parameters receives each point's parameter on its section; at open ends, 0 and 1.
/// @param statuses receives the gusset_point_status of each point.
/// @param steps receives the number of steps of GUSSET_SOLVER_STEP.
/// @errors as gusset_outline_create
/// @complexity O(n); no memory.
/// @source Nadopta; B = P + (P - S) / (2 sqrt(s (1 - s))) for the foot S = A + s (C - A) of the
///     guide.
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
    let steps = input::cleared_optional_output(steps, 0, "steps");
    guard_call(context, |job| {
        let steps = steps?;
        let options = input::read_versioned_struct(options, true, "options")?.checked()?;
        let given = GivenOutlines::read_outlines(outlines)?;
        let outlines = given.as_outlines();
        let count = outlines.points.len();
        let mut controls = optional_result_buffer(controls, (count, 3), "controls")?.chunks_exact_mut(3);
        let mut parameters = optional_result_buffer(parameters, (count, 1), "parameters")?.iter_mut();
        let mut statuses = optional_result_buffer(statuses, (count, 1), "statuses")?.iter_mut();
        let visit = |section: Section, status: PointStatus| {
            controls.next().into_iter().for_each(|to| to.copy_from_slice(&section.control.to_array()));
            parameters.next().into_iter().for_each(|to| *to = section.t);
            statuses.next().into_iter().for_each(|to| *to = status as u8);
        };
        input::set_optional_output(steps, visit_sections(&outlines, &options, visit, job)?);
        Ok(())
    })
}

/// Returns the caller's buffer for `each` numbers a point; `None` if it is NULL.
fn optional_result_buffer<'a, T: bytemuck::Pod>(
    out: *mut T,
    (count, each): (usize, usize),
    name: &'static str,
) -> Result<&'a mut [T], Failure> {
    input::result_buffer(out, if out.is_null() { 0 } else { input::checked_product(count, each, name)? }, name)
}

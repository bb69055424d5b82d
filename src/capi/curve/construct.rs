//! C interface: curves made of curves.

use crate::capi::context::{create, create_and_tell, gusset_context};
use crate::capi::curve::{gusset_curve, gusset_place, view};
use crate::capi::glue::versioned;
use crate::capi::input::{self, flag};
use crate::capi::status::{Failure, gusset_status};
use crate::curve::ops::OffsetOptions;
use crate::job::Job;

/// How an offset is fitted.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_offset_options {
    /// sizeof(gusset_offset_options), set by the caller.
    pub struct_size: usize,
    /// The deviation aimed at, above 0, in the unit of the points.
    pub tolerance: f64,
    /// No segment is halved once there are so many; 0 for 65536.
    pub max_segments: usize,
    /// The degree of the segments, 2 or 3; 0 for 3.
    pub degree: u32,
    /// 0.
    pub reserved: u32,
}

/// What is said about an offset.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_offset_report {
    /// sizeof(gusset_offset_report), set by the caller.
    pub struct_size: usize,
    /// How far the curve is from the true offset, as measured at 16 places inside each segment.
    pub deviation: f64,
    /// The number of corners of the original, bridged by straight segments.
    pub corners: usize,
    /// 1 if the deviation is within the tolerance.
    pub reached: u32,
    /// 1 if somewhere the radius of curvature is at most the distance: the offset has cusps or runs
    /// backwards there.
    pub tight: u32,
}

versioned! { gusset_offset_options: 32 reserved, gusset_offset_report: 32 }

impl gusset_offset_options {
    fn checked(self) -> Result<OffsetOptions, Failure> {
        let degree = if self.degree == 0 { 3 } else { self.degree as usize };
        let max_segments = if self.max_segments == 0 { 1 << 16 } else { self.max_segments };
        Ok(OffsetOptions { degree, tolerance: self.tolerance, max_segments })
    }
}

/// The part of a curve from one place to another, open.
///
/// On a closed curve it may run over the start, and from a place to itself it goes round once.
///
/// @param context threads, progress, cancellation and error report; NULL for the defaults.
/// @param curve the curve.
/// @param from where it begins.
/// @param to where it ends.
/// @param[out] part receives the result, for gusset_curve_destroy, as for all functions of this
///     group; NULL on failure.
/// @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, NO_SUCH_ELEMENT (place 0 is
///     from, 1 is to), OUT_OF_RANGE (an open curve, and to before from), UNKNOWN_VALUE, TOO_LARGE,
///     OUT_OF_MEMORY, CANCELLED.
/// @complexity O(points).
/// @since 0.1
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_curve_part_create(
    context: *const gusset_context,
    curve: *const gusset_curve,
    from: gusset_place,
    to: gusset_place,
    part: *mut *mut gusset_curve,
) -> gusset_status {
    create(context, part, "part", |job| {
        Ok(gusset_curve(view(curve, "curve")?.sub_curve(from.checked()?, to.checked()?, job)?))
    })
}

/// The part of a curve before a place, or the part after it; both are open.
///
/// @param context threads, progress, cancellation and error report; NULL for the defaults.
/// @param curve the curve.
/// @param at the place.
/// @param after 0 for the part before it, 1 for the part after it.
/// @param[out] part receives the result, for gusset_curve_destroy; NULL on failure.
/// @return GUSSET_OK, or an error: those of gusset_curve_part_create.
/// @complexity O(points).
/// @since 0.1
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_curve_split_create(
    context: *const gusset_context,
    curve: *const gusset_curve,
    at: gusset_place,
    after: u32,
    part: *mut *mut gusset_curve,
) -> gusset_status {
    create(context, part, "part", |job| {
        let [first, second] = view(curve, "curve")?.split(at.checked()?, job)?;
        Ok(gusset_curve(if flag(after, "after")? { second } else { first }))
    })
}

/// The same curve run through from its end to its start.
///
/// @param context threads, progress, cancellation and error report; NULL for the defaults.
/// @param curve the curve.
/// @param[out] reversed receives the result, for gusset_curve_destroy; NULL on failure.
/// @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, OUT_OF_MEMORY, CANCELLED.
/// @complexity O(points).
/// @since 0.1
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_curve_reverse_create(
    context: *const gusset_context,
    curve: *const gusset_curve,
    reversed: *mut *mut gusset_curve,
) -> gusset_status {
    create(context, reversed, "reversed", |job| Ok(gusset_curve(view(curve, "curve")?.reversed(job)?)))
}

/// The same curve with higher degrees: every segment's raised by `by`, or if `by` is 0 those below
/// `to` raised to it.
///
/// @param context threads, progress, cancellation and error report; NULL for the defaults.
/// @param curve the curve.
/// @param by how much each segment is raised, or 0.
/// @param to if `by` is 0: the degree, 1 to 64.
/// @param[out] elevated receives the result, for gusset_curve_destroy; NULL on failure.
/// @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, OUT_OF_RANGE (a degree above
///     64, or to is 0), TOO_LARGE, OUT_OF_MEMORY, CANCELLED.
/// @complexity O(degree) for each new control point.
/// @since 0.1
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_curve_elevate_create(
    context: *const gusset_context,
    curve: *const gusset_curve,
    by: u32,
    to: u32,
    elevated: *mut *mut gusset_curve,
) -> gusset_status {
    create(context, elevated, "elevated", |job| {
        let view = view(curve, "curve")?;
        Ok(gusset_curve(if by > 0 { view.elevated_by(by as usize, job)? } else { view.elevated_to(to as usize, job)? }))
    })
}

/// The curve with segments of a lower degree, by least squares with fixed ends.
///
/// @param context threads, progress, cancellation and error report; NULL for the defaults.
/// @param curve the curve.
/// @param degree of each at most, 1 to 64.
/// @param tolerance segments that would deviate by more are kept; at least 0, in the unit of the
///     points; infinity is allowed.
/// @param[out] deviations receives a bound on the deviation of each segment from the original, of a
///     kept one what it would have been; NULL if it is not wanted.
/// @param[out] reduced receives the result, for gusset_curve_destroy; NULL on failure.
/// @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, OUT_OF_RANGE (degree,
///     tolerance), OUT_OF_MEMORY, CANCELLED.
/// @complexity O(degree^3) a segment.
/// @since 0.1
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_curve_reduce_create(
    context: *const gusset_context,
    curve: *const gusset_curve,
    degree: u32,
    tolerance: f64,
    deviations: *mut f64,
    reduced: *mut *mut gusset_curve,
) -> gusset_status {
    create(context, reduced, "reduced", |job| {
        let done = view(curve, "curve")?.reduced(degree as usize, tolerance, job)?;
        if !deviations.is_null() {
            input::results(deviations, done.deviations.len(), "deviations")?.copy_from_slice(&done.deviations);
        }
        Ok(gusset_curve(done.curve))
    })
}

/// The curve beside a plane curve, re-fitted by segments with common tangents.
///
/// Places where it crosses itself are not removed.
///
/// @param context threads, progress, cancellation and error report; NULL for the defaults.
/// @param curve the curve.
/// @param distance how far to the left of it, to the right if negative; in the unit of the points,
///     finite.
/// @param options its tolerance must be given.
/// @param[out] report what became of it; NULL if it is not wanted.
/// @param[out] offset receives the result, for gusset_curve_destroy; NULL on failure.
/// @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE,
///     UNKNOWN_VALUE, CURVE_NOT_PLANE, EMPTY_CURVE, OUT_OF_RANGE (distance, tolerance, degree),
///     TOO_LARGE, OUT_OF_MEMORY, CANCELLED.
/// @complexity O(degree) for each of the places measured.
/// @since 0.1
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_curve_offset_create(
    context: *const gusset_context,
    curve: *const gusset_curve,
    distance: f64,
    options: *const gusset_offset_options,
    report: *mut gusset_offset_report,
    offset: *mut *mut gusset_curve,
) -> gusset_status {
    let out = (!report.is_null()).then(|| input::output_struct(report, "report")).transpose();
    let moved = |job: &Job<'_>| {
        let out = out?;
        let options = input::read(options, false, "options")?.checked()?;
        let done = view(curve, "curve")?.offset(distance, &options, job)?;
        let told = gusset_offset_report {
            struct_size: 0,
            deviation: done.deviation,
            corners: done.corners,
            reached: done.reached.into(),
            tight: done.tight.into(),
        };
        Ok((gusset_curve(done.curve), out.map(|out| (out, told))))
    };
    create_and_tell(context, offset, "offset", moved, |told| {
        if let Some((out, report)) = told {
            out.write(report);
        }
    })
}

//! Curves from curves: Parts, other degrees, offsets.

use crate::capi::context::{create, create_and_tell, gusset_context};
use crate::capi::curve::{gusset_curve, gusset_place, view};
use crate::capi::glue::versioned;
use crate::capi::input;
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
/// On a closed curve the part may run over the start, and from a place to itself it goes round once. A
/// curve of n segments ends at segment n - 1 and t = 1.
///
/// @param from where it begins.
/// @param to where it ends.
/// @param part receives the result, for gusset_curve_destroy, as for all functions of this group;
///     NULL on failure.
/// @errors NO_SUCH_ELEMENT (place 0 is from, 1 is to), OUT_OF_RANGE (an open curve, and to before
///     from), TOO_LARGE
/// @complexity O(points).
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

/// The same curve run through from its end to its start.
///
/// @complexity O(points).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_curve_reverse_create(
    context: *const gusset_context,
    curve: *const gusset_curve,
    reversed: *mut *mut gusset_curve,
) -> gusset_status {
    create(context, reversed, "reversed", |job| Ok(gusset_curve(view(curve, "curve")?.reversed(job)?)))
}

/// Changes the degrees of a curve's segments: lower degrees are raised, higher ones lowered.
///
/// A raised segment stays the same curve. A lowered segment is fitted by least squares with fixed ends.
///
/// @param lowest segments of a lower degree are raised to this, 1 to 64; 1 raises none.
/// @param highest segments of a higher degree are lowered to this, lowest to 64; 64 lowers none.
/// @param tolerance segments that would deviate by more are not lowered; at least 0, in the unit of
///     the points; infinity is allowed.
/// @param deviations receives for each segment a bound on its deviation from the original. A
///     segment that was kept has the deviation that lowering would cost. NULL if it is not wanted.
/// @errors OUT_OF_RANGE (a degree, tolerance), TOO_LARGE
/// @complexity O(degree) for each new control point of a raised segment, O(degree^3) a lowered
///     segment.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_curve_change_degree_create(
    context: *const gusset_context,
    curve: *const gusset_curve,
    lowest: u32,
    highest: u32,
    tolerance: f64,
    deviations: *mut f64,
    changed: *mut *mut gusset_curve,
) -> gusset_status {
    create(context, changed, "changed", |job| {
        let done = view(curve, "curve")?.with_degrees([lowest as usize, highest as usize], tolerance, job)?;
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
/// @param distance how far to the left of it, to the right if negative; in the unit of the points,
///     finite.
/// @param options its tolerance must be given.
/// @param report what became of it; NULL if it is not wanted.
/// @errors CURVE_NOT_PLANE, EMPTY_CURVE, OUT_OF_RANGE (distance, tolerance, degree), TOO_LARGE
/// @complexity O(degree) for each of the places measured.
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

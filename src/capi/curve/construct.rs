//! Curves from curves: Parts, other degrees, offsets.

use crate::capi::context::{create_handle, create_handle_and_outputs, gusset_context};
use crate::capi::curve::{gusset_curve, gusset_place, view_of_curve};
use crate::capi::glue::versioned;
use crate::capi::input;
use crate::capi::status::{Failure, gusset_status};
use crate::curve::ops::OffsetOptions;
use crate::job::Job;

/// Options of gusset_curve_offset_create.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_offset_options {
    /// sizeof(gusset_offset_options).
    pub struct_size: usize,
    /// Wanted deviation, above 0.
    pub tolerance: f64,
    /// Halving stops at this many segments; 0: 65536.
    pub max_segments: usize,
    /// Degree of segments, 2 or 3; 0: 3.
    pub degree: u32,
    /// 0.
    pub reserved: u32,
}

/// Accuracy of an offset.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_offset_report {
    /// sizeof(gusset_offset_report).
    pub struct_size: usize,
    /// Largest distance from the true offset, at 16 places a segment.
    pub deviation: f64,
    /// Corners of the original, bridged straight.
    pub corners: usize,
    /// 1: the deviation is within the tolerance.
    /// @flag
    pub reached: u32,
    /// 1: a radius of curvature is at most the distance: the offset has cusps or runs backwards.
    /// @flag
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

/// Cuts an open part out of a curve.
///
/// On a closed curve the part may pass the start; if from equals to, it is the whole. A curve ends
/// at its last segment, t = 1.
///
/// @errors NO_SUCH_ELEMENT (0: from, 1: to), OUT_OF_RANGE (to precedes from on an open curve),
///     TOO_LARGE
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
    create_handle(context, part, "part", |job| {
        Ok(gusset_curve(view_of_curve(curve, "curve")?.sub_curve(from.checked()?, to.checked()?, job)?))
    })
}

/// Reverses a curve.
///
/// @complexity O(points).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_curve_reverse_create(
    context: *const gusset_context,
    curve: *const gusset_curve,
    reversed: *mut *mut gusset_curve,
) -> gusset_status {
    create_handle(context, reversed, "reversed", |job| Ok(gusset_curve(view_of_curve(curve, "curve")?.reversed(job)?)))
}

/// Raises and lowers degrees of segments.
///
/// Raising is exact. Lowering is a least-squares fit with fixed ends.
///
/// @param lowest least degree, 1 to 64.
/// @param highest greatest degree, lowest to 64.
/// @param tolerance largest deviation of lowered segments; at least 0, or INFINITY.
/// @param deviations receives a bound of each segment's deviation; if it is not lowered, the
///     deviation lowering would cause. May be NULL.
/// @errors OUT_OF_RANGE (degree, tolerance), TOO_LARGE
/// @complexity O(degree) a raised control point, O(degree^3) a lowered segment.
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
    create_handle(context, changed, "changed", |job| {
        let done = view_of_curve(curve, "curve")?.with_degrees([lowest as usize, highest as usize], tolerance, job)?;
        if !deviations.is_null() {
            input::result_buffer(deviations, done.deviations.len(), "deviations")?.copy_from_slice(&done.deviations);
        }
        Ok(gusset_curve(done.curve))
    })
}

/// Fits the offset of a plane curve by segments with common tangents.
///
/// Self-intersections are not removed.
///
/// @param distance to the left; right if negative.
/// @param options required; its tolerance must be set.
/// @param report may be NULL.
/// @errors CURVE_NOT_PLANE, EMPTY_CURVE, OUT_OF_RANGE (distance, tolerance, degree), TOO_LARGE
/// @complexity O(degree) a measured place.
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
        let options = input::read_versioned_struct(options, false, "options")?.checked()?;
        let done = view_of_curve(curve, "curve")?.offset(distance, &options, job)?;
        let told = gusset_offset_report {
            struct_size: 0,
            deviation: done.deviation,
            corners: done.corners,
            reached: done.reached.into(),
            tight: done.tight.into(),
        };
        Ok((gusset_curve(done.curve), out.map(|out| (out, told))))
    };
    create_handle_and_outputs(context, offset, "offset", moved, |told| {
        if let Some((out, report)) = told {
            out.write_known_fields(report);
        }
    })
}

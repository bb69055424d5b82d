//! Curves in other forms: SVG paths, TrueType contours, B-splines.

use crate::capi::context::{create_handle, gusset_context, lend};
use crate::capi::curve::{gusset_curve, view_of_curve};
use crate::capi::glue::{constants, versioned};
use crate::capi::handle::{self, handle};
use crate::capi::input::lend_list;
use crate::capi::status::{Failure, gusset_status};
use crate::curve::ops::{ClampedSpline, TrueTypeContour};
use glam::DVec3;
use gusset_base::alloc;
use std::ffi::c_char;

/// Export format of a curve.
pub type gusset_curve_format = u32;
/// SVG path data (M, L, Q, C, Z), for plane curves up to degree 3. Numbers are exact; y is not
/// flipped.
pub const GUSSET_CURVE_FORMAT_SVG: gusset_curve_format = 0;
/// TrueType contour, for closed plane curves up to degree 2: controls, and joints not midway
/// between two.
pub const GUSSET_CURVE_FORMAT_CONTOUR: gusset_curve_format = 1;
/// Clamped B-spline, for curves of one degree n. Smooth joints become knots of multiplicity n - 1
/// without controls.
pub const GUSSET_CURVE_FORMAT_SPLINE: gusset_curve_format = 2;

/// An exported curve.
#[derive(Default)]
pub struct gusset_curve_form {
    /// The text with a closing 0.
    text: Vec<u8>,
    points: Vec<DVec3>,
    on_curve: Vec<u8>,
    knots: Vec<f64>,
    degree: usize,
}

handle! { gusset_curve_form }

/// Lent parts of an exported curve; other formats' are empty.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_curve_form_view {
    /// sizeof(gusset_curve_form_view).
    pub struct_size: usize,
    /// SVG path, zero-terminated.
    pub text: *const c_char,
    /// Length without the final 0.
    pub text_length: usize,
    /// Points of a contour, controls of a spline.
    /// @shape point_count 3
    pub points: *const f64,
    /// Number of points.
    pub point_count: usize,
    /// Contour: 1 for a point on the curve.
    /// @shape point_count
    /// @flag
    pub on_curve: *const u8,
    /// Spline: point_count + degree + 1 knots.
    /// @shape knot_count
    pub knots: *const f64,
    /// Number of knots.
    pub knot_count: usize,
    /// Spline: degree.
    pub degree: usize,
}

versioned! { gusset_curve_form_view: 72 }

/// Exports a curve.
///
/// @param tolerance for contours: omits joints within it of the middle, besides rounding; at least
///     0.
/// @errors CURVE_NOT_PLANE (not for splines), CURVE_NOT_CLOSED (contours), EMPTY_CURVE (not for
///     SVG), OUT_OF_RANGE (tolerance; degree, see gusset_curve_change_degree_create)
/// @complexity O(points).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_curve_export_create(
    context: *const gusset_context,
    curve: *const gusset_curve,
    format: gusset_curve_format,
    tolerance: f64,
    form: *mut *mut gusset_curve_form,
) -> gusset_status {
    create_handle(context, form, "form", |job| {
        let view = view_of_curve(curve, "curve")?;
        match format {
            GUSSET_CURVE_FORMAT_SVG => {
                let mut text = view.to_svg_path(job)?.into_bytes();
                alloc::push(&mut text, 0)?;
                Ok(gusset_curve_form { text, ..Default::default() })
            }
            GUSSET_CURVE_FORMAT_CONTOUR => {
                let TrueTypeContour { points, on_curve } = view.to_truetype_contour(tolerance, job)?;
                Ok(gusset_curve_form { points, on_curve, ..Default::default() })
            }
            GUSSET_CURVE_FORMAT_SPLINE => {
                let ClampedSpline { controls: points, knots, degree } = view.to_clamped_spline(job)?;
                Ok(gusset_curve_form { points, knots, degree, ..Default::default() })
            }
            other => Err(Failure::unknown_choice(
                "format",
                other,
                &constants![GUSSET_CURVE_FORMAT_SVG, GUSSET_CURVE_FORMAT_CONTOUR, GUSSET_CURVE_FORMAT_SPLINE],
            )),
        }
    })
}

/// Frees an exported curve.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gusset_curve_form_destroy(form: *mut gusset_curve_form) {
    handle::destroy(form);
}

/// Lends the parts.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_curve_form_get_view(
    form: *const gusset_curve_form,
    view: *mut gusset_curve_form_view,
) -> gusset_status {
    lend!(form, view, |form| gusset_curve_form_view {
        struct_size: size_of::<gusset_curve_form_view>(),
        text: if form.text.is_empty() { c"".as_ptr() } else { form.text.as_ptr().cast() },
        text_length: form.text.len().saturating_sub(1),
        points: lend_list(&form.points).cast(),
        point_count: form.points.len(),
        on_curve: lend_list(&form.on_curve),
        knots: lend_list(&form.knots),
        knot_count: form.knots.len(),
        degree: form.degree,
    })
}

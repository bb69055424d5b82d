//! Curves in other forms: SVG paths, TrueType contours, B-splines.

use crate::capi::context::{create, gusset_context, lend};
use crate::capi::curve::{gusset_curve, view};
use crate::capi::glue::versioned;
use crate::capi::handle::{self, handle};
use crate::capi::input::lent;
use crate::capi::status::{Failure, gusset_status};
use crate::curve::ops::{Contour, Spline};
use glam::DVec3;
use gusset_base::alloc;
use std::ffi::c_char;

/// A format that curves are exported to.
pub type gusset_curve_format = u32;
/// The data of an SVG path, of M, L, Q, C and Z, for plane curves of degrees up to 3. Numbers read back
/// as the same bits, and y is not turned over.
pub const GUSSET_CURVE_FORMAT_SVG: gusset_curve_format = 0;
/// The contour of a TrueType font, for closed plane curves of degrees up to 2: control points, and those
/// joints that are not in the middle between two of them.
pub const GUSSET_CURVE_FORMAT_CONTOUR: gusset_curve_format = 1;
/// A clamped B-spline, for curves whose segments have one degree n. A joint with one tangent becomes a
/// knot of multiplicity n - 1, and is not a control point.
pub const GUSSET_CURVE_FORMAT_SPLINE: gusset_curve_format = 2;

/// A curve in another form. Opaque and immutable; it keeps nothing of the curve.
#[derive(Default)]
pub struct gusset_curve_form {
    /// With a 0 at the end.
    text: Vec<u8>,
    points: Vec<DVec3>,
    on_curve: Vec<u8>,
    knots: Vec<f64>,
    degree: usize,
}

handle! { gusset_curve_form }

/// The parts of a form; those that it does not have are empty. Pointers are valid until it is
/// destroyed.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_curve_form_view {
    /// sizeof(gusset_curve_form_view), set by the caller.
    pub struct_size: usize,
    /// The text of an SVG path, ended by a 0; empty for other forms.
    pub text: *const c_char,
    /// Its length without the 0.
    pub text_length: usize,
    /// The points of a contour or the control points of a spline: x, y, z of each.
    pub points: *const f64,
    /// How many.
    pub point_count: usize,
    /// Of a contour, for each point: 1 on the curve, 0 off it.
    pub on_curve: *const u8,
    /// Of a spline: the knots, point_count + degree + 1 of them.
    pub knots: *const f64,
    /// How many.
    pub knot_count: usize,
    /// Of a spline: its degree.
    pub degree: usize,
}

versioned! { gusset_curve_form_view: 72 }

/// Exports a curve to another format.
///
/// @param tolerance for GUSSET_CURVE_FORMAT_CONTOUR: how far from the middle a joint still counts
///     as there, at least 0, in the unit of the points; rounding always does. Other formats do not
///     read it.
/// @errors UNKNOWN_VALUE (format), CURVE_NOT_PLANE (not for splines), CURVE_NOT_CLOSED (contours),
///     EMPTY_CURVE (not for SVG), OUT_OF_RANGE (a degree that the format lacks: see
///     gusset_curve_change_degree_create; tolerance)
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
    create(context, form, "form", |job| {
        let view = view(curve, "curve")?;
        match format {
            GUSSET_CURVE_FORMAT_SVG => {
                let mut text = view.svg_path(job)?.into_bytes();
                alloc::push(&mut text, 0)?;
                Ok(gusset_curve_form { text, ..Default::default() })
            }
            GUSSET_CURVE_FORMAT_CONTOUR => {
                let Contour { points, on_curve } = view.contour(tolerance, job)?;
                Ok(gusset_curve_form { points, on_curve, ..Default::default() })
            }
            GUSSET_CURVE_FORMAT_SPLINE => {
                let Spline { controls: points, knots, degree } = view.spline(job)?;
                Ok(gusset_curve_form { points, knots, degree, ..Default::default() })
            }
            other => Err(Failure::unknown("format", other.into())),
        }
    })
}

/// Destroys a form; NULL is allowed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gusset_curve_form_destroy(form: *mut gusset_curve_form) {
    handle::destroy(form);
}

/// Lends the parts.
///
/// @complexity O(1).
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
        points: lent(&form.points).cast(),
        point_count: form.points.len(),
        on_curve: lent(&form.on_curve),
        knots: lent(&form.knots),
        knot_count: form.knots.len(),
        degree: form.degree,
    })
}

//! C interface: queries of curves whose answers have as many numbers as were asked for.

use crate::capi::context::{answer, answer_struct, guard, gusset_context};
use crate::capi::curve::{gusset_curve, gusset_place, places, points, times, view, write};
use crate::capi::glue::{fixed, versioned};
use crate::capi::input;
use crate::capi::status::{Failure, gusset_status};
use crate::curve::{CurveView, Place};
use crate::job::Job;
use glam::DVec3;

/// Places that are measured between two progress reports.
const PLACES_PER_REPORT: usize = 1 << 8;

/// The nearest point of a curve.
#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
pub struct gusset_curve_nearest_point {
    /// Where on the curve.
    pub place: gusset_place,
    /// x, y, z.
    pub point: [f64; 3],
    /// The distance.
    pub distance: f64,
}

/// The moments of the region that a plane curve encloses; an open curve is closed by its chord.
/// Regions that it runs round clockwise count negative.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_curve_moment_report {
    /// sizeof(gusset_curve_moment_report), set by the caller.
    pub struct_size: usize,
    /// The signed area.
    pub area: f64,
    /// The centre of gravity; the curve's start if the area is 0.
    pub centroid: [f64; 2],
    /// The integrals of x x, x y and y y about the centroid, with the sign of the area.
    pub second: [f64; 3],
}

versioned! { gusset_curve_moment_report: 56 }
fixed! { gusset_curve_nearest_point: 48 }

/// Answers a question about a curve at many places.
fn at_places(
    context: *const gusset_context,
    curve: *const gusset_curve,
    (places, count): (*const gusset_place, usize),
    answer: impl FnOnce(&CurveView<'_>, &[Place], &Job<'_>) -> Result<(), Failure>,
) -> gusset_status {
    guard(context, |job| answer(&view(curve, "curve")?, &self::places(places, count, "places")?, job))
}

/// Writes points as x, y, z to the caller's buffer.
fn write_points(points: &[DVec3], out: *mut f64, name: &'static str) -> Result<(), Failure> {
    write(points, input::results(out, times(points.len(), 3, "results")?, name)?);
    Ok(())
}

/// Points and derivatives at many places.
///
/// @param context threads, progress, cancellation and error report; NULL for the defaults.
/// @param curve the curve.
/// @param places count of them, at least 0.
/// @param count see places.
/// @param order 0 for the points alone, at most 64.
/// @param[out] out receives 3 (order + 1) count numbers: for each place x, y, z of the point, then
///     of the first derivative by t, and so on; 0 beyond the degree.
/// @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, NO_SUCH_ELEMENT (a place),
///     OUT_OF_RANGE (order), UNKNOWN_VALUE, SIZE_OVERFLOW, OUT_OF_MEMORY, CANCELLED.
/// @complexity O(degree^2) a place.
/// @since 0.1
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_curve_derivatives(
    context: *const gusset_context,
    curve: *const gusset_curve,
    places: *const gusset_place,
    count: usize,
    order: u32,
    out: *mut f64,
) -> gusset_status {
    at_places(context, curve, (places, count), |curve, places, job| {
        write_points(&curve.derivatives_at(places, order as usize, job)?, out, "out")
    })
}

/// The directions at many places, of length 1; 0 on a segment without extent.
///
/// @param context threads, progress, cancellation and error report; NULL for the defaults.
/// @param curve the curve.
/// @param places count of them, at any alignment.
/// @param count see places.
/// @param[out] out receives 3 count numbers.
/// @return GUSSET_OK, or an error: those of gusset_curve_derivatives.
/// @since 0.1
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_curve_tangents(
    context: *const gusset_context,
    curve: *const gusset_curve,
    places: *const gusset_place,
    count: usize,
    out: *mut f64,
) -> gusset_status {
    at_places(context, curve, (places, count), |curve, places, job| {
        write_points(&curve.tangents_at(places, job)?, out, "out")
    })
}

/// The curvatures at many places, 1 over the radius: on a plane segment positive where it turns
/// from x to y; infinite where the first derivative is 0.
///
/// @param context threads, progress, cancellation and error report; NULL for the defaults.
/// @param curve the curve.
/// @param places count of them, at any alignment.
/// @param count see places.
/// @param[out] out receives count numbers.
/// @return GUSSET_OK, or an error: those of gusset_curve_derivatives.
/// @since 0.1
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_curve_curvatures(
    context: *const gusset_context,
    curve: *const gusset_curve,
    places: *const gusset_place,
    count: usize,
    out: *mut f64,
) -> gusset_status {
    at_places(context, curve, (places, count), |curve, places, job| {
        input::results(out, count, "out")?.copy_from_slice(&curve.curvatures_at(places, job)?);
        Ok(())
    })
}

/// The nearest points of a curve to many points.
///
/// @param context threads, progress, cancellation and error report; NULL for the defaults.
/// @param curve the curve.
/// @param points x, y, z of each, packed, count of them; any finite numbers. A distance above the
///     largest number is infinite.
/// @param count see points.
/// @param[out] out receives count results.
/// @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, EMPTY_CURVE, NOT_FINITE,
///     TOO_LARGE, SIZE_OVERFLOW, OUT_OF_MEMORY, CANCELLED.
/// @complexity About O(log segments + degree^2) a point, on the context's threads.
/// @since 0.1
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_curve_nearest(
    context: *const gusset_context,
    curve: *const gusset_curve,
    points: *const f64,
    count: usize,
    out: *mut gusset_curve_nearest_point,
) -> gusset_status {
    guard(context, |job| {
        let (view, points) = (view(curve, "curve")?, self::points(points, count, 3)?);
        let out = input::results(out, count, "out")?;
        for (to, n) in out.iter_mut().zip(view.nearest(&points, job)?) {
            *to = gusset_curve_nearest_point { place: n.place.into(), point: n.point.to_array(), distance: n.distance };
        }
        Ok(())
    })
}

/// The arc length of a curve.
///
/// @param context threads, progress, cancellation and error report; NULL for the defaults.
/// @param curve the curve.
/// @param[out] length receives it.
/// @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, OUT_OF_MEMORY, CANCELLED.
/// @complexity O(points); to 1e-13, in closed form up to degree 2.
/// @since 0.1
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_curve_length(
    context: *const gusset_context,
    curve: *const gusset_curve,
    length: *mut f64,
) -> gusset_status {
    answer(context, (length, "length"), 0.0, |job| Ok(view(curve, "curve")?.lengths(job)?.total()))
}

/// The arc lengths from the start to many places.
///
/// @param context threads, progress, cancellation and error report; NULL for the defaults.
/// @param curve the curve.
/// @param places count of them, at any alignment.
/// @param count see places.
/// @param[out] out receives count numbers.
/// @return GUSSET_OK, or an error: those of gusset_curve_derivatives.
/// @complexity O(points) in all.
/// @since 0.1
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_curve_lengths_at(
    context: *const gusset_context,
    curve: *const gusset_curve,
    places: *const gusset_place,
    count: usize,
    out: *mut f64,
) -> gusset_status {
    at_places(context, curve, (places, count), |curve, places, job| {
        let out = input::results(out, count, "out")?;
        let lengths = curve.lengths(&job.part(0.0, 0.5))?;
        let job = job.part(0.5, 1.0);
        for (k, (to, &place)) in out.iter_mut().zip(places).enumerate() {
            job.step_every(PLACES_PER_REPORT, k, count, "lengths at places")?;
            *to = lengths.up_to(place)?;
        }
        Ok(())
    })
}

/// The places at many arc lengths from the start; beyond the ends, the ends.
///
/// @param context threads, progress, cancellation and error report; NULL for the defaults.
/// @param curve the curve.
/// @param lengths count numbers.
/// @param count see lengths.
/// @param[out] out receives count places.
/// @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, EMPTY_CURVE, OUT_OF_RANGE
///     (NaN), SIZE_OVERFLOW, OUT_OF_MEMORY, CANCELLED.
/// @complexity O(points + count log segments).
/// @since 0.1
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_curve_places_at(
    context: *const gusset_context,
    curve: *const gusset_curve,
    lengths: *const f64,
    count: usize,
    out: *mut gusset_place,
) -> gusset_status {
    guard(context, |job| {
        let measured = view(curve, "curve")?.lengths(&job.part(0.0, 0.5))?;
        let (lengths, job) = (input::list(lengths, count, "lengths")?, job.part(0.5, 1.0));
        for (k, (to, length)) in input::results(out, count, "out")?.iter_mut().zip(lengths).enumerate() {
            job.step_every(PLACES_PER_REPORT, k, count, "places at lengths")?;
            *to = measured.place(length)?.into();
        }
        Ok(())
    })
}

/// The smallest box with sides along the axes.
///
/// @param context threads, progress, cancellation and error report; NULL for the defaults.
/// @param curve the curve.
/// @param[out] bounds receives the least x, y, z and the greatest x, y, z.
/// @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, EMPTY_CURVE, CANCELLED.
/// @complexity O(points); exact but for rounding.
/// @since 0.1
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_curve_bounds(
    context: *const gusset_context,
    curve: *const gusset_curve,
    bounds: *mut f64,
) -> gusset_status {
    answer(context, (bounds.cast::<[[f64; 3]; 2]>(), "bounds"), [[0.0; 3]; 2], |job| {
        let found = view(curve, "curve")?.bounding_box(job)?;
        Ok([found.low, found.high].map(|corner| corner.to_array()))
    })
}

/// The area vector, half the integral of r x dr: for a plane curve (0, 0, signed area).
///
/// An open curve is closed by the chord from its end to its start.
///
/// @param context threads, progress, cancellation and error report; NULL for the defaults.
/// @param curve the curve.
/// @param[out] area receives x, y, z.
/// @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, CANCELLED.
/// @complexity O(sum of degree^2); exact but for rounding.
/// @since 0.1
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_curve_area_vector(
    context: *const gusset_context,
    curve: *const gusset_curve,
    area: *mut f64,
) -> gusset_status {
    answer(context, (area.cast::<[f64; 3]>(), "area"), [0.0; 3], |job| {
        Ok(view(curve, "curve")?.area_vector(job)?.to_array())
    })
}

/// Area, centroid and second moments of what a plane curve encloses.
///
/// @param context threads, progress, cancellation and error report; NULL for the defaults.
/// @param curve the curve.
/// @param[out] moments receives the moments; struct_size is set by the caller.
/// @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE,
///     CURVE_NOT_PLANE, EMPTY_CURVE, CANCELLED.
/// @complexity O(sum of degree^2); exact but for rounding.
/// @since 0.1
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_curve_get_moments(
    context: *const gusset_context,
    curve: *const gusset_curve,
    moments: *mut gusset_curve_moment_report,
) -> gusset_status {
    answer_struct(context, (moments, "moments"), |job| {
        let found = view(curve, "curve")?.moments(job)?;
        let centroid = [found.centroid.x, found.centroid.y];
        Ok(gusset_curve_moment_report { struct_size: 0, area: found.area, centroid, second: found.second })
    })
}

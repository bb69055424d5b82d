//! C interface: nearest points of a surface and a line, a plane, a curve or another surface.

use crate::capi::context::{answer_struct, gusset_context};
use crate::capi::curve::{gusset_curve, gusset_place, view};
use crate::capi::glue::versioned;
use crate::capi::handle;
use crate::capi::input;
use crate::capi::status::gusset_status;
use crate::capi::surface::line_intersection::{gusset_line, lines};
use crate::capi::surface::{gusset_surface, gusset_surface_place, read};
use crate::surface::Approach;

/// gusset_surface_distance: the distance is proved: bound is within the tolerance of it, or within
/// 2^-45 of the greatest coordinate. Not set: that would take too long, as it may where much of the
/// surface is equally near; bound is right nevertheless.
pub const GUSSET_DISTANCE_PROVEN: u32 = 1;
/// gusset_surface_distance: the two meet at the points, but for rounding, and the distance is 0.
pub const GUSSET_DISTANCE_MEETS: u32 = 2;

/// The nearest points of a surface and something else.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_surface_distance {
    /// sizeof(gusset_surface_distance), set by the caller.
    pub struct_size: usize,
    /// Where the nearest point of the surface is.
    pub place: gusset_surface_place,
    /// x, y, z of it.
    pub point: [f64; 3],
    /// The unit normal there, or its limit at a pole; 0 where there is none.
    pub normal: [f64; 3],
    /// x, y, z of the nearest point of the other.
    pub other_point: [f64; 3],
    /// Their distance.
    pub distance: f64,
    /// No points of the two are nearer to each other than this.
    pub bound: f64,
    /// Of another surface: where its nearest point is; else 0.
    pub other_place: gusset_surface_place,
    /// Of a curve: where its nearest point is; else 0.
    pub curve_place: gusset_place,
    /// Of a line: its parameter at the nearest point. Of a plane: the distance, negative if the
    /// surface's point is not on the side that the normal points to. Else 0.
    pub parameter: f64,
    /// GUSSET_DISTANCE_...
    pub flags: u32,
    /// 0.
    pub reserved: u32,
}

versioned! { gusset_surface_distance: 192 }

impl gusset_surface_distance {
    /// Without the place on the other.
    fn new<T>(found: &Approach<T>) -> Self {
        let flag = |on: bool, flag: u32| if on { flag } else { 0 };
        gusset_surface_distance {
            struct_size: 0,
            place: found.place.into(),
            point: found.point.to_array(),
            normal: found.normal.to_array(),
            other_point: found.other_point.to_array(),
            distance: found.distance,
            bound: found.bound,
            other_place: gusset_surface_place::default(),
            curve_place: bytemuck::Zeroable::zeroed(),
            parameter: 0.0,
            flags: flag(found.proven, GUSSET_DISTANCE_PROVEN) | flag(found.meets, GUSSET_DISTANCE_MEETS),
            reserved: 0,
        }
    }
}

/// The caller's tolerance; 0 for that of the surfaces.
fn tolerance(given: f64) -> Option<f64> {
    (given != 0.0).then_some(given)
}

/// The nearest points of a surface and a line, ray or segment.
///
/// Of several pairs of points that are equally near it is always the same one. Where much of the
/// surface is equally near, as a tube is to its axis, the search ends without a proof, and says so.
///
/// @param context threads, progress, cancellation and error report; NULL for the defaults.
/// @param surface the surface.
/// @param line one, at any alignment.
/// @param tolerance a length, to which the distance is proved, finite; 0: that of the surface.
/// @param[out] distance struct_size set by the caller; all else is overwritten.
/// @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE,
///     OUT_OF_RANGE for a line that is not finite, has no direction or ends before it begins, and
///     for the tolerance; OUT_OF_MEMORY, CANCELLED.
/// @complexity About O(log cells), and at most 50,000 pairs of pieces.
/// @source Ours; Leus, "Carcasses on smooth surfaces", task c, where there is no intersection.
/// @since 0.1
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_surface_line_distance(
    context: *const gusset_context,
    surface: *const gusset_surface,
    line: *const gusset_line,
    tolerance: f64,
    distance: *mut gusset_surface_distance,
) -> gusset_status {
    answer_struct(context, (distance, "distance"), |job| {
        let (surface, line) = (read(surface)?, lines(line, 1)?[0]);
        let found = surface.distance_to_line(&line, self::tolerance(tolerance), job)?;
        Ok(gusset_surface_distance { parameter: found.other, ..gusset_surface_distance::new(&found) })
    })
}

/// The point of a surface that is nearest to a plane; where they meet, a point of the section.
///
/// @param context threads, progress, cancellation and error report; NULL for the defaults.
/// @param surface the surface.
/// @param point x, y, z of a point of the plane, up to 1e150, at any alignment.
/// @param normal x, y, z across it, of any length but 0, at any alignment.
/// @param tolerance a length, to which the distance is proved, finite; 0: that of the surface.
/// @param[out] distance struct_size set by the caller; all else is overwritten.
/// @return GUSSET_OK, or an error: those of gusset_surface_line_distance, OUT_OF_RANGE for what is
///     not finite, too large, or has no direction.
/// @complexity As for gusset_surface_line_distance.
/// @source Ours; Leus, "Carcasses on smooth surfaces", task d, where there is no section.
/// @since 0.1
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_surface_plane_distance(
    context: *const gusset_context,
    surface: *const gusset_surface,
    point: *const f64,
    normal: *const f64,
    tolerance: f64,
    distance: *mut gusset_surface_distance,
) -> gusset_status {
    answer_struct(context, (distance, "distance"), |job| {
        let (surface, point, normal) =
            (read(surface)?, input::vector(point, "point")?, input::vector(normal, "normal")?);
        let found = surface.distance_to_plane(point, normal, self::tolerance(tolerance), job)?;
        Ok(gusset_surface_distance { parameter: found.other, ..gusset_surface_distance::new(&found) })
    })
}

/// The nearest points of a surface and a curve in space.
///
/// @param context threads, progress, cancellation and error report; NULL for the defaults.
/// @param surface the surface.
/// @param curve the curve, of coordinates up to 1e150; of any degrees.
/// @param tolerance a length, to which the distance is proved, finite; 0: that of the surface.
/// @param[out] distance struct_size set by the caller; all else is overwritten.
/// @return GUSSET_OK, or an error: those of gusset_surface_line_distance, EMPTY_CURVE.
/// @complexity As for gusset_surface_line_distance.
/// @source Ours; Leus, "Carcasses on smooth surfaces", task c, where there is no intersection.
/// @since 0.1
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_surface_curve_distance(
    context: *const gusset_context,
    surface: *const gusset_surface,
    curve: *const gusset_curve,
    tolerance: f64,
    distance: *mut gusset_surface_distance,
) -> gusset_status {
    answer_struct(context, (distance, "distance"), |job| {
        let (surface, curve) = (read(surface)?, view(curve, "curve")?);
        let found = surface.distance_to_curve(&curve, self::tolerance(tolerance), job)?;
        Ok(gusset_surface_distance { curve_place: found.other.into(), ..gusset_surface_distance::new(&found) })
    })
}

/// The nearest points of two surfaces.
///
/// @param context threads, progress, cancellation and error report; NULL for the defaults.
/// @param surface the surface.
/// @param other the other one; of both only what is needed is looked at.
/// @param tolerance a length, to which the distance is proved, finite; 0: the greater one of both
///     surfaces.
/// @param[out] distance struct_size set by the caller; all else is overwritten.
/// @return GUSSET_OK, or an error: those of gusset_surface_line_distance.
/// @complexity As for gusset_surface_line_distance.
/// @source Ours; Leus, "Carcasses on smooth surfaces", task e, where there is no intersection.
/// @since 0.1
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_surface_surface_distance(
    context: *const gusset_context,
    surface: *const gusset_surface,
    other: *const gusset_surface,
    tolerance: f64,
    distance: *mut gusset_surface_distance,
) -> gusset_status {
    answer_struct(context, (distance, "distance"), |job| {
        let (surface, other) = (read(surface)?, &handle::get(other, "other")?.0);
        let found = surface.distance_to_surface(other, self::tolerance(tolerance), job)?;
        Ok(gusset_surface_distance { other_place: found.other.into(), ..gusset_surface_distance::new(&found) })
    })
}

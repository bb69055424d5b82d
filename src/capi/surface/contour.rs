//! C interface: sections, contours and isophotes of a surface.

use crate::capi::context::{answer_struct, create, gusset_context};
use crate::capi::glue::versioned;
use crate::capi::input::{self, flag};
use crate::capi::status::{Failure, gusset_status};
use crate::capi::surface::{gusset_surface, gusset_surface_paths, gusset_surface_place, read};
use crate::surface::contour::{Planes, PointSpacing};

/// What is between the points where a curve crosses the lines of the surface.
pub type gusset_point_spacing = u32;
/// As many points of the surface as keep the chords within 1e-4 of the diagonal of the surface's
/// box.
pub const GUSSET_POINT_SPACING_AUTO: gusset_point_spacing = 0;
/// As many points of the surface as keep the chords within `chord`, as the middle and the quarters of
/// the curve beside each show; where nodes are far apart for that length, it may be more elsewhere.
pub const GUSSET_POINT_SPACING_CHORD: gusset_point_spacing = 1;
/// Nothing.
pub const GUSSET_POINT_SPACING_CELL_EDGES: gusset_point_spacing = 2;
/// `points` points of the paper's approximation: on the cubic through four crossings. They are near
/// the surface, not on it, and have the place of the crossing before them. Order four where
/// crossings are evenly spaced.
pub const GUSSET_POINT_SPACING_LEUS: gusset_point_spacing = 3;

/// How curves of a surface are given.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_contour_options {
    /// sizeof(gusset_contour_options), set by the caller.
    pub struct_size: usize,
    /// With GUSSET_POINT_SPACING_CHORD: a length above 0 and finite; no smaller one counts than the
    /// tolerance of the surface. Otherwise not read. (In gusset_intersection_options, which has no
    /// `spacing`, a chord of 0 stands for GUSSET_POINT_SPACING_AUTO and INFINITY for
    /// GUSSET_POINT_SPACING_CELL_EDGES.)
    pub chord: f64,
    /// GUSSET_POINT_SPACING_...
    pub spacing: gusset_point_spacing,
    /// With GUSSET_POINT_SPACING_LEUS: how many, at most 1000. Otherwise not read.
    pub points: u32,
    /// Of isophotes and the nearest angle. 1: a normal and its opposite are the same.
    pub unsigned_normals: u32,
    /// 0.
    pub reserved: u32,
}

/// Where the angle of a normal is nearest to the one asked for.
#[repr(C)]
#[derive(Clone, Copy, Default)]
pub struct gusset_nearest_angle_report {
    /// sizeof(gusset_nearest_angle_report), set by the caller.
    pub struct_size: usize,
    /// Where it is.
    pub place: gusset_surface_place,
    /// x, y, z.
    pub point: [f64; 3],
    /// The unit normal.
    pub normal: [f64; 3],
    /// Its angle with the direction, in radians.
    pub angle: f64,
    /// How far this is from the angle asked for; infinite if the surface has no normal anywhere,
    /// and all else is 0 then.
    pub deviation: f64,
    /// No normal's angle is nearer than this: at most 1e-9 less than deviation, or more where that
    /// could not be proved.
    pub bound: f64,
}

versioned! { gusset_contour_options: 32 reserved, gusset_nearest_angle_report: 112 }

/// The caller's options: what is between crossings, and whether normals are unsigned.
fn options(given: *const gusset_contour_options) -> Result<(PointSpacing, bool), Failure> {
    let options = input::read(given, true, "options")?;
    let spacing = match options.spacing {
        GUSSET_POINT_SPACING_AUTO => PointSpacing::Auto,
        GUSSET_POINT_SPACING_CHORD => PointSpacing::Chord(options.chord),
        GUSSET_POINT_SPACING_CELL_EDGES => PointSpacing::CellEdges,
        GUSSET_POINT_SPACING_LEUS => PointSpacing::Leus(options.points),
        other => return Err(Failure::unknown("spacing", other.into())),
    };
    Ok((spacing, flag(options.unsigned_normals, "unsigned_normals")?))
}

/// Where parallel planes cut a surface: curves in the order of the planes and of their lowest
/// cells, along the cross product of the planes' normal and the surface's.
///
/// Every curve is found, also one within a cell, and on a closed surface all are closed; a corner
/// on a plane counts as above it. So a plane that touches the surface in corners of cells from
/// below, by its normal, gives no curve there and nothing unresolved, and one that touches it from
/// above closed curves round the contact, however narrow: along a row of corners, a curve there and
/// back. Cells where a plane touches or contains the surface elsewhere, so that curves cannot be
/// told within rounding, are listed as unresolved, and curves no larger than the tolerance too.
///
/// @param context threads, progress, cancellation and error report; NULL for the defaults.
/// @param surface the surface.
/// @param point x, y, z of a point of the plane of offset 0, at any alignment, as normal and
///     offsets are.
/// @param normal x, y, z, not 0, of any length.
/// @param offsets count of them, rising, distances of the planes from the point along the normal.
/// @param count see offsets.
/// @param options NULL for the defaults.
/// @param[out] paths receives the curves, for gusset_surface_paths_destroy; NULL on failure.
/// @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE,
///     UNKNOWN_VALUE, OUT_OF_RANGE (what is not finite, a normal of 0, offsets that do not rise,
///     chord, points), SIZE_OVERFLOW, TOO_LARGE, OUT_OF_MEMORY, CANCELLED.
/// @complexity About O(count + cells that are cut); threads.
/// @source Leus, "Carcasses on smooth surfaces", task d.
/// @since 0.1
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_surface_section_create(
    context: *const gusset_context,
    surface: *const gusset_surface,
    point: *const f64,
    normal: *const f64,
    offsets: *const f64,
    count: usize,
    options: *const gusset_contour_options,
    paths: *mut *mut gusset_surface_paths,
) -> gusset_status {
    create(context, paths, "paths", |job| {
        let (surface, (between, _)) = (read(surface)?, self::options(options)?);
        let offsets = input::list(offsets, count, "offsets")?;
        let (point, normal) = (input::vector(point, "point")?, input::vector(normal, "normal")?);
        Ok(surface.section(&Planes { point, normal, offsets: &offsets }, between, job)?.try_into()?)
    })
}

/// The contours of a scalar field that is given at the corners of the cells: where it takes the
/// values of levels.
///
/// It is interpolated as the surface is; greater values are to the left, seen from where the
/// normals point to.
///
/// @param context threads, progress, cancellation and error report; NULL for the defaults.
/// @param surface the surface.
/// @param values value_count of them, finite, at any alignment, as levels are: of all sheets, one
///     after the other, each row after row, one more row and column than there are cells; the last
///     line of a closed direction repeats the first and is not used.
/// @param value_count see values.
/// @param levels level_count of them, rising.
/// @param level_count see levels.
/// @param options NULL for the defaults.
/// @param[out] paths receives the result, for gusset_surface_paths_destroy; NULL on failure.
/// @return GUSSET_OK, or an error: those of gusset_surface_section_create;
///     SIZE_OVERFLOW if there are too few values, TOO_LARGE if too many, NOT_FINITE with the number
///     of the value.
/// @complexity O(values + cells that are crossed); threads.
/// @since 0.1
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_surface_contours_create(
    context: *const gusset_context,
    surface: *const gusset_surface,
    values: *const f64,
    value_count: usize,
    levels: *const f64,
    level_count: usize,
    options: *const gusset_contour_options,
    paths: *mut *mut gusset_surface_paths,
) -> gusset_status {
    create(context, paths, "paths", |job| {
        let (surface, (between, _)) = (read(surface)?, self::options(options)?);
        let (values, levels) =
            (input::list(values, value_count, "values")?, input::list(levels, level_count, "levels")?);
        Ok(surface.contours(&values, &levels, between, job)?.try_into()?)
    })
}

/// Where the normals of a surface make given angles with a direction: at pi / 2 the silhouettes of
/// the surface seen along the direction; at 0 and pi points in place of curves, each a path of one
/// point.
///
/// Angles are smaller to the left, seen from where the normals point to.
///
/// Where normals jump between cells (patches, GUSSET_SCHEME_FOUR_POINT), curves run along the side
/// between them; poles that may have the angle are listed as unresolved. Angles are of order three,
/// as normals are; contours of the cosines at the nodes are of order four.
///
/// @param context threads, progress, cancellation and error report; NULL for the defaults.
/// @param surface the surface.
/// @param direction x, y, z, not 0, at any alignment, as angles are.
/// @param angles count of them, in radians, rising, from 0 to pi, or to pi / 2 if normals are
///     unsigned.
/// @param count see angles.
/// @param options NULL for the defaults.
/// @param[out] paths receives the result, for gusset_surface_paths_destroy; NULL on failure.
/// @return GUSSET_OK, or an error: those of gusset_surface_section_create.
/// @complexity About O(cells that are crossed), and O(cells) once, for the cones of normals;
///     threads.
/// @source Leus, task b.
/// @since 0.1
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_surface_isophotes_create(
    context: *const gusset_context,
    surface: *const gusset_surface,
    direction: *const f64,
    angles: *const f64,
    count: usize,
    options: *const gusset_contour_options,
    paths: *mut *mut gusset_surface_paths,
) -> gusset_status {
    create(context, paths, "paths", |job| {
        let (surface, (between, unsigned)) = (read(surface)?, self::options(options)?);
        let (direction, angles) = (input::vector(direction, "direction")?, input::list(angles, count, "angles")?);
        Ok(surface.isophotes(direction, &angles, unsigned, between, job)?.try_into()?)
    })
}

/// The place whose normal's angle with a direction is nearest to the one given, proved to 1e-9.
///
/// @param context threads, progress, cancellation and error report; NULL for the defaults.
/// @param surface the surface.
/// @param direction x, y, z, not 0, at any alignment.
/// @param angle in radians, 0 to pi, or to pi / 2 if normals are unsigned.
/// @param options NULL for the defaults; what is between crossings is not used.
/// @param[out] nearest struct_size set by the caller; all else is overwritten.
/// @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE,
///     UNKNOWN_VALUE, OUT_OF_RANGE, OUT_OF_MEMORY, CANCELLED.
/// @complexity About O(cells that come near to the angle), and O(cells) once, for the cones of
///     normals; threads.
/// @source Leus, task b.
/// @since 0.1
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_surface_nearest_angle(
    context: *const gusset_context,
    surface: *const gusset_surface,
    direction: *const f64,
    angle: f64,
    options: *const gusset_contour_options,
    nearest: *mut gusset_nearest_angle_report,
) -> gusset_status {
    answer_struct(context, (nearest, "nearest"), |job| {
        let (surface, (_, unsigned)) = (read(surface)?, self::options(options)?);
        let direction = input::vector(direction, "direction")?;
        let none = gusset_nearest_angle_report { deviation: f64::INFINITY, ..Default::default() };
        Ok(surface.nearest_angle(direction, angle, unsigned, job)?.map_or(none, |found| gusset_nearest_angle_report {
            struct_size: 0,
            place: found.place.into(),
            point: found.point.into(),
            normal: found.normal.into(),
            angle: found.angle,
            deviation: found.deviation,
            bound: found.bound,
        }))
    })
}

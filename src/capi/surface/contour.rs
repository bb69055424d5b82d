//! Sections: Sections by planes, contours, isophotes and silhouettes.

use crate::capi::context::{answer_into_struct, create_handle, gusset_context};
use crate::capi::glue::{constants, versioned};
use crate::capi::input::{self, read_flag};
use crate::capi::status::{Failure, gusset_status};
use crate::capi::surface::{gusset_surface, gusset_surface_paths, gusset_surface_place, surface_of_handle};
use crate::surface::contour::{Planes, PointSpacing};
use glam::DVec3;

/// Curve points between crossings with cell sides.
pub type gusset_spacing_rule = u32;
/// Points on the surface that keep chords within 1e-4 of its box diagonal.
pub const GUSSET_POINT_SPACING_AUTO: gusset_spacing_rule = 0;
/// Points on the surface that keep chords within `chord` at the middle and quarters; larger
/// distances are possible where nodes are far apart.
pub const GUSSET_POINT_SPACING_CHORD: gusset_spacing_rule = 1;
/// No points.
pub const GUSSET_POINT_SPACING_CELL_EDGES: gusset_spacing_rule = 2;
/// `points` points on the cubic through four crossings, near the surface, with the place of the
/// crossing before. Fourth order where crossings are evenly spaced.
pub const GUSSET_POINT_SPACING_LEUS: gusset_spacing_rule = 3;

/// Density of points on curves.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_contour_options {
    /// sizeof(gusset_contour_options).
    pub struct_size: usize,
    /// Above 0; at least the surface's tolerance applies.
    /// @when spacing GUSSET_POINT_SPACING_CHORD
    pub chord: f64,
    /// Curve points between crossings with cell sides.
    pub spacing: gusset_spacing_rule,
    /// Points between two crossings, at most 1000.
    /// @when spacing GUSSET_POINT_SPACING_LEUS
    pub points: u32,
}

/// The function whose contours are drawn.
pub type gusset_contour_kind = u32;
/// Signed distance from the plane through `point` with normal `direction`: sections by parallel
/// planes.
pub const GUSSET_CONTOUR_HEIGHT: gusset_contour_kind = 0;
/// Values at cell corners, interpolated like the surface.
pub const GUSSET_CONTOUR_VALUES: gusset_contour_kind = 1;
/// Angle between the normal and `direction`: isophotes, at pi / 2 silhouettes seen along
/// `direction`.
pub const GUSSET_CONTOUR_ANGLE: gusset_contour_kind = 2;

/// A function on a surface. Fields name the kind that reads them, without prefix.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_contour_function {
    /// sizeof(gusset_contour_function).
    pub struct_size: usize,
    /// The function whose contours are drawn.
    pub kind: gusset_contour_kind,
    /// ANGLE. 1: opposite normals are equal.
    pub unsigned_normals: u32,
    /// HEIGHT: a point at height 0.
    pub point: [f64; 3],
    /// HEIGHT, ANGLE.
    pub direction: [f64; 3],
    /// VALUES: sheet after sheet, row after row, (rows + 1) x (columns + 1) each. A closing line is
    /// not read.
    pub values: *const f64,
    /// Number of values.
    pub value_count: usize,
}

/// The normal nearest to a given angle.
#[repr(C)]
#[derive(Clone, Copy, Default)]
pub struct gusset_nearest_angle_report {
    /// sizeof(gusset_nearest_angle_report).
    pub struct_size: usize,
    /// Place of the normal.
    pub place: gusset_surface_place,
    /// Point at the place.
    pub point: [f64; 3],
    /// The unit normal.
    pub normal: [f64; 3],
    /// Angle between normal and direction.
    pub angle: f64,
    /// Difference from the given angle; infinite, all else 0, if the surface lacks normals.
    pub deviation: f64,
    /// Lower bound of all deviations, within 1e-9 of it unless the proof fails.
    pub bound: f64,
}

versioned! { gusset_contour_options: 24, gusset_contour_function: 80, gusset_nearest_angle_report: 112 }

/// Converts the caller's spacing of the points between crossings.
pub(crate) fn to_point_spacing(spacing: gusset_spacing_rule, chord: f64, points: u32) -> Result<PointSpacing, Failure> {
    Ok(match spacing {
        GUSSET_POINT_SPACING_AUTO => PointSpacing::Auto,
        GUSSET_POINT_SPACING_CHORD => PointSpacing::Chord(chord),
        GUSSET_POINT_SPACING_CELL_EDGES => PointSpacing::CellEdges,
        GUSSET_POINT_SPACING_LEUS => PointSpacing::Leus(points),
        other => {
            return Err(Failure::unknown_choice(
                "spacing",
                other,
                &constants![
                    GUSSET_POINT_SPACING_AUTO,
                    GUSSET_POINT_SPACING_CHORD,
                    GUSSET_POINT_SPACING_CELL_EDGES,
                    GUSSET_POINT_SPACING_LEUS
                ],
            ));
        }
    })
}

/// Draws contours of a function.
///
/// Curves are ordered by level, then lowest cell. Seen against the normals, the function increases
/// to the left (angles decrease): sections run along direction x normal.
///
/// Every curve is found, even within a cell; those within the tolerance in size are unresolved. On
/// closed surfaces all are closed.
///
/// Sections: corners on a plane count as above it.
/// - A plane that touches corners from below gives nothing.
/// - One that touches from above gives closed curves round the contact, however narrow: there and
///   back along rows of corners.
/// - Where one touches or contains the surface elsewhere within rounding, cells are unresolved.
///
/// Isophotes:
/// - At angles 0 and pi, paths are single points.
/// - Where normals jump between cells (patches, GUSSET_SCHEME_FOUR_POINT), curves follow sides.
/// - Poles that may have the angle are unresolved.
/// - Angles are third-order; GUSSET_CONTOUR_VALUES of cosines, fourth-order.
///
/// @param levels rising; angles 0 to pi, or pi/2 for unsigned normals.
/// @errors OUT_OF_RANGE (non-finite numbers, zero direction, levels, angle, chord, points),
///     COUNT_DIFFERS (values), TOO_LARGE (values; 2^32 points), NOT_FINITE (value)
/// @complexity About O(count + crossed cells), parallel; values: O(values); angles: O(cells) once.
/// @source Leus, tasks b and d.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_surface_contours_create(
    context: *const gusset_context,
    surface: *const gusset_surface,
    function: *const gusset_contour_function,
    levels: *const f64,
    count: usize,
    options: *const gusset_contour_options,
    paths: *mut *mut gusset_surface_paths,
) -> gusset_status {
    create_handle(context, paths, "paths", |job| {
        let (surface, options) = (surface_of_handle(surface)?, input::read_versioned_struct(options, true, "options")?);
        let between = to_point_spacing(options.spacing, options.chord, options.points)?;
        let (function, levels) = (
            input::read_versioned_struct(function, false, "function")?,
            input::copy_input_items(levels, count, "levels")?,
        );
        let [point, direction] = [function.point, function.direction].map(DVec3::from_array);
        let unsigned = read_flag(function.unsigned_normals, "unsigned_normals")?;
        let found = match function.kind {
            GUSSET_CONTOUR_HEIGHT => {
                surface.section(&Planes { point, normal: direction, levels: &levels }, between, job)?
            }
            GUSSET_CONTOUR_VALUES => {
                let values = input::copy_input_items(function.values, function.value_count, "values")?;
                surface.contours(&values, &levels, between, job)?
            }
            GUSSET_CONTOUR_ANGLE => surface.isophotes(direction, &levels, unsigned, between, job)?,
            other => {
                return Err(Failure::unknown_choice(
                    "kind",
                    other,
                    &constants![GUSSET_CONTOUR_HEIGHT, GUSSET_CONTOUR_VALUES, GUSSET_CONTOUR_ANGLE],
                ));
            }
        };
        Ok(found.try_into()?)
    })
}

/// Finds the normal with the angle to a direction nearest to a given one, proved to 1e-9.
///
/// @param direction where angles are 0.
/// @param angle 0 to pi, or pi/2 for unsigned normals.
/// @param unsigned_normals 1: opposite normals are equal.
/// @errors OUT_OF_RANGE
/// @complexity About O(cells with normals near the angle), parallel; O(cells) once.
/// @source Leus, task b.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_surface_nearest_angle(
    context: *const gusset_context,
    surface: *const gusset_surface,
    direction: *const f64,
    angle: f64,
    unsigned_normals: u32,
    report: *mut gusset_nearest_angle_report,
) -> gusset_status {
    answer_into_struct(context, (report, "report"), |job| {
        let (surface, unsigned) = (surface_of_handle(surface)?, read_flag(unsigned_normals, "unsigned_normals")?);
        let direction = input::read_vector(direction, "direction")?;
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

//! Sections: Sections by planes, contours, isophotes and silhouettes.

use crate::capi::context::{answer_struct, create, gusset_context};
use crate::capi::glue::versioned;
use crate::capi::input::{self, flag};
use crate::capi::status::{Failure, gusset_status};
use crate::capi::surface::{gusset_surface, gusset_surface_paths, gusset_surface_place, read};
use crate::surface::contour::{Planes, PointSpacing};
use glam::DVec3;

/// The points of a curve between those where it crosses the lines of the surface.
pub type gusset_spacing_rule = u32;
/// As many points of the surface as keep the chords within 1e-4 of the diagonal of the surface's
/// box.
pub const GUSSET_POINT_SPACING_AUTO: gusset_spacing_rule = 0;
/// As many points of the surface as keep the chords within `chord`, as the middle and the quarters of
/// the curve beside each show; where nodes are far apart for that length, it may be more elsewhere.
pub const GUSSET_POINT_SPACING_CHORD: gusset_spacing_rule = 1;
/// Nothing.
pub const GUSSET_POINT_SPACING_CELL_EDGES: gusset_spacing_rule = 2;
/// `points` points of the paper's approximation: on the cubic through four crossings. They are near
/// the surface, not on it, and have the place of the crossing before them. Order four where
/// crossings are evenly spaced.
pub const GUSSET_POINT_SPACING_LEUS: gusset_spacing_rule = 3;

/// How curves of a surface are given.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_contour_options {
    /// sizeof(gusset_contour_options), set by the caller.
    pub struct_size: usize,
    /// With GUSSET_POINT_SPACING_CHORD: a length above 0 and finite; no smaller one counts than the
    /// tolerance of the surface. Otherwise not read.
    pub chord: f64,
    /// The points of a curve between those where it crosses the lines of the surface.
    pub spacing: gusset_spacing_rule,
    /// With GUSSET_POINT_SPACING_LEUS: how many, at most 1000. Otherwise not read.
    pub points: u32,
}

/// The function on a surface whose contours are drawn.
pub type gusset_contour_kind = u32;
/// The distance from the plane through `point` across `direction`, negative below it. Its contours
/// are sections of the surface by parallel planes.
pub const GUSSET_CONTOUR_HEIGHT: gusset_contour_kind = 0;
/// The values at the corners of the cells, interpolated as the surface is.
pub const GUSSET_CONTOUR_VALUES: gusset_contour_kind = 1;
/// The angle between the normal and `direction`, in radians. Its contours are isophotes; at pi / 2
/// they are the silhouettes of the surface seen along the direction.
pub const GUSSET_CONTOUR_ANGLE: gusset_contour_kind = 2;

/// A function on a surface. Only the fields of its kind are read.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_contour_function {
    /// sizeof(gusset_contour_function), set by the caller.
    pub struct_size: usize,
    /// The function on a surface whose contours are drawn.
    pub kind: gusset_contour_kind,
    /// For GUSSET_CONTOUR_ANGLE. 1: a normal and its opposite are the same.
    pub unsigned_normals: u32,
    /// For GUSSET_CONTOUR_HEIGHT: x, y, z of a point where the height is 0.
    pub point: [f64; 3],
    /// For GUSSET_CONTOUR_HEIGHT and GUSSET_CONTOUR_ANGLE: x, y, z, of any length but 0.
    pub direction: [f64; 3],
    /// For GUSSET_CONTOUR_VALUES: finite numbers, at any alignment. Sheet follows sheet and row
    /// follows row; each sheet has one more row and one more column than cells. The last line of a
    /// closed direction repeats the first and is not read.
    pub values: *const f64,
    /// The number of values.
    pub value_count: usize,
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

versioned! { gusset_contour_options: 24, gusset_contour_function: 80, gusset_nearest_angle_report: 112 }

/// The points between crossings that the caller's options ask for.
pub(crate) fn spacing(spacing: gusset_spacing_rule, chord: f64, points: u32) -> Result<PointSpacing, Failure> {
    Ok(match spacing {
        GUSSET_POINT_SPACING_AUTO => PointSpacing::Auto,
        GUSSET_POINT_SPACING_CHORD => PointSpacing::Chord(chord),
        GUSSET_POINT_SPACING_CELL_EDGES => PointSpacing::CellEdges,
        GUSSET_POINT_SPACING_LEUS => PointSpacing::Leus(points),
        other => return Err(Failure::unknown("spacing", other.into())),
    })
}

/// Draws the contours of a function on a surface: sections by planes, contours of values at nodes,
/// or isophotes. The curves come in the order of the levels and of their lowest cells.
///
/// The function increases to the left of a curve, seen from where the normals point to; angles
/// decrease to the left. A section runs along the cross product of the direction and the normal.
///
/// Every curve is found, also one within a cell. On a closed surface all curves are closed. Curves
/// no larger than the tolerance are listed as unresolved.
///
/// Sections: a corner on a plane counts as above it. So a plane that touches the surface in corners
/// of cells from below, by its direction, gives no curve there and nothing unresolved. A plane that
/// touches the surface from above gives closed curves round the contact, however narrow: along a row
/// of corners, a curve there and back. If a plane touches or contains the surface elsewhere, so that
/// curves cannot be told within rounding, the cells are listed as unresolved.
///
/// Isophotes: at the angles 0 and pi there are points in place of curves, each a path of one point.
/// Where normals jump between cells (patches, GUSSET_SCHEME_FOUR_POINT), curves run along the side
/// between them. Poles that may have the angle are listed as unresolved. Angles are of order three,
/// as normals are; contours of the cosines at the nodes are of order four.
///
/// @param function the function; struct_size set by the caller.
/// @param levels count of them, rising, at any alignment: the values of the function on the curves.
///     Angles are from 0 to pi, or to pi / 2 if normals are unsigned.
/// @param count see levels.
/// @errors OUT_OF_RANGE (numbers that are not finite, a direction of 0, levels that do not rise,
///     angles, chord, points, if there are too few values), TOO_LARGE (if there are too many),
///     NOT_FINITE (with the number of the value)
/// @complexity About O(count + cells that are crossed); O(values) for values, and O(cells) once for
///     angles, for the cones of normals; threads.
/// @source Leus, "Carcasses on smooth surfaces", tasks b and d.
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
    create(context, paths, "paths", |job| {
        let (surface, options) = (read(surface)?, input::read(options, true, "options")?);
        let between = spacing(options.spacing, options.chord, options.points)?;
        let (function, levels) = (input::read(function, false, "function")?, input::list(levels, count, "levels")?);
        let [point, direction] = [function.point, function.direction].map(DVec3::from_array);
        let unsigned = flag(function.unsigned_normals, "unsigned_normals")?;
        let found = match function.kind {
            GUSSET_CONTOUR_HEIGHT => {
                surface.section(&Planes { point, normal: direction, levels: &levels }, between, job)?
            }
            GUSSET_CONTOUR_VALUES => {
                let values = input::list(function.values, function.value_count, "values")?;
                surface.contours(&values, &levels, between, job)?
            }
            GUSSET_CONTOUR_ANGLE => surface.isophotes(direction, &levels, unsigned, between, job)?,
            other => return Err(Failure::unknown("kind", other.into())),
        };
        Ok(found.try_into()?)
    })
}

/// Finds the place whose normal makes the angle with a direction that is nearest to a given one,
/// proved to 1e-9.
///
/// @param direction x, y, z, not 0, at any alignment.
/// @param angle in radians, 0 to pi, or to pi / 2 if normals are unsigned.
/// @param unsigned_normals 1: a normal and its opposite are the same; else 0.
/// @param report struct_size set by the caller; all else is overwritten.
/// @errors OUT_OF_RANGE
/// @complexity About O(cells that come near to the angle), and O(cells) once, for the cones of
///     normals; threads.
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
    answer_struct(context, (report, "report"), |job| {
        let (surface, unsigned) = (read(surface)?, flag(unsigned_normals, "unsigned_normals")?);
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

//! Curves and surfaces: Curves through points, along surfaces, and near each other.

use crate::capi::context::{create, gusset_context};
use crate::capi::curve::intersect::gusset_places;
use crate::capi::curve::{gusset_curve, points, view};
use crate::capi::handle;
use crate::capi::input::{choice, flag};
use crate::capi::status::{Failure, gusset_status};
use crate::capi::surface::line_intersection::{gusset_line, lines};
use crate::capi::surface::sheet::{gusset_scheme, gusset_sheet};
use crate::surface::curve_through;

/// The way in which a coordinate curve of a sheet runs.
pub type gusset_sheet_direction = u32;
/// Along rows: u stays and v runs.
pub const GUSSET_ALONG_ROWS: gusset_sheet_direction = 0;
/// Along columns: v stays and u runs.
pub const GUSSET_ALONG_COLUMNS: gusset_sheet_direction = 1;

/// Draws a curve through points as surfaces are drawn through their nodes: a cubic from each to the
/// next, of fourth order.
///
/// @param nodes x, y, z of count points, at any alignment, finite; at least 2, or if closed 4, of
///     which the last is the first one again: closed paths of a surface do not repeat it, and need
///     it added.
/// @param count see nodes.
/// @param closed 0 or 1.
/// @errors MISALIGNED_ARGUMENT (curve), NET_TOO_SMALL (with too few points), NOT_FINITE (with the
///     node), CURVE_NOT_CLOSED, TOO_LARGE
/// @complexity O(count).
/// @source Leus, "Carcasses on smooth surfaces": points are the surface of a curve.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_curve_through_create(
    context: *const gusset_context,
    nodes: *const f64,
    count: usize,
    closed: u32,
    scheme: gusset_scheme,
    curve: *mut *mut gusset_curve,
) -> gusset_status {
    create(context, curve, "curve", |job| {
        let (scheme, closed) = (choice(scheme)?, flag(closed, "closed")?);
        Ok(gusset_curve(curve_through(&points(nodes, count, 3)?, closed, scheme, job)?))
    })
}

/// A coordinate curve of a sheet, exactly: a segment for each cell.
///
/// @param along along rows u is the parameter, along columns v is.
/// @param parameter 0 to the number of cells that way; whole numbers are lines of nodes.
/// @errors OUT_OF_RANGE (parameter)
/// @complexity O(cells along the curve).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_sheet_curve_create(
    context: *const gusset_context,
    sheet: *const gusset_sheet,
    along: gusset_sheet_direction,
    parameter: f64,
    curve: *mut *mut gusset_curve,
) -> gusset_status {
    create(context, curve, "curve", |job| {
        let sheet = &handle::get(sheet, "sheet")?.0;
        Ok(gusset_curve(match along {
            GUSSET_ALONG_ROWS => sheet.row_curve(parameter, job)?,
            GUSSET_ALONG_COLUMNS => sheet.column_curve(parameter, job)?,
            other => return Err(Failure::unknown("along", other.into())),
        }))
    })
}

/// Finds the places where a curve meets a line, ray or segment in space, or comes as near to it as
/// `within`.
///
/// If within is 0 and both lie in the plane z = 0, the places are crossings and touches. Otherwise they are
/// the places where the distance is least, each once. The others among the places have segment 0, and the
/// line's own parameter as t.
///
/// @param line one, at any alignment.
/// @param within a length, 0 or more and finite; in space at least 1e-12 of the curve's size is taken.
/// @param places receives the result, for gusset_places_destroy; NULL on failure. Overlaps are
///     parts that stay as near, and parts where no place can be told from the next.
/// @errors EMPTY_CURVE, OUT_OF_RANGE (within; a line that is not finite or has no direction)
/// @complexity Bounded work for each segment whose box meets the line.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_curve_intersect_line_create(
    context: *const gusset_context,
    curve: *const gusset_curve,
    line: *const gusset_line,
    within: f64,
    places: *mut *mut gusset_places,
) -> gusset_status {
    create(context, places, "places", |job| {
        let (curve, line) = (view(curve, "curve")?, lines(line, 1)?[0]);
        let found = line.meetings(&curve, within, &job.part(0.0, 0.9))?;
        gusset_places::of_meetings(&found, &curve, &job.part(0.9, 1.0))
    })
}

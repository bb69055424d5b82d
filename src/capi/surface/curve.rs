//! Curves and surfaces: Curves through points, along sheets, and near lines.

use crate::capi::context::{create_handle, gusset_context};
use crate::capi::curve::intersect::gusset_places;
use crate::capi::curve::{gusset_curve, read_points, view_of_curve};
use crate::capi::glue::constants;
use crate::capi::handle;
use crate::capi::input::{read_choice, read_flag};
use crate::capi::status::{Failure, gusset_status};
use crate::capi::surface::line_intersection::{gusset_line, read_lines};
use crate::capi::surface::sheet::{gusset_scheme, gusset_sheet};
use crate::surface::curve_through;

/// Direction of a coordinate curve of a sheet.
pub type gusset_sheet_direction = u32;
/// Along rows: u is constant.
pub const GUSSET_ALONG_ROWS: gusset_sheet_direction = 0;
/// Along columns: v is constant.
pub const GUSSET_ALONG_COLUMNS: gusset_sheet_direction = 1;

/// Draws a curve through points, fourth-order, a cubic between neighbours.
///
/// @param nodes at least 2; closed at least 4, the last repeating the first.
/// @param closed 0 or 1.
/// @errors NET_TOO_SMALL (too few points), NOT_FINITE, CURVE_NOT_CLOSED, TOO_LARGE
/// @complexity O(count).
/// @source V. Leus.
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
    create_handle(context, curve, "curve", |job| {
        let (scheme, closed) = (read_choice(scheme)?, read_flag(closed, "closed")?);
        Ok(gusset_curve(curve_through(&read_points(nodes, count, 3)?, closed, scheme, job)?))
    })
}

/// Makes an exact coordinate curve of a sheet, one segment a cell.
///
/// @param parameter the constant u or v, 0 to the cells in its direction.
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
    create_handle(context, curve, "curve", |job| {
        let sheet = &handle::get_object(sheet, "sheet")?.0;
        Ok(gusset_curve(match along {
            GUSSET_ALONG_ROWS => sheet.row_curve(parameter, job)?,
            GUSSET_ALONG_COLUMNS => sheet.column_curve(parameter, job)?,
            other => {
                return Err(Failure::unknown_choice(
                    "along",
                    other,
                    &constants![GUSSET_ALONG_ROWS, GUSSET_ALONG_COLUMNS],
                ));
            }
        }))
    })
}

/// Finds where a curve meets a line, or comes within a distance of it.
///
/// The result has minima of distance, or, if within is 0 and both lie in the plane z = 0, crossings
/// and touches, each once. `others` have segment 0 and the line's parameter as t.
///
/// @param within largest distance; in space raised to 1e-12 of the curve's size.
/// @param places overlaps stay within the distance or cannot be separated.
/// @errors EMPTY_CURVE, OUT_OF_RANGE (within; line not finite or without direction)
/// @complexity Bounded for segments whose boxes meet the line.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_curve_intersect_line_create(
    context: *const gusset_context,
    curve: *const gusset_curve,
    line: *const gusset_line,
    within: f64,
    places: *mut *mut gusset_places,
) -> gusset_status {
    create_handle(context, places, "places", |job| {
        let (curve, line) = (view_of_curve(curve, "curve")?, read_lines(line, 1)?[0]);
        let found = line.intersections_or_near_misses(&curve, within, &job.sub_job(0.0, 0.9))?;
        gusset_places::from_near_misses(&found, &curve, &job.sub_job(0.9, 1.0))
    })
}

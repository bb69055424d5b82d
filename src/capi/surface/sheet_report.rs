//! C interface to reports on sheets: size, degree, closure and poles, and estimates and bounds of
//! their error for each cell.

use crate::capi::context::{answer, guard, gusset_context, lend};
use crate::capi::glue::versioned;
use crate::capi::handle;
use crate::capi::input;
use crate::capi::status::gusset_status::GUSSET_ERROR_BUFFER_TOO_SMALL;
use crate::capi::status::{Failure, gusset_status};
use crate::capi::surface::sheet::gusset_sheet;
use crate::surface::Sheet;

/// What a sheet is.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_sheet_report {
    /// sizeof(gusset_sheet_report), set by the caller.
    pub struct_size: usize,
    /// Cells in u: u runs from 0 to this.
    pub rows: usize,
    /// Cells in v.
    pub columns: usize,
    /// The degree of the patches in both directions as they are kept: 3 or 7.
    pub degree: u32,
    /// 1: the nodes are kept and patches are made when they are needed; 0: the patches are kept.
    pub is_grid: u32,
    /// 1: closed in u.
    pub closed_u: u32,
    /// 1: closed in v.
    pub closed_v: u32,
    /// 1: the side u = 0 is one point, a pole.
    pub pole_u0: u32,
    /// 1: the side u = rows is.
    pub pole_u1: u32,
    /// 1: the side v = 0 is.
    pub pole_v0: u32,
    /// 1: the side v = columns is.
    pub pole_v1: u32,
    /// Of a rational spline, a bound of how far the sheet is from it at equal parameters, rounding
    /// included; 0 of any other sheet.
    pub deviation: f64,
    /// Of a spline, the knots of rows: rows + 1 parameters that rise, between which the spline's
    /// parameter runs evenly; NULL of any other sheet. Valid as long as the sheet.
    pub knots_u: *const f64,
    /// The knots of columns: columns + 1.
    pub knots_v: *const f64,
}

versioned! { gusset_sheet_report: 56 }

/// Tells what a sheet is.
///
/// @param sheet the sheet.
/// @param[out] parts struct_size set by the caller; all else is overwritten.
/// @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE.
/// @complexity O(cells at the sides).
/// @since 0.1
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_sheet_get_report(
    sheet: *const gusset_sheet,
    parts: *mut gusset_sheet_report,
) -> gusset_status {
    lend!(sheet, parts, |gusset_sheet(sheet)| {
        let ([rows, columns], [closed_u, closed_v]) = (sheet.cells(), sheet.is_closed().map(u32::from));
        let [[pole_u0, pole_u1], [pole_v0, pole_v1]] = sheet.poles().map(|pair| pair.map(u32::from));
        let (degree, is_grid) = match sheet {
            Sheet::Grid(_) => (3, 1),
            Sheet::Cubic(_) => (3, 0),
            Sheet::High(_) => (7, 0),
        };
        let [knots_u, knots_v] = [0, 1].map(|d| sheet.knots().map_or(std::ptr::null(), |knots| knots[d].as_ptr()));
        gusset_sheet_report {
            struct_size: 0,
            rows,
            columns,
            degree,
            is_grid,
            closed_u,
            closed_v,
            pole_u0,
            pole_u1,
            pole_v0,
            pole_v1,
            deviation: sheet.deviation(),
            knots_u,
            knots_v,
        }
    })
}

/// A buffer for a number a cell, if one is wanted.
fn buffer<'a>(
    pointer: *mut f64,
    needed: usize,
    capacity: usize,
    name: &'static str,
) -> Result<Option<&'a mut [f64]>, Failure> {
    if pointer.is_null() {
        return Ok(None);
    }
    if capacity < needed {
        let message = format!("{needed} cells, and room for {capacity}");
        return Err(Failure { value: needed as f64, ..Failure::new(GUSSET_ERROR_BUFFER_TOO_SMALL, message) });
    }
    input::results(pointer, needed, name).map(Some)
}

/// Estimates and bounds for each cell, row after row: number i * columns + j is that of cell (i,
/// j).
///
/// @param context threads, progress, cancellation and error report; NULL for the defaults.
/// @param sheet the sheet.
/// @param[out] errors an estimate of how far a surface through nodes is from the smooth one that
///     they were taken from, at equal parameters: C h^4 times the fourth derivatives, from
///     differences of nodes. No bound; infinite for fewer than 5 nodes in a direction; 0 if the
///     patches were given.
/// @param[out] bilinear a bound of how far the surface is from the bilinear patch through the
///     cell's corners.
/// @param[out] triangles from the two triangles that either diagonal makes. Each may be NULL.
/// @param capacity how many numbers each has room for.
/// @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BUFFER_TOO_SMALL (the value
///     is the number of cells), OUT_OF_MEMORY, CANCELLED; nothing is written then.
/// @complexity O(cells); threads.
/// @since 0.1
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_sheet_estimates(
    context: *const gusset_context,
    sheet: *const gusset_sheet,
    errors: *mut f64,
    bilinear: *mut f64,
    triangles: *mut f64,
    capacity: usize,
) -> gusset_status {
    guard(context, |job| {
        let sheet = &handle::get(sheet, "sheet")?.0;
        let needed = sheet.cells().iter().product();
        let wanted = [(errors, "errors"), (bilinear, "bilinear"), (triangles, "triangles")];
        let [errors, bilinear, triangles] = wanted.map(|(to, name)| buffer(to, needed, capacity, name));
        let (errors, bilinear, triangles) = (errors?, bilinear?, triangles?);
        let estimates = errors.is_some().then(|| sheet.interpolation_errors(&job.part(0.0, 0.5))).transpose()?;
        let flat =
            (bilinear.is_some() || triangles.is_some()).then(|| sheet.flatnesses(&job.part(0.5, 1.0))).transpose()?;
        errors.into_iter().zip(estimates).for_each(|(to, from)| to.copy_from_slice(&from));
        for (to, k) in [(bilinear, 0), (triangles, 1)] {
            to.into_iter().zip(&flat).for_each(|(to, from)| to.iter_mut().zip(from).for_each(|(x, y)| *x = y[k]));
        }
        Ok(())
    })
}

/// The largest angle between the normals on both sides of borders between cells, in radians: 0, or
/// rounding, where the surface is smooth.
///
/// @param context threads, progress, cancellation and error report; NULL for the defaults.
/// @param sheet the sheet.
/// @param[out] crease receives it.
/// @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, OUT_OF_MEMORY, CANCELLED.
/// @complexity O(cells); threads.
/// @since 0.1
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_sheet_crease(
    context: *const gusset_context,
    sheet: *const gusset_sheet,
    crease: *mut f64,
) -> gusset_status {
    answer(context, (crease, "crease"), 0.0, |job| Ok(handle::get(sheet, "sheet")?.0.crease(job)?))
}

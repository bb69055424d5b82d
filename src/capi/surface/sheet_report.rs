//! Reports on sheets: Sizes, estimates and bounds.

use crate::capi::context::{guard_changing_call, gusset_context, lend};
use crate::capi::glue::versioned;
use crate::capi::handle;
use crate::capi::input;
use crate::capi::status::gusset_status::GUSSET_ERROR_BUFFER_TOO_SMALL;
use crate::capi::status::{Failure, gusset_status};
use crate::capi::surface::sheet::gusset_sheet;
use crate::surface::Sheet;
use crate::surface::reference::{Diameters, curvature_bound};

/// Facts about a sheet.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_sheet_report {
    /// sizeof(gusset_sheet_report).
    pub struct_size: usize,
    /// Cells in u, which runs from 0 to rows.
    pub rows: usize,
    /// Cells in v, likewise.
    pub columns: usize,
    /// Degree of patches: 3 or 7.
    pub degree: u32,
    /// 1: stores nodes; 0: patches.
    /// @flag
    pub is_grid: u32,
    /// 1: closed in u.
    /// @flag
    pub closed_u: u32,
    /// 1: closed in v.
    /// @flag
    pub closed_v: u32,
    /// 1: u = 0 is a pole, one point.
    /// @flag
    pub pole_u0: u32,
    /// 1: u = rows is a pole.
    /// @flag
    pub pole_u1: u32,
    /// 1: v = 0 is a pole.
    /// @flag
    pub pole_v0: u32,
    /// 1: v = columns is a pole.
    /// @flag
    pub pole_v1: u32,
    /// Bound of the distance from a rational spline at equal parameters, with rounding; else 0.
    pub deviation: f64,
    /// Spline: its rows + 1 rising parameters at u = 0, 1, ..., linear between.
    /// @shape rows+1
    pub knots_u: *const f64,
    /// Spline: its columns + 1 parameters, likewise.
    /// @shape columns+1
    pub knots_v: *const f64,
}

versioned! { gusset_sheet_report: 56 }

/// Reports on a sheet.
///
/// @complexity O(cells at sides).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_sheet_get_report(
    sheet: *const gusset_sheet,
    report: *mut gusset_sheet_report,
) -> gusset_status {
    lend!(sheet, report, |gusset_sheet(sheet)| {
        let ([rows, columns], [closed_u, closed_v]) = (sheet.cells(), sheet.is_closed().map(u32::from));
        let [[pole_u0, pole_u1], [pole_v0, pole_v1]] = sheet.poles_at_sides().map(|pair| pair.map(u32::from));
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

/// Fields of gusset_sheet_measures to compute.
/// @bits
pub type gusset_sheet_measure_flags = u32;
/// `diameter` and `intrinsic_diameter`.
pub const GUSSET_SHEET_MEASURE_DIAMETERS: gusset_sheet_measure_flags = 1;
/// `curvature_bound`.
pub const GUSSET_SHEET_MEASURE_CURVATURE: gusset_sheet_measure_flags = 2;
/// `crease`.
pub const GUSSET_SHEET_MEASURE_CREASE: gusset_sheet_measure_flags = 4;

/// Measures of a sheet (see gusset_cell_arrays); 0 unless requested.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_sheet_measures {
    /// sizeof(gusset_sheet_measures).
    pub struct_size: usize,
    /// Greatest of `diameters`.
    pub diameter: f64,
    /// Greatest of `intrinsic_diameters`.
    pub intrinsic_diameter: f64,
    /// Bound of absolute principal curvatures; infinite if not regular, as at poles.
    pub curvature_bound: f64,
    /// Largest angle between normals across cell sides; if smooth, 0 or rounding.
    pub crease: f64,
}

/// Arrays of one number a cell; cell (i, j) has the index i * columns + j. NULL: not computed.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_cell_arrays {
    /// sizeof(gusset_cell_arrays).
    pub struct_size: usize,
    /// Length of each array, at least all cells.
    pub capacity: usize,
    /// Bounds of a cell's diameter.
    pub diameters: *mut f64,
    /// Bounds of the shortest curve in a cell between any two points.
    pub intrinsic_diameters: *mut f64,
    /// Estimates, not bounds, of the distance from the smooth surface that nodes sample, at equal
    /// parameters. Infinite below 5 nodes in a direction; 0 for patches.
    pub errors: *mut f64,
    /// Bounds of the distance from the bilinear patch of a cell's corners.
    pub bilinear: *mut f64,
    /// Bounds of the distance from a cell's two triangles, for either diagonal.
    pub triangles: *mut f64,
}

versioned! { gusset_sheet_measures: 40, gusset_cell_arrays: 56 }

/// Returns the caller's buffer for a number a cell; `None` if it is omitted.
fn optional_cell_buffer<'a>(
    pointer: *mut f64,
    needed: usize,
    capacity: usize,
    name: &'static str,
) -> Result<Option<&'a mut [f64]>, Failure> {
    if pointer.is_null() {
        return Ok(None);
    }
    if capacity < needed {
        let message = format!("the buffer has room for {capacity} cells; it needs room for {needed}");
        return Err(Failure { value: needed as f64, ..Failure::new(GUSSET_ERROR_BUFFER_TOO_SMALL, message) });
    }
    input::result_buffer(pointer, needed, name).map(Some)
}

/// Measures a sheet and its cells.
///
/// @param parts fields of `measures` to compute; 0: all.
/// @param cells NULL: none. Unchanged after an error.
/// @param measures NULL: none.
/// @errors BUFFER_TOO_SMALL (value: number of cells)
/// @complexity O(cells), parallel; 16 bytes a cell for each of diameters, errors and distances.
/// @source Leus, eqs. (1) and (7).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_sheet_measure(
    context: *const gusset_context,
    sheet: *const gusset_sheet,
    parts: gusset_sheet_measure_flags,
    cells: *const gusset_cell_arrays,
    measures: *mut gusset_sheet_measures,
) -> gusset_status {
    let out = if measures.is_null() { Ok(None) } else { input::output_struct(measures, "measures").map(Some) };
    guard_changing_call(context, |job| {
        let (out, sheet) = (out?, &handle::get_object(sheet, "sheet")?.0);
        let cells = input::read_versioned_struct(cells, true, "cells")?;
        let all = GUSSET_SHEET_MEASURE_DIAMETERS | GUSSET_SHEET_MEASURE_CURVATURE | GUSSET_SHEET_MEASURE_CREASE;
        if parts & !all != 0 {
            return Err(Failure::unknown_value("parts", parts.into(), "a sum of GUSSET_SHEET_MEASURE_ constants"));
        }
        let is_wanted = |part| out.is_some() && (parts == 0 || parts & part != 0);
        let needed = sheet.cells().iter().product();
        let wanted = [
            (cells.diameters, "diameters"),
            (cells.intrinsic_diameters, "intrinsic_diameters"),
            (cells.errors, "errors"),
            (cells.bilinear, "bilinear"),
            (cells.triangles, "triangles"),
        ];
        let [euclidean, intrinsic, errors, bilinear, triangles] =
            wanted.map(|(to, name)| optional_cell_buffer(to, needed, cells.capacity, name));
        let (euclidean, intrinsic, errors) = (euclidean?, intrinsic?, errors?);
        let (bilinear, triangles) = (bilinear?, triangles?);

        let with_diameters = is_wanted(GUSSET_SHEET_MEASURE_DIAMETERS);
        let with_sizes = with_diameters || euclidean.is_some() || intrinsic.is_some();
        let sizes = with_sizes.then(|| Diameters::new(sheet, &job.sub_job(0.0, 0.2))).transpose()?;
        let estimates = errors.is_some().then(|| sheet.interpolation_errors(&job.sub_job(0.2, 0.4))).transpose()?;
        let is_flat_wanted = bilinear.is_some() || triangles.is_some();
        let flat = is_flat_wanted.then(|| sheet.flatness_bounds_of_cells(&job.sub_job(0.4, 0.6))).transpose()?;
        let with_curvature = is_wanted(GUSSET_SHEET_MEASURE_CURVATURE);
        let curvature = with_curvature.then(|| curvature_bound(sheet, &job.sub_job(0.6, 0.8))).transpose()?;
        let with_crease = is_wanted(GUSSET_SHEET_MEASURE_CREASE);
        let crease = with_crease.then(|| sheet.largest_crease_angle(&job.sub_job(0.8, 1.0))).transpose()?;
        job.finish()?;

        let greatest = |sizes: &Diameters| [sizes.euclidean.largest_bound(), sizes.intrinsic.largest_bound()];
        let [diameter, intrinsic_diameter] = sizes.as_ref().filter(|_| with_diameters).map_or([0.0; 2], greatest);
        if let Some(sizes) = sizes {
            euclidean.into_iter().for_each(|to| to.copy_from_slice(sizes.euclidean.values()));
            intrinsic.into_iter().for_each(|to| to.copy_from_slice(sizes.intrinsic.values()));
        }
        errors.into_iter().zip(estimates).for_each(|(to, from)| to.copy_from_slice(&from));
        for (to, k) in [(bilinear, 0), (triangles, 1)] {
            to.into_iter().zip(&flat).for_each(|(to, from)| to.iter_mut().zip(from).for_each(|(x, y)| *x = y[k]));
        }
        if let Some(out) = out {
            out.write_known_fields(gusset_sheet_measures {
                struct_size: 0,
                diameter,
                intrinsic_diameter,
                curvature_bound: curvature.unwrap_or(0.0),
                crease: crease.unwrap_or(0.0),
            });
        }
        Ok(())
    })
}

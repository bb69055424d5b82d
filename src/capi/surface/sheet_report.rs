//! Reports on sheets: Sizes, estimates and bounds.

use crate::capi::context::{guard_change, gusset_context, lend};
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
    /// For a rational spline, a bound of how far the sheet is from it at equal parameters, rounding
    /// included; 0 of any other sheet.
    pub deviation: f64,
    /// For a spline, the knots of rows: rows + 1 parameters that rise, between which the spline's
    /// parameter runs evenly; NULL of any other sheet. Valid as long as the sheet.
    pub knots_u: *const f64,
    /// The knots of columns: columns + 1.
    pub knots_v: *const f64,
}

versioned! { gusset_sheet_report: 56 }

/// Reports what a sheet is.
///
/// @param report struct_size set by the caller; all else is overwritten.
/// @complexity O(cells at the sides).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_sheet_get_report(
    sheet: *const gusset_sheet,
    report: *mut gusset_sheet_report,
) -> gusset_status {
    lend!(sheet, report, |gusset_sheet(sheet)| {
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

/// The numbers of a whole sheet that are wanted.
/// @bits
pub type gusset_sheet_measure_flags = u32;
/// `diameter` and `intrinsic_diameter`.
pub const GUSSET_SHEET_MEASURE_DIAMETERS: gusset_sheet_measure_flags = 1;
/// `curvature_bound`.
pub const GUSSET_SHEET_MEASURE_CURVATURE: gusset_sheet_measure_flags = 2;
/// `crease`.
pub const GUSSET_SHEET_MEASURE_CREASE: gusset_sheet_measure_flags = 4;

/// Numbers of a whole sheet; 0 if they were not asked for.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_sheet_measures {
    /// sizeof(gusset_sheet_measures), set by the caller.
    pub struct_size: usize,
    /// The greatest of the diameters of cells, the paper's d: a bound of the distance between any two
    /// points of a cell.
    pub diameter: f64,
    /// The greatest of the intrinsic diameters of cells.
    pub intrinsic_diameter: f64,
    /// A bound of the principal curvatures in absolute terms, from control nets: the paper's K.
    /// Infinite where the surface is not regular, as at poles.
    pub curvature_bound: f64,
    /// The largest angle between the normals on both sides of borders between cells, in radians: 0,
    /// or rounding, where the surface is smooth.
    pub crease: f64,
}

/// Arrays that receive a number for each cell, row after row: number i * columns + j belongs to
/// cell (i, j). NULL: the number is not computed.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_cell_arrays {
    /// sizeof(gusset_cell_arrays), set by the caller.
    pub struct_size: usize,
    /// How many numbers each array has room for, at least the cells of the sheet.
    pub capacity: usize,
    /// Bounds of the distance between any two points of the cell, from its control net.
    pub diameters: *mut f64,
    /// Bounds of the length of the shortest curve within the cell between any two of its points.
    pub intrinsic_diameters: *mut f64,
    /// Estimates of how far a surface through nodes is from the smooth one that they were taken
    /// from, at equal parameters: C h^4 times the fourth derivatives, from differences of nodes. No
    /// bound; infinite for fewer than 5 nodes in a direction; 0 if the patches were given.
    pub errors: *mut f64,
    /// Bounds of how far the surface is from the bilinear patch through the cell's corners.
    pub bilinear: *mut f64,
    /// Bounds of how far the surface is from the two triangles that either diagonal makes.
    pub triangles: *mut f64,
}

versioned! { gusset_sheet_measures: 40, gusset_cell_arrays: 56 }

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

/// Measures a sheet and its cells: diameters, estimates and bounds of their error, curvature, creases.
/// Computes only the numbers that are asked for.
///
/// @param parts added: what measures receives; 0: everything.
/// @param cells arrays of the caller that receive numbers by cell; NULL for none. Nothing is
///     written to them on failure.
/// @param measures struct_size set by the caller; all else is overwritten; NULL if only cells are
///     wanted.
/// @errors UNKNOWN_VALUE (parts), BUFFER_TOO_SMALL (the value is the number of cells)
/// @complexity O(cells), 16 bytes a cell for each of diameters, errors and distances; threads; the
///     same bits for any number of them.
/// @source Leus, eqs. (1) and (7); the bounds are ours.
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
    guard_change(context, |job| {
        let (out, sheet) = (out?, &handle::get(sheet, "sheet")?.0);
        let cells = input::read(cells, true, "cells")?;
        let all = GUSSET_SHEET_MEASURE_DIAMETERS | GUSSET_SHEET_MEASURE_CURVATURE | GUSSET_SHEET_MEASURE_CREASE;
        if parts & !all != 0 {
            return Err(Failure::unknown("parts", parts.into()));
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
            wanted.map(|(to, name)| buffer(to, needed, cells.capacity, name));
        let (euclidean, intrinsic, errors) = (euclidean?, intrinsic?, errors?);
        let (bilinear, triangles) = (bilinear?, triangles?);

        let with_diameters = is_wanted(GUSSET_SHEET_MEASURE_DIAMETERS);
        let with_sizes = with_diameters || euclidean.is_some() || intrinsic.is_some();
        let sizes = with_sizes.then(|| Diameters::new(sheet, &job.part(0.0, 0.2))).transpose()?;
        let estimates = errors.is_some().then(|| sheet.interpolation_errors(&job.part(0.2, 0.4))).transpose()?;
        let is_flat_wanted = bilinear.is_some() || triangles.is_some();
        let flat = is_flat_wanted.then(|| sheet.flatnesses(&job.part(0.4, 0.6))).transpose()?;
        let with_curvature = is_wanted(GUSSET_SHEET_MEASURE_CURVATURE);
        let curvature = with_curvature.then(|| curvature_bound(sheet, &job.part(0.6, 0.8))).transpose()?;
        let with_crease = is_wanted(GUSSET_SHEET_MEASURE_CREASE);
        let crease = with_crease.then(|| sheet.crease(&job.part(0.8, 1.0))).transpose()?;
        job.memory()?;

        let greatest = |sizes: &Diameters| [sizes.euclidean.greatest(), sizes.intrinsic.greatest()];
        let [diameter, intrinsic_diameter] = sizes.as_ref().filter(|_| with_diameters).map_or([0.0; 2], greatest);
        if let Some(sizes) = sizes {
            euclidean.into_iter().for_each(|to| to.copy_from_slice(sizes.euclidean.all()));
            intrinsic.into_iter().for_each(|to| to.copy_from_slice(sizes.intrinsic.all()));
        }
        errors.into_iter().zip(estimates).for_each(|(to, from)| to.copy_from_slice(&from));
        for (to, k) in [(bilinear, 0), (triangles, 1)] {
            to.into_iter().zip(&flat).for_each(|(to, from)| to.iter_mut().zip(from).for_each(|(x, y)| *x = y[k]));
        }
        if let Some(out) = out {
            out.write(gusset_sheet_measures {
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

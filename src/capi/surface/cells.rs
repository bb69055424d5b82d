//! Cells: Pairs of near cells, and cells of a region.

use crate::capi::context::{create_handle, gusset_context, lend};
use crate::capi::glue::{fixed, versioned};
use crate::capi::handle::{self, handle};
use crate::capi::input::{self, lend_list};
use crate::capi::status::gusset_status;
use crate::capi::surface::{gusset_surface, surface_of_handle};
use crate::surface::CellsInBall;
use gusset_base::alloc;

/// A cell of a surface.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_surface_cell {
    /// Index of the sheet.
    pub sheet: u32,
    /// Its row.
    pub row: u32,
    /// Its column.
    pub column: u32,
}

/// Cells, or pairs of cells.
pub struct gusset_surface_cells {
    cells: Vec<gusset_surface_cell>,
    others: Vec<gusset_surface_cell>,
    whole: Vec<u32>,
    mask: Vec<u64>,
    first: Vec<u64>,
}

handle! { gusset_surface_cells }

/// Lent cells. Regions lack `others`; pairs lack the fields below it.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_surface_cells_view {
    /// sizeof(gusset_surface_cells_view).
    pub struct_size: usize,
    /// Cells by sheet, row, column. Pairs: cells of the first surface by both sheets, row, column.
    /// @shape cell_count
    pub cells: *const gusset_surface_cell,
    /// Number of cells or pairs.
    pub cell_count: usize,
    /// Cells of the second surface.
    /// @shape cell_count
    pub others: *const gusset_surface_cell,
    /// By cell: 1 if all of it is within the radius.
    /// @shape cell_count
    /// @flag
    pub whole: *const u32,
    /// A bit a cell, 1 in the region. Cell (i, j) of sheet k with c columns has bit b = first[k] +
    /// i * c + j: mask[b / 64] >> (b % 64) & 1.
    /// @shape word_count
    pub mask: *const u64,
    /// Words of the mask.
    pub word_count: usize,
    /// First bit of each sheet, then the number of bits.
    /// @shape sheet_count+1
    pub first: *const u64,
    /// Number of sheets.
    pub sheet_count: usize,
}

versioned! { gusset_surface_cells_view: 72 }
fixed! { gusset_surface_cell: 12 }

/// Finds the cells with a point within a radius of a query.
///
/// No cell is missed; some lie outside by the tolerance, or more if bounded work cannot decide.
///
/// @param query a point.
/// @param radius at least 0; INFINITY: all cells.
/// @errors NOT_FINITE, OUT_OF_RANGE (radius, query)
/// @complexity O(cells found), and one bit a cell.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_surface_region_create(
    context: *const gusset_context,
    surface: *const gusset_surface,
    query: *const f64,
    radius: f64,
    cells: *mut *mut gusset_surface_cells,
) -> gusset_status {
    create_handle(context, cells, "cells", |job| {
        let (surface, query) = (surface_of_handle(surface)?, input::read_vector(query, "query")?);
        let CellsInBall { cells, is_whole_cell_inside: whole, mask, first_bit_of_sheet: first } =
            surface.cells_in_ball(query, radius, job)?;
        let cell = |[sheet, row, column]: [u32; 3]| gusset_surface_cell { sheet, row, column };
        Ok(gusset_surface_cells {
            cells: alloc::collect(cells.into_iter().map(cell))?,
            others: Vec::new(),
            whole: alloc::collect(whole.into_iter().map(u32::from))?,
            mask,
            first,
        })
    })
}

/// Finds the pairs of cells of two surfaces that may be within a distance.
///
/// No pair is missed; a few may be farther apart.
///
/// @param within 0: cells that may meet.
/// @errors OUT_OF_RANGE (within), TOO_LARGE (above 2^26 pairs)
/// @complexity Proportional to pairs and index levels; 24 bytes a pair.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_surface_cell_pairs_create(
    context: *const gusset_context,
    surface: *const gusset_surface,
    other: *const gusset_surface,
    within: f64,
    cells: *mut *mut gusset_surface_cells,
) -> gusset_status {
    create_handle(context, cells, "cells", |job| {
        let found =
            surface_of_handle(surface)?.candidate_cell_pairs(&handle::get_object(other, "other")?.0, within, job)?;
        let part = |which: usize| {
            alloc::collect(found.iter().map(move |pair| {
                let [row, column] = pair.cells[which];
                gusset_surface_cell { sheet: pair.sheets[which], row, column }
            }))
        };
        let (cells, others) = (part(0)?, part(1)?);
        Ok(gusset_surface_cells { cells, others, whole: Vec::new(), mask: Vec::new(), first: Vec::new() })
    })
}

/// Lends the cells.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_surface_cells_get_view(
    cells: *const gusset_surface_cells,
    view: *mut gusset_surface_cells_view,
) -> gusset_status {
    lend!(cells, view, |found| gusset_surface_cells_view {
        struct_size: 0,
        cells: lend_list(&found.cells),
        cell_count: found.cells.len(),
        others: lend_list(&found.others),
        whole: lend_list(&found.whole),
        mask: lend_list(&found.mask),
        word_count: found.mask.len(),
        first: lend_list(&found.first),
        sheet_count: found.first.len().saturating_sub(1),
    })
}

/// Frees cells.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gusset_surface_cells_destroy(cells: *mut gusset_surface_cells) {
    handle::destroy(cells);
}

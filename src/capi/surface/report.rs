//! C interface: reports on surfaces and their sheets.

use crate::capi::context::lend;
use crate::capi::glue::versioned;
use crate::capi::status::{Failure, gusset_status};
use crate::capi::surface::gusset_surface;

/// What a surface is.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_surface_report {
    /// sizeof(gusset_surface_report), set by the caller.
    pub struct_size: usize,
    /// How many sheets.
    pub sheet_count: usize,
    /// How many cells, of all sheets.
    pub cell_count: usize,
    /// How many corners of cells: of sheets from nodes, the nodes.
    pub node_count: usize,
    /// Bytes of the index without the cones of normals; the nodes are not counted.
    pub index_bytes: usize,
    /// The length to which answers are proved.
    pub tolerance: f64,
    /// A corner of a box round the surface and the control nets of its cells, which may be larger
    /// than the surface: the least x, y, z.
    pub low: [f64; 3],
    /// The greatest.
    pub high: [f64; 3],
    /// Bytes of the cones of normals; 0 as long as there are none: see gusset_surface_options.
    pub cone_bytes: usize,
}

/// What a sheet of a surface is.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_surface_sheet_report {
    /// sizeof(gusset_surface_sheet_report), set by the caller.
    pub struct_size: usize,
    /// Cells in u: u runs from 0 to this. There is one more row of corners.
    pub rows: usize,
    /// Cells in v.
    pub columns: usize,
    /// The number of its cell (0, 0) among the cells of all sheets, one sheet after the other, each
    /// row after row: of cell (i, j) it is first_cell + i * columns + j, the bit of masks of
    /// gusset_surface_region_view.
    pub first_cell: u64,
    /// The same of its corner (0, 0) among the corners of all sheets, rows + 1 by columns + 1 each:
    /// where its values begin for gusset_surface_contours_create.
    pub first_node: u64,
    /// 1: closed in u.
    pub closed_u: u32,
    /// 1: closed in v.
    pub closed_v: u32,
}

versioned! { gusset_surface_report: 96, gusset_surface_sheet_report: 48 }

/// What a surface is.
///
/// @param surface the surface.
/// @param[out] facts struct_size set by the caller; all else is overwritten.
/// @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE.
/// @complexity O(sheets).
/// @since 0.1
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_surface_get_report(
    surface: *const gusset_surface,
    facts: *mut gusset_surface_report,
) -> gusset_status {
    lend!(surface, facts, |gusset_surface(surface)| {
        let [low, high] = surface.bounds().map(|corner| corner.to_array());
        gusset_surface_report {
            struct_size: 0,
            sheet_count: surface.len(),
            cell_count: surface.cell_count() as usize,
            node_count: surface.node_count() as usize,
            index_bytes: surface.index_bytes(),
            tolerance: surface.tolerance(),
            low,
            high,
            cone_bytes: surface.cone_bytes(),
        }
    })
}

/// What a sheet of a surface is.
///
/// @param surface the surface.
/// @param sheet its number, as in places.
/// @param[out] facts struct_size set by the caller; all else is overwritten.
/// @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE,
///     NO_SUCH_ELEMENT (sheet).
/// @complexity O(sheets).
/// @since 0.1
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_surface_get_sheet(
    surface: *const gusset_surface,
    sheet: usize,
    facts: *mut gusset_surface_sheet_report,
) -> gusset_status {
    lend!(surface, facts, |gusset_surface(surface)| {
        if sheet >= surface.len() {
            return Err(Failure::no_such("sheet", sheet));
        }
        let (cells, closed) = (surface.sheet(sheet).cells(), surface.sheet(sheet).is_closed().map(u32::from));
        let before = |more: usize| -> u64 {
            (0..sheet)
                .map(|k| surface.sheet(k).cells().map(|count| (count + more) as u64).iter().product::<u64>())
                .sum()
        };
        gusset_surface_sheet_report {
            struct_size: 0,
            rows: cells[0],
            columns: cells[1],
            first_cell: before(0),
            first_node: before(1),
            closed_u: closed[0],
            closed_v: closed[1],
        }
    })
}

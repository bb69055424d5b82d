//! Reports on surfaces: Facts about a surface and its sheets.

use crate::capi::context::lend;
use crate::capi::glue::versioned;
use crate::capi::input::lent;
use crate::capi::status::gusset_status;
use crate::capi::surface::{gusset_surface, gusset_surface_sheet};

/// Facts about a surface.
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
    /// The sheets, sheet_count of them, valid as long as the surface.
    pub sheets: *const gusset_surface_sheet,
}

versioned! { gusset_surface_report: 96 }

/// Reports on a surface and its sheets.
///
/// @param report struct_size set by the caller; all else is overwritten.
/// @complexity O(sheets).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_surface_get_report(
    surface: *const gusset_surface,
    report: *mut gusset_surface_report,
) -> gusset_status {
    lend!(surface, report, |gusset_surface(surface, sheets)| {
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
            sheets: lent(sheets),
        }
    })
}

//! Reports on surfaces: Facts about a surface and its sheets.

use crate::capi::context::lend;
use crate::capi::glue::versioned;
use crate::capi::input::lend_list;
use crate::capi::status::gusset_status;
use crate::capi::surface::{gusset_surface, gusset_surface_sheet};

/// Facts about a surface.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_surface_report {
    /// sizeof(gusset_surface_report).
    pub struct_size: usize,
    /// Number of sheets.
    pub sheet_count: usize,
    /// Cells of all sheets.
    pub cell_count: usize,
    /// Corners of cells; nodes of sheets from nodes.
    pub node_count: usize,
    /// Bytes of the index, without nodes and cones.
    pub index_bytes: usize,
    /// Guaranteed accuracy, as in gusset_surface_options.
    pub tolerance: f64,
    /// Low corner of a box round surface and controls.
    pub low: [f64; 3],
    /// High corner.
    pub high: [f64; 3],
    /// Bytes of the cones of normals; 0 if not built.
    pub cone_bytes: usize,
    /// The sheets.
    /// @shape sheet_count
    pub sheets: *const gusset_surface_sheet,
}

versioned! { gusset_surface_report: 96 }

/// Reports on a surface and its sheets.
///
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
            sheets: lend_list(sheets),
        }
    })
}

//! Meshes of sheets: Meshes of points of a sheet.

use crate::capi::context::{create_handle, gusset_context};
use crate::capi::glue::versioned;
use crate::capi::handle;
use crate::capi::input::{self, lend_list, read_flag};
use crate::capi::mesh::result::{OperationResult, gusset_result, report};
use crate::capi::status::{Failure, gusset_status};
use crate::capi::surface::gusset_surface_place;
use crate::capi::surface::sheet::gusset_sheet;
use crate::surface::SurfaceMeshOptions;
use gusset_base::alloc;

/// Options of gusset_sheet_to_mesh. By default each cell becomes one quad.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_sheet_mesh_options {
    /// sizeof(gusset_sheet_mesh_options).
    pub struct_size: usize,
    /// Largest distance of triangles from the surface, above 0; 0 or INFINITY: unlimited.
    pub tolerance: f64,
    /// Least parts of a cell in u; 0: 1.
    pub min_u: u32,
    /// Least parts of a cell in v; 0: 1.
    pub min_v: u32,
    /// 1: triangles only; 0: quads, with triangles at poles.
    /// @flag
    pub triangles: u32,
    /// 0.
    pub reserved: u32,
}

/// Places and normals of a sheet's mesh.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_sheet_mesh_report {
    /// sizeof(gusset_sheet_mesh_report).
    pub struct_size: usize,
    /// Number of vertices.
    pub vertex_count: usize,
    /// Place of each vertex, with sheet 0.
    /// @shape vertex_count
    pub places: *const gusset_surface_place,
    /// Unit normal of each vertex; 0 if undefined.
    /// @shape vertex_count 3
    pub normals: *const f64,
    /// Bound of the distance between surface and triangles, for either diagonal of quads.
    pub deviation: f64,
}

versioned! { gusset_sheet_mesh_options: 32 reserved, gusset_sheet_mesh_report: 40 }

impl gusset_sheet_mesh_options {
    fn checked(self) -> Result<SurfaceMeshOptions, Failure> {
        Ok(SurfaceMeshOptions {
            tolerance: if self.tolerance == 0.0 { f64::INFINITY } else { self.tolerance },
            least: [self.min_u.max(1), self.min_v.max(1)],
            triangles: read_flag(self.triangles, "triangles")?,
        })
    }
}

/// Makes a sheet's mesh.
///
/// Cells of a row share the number of parts in u, cells of a column in v. Seams and poles are
/// closed. Faces are counter-clockwise seen against S_u x S_v. The mesh may lack faces.
///
/// @errors OUT_OF_RANGE (tolerance), TOO_LARGE (UINT32_MAX corners or more)
/// @complexity O(cells + vertices).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_sheet_to_mesh(
    context: *const gusset_context,
    sheet: *const gusset_sheet,
    options: *const gusset_sheet_mesh_options,
    result: *mut *mut gusset_result,
) -> gusset_status {
    create_handle(context, result, "result", |job| {
        let options = input::read_versioned_struct(options, true, "options")?.checked()?;
        let made = handle::get_object(sheet, "sheet")?.0.to_mesh(&options, job)?;
        let places = alloc::collect(made.places.iter().map(|&place| gusset_surface_place::from(place)))?;
        Ok(gusset_result(OperationResult::SheetMesh(made, places)))
    })
}

/// Lends the places and normals.
///
/// @errors WRONG_HANDLE
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_result_get_sheet_mesh(
    result: *const gusset_result,
    report: *mut gusset_sheet_mesh_report,
) -> gusset_status {
    report!(result, report, "gusset_sheet_to_mesh", OperationResult::SheetMesh(made, places) => gusset_sheet_mesh_report {
        struct_size: 0,
        vertex_count: places.len(),
        places: lend_list(places),
        normals: lend_list(&made.normals).cast(),
        deviation: made.deviation,
    })
}

//! C interface: meshes of sheets.

use crate::attributes::Origins;
use crate::capi::context::{create, gusset_context, lend};
use crate::capi::glue::versioned;
use crate::capi::handle::{self, handle};
use crate::capi::input::{self, flag, lent};
use crate::capi::mesh::origins::gusset_origins;
use crate::capi::mesh::{self, gusset_mesh_view};
use crate::capi::status::{Failure, gusset_status};
use crate::capi::surface::gusset_surface_place;
use crate::capi::surface::sheet::gusset_sheet;
use crate::surface::{SurfaceMesh, SurfaceMeshOptions};
use gusset_base::alloc;

/// The mesh of a sheet. Opaque and immutable; it keeps nothing of the sheet.
pub struct gusset_sheet_mesh {
    made: SurfaceMesh,
    places: Vec<gusset_surface_place>,
}

handle! { gusset_sheet_mesh }

/// How a sheet becomes a mesh. All zeros: quads, one a cell.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_sheet_mesh_options {
    /// sizeof(gusset_sheet_mesh_options), set by the caller.
    pub struct_size: usize,
    /// How far triangles may be from the surface, a length more than 0; 0, or INFINITY: no demand.
    pub tolerance: f64,
    /// The fewest parts of each cell in u; 0 stands for 1.
    pub min_u: u32,
    /// The fewest parts of each cell in v; 0 stands for 1.
    pub min_v: u32,
    /// 1: triangles only; 0: quads, and triangles at poles.
    pub triangles: u32,
    /// 0.
    pub reserved: u32,
}

/// What belongs to the mesh of a sheet. Pointers are valid until it is destroyed.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_sheet_mesh_view {
    /// sizeof(gusset_sheet_mesh_view), set by the caller.
    pub struct_size: usize,
    /// The number of vertices.
    pub vertex_count: usize,
    /// For each vertex its place; the sheet is 0.
    pub places: *const gusset_surface_place,
    /// For each vertex the unit normal: x, y, z; 0 where there is none.
    pub normals: *const f64,
    /// A bound of the distance between the surface and the triangles, or either pair of triangles
    /// of quads.
    pub deviation: f64,
}

versioned! { gusset_sheet_mesh_options: 32 reserved, gusset_sheet_mesh_view: 40 }

impl gusset_sheet_mesh_options {
    fn checked(self) -> Result<SurfaceMeshOptions, Failure> {
        Ok(SurfaceMeshOptions {
            tolerance: if self.tolerance == 0.0 { f64::INFINITY } else { self.tolerance },
            least: [self.min_u.max(1), self.min_v.max(1)],
            triangles: flag(self.triangles, "triangles")?,
        })
    }
}

/// Makes a mesh of points of a sheet.
///
/// Cells of a row have equally many parts in u, those of a column in v, so that neighbours fit;
/// seams of closed directions and poles are closed. Faces are counter-clockwise seen from where S_u
/// x S_v points to. A mesh without faces is no failure.
///
/// @param context threads, progress, cancellation and error report; NULL for the defaults.
/// @param sheet the sheet.
/// @param options NULL for the defaults.
/// @param[out] mesh receives the result, for gusset_sheet_mesh_destroy; NULL on failure.
/// @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE,
///     UNKNOWN_VALUE, OUT_OF_RANGE (tolerance), TOO_LARGE (2^32 - 1 corners and more),
///     OUT_OF_MEMORY, CANCELLED.
/// @complexity O(cells + vertices).
/// @since 0.1
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_sheet_mesh_create(
    context: *const gusset_context,
    sheet: *const gusset_sheet,
    options: *const gusset_sheet_mesh_options,
    mesh: *mut *mut gusset_sheet_mesh,
) -> gusset_status {
    create(context, mesh, "mesh", |job| {
        let options = input::read(options, true, "options")?.checked()?;
        let made = handle::get(sheet, "sheet")?.0.to_mesh(&options, job)?;
        let places = alloc::collect(made.places.iter().map(|&place| gusset_surface_place::from(place)))?;
        Ok(gusset_sheet_mesh { made, places })
    })
}

/// Destroys the mesh of a sheet; NULL is allowed.
///
/// @param[in,out] mesh the handle; NULL is allowed.
/// @since 0.1
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gusset_sheet_mesh_destroy(mesh: *mut gusset_sheet_mesh) {
    handle::destroy(mesh);
}

/// Lends the mesh, valid until it is destroyed.
///
/// @param mesh the mesh.
/// @param[out] view its struct_size set.
/// @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE.
/// @complexity O(1).
/// @since 0.1
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_sheet_mesh_get_mesh(
    mesh: *const gusset_sheet_mesh,
    view: *mut gusset_mesh_view,
) -> gusset_status {
    lend!(mesh, view, |mesh| self::mesh::lend(&mesh.made.mesh))
}

/// Lends places and normals of the vertices.
///
/// @param mesh the mesh.
/// @param[out] parts receives the parts; struct_size is set by the caller.
/// @return GUSSET_OK, or an error: those of gusset_sheet_mesh_get_mesh.
/// @since 0.1
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_sheet_mesh_get_view(
    mesh: *const gusset_sheet_mesh,
    parts: *mut gusset_sheet_mesh_view,
) -> gusset_status {
    lend!(mesh, parts, |mesh| gusset_sheet_mesh_view {
        struct_size: 0,
        vertex_count: mesh.places.len(),
        places: lent(&mesh.places),
        normals: lent(&mesh.made.normals).cast(),
        deviation: mesh.made.deviation,
    })
}

/// The origins of the mesh of a sheet: its one input is the sheet, whose nodes are those between its
/// cells, (rows + 1) * (columns + 1) of them, row after row.
///
/// A vertex and a corner have the nodes of their cell, by its parameters; on a line that closes the
/// sheet each corner has those of its own face's side, so that an image need not run back there.
/// Faces have their cells.
///
/// @param context threads, progress, cancellation and error report; NULL for the defaults.
/// @param mesh the mesh.
/// @param[out] origins receives the result, for gusset_origins_destroy; NULL on failure.
/// @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, TOO_LARGE, OUT_OF_MEMORY,
///     CANCELLED.
/// @complexity O(corners); 52 bytes for each vertex and corner.
/// @since 0.1
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_sheet_mesh_origins_create(
    context: *const gusset_context,
    mesh: *const gusset_sheet_mesh,
    origins: *mut *mut gusset_origins,
) -> gusset_status {
    create(context, origins, "origins", |job| {
        Ok(gusset_origins(Origins::of_surface_mesh(&handle::get(mesh, "mesh")?.made, job)?))
    })
}

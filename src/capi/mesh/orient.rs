//! Orientation: Turns faces over until neighbours agree.
//!
//! @source Textbook; the least number of faces is our own.

use crate::attributes::KeepSplitVertices;
use crate::capi::context::{create_handle, gusset_context};
use crate::capi::glue::versioned;
use crate::capi::input::{self, lend_list};
use crate::capi::mesh::result::{OperationResult, gusset_result, report};
use crate::capi::mesh::stitch_options::{gusset_outward, to_outward};
use crate::capi::mesh::{self, gusset_indices, gusset_mesh_view};
use crate::capi::status::gusset_status;
use crate::repair::orient::{Options, Outward, orient};
use gusset_base::alloc;

/// Options of gusset_orient.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_orient_options {
    /// sizeof(gusset_orient_options).
    pub struct_size: usize,
    /// Side that closed components face.
    pub outward: gusset_outward,
    /// 0.
    pub reserved: u32,
}

/// Faces turned over, and components that cannot be oriented.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_orient_report {
    /// sizeof(gusset_orient_report).
    pub struct_size: usize,
    /// For each face, 1 if it was turned over.
    /// @shape face_count
    /// @flag
    pub turned: *const u8,
    /// Number of faces.
    pub face_count: usize,
    /// Smallest face of each non-orientable component, ascending.
    pub one_sided_faces: gusset_indices,
    /// For each of them, a half-edge where faces cannot agree.
    pub one_sided_half_edges: gusset_indices,
    /// Faces turned over.
    pub turned_faces: u32,
    /// Components: faces connected by edges with two faces. A degenerate face is one.
    pub component_count: u32,
    /// Closed components that face outwards only by GUSSET_OUTWARD_CLOSED.
    pub inverted_components: u32,
    /// 0.
    pub reserved: u32,
}

versioned! { gusset_orient_options: 16 reserved, gusset_orient_report: 72 }

/// Turns faces over until the two faces of each edge run it in opposite directions.
///
/// Each component turns the fewest faces; on a tie, its smallest face stays. Non-manifold edges
/// connect nothing. Non-orientable components stay unchanged and are listed. Vertices and the order
/// of faces do not change.
///
/// @errors as gusset_mesh_view
/// @complexity O(H log d).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_orient(
    context: *const gusset_context,
    mesh: *const gusset_mesh_view,
    options: *const gusset_orient_options,
    result: *mut *mut gusset_result,
) -> gusset_status {
    create_handle(context, result, "result", |job| {
        let options = Options {
            outward: to_outward(input::read_versioned_struct(options, true, "options")?.outward, Outward::Keep)?,
        };
        let given_mesh = mesh::read_numbered_mesh(mesh, 0, &job.sub_job(0.0, 0.2))?;
        let mesh = given_mesh.mesh_view();
        let mut done = self::orient(&mesh, &options, &job.sub_job(0.2, 0.9))?;
        done.keep_split_vertices(&[&mesh], &job.sub_job(0.9, 1.0))?;
        let one_sided = [
            alloc::collect(done.one_sided.iter().map(|found| found.face))?,
            alloc::collect(done.one_sided.iter().map(|found| found.half_edge))?,
        ];
        Ok(gusset_result(OperationResult::Orient(done, one_sided)))
    })
}

/// Lends the report.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_result_get_orient(
    result: *const gusset_result,
    report: *mut gusset_orient_report,
) -> gusset_status {
    report!(result, report, "gusset_orient", OperationResult::Orient(done, one_sided) => gusset_orient_report {
        struct_size: size_of::<gusset_orient_report>(),
        // A bool is one byte, 0 or 1.
        turned: lend_list(&done.turned).cast(),
        face_count: done.turned.len(),
        one_sided_faces: gusset_indices::lend_indices(&one_sided[0]),
        one_sided_half_edges: gusset_indices::lend_indices(&one_sided[1]),
        turned_faces: done.turned_faces,
        component_count: done.components,
        inverted_components: done.inverted_components,
        reserved: 0,
    })
}

//! Triangulation: Splits faces into triangles.
//!
//! @source G. Meisters, Polygons have ears, 1975; G. Klincsek, Minimal triangulations of polygonal
//!     domains, 1980.

use crate::capi::context::{create_handle, gusset_context};
use crate::capi::mesh::result::{OperationResult, gusset_result};
use crate::capi::mesh::{self, gusset_mesh_view};
use crate::capi::status::gusset_status;
use crate::mesh::triangulate;

/// Splits faces into triangles of their corners, in order.
///
/// A face of n corners becomes n - 2 triangles with all its corners: a closed mesh stays closed.
/// Vertices keep their indices.
/// - A quad is split by its shorter diagonal, or, if concave, by the one inside.
/// - A larger face becomes a fan if its first corner sees all others. Otherwise its ears are cut
///   off, in projection along a coordinate axis. A face may pass edges twice to reach a hole.
/// - If triangles of a warped or self-crossing face of at most 40 corners overlap, the split with
///   the least overlap replaces them.
///
/// gusset_result_origins_create gives each triangle's face and corners.
///
/// @errors as gusset_mesh_view
/// @complexity O(H); for a face of n corners that is not convex O(n log n), and at most 1000 tests
///     a corner.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_triangulate(
    context: *const gusset_context,
    mesh: *const gusset_mesh_view,
    result: *mut *mut gusset_result,
) -> gusset_status {
    create_handle(context, result, "result", |job| {
        let given_mesh = mesh::read_numbered_mesh(mesh, 0, &job.sub_job(0.0, 0.2))?;
        let done = triangulate(&given_mesh.mesh_view(), &job.sub_job(0.2, 1.0))?;
        Ok(gusset_result(OperationResult::Triangulate(done)))
    })
}

//! Sewing: Joins coincident borders, even if vertices do not match.

use crate::attributes::KeepSplitVertices;
use crate::capi::context::{create_handle, gusset_context};
use crate::capi::glue::versioned;
use crate::capi::input;
use crate::capi::mesh::result::{OperationResult, gusset_result, report};
use crate::capi::mesh::weld::gusset_weld_options;
use crate::capi::mesh::{self, gusset_indices, gusset_mesh_view};
use crate::capi::status::gusset_status;
use crate::repair::sew::sew;

/// Effects of sewing. Lists are ascending.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_sew_report {
    /// sizeof(gusset_sew_report).
    pub struct_size: usize,
    /// As in gusset_weld_report.
    pub vertex_map: gusset_indices,
    /// Index of each old face's first part; UINT32_MAX if dropped.
    pub face_map: gusset_indices,
    /// Old face of each face of the result.
    pub face_origin: gusset_indices,
    /// Old vertices that coincide with another, or lie inside a boundary edge, but are not sewn.
    pub left_vertices: gusset_indices,
    /// Vertices merged into a smaller one.
    pub welded_vertices: u32,
    /// Edges made from boundary edges or their parts.
    pub sewn_edges: u32,
    /// Points at which boundary edges were split.
    pub splits: u32,
    /// Old faces that were cut or gained corners.
    pub split_faces: u32,
    /// Dropped old faces.
    pub dropped_faces: u32,
    /// As in gusset_weld_report.
    pub near_edge_pairs: u32,
    /// As in gusset_weld_report.
    pub tolerance: f64,
    /// As in gusset_weld_report.
    pub near_tolerance: f64,
}

versioned! { gusset_sew_report: 112 }

/// Sews coincident borders.
/// - Vertices are welded as by gusset_weld, before and after the splits.
/// - Boundary edges are split at vertices of other borders inside them (T-junctions), if exactly
///   two pieces coincide there. Triangles are cut into triangles, none turned over; larger faces
///   gain corners.
/// - A vertex lies inside an edge, longer than twice the tolerance, if it is within the tolerance
///   of the edge and not of its ends.
/// - Splitting makes no non-manifold edges or degenerate faces.
/// - The result has the old faces in order, or their parts in their places. The smallest of merged
///   vertices remains. New vertices have old positions.
///
/// @param options as for gusset_weld; GUSSET_WELD_ALL welds all vertices before the splits, borders
///     afterwards.
/// @errors as gusset_weld, TOO_LARGE (the result)
/// @complexity O(H log H), if valences are small and few vertices lie inside each edge.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_sew(
    context: *const gusset_context,
    mesh: *const gusset_mesh_view,
    options: *const gusset_weld_options,
    result: *mut *mut gusset_result,
) -> gusset_status {
    create_handle(context, result, "result", |job| {
        let options = input::read_versioned_struct(options, true, "options")?.checked()?;
        let given_mesh = mesh::read_numbered_mesh(mesh, 0, &job.sub_job(0.0, 0.1))?;
        let mesh = given_mesh.mesh_view();
        let mut done = self::sew(&mesh, &options, &job.sub_job(0.1, 0.9))?;
        done.keep_split_vertices(&[&mesh], &job.sub_job(0.9, 1.0))?;
        Ok(gusset_result(OperationResult::Sew(done)))
    })
}

/// Lends the report.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_result_get_sew(
    result: *const gusset_result,
    report: *mut gusset_sew_report,
) -> gusset_status {
    report!(result, report, "gusset_sew", OperationResult::Sew(done) => gusset_sew_report {
        struct_size: size_of::<gusset_sew_report>(),
        vertex_map: gusset_indices::lend_indices(&done.vertex_map),
        face_map: gusset_indices::lend_indices(&done.face_map),
        face_origin: gusset_indices::lend_indices(&done.face_origin),
        left_vertices: gusset_indices::lend_indices(&done.left_vertices),
        welded_vertices: done.welded_vertices,
        sewn_edges: done.sewn_edges,
        splits: done.splits,
        split_faces: done.split_faces,
        dropped_faces: done.dropped_faces,
        near_edge_pairs: done.near.edge_pairs,
        tolerance: done.tolerance,
        near_tolerance: done.near.tolerance,
    })
}

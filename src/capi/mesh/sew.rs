//! Sewing: Joins coincident borders, also where their vertices do not match.

use crate::attributes::KeepSplits;
use crate::capi::context::{create, gusset_context};
use crate::capi::glue::versioned;
use crate::capi::input;
use crate::capi::mesh::result::{Made, gusset_result, report};
use crate::capi::mesh::weld::gusset_weld_options;
use crate::capi::mesh::{self, gusset_indices, gusset_mesh_view};
use crate::capi::status::gusset_status;
use crate::repair::sew::sew;

/// What became of the old mesh. Lists are ascending; pointers are valid until the result is
/// destroyed.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_sew_report {
    /// sizeof(gusset_sew_report), set by the caller.
    pub struct_size: usize,
    /// Per old vertex, its index in the result; UINT32_MAX if it was left out as unused.
    pub vertex_map: gusset_indices,
    /// Per old face, the index in the result of the first face that it became; UINT32_MAX if it
    /// was dropped.
    pub face_map: gusset_indices,
    /// Per face of the result, the old face that it is, or is a part of; ascending.
    pub face_origin: gusset_indices,
    /// Old vertices that lie together with another, or inside a free edge, and are not sewn to it.
    pub left_vertices: gusset_indices,
    /// Vertices that became one with a smaller one.
    pub welded_vertices: u32,
    /// Edges of two faces that were free edges, or parts of such.
    pub sewn_edges: u32,
    /// Points at which free edges were split.
    pub splits: u32,
    /// Old faces that were cut or gained corners.
    pub split_faces: u32,
    /// Old faces that were dropped.
    pub dropped_faces: u32,
    /// 0.
    pub reserved: u32,
    /// How far apart what lies together was allowed to be, short edges apart; 0 for equal
    /// positions.
    pub tolerance: f64,
}

versioned! { gusset_sew_report: 104 }

/// Sews borders that lie on one another, also where their vertices do not match.
///
/// Vertices are welded first, as by gusset_weld. Where a vertex of one border then lies
/// inside a free edge of another (a T-junction), the edge is split there, if that makes pieces of
/// which exactly two lie on one another; triangles with split edges are cut into triangles, none of
/// them turned over, and larger faces gain corners. Then borders are welded again. So the result
/// has no edge of three or more faces and no degenerate face that welding alone would not have
/// made. Vertices that lie inside an edge which is not split there are listed as left, as are those
/// that welding leaves.
///
/// A vertex lies inside an edge that is longer than twice the tolerance if it is within the
/// tolerance of it and beyond that from both its ends. By default it is that of welding: see
/// gusset_weld_options.
///
/// The result has the old faces in their order, and the parts of one in place of it, one after the
/// other. Of vertices made one the smallest is left, and its position keeps its bits; new vertices
/// have the position of an old one.
///
/// @param options how to weld, NULL for the defaults. With GUSSET_WELD_ALL all vertices are welded
///     before edges are split, and borders after it.
/// @errors as gusset_weld, TOO_LARGE (the result has too many elements)
/// @complexity O(H log H) for H half-edges, if no vertex has very many and few vertices lie inside
///     each edge; linear extra memory.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_sew(
    context: *const gusset_context,
    mesh: *const gusset_mesh_view,
    options: *const gusset_weld_options,
    result: *mut *mut gusset_result,
) -> gusset_status {
    create(context, result, "result", |job| {
        let options = input::read(options, true, "options")?.checked()?;
        let given_mesh = mesh::mesh(mesh, 0, &job.part(0.0, 0.1))?;
        let mesh = given_mesh.view();
        let mut done = self::sew(&mesh, &options, &job.part(0.1, 0.9))?;
        done.keep_splits(&[&mesh], &job.part(0.9, 1.0))?;
        Ok(gusset_result(Made::Sew(done)))
    })
}

/// Lends the maps, lists and counts, for results of gusset_sew.
///
/// @errors as gusset_result_get_mesh, WRONG_HANDLE (the result was made by another operation)
/// @complexity O(1).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_result_get_sew(
    result: *const gusset_result,
    report: *mut gusset_sew_report,
) -> gusset_status {
    report!(result, report, "gusset_sew", Made::Sew(done) => gusset_sew_report {
        struct_size: size_of::<gusset_sew_report>(),
        vertex_map: gusset_indices::lend(&done.vertex_map),
        face_map: gusset_indices::lend(&done.face_map),
        face_origin: gusset_indices::lend(&done.face_origin),
        left_vertices: gusset_indices::lend(&done.left_vertices),
        welded_vertices: done.welded_vertices,
        sewn_edges: done.sewn_edges,
        splits: done.splits,
        split_faces: done.split_faces,
        dropped_faces: done.dropped_faces,
        reserved: 0,
        tolerance: done.tolerance,
    })
}

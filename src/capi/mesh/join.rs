//! Joining: Joins open pieces into one mesh.
//!
//! @source Nesterenko for a single gap.

use crate::assemble::assemble;
use crate::attributes::KeepSplitVertices;
use crate::capi::context::{create_handle, gusset_context};
use crate::capi::input;
use crate::capi::mesh::join_options::{gusset_join_options, read_loop_pairs};
use crate::capi::mesh::join_report::{JoinResult, gusset_join_report};
use crate::capi::mesh::result::{OperationResult, gusset_result, report};
use crate::capi::mesh::{self, GivenMesh, gusset_mesh_view};
use crate::capi::status::gusset_status;
use gusset_base::alloc;

/// Joins open pieces into one mesh: sews coincident borders, orients components, joins facing loops
/// by strips, fills holes, and turns closed components outwards.
///
/// Vertices and faces come from pieces, strips, then patches, in the first piece's scalar type.
/// Strips enclose overlaps that are not trimmed.
///
/// Facing loops of different components are joined, by the best matching:
/// - Whole loops, if the conormals (tangents off the surface) of each point to the other, without a
///   much nearer loop.
/// - Whole loops, if 9/10 of each one's vertices are nearest to the other, once round it or at
///   similar distances. Similar: the ninth decile is at most 4 times the first, or the vertex
///   spacing.
/// - Else runs of mutually nearest vertices, by open strips.
///
/// @param pieces at least one; struct_size of the first holds for all.
/// @errors as gusset_mesh_view, EMPTY_MESH, MIXED_SCALARS, OUT_OF_RANGE (a tolerance, max_gap, or
///     an entry of pairs or excluded: index is the entry, input its loop 0 or 1, value the missing
///     piece, else the vertex. It does not exist. In pairs, also: no vertex, no or several joinable
///     loops at it, or a loop named before), TOO_LARGE
/// @complexity O(H log d + V log V) for V vertices on loops. Also gusset_stitch for each strip,
///     gusset_fill for each hole, and a pass over all faces for each strip faired or tested for
///     intersections.
/// @source Nesterenko for a single gap.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_join(
    context: *const gusset_context,
    pieces: *const gusset_mesh_view,
    piece_count: usize,
    options: *const gusset_join_options,
    result: *mut *mut gusset_result,
) -> gusset_status {
    create_handle(context, result, "result", |job| {
        let options = input::read_versioned_struct(options, true, "options")?;
        let trim = input::read_nested_or_default(options.trim_options, "trim_options", Ok)?;
        let viewpoints = trim.read_viewpoints().map_err(|failure| failure.with_field("trim_options"))?;
        let mut given = read_loop_pairs(options.pairs, options.pair_count, "pairs")?;
        let mut excluded = read_loop_pairs(options.excluded, options.excluded_count, "excluded")?;
        let given_meshes = mesh::read_meshes(pieces, piece_count, &job.sub_job(0.0, 0.1))?;
        let views = alloc::collect(given_meshes.iter().map(GivenMesh::mesh_view))?;
        for selector in given.iter_mut().chain(&mut excluded).flatten() {
            if let Some(view) = views.get(selector.piece as usize) {
                selector.vertex = view.faces().merged_vertex(selector.vertex);
            }
        }
        let options = options.checked([&given, &excluded], trim, &viewpoints)?;
        let mut done = assemble(&views, &options, &job.sub_job(0.1, 0.95))?;
        done.keep_split_vertices(&alloc::gather(views.iter())?, &job.sub_job(0.95, 1.0))?;
        Ok(gusset_result(OperationResult::Join(JoinResult::new(done)?)))
    })
}

/// Lends the report.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_result_get_join(
    result: *const gusset_result,
    report: *mut gusset_join_report,
) -> gusset_status {
    report!(result, report, "gusset_join", OperationResult::Join(join) => join.join_report())
}

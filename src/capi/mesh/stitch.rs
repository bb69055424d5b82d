//! Stitching: Joins two loops by a strip.
//!
//! @source Nesterenko, algorithm 2 and the intermediate mesh; best strips after H. Fuchs, Z. Kedem
//!     and S. Uselton (1977).

use crate::attributes::KeepSplitVertices;
use crate::capi::context::{create_handle, gusset_context};
use crate::capi::glue::versioned;
use crate::capi::input::{self, Choice, lend_list};
use crate::capi::mesh::result::{OperationResult, gusset_result, report};
use crate::capi::mesh::stitch_options::{gusset_finish, gusset_stitch_options};
use crate::capi::mesh::{self, GivenMesh, gusset_indices, gusset_mesh_view};
use crate::capi::status::gusset_status;
use crate::stitch::{Request, stitch};
use gusset_base::alloc;

/// Parts of a stitch, by index in the result. Entry 0 is the first mesh's, 1 the second's.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_stitch_report {
    /// sizeof(gusset_stitch_report).
    pub struct_size: usize,
    /// Index of each old vertex. Entry 1 is empty without a second mesh.
    pub vertex_map: [gusset_indices; 2],
    /// Index of each old face.
    pub face_map: [gusset_indices; 2],
    /// Vertices of each rim from the first meridian on. Before turning components outwards, the
    /// surface is left of rim 0 and right of rim 1.
    pub rim: [gusset_indices; 2],
    /// Pairs (i, j) of rim indices, the matrix H. Whole rims of N and M vertices: from (0, 0) to
    /// (N, M), where index N is 0 again. Arcs: to (N - 1, M - 1). A step advances i or j by 1; with
    /// GUSSET_MERIDIANS_INDEX and GUSSET_MERIDIANS_QUAD, and between common points, also both.
    /// @shape * 2
    pub meridians: gusset_indices,
    /// The matrix P: vertices row by row from rim 0 to rim 1, a column for each meridian.
    /// @shape row_count+2 *
    pub matrix: gusset_indices,
    /// Three rim vertices for each new vertex. In a row: the meridian's ends, rim 1's twice. In a
    /// blend: the corners of the strip triangle around the unfaired vertex.
    /// @shape * 3
    pub parents: gusset_indices,
    /// Weights of the parents, at least 0, sum 1. In row k of r: 1 - k / (r + 1), k / (r + 1), 0.
    /// @shape parents 3
    pub weights: *const f64,
    /// First face of the strip.
    pub strip_face_first: usize,
    /// N + M triangles for whole rims without rows and common points, except in a blend.
    pub strip_face_count: usize,
    /// Interior rows, two less than in the matrix; 0 for a blend.
    pub row_count: u32,
    /// 1 for a closed band, 0 between arcs.
    /// @flag
    pub closed: u32,
    /// 1 if rim 1's component was reversed.
    /// @flag
    pub turned: u32,
    /// 1 if searched for.
    /// @flag
    pub intersections_known: u32,
    /// Pairs of intersecting faces: first a strip face, the larger one if both are. Any contact
    /// counts, by an exact test, except at shared or coincident vertices and edges. Faces are split
    /// as by gusset_triangulate. A self-intersecting polygon is paired with itself.
    /// @shape * 2
    pub intersections: gusset_indices,
    /// Times that faired rows, or the kept blend, moved back.
    pub back_off_count: u32,
    /// Surface between the rims, or in a hole.
    pub finish: gusset_finish,
    /// Faces that GUSSET_OUTWARD_CLOSED reversed, ascending.
    pub turned_outwards: gusset_indices,
}

versioned! { gusset_stitch_report: 192 }

/// Joins two boundary loops, of two meshes or of one, by a strip: a closed band between whole
/// loops, or open between facing arcs.
///
/// The result has the vertices of A, B, then new ones, in A's scalar type; the faces of A, B, then
/// the strip. An arc of one vertex gets a fan, which touches its piece there only; two get one
/// meridian and no face. If vertices of both rims coincide up to rounding, the vertex of rim 0
/// replaces the other, and strips without rows join the rims between these points.
///
/// @param loop_a vertices in order, in either direction, cyclically joined by boundary edges. If
///     both loops are NULL, the two nearest are joined; if one, the nearest to the other.
///     Candidates are closed, manifold, consistently oriented, of at least 3 vertices; two of one
///     mesh share no vertex.
/// @param mesh_b NULL if both loops are of mesh_a.
/// @param loop_b as loop_a, on mesh_b if given.
/// @errors as gusset_mesh_view, OUT_OF_RANGE, PLANES_UNDECIDED, NO_LOOP, LOOP_TOO_SHORT,
///     LOOP_REPEATS_VERTEX, LOOP_EDGE_NOT_FREE, LOOP_NOT_ORIENTED, LOOPS_SHARE_VERTEX,
///     ORIENTATION_CONFLICT, NO_STRIP, MIXED_SCALARS, TOO_LARGE
/// @complexity O(H log d). Meridians O(N M), above 2^21 pairs of vertices and for simple rules O((N
///     + M) log M). Fairing and intersections O(n log n), and a test a pair of overlapping triangle
///     boxes. Blend of n vertices O(n^1.5), nearly linear in narrow gaps. Choice of loops: a box
///     test a pair. GUSSET_SEARCH_EXACT adds 1 byte for each of up to 2^26 pairs, and 8 M bytes per
///     2^26 pairs begun. GUSSET_MERIDIANS_CONTINUATION and _SMOOTH take 2 bytes a pair, 8 if the
///     best strip would repeat an edge; several threads and two starts double that.
/// @source Nesterenko, algorithm 2 and the intermediate mesh (H, P).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_stitch(
    context: *const gusset_context,
    mesh_a: *const gusset_mesh_view,
    loop_a: *const gusset_indices,
    mesh_b: *const gusset_mesh_view,
    loop_b: *const gusset_indices,
    options: *const gusset_stitch_options,
    result: *mut *mut gusset_result,
) -> gusset_status {
    create_handle(context, result, "result", |job| {
        let options = input::read_versioned_struct(options, true, "options")?.checked()?;
        let given_a = mesh::read_named_mesh(mesh_a, "mesh_a", 0, &job.sub_job(0.0, 0.1))?;
        let read_b = || mesh::read_named_mesh(mesh_b, "mesh_b", 1, &job.sub_job(0.1, 0.2));
        let given_b = (!mesh_b.is_null()).then(read_b).transpose()?;
        let (a, b) = (given_a.mesh_view(), given_b.as_ref().map(GivenMesh::mesh_view));
        let loop_a = mesh::read_indices(loop_a, "loop_a")?.map(|vertices| mesh::map_to_merged_vertices(&a, vertices));
        let loop_b = mesh::read_indices(loop_b, "loop_b").map_err(|failure| failure.with_input(1))?;
        let loop_b = loop_b.map(|vertices| mesh::map_to_merged_vertices(b.as_ref().unwrap_or(&a), vertices));
        let request = Request { a: &a, loop_a: loop_a.as_deref(), b: b.as_ref(), loop_b: loop_b.as_deref() };
        let mut done = self::stitch(&request, &options, &job.sub_job(0.2, 0.95))?;
        let inputs = [Some(&a), b.as_ref()];
        done.keep_split_vertices(&alloc::gather(inputs.into_iter().flatten())?, &job.sub_job(0.95, 1.0))?;
        Ok(gusset_result(OperationResult::Stitch(done)))
    })
}

/// Lends the strip alone: vertices of rim 0, rim 1, new ones, and the new faces.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_result_get_strip_mesh(
    result: *const gusset_result,
    view: *mut gusset_mesh_view,
) -> gusset_status {
    report!(result, view, "gusset_stitch", OperationResult::Stitch(done) => mesh::lend_mesh(&done.strip))
}

/// Lends the report.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_result_get_stitch(
    result: *const gusset_result,
    report: *mut gusset_stitch_report,
) -> gusset_status {
    report!(result, report, "gusset_stitch", OperationResult::Stitch(done) => gusset_stitch_report {
        struct_size: size_of::<gusset_stitch_report>(),
        vertex_map: done.maps.each_ref().map(|map| gusset_indices::lend_indices(&map.vertices)),
        face_map: done.maps.each_ref().map(|map| gusset_indices::lend_indices(&map.faces)),
        rim: done.rims.each_ref().map(|rim| gusset_indices::lend_indices(rim)),
        meridians: gusset_indices::lend_indices(done.meridians.as_flattened()),
        matrix: gusset_indices::lend_indices(&done.matrix),
        parents: gusset_indices::lend_indices(done.parents.as_flattened()),
        weights: lend_list(done.weights.as_flattened()),
        strip_face_first: done.strip_faces.start as usize,
        strip_face_count: done.strip_faces.len(),
        row_count: done.rows,
        closed: done.closed.into(),
        turned: done.turned.into(),
        intersections_known: done.intersections.is_some().into(),
        intersections: gusset_indices::lend_indices(done.intersections.as_deref().unwrap_or_default().as_flattened()),
        back_off_count: done.back_offs,
        finish: done.finish.number(),
        turned_outwards: gusset_indices::lend_indices(&done.turned_outwards),
    })
}

//! Stitching: Joins two loops by a strip of new faces.
//!
//! @source Nesterenko, algorithm 2 and the intermediate mesh; best strips after H. Fuchs, Z.
//!     Kedem and S. Uselton (1977).

use crate::attributes::KeepSplits;
use crate::capi::context::{create, gusset_context};
use crate::capi::glue::versioned;
use crate::capi::input::{self, Choice, lent};
use crate::capi::mesh::result::{Made, gusset_result, report};
use crate::capi::mesh::stitch_options::{gusset_finish, gusset_stitch_options};
use crate::capi::mesh::{self, GivenMesh, gusset_indices, gusset_mesh_view};
use crate::capi::status::gusset_status;
use crate::stitch::{Request, stitch};
use gusset_base::alloc;

/// The parts of a stitch. Pointers are valid until the result is destroyed. Index 0 is the first mesh, 1
/// the second.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_stitch_report {
    /// sizeof(gusset_stitch_report), set by the caller.
    pub struct_size: usize,
    /// Per old vertex of each mesh, its index in the result; empty for the second if there was only
    /// one mesh.
    pub vertex_map: [gusset_indices; 2],
    /// Per old face, its index in the result.
    pub face_map: [gusset_indices; 2],
    /// The vertices of each rim, by their indices in the result, from the first meridian on, side
    /// by side: rim 0 has its surface on the left, rim 1 on the right, as they were before closed
    /// components were turned outwards. They are also the strip's own first vertices in order: rim
    /// 0, then rim 1.
    pub rim: [gusset_indices; 2],
    /// The meridians as places on the rims, i and j by turns, the paper's matrix H: meridian k is
    /// (data[2 k], data[2 k + 1]). They go from (0, 0) to (N, M) for whole rims of N and M
    /// vertices, where place N is place 0 again, and to (N - 1, M - 1) for arcs; count is twice the
    /// number of meridians. From one to the next i advances by 1, or j, or both: by the rule
    /// by index and with GUSSET_MERIDIANS_QUAD.
    pub meridians: gusset_indices,
    /// The paper's matrix P, row by row from rim 0 to rim 1, one column for each meridian: vertices
    /// of the result.
    pub matrix: gusset_indices,
    /// Of each new vertex (they are the last ones of the result), three vertices of the rims that it
    /// lies between: in a row the ends of its meridian, that on rim 1 twice; of a blend the corners
    /// of the triangle of the strip that it would be on without fairing.
    pub parents: gusset_indices,
    /// How much it has of each of them, three numbers a vertex, at least 0 with sum 1; in row k of r
    /// rows 1 - k / (r + 1), k / (r + 1) and 0. NULL without new vertices.
    pub weights: *const f64,
    /// The first of the strip's faces in the result; they are the last ones.
    pub strip_face_first: usize,
    /// How many there are; N + M triangles for whole rims without interior rows. A blend has as
    /// many as it needs, and meridians and matrix are those of the strip that it follows.
    pub strip_face_count: usize,
    /// Interior rows; the matrix has two rows more. 0 of a blend.
    pub row_count: u32,
    /// 1 if the strip is a closed band between whole loops, 0 if it joins arcs.
    pub closed: u32,
    /// 1 if the component that rim 1 is on was turned over to agree with the other, else 0: its
    /// faces run the other way, each from its own first corner. Other components stay as they are.
    pub turned: u32,
    /// 1 if faces that cut each other were looked for, else 0.
    pub intersections_known: u32,
    /// Pairs of faces of the result that cut each other, by turns: first one of the strip, the
    /// larger one if both are. What they share, a vertex or an edge, is no cut, nor are vertices and
    /// edges at the same place; any other touch is. Exact. Polygons are taken as triangles: quads split by their shorter diagonals, others
    /// as fans from their first corners; a polygon that cuts itself is paired with itself.
    pub intersections: gusset_indices,
    /// How often the fairing, of rows or of the blend that was kept, had to be taken back in
    /// places.
    pub back_off_count: u32,
    /// What the strip is. A blend that was asked for may have had to give way to the strip.
    pub finish: gusset_finish,
    /// Faces of the result, those of the strip too, that GUSSET_OUTWARD_CLOSED turned over in the
    /// end, ascending. Each keeps its first corner and has the others in reverse order.
    pub turned_outwards: gusset_indices,
}

versioned! { gusset_stitch_report: 192 }

/// Joins two boundary loops, of two meshes or of one, by a strip of new faces: a closed band
/// between whole loops, or a strip between the arcs that face each other.
///
/// The result has the vertices of A, then of B, then new ones in the interior rows; the faces of A,
/// then of B, then the strip. Positions are of the scalar type of A, old ones keep their bits, and
/// every old face is kept. An arc of one vertex gets a fan, which touches its piece at that vertex
/// only; two arcs of one vertex each get one meridian and no face.
///
/// @param loop_a the vertices of each loop in order, in either direction, each consecutive pair
///     (and the last with the first) an edge with exactly one face. If both are NULL, the loops
///     that lie nearest to each other are taken; if one is, the loop of its mesh that is nearest to
///     the one given. Those to choose from are not open, have three vertices or more, and the faces
///     along them agree in orientation and are manifold there; two of one mesh share no vertex.
/// @param mesh_b NULL if both loops are of mesh_a.
/// @param loop_b see loop_a.
/// @errors as gusset_mesh_view, OUT_OF_RANGE, PLANES_UNDECIDED, NO_LOOP (of one mesh: it has no two
///     that share no vertex), LOOP_TOO_SHORT, LOOP_REPEATS_VERTEX, LOOP_EDGE_NOT_FREE,
///     LOOP_NOT_ORIENTED, LOOPS_SHARE_VERTEX, ORIENTATION_CONFLICT, NO_STRIP, MIXED_SCALARS (A has
///     f32 and B f64 positions), TOO_LARGE
/// @complexity O(H log d) for H half-edges and at most d edges at a vertex; plus for the meridians
///     O(N M) up to 2^21 pairs of vertices, beyond that and for the simple rules O((N + M) log M);
///     plus the size of the strip, and fairing and intersection tests where asked for (O(n log n)
///     and a test for each pair of triangles whose boxes overlap, which is all pairs in the worst
///     case); plus, for a blend of n new vertices, O(n log n) and the solution of up to five
///     plates, O(n^1.5) each, nearly linear where the gap is narrow; plus a box test for each pair
///     of loops where the choice is left open. Extra memory is linear in the meshes and the strip;
///     GUSSET_SEARCH_EXACT takes one byte for each of up to 2^26 pairs of vertices and 8 M bytes
///     for each 2^26 pairs begun, with GUSSET_MERIDIANS_CONTINUATION or _SMOOTH 2 bytes for each
///     pair, where the best strip would use an edge twice 8; twice that with more than one thread
///     and two starts.
/// @source Nesterenko, algorithm 2 and the intermediate mesh (H, P). Whole loops repeat their
///     start: N + 1 and M + 1 points.
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
    create(context, result, "result", |job| {
        let options = input::read(options, true, "options")?.checked()?;
        let given_a = mesh::mesh(mesh_a, 0, &job.part(0.0, 0.1))?;
        let given_b = (!mesh_b.is_null()).then(|| mesh::mesh(mesh_b, 1, &job.part(0.1, 0.2))).transpose()?;
        let (a, b) = (given_a.view(), given_b.as_ref().map(GivenMesh::view));
        let loop_a = mesh::indices(loop_a, "loop_a")?.map(|vertices| mesh::merged(&a, vertices));
        let loop_b = mesh::indices(loop_b, "loop_b").map_err(|failure| failure.of_input(1))?;
        let loop_b = loop_b.map(|vertices| mesh::merged(b.as_ref().unwrap_or(&a), vertices));
        let request = Request { a: &a, loop_a: loop_a.as_deref(), b: b.as_ref(), loop_b: loop_b.as_deref() };
        let mut done = self::stitch(&request, &options, &job.part(0.2, 0.95))?;
        let inputs = [Some(&a), b.as_ref()];
        done.keep_splits(&alloc::gather(inputs.into_iter().flatten())?, &job.part(0.95, 1.0))?;
        Ok(gusset_result(Made::Stitch(done)))
    })
}

/// Lends the strip of a stitch alone: the vertices of the two rims, the new ones, and the faces between them.
///
/// @errors as gusset_result_get_stitch
/// @complexity O(1).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_result_get_strip_mesh(
    result: *const gusset_result,
    view: *mut gusset_mesh_view,
) -> gusset_status {
    report!(result, view, "gusset_stitch", Made::Stitch(done) => mesh::lend(&done.strip))
}

/// Lends the maps, rims and meridians, for results of gusset_stitch.
///
/// @errors as gusset_result_get_mesh, WRONG_HANDLE (the result was made by another operation)
/// @complexity O(1).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_result_get_stitch(
    result: *const gusset_result,
    report: *mut gusset_stitch_report,
) -> gusset_status {
    report!(result, report, "gusset_stitch", Made::Stitch(done) => gusset_stitch_report {
        struct_size: size_of::<gusset_stitch_report>(),
        vertex_map: done.maps.each_ref().map(|map| gusset_indices::lend(&map.vertices)),
        face_map: done.maps.each_ref().map(|map| gusset_indices::lend(&map.faces)),
        rim: done.rims.each_ref().map(|rim| gusset_indices::lend(rim)),
        meridians: gusset_indices::lend(done.meridians.as_flattened()),
        matrix: gusset_indices::lend(&done.matrix),
        parents: gusset_indices::lend(done.parents.as_flattened()),
        weights: lent(done.weights.as_flattened()),
        strip_face_first: done.strip_faces.start as usize,
        strip_face_count: done.strip_faces.len(),
        row_count: done.rows,
        closed: done.closed.into(),
        turned: done.turned.into(),
        intersections_known: done.intersections.is_some().into(),
        intersections: gusset_indices::lend(done.intersections.as_deref().unwrap_or_default().as_flattened()),
        back_off_count: done.back_offs,
        finish: done.finish.number(),
        turned_outwards: gusset_indices::lend(&done.turned_outwards),
    })
}

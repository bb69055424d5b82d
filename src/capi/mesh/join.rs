//! Joining: Joins many open pieces to one mesh.
//!
//! @source Nesterenko for a single gap; the rest is our own.

use crate::assemble::assemble;
use crate::attributes::KeepSplits;
use crate::capi::context::{create, gusset_context};
use crate::capi::input;
use crate::capi::mesh::join_options::{gusset_join_options, pairs};
use crate::capi::mesh::join_report::{Join, gusset_join_report};
use crate::capi::mesh::result::{Made, gusset_result, report};
use crate::capi::mesh::{self, GivenMesh, gusset_mesh_view};
use crate::capi::status::gusset_status;
use gusset_base::alloc;

/// Joins open pieces into one mesh: coincident borders are sewn, components oriented alike,
/// loops that face each other across a gap stitched, holes filled, and closed components turned
/// outwards, as the options say.
///
/// That two loops cannot be joined is no failure: each joint has its outcome.
///
/// Loops of different components face each other as wholes if nearly all vertices of each (9/10)
/// are nearest to the other loop, and from similar distances (the ninth decile is at most four
/// times the first, or the spacing of the vertices) or so that the nearest vertices go round the
/// other loop once; else runs of neighbouring vertices that are nearest to each other face each
/// other, and are joined by open strips. What faces nothing is left alone. Pieces that overlap are
/// not cut unless overlaps says so: where two lie on each other, their borders face each other and
/// enclose what is between.
/// Vertices of the result: those of the pieces in order, then those of the strips, then those of
/// the patches; faces in the same way. Positions are of the scalar type of the first piece, and old
/// ones keep their bits.
///
/// @param pieces piece_count mesh views one after another, each as large as the first one's
///     struct_size says, at least one; each may have several components.
/// @param piece_count see pieces.
/// @errors as gusset_mesh_view (the report's input is the piece), EMPTY_MESH (without pieces),
///     MIXED_SCALARS (a piece has f64 positions and the first one f32), OUT_OF_RANGE (a tolerance,
///     max_gap, or one of pairs or of excluded: the report's index is its number, its input is 0 or
///     1 for the first or the second loop, its value the piece that does not exist, else the
///     vertex, and the message says what is wrong: there is no such piece, or no such vertex of it;
///     of pairs also: no vertex is named, no loop that can be joined passes it or several do, it is
///     on the pair's other loop, or its loop is in a pair before), TOO_LARGE
/// @complexity O(H log d) for H half-edges and at most d edges at a vertex, O(V log V) for V
///     vertices on loops, the time of each strip as for gusset_stitch, and of each hole as for
///     gusset_fill; a pass over all faces for each strip that is faired or tested for
///     intersections. Extra memory is linear in the pieces and the result.
/// @source Nesterenko for a single gap; the rest is our own.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_join(
    context: *const gusset_context,
    pieces: *const gusset_mesh_view,
    piece_count: usize,
    options: *const gusset_join_options,
    result: *mut *mut gusset_result,
) -> gusset_status {
    create(context, result, "result", |job| {
        let options = input::read(options, true, "options")?;
        let trim = input::nested(options.trim_options, "trim_options", Ok)?;
        let viewpoints = trim.viewpoints().map_err(|failure| failure.of_field("trim_options"))?;
        let mut given = pairs(options.pairs, options.pair_count, "pairs")?;
        let mut excluded = pairs(options.excluded, options.excluded_count, "excluded")?;
        let given_meshes = mesh::meshes(pieces, piece_count, &job.part(0.0, 0.1))?;
        let views = alloc::collect(given_meshes.iter().map(GivenMesh::view))?;
        for selector in given.iter_mut().chain(&mut excluded).flatten() {
            if let Some(view) = views.get(selector.piece as usize) {
                selector.vertex = view.faces().merge_of(selector.vertex);
            }
        }
        let options = options.checked([&given, &excluded], trim, &viewpoints)?;
        let mut done = assemble(&views, &options, &job.part(0.1, 0.95))?;
        done.keep_splits(&alloc::gather(views.iter())?, &job.part(0.95, 1.0))?;
        Ok(gusset_result(Made::Join(Join::new(done)?)))
    })
}

/// Lends the report on pieces, joints, loops and holes, for results of gusset_join.
///
/// @errors as gusset_result_get_mesh, WRONG_HANDLE (the result was made by another operation)
/// @complexity O(1).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_result_get_join(
    result: *const gusset_result,
    report: *mut gusset_join_report,
) -> gusset_status {
    report!(result, report, "gusset_join", Made::Join(join) => join.report())
}

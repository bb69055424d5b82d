//! Welding: Merges coincident vertices.

use crate::attributes::KeepSplits;
use crate::capi::context::{create, gusset_context};
use crate::capi::glue::{c_enum, versioned};
use crate::capi::input::{self, choice, flag};
use crate::capi::mesh::result::{Made, gusset_result, report};
use crate::capi::mesh::stitch_options::{gusset_tolerance_mode, tolerance};
use crate::capi::mesh::{self, gusset_indices, gusset_mesh_view};
use crate::capi::status::{Failure, gusset_status};
use crate::repair::weld::{Options, Vertices, weld};

/// The vertices that are welded.
pub type gusset_weld_vertices = u32;
/// The ends of free edges are welded: borders that lie on one another are sewn, edge to edge.
pub const GUSSET_WELD_BOUNDARY: gusset_weld_vertices = 0;
/// All vertices that faces use are welded, as triangle soups need it.
pub const GUSSET_WELD_ALL: gusset_weld_vertices = 1;

/// Whether corners of one face may become one.
pub type gusset_collapse = u32;
/// Corners of one face stay apart.
pub const GUSSET_COLLAPSE_NEVER: gusset_collapse = 0;
/// Corners of one face may become one; a face that keeps fewer than three different vertices is
/// dropped.
pub const GUSSET_COLLAPSE_ALLOW: gusset_collapse = 1;

/// The treatment of vertices that no face uses.
pub type gusset_unused = u32;
/// Vertices that no face uses stay.
pub const GUSSET_UNUSED_KEEP: gusset_unused = 0;
/// Vertices that no face of the result uses are left out.
pub const GUSSET_UNUSED_REMOVE: gusset_unused = 1;

/// How to weld; all zero is the default.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_weld_options {
    /// sizeof(gusset_weld_options), set by the caller.
    pub struct_size: usize,
    /// Which vertices.
    pub vertices: gusset_weld_vertices,
    /// GUSSET_TOLERANCE_AUTO: vertices lie together if they are no farther apart than rounding can
    /// have put copies of one vertex: 2^-19 of the largest coordinate for 32-bit positions, 2^-48
    /// for 64-bit ones, or twice the last decimal place that positions show, as those from text
    /// files do, if that is more. Let D be the largest power of ten that does not exceed the
    /// longest side of the box round the vertices in question. The last place is the largest of
    /// 1e-5 D, 1e-6 D, ... of which at least a third of the coordinates (those of the largest order
    /// of magnitude), or of their differences from one vertex to the next, are multiples. Multiples
    /// of 1e-4 D do not count, as a coarse grid is no sign of rounding; of the rest there must be
    /// eight. At each vertex it is at most a quarter of the shortest edge that ends there, so that
    /// no edge collapses. See tolerance of the result's view for what it was.
    /// GUSSET_TOLERANCE_GIVEN: if they are not farther apart than the tolerance.
    /// GUSSET_TOLERANCE_EXACT: if their positions are equal, where -0 equals 0.
    pub tolerance_mode: gusset_tolerance_mode,
    /// In the unit of the positions, finite, at least 0; read for GUSSET_TOLERANCE_GIVEN.
    /// @when tolerance_mode GUSSET_TOLERANCE_GIVEN
    pub tolerance: f64,
    /// Whether corners of one face may become one.
    pub collapse: gusset_collapse,
    /// The treatment of vertices that no face uses.
    pub unused: gusset_unused,
}

/// What became of the old mesh. Indices are the old mesh's; lists are ascending; pointers are valid
/// until the result is destroyed.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_weld_report {
    /// sizeof(gusset_weld_report), set by the caller.
    pub struct_size: usize,
    /// Per old vertex, its index in the result; UINT32_MAX if it was left out as unused.
    pub vertex_map: gusset_indices,
    /// Per old face, its index in the result; UINT32_MAX if it was dropped.
    pub face_map: gusset_indices,
    /// Half-edges of free edges that lie on another edge and did not become one edge of two faces
    /// with it: three or more lie together there, or sewing would have collapsed a face or made an
    /// edge of three or more faces.
    pub left_edges: gusset_indices,
    /// Vertices that lie together with another and are not one with it.
    pub left_vertices: gusset_indices,
    /// Vertices that became one with a smaller one.
    pub welded_vertices: u32,
    /// Edges of two faces that were two free edges.
    pub sewn_edges: u32,
    /// Faces that were dropped.
    pub dropped_faces: u32,
    /// 0.
    pub reserved: u32,
    /// How far apart vertices that lie together were allowed to be, short edges apart; 0 for equal
    /// positions.
    pub tolerance: f64,
}

versioned! { gusset_weld_options: 32, gusset_weld_report: 96 }

c_enum! { vertices: Vertices { GUSSET_WELD_BOUNDARY => Boundary, GUSSET_WELD_ALL => All } }

impl gusset_weld_options {
    pub(crate) fn checked(self) -> Result<Options, Failure> {
        Ok(Options {
            vertices: choice(self.vertices)?,
            tolerance: tolerance(self.tolerance_mode, self.tolerance)?,
            collapse: flag(self.collapse, "collapse")?,
            remove_unused: flag(self.unused, "unused")?,
        })
    }
}

/// Makes one vertex of vertices that lie together.
///
/// By default borders are sewn: where exactly two free edges lie on one another, whatever their
/// directions, they become one edge, and so do their ends. Where three or more lie together none is
/// preferred, and a pair is left where sewing it would collapse a face or make an edge of three or
/// more faces: a manifold stays one. What is left is listed. Vertices that lie together without an
/// edge to sew stay apart, as where two holes touch. With GUSSET_WELD_ALL, vertices that lie
/// together become one whatever comes of the edges.
///
/// Which lie together within a tolerance: in ascending order, each vertex that is still unclaimed
/// claims the unclaimed ones within the tolerance of it, nearest first, so that nothing chains.
///
/// The result has the old faces in their order, each from its own first corner. Of vertices made
/// one the smallest is left, and its position keeps its bits; the vertices left are in their old
/// order. If every face is dropped, the result has none and is no valid input.
///
/// @errors as gusset_mesh_view, OUT_OF_RANGE (the tolerance)
/// @complexity O(H log H) for H half-edges, if no vertex has very many and few corners of one face
///     lie together; linear extra memory.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_weld(
    context: *const gusset_context,
    mesh: *const gusset_mesh_view,
    options: *const gusset_weld_options,
    result: *mut *mut gusset_result,
) -> gusset_status {
    create(context, result, "result", |job| {
        let options = input::read(options, true, "options")?.checked()?;
        let given_mesh = mesh::mesh(mesh, 0, &job.part(0.0, 0.1))?;
        let mesh = given_mesh.view();
        let mut done = self::weld(&mesh, &options, &job.part(0.1, 0.9))?;
        done.keep_splits(&[&mesh], &job.part(0.9, 1.0))?;
        Ok(gusset_result(Made::Weld(done)))
    })
}

/// Lends the maps, lists and counts, for results of gusset_weld.
///
/// @errors as gusset_result_get_mesh, WRONG_HANDLE (the result was made by another operation)
/// @complexity O(1).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_result_get_weld(
    result: *const gusset_result,
    report: *mut gusset_weld_report,
) -> gusset_status {
    report!(result, report, "gusset_weld", Made::Weld(done) => gusset_weld_report {
        struct_size: size_of::<gusset_weld_report>(),
        vertex_map: gusset_indices::lend(&done.vertex_map),
        face_map: gusset_indices::lend(&done.face_map),
        left_edges: gusset_indices::lend(&done.left_edges),
        left_vertices: gusset_indices::lend(&done.left_vertices),
        welded_vertices: done.welded_vertices,
        sewn_edges: done.sewn_edges,
        dropped_faces: done.dropped_faces,
        reserved: 0,
        tolerance: done.tolerance,
    })
}

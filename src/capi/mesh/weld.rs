//! Welding: Merges coincident vertices.

use crate::attributes::KeepSplitVertices;
use crate::capi::context::{create_handle, gusset_context};
use crate::capi::glue::{c_enum, versioned};
use crate::capi::input::{self, read_choice, read_flag};
use crate::capi::mesh::result::{OperationResult, gusset_result, report};
use crate::capi::mesh::stitch_options::{gusset_tolerance_mode, to_tolerance};
use crate::capi::mesh::{self, gusset_indices, gusset_mesh_view};
use crate::capi::status::{Failure, gusset_status};
use crate::repair::weld::{Options, Vertices, weld};

/// Vertices that are welded.
pub type gusset_weld_vertices = u32;
/// Ends of boundary edges: sews coincident borders edge to edge.
pub const GUSSET_WELD_BOUNDARY: gusset_weld_vertices = 0;
/// All used vertices, for triangle soups.
pub const GUSSET_WELD_ALL: gusset_weld_vertices = 1;

/// Treatment of coincident corners of one face.
pub type gusset_collapse = u32;
/// Corners of one face stay apart.
pub const GUSSET_COLLAPSE_NEVER: gusset_collapse = 0;
/// Corners of one face may be merged. Faces left with fewer than three vertices are dropped.
pub const GUSSET_COLLAPSE_ALLOW: gusset_collapse = 1;

/// Treatment of vertices that no face uses.
pub type gusset_unused = u32;
/// Unused vertices stay.
pub const GUSSET_UNUSED_KEEP: gusset_unused = 0;
/// Vertices that no face of the result uses are removed.
pub const GUSSET_UNUSED_REMOVE: gusset_unused = 1;

/// Options of gusset_weld and gusset_sew.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_weld_options {
    /// sizeof(gusset_weld_options).
    pub struct_size: usize,
    /// Vertices that are welded.
    pub vertices: gusset_weld_vertices,
    /// Distance at which vertices coincide.
    /// - GUSSET_TOLERANCE_EXACT: 0; -0 equals 0.
    /// - GUSSET_TOLERANCE_AUTO: at most 2^-19 (32-bit) or 2^-48 (64-bit) of the largest coordinate,
    ///   or, if more, twice the last decimal place that positions show. At each vertex at most a
    ///   quarter of the shortest edge; GUSSET_COLLAPSE_ALLOW skips edges within the first limit.
    /// - Last decimal place: let D be the largest power of ten up to the longest side of the
    ///   vertices' box. The place is the largest of 1e-5 D, 1e-6 D, ... that divides a third of at
    ///   least eight numbers. They are coordinates of the largest order of magnitude, or
    ///   differences of consecutive vertices, except multiples of 1e-4 D.
    pub tolerance_mode: gusset_tolerance_mode,
    /// Largest distance of coincident vertices.
    /// @when tolerance_mode GUSSET_TOLERANCE_GIVEN
    pub tolerance: f64,
    /// Treatment of coincident corners of one face.
    pub collapse: gusset_collapse,
    /// Treatment of vertices that no face uses.
    pub unused: gusset_unused,
}

/// Effects of welding. Indices are of the old mesh, and lists ascending.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_weld_report {
    /// sizeof(gusset_weld_report).
    pub struct_size: usize,
    /// Index of each vertex in the result; UINT32_MAX if removed.
    pub vertex_map: gusset_indices,
    /// Index of each face in the result; UINT32_MAX if dropped.
    pub face_map: gusset_indices,
    /// Half-edges of boundary edges that coincide with another edge but stay apart.
    pub left_edges: gusset_indices,
    /// Vertices that coincide with another but are not merged.
    pub left_vertices: gusset_indices,
    /// Vertices merged into a smaller one.
    pub welded_vertices: u32,
    /// Edges made from two boundary edges.
    pub sewn_edges: u32,
    /// Dropped faces.
    pub dropped_faces: u32,
    /// Pairs of boundary edges that coincide only within near_tolerance, not sewn.
    pub near_edge_pairs: u32,
    /// Largest distance at which vertices coincide, except at short edges; 0 for equal positions.
    pub tolerance: f64,
    /// Tolerance that sews near_edge_pairs, at most a tenth of the edges there; 0 without any.
    pub near_tolerance: f64,
}

versioned! { gusset_weld_options: 32, gusset_weld_report: 104 }

c_enum! { vertices: Vertices { GUSSET_WELD_BOUNDARY => Boundary, GUSSET_WELD_ALL => All } }

impl gusset_weld_options {
    pub(crate) fn checked(self) -> Result<Options, Failure> {
        Ok(Options {
            vertices: read_choice(self.vertices)?,
            tolerance: to_tolerance(self.tolerance_mode, self.tolerance)?,
            collapse: read_flag(self.collapse, "collapse")?,
            remove_unused: read_flag(self.unused, "unused")?,
        })
    }
}

/// Merges coincident vertices.
/// - By default, borders are sewn: exactly two coincident boundary edges, in either direction,
///   become one.
/// - Edges stay apart, and are listed, where three or more coincide, or sewing would collapse a
///   face or make a non-manifold edge.
/// - Coincident vertices without an edge to sew stay apart. GUSSET_WELD_ALL merges all coincident
///   vertices.
/// - In ascending order, each unclaimed vertex claims the unclaimed vertices within the tolerance,
///   nearest first, without chains.
/// - The result has the old faces, each from its first corner, and in order the other vertices and
///   the smallest of merged ones. A result without faces is not a valid input.
///
/// @errors as gusset_mesh_view, OUT_OF_RANGE (tolerance)
/// @complexity O(H log H), if valences are small and few corners of one face coincide.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_weld(
    context: *const gusset_context,
    mesh: *const gusset_mesh_view,
    options: *const gusset_weld_options,
    result: *mut *mut gusset_result,
) -> gusset_status {
    create_handle(context, result, "result", |job| {
        let options = input::read_versioned_struct(options, true, "options")?.checked()?;
        let given_mesh = mesh::read_numbered_mesh(mesh, 0, &job.sub_job(0.0, 0.1))?;
        let mesh = given_mesh.mesh_view();
        let mut done = self::weld(&mesh, &options, &job.sub_job(0.1, 0.9))?;
        done.keep_split_vertices(&[&mesh], &job.sub_job(0.9, 1.0))?;
        Ok(gusset_result(OperationResult::Weld(done)))
    })
}

/// Lends the report.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_result_get_weld(
    result: *const gusset_result,
    report: *mut gusset_weld_report,
) -> gusset_status {
    report!(result, report, "gusset_weld", OperationResult::Weld(done) => gusset_weld_report {
        struct_size: size_of::<gusset_weld_report>(),
        vertex_map: gusset_indices::lend_indices(&done.vertex_map),
        face_map: gusset_indices::lend_indices(&done.face_map),
        left_edges: gusset_indices::lend_indices(&done.left_edges),
        left_vertices: gusset_indices::lend_indices(&done.left_vertices),
        welded_vertices: done.welded_vertices,
        sewn_edges: done.sewn_edges,
        dropped_faces: done.dropped_faces,
        near_edge_pairs: done.near.edge_pairs,
        tolerance: done.tolerance,
        near_tolerance: done.near.tolerance,
    })
}

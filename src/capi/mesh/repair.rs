//! Repair: Makes a valid solid of any polygon mesh.
//!
//! @source Q. Zhou, E. Grinspun, D. Zorin, A. Jacobson, Mesh arrangements for solid geometry (2016),
//! for cells; M. Attene, A lightweight approach to repairing digitized polygon meshes (2010).

use crate::capi::context::{create, gusset_context};
use crate::capi::glue::{c_enum, versioned};
use crate::capi::input::{self, Choice, flag, lend_list};
use crate::capi::mesh::fill::gusset_fill_options;
use crate::capi::mesh::result::{OperationResult, gusset_result, report};
use crate::capi::mesh::stitch_options::{gusset_tolerance_mode, to_tolerance};
use crate::capi::mesh::{self, gusset_indices, gusset_mesh_view};
use crate::capi::status::{Failure, gusset_status};
use crate::solid::{DropReason, Options, Repaired, repair};
use gusset_base::alloc;

/// Reason why a face was dropped.
pub type gusset_drop_reason = u32;
/// Fewer than three different vertices remain.
pub const GUSSET_DROP_DEGENERATE: gusset_drop_reason = 0;
/// The area is 0 up to rounding.
pub const GUSSET_DROP_ZERO_AREA: gusset_drop_reason = 1;
/// An earlier face has the same vertices.
pub const GUSSET_DROP_DUPLICATE: gusset_drop_reason = 2;
/// The solid lies on both sides.
pub const GUSSET_DROP_INSIDE: gusset_drop_reason = 3;
/// Part of an open sheet that was attached to a closed component.
pub const GUSSET_DROP_FIN: gusset_drop_reason = 4;

/// Options of gusset_repair. By default every stage runs.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_repair_options {
    /// sizeof(gusset_repair_options).
    pub struct_size: usize,
    /// Distance at which borders coincide, as in gusset_weld_options.
    pub tolerance_mode: gusset_tolerance_mode,
    /// 1: borders are not sewn.
    /// @flag
    pub leave_borders: u32,
    /// Largest distance of coincident borders, finite, at least 0.
    /// @when tolerance_mode GUSSET_TOLERANCE_GIVEN
    pub tolerance: f64,
    /// 1: faces without area stay.
    /// @flag
    pub leave_flat_faces: u32,
    /// 1: duplicate faces stay.
    /// @flag
    pub leave_duplicates: u32,
    /// 1: non-manifold edges and vertices stay, and faces within the solid.
    /// @flag
    pub leave_non_manifold: u32,
    /// 1: holes stay open.
    /// @flag
    pub leave_holes: u32,
    /// 1: open sheets stay that were attached to a closed component.
    /// @flag
    pub leave_fins: u32,
    /// 1: no component is oriented.
    /// @flag
    pub leave_orientation: u32,
    /// Options of filling. Ignores groups, outward and plan_only; the last two must be valid.
    pub fill_options: *const gusset_fill_options,
}

/// Effects of a repair, and the defects that remain.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_repair_report {
    /// sizeof(gusset_repair_report).
    pub struct_size: usize,
    /// 1 if the result bounds a solid: closed, manifold, oriented, without degenerate, duplicate or
    /// intersecting faces, and without faces of area 0.
    /// @flag
    pub valid: u32,
    /// Vertices merged into others.
    pub welded_vertices: u32,
    /// Edges made from boundary edges or their parts.
    pub sewn_edges: u32,
    /// Old faces that were split or gained corners when borders were sewn.
    pub split_faces: u32,
    /// Copies of vertices that separate sheets of faces.
    pub split_vertices: u32,
    /// Holes that were filled.
    pub filled_holes: u32,
    /// Boundary edges of the result.
    pub boundary_edges_left: u32,
    /// Non-manifold edges of the result.
    pub non_manifold_edges_left: u32,
    /// Non-manifold vertices of the result.
    pub non_manifold_vertices_left: u32,
    /// Edges of the result whose two faces disagree in orientation.
    pub orientation_conflicts_left: u32,
    /// Degenerate, duplicate and zero-area faces of the result.
    pub bad_faces_left: u32,
    /// 0.
    pub reserved: u32,
    /// Largest distance at which vertices were merged; 0 without any.
    pub tolerance: f64,
    /// Old face of each face, or of which it is a part; UINT32_MAX for faces of patches, which come
    /// last.
    pub face_origin: gusset_indices,
    /// Smallest old vertex that each vertex is; UINT32_MAX for new vertices, which come last.
    pub vertex_origin: gusset_indices,
    /// For each face, 1 if it was turned over.
    /// @shape face_count
    /// @flag
    pub turned: *const u8,
    /// Number of faces.
    pub face_count: usize,
    /// Dropped old faces, ascending. Faces with a remaining part are not listed.
    pub dropped_faces: gusset_indices,
    /// Reason for each of them.
    /// @shape dropped_count
    pub drop_reasons: *const gusset_drop_reason,
    /// Number of dropped faces.
    pub dropped_count: usize,
    /// Pairs of faces that intersect in the result, ascending, the smaller face first.
    /// @shape * 2
    pub intersecting_pairs: gusset_indices,
}

versioned! { gusset_repair_options: 56, gusset_repair_report: 160 }

c_enum! {
    reason: DropReason {
        GUSSET_DROP_DEGENERATE => Degenerate,
        GUSSET_DROP_ZERO_AREA => ZeroArea,
        GUSSET_DROP_DUPLICATE => Duplicate,
        GUSSET_DROP_INSIDE => Inside,
        GUSSET_DROP_FIN => Fin,
    }
}

/// A repair, and its dropped faces in the form that C takes.
pub(crate) struct RepairResult {
    pub(crate) done: Repaired,
    dropped_faces: Vec<u32>,
    drop_reasons: Vec<u32>,
}

impl gusset_repair_options {
    fn checked(self) -> Result<Options, Failure> {
        Ok(Options {
            tolerance: to_tolerance(self.tolerance_mode, self.tolerance)?,
            leave_borders: flag(self.leave_borders, "leave_borders")?,
            leave_flat_faces: flag(self.leave_flat_faces, "leave_flat_faces")?,
            leave_duplicates: flag(self.leave_duplicates, "leave_duplicates")?,
            leave_non_manifold: flag(self.leave_non_manifold, "leave_non_manifold")?,
            leave_holes: flag(self.leave_holes, "leave_holes")?,
            leave_orientation: flag(self.leave_orientation, "leave_orientation")?,
            leave_fins: flag(self.leave_fins, "leave_fins")?,
            fill: input::read_nested_or_default(self.fill_options, "fill_options", gusset_fill_options::checked)?,
        })
    }
}

/// Makes a valid solid of a mesh, and changes only faces at its defects. Stages, in order:
/// - Borders that coincide are sewn, as by gusset_sew.
/// - Faces without area are dropped; their neighbours meet in their place.
/// - Duplicate faces are dropped, except the first.
/// - Holes are filled, as by gusset_fill.
/// - Where edges have three or more faces, the faces divide space into cells. Faces with the solid
///   on both sides are dropped. The others are separated into sheets with their own vertices.
/// - Holes of separated sheets are filled. Open sheets that were attached to a closed component are
///   dropped.
/// - Components are oriented, and closed ones turned outwards.
///
/// The solid consists of the cells with a winding number other than 0, if crossing faces from front
/// to back adds 1 consistently; otherwise of all bounded cells. Old faces keep their order, and old
/// vertices their bits. Unused vertices are removed. Vertices merged by the mesh's merge map stay
/// merged. Faces that intersect stay, and are listed. A second repair changes nothing.
///
/// @errors as gusset_mesh_view, OPTION_OUT_OF_RANGE, TOO_LARGE (the result)
/// @complexity O(H log H), the time of gusset_fill for each hole, and the search for intersecting
///     faces.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_repair(
    context: *const gusset_context,
    mesh: *const gusset_mesh_view,
    options: *const gusset_repair_options,
    result: *mut *mut gusset_result,
) -> gusset_status {
    create(context, result, "result", |job| {
        let options = input::read_versioned_struct(options, true, "options")?.checked()?;
        let given_mesh = mesh::mesh(mesh, 0, &job.part(0.0, 0.1))?;
        let done = self::repair(&given_mesh.mesh_view(), &options, &job.part(0.1, 1.0))?;
        let dropped_faces = alloc::collect(done.dropped.iter().map(|dropped| dropped.face))?;
        let drop_reasons = alloc::collect(done.dropped.iter().map(|dropped| dropped.reason.number()))?;
        Ok(gusset_result(OperationResult::Repair(RepairResult { done, dropped_faces, drop_reasons })))
    })
}

/// Lends the report of a repair.
///
/// @errors WRONG_HANDLE
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_result_get_repair(
    result: *const gusset_result,
    report: *mut gusset_repair_report,
) -> gusset_status {
    report!(result, report, "gusset_repair", OperationResult::Repair(RepairResult { done, dropped_faces, drop_reasons }) => {
        let after = &done.after;
        let bad_faces = [&after.degenerate_faces, &after.duplicate_faces, &after.zero_area_faces];
        gusset_repair_report {
            struct_size: size_of::<gusset_repair_report>(),
            valid: done.is_valid().into(),
            welded_vertices: done.welded_vertices,
            sewn_edges: done.sewn_edges,
            split_faces: done.split_faces,
            split_vertices: done.split_vertices,
            filled_holes: done.filled_holes,
            boundary_edges_left: after.boundary_edges.len() as u32,
            non_manifold_edges_left: after.non_manifold_edges.len() as u32,
            non_manifold_vertices_left: after.non_manifold_vertices.len() as u32,
            orientation_conflicts_left: after.orientation_conflicts.len() as u32,
            bad_faces_left: bad_faces.iter().map(|faces| faces.len() as u32).sum(),
            reserved: 0,
            tolerance: done.tolerance,
            face_origin: gusset_indices::lend_indices(&done.face_origin),
            vertex_origin: gusset_indices::lend_indices(&done.vertex_origin),
            // A bool is one byte, 0 or 1.
            turned: lend_list(&done.turned).cast(),
            face_count: done.turned.len(),
            dropped_faces: gusset_indices::lend_indices(dropped_faces),
            drop_reasons: lend_list(drop_reasons),
            dropped_count: drop_reasons.len(),
            intersecting_pairs: gusset_indices::lend_indices(done.intersections.as_flattened()),
        }
    })
}

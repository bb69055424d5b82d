//! Repair: Removes the defects of meshes, and unites solids.
//!
//! @source Q. Zhou, E. Grinspun, D. Zorin, A. Jacobson, Mesh arrangements for solid geometry
//!     (2016), for cells; M. Attene, A lightweight approach to repairing digitized polygon meshes
//!     (2010).

use crate::capi::context::{create_handle, gusset_context};
use crate::capi::glue::versioned;
use crate::capi::input::{self, read_flag};
use crate::capi::mesh::fill::gusset_fill_options;
use crate::capi::mesh::repair_report::{RepairResult, gusset_repair_report};
use crate::capi::mesh::result::{OperationResult, gusset_result, report};
use crate::capi::mesh::stitch_options::{gusset_tolerance_mode, to_tolerance};
use crate::capi::mesh::{self, GivenMesh, gusset_mesh_view};
use crate::capi::status::{Failure, gusset_status};
use crate::solid::{Options, repair, unite_solids};
use gusset_base::alloc;

/// Options of gusset_repair. By default every stage runs.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_repair_options {
    /// sizeof(gusset_repair_options).
    pub struct_size: usize,
    /// Source of the tolerance.
    pub tolerance_mode: gusset_tolerance_mode,
    /// 1: borders are not sewn.
    /// @flag
    pub leave_borders: u32,
    /// Largest distance of coincident borders.
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
    /// 1: open sheets that were attached to closed components stay.
    /// @flag
    pub leave_fins: u32,
    /// 1: no component is oriented.
    /// @flag
    pub leave_orientation: u32,
    /// 1: intersecting faces stay.
    /// @flag
    pub leave_intersections: u32,
    /// 0.
    pub reserved: u32,
    /// Ignores groups, and outward and plan_only, which must be valid.
    pub fill_options: *const gusset_fill_options,
}

versioned! { gusset_repair_options: 64 reserved }

impl gusset_repair_options {
    fn checked(self) -> Result<Options, Failure> {
        Ok(Options {
            tolerance: to_tolerance(self.tolerance_mode, self.tolerance)?,
            leave_borders: read_flag(self.leave_borders, "leave_borders")?,
            leave_flat_faces: read_flag(self.leave_flat_faces, "leave_flat_faces")?,
            leave_duplicates: read_flag(self.leave_duplicates, "leave_duplicates")?,
            leave_non_manifold: read_flag(self.leave_non_manifold, "leave_non_manifold")?,
            leave_holes: read_flag(self.leave_holes, "leave_holes")?,
            leave_orientation: read_flag(self.leave_orientation, "leave_orientation")?,
            leave_fins: read_flag(self.leave_fins, "leave_fins")?,
            leave_intersections: read_flag(self.leave_intersections, "leave_intersections")?,
            fill: input::read_nested_or_default(self.fill_options, "fill_options", gusset_fill_options::checked)?,
        })
    }
}

/// Removes the defects of a mesh, to get a valid solid where possible. Changes only faces at
/// defects. Stages, in order:
/// - Coincident borders are sewn, as by gusset_sew. Without a given tolerance, narrow gaps are
///   closed.
/// - Faces without area are dropped; their neighbours meet there.
/// - Duplicate faces are dropped, except the first.
/// - Holes are filled, as by gusset_fill.
/// - Around non-manifold edges, faces divide space into cells. Faces with the solid on both sides
///   are dropped, others separated into sheets with their own vertices.
/// - Holes of sheets are filled. Open sheets that were attached to closed components are dropped.
/// - Components are oriented, and closed ones turned outwards.
/// - Closed components with intersecting faces are united, as by gusset_unite.
///
/// The solid consists of the cells with a winding number other than 0, if crossing faces from front
/// to back adds 1 consistently. Otherwise it consists of all bounded cells. Old faces keep their
/// order. Unused vertices are removed. Vertices merged by the merge map stay merged. Intersecting
/// faces of open components stay, and are listed. Repairing a valid result changes nothing.
///
/// @errors as gusset_weld, OUT_OF_RANGE, TOO_LARGE (the result)
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
    create_handle(context, result, "result", |job| {
        let options = input::read_versioned_struct(options, true, "options")?.checked()?;
        let given_mesh = mesh::read_numbered_mesh(mesh, 0, &job.sub_job(0.0, 0.1))?;
        let done = self::repair(&given_mesh.mesh_view(), &options, &job.sub_job(0.1, 1.0))?;
        Ok(gusset_result(OperationResult::Repair(RepairResult::new(done)?)))
    })
}

/// Unites closed pieces: returns the border of all points with a winding number of at least 1.
/// Pieces may intersect themselves, and intersect, touch, coincide with or lie within others. Walls
/// of cavities look into the cavities. Inverted parts outside vanish. Faces that no other meets
/// stay unchanged. New vertices are rounded to the first piece's scalar type. Border edges of two
/// pieces may close each other.
///
/// gusset_result_get_repair lends the report. It numbers old vertices and faces piece after piece;
/// dropped faces have GUSSET_DROP_OVERLAP. Intersecting pairs remain only where rounding keeps
/// making them.
///
/// @param pieces as for gusset_join.
/// @errors as gusset_mesh_view, EMPTY_MESH (also if nothing remains), MIXED_SCALARS,
///     MESH_NOT_CLOSED (with input and face at an open edge), TOO_LARGE
/// @complexity O((n + k) log n) for n triangles of which k pairs intersect.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_unite(
    context: *const gusset_context,
    pieces: *const gusset_mesh_view,
    piece_count: usize,
    result: *mut *mut gusset_result,
) -> gusset_status {
    create_handle(context, result, "result", |job| {
        let given_meshes = mesh::read_meshes(pieces, piece_count, &job.sub_job(0.0, 0.1))?;
        let views = alloc::collect(given_meshes.iter().map(GivenMesh::mesh_view))?;
        let done = unite_solids(&views, &job.sub_job(0.1, 1.0))?;
        Ok(gusset_result(OperationResult::Repair(RepairResult::new(done)?)))
    })
}

/// Lends the report of a repair or union.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_result_get_repair(
    result: *const gusset_result,
    report: *mut gusset_repair_report,
) -> gusset_status {
    report!(result, report, "gusset_repair", OperationResult::Repair(repair) => repair.lend_report())
}

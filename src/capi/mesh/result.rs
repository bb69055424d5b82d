//! Results: The mesh and the report of an operation.

use crate::attributes::Origins;
use crate::capi::context::{create_handle, gusset_context, lend};
use crate::capi::glue::versioned;
use crate::capi::handle::{self, handle};
use crate::capi::mesh::develop_report::DevelopedSurface;
use crate::capi::mesh::fill_report::FillResult;
use crate::capi::mesh::join_report::JoinResult;
use crate::capi::mesh::origins::gusset_origins;
use crate::capi::mesh::repair_report::RepairResult;
use crate::capi::mesh::{self, gusset_mesh_view};
use crate::capi::status::gusset_status::GUSSET_ERROR_WRONG_HANDLE;
use crate::capi::status::{Failure, gusset_status};
use crate::capi::surface::gusset_surface_place;
use crate::error::Error;
use crate::job::Job;
use crate::mesh::{Mesh, TriangulatedMesh};
use crate::net::convert::NetMesh;
use crate::repair::orient::Oriented;
use crate::repair::sew::Sew;
use crate::repair::weld::Weld;
use crate::stitch::{Quality, Ruled, Stitch};
use crate::surface::SurfaceMesh;

/// Mesh and report of an operation. Getters of other reports return WRONG_HANDLE.
pub struct gusset_result(pub(crate) OperationResult);

handle! { gusset_result }

/// The result of an operation.
#[allow(clippy::large_enum_variant, reason = "each lies in a handle, on the heap")]
pub(crate) enum OperationResult {
    Join(JoinResult),
    Stitch(Stitch),
    Strip(Ruled),
    Fill(FillResult),
    Weld(Weld),
    Sew(Sew),
    Repair(RepairResult),
    /// With a face and a half-edge of each component that cannot be oriented.
    Orient(Oriented, [Vec<u32>; 2]),
    Develop(DevelopedSurface),
    Triangulate(TriangulatedMesh),
    NetMesh(NetMesh),
    /// With the place of each vertex.
    SheetMesh(SurfaceMesh, Vec<gusset_surface_place>),
}

impl OperationResult {
    /// Returns the C function that made the result.
    fn operation_name(&self) -> &'static str {
        match self {
            OperationResult::Join(_) => "gusset_join",
            OperationResult::Stitch(_) => "gusset_stitch",
            OperationResult::Strip(_) => "gusset_strip",
            OperationResult::Fill(_) => "gusset_fill",
            OperationResult::Weld(_) => "gusset_weld",
            OperationResult::Sew(_) => "gusset_sew",
            OperationResult::Repair(_) => "gusset_repair or gusset_unite",
            OperationResult::Orient(..) => "gusset_orient",
            OperationResult::Develop(_) => "gusset_develop",
            OperationResult::Triangulate(_) => "gusset_triangulate",
            OperationResult::NetMesh(_) => "gusset_net_to_mesh",
            OperationResult::SheetMesh(..) => "gusset_sheet_to_mesh",
        }
    }

    /// Returns the failure if the report belongs to another operation.
    pub(crate) fn wrong_operation_failure(&self, operation: &str) -> Failure {
        let message = format!("result was made by {}; pass a result of {operation}", self.operation_name());
        Failure::new(GUSSET_ERROR_WRONG_HANDLE, message)
    }

    fn result_mesh(&self) -> &Mesh {
        match self {
            OperationResult::Join(join) => &join.assembly.mesh,
            OperationResult::Stitch(stitch) => &stitch.mesh,
            OperationResult::Strip(strip) => &strip.mesh,
            OperationResult::Fill(fill) => &fill.filled.mesh,
            OperationResult::Weld(weld) => &weld.mesh,
            OperationResult::Sew(sew) => &sew.mesh,
            OperationResult::Repair(repair) => &repair.repaired.mesh,
            OperationResult::Orient(orient, _) => &orient.mesh,
            OperationResult::Develop(development) => &development.developed.mesh,
            OperationResult::Triangulate(split) => &split.mesh,
            OperationResult::NetMesh(net) => &net.mesh,
            OperationResult::SheetMesh(sheet, _) => &sheet.mesh,
        }
    }

    fn result_origins(&self, job: &Job<'_>) -> Result<Origins, Error> {
        match self {
            OperationResult::Join(join) => Origins::from_assembly(&join.assembly, job),
            OperationResult::Stitch(stitch) => Origins::from_stitch(stitch, job),
            OperationResult::Strip(strip) => Origins::from_ruled(strip, job),
            OperationResult::Fill(fill) => Origins::from_filled(&fill.filled, job),
            OperationResult::Weld(weld) => Origins::from_weld(weld, job),
            OperationResult::Sew(sew) => Origins::from_sew(sew, job),
            OperationResult::Repair(repair) => Origins::from_repaired(&repair.repaired, job),
            OperationResult::Orient(orient, _) => Origins::from_oriented(orient, job),
            OperationResult::Develop(development) => Origins::from_developed(&development.developed, job),
            OperationResult::Triangulate(split) => Origins::from_triangulated(split, job),
            OperationResult::NetMesh(net) => Origins::from_net_mesh(net, job),
            OperationResult::SheetMesh(sheet, _) => Origins::from_surface_mesh(sheet, job),
        }
    }
}

/// `report!(result, report, "gusset_x", OperationResult::X(it) => struct)` fills the caller's struct `report`
/// from a result of `gusset_x`. It rejects the result of another operation.
macro_rules! report {
    ($result:ident, $report:ident, $operation:literal, $made:pat => $body:expr) => {
        $crate::capi::context::lend!($result, $report, |result| {
            let $made = &result.0 else { return Err(result.0.wrong_operation_failure($operation)) };
            $body
        })
    };
}
pub(crate) use report;

/// Quality of new faces and the result.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_quality_report {
    /// sizeof(gusset_quality_report).
    pub struct_size: usize,
    /// Smallest angle of new triangles; 0 if one is degenerate.
    pub min_angle: f64,
    /// Largest aspect ratio of new triangles, longest side / (2 sqrt(3) inradius): 1 if
    /// equilateral, infinite if degenerate.
    pub max_aspect: f64,
    /// Longest edge of new faces.
    pub max_edge: f64,
    /// Area of new faces. Infinite if it overflows.
    pub area: f64,
    /// New triangles of area 0.
    pub degenerate_faces: u32,
    /// Boundary loops of the result.
    pub loops_left: u32,
    /// Non-manifold edges of the result.
    pub non_manifold_edges: u32,
    /// Edges whose two faces disagree in orientation.
    pub orientation_conflicts: u32,
}

versioned! { gusset_quality_report: 56 }

impl From<&Quality> for gusset_quality_report {
    fn from(q: &Quality) -> Self {
        gusset_quality_report {
            struct_size: size_of::<gusset_quality_report>(),
            min_angle: q.min_angle,
            max_aspect: q.max_aspect,
            max_edge: q.max_edge,
            area: q.area,
            degenerate_faces: q.degenerate_faces,
            loops_left: q.loops_left,
            non_manifold_edges: q.non_manifold_edges,
            orientation_conflicts: q.orientation_conflicts,
        }
    }
}

/// Destroys a result.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gusset_result_destroy(result: *mut gusset_result) {
    handle::destroy(result);
}

/// Lends the mesh.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_result_get_mesh(
    result: *const gusset_result,
    view: *mut gusset_mesh_view,
) -> gusset_status {
    lend!(result, view, |result| mesh::lend_mesh(result.0.result_mesh()))
}

/// Reports the quality of a stitch or filling.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_result_get_quality(
    result: *const gusset_result,
    report: *mut gusset_quality_report,
) -> gusset_status {
    lend!(result, report, |result| match &result.0 {
        OperationResult::Stitch(stitch) => (&stitch.quality).into(),
        OperationResult::Fill(fill) => (&fill.filled.quality).into(),
        other => return Err(other.wrong_operation_failure("gusset_stitch or gusset_fill")),
    })
}

/// Finds the sources of a result's elements in the operation's inputs.
///
/// - A strip has two polylines; its corners and faces lack sources.
/// - A corner that gusset_sew added has its face's corners at both ends of the edge.
/// - Corners and faces of a development have the surface's; each vertex has one source.
/// - In a net's mesh, a vertex has its first node, a face its cell, a corner its own cell's node,
///   which differs across seams.
/// - A sheet has (rows + 1) * (columns + 1) nodes, row by row. Vertices and corners have the nodes
///   of their cell, by parameters; faces have their cells. Where sheets close, corners have nodes
///   on their face's side.
///
/// @errors TOO_LARGE
/// @complexity O(H log n) for n corners of new faces; 16 bytes an element (sheet: 52 a vertex or
///     corner), plus linear in n.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_result_origins_create(
    context: *const gusset_context,
    result: *const gusset_result,
    origins: *mut *mut gusset_origins,
) -> gusset_status {
    create_handle(context, origins, "origins", |job| {
        Ok(gusset_origins(handle::get_object(result, "result")?.0.result_origins(job)?))
    })
}

#[cfg(test)]
mod tests {
    use super::OperationResult;
    use crate::job::Job;
    use crate::mesh::{Faces, MeshView, Positions};
    use crate::repair::weld::{Options, weld};

    #[test]
    fn a_report_of_another_operation_names_both() {
        let (points, corners) = ([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]], [[0, 1, 2]]);
        let job = Job::default();
        let mesh = MeshView::new(Positions::from(&points[..]), Faces::triangles(&corners).unwrap(), &job).unwrap();
        let made = OperationResult::Weld(weld(&mesh, &Options::default(), &job).unwrap());
        let message = made.wrong_operation_failure("gusset_stitch").message;
        assert_eq!(message, "result was made by gusset_weld; pass a result of gusset_stitch");
    }
}

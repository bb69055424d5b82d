//! Report of a repair: Changes and remaining defects.

use crate::capi::glue::{c_enum, versioned};
use crate::capi::input::{Choice, lend_list};
use crate::capi::mesh::gusset_indices;
use crate::error::Error;
use crate::solid::{DropReason, Repaired};
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
/// Part of an open sheet attached to a closed component.
pub const GUSSET_DROP_FIN: gusset_drop_reason = 4;
/// The face is in an overlapping or inverted part.
pub const GUSSET_DROP_OVERLAP: gusset_drop_reason = 5;

/// Changes, and defects that the result still has (_left).
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_repair_report {
    /// sizeof(gusset_repair_report).
    pub struct_size: usize,
    /// 1 if the result bounds a solid: closed, manifold, oriented, without degenerate, duplicate,
    /// intersecting or zero-area faces.
    /// @flag
    pub valid: u32,
    /// Vertices merged into others.
    pub welded_vertices: u32,
    /// Edges made from boundary edges or their parts.
    pub sewn_edges: u32,
    /// Old faces that sewing split or gave corners.
    pub split_faces: u32,
    /// Copies of vertices that separate sheets.
    pub split_vertices: u32,
    /// Holes that were filled.
    pub filled_holes: u32,
    /// Boundary edges.
    pub boundary_edges_left: u32,
    /// Non-manifold edges.
    pub non_manifold_edges_left: u32,
    /// Non-manifold vertices.
    pub non_manifold_vertices_left: u32,
    /// Edges whose two faces disagree in orientation.
    pub orientation_conflicts_left: u32,
    /// Degenerate, duplicate and zero-area faces.
    pub bad_faces_left: u32,
    /// 0.
    pub reserved: u32,
    /// Largest move of a remaining vertex onto another; 0 without any.
    pub tolerance: f64,
    /// Old face that each face is or is part of; UINT32_MAX for patches, which come last.
    pub face_origin: gusset_indices,
    /// Smallest old vertex that each vertex is; UINT32_MAX for new ones, which come last.
    pub vertex_origin: gusset_indices,
    /// For each face, 1 if it was turned over.
    /// @shape face_count
    /// @flag
    pub turned: *const u8,
    /// Number of faces.
    pub face_count: usize,
    /// Old faces without a remaining part, ascending.
    pub dropped_faces: gusset_indices,
    /// Reason why a face was dropped.
    /// @shape dropped_count
    pub drop_reasons: *const gusset_drop_reason,
    /// Number of dropped faces.
    pub dropped_count: usize,
    /// Intersecting pairs in the result, ascending, smaller face first.
    /// @shape * 2
    pub intersecting_pairs: gusset_indices,
}

versioned! { gusset_repair_report: 160 }

c_enum! {
    reason: DropReason {
        GUSSET_DROP_DEGENERATE => Degenerate,
        GUSSET_DROP_ZERO_AREA => ZeroArea,
        GUSSET_DROP_DUPLICATE => Duplicate,
        GUSSET_DROP_INSIDE => Inside,
        GUSSET_DROP_FIN => Fin,
        GUSSET_DROP_OVERLAP => Overlap,
    }
}

/// A repair, and its dropped faces in the form that C takes.
pub(crate) struct RepairResult {
    pub(crate) repaired: Repaired,
    dropped_faces: Vec<u32>,
    drop_reasons: Vec<u32>,
}

impl RepairResult {
    pub(crate) fn new(done: Repaired) -> Result<Self, Error> {
        let dropped_faces = alloc::collect(done.dropped.iter().map(|dropped| dropped.face))?;
        let drop_reasons = alloc::collect(done.dropped.iter().map(|dropped| dropped.reason.number()))?;
        Ok(RepairResult { repaired: done, dropped_faces, drop_reasons })
    }

    pub(crate) fn lend_report(&self) -> gusset_repair_report {
        let (done, after) = (&self.repaired, &self.repaired.after);
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
            dropped_faces: gusset_indices::lend_indices(&self.dropped_faces),
            drop_reasons: lend_list(&self.drop_reasons),
            dropped_count: self.drop_reasons.len(),
            intersecting_pairs: gusset_indices::lend_indices(done.intersections.as_flattened()),
        }
    }
}

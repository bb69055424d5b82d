//! Boundary loops: Finds boundary loops and defects.
//!
//! @source Nesterenko, algorithm 1, as corrected.

use crate::boundary::{self, Boundary, EdgeFlags, LoopFlags, NonManifold, Survey, boundary_loops};
use crate::capi::context::{create_handle, gusset_context, lend};
use crate::capi::glue::{c_enum, fixed, versioned};
use crate::capi::handle::{self, handle};
use crate::capi::input::{self, lend_list, read_choice};
use crate::capi::mesh::{self, gusset_indices, gusset_mesh_view};
use crate::capi::status::{Failure, gusset_status};
use crate::mesh::{Defect, NONE};
use gusset_base::alloc;

/// Treatment of non-manifold edges.
pub type gusset_non_manifold = u32;
/// Each face has its own border there; loops along it are closed.
pub const GUSSET_NON_MANIFOLD_CUT: gusset_non_manifold = 0;
/// Loops have boundary edges only, and end at non-manifold ones as open chains.
pub const GUSSET_NON_MANIFOLD_STOP: gusset_non_manifold = 1;

/// Part of the mesh that is checked.
pub type gusset_survey = u32;
/// Every edge: all defects are reported, and flagged on loops.
pub const GUSSET_SURVEY_WHOLE_MESH: gusset_survey = 0;
/// The boundary only, many times faster. Checks the whole mesh if the boundary is open, touches
/// itself, is not oriented or has edges with three faces.
///
/// Other defects are not reported. Edges with equal numbers of faces in both directions, two or
/// more, do not cut loops.
///
/// The search by hashes fails with a probability below 2^-64, but malicious meshes may hide a
/// boundary: check untrusted ones whole.
pub const GUSSET_SURVEY_BOUNDARY_ONLY: gusset_survey = 1;

/// Properties of a loop.
/// @bits
pub type gusset_loop_flags = u32;
/// An open chain, with one vertex more than edges.
pub const GUSSET_LOOP_OPEN: gusset_loop_flags = 1;
/// Passes a vertex where the surface touches itself.
pub const GUSSET_LOOP_BOW_TIE: gusset_loop_flags = 2;
/// Cut from a longer walk that passes a vertex twice.
pub const GUSSET_LOOP_SPLIT: gusset_loop_flags = 4;
/// Runs along, or ends at, a non-manifold edge.
pub const GUSSET_LOOP_NON_MANIFOLD: gusset_loop_flags = 8;
/// Faces along the loop disagree in orientation.
pub const GUSSET_LOOP_NOT_ORIENTED: gusset_loop_flags = 16;
/// Has an edge of length 0.
pub const GUSSET_LOOP_ZERO_LENGTH: gusset_loop_flags = 32;

/// Properties of an edge of a loop.
/// @bits
pub type gusset_edge_flags = u8;
/// The loop runs this edge against its face.
pub const GUSSET_EDGE_REVERSED: gusset_edge_flags = 1;
/// The edge is non-manifold.
pub const GUSSET_EDGE_NON_MANIFOLD: gusset_edge_flags = 2;
/// The edge has length 0.
pub const GUSSET_EDGE_ZERO_LENGTH: gusset_edge_flags = 4;

const _: () = assert!(
    GUSSET_LOOP_OPEN == LoopFlags::OPEN
        && GUSSET_LOOP_BOW_TIE == LoopFlags::BOW_TIE
        && GUSSET_LOOP_SPLIT == LoopFlags::SPLIT
        && GUSSET_LOOP_NON_MANIFOLD == LoopFlags::NON_MANIFOLD
        && GUSSET_LOOP_NOT_ORIENTED == LoopFlags::NOT_ORIENTED
        && GUSSET_LOOP_ZERO_LENGTH == LoopFlags::ZERO_LENGTH
        && GUSSET_EDGE_REVERSED == EdgeFlags::REVERSED
        && GUSSET_EDGE_NON_MANIFOLD == EdgeFlags::NON_MANIFOLD
        && GUSSET_EDGE_ZERO_LENGTH == EdgeFlags::ZERO_LENGTH
);

/// Kind of a defect.
pub type gusset_defect_kind = u32;
/// A face (index) repeats a vertex (other).
pub const GUSSET_DEFECT_DEGENERATE_FACE: gusset_defect_kind = 1;
/// The two faces of an edge run it in one direction: half-edges index and other.
pub const GUSSET_DEFECT_ORIENTATION_CONFLICT: gusset_defect_kind = 2;
/// An edge has three or more half-edges: index is the first, count their number. A face may count
/// twice.
pub const GUSSET_DEFECT_NON_MANIFOLD_EDGE: gusset_defect_kind = 3;
/// The faces at a vertex (index) form several fans. Ends of non-manifold edges count too where a
/// loop passes.
pub const GUSSET_DEFECT_BOW_TIE: gusset_defect_kind = 4;

/// Boundary loops of a mesh.
pub struct gusset_boundary {
    boundary: Boundary,
    defects: Vec<gusset_defect>,
}

handle! { gusset_boundary }

/// Options of gusset_boundary_create.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_boundary_options {
    /// sizeof(gusset_boundary_options).
    pub struct_size: usize,
    /// Treatment of non-manifold edges.
    pub non_manifold: gusset_non_manifold,
    /// Part of the mesh that is checked.
    pub survey: gusset_survey,
}

/// Boundary loop or open chain. Edge i runs from vertices[i] to vertices[i + 1], cyclically in a
/// loop.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_loop_view {
    /// sizeof(gusset_loop_view).
    pub struct_size: usize,
    /// Vertices, each once. Closed loops start at their smallest half-edge.
    pub vertices: gusset_indices,
    /// Half-edge of each edge.
    pub half_edges: gusset_indices,
    /// Face beside each edge.
    pub faces: gusset_indices,
    /// Properties of each edge.
    /// @shape half_edges
    pub edge_flags: *const gusset_edge_flags,
    /// Sum of the edge lengths.
    pub length: f64,
    /// Properties of a loop.
    pub flags: gusset_loop_flags,
    /// Walk that the loop was cut from.
    pub walk: u32,
}

/// Defect of a mesh.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_defect {
    /// Kind of a defect.
    pub kind: gusset_defect_kind,
    /// Face, half-edge or vertex.
    pub index: u32,
    /// Second element, or UINT32_MAX.
    pub other: u32,
    /// Half-edges of a non-manifold edge; else 0.
    pub count: u32,
}

/// Loop count and defects of a boundary.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_boundary_view {
    /// sizeof(gusset_boundary_view).
    pub struct_size: usize,
    /// Loops and open chains; 0 if the mesh is closed.
    pub loop_count: usize,
    /// Walks that loops were cut from. Touching loops share a walk that passes from one to the
    /// other.
    pub walk_count: usize,
    /// Degenerate faces, orientation conflicts, non-manifold edges, and bow-ties on the boundary.
    /// @shape defect_count
    pub defects: *const gusset_defect,
    /// Number of defects.
    pub defect_count: usize,
}

versioned! { gusset_boundary_options: 16, gusset_boundary_view: 40, gusset_loop_view: 80 }
fixed! { gusset_defect: 16 }

c_enum! {
    non_manifold: NonManifold { GUSSET_NON_MANIFOLD_CUT => Cut, GUSSET_NON_MANIFOLD_STOP => Stop }
    survey: Survey { GUSSET_SURVEY_WHOLE_MESH => WholeMesh, GUSSET_SURVEY_BOUNDARY_ONLY => BoundaryOnly }
}

impl gusset_boundary_options {
    fn checked(self) -> Result<boundary::Options, Failure> {
        Ok(boundary::Options { non_manifold: read_choice(self.non_manifold)?, survey: read_choice(self.survey)? })
    }
}

impl From<&Defect> for gusset_defect {
    fn from(defect: &Defect) -> Self {
        let (kind, index, other, count) = match *defect {
            Defect::DegenerateFace { face, vertex } => (GUSSET_DEFECT_DEGENERATE_FACE, face, vertex, 0),
            Defect::OrientationConflict { half_edges: [h, g] } => (GUSSET_DEFECT_ORIENTATION_CONFLICT, h, g, 0),
            Defect::NonManifoldEdge { half_edge, faces } => (GUSSET_DEFECT_NON_MANIFOLD_EDGE, half_edge, NONE, faces),
            Defect::BowTie { vertex } => (GUSSET_DEFECT_BOW_TIE, vertex, NONE, 0),
        };
        gusset_defect { kind, index, other, count }
    }
}

/// Finds all boundary loops: chains of boundary edges.
///
/// Loops run as the faces along them: if faces are counter-clockwise from outside, the surface is
/// on the left.
/// - Each loop passes a vertex once: a boundary that touches itself is cut. Loops may have only two
///   vertices.
/// - Loops are ordered by smallest half-edge.
/// - Walks along only non-manifold edges are left out, except loops cut from other walks.
/// - A face with fewer than three sides between different vertices lacks a border; its neighbours
///   count as adjacent.
///
/// @errors as gusset_mesh_view
/// @complexity O(H log d); GUSSET_SURVEY_BOUNDARY_ONLY O(H + B log B) for B boundary edges.
/// @source Nesterenko, algorithm 1, corrected.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_boundary_create(
    context: *const gusset_context,
    mesh: *const gusset_mesh_view,
    options: *const gusset_boundary_options,
    boundary: *mut *mut gusset_boundary,
) -> gusset_status {
    create_handle(context, boundary, "boundary", |job| {
        let options = input::read_versioned_struct(options, true, "options")?.checked()?;
        let given_mesh = mesh::read_numbered_mesh(mesh, 0, &job.sub_job(0.0, 0.2))?;
        let mesh = given_mesh.mesh_view();
        let boundary = boundary_loops(&mesh, &options, &job.sub_job(0.2, 1.0))?;
        let defects = alloc::collect(boundary.defects().iter().map(gusset_defect::from))?;
        Ok(gusset_boundary { boundary, defects })
    })
}

/// Destroys a boundary.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gusset_boundary_destroy(boundary: *mut gusset_boundary) {
    handle::destroy(boundary);
}

/// Lends the counts and defects.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_boundary_get_view(
    boundary: *const gusset_boundary,
    view: *mut gusset_boundary_view,
) -> gusset_status {
    lend!(boundary, view, |gusset_boundary { boundary, defects }| gusset_boundary_view {
        struct_size: size_of::<gusset_boundary_view>(),
        loop_count: boundary.len(),
        walk_count: boundary.walk_count() as usize,
        defects: lend_list(defects),
        defect_count: defects.len(),
    })
}

/// Lends one loop.
///
/// @param index below loop_count of gusset_boundary_view.
/// @errors NO_SUCH_ELEMENT
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_boundary_get_loop(
    boundary: *const gusset_boundary,
    index: usize,
    view: *mut gusset_loop_view,
) -> gusset_status {
    lend!(boundary, view, |boundary| {
        let found = boundary
            .boundary
            .get(index)
            .ok_or_else(|| Failure::no_such_element("loop", index, boundary.boundary.len()))?;
        gusset_loop_view {
            struct_size: size_of::<gusset_loop_view>(),
            vertices: gusset_indices::lend_indices(found.vertices),
            half_edges: gusset_indices::lend_indices(found.half_edges),
            faces: gusset_indices::lend_indices(found.faces),
            edge_flags: lend_list(found.edge_flags),
            length: found.length,
            flags: found.flags.0,
            walk: found.walk,
        }
    })
}

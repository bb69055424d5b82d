//! Boundary loops: Finds the free boundary loops of a mesh, in a stated direction, and reports
//! everything unusual in them.
//!
//! @source Nesterenko, algorithm 1, as corrected.

use crate::boundary::{self, Boundary, EdgeFlags, LoopFlags, NonManifold, Survey, boundary_loops};
use crate::capi::context::{create, gusset_context, lend};
use crate::capi::glue::{c_enum, fixed, versioned};
use crate::capi::handle::{self, handle};
use crate::capi::input::{self, choice, lent};
use crate::capi::mesh::{self, gusset_indices, gusset_mesh_view};
use crate::capi::status::{Failure, gusset_status};
use crate::mesh::{Defect, NONE};
use gusset_base::alloc;

/// The treatment of edges with three or more faces.
pub type gusset_non_manifold = u32;
/// At an edge with three or more faces each face has a border of its own; loops run along it and
/// are always closed.
pub const GUSSET_NON_MANIFOLD_CUT: gusset_non_manifold = 0;
/// Only edges with exactly one face belong to loops; one that meets an edge with more ends there,
/// as an open chain.
pub const GUSSET_NON_MANIFOLD_STOP: gusset_non_manifold = 1;

/// The part of the mesh that is checked.
pub type gusset_survey = u32;
/// Every edge is looked at: all that is wrong or unusual in the mesh is reported, and flagged on
/// the loops.
pub const GUSSET_SURVEY_WHOLE_MESH: gusset_survey = 0;
/// As little is looked at as will give the loops, which is many times faster. Where the boundary
/// itself is odd (open, touching itself, badly oriented, with three faces on an edge) the whole
/// mesh is looked at after all. But what is away from the boundary is not reported, nor an edge
/// with as many faces one way as the other, two or more each; loops are not cut there. The answer
/// rests on sums of hashes: an ordinary mesh errs with a chance of less than 2^-64, but one that
/// was made to deceive may hide a boundary. For meshes from hostile hands take
/// GUSSET_SURVEY_WHOLE_MESH.
pub const GUSSET_SURVEY_BOUNDARY_ONLY: gusset_survey = 1;

/// Bits that describe a loop.
/// @bits
pub type gusset_loop_flags = u32;
/// The chain does not close: it has one vertex more than it has edges.
pub const GUSSET_LOOP_OPEN: gusset_loop_flags = 1;
/// The loop passes a vertex where the surface touches itself.
pub const GUSSET_LOOP_BOW_TIE: gusset_loop_flags = 2;
/// It was cut from a longer walk at a vertex that the walk passed twice.
pub const GUSSET_LOOP_SPLIT: gusset_loop_flags = 4;
/// It runs along, or ends at, an edge with three or more faces.
pub const GUSSET_LOOP_NON_MANIFOLD: gusset_loop_flags = 8;
/// The faces along it disagree in orientation.
pub const GUSSET_LOOP_NOT_ORIENTED: gusset_loop_flags = 16;
/// It has an edge of length 0.
pub const GUSSET_LOOP_ZERO_LENGTH: gusset_loop_flags = 32;

/// The loop runs this edge against its face.
pub const GUSSET_EDGE_REVERSED: u8 = 1;
/// The edge has three or more faces.
pub const GUSSET_EDGE_NON_MANIFOLD: u8 = 2;
/// The edge has length 0.
pub const GUSSET_EDGE_ZERO_LENGTH: u8 = 4;

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

/// The kind of a defect.
pub type gusset_defect_kind = u32;
/// A face (index) that repeats a vertex (other).
pub const GUSSET_DEFECT_DEGENERATE_FACE: gusset_defect_kind = 1;
/// An edge whose two faces run it in the same direction: half-edges index and other.
pub const GUSSET_DEFECT_ORIENTATION_CONFLICT: gusset_defect_kind = 2;
/// An edge with three or more half-edges (count; a face that runs it twice counts twice): its first
/// half-edge is index.
pub const GUSSET_DEFECT_NON_MANIFOLD_EDGE: gusset_defect_kind = 3;
/// A vertex (index) where the surface touches itself: its faces form more than one fan. Fans end at
/// edges with three or more faces, whose own ends are therefore listed too where a loop passes them.
pub const GUSSET_DEFECT_BOW_TIE: gusset_defect_kind = 4;

/// The free boundary loops of a mesh. Opaque and immutable; it keeps nothing of the mesh.
pub struct gusset_boundary {
    boundary: Boundary,
    defects: Vec<gusset_defect>,
}

handle! { gusset_boundary }

/// How loops are found; all zero is the default.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_boundary_options {
    /// sizeof(gusset_boundary_options), set by the caller.
    pub struct_size: usize,
    /// The treatment of edges with three or more faces.
    pub non_manifold: gusset_non_manifold,
    /// The part of the mesh that is checked.
    pub survey: gusset_survey,
}

/// One loop or open chain. Edge i runs from vertices[i] to vertices[i + 1], the last one of a
/// closed loop back to vertices[0]. Pointers are valid until the boundary is destroyed.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_loop_view {
    /// sizeof(gusset_loop_view), set by the caller.
    pub struct_size: usize,
    /// The vertices in order, each once; a closed loop starts at its smallest half-edge.
    pub vertices: gusset_indices,
    /// The half-edge (position in face_corners) that each edge is.
    pub half_edges: gusset_indices,
    /// The face that each edge borders.
    pub faces: gusset_indices,
    /// GUSSET_EDGE_... of each edge: as many as half_edges.
    pub edge_flags: *const u8,
    /// The sum of the edges' lengths, in the unit of the positions.
    pub length: f64,
    /// Bits; 0 for an ordinary closed loop.
    pub flags: gusset_loop_flags,
    /// The number of the walk that the loop was cut from.
    pub walk: u32,
}

/// Something wrong or unusual in a mesh.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_defect {
    /// The kind of a defect.
    pub kind: gusset_defect_kind,
    /// The face, half-edge or vertex.
    pub index: u32,
    /// The second element of the kinds that have one, else UINT32_MAX.
    pub other: u32,
    /// How many half-edges meet there, for GUSSET_DEFECT_NON_MANIFOLD_EDGE, else 0.
    pub count: u32,
}

/// The loops of a boundary as a whole. Pointers are valid until the boundary is destroyed.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_boundary_view {
    /// sizeof(gusset_boundary_view), set by the caller.
    pub struct_size: usize,
    /// The number of loops and open chains; 0 if the mesh is closed. gusset_boundary_get_loop lends each.
    pub loop_count: usize,
    /// The number of walks that the loops were cut from. Loops that touch at vertices count as one walk where the walk
    /// round the boundary passes from one loop to the next.
    pub walk_count: usize,
    /// Degenerate faces, orientation conflicts and non-manifold edges of the whole mesh, and the bow-tie vertices on its
    /// boundary. NULL if there are none.
    pub defects: *const gusset_defect,
    /// The number of defects.
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
        Ok(boundary::Options { non_manifold: choice(self.non_manifold)?, survey: choice(self.survey)? })
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

/// Finds every free boundary loop of a mesh: the chains of edges that have a face on one side only.
///
/// Direction: a loop runs as the faces along it run their own edges. With faces counter-clockwise
/// from outside, the surface is on the left and the hole on the right of someone who walks along
/// the loop on the outside. Every loop passes each of its vertices once: where the boundary touches
/// itself it is cut into several loops. Loops come in the order of their smallest half-edges. Walks
/// along edges with three or more faces alone are left out; a loop that is cut out of another walk
/// may have no edge with exactly one face. A face of fewer than three sides of different ends has no
/// border; its neighbours are taken to touch each other. A loop may have two vertices. Odd places
/// are no errors: see the flags of each loop, and the defects.
///
/// @errors as gusset_mesh_view
/// @complexity O(H log d) for H half-edges and at most d edges at a vertex, or O(H + B log B) for
///     GUSSET_SURVEY_BOUNDARY_ONLY and B boundary edges; linear extra memory.
/// @source Nesterenko, algorithm 1, as corrected: every loop, a stated direction, fan by fan round
///     each vertex.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_boundary_create(
    context: *const gusset_context,
    mesh: *const gusset_mesh_view,
    options: *const gusset_boundary_options,
    boundary: *mut *mut gusset_boundary,
) -> gusset_status {
    create(context, boundary, "boundary", |job| {
        let options = input::read(options, true, "options")?.checked()?;
        let given_mesh = mesh::mesh(mesh, 0, &job.part(0.0, 0.2))?;
        let mesh = given_mesh.view();
        let boundary = boundary_loops(&mesh, &options, &job.part(0.2, 1.0))?;
        let defects = alloc::collect(boundary.defects().iter().map(gusset_defect::from))?;
        Ok(gusset_boundary { boundary, defects })
    })
}

/// Destroys a boundary; NULL is allowed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gusset_boundary_destroy(boundary: *mut gusset_boundary) {
    handle::destroy(boundary);
}

/// Lends the number of loops and all defects, valid until the boundary is destroyed.
///
/// @complexity O(1).
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
        defects: lent(defects),
        defect_count: defects.len(),
    })
}

/// Lends loop number `index`, below loop_count of gusset_boundary_view.
///
/// @param index its number, from 0.
/// @errors NO_SUCH_ELEMENT
/// @complexity O(1).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_boundary_get_loop(
    boundary: *const gusset_boundary,
    index: usize,
    view: *mut gusset_loop_view,
) -> gusset_status {
    lend!(boundary, view, |boundary| {
        let found = boundary.boundary.get(index).ok_or_else(|| Failure::no_such("loop", index))?;
        gusset_loop_view {
            struct_size: size_of::<gusset_loop_view>(),
            vertices: gusset_indices::lend(found.vertices),
            half_edges: gusset_indices::lend(found.half_edges),
            faces: gusset_indices::lend(found.faces),
            edge_flags: lent(found.edge_flags),
            length: found.length,
            flags: found.flags.0,
            walk: found.walk,
        }
    })
}

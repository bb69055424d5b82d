//! Winged-edge tables: The tables of the paper, and the loops found in them.
//!
//! @source Nesterenko, equations 1 to 3, after Baumgart.

use crate::capi::context::{create, gusset_context, lend};
use crate::capi::glue::{c_enum, laid_out_like, versioned};
use crate::capi::handle::{self, handle};
use crate::capi::input::{self, choice, lent};
use crate::capi::mesh::{self, gusset_indices, gusset_mesh_view};
use crate::capi::status::gusset_status;
use crate::error::Error;
use crate::mesh::MAX_ELEMENTS;
use crate::winged::{EdgeMarks, FreeLoops, Winding, WingedEdge, WingedEdges, WingedFaces, faces, free_loops};

/// The direction in which faces are read.
pub type gusset_winding = u32;
/// Faces are stored counter-clockwise seen from outside, as modern libraries have it; the tables
/// take them backwards.
pub const GUSSET_FACES_COUNTER_CLOCKWISE: gusset_winding = 0;
/// Faces are stored clockwise seen from outside, as Baumgart has it.
pub const GUSSET_FACES_CLOCKWISE: gusset_winding = 1;

/// Bits that describe an edge of a table.
/// @bits
pub type gusset_winged_flags = u32;
/// One of several records of an edge with three or more faces; each has one face.
pub const GUSSET_WINGED_NON_MANIFOLD: gusset_winged_flags = 1;
/// One of two records of an edge whose faces run it in the same direction; each has one face.
pub const GUSSET_WINGED_NOT_ORIENTED: gusset_winged_flags = 2;
/// M = N, or the edge belongs to a face of fewer than three proper edges.
pub const GUSSET_WINGED_DEGENERATE: gusset_winged_flags = 4;

const _: () = assert!(
    GUSSET_WINGED_NON_MANIFOLD == EdgeMarks::NON_MANIFOLD
        && GUSSET_WINGED_NOT_ORIENTED == EdgeMarks::NOT_ORIENTED
        && GUSSET_WINGED_DEGENERATE == EdgeMarks::DEGENERATE
);

/// The winged-edge tables of a mesh. Opaque and immutable; it keeps nothing of the mesh.
pub struct gusset_winged {
    tables: WingedEdges,
    loops: FreeLoops,
}

handle! { gusset_winged }

/// The faces of a winged-edge table. Opaque and immutable; it keeps nothing of the table.
pub struct gusset_winged_faces(WingedFaces);

handle! { gusset_winged_faces }

/// How tables are made, and read; all zero is the default.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_winged_options {
    /// sizeof(gusset_winged_options), set by the caller.
    pub struct_size: usize,
    /// The direction in which faces are read.
    pub winding: gusset_winding,
    /// 0.
    pub reserved: u32,
}

/// One edge: Baumgart's M, N, b, c, d, e, L, R, where UINT32_MAX is NULL. Faces run clockwise seen
/// from outside.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_winged_edge {
    /// The vertex M, where it starts.
    pub m: u32,
    /// The vertex N, where it ends.
    pub n: u32,
    /// In R, the edge after this one; it leaves N.
    pub b: u32,
    /// In L, the edge before this one; it arrives at N.
    pub c: u32,
    /// In R, the edge before this one; it arrives at M.
    pub d: u32,
    /// In L, the edge after this one; it leaves M.
    pub e: u32,
    /// The face L: it runs N to M.
    pub left: u32,
    /// The face R: it runs M to N.
    pub right: u32,
    /// Bits; 0 for an ordinary edge.
    pub marks: gusset_winged_flags,
}

/// The tables. Pointers are valid until the handle is destroyed.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_winged_view {
    /// sizeof(gusset_winged_view), set by the caller.
    pub struct_size: usize,
    /// The edges in the order of their first half-edges; M is the vertex where that half-edge
    /// starts.
    pub edges: *const gusset_winged_edge,
    /// How many.
    pub edge_count: usize,
    /// Per half-edge (position in face_corners), its edge.
    pub edge_of_half_edge: gusset_indices,
    /// Per face, its first edge.
    pub edge_of_face: gusset_indices,
    /// Per vertex, an edge at it, or UINT32_MAX.
    pub edge_of_vertex: gusset_indices,
    /// The vertices of all loops of free edges (exactly one of L, R is NULL), loop after loop,
    /// surface on the left.
    pub loop_vertices: gusset_indices,
    /// The edges along them; edge i starts at vertex i.
    pub loop_edges: gusset_indices,
    /// Where each loop starts in both; one entry more than there are loops.
    pub loop_offsets: gusset_indices,
}

/// The faces of a table. Pointers are valid until the handle is destroyed.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_winged_faces_view {
    /// sizeof(gusset_winged_faces_view), set by the caller.
    pub struct_size: usize,
    /// For face_offsets of a gusset_mesh_view: one entry more than there are faces.
    pub face_offsets: gusset_indices,
    /// For face_corners: the vertices of each face in order.
    pub face_corners: gusset_indices,
    /// Per corner, the edge that leaves it.
    pub edge_of_half_edge: gusset_indices,
}

versioned! { gusset_winged_options: 16 reserved, gusset_winged_view: 120, gusset_winged_faces_view: 56 }
laid_out_like! { gusset_winged_edge: WingedEdge { m, n, b, c, d, e, left, right, marks } }
c_enum! { winding: Winding { GUSSET_FACES_COUNTER_CLOCKWISE => CounterClockwise, GUSSET_FACES_CLOCKWISE => Clockwise } }

/// Fills the winged-edge tables of a mesh, and runs the paper's algorithm 1 on them.
///
/// An edge with three or more faces, or with two that run it in the same direction, becomes several
/// marked records of one face each. The mesh of a stitch keeps the edge numbers of its first mesh:
/// only NULL sides along the rim are filled.
///
/// @errors as gusset_mesh_view
/// @complexity O(H log d) for H half-edges and at most d edges at a vertex; linear extra memory.
/// @source Nesterenko, equations 1-3 and algorithm 1. Criterion 3 is taken as "exactly one of L, R
///     is NULL", as the text has it; the loops are those of gusset_boundary_create, except that an
///     edge whose faces disagree has a border on both sides.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_winged_create(
    context: *const gusset_context,
    mesh: *const gusset_mesh_view,
    options: *const gusset_winged_options,
    winged: *mut *mut gusset_winged,
) -> gusset_status {
    create(context, winged, "winged", |job| {
        let winding = choice(input::read(options, true, "options")?.winding)?;
        let given_mesh = mesh::mesh(mesh, 0, &job.part(0.0, 0.2))?;
        let mesh = given_mesh.view();
        let tables = WingedEdges::new(&mesh, winding, &job.part(0.2, 0.9))?;
        let loops = free_loops(&tables, &job.part(0.9, 1.0))?;
        Ok(gusset_winged { tables, loops })
    })
}

/// Destroys tables; NULL is allowed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gusset_winged_destroy(winged: *mut gusset_winged) {
    handle::destroy(winged);
}

/// Lends the tables.
///
/// @complexity O(1).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_winged_get_view(
    winged: *const gusset_winged,
    view: *mut gusset_winged_view,
) -> gusset_status {
    lend!(winged, view, |gusset_winged { tables, loops }| gusset_winged_view {
        struct_size: size_of::<gusset_winged_view>(),
        edges: lent(tables.edges()).cast(),
        edge_count: tables.edges().len(),
        edge_of_half_edge: gusset_indices::lend(tables.edge_of_half_edge()),
        edge_of_face: gusset_indices::lend(tables.edge_of_face()),
        edge_of_vertex: gusset_indices::lend(tables.edge_of_vertex()),
        loop_vertices: gusset_indices::lend(&loops.vertices),
        loop_edges: gusset_indices::lend(&loops.edges),
        loop_offsets: gusset_indices::lend(&loops.offsets),
    })
}

/// Reads the faces off a winged-edge table: the way back from gusset_winged_create to a polygon
/// mesh, whose positions the caller has.
///
/// The records are held against each other and nothing is put right: each face must be one cycle of
/// three sides or more from wing to wing, wings and faces exist, and a side without a face has no
/// wings. The marks are not read. From the edges and edge_of_face of gusset_winged_create come the
/// faces that it was given, corner for corner.
///
/// @param edges the records, edge_count of them, packed.
/// @param edge_count see edges; 0 is a table without faces.
/// @param vertex_count how many vertices there are; those of edges are below it.
/// @param first_edges per face the edge at which it begins, of two such places the one where it
///     runs M to N; NULL: the one of the smallest number.
/// @param options the winding of the faces to be made; NULL for the defaults.
/// @errors BAD_WINGS (with the edge), FACE_TOO_SMALL (a number below the largest that no side has,
///     too), OUT_OF_RANGE (not one first edge for each face), TOO_LARGE
/// @complexity Linear time and memory.
/// @source Nesterenko, equation 2, read backwards.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_winged_faces_create(
    context: *const gusset_context,
    edges: *const gusset_winged_edge,
    edge_count: usize,
    vertex_count: usize,
    first_edges: *const gusset_indices,
    options: *const gusset_winged_options,
    faces: *mut *mut gusset_winged_faces,
) -> gusset_status {
    create(context, faces, "faces", |job| {
        let winding = choice(input::read(options, true, "options")?.winding)?;
        Error::check_count("edges", edge_count as u64, MAX_ELEMENTS)?;
        let edges: Vec<WingedEdge> = input::list(edges.cast(), edge_count, "edges")?;
        let first_edges = mesh::indices(first_edges, "first_edges")?;
        Ok(gusset_winged_faces(self::faces(&edges, vertex_count, first_edges.as_deref(), winding, job)?))
    })
}

/// Destroys faces; NULL is allowed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gusset_winged_faces_destroy(faces: *mut gusset_winged_faces) {
    handle::destroy(faces);
}

/// Lends the faces.
///
/// @complexity O(1).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_winged_faces_get_view(
    faces: *const gusset_winged_faces,
    view: *mut gusset_winged_faces_view,
) -> gusset_status {
    lend!(faces, view, |gusset_winged_faces(found)| gusset_winged_faces_view {
        struct_size: size_of::<gusset_winged_faces_view>(),
        face_offsets: gusset_indices::lend(&found.offsets),
        face_corners: gusset_indices::lend(&found.corners),
        edge_of_half_edge: gusset_indices::lend(&found.edges),
    })
}

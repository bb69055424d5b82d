//! Winged-edge tables: Baumgart's tables of a mesh, and its boundary loops.
//!
//! @source Nesterenko, equations 1 to 3, after Baumgart.

use crate::capi::context::{create_handle, gusset_context, lend};
use crate::capi::glue::{c_enum, laid_out_like, versioned};
use crate::capi::handle::{self, handle};
use crate::capi::input::{self, lend_list, read_choice};
use crate::capi::mesh::{self, gusset_indices, gusset_mesh_view};
use crate::capi::status::gusset_status;
use crate::error::Error;
use crate::mesh::MAX_ELEMENTS;
use crate::winged::{EdgeMarks, FreeLoops, Winding, WingedEdge, WingedEdges, WingedFaces, faces, free_loops};

/// Orientation of faces in a mesh.
pub type gusset_winding = u32;
/// Counter-clockwise seen from outside. The tables list them in reverse, as Baumgart does.
pub const GUSSET_FACES_COUNTER_CLOCKWISE: gusset_winding = 0;
/// Clockwise seen from outside, as Baumgart's.
pub const GUSSET_FACES_CLOCKWISE: gusset_winding = 1;

/// Marks of an edge.
/// @bits
pub type gusset_winged_flags = u32;
/// One face of a non-manifold edge.
pub const GUSSET_WINGED_NON_MANIFOLD: gusset_winged_flags = 1;
/// One face of an edge that two faces traverse in one direction.
pub const GUSSET_WINGED_NOT_ORIENTED: gusset_winged_flags = 2;
/// The ends are equal, or a face has fewer than three edges with different ends.
pub const GUSSET_WINGED_DEGENERATE: gusset_winged_flags = 4;

const _: () = assert!(
    GUSSET_WINGED_NON_MANIFOLD == EdgeMarks::NON_MANIFOLD
        && GUSSET_WINGED_NOT_ORIENTED == EdgeMarks::NOT_ORIENTED
        && GUSSET_WINGED_DEGENERATE == EdgeMarks::DEGENERATE
);

/// Winged-edge tables of a mesh.
pub struct gusset_winged {
    tables: WingedEdges,
    loops: FreeLoops,
}

handle! { gusset_winged }

/// Faces of a winged-edge table.
pub struct gusset_winged_faces(WingedFaces);

handle! { gusset_winged_faces }

/// Options of winged-edge tables.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_winged_options {
    /// sizeof(gusset_winged_options).
    pub struct_size: usize,
    /// Orientation of faces in a mesh.
    pub winding: gusset_winding,
    /// 0.
    pub reserved: u32,
}

/// An edge in Baumgart's notation, UINT32_MAX for NULL. Faces are clockwise seen from outside.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_winged_edge {
    /// Start vertex M.
    pub m: u32,
    /// End vertex N.
    pub n: u32,
    /// Next edge in R, at N.
    pub b: u32,
    /// Previous edge in L, at N.
    pub c: u32,
    /// Previous edge in R, at M.
    pub d: u32,
    /// Next edge in L, at M.
    pub e: u32,
    /// Face L, which traverses the edge from N to M.
    pub left: u32,
    /// Face R, which traverses the edge from M to N.
    pub right: u32,
    /// Marks of an edge.
    pub marks: gusset_winged_flags,
}

/// Lent tables.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_winged_view {
    /// sizeof(gusset_winged_view).
    pub struct_size: usize,
    /// Edges, ordered by their first half-edges, which start at M.
    /// @shape edge_count
    pub edges: *const gusset_winged_edge,
    /// Number of edges.
    pub edge_count: usize,
    /// Edge of each half-edge (position in face_corners).
    pub edge_of_half_edge: gusset_indices,
    /// First edge of each face.
    pub edge_of_face: gusset_indices,
    /// An edge at each vertex, or UINT32_MAX.
    pub edge_of_vertex: gusset_indices,
    /// Vertices of all boundary loops, surface on the left. Exactly one of L and R of a boundary
    /// edge is NULL.
    pub loop_vertices: gusset_indices,
    /// Edges of the loops; edge i starts at vertex i.
    pub loop_edges: gusset_indices,
    /// Offsets into loop_vertices and loop_edges, by loop.
    pub loop_offsets: gusset_indices,
}

/// Lent faces.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_winged_faces_view {
    /// sizeof(gusset_winged_faces_view).
    pub struct_size: usize,
    /// As in gusset_mesh_view.
    pub face_offsets: gusset_indices,
    /// As in gusset_mesh_view.
    pub face_corners: gusset_indices,
    /// Edge that leaves each corner.
    pub edge_of_half_edge: gusset_indices,
}

versioned! { gusset_winged_options: 16 reserved, gusset_winged_view: 120, gusset_winged_faces_view: 56 }
laid_out_like! { gusset_winged_edge: WingedEdge { m, n, b, c, d, e, left, right, marks } }
c_enum! { winding: Winding { GUSSET_FACES_COUNTER_CLOCKWISE => CounterClockwise, GUSSET_FACES_CLOCKWISE => Clockwise } }

/// Makes the winged-edge tables of a mesh, and finds its boundary loops by Nesterenko's algorithm
/// 1.
///
/// A non-manifold edge, or one with two faces in one direction, becomes marked records of one face
/// each. A stitched mesh keeps its first mesh's edge numbers. Loops are as in
/// gusset_boundary_create, except that edges with inconsistent faces are boundaries on both sides.
///
/// @errors as gusset_mesh_view
/// @complexity O(H log d); linear memory.
/// @source Nesterenko, equations 1-3 and algorithm 1; criterion 3 as "exactly one of L, R is NULL".
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_winged_create(
    context: *const gusset_context,
    mesh: *const gusset_mesh_view,
    options: *const gusset_winged_options,
    winged: *mut *mut gusset_winged,
) -> gusset_status {
    create_handle(context, winged, "winged", |job| {
        let winding = read_choice(input::read_versioned_struct(options, true, "options")?.winding)?;
        let given_mesh = mesh::read_numbered_mesh(mesh, 0, &job.sub_job(0.0, 0.2))?;
        let mesh = given_mesh.mesh_view();
        let tables = WingedEdges::new(&mesh, winding, &job.sub_job(0.2, 0.9))?;
        let loops = free_loops(&tables, &job.sub_job(0.9, 1.0))?;
        Ok(gusset_winged { tables, loops })
    })
}

/// Frees tables.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gusset_winged_destroy(winged: *mut gusset_winged) {
    handle::destroy(winged);
}

/// Lends the tables.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_winged_get_view(
    winged: *const gusset_winged,
    view: *mut gusset_winged_view,
) -> gusset_status {
    lend!(winged, view, |gusset_winged { tables, loops }| gusset_winged_view {
        struct_size: size_of::<gusset_winged_view>(),
        edges: lend_list(tables.edges()).cast(),
        edge_count: tables.edges().len(),
        edge_of_half_edge: gusset_indices::lend_indices(tables.edge_of_half_edge()),
        edge_of_face: gusset_indices::lend_indices(tables.edge_of_face()),
        edge_of_vertex: gusset_indices::lend_indices(tables.edge_of_vertex()),
        loop_vertices: gusset_indices::lend_indices(&loops.vertices),
        loop_edges: gusset_indices::lend_indices(&loops.edges),
        loop_offsets: gusset_indices::lend_indices(&loops.offsets),
    })
}

/// Reads the faces of a winged-edge table, and checks its records.
///
/// Each face must be one cycle of three or more sides along the wings. Wings and faces must exist;
/// sides without a face lack wings. Marks are not read. Edges and edge_of_face of
/// gusset_winged_create give back its faces corner for corner.
///
/// @param edge_count 0: no faces.
/// @param vertex_count exceeds every vertex of an edge.
/// @param first_edges for each face, the edge where it begins; from M to N if both sides are the
///     face's. NULL: the lowest.
/// @errors BAD_WINGS (edge), FACE_TOO_SMALL (also a face without sides), OUT_OF_RANGE
///     (first_edges), TOO_LARGE
/// @complexity O(edges) time and memory.
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
    create_handle(context, faces, "faces", |job| {
        let winding = read_choice(input::read_versioned_struct(options, true, "options")?.winding)?;
        Error::check_count("edges", edge_count as u64, MAX_ELEMENTS)?;
        let edges: Vec<WingedEdge> = input::copy_input_items(edges.cast(), edge_count, "edges")?;
        let first_edges = mesh::read_indices(first_edges, "first_edges")?;
        Ok(gusset_winged_faces(self::faces(&edges, vertex_count, first_edges.as_deref(), winding, job)?))
    })
}

/// Frees faces.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gusset_winged_faces_destroy(faces: *mut gusset_winged_faces) {
    handle::destroy(faces);
}

/// Lends the faces.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_winged_faces_get_view(
    faces: *const gusset_winged_faces,
    view: *mut gusset_winged_faces_view,
) -> gusset_status {
    lend!(faces, view, |gusset_winged_faces(found)| gusset_winged_faces_view {
        struct_size: size_of::<gusset_winged_faces_view>(),
        face_offsets: gusset_indices::lend_indices(&found.offsets),
        face_corners: gusset_indices::lend_indices(&found.corners),
        edge_of_half_edge: gusset_indices::lend_indices(&found.edges),
    })
}

//! Checks: Properties and defects of a mesh.
//!
//! @source Textbook topology of polygon meshes.

use crate::capi::context::{create_handle, gusset_context, lend};
use crate::capi::glue::versioned;
use crate::capi::handle::{self, handle};
use crate::capi::mesh::{self, gusset_indices, gusset_mesh_view};
use crate::capi::status::gusset_status;
use crate::check::{Check, check};

/// Properties of a mesh.
/// @bits
pub type gusset_mesh_flags = u32;
/// The mesh has edges, each with exactly two faces.
pub const GUSSET_MESH_CLOSED: gusset_mesh_flags = 1;
/// No edge or vertex is non-manifold.
pub const GUSSET_MESH_MANIFOLD: gusset_mesh_flags = 2;
/// The two faces of each edge run it in opposite directions.
pub const GUSSET_MESH_ORIENTED: gusset_mesh_flags = 4;
/// The mesh is oriented, or would be after turning faces over.
pub const GUSSET_MESH_ORIENTABLE: gusset_mesh_flags = 8;

/// Findings of a check.
pub struct gusset_check(Check);

handle! { gusset_check }

/// Counts, properties and defects of a mesh. Lists are ascending. Degenerate faces lack edges.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_check_view {
    /// sizeof(gusset_check_view).
    pub struct_size: usize,
    /// Vertices, also unused ones.
    pub vertex_count: u32,
    /// Distinct edges, between different vertices.
    pub edge_count: u32,
    /// Faces.
    pub face_count: u32,
    /// Components: faces connected by shared edges.
    pub component_count: u32,
    /// Number of boundary walks.
    pub boundary_walk_count: u32,
    /// Properties of a mesh.
    pub properties: gusset_mesh_flags,
    /// Used vertices - edges + faces: the Euler characteristic without degenerate faces.
    pub euler: i64,
    /// Handles of all components together; -1 if not manifold or orientable, or with a degenerate
    /// face.
    pub genus: i64,
    /// Half-edges of boundary edges.
    pub boundary_edges: gusset_indices,
    /// First half-edge of each non-manifold edge.
    pub non_manifold_edges: gusset_indices,
    /// Ends of non-manifold edges, and bow-ties.
    pub non_manifold_vertices: gusset_indices,
    /// Vertices whose faces form several fans; usually also ends of non-manifold edges.
    pub bow_ties: gusset_indices,
    /// First half-edge of each edge whose two faces run it in one direction.
    pub orientation_conflicts: gusset_indices,
    /// Faces with the cycle of vertices of an earlier face, in either direction; none degenerate.
    pub duplicate_faces: gusset_indices,
    /// Faces that repeat a vertex.
    pub degenerate_faces: gusset_indices,
    /// Other faces whose vector area is 0 up to rounding.
    pub zero_area_faces: gusset_indices,
    /// Vertices that no face uses.
    pub unused_vertices: gusset_indices,
}

versioned! { gusset_check_view: 192 }

/// Checks the topology of a mesh.
///
/// @errors as gusset_mesh_view
/// @complexity O(H log d).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_check_create(
    context: *const gusset_context,
    mesh: *const gusset_mesh_view,
    check: *mut *mut gusset_check,
) -> gusset_status {
    create_handle(context, check, "check", |job| {
        let given_mesh = mesh::read_numbered_mesh(mesh, 0, &job.sub_job(0.0, 0.2))?;
        let mesh = given_mesh.mesh_view();
        Ok(gusset_check(self::check(&mesh, &job.sub_job(0.2, 1.0))?))
    })
}

/// Destroys a check.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gusset_check_destroy(check: *mut gusset_check) {
    handle::destroy(check);
}

/// Lends the findings.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_check_get_view(
    check: *const gusset_check,
    view: *mut gusset_check_view,
) -> gusset_status {
    lend!(check, view, |gusset_check(c)| {
        let bit = |set, bit| if set { bit } else { 0 };
        gusset_check_view {
            struct_size: size_of::<gusset_check_view>(),
            vertex_count: c.vertices,
            edge_count: c.edges,
            face_count: c.faces,
            component_count: c.components,
            boundary_walk_count: c.boundary_walks,
            properties: bit(c.closed, GUSSET_MESH_CLOSED)
                | bit(c.manifold, GUSSET_MESH_MANIFOLD)
                | bit(c.oriented, GUSSET_MESH_ORIENTED)
                | bit(c.orientable, GUSSET_MESH_ORIENTABLE),
            euler: c.euler,
            genus: c.genus.map_or(-1, i64::from),
            boundary_edges: gusset_indices::lend_indices(&c.boundary_edges),
            non_manifold_edges: gusset_indices::lend_indices(&c.non_manifold_edges),
            non_manifold_vertices: gusset_indices::lend_indices(&c.non_manifold_vertices),
            bow_ties: gusset_indices::lend_indices(&c.bow_ties),
            orientation_conflicts: gusset_indices::lend_indices(&c.orientation_conflicts),
            duplicate_faces: gusset_indices::lend_indices(&c.duplicate_faces),
            degenerate_faces: gusset_indices::lend_indices(&c.degenerate_faces),
            zero_area_faces: gusset_indices::lend_indices(&c.zero_area_faces),
            unused_vertices: gusset_indices::lend_indices(&c.unused_vertices),
        }
    })
}

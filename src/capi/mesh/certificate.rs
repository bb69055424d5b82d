//! Certificates: Facts that programs without the library can check.
//!
//! @source Y. Shiloach, Fast canonization of circular strings (1981), for matching faces.

use crate::capi::context::{create_handle, gusset_context, lend};
use crate::capi::glue::versioned;
use crate::capi::handle::{self, handle};
use crate::capi::mesh::{self, GivenMesh, gusset_indices, gusset_mesh_view};
use crate::capi::status::gusset_status;
use crate::certify::{Certificate, certify};
use crate::mesh::NONE;
use gusset_base::alloc;

/// Facts about a result.
pub struct gusset_certificate(Certificate);

handle! { gusset_certificate }

/// Facts about a result. Faces match by the positions of their corners, from any corner; -0 equals
/// 0. Each result face matches at most one face of the pieces. Edges connect different vertices; a
/// face with fewer than three has none. Shared edges connect components.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_certificate_view {
    /// sizeof(gusset_certificate_view).
    pub struct_size: usize,
    /// Vertices that faces use.
    pub vertex_count: u32,
    /// Number of edges.
    pub edge_count: u32,
    /// Faces.
    pub face_count: u32,
    /// Number of components.
    pub component_count: u32,
    /// 1 if there are edges, and each has exactly two faces.
    /// @flag
    pub closed: u32,
    /// 1 if closed and oriented without intersecting pairs, and facing outwards. A component that
    /// an odd number of others encloses has a negative volume, any other a positive one.
    /// @flag
    pub outward: u32,
    /// Edges with one face.
    pub boundary_edges: u32,
    /// Edges with three or more faces.
    pub non_manifold_edges: u32,
    /// Ends of non-manifold edges, and vertices with several fans.
    pub non_manifold_vertices: u32,
    /// Edges whose two faces run them in one direction.
    pub orientation_conflicts: u32,
    /// Faces that repeat a vertex.
    pub degenerate_faces: u32,
    /// As in gusset_check_view.
    pub duplicate_faces: u32,
    /// Triangles, also of polygons, with three different vertices on one line.
    pub collinear_triangles: u32,
    /// Faces that match no face of the pieces.
    pub new_faces: u32,
    /// Pairs of faces with common points beyond common vertices and edges.
    pub intersecting_pairs: u64,
    /// Faces of the pieces that the result has.
    pub kept_faces: u64,
    /// Faces that the result has only reversed, as (piece, face), ascending.
    /// @shape * 2
    pub turned_faces: gusset_indices,
    /// Faces that the result lacks, as (piece, face), ascending.
    /// @shape * 2
    pub lost_faces: gusset_indices,
    /// Largest distance of a used vertex of the pieces from the result's nearest used vertex; 0 if
    /// all remain.
    pub farthest_distance: f64,
    /// Piece of the farthest vertex; UINT32_MAX without one.
    pub farthest_piece: u32,
    /// The farthest vertex; UINT32_MAX without one.
    pub farthest_vertex: u32,
    /// Vertex of the result nearest to it; UINT32_MAX without one.
    pub nearest_vertex: u32,
    /// 0.
    pub reserved: u32,
    /// Triangles of faces with more than three corners, as half-edges, face by face.
    /// @shape * 3
    pub polygon_triangles: gusset_indices,
}

versioned! { gusset_certificate_view: 152 }

/// States facts about a result, from anywhere, and its pieces. verify.py confirms or refutes the
/// facts by exact arithmetic, without the library.
///
/// All facts are exact, except farthest_distance. outward is 0 also if undecided: a volume is 0 up
/// to rounding, or a component shares the positions of all its vertices with others.
///
/// @param pieces the meshes that the result was made from; may be NULL without any.
/// @errors as gusset_mesh_view, TOO_LARGE (vertices of all meshes)
/// @complexity O(n log n) for n corners of all meshes, and the search for intersecting faces.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_certificate_create(
    context: *const gusset_context,
    pieces: *const gusset_mesh_view,
    piece_count: usize,
    result: *const gusset_mesh_view,
    certificate: *mut *mut gusset_certificate,
) -> gusset_status {
    create_handle(context, certificate, "certificate", |job| {
        let given_pieces = mesh::read_meshes(pieces, piece_count, &job.sub_job(0.0, 0.1))?;
        let given_result = mesh::read_named_mesh(result, "result", piece_count as u32, &job.sub_job(0.1, 0.2))?;
        let views = alloc::collect(given_pieces.iter().map(GivenMesh::mesh_view))?;
        Ok(gusset_certificate(certify(&views, &given_result.mesh_view(), &job.sub_job(0.2, 1.0))?))
    })
}

/// Destroys a certificate.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gusset_certificate_destroy(certificate: *mut gusset_certificate) {
    handle::destroy(certificate);
}

/// Lends the facts.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_certificate_get_view(
    certificate: *const gusset_certificate,
    view: *mut gusset_certificate_view,
) -> gusset_status {
    lend!(certificate, view, |gusset_certificate(c)| {
        let farthest = c.farthest_vertex;
        gusset_certificate_view {
            struct_size: size_of::<gusset_certificate_view>(),
            vertex_count: c.vertices,
            edge_count: c.edges,
            face_count: c.faces,
            component_count: c.components,
            closed: c.closed.into(),
            outward: c.outward.into(),
            boundary_edges: c.boundary_edges,
            non_manifold_edges: c.non_manifold_edges,
            non_manifold_vertices: c.non_manifold_vertices,
            orientation_conflicts: c.orientation_conflicts,
            degenerate_faces: c.degenerate_faces,
            duplicate_faces: c.duplicate_faces,
            collinear_triangles: c.collinear_triangles,
            new_faces: c.new_faces,
            intersecting_pairs: c.intersecting_pairs,
            kept_faces: c.kept_faces,
            turned_faces: gusset_indices::lend_indices(c.turned_faces.as_flattened()),
            lost_faces: gusset_indices::lend_indices(c.lost_faces.as_flattened()),
            farthest_distance: farthest.map_or(0.0, |farthest| farthest.distance),
            farthest_piece: farthest.map_or(NONE, |farthest| farthest.piece),
            farthest_vertex: farthest.map_or(NONE, |farthest| farthest.vertex),
            nearest_vertex: farthest.map_or(NONE, |farthest| farthest.nearest),
            reserved: 0,
            polygon_triangles: gusset_indices::lend_indices(c.polygon_triangles.as_flattened()),
        }
    })
}

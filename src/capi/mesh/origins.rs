//! Origins: Names the elements of the inputs from which each vertex, corner and face of a result
//! comes.

use crate::attributes::{Domain, Origins};
use crate::capi::context::lend;
use crate::capi::glue::{c_enum, versioned};
use crate::capi::handle::{self, handle};
use crate::capi::input::{choice, lent};
use crate::capi::mesh::gusset_indices;
use crate::capi::status::gusset_status;

/// Elements of meshes, and of what meshes are made from.
pub type gusset_domain = u32;
/// Vertices; the points of polylines, the nodes of a net or a sheet.
pub const GUSSET_DOMAIN_VERTICES: gusset_domain = 0;
/// Corners of faces, in the order of face_corners; the nodes of a net or a sheet.
pub const GUSSET_DOMAIN_CORNERS: gusset_domain = 1;
/// Faces; the cells of a net or a sheet.
pub const GUSSET_DOMAIN_FACES: gusset_domain = 2;

c_enum! {
    domain: Domain {
        GUSSET_DOMAIN_VERTICES => Vertices,
        GUSSET_DOMAIN_CORNERS => Corners,
        GUSSET_DOMAIN_FACES => Faces,
    }
}

/// For each vertex, corner and face of a result, the elements of the inputs that it has its values
/// from. Opaque and immutable; it keeps nothing of the result.
///
/// An element that was there before has itself, and a vertex that several became all of them in
/// equal parts. A new vertex has the vertices of the rims round it, by where it would be on plain
/// triangles between them without fairing, and one that was put on an edge the ends of the edge. A
/// new face has the face across the nearest edge of the rims (the first one of those as near), and at
/// its corners what old faces have there: those on its own side where it has an edge in common with
/// them.
pub struct gusset_origins(pub(crate) Origins);

handle! { gusset_origins }

/// The origins of the elements of one kind. Pointers are valid until the origins are destroyed.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_origins_view {
    /// sizeof(gusset_origins_view), set by the caller.
    pub struct_size: usize,
    /// One more than there are elements: element k has the entries offsets[k] to
    /// offsets[k + 1] - 1 of sources and weights; none if it comes from nothing.
    pub offsets: gusset_indices,
    /// The sources, numbered through all inputs.
    pub sources: gusset_indices,
    /// How much each source counts: more than 0, with the sum 1 for each element; as many as sources;
    /// NULL without any.
    pub weights: *const f64,
    /// One more than there are inputs: the elements of input i are the sources starts[i] to
    /// starts[i + 1] - 1. The inputs are the meshes, pieces or polylines in their order, the one mesh,
    /// net or sheet.
    pub starts: gusset_indices,
}

versioned! { gusset_origins_view: 64 }

/// Destroys origins; NULL is allowed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gusset_origins_destroy(origins: *mut gusset_origins) {
    handle::destroy(origins);
}

/// Lends the origins of the result's vertices, corners or faces, valid until they are destroyed.
///
/// @complexity O(1).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_origins_get_view(
    origins: *const gusset_origins,
    domain: gusset_domain,
    view: *mut gusset_origins_view,
) -> gusset_status {
    lend!(origins, view, |gusset_origins(of)| {
        let domain = choice(domain)?;
        let table = of.table(domain);
        gusset_origins_view {
            struct_size: 0,
            offsets: gusset_indices::lend(table.offsets()),
            sources: gusset_indices::lend(table.sources()),
            weights: lent(table.weights()),
            starts: gusset_indices::lend(of.starts(domain)),
        }
    })
}

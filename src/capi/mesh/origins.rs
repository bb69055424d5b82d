//! Origins: Sources of elements.

use crate::attributes::{Domain, Origins};
use crate::capi::context::lend;
use crate::capi::glue::{c_enum, versioned};
use crate::capi::handle::{self, handle};
use crate::capi::input::{lend_list, read_choice};
use crate::capi::mesh::gusset_indices;
use crate::capi::status::gusset_status;

/// Kind of element.
pub type gusset_domain = u32;
/// Vertices, points of polylines, nodes of nets and sheets.
pub const GUSSET_DOMAIN_VERTICES: gusset_domain = 0;
/// Corners of faces, in the order of face_corners; nodes of nets and sheets.
pub const GUSSET_DOMAIN_CORNERS: gusset_domain = 1;
/// Faces, cells of nets and sheets.
pub const GUSSET_DOMAIN_FACES: gusset_domain = 2;

c_enum! {
    domain: Domain {
        GUSSET_DOMAIN_VERTICES => Vertices,
        GUSSET_DOMAIN_CORNERS => Corners,
        GUSSET_DOMAIN_FACES => Faces,
    }
}

/// Sources of a result's elements.
///
/// - An old element has itself; a merged vertex all its vertices in equal parts.
/// - A new vertex has the rim vertices around it, by its place on plain triangles between them,
///   before fairing; on an edge, its ends.
/// - A new face has the face across the nearest rim edge (the first of equals). Its corners have
///   the old corners there, on its own side if it shares an edge with old faces.
pub struct gusset_origins(pub(crate) Origins);

handle! { gusset_origins }

/// Origins of the elements of one domain.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_origins_view {
    /// sizeof(gusset_origins_view).
    pub struct_size: usize,
    /// Element k has the sources and weights offsets[k] to offsets[k + 1] - 1, if any.
    pub offsets: gusset_indices,
    /// Sources, numbered through all inputs.
    pub sources: gusset_indices,
    /// Weight of each source, above 0, sum 1.
    /// @shape sources
    pub weights: *const f64,
    /// Input i has the sources starts[i] to starts[i + 1] - 1. Inputs are the meshes, pieces,
    /// polylines, net or sheet in order.
    pub starts: gusset_indices,
}

versioned! { gusset_origins_view: 64 }

/// Destroys origins.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gusset_origins_destroy(origins: *mut gusset_origins) {
    handle::destroy(origins);
}

/// Lends the origins of one domain.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_origins_get_view(
    origins: *const gusset_origins,
    domain: gusset_domain,
    view: *mut gusset_origins_view,
) -> gusset_status {
    lend!(origins, view, |gusset_origins(of)| {
        let domain = read_choice(domain)?;
        let table = of.table(domain);
        gusset_origins_view {
            struct_size: 0,
            offsets: gusset_indices::lend_indices(table.offsets()),
            sources: gusset_indices::lend_indices(table.source_indices()),
            weights: lend_list(table.weights()),
            starts: gusset_indices::lend_indices(of.first_sources_of_inputs(domain)),
        }
    })
}

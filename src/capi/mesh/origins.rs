//! C interface: where the elements of results come from.

use crate::attributes::{Domain, Origins};
use crate::capi::context::{create, gusset_context, lend};
use crate::capi::glue::{c_enum, versioned};
use crate::capi::handle::{self, handle};
use crate::capi::input::{choice, lent};
use crate::capi::mesh::assembly::gusset_assembly;
use crate::capi::mesh::develop::gusset_development;
use crate::capi::mesh::fill::gusset_fill;
use crate::capi::mesh::gusset_indices;
use crate::capi::mesh::orient::gusset_orient;
use crate::capi::mesh::sew::gusset_sew;
use crate::capi::mesh::stitch::gusset_stitch;
use crate::capi::mesh::strip::gusset_strip;
use crate::capi::mesh::weld::gusset_weld;
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

/// The origins of a stitched mesh, whose inputs are its one or two meshes.
///
/// @param context threads, progress, cancellation and error report; NULL for the defaults.
/// @param stitch the stitched mesh.
/// @param[out] origins receives the result, for gusset_origins_destroy; NULL on failure.
/// @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, TOO_LARGE, OUT_OF_MEMORY,
///     CANCELLED.
/// @complexity O(H log n) for H corners, n of them of new faces; 16 bytes for each vertex, corner and
///     face, and linear in n.
/// @since 0.1
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_stitch_origins_create(
    context: *const gusset_context,
    stitch: *const gusset_stitch,
    origins: *mut *mut gusset_origins,
) -> gusset_status {
    create(context, origins, "origins", |job| {
        Ok(gusset_origins(Origins::of_stitch(&handle::get(stitch, "stitch")?.0, job)?))
    })
}

/// The origins of a strip, whose inputs are its two polylines; they have no corners and faces, and
/// nor have its own any sources.
///
/// @param context threads, progress, cancellation and error report; NULL for the defaults.
/// @param strip the strip.
/// @param[out] origins receives the result, for gusset_origins_destroy; NULL on failure.
/// @return GUSSET_OK, or an error: those of gusset_stitch_origins_create.
/// @complexity As gusset_stitch_origins_create.
/// @since 0.1
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_strip_origins_create(
    context: *const gusset_context,
    strip: *const gusset_strip,
    origins: *mut *mut gusset_origins,
) -> gusset_status {
    create(context, origins, "origins", |job| {
        Ok(gusset_origins(Origins::of_ruled(&handle::get(strip, "strip")?.0, job)?))
    })
}

/// The origins of a mesh with holes filled.
///
/// @param context threads, progress, cancellation and error report; NULL for the defaults.
/// @param fill the mesh.
/// @param[out] origins receives the result, for gusset_origins_destroy; NULL on failure.
/// @return GUSSET_OK, or an error: those of gusset_stitch_origins_create.
/// @complexity As gusset_stitch_origins_create.
/// @since 0.1
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_fill_origins_create(
    context: *const gusset_context,
    fill: *const gusset_fill,
    origins: *mut *mut gusset_origins,
) -> gusset_status {
    create(context, origins, "origins", |job| {
        Ok(gusset_origins(Origins::of_filled(&handle::get(fill, "fill")?.filled, job)?))
    })
}

/// The origins of an assembly, whose inputs are its pieces.
///
/// @param context threads, progress, cancellation and error report; NULL for the defaults.
/// @param assembly the assembly.
/// @param[out] origins receives the result, for gusset_origins_destroy; NULL on failure.
/// @return GUSSET_OK, or an error: those of gusset_stitch_origins_create.
/// @complexity As gusset_stitch_origins_create.
/// @since 0.1
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_assembly_origins_create(
    context: *const gusset_context,
    assembly: *const gusset_assembly,
    origins: *mut *mut gusset_origins,
) -> gusset_status {
    create(context, origins, "origins", |job| {
        Ok(gusset_origins(Origins::of_assembly(&handle::get(assembly, "assembly")?.done, job)?))
    })
}

/// The origins of a welded mesh.
///
/// @param context threads, progress, cancellation and error report; NULL for the defaults.
/// @param weld the welded mesh.
/// @param[out] origins receives the result, for gusset_origins_destroy; NULL on failure.
/// @return GUSSET_OK, or an error: those of gusset_stitch_origins_create.
/// @complexity O(size); 16 bytes for each vertex, corner and face.
/// @since 0.1
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_weld_origins_create(
    context: *const gusset_context,
    weld: *const gusset_weld,
    origins: *mut *mut gusset_origins,
) -> gusset_status {
    create(context, origins, "origins", |job| Ok(gusset_origins(Origins::of_weld(&handle::get(weld, "weld")?.0, job)?)))
}

/// The origins of a sewn mesh. A corner that a face gained on an edge has the face's corners at both
/// ends of the edge.
///
/// @param context threads, progress, cancellation and error report; NULL for the defaults.
/// @param sew the sewn mesh.
/// @param[out] origins receives the result, for gusset_origins_destroy; NULL on failure.
/// @return GUSSET_OK, or an error: those of gusset_stitch_origins_create.
/// @complexity As gusset_weld_origins_create.
/// @since 0.1
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_sew_origins_create(
    context: *const gusset_context,
    sew: *const gusset_sew,
    origins: *mut *mut gusset_origins,
) -> gusset_status {
    create(context, origins, "origins", |job| Ok(gusset_origins(Origins::of_sew(&handle::get(sew, "sew")?.0, job)?)))
}

/// The origins of an oriented mesh.
///
/// @param context threads, progress, cancellation and error report; NULL for the defaults.
/// @param orient the oriented mesh.
/// @param[out] origins receives the result, for gusset_origins_destroy; NULL on failure.
/// @return GUSSET_OK, or an error: those of gusset_stitch_origins_create.
/// @complexity As gusset_weld_origins_create.
/// @since 0.1
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_orient_origins_create(
    context: *const gusset_context,
    orient: *const gusset_orient,
    origins: *mut *mut gusset_origins,
) -> gusset_status {
    create(context, origins, "origins", |job| {
        Ok(gusset_origins(Origins::of_oriented(&handle::get(orient, "orient")?.done, job)?))
    })
}

/// The origins of a development: each vertex comes from one, corners and faces are those of the
/// surface.
///
/// @param context threads, progress, cancellation and error report; NULL for the defaults.
/// @param development the development.
/// @param[out] origins receives the result, for gusset_origins_destroy; NULL on failure.
/// @return GUSSET_OK, or an error: those of gusset_stitch_origins_create.
/// @complexity As gusset_weld_origins_create.
/// @since 0.1
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_development_origins_create(
    context: *const gusset_context,
    development: *const gusset_development,
    origins: *mut *mut gusset_origins,
) -> gusset_status {
    create(context, origins, "origins", |job| {
        Ok(gusset_origins(Origins::of_developed(&handle::get(development, "development")?.done, job)?))
    })
}

/// Destroys origins; NULL is allowed.
///
/// @param[in,out] origins the handle; NULL is allowed.
/// @since 0.1
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gusset_origins_destroy(origins: *mut gusset_origins) {
    handle::destroy(origins);
}

/// Lends the origins of the result's vertices, corners or faces, valid until they are destroyed.
///
/// @param origins the origins.
/// @param domain GUSSET_DOMAIN_...
/// @param[out] view receives the view; struct_size is set by the caller.
/// @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE,
///     UNKNOWN_VALUE.
/// @complexity O(1).
/// @since 0.1
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

//! C interface: orientation.

use crate::attributes::KeepSplits;
use crate::capi::context::{create, gusset_context, lend};
use crate::capi::glue::{c_enum, versioned};
use crate::capi::handle::{self, handle};
use crate::capi::input::{self, choice, lent};
use crate::capi::mesh::{self, gusset_indices, gusset_mesh_view};
use crate::capi::status::gusset_status;
use crate::repair::orient::{Options, Oriented, Outward, orient};
use gusset_base::alloc;

/// Closed components face as most of their faces did; those of a stitch or of a filled mesh stay as
/// they are.
pub const GUSSET_OUTWARD_KEEP: u32 = 0;
/// Closed components face outwards, each by its own volume: of shells inside one another each one
/// encloses what is within it, and the wall of a cavity is turned over too. One whose volume is 0 up
/// to rounding is as with GUSSET_OUTWARD_KEEP. Of a stitch or of a filled mesh, components that are
/// closed (every edge has two faces), consistently oriented and inside out are turned over, each as
/// a whole; all others stay as they are.
pub const GUSSET_OUTWARD_CLOSED: u32 = 1;

/// An oriented mesh. Opaque and immutable; it keeps nothing of the mesh it was made from.
pub struct gusset_orient {
    pub(crate) done: Oriented,
    one_sided: [Vec<u32>; 2],
}

handle! { gusset_orient }

/// How to orient; all zero is the default.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_orient_options {
    /// sizeof(gusset_orient_options), set by the caller.
    pub struct_size: usize,
    /// GUSSET_OUTWARD_...
    pub outward: u32,
    /// 0.
    pub reserved: u32,
}

/// What was turned, and what could not be oriented. Pointers are valid until the handle is
/// destroyed.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_orient_view {
    /// sizeof(gusset_orient_view), set by the caller.
    pub struct_size: usize,
    /// Per face, 1 if it was turned over, else 0.
    pub turned: *const u8,
    /// The number of faces.
    pub face_count: usize,
    /// The smallest face of each component that cannot be oriented, ascending. Such components stay
    /// as they are.
    pub one_sided_faces: gusset_indices,
    /// For each of them, a half-edge of it at which two faces disagree when others agree.
    pub one_sided_half_edges: gusset_indices,
    /// The number of faces turned over.
    pub turned_faces: u32,
    /// Components: faces that hang together across edges of two faces. A degenerate face is one of
    /// its own.
    pub component_count: u32,
    /// Closed components that face outwards now and, with GUSSET_OUTWARD_KEEP, would not.
    pub inverted_components: u32,
    /// 0.
    pub reserved: u32,
}

versioned! { gusset_orient_options: 16 reserved, gusset_orient_view: 72 }

c_enum! { outward: Outward { GUSSET_OUTWARD_KEEP => Keep, GUSSET_OUTWARD_CLOSED => Closed } }

/// Turns faces over until faces that share an edge of two faces run it in opposite directions.
///
/// In each component as few faces as possible are turned; where both sides are as many, its
/// smallest face stays. Edges of three or more faces connect nothing. A component that cannot be
/// oriented, such as a Moebius strip, stays as it is and is listed. A turned face keeps its first
/// corner and has the others in reverse order; all else is as it was: vertices, positions, order of
/// faces.
///
/// @param context threads, progress, cancellation and error report; NULL for the defaults.
/// @param mesh the mesh.
/// @param options NULL for the defaults.
/// @param[out] orient receives the result, for gusset_orient_destroy; NULL on failure.
/// @return GUSSET_OK, or an error: those of gusset_mesh_view, UNKNOWN_VALUE, OUT_OF_MEMORY,
///     CANCELLED.
/// @complexity O(H log d) for H half-edges and at most d edges at a vertex; linear extra memory.
/// @since 0.1
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_orient_create(
    context: *const gusset_context,
    mesh: *const gusset_mesh_view,
    options: *const gusset_orient_options,
    orient: *mut *mut gusset_orient,
) -> gusset_status {
    create(context, orient, "orient", |job| {
        let options = Options { outward: choice(input::read(options, true, "options")?.outward)? };
        let given_mesh = mesh::mesh(mesh, 0, &job.part(0.0, 0.2))?;
        let mesh = given_mesh.view();
        let mut done = self::orient(&mesh, &options, &job.part(0.2, 0.9))?;
        done.keep_splits(&[&mesh], &job.part(0.9, 1.0))?;
        let one_sided = [
            alloc::collect(done.one_sided.iter().map(|found| found.face))?,
            alloc::collect(done.one_sided.iter().map(|found| found.half_edge))?,
        ];
        Ok(gusset_orient { done, one_sided })
    })
}

/// Destroys what gusset_orient_create made; NULL is allowed.
///
/// @param[in,out] orient the handle; NULL is allowed.
/// @since 0.1
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gusset_orient_destroy(orient: *mut gusset_orient) {
    handle::destroy(orient);
}

/// Lends the oriented mesh, valid until the handle is destroyed.
///
/// @param orient the oriented mesh.
/// @param[out] view receives the view; struct_size is set by the caller.
/// @return GUSSET_OK, or an error: NULL_ARGUMENT, MISALIGNED_ARGUMENT, BAD_STRUCT_SIZE.
/// @complexity O(1).
/// @since 0.1
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_orient_get_mesh(
    orient: *const gusset_orient,
    view: *mut gusset_mesh_view,
) -> gusset_status {
    lend!(orient, view, |orient| mesh::lend(&orient.done.mesh))
}

/// Lends the flags, lists and counts.
///
/// @param orient the oriented mesh.
/// @param[out] parts receives the parts; struct_size is set by the caller.
/// @return GUSSET_OK, or an error: those of gusset_orient_get_mesh.
/// @since 0.1
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_orient_get_view(
    orient: *const gusset_orient,
    parts: *mut gusset_orient_view,
) -> gusset_status {
    lend!(orient, parts, |gusset_orient { done, one_sided }| gusset_orient_view {
        struct_size: size_of::<gusset_orient_view>(),
        // A bool is one byte, 0 or 1.
        turned: lent(&done.turned).cast(),
        face_count: done.turned.len(),
        one_sided_faces: gusset_indices::lend(&one_sided[0]),
        one_sided_half_edges: gusset_indices::lend(&one_sided[1]),
        turned_faces: done.turned_faces,
        component_count: done.components,
        inverted_components: done.inverted_components,
        reserved: 0,
    })
}

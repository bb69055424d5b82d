//! Morphs: Interpolates between two nets.

use crate::capi::context::{create_handle, gusset_context};
use crate::capi::glue::c_enum;
use crate::capi::input::read_choice;
use crate::capi::net::{gusset_net, net_of_handle};
use crate::capi::status::gusset_status;
use crate::net::{MorphPath, morph};

/// Path of nodes from one net to another.
pub type gusset_morph_path = u32;
/// Straight.
pub const GUSSET_MORPH_LINEAR: gusset_morph_path = 0;
/// Uniform best-fitting rotation, straight in the rotating frame. Rigidly moved nets keep their
/// shape.
pub const GUSSET_MORPH_RIGID: gusset_morph_path = 1;

c_enum! { path: MorphPath { GUSSET_MORPH_LINEAR => Linear, GUSSET_MORPH_RIGID => Rigid } }

/// Interpolates between nets of equal rows, columns, scalar type and gluing.
///
/// Nodes with equal bits in both keep them. Bridges are as in first. A node missing in either is
/// missing.
///
/// @param t time, from 0 (bits of first) to 1 (bits of second).
/// @errors OUT_OF_RANGE (t), SIDES_DIFFER (another size; see gusset_net_copy_options),
///     MIXED_SCALARS, GLUINGS_DIFFER (node), ORIENTATION_CONFLICT (one net is reversed)
/// @complexity O(nodes).
/// @source Horn 1987, for the rotation.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_net_morph_create(
    context: *const gusset_context,
    first: *const gusset_net,
    second: *const gusset_net,
    t: f64,
    path: gusset_morph_path,
    between: *mut *mut gusset_net,
) -> gusset_status {
    create_handle(context, between, "between", |job| {
        Ok(gusset_net::new(morph(net_of_handle(first)?, net_of_handle(second)?, t, read_choice(path)?, job)?))
    })
}

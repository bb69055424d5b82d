//! Morphs: Nets between two nets.

use crate::capi::context::{create, gusset_context};
use crate::capi::glue::c_enum;
use crate::capi::input::choice;
use crate::capi::net::{gusset_net, read};
use crate::capi::status::gusset_status;
use crate::net::{MorphPath, morph};

/// The way of nodes from one net to another.
pub type gusset_morph_path = u32;
/// Straight.
pub const GUSSET_MORPH_LINEAR: gusset_morph_path = 0;
/// The rotation that fits best is done evenly; the rest goes straight in the frame that turns, so
/// that a net moved rigidly keeps its shape on the way.
pub const GUSSET_MORPH_RIGID: gusset_morph_path = 1;

c_enum! { path: MorphPath { GUSSET_MORPH_LINEAR => Linear, GUSSET_MORPH_RIGID => Rigid } }

/// Makes the net at a time on the way from one net to another of the same rows, columns, type and
/// gluing.
///
/// Two nodes that have the same bits as each other in both nets, as glued ones have, have the same
/// bits as each other in it. It is glued as the first, and has its bridges; a node missing in one
/// of them is missing between.
///
/// @param t the time, from 0 for the bits of the first to 1 for those of the second.
/// @errors UNKNOWN_VALUE (path), OUT_OF_RANGE (t), SIDES_DIFFER (other rows or columns: see
///     gusset_net_copy_options), MIXED_SCALARS, GLUINGS_DIFFER (with the node),
///     ORIENTATION_CONFLICT (one is reversed)
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
    create(context, between, "between", |job| {
        Ok(gusset_net::new(morph(read(first)?, read(second)?, t, choice(path)?, job)?))
    })
}

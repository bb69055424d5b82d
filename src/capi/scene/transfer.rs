//! Scenes as bytes: Encodes scenes with their nets, and decodes them.
//!
//! @source Deryagin, transfer of information in various systems.

use crate::capi::context::{create_handle, gusset_context};
use crate::capi::input;
use crate::capi::scene::{gusset_scene, scene_of_handle};
use crate::capi::status::gusset_status;
use crate::capi::stream::{gusset_stream, gusset_stream_options};
use crate::net::scene::{decode_scene_within, encode_scene};
use std::ffi::c_void;

/// Encodes a scene as a stream: entries with their indices, groups, transforms and visibility, and
/// each distinct net once.
///
/// @param options of gusset_net_encode_create, for each net.
/// @errors as gusset_net_encode_create
/// @complexity O(nodes + entries + children), parallel by blocks of nets.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_scene_encode_create(
    context: *const gusset_context,
    scene: *const gusset_scene,
    options: *const gusset_stream_options,
    stream: *mut *mut gusset_stream,
) -> gusset_status {
    create_handle(context, stream, "stream", |job| {
        let options = input::read_versioned_struct(options, true, "options")?.checked()?;
        Ok(gusset_stream(encode_scene(scene_of_handle(scene)?, &options, job)?))
    })
}

/// Decodes the stream of a scene. Entries keep their indices; shared nets stay shared.
///
/// Damaged and malicious streams do no harm: memory is at most 4096 nodes, or 96 KiB, a byte.
///
/// @param data the whole stream.
/// @param node_limit most nodes of all nets together; 0: no limit.
/// @errors BAD_STREAM (byte), TOO_LARGE
/// @complexity O(nodes + entries + children), parallel by blocks of nets.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_scene_decode_create(
    context: *const gusset_context,
    data: *const c_void,
    size: usize,
    node_limit: u64,
    scene: *mut *mut gusset_scene,
) -> gusset_status {
    create_handle(context, scene, "scene", |job| {
        let data = input::input_bytes(data, size, 1, "data")?;
        let limit = if node_limit == 0 { u64::MAX } else { node_limit };
        Ok(gusset_scene(decode_scene_within(data, limit, job)?))
    })
}

//! Streams: Encodes nets as bytes, and decodes them.

use crate::capi::context::{answer_into_struct, create_handle, guard_changing_call, gusset_context, lend};
use crate::capi::glue::{constants, versioned};
use crate::capi::handle::{self, handle};
use crate::capi::input::{self, Choice, lend_list, read_flag};
use crate::capi::mesh::gusset_scalar;
use crate::capi::net::{gusset_net, net_of_handle};
use crate::capi::status::{Failure, gusset_status};
use crate::net::MAX_NODES;
use crate::net::stream::{LevelBox, StreamDecoder, StreamInfo, StreamMode, StreamOptions, decode_within, encode};
use std::ffi::c_void;
use std::ptr;

/// Storage of coordinates in a stream.
pub type gusset_stream_mode = u32;
/// Compressed, rounded to a number of bits.
pub const GUSSET_STREAM_QUANTISED: gusset_stream_mode = 0;
/// Compressed bit for bit, including NaN.
pub const GUSSET_STREAM_LOSSLESS: gusset_stream_mode = 1;
/// Uncompressed little-endian matrices, aligned to 64 bytes.
pub const GUSSET_STREAM_RAW: gusset_stream_mode = 2;

/// Choice of the levels that coordinates are rounded to.
pub type gusset_stream_levels = u32;
/// Levels of the net's box, or a coarser step that its coordinates already have.
pub const GUSSET_LEVELS_AUTO: gusset_stream_levels = 0;
/// Levels of the box from low to high. Shared nodes of tiles with equal boxes stay equal.
pub const GUSSET_LEVELS_GIVEN: gusset_stream_levels = 1;

/// Options of gusset_net_encode_create and gusset_scene_encode_create.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_stream_options {
    /// sizeof(gusset_stream_options).
    pub struct_size: usize,
    /// Rows of each independent block; 0: about 2^17 nodes, or all for RAW.
    pub rows_per_block: usize,
    /// Storage of coordinates in a stream.
    pub mode: gusset_stream_mode,
    /// QUANTISED: bits of a coordinate, 8 to 24; 0: 14. Else 0.
    pub bits: u32,
    /// QUANTISED. 1: each axis has its own step; 0: the longest extent's. Else 0.
    /// @flag
    pub per_axis: u32,
    /// QUANTISED: choice of the levels. Else 0.
    pub levels: gusset_stream_levels,
    /// Smallest coordinates of all tiles: level 0.
    /// @when levels GUSSET_LEVELS_GIVEN
    pub low: [f64; 3],
    /// Largest coordinates of all tiles, at least low.
    /// @when levels GUSSET_LEVELS_GIVEN
    pub high: [f64; 3],
    /// Distance of levels on all axes, above 0; bits must be 0 and becomes the least number that
    /// spans the box. 0: follows from bits.
    /// @when levels GUSSET_LEVELS_GIVEN
    pub step: f64,
}

/// Header of a stream.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_stream_report {
    /// sizeof(gusset_stream_report).
    pub struct_size: usize,
    /// Node rows.
    pub rows: usize,
    /// Node columns.
    pub columns: usize,
    /// Rows of a block; the last may have fewer.
    pub rows_per_block: usize,
    /// Bytes before the first block.
    pub prelude_size: u64,
    /// QUANTISED: level 0; level k is at origin + k * step. Else 0.
    pub origin: [f64; 3],
    /// QUANTISED: distance of levels; errors are at most step / 2 and half a unit in the last
    /// place. Else 0.
    pub step: [f64; 3],
    /// Type of coordinates.
    pub scalar: gusset_scalar,
    /// Storage of coordinates in a stream.
    pub mode: gusset_stream_mode,
    /// QUANTISED: bits of a coordinate. Else 0.
    pub bits: u32,
    /// 0.
    pub reserved: u32,
}

/// Bytes of an encoded net or scene.
pub struct gusset_stream(pub(crate) Vec<u8>);

handle! { gusset_stream }

/// Bytes of a stream.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_stream_view {
    /// sizeof(gusset_stream_view).
    pub struct_size: usize,
    /// First byte.
    pub data: *const c_void,
    /// Bytes.
    pub size: usize,
}

/// Decoder of a stream in pieces.
pub struct gusset_stream_decoder(StreamDecoder);

handle! { gusset_stream_decoder }

versioned! { gusset_stream_options: 88, gusset_stream_report: 104, gusset_stream_view: 24 }

impl gusset_stream_options {
    pub(crate) fn checked(self) -> Result<StreamOptions, Failure> {
        let mode = match (self.mode, self.bits) {
            (GUSSET_STREAM_QUANTISED, 0) => StreamMode::Quantised { bits: 14 },
            (GUSSET_STREAM_QUANTISED, bits) => StreamMode::Quantised { bits },
            (GUSSET_STREAM_LOSSLESS, 0) => StreamMode::Lossless,
            (GUSSET_STREAM_RAW, 0) => StreamMode::Raw,
            (GUSSET_STREAM_LOSSLESS | GUSSET_STREAM_RAW, bits) => {
                return Err(Failure::unknown_value("bits", bits.into(), "0 unless coordinates are quantised"));
            }
            (other, _) => {
                return Err(Failure::unknown_choice(
                    "mode",
                    other,
                    &constants![GUSSET_STREAM_QUANTISED, GUSSET_STREAM_LOSSLESS, GUSSET_STREAM_RAW],
                ));
            }
        };
        let per_axis = read_flag(self.per_axis, "per_axis")?;
        if per_axis && !matches!(mode, StreamMode::Quantised { .. }) {
            let allowed = "0 unless coordinates are quantised";
            return Err(Failure::unknown_value("per_axis", self.per_axis.into(), allowed));
        }
        let levels = match self.levels {
            GUSSET_LEVELS_AUTO => None,
            GUSSET_LEVELS_GIVEN if matches!(mode, StreamMode::Quantised { .. }) => {
                let step = (self.step != 0.0).then_some(self.step);
                if step.is_some() && self.bits != 0 {
                    return Err(Failure::unknown_value("bits", self.bits.into(), "0 beside a step"));
                }
                if step.is_some() && per_axis {
                    return Err(Failure::unknown_value("per_axis", self.per_axis.into(), "0 beside a step"));
                }
                Some(LevelBox { low: self.low, high: self.high, step })
            }
            other => {
                return Err(Failure::unknown_choice(
                    "levels",
                    other,
                    &constants![GUSSET_LEVELS_AUTO, GUSSET_LEVELS_GIVEN],
                ));
            }
        };
        Ok(StreamOptions { mode, per_axis, rows_per_block: self.rows_per_block, levels })
    }
}

/// Encodes a net as a stream: coordinates, gluing and bridges.
///
/// - QUANTISED and LOSSLESS store one node of each glued point, which decoding repeats; LOSSLESS
///   stores all if bits differ.
/// - QUANTISED replaces missing nodes by three NaN.
///
/// @errors OUT_OF_RANGE (bits; QUANTISED: a coordinate above a quarter of DBL_MAX; low, high or
///     step; a node outside the box)
/// @complexity O(nodes), parallel by blocks.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_net_encode_create(
    context: *const gusset_context,
    net: *const gusset_net,
    options: *const gusset_stream_options,
    stream: *mut *mut gusset_stream,
) -> gusset_status {
    create_handle(context, stream, "stream", |job| {
        let options = input::read_versioned_struct(options, true, "options")?.checked()?;
        Ok(gusset_stream(encode(net_of_handle(net)?, &options, job)?))
    })
}

/// Lends the bytes.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_stream_get_view(
    stream: *const gusset_stream,
    view: *mut gusset_stream_view,
) -> gusset_status {
    lend!(stream, view, |gusset_stream(bytes)| gusset_stream_view {
        struct_size: 0,
        data: lend_list(bytes).cast(),
        size: bytes.len(),
    })
}

/// Destroys a stream.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gusset_stream_destroy(stream: *mut gusset_stream) {
    handle::destroy(stream);
}

/// Reads the header of a stream.
///
/// @param data the first 128 bytes or more.
/// @errors BAD_STREAM (byte)
/// @complexity O(1).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_stream_inspect(
    context: *const gusset_context,
    data: *const c_void,
    size: usize,
    report: *mut gusset_stream_report,
) -> gusset_status {
    answer_into_struct(context, (report, "report"), |_| {
        let info = StreamInfo::read(input::input_bytes(data, size, 1, "data")?)?;
        let (mode, bits) = match info.mode {
            StreamMode::Quantised { bits } => (GUSSET_STREAM_QUANTISED, bits),
            StreamMode::Lossless => (GUSSET_STREAM_LOSSLESS, 0),
            StreamMode::Raw => (GUSSET_STREAM_RAW, 0),
        };
        Ok(gusset_stream_report {
            struct_size: 0,
            rows: info.shape.rows(),
            columns: info.shape.columns(),
            rows_per_block: info.rows_per_block,
            prelude_size: info.prelude_size,
            origin: info.origin,
            step: info.step,
            scalar: info.scalar.number(),
            mode,
            bits,
            reserved: 0,
        })
    })
}

/// Decodes a stream to a net.
///
/// Damaged and malicious streams do no harm: memory is at most 4096 nodes, or 96 KiB, a byte.
///
/// @param data the whole stream.
/// @param node_limit most nodes, checked before allocation; 0: no limit.
/// @errors BAD_STREAM (byte), TOO_LARGE
/// @complexity O(nodes), parallel by blocks.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_net_decode_create(
    context: *const gusset_context,
    data: *const c_void,
    size: usize,
    node_limit: u64,
    net: *mut *mut gusset_net,
) -> gusset_status {
    create_handle(context, net, "net", |job| {
        let data = input::input_bytes(data, size, 1, "data")?;
        let limit = if node_limit == 0 { u64::MAX } else { node_limit };
        Ok(gusset_net::new(decode_within(data, limit, job)?))
    })
}

/// Makes a decoder.
///
/// @param node_limit most nodes; 0: INT32_MAX. Memory is allocated before the stream is complete.
/// @complexity O(1).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_stream_decoder_create(
    context: *const gusset_context,
    node_limit: u64,
    decoder: *mut *mut gusset_stream_decoder,
) -> gusset_status {
    create_handle(context, decoder, "decoder", |_| {
        let limit = if node_limit == 0 { MAX_NODES } else { node_limit };
        Ok(gusset_stream_decoder(StreamDecoder::new(limit)))
    })
}

/// Passes the next bytes to a decoder.
///
/// After OUT_OF_MEMORY the decoder is unchanged; other errors are final, and further calls return
/// them.
///
/// @param data any number of bytes.
/// @param rows_done receives the count of complete rows, or NULL.
/// @errors BAD_STREAM (byte), TOO_LARGE
/// @complexity O(bytes + nodes of completed blocks).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_stream_decoder_push(
    context: *const gusset_context,
    decoder: *mut gusset_stream_decoder,
    data: *const c_void,
    size: usize,
    rows_done: *mut usize,
) -> gusset_status {
    let rows_done = input::cleared_optional_output(rows_done, 0, "rows_done");
    guard_changing_call(context, |_| {
        let rows_done = rows_done?;
        let decoder = handle::get_object_mut(decoder, "decoder")?;
        input::set_optional_output(rows_done, decoder.0.decode_next_bytes(input::input_bytes(data, size, 1, "data")?)?);
        Ok(())
    })
}

/// Makes a net of the complete rows, without gluing and bridges.
///
/// @errors NET_TOO_SMALL (fewer than two complete rows)
/// @complexity O(nodes).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_stream_decoder_preview_create(
    context: *const gusset_context,
    decoder: *const gusset_stream_decoder,
    net: *mut *mut gusset_net,
) -> gusset_status {
    create_handle(context, net, "net", |job| {
        Ok(gusset_net::new(handle::get_object(decoder, "decoder")?.0.net_of_complete_rows(job)?))
    })
}

/// Makes the net of a complete stream, and resets the decoder.
///
/// @errors BAD_STREAM (incomplete), as gusset_stream_decoder_push
/// @complexity O(1).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_stream_decoder_finish_create(
    context: *const gusset_context,
    decoder: *mut gusset_stream_decoder,
    net: *mut *mut gusset_net,
) -> gusset_status {
    let slot = input::cleared_output(net, ptr::null_mut(), "net");
    guard_changing_call(context, |job| {
        let (slot, decoder) = (slot?, handle::get_object_mut(decoder, "decoder")?);
        job.finish()?;
        *slot = handle::into_handle(handle::box_with_kind(gusset_net::new(decoder.0.finish()?)));
        Ok(())
    })
}

/// Destroys a decoder.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gusset_stream_decoder_destroy(decoder: *mut gusset_stream_decoder) {
    handle::destroy(decoder);
}

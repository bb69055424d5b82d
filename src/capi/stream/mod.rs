//! Streams: Nets as bytes.

use crate::capi::context::{answer_struct, create, guard_change, gusset_context, lend};
use crate::capi::glue::versioned;
use crate::capi::handle::{self, handle};
use crate::capi::input::{self, Choice, flag, lent};
use crate::capi::mesh::gusset_scalar;
use crate::capi::net::{gusset_net, read};
use crate::capi::status::{Failure, gusset_status};
use crate::net::MAX_NODES;
use crate::net::stream::{Mode, StreamDecoder, StreamInfo, StreamOptions, decode_within, encode};
use std::ffi::c_void;
use std::ptr;

/// How a stream stores coordinates.
pub type gusset_stream_mode = u32;
/// Rounded to some number of bits, and compressed.
pub const GUSSET_STREAM_QUANTISED: gusset_stream_mode = 0;
/// Compressed, bit for bit, NaN too.
pub const GUSSET_STREAM_LOSSLESS: gusset_stream_mode = 1;
/// As they are: little-endian matrices that begin at multiples of 64 bytes, for files that are
/// mapped into memory.
pub const GUSSET_STREAM_RAW: gusset_stream_mode = 2;

/// How a net is to be stored.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_stream_options {
    /// sizeof(gusset_stream_options), set by the caller.
    pub struct_size: usize,
    /// Rows in a block, which is coded without knowledge of other blocks; 0 for about 2^17 nodes in
    /// each, and for one block of all rows if the mode is RAW.
    pub rows_per_block: usize,
    /// How coordinates are stored.
    pub mode: gusset_stream_mode,
    /// For QUANTISED, the bits of a coordinate, 8 to 24; 0 for 14. Else 0.
    pub bits: u32,
    /// For QUANTISED: 1 if the step of each axis follows from its own extent, 0 if that of all
    /// follows from the longest. Else 0.
    pub per_axis: u32,
    /// 0.
    pub reserved: u32,
}

/// What the first bytes of a stream say.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_stream_report {
    /// sizeof(gusset_stream_report), set by the caller.
    pub struct_size: usize,
    /// The rows of nodes.
    pub rows: usize,
    /// The columns of nodes.
    pub columns: usize,
    /// Rows in each block; the last one may have fewer.
    pub rows_per_block: usize,
    /// The bytes before the first block.
    pub prelude_size: u64,
    /// QUANTISED: the coordinates of level 0; a coordinate of level k is origin + k * step. Else 0.
    pub origin: [f64; 3],
    /// QUANTISED: the distance of levels. No coordinate is off by more than half of it and, as it
    /// is rounded to its type, half a unit in its last place. Else 0.
    pub step: [f64; 3],
    /// The type of coordinates.
    pub scalar: gusset_scalar,
    /// How coordinates are stored.
    pub mode: gusset_stream_mode,
    /// QUANTISED: the bits of a coordinate. Else 0.
    pub bits: u32,
    /// 0.
    pub reserved: u32,
}

/// The bytes of a stream. Opaque and immutable; may be used from many threads.
pub struct gusset_stream(Vec<u8>);

handle! { gusset_stream }

/// The bytes of a stream, lent: valid until gusset_stream_destroy.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_stream_view {
    /// sizeof(gusset_stream_view), set by the caller.
    pub struct_size: usize,
    /// The first byte.
    pub data: *const c_void,
    /// The number of bytes.
    pub size: usize,
}

/// A stream that is decoded while it arrives. Opaque; used by one thread at a time.
pub struct gusset_stream_decoder(StreamDecoder);

handle! { gusset_stream_decoder }

versioned! { gusset_stream_options: 32 reserved, gusset_stream_report: 104, gusset_stream_view: 24 }

impl gusset_stream_options {
    fn checked(self) -> Result<StreamOptions, Failure> {
        let mode = match (self.mode, self.bits) {
            (GUSSET_STREAM_QUANTISED, 0) => Mode::Quantised { bits: 14 },
            (GUSSET_STREAM_QUANTISED, bits) => Mode::Quantised { bits },
            (GUSSET_STREAM_LOSSLESS, 0) => Mode::Lossless,
            (GUSSET_STREAM_RAW, 0) => Mode::Raw,
            (GUSSET_STREAM_LOSSLESS | GUSSET_STREAM_RAW, bits) => return Err(Failure::unknown("bits", bits.into())),
            (other, _) => return Err(Failure::unknown("mode", other.into())),
        };
        let per_axis = flag(self.per_axis, "per_axis")?;
        if per_axis && !matches!(mode, Mode::Quantised { .. }) {
            return Err(Failure::unknown("per_axis", self.per_axis.into()));
        }
        Ok(StreamOptions { mode, per_axis, rows_per_block: self.rows_per_block })
    }
}

/// Makes a stream of a net: its coordinates, what is glued to what, its bridges.
///
/// QUANTISED and LOSSLESS do not store nodes that are glued to others; decoding gives them the same
/// bits (LOSSLESS stores all if the net's differ). QUANTISED gives nodes with a coordinate that is
/// NaN or infinite three NaN. Method: linear prediction with weights fitted to each block, and a
/// range coder with adaptive models.
///
/// @param options NULL for 14 bits a coordinate.
/// @errors OUT_OF_RANGE (bits; QUANTISED: a coordinate above a quarter of the largest double)
/// @complexity O(nodes), with blocks coded by the context's threads; the same bytes for any number
///     of them.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_net_encode_create(
    context: *const gusset_context,
    net: *const gusset_net,
    options: *const gusset_stream_options,
    stream: *mut *mut gusset_stream,
) -> gusset_status {
    create(context, stream, "stream", |job| {
        let options = input::read(options, true, "options")?.checked()?;
        Ok(gusset_stream(encode(read(net)?, &options, job)?))
    })
}

/// Lends the bytes of a stream.
///
/// @complexity O(1).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_stream_get_view(
    stream: *const gusset_stream,
    view: *mut gusset_stream_view,
) -> gusset_status {
    lend!(stream, view, |gusset_stream(bytes)| gusset_stream_view {
        struct_size: 0,
        data: lent(bytes).cast(),
        size: bytes.len(),
    })
}

/// Destroys a stream; NULL is allowed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gusset_stream_destroy(stream: *mut gusset_stream) {
    handle::destroy(stream);
}

/// Reads the header of a stream.
///
/// @param data its first 128 bytes, or more.
/// @param size how many there are.
/// @param report its struct_size set.
/// @errors BAD_STREAM (with the byte)
/// @complexity O(1).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_stream_inspect(
    context: *const gusset_context,
    data: *const c_void,
    size: usize,
    report: *mut gusset_stream_report,
) -> gusset_status {
    answer_struct(context, (report, "report"), |_| {
        let info = StreamInfo::read(input::bytes(data, size, 1, "data")?)?;
        let (mode, bits) = match info.mode {
            Mode::Quantised { bits } => (GUSSET_STREAM_QUANTISED, bits),
            Mode::Lossless => (GUSSET_STREAM_LOSSLESS, 0),
            Mode::Raw => (GUSSET_STREAM_RAW, 0),
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

/// Makes the net of a stream.
///
/// A stream that is damaged, cut off or forged does no harm; memory is asked for only as far as one
/// of its size can need it: 4096 nodes a byte at most. That is little of a file of one's own, and may
/// be much of a stranger's: 96 KiB a byte.
///
/// @param data all its bytes, at any alignment.
/// @param size how many.
/// @param node_limit a net of more nodes is refused before memory is asked for; 0 for no other
///     limit than that by the size.
/// @errors BAD_STREAM (with the byte), TOO_LARGE
/// @complexity O(nodes), with blocks decoded by the context's threads.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_net_decode_create(
    context: *const gusset_context,
    data: *const c_void,
    size: usize,
    node_limit: u64,
    net: *mut *mut gusset_net,
) -> gusset_status {
    create(context, net, "net", |job| {
        let data = input::bytes(data, size, 1, "data")?;
        let limit = if node_limit == 0 { u64::MAX } else { node_limit };
        Ok(gusset_net::new(decode_within(data, limit, job)?))
    })
}

/// Begins to decode a stream that arrives in pieces.
///
/// @param node_limit a net of more nodes is refused, as its memory is taken before all of the
///     stream is there; 0 for no limit but the library's, 2^31 - 1.
/// @complexity O(1).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_stream_decoder_create(
    context: *const gusset_context,
    node_limit: u64,
    decoder: *mut *mut gusset_stream_decoder,
) -> gusset_status {
    create(context, decoder, "decoder", |_| {
        let limit = if node_limit == 0 { MAX_NODES } else { node_limit };
        Ok(gusset_stream_decoder(StreamDecoder::new(limit)))
    })
}

/// Gives a decoder the next bytes of its stream, any number of them.
///
/// After a failure every call fails alike, but OUT_OF_MEMORY leaves the decoder as it was.
///
/// @param data the bytes, at any alignment.
/// @param size how many.
/// @param rows_done receives how many rows are complete, those of all blocks so far; NULL if it is
///     not wanted.
/// @errors BAD_STREAM (with the byte), TOO_LARGE
/// @complexity O(bytes + nodes of the blocks that they complete).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_stream_decoder_push(
    context: *const gusset_context,
    decoder: *mut gusset_stream_decoder,
    data: *const c_void,
    size: usize,
    rows_done: *mut usize,
) -> gusset_status {
    let rows_done = input::optional_output(rows_done, 0, "rows_done");
    guard_change(context, |_| {
        let rows_done = rows_done?;
        let decoder = handle::get_mut(decoder, "decoder")?;
        input::set(rows_done, decoder.0.push(input::bytes(data, size, 1, "data")?)?);
        Ok(())
    })
}

/// Makes the net of the rows that a decoder has so far, at least two: open on all sides, without
/// gluing and bridges, for a preview.
///
/// @errors NET_TOO_SMALL (if there are fewer rows)
/// @complexity O(nodes).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_stream_decoder_preview_create(
    context: *const gusset_context,
    decoder: *const gusset_stream_decoder,
    net: *mut *mut gusset_net,
) -> gusset_status {
    create(context, net, "net", |job| Ok(gusset_net::new(handle::get(decoder, "decoder")?.0.preview(job)?)))
}

/// Makes the net of a decoder whose stream is complete, and leaves the decoder empty, as if nothing
/// had been pushed.
///
/// @errors BAD_STREAM (if the stream is not complete, what pushing failed with)
/// @complexity O(1).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_stream_decoder_finish_create(
    context: *const gusset_context,
    decoder: *mut gusset_stream_decoder,
    net: *mut *mut gusset_net,
) -> gusset_status {
    let slot = input::output(net, ptr::null_mut(), "net");
    guard_change(context, |job| {
        let (slot, decoder) = (slot?, handle::get_mut(decoder, "decoder")?);
        job.memory()?;
        *slot = handle::give(handle::boxed(gusset_net::new(decoder.0.finish()?)));
        Ok(())
    })
}

/// Destroys a decoder; NULL is allowed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gusset_stream_decoder_destroy(decoder: *mut gusset_stream_decoder) {
    handle::destroy(decoder);
}

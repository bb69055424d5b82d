/* Generated from src/capi; see gusset.h. */

#ifndef GUSSET_STREAM_H
#define GUSSET_STREAM_H
#include "base.h"
#include "mesh.h"
#include "net.h"

#ifdef __cplusplus
extern "C" {
#endif

/*** Streams */

/// Storage of coordinates in a stream.
typedef uint32_t gusset_stream_mode;
/// Compressed, rounded to a number of bits.
#define GUSSET_STREAM_QUANTISED 0
/// Compressed bit for bit, including NaN.
#define GUSSET_STREAM_LOSSLESS 1
/// Uncompressed little-endian matrices, aligned to 64 bytes.
#define GUSSET_STREAM_RAW 2

/// Choice of the levels that coordinates are rounded to.
typedef uint32_t gusset_stream_levels;
/// Levels of the net's box, or a coarser step that its coordinates already have.
#define GUSSET_LEVELS_AUTO 0
/// Levels of the box from low to high. Shared nodes of tiles with equal boxes stay equal.
#define GUSSET_LEVELS_GIVEN 1

typedef struct gusset_stream_options {
    size_t struct_size;
    /// Rows of each independent block; 0: about 2^17 nodes, or all for RAW.
    size_t rows_per_block;
    gusset_stream_mode mode;
    /// QUANTISED: bits of a coordinate, 8 to 24; 0: 14. Else 0.
    uint32_t bits;
    /// QUANTISED. 1: each axis has its own step; 0: the longest extent's. Else 0.
    uint32_t per_axis;
    /// QUANTISED: choice of the levels. Else 0.
    gusset_stream_levels levels;
    /// Smallest coordinates of all tiles: level 0.
    /// @when levels GUSSET_LEVELS_GIVEN
    double low[3];
    /// Largest coordinates of all tiles, at least low.
    /// @when levels GUSSET_LEVELS_GIVEN
    double high[3];
    /// Distance of levels on all axes, above 0; bits must be 0 and becomes the least number that spans the box. 0:
    /// follows from bits.
    /// @when levels GUSSET_LEVELS_GIVEN
    double step;
} gusset_stream_options;

/// Header of a stream.
typedef struct gusset_stream_report {
    size_t struct_size;
    /// Node rows.
    size_t rows;
    /// Node columns.
    size_t columns;
    /// Rows of a block; the last may have fewer.
    size_t rows_per_block;
    /// Bytes before the first block.
    uint64_t prelude_size;
    /// QUANTISED: level 0; level k is at origin + k * step. Else 0.
    double origin[3];
    /// QUANTISED: distance of levels; errors are at most step / 2 and half a unit in the last place. Else 0.
    double step[3];
    gusset_scalar scalar;
    gusset_stream_mode mode;
    /// QUANTISED: bits of a coordinate. Else 0.
    uint32_t bits;
    uint32_t reserved;
} gusset_stream_report;

/// Bytes of an encoded net or scene.
typedef struct gusset_stream gusset_stream;

/// Bytes of a stream.
typedef struct gusset_stream_view {
    size_t struct_size;
    /// First byte.
    const void *data;
    /// Bytes.
    size_t size;
} gusset_stream_view;

/// Decoder of a stream in pieces.
typedef struct gusset_stream_decoder gusset_stream_decoder;

/// Encodes a net as a stream: coordinates, gluing and bridges.
/// - QUANTISED and LOSSLESS store one node of each glued point, which decoding repeats; LOSSLESS stores all if bits
///   differ.
/// - QUANTISED replaces missing nodes by three NaN.
/// @errors OUT_OF_RANGE (bits; QUANTISED: a coordinate above a quarter of DBL_MAX; low, high or step; a node outside
///     the box)
/// @complexity O(nodes), parallel by blocks.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_encode_create(const struct gusset_context *context,
    const struct gusset_net *net, const struct gusset_stream_options *options, struct gusset_stream **stream);

GUSSET_API GUSSET_MUST_USE gusset_status gusset_stream_get_view(const struct gusset_stream *stream,
    struct gusset_stream_view *view);

GUSSET_API void gusset_stream_destroy(struct gusset_stream *stream);

/// Reads the header of a stream.
/// @param data the first 128 bytes or more.
/// @errors BAD_STREAM (byte)
GUSSET_API GUSSET_MUST_USE gusset_status gusset_stream_inspect(const struct gusset_context *context, const void *data,
    size_t size, struct gusset_stream_report *report);

/// Decodes a stream to a net.
/// Damaged and malicious streams do no harm: memory is at most 4096 nodes, or 96 KiB, a byte.
/// @param data the whole stream.
/// @param node_limit most nodes, checked before allocation; 0: no limit.
/// @errors BAD_STREAM (byte)
/// @complexity O(nodes), parallel by blocks.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_decode_create(const struct gusset_context *context,
    const void *data, size_t size, uint64_t node_limit, struct gusset_net **net);

/// Makes a decoder.
/// @param node_limit most nodes; 0: INT32_MAX. Memory is allocated before the stream is complete.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_stream_decoder_create(const struct gusset_context *context,
    uint64_t node_limit, struct gusset_stream_decoder **decoder);

/// Passes the next bytes to a decoder.
/// After OUT_OF_MEMORY the decoder is unchanged; other errors are final, and further calls return them.
/// @param data any number of bytes.
/// @param rows_done count of complete rows, or NULL.
/// @errors BAD_STREAM (byte)
/// @complexity O(bytes + nodes of completed blocks).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_stream_decoder_push(const struct gusset_context *context,
    struct gusset_stream_decoder *decoder, const void *data, size_t size, size_t *rows_done);

/// Makes a net of the complete rows, without gluing and bridges.
/// @errors NET_TOO_SMALL (fewer than two complete rows)
/// @complexity O(nodes).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_stream_decoder_preview_create(const struct gusset_context *context,
    const struct gusset_stream_decoder *decoder, struct gusset_net **net);

/// Makes the net of a complete stream, and resets the decoder.
/// @errors BAD_STREAM (incomplete), as gusset_stream_decoder_push
GUSSET_API GUSSET_MUST_USE gusset_status gusset_stream_decoder_finish_create(const struct gusset_context *context,
    struct gusset_stream_decoder *decoder, struct gusset_net **net);

GUSSET_API void gusset_stream_decoder_destroy(struct gusset_stream_decoder *decoder);

#ifdef __cplusplus
}
#endif
#endif

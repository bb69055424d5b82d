/* Generated from src/capi; do not edit. See gusset.h. */

#ifndef GUSSET_STREAM_H
#define GUSSET_STREAM_H

#include "base.h"
#include "mesh.h"
#include "net.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ------------------------------------------------------------------------------------------------------------------ */
/* Streams: Nets as bytes. */

/// How a stream stores coordinates.
typedef uint32_t gusset_stream_mode;
/// Rounded to some number of bits, and compressed.
#define GUSSET_STREAM_QUANTISED 0
/// Compressed, bit for bit, NaN too.
#define GUSSET_STREAM_LOSSLESS 1
/// As they are: little-endian matrices that begin at multiples of 64 bytes, for files that are mapped into memory.
#define GUSSET_STREAM_RAW 2

/// How a net is to be stored.
typedef struct gusset_stream_options {
    size_t struct_size;
    /// Rows in a block, which is coded without knowledge of other blocks; 0 for about 2^17 nodes in each, and for one
    /// block of all rows if the mode is RAW.
    size_t rows_per_block;
    /// How coordinates are stored.
    gusset_stream_mode mode;
    /// For QUANTISED, the bits of a coordinate, 8 to 24; 0 for 14. Else 0.
    uint32_t bits;
    /// For QUANTISED: 1 if the step of each axis follows from its own extent, 0 if that of all follows from the
    /// longest. Else 0.
    uint32_t per_axis;
    uint32_t reserved;
} gusset_stream_options;

/// What the first bytes of a stream say.
typedef struct gusset_stream_report {
    size_t struct_size;
    /// The rows of nodes.
    size_t rows;
    /// The columns of nodes.
    size_t columns;
    /// Rows in each block; the last one may have fewer.
    size_t rows_per_block;
    /// The bytes before the first block.
    uint64_t prelude_size;
    /// QUANTISED: the coordinates of level 0; a coordinate of level k is origin + k * step. Else 0.
    double origin[3];
    /// QUANTISED: the distance of levels. No coordinate is off by more than half of it and, as it is rounded to its
    /// type, half a unit in its last place. Else 0.
    double step[3];
    gusset_scalar scalar;
    /// How coordinates are stored.
    gusset_stream_mode mode;
    /// QUANTISED: the bits of a coordinate. Else 0.
    uint32_t bits;
    uint32_t reserved;
} gusset_stream_report;

/// The bytes of a stream. Opaque and immutable; may be used from many threads.
typedef struct gusset_stream gusset_stream;

/// The bytes of a stream, lent: valid until gusset_stream_destroy.
typedef struct gusset_stream_view {
    size_t struct_size;
    /// The first byte.
    const void *data;
    /// The number of bytes.
    size_t size;
} gusset_stream_view;

/// A stream that is decoded while it arrives. Opaque; used by one thread at a time.
typedef struct gusset_stream_decoder gusset_stream_decoder;

/// Makes a stream of a net: its coordinates, what is glued to what, its bridges. QUANTISED and LOSSLESS do not store
/// nodes that are glued to others; decoding gives them the same bits (LOSSLESS stores all if the net's differ).
/// QUANTISED gives nodes with a coordinate that is NaN or infinite three NaN. Method: linear prediction with weights
/// fitted to each block, and a range coder with adaptive models.
/// @param options NULL for 14 bits a coordinate.
/// @errors OUT_OF_RANGE (bits; QUANTISED: a coordinate above a quarter of the largest double)
/// @complexity O(nodes), with blocks coded by the context's threads; the same bytes for any number of them.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_encode_create(const struct gusset_context *context,
    const struct gusset_net *net, const struct gusset_stream_options *options, struct gusset_stream **stream);

/// Lends the bytes of a stream.
/// @complexity O(1).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_stream_get_view(const struct gusset_stream *stream,
    struct gusset_stream_view *view);

/// Destroys a stream; NULL is allowed.
GUSSET_API void gusset_stream_destroy(struct gusset_stream *stream);

/// Reads the header of a stream.
/// @param data its first 128 bytes, or more.
/// @param size how many there are.
/// @param report its struct_size set.
/// @errors BAD_STREAM (with the byte)
/// @complexity O(1).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_stream_inspect(const struct gusset_context *context, const void *data,
    size_t size, struct gusset_stream_report *report);

/// Makes the net of a stream. A stream that is damaged, cut off or forged does no harm; memory is asked for only as far
/// as one of its size can need it: 4096 nodes a byte at most. That is little of a file of one's own, and may be much of
/// a stranger's: 96 KiB a byte.
/// @param data all its bytes, at any alignment.
/// @param size how many.
/// @param node_limit a net of more nodes is refused before memory is asked for; 0 for no other limit than that by the
///     size.
/// @errors BAD_STREAM (with the byte), TOO_LARGE
/// @complexity O(nodes), with blocks decoded by the context's threads.
GUSSET_API GUSSET_MUST_USE gusset_status gusset_net_decode_create(const struct gusset_context *context,
    const void *data, size_t size, uint64_t node_limit, struct gusset_net **net);

/// Begins to decode a stream that arrives in pieces.
/// @param node_limit a net of more nodes is refused, as its memory is taken before all of the stream is there; 0 for no
///     limit but the library's, 2^31 - 1.
/// @complexity O(1).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_stream_decoder_create(const struct gusset_context *context,
    uint64_t node_limit, struct gusset_stream_decoder **decoder);

/// Gives a decoder the next bytes of its stream, any number of them. After a failure every call fails alike, but
/// OUT_OF_MEMORY leaves the decoder as it was.
/// @param data the bytes, at any alignment.
/// @param size how many.
/// @param rows_done receives how many rows are complete, those of all blocks so far; NULL if it is not wanted.
/// @errors BAD_STREAM (with the byte), TOO_LARGE
/// @complexity O(bytes + nodes of the blocks that they complete).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_stream_decoder_push(const struct gusset_context *context,
    struct gusset_stream_decoder *decoder, const void *data, size_t size, size_t *rows_done);

/// Makes the net of the rows that a decoder has so far, at least two: open on all sides, without gluing and bridges,
/// for a preview.
/// @errors NET_TOO_SMALL (if there are fewer rows)
/// @complexity O(nodes).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_stream_decoder_preview_create(const struct gusset_context *context,
    const struct gusset_stream_decoder *decoder, struct gusset_net **net);

/// Makes the net of a decoder whose stream is complete, and leaves the decoder empty, as if nothing had been pushed.
/// @errors BAD_STREAM (if the stream is not complete, what pushing failed with)
/// @complexity O(1).
GUSSET_API GUSSET_MUST_USE gusset_status gusset_stream_decoder_finish_create(const struct gusset_context *context,
    struct gusset_stream_decoder *decoder, struct gusset_net **net);

/// Destroys a decoder; NULL is allowed.
GUSSET_API void gusset_stream_decoder_destroy(struct gusset_stream_decoder *decoder);

#ifdef __cplusplus
}
#endif

#endif /* GUSSET_STREAM_H */

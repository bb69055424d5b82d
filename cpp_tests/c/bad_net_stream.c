/* Streams of nets: every function, rightly and wrongly. */
#include "check.h"
#include <math.h>
#include <stdlib.h>

enum { ROWS = 9, COLUMNS = 7 };
static float x[ROWS * COLUMNS], y[ROWS * COLUMNS], z[ROWS * COLUMNS];
static gusset_context *context;

static gusset_net *sheet(void) {
    gusset_net_view arrays;
    gusset_net *net = NULL;
    int k;
    for (k = 0; k < ROWS * COLUMNS; ++k) {
        x[k] = (float)(k % COLUMNS), y[k] = (float)(k / COLUMNS), z[k] = (float)sin(k);
    }
    z[10] = NAN;
    memset(&arrays, 0, sizeof arrays);
    arrays.struct_size = sizeof arrays;
    arrays.rows = ROWS, arrays.columns = COLUMNS;
    arrays.x = x, arrays.y = y, arrays.z = z;
    arrays.scalar = GUSSET_F32;
    EXPECT(GUSSET_OK, gusset_net_create(context, &arrays, NULL, GUSSET_NET_MEMORY_COPY, &net));
    return net;
}

static gusset_stream_options options(gusset_stream_mode mode) {
    gusset_stream_options made;
    memset(&made, 0, sizeof made);
    made.struct_size = sizeof made;
    made.mode = mode;
    made.rows_per_block = 4;
    return made;
}

static const float *heights(const gusset_net *net) {
    gusset_net_view arrays;
    memset(&arrays, 0, sizeof arrays);
    arrays.struct_size = sizeof arrays;
    EXPECT(GUSSET_OK, gusset_net_get_view(net, &arrays));
    return (const float *)arrays.z;
}

static void bytes_of(const gusset_stream *stream, const void **data, size_t *size) {
    gusset_stream_view view = {.struct_size = sizeof view};
    EXPECT(GUSSET_OK, gusset_stream_get_view(stream, &view));
    *data = view.data, *size = view.size;
}

static void there_and_back(const gusset_net *net) {
    const gusset_stream_mode modes[] = {GUSSET_STREAM_QUANTISED, GUSSET_STREAM_LOSSLESS, GUSSET_STREAM_RAW};
    size_t m, k;
    for (m = 0; m < 3; ++m) {
        const gusset_stream_options made = options(modes[m]);
        gusset_stream *stream = NULL;
        gusset_stream_report info;
        gusset_net *back = NULL;
        const void *data = NULL;
        size_t size = 0;
        EXPECT(GUSSET_OK, gusset_net_encode_create(context, net, &made, &stream));
        bytes_of(stream, &data, &size);
        memset(&info, 0, sizeof info);
        info.struct_size = sizeof info;
        EXPECT(GUSSET_OK, gusset_stream_inspect(context, data, 128, &info));
        CHECK(info.rows == ROWS && info.columns == COLUMNS && info.rows_per_block == 4);
        CHECK(info.mode == modes[m] && info.scalar == GUSSET_F32 && info.bits == (m == 0 ? 14u : 0u));
        CHECK(info.prelude_size < size && (info.step[2] > 0) == (m == 0));
        EXPECT(GUSSET_OK, gusset_net_decode_create(context, data, size, 0, &back));
        for (k = 0; k < ROWS * COLUMNS; ++k) {
            const float found = heights(back)[k], given = z[k];
            CHECK(k == 10 ? isnan(found) : fabs(found - given) <= info.step[2] / 2 + 1e-7);
            CHECK(k == 10 || m == 0 || found == given);
        }
        gusset_net_destroy(back);
        gusset_stream_destroy(stream);
    }
}

static void damaged(const gusset_net *net) {
    gusset_stream *stream = NULL;
    gusset_net *back = NULL;
    gusset_stream_report info;
    gusset_error_report report;
    const void *data = NULL;
    size_t size = 0, k;
    unsigned char *copy;
    EXPECT(GUSSET_OK, gusset_net_encode_create(context, net, NULL, &stream));
    bytes_of(stream, &data, &size);
    copy = malloc(size);
    if (copy == NULL) {
        return;
    }
    for (k = 0; k < size; ++k) {
        memcpy(copy, data, size);
        copy[k] ^= 4;
        EXPECT(GUSSET_ERROR_BAD_STREAM, gusset_net_decode_create(context, copy, size, 0, &back));
        EXPECT(GUSSET_ERROR_BAD_STREAM, gusset_net_decode_create(context, data, k, 0, &back));
    }
    CHECK(back == NULL);
    memset(&report, 0, sizeof report);
    report.struct_size = sizeof report;
    EXPECT(GUSSET_OK, gusset_context_get_report(context, &report));
    CHECK(report.element == GUSSET_ELEMENT_BYTE && report.index <= size);
    EXPECT(GUSSET_ERROR_TOO_LARGE, gusset_net_decode_create(context, data, size, 3, &back));
    report.struct_size = sizeof report;
    EXPECT(GUSSET_OK, gusset_context_get_report(context, &report));
    CHECK(back == NULL && report.value == 3.0);
    EXPECT(GUSSET_ERROR_BAD_STREAM, gusset_net_decode_create(context, NULL, 0, 0, &back));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_decode_create(context, NULL, 5, 0, &back));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_decode_create(context, data, size, 0, NULL));
    memset(&info, 0, sizeof info);
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_stream_inspect(context, data, size, &info));
    info.struct_size = sizeof info;
    EXPECT(GUSSET_ERROR_BAD_STREAM, gusset_stream_inspect(context, data, 127, &info));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_stream_inspect(context, NULL, 128, &info));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_stream_inspect(context, data, size, NULL));
    free(copy);
    gusset_stream_destroy(stream);
}

static void wrong_options(const gusset_net *net) {
    gusset_stream_options made = options(GUSSET_STREAM_QUANTISED);
    gusset_stream *stream = NULL;
    gusset_stream_view view = {.struct_size = sizeof view, .data = net, .size = 1};
    made.bits = 25;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_net_encode_create(context, net, &made, &stream));
    made.bits = 7;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_net_encode_create(context, net, &made, &stream));
    made.bits = 8, made.per_axis = 2;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_net_encode_create(context, net, &made, &stream));
    made.per_axis = 0, made.mode = 3;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_net_encode_create(context, net, &made, &stream));
    made.mode = GUSSET_STREAM_RAW;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_net_encode_create(context, net, &made, &stream));
    made.bits = 0, made.levels = GUSSET_LEVELS_GIVEN;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_net_encode_create(context, net, &made, &stream));
    made.mode = GUSSET_STREAM_QUANTISED, made.levels = 2;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_net_encode_create(context, net, &made, &stream));
    made.levels = GUSSET_LEVELS_GIVEN, made.low[1] = INFINITY;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_net_encode_create(context, net, &made, &stream));
    made.low[1] = 1e9, made.high[1] = 2e9;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_net_encode_create(context, net, &made, &stream));
    made.step = -1;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_net_encode_create(context, net, &made, &stream));
    made.bits = 12;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_net_encode_create(context, net, &made, &stream));
    made.bits = 0, made.levels = GUSSET_LEVELS_AUTO, made.struct_size = 8;
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_net_encode_create(context, net, &made, &stream));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_encode_create(context, NULL, NULL, &stream));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_encode_create(context, net, NULL, NULL));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_net_encode_create(context, misaligned(), NULL, &stream));
    CHECK(stream == NULL);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_stream_get_view(NULL, &view));
    CHECK(view.data == NULL && view.size == 0);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_stream_get_view(stream, NULL));
    view.struct_size = 8;
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_stream_get_view(stream, &view));
    gusset_stream_destroy(NULL);
}

static void in_pieces(const gusset_net *net) {
    gusset_stream_options made = options(GUSSET_STREAM_LOSSLESS);
    gusset_stream *stream = NULL;
    gusset_stream_decoder *decoder = NULL, *small = NULL;
    gusset_net *back = NULL;
    const void *data = NULL;
    size_t size = 0, at, rows = 99;
    made.per_axis = 1;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_net_encode_create(context, net, &made, &stream));
    made.per_axis = 0;
    EXPECT(GUSSET_OK, gusset_net_encode_create(context, net, &made, &stream));
    bytes_of(stream, &data, &size);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_stream_decoder_create(context, 0, NULL));
    EXPECT(GUSSET_OK, gusset_stream_decoder_create(context, 0, &decoder));
    EXPECT(GUSSET_ERROR_NET_TOO_SMALL, gusset_stream_decoder_preview_create(context, decoder, &back));
    EXPECT(GUSSET_ERROR_BAD_STREAM, gusset_stream_decoder_finish_create(context, decoder, &back));
    for (at = 0; at < size; ++at) {
        EXPECT(GUSSET_OK, gusset_stream_decoder_push(context, decoder, (const char *)data + at, 1, &rows));
        CHECK(rows == 0 || rows == 4 || rows == 8 || rows == ROWS);
        if (rows == 4 && back == NULL) {
            EXPECT(GUSSET_OK, gusset_stream_decoder_preview_create(context, decoder, &back));
            CHECK(heights(back)[27] == z[27]);
        }
    }
    gusset_net_destroy(back);
    CHECK(rows == ROWS);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_stream_decoder_finish_create(context, decoder, NULL));
    EXPECT(GUSSET_OK, gusset_stream_decoder_finish_create(context, decoder, &back));
    CHECK(heights(back)[62] == z[62]);
    gusset_net_destroy(back);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_stream_decoder_finish_create(context, NULL, &back));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_stream_decoder_preview_create(context, NULL, &back));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_stream_decoder_push(context, NULL, data, size, &rows));
    CHECK(rows == 0);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_stream_decoder_push(context, decoder, NULL, 1, NULL));
    EXPECT(GUSSET_OK, gusset_stream_decoder_push(context, decoder, data, size, NULL));
    EXPECT(GUSSET_ERROR_BAD_STREAM, gusset_stream_decoder_push(context, decoder, data, 1, NULL));
    EXPECT(GUSSET_ERROR_BAD_STREAM, gusset_stream_decoder_finish_create(context, decoder, &back));
    EXPECT(GUSSET_OK, gusset_stream_decoder_create(context, ROWS * COLUMNS - 1, &small));
    EXPECT(GUSSET_ERROR_TOO_LARGE, gusset_stream_decoder_push(context, small, data, size, &rows));
    CHECK(rows == 0 && back == NULL);
    gusset_stream_decoder_destroy(small);
    gusset_stream_decoder_destroy(decoder);
    gusset_stream_decoder_destroy(NULL);
    gusset_stream_destroy(stream);
}

int main(void) {
    gusset_net *net;
    if (gusset_context_create(&context) != GUSSET_OK) {
        return 1;
    }
    net = sheet();
    there_and_back(net);
    damaged(net);
    wrong_options(net);
    in_pieces(net);
    gusset_net_destroy(net);
    gusset_context_destroy(context);
    return failures != 0;
}

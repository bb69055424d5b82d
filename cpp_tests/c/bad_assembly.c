/* Calls strips, stitching and joining with invalid arguments, and checks the errors. */
#include "check.h"
#include <math.h>
#include <stddef.h>
#include <stdlib.h>

static gusset_context *context;

static double reported_value(void) {
    gusset_error_report report = {sizeof report, 0, 0, 0, 0.0, 0, 0};
    EXPECT(GUSSET_OK, gusset_context_get_report(context, &report));
    return report.value;
}

static const double square[4][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
static const double above[4][3] = {{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};

static void strips_refused(void) {
    gusset_strip_options options = {.struct_size = sizeof options, .closed = 1};
    gusset_strip_report parts = {0};
    gusset_result *strip = NULL;
    const double *a = square[0], *b = above[0];
    double wrong[4][3];

    FAILS(GUSSET_ERROR_NULL_ARGUMENT, strip, gusset_strip(context, NULL, 4, b, 4, NULL, &strip));
    REPORT(context, GUSSET_ERROR_NULL_ARGUMENT, GUSSET_ELEMENT_NONE, 0, 0);
    FAILS(GUSSET_ERROR_NULL_ARGUMENT, strip, gusset_strip(context, a, 4, NULL, 4, NULL, &strip));
    REPORT(context, GUSSET_ERROR_NULL_ARGUMENT, GUSSET_ELEMENT_NONE, 0, 1);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_strip(context, a, 4, b, 4, NULL, NULL));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_strip(context, a, 4, b, 4, NULL, misaligned()));
    FAILS(GUSSET_ERROR_MISALIGNED_ARGUMENT, strip, gusset_strip(misaligned(), a, 4, b, 4, NULL, &strip));
    FAILS(GUSSET_ERROR_MISALIGNED_ARGUMENT, strip, gusset_strip(context, a, 4, b, 4, misaligned(), &strip));
    for (options.struct_size = 0; options.struct_size < 40; ++options.struct_size) {
        FAILS(GUSSET_ERROR_BAD_STRUCT_SIZE, strip, gusset_strip(context, a, 4, b, 4, &options, &strip));
    }
    options.struct_size = SIZE_MAX;
    FAILS(GUSSET_ERROR_BAD_STRUCT_SIZE, strip, gusset_strip(context, a, 4, b, 4, &options, &strip));
    options.struct_size = sizeof options, options.meridians = 8;
    FAILS(GUSSET_ERROR_UNKNOWN_VALUE, strip, gusset_strip(context, a, 4, b, 4, &options, &strip));
    CHECK(reported_value() == 8.0);
    options.meridians = 0, options.search = 2;
    FAILS(GUSSET_ERROR_UNKNOWN_VALUE, strip, gusset_strip(context, a, 4, b, 4, &options, &strip));
    options.search = 0, options.start = 3;
    FAILS(GUSSET_ERROR_UNKNOWN_VALUE, strip, gusset_strip(context, a, 4, b, 4, &options, &strip));
    options.start = 0, options.closed = 2;
    FAILS(GUSSET_ERROR_UNKNOWN_VALUE, strip, gusset_strip(context, a, 4, b, 4, &options, &strip));
    options.closed = 1, options.rows = 3;
    FAILS(GUSSET_ERROR_UNKNOWN_VALUE, strip, gusset_strip(context, a, 4, b, 4, &options, &strip));
    options.rows = 0, options.cells = 2;
    FAILS(GUSSET_ERROR_UNKNOWN_VALUE, strip, gusset_strip(context, a, 4, b, 4, &options, &strip));
    options.cells = 0, options.reserved = 1;
    FAILS(GUSSET_ERROR_UNKNOWN_VALUE, strip, gusset_strip(context, a, 4, b, 4, &options, &strip));
    options.reserved = 0, options.rows = GUSSET_ROWS_COUNT, options.row_count = UINT32_MAX;
    FAILS(GUSSET_ERROR_TOO_LARGE, strip, gusset_strip(context, a, 4, b, 4, &options, &strip));
    options.rows = 0, options.row_count = 0;

    /* Too few points, closed and open, and too many. */
    FAILS(GUSSET_ERROR_LOOP_TOO_SHORT, strip, gusset_strip(context, a, 2, b, 4, &options, &strip));
    REPORT(context, GUSSET_ERROR_LOOP_TOO_SHORT, GUSSET_ELEMENT_COUNT, 2, 0);
    FAILS(GUSSET_ERROR_LOOP_TOO_SHORT, strip, gusset_strip(context, a, 3, b, 0, &options, &strip));
    REPORT(context, GUSSET_ERROR_LOOP_TOO_SHORT, GUSSET_ELEMENT_COUNT, 0, 1);
    FAILS(GUSSET_ERROR_LOOP_TOO_SHORT, strip, gusset_strip(context, NULL, 0, b, 4, NULL, &strip));
    FAILS(GUSSET_ERROR_TOO_LARGE, strip, gusset_strip(context, a, SIZE_MAX, b, 4, &options, &strip));
    FAILS(GUSSET_ERROR_TOO_LARGE, strip, gusset_strip(context, a, 4, b, UINT32_MAX, &options, &strip));
    REPORT(context, GUSSET_ERROR_TOO_LARGE, GUSSET_ELEMENT_COUNT, UINT32_MAX, 1);

    /* Coordinates that are not finite, on either side, at any point and axis. */
    for (int place = 0; place < 4; ++place) {
        memcpy(wrong, square, sizeof wrong);
        wrong[place][place % 3] = place % 2 ? -INFINITY : NAN;
        FAILS(GUSSET_ERROR_NOT_FINITE, strip, gusset_strip(context, wrong[0], 4, b, 4, &options, &strip));
        REPORT(context, GUSSET_ERROR_NOT_FINITE, GUSSET_ELEMENT_LOOP_PLACE, (uint64_t)place, 0);
        FAILS(GUSSET_ERROR_NOT_FINITE, strip, gusset_strip(context, a, 4, wrong[0], 4, NULL, &strip));
        REPORT(context, GUSSET_ERROR_NOT_FINITE, GUSSET_ELEMENT_LOOP_PLACE, (uint64_t)place, 1);
        CHECK(place % 2 ? reported_value() == -INFINITY : isnan(reported_value()));
    }
    gusset_context_cancel(context);
    FAILS(GUSSET_ERROR_CANCELLED, strip, gusset_strip(context, a, 4, b, 4, &options, &strip));
    gusset_context_reset(context);

    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_result_get_strip(NULL, &parts));
    parts.struct_size = sizeof parts, parts.start[0] = 9, parts.meridians.count = 9;
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_result_get_strip(NULL, &parts));
    CHECK(parts.start[0] == 0 && parts.meridians.count == 0 && parts.struct_size == sizeof parts);
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_result_get_strip(misaligned(), &parts));
    gusset_mesh_view mesh = {0};
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_result_get_mesh(NULL, &mesh));
    mesh.struct_size = sizeof mesh;
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_result_get_mesh(NULL, &mesh));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_result_get_mesh(misaligned(), &mesh));
    gusset_result_destroy(NULL);
}

static void strips_made(void) {
    struct {
        gusset_strip_options known;
        uint64_t tail[2];
    } larger = {{.struct_size = sizeof larger, .start = GUSSET_START_GIVEN, .closed = 1}, {0, 0}};
    gusset_strip_report parts = {.struct_size = sizeof parts};
    gusset_mesh_view mesh = {.struct_size = sizeof mesh};
    gusset_result *strip = NULL;
    char bytes[1 + sizeof square];

    /* A struct of a later version: unknown fields must be 0. Points may lie anywhere. */
    memcpy(bytes + 1, square, sizeof square);
    larger.tail[1] = 1;
    FAILS(GUSSET_ERROR_UNKNOWN_VALUE, strip,
          gusset_strip(context, square[0], 4, above[0], 4, &larger.known, &strip));
    larger.tail[1] = 0;
    EXPECT(GUSSET_OK, gusset_strip(context, (const double *)(const void *)(bytes + 1), 4, above[0], 3,
                                          &larger.known, &strip));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_result_get_strip(strip, NULL));
    EXPECT(GUSSET_OK, gusset_result_get_strip(strip, &parts));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_result_get_mesh(strip, NULL));
    EXPECT(GUSSET_OK, gusset_result_get_mesh(strip, &mesh));
    CHECK(mesh.vertex_count == 7 && mesh.face_count == 7);
    CHECK(parts.start[0] == 0 && parts.start[1] == 0 && parts.matrix.count == 2 * 8 && parts.row_count == 0);
    CHECK(parts.meridians.count == 2 * 8 && parts.meridians.data[14] == 4 && parts.meridians.data[15] == 3);
    gusset_result_destroy(strip);

    /* Open by default; two single points are one meridian and no triangle. Without a context. */
    EXPECT(GUSSET_OK, gusset_strip(NULL, square[0], 1, above[0], 1, NULL, &strip));
    EXPECT(GUSSET_OK, gusset_result_get_strip(strip, &parts));
    EXPECT(GUSSET_OK, gusset_result_get_mesh(strip, &mesh));
    CHECK(mesh.face_count == 0 && mesh.vertex_count == 2 && parts.weights == NULL && parts.meridians.count == 2);
    gusset_result_destroy(strip);
}

static void stitch_options(void) {
    const gusset_mesh_view up = pyramid(pyramid_up), down = pyramid(pyramid_down);
    const size_t first_version = offsetof(gusset_stitch_options, search);
    gusset_stitch_options options = {0};
    gusset_stitch_report parts = {0};
    gusset_result *stitch = NULL;

    CHECK(sizeof(void *) != 8 || first_version == 72);
    options.struct_size = sizeof options;
    for (int field = 0; field < 7; ++field) {
        uint32_t *fields[7];
        static const uint32_t unknown[7] = {2, 2, 2, 3, 2, 3, 2};
        fields[0] = &options.search, fields[1] = &options.start;
        fields[2] = &options.fairing, fields[3] = &options.intersections;
        fields[4] = &options.centres, fields[5] = &options.outward, fields[6] = &options.finish;
        *fields[field] = unknown[field];
        FAILS(GUSSET_ERROR_UNKNOWN_VALUE, stitch,
              gusset_stitch(context, &up, NULL, &down, NULL, &options, &stitch));
        CHECK(reported_value() == unknown[field]);
        *fields[field] = UINT32_MAX;
        FAILS(GUSSET_ERROR_UNKNOWN_VALUE, stitch,
              gusset_stitch(context, &up, NULL, &down, NULL, &options, &stitch));
        *fields[field] = 0;
    }
    /* A caller of the first version has none of the later fields: whatever lies behind its struct is not read. */
    gusset_stitch_options shorter;
    memset(&shorter, 0xff, sizeof shorter);
    memset(&shorter, 0, first_version);
    shorter.struct_size = first_version - 1;
    FAILS(GUSSET_ERROR_BAD_STRUCT_SIZE, stitch,
          gusset_stitch(context, &up, NULL, &down, NULL, &shorter, &stitch));
    shorter.struct_size = first_version;
    EXPECT(GUSSET_OK, gusset_stitch(context, &up, NULL, &down, NULL, &shorter, &stitch));
    parts.struct_size = sizeof parts;
    EXPECT(GUSSET_OK, gusset_result_get_stitch(stitch, &parts));
    CHECK(parts.strip_face_count == 8 && parts.intersections_known == 1 && parts.intersections.count == 0);
    CHECK(parts.finish == GUSSET_FINISH_STRIP);
    gusset_result_destroy(stitch);

    /* Each field counts from the size on that holds it. */
    memset(&options, 0xff, sizeof options);
    memset(&options, 0, first_version);
    options.search = GUSSET_SEARCH_EXACT, options.start = GUSSET_START_CLOSEST;
    options.struct_size = offsetof(gusset_stitch_options, fairing);
    EXPECT(GUSSET_OK, gusset_stitch(context, &up, NULL, &down, NULL, &options, &stitch));
    gusset_result_destroy(stitch);
    options.struct_size = offsetof(gusset_stitch_options, centres);
    FAILS(GUSSET_ERROR_UNKNOWN_VALUE, stitch,
          gusset_stitch(context, &up, NULL, &down, NULL, &options, &stitch));
    options.struct_size = sizeof options, options.fairing = GUSSET_FAIRING_THIN_PLATE;
    options.centres = GUSSET_CENTRES_LENGTH, options.outward = GUSSET_OUTWARD_CLOSED;
    options.finish = GUSSET_FINISH_STRIP, options.reserved = 1;
    FAILS(GUSSET_ERROR_UNKNOWN_VALUE, stitch,
          gusset_stitch(context, &up, NULL, &down, NULL, &options, &stitch));
    options.reserved = 0;
    options.rows = GUSSET_ROWS_COUNT, options.row_count = 2, options.intersections = GUSSET_INTERSECTIONS_REPORT;
    EXPECT(GUSSET_OK, gusset_stitch(context, &up, NULL, &down, NULL, &options, &stitch));
    EXPECT(GUSSET_OK, gusset_result_get_stitch(stitch, &parts));
    CHECK(parts.intersections_known == 1 && parts.intersections.count == 0 && parts.row_count == 2);
    CHECK(parts.turned_outwards.count == 0 && parts.turned_outwards.data == NULL);
    gusset_result_destroy(stitch);
    /* A blend lacks rows; each of its new vertices has parents. */
    options.finish = GUSSET_FINISH_BLEND;
    EXPECT(GUSSET_OK, gusset_stitch(context, &up, NULL, &down, NULL, &options, &stitch));
    EXPECT(GUSSET_OK, gusset_result_get_stitch(stitch, &parts));
    CHECK(parts.row_count == 0 && parts.intersections_known == 1 && parts.intersections.count == 0);
    CHECK(parts.strip_face_count >= 8 && parts.parents.count % 3 == 0);
    gusset_result_destroy(stitch);
}

static gusset_status assemble(const gusset_mesh_view *pieces, size_t count, const gusset_join_options *options,
                              gusset_result **assembly) {
    return gusset_join(context, pieces, count, options, assembly);
}

static void assembly_arguments(void) {
    gusset_mesh_view pieces[2];
    gusset_join_options options = {0};
    gusset_result *done = NULL;
    gusset_weld_options weld = {0};
    gusset_stitch_options strips = {0};
    gusset_fill_options fill = {0};
    double points[5][3];

    pieces[0] = pyramid(pyramid_up), pieces[1] = pyramid(pyramid_down);
    FAILS(GUSSET_ERROR_NULL_ARGUMENT, done, assemble(NULL, 2, NULL, &done));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, assemble(pieces, 2, NULL, NULL));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, assemble(pieces, 2, NULL, misaligned()));
    FAILS(GUSSET_ERROR_MISALIGNED_ARGUMENT, done, assemble(misaligned(), 2, NULL, &done));
    FAILS(GUSSET_ERROR_MISALIGNED_ARGUMENT, done, assemble(pieces, 2, misaligned(), &done));
    FAILS(GUSSET_ERROR_MISALIGNED_ARGUMENT, done, gusset_join(misaligned(), pieces, 2, NULL, &done));
    FAILS(GUSSET_ERROR_EMPTY_MESH, done, assemble(pieces, 0, NULL, &done));
    FAILS(GUSSET_ERROR_EMPTY_MESH, done, assemble(NULL, 0, NULL, &done));
    CHECK(strcmp(gusset_context_get_message(context), "no pieces were given; at least one is needed") == 0);
    FAILS(GUSSET_ERROR_TOO_LARGE, done, assemble(pieces, SIZE_MAX, NULL, &done));
    pieces[0].struct_size = 8;
    FAILS(GUSSET_ERROR_BAD_STRUCT_SIZE, done, assemble(pieces, 2, NULL, &done));
    pieces[0].struct_size = sizeof pieces[0], pieces[1].struct_size = 8;
    FAILS(GUSSET_ERROR_BAD_STRUCT_SIZE, done, assemble(pieces, 2, NULL, &done));
    REPORT(context, GUSSET_ERROR_BAD_STRUCT_SIZE, GUSSET_ELEMENT_ITEM, 1, 1);
    /* Larger than the first one, whose size says how far they are apart: nothing beyond the array is read. */
    pieces[1].struct_size = sizeof pieces[1] + 8;
    FAILS(GUSSET_ERROR_BAD_STRUCT_SIZE, done, assemble(pieces, 2, NULL, &done));
    REPORT(context, GUSSET_ERROR_BAD_STRUCT_SIZE, GUSSET_ELEMENT_ITEM, 1, 1);
    CHECK(reported_value() == (double)pieces[1].struct_size);

    /* An error of a mesh names the index of its piece. */
    pieces[1] = pyramid(pyramid_down), pieces[1].vertex_count = 4;
    FAILS(GUSSET_ERROR_INDEX_OUT_OF_RANGE, done, assemble(pieces, 2, NULL, &done));
    REPORT(context, GUSSET_ERROR_INDEX_OUT_OF_RANGE, GUSSET_ELEMENT_HALF_EDGE, 8, 1);
    CHECK(reported_value() == 4.0);
    memcpy(points, pyramid_down, sizeof points);
    points[3][2] = NAN;
    pieces[1] = pyramid((const double (*)[3])points);
    FAILS(GUSSET_ERROR_NOT_FINITE, done, assemble(pieces, 2, NULL, &done));
    REPORT(context, GUSSET_ERROR_NOT_FINITE, GUSSET_ELEMENT_VERTEX, 3, 1);
    pieces[1].face_count = 0;
    FAILS(GUSSET_ERROR_EMPTY_MESH, done, assemble(pieces, 2, NULL, &done));
    REPORT(context, GUSSET_ERROR_EMPTY_MESH, GUSSET_ELEMENT_NONE, 0, 1);
    pieces[1] = pyramid(pyramid_down), pieces[1].face_count = SIZE_MAX / 2;
    FAILS(GUSSET_ERROR_TOO_LARGE, done, assemble(pieces, 2, NULL, &done));
    pieces[1] = pyramid(pyramid_down), pieces[1].positions = NULL;
    FAILS(GUSSET_ERROR_NULL_ARGUMENT, done, assemble(pieces, 2, NULL, &done));
    pieces[1] = pyramid(pyramid_down), pieces[0].scalar = GUSSET_F32;
    FAILS(GUSSET_ERROR_MIXED_SCALARS, done, assemble(pieces, 2, NULL, &done));
    pieces[0].scalar = GUSSET_F64;

    /* Every field of the options. */
    FAILS(GUSSET_ERROR_BAD_STRUCT_SIZE, done, assemble(pieces, 2, &options, &done));
    options.struct_size = offsetof(gusset_join_options, outward) - 1;
    FAILS(GUSSET_ERROR_BAD_STRUCT_SIZE, done, assemble(pieces, 2, &options, &done));
    options.struct_size = sizeof options;
    for (int field = 0; field < 8; ++field) {
        static const uint32_t unknown[8] = {3, GUSSET_ORIENTATION_REFUSE, 2, 3, 2, 2, 3, 2};
        uint32_t *fields[8];
        fields[0] = &options.weld, fields[1] = &options.orientation, fields[2] = &options.gap;
        fields[3] = &options.extent, fields[4] = &options.within_components, fields[5] = &options.fill;
        fields[6] = &options.outward, fields[7] = &options.overlaps;
        *fields[field] = unknown[field];
        FAILS(GUSSET_ERROR_UNKNOWN_VALUE, done, assemble(pieces, 2, &options, &done));
        CHECK(reported_value() == unknown[field]);
        *fields[field] = 0;
    }
    options.gap = GUSSET_GAP_GIVEN, options.max_gap = -1e-300;
    FAILS(GUSSET_ERROR_OUT_OF_RANGE, done, assemble(pieces, 2, &options, &done));
    CHECK(reported_value() == -1e-300);
    options.max_gap = INFINITY;
    FAILS(GUSSET_ERROR_OUT_OF_RANGE, done, assemble(pieces, 2, &options, &done));
    options.max_gap = NAN;
    FAILS(GUSSET_ERROR_OUT_OF_RANGE, done, assemble(pieces, 2, &options, &done));
    CHECK(isnan(reported_value()));
    options.gap = GUSSET_GAP_AUTO;
    EXPECT(GUSSET_OK, assemble(pieces, 2, &options, &done));
    gusset_result_destroy(done);

    /* The options of the parts, each with a mistake of its own. */
    options.weld_options = &weld;
    FAILS(GUSSET_ERROR_BAD_STRUCT_SIZE, done, assemble(pieces, 2, &options, &done));
    weld.struct_size = sizeof weld, weld.tolerance_mode = GUSSET_TOLERANCE_GIVEN, weld.tolerance = NAN;
    FAILS(GUSSET_ERROR_OUT_OF_RANGE, done, assemble(pieces, 2, &options, &done));
    weld.tolerance_mode = 3;
    FAILS(GUSSET_ERROR_UNKNOWN_VALUE, done, assemble(pieces, 2, &options, &done));
    CHECK(strstr(gusset_context_get_message(context), "weld_options.tolerance_mode is 3;") != NULL);
    options.weld_options = misaligned();
    FAILS(GUSSET_ERROR_MISALIGNED_ARGUMENT, done, assemble(pieces, 2, &options, &done));
    options.weld_options = NULL, options.strip_options = &strips;
    FAILS(GUSSET_ERROR_BAD_STRUCT_SIZE, done, assemble(pieces, 2, &options, &done));
    strips.struct_size = sizeof strips, strips.extent = 9;
    FAILS(GUSSET_ERROR_UNKNOWN_VALUE, done, assemble(pieces, 2, &options, &done));
    CHECK(strstr(gusset_context_get_message(context), "strip_options.extent is 9;") != NULL);
    strips.extent = 0, strips.fairing = 9;
    FAILS(GUSSET_ERROR_UNKNOWN_VALUE, done, assemble(pieces, 2, &options, &done));
    strips.fairing = 0, strips.finish = 2;
    FAILS(GUSSET_ERROR_UNKNOWN_VALUE, done, assemble(pieces, 2, &options, &done));
    options.strip_options = misaligned();
    FAILS(GUSSET_ERROR_MISALIGNED_ARGUMENT, done, assemble(pieces, 2, &options, &done));
    options.strip_options = NULL, options.fill_options = &fill, options.fill = 1;
    FAILS(GUSSET_ERROR_BAD_STRUCT_SIZE, done, assemble(pieces, 2, &options, &done));
    fill.struct_size = sizeof fill, fill.max_length = -1.0;
    FAILS(GUSSET_ERROR_OUT_OF_RANGE, done, assemble(pieces, 2, &options, &done));
    fill.outward = 3, fill.max_length = 0.0;
    FAILS(GUSSET_ERROR_UNKNOWN_VALUE, done, assemble(pieces, 2, &options, &done));
    fill.outward = 0;
    options.fill_options = NULL;
    gusset_context_cancel(context);
    FAILS(GUSSET_ERROR_CANCELLED, done, assemble(pieces, 2, &options, &done));
    gusset_context_reset(context);
    gusset_result_destroy(NULL);
}

static void assembly_pairs(void) {
    /* A piece, its vertex, another piece, its vertex: both pyramids have their rims at 1 2 3 4. */
    static const gusset_loop_pair wrong[] = {
        {{0, 2}, {1, 1}},          {{UINT32_MAX, 1}, {1, 1}}, {{0, 1}, {0, 1}}, {{0, 1}, {1, 5}},
        {{0, 1}, {UINT32_MAX, 1}}, {{0, 0}, {1, 2}},          {{1, 1}, {4, 4}},
    };
    const gusset_loop_pair right = {{1, 0}, {3, 2}};
    /* Which loop of each is to blame, by itself and after the right one, and for which piece or vertex. */
    static const uint32_t blame[7] = {1, 0, 0, 1, 0, 1, 1}, in_second[7] = {1, 0, 0, 1, 0, 0, 0};
    static const double value[7] = {2, UINT32_MAX, 0, 5, UINT32_MAX, 2, 4};
    gusset_mesh_view pieces[2];
    gusset_join_options options = {0};
    gusset_loop_pair list[2];
    gusset_result *done = NULL;
    gusset_join_report parts = {0};

    parts.struct_size = sizeof parts;
    pieces[0] = pyramid(pyramid_up), pieces[1] = pyramid(pyramid_down);
    options.struct_size = sizeof options, options.pairs = list, options.pair_count = 2;
    /* The pair to blame is named, wherever it stands. */
    for (size_t k = 0; k < sizeof wrong / sizeof *wrong; ++k) {
        list[0] = right, list[1] = wrong[k];
        FAILS(GUSSET_ERROR_OUT_OF_RANGE, done, assemble(pieces, 2, &options, &done));
        REPORT(context, GUSSET_ERROR_OUT_OF_RANGE, GUSSET_ELEMENT_ITEM, 1, in_second[k]);
        list[0] = wrong[k], list[1] = right;
        FAILS(GUSSET_ERROR_OUT_OF_RANGE, done, assemble(pieces, 2, &options, &done));
        REPORT(context, GUSSET_ERROR_OUT_OF_RANGE, GUSSET_ELEMENT_ITEM, 0, blame[k]);
        CHECK(reported_value() == value[k]);
    }
    CHECK(strcmp(gusset_context_get_message(context), "pair 0 of pairs: vertex 4 of piece 1 is on the pair's other loop") == 0);
    list[0] = list[1] = right;
    FAILS(GUSSET_ERROR_OUT_OF_RANGE, done, assemble(pieces, 2, &options, &done));
    REPORT(context, GUSSET_ERROR_OUT_OF_RANGE, GUSSET_ELEMENT_ITEM, 1, 0);
    CHECK(reported_value() == 3.0);
    options.pair_count = SIZE_MAX;
    FAILS(GUSSET_ERROR_TOO_LARGE, done, assemble(pieces, 2, &options, &done));
    options.pair_count = 1, options.pairs = NULL;
    FAILS(GUSSET_ERROR_NULL_ARGUMENT, done, assemble(pieces, 2, &options, &done));
    options.pair_count = 0, options.excluded_count = SIZE_MAX, options.excluded = list;
    FAILS(GUSSET_ERROR_TOO_LARGE, done, assemble(pieces, 2, &options, &done));
    options.excluded_count = 1, options.excluded = NULL;
    FAILS(GUSSET_ERROR_NULL_ARGUMENT, done, assemble(pieces, 2, &options, &done));
    options.excluded = list;
    for (size_t k = 0; k < 2; ++k) {
        list[0] = wrong[k];
        FAILS(GUSSET_ERROR_OUT_OF_RANGE, done, assemble(pieces, 2, &options, &done));
    }
    list[0] = wrong[3];
    FAILS(GUSSET_ERROR_OUT_OF_RANGE, done, assemble(pieces, 2, &options, &done));

    /* An exclusion holds, by loop or by piece, where the gap is narrow enough, and a given pair is joined however wide it is. */
    list[0] = right, options.gap = GUSSET_GAP_GIVEN, options.max_gap = 2.0;
    for (int by_piece = 0; by_piece < 2; ++by_piece) {
        EXPECT(GUSSET_OK, assemble(pieces, 2, &options, &done));
        EXPECT(GUSSET_OK, gusset_result_get_join(done, &parts));
        CHECK(parts.joint_count == 0 && parts.joints == NULL && parts.left_count == 2 && parts.loops_left == 2);
        CHECK(parts.left[0].reason == GUSSET_LEFT_EXCLUDED && parts.near_loops_left == 0 && parts.left[1].vertices.count == 4);
        gusset_result_destroy(done);
        list[0].vertex[0] = list[0].vertex[1] = UINT32_MAX;
    }
    list[0] = right, options.excluded = NULL, options.excluded_count = 0;
    options.pairs = list, options.pair_count = 1, options.max_gap = 0.0;
    EXPECT(GUSSET_OK, assemble(pieces, 2, &options, &done));
    EXPECT(GUSSET_OK, gusset_result_get_join(done, &parts));
    CHECK(parts.joint_count == 1 && parts.joints[0].outcome == GUSSET_JOINT_JOINED && parts.joints[0].whole == 1);
    CHECK(parts.joints[0].face_first == 8 && parts.joints[0].face_count == 8 && parts.loops_left == 0);
    gusset_result_destroy(done);
}

static void assembly_results(void) {
    struct {
        gusset_join_options known;
        uint64_t tail;
    } larger;
    gusset_mesh_view pieces[2], view = {0};
    gusset_join_report parts = {0};
    gusset_result *done = NULL;

    memset(&larger, 0, sizeof larger);
    larger.known.struct_size = sizeof larger, larger.tail = 1;
    larger.known.gap = GUSSET_GAP_GIVEN, larger.known.max_gap = 2.0;
    pieces[0] = pyramid(pyramid_up), pieces[1] = pyramid(pyramid_down);
    FAILS(GUSSET_ERROR_UNKNOWN_VALUE, done, assemble(pieces, 2, &larger.known, &done));
    larger.tail = 0;
    EXPECT(GUSSET_OK, assemble(pieces, 2, &larger.known, &done));
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_result_get_mesh(done, &view));
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_result_get_join(done, &parts));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_result_get_mesh(done, NULL));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_result_get_join(done, NULL));
    view.struct_size = sizeof view, view.face_count = 7;
    parts.struct_size = sizeof parts, parts.joint_count = 7;
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_result_get_mesh(NULL, &view));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_result_get_join(NULL, &parts));
    CHECK(view.face_count == 0 && parts.joint_count == 0);
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_result_get_mesh(misaligned(), &view));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_result_get_join(done, misaligned()));
    EXPECT(GUSSET_OK, gusset_result_get_mesh(done, &view));
    EXPECT(GUSSET_OK, gusset_result_get_join(done, &parts));
    CHECK(view.vertex_count == 10 && view.face_count == 16 && parts.piece_count == 2);
    for (uint32_t k = 0; k < 10; ++k) {
        CHECK(parts.pieces[k / 5].vertices.count == 5 && parts.pieces[k / 5].vertices.data[k % 5] == k);
        CHECK(memcmp((const double(*)[3])view.positions + k, k < 5 ? pyramid_up[k] : pyramid_down[k - 5], 24) == 0);
    }
    CHECK(parts.turned.count == 0 && parts.one_sided.count == 0 && parts.non_manifold_edges == 0);
    gusset_result_destroy(done);

    /* The first piece inside out: with GUSSET_OUTWARD_KEEP the second is turned to agree with it, else the first one is. */
    static const uint32_t inside_out[12] = {0, 2, 1, 0, 3, 2, 0, 4, 3, 0, 1, 4};
    pieces[0].face_corners = inside_out;
    static const gusset_outward ways[3] = {GUSSET_OUTWARD_CLOSED, GUSSET_OUTWARD_KEEP, GUSSET_OUTWARD_AUTO};
    for (int way = 0; way < 3; ++way) {
        const uint32_t keep = ways[way] == GUSSET_OUTWARD_KEEP;
        larger.known.outward = ways[way];
        EXPECT(GUSSET_OK, assemble(pieces, 2, &larger.known, &done));
        EXPECT(GUSSET_OK, gusset_result_get_mesh(done, &view));
        EXPECT(GUSSET_OK, gusset_result_get_join(done, &parts));
        CHECK(parts.turned.count == 4 && parts.loops_left == 0);
        for (uint32_t k = 0; k < parts.turned.count; ++k) {
            CHECK(parts.turned.data[k] == 4 * keep + k);
        }
        CHECK(memcmp(view.face_corners, keep ? inside_out : pyramid_faces, sizeof inside_out) == 0);
        gusset_result_destroy(done);
    }
}

int main(void) {
    if (gusset_context_create(&context) != GUSSET_OK) {
        return 1;
    }
    strips_refused();
    strips_made();
    stitch_options();
    assembly_arguments();
    assembly_pairs();
    assembly_results();
    gusset_context_destroy(context);
    return failures != 0;
}

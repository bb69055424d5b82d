/* Stitches with invalid meshes, loops and options, and checks the errors. */
#include "check.h"
#include <math.h>

static gusset_context *context;

/* Stitching two good meshes with these options, all others 0, has this status. */
#define OPTION(change, status)                                                                                         \
    do {                                                                                                               \
        memset(&options, 0, sizeof options);                                                                           \
        options.struct_size = sizeof options;                                                                          \
        change;                                                                                                        \
        stitch = (gusset_result *)misaligned();                                                                        \
        EXPECT(status, gusset_stitch(context, &up, NULL, &down, NULL, &options, &stitch));                      \
        CHECK(stitch == NULL);                                                                                         \
    } while (0)

/* Pointers and options of gusset_stitch and its readers. */
static void stitch_pointers(void) {
    const gusset_mesh_view up = pyramid(pyramid_up), down = pyramid(pyramid_down);
    gusset_stitch_options options = {0};
    gusset_indices loop = {NULL, 4};
    gusset_result *stitch = (gusset_result *)misaligned();
    gusset_mesh_view view;
    gusset_stitch_report parts;
    gusset_quality_report quality;

    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_stitch(context, NULL, NULL, &down, NULL, NULL, &stitch));
    CHECK(stitch == NULL);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_stitch(context, &up, NULL, &down, NULL, NULL, NULL));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_stitch(context, &up, &loop, &down, NULL, NULL, &stitch));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_stitch(misaligned(), &up, NULL, &down, NULL, NULL, &stitch));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT,
           gusset_stitch(context, misaligned(), NULL, &down, NULL, NULL, &stitch));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT,
           gusset_stitch(context, &up, misaligned(), &down, NULL, NULL, &stitch));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_stitch(context, &up, NULL, misaligned(), NULL, NULL, &stitch));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT,
           gusset_stitch(context, &up, NULL, &down, misaligned(), NULL, &stitch));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT,
           gusset_stitch(context, &up, NULL, &down, NULL, misaligned(), &stitch));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT,
           gusset_stitch(context, &up, NULL, &down, NULL, NULL, misaligned()));
    options.struct_size = sizeof options;
    options.meridians = 8;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_stitch(context, &up, NULL, &down, NULL, &options, &stitch));
    options.meridians = 0, options.orientation = 3;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_stitch(context, &up, NULL, &down, NULL, &options, &stitch));
    options.struct_size = 1;
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_stitch(context, &up, NULL, &down, NULL, &options, &stitch));
    CHECK(stitch == NULL);
    OPTION(options.extent = 4, GUSSET_ERROR_UNKNOWN_VALUE);
    OPTION(options.run = 2, GUSSET_ERROR_UNKNOWN_VALUE);
    OPTION(options.rows = 3, GUSSET_ERROR_UNKNOWN_VALUE);
    OPTION(options.cells = 2, GUSSET_ERROR_UNKNOWN_VALUE);
    OPTION(options.tolerance_mode = 3, GUSSET_ERROR_UNKNOWN_VALUE);
    OPTION((options.tolerance_mode = 1, options.tolerance = NAN), GUSSET_ERROR_OUT_OF_RANGE);
    OPTION((options.tolerance_mode = 1, options.tolerance = -1.0), GUSSET_ERROR_OUT_OF_RANGE);
    OPTION((options.tolerance_mode = 1, options.tolerance = INFINITY), GUSSET_ERROR_OUT_OF_RANGE);
    OPTION(options.extent = GUSSET_EXTENT_ARCS, GUSSET_ERROR_OUT_OF_RANGE);
    OPTION((options.extent = GUSSET_EXTENT_ARCS, options.arc_a[0] = 4, options.arc_a[1] = options.arc_b[1] = 1),
           GUSSET_ERROR_OUT_OF_RANGE);
    CHECK(strstr(gusset_context_get_message(context), "arc_a is 4; it must be ") != NULL);
    /* The sentence is about the last call. */
    EXPECT(GUSSET_OK, gusset_context_set_threads(context, 0));
    CHECK(gusset_context_get_message(context)[0] == '\0');
    OPTION((options.extent = GUSSET_EXTENT_ARCS, options.arc_a[1] = 1, options.arc_b[1] = UINT32_MAX),
           GUSSET_ERROR_OUT_OF_RANGE);
    OPTION((options.extent = GUSSET_EXTENT_ARCS, options.arc_a[1] = options.arc_b[1] = 2, options.twist = 1),
           GUSSET_ERROR_OUT_OF_RANGE);
    /* The rims of the pyramids are coaxial. */
    OPTION(options.extent = GUSSET_EXTENT_OPEN_ARCS, GUSSET_ERROR_PLANES_UNDECIDED);
    OPTION((options.extent = GUSSET_EXTENT_OPEN_ARCS, options.twist = 1), GUSSET_ERROR_OUT_OF_RANGE);
    OPTION((options.rows = GUSSET_ROWS_COUNT, options.row_count = UINT32_MAX), GUSSET_ERROR_TOO_LARGE);

    EXPECT(GUSSET_OK, gusset_stitch(context, &up, NULL, &down, NULL, NULL, &stitch));
    memset(&view, 0xff, sizeof view), view.struct_size = sizeof view;
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_result_get_mesh(NULL, &view));
    CHECK(view.positions == NULL && view.face_count == 0 && view.struct_size == sizeof view);
    memset(&view, 0xff, sizeof view), view.struct_size = sizeof view;
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_result_get_strip_mesh(NULL, &view));
    CHECK(view.positions == NULL && view.face_count == 0);
    memset(&parts, 0xff, sizeof parts), parts.struct_size = sizeof parts;
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_result_get_stitch(NULL, &parts));
    CHECK(parts.rim[1].data == NULL && parts.turned == 0);
    memset(&quality, 0xff, sizeof quality), quality.struct_size = sizeof quality;
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_result_get_quality(NULL, &quality));
    CHECK(quality.area == 0.0 && quality.loops_left == 0);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_result_get_mesh(stitch, NULL));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_result_get_strip_mesh(stitch, NULL));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_result_get_stitch(stitch, NULL));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_result_get_quality(stitch, NULL));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_result_get_mesh(misaligned(), &view));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_result_get_strip_mesh(misaligned(), &view));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_result_get_stitch(misaligned(), &parts));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_result_get_quality(misaligned(), &quality));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_result_get_mesh(stitch, misaligned()));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_result_get_strip_mesh(stitch, misaligned()));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_result_get_stitch(stitch, misaligned()));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_result_get_quality(stitch, misaligned()));
    view.struct_size = parts.struct_size = quality.struct_size = 8;
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_result_get_mesh(stitch, &view));
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_result_get_strip_mesh(stitch, &view));
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_result_get_stitch(stitch, &parts));
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_result_get_quality(stitch, &quality));
    gusset_result_destroy(stitch);
    gusset_result_destroy(NULL);
}

/* Loop B, or the pieces, are refused with this status; the report names the element. */
static void unstitchable(const gusset_mesh_view *a, const gusset_indices *loop_a, const gusset_mesh_view *b,
                         const gusset_indices *loop_b, const gusset_stitch_options *options, gusset_status status,
                         gusset_element element, uint64_t index, uint32_t input) {
    gusset_result *stitch = (gusset_result *)misaligned();
    gusset_error_report report = {sizeof report, 0, 0, 0, 0.0, 0, 0};
    EXPECT(status, gusset_stitch(context, a, loop_a, b, loop_b, options, &stitch));
    CHECK(stitch == NULL);
    EXPECT(GUSSET_OK, gusset_context_get_report(context, &report));
    CHECK(report.status == status && report.element == element && report.index == index && report.input == input);
    if (report.element != element || report.index != index || report.input != input) {
        printf("  status %d: element %u index %llu input %u\n", (int)status, (unsigned)report.element,
               (unsigned long long)report.index, (unsigned)report.input);
    }
    fit_for_more(context);
}

static void loops(void) {
    const gusset_mesh_view up = pyramid(pyramid_up), down = pyramid(pyramid_down);
    gusset_mesh_view closed = up, turned = down, narrow = up;
    float floats[5][3] = {{0, 0, 2}, {1, 0, 1}, {0, 1, 1}, {-1, 0, 1}, {0, -1, 1}};
    const uint32_t closed_faces[12] = {1, 3, 2, 0, 1, 2, 0, 2, 3, 0, 3, 1};
    const uint32_t turned_faces[12] = {0, 2, 1, 0, 3, 2, 0, 4, 3, 0, 1, 4};
    uint32_t places[5] = {1, 2, 3, 4, 1};
    char bytes[1 + sizeof places];
    gusset_indices loop = {places, 4};
    gusset_stitch_options refuse = {0};
    gusset_result *stitch = NULL;

    refuse.struct_size = sizeof refuse;
    refuse.orientation = GUSSET_ORIENTATION_REFUSE;
    closed.face_corners = closed_faces;
    unstitchable(&up, NULL, &closed, NULL, NULL, GUSSET_ERROR_NO_LOOP, GUSSET_ELEMENT_NONE, 0, 1);
    unstitchable(&closed, NULL, &up, NULL, NULL, GUSSET_ERROR_NO_LOOP, GUSSET_ELEMENT_NONE, 0, 0);
    /* One mesh with one loop only. */
    unstitchable(&up, NULL, NULL, NULL, NULL, GUSSET_ERROR_NO_LOOP, GUSSET_ELEMENT_NONE, 0, 0);
    unstitchable(&up, &loop, NULL, &loop, NULL, GUSSET_ERROR_LOOPS_SHARE_VERTEX, GUSSET_ELEMENT_VERTEX, 1, 0);
    loop.count = 2;
    unstitchable(&up, NULL, &down, &loop, NULL, GUSSET_ERROR_LOOP_TOO_SHORT, GUSSET_ELEMENT_COUNT, 2, 1);
    loop.data = NULL, loop.count = 0;
    unstitchable(&up, &loop, &down, NULL, NULL, GUSSET_ERROR_LOOP_TOO_SHORT, GUSSET_ELEMENT_COUNT, 0, 0);
    loop.count = SIZE_MAX;
    unstitchable(&up, NULL, &down, &loop, NULL, GUSSET_ERROR_TOO_LARGE, GUSSET_ELEMENT_COUNT, SIZE_MAX, 1);
    loop.data = places, loop.count = 5;
    unstitchable(&up, NULL, &down, &loop, NULL, GUSSET_ERROR_LOOP_REPEATS_VERTEX, GUSSET_ELEMENT_VERTEX, 1, 1);
    loop.count = 4, places[2] = 0;
    unstitchable(&up, NULL, &down, &loop, NULL, GUSSET_ERROR_LOOP_EDGE_NOT_FREE, GUSSET_ELEMENT_LOOP_PLACE, 1, 1);
    places[2] = UINT32_MAX;
    unstitchable(&up, &loop, &down, NULL, NULL, GUSSET_ERROR_INDEX_OUT_OF_RANGE, GUSSET_ELEMENT_LOOP_PLACE, 2, 0);

    turned.face_corners = turned_faces;
    unstitchable(&up, NULL, &turned, NULL, &refuse, GUSSET_ERROR_ORIENTATION_CONFLICT, GUSSET_ELEMENT_FACE, 0, 1);
    narrow.positions = floats, narrow.scalar = GUSSET_F32;
    unstitchable(&narrow, NULL, &down, NULL, NULL, GUSSET_ERROR_MIXED_SCALARS, GUSSET_ELEMENT_NONE, 0, 1);
    EXPECT(GUSSET_OK, gusset_stitch(context, &down, NULL, &narrow, NULL, NULL, &stitch));
    gusset_result_destroy(stitch);

    /* Indices at an odd address are valid. */
    places[2] = 3;
    memcpy(bytes + 1, places, sizeof places);
    loop.data = (const uint32_t *)(const void *)(bytes + 1);
    EXPECT(GUSSET_OK, gusset_stitch(context, &up, &loop, &down, NULL, NULL, &stitch));
    gusset_result_destroy(stitch);
}

int main(void) {
    if (gusset_context_create(&context) != GUSSET_OK) {
        return 1;
    }
    stitch_pointers();
    loops();
    fit_for_more(context);
    gusset_context_destroy(context);
    return failures != 0;
}

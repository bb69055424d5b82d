/* Calls gusset_develop with invalid arguments, and checks the errors. */
#include "check.h"
#include <math.h>
#include <stddef.h>

static gusset_context *context;

static const double points[5][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0.5}, {0, 1, 0}, {9, 9, 9}};
static const uint32_t corners[2][3] = {{0, 1, 2}, {0, 2, 3}};

int main(void) {
    gusset_mesh_view mesh = {.struct_size = sizeof mesh, .scalar = GUSSET_F64, .face_size = 3};
    gusset_develop_options options = {.struct_size = sizeof options};
    gusset_develop_report view = {.struct_size = sizeof view};
    gusset_mesh_view flat = {.struct_size = sizeof flat};
    gusset_result *done = NULL;
    uint32_t repeated[2][3] = {{0, 1, 2}, {0, 2, 2}};
    const uint32_t path[3] = {0, 4, 2}, beyond[2] = {0, 7}, offsets[3] = {0, 2, 1}, late[2] = {1, 3};
    double wild[5][3] = {{0, 0, 0}, {1, 0, 0}, {1, NAN, 0.5}, {0, 1, 0}, {9, 9, 9}};

    if (gusset_context_create(&context) != GUSSET_OK) {
        return 1;
    }
    mesh.positions = points, mesh.vertex_count = 5, mesh.face_corners = corners, mesh.face_count = 2;

    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_develop(context, &mesh, NULL, NULL));
    FAILS(GUSSET_ERROR_NULL_ARGUMENT, done, gusset_develop(context, NULL, NULL, &done));
    FAILS(GUSSET_ERROR_MISALIGNED_ARGUMENT, done, gusset_develop(context, misaligned(), NULL, &done));
    FAILS(GUSSET_ERROR_MISALIGNED_ARGUMENT, done, gusset_develop(context, &mesh, misaligned(), &done));
    options.struct_size = 8;
    FAILS(GUSSET_ERROR_BAD_STRUCT_SIZE, done, gusset_develop(context, &mesh, &options, &done));
    options.struct_size = sizeof options, options.distortion = 3;
    FAILS(GUSSET_ERROR_UNKNOWN_VALUE, done, gusset_develop(context, &mesh, &options, &done));
    options.distortion = 0, options.reserved = 1;
    FAILS(GUSSET_ERROR_UNKNOWN_VALUE, done, gusset_develop(context, &mesh, &options, &done));
    options.reserved = 0, options.max_stretch = 1.0;
    FAILS(GUSSET_ERROR_OUT_OF_RANGE, done, gusset_develop(context, &mesh, &options, &done));
    options.max_stretch = NAN;
    FAILS(GUSSET_ERROR_OUT_OF_RANGE, done, gusset_develop(context, &mesh, &options, &done));
    options.max_stretch = INFINITY;
    FAILS(GUSSET_ERROR_OUT_OF_RANGE, done, gusset_develop(context, &mesh, &options, &done));
    options.max_stretch = 0.0;

    options.cuts.count = 2;
    FAILS(GUSSET_ERROR_NULL_ARGUMENT, done, gusset_develop(context, &mesh, &options, &done));
    options.cuts.data = beyond;
    FAILS(GUSSET_ERROR_INDEX_OUT_OF_RANGE, done, gusset_develop(context, &mesh, &options, &done));
    REPORT(context, GUSSET_ERROR_INDEX_OUT_OF_RANGE, GUSSET_ELEMENT_LOOP_PLACE, 1, 0);
    options.cuts.data = path, options.cuts.count = 3;
    FAILS(GUSSET_ERROR_CUT_NOT_CONNECTED, done, gusset_develop(context, &mesh, &options, &done));
    REPORT(context, GUSSET_ERROR_CUT_NOT_CONNECTED, GUSSET_ELEMENT_LOOP_PLACE, 1, 0);
    options.cut_offsets.data = offsets, options.cut_offsets.count = 3;
    FAILS(GUSSET_ERROR_BAD_OFFSETS, done, gusset_develop(context, &mesh, &options, &done));
    REPORT(context, GUSSET_ERROR_BAD_OFFSETS, GUSSET_ELEMENT_OFFSET, 2, 0);
    options.cut_offsets.data = late, options.cut_offsets.count = 2;
    FAILS(GUSSET_ERROR_BAD_OFFSETS, done, gusset_develop(context, &mesh, &options, &done));
    REPORT(context, GUSSET_ERROR_BAD_OFFSETS, GUSSET_ELEMENT_OFFSET, 0, 0);
    options.cuts.count = options.cut_offsets.count = 0;

    mesh.face_corners = repeated;
    FAILS(GUSSET_ERROR_REPEATED_CORNER, done, gusset_develop(context, &mesh, &options, &done));
    REPORT(context, GUSSET_ERROR_REPEATED_CORNER, GUSSET_ELEMENT_FACE, 1, 0);
    mesh.face_corners = corners, mesh.positions = wild;
    FAILS(GUSSET_ERROR_NOT_FINITE, done, gusset_develop(context, &mesh, &options, &done));
    mesh.positions = points;

    EXPECT(GUSSET_OK, gusset_develop(context, &mesh, &options, &done));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_result_get_develop(NULL, &view));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_result_get_develop(done, NULL));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_result_get_mesh(NULL, &flat));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_result_get_mesh(done, NULL));
    view.struct_size = 8;
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_result_get_develop(done, &view));
    view.struct_size = sizeof view;
    EXPECT(GUSSET_OK, gusset_result_get_develop(done, &view));
    CHECK(view.chart_count == 1 && view.vertex_map.count == 4 && view.charts[0].finish == GUSSET_CHART_EXACT);
    gusset_result_destroy(done);
    gusset_result_destroy(NULL);
    gusset_context_destroy(context);
    return failures != 0;
}

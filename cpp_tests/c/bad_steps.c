/* Calls the single steps of stitching with invalid and valid arguments, and checks errors and results. */
#include "check.h"
#include <math.h>

static gusset_context *context;

static void steps(void) {
    double a[6] = {0, 0, 0, 0, 1, 0}, b[6] = {2, 0, 0, 2, 1, 0};
    char bytes[1 + sizeof a];
    gusset_facing_options options = {0};
    gusset_facing *facing = (gusset_facing *)misaligned();
    gusset_facing_view view;
    gusset_error_report report = {sizeof report, 0, 0, 0, 0.0, 0, 0};
    uint32_t j[8] = {9, 9, 9, 9, 9, 9, 9, 9};
    size_t written = 7;

    /* Both vertices of each lie on the plane through their centre. */
    EXPECT(GUSSET_ERROR_PLANES_UNDECIDED, gusset_facing_create(context, a, 2, b, 2, NULL, &facing));
    CHECK(facing == NULL);
    a[3] = 0.5;
    EXPECT(GUSSET_ERROR_PLANES_UNDECIDED, gusset_facing_create(context, a, 2, b, 2, NULL, &facing));
    EXPECT(GUSSET_OK, gusset_context_get_report(context, &report));
    CHECK(report.input == 1);
    b[0] = 1.5;
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_facing_create(context, NULL, 2, b, 2, NULL, &facing));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_facing_create(context, a, 2, NULL, 2, NULL, &facing));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_facing_create(context, a, 2, b, 2, NULL, NULL));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_facing_create(misaligned(), a, 2, b, 2, NULL, &facing));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_facing_create(context, a, 2, b, 2, misaligned(), &facing));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_facing_create(context, a, 2, b, 2, NULL, misaligned()));
    EXPECT(GUSSET_ERROR_LOOP_TOO_SHORT, gusset_facing_create(context, a, 0, b, 2, NULL, &facing));
    EXPECT(GUSSET_ERROR_TOO_LARGE, gusset_facing_create(context, a, SIZE_MAX, b, 2, NULL, &facing));
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_facing_create(context, a, 2, b, 2, &options, &facing));
    options.struct_size = sizeof options, options.run = 2;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_facing_create(context, a, 2, b, 2, &options, &facing));
    options.run = 1, options.tolerance_mode = 3;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_facing_create(context, a, 2, b, 2, &options, &facing));
    options.tolerance_mode = 1, options.tolerance = NAN;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_facing_create(context, a, 2, b, 2, &options, &facing));
    b[4] = NAN;
    EXPECT(GUSSET_ERROR_NOT_FINITE, gusset_facing_create(context, a, 2, b, 2, NULL, &facing));
    EXPECT(GUSSET_OK, gusset_context_get_report(context, &report));
    CHECK(report.input == 1 && report.element == GUSSET_ELEMENT_LOOP_PLACE && report.index == 1 && facing == NULL);
    b[4] = 1.0;

    memcpy(bytes + 1, a, sizeof a);
    EXPECT(GUSSET_OK, gusset_facing_create(context, (const double *)(const void *)(bytes + 1), 2, b, 2, NULL, &facing));
    memset(&view, 0xff, sizeof view), view.struct_size = sizeof view;
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_facing_get_view(NULL, &view));
    CHECK(view.distances[0] == NULL && view.taken[1][1] == 0);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_facing_get_view(facing, NULL));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_facing_get_view(misaligned(), &view));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_facing_get_view(facing, misaligned()));
    EXPECT(GUSSET_OK, gusset_facing_get_view(facing, &view));
    CHECK(view.centre[0][0] == 0.25 && view.centre[1][0] == 1.75 && view.normal[0][0] == 1.5 && view.normal[1][0] == -1.5);
    CHECK(view.runs[0].count == 2 && view.taken[0][0] == 1 && view.taken[0][1] == 1 && view.taken[1][0] == 0);
    CHECK(view.distances[0][0] == -0.25 && view.distances[0][1] == 0.25 && view.distances[1][0] == 0.25);
    view.struct_size = 8;
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_facing_get_view(facing, &view));
    gusset_facing_destroy(facing);
    gusset_facing_destroy(NULL);

    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_meridians_index(5, 3, j, 8, NULL));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_meridians_index(5, 3, j, 8, misaligned()));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_meridians_index(5, 3, misaligned(), 8, &written));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_meridians_index(5, 3, NULL, 8, &written));
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_meridians_index(3, 5, j, 8, &written));
    CHECK(written == 0);
    EXPECT(GUSSET_OK, gusset_meridians_index(5, 3, NULL, 0, &written));
    CHECK(written == 6);
    EXPECT(GUSSET_ERROR_BUFFER_TOO_SMALL, gusset_meridians_index(5, 3, j, 5, &written));
    CHECK(written == 6 && j[0] == 9);
    /* The paper's example: 1 2 2 3 3 4, from 1. */
    EXPECT(GUSSET_OK, gusset_meridians_index(5, 3, j, 8, &written));
    CHECK(j[0] == 0 && j[1] == 1 && j[2] == 1 && j[3] == 2 && j[4] == 2 && j[5] == 3 && j[6] == 9);
}

int main(void) {
    const gusset_mesh_view mesh = pyramid(pyramid_up), other = pyramid(pyramid_down);
    if (gusset_context_create(&context) != GUSSET_OK) {
        return 1;
    }
    CHECK(mesh.positions != other.positions);
    steps();
    gusset_context_destroy(context);
    return failures != 0;
}

/* Calls functions of net handles with invalid and valid arguments, and checks errors and results. */
#include "check.h"
#include <math.h>

static gusset_context *context;
static float x[12], y[12], z[12];

/* 3 x 4 nodes: x = column, y = row, z = 0. */
static gusset_net_view grid(void) {
    gusset_net_view arrays = {sizeof arrays, 3, 4, x, y, z, 0, 0, GUSSET_F32, 0};
    for (int k = 0; k < 12; k++) {
        x[k] = (float)(k % 4);
        y[k] = (float)(k / 4);
        z[k] = 0;
    }
    return arrays;
}

static gusset_net *net_of(const gusset_net_gluing *gluing) {
    gusset_net *net = NULL;
    const gusset_net_view arrays = grid();
    EXPECT(GUSSET_OK, gusset_net_create(context, &arrays, gluing, GUSSET_NET_MEMORY_COPY, &net));
    return net;
}

static void creation(void) {
    gusset_net *net = (gusset_net *)misaligned();
    gusset_net_view arrays = grid(), bad;

    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_create(context, NULL, NULL, GUSSET_NET_MEMORY_COPY, &net));
    CHECK(net == NULL);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_create(context, &arrays, NULL, GUSSET_NET_MEMORY_COPY, NULL));
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_net_create(context, &arrays, NULL, 2, &net));
    bad = arrays, bad.rows = 1;
    EXPECT(GUSSET_ERROR_NET_TOO_SMALL, gusset_net_create(context, &bad, NULL, GUSSET_NET_MEMORY_COPY, &net));
    bad = arrays, bad.columns = 0;
    EXPECT(GUSSET_ERROR_NET_TOO_SMALL, gusset_net_create(context, &bad, NULL, GUSSET_NET_MEMORY_COPY, &net));
    bad = arrays, bad.rows = SIZE_MAX;
    EXPECT(GUSSET_ERROR_TOO_LARGE, gusset_net_create(context, &bad, NULL, GUSSET_NET_MEMORY_COPY, &net));
    bad = arrays, bad.scalar = 0;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_net_create(context, &bad, NULL, GUSSET_NET_MEMORY_COPY, &net));
    bad = arrays, bad.reserved = 1;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_net_create(context, &bad, NULL, GUSSET_NET_MEMORY_COPY, &net));
    bad = arrays, bad.struct_size = 8;
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_net_create(context, &bad, NULL, GUSSET_NET_MEMORY_COPY, &net));
    bad = arrays, bad.y = NULL;
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_create(context, &bad, NULL, GUSSET_NET_MEMORY_COPY, &net));
    bad = arrays, bad.row_stride = 15;
    EXPECT(GUSSET_ERROR_BAD_STRIDE, gusset_net_create(context, &bad, NULL, GUSSET_NET_MEMORY_COPY, &net));
    bad = arrays, bad.column_stride = 3;
    EXPECT(GUSSET_ERROR_BAD_STRIDE, gusset_net_create(context, &bad, NULL, GUSSET_NET_MEMORY_COPY, &net));
    bad = arrays, bad.row_stride = SIZE_MAX;
    EXPECT(GUSSET_ERROR_SIZE_OVERFLOW, gusset_net_create(context, &bad, NULL, GUSSET_NET_MEMORY_COPY, &net));
    CHECK(net == NULL);
    gusset_net_destroy(NULL);
}

/* Points that lie as x, y, z, at an odd address. */
static void layouts(void) {
    unsigned char bytes[12 * 24 + 1], out[12 * 24];
    gusset_net_view arrays = {sizeof arrays, 3, 4, bytes + 1, bytes + 9, bytes + 17, 0, 24, GUSSET_F64, 0}, view;
    gusset_net *net = NULL;

    for (int k = 0; k < 36; k++) {
        const double value = k;
        memcpy(bytes + 1 + 8 * k, &value, 8);
    }
    EXPECT(GUSSET_OK, gusset_net_create(context, &arrays, NULL, GUSSET_NET_MEMORY_COPY, &net));
    view.struct_size = sizeof view;
    EXPECT(GUSSET_OK, gusset_net_get_view(net, &view));
    CHECK(view.rows == 3 && view.columns == 4 && view.scalar == GUSSET_F64 && view.column_stride == 8);
    CHECK(((const double *)view.y)[5] == 16.0 && ((const double *)view.z)[11] == 35.0);
    arrays.x = out, arrays.y = out + 8, arrays.z = out + 16;
    EXPECT(GUSSET_OK, gusset_net_read(context, net, &arrays));
    CHECK(memcmp(out, bytes + 1, sizeof out) == 0);
    arrays.rows = 4;
    EXPECT(GUSSET_ERROR_SIDES_DIFFER, gusset_net_read(context, net, &arrays));
    arrays = grid();
    EXPECT(GUSSET_OK, gusset_net_read(context, net, &arrays));
    CHECK(x[1] == 3.0f && y[11] == 34.0f);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_read(context, NULL, &arrays));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_get_view(NULL, &view));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_get_view(net, NULL));
    gusset_net_destroy(net);
}

static void borrowing(void) {
    gusset_net_view arrays = grid(), bad = arrays, view = arrays;
    gusset_net *net = NULL, *copy = NULL;

    bad.y = x + 4;
    EXPECT(GUSSET_ERROR_OVERLAP, gusset_net_create(context, &bad, NULL, GUSSET_NET_MEMORY_BORROW, &net));
    bad = arrays, bad.x = (char *)x + 1;
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_net_create(context, &bad, NULL, GUSSET_NET_MEMORY_BORROW, &net));
    bad = arrays, bad.column_stride = 8;
    EXPECT(GUSSET_ERROR_BAD_STRIDE, gusset_net_create(context, &bad, NULL, GUSSET_NET_MEMORY_BORROW, &net));
    bad = arrays, bad.z = NULL;
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_create(context, &bad, NULL, GUSSET_NET_MEMORY_BORROW, &net));
    EXPECT(GUSSET_OK, gusset_net_create(context, &arrays, NULL, GUSSET_NET_MEMORY_BORROW, &net));
    EXPECT(GUSSET_OK, gusset_net_get_view(net, &view));
    CHECK(view.x == x && view.y == y && view.z == z && view.row_stride == 16);
    EXPECT(GUSSET_OK, gusset_net_copy_create(context, net, NULL, &copy));
    EXPECT(GUSSET_OK, gusset_net_edit(context, net, &view));
    CHECK(view.x == x);
    ((float *)view.x)[0] = 7;
    CHECK(x[0] == 7.0f);
    EXPECT(GUSSET_OK, gusset_net_get_view(copy, &view));
    CHECK(view.x != x && ((const float *)view.x)[0] == 0.0f);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_edit(context, NULL, &view));
    gusset_net_destroy(copy);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_copy_create(context, NULL, NULL, &copy));
    CHECK(copy == NULL);
    gusset_net_destroy(net);
}

/* A copy shares memory until one of the two is changed. */
static void sharing(void) {
    gusset_net *net = net_of(NULL), *copy = NULL;
    gusset_net_view first = {0}, second = {0};
    first.struct_size = second.struct_size = sizeof first;

    EXPECT(GUSSET_OK, gusset_net_copy_create(context, net, NULL, &copy));
    EXPECT(GUSSET_OK, gusset_net_get_view(net, &first));
    EXPECT(GUSSET_OK, gusset_net_get_view(copy, &second));
    CHECK(first.x == second.x);
    EXPECT(GUSSET_OK, gusset_net_edit(context, copy, &second));
    CHECK(first.x != second.x);
    ((float *)second.x)[3] = -1;
    CHECK(((const float *)first.x)[3] == 3.0f);
    gusset_net_destroy(net);
    CHECK(((const float *)second.x)[3] == -1.0f);
    gusset_net_destroy(copy);
}

static gusset_net_gluing_report report_of(const gusset_net *net) {
    gusset_net_gluing_report report = {0};
    report.struct_size = sizeof report;
    EXPECT(GUSSET_OK, gusset_net_get_gluing(net, NULL, 0, NULL, 0, &report));
    return report;
}

static void gluing(void) {
    gusset_net_gluing_report report;
    gusset_net_gluing gluing = {0};
    gusset_seam seam = {0, 0, 1, 0, 2, 3, -1, 0, 3, 0}, read[1];
    gusset_net *net = NULL;
    gusset_net_view arrays = grid();
    uint8_t matrix[24] = {0}, got[24];

    gluing.struct_size = sizeof gluing;
    gluing.sides = 64;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_net_create(context, &arrays, &gluing, GUSSET_NET_MEMORY_COPY, &net));
    gluing.sides = GUSSET_SIDES_TUBE, gluing.matrix = matrix;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_net_create(context, &arrays, &gluing, GUSSET_NET_MEMORY_COPY, &net));
    gluing.sides = 0, matrix[0] = 2;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_net_create(context, &arrays, &gluing, GUSSET_NET_MEMORY_COPY, &net));
    matrix[0] = 0, gluing.matrix = NULL, gluing.reversed = 2;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_net_create(context, &arrays, &gluing, GUSSET_NET_MEMORY_COPY, &net));
    gluing.reversed = 0, gluing.seam_count = 1;
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_create(context, &arrays, &gluing, GUSSET_NET_MEMORY_COPY, &net));
    gluing.seams = &seam, seam.count = 4;
    EXPECT(GUSSET_ERROR_BAD_SEAM, gusset_net_create(context, &arrays, &gluing, GUSSET_NET_MEMORY_COPY, &net));
    /* One pair again and again is refused at once, not walked. */
    seam.count = UINT32_MAX, seam.row_step_a = seam.row_step_b = 0;
    EXPECT(GUSSET_ERROR_BAD_SEAM, gusset_net_create(context, &arrays, &gluing, GUSSET_NET_MEMORY_COPY, &net));
    seam.row_step_a = 1, seam.row_step_b = -1;
    seam.count = 3, seam.reserved = 1;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_net_create(context, &arrays, &gluing, GUSSET_NET_MEMORY_COPY, &net));
    seam.reserved = 0;

    /* A Moebius strip. */
    net = net_of(&gluing);
    report = report_of(net);
    CHECK(report.sides == GUSSET_SIDES_SHEET && report.seam_count == 1 && report.reversed == 0);
    CHECK(report.bridge_count == 0 && report.matrix_size == 24);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_get_gluing(net, NULL, 0, NULL, 1, NULL));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_get_gluing(net, NULL, 0, NULL, 1, &report));
    CHECK(report.seam_count == 0 && report.matrix_size == 0);
    EXPECT(GUSSET_ERROR_BUFFER_TOO_SMALL, gusset_net_get_gluing(net, NULL, 0, read, 0, &report));
    EXPECT(GUSSET_OK, gusset_net_get_gluing(net, NULL, 0, read, 1, &report));
    CHECK(read[0].count == 3 && report.seam_count == 1);
    report.struct_size = 8;
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_net_get_gluing(net, NULL, 0, read, 1, &report));
    report.struct_size = sizeof report;

    /* Closed rows, said by the matrix, are sides. */
    memset(&gluing, 0, sizeof gluing);
    gluing.struct_size = sizeof gluing;
    gluing.matrix = matrix;
    matrix[3] = matrix[11] = matrix[19] = 1;
    EXPECT(GUSSET_OK, gusset_net_set_gluing(context, net, &gluing));
    report = report_of(net);
    CHECK(report.sides == GUSSET_SIDES_TUBE && report.seam_count == 0 && report.matrix_size == 24);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_get_gluing(net, NULL, 24, NULL, 0, &report));
    EXPECT(GUSSET_ERROR_BUFFER_TOO_SMALL, gusset_net_get_gluing(net, got, 23, NULL, 0, &report));
    EXPECT(GUSSET_OK, gusset_net_get_gluing(net, got, 24, read, 1, &report));
    CHECK(memcmp(got, matrix, 24) == 0 && report.seam_count == 0);

    /* Both diagonals of a cell: refused, and nothing is lost. */
    {
        const gusset_seam cross[2] = {{0, 0, 0, 0, 1, 1, 0, 0, 1, 0}, {0, 1, 0, 0, 1, 0, 0, 0, 1, 0}};
        gluing.matrix = NULL, gluing.seams = cross, gluing.seam_count = 2;
        EXPECT(GUSSET_ERROR_CROSSING_CELL, gusset_net_set_gluing(context, net, &gluing));
        gluing.seam_count = 1;
        CHECK(report_of(net).sides == GUSSET_SIDES_TUBE);
        EXPECT(GUSSET_OK, gusset_net_set_gluing(context, net, &gluing));
        CHECK(report_of(net).sides == GUSSET_SIDES_SHEET && report_of(net).seam_count == 1);
    }
    EXPECT(GUSSET_OK, gusset_net_set_gluing(context, net, NULL));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_set_gluing(context, NULL, NULL));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_get_gluing(NULL, NULL, 0, NULL, 0, &report));
    gusset_net_destroy(net);
}

/* Column after column, as some hosts keep matrices; and the other scalar type. */
static void other_orders_and_types(void) {
    const double columns[3][6] = {{0, 0, 1, 1, 2, 2}, {0, 5, 0, 5, 0, 5}, {1e300, 0, 0, 0, 0, 0}};
    double back[3][6];
    gusset_net_view arrays = {sizeof arrays,       2, 3, (void *)(uintptr_t)columns[0], (void *)(uintptr_t)columns[1],
                                (void *)(uintptr_t)columns[2], 8, 16, GUSSET_F64,        0},
                      view = {0};
    gusset_net_copy_options options = {0};
    gusset_net *net = NULL, *single = NULL;

    options.struct_size = sizeof options, options.scalar = GUSSET_F32;
    EXPECT(GUSSET_OK, gusset_net_create(context, &arrays, NULL, GUSSET_NET_MEMORY_COPY, &net));
    view.struct_size = sizeof view;
    EXPECT(GUSSET_OK, gusset_net_get_view(net, &view));
    CHECK(((const double *)view.x)[2] == 2 && ((const double *)view.y)[3] == 5 && ((const double *)view.x)[5] == 2);
    arrays.x = back[0], arrays.y = back[1], arrays.z = back[2];
    EXPECT(GUSSET_OK, gusset_net_read(context, net, &arrays));
    CHECK(memcmp(back, columns, sizeof back) == 0);
    arrays.row_stride = 16;
    EXPECT(GUSSET_ERROR_BAD_STRIDE, gusset_net_read(context, net, &arrays));
    EXPECT(GUSSET_OK, gusset_net_copy_create(context, net, &options, &single));
    EXPECT(GUSSET_OK, gusset_net_get_view(single, &view));
    CHECK(view.scalar == GUSSET_F32 && ((const float *)view.y)[3] == 5.0f && isinf(((const float *)view.z)[0]));
    gusset_net_destroy(single);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_copy_create(context, NULL, &options, &single));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_copy_create(context, net, &options, NULL));
    options.scalar = 3;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_net_copy_create(context, net, &options, &single));
    CHECK(single == NULL);
    /* A copy in the type of the net shares its memory. */
    options.scalar = GUSSET_F64;
    EXPECT(GUSSET_OK, gusset_net_copy_create(context, net, &options, &single));
    arrays.struct_size = sizeof arrays;
    EXPECT(GUSSET_OK, gusset_net_get_view(net, &arrays));
    EXPECT(GUSSET_OK, gusset_net_get_view(single, &view));
    CHECK(view.x == arrays.x && view.scalar == GUSSET_F64);
    gusset_net_destroy(single);
    gusset_net_destroy(net);
}

/* A map that overflows is refused and moves no node. A cancelled call leaves cleared outputs. */
static void nothing_is_lost(void) {
    gusset_net *net = net_of(NULL);
    gusset_net_view before = {0}, after = {0};
    gusset_operation far_away = {GUSSET_OPERATION_TRANSLATE, 0, {1e39}};
    gusset_glue_options snap = {0};
    gusset_scene *scene = NULL;
    uint64_t moved = 777;
    uint32_t entry = 777;

    before.struct_size = after.struct_size = sizeof before;
    snap.struct_size = sizeof snap, snap.snap = 1;
    EXPECT(GUSSET_OK, gusset_net_get_view(net, &before));
    EXPECT(GUSSET_ERROR_FIELD_UNDEFINED, gusset_net_transform(context, net, &far_away, 1));
    far_away.values[0] = 1e37;
    EXPECT(GUSSET_OK, gusset_net_transform(context, net, &far_away, 1));
    EXPECT(GUSSET_OK, gusset_net_get_view(net, &after));
    CHECK(((const float *)after.x)[3] == 1e37f);
    EXPECT(GUSSET_OK, gusset_scene_create(context, &scene));
    gusset_context_cancel(context);
    EXPECT(GUSSET_ERROR_CANCELLED, gusset_net_glue(context, net, &snap, &moved));
    CHECK(moved == 0);
    EXPECT(GUSSET_ERROR_CANCELLED, gusset_scene_add(context, scene, NULL, &entry));
    CHECK(entry == UINT32_MAX);
    after.x = &moved;
    EXPECT(GUSSET_ERROR_CANCELLED, gusset_net_edit(context, net, &after));
    CHECK(after.x == NULL);
    gusset_context_reset(context);
    gusset_scene_destroy(scene);
    gusset_net_destroy(net);
}

int main(void) {
    const gusset_mesh_view up = pyramid(pyramid_up), down = pyramid(pyramid_down);
    if (gusset_context_create(&context) != GUSSET_OK || up.face_count != down.face_count) {
        return 1;
    }
    creation();
    layouts();
    borrowing();
    sharing();
    gluing();
    other_orders_and_types();
    nothing_is_lost();
    gusset_context_destroy(context);
    return failures != 0;
}

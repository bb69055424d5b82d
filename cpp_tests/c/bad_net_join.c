/* Nets copied, resampled, joined, taken apart, as meshes: what a host can get wrong, and what it gets if it does not. */
#include "check.h"
#include <math.h>

static gusset_context *context;

/* rows x columns nodes: x = column + shift, y = row, z = 0. */
static gusset_net *grid(size_t rows, size_t columns, double shift, gusset_sides sides) {
    static double x[64], y[64], z[64];
    const gusset_net_view arrays = {sizeof arrays, rows, columns, x, y, z, 0, 0, GUSSET_F64, 0};
    gusset_net_gluing gluing;
    gusset_net *net = NULL;

    memset(&gluing, 0, sizeof gluing);
    gluing.struct_size = sizeof gluing;
    gluing.sides = sides;
    for (size_t k = 0; k < rows * columns; k++) {
        x[k] = (double)(k % columns) + shift;
        y[k] = (double)(k / columns);
        z[k] = 0;
    }
    EXPECT(GUSSET_OK, gusset_net_create(context, &arrays, &gluing, GUSSET_NET_MEMORY_COPY, &net));
    return net;
}

static double at(const gusset_net *net, int axis, size_t i, size_t j) {
    gusset_net_view view;
    view.struct_size = sizeof view;
    EXPECT(GUSSET_OK, gusset_net_get_view(net, &view));
    return ((const double *)(axis == 0 ? view.x : axis == 1 ? view.y : view.z))[i * view.columns + j];
}

static int has_size(const gusset_net *net, size_t rows, size_t columns) {
    gusset_net_view view;
    view.struct_size = sizeof view;
    EXPECT(GUSSET_OK, gusset_net_get_view(net, &view));
    return view.rows == rows && view.columns == columns;
}

static void arranged(void) {
    gusset_net *net = grid(3, 5, 0, GUSSET_SIDES_TUBE), *out = (gusset_net *)misaligned(), *back = NULL;
    /* Number (0, 0) of x and y, and the number of rows, under each symmetry. */
    static const double turned[8][3] = {{0, 0, 3}, {4, 0, 5}, {4, 2, 3}, {0, 2, 5}, {4, 0, 3}, {0, 2, 3}, {0, 0, 5}, {4, 2, 5}};
    const gusset_net_copy_options none = {.struct_size = sizeof none};
    const gusset_net_copy_options part = {
        .struct_size = sizeof part, .row_first = 1, .row_count = 2, .column_first = 2, .column_count = 3};
    const gusset_net_copy_options larger = {.struct_size = sizeof larger,
                                            .rows = 5,
                                            .row_replication = GUSSET_REPLICATE_AT,
                                            .column_replication = GUSSET_REPLICATE_LAST,
                                            .row_index = 1};
    gusset_net_copy_options given;

    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_copy_create(context, NULL, &part, &out));
    CHECK(out == NULL);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_copy_create(context, net, &part, NULL));
    given = part, given.row_count = 1;
    EXPECT(GUSSET_ERROR_NET_TOO_SMALL, gusset_net_copy_create(context, net, &given, &out));
    given = part, given.row_first = 2;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_net_copy_create(context, net, &given, &out));
    given = part, given.column_first = SIZE_MAX;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_net_copy_create(context, net, &given, &out));
    given.column_count = 0;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_net_copy_create(context, net, &given, &out));
    CHECK(out == NULL);
    EXPECT(GUSSET_OK, gusset_net_copy_create(context, net, &part, &out));
    CHECK(has_size(out, 2, 3) && at(out, 0, 0, 0) == 2 && at(out, 1, 1, 2) == 2);
    gusset_net_destroy(out);
    given = none, given.row_first = 1; /* as many rows as there are from there on, and all columns */
    EXPECT(GUSSET_OK, gusset_net_copy_create(context, net, &given, &out));
    CHECK(has_size(out, 2, 5) && at(out, 1, 0, 0) == 1);
    gusset_net_destroy(out);

    for (uint32_t turn = 0; turn < 8; ++turn) {
        given = none, given.turn = turn;
        EXPECT(GUSSET_OK, gusset_net_copy_create(context, net, &given, &out));
        CHECK(at(out, 0, 0, 0) == turned[turn][0] && at(out, 1, 0, 0) == turned[turn][1]);
        CHECK(has_size(out, (size_t)turned[turn][2], (size_t)(8 - turned[turn][2])));
        gusset_net_destroy(out);
    }
    given.turn = GUSSET_NET_TURN_TRANSPOSE;
    EXPECT(GUSSET_OK, gusset_net_copy_create(context, net, &given, &out));
    CHECK(at(out, 0, 4, 1) == 4);
    gusset_net_destroy(out);
    given.turn = 8;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_net_copy_create(context, net, &given, &out));
    given = none, given.compact = 2;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_net_copy_create(context, net, &given, &out));
    given = none, given.reserved = 1;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_net_copy_create(context, net, &given, &out));

    given = larger, given.struct_size = 8;
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_net_copy_create(context, net, &given, &out));
    given = larger, given.row_replication = GUSSET_REPLICATE_REFUSE;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_net_copy_create(context, net, &given, &out));
    given = larger, given.rows = 2;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_net_copy_create(context, net, &given, &out));
    given = larger, given.row_index = 3;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_net_copy_create(context, net, &given, &out));
    given = larger, given.columns = SIZE_MAX;
    EXPECT(GUSSET_ERROR_TOO_LARGE, gusset_net_copy_create(context, net, &given, &out));
    CHECK(out == NULL);
    EXPECT(GUSSET_OK, gusset_net_copy_create(context, net, &larger, &out));
    CHECK(has_size(out, 5, 5) && at(out, 1, 3, 0) == 1 && at(out, 1, 4, 0) == 2);
    given = none, given.compact = 1;
    EXPECT(GUSSET_OK, gusset_net_copy_create(context, out, &given, &back));
    CHECK(has_size(back, 3, 5));
    gusset_net_destroy(back);
    /* Several steps: a part of what was enlarged, compact, turned and in floats. */
    given.row_count = 4, given.turn = GUSSET_NET_TURN_QUARTER, given.scalar = GUSSET_F32;
    EXPECT(GUSSET_OK, gusset_net_copy_create(context, out, &given, &back));
    CHECK(has_size(back, 5, 2));
    gusset_net_destroy(back);
    EXPECT(GUSSET_OK, gusset_net_copy_create(context, net, NULL, &back));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_clear_no_data(context, NULL, 1));
    EXPECT(GUSSET_OK, gusset_net_clear_no_data(context, back, 4));
    CHECK(isnan(at(back, 1, 0, 4)) && at(back, 1, 1, 3) == 1);
    gusset_net_destroy(back);
    gusset_net_destroy(out);
    gusset_net_destroy(net);
}

static void sizes(void) {
    gusset_net *net = grid(5, 9, 0, GUSSET_SIDES_SHEET), *made = (gusset_net *)misaligned(), *levels[GUSSET_PYRAMID_LEVELS];
    const uint32_t link = 2 * (2 * 9 + 3);
    const gusset_glue_options glue = {.struct_size = sizeof glue, .links = &link, .link_count = 1};
    uint32_t rows[5], columns[9];
    double deviation = -1;
    size_t count = 0;

    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_net_resample_create(context, net, 9, 9, 2, &made));
    CHECK(made == NULL);
    EXPECT(GUSSET_ERROR_NET_TOO_SMALL, gusset_net_resample_create(context, net, 1, 9, 0, &made));
    EXPECT(GUSSET_ERROR_TOO_LARGE, gusset_net_resample_create(context, net, SIZE_MAX, 9, 0, &made));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_resample_create(context, NULL, 9, 9, 0, &made));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_resample_create(context, net, 9, 9, 0, NULL));
    EXPECT(GUSSET_OK, gusset_net_resample_create(context, net, 9, 5, GUSSET_INTERPOLATION_BILINEAR, &made));
    CHECK(has_size(made, 9, 5) && at(made, 1, 1, 0) == 0.5 && at(made, 0, 0, 1) == 2);
    gusset_net_destroy(made);
    EXPECT(GUSSET_OK, gusset_net_resample_create(context, net, 9, 5, GUSSET_INTERPOLATION_BICUBIC, &made));
    gusset_net_destroy(made);

    EXPECT(GUSSET_OK, gusset_net_decimate_create(context, net, 1e-9, rows, columns, &deviation, &made));
    CHECK(has_size(made, 2, 2) && rows[1] == 4 && columns[1] == 8 && deviation == 0);
    gusset_net_destroy(made);
    EXPECT(GUSSET_OK, gusset_net_decimate_create(context, net, 0, NULL, NULL, NULL, &made));
    gusset_net_destroy(made);
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_net_decimate_create(context, net, -1, rows, columns, &deviation, &made));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_decimate_create(context, NULL, 0, rows, columns, &deviation, &made));

    EXPECT(GUSSET_ERROR_BUFFER_TOO_SMALL, gusset_net_pyramid_create(context, net, 0, NULL, 0, &count));
    /* Handles are NULL whatever fails, so that they may be destroyed. */
    for (int k = 0; k < 4; ++k) {
        levels[k] = (gusset_net *)misaligned();
    }
    gusset_context_cancel(context);
    EXPECT(GUSSET_ERROR_CANCELLED, gusset_net_pyramid_create(context, net, 0, levels, 4, &count));
    gusset_context_reset(context);
    for (int k = 0; k < 4; ++k) {
        CHECK(levels[k] == NULL);
    }
    EXPECT(GUSSET_ERROR_BUFFER_TOO_SMALL, gusset_net_pyramid_create(context, net, 0, levels, 3, &count));
    CHECK(count == 4 && levels[0] == NULL && levels[2] == NULL);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_pyramid_create(context, net, 0, NULL, 3, &count));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_pyramid_create(context, net, 0, levels, 3, NULL));
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_net_pyramid_create(context, net, 7, levels, 3, &count));
    EXPECT(GUSSET_OK, gusset_net_pyramid_create(context, net, 0, levels, GUSSET_PYRAMID_LEVELS, &count));
    CHECK(count == 4 && levels[4] == NULL && has_size(levels[3], 2, 2));
    for (size_t k = 0; k < count; k++) {
        gusset_net_destroy(levels[k]);
    }

    EXPECT(GUSSET_OK, gusset_net_glue(context, net, &glue, NULL));
    EXPECT(GUSSET_ERROR_GLUED_INSIDE, gusset_net_resample_create(context, net, 9, 9, 0, &made));
    EXPECT(GUSSET_ERROR_GLUED_INSIDE, gusset_net_decimate_create(context, net, 0, NULL, NULL, NULL, &made));
    EXPECT(GUSSET_ERROR_GLUED_INSIDE, gusset_net_pyramid_create(context, net, 0, levels, 32, &count));
    gusset_net_destroy(net);
}

static void at_rest(void) {
    gusset_net *a = grid(3, 4, 0, GUSSET_SIDES_SHEET), *b = grid(3, 4, 9, GUSSET_SIDES_SHEET), *net = NULL;
    const gusset_net *nets[2] = {a, b};
    const gusset_bridge_properties negative = {.tension = 1, .elasticity = -1};
    uint8_t free_parts[2] = {0, 1};
    gusset_concatenate_options joining;
    gusset_settle_options options;
    gusset_settle_report report;
    gusset_bridge bridge;

    memset(&joining, 0, sizeof joining);
    memset(&options, 0, sizeof options);
    memset(&report, 0, sizeof report);
    joining.struct_size = sizeof joining, options.struct_size = sizeof options, report.struct_size = sizeof report;
    joining.rows = 2, joining.properties.tension = 1, bridge.struct_size = sizeof bridge;
    EXPECT(GUSSET_OK, gusset_net_concatenate_create(context, nets, 2, &joining, &net));
    EXPECT(GUSSET_OK, gusset_net_get_bridge(net, 0, &bridge));
    CHECK(has_size(net, 3, 10) && bridge.at == 6 && bridge.rows == 2 && bridge.reserved == 0);
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_net_set_bridge(context, net, 0, GUSSET_BRIDGE_WELD, 1e9, NULL));
    EXPECT(GUSSET_OK, gusset_net_settle(context, net, NULL, &report));
    CHECK(report.converged == 1 && report.settled == 1 && report.idle == 0 && report.collapsed == 0);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_settle(context, net, &options, NULL));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_settle(context, NULL, &options, &report));
    options.tolerance = -1;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_net_settle(context, net, &options, &report));
    options.tolerance = 0, options.rest_ratio = NAN;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_net_settle(context, net, &options, &report));
    options.rest_ratio = 0, options.reserved = 1;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_net_settle(context, net, &options, &report));
    options.reserved = 0, options.reference = a;
    EXPECT(GUSSET_ERROR_SIDES_DIFFER, gusset_net_settle(context, net, &options, &report));
    options.reference = net, options.free = free_parts, options.free_count = 2;
    EXPECT(GUSSET_OK, gusset_net_settle(context, net, &options, &report));
    options.free_count = 1;
    EXPECT(GUSSET_ERROR_COUNT_DIFFERS, gusset_net_settle(context, net, &options, &report));
    options.free_count = 2, options.free = NULL;
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_settle(context, net, &options, &report));
    options.free = free_parts, free_parts[0] = 2;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_net_settle(context, net, &options, &report));
    EXPECT(GUSSET_OK, gusset_net_set_bridge(context, net, 0, GUSSET_BRIDGE_KEEP, 0, &negative));
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_net_settle(context, net, NULL, &report));
    options.struct_size = 8;
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_net_settle(context, net, &options, &report));
    report.struct_size = 0;
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_net_settle(context, net, NULL, &report));
    gusset_net_destroy(net);
    gusset_net_destroy(b);
    gusset_net_destroy(a);
}

static void joined(void) {
    gusset_net *a = grid(3, 4, 0, GUSSET_SIDES_TUBE), *b = grid(4, 3, 9, GUSSET_SIDES_SHEET);
    gusset_net *out = (gusset_net *)misaligned(), *first = (gusset_net *)misaligned(), *second = NULL;
    const gusset_net *nets[3] = {a, b, NULL}, *unaligned_nets[3];
    gusset_concatenate_options options, bad;
    gusset_bridge bridge;
    gusset_bridge_properties given = {1, 2, 3, 4};
    gusset_net_gluing_report report;

    memset(&options, 0, sizeof options);
    options.struct_size = sizeof options;
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_concatenate_create(context, nets, 3, &options, &out));
    CHECK(out == NULL);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_concatenate_create(context, NULL, 2, &options, &out));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_concatenate_create(context, nets, 2, &options, NULL));
    EXPECT(GUSSET_ERROR_EMPTY_SCENE, gusset_net_concatenate_create(context, nets, 0, &options, &out));
    EXPECT(GUSSET_ERROR_TOO_LARGE, gusset_net_concatenate_create(context, nets, SIZE_MAX, &options, &out));
    bad = options, bad.struct_size = 8;
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_net_concatenate_create(context, nets, 2, &bad, &out));
    bad = options, bad.direction = 2;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_net_concatenate_create(context, nets, 2, &bad, &out));
    bad = options, bad.mode = 3;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_net_concatenate_create(context, nets, 2, &bad, &out));
    bad = options, bad.turn = 2;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_net_concatenate_create(context, nets, 2, &bad, &out));
    bad = options, bad.equalise = 6;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_net_concatenate_create(context, nets, 2, &bad, &out));
    bad = options, bad.equalise = GUSSET_REPLICATE_REFUSE;
    EXPECT(GUSSET_ERROR_SIDES_DIFFER, gusset_net_concatenate_create(context, nets, 2, &bad, &out));
    bad = options, bad.tolerance = NAN;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_net_concatenate_create(context, nets, 2, &bad, &out));
    bad = options, bad.twist = 1;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_net_concatenate_create(context, nets, 2, &bad, &out));
    bad = options, bad.mode = GUSSET_BRIDGE_WELD;
    EXPECT(GUSSET_ERROR_SIDES_DIFFER, gusset_net_concatenate_create(context, nets, 2, &bad, &out));
    bad.rows = 1;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_net_concatenate_create(context, nets, 2, &bad, &out));
    bad = options, bad.rows = UINT32_MAX;
    EXPECT(GUSSET_ERROR_TOO_LARGE, gusset_net_concatenate_create(context, nets, 2, &bad, &out));
    bad = options, bad.reserved = 1;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_net_concatenate_create(context, nets, 2, &bad, &out));
    CHECK(out == NULL);

    memcpy(unaligned_nets, nets, sizeof nets);
    options.properties = given;
    EXPECT(GUSSET_OK, gusset_net_concatenate_create(context, unaligned_nets, 2, &options, &out));
    CHECK(has_size(out, 4, 7) && at(out, 0, 0, 4) == 9);
    report.struct_size = sizeof report;
    EXPECT(GUSSET_OK, gusset_net_get_gluing(out, NULL, 0, NULL, 0, &report));
    CHECK(report.bridge_count == 1);
    bridge.struct_size = sizeof bridge;
    EXPECT(GUSSET_ERROR_NO_SUCH_ELEMENT, gusset_net_get_bridge(out, 1, &bridge));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_get_bridge(out, 0, NULL));
    EXPECT(GUSSET_OK, gusset_net_get_bridge(out, 0, &bridge));
    CHECK(bridge.at == 4 && bridge.start == 0 && bridge.end == 4 && bridge.kind == GUSSET_BRIDGE_RIBBON);
    CHECK(bridge.mode == GUSSET_BRIDGE_KEEP && bridge.direction == GUSSET_DIRECTION_RIGHT);
    CHECK(bridge.properties.stiffness == 3 && bridge.properties.user == 4);

    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_set_bridge(context, NULL, 0, GUSSET_BRIDGE_HIDE, 0, NULL));
    EXPECT(GUSSET_ERROR_NO_SUCH_ELEMENT, gusset_net_set_bridge(context, out, 1, GUSSET_BRIDGE_HIDE, 0, NULL));
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_net_set_bridge(context, out, 0, 3, 0, NULL));
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_net_set_bridge(context, out, 0, GUSSET_BRIDGE_HIDE, -1, NULL));
    EXPECT(GUSSET_ERROR_SIDES_DIFFER, gusset_net_set_bridge(context, out, 0, GUSSET_BRIDGE_WELD, 0.5, NULL));
    given.user = 5;
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT,
           gusset_net_set_bridge(context, out, 0, GUSSET_BRIDGE_HIDE, 0, (gusset_bridge_properties *)misaligned()));
    EXPECT(GUSSET_OK, gusset_net_set_bridge(context, out, 0, GUSSET_BRIDGE_HIDE, 0, &given));
    EXPECT(GUSSET_OK, gusset_net_get_bridge(out, 0, &bridge));
    CHECK(bridge.mode == GUSSET_BRIDGE_HIDE && bridge.properties.user == 5);

    EXPECT(GUSSET_ERROR_NO_SUCH_ELEMENT, gusset_net_split_create(context, out, 1, &first, &second));
    CHECK(first == NULL && second == NULL);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_split_create(context, NULL, 0, &first, &second));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_split_create(context, out, 0, NULL, &second));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_split_create(context, out, 0, &first, NULL));
    EXPECT(GUSSET_ERROR_OVERLAP, gusset_net_split_create(context, out, 0, &first, &first));
    CHECK(first == NULL);
    EXPECT(GUSSET_OK, gusset_net_split_create(context, out, 0, &first, &second));
    CHECK(has_size(first, 3, 4) && has_size(second, 4, 3) && at(second, 0, 0, 2) == 11);
    gusset_net_destroy(first);
    gusset_net_destroy(second);
    gusset_net_destroy(out);
    EXPECT(GUSSET_OK, gusset_net_concatenate_create(NULL, nets, 1, NULL, &out));
    CHECK(has_size(out, 3, 4));
    gusset_net_destroy(out);
    gusset_net_destroy(a);
    gusset_net_destroy(b);
}

static void meshes(void) {
    gusset_net *net = grid(4, 5, 0, GUSSET_SIDES_TWO_POLES), *found = NULL;
    gusset_result *mesh = (gusset_result *)misaligned();
    gusset_net_mesh_options options, bad;
    gusset_net_mesh_report maps;
    gusset_mesh_view view;
    gusset_net_grid *grid_found = (gusset_net_grid *)misaligned();
    gusset_net_grid_view parts;

    memset(&options, 0, sizeof options);
    options.struct_size = sizeof options;
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_to_mesh(context, NULL, NULL, &mesh));
    CHECK(mesh == NULL);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_to_mesh(context, net, NULL, NULL));
    bad = options, bad.struct_size = 0;
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_net_to_mesh(context, net, &bad, &mesh));
    bad = options, bad.faces = 3;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_net_to_mesh(context, net, &bad, &mesh));
    bad = options, bad.no_weld = 2;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_net_to_mesh(context, net, &bad, &mesh));
    bad = options, bad.keep_unused = 2;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_net_to_mesh(context, net, &bad, &mesh));
    bad = options, bad.fill_corners = 2;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_net_to_mesh(context, net, &bad, &mesh));
    bad = options, bad.texture = 2;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_net_to_mesh(context, net, &bad, &mesh));
    bad = options, bad.reserved = 1;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_net_to_mesh(context, net, &bad, &mesh));
    bad = options, bad.max_edge_ratio = -1;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_net_to_mesh(context, net, &bad, &mesh));
    bad = options, bad.max_edge_ratio = NAN;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_net_to_mesh(context, net, &bad, &mesh));
    options.texture = 1;
    EXPECT(GUSSET_OK, gusset_net_to_mesh(context, net, &options, &mesh));
    view.struct_size = sizeof view, maps.struct_size = sizeof maps;
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_result_get_mesh(NULL, &view));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_result_get_mesh(mesh, NULL));
    EXPECT(GUSSET_OK, gusset_result_get_mesh(mesh, &view));
    /* Two poles and two rings of four; a ring of quads between fans of triangles. */
    CHECK(view.vertex_count == 10 && view.face_count == 12 && view.scalar == GUSSET_F64);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_result_get_net_mesh(NULL, &maps));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_result_get_net_mesh(mesh, NULL));
    EXPECT(GUSSET_OK, gusset_result_get_net_mesh(mesh, &maps));
    CHECK(maps.vertex_of_node.count == 20 && maps.node_of_vertex.count == 10 && maps.cell_of_face.count == 12);
    CHECK(maps.wires.count == 0 && maps.texture_corners.count == 40 && maps.texture_count == 18);
    CHECK(maps.vertex_of_node.data[9] == maps.vertex_of_node.data[5]);

    gusset_net_grid_options seeking = {.struct_size = sizeof seeking, .has_face = 1, .face = 12};
    grid_found = misaligned(), found = misaligned();
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_from_mesh_create(context, NULL, NULL, &grid_found, &found));
    CHECK(grid_found == NULL && found == NULL);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_from_mesh_create(context, &view, NULL, &grid_found, NULL));
    CHECK(grid_found == NULL);
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_net_from_mesh_create(context, &view, NULL, misaligned(), &found));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_net_from_mesh_create(context, &view, misaligned(), &grid_found, &found));
    EXPECT(GUSSET_ERROR_NO_GRID, gusset_net_from_mesh_create(context, &view, &seeking, &grid_found, &found));
    seeking.has_face = 2;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_net_from_mesh_create(context, &view, &seeking, &grid_found, &found));
    seeking.has_face = 0, seeking.cells = 2;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_net_from_mesh_create(context, &view, &seeking, &grid_found, &found));
    seeking.cells = 0, seeking.reserved = 1;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_net_from_mesh_create(context, &view, &seeking, &grid_found, &found));
    seeking.reserved = 0, seeking.struct_size = sizeof seeking - 1;
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_net_from_mesh_create(context, &view, &seeking, &grid_found, &found));
    const gusset_mesh_view triangles = pyramid(pyramid_up);
    EXPECT(GUSSET_ERROR_NO_GRID, gusset_net_from_mesh_create(context, &triangles, NULL, &grid_found, &found));
    seeking.struct_size = sizeof seeking, seeking.has_face = 1, seeking.face = 0;
    EXPECT(GUSSET_OK, gusset_net_from_mesh_create(context, &view, &seeking, NULL, &found));
    gusset_net_destroy(found);
    EXPECT(GUSSET_OK, gusset_net_from_mesh_create(context, &view, NULL, &grid_found, &found));
    parts.struct_size = sizeof parts;
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_grid_get_view(NULL, &parts));
    EXPECT(GUSSET_OK, gusset_net_grid_get_view(grid_found, &parts));
    CHECK(parts.vertex_of_node.count == 20 && parts.face_of_cell.count == 12);
    gusset_net_grid_destroy(grid_found);
    CHECK(has_size(found, 4, 5));
    gusset_net_destroy(found);
    seeking.has_face = 0, seeking.cells = GUSSET_GRID_TRIANGLES;
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_from_mesh_create(context, NULL, &seeking, &grid_found, &found));
    CHECK(grid_found == NULL && found == NULL);
    EXPECT(GUSSET_ERROR_NO_GRID, gusset_net_from_mesh_create(context, &view, &seeking, &grid_found, &found));
    gusset_result_destroy(mesh);
    options.texture = 0, options.faces = GUSSET_NET_TRIANGLES_FIXED;
    EXPECT(GUSSET_OK, gusset_net_to_mesh(context, net, &options, &mesh));
    EXPECT(GUSSET_OK, gusset_result_get_mesh(mesh, &view));
    EXPECT(GUSSET_OK, gusset_net_from_mesh_create(context, &view, &seeking, &grid_found, &found));
    gusset_result_destroy(mesh);
    gusset_net_grid_destroy(grid_found);
    CHECK(has_size(found, 4, 5));
    gusset_net_destroy(found);
    gusset_net_destroy(net);
    gusset_result_destroy(NULL);
    gusset_net_grid_destroy(NULL);
}

static void heights(void) {
    unsigned char bytes[6 * 4 + 1];
    const float values[6] = {0, 1, 2, 3, -99, 5};
    gusset_heights heights, bad;
    gusset_net *net = (gusset_net *)misaligned();

    memset(&heights, 0, sizeof heights);
    memcpy(bytes + 1, values, sizeof values);
    heights.struct_size = sizeof heights;
    heights.rows = 2, heights.columns = 3;
    heights.values = bytes + 1;
    heights.spacing[0] = 2, heights.spacing[1] = -1;
    heights.scalar = GUSSET_F32;
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_from_heights_create(context, NULL, &net));
    CHECK(net == NULL);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_from_heights_create(context, &heights, NULL));
    bad = heights, bad.struct_size = 1;
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_net_from_heights_create(context, &bad, &net));
    bad = heights, bad.rows = 1;
    EXPECT(GUSSET_ERROR_NET_TOO_SMALL, gusset_net_from_heights_create(context, &bad, &net));
    bad = heights, bad.columns = SIZE_MAX;
    EXPECT(GUSSET_ERROR_TOO_LARGE, gusset_net_from_heights_create(context, &bad, &net));
    bad = heights, bad.values = NULL;
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_net_from_heights_create(context, &bad, &net));
    bad = heights, bad.row_stride = 11;
    EXPECT(GUSSET_ERROR_BAD_STRIDE, gusset_net_from_heights_create(context, &bad, &net));
    bad = heights, bad.row_stride = SIZE_MAX;
    EXPECT(GUSSET_ERROR_SIZE_OVERFLOW, gusset_net_from_heights_create(context, &bad, &net));
    bad = heights, bad.spacing[1] = 0;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_net_from_heights_create(context, &bad, &net));
    bad = heights, bad.origin[2] = NAN;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_net_from_heights_create(context, &bad, &net));
    bad = heights, bad.scalar = 0;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_net_from_heights_create(context, &bad, &net));
    bad = heights, bad.has_no_data = 2;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_net_from_heights_create(context, &bad, &net));
    CHECK(net == NULL);
    heights.has_no_data = 1, heights.no_data = -99;
    EXPECT(GUSSET_OK, gusset_net_from_heights_create(context, &heights, &net));
    gusset_net_view view;
    view.struct_size = sizeof view;
    EXPECT(GUSSET_OK, gusset_net_get_view(net, &view));
    CHECK(view.scalar == GUSSET_F32 && ((const float *)view.x)[5] == 4 && ((const float *)view.y)[5] == -1);
    CHECK(isnan(((const float *)view.z)[4]) && ((const float *)view.z)[5] == 5);
    gusset_net_destroy(net);
}

int main(void) {
    const gusset_mesh_view up = pyramid(pyramid_up), down = pyramid(pyramid_down);
    if (gusset_context_create(&context) != GUSSET_OK || up.face_count != down.face_count) {
        return 1;
    }
    arranged();
    sizes();
    at_rest();
    joined();
    meshes();
    heights();
    gusset_context_destroy(context);
    return failures != 0;
}

/* Queries nearest points of surfaces with invalid and valid arguments, and checks errors and results. */
#include "check.h"
#include <math.h>

static gusset_context *context;

/* z = 0 over [0, 4] x [0, 4], nodes one apart. */
static gusset_surface *flat(void) {
    static double nodes[25][3];
    gusset_nodes view;
    gusset_sheet *sheet = NULL;
    gusset_surface *surface = NULL;
    int k;
    for (k = 0; k < 25; ++k) {
        nodes[k][0] = k / 5, nodes[k][1] = k % 5, nodes[k][2] = 0;
    }
    memset(&view, 0, sizeof view);
    view.struct_size = sizeof view;
    view.nodes = nodes;
    view.rows = view.columns = 5;
    view.scalar = GUSSET_F64;
    EXPECT(GUSSET_OK, gusset_sheet_create(context, &view, NULL, 0, &sheet));
    EXPECT(GUSSET_OK, gusset_surface_create(context, (const gusset_sheet *const *)&sheet, 1, NULL, &surface));
    gusset_sheet_destroy(sheet);
    return surface;
}

static void closest(const gusset_surface *surface) {
    const double queries[2][3] = {{1.5, 2.25, 3}, {5, 2, 0}};
    const double nan[3] = {0, NAN, 0};
    gusset_nearest_options options = {sizeof options, 2.0, 0};
    gusset_surface_nearest_point found[2];

    EXPECT(GUSSET_OK, gusset_surface_nearest(context, surface, queries[0], 2, NULL, found));
    CHECK(found[0].flags == (GUSSET_NEAREST_FOUND | GUSSET_NEAREST_PROVEN));
    CHECK(fabs(found[0].distance - 3) < 1e-12 && found[0].bound <= 3 && found[0].bound > 3 - 1e-7);
    CHECK(fabs(found[0].point[0] - 1.5) < 1e-9 && fabs(fabs(found[0].normal[2]) - 1) < 1e-12);
    CHECK(found[0].place.row == 1 && found[0].place.column == 2 && fabs(found[0].place.v - 0.25) < 1e-9);
    CHECK(fabs(found[1].distance - 1) < 1e-12 && found[1].place.row == 3 && found[1].place.u == 1);
    EXPECT(GUSSET_OK, gusset_surface_nearest(context, surface, queries[0], 2, &options, found));
    CHECK(found[0].flags == 0 && found[0].distance == HUGE_VAL && found[1].flags != 0);
    EXPECT(GUSSET_OK, gusset_surface_nearest(context, surface, NULL, 0, NULL, NULL));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_surface_nearest(context, NULL, queries[0], 1, NULL, found));
    CHECK(found[0].flags == 0 && found[1].flags != 0);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_surface_nearest(context, surface, NULL, 1, NULL, found));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_surface_nearest(context, surface, queries[0], 1, NULL, NULL));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_surface_nearest(context, surface, queries[0], 1, NULL, misaligned()));
    EXPECT(GUSSET_ERROR_SIZE_OVERFLOW, gusset_surface_nearest(context, surface, queries[0], SIZE_MAX, NULL, found));
    found[0].flags = 1;
    EXPECT(GUSSET_ERROR_NOT_FINITE, gusset_surface_nearest(context, surface, nan, 1, NULL, found));
    CHECK(found[0].flags == 0);
    options.limit = -1;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_surface_nearest(context, surface, queries[0], 1, &options, found));
    options.limit = NAN;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_surface_nearest(context, surface, queries[0], 1, &options, found));
    options.limit = 0.0;
    EXPECT(GUSSET_OK, gusset_surface_nearest(context, surface, queries[0], 1, &options, found));
    CHECK(found[0].flags == (GUSSET_NEAREST_FOUND | GUSSET_NEAREST_PROVEN));
    options.struct_size = 8;
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_surface_nearest(context, surface, queries[0], 1, &options, found));
}

static gusset_target target_of(gusset_target_kind kind) {
    const gusset_line line = {{-3, 1, 2}, {2, 0, 0}, -INFINITY, INFINITY};
    const double above[3] = {1, 1, 2}, up[3] = {0, 0, 1};
    gusset_target target;
    memset(&target, 0, sizeof target);
    target.struct_size = sizeof target;
    target.kind = kind, target.line = line;
    memcpy(target.point, above, sizeof above), memcpy(target.normal, up, sizeof up);
    return target;
}

static void distances(const gusset_surface *surface) {
    const double a[6] = {1, 1, 3, 2, 3, 3}, large[6] = {0, 0, 0, 1e200, 0, 0};
    const uint32_t ends[2] = {0, 1}, none[1] = {0};
    gusset_target target = target_of(GUSSET_TARGET_LINE);
    gusset_distance_report found;
    gusset_curve *curve = NULL, *empty = NULL, *wide = NULL;
    uint32_t kind;

    memset(&found, 0, sizeof found);
    found.struct_size = sizeof found;
    EXPECT(GUSSET_OK, gusset_surface_distance(context, surface, &target, 0, &found));
    CHECK(fabs(found.distance - 2) < 1e-12 && found.bound <= 2 && found.flags == GUSSET_DISTANCE_PROVEN);
    CHECK(fabs(found.point[2]) < 1e-12 && fabs(found.other_point[2] - 2) < 1e-12 && found.reserved == 0);
    CHECK(fabs(target.line.origin[0] + 2 * found.parameter - found.other_point[0]) < 1e-12);
    target.line.origin[2] = 0;
    EXPECT(GUSSET_OK, gusset_surface_distance(context, surface, &target, 1e-3, &found));
    CHECK(found.distance == 0 && found.bound == 0 && found.flags == (GUSSET_DISTANCE_PROVEN | GUSSET_DISTANCE_MEETS));
    target.line.direction[0] = 0;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_surface_distance(context, surface, &target, 0, &found));
    CHECK(found.struct_size == sizeof found && found.flags == 0);
    target.line.direction[0] = 1, target.line.from = 2, target.line.to = 1;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_surface_distance(context, surface, &target, 0, &found));

    target = target_of(GUSSET_TARGET_PLANE);
    EXPECT(GUSSET_OK, gusset_surface_distance(context, surface, &target, 0, &found));
    CHECK(fabs(found.parameter + 2) < 1e-12 && fabs(found.distance - 2) < 1e-12);
    target.normal[2] = 0;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_surface_distance(context, surface, &target, 0, &found));
    target.normal[2] = 1, target.point[1] = NAN;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_surface_distance(context, surface, &target, 0, &found));
    target.point[1] = 1e200;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_surface_distance(context, surface, &target, 0, &found));

    EXPECT(GUSSET_OK, gusset_curve_create(context, a, 2, 3, ends, 2, 0, &curve));
    EXPECT(GUSSET_OK, gusset_curve_create(context, NULL, 0, 3, none, 1, 0, &empty));
    EXPECT(GUSSET_OK, gusset_curve_create(context, large, 2, 3, ends, 2, 0, &wide));
    target = target_of(GUSSET_TARGET_CURVE);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_surface_distance(context, surface, &target, 0, &found));
    CHECK(strncmp(gusset_context_get_message(context), "target.curve", 12) == 0);
    target.curve = curve;
    EXPECT(GUSSET_OK, gusset_surface_distance(context, surface, &target, 0, &found));
    CHECK(fabs(found.distance - 3) < 1e-12 && found.curve_place.segment == 0 && found.parameter == 0);
    target.curve = empty;
    EXPECT(GUSSET_ERROR_EMPTY_CURVE, gusset_surface_distance(context, surface, &target, 0, &found));
    target.curve = wide;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_surface_distance(context, surface, &target, 0, &found));

    target = target_of(GUSSET_TARGET_SURFACE);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_surface_distance(context, surface, &target, 0, &found));
    CHECK(strncmp(gusset_context_get_message(context), "target.surface", 14) == 0);
    target.surface = surface;
    EXPECT(GUSSET_OK, gusset_surface_distance(context, surface, &target, 0, &found));
    CHECK(found.distance == 0 && (found.flags & GUSSET_DISTANCE_MEETS));

    for (kind = GUSSET_TARGET_LINE; kind <= GUSSET_TARGET_SURFACE; ++kind) {
        target = target_of(kind);
        target.curve = curve, target.surface = surface;
        EXPECT(GUSSET_OK, gusset_surface_distance(NULL, surface, &target, 0, &found));
        EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_surface_distance(context, surface, &target, -1, &found));
        EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_surface_distance(context, surface, &target, NAN, &found));
        EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_surface_distance(context, surface, &target, INFINITY, &found));
        EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_surface_distance(context, NULL, &target, 0, &found));
        EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_surface_distance(context, surface, &target, 0, NULL));
    }
    target.kind = kind;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_surface_distance(context, surface, &target, 0, &found));
    target.kind = GUSSET_TARGET_LINE, target.reserved = 1;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_surface_distance(context, surface, &target, 0, &found));
    target.reserved = 0, target.struct_size = 8;
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_surface_distance(context, surface, &target, 0, &found));
    target.struct_size = sizeof target;
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_surface_distance(context, surface, NULL, 0, &found));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_surface_distance(context, surface, misaligned(), 0, &found));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_surface_distance(context, surface, &target, 0, misaligned()));
    found.struct_size = 8;
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_surface_distance(context, surface, &target, 0, &found));
    gusset_curve_destroy(curve);
    gusset_curve_destroy(empty);
    gusset_curve_destroy(wide);
}

static void minima(const gusset_surface *surface) {
    const double query[3] = {1.5, 2.25, 3}, nan[3] = {0, NAN, 0};
    gusset_nearest_options options = {sizeof options, 0.0, 1};
    gusset_surface_points_view parts = {sizeof parts, NULL, 0, 0, 0, 0};
    gusset_surface_points *points = NULL;

    EXPECT(GUSSET_OK, gusset_surface_minima_create(context, surface, query, &options, &points));
    EXPECT(GUSSET_OK, gusset_surface_points_get_view(points, &parts));
    CHECK(parts.count == 1 && parts.complete == 1 && fabs(parts.points[0].distance - 3) < 1e-12);
    CHECK(parts.points[0].flags == (GUSSET_NEAREST_FOUND | GUSSET_NEAREST_PROVEN));
    gusset_surface_points_destroy(points);
    options.limit = 1;
    EXPECT(GUSSET_OK, gusset_surface_minima_create(context, surface, query, &options, &points));
    EXPECT(GUSSET_OK, gusset_surface_points_get_view(points, &parts));
    CHECK(parts.count == 0);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_surface_points_get_view(points, NULL));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_surface_points_get_view(NULL, &parts));
    CHECK(parts.points == NULL);
    parts.struct_size = 8;
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_surface_points_get_view(points, &parts));
    gusset_surface_points_destroy(points);
    gusset_surface_points_destroy(NULL);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_surface_minima_create(context, surface, NULL, NULL, &points));
    CHECK(points == NULL);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_surface_minima_create(context, NULL, query, NULL, &points));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_surface_minima_create(context, surface, query, NULL, NULL));
    EXPECT(GUSSET_ERROR_NOT_FINITE, gusset_surface_minima_create(context, surface, nan, NULL, &points));
    options.limit = NAN;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_surface_minima_create(context, surface, query, &options, &points));
}

static void region(const gusset_surface *surface) {
    const double query[3] = {0.5, 1.5, 1}, nan[3] = {0, NAN, 0};
    gusset_surface_cells_view parts;
    gusset_surface_cells *found = NULL;

    memset(&parts, 0, sizeof parts);
    parts.struct_size = sizeof parts;
    EXPECT(GUSSET_OK, gusset_surface_region_create(context, surface, query, 1.01, &found));
    EXPECT(GUSSET_OK, gusset_surface_cells_get_view(found, &parts));
    CHECK(parts.cell_count == 1 && parts.cells[0].row == 0 && parts.cells[0].column == 1 && parts.whole[0] == 0);
    CHECK(parts.others == NULL);
    CHECK(parts.word_count == 1 && parts.mask[0] == 2 && parts.sheet_count == 1 && parts.first[1] == 16);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_surface_cells_get_view(found, NULL));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_surface_cells_get_view(NULL, &parts));
    CHECK(parts.cells == NULL);
    gusset_surface_cells_destroy(found);
    gusset_surface_cells_destroy(NULL);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_surface_region_create(context, NULL, query, 1, &found));
    CHECK(found == NULL);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_surface_region_create(context, surface, NULL, 1, &found));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_surface_region_create(context, surface, query, 1, NULL));
    EXPECT(GUSSET_ERROR_NOT_FINITE, gusset_surface_region_create(context, surface, nan, 1, &found));
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_surface_region_create(context, surface, query, -1, &found));
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_surface_region_create(context, surface, query, NAN, &found));
}

static void info(const gusset_surface *surface) {
    gusset_surface_report facts;
    memset(&facts, 0, sizeof facts);
    facts.struct_size = sizeof facts;
    EXPECT(GUSSET_OK, gusset_surface_get_report(surface, &facts));
    CHECK(facts.sheet_count == 1 && facts.cell_count == 16 && facts.node_count == 25 && facts.index_bytes > 0);
    CHECK(facts.low[0] <= 0 && facts.high[1] >= 4 && facts.high[2] < 1e-3 && facts.tolerance > 0);
    CHECK(facts.cone_bytes == 0);
    /* As long as it was at first. */
    facts.struct_size = 96, facts.cone_bytes = 7;
    EXPECT(GUSSET_OK, gusset_surface_get_report(surface, &facts));
    CHECK(facts.cell_count == 16 && facts.cone_bytes == 7);
    facts.struct_size = sizeof facts;
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_surface_get_report(NULL, &facts));
    CHECK(facts.cell_count == 0);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_surface_get_report(surface, NULL));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_surface_get_report(surface, misaligned()));
}

static double plane[2][9][3];

/* Two sheets of 3 x 3 nodes, the second times a factor. */
static gusset_status pair(double factor, gusset_surface **surface) {
    gusset_sheet *sheets[2] = {NULL, NULL};
    gusset_nodes nodes;
    gusset_status status;
    int k;
    memset(&nodes, 0, sizeof nodes);
    nodes.struct_size = sizeof nodes, nodes.rows = nodes.columns = 3, nodes.scalar = GUSSET_F64;
    for (k = 0; k < 9; ++k) {
        plane[0][k][0] = k / 3, plane[0][k][1] = k % 3;
        plane[1][k][0] = factor * (k / 3), plane[1][k][1] = factor * (k % 3);
    }
    nodes.nodes = plane[0];
    EXPECT(GUSSET_OK, gusset_sheet_create(context, &nodes, NULL, 0, &sheets[0]));
    nodes.nodes = plane[1];
    EXPECT(GUSSET_OK, gusset_sheet_create(context, &nodes, NULL, 1, &sheets[1]));
    status = gusset_surface_create(context, (const gusset_sheet *const *)sheets, 2, NULL, surface);
    gusset_sheet_destroy(sheets[0]), gusset_sheet_destroy(sheets[1]);
    return status;
}

static void sheets(void) {
    const double factors[3] = {1e39, 1e300, 1e-60};
    gusset_surface_report facts;
    const gusset_surface_sheet *second;
    gusset_surface *surface = NULL;
    gusset_error_report report;
    int k;
    memset(&facts, 0, sizeof facts), memset(&report, 0, sizeof report);
    facts.struct_size = sizeof facts, report.struct_size = sizeof report;
    EXPECT(GUSSET_OK, pair(2.0, &surface));
    EXPECT(GUSSET_OK, gusset_surface_get_report(surface, &facts));
    CHECK(facts.sheet_count == 2 && facts.sheets[0].first_cell == 0 && facts.sheets[0].first_node == 0);
    second = &facts.sheets[1];
    CHECK(second->rows == 2 && second->columns == 2 && second->first_cell == 4 && second->first_node == 9);
    CHECK(second->closed_u == 0 && second->closed_v == 0);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_surface_get_report(NULL, &facts));
    CHECK(facts.sheets == NULL && facts.struct_size == sizeof facts);
    facts.struct_size = 8;
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_surface_get_report(surface, &facts));
    gusset_surface_destroy(surface);

    /* Sizes that boxes in single precision cannot hold. */
    for (k = 0; k < 3; ++k) {
        EXPECT(GUSSET_ERROR_OUT_OF_RANGE, pair(factors[k], &surface));
        CHECK(surface == NULL);
        EXPECT(GUSSET_OK, gusset_context_get_report(context, &report));
        CHECK(report.element == GUSSET_ELEMENT_ITEM && report.index == 1);
        CHECK(strncmp(gusset_context_get_message(context), "sheet 1", 7) == 0);
    }
    EXPECT(GUSSET_OK, pair(1e30, &surface));
    gusset_surface_destroy(surface);
    EXPECT(GUSSET_OK, pair(1e-29, &surface));
    gusset_surface_destroy(surface);
    EXPECT(GUSSET_OK, pair(0, &surface));
    gusset_surface_destroy(surface);
}

int main(void) {
    const gusset_mesh_view up = pyramid(pyramid_up), down = pyramid(pyramid_down);
    gusset_surface *surface;
    if (gusset_context_create(&context) != GUSSET_OK || up.face_count != down.face_count) {
        return 1;
    }
    surface = flat();
    closest(surface);
    distances(surface);
    minima(surface);
    region(surface);
    info(surface);
    sheets();
    gusset_surface_destroy(surface);
    gusset_context_destroy(context);
    return failures != 0;
}

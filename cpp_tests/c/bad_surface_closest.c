/* What a host can get wrong with nearest points of surfaces, and what it gets if it does not. */
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
    EXPECT(GUSSET_OK, gusset_sheet_from_nodes_create(context, &view, &sheet));
    EXPECT(GUSSET_OK, gusset_surface_create(context, (const gusset_sheet *const *)&sheet, 1, NULL, &surface));
    gusset_sheet_destroy(sheet);
    return surface;
}

static void closest(const gusset_surface *surface) {
    const double queries[2][4] = {{1.5, 2.25, 3, NAN}, {5, 2, 0, NAN}};
    const double nan[3] = {0, NAN, 0};
    gusset_nearest_options options = {sizeof options, 2.0, 0, 1, 0};
    gusset_surface_nearest_point found[2];

    EXPECT(GUSSET_OK, gusset_surface_nearest(context, surface, queries[0], 2, sizeof queries[0], NULL, found));
    CHECK(found[0].flags == (GUSSET_NEAREST_FOUND | GUSSET_NEAREST_PROVEN));
    CHECK(fabs(found[0].distance - 3) < 1e-12 && found[0].bound <= 3 && found[0].bound > 3 - 1e-7);
    CHECK(fabs(found[0].point[0] - 1.5) < 1e-9 && fabs(fabs(found[0].normal[2]) - 1) < 1e-12);
    CHECK(found[0].place.row == 1 && found[0].place.column == 2 && fabs(found[0].place.v - 0.25) < 1e-9);
    CHECK(fabs(found[1].distance - 1) < 1e-12 && found[1].place.row == 3 && found[1].place.u == 1);
    EXPECT(GUSSET_OK, gusset_surface_nearest(context, surface, queries[0], 2, sizeof queries[0], &options, found));
    CHECK(found[0].flags == 0 && found[0].distance == HUGE_VAL && found[1].flags != 0);
    EXPECT(GUSSET_OK, gusset_surface_nearest(context, surface, NULL, 0, 0, NULL, NULL));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_surface_nearest(context, NULL, queries[0], 1, 0, NULL, found));
    CHECK(found[0].flags == 0 && found[1].flags != 0);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_surface_nearest(context, surface, NULL, 1, 0, NULL, found));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_surface_nearest(context, surface, queries[0], 1, 0, NULL, NULL));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_surface_nearest(context, surface, queries[0], 1, 0, NULL, misaligned()));
    EXPECT(GUSSET_ERROR_BAD_STRIDE, gusset_surface_nearest(context, surface, queries[0], 1, 16, NULL, found));
    EXPECT(GUSSET_ERROR_SIZE_OVERFLOW, gusset_surface_nearest(context, surface, queries[0], SIZE_MAX, 0, NULL, found));
    found[0].flags = 1;
    EXPECT(GUSSET_ERROR_NOT_FINITE, gusset_surface_nearest(context, surface, nan, 1, 0, NULL, found));
    CHECK(found[0].flags == 0);
    options.limit = -1;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_surface_nearest(context, surface, queries[0], 1, 0, &options, found));
    options.limited = 2;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_surface_nearest(context, surface, queries[0], 1, 0, &options, found));
    options.limited = 0, options.reserved = 1;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_surface_nearest(context, surface, queries[0], 1, 0, &options, found));
    options.struct_size = 8;
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_surface_nearest(context, surface, queries[0], 1, 0, &options, found));
}

static void distances(const gusset_surface *surface) {
    const double above[3] = {1, 1, 2}, up[3] = {0, 0, 1}, zero[3] = {0, 0, 0}, nan[3] = {0, NAN, 0}, far[3] = {1e200, 0, 0};
    const double a[6] = {1, 1, 3, 2, 3, 3}, large[6] = {0, 0, 0, 1e200, 0, 0};
    const uint32_t ends[2] = {0, 1}, none[1] = {0};
    gusset_line line = {{-3, 1, 2}, {2, 0, 0}, -INFINITY, INFINITY};
    gusset_surface_distance found;
    gusset_curve *curve = NULL, *empty = NULL, *wide = NULL;

    memset(&found, 0, sizeof found);
    found.struct_size = sizeof found;
    EXPECT(GUSSET_OK, gusset_surface_line_distance(context, surface, &line, 0, &found));
    CHECK(fabs(found.distance - 2) < 1e-12 && found.bound <= 2 && found.flags == GUSSET_DISTANCE_PROVEN);
    CHECK(fabs(found.point[2]) < 1e-12 && fabs(found.other_point[2] - 2) < 1e-12 && found.reserved == 0);
    CHECK(fabs(line.origin[0] + 2 * found.parameter - found.other_point[0]) < 1e-12);
    line.origin[2] = 0;
    EXPECT(GUSSET_OK, gusset_surface_line_distance(context, surface, &line, 1e-3, &found));
    CHECK(found.distance == 0 && found.bound == 0 && found.flags == (GUSSET_DISTANCE_PROVEN | GUSSET_DISTANCE_MEETS));
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_surface_line_distance(context, surface, &line, -1, &found));
    CHECK(found.struct_size == sizeof found && found.flags == 0);
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_surface_line_distance(context, surface, &line, NAN, &found));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_surface_line_distance(context, NULL, &line, 0, &found));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_surface_line_distance(context, surface, NULL, 0, &found));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_surface_line_distance(context, surface, &line, 0, NULL));
    line.direction[0] = 0;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_surface_line_distance(context, surface, &line, 0, &found));
    line.direction[0] = 1, line.from = 2, line.to = 1;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_surface_line_distance(context, surface, &line, 0, &found));

    EXPECT(GUSSET_OK, gusset_surface_plane_distance(context, surface, above, up, 0, &found));
    CHECK(fabs(found.parameter + 2) < 1e-12 && fabs(found.distance - 2) < 1e-12);
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_surface_plane_distance(context, surface, above, zero, 0, &found));
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_surface_plane_distance(context, surface, nan, up, 0, &found));
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_surface_plane_distance(context, surface, far, up, 0, &found));
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_surface_plane_distance(context, surface, above, up, INFINITY, &found));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_surface_plane_distance(context, NULL, above, up, 0, &found));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_surface_plane_distance(context, surface, NULL, up, 0, &found));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_surface_plane_distance(context, surface, above, NULL, 0, &found));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_surface_plane_distance(context, surface, above, up, 0, NULL));

    EXPECT(GUSSET_OK, gusset_curve_create(context, a, 2, 3, ends, 2, 0, &curve));
    EXPECT(GUSSET_OK, gusset_curve_create(context, NULL, 0, 3, none, 1, 0, &empty));
    EXPECT(GUSSET_OK, gusset_curve_create(context, large, 2, 3, ends, 2, 0, &wide));
    EXPECT(GUSSET_OK, gusset_surface_curve_distance(context, surface, curve, 0, &found));
    CHECK(fabs(found.distance - 3) < 1e-12 && found.curve_place.segment == 0 && found.parameter == 0);
    EXPECT(GUSSET_ERROR_EMPTY_CURVE, gusset_surface_curve_distance(context, surface, empty, 0, &found));
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_surface_curve_distance(context, surface, wide, 0, &found));
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_surface_curve_distance(context, surface, curve, -1, &found));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_surface_curve_distance(context, NULL, curve, 0, &found));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_surface_curve_distance(context, surface, NULL, 0, &found));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_surface_curve_distance(context, surface, curve, 0, NULL));
    gusset_curve_destroy(curve);
    gusset_curve_destroy(empty);
    gusset_curve_destroy(wide);

    EXPECT(GUSSET_OK, gusset_surface_surface_distance(context, surface, surface, 0, &found));
    CHECK(found.distance == 0 && (found.flags & GUSSET_DISTANCE_MEETS));
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_surface_surface_distance(context, surface, surface, -1, &found));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_surface_surface_distance(context, NULL, surface, 0, &found));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_surface_surface_distance(context, surface, NULL, 0, &found));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_surface_surface_distance(context, surface, surface, 0, NULL));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_surface_surface_distance(context, surface, surface, 0, misaligned()));
    found.struct_size = 8;
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_surface_surface_distance(context, surface, surface, 0, &found));
}

static void minima(const gusset_surface *surface) {
    const double query[3] = {1.5, 2.25, 3}, nan[3] = {0, NAN, 0};
    gusset_nearest_options options = {sizeof options, 0.0, 1, 0, 0};
    gusset_surface_points_view parts = {sizeof parts, NULL, 0, 0, 0, 0};
    gusset_surface_points *points = NULL;

    EXPECT(GUSSET_OK, gusset_surface_minima_create(context, surface, query, &options, &points));
    EXPECT(GUSSET_OK, gusset_surface_points_get_view(points, &parts));
    CHECK(parts.count == 1 && parts.complete == 1 && fabs(parts.points[0].distance - 3) < 1e-12);
    CHECK(parts.points[0].flags == (GUSSET_NEAREST_FOUND | GUSSET_NEAREST_PROVEN));
    gusset_surface_points_destroy(points);
    options.limited = 1, options.limit = 1;
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
    gusset_surface_region_view parts;
    gusset_surface_region *found = NULL;

    memset(&parts, 0, sizeof parts);
    parts.struct_size = sizeof parts;
    EXPECT(GUSSET_OK, gusset_surface_region_create(context, surface, query, 1.01, &found));
    EXPECT(GUSSET_OK, gusset_surface_region_get_view(found, &parts));
    CHECK(parts.cell_count == 1 && parts.cells[0].row == 0 && parts.cells[0].column == 1 && parts.cells[0].whole == 0);
    CHECK(parts.word_count == 1 && parts.mask[0] == 2 && parts.sheet_count == 1 && parts.first[1] == 16);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_surface_region_get_view(found, NULL));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_surface_region_get_view(NULL, &parts));
    CHECK(parts.cells == NULL);
    gusset_surface_region_destroy(found);
    gusset_surface_region_destroy(NULL);
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
    EXPECT(GUSSET_OK, gusset_sheet_from_nodes_create(context, &nodes, &sheets[0]));
    nodes.nodes = plane[1];
    EXPECT(GUSSET_OK, gusset_sheet_borrow_create(context, &nodes, &sheets[1]));
    status = gusset_surface_create(context, (const gusset_sheet *const *)sheets, 2, NULL, surface);
    gusset_sheet_destroy(sheets[0]), gusset_sheet_destroy(sheets[1]);
    return status;
}

static void sheets(void) {
    const double factors[3] = {1e39, 1e300, 1e-60};
    gusset_surface_sheet_report facts;
    gusset_surface *surface = NULL;
    gusset_error_report report;
    int k;
    memset(&facts, 0, sizeof facts), memset(&report, 0, sizeof report);
    facts.struct_size = sizeof facts, report.struct_size = sizeof report;
    EXPECT(GUSSET_OK, pair(2.0, &surface));
    EXPECT(GUSSET_OK, gusset_surface_get_sheet(surface, 1, &facts));
    CHECK(facts.rows == 2 && facts.columns == 2 && facts.first_cell == 4 && facts.first_node == 9);
    CHECK(facts.closed_u == 0 && facts.closed_v == 0);
    EXPECT(GUSSET_ERROR_NO_SUCH_ELEMENT, gusset_surface_get_sheet(surface, 2, &facts));
    CHECK(facts.rows == 0 && facts.first_cell == 0 && facts.struct_size == sizeof facts);
    EXPECT(GUSSET_OK, gusset_surface_get_sheet(surface, 0, &facts));
    CHECK(facts.first_cell == 0 && facts.first_node == 0);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_surface_get_sheet(NULL, 0, &facts));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_surface_get_sheet(surface, 0, NULL));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_surface_get_sheet(surface, 0, misaligned()));
    facts.struct_size = 8;
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_surface_get_sheet(surface, 0, &facts));
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

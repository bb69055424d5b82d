/* Makes surfaces of all kinds, meshes and points on them with invalid and valid arguments, and checks errors and
   results. */
#include "check.h"
#include <math.h>

static gusset_context *context;

/* Nodes (i, j, i * j) for i, j = 0 .. 5, row after row. */
static double grid[6 * 6 * 3];

static gusset_nodes nodes_of(const double *points, size_t rows, size_t columns) {
    gusset_nodes nodes;
    memset(&nodes, 0, sizeof nodes);
    nodes.struct_size = sizeof nodes;
    nodes.nodes = points, nodes.rows = rows, nodes.columns = columns, nodes.scalar = GUSSET_F64;
    return nodes;
}

static gusset_sheet *saddle(void) {
    const gusset_nodes nodes = nodes_of(grid, 6, 6);
    gusset_sheet *sheet = NULL;
    EXPECT(GUSSET_OK, gusset_sheet_create(context, &nodes, NULL, 0, &sheet));
    return sheet;
}

static void from_tangents(void) {
    static double u[36 * 3], v[36 * 3], twists[36 * 3];
    gusset_nodes nodes = nodes_of(grid, 6, 6);
    gusset_tangents tangents = {sizeof tangents, u, v, twists, GUSSET_TWISTS_DIFFERENCES, 0};
    gusset_sheet *sheet = (gusset_sheet *)misaligned();
    gusset_sheet_report parts;
    gusset_error_report report;
    int k;

    for (k = 0; k < 36; ++k) {
        u[3 * k] = 1.0, u[3 * k + 2] = k % 6;
        v[3 * k + 1] = 1.0, v[3 * k + 2] = k / 6;
        twists[3 * k + 2] = 1.0;
    }
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_sheet_create(context, NULL, &tangents, 0, &sheet));
    CHECK(sheet == NULL);
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_sheet_create(context, &nodes, &tangents, 2, &sheet));
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_sheet_create(context, &nodes, NULL, 2, &sheet));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_sheet_create(context, &nodes, misaligned(), 0, &sheet));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_sheet_create(context, &nodes, &tangents, 0, NULL));
    tangents.u = NULL;
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_sheet_create(context, &nodes, &tangents, 0, &sheet));
    tangents.u = u, tangents.twist = 9;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_sheet_create(context, &nodes, &tangents, 0, &sheet));
    tangents.twist = GUSSET_TWISTS_GIVEN, tangents.twists = NULL;
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_sheet_create(context, &nodes, &tangents, 0, &sheet));
    tangents.twists = twists, tangents.reserved = 1;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_sheet_create(context, &nodes, &tangents, 0, &sheet));
    tangents.reserved = 0, tangents.struct_size = 8;
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_sheet_create(context, &nodes, &tangents, 0, &sheet));
    tangents.struct_size = sizeof tangents, nodes.rows = 1;
    EXPECT(GUSSET_ERROR_NET_TOO_SMALL, gusset_sheet_create(context, &nodes, &tangents, 0, &sheet));
    nodes.rows = 6, nodes.closed_u = 1;
    EXPECT(GUSSET_ERROR_SIDES_DIFFER, gusset_sheet_create(context, &nodes, &tangents, 0, &sheet));
    nodes.closed_u = 0, u[3 * 8 + 1] = NAN;
    EXPECT(GUSSET_ERROR_NOT_FINITE, gusset_sheet_create(context, &nodes, &tangents, 0, &sheet));
    memset(&report, 0, sizeof report), report.struct_size = sizeof report;
    EXPECT(GUSSET_OK, gusset_context_get_report(context, &report));
    CHECK(report.element == GUSSET_ELEMENT_NODE && report.index == 8);
    u[3 * 8 + 1] = 0.0;
    for (k = GUSSET_TWISTS_DIFFERENCES; k <= GUSSET_TWISTS_GIVEN; ++k) {
        tangents.twist = (gusset_twists)k;
        /* Borrowed or copied, the nodes are not kept. */
        EXPECT(GUSSET_OK, gusset_sheet_create(context, &nodes, &tangents, k % 2, &sheet));
        memset(&parts, 0, sizeof parts), parts.struct_size = sizeof parts;
        EXPECT(GUSSET_OK, gusset_sheet_get_report(sheet, &parts));
        CHECK(parts.rows == 5 && parts.columns == 5 && parts.degree == 3 && parts.is_grid == 0 && parts.closed_u == 0);
        gusset_sheet_destroy(sheet);
    }
}

static void from_patches(void) {
    /* A bilinear patch with one side in a point. */
    const double points[12] = {0, 0, 0, 0, 0, 0, 1, 0, 0, 1, 1, 0};
    const double nan[12] = {0, 0, 0, 0, 0, 0, 1, 0, NAN, 1, 1, 0};
    gusset_sheet *sheet = (gusset_sheet *)misaligned();
    gusset_sheet_report parts;

    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_sheet_from_patches_create(context, NULL, 1, 1, 1, 1, &sheet));
    CHECK(sheet == NULL);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_sheet_from_patches_create(context, points, 1, 1, 1, 1, NULL));
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_sheet_from_patches_create(context, points, 0, 1, 1, 1, &sheet));
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_sheet_from_patches_create(context, points, 11, 0, 1, 1, &sheet));
    EXPECT(GUSSET_ERROR_EMPTY_MESH, gusset_sheet_from_patches_create(context, points, 1, 1, 0, 1, &sheet));
    EXPECT(GUSSET_ERROR_SIZE_OVERFLOW, gusset_sheet_from_patches_create(context, points, 1, 1, SIZE_MAX, 2, &sheet));
    EXPECT(GUSSET_ERROR_TOO_LARGE, gusset_sheet_from_patches_create(context, points, 1, 1, SIZE_MAX / 8, 1, &sheet));
    EXPECT(GUSSET_ERROR_NOT_FINITE, gusset_sheet_from_patches_create(context, nan, 1, 1, 1, 1, &sheet));
    CHECK(sheet == NULL);
    EXPECT(GUSSET_OK, gusset_sheet_from_patches_create(context, points, 1, 1, 1, 1, &sheet));
    memset(&parts, 0, sizeof parts), parts.struct_size = sizeof parts;
    EXPECT(GUSSET_OK, gusset_sheet_get_report(sheet, &parts));
    CHECK(parts.rows == 1 && parts.pole_u0 == 1 && parts.pole_u1 == 0 && parts.pole_v0 == 0 && parts.pole_v1 == 0);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_sheet_get_report(NULL, &parts));
    CHECK(parts.rows == 0);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_sheet_get_report(sheet, NULL));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_sheet_get_report(sheet, misaligned()));
    parts.struct_size = 8;
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_sheet_get_report(sheet, &parts));
    gusset_sheet_destroy(sheet);
}

static void from_spline(void) {
    double knots[8] = {0, 0, 0, 0, 1, 1, 1, 1};
    const double round[7] = {0, 1, 2, 3, 4, 5, 6};
    gusset_spline spline;
    gusset_sheet *sheet = (gusset_sheet *)misaligned();
    gusset_sheet_report parts;
    gusset_error_report report;

    memset(&spline, 0, sizeof spline);
    spline.struct_size = sizeof spline;
    spline.points = grid, spline.count_u = spline.count_v = 4;
    spline.knots_u = spline.knots_v = knots, spline.knot_count_u = spline.knot_count_v = 8;
    spline.degree_u = spline.degree_v = 3;
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_sheet_from_spline_create(context, NULL, &sheet));
    CHECK(sheet == NULL);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_sheet_from_spline_create(context, &spline, NULL));
    EXPECT(GUSSET_OK, gusset_sheet_from_spline_create(context, &spline, &sheet));
    gusset_sheet_destroy(sheet);
    spline.degree_u = 8;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_sheet_from_spline_create(context, &spline, &sheet));
    spline.degree_u = 4;
    EXPECT(GUSSET_ERROR_NET_TOO_SMALL, gusset_sheet_from_spline_create(context, &spline, &sheet));
    spline.degree_u = 3, spline.knot_count_v = 7;
    EXPECT(GUSSET_ERROR_BAD_KNOTS, gusset_sheet_from_spline_create(context, &spline, &sheet));
    spline.knot_count_v = 8, knots[5] = 0.5;
    EXPECT(GUSSET_ERROR_BAD_KNOTS, gusset_sheet_from_spline_create(context, &spline, &sheet));
    memset(&report, 0, sizeof report), report.struct_size = sizeof report;
    EXPECT(GUSSET_OK, gusset_context_get_report(context, &report));
    CHECK(report.element == GUSSET_ELEMENT_KNOT && report.index == 5 && report.value == 0.5);
    knots[5] = 1.0, spline.closed_u = 2;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_sheet_from_spline_create(context, &spline, &sheet));
    spline.closed_u = 0, spline.knots_u = NULL;
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_sheet_from_spline_create(context, &spline, &sheet));
    spline.knots_u = knots, spline.count_u = SIZE_MAX;
    EXPECT(GUSSET_ERROR_SIZE_OVERFLOW, gusset_sheet_from_spline_create(context, &spline, &sheet));
    spline.struct_size = 8;
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_sheet_from_spline_create(context, &spline, &sheet));
    CHECK(sheet == NULL);
    /* Closed in u, of degree 5. */
    spline.struct_size = sizeof spline, spline.count_u = 6, spline.count_v = 4, spline.degree_u = 5;
    spline.knots_u = round, spline.knot_count_u = 7, spline.closed_u = 1;
    EXPECT(GUSSET_OK, gusset_sheet_from_spline_create(context, &spline, &sheet));
    memset(&parts, 0, sizeof parts), parts.struct_size = sizeof parts;
    EXPECT(GUSSET_OK, gusset_sheet_get_report(sheet, &parts));
    CHECK(parts.rows == 6 && parts.columns == 1 && parts.degree == 7 && parts.closed_u == 1 && parts.closed_v == 0);
    CHECK(parts.deviation == 0.0 && parts.knots_u[6] == 6.0 && parts.knots_v[0] == 0.0 && parts.knots_v[1] == 1.0);
    gusset_sheet_destroy(sheet);
}

static void from_rational_spline(void) {
    const double knots[8] = {0, 0, 0, 0, 1, 1, 1, 1}, bad[5] = {0.0, -1.0, NAN, INFINITY, 1e-300};
    /* Knots of which the last span cannot be cut. */
    const double apart[9] = {0, 0, 0, 0, 1, nextafter(1, 2), nextafter(1, 2), nextafter(1, 2), nextafter(1, 2)};
    static double points[5 * 4 * 3];
    double weights[20];
    gusset_spline spline;
    gusset_sheet *sheet = (gusset_sheet *)misaligned();
    gusset_sheet_report parts;
    gusset_error_report report;
    int k;

    for (k = 0; k < 60; ++k) {
        points[k] = k % 3 == 0 ? k / 12 : k % 3 == 1 ? k / 3 % 4 : 0.1 * (k * k % 7);
    }
    for (k = 0; k < 20; ++k) {
        weights[k] = 1.0 + k % 3;
    }
    memset(&spline, 0, sizeof spline);
    spline.struct_size = sizeof spline;
    spline.points = points, spline.count_u = spline.count_v = 4;
    spline.knots_u = spline.knots_v = knots, spline.knot_count_u = spline.knot_count_v = 8;
    spline.degree_u = spline.degree_v = 3, spline.weights = weights;
    EXPECT(GUSSET_OK, gusset_sheet_from_spline_create(context, &spline, &sheet));
    memset(&parts, 0, sizeof parts), parts.struct_size = sizeof parts;
    EXPECT(GUSSET_OK, gusset_sheet_get_report(sheet, &parts));
    CHECK(parts.deviation > 0.0 && parts.deviation < 1e-11 && parts.degree == 7);
    CHECK(parts.knots_u[0] == 0.0 && parts.knots_u[parts.rows] == 1.0 && parts.knots_v[parts.columns] == 1.0);
    gusset_sheet_destroy(sheet);
    for (k = 0; k < 5; ++k) {
        weights[6] = bad[k];
        EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_sheet_from_spline_create(context, &spline, &sheet));
        memset(&report, 0, sizeof report), report.struct_size = sizeof report;
        EXPECT(GUSSET_OK, gusset_context_get_report(context, &report));
        CHECK(report.element == GUSSET_ELEMENT_NODE && report.index == 6 && (k == 2 || report.value == bad[k]));
    }
    CHECK(sheet == NULL);
    weights[6] = 1.0;
    spline.tolerance = -1.0;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_sheet_from_spline_create(context, &spline, &sheet));
    spline.tolerance = NAN;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_sheet_from_spline_create(context, &spline, &sheet));
    spline.tolerance = 1e-16;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_sheet_from_spline_create(context, &spline, &sheet));
    spline.tolerance = 1e-9, spline.max_cells = 3;
    EXPECT(GUSSET_ERROR_TOO_LARGE, gusset_sheet_from_spline_create(context, &spline, &sheet));
    spline.max_cells = 0, spline.count_u = 5, spline.knots_u = apart, spline.knot_count_u = 9;
    EXPECT(GUSSET_ERROR_BAD_KNOTS, gusset_sheet_from_spline_create(context, &spline, &sheet));
    /* A struct of an earlier version lacks weights. */
    spline.struct_size = 80;
    EXPECT(GUSSET_OK, gusset_sheet_from_spline_create(context, &spline, &sheet));
    gusset_sheet_destroy(sheet);
}

static gusset_curve *line(double ax, double ay, double bx, double by) {
    const double points[4] = {ax, ay, bx, by};
    const uint32_t ends[2] = {0, 1};
    gusset_curve *made = NULL;
    EXPECT(GUSSET_OK, gusset_curve_create(context, points, 2, 2, ends, 2, 0, &made));
    return made;
}

static void from_curves(void) {
    gusset_curve *made[5];
    const gusset_curve *rows[2], *columns[2];
    gusset_curve_net net = {sizeof net, rows, 2, columns, 2, 0.0, 0, 0};
    gusset_sheet *sheet = (gusset_sheet *)misaligned();
    gusset_error_report report;
    gusset_sheet_measures measures;
    int k;

    made[0] = line(0, 0, 0, 1), made[1] = line(1, 0, 1, 1), made[2] = line(0, 0, 1, 0), made[3] = line(0, 1, 1, 1);
    made[4] = line(0, 3, 1, 3);
    rows[0] = made[0], rows[1] = made[1], columns[0] = made[2], columns[1] = made[3];
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_sheet_from_curves_create(context, NULL, &sheet));
    CHECK(sheet == NULL);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_sheet_from_curves_create(context, &net, NULL));
    EXPECT(GUSSET_OK, gusset_sheet_from_curves_create(context, &net, &sheet));
    memset(&measures, 0, sizeof measures), measures.struct_size = sizeof measures, measures.crease = 7.0;
    EXPECT(GUSSET_OK, gusset_sheet_measure(context, sheet, GUSSET_SHEET_MEASURE_CREASE, NULL, &measures));
    CHECK(measures.crease == 0.0 && measures.curvature_bound == 0.0);
    gusset_sheet_destroy(sheet);
    columns[1] = made[4];
    EXPECT(GUSSET_ERROR_CURVES_APART, gusset_sheet_from_curves_create(context, &net, &sheet));
    memset(&report, 0, sizeof report), report.struct_size = sizeof report;
    EXPECT(GUSSET_OK, gusset_context_get_report(context, &report));
    CHECK(report.element == GUSSET_ELEMENT_ROW && report.index == 0 && report.value == 2.0);
    columns[1] = NULL;
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_sheet_from_curves_create(context, &net, &sheet));
    columns[1] = made[3], net.tolerance = -1.0;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_sheet_from_curves_create(context, &net, &sheet));
    net.tolerance = 0.0, net.column_count = 1;
    EXPECT(GUSSET_ERROR_NET_TOO_SMALL, gusset_sheet_from_curves_create(context, &net, &sheet));
    net.row_count = 0;
    EXPECT(GUSSET_ERROR_NET_TOO_SMALL, gusset_sheet_from_curves_create(context, &net, &sheet));
    net.rows = NULL, net.column_count = 2;
    EXPECT(GUSSET_OK, gusset_sheet_from_curves_create(context, &net, &sheet));
    gusset_sheet_destroy(sheet);
    net.closed_u = 2;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_sheet_from_curves_create(context, &net, &sheet));
    net.closed_u = 1;
    EXPECT(GUSSET_ERROR_CURVE_NOT_CLOSED, gusset_sheet_from_curves_create(context, &net, &sheet));
    net.row_count = SIZE_MAX;
    EXPECT(GUSSET_ERROR_SIZE_OVERFLOW, gusset_sheet_from_curves_create(context, &net, &sheet));
    net.struct_size = 8;
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_sheet_from_curves_create(context, &net, &sheet));
    CHECK(sheet == NULL);
    for (k = 0; k < 5; ++k) {
        gusset_curve_destroy(made[k]);
    }
}

static void from_frame(void) {
    const uint32_t offsets[3] = {0, 4, 8};
    const double points[24] = {1, 0, 0, 0, 1, 0, -1, 0, 0, 0, -1, 0, 1, 0, 1, 0, 1, 1, -1, 0, 1, 0, -1, 1};
    gusset_outlines sections;
    gusset_frame_options options;
    gusset_frame *frame = NULL;
    gusset_sheet *sheet = (gusset_sheet *)misaligned();
    gusset_sheet_report parts;
    uint32_t kind;

    memset(&sections, 0, sizeof sections);
    sections.struct_size = sizeof sections;
    sections.points = points, sections.point_count = 8, sections.dimension = 3, sections.offsets = offsets;
    sections.outline_count = 2, sections.closed = 1;
    /* Sections of four points have corners, which a grid would round. */
    memset(&options, 0, sizeof options);
    options.struct_size = sizeof options;
    options.smooth_corners = 1;
    EXPECT(GUSSET_OK, gusset_frame_create(context, &sections, &options, &frame));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_sheet_from_frame_create(context, NULL, GUSSET_FRAME_NODES, &sheet));
    CHECK(sheet == NULL);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_sheet_from_frame_create(context, frame, GUSSET_FRAME_NODES, NULL));
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_sheet_from_frame_create(context, frame, 3, &sheet));
    for (kind = GUSSET_FRAME_SECTIONS; kind <= GUSSET_FRAME_CURVES; ++kind) {
        EXPECT(GUSSET_OK, gusset_sheet_from_frame_create(context, frame, kind, &sheet));
        memset(&parts, 0, sizeof parts), parts.struct_size = sizeof parts;
        EXPECT(GUSSET_OK, gusset_sheet_get_report(sheet, &parts));
        CHECK(parts.closed_u == 0 && parts.closed_v == 1 && parts.is_grid == (kind == GUSSET_FRAME_NODES));
        {
            const double by = 0.1, bad[2] = {0.1, INFINITY};
            double deviation = 9.0;
            gusset_sheet *offset = NULL;
            EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_sheet_offset_create(context, NULL, &by, 1, &deviation, &offset));
            EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_sheet_offset_create(context, sheet, NULL, 1, &deviation, &offset));
            EXPECT(GUSSET_ERROR_COUNT_DIFFERS, gusset_sheet_offset_create(context, sheet, &by, 0, &deviation, &offset));
            EXPECT(GUSSET_ERROR_NOT_FINITE, gusset_sheet_offset_create(context, sheet, bad, 2, &deviation, &offset));
            EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_sheet_offset_create(context, sheet, &by, 1, misaligned(), &offset));
            CHECK(offset == NULL);
            EXPECT(GUSSET_OK, gusset_sheet_offset_create(context, sheet, &by, 1, NULL, &offset));
            gusset_sheet_destroy(offset);
        }
        gusset_sheet_destroy(sheet);
    }
    gusset_frame_destroy(frame);
}

static void questions(void) {
    gusset_sheet *sheet = saddle();
    const gusset_sheet *sheets[1];
    gusset_surface *surface = NULL;
    double errors[25], bilinear[25], triangles[25];
    const double parameters[4] = {2.5, 3.25, -1.0, 99.0};
    const double nan[4] = {2.5, 3.25, NAN, 0.0};
    gusset_surface_place places[2];
    gusset_surface_point found[2];
    gusset_nodes given = nodes_of(grid, 6, 6);
    gusset_sheet *none = NULL;
    gusset_cell_arrays arrays = {sizeof arrays, 25, NULL, NULL, errors, bilinear, triangles};
    gusset_sheet_measures measures;
    gusset_error_report report;

    errors[0] = 7.0;
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_sheet_measure(context, NULL, 0, &arrays, NULL));
    arrays.capacity = 24;
    EXPECT(GUSSET_ERROR_BUFFER_TOO_SMALL, gusset_sheet_measure(context, sheet, 0, &arrays, NULL));
    arrays.capacity = 25, arrays.bilinear = (double *)misaligned();
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_sheet_measure(context, sheet, 0, &arrays, NULL));
    CHECK(errors[0] == 7.0);
    arrays.bilinear = bilinear;
    EXPECT(GUSSET_OK, gusset_sheet_measure(context, sheet, 0, &arrays, NULL));
    CHECK(errors[0] < 1e-13 && bilinear[24] < 1e-13 && fabs(triangles[7] - 0.25) < 1e-13);

    sheets[0] = sheet;
    EXPECT(GUSSET_OK, gusset_surface_create(context, sheets, 1, NULL, &surface));
    EXPECT(GUSSET_ERROR_SIZE_OVERFLOW, gusset_sheet_from_patches_create(context, grid, 3, 3, SIZE_MAX / 2, 4, &none));
    CHECK(strstr(gusset_context_get_message(context), "patches") != NULL);
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_sheet_from_patches_create(context, grid, UINT32_MAX, 3, 1, 1, &none));
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_sheet_from_patches_create(context, grid, 3, 0, 1, 1, &none));
    given.scalar = GUSSET_F32;
    EXPECT(GUSSET_ERROR_BAD_STRIDE, gusset_sheet_create(context, &given, NULL, 1, &none));
    given.scalar = GUSSET_F64;
    gusset_context_cancel(context);
    EXPECT(GUSSET_ERROR_CANCELLED, gusset_sheet_create(context, &given, NULL, 0, &none));
    EXPECT(GUSSET_ERROR_CANCELLED, gusset_sheet_create(context, &given, NULL, 1, &none));
    memset(&measures, 0, sizeof measures), measures.struct_size = sizeof measures;
    EXPECT(GUSSET_ERROR_CANCELLED, gusset_sheet_measure(context, sheet, 0, NULL, &measures));
    gusset_context_reset(context);
    EXPECT(GUSSET_OK, gusset_sheet_measure(context, sheet, 0, NULL, &measures));
    CHECK(measures.crease < 1e-12);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_surface_locate(context, NULL, 0, parameters, 2, places));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_surface_locate(context, surface, 0, NULL, 2, places));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_surface_locate(context, surface, 0, parameters, 2, NULL));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_surface_locate(context, surface, 0, parameters, 2, misaligned()));
    EXPECT(GUSSET_ERROR_SIZE_OVERFLOW, gusset_surface_locate(context, surface, 0, parameters, SIZE_MAX, places));
    EXPECT(GUSSET_ERROR_NO_SUCH_ELEMENT, gusset_surface_locate(context, surface, 1, parameters, 2, places));
    EXPECT(GUSSET_ERROR_NO_SUCH_ELEMENT, gusset_surface_locate(context, surface, 0, nan, 2, places));
    memset(&report, 0, sizeof report), report.struct_size = sizeof report;
    EXPECT(GUSSET_OK, gusset_context_get_report(context, &report));
    CHECK(report.element == GUSSET_ELEMENT_PLACE && report.index == 1);
    EXPECT(GUSSET_OK, gusset_surface_locate(context, surface, 0, parameters, 2, places));
    CHECK(places[0].row == 2 && places[0].u == 0.5 && places[0].column == 3 && places[0].v == 0.25);
    CHECK(places[1].row == 0 && places[1].u == 0.0 && places[1].column == 4 && places[1].v == 1.0);

    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_surface_evaluate(context, NULL, places, 2, found));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_surface_evaluate(context, surface, NULL, 2, found));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_surface_evaluate(context, surface, places, 2, NULL));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_surface_evaluate(context, surface, places, 2, misaligned()));
    EXPECT(GUSSET_ERROR_SIZE_OVERFLOW, gusset_surface_evaluate(context, surface, places, SIZE_MAX, found));
    EXPECT(GUSSET_OK, gusset_surface_evaluate(context, surface, NULL, 0, NULL));
    EXPECT(GUSSET_OK, gusset_surface_evaluate(context, surface, places, 2, found));
    CHECK(fabs(found[0].point[2] - 2.5 * 3.25) < 1e-12 && fabs(found[0].uv[2] - 1.0) < 1e-12);
    CHECK(found[0].normal_kind == GUSSET_NORMAL_REGULAR && found[0].is_curved == 1 && found[0].gaussian < 0.0);
    CHECK(fabs(found[0].principal[0] * found[0].principal[1] - found[0].gaussian) < 1e-12);
    places[1].v = 1.5;
    EXPECT(GUSSET_ERROR_NO_SUCH_ELEMENT, gusset_surface_evaluate(context, surface, places, 2, found));
    EXPECT(GUSSET_OK, gusset_context_get_report(context, &report));
    CHECK(report.element == GUSSET_ELEMENT_PLACE && report.index == 1);
    CHECK(found[0].normal_kind == GUSSET_NORMAL_NONE && found[0].uv[2] == 0.0);
    places[1].v = 1.0, places[1].reserved = 1;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_surface_evaluate(context, surface, places, 2, found));
    /* Every failure clears the buffers. */
    memset(found, 7, sizeof found), memset(places, 7, sizeof places);
    gusset_context_cancel(context);
    EXPECT(GUSSET_ERROR_CANCELLED, gusset_surface_evaluate(context, surface, NULL, 2, found));
    EXPECT(GUSSET_ERROR_CANCELLED, gusset_surface_locate(context, surface, 0, parameters, 2, places));
    gusset_context_reset(context);
    CHECK(found[1].is_curved == 0 && found[0].point[0] == 0 && places[0].row == 0 && places[1].v == 0);
    gusset_surface_destroy(surface);
    gusset_sheet_destroy(sheet);
}

static void meshes(void) {
    gusset_sheet *sheet = saddle();
    gusset_result *mesh = (gusset_result *)misaligned();
    gusset_sheet_mesh_options options = {sizeof options, 0.01, 0, 0, 1, 0};
    gusset_sheet_mesh_report parts;
    gusset_mesh_view view;

    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_sheet_to_mesh(context, NULL, NULL, &mesh));
    CHECK(mesh == NULL);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_sheet_to_mesh(context, sheet, NULL, NULL));
    options.tolerance = NAN;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_sheet_to_mesh(context, sheet, &options, &mesh));
    options.tolerance = 1e-300;
    EXPECT(GUSSET_ERROR_TOO_LARGE, gusset_sheet_to_mesh(context, sheet, &options, &mesh));
    options.tolerance = 0.01, options.triangles = 2;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_sheet_to_mesh(context, sheet, &options, &mesh));
    options.triangles = 1, options.reserved = 1;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_sheet_to_mesh(context, sheet, &options, &mesh));
    options.reserved = 0, options.struct_size = 8;
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_sheet_to_mesh(context, sheet, &options, &mesh));
    CHECK(mesh == NULL);
    memset(&view, 0, sizeof view), view.struct_size = sizeof view;
    memset(&parts, 0, sizeof parts), parts.struct_size = sizeof parts;
    EXPECT(GUSSET_OK, gusset_sheet_to_mesh(context, sheet, NULL, &mesh));
    EXPECT(GUSSET_OK, gusset_result_get_mesh(mesh, &view));
    CHECK(view.face_count == 25 && view.vertex_count == 36 && view.scalar == GUSSET_F64);
    gusset_result_destroy(mesh);
    options.struct_size = sizeof options;
    EXPECT(GUSSET_OK, gusset_sheet_to_mesh(context, sheet, &options, &mesh));
    EXPECT(GUSSET_OK, gusset_result_get_mesh(mesh, &view));
    EXPECT(GUSSET_OK, gusset_result_get_sheet_mesh(mesh, &parts));
    CHECK(parts.vertex_count == view.vertex_count && parts.deviation <= 0.01 && view.face_count > 50);
    CHECK(parts.places[0].row == 0 && parts.normals[2] > 0.9);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_result_get_mesh(NULL, &view));
    CHECK(view.face_count == 0);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_result_get_mesh(mesh, NULL));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_result_get_sheet_mesh(NULL, &parts));
    CHECK(parts.vertex_count == 0);
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_result_get_sheet_mesh(mesh, misaligned()));
    parts.struct_size = 8;
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_result_get_sheet_mesh(mesh, &parts));
    gusset_result_destroy(mesh);
    gusset_result_destroy(NULL);
    gusset_sheet_destroy(sheet);
}

int main(void) {
    const gusset_mesh_view up = pyramid(pyramid_up), down = pyramid(pyramid_down);
    int k;

    if (gusset_context_create(&context) != GUSSET_OK || up.face_count != down.face_count) {
        return 1;
    }
    for (k = 0; k < 36; ++k) {
        grid[3 * k] = k / 6, grid[3 * k + 1] = k % 6, grid[3 * k + 2] = (k / 6) * (k % 6);
    }
    from_tangents();
    from_patches();
    from_spline();
    from_rational_spline();
    from_curves();
    from_frame();
    questions();
    meshes();
    gusset_context_destroy(context);
    return failures != 0;
}

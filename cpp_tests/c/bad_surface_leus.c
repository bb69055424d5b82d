/* What a host can get wrong with the paper's search, and what it gets if it does not. */
#include "check.h"
#include <math.h>

enum { ROWS = 6, COLUMNS = 9, CELLS = (ROWS - 1) * (COLUMNS - 1) };

static gusset_context *context;
static double data[3 * ROWS * COLUMNS];

/* The plane z = 0 with cells 1 x 1. */
static gusset_sheet *plane(void) {
    gusset_sheet *sheet = NULL;
    gusset_nodes nodes;
    for (int k = 0; k < ROWS * COLUMNS; k++) {
        data[3 * k] = k / COLUMNS;
        data[3 * k + 1] = k % COLUMNS;
        data[3 * k + 2] = 0.0;
    }
    memset(&nodes, 0, sizeof nodes);
    nodes.struct_size = sizeof nodes;
    nodes.nodes = data;
    nodes.rows = ROWS;
    nodes.columns = COLUMNS;
    nodes.scalar = GUSSET_F64;
    EXPECT(GUSSET_OK, gusset_sheet_create(context, &nodes, NULL, 0, &sheet));
    return sheet;
}

static void diameters(gusset_sheet *sheet) {
    double euclidean[CELLS], intrinsic[CELLS];
    gusset_cell_arrays arrays = {sizeof arrays, CELLS, euclidean, intrinsic, NULL, NULL, NULL};
    gusset_sheet_measures found;
    gusset_error_report report;

    memset(&found, 0, sizeof found), memset(&report, 0, sizeof report);
    found.struct_size = sizeof found, report.struct_size = sizeof report;
    EXPECT(GUSSET_OK, gusset_sheet_measure(context, sheet, 0, NULL, NULL));
    EXPECT(GUSSET_OK, gusset_sheet_measure(context, sheet, GUSSET_SHEET_MEASURE_DIAMETERS, &arrays, &found));
    CHECK(fabs(euclidean[7] - sqrt(2.0)) < 1e-12 && fabs(intrinsic[CELLS - 1] - sqrt(2.0)) < 1e-12);
    CHECK(found.diameter >= euclidean[3] && found.intrinsic_diameter >= intrinsic[3] && found.crease == 0.0);
    arrays.diameters = NULL, intrinsic[3] = 7.0;
    EXPECT(GUSSET_OK, gusset_sheet_measure(context, sheet, 0, &arrays, NULL));
    CHECK(fabs(intrinsic[3] - sqrt(2.0)) < 1e-12);
    arrays.capacity = CELLS - 1, intrinsic[3] = 7.0;
    EXPECT(GUSSET_ERROR_BUFFER_TOO_SMALL, gusset_sheet_measure(context, sheet, 0, &arrays, &found));
    EXPECT(GUSSET_OK, gusset_context_get_report(context, &report));
    CHECK(report.value == CELLS && found.diameter == 0.0 && intrinsic[3] == 7.0);
    arrays.capacity = CELLS, arrays.diameters = (double *)misaligned();
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_sheet_measure(context, sheet, 0, &arrays, NULL));
    arrays.diameters = NULL;
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_sheet_measure(context, NULL, 0, &arrays, NULL));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_sheet_measure(context, sheet, 0, misaligned(), NULL));
    arrays.struct_size = 8;
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_sheet_measure(context, sheet, 0, &arrays, NULL));

    EXPECT(GUSSET_OK, gusset_sheet_measure(context, sheet, 0, NULL, &found));
    CHECK(found.diameter >= sqrt(2.0) && found.curvature_bound < 1e-9 && found.crease < 1e-9);
    EXPECT(GUSSET_OK, gusset_sheet_measure(context, sheet, GUSSET_SHEET_MEASURE_CURVATURE, NULL, &found));
    CHECK(found.diameter == 0.0 && found.curvature_bound < 1e-9);
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_sheet_measure(context, sheet, 8, NULL, &found));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_sheet_measure(context, sheet, 0, NULL, misaligned()));
    found.curvature_bound = 7.0;
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_sheet_measure(context, NULL, 0, NULL, &found));
    CHECK(found.curvature_bound == 0.0);
    found.struct_size = 8;
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_sheet_measure(context, sheet, 0, NULL, &found));
}

static void regions(gusset_sheet *sheet) {
    const uint32_t from[2] = {0, 0}, to[2] = {4, 7}, beside[2] = {0, 2}, outside[2] = {5, 0};
    uint32_t cells[2 * CELLS];
    uint64_t words[1] = {0};
    size_t written = 99;
    gusset_mask_report report;

    memset(&report, 0, sizeof report);
    report.struct_size = sizeof report;
    EXPECT(GUSSET_OK, gusset_sheet_mask_chain(context, sheet, NULL, 0, from, to, NULL, 0, &written));
    CHECK(written == 8);
    EXPECT(GUSSET_OK, gusset_sheet_mask_chain(context, sheet, NULL, 0, from, to, cells, CELLS, &written));
    CHECK(written == 8 && cells[0] == 0 && cells[14] == 4 && cells[15] == 7);
    EXPECT(GUSSET_ERROR_BUFFER_TOO_SMALL, gusset_sheet_mask_chain(context, sheet, NULL, 0, from, to, cells, 7, &written));
    EXPECT(GUSSET_ERROR_NO_SUCH_ELEMENT,
           gusset_sheet_mask_chain(context, sheet, NULL, 0, from, outside, cells, CELLS, &written));
    CHECK(written == 0);
    /* Cells (0, 0), (1, 1) and, apart, (0, 3). */
    words[0] = UINT64_C(1) | UINT64_C(1) << 9 | UINT64_C(1) << 3;
    EXPECT(GUSSET_ERROR_NO_SUCH_ELEMENT, gusset_sheet_mask_chain(context, sheet, words, 1, from, beside, cells, CELLS, &written));
    EXPECT(GUSSET_OK, gusset_sheet_mask_measure(context, sheet, words, 1, &report));
    CHECK(report.cells == 3 && report.integer_diameter == UINT64_MAX && report.euler == 2 && isinf(report.diameter));
    words[0] = UINT64_C(1) | UINT64_C(1) << 9;
    EXPECT(GUSSET_OK, gusset_sheet_mask_measure(context, sheet, words, 1, &report));
    CHECK(report.cells == 2 && report.integer_diameter == 2 && report.euler == 1);
    CHECK(fabs(report.diameter - 2.0 * sqrt(2.0)) < 1e-12);
    EXPECT(GUSSET_OK, gusset_sheet_mask_measure(context, sheet, NULL, 0, &report));
    CHECK(report.cells == CELLS && report.integer_diameter == 8 && report.euler == 1);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_sheet_mask_chain(context, sheet, NULL, 0, NULL, to, cells, CELLS, &written));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_sheet_mask_chain(context, sheet, NULL, 0, from, NULL, cells, CELLS, &written));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_sheet_mask_chain(context, sheet, NULL, 1, from, to, cells, CELLS, &written));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_sheet_mask_chain(context, NULL, NULL, 0, from, to, cells, CELLS, &written));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_sheet_mask_chain(context, sheet, NULL, 0, from, to, cells, CELLS, NULL));
    EXPECT(GUSSET_ERROR_SIZE_OVERFLOW, gusset_sheet_mask_chain(context, sheet, words, SIZE_MAX, from, to, cells, CELLS, &written));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_sheet_mask_measure(context, NULL, NULL, 0, &report));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_sheet_mask_measure(context, sheet, NULL, 0, NULL));
    EXPECT(GUSSET_ERROR_COUNT_DIFFERS, gusset_sheet_mask_measure(context, sheet, words, 0, &report));
    CHECK(report.cells == 0);
    report.struct_size = 8;
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_sheet_mask_measure(context, sheet, NULL, 0, &report));
}

static gusset_reference_task task_of(gusset_reference_object object, double x, double y, double z) {
    gusset_reference_task task;
    memset(&task, 0, sizeof task);
    task.struct_size = sizeof task;
    task.object = object;
    task.point[0] = x, task.point[1] = y, task.point[2] = z;
    return task;
}

static void masks(gusset_sheet *sheet) {
    gusset_reference_task task = task_of(GUSSET_REFERENCE_POINT, 2.5, 3.5, 0.0);
    gusset_reference_report report;
    uint64_t words[1] = {0};
    size_t written = 99;

    memset(&report, 0, sizeof report);
    report.struct_size = sizeof report;
    EXPECT(GUSSET_OK, gusset_sheet_reference_mask(context, sheet, &task, NULL, 0, &written, &report));
    CHECK(written == 1 && report.cells > 0 && report.evaluations > 0);
    EXPECT(GUSSET_OK, gusset_sheet_reference_mask(context, sheet, &task, words, 1, &written, &report));
    CHECK((words[0] >> (2 * (COLUMNS - 1) + 3) & 1) == 1 && report.cells < CELLS);
    task.find_nearest = 1;
    EXPECT(GUSSET_OK, gusset_sheet_reference_mask(context, sheet, &task, words, 1, &written, &report));
    CHECK(fabs(report.min_distance - sqrt(0.5)) < 1e-12);
    task = task_of(GUSSET_REFERENCE_POINT, 0.0, 0.0, 1e3);
    EXPECT(GUSSET_OK, gusset_sheet_reference_mask(context, sheet, &task, words, 1, &written, &report));
    CHECK(report.cells == 0 && words[0] == 0 && report.evaluations == 1 && report.dropped > 0);
    task = task_of(GUSSET_REFERENCE_PLANE, 2.5, 0.0, 0.0);
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_sheet_reference_mask(context, sheet, &task, words, 1, &written, NULL));
    task.direction[0] = 3.0, task.by_rows = task.by_rings = task.keep_lines = 1;
    EXPECT(GUSSET_OK, gusset_sheet_reference_mask(context, sheet, &task, words, 1, &written, NULL));
    CHECK((words[0] >> 16 & 0xff) == 0xff);
    task.object = GUSSET_REFERENCE_LINE;
    EXPECT(GUSSET_OK, gusset_sheet_reference_mask(context, sheet, &task, words, 1, &written, NULL));
    task.object = GUSSET_REFERENCE_SEGMENT;
    EXPECT(GUSSET_OK, gusset_sheet_reference_mask(context, sheet, &task, words, 1, &written, NULL));
    CHECK((words[0] >> 16 & 1) == 1);
    task = task_of(GUSSET_REFERENCE_ANGLE, 0.0, 0.0, 0.0);
    task.direction[2] = 1.0, task.angle = 1.0, task.within = 0.5;
    EXPECT(GUSSET_OK, gusset_sheet_reference_mask(context, sheet, &task, words, 1, &written, &report));
    CHECK(report.cells == 0);
    task.within = 1.1, task.curvature = 1e-6, task.unsigned_normals = 1;
    EXPECT(GUSSET_OK, gusset_sheet_reference_mask(context, sheet, &task, words, 1, &written, &report));
    CHECK(report.cells == CELLS);

    task.curvature = -1.0, words[0] = 7;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_sheet_reference_mask(context, sheet, &task, words, 1, &written, &report));
    CHECK(written == 0 && report.cells == 0 && words[0] == 0);
    words[0] = 7;
    gusset_context_cancel(context);
    EXPECT(GUSSET_ERROR_CANCELLED, gusset_sheet_reference_mask(context, sheet, &task, words, 1, &written, &report));
    gusset_context_reset(context);
    CHECK(words[0] == 0);
    task.curvature = 0.0, task.angle = 4.0;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_sheet_reference_mask(context, sheet, &task, words, 1, &written, &report));
    task.angle = 1.0, task.within = NAN;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_sheet_reference_mask(context, sheet, &task, words, 1, &written, &report));
    task.within = 0.0, task.object = 99;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_sheet_reference_mask(context, sheet, &task, words, 1, &written, &report));
    task.object = GUSSET_REFERENCE_POINT, task.find_nearest = 2;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_sheet_reference_mask(context, sheet, &task, words, 1, &written, &report));
    task.find_nearest = 0, task.point[1] = NAN;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_sheet_reference_mask(context, sheet, &task, words, 1, &written, &report));
    task.point[1] = 0.0;
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_sheet_reference_mask(context, NULL, &task, words, 1, &written, &report));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_sheet_reference_mask(context, sheet, NULL, words, 1, &written, &report));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_sheet_reference_mask(context, sheet, &task, NULL, 1, &written, &report));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_sheet_reference_mask(context, sheet, &task, words, 1, NULL, &report));
    EXPECT(GUSSET_ERROR_BUFFER_TOO_SMALL, gusset_sheet_reference_mask(context, sheet, &task, words, 0, &written, &report));
    report.struct_size = 8;
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_sheet_reference_mask(context, sheet, &task, words, 1, &written, &report));
    task.struct_size = 8;
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_sheet_reference_mask(context, sheet, &task, words, 1, &written, NULL));
}

/* Curves and surfaces as objects, curves in the place of sheets, and lists of cells and nodes. */
static void figures(gusset_sheet *sheet) {
    const double bar[6] = {0.5, 0.5, 0.0, 0.5, 6.5, 0.0}, up[3] = {0, 0, 1}, zero[3] = {0, 0, 0};
    const uint32_t ends[2] = {0, 1}, none[1] = {0};
    gusset_reference_task task = task_of(GUSSET_REFERENCE_CURVE, 0.0, 0.0, 0.0);
    gusset_reference_report report;
    uint64_t words[1] = {0};
    uint32_t cells[2 * CELLS];
    size_t written = 0;
    gusset_curve *curve = NULL, *empty = NULL;
    gusset_surface *surface = NULL;
    gusset_places *places = NULL;
    gusset_places_view view;

    memset(&report, 0, sizeof report);
    report.struct_size = sizeof report;
    memset(&view, 0, sizeof view);
    view.struct_size = sizeof view;
    EXPECT(GUSSET_OK, gusset_curve_create(context, bar, 2, 3, ends, 2, 0, &curve));
    EXPECT(GUSSET_OK, gusset_curve_create(context, NULL, 0, 3, none, 1, 0, &empty));
    EXPECT(GUSSET_OK, gusset_surface_create(context, (const gusset_sheet *const *)&sheet, 1, NULL, &surface));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_sheet_reference_mask(context, sheet, &task, words, 1, &written, &report));
    task.curve = empty;
    EXPECT(GUSSET_ERROR_EMPTY_CURVE, gusset_sheet_reference_mask(context, sheet, &task, words, 1, &written, &report));
    task.curve = curve;
    EXPECT(GUSSET_OK, gusset_sheet_reference_mask(context, sheet, &task, words, 1, &written, &report));
    CHECK((words[0] & 0x7f) == 0x7f && report.cells < CELLS);
    EXPECT(GUSSET_OK, gusset_sheet_mask_elements(context, sheet, words, 1, GUSSET_DOMAIN_FACES, NULL, 0, &written));
    CHECK(written == report.cells);
    EXPECT(GUSSET_OK, gusset_sheet_mask_elements(context, sheet, words, 1, GUSSET_DOMAIN_FACES, cells, CELLS, &written));
    CHECK(written == report.cells && cells[0] == 0 && cells[2] == 0 && cells[3] == 1);
    EXPECT(GUSSET_ERROR_BUFFER_TOO_SMALL, gusset_sheet_mask_elements(context, sheet, words, 1, GUSSET_DOMAIN_FACES, cells, 1, &written));
    EXPECT(GUSSET_ERROR_COUNT_DIFFERS, gusset_sheet_mask_elements(context, sheet, words, 0, GUSSET_DOMAIN_FACES, cells, CELLS, &written));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_sheet_mask_elements(context, NULL, words, 1, GUSSET_DOMAIN_FACES, cells, CELLS, &written));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_sheet_mask_elements(context, sheet, NULL, 1, GUSSET_DOMAIN_FACES, cells, CELLS, &written));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_sheet_mask_elements(context, sheet, words, 1, GUSSET_DOMAIN_FACES, NULL, CELLS, &written));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_sheet_mask_elements(context, sheet, words, 1, GUSSET_DOMAIN_FACES, cells, CELLS, NULL));
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_sheet_mask_elements(context, sheet, words, 1, 3, cells, CELLS, &written));
    CHECK(written == 0);
    words[0] = 1;
    EXPECT(GUSSET_OK, gusset_sheet_mask_elements(context, sheet, words, 1, GUSSET_DOMAIN_CORNERS, NULL, 0, &written));
    CHECK(written == 4);
    EXPECT(GUSSET_OK, gusset_sheet_mask_elements(context, sheet, words, 1, GUSSET_DOMAIN_VERTICES, cells, 4, &written));
    CHECK(written == 4 && cells[0] == 0 && cells[3] == 1 && cells[4] == 1 && cells[7] == 1);
    EXPECT(GUSSET_ERROR_BUFFER_TOO_SMALL, gusset_sheet_mask_elements(context, sheet, words, 1, GUSSET_DOMAIN_VERTICES, cells, 3, &written));
    EXPECT(GUSSET_ERROR_COUNT_DIFFERS, gusset_sheet_mask_elements(context, sheet, words, 0, GUSSET_DOMAIN_VERTICES, cells, 4, &written));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_sheet_mask_elements(context, NULL, words, 1, GUSSET_DOMAIN_VERTICES, cells, 4, &written));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_sheet_mask_elements(context, sheet, words, 1, GUSSET_DOMAIN_VERTICES, cells, 4, NULL));

    task.object = GUSSET_REFERENCE_SURFACE;
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_sheet_reference_mask(context, sheet, &task, words, 1, &written, &report));
    task.surface = surface;
    EXPECT(GUSSET_OK, gusset_sheet_reference_mask(context, sheet, &task, words, 1, &written, &report));
    CHECK(report.cells == CELLS && report.min_distance == 0);
    task = task_of(GUSSET_REFERENCE_RAY, 2.5, 6.5, 0.0);
    task.direction[1] = 1.0;
    EXPECT(GUSSET_OK, gusset_sheet_reference_mask(context, sheet, &task, words, 1, &written, &report));
    CHECK((words[0] >> 16 & 1) == 0 && (words[0] >> 22 & 3) == 3);

    /* Over the curve's own points: ten arcs of length 0.6, of which two are near y = 3.5. */
    task = task_of(GUSSET_REFERENCE_PLANE, 0.0, 3.3, 0.0);
    task.direction[1] = 2.0;
    EXPECT(GUSSET_OK, gusset_curve_reference_mask(context, curve, 10, &task, words, 1, &written, &report));
    CHECK(written == 1 && (words[0] >> 4 & 1) == 1 && report.cells < 6 && report.row == 0);
    EXPECT(GUSSET_OK, gusset_curve_reference_mask(context, curve, 10, &task, NULL, 0, &written, NULL));
    CHECK(written == 1);
    task.object = GUSSET_REFERENCE_ANGLE, task.angle = 0.1;
    EXPECT(GUSSET_OK, gusset_curve_reference_mask(context, curve, 10, &task, words, 1, &written, &report));
    CHECK(report.cells == 0);
    task.angle = 0.0;
    EXPECT(GUSSET_OK, gusset_curve_reference_mask(context, curve, 10, &task, words, 1, &written, &report));
    CHECK(report.cells == 10);
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_curve_reference_mask(context, curve, 0, &task, words, 1, &written, &report));
    CHECK(written == 0 && words[0] == 0);
    EXPECT(GUSSET_ERROR_TOO_LARGE, gusset_curve_reference_mask(context, curve, SIZE_MAX, &task, words, 1, &written, &report));
    EXPECT(GUSSET_ERROR_EMPTY_CURVE, gusset_curve_reference_mask(context, empty, 1, &task, words, 1, &written, &report));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_curve_reference_mask(context, NULL, 1, &task, words, 1, &written, &report));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_curve_reference_mask(context, curve, 1, NULL, words, 1, &written, &report));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_curve_reference_mask(context, curve, 1, &task, words, 1, NULL, &report));
    EXPECT(GUSSET_ERROR_BUFFER_TOO_SMALL, gusset_curve_reference_mask(context, curve, 65, &task, words, 1, &written, &report));
    task.object = 99;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_curve_reference_mask(context, curve, 1, &task, words, 1, &written, &report));

    /* Tangents at an angle: the bar is level. */
    EXPECT(GUSSET_OK, gusset_curve_tangent_angle_create(context, curve, up, 0.5 * acos(-1.0), &places));
    EXPECT(GUSSET_OK, gusset_places_get_view(places, &view));
    CHECK(view.count == 0 && view.overlap_count == 1 && view.overlaps[0].t == 0 && view.overlaps[1].t == 1);
    gusset_places_destroy(places);
    EXPECT(GUSSET_OK, gusset_curve_tangent_angle_create(context, empty, up, 1, &places));
    gusset_places_destroy(places);
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_curve_tangent_angle_create(context, curve, zero, 1, &places));
    CHECK(places == NULL);
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_curve_tangent_angle_create(context, curve, up, -1, &places));
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_curve_tangent_angle_create(context, curve, up, NAN, &places));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_curve_tangent_angle_create(context, NULL, up, 1, &places));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_curve_tangent_angle_create(context, curve, NULL, 1, &places));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_curve_tangent_angle_create(context, curve, up, 1, NULL));
    gusset_surface_destroy(surface);
    gusset_curve_destroy(curve);
    gusset_curve_destroy(empty);
}

static void normals(gusset_sheet *sheet) {
    gusset_surface_place places[2];
    double out[6];

    memset(places, 0, sizeof places);
    places[1].row = 4, places[1].column = 7, places[1].u = 1.0, places[1].v = 0.25;
    EXPECT(GUSSET_OK, gusset_sheet_normals_by_sections(context, sheet, places, 2, out));
    CHECK(fabs(out[2] - 1.0) < 1e-12 && fabs(out[5] - 1.0) < 1e-12 && fabs(out[3]) < 1e-12);
    EXPECT(GUSSET_OK, gusset_sheet_normals_by_sections(context, sheet, NULL, 0, NULL));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_sheet_normals_by_sections(context, NULL, places, 2, out));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_sheet_normals_by_sections(context, sheet, NULL, 2, out));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_sheet_normals_by_sections(context, sheet, places, 2, NULL));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT,
           gusset_sheet_normals_by_sections(context, sheet, places, 2, (double *)misaligned()));
    places[1].u = NAN;
    EXPECT(GUSSET_ERROR_NO_SUCH_ELEMENT, gusset_sheet_normals_by_sections(context, sheet, places, 2, out));
    CHECK(out[2] == 0 && out[5] == 0);
    places[1].u = 0.0, places[1].row = 5;
    EXPECT(GUSSET_ERROR_NO_SUCH_ELEMENT, gusset_sheet_normals_by_sections(context, sheet, places, 2, out));
    places[1].row = 4, places[0].reserved = 1, out[0] = out[5] = 7;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_sheet_normals_by_sections(context, sheet, places, 2, out));
    CHECK(out[0] == 0 && out[5] == 0);
    places[0].reserved = 0, out[0] = out[5] = 7;
    gusset_context_cancel(context);
    EXPECT(GUSSET_ERROR_CANCELLED, gusset_sheet_normals_by_sections(context, sheet, places, 2, out));
    gusset_context_reset(context);
    CHECK(out[0] == 0 && out[5] == 0);
}

int main(void) {
    const gusset_mesh_view up = pyramid(pyramid_up), down = pyramid(pyramid_down);
    gusset_sheet *sheet;
    if (gusset_context_create(&context) != GUSSET_OK || up.face_count != down.face_count) {
        return 1;
    }
    sheet = plane();
    diameters(sheet);
    regions(sheet);
    masks(sheet);
    figures(sheet);
    normals(sheet);
    gusset_sheet_destroy(sheet);
    gusset_context_destroy(context);
    return failures != 0;
}

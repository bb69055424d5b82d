/* Sections, contours and isophotes of surfaces: rightly, and with wrong arguments. */
#include "check.h"
#include <math.h>
#include <stdlib.h>

#define ROWS 17
#define COLUMNS 25

static gusset_context *context;
static double nodes[ROWS][COLUMNS][3], heights[ROWS][COLUMNS];

/* Cones of normals from the start, or not: also as the options were when they had none. */
static void cones(const gusset_sheet *sheet) {
    gusset_surface_options options;
    gusset_surface_report facts;
    gusset_surface *made = NULL;
    memset(&options, 0, sizeof options), memset(&facts, 0, sizeof facts);
    options.struct_size = sizeof options, facts.struct_size = sizeof facts;
    options.cones = 2;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_surface_create(context, &sheet, 1, &options, &made));
    options.cones = 1, options.reserved = 1;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_surface_create(context, &sheet, 1, &options, &made));
    CHECK(made == NULL);
    options.reserved = 0;
    EXPECT(GUSSET_OK, gusset_surface_create(context, &sheet, 1, &options, &made));
    EXPECT(GUSSET_OK, gusset_surface_get_report(made, &facts));
    CHECK(facts.cone_bytes > 0);
    gusset_surface_destroy(made);
    options.struct_size = 16;
    EXPECT(GUSSET_OK, gusset_surface_create(context, &sheet, 1, &options, &made));
    EXPECT(GUSSET_OK, gusset_surface_get_report(made, &facts));
    CHECK(facts.cone_bytes == 0);
    gusset_surface_destroy(made);
}

/* A torus of radii 1 and 0.4; the last lines repeat the first to the bit. */
static gusset_surface *torus(void) {
    const double tau = 6.283185307179586;
    gusset_nodes given;
    gusset_sheet *sheet = NULL;
    gusset_surface *made = NULL;
    int i, j;
    for (i = 0; i < ROWS; ++i) {
        for (j = 0; j < COLUMNS; ++j) {
            const double u = tau * (i % (ROWS - 1)) / (ROWS - 1), v = tau * (j % (COLUMNS - 1)) / (COLUMNS - 1);
            nodes[i][j][0] = (1 + 0.4 * cos(u)) * cos(v);
            nodes[i][j][1] = (1 + 0.4 * cos(u)) * sin(v);
            nodes[i][j][2] = heights[i][j] = 0.4 * sin(u);
        }
    }
    memset(&given, 0, sizeof given);
    given.struct_size = sizeof given;
    given.nodes = nodes;
    given.rows = ROWS;
    given.columns = COLUMNS;
    given.scalar = GUSSET_F64;
    given.closed_u = given.closed_v = 1;
    EXPECT(GUSSET_OK, gusset_sheet_create(context, &given, NULL, 0, &sheet));
    cones(sheet);
    EXPECT(GUSSET_OK, gusset_surface_create(context, (const gusset_sheet *const *)&sheet, 1, NULL, &made));
    gusset_sheet_destroy(sheet);
    return made;
}

/* How many curves there are, all of them closed; destroys them. */
static size_t closed_curves(gusset_surface_paths *paths) {
    gusset_surface_paths_view parts;
    size_t k, closed = 0;
    memset(&parts, 0, sizeof parts);
    parts.struct_size = sizeof parts;
    EXPECT(GUSSET_OK, gusset_surface_paths_get_view(paths, &parts));
    CHECK(parts.unresolved_count == 0 && parts.others == NULL && parts.ends.count == parts.path_count + 1);
    for (k = 0; k < parts.path_count; ++k) {
        closed += parts.closed[k];
    }
    CHECK(closed == parts.path_count);
    gusset_surface_paths_destroy(paths);
    return closed;
}

static gusset_contour_function function_of(gusset_contour_kind kind, double x, double y, double z) {
    gusset_contour_function function;
    memset(&function, 0, sizeof function);
    function.struct_size = sizeof function;
    function.kind = kind;
    function.direction[0] = x, function.direction[1] = y, function.direction[2] = z;
    return function;
}

/* The contours must fail with this status. */
static void refused(gusset_status expected, const gusset_surface *surface, const gusset_contour_function *function,
                    const double *levels, size_t count, const gusset_contour_options *options) {
    gusset_surface_paths *paths = (gusset_surface_paths *)misaligned();
    EXPECT(expected, gusset_surface_contours_create(context, surface, function, levels, count, options, &paths));
    CHECK(paths == NULL);
}

static void sections(const gusset_surface *surface) {
    const double bad[3] = {NAN, 0, 0}, levels[3] = {-0.3, 0.05, 0.1}, falling[2] = {1, 0};
    gusset_contour_function function = function_of(GUSSET_CONTOUR_HEIGHT, 0, 0, 2);
    gusset_contour_options options;
    gusset_surface_paths *paths = NULL;

    function.point[0] = 0.01, function.point[1] = 0.02;
    memset(&options, 0, sizeof options);
    options.struct_size = sizeof options;
    EXPECT(GUSSET_OK, gusset_surface_contours_create(context, surface, &function, levels, 3, NULL, &paths));
    CHECK(closed_curves(paths) == 6);
    EXPECT(GUSSET_OK, gusset_surface_contours_create(NULL, surface, &function, levels, 3, &options, &paths));
    CHECK(closed_curves(paths) == 6);
    EXPECT(GUSSET_OK, gusset_surface_contours_create(context, surface, &function, NULL, 0, NULL, &paths));
    CHECK(closed_curves(paths) == 0);
    options.spacing = GUSSET_POINT_SPACING_CHORD;
    refused(GUSSET_ERROR_OUT_OF_RANGE, surface, &function, levels, 3, &options);
    options.chord = NAN;
    refused(GUSSET_ERROR_OUT_OF_RANGE, surface, &function, levels, 3, &options);
    options.chord = 1e-5;
    EXPECT(GUSSET_OK, gusset_surface_contours_create(context, surface, &function, levels, 3, &options, &paths));
    CHECK(closed_curves(paths) == 6);
    options.spacing = GUSSET_POINT_SPACING_LEUS;
    options.points = 1001;
    refused(GUSSET_ERROR_OUT_OF_RANGE, surface, &function, levels, 3, &options);
    options.points = 3;
    EXPECT(GUSSET_OK, gusset_surface_contours_create(context, surface, &function, levels, 3, &options, &paths));
    CHECK(closed_curves(paths) == 6);
    options.spacing = GUSSET_POINT_SPACING_CELL_EDGES;
    EXPECT(GUSSET_OK, gusset_surface_contours_create(context, surface, &function, levels, 3, &options, &paths));
    CHECK(closed_curves(paths) == 6);
    options.spacing = 4;
    refused(GUSSET_ERROR_UNKNOWN_VALUE, surface, &function, levels, 3, &options);
    options.spacing = 0, options.struct_size = 8;
    refused(GUSSET_ERROR_BAD_STRUCT_SIZE, surface, &function, levels, 3, &options);
    refused(GUSSET_ERROR_MISALIGNED_ARGUMENT, surface, &function, levels, 3, misaligned());
    refused(GUSSET_ERROR_NULL_ARGUMENT, NULL, &function, levels, 3, NULL);
    refused(GUSSET_ERROR_NULL_ARGUMENT, surface, NULL, levels, 3, NULL);
    refused(GUSSET_ERROR_MISALIGNED_ARGUMENT, surface, misaligned(), levels, 3, NULL);
    refused(GUSSET_ERROR_NULL_ARGUMENT, surface, &function, NULL, 3, NULL);
    refused(GUSSET_ERROR_SIZE_OVERFLOW, surface, &function, levels, (size_t)-1 / 2, NULL);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_surface_contours_create(context, surface, &function, levels, 3, NULL, NULL));
    refused(GUSSET_ERROR_OUT_OF_RANGE, surface, &function, falling, 2, NULL);
    CHECK(strncmp(gusset_context_get_message(context), "levels is ", 10) == 0);
    refused(GUSSET_ERROR_OUT_OF_RANGE, surface, &function, bad, 1, NULL);
    function.unsigned_normals = 2;
    refused(GUSSET_ERROR_UNKNOWN_VALUE, surface, &function, levels, 3, NULL);
    function.unsigned_normals = 0, function.kind = 3;
    refused(GUSSET_ERROR_UNKNOWN_VALUE, surface, &function, levels, 3, NULL);
    function.kind = GUSSET_CONTOUR_HEIGHT, function.struct_size = 8;
    refused(GUSSET_ERROR_BAD_STRUCT_SIZE, surface, &function, levels, 3, NULL);
    function.struct_size = sizeof function, function.point[0] = NAN;
    refused(GUSSET_ERROR_OUT_OF_RANGE, surface, &function, levels, 3, NULL);
    function.point[0] = 0, function.direction[0] = NAN;
    refused(GUSSET_ERROR_OUT_OF_RANGE, surface, &function, levels, 3, NULL);
    function.direction[0] = 0, function.direction[2] = 0;
    refused(GUSSET_ERROR_OUT_OF_RANGE, surface, &function, levels, 3, NULL);
}

static void contours(const gusset_surface *surface) {
    const double levels[2] = {0.1, 0.2}, same[2] = {0.1, 0.1};
    gusset_contour_function function = function_of(GUSSET_CONTOUR_VALUES, 0, 0, 0);
    double *bad = malloc(sizeof heights);
    gusset_surface_paths *paths = NULL;

    function.values = &heights[0][0], function.value_count = ROWS * COLUMNS;
    EXPECT(GUSSET_OK, gusset_surface_contours_create(context, surface, &function, levels, 2, NULL, &paths));
    CHECK(closed_curves(paths) == 4);
    function.value_count = ROWS * COLUMNS - 1;
    refused(GUSSET_ERROR_COUNT_DIFFERS, surface, &function, levels, 2, NULL);
    function.value_count = ROWS * COLUMNS;
    refused(GUSSET_ERROR_OUT_OF_RANGE, surface, &function, same, 2, NULL);
    refused(GUSSET_ERROR_NULL_ARGUMENT, surface, &function, NULL, 2, NULL);
    refused(GUSSET_ERROR_NULL_ARGUMENT, NULL, &function, levels, 2, NULL);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_surface_contours_create(context, surface, &function, levels, 2, NULL, NULL));
    function.values = NULL;
    refused(GUSSET_ERROR_NULL_ARGUMENT, surface, &function, levels, 2, NULL);
    if (bad != NULL) {
        memcpy(bad, heights, sizeof heights);
        bad[30] = INFINITY;
        function.values = bad;
        refused(GUSSET_ERROR_NOT_FINITE, surface, &function, levels, 2, NULL);
        free(bad);
    }
}

static void angles(const gusset_surface *surface) {
    const double right = 1.5707963267948966, along[3] = {0.2, 0.3, 5}, zero[3] = {0, 0, 0};
    const double given[2] = {0.7, right}, wide[1] = {3.2}, obtuse[1] = {2.0};
    gusset_contour_function function = function_of(GUSSET_CONTOUR_ANGLE, 0.2, 0.3, 5), flat = function_of(GUSSET_CONTOUR_ANGLE, 0, 0, 0);
    gusset_surface_paths *paths = NULL;
    gusset_nearest_angle_report nearest;

    memset(&nearest, 0, sizeof nearest);
    nearest.struct_size = sizeof nearest;
    EXPECT(GUSSET_OK, gusset_surface_contours_create(context, surface, &function, given, 2, NULL, &paths));
    CHECK(closed_curves(paths) == 4);
    refused(GUSSET_ERROR_OUT_OF_RANGE, surface, &function, wide, 1, NULL);
    refused(GUSSET_ERROR_NULL_ARGUMENT, surface, &function, NULL, 2, NULL);
    refused(GUSSET_ERROR_NULL_ARGUMENT, NULL, &function, given, 2, NULL);
    refused(GUSSET_ERROR_OUT_OF_RANGE, surface, &flat, given, 2, NULL);
    function.unsigned_normals = 1;
    EXPECT(GUSSET_OK, gusset_surface_contours_create(context, surface, &function, given, 2, NULL, &paths));
    CHECK(closed_curves(paths) == 6);
    refused(GUSSET_ERROR_OUT_OF_RANGE, surface, &function, obtuse, 1, NULL);

    EXPECT(GUSSET_OK, gusset_surface_nearest_angle(context, surface, along, 0.7, 0, &nearest));
    CHECK(nearest.deviation < 1e-8 && nearest.bound <= nearest.deviation && fabs(nearest.angle - 0.7) < 1e-8);
    CHECK(fabs(nearest.normal[0] * nearest.normal[0] + nearest.normal[1] * nearest.normal[1] +
               nearest.normal[2] * nearest.normal[2] - 1) < 1e-12);
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_surface_nearest_angle(context, surface, along, NAN, 0, &nearest));
    CHECK(nearest.deviation == 0 && nearest.struct_size == sizeof nearest);
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_surface_nearest_angle(context, surface, along, 2, 1, &nearest));
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_surface_nearest_angle(context, surface, along, 1, 2, &nearest));
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_surface_nearest_angle(context, surface, zero, 1, 0, &nearest));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_surface_nearest_angle(context, NULL, along, 1, 0, &nearest));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_surface_nearest_angle(context, surface, NULL, 1, 0, &nearest));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_surface_nearest_angle(context, surface, along, 1, 0, NULL));
    nearest.struct_size = 16;
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_surface_nearest_angle(context, surface, along, 1, 0, &nearest));
}

int main(void) {
    const gusset_mesh_view up = pyramid(pyramid_up), down = pyramid(pyramid_down);
    gusset_surface *surface;
    if (gusset_context_create(&context) != GUSSET_OK || up.face_count != down.face_count) {
        return 1;
    }
    surface = torus();
    sections(surface);
    contours(surface);
    angles(surface);
    gusset_surface_destroy(surface);
    gusset_context_destroy(context);
    return failures != 0;
}

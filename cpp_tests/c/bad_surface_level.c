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
    EXPECT(GUSSET_OK, gusset_sheet_from_nodes_create(context, &given, &sheet));
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

static void sections(const gusset_surface *surface) {
    const double origin[3] = {0.01, 0.02, 0}, up[3] = {0, 0, 2}, zero[3] = {0, 0, 0}, bad[3] = {NAN, 0, 0};
    const double offsets[3] = {-0.3, 0.05, 0.1}, falling[2] = {1, 0};
    gusset_contour_options options;
    gusset_surface_paths *paths = NULL;

    memset(&options, 0, sizeof options);
    options.struct_size = sizeof options;
    EXPECT(GUSSET_OK, gusset_surface_section_create(context, surface, origin, up, offsets, 3, NULL, &paths));
    CHECK(closed_curves(paths) == 6);
    EXPECT(GUSSET_OK, gusset_surface_section_create(NULL, surface, origin, up, offsets, 3, &options, &paths));
    CHECK(closed_curves(paths) == 6);
    EXPECT(GUSSET_OK, gusset_surface_section_create(context, surface, origin, up, NULL, 0, NULL, &paths));
    CHECK(closed_curves(paths) == 0);
    options.spacing = GUSSET_POINT_SPACING_CHORD;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE,
           gusset_surface_section_create(context, surface, origin, up, offsets, 3, &options, &paths));
    CHECK(paths == NULL);
    options.chord = NAN;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE,
           gusset_surface_section_create(context, surface, origin, up, offsets, 3, &options, &paths));
    options.chord = 1e-5;
    EXPECT(GUSSET_OK, gusset_surface_section_create(context, surface, origin, up, offsets, 3, &options, &paths));
    CHECK(closed_curves(paths) == 6);
    options.spacing = GUSSET_POINT_SPACING_LEUS;
    options.points = 1001;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE,
           gusset_surface_section_create(context, surface, origin, up, offsets, 3, &options, &paths));
    options.points = 3;
    EXPECT(GUSSET_OK, gusset_surface_section_create(context, surface, origin, up, offsets, 3, &options, &paths));
    CHECK(closed_curves(paths) == 6);
    options.spacing = GUSSET_POINT_SPACING_CELL_EDGES;
    EXPECT(GUSSET_OK, gusset_surface_section_create(context, surface, origin, up, offsets, 3, &options, &paths));
    CHECK(closed_curves(paths) == 6);
    options.spacing = 4;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE,
           gusset_surface_section_create(context, surface, origin, up, offsets, 3, &options, &paths));
    options.spacing = 0, options.unsigned_normals = 2;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE,
           gusset_surface_section_create(context, surface, origin, up, offsets, 3, &options, &paths));
    options.unsigned_normals = 0, options.reserved = 1;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE,
           gusset_surface_section_create(context, surface, origin, up, offsets, 3, &options, &paths));
    options.reserved = 0, options.struct_size = 8;
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE,
           gusset_surface_section_create(context, surface, origin, up, offsets, 3, &options, &paths));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT,
           gusset_surface_section_create(context, surface, origin, up, offsets, 3, misaligned(), &paths));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_surface_section_create(context, NULL, origin, up, offsets, 3, NULL, &paths));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_surface_section_create(context, surface, NULL, up, offsets, 3, NULL, &paths));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT,
           gusset_surface_section_create(context, surface, origin, NULL, offsets, 3, NULL, &paths));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_surface_section_create(context, surface, origin, up, NULL, 3, NULL, &paths));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_surface_section_create(context, surface, origin, up, offsets, 3, NULL, NULL));
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_surface_section_create(context, surface, origin, zero, offsets, 3, NULL, &paths));
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_surface_section_create(context, surface, bad, up, offsets, 3, NULL, &paths));
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_surface_section_create(context, surface, origin, bad, offsets, 3, NULL, &paths));
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_surface_section_create(context, surface, origin, up, falling, 2, NULL, &paths));
    CHECK(strncmp(gusset_context_get_message(context), "option offsets ", 15) == 0);
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_surface_section_create(context, surface, origin, up, bad, 1, NULL, &paths));
    EXPECT(GUSSET_ERROR_SIZE_OVERFLOW,
           gusset_surface_section_create(context, surface, origin, up, offsets, (size_t)-1 / 2, NULL, &paths));
    CHECK(paths == NULL);
}

static void contours(const gusset_surface *surface) {
    const double levels[2] = {0.1, 0.2}, same[2] = {0.1, 0.1};
    const size_t count = ROWS * COLUMNS;
    double *bad = malloc(sizeof heights);
    gusset_surface_paths *paths = NULL;

    EXPECT(GUSSET_OK, gusset_surface_contours_create(context, surface, &heights[0][0], count, levels, 2, NULL, &paths));
    CHECK(closed_curves(paths) == 4);
    EXPECT(GUSSET_ERROR_SIZE_OVERFLOW,
           gusset_surface_contours_create(context, surface, &heights[0][0], count - 1, levels, 2, NULL, &paths));
    CHECK(paths == NULL);
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE,
           gusset_surface_contours_create(context, surface, &heights[0][0], count, same, 2, NULL, &paths));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_surface_contours_create(context, surface, NULL, count, levels, 2, NULL, &paths));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT,
           gusset_surface_contours_create(context, surface, &heights[0][0], count, NULL, 2, NULL, &paths));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT,
           gusset_surface_contours_create(context, NULL, &heights[0][0], count, levels, 2, NULL, &paths));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT,
           gusset_surface_contours_create(context, surface, &heights[0][0], count, levels, 2, NULL, NULL));
    if (bad != NULL) {
        memcpy(bad, heights, sizeof heights);
        bad[30] = INFINITY;
        EXPECT(GUSSET_ERROR_NOT_FINITE, gusset_surface_contours_create(context, surface, bad, count, levels, 2, NULL, &paths));
        free(bad);
    }
}

static void angles(const gusset_surface *surface) {
    const double right = 1.5707963267948966, along[3] = {0.2, 0.3, 5}, zero[3] = {0, 0, 0};
    const double given[2] = {0.7, right}, wide[1] = {3.2}, obtuse[1] = {2.0};
    gusset_contour_options options;
    gusset_surface_paths *paths = NULL;
    gusset_nearest_angle_report nearest;

    memset(&options, 0, sizeof options);
    options.struct_size = sizeof options;
    memset(&nearest, 0, sizeof nearest);
    nearest.struct_size = sizeof nearest;
    EXPECT(GUSSET_OK, gusset_surface_isophotes_create(context, surface, along, given, 2, NULL, &paths));
    CHECK(closed_curves(paths) == 4);
    options.unsigned_normals = 1;
    EXPECT(GUSSET_OK, gusset_surface_isophotes_create(context, surface, along, given, 2, &options, &paths));
    CHECK(closed_curves(paths) == 6);
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_surface_isophotes_create(context, surface, along, obtuse, 1, &options, &paths));
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_surface_isophotes_create(context, surface, along, wide, 1, NULL, &paths));
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_surface_isophotes_create(context, surface, zero, given, 2, NULL, &paths));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_surface_isophotes_create(context, surface, NULL, given, 2, NULL, &paths));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_surface_isophotes_create(context, surface, along, NULL, 2, NULL, &paths));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_surface_isophotes_create(context, NULL, along, given, 2, NULL, &paths));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_surface_isophotes_create(context, surface, along, given, 2, NULL, NULL));
    CHECK(paths == NULL);

    EXPECT(GUSSET_OK, gusset_surface_nearest_angle(context, surface, along, 0.7, NULL, &nearest));
    CHECK(nearest.deviation < 1e-8 && nearest.bound <= nearest.deviation && fabs(nearest.angle - 0.7) < 1e-8);
    CHECK(fabs(nearest.normal[0] * nearest.normal[0] + nearest.normal[1] * nearest.normal[1] +
               nearest.normal[2] * nearest.normal[2] - 1) < 1e-12);
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_surface_nearest_angle(context, surface, along, NAN, NULL, &nearest));
    CHECK(nearest.deviation == 0 && nearest.struct_size == sizeof nearest);
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_surface_nearest_angle(context, surface, along, 2, &options, &nearest));
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_surface_nearest_angle(context, surface, zero, 1, NULL, &nearest));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_surface_nearest_angle(context, NULL, along, 1, NULL, &nearest));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_surface_nearest_angle(context, surface, NULL, 1, NULL, &nearest));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_surface_nearest_angle(context, surface, along, 1, NULL, NULL));
    nearest.struct_size = 16;
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_surface_nearest_angle(context, surface, along, 1, NULL, &nearest));
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

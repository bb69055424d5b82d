/* Intersects surfaces with invalid and valid arguments, and checks errors and results. */
#include "check.h"
#include <math.h>

static gusset_context *context;

/* A flat sheet of 4 x 4 nodes over -1..1, tilted so that z = slope * x. */
static gusset_surface *flat(double slope) {
    double nodes[48];
    gusset_nodes given = {sizeof given, nodes, 4, 4, 0, 0, GUSSET_F64, GUSSET_SCHEME_SIX_TAP, 0, 0};
    gusset_sheet *sheet = NULL;
    const gusset_sheet *sheets[1];
    gusset_surface *made = NULL;
    int k;

    for (k = 0; k < 16; ++k) {
        nodes[3 * k] = (k / 4) / 1.5 - 1.0;
        nodes[3 * k + 1] = (k % 4) / 1.5 - 1.0;
        nodes[3 * k + 2] = slope * nodes[3 * k];
    }
    EXPECT(GUSSET_OK, gusset_sheet_create(context, &given, NULL, 0, &sheet));
    sheets[0] = sheet;
    EXPECT(GUSSET_OK, gusset_surface_create(context, sheets, 1, NULL, &made));
    gusset_sheet_destroy(sheet);
    return made;
}

static void curves(void) {
    gusset_surface *a = flat(0.0), *b = flat(1.0);
    gusset_surface_paths *paths = (gusset_surface_paths *)misaligned();
    gusset_surface_paths_view parts;
    gusset_intersection_options options = {sizeof options, 0.0, 0.0, GUSSET_POINT_SPACING_CHORD, 0};
    size_t k;

    memset(&parts, 0, sizeof parts);
    parts.struct_size = sizeof parts;
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_surface_intersection_create(context, NULL, b, NULL, &paths));
    CHECK(paths == NULL);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_surface_intersection_create(context, a, b, NULL, NULL));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT,
           gusset_surface_intersection_create(context, a, b, NULL, (gusset_surface_paths **)misaligned()));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT,
           gusset_surface_intersection_create(context, a, b, (const gusset_intersection_options *)misaligned(), &paths));
    options.chord = -1.0;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_surface_intersection_create(context, a, b, &options, &paths));
    options.chord = NAN;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_surface_intersection_create(context, a, b, &options, &paths));
    options.chord = INFINITY;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_surface_intersection_create(context, a, b, &options, &paths));
    options.chord = 0.0;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_surface_intersection_create(context, a, b, &options, &paths));
    options.spacing = GUSSET_POINT_SPACING_LEUS;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_surface_intersection_create(context, a, b, &options, &paths));
    options.spacing = 4;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_surface_intersection_create(context, a, b, &options, &paths));
    options.spacing = GUSSET_POINT_SPACING_CELL_EDGES, options.reserved = 1;
    EXPECT(GUSSET_ERROR_UNKNOWN_VALUE, gusset_surface_intersection_create(context, a, b, &options, &paths));
    options.reserved = 0, options.tolerance = INFINITY;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_surface_intersection_create(context, a, b, &options, &paths));
    options.tolerance = NAN;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_surface_intersection_create(context, a, b, &options, &paths));
    options.tolerance = 0.0, options.struct_size = 8;
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_surface_intersection_create(context, a, b, &options, &paths));
    CHECK(paths == NULL);
    options.struct_size = sizeof options;
    /* The line x = 0, z = 0, along N_A x N_B. */
    EXPECT(GUSSET_OK, gusset_surface_intersection_create(context, a, b, &options, &paths));
    EXPECT(GUSSET_OK, gusset_surface_paths_get_view(paths, &parts));
    CHECK(parts.path_count == 1 && parts.closed[0] == 0 && parts.unresolved_count == 0 && parts.others != NULL && parts.contact_count == 0);
    CHECK(parts.point_count >= 2 && fabs(fabs(parts.points[1]) - 1.0) < 1e-12);
    for (k = 0; k < parts.point_count; ++k) {
        CHECK(fabs(parts.points[3 * k]) < 1e-12 && fabs(parts.points[3 * k + 2]) < 1e-12 && parts.normals[3 * k + 2] == 1.0);
        CHECK(parts.places[k].sheet == 0 && parts.places[k].row == 1 && parts.others[k].row == 1);
    }
    gusset_surface_paths_destroy(paths);
    /* With itself: everything touches. */
    EXPECT(GUSSET_OK, gusset_surface_intersection_create(context, a, a, NULL, &paths));
    EXPECT(GUSSET_OK, gusset_surface_paths_get_view(paths, &parts));
    CHECK(parts.path_count == 0 && parts.unresolved_count >= 9);
    gusset_surface_paths_destroy(paths);
    gusset_context_cancel(context);
    EXPECT(GUSSET_ERROR_CANCELLED, gusset_surface_intersection_create(context, a, b, NULL, &paths));
    CHECK(paths == NULL);
    gusset_context_reset(context);
    gusset_surface_destroy(a);
    gusset_surface_destroy(b);
}

/* A cubic loop with y from -1 to 1: x = (2 t - 1) (1 - 10 t (1 - t)), z = 9 t (1 - t). */
static gusset_surface *loop(void) {
    static const double profile[4][2] = {{-1.0, 0.0}, {3.0, 3.0}, {-3.0, 3.0}, {1.0, 0.0}};
    double points[24];
    gusset_sheet *sheet = NULL;
    const gusset_sheet *sheets[1];
    gusset_surface *surface = NULL;
    size_t k;

    for (k = 0; k < 8; ++k) {
        points[3 * k] = profile[k / 2][0], points[3 * k + 1] = k % 2 ? 1.0 : -1.0, points[3 * k + 2] = profile[k / 2][1];
    }
    EXPECT(GUSSET_OK, gusset_sheet_from_patches_create(NULL, points, 3, 1, 1, 1, &sheet));
    sheets[0] = sheet;
    EXPECT(GUSSET_OK, gusset_surface_create(NULL, sheets, 1, NULL, &surface));
    gusset_sheet_destroy(sheet);
    return surface;
}

static void with_itself(void) {
    gusset_surface *a = flat(0.0), *b = loop();
    gusset_surface_paths *paths = (gusset_surface_paths *)misaligned();
    gusset_surface_paths_view parts;
    gusset_intersection_options options = {sizeof options, 0.0, 0.0, GUSSET_POINT_SPACING_CHORD, 0};

    memset(&parts, 0, sizeof parts);
    parts.struct_size = sizeof parts;
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_surface_intersection_create(context, NULL, NULL, NULL, &paths));
    CHECK(paths == NULL);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_surface_intersection_create(context, a, NULL, NULL, NULL));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT,
           gusset_surface_intersection_create(context, a, NULL, NULL, (gusset_surface_paths **)misaligned()));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT,
           gusset_surface_intersection_create(context, a, NULL, (const gusset_intersection_options *)misaligned(), &paths));
    options.chord = -1.0;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_surface_intersection_create(context, a, NULL, &options, &paths));
    options.spacing = GUSSET_POINT_SPACING_AUTO, options.tolerance = NAN;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_surface_intersection_create(context, a, NULL, &options, &paths));
    options.tolerance = INFINITY;
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_surface_intersection_create(context, a, NULL, &options, &paths));
    options.tolerance = 0.0, options.struct_size = 8;
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_surface_intersection_create(context, a, NULL, &options, &paths));
    CHECK(paths == NULL);
    options.struct_size = sizeof options;
    EXPECT(GUSSET_OK, gusset_surface_intersection_create(context, a, NULL, &options, &paths));
    EXPECT(GUSSET_OK, gusset_surface_paths_get_view(paths, &parts));
    CHECK(parts.path_count == 0 && parts.unresolved_count == 0);
    gusset_surface_paths_destroy(paths);
    EXPECT(GUSSET_OK, gusset_surface_intersection_create(context, b, NULL, NULL, &paths));
    EXPECT(GUSSET_OK, gusset_surface_paths_get_view(paths, &parts));
    CHECK(parts.path_count == 1 && parts.closed[0] == 0 && parts.unresolved_count == 0 && parts.others != NULL);
    CHECK(parts.point_count >= 2 && fabs(fabs(parts.points[1]) - 1.0) < 1e-12);
    CHECK(fabs(parts.points[0]) < 1e-12 && fabs(parts.points[2] - 0.9) < 1e-12);
    gusset_surface_paths_destroy(paths);
    gusset_context_cancel(context);
    EXPECT(GUSSET_ERROR_CANCELLED, gusset_surface_intersection_create(context, b, NULL, NULL, &paths));
    CHECK(paths == NULL);
    gusset_context_reset(context);
    gusset_surface_destroy(a);
    gusset_surface_destroy(b);
}

static void candidates(void) {
    gusset_surface *a = flat(0.0), *b = flat(1.0);
    gusset_surface_cells *pairs = (gusset_surface_cells *)misaligned();
    gusset_surface_cells_view parts;
    size_t k, met;

    memset(&parts, 0, sizeof parts);
    parts.struct_size = sizeof parts;
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_surface_cell_pairs_create(context, NULL, b, 0.0, &pairs));
    CHECK(pairs == NULL);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_surface_cell_pairs_create(context, a, NULL, 0.0, &pairs));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_surface_cell_pairs_create(context, a, b, 0.0, NULL));
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_surface_cell_pairs_create(context, a, b, -1.0, &pairs));
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_surface_cell_pairs_create(context, a, b, NAN, &pairs));
    EXPECT(GUSSET_ERROR_OUT_OF_RANGE, gusset_surface_cell_pairs_create(context, a, b, INFINITY, &pairs));
    CHECK(pairs == NULL);
    EXPECT(GUSSET_OK, gusset_surface_cell_pairs_create(context, a, b, 0.0, &pairs));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_surface_cells_get_view(NULL, &parts));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_surface_cells_get_view(pairs, NULL));
    parts.struct_size = 8;
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_surface_cells_get_view(pairs, &parts));
    parts.struct_size = sizeof parts;
    EXPECT(GUSSET_OK, gusset_surface_cells_get_view(pairs, &parts));
    CHECK(parts.whole == NULL && parts.mask == NULL && parts.first == NULL && parts.sheet_count == 0);
    /* The middle rows meet. */
    CHECK(parts.cell_count >= 3);
    for (k = 0, met = 0; k < parts.cell_count; ++k) {
        CHECK(parts.cells[k].row < 3 && parts.others[k].column < 3 && parts.cells[k].sheet == 0);
        met += parts.cells[k].row == 1 && parts.others[k].row == 1 && parts.cells[k].column == parts.others[k].column;
    }
    CHECK(met == 3);
    met = parts.cell_count;
    gusset_surface_cells_destroy(pairs);
    EXPECT(GUSSET_OK, gusset_surface_cell_pairs_create(context, a, b, 10.0, &pairs));
    EXPECT(GUSSET_OK, gusset_surface_cells_get_view(pairs, &parts));
    CHECK(parts.cell_count == 81 && met < 81);
    gusset_surface_cells_destroy(pairs);
    gusset_surface_cells_destroy(NULL);
    gusset_surface_destroy(a);
    gusset_surface_destroy(b);
}

int main(void) {
    const gusset_mesh_view up = pyramid(pyramid_up), down = pyramid(pyramid_down);
    if (gusset_context_create(&context) != GUSSET_OK || up.face_count != down.face_count) {
        return 1;
    }
    curves();
    with_itself();
    candidates();
    gusset_context_destroy(context);
    return failures != 0;
}

/* Calls the functions of mesh sections with invalid arguments, and checks the errors. */
#include "check.h"
#include <float.h>
#include <math.h>
#include <stddef.h>

static gusset_context *context;
static gusset_mesh_sections *sections;

static gusset_status cut(const gusset_mesh_view *mesh, const gusset_cutting_planes *planes,
                         const gusset_mesh_section_options *options) {
    return gusset_mesh_sections_create(context, mesh, planes, options, &sections);
}

static void check_planes(const gusset_mesh_view *mesh) {
    gusset_cutting_planes planes = {.struct_size = sizeof planes, .direction = {0, 0, 1}, .reference = {1, 0, 0}};
    const gusset_cutting_planes stack = planes;
    double values[3] = {1.2, 1.5, 1.5}, points[2][3] = {{0, 0, 1.5}, {0, 0, 1.6}}, normals[2][3] = {{0, 0, 1}, {0, 0, 0}};

    FAILS(GUSSET_ERROR_NULL_ARGUMENT, sections, cut(mesh, NULL, NULL));
    FAILS(GUSSET_ERROR_MISALIGNED_ARGUMENT, sections, cut(mesh, misaligned(), NULL));
    planes.struct_size = 8;
    FAILS(GUSSET_ERROR_BAD_STRUCT_SIZE, sections, cut(mesh, &planes, NULL));
    planes = stack, planes.kind = 4;
    FAILS(GUSSET_ERROR_UNKNOWN_VALUE, sections, cut(mesh, &planes, NULL));

    /* Stacks: numbers that are missing, do not rise or are not finite; directions of no length. */
    planes = stack, planes.value_count = 1;
    FAILS(GUSSET_ERROR_NULL_ARGUMENT, sections, cut(mesh, &planes, NULL));
    planes.values = values, planes.value_count = SIZE_MAX;
    FAILS(GUSSET_ERROR_SIZE_OVERFLOW, sections, cut(mesh, &planes, NULL));
    planes.value_count = 3;
    FAILS(GUSSET_ERROR_OUT_OF_RANGE, sections, cut(mesh, &planes, NULL));
    values[2] = NAN;
    FAILS(GUSSET_ERROR_OUT_OF_RANGE, sections, cut(mesh, &planes, NULL));
    values[2] = INFINITY;
    FAILS(GUSSET_ERROR_OUT_OF_RANGE, sections, cut(mesh, &planes, NULL));
    values[2] = 1.7, planes.point[1] = DBL_MAX;
    FAILS(GUSSET_ERROR_OUT_OF_RANGE, sections, cut(mesh, &planes, NULL));
    planes.point[1] = 0.0, planes.direction[2] = 0.0;
    FAILS(GUSSET_ERROR_OUT_OF_RANGE, sections, cut(mesh, &planes, NULL));
    planes.direction[2] = NAN;
    FAILS(GUSSET_ERROR_OUT_OF_RANGE, sections, cut(mesh, &planes, NULL));

    /* Single planes: arrays that are missing, a normal of no length. */
    planes = stack, planes.kind = GUSSET_CUTTING_PLANES, planes.point_count = 2, planes.points = points[0];
    FAILS(GUSSET_ERROR_NULL_ARGUMENT, sections, cut(mesh, &planes, NULL));
    planes.normals = normals[0];
    FAILS(GUSSET_ERROR_OUT_OF_RANGE, sections, cut(mesh, &planes, NULL));
    planes.point_count = SIZE_MAX / 2;
    FAILS(GUSSET_ERROR_SIZE_OVERFLOW, sections, cut(mesh, &planes, NULL));
    planes.point_count = 1, points[0][0] = NAN;
    FAILS(GUSSET_ERROR_OUT_OF_RANGE, sections, cut(mesh, &planes, NULL));
    points[0][0] = 0.0;

    /* Planes about an axis: a reference along the axis, an angle that is not finite. */
    planes = stack, planes.kind = GUSSET_CUTTING_AXIS, planes.values = values, planes.value_count = 1;
    planes.reference[0] = 0.0, planes.reference[2] = 3.0;
    FAILS(GUSSET_ERROR_OUT_OF_RANGE, sections, cut(mesh, &planes, NULL));
    planes.reference[0] = 1.0, values[0] = -INFINITY;
    FAILS(GUSSET_ERROR_OUT_OF_RANGE, sections, cut(mesh, &planes, NULL));
    values[0] = 0.0;

    /* Planes across a curve: without length, past its end, through points that are not finite. */
    planes = stack, planes.kind = GUSSET_CUTTING_CURVE, planes.values = values, planes.value_count = 1;
    FAILS(GUSSET_ERROR_EMPTY_CURVE, sections, cut(mesh, &planes, NULL));
    planes.points = points[0], planes.point_count = 1;
    FAILS(GUSSET_ERROR_EMPTY_CURVE, sections, cut(mesh, &planes, NULL));
    planes.point_count = 2, values[0] = 5.0;
    FAILS(GUSSET_ERROR_OUT_OF_RANGE, sections, cut(mesh, &planes, NULL));
    values[0] = 0.0, planes.closed = 2;
    FAILS(GUSSET_ERROR_UNKNOWN_VALUE, sections, cut(mesh, &planes, NULL));
    planes.closed = 0, points[1][2] = NAN;
    FAILS(GUSSET_ERROR_NOT_FINITE, sections, cut(mesh, &planes, NULL));
    REPORT(context, GUSSET_ERROR_NOT_FINITE, GUSSET_ELEMENT_POINT, 1, 0);
}

static void check_meshes_and_options(void) {
    gusset_mesh_view mesh = pyramid(pyramid_up);
    const double height = 1.5;
    const gusset_cutting_planes planes = {
        .struct_size = sizeof planes, .direction = {0, 0, 1}, .values = &height, .value_count = 1};
    gusset_mesh_section_options options = {.struct_size = sizeof options};
    double wild[5][3];

    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_mesh_sections_create(context, &mesh, &planes, NULL, NULL));
    FAILS(GUSSET_ERROR_NULL_ARGUMENT, sections, cut(NULL, &planes, NULL));
    FAILS(GUSSET_ERROR_MISALIGNED_ARGUMENT, sections, cut(misaligned(), &planes, NULL));
    FAILS(GUSSET_ERROR_MISALIGNED_ARGUMENT, sections, cut(&mesh, &planes, misaligned()));
    options.struct_size = 4;
    FAILS(GUSSET_ERROR_BAD_STRUCT_SIZE, sections, cut(&mesh, &planes, &options));
    options.struct_size = sizeof options, options.in_plane = 2;
    FAILS(GUSSET_ERROR_UNKNOWN_VALUE, sections, cut(&mesh, &planes, &options));
    options.in_plane = 0, options.reserved = 1;
    FAILS(GUSSET_ERROR_UNKNOWN_VALUE, sections, cut(&mesh, &planes, &options));
    options.reserved = 0, options.tolerance = -1.0;
    FAILS(GUSSET_ERROR_OUT_OF_RANGE, sections, cut(&mesh, &planes, &options));
    options.tolerance = NAN;
    FAILS(GUSSET_ERROR_OUT_OF_RANGE, sections, cut(&mesh, &planes, &options));
    options.tolerance = INFINITY;
    FAILS(GUSSET_ERROR_OUT_OF_RANGE, sections, cut(&mesh, &planes, &options));

    /* A vertex beyond all planes, which a face uses. */
    memcpy(wild, pyramid_up, sizeof wild);
    wild[3][1] = 1e200;
    mesh.positions = wild;
    FAILS(GUSSET_ERROR_OUT_OF_RANGE, sections, cut(&mesh, &planes, NULL));
    REPORT(context, GUSSET_ERROR_OUT_OF_RANGE, GUSSET_ELEMENT_VERTEX, 3, 0);
    wild[3][1] = NAN;
    FAILS(GUSSET_ERROR_NOT_FINITE, sections, cut(&mesh, &planes, NULL));
    REPORT(context, GUSSET_ERROR_NOT_FINITE, GUSSET_ELEMENT_VERTEX, 3, 0);
}

int main(void) {
    const gusset_mesh_view mesh = pyramid(pyramid_up);
    const double heights[2] = {1.25, 1.5};
    const gusset_cutting_planes planes = {
        .struct_size = sizeof planes, .direction = {0, 0, 1}, .values = heights, .value_count = 2};
    gusset_mesh_sections_view view = {.struct_size = sizeof view};
    gusset_origins *origins = NULL;

    if (gusset_context_create(&context) != GUSSET_OK) {
        return 1;
    }
    check_planes(&mesh);
    check_meshes_and_options();
    fit_for_more(context);

    EXPECT(GUSSET_OK, cut(&mesh, &planes, NULL));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_mesh_sections_get_view(NULL, &view));
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_mesh_sections_get_view(sections, NULL));
    EXPECT(GUSSET_ERROR_MISALIGNED_ARGUMENT, gusset_mesh_sections_get_view(sections, misaligned()));
    view.struct_size = 8;
    EXPECT(GUSSET_ERROR_BAD_STRUCT_SIZE, gusset_mesh_sections_get_view(sections, &view));
    view.struct_size = sizeof view;
    EXPECT(GUSSET_OK, gusset_mesh_sections_get_view(sections, &view));
    CHECK(view.path_count == 2 && view.point_count == 8 && view.paths[1].closed == 1);
    EXPECT(GUSSET_ERROR_NULL_ARGUMENT, gusset_mesh_sections_origins_create(context, sections, NULL));
    FAILS(GUSSET_ERROR_NULL_ARGUMENT, origins, gusset_mesh_sections_origins_create(context, NULL, &origins));
    EXPECT(GUSSET_OK, gusset_mesh_sections_origins_create(context, sections, &origins));
    /* A handle of another kind is refused. */
    EXPECT(GUSSET_ERROR_WRONG_HANDLE, gusset_mesh_sections_get_view((const void *)origins, &view));
    gusset_origins_destroy(origins);
    gusset_mesh_sections_destroy(sections);
    gusset_mesh_sections_destroy(NULL);

    /* No planes, no paths. */
    EXPECT(GUSSET_OK, cut(&mesh, &(gusset_cutting_planes){.struct_size = sizeof planes, .direction = {0, 0, 1}}, NULL));
    EXPECT(GUSSET_OK, gusset_mesh_sections_get_view(sections, &view));
    CHECK(view.plane_count == 0 && view.path_count == 0 && view.point_count == 0 && view.starts.count == 1);
    gusset_mesh_sections_destroy(sections);
    gusset_context_destroy(context);
    return failures != 0;
}

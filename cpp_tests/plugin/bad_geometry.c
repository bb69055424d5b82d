/* Meshes and curves that break the rules, given to every filter that takes them: bad_geometry LIBRARY */
#include "loaded.h"

#include <math.h>
#include <string.h>

static const gusset_plugin *plugin;

/* One of a filter's inputs is wrong; the others are good. The expected element and index of the report; element 0:
   none. */
static void expect(const gusset_filter *filter, const gusset_input *inputs, uint32_t count, uint32_t which,
                   int32_t status, uint32_t element, uint64_t index, int line) {
    gusset_outputs *outputs = NULL;
    gusset_failure failure = {0};
    const int32_t got = filter->run(filter, NULL, inputs, count, NULL, 0, &outputs);
    failure.struct_size = sizeof failure;
    CHECK_OF(filter->id, outputs != NULL && plugin->output_failure(outputs, &failure) == GUSSET_PLUGIN_DONE);
    if (got != status || failure.input != which || failure.param != GUSSET_PLUGIN_NONE || failure.message[0] == '\0' ||
        (element != 0 && (failure.element != element || failure.index != index))) {
        printf("%s:%d: %s: input %u: %s (status %d, not %d; input %u; element %u, index %llu, not %u, %llu)\n",
               __FILE__, line, filter->id, which, failure.message, got, status, failure.input, failure.element,
               (unsigned long long)failure.index, element, (unsigned long long)index);
        ++failures;
    }
    plugin->output_free(outputs);
}

#define EXPECT(status, element, index) expect(filter, made->inputs, made->count, k, status, element, index, __LINE__)

enum { VERTEX = 1, FACE = 2, CORNER = 3, OFFSET = 4, POINT = 7 };

static void check_mesh(const gusset_filter *filter, shapes *made, uint32_t k) {
    gusset_plugin_mesh *mesh = &made->views[k].mesh;
    const gusset_plugin_mesh good = *mesh;
    double *positions = made->memory[k][0];
    uint32_t *offsets = made->memory[k][1], *corners = made->memory[k][2];

    mesh->struct_size = 8;
    EXPECT(3, 0, 0);
    *mesh = good;
    mesh->scalar = 0;
    EXPECT(4, 0, 0);
    mesh->scalar = 3;
    EXPECT(4, 0, 0);
    *mesh = good;
    mesh->index = 1;
    EXPECT(4, 0, 0);
    *mesh = good;
    mesh->reserved = 1;
    EXPECT(4, 0, 0);
    *mesh = good;
    mesh->position_stride = 23;
    EXPECT(9, 0, 0);
    *mesh = good;
    mesh->face_size = 4;
    EXPECT(10, 0, 0);
    mesh->face_size = 0;
    mesh->face_offsets = NULL;
    EXPECT(10, 0, 0);
    *mesh = good;
    mesh->positions = NULL;
    EXPECT(1, 0, 0);
    *mesh = good;
    mesh->face_corners = NULL;
    EXPECT(1, 0, 0);
    *mesh = good;
    mesh->vertex_count = 0;
    EXPECT(1002, 0, 0);
    *mesh = good;
    mesh->face_count = 0;
    EXPECT(1002, 0, 0);
    *mesh = good;
    mesh->vertex_count = UINT32_MAX;
    EXPECT(1000, 0, 0);
    *mesh = good;
    mesh->vertex_count = SIZE_MAX;
    EXPECT(1000, 0, 0);
    *mesh = good;
    mesh->face_count = SIZE_MAX;
    EXPECT(1000, 0, 0);
    *mesh = good;
    mesh->position_stride = SIZE_MAX / 2;
    EXPECT(1001, 0, 0);
    *mesh = good;

    offsets[0] = 1;
    EXPECT(1003, OFFSET, 0);
    offsets[0] = 0;
    const uint32_t second = offsets[2];
    offsets[2] = 0;
    EXPECT(1003, OFFSET, 2);
    offsets[2] = offsets[1] + 2;
    EXPECT(1004, FACE, 1);
    offsets[2] = second;
    const uint32_t corner = corners[5];
    corners[5] = (uint32_t)mesh->vertex_count;
    EXPECT(1005, CORNER, 5);
    corners[5] = UINT32_MAX;
    EXPECT(1005, CORNER, 5);
    corners[5] = corner;
    const double kept = positions[3 * (size_t)corner + 1];
    const double wrong[] = {NAN, INFINITY, -INFINITY};
    for (int w = 0; w < 3; ++w) {
        positions[3 * (size_t)corner + 1] = wrong[w];
        EXPECT(1006, VERTEX, corner);
    }
    positions[3 * (size_t)corner + 1] = kept;
}

static void check_curves(const gusset_filter *filter, shapes *made, uint32_t k) {
    gusset_plugin_curves *curves = &made->views[k].curves;
    const gusset_plugin_curves good = *curves;
    double *points = made->memory[k][0];
    uint32_t *offsets = made->memory[k][1];
    uint8_t *closed = made->memory[k][2];

    curves->struct_size = 8;
    EXPECT(3, 0, 0);
    *curves = good;
    curves->scalar = 0;
    EXPECT(4, 0, 0);
    *curves = good;
    curves->reserved = 1;
    EXPECT(4, 0, 0);
    *curves = good;
    curves->point_stride = 23;
    EXPECT(9, 0, 0);
    *curves = good;
    curves->points = NULL;
    EXPECT(1, 0, 0);
    *curves = good;
    curves->offsets = NULL;
    EXPECT(1, 0, 0);
    *curves = good;
    curves->point_count = SIZE_MAX;
    EXPECT(1000, 0, 0);
    *curves = good;
    curves->curve_count = UINT32_MAX;
    EXPECT(1000, 0, 0);
    *curves = good;
    curves->point_stride = SIZE_MAX / 2;
    EXPECT(1001, 0, 0);
    *curves = good;
    closed[1] = 2;
    EXPECT(4, 0, 0);
    closed[1] = closed[0];

    offsets[0] = 1;
    EXPECT(1003, OFFSET, 0);
    offsets[0] = 0;
    const uint32_t second = offsets[2], last = offsets[curves->curve_count];
    offsets[2] = offsets[1] - 1;
    EXPECT(1003, OFFSET, 2);
    offsets[2] = UINT32_MAX;
    EXPECT(1003, OFFSET, 2);
    offsets[2] = second;
    offsets[curves->curve_count] = last - 1;
    EXPECT(1003, OFFSET, curves->curve_count);
    offsets[curves->curve_count] = last;
    const double kept = points[4];
    const double wrong[] = {NAN, INFINITY, -INFINITY};
    for (int w = 0; w < 3; ++w) {
        points[4] = wrong[w];
        EXPECT(1006, POINT, 1);
    }
    points[4] = kept;
}

int main(int argc, char **argv) {
    if (argc != 2) {
        return 2;
    }
    void *library = open_library(argv[1]);
    plugin = entry_of(library)(GUSSET_PLUGIN_ABI);
    if (plugin == NULL) {
        return 1;
    }
    for (uint32_t i = 0; i < plugin->filter_count; ++i) {
        const gusset_filter *filter = plugin->filter(i);
        shapes made;
        shapes_make(&made, filter, 0, 5);
        for (uint32_t k = 0; k < made.count; ++k) {
            if (made.inputs[k].kind == GUSSET_KIND_MESH) {
                check_mesh(filter, &made, k);
            } else {
                check_curves(filter, &made, k);
            }
        }
        shapes_free(&made);
    }
    return failures == 0 ? 0 : 1;
}

/* Attributes of meshes through every filter: attributes LIBRARY [SIZE], on shapes of this size, 8
 * unless told */
#include "loaded.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Statuses of gusset.h, which this host does not have. */
enum { IS_NULL = 1, BAD_STRUCT_SIZE = 3, UNKNOWN_VALUE = 4, NO_SUCH_ELEMENT = 8, COUNT_DIFFERS = 13, NOT_FINITE = 1006 };
enum { POSITION = 3 * sizeof(double) };

static uint32_t shape_size = 8;

static const gusset_plugin *plugin;
static const gusset_plugin_attributes *attributes;

static void *zeros(size_t count, size_t size) {
    void *made = calloc(count + 1, size);
    if (made == NULL) {
        exit(2);
    }
    return made;
}

static gusset_plugin_mesh mesh_of(const char *of, const gusset_outputs *outputs) {
    gusset_plugin_mesh mesh = {0};
    mesh.struct_size = sizeof mesh;
    CHECK_OF(of, plugin->output_mesh(outputs, 0, &mesh) == GUSSET_PLUGIN_DONE);
    return mesh;
}

/* The table of a domain: a row for each element, of sources that there are. */
static gusset_plugin_origins origins_of(const char *of, const gusset_outputs *outputs, uint32_t domain, size_t count) {
    gusset_plugin_origins origins = {0};
    origins.struct_size = sizeof origins;
    CHECK_OF(of, attributes->origins(outputs, 0, domain, &origins) == GUSSET_PLUGIN_DONE);
    CHECK_OF(of, origins.count == count && origins.offsets[0] == 0);
    for (size_t k = 0; k < origins.count; ++k) {
        double sum = 0;
        for (uint32_t e = origins.offsets[k]; e < origins.offsets[k + 1]; ++e) {
            CHECK_OF(of, origins.sources[e] < origins.starts[origins.input_count] && origins.weights[e] > 0);
            sum += origins.weights[e];
        }
        CHECK_OF(of, fabs(sum - 1) < 1e-12 || origins.offsets[k] == origins.offsets[k + 1]);
    }
    return origins;
}

/* Carries positions of the inputs as a channel: each vertex of the result gets the weighted mean of its sources. */
static void check_positions(const gusset_filter *filter, const shapes *made, const gusset_outputs *outputs) {
    const gusset_plugin_mesh mesh = mesh_of(filter->id, outputs);
    const gusset_plugin_origins origins =
        origins_of(filter->id, outputs, GUSSET_PLUGIN_VERTICES, mesh.vertex_count);
    const gusset_plugin_channel channel = {
        sizeof channel, GUSSET_PLUGIN_VERTICES, GUSSET_PLUGIN_VALUE_F64, 3, GUSSET_PLUGIN_RULE_LINEAR, 0, 0};
    gusset_plugin_channel_values inputs[MOST_INPUTS];
    CHECK_OF(filter->id, origins.input_count == made->count);
    for (uint32_t i = 0; i < made->count; ++i) {
        const gusset_plugin_mesh *view = &made->views[i].mesh;
        inputs[i] = (gusset_plugin_channel_values){view->positions, view->vertex_count, view->position_stride};
        CHECK_OF(filter->id, origins.starts[i + 1] - origins.starts[i] == view->vertex_count);
    }
    double *carried = zeros(mesh.vertex_count, POSITION);
    gusset_failure failure = {0};
    failure.struct_size = sizeof failure;
    CHECK_OF(filter->id, attributes->apply(outputs, 0, NULL, &channel, inputs, made->count, carried, mesh.vertex_count,
                                           0, &failure) == GUSSET_PLUGIN_DONE);
    CHECK_OF(filter->id, failure.status == GUSSET_PLUGIN_DONE && failure.message != NULL && failure.message[0] == '\0');
    for (size_t v = 0; v < mesh.vertex_count; ++v) {
        double expected[3] = {0};
        for (uint32_t e = origins.offsets[v]; e < origins.offsets[v + 1]; ++e) {
            uint32_t i = 0;
            while (origins.sources[e] >= origins.starts[i + 1]) {
                ++i;
            }
            const char *bytes = inputs[i].values;
            const size_t stride = inputs[i].stride == 0 ? POSITION : inputs[i].stride;
            double own[3];
            memcpy(own, bytes + stride * (origins.sources[e] - origins.starts[i]), sizeof own);
            for (int k = 0; k < 3; ++k) {
                expected[k] += origins.weights[e] * own[k];
            }
        }
        for (int k = 0; k < 3; ++k) {
            CHECK_OF(filter->id, fabs(carried[3 * v + (size_t)k] - expected[k]) < 1e-12);
        }
    }
    free(carried);
}

/* Carries integers of faces: each integer of the result occurs in an input, and a host that cancels gets the status.
   */
static void check_numbers(const gusset_filter *filter, const shapes *made, const gusset_outputs *outputs) {
    const gusset_plugin_mesh mesh = mesh_of(filter->id, outputs);
    const gusset_plugin_channel channel = {
        sizeof channel, GUSSET_PLUGIN_FACES, GUSSET_PLUGIN_VALUE_U32, 1, GUSSET_PLUGIN_RULE_NEAREST, 0, 0};
    const gusset_plugin_origins origins = origins_of(filter->id, outputs, GUSSET_PLUGIN_FACES, mesh.face_count);
    const uint32_t *offsets = mesh.face_offsets;
    (void)origins_of(filter->id, outputs, GUSSET_PLUGIN_CORNERS, offsets[mesh.face_count]);
    gusset_plugin_channel_values inputs[MOST_INPUTS];
    uint32_t *numbers[MOST_INPUTS] = {NULL};
    uint32_t next = 0;
    for (uint32_t i = 0; i < made->count; ++i) {
        const size_t count = made->views[i].mesh.face_count;
        numbers[i] = zeros(count, sizeof(uint32_t));
        for (size_t f = 0; f < count; ++f) {
            numbers[i][f] = ++next;
        }
        inputs[i] = (gusset_plugin_channel_values){numbers[i], count, 0};
    }
    uint32_t *carried = zeros(mesh.face_count, sizeof(uint32_t));
    CHECK_OF(filter->id, attributes->apply(outputs, 0, NULL, &channel, inputs, made->count, carried, mesh.face_count, 0,
                                           NULL) == GUSSET_PLUGIN_DONE);
    for (size_t f = 0; f < mesh.face_count; ++f) {
        const uint32_t first = origins.offsets[f];
        CHECK_OF(filter->id,
                 carried[f] == (first == origins.offsets[f + 1] ? 0 : origins.sources[first] + 1));
    }
    free(carried);
    for (uint32_t i = 0; i < made->count; ++i) {
        free(numbers[i]);
    }
}

static int32_t stop(void *user, double fraction, const char *stage) {
    (void)user;
    (void)stage;
    return fraction >= 0;
}

/* Channels that fit no input: a status, with the element and the input. */
static void check_bad(void) {
    shapes made;
    gusset_host host = {0};
    host.struct_size = sizeof host;
    host.origins = 1;
    gusset_outputs *outputs = run_on_shapes(plugin, plugin->find("weld"), &host, shape_size, &made);
    const gusset_plugin_mesh mesh = mesh_of("weld", outputs);
    const size_t given = made.views[0].mesh.vertex_count;
    const gusset_plugin_channel good = {
        sizeof good, GUSSET_PLUGIN_VERTICES, GUSSET_PLUGIN_VALUE_F32, 1, GUSSET_PLUGIN_RULE_LINEAR, 0, 0};
    float *values = zeros(given, sizeof(float)), *carried = zeros(mesh.vertex_count, sizeof(float));
    gusset_plugin_channel_values input = {values, given, 0};
    gusset_failure failure = {0};
    failure.struct_size = sizeof failure;
#define APPLY(index, host_, channel_, inputs_, count_, room_)                                                          \
    attributes->apply(outputs, (index), (host_), (channel_), (inputs_), (count_), carried, (room_), 0, &failure)
    CHECK(APPLY(0, NULL, &good, &input, 1, mesh.vertex_count) == GUSSET_PLUGIN_DONE);
    CHECK(attributes->apply(NULL, 0, NULL, &good, &input, 1, carried, mesh.vertex_count, 0, NULL) == IS_NULL);
    CHECK(APPLY(1, NULL, &good, &input, 1, mesh.vertex_count) == NO_SUCH_ELEMENT);
    CHECK(APPLY(9, NULL, &good, &input, 1, mesh.vertex_count) == NO_SUCH_ELEMENT && failure.message[0] != '\0');
    CHECK(APPLY(0, NULL, NULL, &input, 1, mesh.vertex_count) == IS_NULL);
    CHECK(APPLY(0, NULL, &good, NULL, 1, mesh.vertex_count) == IS_NULL);
    CHECK(APPLY(0, NULL, &good, &input, 0, mesh.vertex_count) == COUNT_DIFFERS);
    CHECK(APPLY(0, NULL, &good, &input, 2, mesh.vertex_count) == COUNT_DIFFERS);
    CHECK(APPLY(0, NULL, &good, &input, 1, mesh.vertex_count - 1) != GUSSET_PLUGIN_DONE);
    gusset_plugin_channel bad = good;
    bad.value_type = 0;
    CHECK(APPLY(0, NULL, &bad, &input, 1, mesh.vertex_count) == UNKNOWN_VALUE);
    bad = good;
    bad.struct_size = 8;
    CHECK(APPLY(0, NULL, &bad, &input, 1, mesh.vertex_count) == BAD_STRUCT_SIZE);
    input.count = given - 1;
    CHECK(APPLY(0, NULL, &good, &input, 1, mesh.vertex_count) == COUNT_DIFFERS && failure.input == 0);
    input.count = given;
    values[3] = NAN;
    CHECK(APPLY(0, NULL, &good, &input, 1, mesh.vertex_count) == NOT_FINITE);
    CHECK(failure.index == 3 && failure.input == 0 && failure.param == GUSSET_PLUGIN_NONE);
    values[3] = 0;
    host.progress = stop;
    CHECK(APPLY(0, &host, &good, &input, 1, mesh.vertex_count) == GUSSET_PLUGIN_CANCELLED);
    gusset_plugin_origins origins = {0};
    CHECK(attributes->origins(outputs, 0, GUSSET_PLUGIN_VERTICES, &origins) == BAD_STRUCT_SIZE);
    origins.struct_size = sizeof origins;
    CHECK(attributes->origins(outputs, 0, 3, &origins) == UNKNOWN_VALUE && origins.offsets == NULL);
    CHECK(attributes->origins(outputs, 1, GUSSET_PLUGIN_VERTICES, &origins) == NO_SUCH_ELEMENT);
    CHECK(attributes->has_origins(outputs, 0) == 1 && attributes->has_origins(outputs, 1) == 0);
    CHECK(attributes->has_origins(outputs, 2) == 0 && attributes->has_origins(NULL, 0) == 0);
    free(values);
    free(carried);
    plugin->output_free(outputs);
    shapes_free(&made);
}

int main(int argc, char **argv) {
    if (argc != 2 && argc != 3) {
        return 2;
    }
    shape_size = argc == 3 ? (uint32_t)atoi(argv[2]) : shape_size;
    plugin = entry_of(open_library(argv[1]))(GUSSET_PLUGIN_ABI);
    attributes = plugin == NULL ? NULL : plugin->extension("attributes/1");
    if (attributes == NULL) {
        return 1;
    }
    unsigned carrying = 0;
    gusset_host host = {0};
    host.struct_size = sizeof host;
    for (uint32_t i = 0; i < plugin->filter_count; ++i) {
        const gusset_filter *filter = plugin->filter(i);
        const uint32_t carries = (filter->flags & GUSSET_FILTER_ORIGINS) != 0;
        for (host.origins = 0; host.origins < 2; ++host.origins) {
            shapes made;
            gusset_outputs *outputs = run_on_shapes(plugin, filter, &host, shape_size, &made);
            if (outputs == NULL) {
                continue;
            }
            CHECK_OF(filter->id, attributes->has_origins(outputs, 0) == (carries & host.origins));
            if (carries & host.origins) {
                check_positions(filter, &made, outputs);
                check_numbers(filter, &made, outputs);
                ++carrying;
            }
            plugin->output_free(outputs);
            shapes_free(&made);
        }
    }
    check_bad();
    printf("%u filters tell where elements come from\n", carrying);
    return failures == 0 && carrying > 0 ? 0 : 1;
}

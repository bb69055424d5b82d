/* Every filter run as a host runs it: runs LIBRARY [MOST SIZE], cancelled at MOST of its calls of the callback, 60 unless
 * told, on shapes of this size, 8 unless told */
#include "loaded.h"

#include <math.h>
#include <pthread.h>
#include <stdlib.h>
#include <string.h>

static const gusset_plugin *plugin;
static uint32_t most_calls = 60;
static uint32_t shape_size = 8;

static void check_mesh(const char *of, const gusset_outputs *outputs, uint32_t index) {
    gusset_plugin_mesh mesh = {0};
    mesh.struct_size = sizeof mesh;
    CHECK_OF(of, plugin->output_mesh(outputs, index, &mesh) == GUSSET_PLUGIN_DONE);
    CHECK_OF(of, mesh.vertex_count > 0 && mesh.face_count > 0 && mesh.positions != NULL);
    CHECK_OF(of, mesh.face_offsets != NULL && mesh.face_size == 0 && mesh.index == 0 && mesh.reserved == 0);
    CHECK_OF(of, mesh.scalar == GUSSET_PLUGIN_F64 && mesh.position_stride == 3 * sizeof(double));
    const uint32_t *offsets = mesh.face_offsets, *corners = mesh.face_corners;
    const double *positions = mesh.positions;
    CHECK_OF(of, offsets != NULL && offsets[0] == 0);
    for (size_t f = 0; offsets != NULL && f < mesh.face_count; ++f) {
        CHECK_OF(of, offsets[f + 1] >= offsets[f] + 3);
        for (uint32_t c = offsets[f]; c < offsets[f + 1]; ++c) {
            const int there = corners[c] < mesh.vertex_count;
            CHECK_OF(of, there);
            for (size_t k = 0; there && k < 3; ++k) {
                CHECK_OF(of, isfinite(positions[3 * (size_t)corners[c] + k]));
            }
        }
    }
}

static void check_curves(const char *of, const gusset_outputs *outputs, uint32_t index) {
    gusset_plugin_curves curves = {0};
    curves.struct_size = sizeof curves;
    CHECK_OF(of, plugin->output_curves(outputs, index, &curves) == GUSSET_PLUGIN_DONE);
    CHECK_OF(of,
             curves.scalar == GUSSET_PLUGIN_F64 && curves.point_stride == 3 * sizeof(double) && curves.reserved == 0);
    const uint32_t *offsets = curves.offsets;
    const double *points = curves.points;
    CHECK_OF(of, offsets != NULL && offsets[0] == 0 && offsets[curves.curve_count] == curves.point_count);
    for (size_t c = 0; offsets != NULL && c < curves.curve_count; ++c) {
        CHECK_OF(of, offsets[c + 1] > offsets[c] && (curves.closed == NULL || curves.closed[c] <= 1));
    }
    for (size_t k = 0; k < 3 * curves.point_count; ++k) {
        CHECK_OF(of, isfinite(points[k]));
    }
}

/* The numbers of an output have names of their own, and end where they say; only texts have any. */
static void check_values(const gusset_filter *filter, const gusset_outputs *outputs, uint32_t index, int is_text) {
    const gusset_plugin_values *values = plugin->extension("values/1");
    const uint32_t count = values->count(outputs, index);
    CHECK_OF(filter->id, is_text || count == 0);
    for (uint32_t v = 0; v < count; ++v) {
        const char *name = values->name(outputs, index, v);
        CHECK_OF(filter->id,
                 name != NULL && name[0] != '\0' && name[strspn(name, "abcdefghijklmnopqrstuvwxyz_")] == '\0');
        const double value = values->value(outputs, index, v);
        const uint32_t kind = values->kind(outputs, index, v);
        CHECK_OF(filter->id, isfinite(value) && kind >= GUSSET_VALUE_COUNT && kind <= GUSSET_VALUE_ANGLE);
        CHECK_OF(filter->id, kind != GUSSET_VALUE_COUNT || value == floor(value));
        CHECK_OF(filter->id, kind != GUSSET_VALUE_FLAG || value == 0 || value == 1);
        CHECK_OF(filter->id, kind != GUSSET_VALUE_ANGLE || (value >= 0 && value < 3.15));
        for (uint32_t before = 0; before < v && name != NULL; ++before) {
            CHECK_OF(filter->id, strcmp(name, values->name(outputs, index, before)) != 0);
        }
    }
    CHECK_OF(filter->id, values->name(outputs, index, count) == NULL && isnan(values->value(outputs, index, count)));
    CHECK_OF(filter->id, values->kind(outputs, index, count) == 0);
}

/* Outputs have the declared kinds, and each reader refuses outputs of other kinds. */
static void check_outputs(const gusset_filter *filter, const gusset_outputs *outputs) {
    gusset_failure none = {0};
    gusset_plugin_mesh mesh = {0};
    gusset_plugin_curves curves = {0};
    none.struct_size = sizeof none;
    mesh.struct_size = sizeof mesh;
    curves.struct_size = sizeof curves;
    CHECK_OF(filter->id, plugin->output_failure(outputs, &none) == GUSSET_PLUGIN_DONE);
    CHECK_OF(filter->id, none.status == GUSSET_PLUGIN_DONE && none.message != NULL && none.message[0] == '\0');
    CHECK_OF(filter->id, none.param == GUSSET_PLUGIN_NONE && none.input == GUSSET_PLUGIN_NONE && none.element == 0);
    CHECK_OF(filter->id, plugin->output_count(outputs) == filter->output_count);
    for (uint32_t i = 0; i < filter->output_count; ++i) {
        const uint32_t kind = plugin->output_kind(outputs, i);
        CHECK_OF(filter->id, kind == filter->output_kinds[i]);
        const char *text = plugin->output_text(outputs, i);
        CHECK_OF(filter->id, (text != NULL) == (kind == GUSSET_KIND_TEXT));
        if (kind == GUSSET_KIND_MESH) {
            check_mesh(filter->id, outputs, i);
        } else {
            CHECK_OF(filter->id,
                     plugin->output_mesh(outputs, i, &mesh) != GUSSET_PLUGIN_DONE && mesh.positions == NULL);
        }
        if (kind == GUSSET_KIND_CURVES) {
            check_curves(filter->id, outputs, i);
        } else {
            CHECK_OF(filter->id,
                     plugin->output_curves(outputs, i, &curves) != GUSSET_PLUGIN_DONE && curves.points == NULL);
        }
        check_values(filter, outputs, i, kind == GUSSET_KIND_TEXT);
        if (text != NULL) {
            CHECK_OF(filter->id, text[0] != '\0' && text[strlen(text) - 1] == '\n');
        }
    }
    CHECK_OF(filter->id, plugin->output_kind(outputs, filter->output_count) == 0);
    CHECK_OF(filter->id, plugin->output_text(outputs, filter->output_count) == NULL);
    CHECK_OF(filter->id, plugin->output_mesh(outputs, UINT32_MAX, &mesh) != GUSSET_PLUGIN_DONE);
}

/* The calls of the callback so far, and the call at which it cancels. */
typedef struct follower {
    const char *of;
    pthread_t thread;
    double fraction;
    uint32_t calls, stop_at;
} follower;

static int32_t follow(void *user, double fraction, const char *stage) {
    follower *self = user;
    CHECK_OF(self->of, pthread_equal(self->thread, pthread_self()));
    CHECK_OF(self->of, stage != NULL && stage[0] != '\0');
    CHECK_OF(self->of, fraction >= self->fraction && fraction <= 1);
    CHECK_OF(self->of, self->stop_at == 0 || self->calls < self->stop_at);
    self->fraction = fraction;
    return ++self->calls == self->stop_at ? 7 : 0;
}

static gusset_host host_of(follower *self, const char *of, uint32_t stop_at, uint32_t threads) {
    gusset_host host = {0};
    memset(self, 0, sizeof *self);
    self->of = of;
    self->thread = pthread_self();
    self->stop_at = stop_at;
    host.struct_size = sizeof host;
    host.user = self;
    host.progress = follow;
    host.threads = threads;
    host.origins = 1;
    return host;
}

/* Whichever call asks to stop, that is the last one, and the run was cancelled. */
static void check_cancel(const gusset_filter *filter, const shapes *made, uint32_t calls) {
    const uint32_t step = calls / most_calls + 1;
    for (uint32_t k = 1; k <= calls; k += step) {
        follower self;
        const gusset_host host = host_of(&self, filter->id, k, 1);
        gusset_outputs *outputs = NULL;
        gusset_failure failure = {0};
        failure.struct_size = sizeof failure;
        CHECK_OF(filter->id,
                 filter->run(filter, &host, made->inputs, made->count, NULL, 0, &outputs) == GUSSET_PLUGIN_CANCELLED);
        CHECK_OF(filter->id, self.calls == k && outputs != NULL && plugin->output_count(outputs) == 0);
        CHECK_OF(filter->id, plugin->output_failure(outputs, &failure) == GUSSET_PLUGIN_DONE);
        CHECK_OF(filter->id,
                 failure.status == GUSSET_PLUGIN_CANCELLED && failure.message != NULL && failure.message[0] != '\0');
        CHECK_OF(filter->id, failure.param == GUSSET_PLUGIN_NONE && failure.input == GUSSET_PLUGIN_NONE);
        plugin->output_free(outputs);
    }
}

/* A copy of an array at an odd address, `size` bytes of every `stride`; to be freed at the address before. */
static void *odd_copy(const void *data, size_t count, size_t size, size_t stride) {
    unsigned char *copy = malloc(count * stride + 1);
    if (copy == NULL) {
        exit(2);
    }
    memset(copy, 0xff, count * stride + 1);
    for (size_t i = 0; i < count; ++i) {
        memcpy(copy + 1 + i * stride, (const unsigned char *)data + i * size, size);
    }
    return copy;
}

/* Arrays of any alignment, with gaps between positions, are the same mesh. */
static void check_odd_arrays(const gusset_filter *filter, const shapes *made, const gusset_outputs *expected) {
    gusset_input inputs[MOST_INPUTS];
    gusset_plugin_mesh meshes[MOST_INPUTS];
    unsigned char *copies[MOST_INPUTS][3] = {{0}};
    gusset_outputs *outputs = NULL;
    memcpy(inputs, made->inputs, sizeof inputs);
    for (uint32_t k = 0; k < made->count; ++k) {
        if (inputs[k].kind == GUSSET_KIND_MESH) {
            const gusset_plugin_mesh *mesh = inputs[k].view;
            const size_t corners = ((const uint32_t *)mesh->face_offsets)[mesh->face_count];
            copies[k][0] = odd_copy(mesh->positions, mesh->vertex_count, 24, 29);
            copies[k][1] = odd_copy(mesh->face_offsets, mesh->face_count + 1, 4, 4);
            copies[k][2] = odd_copy(mesh->face_corners, corners, 4, 4);
            meshes[k] = *mesh;
            meshes[k].positions = copies[k][0] + 1;
            meshes[k].position_stride = 29;
            meshes[k].face_offsets = copies[k][1] + 1;
            meshes[k].face_corners = copies[k][2] + 1;
            inputs[k].view = &meshes[k];
        }
    }
    CHECK_OF(filter->id, filter->run(filter, NULL, inputs, made->count, NULL, 0, &outputs) == GUSSET_PLUGIN_DONE);
    CHECK_OF(filter->id, same_outputs(plugin, expected, plugin, outputs));
    plugin->output_free(outputs);
    for (uint32_t k = 0; k < made->count; ++k) {
        for (int a = 0; a < 3; ++a) {
            free(copies[k][a]);
        }
    }
}

int main(int argc, char **argv) {
    if (argc != 2 && argc != 4) {
        return 2;
    }
    most_calls = argc == 4 ? (uint32_t)atoi(argv[2]) : most_calls;
    shape_size = argc == 4 ? (uint32_t)atoi(argv[3]) : shape_size;
    void *library = open_library(argv[1]);
    plugin = entry_of(library)(GUSSET_PLUGIN_ABI);
    if (plugin == NULL) {
        return 1;
    }
    for (uint32_t i = 0; i < plugin->filter_count; ++i) {
        const gusset_filter *filter = plugin->filter(i);
        shapes made;
        gusset_outputs *outputs = run_on_shapes(plugin, filter, NULL, shape_size, &made);
        if (outputs == NULL) {
            continue;
        }
        check_outputs(filter, outputs);

        /* Without values, with other threads: the same; and how often the callback is called then. */
        gusset_outputs *again = NULL;
        follower self;
        gusset_host host = host_of(&self, filter->id, 0, 1);
        CHECK_OF(filter->id,
                 filter->run(filter, &host, made.inputs, made.count, NULL, 0, &again) == GUSSET_PLUGIN_DONE);
        CHECK_OF(filter->id, same_outputs(plugin, outputs, plugin, again));
        plugin->output_free(again);
        const uint32_t calls = self.calls;
        CHECK_OF(filter->id, calls > 0 && self.fraction == 1);
        host = host_of(&self, filter->id, 0, 3);
        CHECK_OF(filter->id,
                 filter->run(filter, &host, made.inputs, made.count, NULL, 0, &again) == GUSSET_PLUGIN_DONE);
        CHECK_OF(filter->id, same_outputs(plugin, outputs, plugin, again));
        plugin->output_free(again);

        check_cancel(filter, &made, calls);
        check_odd_arrays(filter, &made, outputs);
        printf("%s: %u calls of the callback\n", filter->id, calls);
        plugin->output_free(outputs);
        shapes_free(&made);
    }
    return failures == 0 ? 0 : 1;
}

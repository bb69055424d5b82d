/* A plugin that has nothing of gusset: one filter that shifts a mesh along x. The plugin owns its outputs, and lacks
   extensions. */
#include <gusset_plugin.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct gusset_outputs {
    gusset_plugin_mesh mesh;
    char text[64];
};

static const uint32_t in[] = {GUSSET_KIND_MESH}, out[] = {GUSSET_KIND_MESH, GUSSET_KIND_TEXT};
static const double none[] = {0};
static const gusset_param_info by = {sizeof by, "by", "By", "How far.", GUSSET_PARAM_LENGTH, 1, -1e3, 1e3, none,
                                     0,         NULL, 0,    0};

static const gusset_param_info *param(const gusset_filter *filter, uint32_t index) {
    (void)filter;
    return index == 0 ? &by : NULL;
}

static int32_t suggest(const gusset_filter *filter, const gusset_input *inputs, uint32_t count, double *values) {
    (void)filter, (void)inputs, (void)count;
    values[0] = 1;
    return GUSSET_PLUGIN_DONE;
}

static int32_t run(const gusset_filter *filter, const gusset_host *host, const gusset_input *inputs, uint32_t count,
                   const double *values, uint32_t value_count, struct gusset_outputs **outputs) {
    const gusset_plugin_mesh *mesh = inputs[0].view;
    const size_t numbers = 3 * mesh->vertex_count;
    struct gusset_outputs *made = calloc(1, sizeof *made);
    double *positions = malloc(numbers * sizeof *positions);
    size_t k;
    (void)filter, (void)host, (void)count, (void)value_count;
    *outputs = made;
    if (made == NULL || positions == NULL) {
        free(positions);
        return GUSSET_PLUGIN_OUT_OF_MEMORY;
    }
    memcpy(positions, mesh->positions, numbers * sizeof *positions);
    for (k = 0; k < numbers; k += 3) {
        positions[k] += values[0];
    }
    /* The faces are the host's, which keeps them until it has read this. */
    made->mesh = *mesh;
    made->mesh.positions = positions;
    made->mesh.position_stride = 0;
    snprintf(made->text, sizeof made->text, "shifted %lu vertices\n", (unsigned long)mesh->vertex_count);
    return GUSSET_PLUGIN_DONE;
}

static const gusset_filter shift = {
    sizeof shift,           "shift", "Shift", "shift", "Test", "Shifts a mesh.", "None", in, out, 1, 1, 1, 2,
    GUSSET_FILTER_REPLACES, 1,       1,       0,       param,  suggest,          run};

static const gusset_filter *filter_at(uint32_t index) { return index == 0 ? &shift : NULL; }
static const gusset_filter *find(const char *id) { return strcmp(id, "shift") == 0 ? &shift : NULL; }
static uint32_t output_count(const struct gusset_outputs *outputs) { return outputs == NULL ? 0 : 2; }
static uint32_t output_kind(const struct gusset_outputs *outputs, uint32_t index) {
    return outputs != NULL && index < 2 ? out[index] : 0;
}
static int32_t output_mesh(const struct gusset_outputs *outputs, uint32_t index, gusset_plugin_mesh *mesh) {
    if (outputs == NULL || index != 0) {
        return GUSSET_PLUGIN_OUT_OF_RANGE;
    }
    *mesh = outputs->mesh;
    return GUSSET_PLUGIN_DONE;
}
static int32_t output_curves(const struct gusset_outputs *outputs, uint32_t index, gusset_plugin_curves *curves) {
    (void)outputs, (void)index, (void)curves;
    return GUSSET_PLUGIN_OUT_OF_RANGE;
}
static const char *output_text(const struct gusset_outputs *outputs, uint32_t index) {
    return outputs != NULL && index == 1 ? outputs->text : NULL;
}
static int32_t output_failure(const struct gusset_outputs *outputs, gusset_failure *failure) {
    (void)outputs, (void)failure;
    return GUSSET_PLUGIN_OUT_OF_RANGE;
}
static void output_free(struct gusset_outputs *outputs) {
    if (outputs != NULL) {
        free((void *)outputs->mesh.positions);
        free(outputs);
    }
}
static const void *extension(const char *name) {
    (void)name;
    return NULL;
}

static const gusset_plugin tables = {sizeof tables,
                                     GUSSET_PLUGIN_ABI,
                                     1,
                                     "other",
                                     "Other",
                                     "1.0.0",
                                     "a test",
                                     "Shifts meshes.",
                                     "MIT OR Apache-2.0",
                                     filter_at,
                                     find,
                                     output_count,
                                     output_kind,
                                     output_mesh,
                                     output_curves,
                                     output_text,
                                     output_failure,
                                     output_free,
                                     extension};

const gusset_plugin *gusset_plugin_entry(uint32_t host_abi) { return host_abi == GUSSET_PLUGIN_ABI ? &tables : NULL; }

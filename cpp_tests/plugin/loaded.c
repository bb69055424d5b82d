#include "loaded.h"

#include <dlfcn.h>
#include <stdlib.h>
#include <string.h>

int failures;

void *open_library(const char *path) {
    void *library = dlopen(path, RTLD_NOW | RTLD_LOCAL);
    if (library == NULL) {
        fprintf(stderr, "%s\n", dlerror());
        exit(2);
    }
    return library;
}

gusset_plugin_entry_fn entry_of(void *library) {
    /* ISO C lacks a cast from void * to a function. */
    void *symbol = dlsym(library, "gusset_plugin_entry");
    gusset_plugin_entry_fn entry;
    if (symbol == NULL) {
        fprintf(stderr, "%s\n", dlerror());
        exit(2);
    }
    memcpy(&entry, &symbol, sizeof entry);
    return entry;
}

gusset_outputs *run_on_shapes(const gusset_plugin *plugin, const gusset_filter *filter, const gusset_host *host,
                              uint32_t size, shapes *made) {
    for (uint32_t number = 0; number < TRIES; ++number) {
        gusset_outputs *outputs = NULL;
        double *values = malloc((filter->value_count + 1) * sizeof *values);
        shapes_make(made, filter, number, size);
        int32_t status =
            values == NULL ? GUSSET_PLUGIN_OUT_OF_MEMORY : filter->suggest(filter, made->inputs, made->count, values);
        if (status == GUSSET_PLUGIN_DONE) {
            status = filter->run(filter, host, made->inputs, made->count, values, filter->value_count, &outputs);
        }
        free(values);
        if (status == GUSSET_PLUGIN_DONE) {
            return outputs;
        }
        plugin->output_free(outputs);
        shapes_free(made);
    }
    printf("%s: takes none of the shapes\n", filter->id);
    ++failures;
    return NULL;
}

static int same_bytes(const void *a, const void *b, size_t size) { return size == 0 || memcmp(a, b, size) == 0; }

static int same_meshes(const gusset_plugin_mesh *a, const gusset_plugin_mesh *b) {
    if (a->vertex_count != b->vertex_count || a->face_count != b->face_count || a->scalar != b->scalar ||
        a->position_stride != b->position_stride ||
        !same_bytes(a->face_offsets, b->face_offsets, (a->face_count + 1) * sizeof(uint32_t))) {
        return 0;
    }
    const size_t corners = ((const uint32_t *)a->face_offsets)[a->face_count];
    return same_bytes(a->positions, b->positions, a->vertex_count * a->position_stride) &&
           same_bytes(a->face_corners, b->face_corners, corners * sizeof(uint32_t));
}

static int same_curves(const gusset_plugin_curves *a, const gusset_plugin_curves *b) {
    return a->point_count == b->point_count && a->curve_count == b->curve_count && a->scalar == b->scalar &&
           a->point_stride == b->point_stride && same_bytes(a->points, b->points, a->point_count * a->point_stride) &&
           same_bytes(a->offsets, b->offsets, (a->curve_count + 1) * sizeof(uint32_t)) &&
           same_bytes(a->closed, b->closed, a->curve_count);
}

static int same_output(const gusset_plugin *a, const gusset_outputs *of_a, const gusset_plugin *b,
                       const gusset_outputs *of_b, uint32_t index) {
    gusset_plugin_mesh meshes[2] = {{0}, {0}};
    gusset_plugin_curves curves[2] = {{0}, {0}};
    meshes[0].struct_size = meshes[1].struct_size = sizeof meshes[0];
    curves[0].struct_size = curves[1].struct_size = sizeof curves[0];
    if (a->output_kind(of_a, index) != b->output_kind(of_b, index)) {
        return 0;
    }
    switch (a->output_kind(of_a, index)) {
    case GUSSET_KIND_MESH:
        return a->output_mesh(of_a, index, &meshes[0]) == GUSSET_PLUGIN_DONE &&
               b->output_mesh(of_b, index, &meshes[1]) == GUSSET_PLUGIN_DONE && same_meshes(&meshes[0], &meshes[1]);
    case GUSSET_KIND_CURVES:
        return a->output_curves(of_a, index, &curves[0]) == GUSSET_PLUGIN_DONE &&
               b->output_curves(of_b, index, &curves[1]) == GUSSET_PLUGIN_DONE && same_curves(&curves[0], &curves[1]);
    case GUSSET_KIND_TEXT:
        return strcmp(a->output_text(of_a, index), b->output_text(of_b, index)) == 0;
    default:
        return 0;
    }
}

int same_outputs(const gusset_plugin *a, const gusset_outputs *of_a, const gusset_plugin *b,
                 const gusset_outputs *of_b) {
    if (of_a == NULL || of_b == NULL || a->output_count(of_a) != b->output_count(of_b)) {
        return 0;
    }
    for (uint32_t i = 0; i < a->output_count(of_a); ++i) {
        if (!same_output(a, of_a, b, of_b, i)) {
            return 0;
        }
    }
    return 1;
}

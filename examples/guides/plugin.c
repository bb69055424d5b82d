/* The program of docs/guides/plugin.md: a host that knows the descriptor and nothing else. plugin libgusset.so.0.1 */
#include <dlfcn.h>
#include <gusset_plugin.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

//! [load]
/* The library needs no initialisation, and stays loaded. */
static const gusset_plugin *load(const char *path) {
    gusset_plugin_entry_fn entry;
    void *library = dlopen(path, RTLD_NOW | RTLD_LOCAL);
    if (library == NULL) {
        fprintf(stderr, "%s\n", dlerror());
        return NULL;
    }
    /* POSIX returns the address of a function as a data pointer. */
    *(void **)&entry = dlsym(library, "gusset_plugin_entry");
    return entry == NULL ? NULL : entry(GUSSET_PLUGIN_ABI);
}
//! [load]

//! [list]
static void list(const gusset_plugin *plugin) {
    uint32_t f, p;
    for (f = 0; f < plugin->filter_count; ++f) {
        const gusset_filter *filter = plugin->filter(f);
        printf("%s: %s\n", filter->id, filter->name);
        for (p = 0; p < filter->param_count; ++p) {
            const gusset_param_info *param = filter->param(filter, p);
            printf("  %s, from %g to %g, %g by itself\n", param->id, param->min, param->max, param->default_values[0]);
        }
    }
}
//! [list]

//! [run]
/* Gets values that suit the mesh, runs the filter, and reads its result. A host first applies the user's changes to the values. */
static int weld(const gusset_plugin *plugin, const gusset_plugin_mesh *mesh, gusset_plugin_mesh *welded,
                gusset_outputs **outputs, const gusset_host *host) {
    const gusset_filter *filter = plugin->find("weld");
    const gusset_input input = {sizeof input, mesh, GUSSET_KIND_MESH, 0};
    gusset_failure failure = {0};
    double *values;
    int32_t status;
    *outputs = NULL;
    if (filter == NULL || (values = calloc(filter->value_count + 1, sizeof *values)) == NULL) {
        return 1;
    }
    /* If it refuses the mesh, values are the plain defaults, and the run reports why. */
    (void)filter->suggest(filter, &input, 1, values);
    status = filter->run(filter, host, &input, 1, values, filter->value_count, outputs);
    free(values);
    if (status != GUSSET_PLUGIN_DONE) {
        failure.struct_size = sizeof failure;
        if (*outputs != NULL && plugin->output_failure(*outputs, &failure) == GUSSET_PLUGIN_DONE) {
            fprintf(stderr, "weld: %s\n", failure.message);
        }
        return 1;
    }
    welded->struct_size = sizeof *welded;
    return plugin->output_mesh(*outputs, 0, welded) != GUSSET_PLUGIN_DONE;
}
//! [run]

//! [attributes]
/* Carries the colours of the input over to the result: old vertices keep theirs bit for bit. */
static int carry_colours(const gusset_plugin *plugin, const gusset_outputs *outputs, const uint8_t *colours,
                         size_t count, uint8_t *carried, size_t carried_count) {
    const gusset_plugin_attributes *attributes = plugin->extension("attributes/1");
    gusset_plugin_channel channel = {0};
    const gusset_plugin_channel_values input = {colours, count, 0};
    channel.struct_size = sizeof channel;
    channel.domain = GUSSET_PLUGIN_VERTICES;
    channel.value_type = GUSSET_PLUGIN_VALUE_U8;
    channel.components = 4;
    channel.rule = GUSSET_PLUGIN_RULE_LINEAR;
    return attributes == NULL || attributes->apply(outputs, 0, NULL, &channel, &input, 1, carried, carried_count, 0,
                                                   NULL) != GUSSET_PLUGIN_DONE;
}
//! [attributes]

//! [progress]
static int32_t on_progress(void *user, double fraction, const char *stage) {
    (void)stage;
    *(double *)user = fraction; /* a progress bar */
    return 0;                   /* anything else: the user pressed Cancel */
}
//! [progress]

int main(int argc, char **argv) {
    /* Two triangles with corners of their own, side by side. */
    const float points[6][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    const uint32_t corners[6] = {0, 1, 2, 3, 4, 5};
    const uint8_t colours[6][4] = {{255, 0, 0, 255}, {0, 255, 0, 255}, {0, 0, 255, 255}, {0, 255, 0, 255}, {9, 9, 9, 255}, {0, 0, 255, 255}};
    uint8_t carried[6][4];
    gusset_plugin_mesh mesh = {0}, welded = {0};
    gusset_outputs *outputs = NULL;
    gusset_host host = {0};
    double done = 0.0;
    int failed;
    const gusset_plugin *plugin = argc == 2 ? load(argv[1]) : NULL;
    if (plugin == NULL) {
        fprintf(stderr, "usage: plugin libgusset.so.0.1\n");
        return 2;
    }
    printf("%s %s, %s\n", plugin->name, plugin->version, plugin->license);
    list(plugin);

    mesh.struct_size = sizeof mesh;
    mesh.positions = points;
    mesh.vertex_count = 6;
    mesh.face_corners = corners;
    mesh.face_count = 2;
    mesh.face_size = 3;
    mesh.scalar = GUSSET_PLUGIN_F32;
    host.struct_size = sizeof host;
    host.user = &done;
    host.progress = on_progress;
    host.origins = 1; /* for colours */
    failed = weld(plugin, &mesh, &welded, &outputs, &host);
    printf("%lu vertices are left of %lu\n", (unsigned long)welded.vertex_count, (unsigned long)mesh.vertex_count);
    failed = failed || carry_colours(plugin, outputs, colours[0], 6, carried[0], 6) || carried[1][1] != 255;
    plugin->output_free(outputs); /* and with it what welded points to */
    return failed || welded.vertex_count != 4;
}

/* Runs filters of the native library as a test asks for: jobs on standard input, what came out on standard output, numbers of 32 bits
 * unless said otherwise, in the order of this machine.
 *     job:    length of the filter's id, the id; inputs: their number, each its kind, scalar and arrays; parameters: their number, each its
 *             place among the values and a double
 *     answer: status; if it is 0 the outputs, as the inputs are; else element, parameter, input, index (64 bits), value, message;
 *             then the seconds that the run took, a double */
#include "gusset_plugin.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

static void get(void *to, size_t bytes) {
    if (bytes && fread(to, bytes, 1, stdin) != 1) {
        fputs("the job is cut off\n", stderr);
        exit(1);
    }
}

static uint32_t number(void) {
    uint32_t value;
    get(&value, sizeof value);
    return value;
}

static void *array(size_t bytes) {
    void *made = malloc(bytes ? bytes : 1);
    if (!made) {
        exit(1);
    }
    get(made, bytes);
    return made;
}

static void put(const void *from, size_t bytes) {
    if (bytes && fwrite(from, bytes, 1, stdout) != 1) {
        exit(1);
    }
}

static void put_number(size_t value) {
    uint32_t number = (uint32_t)value;
    put(&number, sizeof number);
}

static void put_text(const char *text) {
    put_number(strlen(text));
    put(text, strlen(text));
}

static size_t scalar_size(uint32_t scalar) { return scalar == GUSSET_PLUGIN_F32 ? 4 : 8; }

static void *read_input(uint32_t kind) {
    uint32_t scalar = number(), count = number();
    void *points = array(3 * scalar_size(scalar) * count);
    uint32_t parts = number();
    uint32_t *offsets = array(4 * ((size_t)parts + 1));
    if (kind == GUSSET_KIND_MESH) {
        gusset_plugin_mesh *mesh = calloc(1, sizeof *mesh);
        uint32_t corners = number();
        *mesh = (gusset_plugin_mesh){.struct_size = sizeof *mesh, .positions = points, .vertex_count = count, .face_offsets = offsets,
                                     .face_corners = array(4 * (size_t)corners), .face_count = parts, .scalar = scalar};
        return mesh;
    }
    gusset_plugin_curves *curves = calloc(1, sizeof *curves);
    *curves = (gusset_plugin_curves){.struct_size = sizeof *curves, .points = points, .point_count = count, .offsets = offsets,
                                     .closed = array(parts), .curve_count = parts, .scalar = scalar};
    return curves;
}

static void write_output(const gusset_plugin *plugin, const gusset_outputs *outputs, uint32_t index) {
    uint32_t kind = plugin->output_kind(outputs, index);
    put_number(kind);
    if (kind == GUSSET_KIND_TEXT) {
        const gusset_plugin_values *values = plugin->extension("values/1");
        uint32_t count = values->count(outputs, index);
        put_text(plugin->output_text(outputs, index));
        put_number(count);
        for (uint32_t k = 0; k < count; k++) {
            double value = values->value(outputs, index, k);
            put_text(values->name(outputs, index, k));
            put(&value, sizeof value);
            put_number(values->kind(outputs, index, k));
        }
    } else if (kind == GUSSET_KIND_MESH) {
        gusset_plugin_mesh mesh = {.struct_size = sizeof mesh};
        if (plugin->output_mesh(outputs, index, &mesh) != 0) {
            exit(1);
        }
        put_number(mesh.scalar);
        put_number(mesh.vertex_count);
        put(mesh.positions, 3 * scalar_size(mesh.scalar) * mesh.vertex_count);
        put_number(mesh.face_count);
        put(mesh.face_offsets, 4 * (mesh.face_count + 1));
        uint32_t corners = ((const uint32_t *)mesh.face_offsets)[mesh.face_count];
        put_number(corners);
        put(mesh.face_corners, 4 * (size_t)corners);
    } else {
        gusset_plugin_curves curves = {.struct_size = sizeof curves};
        const uint32_t none = 0;
        if (plugin->output_curves(outputs, index, &curves) != 0) {
            exit(1);
        }
        put_number(curves.scalar);
        put_number(curves.point_count);
        put(curves.points, 3 * scalar_size(curves.scalar) * curves.point_count);
        put_number(curves.curve_count);
        put(curves.offsets ? curves.offsets : &none, 4 * (curves.curve_count + 1));
        put(curves.closed, curves.curve_count);
    }
}

int main(void) {
    const gusset_plugin *plugin = gusset_plugin_entry(GUSSET_PLUGIN_ABI);
    uint32_t length;
    while (plugin && fread(&length, sizeof length, 1, stdin) == 1) {
        char id[64] = {0};
        if (length >= sizeof id) {
            return 1;
        }
        get(id, length);
        const gusset_filter *filter = plugin->find(id);
        if (!filter) {
            fprintf(stderr, "there is no filter %s\n", id);
            return 1;
        }
        uint32_t count = number();
        gusset_input *inputs = calloc(count + 1, sizeof *inputs);
        for (uint32_t k = 0; k < count; k++) {
            inputs[k].struct_size = sizeof *inputs;
            inputs[k].kind = number();
            inputs[k].view = read_input(inputs[k].kind);
        }
        double *values = calloc(filter->value_count + 1, sizeof *values);
        /* run returns its result again. */
        (void)filter->suggest(filter, inputs, count, values);
        for (uint32_t given = number(); given > 0; given--) {
            uint32_t place = number();
            get(&values[place], sizeof *values);
        }
        gusset_host host = {.struct_size = sizeof host, .threads = 1};
        gusset_outputs *outputs = NULL;
        struct timespec begin, end;
        clock_gettime(CLOCK_MONOTONIC, &begin);
        int32_t status = filter->run(filter, &host, inputs, count, values, filter->value_count, &outputs);
        clock_gettime(CLOCK_MONOTONIC, &end);
        put(&status, sizeof status);
        if (status == 0) {
            put_number(plugin->output_count(outputs));
            for (uint32_t k = 0; k < plugin->output_count(outputs); k++) {
                write_output(plugin, outputs, k);
            }
        } else {
            gusset_failure failure = {.struct_size = sizeof failure};
            if (plugin->output_failure(outputs, &failure) != 0) {
                return 1;
            }
            put_number(failure.element);
            put_number(failure.param);
            put_number(failure.input);
            put(&failure.index, sizeof failure.index);
            put(&failure.value, sizeof failure.value);
            put_text(failure.message);
        }
        double seconds = (double)(end.tv_sec - begin.tv_sec) + 1e-9 * (double)(end.tv_nsec - begin.tv_nsec);
        put(&seconds, sizeof seconds);
        plugin->output_free(outputs);
        /* The arrays are the system's to take back: there are few jobs. */
    }
    return plugin ? 0 : 1;
}

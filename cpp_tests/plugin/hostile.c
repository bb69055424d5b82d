/* Mistakes of a careless host, except invalid pointers: hostile LIBRARY */
#include "loaded.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Statuses of gusset.h, which this host does not have. */
enum { IS_NULL = 1, MISALIGNED = 2, BAD_STRUCT_SIZE = 3, UNKNOWN_VALUE = 4, OUT_OF_RANGE = 5, NO_SUCH_ELEMENT = 8 };

static const gusset_plugin *plugin;

/* A run that must fail, with this status, and with an account of it. */
typedef struct attempt {
    const gusset_filter *filter;
    const gusset_host *host;
    const gusset_input *inputs;
    const double *values;
    uint32_t input_count, value_count;
} attempt;

static gusset_failure failed(const char *what, const attempt *of, const gusset_filter *self) {
    gusset_outputs *outputs = NULL;
    gusset_failure failure = {0};
    const int32_t status =
        of->filter->run(self, of->host, of->inputs, of->input_count, of->values, of->value_count, &outputs);
    failure.struct_size = sizeof failure;
    CHECK_OF(what, status != GUSSET_PLUGIN_DONE && outputs != NULL);
    CHECK_OF(what, plugin->output_failure(outputs, &failure) == GUSSET_PLUGIN_DONE && failure.status == status);
    CHECK_OF(what, failure.message != NULL && failure.message[0] != '\0');
    CHECK_OF(what, plugin->output_count(outputs) == 0 && plugin->output_kind(outputs, 0) == 0);
    plugin->output_free(outputs);
    failure.message = NULL;
    return failure;
}

#define EXPECT(of, expected, input_, attempt_)                                                                         \
    do {                                                                                                               \
        const gusset_failure got_ = failed(#attempt_, &(attempt_), (attempt_).filter);                                 \
        if (got_.status != (expected) || got_.input != (input_)) {                                                     \
            printf("%s:%d: %s: status %d and input %d, not %s and %d\n", __FILE__, __LINE__, (of), got_.status,        \
                   (int)got_.input, #expected, (int)(input_));                                                         \
            ++failures;                                                                                                \
        }                                                                                                              \
    } while (0)

static void check_readers(void) {
    gusset_plugin_mesh mesh = {0};
    gusset_plugin_curves curves = {0};
    gusset_failure failure = {0};
    mesh.struct_size = sizeof mesh;
    curves.struct_size = sizeof curves;
    failure.struct_size = sizeof failure;
    CHECK(plugin->output_count(NULL) == 0 && plugin->output_kind(NULL, 0) == 0 && plugin->output_text(NULL, 0) == NULL);
    CHECK(plugin->output_mesh(NULL, 0, &mesh) == IS_NULL && plugin->output_curves(NULL, 0, &curves) == IS_NULL);
    CHECK(plugin->output_failure(NULL, &failure) == IS_NULL);
    plugin->output_free(NULL);
    const gusset_plugin_values *values = plugin->extension("values/1");
    CHECK(values->count(NULL, 0) == 0 && values->name(NULL, 0, 0) == NULL && values->kind(NULL, 0, 0) == 0);
    CHECK(values->value(NULL, 0, 0) != values->value(NULL, 0, 0));

    shapes made;
    const gusset_filter *filter = plugin->find("boundary_loops");
    gusset_outputs *outputs = run_on_shapes(plugin, filter, NULL, 4, &made);
    CHECK(plugin->output_curves(outputs, 0, NULL) == IS_NULL && plugin->output_failure(outputs, NULL) == IS_NULL);
    curves.struct_size = 0;
    failure.struct_size = 8;
    CHECK(plugin->output_curves(outputs, 0, &curves) == BAD_STRUCT_SIZE);
    CHECK(plugin->output_failure(outputs, &failure) == BAD_STRUCT_SIZE);
    /* A host of a later version has longer structs, whose tails come back 0. */
    struct {
        gusset_plugin_curves curves;
        uint64_t later[2];
    } longer;
    memset(&longer, 0xff, sizeof longer);
    longer.curves.struct_size = sizeof longer;
    CHECK(plugin->output_curves(outputs, 0, &longer.curves) == GUSSET_PLUGIN_DONE && longer.curves.curve_count > 0);
    CHECK(longer.curves.struct_size == sizeof longer && longer.later[0] == 0 && longer.later[1] == 0);
    plugin->output_free(outputs);
    shapes_free(&made);
}

/* Structs that are none of the table's, and NULL wherever it can be. */
static void check_pointers(const gusset_filter *filter, const shapes *made) {
    const attempt good = {filter, NULL, made->inputs, NULL, made->count, 0};
    attempt bad = good;
    gusset_filter copy = *filter;
    void *room[2];
    CHECK_OF(filter->id, copy.param(&copy, 0) == NULL && filter->param(NULL, 0) == NULL);
    CHECK_OF(filter->id, failed("no filter", &good, NULL).status == IS_NULL);
    CHECK_OF(filter->id, failed("a copy", &good, &copy).status == NO_SUCH_ELEMENT);
    CHECK_OF(filter->id, filter->run(filter, NULL, made->inputs, made->count, NULL, 0, NULL) == IS_NULL);
    gusset_outputs **odd = (gusset_outputs **)(void *)((char *)room + 1);
    CHECK_OF(filter->id, filter->run(filter, NULL, made->inputs, made->count, NULL, 0, odd) == MISALIGNED);
    CHECK_OF(filter->id, filter->suggest(NULL, made->inputs, made->count, (double *)room) == IS_NULL);
    CHECK_OF(filter->id,
             filter->value_count == 0 || filter->suggest(filter, made->inputs, made->count, NULL) == IS_NULL);

    bad.value_count = 1;
    EXPECT(filter->id, filter->value_count == 0 ? OUT_OF_RANGE : IS_NULL, GUSSET_PLUGIN_NONE, bad);
    bad.value_count = filter->value_count + 1;
    EXPECT(filter->id, OUT_OF_RANGE, GUSSET_PLUGIN_NONE, bad);
    bad.value_count = UINT32_MAX;
    bad.values = (double *)room;
    EXPECT(filter->id, OUT_OF_RANGE, GUSSET_PLUGIN_NONE, bad);

    gusset_host host = {0};
    bad = good;
    bad.host = &host;
    EXPECT(filter->id, BAD_STRUCT_SIZE, GUSSET_PLUGIN_NONE, bad);
    host.struct_size = sizeof host;
    host.origins = 2;
    EXPECT(filter->id, UNKNOWN_VALUE, GUSSET_PLUGIN_NONE, bad);
}

/* Each component of each parameter below, above and beside its range: the parameter is named. */
static void check_values(const gusset_filter *filter, const shapes *made) {
    double *values = calloc(filter->value_count + 1, sizeof *values);
    if (values == NULL) {
        exit(2);
    }
    CHECK_OF(filter->id, filter->suggest(filter, made->inputs, made->count, values) == GUSSET_PLUGIN_DONE);
    for (uint32_t i = 0; i < filter->param_count; ++i) {
        const gusset_param_info *param = filter->param(filter, i);
        const int whole =
            param->kind == GUSSET_PARAM_BOOL || param->kind == GUSSET_PARAM_INT || param->kind == GUSSET_PARAM_CHOICE;
        const double wrong[] = {
            nextafter(param->min, -INFINITY), nextafter(param->max, INFINITY), NAN, INFINITY, -INFINITY,
            whole ? param->min + 0.5 : NAN};
        for (uint32_t k = 0; k < param->arity; ++k) {
            double *value = values + param->first_value + k;
            const double kept = *value;
            for (size_t w = 0; w < sizeof wrong / sizeof wrong[0]; ++w) {
                const attempt bad = {filter, NULL, made->inputs, values, made->count, filter->value_count};
                *value = wrong[w];
                const gusset_failure failure = failed(param->id, &bad, filter);
                CHECK_OF(param->id, failure.status == GUSSET_PLUGIN_OUT_OF_RANGE && failure.param == i);
                CHECK_OF(param->id,
                         failure.input == GUSSET_PLUGIN_NONE && memcmp(&failure.value, value, sizeof *value) == 0);
            }
            *value = kept;
        }
        if (param->kind == GUSSET_PARAM_DIRECTION || param->kind == GUSSET_PARAM_PLANE) {
            const attempt bad = {filter, NULL, made->inputs, values, made->count, filter->value_count};
            double kept[3];
            memcpy(kept, values + param->first_value, sizeof kept);
            memset(values + param->first_value, 0, sizeof kept);
            CHECK_OF(param->id, failed(param->id, &bad, filter).param == i);
            memcpy(values + param->first_value, kept, sizeof kept);
        }
    }
    free(values);
}

/* The wrong number of inputs, and each input wrong in turn: the input is named. */
static void check_inputs(const gusset_filter *filter, const shapes *made) {
    gusset_input inputs[MOST_INPUTS];
    attempt bad = {filter, NULL, inputs, NULL, made->count, 0};
    memcpy(inputs, made->inputs, sizeof inputs);
    if (filter->min_inputs > 0) {
        bad.input_count = filter->min_inputs - 1;
        EXPECT(filter->id, OUT_OF_RANGE, GUSSET_PLUGIN_NONE, bad);
        bad.input_count = filter->min_inputs;
        bad.inputs = NULL;
        EXPECT(filter->id, IS_NULL, GUSSET_PLUGIN_NONE, bad);
        bad.inputs = inputs;
    }
    if (filter->max_inputs < UINT32_MAX) {
        /* More than there are: none may be read. */
        bad.input_count = filter->max_inputs + 1;
        EXPECT(filter->id, OUT_OF_RANGE, GUSSET_PLUGIN_NONE, bad);
        bad.input_count = UINT32_MAX;
        EXPECT(filter->id, OUT_OF_RANGE, GUSSET_PLUGIN_NONE, bad);
    }
    bad.input_count = made->count;
    for (uint32_t k = 0; k < made->count; ++k) {
        const gusset_input good = inputs[k];
        inputs[k].view = NULL;
        EXPECT(filter->id, IS_NULL, k, bad);
        inputs[k] = good;
        inputs[k].reserved = 1;
        EXPECT(filter->id, UNKNOWN_VALUE, k, bad);
        inputs[k] = good;
        inputs[k].kind = GUSSET_KIND_TEXT;
        EXPECT(filter->id, UNKNOWN_VALUE, k, bad);
        inputs[k].kind = UINT32_MAX;
        EXPECT(filter->id, UNKNOWN_VALUE, k, bad);
        /* The other kind is refused before its view is looked at. */
        inputs[k].kind = good.kind == GUSSET_KIND_MESH ? GUSSET_KIND_CURVES : GUSSET_KIND_MESH;
        inputs[k].view = (const void *)inputs;
        EXPECT(filter->id, OUT_OF_RANGE, k, bad);
        inputs[k] = good;
    }
    if (made->count > 0) {
        inputs[0].struct_size = 1;
        EXPECT(filter->id, BAD_STRUCT_SIZE, GUSSET_PLUGIN_NONE, bad);
        inputs[0].struct_size = SIZE_MAX;
        EXPECT(filter->id, BAD_STRUCT_SIZE, GUSSET_PLUGIN_NONE, bad);
        inputs[0].struct_size = sizeof inputs[0];
    }
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
    check_readers();
    for (uint32_t i = 0; i < plugin->filter_count; ++i) {
        const gusset_filter *filter = plugin->filter(i);
        shapes made;
        shapes_make(&made, filter, 0, 5);
        check_pointers(filter, &made);
        check_values(filter, &made);
        check_inputs(filter, &made);
        shapes_free(&made);
    }
    return failures == 0 ? 0 : 1;
}

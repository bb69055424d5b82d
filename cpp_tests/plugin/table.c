/* The plugin's table, as a host walks it: table LIBRARY */
#include "loaded.h"

#include <ctype.h>
#include <math.h>
#include <string.h>

static int filled(const char *text) { return text != NULL && text[0] != '\0'; }

/* Lower case, digits and underscores, a letter first: what scripts and stored projects can hold. */
static int is_name(const char *text) {
    if (!filled(text) || !islower((unsigned char)text[0])) {
        return 0;
    }
    for (; *text != '\0'; ++text) {
        if (!islower((unsigned char)*text) && !isdigit((unsigned char)*text) && *text != '_') {
            return 0;
        }
    }
    return 1;
}

static uint32_t arity_of(uint32_t kind) {
    switch (kind) {
    case GUSSET_PARAM_BOOL:
    case GUSSET_PARAM_INT:
    case GUSSET_PARAM_REAL:
    case GUSSET_PARAM_CHOICE:
    case GUSSET_PARAM_LENGTH:
    case GUSSET_PARAM_ANGLE:
        return 1;
    case GUSSET_PARAM_POINT:
    case GUSSET_PARAM_DIRECTION:
        return 3;
    case GUSSET_PARAM_PLANE:
        return 4;
    default:
        return 0;
    }
}

static int is_whole(uint32_t kind) {
    return kind == GUSSET_PARAM_BOOL || kind == GUSSET_PARAM_INT || kind == GUSSET_PARAM_CHOICE;
}

/* Whether a parameter of the filter takes these values. */
static int accepts(const gusset_param_info *param, const double *values) {
    for (uint32_t k = 0; k < param->arity; ++k) {
        if (!(values[k] >= param->min && values[k] <= param->max) ||
            (is_whole(param->kind) && floor(values[k]) != values[k])) {
            return 0;
        }
    }
    const int directed = param->kind == GUSSET_PARAM_DIRECTION || param->kind == GUSSET_PARAM_PLANE;
    return !directed || values[0] != 0 || values[1] != 0 || values[2] != 0;
}

static void check_choices(const char *of, const gusset_param_info *param) {
    CHECK_OF(of, param->min == 0 && param->max == param->choice_count - 1.0 && param->choice_count > 1);
    for (uint32_t c = 0; c < param->choice_count; ++c) {
        CHECK_OF(of, filled(param->choices[c].label) && filled(param->choices[c].help));
        for (uint32_t d = 0; d < c; ++d) {
            CHECK_OF(of, strcmp(param->choices[c].label, param->choices[d].label) != 0);
        }
    }
}

static void check_params(const gusset_filter *filter) {
    uint32_t next = 0;
    for (uint32_t i = 0; i < filter->param_count; ++i) {
        const gusset_param_info *param = filter->param(filter, i);
        char of[200];
        if (param == NULL) {
            CHECK_OF(filter->id, param != NULL);
            return;
        }
        snprintf(of, sizeof of, "%s.%s", filter->id, filled(param->id) ? param->id : "?");
        CHECK_OF(of, param->struct_size >= sizeof *param);
        CHECK_OF(of, is_name(param->id) && filled(param->label) && filled(param->help));
        CHECK_OF(of, param->arity > 0 && param->arity == arity_of(param->kind));
        CHECK_OF(of, param->first_value == next);
        next += param->arity;
        CHECK_OF(of, isfinite(param->min) && isfinite(param->max) && param->min < param->max);
        CHECK_OF(of, param->step >= 0 && isfinite(param->step));
        CHECK_OF(of, param->default_values != NULL && accepts(param, param->default_values));
        CHECK_OF(of, (param->choices != NULL) == (param->kind == GUSSET_PARAM_CHOICE));
        CHECK_OF(of, param->kind != GUSSET_PARAM_BOOL || (param->min == 0 && param->max == 1));
        if (param->kind == GUSSET_PARAM_CHOICE) {
            check_choices(of, param);
        } else {
            CHECK_OF(of, param->choice_count == 0);
        }
        for (uint32_t j = 0; j < i; ++j) {
            const gusset_param_info *other = filter->param(filter, j);
            CHECK_OF(of, other != NULL && strcmp(other->id, param->id) != 0 && strcmp(other->label, param->label) != 0);
        }
    }
    CHECK_OF(filter->id, next == filter->value_count);
    CHECK_OF(filter->id, filter->param(filter, filter->param_count) == NULL);
    CHECK_OF(filter->id, filter->param(filter, UINT32_MAX) == NULL);
}

static void check_kinds(const gusset_filter *filter) {
    CHECK_OF(filter->id, filter->min_inputs <= filter->max_inputs);
    CHECK_OF(filter->id, (filter->input_kind_count == 0) == (filter->max_inputs == 0));
    for (uint32_t i = 0; i < filter->input_kind_count; ++i) {
        CHECK_OF(filter->id,
                 filter->input_kinds[i] == GUSSET_KIND_MESH || filter->input_kinds[i] == GUSSET_KIND_CURVES);
    }
    CHECK_OF(filter->id, filter->output_count > 0);
    for (uint32_t i = 0; i < filter->output_count; ++i) {
        CHECK_OF(filter->id,
                 filter->output_kinds[i] >= GUSSET_KIND_MESH && filter->output_kinds[i] <= GUSSET_KIND_TEXT);
    }
    CHECK_OF(filter->id, (filter->flags & ~(uint32_t)(GUSSET_FILTER_REPLACES | GUSSET_FILTER_ORIGINS)) == 0);
    if (filter->flags & GUSSET_FILTER_REPLACES) {
        CHECK_OF(filter->id, filter->min_inputs > 0 && filter->input_kinds[0] == filter->output_kinds[0]);
    }
}

/* Suggested values for shapes are in range. For inputs of a wrong kind, the defaults remain. */
static void check_suggest(const gusset_filter *filter) {
    double values[100] = {0};
    shapes made;
    CHECK_OF(filter->id, filter->value_count <= 100);
    for (uint32_t number = 0; number < TRIES; ++number) {
        shapes_make(&made, filter, number, 6);
        CHECK_OF(filter->id, filter->suggest(filter, made.inputs, made.count, values) == GUSSET_PLUGIN_DONE);
        for (uint32_t i = 0; i < filter->param_count; ++i) {
            const gusset_param_info *param = filter->param(filter, i);
            CHECK_OF(param->id, accepts(param, values + param->first_value));
        }
        shapes_free(&made);
    }
    memset(values, 0xff, sizeof values);
    CHECK_OF(filter->id, filter->suggest(filter, NULL, UINT32_MAX, values) != GUSSET_PLUGIN_DONE);
    for (uint32_t i = 0; i < filter->param_count; ++i) {
        const gusset_param_info *param = filter->param(filter, i);
        CHECK_OF(param->id,
                 memcmp(values + param->first_value, param->default_values, param->arity * sizeof(double)) == 0);
    }
}

int main(int argc, char **argv) {
    if (argc != 2) {
        return 2;
    }
    void *library = open_library(argv[1]);
    const gusset_plugin_entry_fn entry = entry_of(library);
    const gusset_plugin *plugin = entry(GUSSET_PLUGIN_ABI);
    CHECK(entry(0) == NULL && entry(GUSSET_PLUGIN_ABI + 1) == NULL && entry(UINT32_MAX) == NULL);
    CHECK(plugin != NULL && entry(GUSSET_PLUGIN_ABI) == plugin);
    if (plugin == NULL) {
        return 1;
    }
    CHECK(plugin->struct_size >= sizeof *plugin && plugin->abi == GUSSET_PLUGIN_ABI && plugin->filter_count > 0);
    CHECK(is_name(plugin->id) && filled(plugin->name) && filled(plugin->vendor) && filled(plugin->description));
    CHECK(filled(plugin->license));
    unsigned parts[3];
    char rest;
    CHECK(sscanf(plugin->version, "%u.%u.%u%c", &parts[0], &parts[1], &parts[2], &rest) == 3);
    CHECK(plugin->filter(plugin->filter_count) == NULL && plugin->filter(UINT32_MAX) == NULL);
    CHECK(plugin->find(NULL) == NULL && plugin->find("") == NULL && plugin->find("no such filter") == NULL);
    const gusset_plugin_values *values = plugin->extension("values/1");
    CHECK(values != NULL && values->struct_size == sizeof *values);
    const gusset_plugin_attributes *attributes = plugin->extension("attributes/1");
    CHECK(attributes != NULL && attributes->struct_size == sizeof *attributes);
    CHECK(plugin->extension(NULL) == NULL && plugin->extension("") == NULL && plugin->extension("nothing/1") == NULL);

    for (uint32_t i = 0; i < plugin->filter_count; ++i) {
        const gusset_filter *filter = plugin->filter(i);
        if (filter == NULL) {
            CHECK(filter != NULL);
            break;
        }
        CHECK_OF(filter->id, filter->struct_size >= sizeof *filter && filter->reserved == 0);
        CHECK_OF(filter->id, is_name(filter->id) && is_name(filter->script_name));
        CHECK_OF(filter->id,
                 filled(filter->name) && filled(filter->category) && filled(filter->help) && filled(filter->reference));
        CHECK_OF(filter->id, plugin->find(filter->id) == filter && plugin->filter(i) == filter);
        for (uint32_t j = 0; j < i; ++j) {
            const gusset_filter *other = plugin->filter(j);
            CHECK_OF(filter->id, strcmp(other->id, filter->id) != 0 && strcmp(other->name, filter->name) != 0);
            CHECK_OF(filter->id, strcmp(other->script_name, filter->script_name) != 0);
        }
        check_kinds(filter);
        check_params(filter);
        check_suggest(filter);
    }
    printf("%u filters\n", plugin->filter_count);
    return failures == 0 ? 0 : 1;
}

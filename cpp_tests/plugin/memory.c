/* Every filter where memory runs out: each of its allocations fails in turn, alone and with all after it, or as many of them as
 * TORTURE_ALLOCATIONS says. The run says so or does without, leaves nothing behind, and the next one gives the same as the first.
 *     memory LIBRARY */
#include "../torture/memory.h"
#include "loaded.h"

#include <limits.h>
#include <stdlib.h>

enum { SIZE = 8 };

static const gusset_plugin *plugin;
static size_t refused, resolved;

/* A run with allocations `first` to `last` failing; how many were asked for in `requests`. */
static gusset_outputs *run(const gusset_filter *filter, const shapes *made, long long first, long long last,
                           long long *requests, int32_t *status) {
    gusset_host host = {0};
    gusset_outputs *outputs = NULL;
    host.struct_size = sizeof host;
    host.threads = 2;
    host.origins = 1;
    atomic_store(&memory_requests, 0);
    atomic_store(&memory_last, last);
    atomic_store(&memory_first, first);
    *status = filter->run(filter, &host, made->inputs, made->count, NULL, 0, &outputs);
    atomic_store(&memory_first, 0);
    *requests = atomic_load(&memory_requests);
    return outputs;
}

static void check_failure(const char *of, const gusset_outputs *outputs) {
    gusset_failure failure = {0};
    failure.struct_size = sizeof failure;
    if (outputs == NULL) {
        return; /* Then there was no memory for an account of it. */
    }
    CHECK_OF(of, plugin->output_count(outputs) == 0);
    CHECK_OF(of, plugin->output_failure(outputs, &failure) == GUSSET_PLUGIN_DONE);
    CHECK_OF(of, failure.status == GUSSET_PLUGIN_OUT_OF_MEMORY && failure.message != NULL && failure.message[0] != '\0');
}

static void check_filter(const gusset_filter *filter, const shapes *made, const gusset_outputs *expected, long long most) {
    long long all, requests;
    int32_t status;
    /* The first run allocates the memory that is kept for all runs. */
    plugin->output_free(run(filter, made, 0, 0, &all, &status));
    const long long step = all > most ? all / most + 1 : 1;
    for (long long nth = 1; nth <= all; nth += step) {
        for (int after = 0; after < 2; ++after) {
            const long long live = atomic_load(&memory_live);
            gusset_outputs *outputs = run(filter, made, nth, after ? LLONG_MAX : nth, &requests, &status);
            CHECK_OF(filter->id, status == GUSSET_PLUGIN_DONE || status == GUSSET_PLUGIN_OUT_OF_MEMORY);
            if (status == GUSSET_PLUGIN_DONE) {
                CHECK_OF(filter->id, same_outputs(plugin, expected, plugin, outputs));
                ++resolved;
            } else {
                check_failure(filter->id, outputs);
                ++refused;
            }
            plugin->output_free(outputs);
            CHECK_OF(filter->id, atomic_load(&memory_live) == live);
        }
    }
    gusset_outputs *again = run(filter, made, 0, 0, &requests, &status);
    CHECK_OF(filter->id, status == GUSSET_PLUGIN_DONE && same_outputs(plugin, expected, plugin, again));
    plugin->output_free(again);
}

int main(int argc, char **argv) {
    if (argc != 2) {
        return 2;
    }
    const char *given = getenv("TORTURE_ALLOCATIONS");
    const long long most = given != NULL ? atoll(given) : 40;
    plugin = entry_of(open_library(argv[1]))(GUSSET_PLUGIN_ABI);
    if (plugin == NULL || most <= 0) {
        return 1;
    }
    for (uint32_t i = 0; i < plugin->filter_count; ++i) {
        const gusset_filter *filter = plugin->filter(i);
        shapes made;
        gusset_outputs *outputs = run_on_shapes(plugin, filter, NULL, SIZE, &made);
        if (outputs == NULL) {
            continue;
        }
        check_filter(filter, &made, outputs, most);
        plugin->output_free(outputs);
        shapes_free(&made);
    }
    printf("%zu runs without memory said so, %zu did without\n", refused, resolved);
    return failures == 0 && refused > 0 ? 0 : 1;
}

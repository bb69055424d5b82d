/* Two copies of the plugin in one program, at work at the same time: copies LIBRARY COPY [SIZE], of shapes of this size, 10 unless told */
#include "loaded.h"

#include <pthread.h>
#include <stdlib.h>

enum { MOST_FILTERS = 200 };

static uint32_t shape_size = 10;

/* The results of one copy, filter by filter. */
typedef struct work {
    const gusset_plugin *plugin;
    gusset_outputs *outputs[MOST_FILTERS];
    int failures;
} work;

static void *run_all(void *user) {
    work *mine = user;
    for (uint32_t i = 0; i < mine->plugin->filter_count; ++i) {
        const gusset_filter *filter = mine->plugin->filter(i);
        for (uint32_t number = 0; number < TRIES && mine->outputs[i] == NULL; ++number) {
            shapes made;
            shapes_make(&made, filter, number, shape_size);
            if (filter->run(filter, NULL, made.inputs, made.count, NULL, 0, &mine->outputs[i]) != GUSSET_PLUGIN_DONE) {
                mine->plugin->output_free(mine->outputs[i]);
                mine->outputs[i] = NULL;
            }
            shapes_free(&made);
        }
        mine->failures += mine->outputs[i] == NULL;
    }
    return NULL;
}

int main(int argc, char **argv) {
    if (argc != 3 && argc != 4) {
        return 2;
    }
    shape_size = argc == 4 ? (uint32_t)atoi(argv[3]) : shape_size;
    static work works[2];
    pthread_t threads[2];
    void *libraries[2];
    gusset_plugin_entry_fn entries[2];
    for (int k = 0; k < 2; ++k) {
        libraries[k] = open_library(argv[1 + k]);
        entries[k] = entry_of(libraries[k]);
        works[k].plugin = entries[k](GUSSET_PLUGIN_ABI);
        if (works[k].plugin == NULL) {
            return 1;
        }
    }
    /* They share nothing. */
    CHECK(libraries[0] != libraries[1] && entries[0] != entries[1] && works[0].plugin != works[1].plugin);
    const gusset_filter *theirs = works[1].plugin->filter(0);
    CHECK(theirs != works[0].plugin->filter(0));
    gusset_outputs *refused = NULL;
    CHECK(works[0].plugin->filter(0)->run(theirs, NULL, NULL, 0, NULL, 0, &refused) != GUSSET_PLUGIN_DONE);
    works[0].plugin->output_free(refused);
    CHECK(works[0].plugin->filter_count == works[1].plugin->filter_count &&
          works[0].plugin->filter_count <= MOST_FILTERS);
    if (failures != 0) {
        return 1;
    }
    for (int k = 0; k < 2; ++k) {
        if (pthread_create(&threads[k], NULL, run_all, &works[k]) != 0) {
            return 2;
        }
    }
    for (int k = 0; k < 2; ++k) {
        CHECK(pthread_join(threads[k], NULL) == 0);
        CHECK(works[k].failures == 0);
    }
    for (uint32_t i = 0; i < works[0].plugin->filter_count; ++i) {
        const char *id = works[0].plugin->filter(i)->id;
        CHECK_OF(id, same_outputs(works[0].plugin, works[0].outputs[i], works[1].plugin, works[1].outputs[i]));
        works[0].plugin->output_free(works[0].outputs[i]);
        works[1].plugin->output_free(works[1].outputs[i]);
    }
    return failures == 0 ? 0 : 1;
}

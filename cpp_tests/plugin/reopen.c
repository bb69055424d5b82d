/* Threads that open the plugin, run it, close it and end: reopen LIBRARY [TIMES], by default 100 times on one thread */
#include "loaded.h"

#include <dlfcn.h>
#include <pthread.h>
#include <stdlib.h>

enum { REOPENED = 100, THREADS = 20 };

static const char *path;
/* The tables of its first life. */
static const gusset_plugin *first;

static int is_loaded(void) {
    void *library = dlopen(path, RTLD_NOW | RTLD_NOLOAD);
    return library != NULL && dlclose(library) == 0;
}

/* One life of the library: two threads of its own come and go, and something of the caller's thread is kept for its
 * end. */
static void open_run_close(void) {
    void *library = open_library(path);
    const gusset_plugin *plugin = entry_of(library)(GUSSET_PLUGIN_ABI);
    if (plugin == NULL) {
        exit(1);
    }
    gusset_host host = {0};
    host.struct_size = sizeof host;
    host.threads = 2;
    for (uint32_t i = 0; i < plugin->filter_count; i += 3) {
        const gusset_filter *filter = plugin->filter(i);
        shapes made;
        gusset_outputs *outputs = run_on_shapes(plugin, filter, &host, 4, &made);
        CHECK_OF(filter->id, plugin->output_count(outputs) == filter->output_count);
        plugin->output_free(outputs);
        if (outputs != NULL) {
            shapes_free(&made);
        }
    }
    CHECK(dlclose(library) == 0);
    /* It stays where it is all the same, and so do its tables. */
    CHECK(first == NULL || first == plugin);
    first = plugin;
    CHECK(is_loaded() && first->filter(0) != NULL && first->find(first->filter(0)->id) == first->filter(0));
}

static void *again_and_again(void *count) {
    for (int i = 0; i < *(const int *)count; ++i) {
        open_run_close();
    }
    return NULL;
}

static void on_a_thread(int count) {
    pthread_t thread;
    if (pthread_create(&thread, NULL, again_and_again, &count) != 0) {
        exit(2);
    }
    /* The thread ends after the library was closed, and runs its destructors then. */
    CHECK(pthread_join(thread, NULL) == 0);
}

int main(int argc, char **argv) {
    if (argc != 2 && argc != 3) {
        return 2;
    }
    path = argv[1];
    int reopened = argc == 3 ? atoi(argv[2]) : REOPENED;
    CHECK(!is_loaded());
    on_a_thread(reopened);
    for (int i = 0; i < THREADS && i < reopened; ++i) {
        on_a_thread(1);
    }
    open_run_close();
    return failures == 0 ? 0 : 1;
}

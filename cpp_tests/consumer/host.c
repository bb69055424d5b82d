/* Opens a plugin, runs it in a thread and closes it before the thread ends, as hosts do; several times. The Rust
   runtime clears its data of a thread when the thread ends. The plugin must still be mapped then. */
#include <dlfcn.h>
#include <pthread.h>
#include <stdio.h>

typedef int run_function(void);

static void *open_run_close(void *path) {
    void *plugin = dlopen((const char *)path, RTLD_NOW | RTLD_LOCAL);
    void *symbol = plugin ? dlsym(plugin, "plugin_run") : NULL;
    run_function *run;
    int loops;
    if (!symbol) {
        fprintf(stderr, "%s\n", dlerror());
        return path;
    }
    *(void **)&run = symbol;
    loops = run();
    return dlclose(plugin) == 0 && loops == 1 ? NULL : path;
}

int main(int argc, char **argv) {
    void *plugin;
    int round;
    if (argc != 2) {
        return 2;
    }
    for (round = 0; round < 10; ++round) {
        pthread_t thread;
        void *failed = NULL;
        if (pthread_create(&thread, NULL, open_run_close, argv[1]) != 0 || pthread_join(thread, &failed) != 0 || failed) {
            return 1;
        }
    }
    /* No thread holds it any more. */
    plugin = dlopen(argv[1], RTLD_NOW | RTLD_LOCAL);
    if (!plugin || dlclose(plugin) != 0 || !dlopen(argv[1], RTLD_NOW | RTLD_NOLOAD)) {
        fprintf(stderr, "the plugin was unmapped\n");
        return 1;
    }
    return 0;
}

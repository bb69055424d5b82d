/* Shared by the tests of the plugin: checks that count failures, the plugin loaded by its path, and a first run of
   any filter.
 */
#ifndef LOADED_H
#define LOADED_H

#include "shapes.h"

#include <gusset_plugin.h>
#include <stdio.h>

extern int failures;

#define CHECK(condition)                                                                                               \
    do {                                                                                                               \
        if (!(condition)) {                                                                                            \
            printf("%s:%d: %s\n", __FILE__, __LINE__, #condition);                                                     \
            ++failures;                                                                                                \
        }                                                                                                              \
    } while (0)

/* The same, said of one filter, or of whatever `of` names. */
#define CHECK_OF(of, condition)                                                                                        \
    do {                                                                                                               \
        if (!(condition)) {                                                                                            \
            printf("%s:%d: %s: %s\n", __FILE__, __LINE__, (of), #condition);                                           \
            ++failures;                                                                                                \
        }                                                                                                              \
    } while (0)

/* dlopen and the one symbol; prints why and ends the program if that fails. */
void *open_library(const char *path);
gusset_plugin_entry_fn entry_of(void *library);

/* Runs the filter on the first of the shapes of this size that it takes, with the values that it suggests for them.
 * Returns that try's shapes in `made` and what came out; NULL, and a failure counted, if it takes none. */
gusset_outputs *run_on_shapes(const gusset_plugin *plugin, const gusset_filter *filter, const gusset_host *host,
                              uint32_t size, shapes *made);

/* Whether two runs left the same bytes. Each is asked through its own plugin's functions. */
int same_outputs(const gusset_plugin *a, const gusset_outputs *of_a, const gusset_plugin *b,
                 const gusset_outputs *of_b);

#endif

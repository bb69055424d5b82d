/* An example of the reference in many threads at once, and then once more alone: each checks its own answers. Afterwards the process is
 * as it was, and the thread of each caller has its own floating-point mode and mask of signals back.
 *     together NAME */
#include "process_state.h"
#include "programs.h"

#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>

enum { THREADS = 6 };

static program_main *example_main;

static void *run(void *failed) {
    const process_state before = process_state_now();
    *(int *)failed = example_main();
    const process_state after = process_state_now();
    *(int *)failed += before.rounding != after.rounding || before.control_word != after.control_word ||
                      before.signal_mask != after.signal_mask;
    return NULL;
}

int main(int argc, char **argv) {
    example_main = argc == 2 ? find_program(argv[1]) : NULL;
    if (example_main == NULL) return 2;
    pthread_t threads[THREADS];
    int failed[THREADS], failures = 0;
    /* A first thread makes the C library keep memory, which is not a leak of gusset. */
    if (pthread_create(&threads[0], NULL, run, &failed[0]) != 0 || pthread_join(threads[0], NULL) != 0) return 2;
    const process_state before = process_state_now();
    for (int i = 0; i < THREADS; ++i)
        if (pthread_create(&threads[i], NULL, run, &failed[i]) != 0) return 2;
    for (int i = 0; i < THREADS; ++i) {
        pthread_join(threads[i], NULL);
        failures += failed[i];
    }
    failures += example_main();
    const process_state after = process_state_now();
    failures += process_state_changed(&before, &after);
    return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

/* Runs files of add_programs one after another: NAME [ARGUMENT...] [-- NAME [ARGUMENT...]]...
 * Returns the number of failures, or 99 if a file does not exist. */
#include "programs.h"

#include <stdio.h>

int main(int argc, char **argv) {
    int first = 1, failed = 0;
    if (argc < 2) return 99;
    while (first < argc) {
        program_main *const run = find_program(argv[first]);
        int end = first, status;
        while (end < argc && strcmp(argv[end], "--") != 0) ++end;
        if (run == NULL) {
            fprintf(stderr, "no file of the name %s\n", argv[first]);
            return 99;
        }
#ifdef PROGRAMS_TAKE_ARGUMENTS
        {
            char *const separator = argv[end];
            argv[end] = NULL;
            status = run(end - first, argv + first);
            argv[end] = separator;
        }
#else
        status = run();
#endif
        if (status != 0) {
            fprintf(stderr, "%s returns %d\n", argv[first], status);
            ++failed;
        }
        first = end + 1;
    }
    return failed;
}

/* The mains of the files that add_programs compiles, by the names of the files. */
#ifndef PROGRAMS_H
#define PROGRAMS_H

#include <string.h>

#ifdef PROGRAMS_TAKE_ARGUMENTS
typedef int program_main(int argc, char **argv);
#define PROGRAM(name) int name##_main(int argc, char **argv);
#else
typedef int program_main(void);
#define PROGRAM(name) int name##_main(void);
#endif
#include "programs.inc"
#undef PROGRAM

/* Returns the main of the file of this name, or NULL. */
static inline program_main *find_program(const char *name) {
#define PROGRAM(file)                                                                                                  \
    if (strcmp(name, #file) == 0) return file##_main;
#include "programs.inc"
#undef PROGRAM
    return NULL;
}

#endif

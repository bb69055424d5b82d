/* Shared by the examples of the reference: calls that must succeed, facts that must hold, and a first mesh. */
#ifndef EXAMPLE_H
#define EXAMPLE_H

#include <gusset.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Ends the program if the call fails. */
#define MUST(call)                                                                                                     \
    do {                                                                                                               \
        const gusset_status status_ = (call);                                                                          \
        if (status_ != GUSSET_OK) {                                                                                    \
            fprintf(stderr, "%s:%d: %s: %s\n", __FILE__, __LINE__, #call, gusset_status_text(status_));                \
            exit(1);                                                                                                   \
        }                                                                                                              \
    } while (0)

/* Ends the program if something that the example says is not so. */
#define HOLDS(fact)                                                                                                    \
    do {                                                                                                               \
        if (!(fact)) {                                                                                                 \
            fprintf(stderr, "%s:%d: not so: %s\n", __FILE__, __LINE__, #fact);                                         \
            exit(1);                                                                                                   \
        }                                                                                                              \
    } while (0)

static const double pi = 3.14159265358979323846;

/* Whether two numbers are equal except for rounding. */
static inline int about(double a, double b) {
    return fabs(a - b) <= 1e-9 * (1.0 + fabs(a) + fabs(b));
}

#endif

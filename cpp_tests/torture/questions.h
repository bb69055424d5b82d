/* Which functions ask the host whether to continue.
 *
 * A cancel stops only a call that asks: the call runs the progress callback, and looks for a cancel. A function that takes a context
 * must ask in at least one of its calls if its work grows with its input. A function may be silent if its documented complexity is
 * exactly O(1), or if the list below names it. */
#ifndef TORTURE_QUESTIONS_H
#define TORTURE_QUESTIONS_H

#include <stddef.h>
#include <stdio.h>
#include <string.h>

/* The promise of a function: it takes no context, its work is O(1), or it asks the host. */
enum torture_promise { TORTURE_NO_CONTEXT, TORTURE_CONSTANT, TORTURE_ASKS };

/* A function that the program calls; its successful calls, and the questions that all its calls asked. */
struct torture_questions {
    const char *function;
    enum torture_promise promise;
    size_t successes, asked;
};

#define TORTURE_MAX_FUNCTIONS 512

#define TORTURE_IN_PLACE "changes the caller's net or scene in place, and cannot stop half way"
#define TORTURE_ONE_PASS "copies or reads its input once, at the speed of memory"

/* The functions that do not ask although their work grows with the input, each with its reason. */
static const struct { const char *function, *reason; } torture_silent[] = {
    {"gusset_net_clear_no_data", TORTURE_IN_PLACE},
    {"gusset_net_unglue", TORTURE_IN_PLACE},
    {"gusset_net_set_bridge", TORTURE_IN_PLACE},
    {"gusset_scene_add", TORTURE_IN_PLACE},
    {"gusset_scene_set_entry", TORTURE_IN_PLACE},
    {"gusset_scene_add_child", TORTURE_IN_PLACE},
    {"gusset_scene_remove_child", TORTURE_IN_PLACE},
    {"gusset_scene_remove", TORTURE_IN_PLACE},
    {"gusset_scene_get_children", TORTURE_ONE_PASS},
    {"gusset_net_edit", TORTURE_ONE_PASS},
    {"gusset_sheet_from_patches_create", TORTURE_ONE_PASS},
    {"gusset_sheet_mask_elements", TORTURE_ONE_PASS},
    {"gusset_stream_decoder_push", "the caller chooses how many bytes it pushes at once"},
};

static inline const char *torture_reason(const char *function) {
    for (size_t i = 0; i < sizeof torture_silent / sizeof *torture_silent; ++i)
        if (strcmp(torture_silent[i].function, function) == 0) return torture_silent[i].reason;
    return NULL;
}

/* The row of a function, which is made if it is new; NULL if the table is full. */
static inline struct torture_questions *torture_row(struct torture_questions *table, const char *function, enum torture_promise promise) {
    for (size_t i = 0; i < TORTURE_MAX_FUNCTIONS; ++i) {
        struct torture_questions *const row = &table[i];
        if (!row->function) row->function = function, row->promise = promise;
        if (strcmp(row->function, function) == 0) return row;
    }
    return NULL;
}

/* Prints each function that breaks its promise, and each listed function that asks. Returns their number. */
static inline size_t torture_unheard(const struct torture_questions *table) {
    size_t failures = 0, asked = 0, silent = 0;
    for (size_t i = 0; i < TORTURE_MAX_FUNCTIONS && table[i].function; ++i) {
        const struct torture_questions *const row = &table[i];
        const char *const reason = torture_reason(row->function);
        asked += row->asked > 0, silent += row->successes > 0 && row->asked == 0 && reason;
        if (row->promise == TORTURE_ASKS && row->successes > 0 && row->asked == 0 && !reason) {
            printf("%s: never asks the host whether to continue\n", row->function);
            ++failures;
        }
        if (reason && row->asked > 0) {
            printf("%s: asks the host, although questions.h lists it as silent\n", row->function);
            ++failures;
        }
    }
    printf("%zu functions ask the host whether to continue, %zu are silent for the reasons in questions.h\n", asked, silent);
    return failures;
}

#endif

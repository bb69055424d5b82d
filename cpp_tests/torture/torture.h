/* What the wrappers of wrappers.py do: hostile values one after another, and what must hold after each call.
 *
 * A call is tried in a process of its own, so that what it changes, and how it dies, touches nobody. Which value is in force stands in
 * memory that both share: when the process dies or does not come back, the parent names the value and goes on after it. */
#ifndef TORTURE_H
#define TORTURE_H

#include "hostile.h"
#include "memory.h"
#include "questions.h"

#include <gusset.h>
#include <limits.h>
#include <pthread.h>
#include <signal.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

/* No handle that the library makes. */
#define TORTURE_UNTOUCHED ((uintptr_t)0xDEAD)
/* Of processor time, which a machine that is busy with other things does not matter to: when a call that goes on is cancelled, and
 * when it should have heard that. */
#define TORTURE_PATIENCE 4
/* Under the address sanitizer, with the library hardly optimised, all takes several times as long. */
#ifdef __SANITIZE_ADDRESS__
#define TORTURE_SECONDS 60
#else
#define TORTURE_SECONDS 6
#endif
/* The status of a process after which another one goes on. */
#define TORTURE_AGAIN 3

/* What is tried, one after another: hostile arguments; a cancel at each step; allocations that fail, each alone and with all after it,
 * or as many of them as TORTURE_ALLOCATIONS says. With TORTURE_FROM=2 only the latter. After each failure the call is made again with the
 * same context, and must give what it gave before. What changes a handle, or keeps something in one, is tried once in
 * each process. */
enum torture_phase { TORTURE_ARGUMENTS, TORTURE_CANCELS, TORTURE_ONE_ALLOCATION, TORTURE_ALL_ALLOCATIONS, TORTURE_PHASES };

struct torture_shared {
    enum torture_phase phase;
    size_t value, calls[TORTURE_PHASES], failures;
    long long allocations;    /* of the call as it is */
    long long kept;           /* the blocks that it leaves in handles */
    int plain;                /* and its status */
    uint64_t result;          /* and its results, with the handle that it changes */
    size_t refused, resolved; /* calls that returned OUT_OF_MEMORY, and that succeeded without an allocation */
    struct torture_questions questions[TORTURE_MAX_FUNCTIONS];
    double slowest;
    char now[360], slow[360];
};

static size_t torture_failures, torture_functions;
static struct torture_shared *torture_told;
static const char *torture_function;
static struct torture_questions *torture_asking;
/* The values in force: their slots and what was there. */
static struct torture_change {
    struct torture_slot *slot;
    unsigned char *before;
} torture_changes[4];
static size_t torture_change_count;
static int torture_begun;
/* When the call began. */
static double torture_began;

static inline void torture_summary(void) {
    const size_t *const calls = torture_told->calls;
    printf("in place of %zu calls %zu with other arguments, %zu cancelled, %zu without memory (%zu said so, %zu did without); "
           "%zu failures; slowest %.2f s: %s\n",
           torture_functions, calls[0], calls[1], calls[2] + calls[3], torture_told->refused, torture_told->resolved,
           torture_failures + torture_told->failures, torture_told->slowest, torture_told->slow);
    torture_failures += torture_unheard(torture_told->questions);
    fflush(stdout);
    if (torture_failures + torture_told->failures) _exit(1);
}

/* The context that calls are given instead of the program's own, so that they can be cancelled and report. */
static gusset_context *torture_context;
/* Ends the process. */
static timer_t torture_end;
/* Whether the function changes nothing that it is given, so that it does the same each time. */
static int torture_pure;

static inline void torture_cancel(int signal) {
    (void)signal;
    (gusset_context_cancel)(torture_context);
    if (torture_alien_context) (gusset_context_cancel)(torture_alien_context);
}

static inline const gusset_context *torture_own_context(void) {
    if (!torture_context && (gusset_context_create)(&torture_context) != GUSSET_OK) abort();
    return torture_context;
}

static inline double torture_clock(void) {
    struct rusage used;
    getrusage(RUSAGE_SELF, &used);
    return (double)(used.ru_utime.tv_sec + used.ru_stime.tv_sec) + 1e-6 * (double)(used.ru_utime.tv_usec + used.ru_stime.tv_usec);
}

static inline size_t torture_limit(const char *name, size_t usual) {
    const char *const given = getenv(name);
    return given ? strtoul(given, NULL, 10) : usual;
}

/* Tries a call in other processes, as many as die. True in those: they list their slots, try them, and leave. */
static inline int torture_enter(const char *function, enum torture_promise promise) {
    if (!torture_told) {
        torture_told = mmap(NULL, sizeof *torture_told, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
        atexit(torture_summary);
    }
    ++torture_functions;
    torture_asking = torture_row(torture_told->questions, function, promise);
    torture_function = function, torture_told->phase = (enum torture_phase)torture_limit("TORTURE_FROM", 0), torture_told->value = 0;
    torture_told->allocations = torture_told->kept = 0;
    for (;;) {
        fflush(NULL);
        const pid_t child = fork();
        if (child == 0) return 1;
        int state = 0;
        waitpid(child, &state, 0);
        if (WIFEXITED(state) && WEXITSTATUS(state) == 0) return 0;
        if (WIFEXITED(state) && WEXITSTATUS(state) == TORTURE_AGAIN) continue;
        printf("%s: %s\n", torture_told->now,
               WIFEXITED(state) ? "ended the process" : WTERMSIG(state) == SIGXCPU ? "went on although it was cancelled" : strsignal(WTERMSIG(state)));
        ++torture_failures;
        ++torture_told->value;
    }
}

static inline void torture_fails(const char *what) {
    printf("%s: %s\n", torture_told->now, what);
    ++torture_told->failures;
}

static inline size_t torture_size(const struct torture_slot *slot) {
    if (slot->kind == TORTURE_POINTS || slot->kind == TORTURE_FLOAT_POINTS)
        return slot->count * slot->dimension * (slot->kind == TORTURE_POINTS ? sizeof(double) : sizeof(float));
    return torture_width(slot->kind);
}

/* Puts the n-th hostile value of a slot in its place, if there is one. */
static inline int torture_put(struct torture_slot *slot, size_t n) {
    unsigned char hostile[8] = {0};
    uint64_t whole = 0;
    struct torture_change *const change = &torture_changes[torture_change_count];
    for (size_t i = 0; i < torture_change_count; ++i)
        if (torture_changes[i].slot == slot) return 0;
    if (!torture_hostile(slot->kind, n, slot->at, hostile)) return 0;
    change->slot = slot, change->before = malloc(torture_size(slot));
    memcpy(change->before, slot->at, torture_size(slot));
    if (slot->count) torture_points_as(slot, n);
    else memcpy(slot->at, hostile, torture_width(slot->kind));
    memcpy(&whole, hostile, torture_width(slot->kind));
    const size_t length = torture_change_count++ ? strlen(torture_told->now) : 0;
    snprintf(torture_told->now + length, sizeof torture_told->now - length, "%s%s%s[%zu] = 0x%llx", length ? "" : torture_function, length ? ", " : ": ",
             slot->path, (size_t)(slot - torture_slots), (unsigned long long)whole);
    return 1;
}

static inline void torture_take_back(void) {
    while (torture_change_count > 0) {
        const struct torture_change *const change = &torture_changes[--torture_change_count];
        memcpy(change->slot->at, change->before, torture_size(change->slot));
        free(change->before);
    }
}

static inline uint64_t torture_random(uint64_t *state) {
    uint64_t z = *state += 0x9E3779B97F4A7C15u;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u, z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
}

/* The value-th of one hostile value at a time; after these, as many times as TORTURE_TOGETHER says, of two or three at once. */
static inline int torture_choose(size_t value) {
    const char *const together = getenv("TORTURE_TOGETHER");
    size_t singles = 0;
    for (size_t k = 0; k < torture_slot_count; ++k) {
        unsigned char hostile[8];
        for (size_t n = 0; torture_hostile(torture_slots[k].kind, n, torture_slots[k].at, hostile); ++n)
            if (singles++ == value) return torture_put(&torture_slots[k], n);
    }
    if (torture_slot_count == 0 || value - singles >= (together ? strtoul(together, NULL, 10) : 0)) return 0;
    uint64_t state = value * 1000003u + torture_functions;
    for (size_t left = 2 + torture_random(&state) % 2; left > 0; --left) {
        const uint64_t slot = torture_random(&state) % torture_slot_count;
        for (size_t n = torture_random(&state) % 16; !torture_put(&torture_slots[slot], n) && n > 0; n /= 2) {}
    }
    return 1;
}

/* Of the call that is tried: the steps that were reported, the last of them, whether one was cancelled, and the blocks in use before it. */
static size_t torture_steps;
static double torture_fraction;
static int torture_fired, torture_falls;
static long long torture_live, torture_bytes, torture_nth;
/* Whether the call is made again after a failure, and as it was left before the failure, what it changes. */
static int torture_repeats, torture_failed;
static uint64_t torture_before;

static inline int torture_step(void *user, double fraction, const char *stage) {
    (void)stage;
    torture_falls |= fraction < torture_fraction, torture_fraction = fraction;
    return torture_fired |= torture_steps++ == *(const size_t *)user;
}

/* The value-th step is cancelled; the last call of the phase is one that ended before. */
static inline int torture_cancel_step(size_t value) {
    static size_t at;
    at = value, torture_steps = 0, torture_fired = 0, torture_fraction = 0, torture_falls = 0;
    snprintf(torture_told->now, sizeof torture_told->now, "%s: cancelled at step %zu", torture_function, value);
    return torture_context && value < torture_limit("TORTURE_CANCELS", 40) &&
           (gusset_context_set_progress)(torture_context, torture_step, &at) == GUSSET_OK;
}

/* No allocation fails at first, which counts them; then each, or if there are many, some. */
static inline int torture_refuse(enum torture_phase phase, size_t value) {
    const long long all = torture_told->allocations, most = (long long)torture_limit("TORTURE_ALLOCATIONS", 12);
    const long long step = most > 1 ? most - 1 : 1;
    const long long nth = value == 0 ? 0 : all <= most ? (long long)value : 1 + (all - 1) * ((long long)value - 1) / step;
    if (!torture_context || (value > 0 && (nth > all || (long long)value > most))) return 0;
    if (!torture_repeats) {
        (gusset_context_destroy)(torture_context);
        torture_context = NULL, torture_live = atomic_load(&memory_live), torture_bytes = atomic_load(&memory_bytes);
        torture_own_context();
        if ((gusset_context_set_threads)(torture_context, 2) != GUSSET_OK) abort();
    }
    snprintf(torture_told->now, sizeof torture_told->now, "%s: allocation %lld of %lld fails%s%s", torture_function, nth, all,
             phase == TORTURE_ALL_ALLOCATIONS ? ", and all after it" : "", torture_repeats ? "; then again" : "");
    torture_nth = torture_repeats ? 0 : nth;
    return 1;
}

/* Right before the call: from now on requests are counted and fail. */
static inline void torture_arm(void) {
    atomic_store(&memory_last, torture_told->phase == TORTURE_ALL_ALLOCATIONS ? LLONG_MAX : torture_nth);
    atomic_store(&memory_requests, 0);
    atomic_store(&memory_first, torture_nth);
}

/* After a call: all as before, and what its time and its memory were. */
static inline void torture_finish(void) {
    const double took = torture_clock() - torture_began;
    struct torture_shared *const told = torture_told;
    told->calls[told->phase] += told->phase < TORTURE_ONE_ALLOCATION || told->value > 0;
    if (took > told->slowest) {
        told->slowest = took;
        memcpy(told->slow, told->now, sizeof told->slow);
    }
    torture_take_back();
    if (told->phase >= TORTURE_ONE_ALLOCATION) {
        torture_repeats = !torture_repeats && torture_failed;
        if (torture_repeats) return;
        (gusset_context_destroy)(torture_context);
        torture_context = NULL;
        const long long blocks = atomic_load(&memory_live) - torture_live, bytes = atomic_load(&memory_bytes) - torture_bytes;
        if (told->phase == TORTURE_ONE_ALLOCATION && told->value == 0) told->kept = blocks;
        if (blocks != told->kept || (told->kept == 0 && torture_pure && bytes != 0)) {
            torture_fails("memory is left");
        }
    }
    if (told->phase == TORTURE_CANCELS && !torture_fired) ++told->phase, told->value = 0;
    else ++told->value;
}

static inline void *torture_nothing(void *nothing) {
    return nothing;
}

/* Starts a thread as the library does: the C library keeps its stack and what it notes of it for the next one. */
static inline void torture_start_thread(void) {
    pthread_attr_t attributes;
    pthread_t thread;
    pthread_attr_init(&attributes);
    pthread_attr_setstacksize(&attributes, (size_t)2 << 20);
    if (pthread_create(&thread, &attributes, torture_nothing, NULL) == 0) pthread_join(thread, NULL);
    pthread_attr_destroy(&attributes);
}

/* Arranges the next call; 0 after the last. */
static inline int torture_next(void) {
    const struct itimerval limit = {{0, 0}, {TORTURE_PATIENCE, 0}};
    /* From now on, as the cancel: a limit of the whole process would be counted by another clock, which goes off on a busy machine. */
    const struct itimerspec end = {{0, 0}, {TORTURE_SECONDS, 0}};
    struct torture_shared *const told = torture_told;
    if (torture_begun) {
        torture_finish();
    } else {
        const struct rlimit core = {0, 0};
#ifndef __SANITIZE_ADDRESS__ /* Its shadow is an eighth of all addresses. */
        const struct rlimit memory = {(rlim_t)8 << 30, (rlim_t)8 << 30};
        setrlimit(RLIMIT_AS, &memory);
#endif
        setrlimit(RLIMIT_CORE, &core);
        struct sigevent event = {.sigev_notify = SIGEV_SIGNAL, .sigev_signo = SIGXCPU};
        if (timer_create(CLOCK_PROCESS_CPUTIME_ID, &event, &torture_end) != 0) abort();
        signal(SIGPROF, torture_cancel);
        torture_start_thread();
    }
    torture_own_context();
    for (; told->phase < TORTURE_PHASES; ++told->phase, told->value = 0) {
        if (told->phase > TORTURE_CANCELS) (gusset_context_set_progress)(torture_context, NULL, NULL);
        if (told->phase > TORTURE_CANCELS && torture_begun && (!torture_pure || told->kept) && !torture_repeats) {
            fflush(NULL);
            _exit(TORTURE_AGAIN);
        }
        (gusset_context_reset)(torture_context);
        if (torture_alien_context) (gusset_context_reset)(torture_alien_context);
        torture_began = torture_clock();
        timer_settime(torture_end, 0, &end, NULL);
        setitimer(ITIMER_PROF, &limit, NULL);
        if (told->phase == TORTURE_ARGUMENTS ? torture_choose(told->value)
            : told->phase == TORTURE_CANCELS ? torture_cancel_step(told->value)
                                             : torture_refuse(told->phase, told->value))
            return torture_begun = 1;
    }
    return 0;
}

/* The status of a call: one that the header names, and what the context says is of that call. */
static inline void torture_check(gusset_status status, const gusset_context *context) {
    gusset_error_report report = {.struct_size = sizeof report};
    struct torture_shared *const told = torture_told;
    const long long requests = atomic_load(&memory_requests);
    const long long asked = atomic_exchange(&memory_first, 0);
    torture_failed = told->phase >= TORTURE_ONE_ALLOCATION && asked > 0 && status != told->plain;
    if (told->phase >= TORTURE_ONE_ALLOCATION && told->value == 0) {
        if (told->phase == TORTURE_ALL_ALLOCATIONS && status != told->plain) torture_fails("not what it was before");
        told->allocations = requests, told->plain = status;
    }
    if (told->phase >= TORTURE_ONE_ALLOCATION && told->value > 0) {
        if (torture_repeats && status != told->plain) torture_fails("not what it was before");
        if (!torture_repeats) ++*(status == told->plain ? &told->resolved : &told->refused);
    }
    if (told->phase == TORTURE_CANCELS && torture_asking) {
        torture_asking->successes += status == GUSSET_OK && !torture_fired;
        torture_asking->asked += torture_steps;
    }
    if (told->phase == TORTURE_CANCELS && torture_steps > 0 && (torture_falls || (status == GUSSET_OK && torture_fraction != 1))) {
        torture_fails("progress decreases, or ends below 1");
    }
    if (status == GUSSET_ERROR_PANIC) torture_fails("a panic");
    if (strcmp((gusset_status_text)(status), "unknown status") == 0) torture_fails("a status that the header does not have");
    if (told->phase == TORTURE_CANCELS && torture_fired && torture_pure && status != GUSSET_ERROR_CANCELLED) torture_fails("the cancel was not heard");
    if (told->phase >= TORTURE_ONE_ALLOCATION && status != told->plain && status != GUSSET_ERROR_OUT_OF_MEMORY)
        torture_fails("another status than that of memory");
    if (status == GUSSET_OK || !context || (gusset_context_get_report)(context, &report) != GUSSET_OK) return;
    if (report.status != status) torture_fails("the report is of another status");
    if (strlen((gusset_context_get_message)(context)) == 0) torture_fails("no message");
}

#include "results.h"

/* Ends the process of a call: nothing of the program's is to run. */
static inline void torture_leave(void) {
    fflush(NULL);
    _exit(0);
}

#endif

#include "process_state.h"

#include <dirent.h>
#include <fenv.h>
#include <locale.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <unistd.h>

extern char **environ;

uint64_t hashed(uint64_t hash, const void *data, size_t size) {
    const unsigned char *const bytes = data;
    for (size_t i = 0; data && i < size; ++i) hash = (hash ^ bytes[i]) * 0x100000001B3u;
    return hash;
}

static uint64_t text(uint64_t hash, const char *of) {
    return of ? hashed(hash, of, strlen(of) + 1) : hash + 1;
}

/* Names in a folder of /proc, in the order of the kernel; with the targets of links, if `targets`. */
static uint64_t entries(const char *path, int targets, uint64_t *count) {
    DIR *const folder = opendir(path);
    uint64_t hash = 0;
    *count = 0;
    if (!folder) return 0;
    for (const struct dirent *entry = readdir(folder); entry; entry = readdir(folder)) {
        char name[300], target[300] = {0};
        snprintf(name, sizeof name, "%.20s/%.200s", path, entry->d_name);
        /* The folder that is read is itself an open file. */
        if (entry->d_name[0] == '.' || (targets && atoi(entry->d_name) == dirfd(folder))) continue;
        if (targets && readlink(name, target, sizeof target - 1) < 0) continue;
        hash = text(text(hash, entry->d_name), target);
        ++*count;
    }
    closedir(folder);
    return hash;
}

/* The mask of new files as the kernel tells it: umask() would have to set another one for a moment, which other threads would see. */
static uint64_t mask_of_new_files(void) {
    char line[200];
    unsigned mask = 0;
    FILE *const status = fopen("/proc/self/status", "r");
    while (status && fgets(line, sizeof line, status) && sscanf(line, "Umask: %o", &mask) != 1) {}
    if (status) fclose(status);
    return mask;
}

process_state process_state_now(void) {
    process_state now = {0};
    char folder[4096];
    uint64_t count = 0;
    for (char **variable = environ; *variable; ++variable) now.environment = text(now.environment, *variable);
    now.locale = text(0, setlocale(LC_ALL, NULL));
    for (int number = 1; number < NSIG; ++number) {
        struct sigaction action;
        memset(&action, 0, sizeof action);
        if (sigaction(number, NULL, &action) != 0) continue;
        now.signals = hashed(now.signals, &action.sa_handler, sizeof action.sa_handler);
        now.signals = hashed(now.signals, &action.sa_flags, sizeof action.sa_flags);
    }
    sigset_t mask;
    sigemptyset(&mask);
    sigprocmask(SIG_SETMASK, NULL, &mask);
    for (int number = 1; number < NSIG; ++number) now.signal_mask = 3 * now.signal_mask + (uint64_t)(sigismember(&mask, number) == 1);
    now.rounding = (uint64_t)fegetround();
#if defined __x86_64__ || defined __i386__
    /* Without the flags of exceptions, which all arithmetic sets: masks, rounding, denormals as zeros. */
    uint16_t x87 = 0;
    __asm__ volatile("fnstcw %0" : "=m"(x87));
    now.control_word = (uint64_t)x87 << 32 | (__builtin_ia32_stmxcsr() & ~0x3Fu);
#endif
    now.descriptors = entries("/proc/self/fd", 1, &count);
    entries("/proc/self/task", 0, &now.threads);
    now.folder = text(0, getcwd(folder, sizeof folder));
    now.file_mask = mask_of_new_files();
    for (int resource = 0; resource < RLIM_NLIMITS; ++resource) {
        struct rlimit limit = {0, 0};
        getrlimit((__rlimit_resource_t)resource, &limit);
        now.limits = hashed(now.limits, &limit, sizeof limit);
    }
    return now;
}

int process_state_changed(const process_state *before, const process_state *after) {
    static const char *const names[] = {"environment", "locale",      "handlers of signals", "mask of signals",
                                        "rounding",    "mode of floating-point arithmetic", "open files", "working folder",
                                        "mask of new files", "limits of resources", "threads"};
    uint64_t was[sizeof names / sizeof *names], is[sizeof names / sizeof *names];
    int changed = 0;
    memcpy(was, before, sizeof was);
    memcpy(is, after, sizeof is);
    for (size_t i = 0; i < sizeof names / sizeof *names; ++i) {
        if (was[i] == is[i]) continue;
        printf("changed: %s\n", names[i]);
        ++changed;
    }
    return changed;
}

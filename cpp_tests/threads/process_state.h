/* The state of the process that a library must leave unchanged. */
#ifndef PROCESS_STATE_H
#define PROCESS_STATE_H

#include <stddef.h>
#include <stdint.h>

typedef struct process_state {
    uint64_t environment, locale, signals, signal_mask, rounding, control_word, descriptors, folder, file_mask, limits, threads;
} process_state;

process_state process_state_now(void);

/* How many of the things above differ; names them on standard output. */
int process_state_changed(const process_state *before, const process_state *after);

/* Extends a hash by some bytes, if any: FNV-1a, G. Fowler, L. C. Noll and K.-P. Vo. */
uint64_t hashed(uint64_t hash, const void *data, size_t size);

#endif

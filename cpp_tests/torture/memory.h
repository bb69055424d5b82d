/* The allocator of a program, of which a given call can fail: the library's allocations go through it, as they are the C library's.
   Under the address sanitizer the allocator is the sanitizer's: no call fails then, and none is counted. */
#ifndef TORTURE_MEMORY_H
#define TORTURE_MEMORY_H

#include <errno.h>
#include <malloc.h>
#include <stdatomic.h>
#include <stddef.h>
#include <stdint.h>

void *__libc_malloc(size_t size);
void *__libc_calloc(size_t count, size_t size);
void *__libc_realloc(void *block, size_t size);
void *__libc_memalign(size_t alignment, size_t size);
void __libc_free(void *block);

/* Blocks and bytes that are in use; requests since they are counted; the first of these that fails (0: none), and the last. */
static atomic_llong memory_live, memory_bytes, memory_requests, memory_first, memory_last;
/* The size of the last request that failed; the least size of requests that are counted and may fail. */
static atomic_size_t memory_refused, memory_least;

/* Whether this request is one that fails. */
static inline int memory_fails(size_t size) {
    if (size < atomic_load(&memory_least)) return 0;
    const long long now = atomic_fetch_add(&memory_requests, 1) + 1, first = atomic_load(&memory_first);
    if (first == 0 || now < first || now > atomic_load(&memory_last)) return 0;
    atomic_store(&memory_refused, size);
    errno = ENOMEM;
    return 1;
}

static inline void *memory_counted(void *block) {
    if (block) {
        atomic_fetch_add(&memory_live, 1);
        atomic_fetch_add(&memory_bytes, (long long)malloc_usable_size(block));
    }
    return block;
}

#ifndef __SANITIZE_ADDRESS__

void *malloc(size_t size) {
    return memory_fails(size) ? NULL : memory_counted(__libc_malloc(size));
}

void *calloc(size_t count, size_t size) {
    return memory_fails(count * size) ? NULL : memory_counted(__libc_calloc(count, size));
}

void *realloc(void *block, size_t size) {
    if (memory_fails(size)) return NULL;
    const long long before = block ? (long long)malloc_usable_size(block) : 0;
    void *const made = __libc_realloc(block, size);
    if (!block) return memory_counted(made);
    if (made) atomic_fetch_add(&memory_bytes, (long long)malloc_usable_size(made) - before);
    return made;
}

void *aligned_alloc(size_t alignment, size_t size) {
    return memory_fails(size) ? NULL : memory_counted(__libc_memalign(alignment, size));
}

int posix_memalign(void **block, size_t alignment, size_t size) {
    void *const made = aligned_alloc(alignment, size);
    if (!made) return ENOMEM;
    *block = made;
    return 0;
}

void free(void *block) {
    if (block) {
        atomic_fetch_sub(&memory_live, 1);
        atomic_fetch_sub(&memory_bytes, (long long)malloc_usable_size(block));
    }
    __libc_free(block);
}

#endif

#endif

/* Slots, which are the numbers, sizes and pointers that a call is given, and the hostile values of each. */
#ifndef TORTURE_HOSTILE_H
#define TORTURE_HOSTILE_H

#include <float.h>
#include <gusset.h>
#include <limits.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

enum torture_kind {
    TORTURE_F64, TORTURE_F32, TORTURE_U32, TORTURE_I32, TORTURE_U64, TORTURE_I64, TORTURE_U8,
    TORTURE_COUNT,       /* elements of an array: what its memory has for certain, or what nothing can have */
    TORTURE_CAPACITY,    /* of an array that is written: less than it has */
    TORTURE_STRIDE,      /* between elements of an array: none, or what nothing can have */
    TORTURE_WIDE,        /* a size that no array has: any */
    TORTURE_OFFSET,      /* where a part of an array begins that has no length of its own: within it, or what nothing can have */
    TORTURE_READ_AS,     /* how an array is read: values without meaning */
    TORTURE_POINTS, TORTURE_FLOAT_POINTS, /* an array of points as a whole */
    TORTURE_STRUCT_SIZE, TORTURE_POINTER,
    TORTURE_BYTES,       /* a pointer of any alignment */
    TORTURE_HANDLE       /* a pointer to what the library made, of which it knows the kind */
};

struct torture_slot {
    enum torture_kind kind;
    void *at;
    size_t count, dimension; /* of points */
    char path[72];
};

static struct torture_slot torture_slots[4096];
static size_t torture_slot_count;
/* A context for arguments that should be NULL, or another context. */
static gusset_context *torture_alien_context;

static inline const char *torture_path(const char *path, const char *name) {
    static char paths[64][72];
    static size_t next;
    char *const made = paths[next++ % 64];
    snprintf(made, 72, "%.34s.%.34s", path, name);
    return made;
}

/* Data that programs may not write can be written in a process of one's own. */
static inline void *torture_writable(const void *data, size_t size) {
    const uintptr_t page = (uintptr_t)sysconf(_SC_PAGESIZE), from = (uintptr_t)data & ~(page - 1);
    mprotect((void *)from, ((uintptr_t)data + size + page - 1 - from) & ~(page - 1), PROT_READ | PROT_WRITE);
    return (void *)(uintptr_t)data;
}

/* A copy of a struct with garbage behind it. */
static inline void *torture_copy(const void *given, size_t size, size_t least) {
    if (!given) return NULL;
    size = size > least ? size : least;
    unsigned char *const copy = malloc(size + 64);
    memcpy(copy, given, size);
    memset(copy + size, 0xAB, 64);
    return copy;
}

static inline void torture_slot(enum torture_kind kind, const void *at, const char *path) {
    if (torture_slot_count == sizeof torture_slots / sizeof *torture_slots) return;
    struct torture_slot *const slot = &torture_slots[torture_slot_count++];
    slot->kind = kind, slot->at = (void *)(uintptr_t)at, slot->count = slot->dimension = 0;
    snprintf(slot->path, sizeof slot->path, "%s", path);
}

static inline size_t torture_width(enum torture_kind kind) {
    switch (kind) {
    case TORTURE_U8: return 1;
    case TORTURE_F32: case TORTURE_U32: case TORTURE_I32: case TORTURE_READ_AS: case TORTURE_OFFSET: return 4;
    default: return 8;
    }
}

/* A packed array of points. */
static inline void torture_points(enum torture_kind kind, const void *array, size_t count, size_t dimension, size_t stride, const char *path) {
    const size_t width = torture_width(kind);
    if (!array || count == 0 || count > 100000 || (stride != 0 && stride != dimension * width)) return;
    torture_writable(array, count * dimension * width);
    torture_slot(kind == TORTURE_F64 ? TORTURE_POINTS : TORTURE_FLOAT_POINTS, array, path);
    torture_slots[torture_slot_count - 1].count = count, torture_slots[torture_slot_count - 1].dimension = dimension;
}

/* Points as a whole, in the n-th way: in one place, on a line, in steps that no grid has, as large and as small as numbers go. */
static inline void torture_points_as(const struct torture_slot *slot, size_t n) {
    static const double scales[] = {1e150, 1e-150, 1e300, 1e-300, 1e-310};
    for (size_t i = 0; i < slot->count * slot->dimension; ++i) {
        double *const real = (double *)slot->at + i;
        float *const single = (float *)slot->at + i;
        const size_t axis = i % slot->dimension;
        const double was = slot->kind == TORTURE_POINTS ? *real : *single;
        const double first = slot->kind == TORTURE_POINTS ? ((double *)slot->at)[axis] : ((float *)slot->at)[axis];
        const double line = slot->kind == TORTURE_POINTS ? real[-(ptrdiff_t)axis] : single[-(ptrdiff_t)axis];
        const double now = n == 0 ? 0.0 : n == 1 ? first : n == 2 ? line : n == 3 ? was + 1e15 : was * scales[n - 4];
        if (slot->kind == TORTURE_POINTS) *real = now;
        else *single = (float)now;
    }
}
#define TORTURE_WAYS 9

/* The first elements of an array. */
static inline void torture_elements(enum torture_kind kind, const void *array, size_t count, const char *path) {
    if (!array) return;
    torture_writable(array, 3 * torture_width(kind));
    for (size_t i = 0; i < count && i < 3; ++i) torture_slot(kind, (const char *)array + i * torture_width(kind), path);
}

/* A context or a scene: at least one of the two has another kind than a function wants. */
static inline void *torture_alien(int which) {
    static gusset_scene *scene;
    if (!torture_alien_context && (gusset_context_create)(&torture_alien_context) != GUSSET_OK) abort();
    if (!scene && (gusset_scene_create)(NULL, &scene) != GUSSET_OK) abort();
    return which ? (void *)scene : (void *)torture_alien_context;
}

/* Writes the n-th hostile value of a kind in place of `was`. Returns 0 after the last value. */
static inline int torture_hostile(enum torture_kind kind, size_t n, const void *was, void *value) {
    static const double reals[] = {NAN, INFINITY, -INFINITY, 0, -0.0, -1, 1, 1e300, -1e300, DBL_MAX, 1e150, 1e-150, 1e-300, 5e-324};
    static const float floats[] = {NAN, INFINITY, -INFINITY, 0, -1, 1, FLT_MAX, -FLT_MAX, FLT_MIN};
    static const uint32_t words[] = {0, 1, INT32_MAX, 0x80000000u, UINT32_MAX - 1, UINT32_MAX};
    static const uint32_t meaningless[] = {UINT32_MAX};
    static const uint32_t offsets[] = {0, 1, 2, UINT32_MAX};
    static const int32_t integers[] = {0, 1, -1, INT32_MIN, INT32_MAX};
    static const uint64_t longs[] = {0, 1, UINT32_MAX, (uint64_t)1 << 32, INT64_MAX, UINT64_MAX};
    static const int64_t signed_longs[] = {0, 1, -1, INT64_MIN, INT64_MAX};
    static const uint8_t bytes[] = {0, 1, 2, 0x80, 0xFF};
    static const size_t impossible[] = {SIZE_MAX, SIZE_MAX - 1, SIZE_MAX / 2, SIZE_MAX / 4 + 2};
    uint64_t whole = 0;
    memcpy(&whole, was, torture_width(kind));
#define TORTURE_FROM(list)                                                                                             \
    if (n >= sizeof list / sizeof *list) return 0;                                                                     \
    memcpy(value, &list[n], sizeof *list);                                                                             \
    return 1
    switch (kind) {
    case TORTURE_F64: TORTURE_FROM(reals);
    case TORTURE_F32: TORTURE_FROM(floats);
    case TORTURE_U32: TORTURE_FROM(words);
    case TORTURE_READ_AS: TORTURE_FROM(meaningless);
    case TORTURE_OFFSET: TORTURE_FROM(offsets);
    case TORTURE_I32: TORTURE_FROM(integers);
    case TORTURE_U64: case TORTURE_WIDE: TORTURE_FROM(longs);
    case TORTURE_I64: TORTURE_FROM(signed_longs);
    case TORTURE_U8: TORTURE_FROM(bytes);
    case TORTURE_COUNT: {
        const uint64_t fewer[] = {0, whole ? 1 : 0, whole ? whole - 1 : 0};
        if (n < 3) return memcpy(value, &fewer[n], 8), 1;
        n -= 3;
        TORTURE_FROM(impossible);
    }
    case TORTURE_CAPACITY: {
        const uint64_t fewer[] = {0, whole ? 1 : 0, whole ? whole - 1 : 0};
        TORTURE_FROM(fewer);
    }
    case TORTURE_STRIDE: {
        static const size_t strides[] = {0, SIZE_MAX, SIZE_MAX - 1, SIZE_MAX / 2};
        TORTURE_FROM(strides);
    }
    case TORTURE_STRUCT_SIZE: {
        const uint64_t sizes[] = {0, 1, 8, whole - 8, whole - 5, whole - 1, whole + 1, whole + 8, whole + 64, SIZE_MAX};
#ifdef __SANITIZE_ADDRESS__ /* What is longer than the program's is read past its end. */
        if (n > 5) return 0;
#endif
        TORTURE_FROM(sizes);
    }
    case TORTURE_POINTER: {
        const uint64_t pointers[] = {0, whole + 1, whole + 4};
        if (n > 0 && !whole) return 0;
#ifdef __SANITIZE_ADDRESS__ /* From a misaligned one as many bytes are read: past the end of what the program has. */
        if (n > 0) return 0;
#endif
        TORTURE_FROM(pointers);
    }
    case TORTURE_HANDLE: {
        const uint64_t pointers[] = {0, whole + 1, whole + 4, (uintptr_t)torture_alien(0), (uintptr_t)torture_alien(1)};
        if (n > 0 && !whole) return 0;
        TORTURE_FROM(pointers);
    }
    case TORTURE_BYTES:
        if (n > 0) return 0;
        return memset(value, 0, 8), 1;
    case TORTURE_POINTS: case TORTURE_FLOAT_POINTS:
        return memcpy(value, &n, 8), n < TORTURE_WAYS;
    }
#undef TORTURE_FROM
    return 0;
}

#endif

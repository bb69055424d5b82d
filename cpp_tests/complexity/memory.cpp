#include "memory.hpp"

#include <malloc.h>

#include <atomic>
#include <cerrno>

// The library's allocations are the C library's, which a program can define itself.
extern "C" {
void *__libc_malloc(std::size_t size);
void *__libc_calloc(std::size_t count, std::size_t size);
void *__libc_realloc(void *block, std::size_t size);
void *__libc_memalign(std::size_t alignment, std::size_t size);
void __libc_free(void *block);
}

namespace {
std::atomic<std::size_t> in_use{0}, most{0};

void *taken(void *block) {
    if (block == nullptr) {
        return nullptr;
    }
    const std::size_t now = in_use += malloc_usable_size(block);
    std::size_t peak = most;
    while (peak < now && !most.compare_exchange_weak(peak, now)) {
    }
    return block;
}
void given(void *block) {
    if (block != nullptr) {
        in_use -= malloc_usable_size(block);
    }
}
} // namespace

extern "C" {
void *malloc(std::size_t size) { return taken(__libc_malloc(size)); }
void *calloc(std::size_t count, std::size_t size) { return taken(__libc_calloc(count, size)); }
void *realloc(void *block, std::size_t size) {
    const std::size_t before = block != nullptr ? malloc_usable_size(block) : 0;
    void *const made = __libc_realloc(block, size);
    if (made != nullptr || size == 0) {
        in_use -= before;
    }
    return taken(made);
}
void *aligned_alloc(std::size_t alignment, std::size_t size) { return taken(__libc_memalign(alignment, size)); }
int posix_memalign(void **block, std::size_t alignment, std::size_t size) {
    void *const made = aligned_alloc(alignment, size);
    if (made == nullptr) {
        return ENOMEM;
    }
    *block = made;
    return 0;
}
void free(void *block) {
    given(block);
    __libc_free(block);
}
}

namespace complexity {

std::size_t memory_in_use() { return in_use; }
std::size_t memory_peak() { return most; }
void memory_reset_peak() { most = in_use.load(); }

} // namespace complexity

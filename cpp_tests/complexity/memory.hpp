// The allocator of the program, which counts the bytes that are in use and their peak.
#ifndef COMPLEXITY_MEMORY_HPP
#define COMPLEXITY_MEMORY_HPP

#include <cstddef>

namespace complexity {

/// Bytes in use, as the callers asked for them.
std::size_t memory_in_use();
/// The most since the last reset.
std::size_t memory_peak();
void memory_reset_peak();

} // namespace complexity

#endif // COMPLEXITY_MEMORY_HPP

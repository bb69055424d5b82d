// Numbers in the bytes of a binary file.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <string_view>

/// The number of type T at this place, of which the caller knows that it is there.
template <class T> T number_at(std::string_view bytes, std::size_t place, bool big_endian = false) {
    char raw[sizeof(T)];
    std::memcpy(raw, bytes.data() + place, sizeof raw);
    if (big_endian) {
        std::reverse(raw, raw + sizeof raw);
    }
    T value;
    std::memcpy(&value, raw, sizeof value);
    return value;
}

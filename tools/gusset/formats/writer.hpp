// Files as they are written: text whose numbers read as the same ones again, or bytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <string>

/// Throws Failure if the file cannot be written, at the latest in `finish`.
class Writer {
public:
    explicit Writer(const std::string &path);

    Writer &operator<<(char c);
    Writer &operator<<(const char *text);
    Writer &operator<<(const std::string &text);
    /// As many digits as it takes to read the same number; NaN is 0.
    Writer &operator<<(double value);
    Writer &operator<<(uint32_t value);

    /// As it is in memory, which is little-endian wherever this is built.
    template <class T> void raw(T value) {
        char bytes[sizeof value];
        std::memcpy(bytes, &value, sizeof value);
        add(bytes, sizeof value);
    }

    void finish();

private:
    void add(const char *bytes, std::size_t count);
    void flush();

    std::string path;
    std::ofstream out;
    std::string waiting;
};

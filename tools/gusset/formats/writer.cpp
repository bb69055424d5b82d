#include "writer.hpp"

#include "../failure.hpp"

#include <charconv>
#include <cmath>

Writer::Writer(const std::string &path_) : path(path_), out(path_, std::ios::binary) {
    if (!out) {
        throw Failure(Exit::file, path + ": it cannot be opened for writing");
    }
}

void Writer::add(const char *bytes, std::size_t count) {
    constexpr std::size_t enough = 1 << 16;
    waiting.append(bytes, count);
    if (waiting.size() > enough) {
        flush();
    }
}

void Writer::flush() {
    out.write(waiting.data(), static_cast<std::streamsize>(waiting.size()));
    waiting.clear();
}

Writer &Writer::operator<<(char c) {
    add(&c, 1);
    return *this;
}

Writer &Writer::operator<<(const char *text) {
    add(text, std::strlen(text));
    return *this;
}

Writer &Writer::operator<<(const std::string &text) {
    add(text.data(), text.size());
    return *this;
}

Writer &Writer::operator<<(double value) {
    char text[32];
    // Without the sign of 0, which some readers take for a word.
    const double shown = std::isnan(value) || value == 0 ? 0 : value;
    add(text, static_cast<std::size_t>(std::to_chars(text, text + sizeof text, shown).ptr - text));
    return *this;
}

Writer &Writer::operator<<(uint32_t value) {
    char text[16];
    add(text, static_cast<std::size_t>(std::to_chars(text, text + sizeof text, value).ptr - text));
    return *this;
}

void Writer::finish() {
    flush();
    if (!out.flush()) {
        throw Failure(Exit::file, path + ": it cannot be written; is there room for it?");
    }
}

#include "scanner.hpp"

#include "../failure.hpp"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace {
bool is_space(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f'; }

/// A word as messages show it: not all of a binary file.
std::string quoted(std::string_view word) {
    constexpr std::size_t most = 40;
    std::string text = "\"";
    for (const char c : word.substr(0, most)) {
        text += c >= ' ' && c <= '~' ? c : '?';
    }
    return text + (word.size() > most ? "...\"" : "\"");
}
} // namespace

std::string load(const std::string &path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream all;
    if (file && file.peek() != std::ifstream::traits_type::eof()) {
        all << file.rdbuf();
    }
    if (!file && !file.eof()) {
        throw Failure(Exit::file, path + ": it cannot be opened for reading");
    }
    return std::move(all).str();
}

std::optional<double> number_in(std::string_view text) {
    const bool plus = text.size() > 1 && text[0] == '+' && text[1] != '-';
    text.remove_prefix(plus ? 1 : 0);
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (end != text.data() + text.size() || text.empty()) {
        return std::nullopt;
    }
    if (error == std::errc::result_out_of_range) {
        // Too small is 0 and too large infinite, which strtod tells apart.
        return std::strtod(std::string(text).c_str(), nullptr);
    }
    return error == std::errc() ? std::optional(value) : std::nullopt;
}

std::vector<std::string_view> words_of(std::string_view text) {
    std::vector<std::string_view> words;
    for (std::size_t place = 0; place < text.size();) {
        if (is_space(text[place]) || text[place] == '\n') {
            ++place;
            continue;
        }
        const std::size_t start = place;
        while (place < text.size() && !is_space(text[place]) && text[place] != '\n') {
            ++place;
        }
        words.push_back(text.substr(start, place - start));
    }
    return words;
}

void Scanner::skip(bool over_lines) {
    for (; place < text.size(); ++place) {
        const char c = text[place];
        if (comment != '\0' && c == comment) {
            place = std::min(text.find('\n', place), text.size());
            if (place == text.size()) {
                return;
            }
            --place;
        } else if (c == '\n') {
            if (!over_lines) {
                return;
            }
            ++lines;
        } else if (!is_space(c)) {
            return;
        }
    }
}

std::string_view Scanner::word() {
    skip(true);
    return word_of_line();
}

std::string_view Scanner::word_of_line() {
    skip(false);
    const std::size_t start = place;
    while (place < text.size() && !is_space(text[place]) && text[place] != '\n' &&
           (comment == '\0' || text[place] != comment)) {
        ++place;
    }
    return text.substr(start, place - start);
}

std::string_view Scanner::rest_of_line() {
    const std::size_t start = place;
    place = std::min(text.find('\n', place), text.size());
    std::string_view rest = text.substr(start, place - start);
    while (!rest.empty() && is_space(rest.back())) {
        rest.remove_suffix(1);
    }
    return rest;
}

bool Scanner::at_end() {
    skip(true);
    return place == text.size();
}

double Scanner::number(const Element &of) {
    const std::string_view found = word();
    if (found.empty()) {
        fail(of, "the file ends there");
    }
    const auto value = number_in(found);
    if (!value) {
        fail(of, quoted(found) + " is no number");
    }
    return *value;
}

std::size_t Scanner::index(const Element &of, std::size_t most) {
    const std::string_view found = word();
    if (found.empty()) {
        fail(of, "the file ends there");
    }
    std::size_t value = 0;
    const auto [end, error] = std::from_chars(found.data(), found.data() + found.size(), value);
    if (error == std::errc::invalid_argument || end != found.data() + found.size()) {
        fail(of, quoted(found) + " is no whole number from 0 on");
    }
    if (error != std::errc() || value > most) {
        fail(of, std::string(found) + " is more than " + std::to_string(most));
    }
    return value;
}

void Scanner::fail(const std::string &why) const {
    throw Failure(Exit::file, path + ':' + std::to_string(lines) + ": " + why);
}

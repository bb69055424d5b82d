// Files of text as words and numbers, and where they stand, so that whatever is wrong can be pointed at.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// All of a file. Throws Failure.
std::string load(const std::string &path);

/// Exactly this number, with or without a plus; nothing if the text is none.
std::optional<double> number_in(std::string_view text);

/// The words of a line or of any text.
std::vector<std::string_view> words_of(std::string_view text);

/// What is being read, for messages: vertex 3 is "vertex number 3 from 0".
struct Element {
    const char *name;
    std::size_t index;
    std::string text() const { return std::string(name) + " number " + std::to_string(index) + " from 0"; }
};

/// Reads word by word. From `comment` to the end of its line nothing counts.
class Scanner {
public:
    Scanner(std::string path_, std::string_view text_, char comment_ = '\0')
        : path(std::move(path_)), text(text_), comment(comment_) {}

    /// The next word; empty at the end of the file.
    std::string_view word();
    /// The next word of this line; empty at its end, which it does not pass.
    std::string_view word_of_line();
    /// The rest of this line, up to its end.
    std::string_view rest_of_line();
    /// The next word as a number; fails if there is none.
    double number(const Element &of);
    /// The next word as a whole number from 0 to `most`.
    std::size_t index(const Element &of, std::size_t most);

    std::size_t line() const { return lines; }
    std::size_t at() const { return place; }
    bool at_end();

    /// Throws Failure with the path and the line.
    [[noreturn]] void fail(const std::string &why) const;
    [[noreturn]] void fail(const Element &of, const std::string &why) const { fail(of.text() + ": " + why); }

private:
    void skip(bool over_lines);

    std::string path;
    std::string_view text;
    char comment;
    std::size_t place = 0;
    std::size_t lines = 1;
};

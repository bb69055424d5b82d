// Why the program ends without having done what it was asked for.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>

/// What the program returns; --help says the same.
enum class Exit : int { done = 0, usage = 1, file = 2, plugin = 3, refused = 4, cancelled = 5, memory = 6 };

/// "1 input", "2 inputs".
inline std::string number_of(std::size_t count, const std::string &what) {
    return std::to_string(count) + ' ' + what + (count == 1 ? "" : "s");
}

struct Failure : std::runtime_error {
    Failure(Exit exit_, const std::string &message) : std::runtime_error(message), exit(exit_) {}
    Exit exit;
};

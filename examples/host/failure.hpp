// Why the program ends without having done what it was asked for.
#pragma once

#include <stdexcept>
#include <string>

/// What the program returns; --help says the same.
enum class Exit : int { done = 0, usage = 1, file = 2, plugin = 3, refused = 4, cancelled = 5 };

struct Failure : std::runtime_error {
    Failure(Exit exit_, const std::string &message) : std::runtime_error(message), exit(exit_) {}
    Exit exit;
};

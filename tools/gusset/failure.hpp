// Why the program ends without having done what it was asked for.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>

/// What the program returns; --help and the manual say the same.
enum class Exit : int { done = 0, usage = 1, file = 2, plugin = 3, refused = 4, cancelled = 5, memory = 6 };

/// "1 input", "2 inputs", "2 vertices".
inline std::string number_of(std::size_t count, const std::string &what, const std::string &many = "") {
    return std::to_string(count) + ' ' + (count == 1 ? what : many.empty() ? what + 's' : many);
}

/// A sentence for people, and for programs what it is about.
struct Failure : std::runtime_error {
    Failure(Exit exit_, const std::string &message) : std::runtime_error(message), exit(exit_) {}
    Exit exit;
    /// Of a refusal: the plugin's status, the parameter, the input from 0, the kind of element and its number from 0.
    std::optional<int32_t> status;
    std::string parameter;
    std::optional<uint32_t> input;
    std::string element;
    std::optional<uint64_t> index;
};

// Time by stage, and the memory that a process had at its peak.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <sys/resource.h>

namespace tiles {
/// The stages of the program; `disk` is what DIY needs to move blocks out of memory and back.
enum class Stage : std::size_t { load, weld, orient, check, exchange, seams, write, disk };
constexpr std::size_t stage_count = 8;
constexpr std::array<const char *, stage_count> stage_names{"load", "weld", "orient", "check", "exchange", "seams", "write", "disk"};

/// Gives the time since the last lap to a stage.
class Stopwatch {
public:
    void start() { last_ = std::chrono::steady_clock::now(); }
    void lap(Stage stage) {
        const auto now = std::chrono::steady_clock::now();
        seconds_[static_cast<std::size_t>(stage)] += std::chrono::duration<double>(now - last_).count();
        last_ = now;
    }
    const std::array<double, stage_count> &seconds() const { return seconds_; }

private:
    std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
    std::array<double, stage_count> seconds_{};
};

/// Megabytes (10^6 bytes) of memory that this process had at its peak.
inline double peak_megabytes() {
    rusage used{};
    getrusage(RUSAGE_SELF, &used);
    return static_cast<double>(used.ru_maxrss) * 1024 / 1e6;
}
} // namespace tiles

// Time by stage, and the memory that a process had at its peak.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <ctime>
#include <sys/resource.h>

namespace tiles {
/// The stages of the program; `disk` is what DIY needs to move blocks out of memory and back.
enum class Stage : std::size_t { load, weld, orient, check, exchange, seams, write, disk };
constexpr std::size_t stage_count = 8;
constexpr std::array<const char *, stage_count> stage_names{"load", "weld", "orient", "check", "exchange", "seams", "write", "disk"};

/// Seconds that pass, and those that processors work for this process: the same on an idle machine with a fast disk.
struct Seconds {
    double elapsed = 0, processor = 0;

    static Seconds now() {
        const auto read = [](clockid_t clock) {
            timespec time{};
            clock_gettime(clock, &time);
            return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
        };
        return {read(CLOCK_MONOTONIC), read(CLOCK_PROCESS_CPUTIME_ID)};
    }
    void add(const Seconds &from, const Seconds &to) {
        elapsed += to.elapsed - from.elapsed;
        processor += to.processor - from.processor;
    }
};

/// Gives the time since the last lap to a stage.
class Stopwatch {
public:
    void start() { last_ = Seconds::now(); }
    void lap(Stage stage) {
        const Seconds now = Seconds::now();
        stages_[static_cast<std::size_t>(stage)].add(last_, now);
        last_ = now;
    }
    const std::array<Seconds, stage_count> &stages() const { return stages_; }

private:
    Seconds last_ = Seconds::now();
    std::array<Seconds, stage_count> stages_{};
};

/// Megabytes (10^6 bytes) of memory that this process had at its peak.
inline double peak_megabytes() {
    rusage used{};
    getrusage(RUSAGE_SELF, &used);
    return static_cast<double>(used.ru_maxrss) * 1024 / 1e6;
}
} // namespace tiles

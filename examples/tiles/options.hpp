// The options of a run.
#pragma once

#include "plan.hpp"

#include <stdexcept>
#include <string>

namespace tiles {
struct Options {
    Plan plan;
    /// Blocks in memory on each rank; -1: all.
    int in_memory = -1;
    uint32_t threads = 1;
    uint64_t first_id = 0;
    /// Empty: no such files.
    std::string out, input, save_input;
    std::string scratch = ".";
    /// 0: any.
    double max_megabytes = 0;
};

/// Throws std::invalid_argument if the options make no torus.
inline void check(const Options &options) {
    const Plan &plan = options.plan;
    const auto wrong = [](const char *why) { throw std::invalid_argument(why); };
    if (plan.rows < 2 || plan.columns < 2) {
        wrong("a torus has at least 2 rows and 2 columns of tiles");
    }
    // The first rank gathers 128 bytes of each in one message, which MPI counts by int.
    if (uint64_t{plan.rows} * plan.columns > 16000000) {
        wrong("there can be 16000000 tiles at most");
    }
    // Faces have three indices of 32 bits, and so must the soup have.
    if (plan.cells < 2 || plan.cells > 20000) {
        wrong("a tile has 2 to 20000 cells along each side");
    }
    if (plan.mixed && (!plan.gap || plan.cells % 2 != 0 || plan.cells < 4)) {
        wrong("tiles of two finenesses need a gap between them and an even number of cells, at least 4");
    }
    if (options.in_memory == 0 || options.in_memory < -1) {
        wrong("at least 1 block must be in memory, or all (-1)");
    }
    if (!options.input.empty() && !options.save_input.empty()) {
        wrong("input is either read or written");
    }
    if (options.first_id > uint64_t{1} << 62) {
        wrong("the first id is 2^62 at most");
    }
}
} // namespace tiles

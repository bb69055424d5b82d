// Counts the instructions (by callgrind) and the peak bytes of each row at n, 2 n and 4 n. Fails if one grows by a
// larger power of n than the header states.
#include "memory.hpp"
#include "row.hpp"

#include <CLI/CLI.hpp>
#include <valgrind/callgrind.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <string>

namespace {
using namespace complexity;

/// Allows for log n at these sizes, and for grids and tables that double in size.
constexpr double margin = 0.25;
/// By how much the bytes of a unit of n may differ from what docs/guides/guarantees.md says.
constexpr double bytes_margin = 0.25;
/// Smaller growth in bytes is ignored: stacks, tables of a few entries.
constexpr double few_bytes = 1 << 16;

struct Cost {
    double work = 0, bytes = 0;
};

/// Callgrind writes a file for each request, with the counts since the last request.
class Counter {
public:
    explicit Counter(std::string prefix) : prefix_(std::move(prefix)) {}
    void start() { CALLGRIND_ZERO_STATS; }
    double stop() {
        if (!RUNNING_ON_VALGRIND) {
            return 0;
        }
        CALLGRIND_DUMP_STATS;
        const std::string name = prefix_ + "." + std::to_string(++count_);
        std::ifstream file(name);
        std::string line;
        double total = 0;
        while (std::getline(file, line)) {
            if (line.rfind("totals: ", 0) == 0) {
                total = std::stod(line.substr(8));
            }
        }
        std::remove(name.c_str());
        return total;
    }

private:
    std::string prefix_;
    std::size_t count_ = 0;
};

Cost measure(const Row &row, std::size_t n, Counter &counter) {
    gusset::Context context;
    context.set_threads(1);
    const Call call = row.prepare(n);
    Cost cost;
    const std::size_t before = memory_in_use();
    memory_reset_peak();
    counter.start();
    try {
        const auto kept = call(context);
        cost.work = counter.stop();
    } catch (const gusset::Error &error) {
        cost.work = counter.stop();
        if (n == row.size) {
            std::printf("  refused: %s\n", error.what());
        }
    }
    cost.bytes = static_cast<double>(memory_peak() - before);
    return cost;
}

/// The power of n by which two doublings grew: grids of 4 n are twice as wide, stars have a smaller one more.
double exponent(double before, double after) {
    return after > before && before > 0 ? 0.5 * std::log2(after / before) : 0;
}

bool hold(const Row &row, std::size_t scale, Counter &counter) {
    Cost costs[3];
    for (std::size_t i = 0; i < 3; ++i) {
        costs[i] = measure(row, (row.size * scale) << i, counter);
    }
    const double work = exponent(costs[0].work, costs[2].work), memory = exponent(costs[0].bytes, costs[2].bytes);
    const double each = costs[2].bytes / static_cast<double>(4 * row.size * scale);
    const bool good = work <= row.work + margin &&
                      (memory <= row.memory + margin || costs[2].bytes < few_bytes) &&
                      (row.bytes == 0 || std::abs(each / row.bytes - 1) <= bytes_margin);
    std::printf("%-32s %-24s %7zu %12.0f %5.2f %4.1f %12.0f %5.2f %4.1f %8.0f %s\n", row.function, row.family,
                4 * row.size * scale, costs[2].work, work, row.work, costs[2].bytes, memory, row.memory, each,
                good ? "" : "FAILS");
    std::fflush(stdout);
    return good;
}
} // namespace

int main(int argc, char **argv) {
    CLI::App app("Whether work and memory grow as the header states.");
    std::string prefix, only;
    std::size_t scale = 1, half = 2, number = 0;
    bool all = false, operations = false;
    app.add_option("--counts", prefix, "The --callgrind-out-file that valgrind was given");
    app.add_option("--half", half, "Every second row, from the first or from the second");
    app.add_option("--only", only, "Rows whose function or family contains this");
    app.add_flag("--all", all, "Slow rows too");
    app.add_flag("--operations", operations, "The memory of all other operations instead");
    app.add_option("--scale", scale, "A factor of all sizes");
    CLI11_PARSE(app, argc, argv);
    std::printf("%-32s %-24s %7s %12s %5s %4s %12s %5s %4s %8s\n", "function", "family", "n", "instructions", "power", "<=",
                "bytes", "power", "<=", "each");
    Counter counter(prefix);
    bool good = true;
    const std::vector<std::vector<Row>> hostile{mesh_rows(), curve_rows(), net_rows(), surface_rows()};
    for (const auto &rows : operations ? std::vector<std::vector<Row>>{operation_rows()} : hostile) {
        for (const Row &row : rows) {
            const bool listed = (all || operations || !row.slow) && (half > 1 || number++ % 2 == half);
            if (listed && (std::string(row.function) + " " + row.family).find(only) != std::string::npos) {
                good = hold(row, scale, counter) && good;
            }
        }
    }
    return good ? 0 : 1;
}

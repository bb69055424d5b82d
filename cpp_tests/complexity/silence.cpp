// For how long the rows of the table are silent on large inputs, between one progress call and the next: a request to stop is heard
// with these. Prints a table, and fails if a row exceeds its limit: a tenth of a second, with few exceptions. Run by
// `make check-cancel`: no
// test looks at clocks.
#include "instant.hpp"
#include "row.hpp"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <string>

namespace {
using namespace complexity;
using cancel::Milliseconds;
using cancel::Silence;

bool hold(const Row &row, Milliseconds longest, std::size_t size) {
    const Call call = row.prepare(size);
    gusset::Context context;
    Silence silence;
    context.set_progress([&](double fraction, const char *stage) {
        silence.heard(stage, fraction);
        // False when the call has run for long enough.
        return silence.last.wall - silence.start.wall < longest;
    });
    silence.begin();
    std::string outcome;
    std::shared_ptr<void> kept;
    try {
        kept = call(context);
    } catch (const gusset::Error &error) {
        outcome = error.status() == GUSSET_ERROR_CANCELLED ? "stopped" : error.what();
    }
    silence.heard("end");
    const bool good = silence.longest.count() <= row.silence;
    std::printf("%-32s %-24s %8zu %9.0f %9.1f %s from \"%s\" (%.3f) to \"%s\" %s\n", row.function, row.family, size,
                (silence.last.wall - silence.start.wall).count(), silence.longest.count(), good ? "    " : "LATE",
                silence.after.c_str(), silence.done, silence.before.c_str(), outcome.c_str());
    std::fflush(stdout);
    return good;
}
} // namespace

int main(int argc, char **argv) {
    CLI::App app("How long functions are silent between progress calls.");
    std::string only;
    double seconds = 10, scale = 1;
    app.add_option("--only", only, "Rows whose function or family contains this");
    app.add_option("--seconds", seconds, "Longer calls are stopped")->capture_default_str();
    app.add_option("--scale", scale, "A factor of all sizes")->capture_default_str();
    CLI11_PARSE(app, argc, argv);
    std::printf("%-32s %-24s %8s %9s %9s\n", "function", "family", "n", "ms", "silence");
    bool good = true;
    for (const auto &rows : {mesh_rows(), curve_rows(), net_rows(), surface_rows()}) {
        for (const Row &row : rows) {
            if ((std::string(row.function) + " " + row.family).find(only) != std::string::npos) {
                const auto size = static_cast<std::size_t>(scale * static_cast<double>(row.large));
                good = hold(row, Milliseconds(1000 * seconds), size) && good;
            }
        }
    }
    std::puts(good ? "all within their limits" : "not all within their limits");
    return good ? 0 : 1;
}

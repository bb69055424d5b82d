// Time from a cancel to the return of a run, for each filter on large shapes, minus the time in which the system
// reclaims the memory of the run. Prints a table, and fails above a tenth of a second. No test of `make test`, which
// has none
// that look at clocks.
#include "instant.hpp"
#include "shapes.h"

#include <CLI/CLI.hpp>
#include <dlfcn.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <map>
#include <mutex>
#include <optional>
#include <random>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace {
using cancel::between;
using cancel::Instant;
using cancel::Milliseconds;

constexpr double limit = 100;
/// Longer runs are not waited for: requests come within that time.
constexpr Milliseconds patience{20000};

/// A run that stops when it is asked to, and the longest time that it did not ask.
struct Run : cancel::Silence {
    Instant end;
    /// The memory held then.
    double left = 0;
    std::atomic<bool> stop{false};
    int32_t status = 0;
};

int32_t progress(void *user, double, const char *stage) {
    auto &run = *static_cast<Run *>(user);
    run.heard(stage);
    return run.stop || run.last.wall - run.start.wall > patience ? 1 : 0;
}

/// Sets the flag of a run after a while, unless the run is over by then.
class Watcher {
public:
    Watcher(Run &run, Milliseconds wait)
        : thread([this, &run, wait] {
              std::unique_lock lock(guard);
              if (!over.wait_for(lock, wait, [this] { return finished; })) {
                  requested = {Instant::now(), cancel::held()};
                  run.stop = true;
              }
          }) {}
    /// When the request came, and the memory held then.
    std::optional<std::pair<Instant, double>> finish() {
        {
            const std::lock_guard lock(guard);
            finished = true;
        }
        over.notify_all();
        thread.join();
        return requested;
    }

private:
    std::mutex guard;
    std::condition_variable over;
    bool finished = false;
    std::optional<std::pair<Instant, double>> requested;
    std::thread thread;
};

class Subject {
public:
    Subject(const gusset_plugin &plugin_, const gusset_filter &filter_, uint32_t size, uint32_t threads_,
            const std::map<std::string, double> &set)
        : plugin(plugin_), filter(filter_), threads(threads_) {
        // The first shapes that it takes, found out on small ones.
        uint32_t number = 0;
        for (; number < TRIES; ++number) {
            Run run;
            make(number, 8);
            go(run);
            shapes_free(&made);
            if (run.status == GUSSET_PLUGIN_DONE) {
                break;
            }
        }
        make(number % TRIES, size);
        for (uint32_t i = 0; i < filter.param_count; ++i) {
            const gusset_param_info &param = *filter.param(&filter, i);
            if (const auto given = set.find(param.id); given != set.end()) {
                values[param.first_value] = given->second;
            }
        }
    }
    ~Subject() { shapes_free(&made); }
    Subject(const Subject &) = delete;
    Subject &operator=(const Subject &) = delete;

    void go(Run &run) const {
        gusset_host host{};
        host.struct_size = sizeof host;
        host.user = &run;
        host.progress = progress;
        host.threads = threads;
        gusset_outputs *outputs = nullptr;
        run.begin();
        run.status = filter.run(&filter, &host, made.inputs, made.count, values.data(), filter.value_count, &outputs);
        run.end = Instant::now();
        run.left = cancel::held();
        run.heard("end");
        plugin.output_free(outputs);
    }

private:
    void make(uint32_t number, uint32_t size) {
        shapes_make(&made, &filter, number, size);
        values.assign(filter.value_count, 0);
        static_cast<void>(filter.suggest(&filter, made.inputs, made.count, values.data()));
        // Filters without inputs, or with curves, get their size from parameters for rows and columns.
        const bool of_mesh = made.count > 0 && made.inputs[0].kind == GUSSET_KIND_MESH;
        for (uint32_t i = 0; !of_mesh && i < filter.param_count; ++i) {
            const gusset_param_info &param = *filter.param(&filter, i);
            const std::string id = param.id;
            if (id == "rows" || id == "columns") {
                values[param.first_value] = std::clamp<double>(size + 1, param.min, param.max);
            }
        }
    }

    const gusset_plugin &plugin;
    const gusset_filter &filter;
    const uint32_t threads;
    shapes made{};
    std::vector<double> values;
};

/// One row of the table; false if the filter is too slow to stop.
bool measure(const gusset_plugin &plugin, const gusset_filter &filter, uint32_t size, uint32_t threads, int cancels,
             const std::map<std::string, double> &set) {
    const Subject subject(plugin, filter, size, threads, set);
    Run whole;
    subject.go(whole);
    const Milliseconds time = whole.end.wall - whole.start.wall;
    const bool cut = whole.status == GUSSET_PLUGIN_CANCELLED;
    if (whole.status != GUSSET_PLUGIN_DONE && !cut) {
        std::printf("%-20s refuses its shapes, with status %d\n", filter.id, whole.status);
        return false;
    }
    std::mt19937 random(1);
    std::vector<double> late;
    // Runs take their time differently: some requests come too late.
    for (int k = 0; k < 3 * cancels && late.size() < static_cast<std::size_t>(cancels); ++k) {
        Run run;
        Watcher watcher(run, std::uniform_real_distribution<>(0, 0.95)(random) * std::min(time, patience));
        subject.go(run);
        const auto requested = watcher.finish();
        if (requested && requested->first.wall <= run.end.wall && run.status == GUSSET_PLUGIN_CANCELLED) {
            const Milliseconds wait = between(requested->first, run.end);
            late.push_back((wait - cancel::to_take_back(requested->second - run.left)).count());
        }
    }
    std::sort(late.begin(), late.end());
    const double median = late.empty() ? 0 : late[late.size() / 2], worst = late.empty() ? 0 : late.back();
    std::printf("%-20s %s%8.0f %8.1f %8.1f %5zu %10.1f  from \"%s\" to \"%s\"\n", filter.id, cut ? ">" : " ", time.count(),
                median, worst, late.size(), whole.longest.count(), whole.after.c_str(), whole.before.c_str());
    std::fflush(stdout);
    return worst <= limit;
}
} // namespace

int main(int argc, char **argv) {
    CLI::App app("How long after a request to stop the filters of a plugin return.");
    std::string library;
    std::vector<std::string> only;
    uint32_t size = 1000, threads = 0;
    int cancels = 20;
    app.add_option("library", library, "The plugin")->required();
    app.add_option("filters", only, "Ids; all of them without any");
    app.add_option("--size", size, "The square root of the number of faces and points")->capture_default_str();
    app.add_option("--cancels", cancels, "How many, at random times")->capture_default_str();
    std::vector<std::string> set;
    app.add_option("--set", set, "Values for parameters that have these ids, as id=value");
    app.add_option("--threads", threads, "0: as many as the machine has")->capture_default_str();
    CLI11_PARSE(app, argc, argv);

    std::map<std::string, double> numbers;
    for (const std::string &text : set) {
        const std::size_t sign = text.find('=');
        if (sign == std::string::npos) {
            std::fprintf(stderr, "%s is not id=value\n", text.c_str());
            return 2;
        }
        numbers[text.substr(0, sign)] = std::stod(text.substr(sign + 1));
    }
    void *open = dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL);
    const auto entry =
        open != nullptr ? reinterpret_cast<gusset_plugin_entry_fn>(dlsym(open, "gusset_plugin_entry")) : nullptr;
    const gusset_plugin *plugin = entry != nullptr ? entry(GUSSET_PLUGIN_ABI) : nullptr;
    if (plugin == nullptr) {
        std::fprintf(stderr, "%s is no plugin of ABI %d\n", library.c_str(), GUSSET_PLUGIN_ABI);
        return 2;
    }
    std::printf("%u x %u faces or points, times in ms\n%-20s %9s %8s %8s %5s %10s\n", size, size, "filter", "run",
                "median", "worst", "of", "silence");
    bool good = true;
    for (uint32_t i = 0; i < plugin->filter_count; ++i) {
        const gusset_filter &filter = *plugin->filter(i);
        if (only.empty() || std::find(only.begin(), only.end(), filter.id) != only.end()) {
            good = measure(*plugin, filter, size, threads, cancels, numbers) && good;
        }
    }
    std::puts(good ? "all within their limits" : "not all within their limits");
    return good ? 0 : 1;
}

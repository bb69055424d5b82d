// Contenders by turns, and the report.
#include "surface_bench.hpp"
#include "timing.hpp"

#include <cmath>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <numeric>

namespace surface {
namespace {
/// Milliseconds of all threads.
double of_processor(const std::function<void()> &work) {
    const auto now = [] {
        std::timespec time{};
        clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
        return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
    };
    const double start = now();
    work();
    return now() - start;
}

void run(const Contender &contender, double scale, bool by_processor, Outcome &outcome) {
    try {
        contender.prepare();
        outcome.times.push_back(scale * (by_processor ? of_processor(contender.work) : milliseconds(contender.work)));
    } catch (const std::exception &error) {
        outcome.failed = error.what();
    }
}
} // namespace

void Bench::compare(const std::string &id, const std::string &unit, double scale, const std::vector<Contender> &contenders) {
    std::vector<Outcome> outcomes(contenders.size());
    for (std::size_t k = 0; k < contenders.size(); ++k) {
        outcomes[k].failed = contenders[k].skipped;
    }
    for (int turn = 0; turn < options_.runs; ++turn) {
        for (std::size_t k = 0; k < contenders.size(); ++k) {
            const double spent = std::accumulate(outcomes[k].times.begin(), outcomes[k].times.end(), 0.0) / scale;
            if (outcomes[k].failed.empty() && spent < options_.patience) {
                run(contenders[k], scale, options_.by_processor, outcomes[k]);
            }
        }
    }
    for (std::size_t k = 0; k < contenders.size(); ++k) {
        if (outcomes[k].failed.empty()) {
            outcomes[k].value = median(outcomes[k].times);
            outcomes[k].quality = contenders[k].judge();
        }
    }
    for (std::size_t k = 1; k < contenders.size(); ++k) {
        enter(id, contenders[k].name, outcomes[0], outcomes[k], unit);
    }
}

void Bench::enter(const std::string &id, const std::string &peer, const Outcome &ours, const Outcome &theirs, const std::string &unit) {
    nlohmann::json entry = {{"id", id + "/" + peer}, {"ours", nullptr}, {"peer", nullptr}, {"unit", unit}, {"ratio", nullptr},
                            {"runs", std::max(ours.times.size(), theirs.times.size())}, {"quality", ours.quality}};
    std::string failed;
    const auto take = [&](const char *key, const std::string &who, const Outcome &outcome) {
        if (outcome.failed.empty()) {
            entry[key] = *outcome.value;
        } else {
            failed += (failed.empty() ? "" : "; ") + who + ": " + outcome.failed;
        }
    };
    take("ours", "gusset", ours);
    take("peer", peer, theirs);
    if (failed.empty()) {
        entry["ratio"] = *theirs.value / *ours.value;
    } else {
        entry["failed"] = failed;
    }
    if (!theirs.quality.empty()) {
        entry["quality"]["peer"] = theirs.quality;
    }
    const auto shown = [&](const char *key) { return entry[key].is_null() ? std::nan("") : entry[key].get<double>(); };
    std::printf("%-30s %-22s %10.3f %10.3f %-4s%9.2f   %s\n", id.c_str(), peer.c_str(), shown("ours"), shown("peer"), unit.c_str(),
                shown("ratio"), failed.c_str());
    std::fflush(stdout);
    report_.push_back(std::move(entry));
}

void Bench::write(const std::string &path) const { std::ofstream(path) << report_.dump(2) << '\n'; }
} // namespace surface

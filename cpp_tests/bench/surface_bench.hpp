// Contenders by turns, and the report.
#pragma once

#include <nlohmann/json.hpp>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace surface {
/// The contenders: names of our own begin with "gusset". Only `work` is timed; `prepare` comes before each run,
/// `judge` after the last.
struct Contender {
    std::string name;
    std::function<void()> work;
    std::function<void()> prepare = [] {};
    std::function<nlohmann::json()> judge = [] { return nlohmann::json::object(); };
    /// Why it is not even tried.
    std::string skipped = {};
};

struct Outcome {
    std::vector<double> times;
    std::optional<double> value;
    std::string failed;
    nlohmann::json quality = nlohmann::json::object();
};

class Bench {
public:
    struct Options {
        int runs = 7;
        /// Milliseconds after which a slow contender gets no further run.
        double patience = 1500;
        /// Time of the processor in place of time: where others keep the machine busy. It says nothing of threads.
        bool by_processor = false;
        /// Also what takes half a minute a run.
        bool slow = false;
        /// Cases whose names contain this.
        std::string only = {};
    };

    explicit Bench(Options options) : options_(std::move(options)) {}

    bool wants(const std::string &id) const { return id.find(options_.only) != std::string::npos; }
    bool slow() const { return options_.slow; }

    /// The first contender against all others, by turns: each as many runs as were asked for, or as have patience. Times are in
    /// milliseconds times `scale`.
    void compare(const std::string &id, const std::string &unit, double scale, const std::vector<Contender> &contenders);
    /// One entry; whoever failed says why.
    void enter(const std::string &id, const std::string &peer, const Outcome &ours, const Outcome &theirs, const std::string &unit);
    void write(const std::string &path) const;

private:
    Options options_;
    nlohmann::json report_ = nlohmann::json::array();
};
} // namespace surface

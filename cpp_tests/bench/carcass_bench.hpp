// Contenders by turns, and the report.
#pragma once

#include <nlohmann/json.hpp>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace carcass {
/// Who is timed: the names begin with "gusset" for ours. Only `work` is timed; `prepare` comes before each run, `judge` after the last.
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
    Bench(int runs, double patience, std::string only, bool slow)
        : runs_(runs), patience_(patience), only_(std::move(only)), slow_(slow) {}

    bool wants(const std::string &id) const { return id.find(only_) != std::string::npos; }
    bool slow() const { return slow_; }

    /// The first contender against all others, by turns: each as many runs as were asked for, or as have patience. Times are in
    /// milliseconds times `scale`.
    void compare(const std::string &id, const std::string &unit, double scale, const std::vector<Contender> &contenders);
    /// One entry; whoever failed says why.
    void enter(const std::string &id, const std::string &peer, const Outcome &ours, const Outcome &theirs, const std::string &unit);
    void write(const std::string &path) const;

private:
    int runs_;
    double patience_;
    std::string only_;
    bool slow_;
    nlohmann::json report_ = nlohmann::json::array();
};
} // namespace carcass

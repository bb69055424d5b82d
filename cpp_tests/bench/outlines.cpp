// Benchmarks of outlines: gusset, SISL and Open CASCADE by turns, on the same points, in one run. Prints a table and writes a report.
#include "timing.hpp"

#include <gusset.h>
#include <sisl.h>

#include <CLI/CLI.hpp>
#include <Geom2dAPI_Interpolate.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Precision.hxx>
#include <TColgp_HArray1OfPnt2d.hxx>
#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <iostream>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

namespace {
using Point = std::array<double, 2>;

/// Closed outlines in the plane, all in one.
struct Outlines {
    std::vector<uint32_t> offsets;
    std::vector<Point> points;

    std::size_t size() const { return offsets.size() - 1; }
    std::size_t length(std::size_t k) const { return offsets[k + 1] - offsets[k]; }
    const Point *begin(std::size_t k) const { return &points[offsets[k]]; }

    /// The longest side of an outline's box.
    double extent(std::size_t k) const {
        double longest = 0;
        for (std::size_t axis = 0; axis < 2; ++axis) {
            const auto less = [axis](const Point &p, const Point &q) { return p[axis] < q[axis]; };
            const auto [low, high] = std::minmax_element(begin(k), begin(k) + length(k), less);
            longest = std::max(longest, (*high)[axis] - (*low)[axis]);
        }
        return longest;
    }
};

Outlines read_outlines(const std::string &path) {
    std::ifstream in(path, std::ios::binary);
    std::array<uint64_t, 2> counts{};
    Outlines read;
    const auto into = [&](void *data, std::size_t bytes) { in.read(static_cast<char *>(data), static_cast<std::streamsize>(bytes)); };
    into(counts.data(), sizeof counts);
    read.offsets.resize(counts[0] + 1);
    read.points.resize(counts[1]);
    into(read.offsets.data(), read.offsets.size() * sizeof(uint32_t));
    into(read.points.data(), read.points.size() * sizeof(Point));
    if (!in || read.offsets.back() != read.points.size()) {
        throw std::runtime_error(path + " cannot be read");
    }
    return read;
}

void check(gusset_status status) {
    if (status != GUSSET_OK) {
        throw std::runtime_error(gusset_status_text(status));
    }
}

/// Someone who does the work: only `work` is timed. The result is kept until `forget`.
struct Contender {
    virtual ~Contender() = default;
    virtual void prepare() {}
    virtual void work() = 0;
    /// The largest distance of a point from its place on the curve, by the size of its outline; none for sections.
    virtual std::optional<double> residual() const { return {}; }
    virtual void forget() {}
    /// Points evenly along the parameter of outline `k`'s curve, from its beginning to its end.
    virtual std::vector<Point> sampled(std::size_t, std::size_t) const { return {}; }
};

class Gusset : public Contender {
public:
    Gusset(const Outlines &outlines, uint32_t threads) {
        check(gusset_context_create(&context_));
        check(gusset_context_set_threads(context_, threads));
        given_.struct_size = sizeof given_;
        given_.points = outlines.points.data();
        given_.point_count = outlines.points.size();
        given_.offsets = outlines.offsets.data();
        given_.outline_count = outlines.size();
        given_.dimension = 2;
        given_.closed = 1;
        options_.struct_size = sizeof options_;
    }
    Gusset(const Gusset &) = delete;
    Gusset &operator=(const Gusset &) = delete;
    ~Gusset() override { gusset_context_destroy(context_); }

protected:
    gusset_context *context_ = nullptr;
    gusset_outlines given_{};
    gusset_outline_options options_{};
};

class Curves final : public Gusset {
public:
    Curves(const Outlines &outlines, uint32_t threads, uint32_t curve, uint32_t method, uint32_t lock) : Gusset(outlines, threads) {
        options_.curve = curve;
        options_.method = method;
        options_.lock = lock;
    }
    ~Curves() override { forget(); }
    void work() override { check(gusset_outline_create(context_, &given_, &options_, &outline_)); }
    void forget() override {
        gusset_outline_destroy(outline_);
        outline_ = nullptr;
    }
    std::optional<double> residual() const override {
        double worst = 0;
        for (std::size_t k = 0; k < given_.outline_count; ++k) {
            gusset_outline_report report{};
            report.struct_size = sizeof report;
            check(gusset_outline_get_report(outline_, k, &report));
            worst = std::max(worst, report.max_residual);
        }
        return worst;
    }

private:
    gusset_outline *outline_ = nullptr;
};

class Sections final : public Gusset {
public:
    using Gusset::Gusset;
    void work() override {
        // Not cleared: the library writes every number.
        controls_.reset(new double[3 * given_.point_count]);
        parameters_.reset(new double[given_.point_count]);
        statuses_.reset(new uint8_t[given_.point_count]);
        check(gusset_outlines_find_sections(context_, &given_, &options_, controls_.get(), parameters_.get(), statuses_.get(), nullptr));
    }
    void forget() override {
        controls_.reset();
        parameters_.reset();
        statuses_.reset();
    }

private:
    std::unique_ptr<double[]> controls_, parameters_;
    std::unique_ptr<uint8_t[]> statuses_;
};

/// The parameters of `count` places evenly from `low` to `high`.
template <class At> std::vector<Point> along(double low, double high, std::size_t count, At at) {
    std::vector<Point> points;
    for (std::size_t i = 0; i < count; ++i) {
        points.push_back(at(low + (high - low) * static_cast<double>(i) / static_cast<double>(count - 1)));
    }
    return points;
}

/// Interpolation by cubic splines, as C2 at the closure as SISL has it.
class Sisl final : public Contender {
public:
    explicit Sisl(const Outlines &outlines) : outlines_(outlines), curves_(outlines.size()), parameters_(outlines.size()) {
        // The first point comes again at the end.
        for (std::size_t k = 0; k < outlines.size(); ++k) {
            std::vector<double> flat;
            for (std::size_t i = 0; i <= outlines.length(k); ++i) {
                const Point &p = outlines.begin(k)[i % outlines.length(k)];
                flat.insert(flat.end(), {p[0], p[1]});
            }
            closed_.push_back(std::move(flat));
            kinds_.emplace_back(outlines.length(k) + 1, 1);
        }
    }
    ~Sisl() override { forget(); }
    void work() override {
        for (std::size_t k = 0; k < closed_.size(); ++k) {
            double end = 0;
            int count = 0, status = 0;
            const int points = static_cast<int>(kinds_[k].size());
            s1356(closed_[k].data(), points, 2, kinds_[k].data(), 0, 0, 1, 4, 0.0, &end, &curves_[k], &parameters_[k], &count, &status);
            if (status < 0 || count != points) {
                throw std::runtime_error("s1356 returns " + std::to_string(status));
            }
        }
    }
    std::optional<double> residual() const override {
        double worst = 0;
        for (std::size_t k = 0; k < curves_.size(); ++k) {
            double farthest = 0;
            for (std::size_t i = 0; i < outlines_.length(k); ++i) {
                const Point at = point(k, parameters_[k][i]), p = outlines_.begin(k)[i];
                farthest = std::max(farthest, std::hypot(at[0] - p[0], at[1] - p[1]));
            }
            worst = std::max(worst, farthest / outlines_.extent(k));
        }
        return worst;
    }
    void forget() override {
        for (std::size_t k = 0; k < curves_.size(); ++k) {
            if (curves_[k]) {
                freeCurve(curves_[k]);
            }
            std::free(parameters_[k]);
            curves_[k] = nullptr;
            parameters_[k] = nullptr;
        }
    }
    std::vector<Point> sampled(std::size_t k, std::size_t count) const override {
        return along(parameters_[k][0], parameters_[k][outlines_.length(k)], count, [&](double t) { return point(k, t); });
    }

private:
    Point point(std::size_t k, double parameter) const {
        Point at{};
        int left = 0, status = 0;
        s1221(curves_[k], 0, parameter, &left, at.data(), &status);
        return at;
    }

    const Outlines &outlines_;
    std::vector<std::vector<double>> closed_;
    std::vector<std::vector<int>> kinds_;
    std::vector<SISLCurve *> curves_;
    std::vector<double *> parameters_;
};

/// Periodic interpolation by cubic splines; only Perform() is timed.
class Occt final : public Contender {
public:
    explicit Occt(const Outlines &outlines) : outlines_(outlines) {
        for (std::size_t k = 0; k < outlines.size(); ++k) {
            const int count = static_cast<int>(outlines.length(k));
            Handle(TColgp_HArray1OfPnt2d) list = new TColgp_HArray1OfPnt2d(1, count);
            for (int i = 0; i < count; ++i) {
                const Point &p = outlines.begin(k)[i];
                list->SetValue(i + 1, gp_Pnt2d(p[0], p[1]));
            }
            lists_.push_back(list);
        }
    }
    void prepare() override {
        for (const auto &list : lists_) {
            made_.push_back(std::make_unique<Geom2dAPI_Interpolate>(list, true, Precision::Confusion()));
        }
    }
    void work() override {
        for (const auto &one : made_) {
            one->Perform();
            if (!one->IsDone()) {
                throw std::runtime_error("Geom2dAPI_Interpolate is not done");
            }
        }
    }
    std::optional<double> residual() const override {
        double worst = 0;
        for (std::size_t k = 0; k < made_.size(); ++k) {
            double farthest = 0;
            const auto &curve = made_[k]->Curve();
            for (std::size_t i = 0; i < outlines_.length(k); ++i) {
                const Point &p = outlines_.begin(k)[i];
                farthest = std::max(farthest, curve->Value(curve->Knot(static_cast<int>(i) + 1)).Distance({p[0], p[1]}));
            }
            worst = std::max(worst, farthest / outlines_.extent(k));
        }
        return worst;
    }
    void forget() override { made_.clear(); }
    std::vector<Point> sampled(std::size_t k, std::size_t count) const override {
        const auto &curve = made_[k]->Curve();
        return along(curve->FirstParameter(), curve->LastParameter(), count, [&](double t) {
            const gp_Pnt2d p = curve->Value(t);
            return Point{p.X(), p.Y()};
        });
    }

private:
    const Outlines &outlines_;
    std::vector<Handle(TColgp_HArray1OfPnt2d)> lists_;
    std::vector<std::unique_ptr<Geom2dAPI_Interpolate>> made_;
};

struct Kind {
    uint32_t curve, method, lock;
};
const std::vector<std::pair<std::string, Kind>> KINDS = {
    {"composite", {GUSSET_CURVE_KIND_COMPOSITE, GUSSET_METHOD_BISECTOR, GUSSET_LOCK_PARAMETER}},
    {"composite-median", {GUSSET_CURVE_KIND_COMPOSITE, GUSSET_METHOD_MEDIAN, GUSSET_LOCK_PARAMETER}},
    {"self", {GUSSET_CURVE_KIND_COMPOSITE, GUSSET_METHOD_BISECTOR, GUSSET_LOCK_SELF_CONSISTENT}},
    {"cubic", {GUSSET_CURVE_KIND_CUBIC_C2, GUSSET_METHOD_BISECTOR, GUSSET_LOCK_PARAMETER}},
    {"blend", {GUSSET_CURVE_KIND_BLEND_C1, GUSSET_METHOD_BISECTOR, GUSSET_LOCK_PARAMETER}},
};

struct Outcome {
    std::vector<double> times;
    std::string failed;
    std::optional<double> residual;
};

/// All contenders by turns.
std::map<std::string, Outcome> by_turns(std::map<std::string, std::unique_ptr<Contender>> &contenders, int runs, double points) {
    std::map<std::string, Outcome> outcomes;
    for (int run = 0; run < runs; ++run) {
        for (auto &[name, contender] : contenders) {
            Outcome &outcome = outcomes[name];
            if (!outcome.failed.empty()) {
                continue;
            }
            try {
                contender->prepare();
                outcome.times.push_back(1e6 * milliseconds([&, &one = contender] { one->work(); }) / points);
                if (run + 1 == runs) {
                    outcome.residual = contender->residual();
                }
            } catch (const std::exception &error) {
                outcome.failed = error.what();
            }
            contender->forget();
        }
    }
    return outcomes;
}

/// One line and one entry.
nlohmann::json compared(const std::string &id, const std::string &peer, const Outcome &ours, const Outcome &theirs) {
    nlohmann::json entry = {{"id", id + "/" + peer}, {"ours", nullptr}, {"peer", nullptr}, {"unit", "ns"}, {"ratio", nullptr},
                            {"quality", nlohmann::json::object()}};
    std::string failed;
    for (const auto &[who, outcome, key] : {std::tuple{std::string("gusset"), &ours, "ours"}, std::tuple{peer, &theirs, "peer"}}) {
        if (outcome->failed.empty()) {
            entry[key] = median(outcome->times);
        } else {
            failed += (failed.empty() ? "" : "; ") + who + ": " + outcome->failed;
        }
    }
    if (failed.empty()) {
        entry["ratio"] = entry["peer"].get<double>() / entry["ours"].get<double>();
    } else {
        entry["failed"] = failed;
    }
    if (ours.residual) {
        entry["quality"]["residual"] = *ours.residual;
    }
    if (theirs.residual) {
        entry["quality"]["peer"] = {{"residual", *theirs.residual}};
    }
    const auto shown = [&](const char *key) { return entry[key].is_null() ? std::nan("") : entry[key].get<double>(); };
    std::printf("%-30s %-22s %10.2f %10.2f ns  %9.2f   %s\n", id.c_str(), peer.c_str(), shown("ours"), shown("peer"), shown("ratio"),
                failed.c_str());
    std::fflush(stdout);
    return entry;
}

void time_all(const Outlines &outlines, const std::string &only, int runs, const std::string &out) {
    const auto wants = [&](const std::string &name) { return ("outline/" + name).find(only) != std::string::npos; };
    std::map<std::string, std::unique_ptr<Contender>> contenders;
    std::vector<std::string> cases;
    for (const uint32_t threads : {1u, 0u}) {
        const std::string suffix = threads == 1 ? "" : "-automatic";
        if (wants("section")) {
            contenders["section" + suffix] = std::make_unique<Sections>(outlines, threads);
        }
        for (const auto &[name, kind] : KINDS) {
            if (wants(name)) {
                contenders[name + suffix] = std::make_unique<Curves>(outlines, threads, kind.curve, kind.method, kind.lock);
            }
        }
    }
    contenders["sisl"] = std::make_unique<Sisl>(outlines);
    contenders["occt"] = std::make_unique<Occt>(outlines);
    const auto outcomes = by_turns(contenders, runs, static_cast<double>(outlines.points.size()));
    auto report = nlohmann::json::array();
    const auto enter = [&](const std::string &name, const std::string &peer, const std::string &who) {
        report.push_back(compared("outline/" + name, peer, outcomes.at(name), outcomes.at(who)));
    };
    if (wants("section")) {
        enter("section", "gusset-automatic", "section-automatic");
    }
    for (const auto &[name, kind] : KINDS) {
        if (wants(name)) {
            enter(name, "sisl", "sisl");
            enter(name, "occt", "occt");
            enter(name, "gusset-automatic", name + "-automatic");
        }
    }
    std::ofstream(out) << report.dump(2) << '\n';
}

/// The peers' curves as polygons with `fine` points for each one given, all in one file: SISL's and then Open CASCADE's.
void write_samples(const Outlines &outlines, std::size_t fine, const std::string &out) {
    std::ofstream file(out, std::ios::binary);
    Sisl sisl(outlines);
    Occt occt(outlines);
    for (Contender *peer : {static_cast<Contender *>(&sisl), static_cast<Contender *>(&occt)}) {
        peer->prepare();
        peer->work();
        for (std::size_t k = 0; k < outlines.size(); ++k) {
            const std::vector<Point> points = peer->sampled(k, fine * outlines.length(k) + 1);
            file.write(reinterpret_cast<const char *>(points.data()), static_cast<std::streamsize>(points.size() * sizeof(Point)));
        }
    }
}
} // namespace

int main(int argc, char **argv) {
    CLI::App app("Outlines against SISL and Open CASCADE, in ns per point; ratio = peer / ours");
    std::string outlines, only, out = "outlines.json", samples;
    int runs = 15;
    std::size_t fine = 200;
    app.add_option("--outlines", outlines, "the file of outlines")->required();
    app.add_option("--only", only, "cases whose names contain this");
    app.add_option("--runs", runs, "runs of each; medians are reported")->check(CLI::Range(1, 1000));
    app.add_option("--out", out, "the report");
    app.add_option("--samples", samples, "no times: instead write the peers' curves as polygons into this file");
    app.add_option("--fine", fine, "sides of these polygons for each given point");
    CLI11_PARSE(app, argc, argv);
    try {
        const Outlines given = read_outlines(outlines);
        if (samples.empty()) {
            time_all(given, only, runs, out);
        } else {
            write_samples(given, fine, samples);
        }
    } catch (const std::exception &error) {
        std::cerr << "outlines: " << error.what() << '\n';
        return 1;
    }
    return 0;
}

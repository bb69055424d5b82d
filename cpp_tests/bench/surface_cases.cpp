// The cases with triangles: the same nodes for all, and few nodes against many triangles of the same accuracy.
#include "surface_cases.hpp"
#include "surface_judge.hpp"

#include <malloc.h>

#include <algorithm>

namespace surface {
namespace {
/// The cases at equal accuracy: 25 x 49 nodes deviate from the torus about as much as triangles of 10^6 nodes.
constexpr double CHORD = 8e-7;
constexpr std::size_t NEAR = 20'000, FAR = 10'000, LINES = 10'000;

double allocated() {
    const struct mallinfo2 info = mallinfo2();
    return static_cast<double>(info.uordblks) + static_cast<double>(info.hblkhd);
}

Outcome known(double value) {
    Outcome outcome;
    outcome.value = value;
    return outcome;
}

Contender building(const std::string &name, Solver &solver) {
    return {name, [&solver] { solver.build(); }, [&solver] { solver.prepare(); }};
}

/// A plane across, along nothing.
Plane across(const Surface &surface) {
    return {0.5 * (surface.low + surface.high) + Point{0.05, 0.1, 0.02}, {0.3, 0.5, 0.8124038404635961}};
}

/// Everything that is asked about a surface, of `ours` on the stage `few` and of the peers on the stage `many`.
class Asking {
public:
    Asking(Bench &bench, Stage &few, Stage &many, std::string suffix)
        : bench_(bench), few_(few), many_(many), suffix_(std::move(suffix)) {}

    void closest(const std::string &kind, const std::function<Points()> &make) {
        for (const bool in_order : {false, true}) {
            const std::string id = "carcass/" + kind + suffix_ + (in_order ? "-sorted" : "");
            if (bench_.wants(id)) {
                const Points queries = in_order ? sorted(make()) : make();
                const double each = 1e6 / static_cast<double>(queries.size());
                compare(id, "ns", each, PEERS, [&](const std::string &who, Stage &stage) {
                    return feet_of(who, stage.at(who), many_.surface, queries);
                });
            }
        }
    }
    void along_lines(const std::string &kind, bool first_only) {
        const std::string id = "carcass/" + kind + suffix_;
        if (bench_.wants(id)) {
            const std::vector<Line> asked = lines(many_.surface, LINES);
            compare(id, "ns", 1e6 / static_cast<double>(asked.size()), PEERS, [&](const std::string &who, Stage &stage) {
                return hits_of(who, stage.at(who), many_.surface, asked, first_only);
            });
        }
    }
    void planes() {
        const std::string id = "carcass/plane" + suffix_;
        if (bench_.wants(id)) {
            // As near as the triangles between its points too, where these are far apart.
            const bool apart = &few_ != &many_;
            compare(id, "ms", 1, {"cgal", "cgal-segments", "parry", "gusset-chord"}, [&](const std::string &who, Stage &stage) {
                Solver &solver = stage.at(apart && who == "gusset" ? "gusset-chord" : who);
                solver.prepare_planes();
                return section_of(who, solver, many_.surface, across(many_.surface));
            });
        }
    }
    void build(const std::vector<std::string> &peers) {
        const std::string id = "carcass/build" + suffix_;
        if (bench_.wants(id)) {
            compare(id, "ms", 1, peers, [](const std::string &who, Stage &stage) { return building(who, stage.at(who)); });
        }
    }

private:
    void compare(const std::string &id, const std::string &unit, double scale, const std::vector<std::string> &peers,
                 const std::function<Contender(const std::string &, Stage &)> &with) {
        std::vector<Contender> all = {with("gusset", few_)};
        for (const std::string &who : peers) {
            all.push_back(with(who, who.rfind("gusset", 0) == 0 ? few_ : many_));
        }
        bench_.compare(id, unit, scale, all);
    }

    Bench &bench_;
    Stage &few_, &many_;
    std::string suffix_;
};

void everything(Bench &bench, Stage &few, Stage &many, const std::string &suffix, const std::vector<std::string> &builders) {
    Asking asking(bench, few, many, suffix);
    asking.build(builders);
    asking.closest("near", [&] { return near_queries(many.surface, NEAR); });
    asking.closest("far", [&] { return far_queries(many.surface, FAR); });
    asking.along_lines("line", false);
    asking.along_lines("ray", true);
    asking.planes();
}

/// Bytes of the index for each node, and of all in the case of equal accuracy.
void memory(Bench &bench, Stage &few, Stage &many) {
    const double count = static_cast<double>(many.nodes.points.size());
    const auto whole = [](const Triangles &mesh) {
        return static_cast<double>(mesh.points.size() * sizeof(Point) + mesh.corners.size() * sizeof(uint32_t));
    };
    const double nodes = static_cast<double>(few.nodes.points.size() * sizeof(Point));
    for (const std::string who : {"cgal", "cgal-tree", "embree", "parry"}) {
        if (bench.wants("carcass/memory")) {
            bench.enter("carcass/memory", who, known(many.bytes("gusset") / count), known(many.bytes(who) / count), "B");
        }
        if (bench.wants("carcass/memory-equal-accuracy")) {
            bench.enter("carcass/memory-equal-accuracy", who, known((few.bytes("gusset") + nodes) / 1024),
                        known((many.bytes(who) + whole(many.triangles())) / 1024), "KiB");
        }
    }
}

void threads(Bench &bench, Stage &stage) {
    const Points near = near_queries(stage.surface, 4 * NEAR), far = far_queries(stage.surface, 4 * FAR);
    for (const auto &[name, queries] : {std::pair{"near", &near}, std::pair{"far", &far}}) {
        const std::string id = std::string("carcass/threads-") + name;
        if (bench.wants(id)) {
            const auto contender = [&, queries = queries](const std::string &who, const char *as) {
                return feet_of(as, stage.at(who), stage.surface, *queries);
            };
            bench.compare(id, "ns", 1e6 / static_cast<double>(queries->size()),
                          {contender("gusset-automatic", "gusset"), contender("gusset", "gusset-one-thread")});
        }
    }
}
} // namespace

const std::vector<std::string> PEERS = {"cgal", "embree", "parry"};

Stage::Stage(Surface of, std::size_t rows, std::size_t columns)
    : surface(std::move(of)), nodes(surface::nodes(surface, rows, columns)) {}

const Triangles &Stage::triangles() {
    if (triangles_.points.empty()) {
        triangles_ = surface::triangles(nodes);
    }
    return triangles_;
}

std::unique_ptr<Solver> Stage::make(const std::string &who) {
    const std::map<std::string, std::function<std::unique_ptr<Solver>()>> makers = {
        {"gusset", [this] { return gusset(nodes, 1); }},
        {"gusset-chord", [this] { return gusset(nodes, 1, CHORD); }},
        {"gusset-automatic", [this] { return gusset(nodes, 0); }},
        {"cgal", [this] { return cgal(triangles()); }},
        {"cgal-tree", [this] { return cgal(triangles(), false); }},
        {"cgal-segments", [this] { return cgal_segments(triangles()); }},
        {"embree", [this] { return embree(triangles(), 1); }},
        {"embree-automatic", [this] { return embree(triangles(), 0); }},
        {"parry", [this] { return parry(triangles()); }},
    };
    return makers.at(who)();
}

Stage::Built &Stage::built(const std::string &who) {
    auto found = built_.find(who);
    if (found == built_.end()) {
        std::unique_ptr<Solver> solver = make(who);
        solver->prepare();
        const double before = allocated();
        solver->build();
        const double bytes = solver->bytes() ? static_cast<double>(solver->bytes()) : allocated() - before;
        found = built_.emplace(who, Built{std::move(solver), bytes}).first;
    }
    return found->second;
}

Solver &Stage::at(const std::string &who) { return *built(who).solver; }
double Stage::bytes(const std::string &who) { return built(who).bytes; }

Contender feet_of(const std::string &name, Solver &solver, const Surface &surface, const Points &queries) {
    const auto feet = std::make_shared<Points>();
    return {name, [&, feet] { solver.closest(queries, *feet); }, [] {},
            [&, feet] { return judge_feet(surface, queries, *feet, solver.unproven()); }};
}

Contender hits_of(const std::string &name, Solver &solver, const Surface &surface, const std::vector<Line> &lines, bool first_only) {
    const auto hits = std::make_shared<Hits>();
    return {name, [&, hits, first_only] { first_only ? solver.rays(lines, *hits) : solver.lines(lines, *hits); }, [] {},
            [&, hits, first_only] { return judge_hits(surface, lines, *hits, first_only); }};
}

Contender section_of(const std::string &name, Solver &solver, const Surface &surface, const Plane &plane) {
    const auto curves = std::make_shared<Polylines>();
    return {name, [&, plane, curves] { solver.plane(plane, *curves); }, [] {},
            [&, curves] { return judge_curves({surface}, *curves); }};
}

Contender meeting_of(const std::string &name, Solver &a, Solver &b, const std::vector<Surface> &surfaces) {
    const auto curves = std::make_shared<Polylines>();
    return {name, [&, curves] { a.meet(b, *curves); }, [] {}, [&, curves] { return judge_curves(surfaces, *curves); }};
}

void same_nodes(Bench &bench) {
    const std::vector<std::string> builders = {"gusset-automatic", "cgal", "cgal-tree", "embree", "embree-automatic", "parry"};
    {
        Stage waves(surface::waves(), 1000, 1000);
        everything(bench, waves, waves, "-1e6-wavy", builders);
    }
    {
        Stage small(torus(), 101, 101);
        everything(bench, small, small, "-1e4", builders);
    }
    Stage large(torus(), 708, 1413), few(torus(), 25, 49);
    everything(bench, large, large, "-1e6", builders);
    everything(bench, few, large, "-equal-accuracy", PEERS);
    memory(bench, few, large);
    threads(bench, large);
}

void many_nodes(Bench &bench) {
    const std::vector<std::string> kinds = {"build", "near", "far"};
    const auto id = [](const std::string &kind) { return "carcass/" + kind + "-1e7"; };
    if (std::none_of(kinds.begin(), kinds.end(), [&](const std::string &kind) { return bench.wants(id(kind)); })) {
        return;
    }
    Stage stage(torus(), 2236, 4473);
    const Points near = near_queries(stage.surface, NEAR), far = far_queries(stage.surface, FAR);
    for (const std::string &kind : kinds) {
        if (!bench.wants(id(kind))) {
            continue;
        }
        const Points &queries = kind == "near" ? near : far;
        std::vector<Contender> all;
        for (const std::string who : {"gusset", "gusset-automatic", "embree", "cgal"}) {
            if (!bench.slow() && who.rfind("gusset", 0) != 0) {
                all.push_back({who, [] {}});
                all.back().skipped = "skipped, as 2e7 triangles take it half a minute: SLOW=1 runs it";
            } else if (kind == "build") {
                all.push_back(building(who, stage.at(who)));
            } else {
                all.push_back(feet_of(who, stage.at(who), stage.surface, queries));
            }
        }
        bench.compare(id(kind), kind == "build" ? "ms" : "ns", kind == "build" ? 1 : 1e6 / static_cast<double>(queries.size()), all);
    }
}
} // namespace surface

// The cases with kernels of CAD: a torus by nodes, for them as a bicubic C2 spline through the same nodes.
#include "surface_cases.hpp"

#include <fstream>

namespace surface {
namespace {
constexpr std::size_t ROWS = 51, COLUMNS = 101, QUERIES = 40, LINES = 20;
/// About as many points as SISL has spans.
constexpr double CHORD = 1e-5;
const Point SHIFT = {0.7, 0.2, 0.1};

/// All of them, of one torus.
struct Toruses {
    explicit Toruses(const Point &centre)
        : surface(torus(centre)), nodes(surface::nodes(surface, ROWS, COLUMNS)), spline(surface::spline(nodes)) {
        solvers["gusset"] = gusset(spline, 1, CHORD);
        solvers["gusset-nodes"] = gusset(nodes, 1, CHORD);
        solvers["sisl"] = sisl(spline);
        solvers["occt"] = occt(spline);
        solvers["occt-exact"] = occt_torus(centre);
        for (auto &[name, solver] : solvers) {
            solver->prepare();
            solver->build();
        }
    }

    Surface surface;
    Nodes nodes;
    Spline spline;
    std::map<std::string, std::unique_ptr<Solver>> solvers;
};

const Plane ACROSS = {{0.05, 0.1, 0.02}, {0.3, 0.5, 0.8124038404635961}};

const std::vector<std::string> KERNELS = {"gusset", "sisl", "occt", "occt-exact", "gusset-nodes"};

void of_one(Bench &bench, Toruses &toruses) {
    const auto compare = [&](const std::string &id, const char *unit, double scale, const auto &contender) {
        if (bench.wants(id)) {
            std::vector<Contender> all;
            for (const std::string &who : KERNELS) {
                all.push_back(contender(who, *toruses.solvers.at(who)));
            }
            bench.compare(id, unit, scale, all);
        }
    };
    const Points near = near_queries(toruses.surface, QUERIES), far = far_queries(toruses.surface, QUERIES);
    for (const auto &[name, queries] : {std::pair{"near", &near}, std::pair{"far", &far}}) {
        compare(std::string("carcass/") + name + "-spline", "us", 1e3 / QUERIES,
                [&, queries = queries](const std::string &who, Solver &solver) { return feet_of(who, solver, toruses.surface, *queries); });
    }
    const std::vector<Line> asked = lines(toruses.surface, LINES);
    compare("carcass/line-spline", "us", 1e3 / LINES,
            [&](const std::string &who, Solver &solver) { return hits_of(who, solver, toruses.surface, asked, false); });
    compare("carcass/plane-spline", "ms", 1, [&](const std::string &who, Solver &solver) {
        return section_of(who, solver, toruses.surface, ACROSS);
    });
}

void of_two(Bench &bench, Toruses &a, Toruses &b) {
    const std::vector<Surface> both = {a.surface, b.surface};
    const auto contender = [&](const std::string &who) { return meeting_of(who, *a.solvers.at(who), *b.solvers.at(who), both); };
    if (bench.wants("carcass/ssi")) {
        const Triangles fine_a = triangles(nodes(a.surface, 354, 707)), fine_b = triangles(nodes(b.surface, 354, 707));
        const auto cgal_a = cgal(fine_a), cgal_b = cgal(fine_b);
        bench.compare("carcass/ssi", "ms", 1,
                      {contender("gusset"), contender("sisl"), contender("occt"), contender("gusset-nodes"),
                       meeting_of("cgal-500k-triangles", *cgal_a, *cgal_b, both)});
    }
    if (bench.wants("carcass/ssi-exact")) {
        const Nodes fine_a = nodes(a.surface, 97, 193), fine_b = nodes(b.surface, 97, 193);
        const auto ours_a = gusset(fine_a, 1, CHORD), ours_b = gusset(fine_b, 1, CHORD);
        ours_a->build();
        ours_b->build();
        bench.compare("carcass/ssi-exact", "ms", 1, {meeting_of("gusset", *ours_a, *ours_b, both), contender("occt-exact")});
    }
}
} // namespace

void kernels(Bench &bench) {
    Toruses a({}), b(SHIFT);
    of_one(bench, a);
    of_two(bench, a, b);
}

void write_questions(const std::string &path) {
    const Toruses a({}), b(SHIFT);
    const auto written = [](const Spline &spline) {
        return nlohmann::json{{"rows", spline.rows},
                              {"columns", spline.columns},
                              {"u_knots", spline.u_knots},
                              {"v_knots", spline.v_knots},
                              {"controls", spline.controls}};
    };
    auto asked = nlohmann::json::array();
    for (const Line &line : lines(a.surface, LINES)) {
        asked.push_back({line.origin, line.direction});
    }
    std::ofstream(path) << nlohmann::json{{"splines", {written(a.spline), written(b.spline)}},
                                          {"shift", SHIFT},
                                          {"near", near_queries(a.surface, QUERIES)},
                                          {"far", far_queries(a.surface, QUERIES)},
                                          {"lines", asked},
                                          {"plane", {ACROSS.origin, ACROSS.normal}}};
}
} // namespace surface

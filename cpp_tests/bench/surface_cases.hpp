// The cases of surfaces: who answers what.
#pragma once

#include "surface.hpp"
#include "surface_bench.hpp"

#include <map>

namespace surface {
/// A surface by nodes, in every form, and those who answer about it: each is built when it is first asked for.
class Stage {
public:
    Stage(Surface of, std::size_t rows, std::size_t columns);

    Solver &at(const std::string &who);
    /// The bytes of an index, beside nodes or triangles.
    double bytes(const std::string &who);

    const Triangles &triangles();

    const Surface surface;
    const Nodes nodes;

private:
    struct Built {
        std::unique_ptr<Solver> solver;
        double bytes;
    };
    std::unique_ptr<Solver> make(const std::string &who);
    Built &built(const std::string &who);

    Triangles triangles_;
    std::map<std::string, Built> built_;
};

/// Contenders that use triangles; Embree in single precision.
extern const std::vector<std::string> PEERS;

/// Someone who answers; the answer is kept for the judge.
Contender feet_of(const std::string &name, Solver &solver, const Surface &surface, const Points &queries);
Contender hits_of(const std::string &name, Solver &solver, const Surface &surface, const std::vector<Line> &lines, bool first_only);
Contender section_of(const std::string &name, Solver &solver, const Surface &surface, const Plane &plane);
Contender meeting_of(const std::string &name, Solver &a, Solver &b, const std::vector<Surface> &surfaces);

/// The same 10^6 nodes for all; few nodes against many triangles.
void same_nodes(Bench &bench);
/// 10^7 nodes; the peers take half a minute each.
void many_nodes(Bench &bench);
/// Beside kernels of CAD.
void kernels(Bench &bench);
/// The queries of these cases, for other contenders.
void write_questions(const std::string &path);
} // namespace surface

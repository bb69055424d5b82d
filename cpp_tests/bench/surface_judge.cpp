// Compares answers with the surface by formula.
#include "surface_judge.hpp"

#include <algorithm>
#include <cmath>

namespace surface {
namespace {
constexpr double WRONG = 2e-3;
} // namespace

nlohmann::json judge_feet(const Surface &surface, const Points &queries, const Points &feet,
                          const std::optional<std::vector<std::size_t>> &unproven) {
    double worst = 0, worst_unproven = 0;
    std::size_t wrong = 0;
    for (std::size_t k = 0; k < queries.size(); ++k) {
        const double error = std::abs(length(feet[k] - queries[k]) - surface.distance(queries[k], feet[k]));
        if (unproven && std::binary_search(unproven->begin(), unproven->end(), k)) {
            worst_unproven = std::max(worst_unproven, error);
        } else if (error > WRONG) {
            ++wrong;
        } else {
            worst = std::max(worst, error);
        }
    }
    nlohmann::json quality = {{"max_error", worst}, {"wrong", wrong}, {"queries", queries.size()}};
    if (unproven) {
        quality["unproven"] = unproven->size();
        quality["unproven_error"] = worst_unproven;
    }
    return quality;
}

nlohmann::json judge_hits(const Surface &surface, const std::vector<Line> &lines, const Hits &hits, bool first_only) {
    double worst = 0;
    for (const Point &p : hits.points) {
        worst = std::max(worst, surface.off(p));
    }
    std::size_t wrong = 0, begin = 0;
    for (std::size_t k = 0; k < lines.size(); ++k) {
        const std::size_t there = crossings(surface, lines[k]), found = hits.ends[k] - begin;
        wrong += found != (first_only ? std::min<std::size_t>(there, 1) : there);
        begin = hits.ends[k];
    }
    return {{"max_error", worst}, {"wrong", wrong}, {"queries", lines.size()}, {"hits", hits.points.size()}};
}

nlohmann::json judge_curves(const std::vector<Surface> &surfaces, const Polylines &curves) {
    double worst = 0, chord = 0, total = 0;
    const auto off = [&](const Point &p) {
        double most = 0;
        for (const Surface &surface : surfaces) {
            most = std::max(most, surface.off(p));
        }
        return most;
    };
    std::size_t begin = 0;
    for (const std::size_t end : curves.ends) {
        for (std::size_t i = begin; i < end; ++i) {
            worst = std::max(worst, off(curves.points[i]));
            if (i > begin) {
                chord = std::max(chord, off(0.5 * (curves.points[i - 1] + curves.points[i])));
                total += length(curves.points[i] - curves.points[i - 1]);
            }
        }
        begin = end;
    }
    const auto open = static_cast<std::size_t>(std::count(curves.closed.begin(), curves.closed.end(), false));
    nlohmann::json quality = {{"max_error", worst},
                              {"chord_error", curves.sampled ? nlohmann::json() : nlohmann::json(chord)},
                              {"points", curves.points.size()},
                              {"curves", curves.ends.size()},
                              {"closed", open == 0},
                              {"ordered", curves.ordered},
                              {"length", total}};
    if (curves.unresolved) {
        quality["unresolved"] = *curves.unresolved;
    }
    return quality;
}
} // namespace surface

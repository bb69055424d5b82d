// Compares answers with the surface by formula.
#pragma once

#include "surface.hpp"

#include <nlohmann/json.hpp>

namespace surface {
/// `max_error` of the distances, without the `wrong` ones: those that are farther than the nearest point by more than
/// 2e-3. Answers that report `unproven` count in neither number, and have an error of their own.
nlohmann::json judge_feet(const Surface &surface, const Points &queries, const Points &feet,
                          const std::optional<std::vector<std::size_t>> &unproven);
/// `max_error`: how far hits are from the surface. `wrong`: lines that have more or fewer hits than there are.
nlohmann::json judge_hits(const Surface &surface, const std::vector<Line> &lines, const Hits &hits, bool first_only);
/// `max_error`: how far points are from all the surfaces; `chord_error`: the same at the middles between them, if they
/// are the answer itself.
nlohmann::json judge_curves(const std::vector<Surface> &surfaces, const Polylines &curves);
} // namespace surface

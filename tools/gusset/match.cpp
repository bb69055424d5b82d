#include "match.hpp"

#include <algorithm>
#include <functional>
#include <unordered_map>

namespace {
constexpr uint32_t none = UINT32_MAX;

struct Hash {
    std::size_t operator()(const Point &p) const {
        std::size_t hash = 0;
        for (const double x : p) {
            // -0 is equal to 0.
            hash = (hash ^ std::hash<double>()(x + 0.0)) * 0x9E3779B97F4A7C15U;
        }
        return hash;
    }
};

/// Numbers of positions, the same for equal ones.
class Places {
public:
    explicit Places(const std::vector<const Mesh *> &inputs) {
        for (const Mesh *input : inputs) {
            of_input.emplace_back();
            for (const Point &point : input->points) {
                of_input.back().push_back(known.emplace(point, static_cast<uint32_t>(known.size())).first->second);
            }
        }
    }
    uint32_t of(const Point &point) const {
        const auto found = known.find(point);
        return found == known.end() ? none : found->second;
    }
    std::size_t count() const { return known.size(); }

    std::vector<std::vector<uint32_t>> of_input;

private:
    std::unordered_map<Point, uint32_t, Hash> known;
};

/// The same for all cycles of the same places, either way round.
std::size_t hash_of(const std::vector<uint32_t> &places) {
    std::size_t sum = places.size(), twisted = 0;
    for (const uint32_t place : places) {
        const std::size_t mixed = (place + std::size_t{1}) * 0x9E3779B97F4A7C15U;
        sum += mixed;
        twisted ^= mixed;
    }
    return sum ^ (twisted >> 7);
}

std::vector<uint32_t> places_of(const Mesh &mesh, std::size_t face, const std::vector<uint32_t> &of_vertices) {
    std::vector<uint32_t> places;
    for (uint32_t c = mesh.offsets[face]; c < mesh.offsets[face + 1]; ++c) {
        places.push_back(of_vertices[mesh.corners[c]]);
    }
    return places;
}

/// How the new cycle is the old one.
std::optional<FaceOrigin> same_cycle(const std::vector<uint32_t> &now, const std::vector<uint32_t> &was) {
    const std::size_t degree = now.size();
    if (was.size() != degree) {
        return std::nullopt;
    }
    for (const bool turned : {false, true}) {
        for (std::size_t first = 0; first < degree; ++first) {
            const FaceOrigin origin{0, 0, static_cast<uint32_t>(first), turned};
            bool same = true;
            for (std::size_t k = 0; same && k < degree; ++k) {
                same = now[k] == was[corner_of(origin, k, degree)];
            }
            if (same) {
                return origin;
            }
        }
    }
    return std::nullopt;
}

/// All faces of the inputs, one after the other.
struct Faces {
    struct Name {
        uint32_t input, face;
    };
    std::vector<Name> all;
    std::vector<bool> taken;
    std::unordered_map<std::size_t, std::vector<uint32_t>> by_hash;

    Faces(const std::vector<const Mesh *> &inputs, const Places &places) {
        for (uint32_t i = 0; i < inputs.size(); ++i) {
            for (uint32_t f = 0; f < inputs[i]->face_count(); ++f) {
                by_hash[hash_of(places_of(*inputs[i], f, places.of_input[i]))].push_back(
                    static_cast<uint32_t>(all.size()));
                all.push_back({i, f});
            }
        }
        taken.resize(all.size());
    }
};

std::optional<FaceOrigin> face_of(const std::vector<const Mesh *> &inputs, const Places &places, Faces &faces,
                                  const std::vector<uint32_t> &now) {
    const auto candidates = faces.by_hash.find(hash_of(now));
    if (candidates == faces.by_hash.end()) {
        return std::nullopt;
    }
    for (const uint32_t candidate : candidates->second) {
        const auto [input, face] = faces.all[candidate];
        if (faces.taken[candidate]) {
            continue;
        }
        if (auto found = same_cycle(now, places_of(*inputs[input], face, places.of_input[input]))) {
            faces.taken[candidate] = true;
            found->input = input;
            found->face = face;
            return found;
        }
    }
    return std::nullopt;
}

/// The face at the same place, if a corner of it stayed where it was.
std::optional<FaceOrigin> face_at(const std::vector<const Mesh *> &inputs, const Places &places, Faces &faces,
                                  std::size_t place, const std::vector<uint32_t> &now) {
    if (place >= faces.all.size() || faces.taken[place]) {
        return std::nullopt;
    }
    const auto [input, face] = faces.all[place];
    const auto was = places_of(*inputs[input], face, places.of_input[input]);
    bool stayed = false;
    for (std::size_t k = 0; was.size() == now.size() && k < was.size(); ++k) {
        stayed = stayed || was[k] == now[k];
    }
    if (!stayed) {
        return std::nullopt;
    }
    faces.taken[place] = true;
    return FaceOrigin{input, face, 0, false};
}

Match same_faces(const Mesh &input, const Mesh &result) {
    Match made;
    made.moved = input.points != result.points;
    for (uint32_t v = 0; v < result.points.size(); ++v) {
        made.vertices.emplace_back(Origin{0, v});
    }
    for (uint32_t f = 0; f < result.face_count(); ++f) {
        made.faces.emplace_back(FaceOrigin{0, f, 0, false});
    }
    return made;
}

void match_vertices(const std::vector<const Mesh *> &inputs, const Mesh &result, const Places &places,
                    const std::vector<uint32_t> &of_result, Match &made) {
    for (std::size_t f = 0; f < result.face_count(); ++f) {
        const auto &origin = made.faces[f];
        for (std::size_t k = 0; origin && k < result.degree(f); ++k) {
            const Mesh &input = *inputs[origin->input];
            const std::size_t corner = input.offsets[origin->face] + corner_of(*origin, k, result.degree(f));
            auto &vertex = made.vertices[result.corners[result.offsets[f] + k]];
            vertex = vertex ? vertex : Origin{origin->input, input.corners[corner]};
        }
    }
    // The others, such as those that no face uses: the first at the same position that is none's yet.
    std::vector<std::vector<Origin>> at(places.count());
    std::vector<std::vector<bool>> taken;
    for (const Mesh *input : inputs) {
        taken.emplace_back(input->points.size());
    }
    for (const auto &vertex : made.vertices) {
        if (vertex) {
            taken[vertex->input][vertex->vertex] = true;
        }
    }
    for (uint32_t i = 0; i < inputs.size(); ++i) {
        for (uint32_t v = static_cast<uint32_t>(inputs[i]->points.size()); v-- > 0;) {
            auto &there = at[places.of_input[i][v]];
            if (!taken[i][v] || there.empty()) {
                there.push_back({i, v});
            }
        }
    }
    for (std::size_t v = 0; v < result.points.size(); ++v) {
        if (made.vertices[v] || of_result[v] == none) {
            continue;
        }
        auto &there = at[of_result[v]];
        made.vertices[v] = there.back();
        if (there.size() > 1) {
            there.pop_back();
        }
    }
}
} // namespace

Match match(const std::vector<const Mesh *> &inputs, const Mesh &result) {
    if (!inputs.empty() && inputs[0]->points.size() == result.points.size() && inputs[0]->offsets == result.offsets &&
        inputs[0]->corners == result.corners) {
        return same_faces(*inputs[0], result);
    }
    const Places places(inputs);
    std::vector<uint32_t> of_result;
    for (const Point &point : result.points) {
        of_result.push_back(places.of(point));
    }
    Faces faces(inputs, places);
    Match made;
    made.vertices.resize(result.points.size());
    std::vector<std::vector<uint32_t>> now;
    for (std::size_t f = 0; f < result.face_count(); ++f) {
        now.push_back(places_of(result, f, of_result));
        made.faces.push_back(face_of(inputs, places, faces, now.back()));
    }
    for (std::size_t f = 0; f < result.face_count(); ++f) {
        if (!made.faces[f]) {
            made.faces[f] = face_at(inputs, places, faces, f, now[f]);
        }
    }
    match_vertices(inputs, result, places, of_result, made);
    return made;
}

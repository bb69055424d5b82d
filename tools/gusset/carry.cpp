#include "carry.hpp"

#include "attributes.hpp"
#include "failure.hpp"
#include "match.hpp"

#include <algorithm>
#include <set>

namespace {
template <std::size_t N> using Values = std::vector<std::array<double, N>>;

template <std::size_t N> void add(std::array<double, N> &to, const std::array<double, N> &value) {
    for (std::size_t k = 0; k < N; ++k) {
        to[k] += value[k];
    }
}

/// Gives vertices without a value the mean of their neighbours that have one, ring after ring.
template <std::size_t N> void spread(const Mesh &mesh, Values<N> &values) {
    std::vector<uint32_t> open;
    for (uint32_t f = 0; f < mesh.face_count(); ++f) {
        open.push_back(f);
    }
    while (true) {
        const auto without = [&](uint32_t f) {
            return std::any_of(mesh.corners.begin() + mesh.offsets[f], mesh.corners.begin() + mesh.offsets[f + 1],
                               [&](uint32_t v) { return is_missing(values[v]); });
        };
        open.erase(std::remove_if(open.begin(), open.end(), [&](uint32_t f) { return !without(f); }), open.end());
        std::vector<std::pair<uint32_t, uint32_t>> links;
        for (const uint32_t f : open) {
            for (std::size_t k = 0; k < mesh.degree(f); ++k) {
                const uint32_t a = mesh.corners[mesh.offsets[f] + k];
                const uint32_t b = mesh.corners[mesh.offsets[f] + (k + 1) % mesh.degree(f)];
                if (is_missing(values[a]) != is_missing(values[b])) {
                    links.emplace_back(is_missing(values[a]) ? std::pair(a, b) : std::pair(b, a));
                }
            }
        }
        if (links.empty()) {
            return;
        }
        // Sorted, as the sum depends on the order.
        std::sort(links.begin(), links.end());
        links.erase(std::unique(links.begin(), links.end()), links.end());
        for (auto next = links.begin(); next != links.end();) {
            const uint32_t vertex = next->first;
            std::array<double, N> sum{};
            double count = 0;
            for (; next != links.end() && next->first == vertex; ++next, ++count) {
                // What was given in this ring is not counted: its links are to vertices of rings before.
                add(sum, values[next->second]);
            }
            for (double &part : sum) {
                part /= count;
            }
            values[vertex] = sum;
        }
    }
}

std::array<double, 4> wide(const Colour &colour) {
    std::array<double, 4> made;
    std::copy(colour.begin(), colour.end(), made.begin());
    return made;
}

/// A mean as a colour, as one of 256 steps if the others are.
Colour narrow(const std::array<double, 4> &value, bool steps) {
    Colour made = white;
    for (std::size_t k = 0; k < 4 && !is_missing(value); ++k) {
        made[k] = static_cast<float>(value[k]);
        if (steps) {
            made[k] = static_cast<float>(step_of(made[k])) / 255;
        }
    }
    return made;
}

class Carrier {
public:
    Carrier(const std::vector<Piece> &pieces_, Mesh &result_)
        : pieces(pieces_), result(result_), found(match(meshes(), result_)) {}

    std::vector<std::string> run() {
        const bool any =
            std::any_of(found.vertices.begin(), found.vertices.end(), [](const auto &v) { return v.has_value(); });
        if (!any) {
            std::set<std::string> names;
            for (const Piece &piece : pieces) {
                const auto of_piece = attribute_names(*piece.mesh);
                names.insert(of_piece.begin(), of_piece.end());
            }
            for (const std::string &name : names) {
                lost.push_back(name + ": the result has no vertex of the input");
            }
            return lost;
        }
        carry_vertex_colours();
        carry_face_colours();
        carry_texcoords();
        carry_normals();
        simplify(result);
        return lost;
    }

private:
    std::vector<const Mesh *> meshes() const {
        std::vector<const Mesh *> all;
        for (const Piece &piece : pieces) {
            all.push_back(piece.mesh);
        }
        return all;
    }

    /// Whether any input has it; a remark on those that do not.
    template <class Has> bool present(Has has, const std::string &what, const std::string &instead) {
        std::vector<std::string> without;
        for (const Piece &piece : pieces) {
            if (!has(*piece.mesh)) {
                without.push_back(piece.name);
            }
        }
        if (without.size() == pieces.size()) {
            return false;
        }
        for (const std::string &name : without) {
            if (!instead.empty()) {
                lost.push_back("no " + what + " in " + name + ": " + instead);
            }
        }
        return true;
    }

    const Mesh &input(uint32_t place) const { return *pieces[place].mesh; }

    void carry_vertex_colours() {
        if (!present([](const Mesh &mesh) { return !mesh.vertex_colours.empty(); }, "colours of vertices",
                     "white is taken")) {
            return;
        }
        bool steps = true;
        for (const Piece &piece : pieces) {
            steps = steps && are_steps(piece.mesh->vertex_colours);
        }
        Values<4> values;
        for (const auto &origin : found.vertices) {
            const bool has = origin && !input(origin->input).vertex_colours.empty();
            values.push_back(has      ? wide(input(origin->input).vertex_colours[origin->vertex])
                             : origin ? wide(white)
                                      : missing<4>());
        }
        say_merged();
        spread(result, values);
        for (std::size_t v = 0; v < values.size(); ++v) {
            // Steps stay what they are.
            const auto &origin = found.vertices[v];
            result.vertex_colours.push_back(origin && !input(origin->input).vertex_colours.empty()
                                                ? input(origin->input).vertex_colours[origin->vertex]
                                                : narrow(values[v], steps));
        }
    }

    /// Of vertices that became one, whose colours differed.
    void say_merged() {
        std::size_t count = 0;
        for (std::size_t f = 0; f < result.face_count(); ++f) {
            for (std::size_t k = 0; found.faces[f] && k < result.degree(f); ++k) {
                const auto &face = *found.faces[f];
                const Mesh &from = input(face.input);
                if (from.vertex_colours.empty()) {
                    continue;
                }
                const uint32_t was = from.corners[from.offsets[face.face] + corner_of(face, k, result.degree(f))];
                const auto &kept = found.vertices[result.corners[result.offsets[f] + k]];
                const Mesh &other = input(kept->input);
                count += !other.vertex_colours.empty() && other.vertex_colours[kept->vertex] != from.vertex_colours[was]
                             ? 1
                             : 0;
            }
        }
        if (count > 0) {
            lost.push_back("colours of " + number_of(count, "corner") +
                           " whose vertices were welded to others of another colour");
        }
    }

    void carry_face_colours() {
        if (!present([](const Mesh &mesh) { return !mesh.face_colours.empty(); }, "colours of faces",
                     "white is taken")) {
            return;
        }
        bool steps = true;
        for (const Piece &piece : pieces) {
            steps = steps && are_steps(piece.mesh->face_colours);
        }
        // The mean of the old faces at each vertex, and from it the new ones.
        Values<4> sums(result.points.size());
        std::vector<double> counts(result.points.size());
        const auto colour = [&](const FaceOrigin &origin) {
            return input(origin.input).face_colours.empty() ? white : input(origin.input).face_colours[origin.face];
        };
        for (std::size_t f = 0; f < result.face_count(); ++f) {
            for (uint32_t c = result.offsets[f]; found.faces[f] && c < result.offsets[f + 1]; ++c) {
                add(sums[result.corners[c]], wide(colour(*found.faces[f])));
                ++counts[result.corners[c]];
            }
        }
        for (std::size_t v = 0; v < sums.size(); ++v) {
            for (double &part : sums[v]) {
                part = counts[v] > 0 ? part / counts[v] : std::nan("");
            }
        }
        spread(result, sums);
        for (std::size_t f = 0; f < result.face_count(); ++f) {
            if (found.faces[f]) {
                result.face_colours.push_back(colour(*found.faces[f]));
                continue;
            }
            std::array<double, 4> mean{};
            for (uint32_t c = result.offsets[f]; c < result.offsets[f + 1]; ++c) {
                add(mean, sums[result.corners[c]]);
            }
            for (double &part : mean) {
                part /= static_cast<double>(result.degree(f));
            }
            result.face_colours.push_back(narrow(mean, steps));
        }
    }

    /// The values at the corners of old faces; missing at those of new ones.
    template <std::size_t N> Values<N> old_corners(Attribute<N> Mesh::*of) const {
        Values<N> values(result.corners.size(), missing<N>());
        for (std::size_t f = 0; f < result.face_count(); ++f) {
            for (std::size_t k = 0; found.faces[f] && k < result.degree(f); ++k) {
                const auto &face = *found.faces[f];
                const Mesh &from = input(face.input);
                const Attribute<N> &attribute = from.*of;
                const std::size_t corner = from.offsets[face.face] + corner_of(face, k, result.degree(f));
                if (attribute) {
                    values[result.offsets[f] + k] = attribute.at == Attribute<N>::At::corners
                                                        ? attribute.values[corner]
                                                        : attribute.values[from.corners[corner]];
                }
            }
        }
        return values;
    }

    /// At vertices whose old corners agree.
    template <std::size_t N> Values<N> agreed(const Values<N> &corners) const {
        Values<N> values(result.points.size(), missing<N>());
        std::vector<bool> torn(result.points.size());
        for (std::size_t c = 0; c < corners.size(); ++c) {
            auto &value = values[result.corners[c]];
            if (!is_missing(corners[c])) {
                torn[result.corners[c]] = torn[result.corners[c]] || (!is_missing(value) && value != corners[c]);
                value = corners[c];
            }
        }
        for (std::size_t v = 0; v < values.size(); ++v) {
            values[v] = torn[v] ? missing<N>() : values[v];
        }
        return values;
    }

    void carry_texcoords() {
        if (!present([](const Mesh &mesh) { return bool(mesh.texcoords); }, "texture coordinates",
                     "its faces have none")) {
            return;
        }
        if (found.moved || all_same()) {
            result.texcoords = input(0).texcoords;
            return;
        }
        using At = Attribute<2>::At;
        Values<2> corners = old_corners(&Mesh::texcoords);
        const bool continuous = std::all_of(
            pieces.begin(), pieces.end(), [](const Piece &piece) { return piece.mesh->texcoords.at == At::vertices; });
        std::size_t bare = 0;
        if (continuous) {
            Values<2> values = agreed(corners);
            spread(result, values);
            fill(corners, values);
        }
        for (std::size_t f = 0; f < result.face_count(); ++f) {
            bare += !found.faces[f] && is_missing(corners[result.offsets[f]]) ? 1 : 0;
        }
        if (bare > 0) {
            lost.push_back("no texture coordinates on " + number_of(bare, "new face"));
        }
        result.texcoords = {At::corners, std::move(corners)};
    }

    /// Corners of new faces, by their vertices.
    template <std::size_t N> void fill(Values<N> &corners, const Values<N> &values) const {
        for (std::size_t f = 0; f < result.face_count(); ++f) {
            for (uint32_t c = result.offsets[f]; !found.faces[f] && c < result.offsets[f + 1]; ++c) {
                corners[c] = values[result.corners[c]];
            }
        }
    }

    void carry_normals() {
        if (!present([](const Mesh &mesh) { return bool(mesh.normals); }, "normals", "")) {
            return;
        }
        if (found.moved) {
            lost.emplace_back("normals, as vertices were moved");
            return;
        }
        if (all_same()) {
            result.normals = input(0).normals;
            return;
        }
        Values<3> corners = old_corners(&Mesh::normals);
        for (std::size_t f = 0; f < result.face_count(); ++f) {
            for (uint32_t c = result.offsets[f]; found.faces[f] && found.faces[f]->turned && c < result.offsets[f + 1];
                 ++c) {
                for (double &part : corners[c]) {
                    part = -part;
                }
            }
        }
        const Values<3> own = agreed(corners), computed = of_faces();
        for (std::size_t c = 0; c < corners.size(); ++c) {
            const uint32_t v = result.corners[c];
            corners[c] = !is_missing(corners[c]) ? corners[c] : !is_missing(own[v]) ? own[v] : computed[v];
        }
        result.normals = {Attribute<3>::At::corners, std::move(corners)};
    }

    /// The directions that faces have on average at each vertex, by their areas.
    Values<3> of_faces() const {
        Values<3> sums(result.points.size());
        for (std::size_t f = 0; f < result.face_count(); ++f) {
            std::array<double, 3> area{};
            const Point &origin = result.points[result.corners[result.offsets[f]]];
            for (std::size_t k = 1; k + 1 < result.degree(f); ++k) {
                const Point &p = result.points[result.corners[result.offsets[f] + k]];
                const Point &q = result.points[result.corners[result.offsets[f] + k + 1]];
                for (std::size_t i = 0; i < 3; ++i) {
                    const std::size_t a = (i + 1) % 3, b = (i + 2) % 3;
                    area[i] += (p[a] - origin[a]) * (q[b] - origin[b]) - (p[b] - origin[b]) * (q[a] - origin[a]);
                }
            }
            for (uint32_t c = result.offsets[f]; c < result.offsets[f + 1]; ++c) {
                add(sums[result.corners[c]], area);
            }
        }
        for (auto &sum : sums) {
            const double length = std::hypot(sum[0], sum[1], sum[2]);
            for (double &part : sum) {
                part = length > 0 ? part / length : 0;
            }
        }
        return sums;
    }

    /// The result is the first input.
    bool all_same() const {
        return result.points == input(0).points && result.offsets == input(0).offsets &&
               result.corners == input(0).corners;
    }

    const std::vector<Piece> &pieces;
    Mesh &result;
    const Match found;
    std::vector<std::string> lost;
};
} // namespace

std::vector<std::string> carry(const std::vector<Piece> &pieces, Mesh &result) {
    const bool bare = std::all_of(pieces.begin(), pieces.end(),
                                  [](const Piece &piece) { return attribute_names(*piece.mesh).empty(); });
    return bare ? std::vector<std::string>() : Carrier(pieces, result).run();
}

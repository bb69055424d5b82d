#include "carry.hpp"

#include "attributes.hpp"
#include "failure.hpp"

#include <algorithm>
#include <set>

namespace {
constexpr const char *moved_normals = "normals, as vertices were moved";

template <std::size_t N> using Values = std::vector<std::array<double, N>>;

/// Whether a value is one that means or copies can be taken of.
template <std::size_t N> bool is_finite(const std::array<double, N> &value) {
    return std::all_of(value.begin(), value.end(), [](double x) { return std::isfinite(x); });
}

Values<4> wide(const std::vector<Colour> &colours) {
    Values<4> made(colours.size());
    for (std::size_t k = 0; k < colours.size(); ++k) {
        std::copy(colours[k].begin(), colours[k].end(), made[k].begin());
    }
    return made;
}

std::vector<std::string> all_names(const std::vector<Piece> &pieces) {
    std::vector<std::string> names;
    for (const Piece &piece : pieces) {
        for (const std::string &name : attribute_names(*piece.mesh)) {
            if (std::find(names.begin(), names.end(), name) == names.end()) {
                names.push_back(name);
            }
        }
    }
    return names;
}

class Carrier {
public:
    Carrier(const std::vector<Piece> &pieces_, const Origins &origins_, Mesh &result_)
        : pieces(pieces_), origins(origins_), result(result_) {}

    std::vector<std::string> run() {
        carry_colours(&Mesh::vertex_colours, GUSSET_PLUGIN_VERTICES, "colours of vertices");
        carry_colours(&Mesh::face_colours, GUSSET_PLUGIN_FACES, "colours of faces");
        carry_texcoords();
        carry_normals();
        carry_materials();
        carry_properties();
        simplify(result);
        return lost;
    }

private:
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

    /// The values of the result's elements; missing where a source has none.
    template <std::size_t N> Values<N> carried(uint32_t domain, uint32_t rule, const std::vector<Values<N>> &given) {
        std::vector<std::vector<double>> flat(given.size()), present(given.size());
        bool all = true;
        for (std::size_t i = 0; i < given.size(); ++i) {
            for (const auto &value : given[i]) {
                const bool there = is_finite(value);
                for (const double x : value) {
                    flat[i].push_back(there ? x : 0);
                }
                present[i].push_back(there ? 1 : 0);
                all = all && there;
            }
        }
        const std::vector<double> values = origins.apply(domain, rule, N, flat);
        Values<N> made(values.size() / N);
        for (std::size_t k = 0; k < values.size(); ++k) {
            made[k / N][k % N] = values[k];
        }
        if (!all) {
            const std::vector<double> parts = origins.apply(domain, GUSSET_PLUGIN_RULE_LINEAR, 1, present);
            for (std::size_t k = 0; k < made.size(); ++k) {
                // The sum of weights is 1 but for rounding.
                if (parts[k] < 1 - 1e-9) {
                    made[k] = missing<N>();
                }
            }
        }
        return made;
    }

    void carry_colours(std::vector<Colour> Mesh::*of, uint32_t domain, const std::string &what) {
        if (!present([&](const Mesh &mesh) { return !(mesh.*of).empty(); }, what, "white is taken")) {
            return;
        }
        std::vector<Values<4>> given;
        bool steps = true;
        for (const Piece &piece : pieces) {
            const Mesh &mesh = *piece.mesh;
            steps = steps && are_steps(mesh.*of);
            const std::size_t count = domain == GUSSET_PLUGIN_FACES ? mesh.face_count() : mesh.points.size();
            given.push_back((mesh.*of).empty() ? Values<4>(count, {1, 1, 1, 1}) : wide(mesh.*of));
        }
        const Values<4> values = carried(domain, GUSSET_PLUGIN_RULE_LINEAR, given);
        const gusset_plugin_origins from = origins.of(domain);
        std::vector<Colour> &colours = result.*of;
        colours.assign(values.size(), white);
        for (std::size_t k = 0; k < values.size(); ++k) {
            const bool is_new = from.offsets[k + 1] > from.offsets[k] + 1;
            for (std::size_t c = 0; c < 4 && !is_missing(values[k]); ++c) {
                const auto part = static_cast<float>(values[k][c]);
                // What is one of 256 steps everywhere stays one.
                colours[k][c] = steps && is_new ? static_cast<float>(step_of(part)) / 255 : part;
            }
        }
    }

    /// What each input has at its corners, missing in those without.
    template <std::size_t N> std::vector<Values<N>> corners_of(Attribute<N> Mesh::*of) const {
        std::vector<Values<N>> given;
        for (const Piece &piece : pieces) {
            const Mesh &mesh = *piece.mesh;
            given.push_back(mesh.*of ? at_corners(mesh, mesh.*of) : Values<N>(mesh.corners.size(), missing<N>()));
        }
        return given;
    }

    void carry_texcoords() {
        if (!present([](const Mesh &mesh) { return bool(mesh.texcoords); }, "texture coordinates",
                     "its faces have none")) {
            return;
        }
        result.texcoords = {Attribute<2>::At::corners, carried(GUSSET_PLUGIN_CORNERS, GUSSET_PLUGIN_RULE_TEXTURE,
                                                               corners_of(&Mesh::texcoords))};
    }

    void carry_normals() {
        if (!present([](const Mesh &mesh) { return bool(mesh.normals); }, "normals", "")) {
            return;
        }
        if (are_moved()) {
            lost.emplace_back(moved_normals);
            return;
        }
        using At = Attribute<3>::At;
        const bool smooth = std::all_of(pieces.begin(), pieces.end(),
                                        [](const Piece &piece) { return piece.mesh->normals.at == At::vertices; });
        if (smooth) {
            std::vector<Values<3>> given;
            for (const Piece &piece : pieces) {
                given.push_back(piece.mesh->normals.values);
            }
            result.normals = {At::vertices, carried(GUSSET_PLUGIN_VERTICES, GUSSET_PLUGIN_RULE_NORMAL, given)};
        } else {
            result.normals = {At::corners, carried(GUSSET_PLUGIN_CORNERS, GUSSET_PLUGIN_RULE_NORMAL,
                                                   corners_of(&Mesh::normals))};
        }
        const Values<3> computed = of_faces();
        for (std::size_t k = 0; k < result.normals.values.size(); ++k) {
            auto &normal = result.normals.values[k];
            normal = is_missing(normal) ? computed[smooth ? k : result.corners[k]] : normal;
        }
    }

    /// Whether a vertex is elsewhere than the one that it comes from.
    bool are_moved() const {
        const gusset_plugin_origins from = origins.of(GUSSET_PLUGIN_VERTICES);
        for (std::size_t v = 0; v < result.points.size(); ++v) {
            if (from.offsets[v + 1] != from.offsets[v] + 1) {
                continue;
            }
            const uint32_t source = from.sources[from.offsets[v]];
            std::size_t i = 0;
            while (source >= from.starts[i + 1]) {
                ++i;
            }
            if (pieces[i].mesh->points[source - from.starts[i]] != result.points[v]) {
                return true;
            }
        }
        return false;
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
                for (std::size_t i = 0; i < 3; ++i) {
                    sums[result.corners[c]][i] += area[i];
                }
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

    void carry_materials() {
        if (!present([](const Mesh &mesh) { return !mesh.face_materials.empty(); }, "materials",
                     "its faces have none")) {
            return;
        }
        // Their numbers from 1 among all; 0 for none.
        std::vector<Values<1>> given;
        for (const Piece &piece : pieces) {
            std::vector<uint32_t> numbers;
            for (const Material &material : piece.mesh->materials) {
                numbers.push_back(number_of_material(result.materials, material));
            }
            given.emplace_back(piece.mesh->face_count());
            for (std::size_t f = 0; f < piece.mesh->face_materials.size(); ++f) {
                const uint32_t own = piece.mesh->face_materials[f];
                given.back()[f][0] = own == no_material ? 0 : numbers[own] + 1.0;
            }
        }
        for (const auto &[number] : carried(GUSSET_PLUGIN_FACES, GUSSET_PLUGIN_RULE_NEAREST, given)) {
            result.face_materials.push_back(number == 0 ? no_material : static_cast<uint32_t>(number) - 1);
        }
    }

    static const Property *find(const Mesh &mesh, const Property &like) {
        const auto found = std::find_if(mesh.properties.begin(), mesh.properties.end(), [&](const Property &one) {
            return one.name == like.name && one.of_faces == like.of_faces && one.type == like.type;
        });
        return found == mesh.properties.end() ? nullptr : &*found;
    }

    void carry_properties() {
        for (const Piece &piece : pieces) {
            for (const Property &property : piece.mesh->properties) {
                if (find(result, property) == nullptr) {
                    carry_property(property);
                }
            }
        }
    }

    static double of_source(const std::vector<Values<1>> &given, const gusset_plugin_origins &from, uint32_t source) {
        std::size_t i = 0;
        while (source >= from.starts[i + 1]) {
            ++i;
        }
        return given[i][source - from.starts[i]][0];
    }

    void carry_property(const Property &property) {
        static_cast<void>(present([&](const Mesh &mesh) { return find(mesh, property) != nullptr; }, property.name,
                                  "0 is taken"));
        std::vector<Values<1>> given;
        for (const Piece &piece : pieces) {
            const Property *own = find(*piece.mesh, property);
            given.emplace_back(property.of_faces ? piece.mesh->face_count() : piece.mesh->points.size());
            for (std::size_t k = 0; own != nullptr && k < own->values.size(); ++k) {
                given.back()[k][0] = own->values[k];
            }
        }
        Property made{property.name, property.type, property.of_faces, {}};
        const uint32_t domain = property.of_faces ? GUSSET_PLUGIN_FACES : GUSSET_PLUGIN_VERTICES;
        const uint32_t rule = property.is_whole() ? GUSSET_PLUGIN_RULE_NEAREST : GUSSET_PLUGIN_RULE_LINEAR;
        // Old elements keep what they had, numbers or not.
        const gusset_plugin_origins from = origins.of(domain);
        const Values<1> values = carried(domain, rule, given);
        for (std::size_t k = 0; k < values.size(); ++k) {
            const bool is_old = from.offsets[k + 1] == from.offsets[k] + 1;
            made.values.push_back(is_old ? of_source(given, from, from.sources[from.offsets[k]]) : values[k][0]);
        }
        result.properties.push_back(std::move(made));
    }

    const std::vector<Piece> &pieces;
    const Origins &origins;
    Mesh &result;
    std::vector<std::string> lost;
};
/// To the same vertices and faces, the vertices perhaps elsewhere.
std::vector<std::string> carry_all(const Mesh &from, Mesh &result) {
    const bool moved = result.points != from.points;
    Mesh made = from;
    made.points = std::move(result.points);
    made.normals = moved ? Attribute<3>() : std::move(made.normals);
    result = std::move(made);
    return moved && from.normals ? std::vector<std::string>{moved_normals} : std::vector<std::string>();
}
} // namespace

std::vector<std::string> carry(const std::vector<Piece> &pieces, const Origins &origins, Mesh &result) {
    std::vector<std::string> names = all_names(pieces);
    if (names.empty() || origins.are_known()) {
        return names.empty() ? names : Carrier(pieces, origins, result).run();
    }
    const Mesh &first = *pieces[0].mesh;
    if (result.points.size() == first.points.size() && result.offsets == first.offsets &&
        result.corners == first.corners) {
        return carry_all(first, result);
    }
    for (std::string &name : names) {
        name += ": the filter does not tell where its result comes from";
    }
    return names;
}

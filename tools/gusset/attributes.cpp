#include "attributes.hpp"

#include <algorithm>

namespace {
template <std::size_t N> void simplify(const Mesh &mesh, Attribute<N> &of) {
    if (of.at != Attribute<N>::At::corners) {
        return;
    }
    if (auto values = at_vertices(mesh, of)) {
        of = {Attribute<N>::At::vertices, std::move(*values)};
    }
}

template <std::size_t N> void name(const Attribute<N> &of, const std::string &what, std::vector<std::string> &names) {
    if (of) {
        names.push_back(what + (of.at == Attribute<N>::At::vertices ? " of vertices" : " of corners"));
    }
}
} // namespace

void simplify(Mesh &mesh) {
    simplify(mesh, mesh.normals);
    simplify(mesh, mesh.texcoords);
}

uint8_t step_of(float part) {
    // NaN is 0.
    return part > 0 ? static_cast<uint8_t>(std::lround(255 * std::min(part, 1.0F))) : uint8_t{0};
}

bool are_steps(const std::vector<Colour> &colours) {
    // The six digits of a text are enough to find the step again.
    constexpr float tolerance = 1e-3F;
    return std::all_of(colours.begin(), colours.end(), [&](const Colour &colour) {
        return std::all_of(colour.begin(), colour.end(), [&](float part) {
            return std::abs(255 * part - static_cast<float>(step_of(part))) <= tolerance;
        });
    });
}

bool are_opaque(const std::vector<Colour> &colours) {
    return std::all_of(colours.begin(), colours.end(), [](const Colour &colour) { return colour[3] == 1; });
}

bool is_single(double value) { return std::isnan(value) || static_cast<double>(static_cast<float>(value)) == value; }

bool is_single(const std::vector<Point> &points) {
    return std::all_of(points.begin(), points.end(), [](const Point &point) {
        return std::all_of(point.begin(), point.end(), [](double x) { return is_single(x); });
    });
}

std::vector<std::string> attribute_names(const Mesh &mesh) {
    std::vector<std::string> names;
    if (!mesh.vertex_colours.empty()) {
        names.emplace_back("colours of vertices");
    }
    if (!mesh.face_colours.empty()) {
        names.emplace_back("colours of faces");
    }
    name(mesh.normals, "normals", names);
    name(mesh.texcoords, "texture coordinates", names);
    if (!mesh.face_materials.empty()) {
        names.emplace_back("materials");
    }
    for (const Property &property : mesh.properties) {
        names.push_back(property.name + (property.of_faces ? " of faces" : " of vertices"));
    }
    return names;
}

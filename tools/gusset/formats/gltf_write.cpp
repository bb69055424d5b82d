// glTF by tinygltf: one mesh of triangles in a buffer within the file. Polygons are fans by an extension that readers
// may ignore, and vertices whose corners carry different values are divided, with a note of what they were.
#include "../attributes.hpp"
#include "../failure.hpp"
#include "formats.hpp"
#include "gltf_materials.hpp"
#include "gltf_values.hpp"
#include "triangles.hpp"
#include "writer.hpp"

#include <tiny_gltf.h>

#include <algorithm>
#include <limits>
#include <map>
#include <sstream>

namespace {
template <std::size_t N> using Values = std::vector<std::array<double, N>>;

/// A mesh whose normals and texture coordinates are at its vertices, and the vertex that each was.
struct Divided {
    std::vector<uint32_t> corners, origins;
    std::vector<std::array<double, 3>> normals;
    std::vector<std::array<double, 2>> texcoords;
};

Divided divided(const Mesh &mesh) {
    Divided made;
    made.corners = mesh.corners;
    for (std::size_t v = 0; v < mesh.points.size(); ++v) {
        made.origins.push_back(static_cast<uint32_t>(v));
    }
    const auto normals = mesh.normals ? at_vertices(mesh, mesh.normals) : std::nullopt;
    const auto texcoords = mesh.texcoords ? at_vertices(mesh, mesh.texcoords) : std::nullopt;
    if (bool(normals) == bool(mesh.normals) && bool(texcoords) == bool(mesh.texcoords)) {
        made.normals = normals.value_or(made.normals);
        made.texcoords = texcoords.value_or(made.texcoords);
        return made;
    }
    // Vertices that no face uses have what is at vertices.
    made.normals = normals.value_or(Values<3>(mesh.normals ? mesh.points.size() : 0, missing<3>()));
    made.texcoords = texcoords.value_or(Values<2>(mesh.texcoords ? mesh.points.size() : 0, missing<2>()));
    const auto corner_normals = mesh.normals ? at_corners(mesh, mesh.normals) : made.normals;
    const auto corner_texcoords = mesh.texcoords ? at_corners(mesh, mesh.texcoords) : made.texcoords;
    // What is missing is 0 in the file; NaN would be equal to nothing.
    const auto shown = [](auto value) {
        if (is_missing(value)) {
            value.fill(0);
        }
        return value;
    };
    std::map<std::pair<uint32_t, std::array<double, 5>>, uint32_t> known;
    std::vector<bool> taken(mesh.points.size());
    for (std::size_t c = 0; c < mesh.corners.size(); ++c) {
        const uint32_t v = mesh.corners[c];
        std::array<double, 5> key{};
        if (mesh.normals) {
            const auto value = shown(corner_normals[c]);
            std::copy(value.begin(), value.end(), key.begin());
        }
        if (mesh.texcoords) {
            const auto value = shown(corner_texcoords[c]);
            std::copy(value.begin(), value.end(), key.begin() + 3);
        }
        const auto next = taken[v] ? static_cast<uint32_t>(made.origins.size()) : v;
        const auto [place, is_new] = known.emplace(std::pair(v, key), next);
        made.corners[c] = place->second;
        if (!is_new) {
            continue;
        }
        if (taken[v]) {
            made.origins.push_back(v);
            made.normals.resize(mesh.normals ? made.origins.size() : 0);
            made.texcoords.resize(mesh.texcoords ? made.origins.size() : 0);
        }
        taken[v] = true;
        if (mesh.normals) {
            made.normals[next] = shown(corner_normals[c]);
        }
        if (mesh.texcoords) {
            made.texcoords[next] = shown(corner_texcoords[c]);
        }
    }
    return made;
}

/// A model that grows by one accessor after the other.
class Builder {
public:
    Builder() {
        model.asset.version = "2.0";
        model.asset.generator = "gusset";
        model.buffers.emplace_back();
        model.meshes.emplace_back();
        model.meshes[0].primitives.emplace_back();
        primitive().mode = TINYGLTF_MODE_TRIANGLES;
        model.nodes.emplace_back();
        model.nodes[0].mesh = 0;
        model.scenes.emplace_back();
        model.scenes[0].nodes = {0};
        model.defaultScene = 0;
    }

    tinygltf::Primitive &primitive() { return model.meshes[0].primitives.back(); }
    /// Another one of the same vertices.
    void next_primitive() {
        tinygltf::Primitive next;
        next.mode = TINYGLTF_MODE_TRIANGLES;
        next.attributes = primitive().attributes;
        model.meshes[0].primitives.push_back(next);
    }

    template <class T> void put(T value) {
        const auto *bytes = reinterpret_cast<const unsigned char *>(&value);
        auto &data = model.buffers[0].data;
        data.insert(data.end(), bytes, bytes + sizeof value);
    }

    /// What was put since the last one, as an accessor; returns its number.
    int close(int component, int type, std::size_t count, int target) {
        auto &data = model.buffers[0].data;
        tinygltf::BufferView view;
        view.buffer = 0;
        view.byteOffset = start;
        view.byteLength = data.size() - start;
        view.target = target;
        // The next one begins at a whole word.
        data.resize((data.size() + 3) / 4 * 4);
        start = data.size();
        model.bufferViews.push_back(view);
        tinygltf::Accessor accessor;
        accessor.bufferView = static_cast<int>(model.bufferViews.size() - 1);
        accessor.byteOffset = 0;
        accessor.componentType = component;
        accessor.type = type;
        accessor.count = count;
        model.accessors.push_back(accessor);
        return static_cast<int>(model.accessors.size() - 1);
    }

    tinygltf::Model model;

private:
    std::size_t start = 0;
};

float single(double value) { return static_cast<float>(std::isnan(value) ? 0 : value); }

void add_positions(Builder &builder, const Mesh &mesh, const Divided &as) {
    std::array<double, 3> low, high;
    low.fill(std::numeric_limits<double>::infinity());
    high.fill(-std::numeric_limits<double>::infinity());
    for (const uint32_t v : as.origins) {
        for (std::size_t k = 0; k < 3; ++k) {
            const float x = single(mesh.points[v][k]);
            builder.put(x);
            low[k] = std::min(low[k], static_cast<double>(x));
            high[k] = std::max(high[k], static_cast<double>(x));
        }
    }
    const int made = builder.close(TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_VEC3, as.origins.size(),
                                   TINYGLTF_TARGET_ARRAY_BUFFER);
    builder.model.accessors.back().minValues.assign(low.begin(), low.end());
    builder.model.accessors.back().maxValues.assign(high.begin(), high.end());
    builder.primitive().attributes["POSITION"] = made;
}

void add_colours(Builder &builder, const Mesh &mesh, const Divided &as) {
    // As floats: eight bits are too few for linear parts, and MeshLab 2025.07 takes sixteen for eight.
    for (const uint32_t v : as.origins) {
        for (std::size_t k = 0; k < 4; ++k) {
            const auto part = static_cast<double>(mesh.vertex_colours[v][k]);
            builder.put(static_cast<float>(k == 3 ? part : linear_of(part)));
        }
    }
    builder.primitive().attributes["COLOR_0"] = builder.close(TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_VEC4,
                                                              as.origins.size(), TINYGLTF_TARGET_ARRAY_BUFFER);
}

/// The vertex that each one was before it was divided, here or where the mesh comes from.
std::vector<uint32_t> undivided(const Mesh &mesh, const Divided &as) {
    std::vector<uint32_t> made = as.origins;
    for (uint32_t &v : made) {
        v = mesh.merge.empty() ? v : mesh.merge[v];
    }
    return made;
}

/// Whether a reader must be told: where vertices were divided, and where others at equal positions were not.
bool needs_origins(const Mesh &mesh, const std::vector<uint32_t> &undivided) {
    for (std::size_t v = 0; v < undivided.size(); ++v) {
        if (undivided[v] != v) {
            return true;
        }
    }
    std::vector<std::array<float, 3>> places;
    for (const Point &point : mesh.points) {
        places.push_back({single(point[0]), single(point[1]), single(point[2])});
    }
    std::sort(places.begin(), places.end());
    return std::adjacent_find(places.begin(), places.end()) != places.end();
}

void add_origins(Builder &builder, const Divided &as, const std::vector<uint32_t> &undivided) {
    for (const uint32_t v : undivided) {
        builder.put(static_cast<uint16_t>(v & 0xFFFF));
        builder.put(static_cast<uint16_t>(v >> 16));
    }
    builder.primitive().attributes[vertex_attribute] = builder.close(
        TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT, TINYGLTF_TYPE_VEC2, as.origins.size(), TINYGLTF_TARGET_ARRAY_BUFFER);
}

/// Faces as triangles of the last primitive; returns how many were left out.
std::size_t add_faces(Builder &builder, const Mesh &shown, const std::vector<std::size_t> &faces, bool polygons) {
    std::size_t count = 0, left_out = 0;
    std::optional<uint32_t> before;
    for (const std::size_t f : faces) {
        const std::size_t degree = shown.degree(f);
        if (degree < 3) {
            ++left_out;
            continue;
        }
        const std::size_t first = polygons ? fan_corner(shown, f, before) : 0;
        const auto vertex = [&](std::size_t k) { return shown.corners[shown.offsets[f] + (first + k) % degree]; };
        for (std::size_t k = 1; k + 1 < degree; ++k) {
            for (const uint32_t v : {vertex(0), vertex(k), vertex(k + 1)}) {
                builder.put(v);
            }
            count += 3;
        }
        before = vertex(0);
    }
    builder.primitive().indices = builder.close(TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT, TINYGLTF_TYPE_SCALAR, count,
                                                TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
    if (polygons) {
        builder.primitive().extensions[polygons_extension] = tinygltf::Value(tinygltf::Value::Object());
    }
    return left_out;
}

/// All faces, those of each material as one primitive; returns how many were left out.
std::size_t add_primitives(Builder &builder, const Mesh &mesh, const Divided &as, Losses &losses) {
    Mesh shown;
    shown.offsets = mesh.offsets;
    shown.corners = as.corners;
    bool polygons = false;
    for (const uint32_t v : as.origins) {
        shown.points.push_back(mesh.points[v]);
    }
    const UsedMaterials materials = used_materials(mesh);
    // By material, those without one at last.
    std::vector<std::vector<std::size_t>> faces(materials.all.size() + 1);
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        polygons = polygons || mesh.degree(f) > 3;
        const uint32_t material = materials.of_faces.empty() ? no_material : materials.of_faces[f];
        faces[std::min<std::size_t>(material, materials.all.size())].push_back(f);
    }
    if (polygons) {
        builder.model.extensionsUsed.emplace_back(polygons_extension);
    }
    MaterialWriter writer(builder.model, losses);
    std::size_t left_out = 0;
    bool first = true;
    for (std::size_t m = 0; m < faces.size(); ++m) {
        if (faces[m].empty() && !(first && m + 1 == faces.size())) {
            continue;
        }
        if (!first) {
            builder.next_primitive();
        }
        first = false;
        left_out += add_faces(builder, shown, faces[m], polygons);
    }
    // Images are behind everything else.
    std::size_t primitive = 0;
    for (std::size_t m = 0; m < materials.all.size(); ++m) {
        builder.model.meshes[0].primitives[primitive++].material = writer.add(*materials.all[m], materials.names[m]);
    }
    return left_out;
}

/// "positions and normals": what has digits beyond single precision.
std::string rounded_ones(const Mesh &mesh) {
    const auto are_single = [](const auto &values) {
        return std::all_of(values.begin(), values.end(), [](const auto &value) {
            return std::all_of(value.begin(), value.end(), [](double x) { return is_single(x); });
        });
    };
    std::string text;
    const auto name = [&](bool single, const char *what) {
        if (!single) {
            text += (text.empty() ? "" : " and ") + std::string(what);
        }
    };
    name(are_single(mesh.points), "positions");
    name(are_single(mesh.normals.values), "normals");
    name(are_single(mesh.texcoords.values), "texture coordinates");
    return text;
}

/// A corner that has no pair of its own shows the first point of the image.
bool are_some_missing(const Attribute<2> &of) {
    return of.at == Attribute<2>::At::corners &&
           std::any_of(of.values.begin(), of.values.end(), [](const auto &value) { return is_missing(value); });
}
} // namespace

Losses write_gltf(const std::string &path, const Mesh &mesh, bool binary) {
    const Divided as = divided(mesh);
    Builder builder;
    add_positions(builder, mesh, as);
    if (!as.normals.empty()) {
        for (const auto &normal : as.normals) {
            for (const double x : normal) {
                builder.put(single(x));
            }
        }
        builder.primitive().attributes["NORMAL"] = builder.close(TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_VEC3,
                                                                 as.normals.size(), TINYGLTF_TARGET_ARRAY_BUFFER);
    }
    if (!as.texcoords.empty()) {
        for (const auto &[u, v] : as.texcoords) {
            builder.put(single(u));
            // Images hang down from their first row here.
            builder.put(single(1 - v));
        }
        builder.primitive().attributes["TEXCOORD_0"] = builder.close(TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_VEC2,
                                                                     as.texcoords.size(), TINYGLTF_TARGET_ARRAY_BUFFER);
    }
    if (!mesh.vertex_colours.empty()) {
        add_colours(builder, mesh, as);
    }
    const std::vector<uint32_t> whole = undivided(mesh, as);
    if (needs_origins(mesh, whole)) {
        add_origins(builder, as, whole);
    }
    Losses losses;
    const std::size_t left_out = add_primitives(builder, mesh, as, losses);
    if (builder.model.buffers[0].data.size() > UINT32_MAX / 2) {
        throw Failure(Exit::file, path + ": glTF files of more than two gigabytes are not written");
    }
    std::ostringstream all;
    if (!tinygltf::TinyGLTF().WriteGltfSceneToStream(&builder.model, all, true, binary)) {
        throw Failure(Exit::file, path + ": it cannot be written as glTF");
    }
    Writer out(path);
    out << all.str();
    out.finish();
    const std::string rounded = rounded_ones(mesh);
    if (!rounded.empty()) {
        losses.push_back("digits of " + rounded + ": glTF files have single precision");
    }
    if (!mesh.face_colours.empty()) {
        losses.emplace_back("colours of faces, which glTF files do not hold");
    }
    if (left_out > 0) {
        losses.push_back(number_of(left_out, "face") + " of fewer than three corners");
    }
    if (are_some_missing(mesh.texcoords)) {
        losses.emplace_back("which corners have no texture coordinates: glTF files hold some for each");
    }
    return losses;
}

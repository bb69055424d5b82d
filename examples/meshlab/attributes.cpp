#include "attributes.hpp"

#include <algorithm>
#include <cmath>

namespace {

using vcg::Color4b;
using vcg::Point3f;

/// How the plugin sees values of a type.
struct Layout {
    std::uint32_t type, components;
};
template <class T> constexpr Layout layout{};
template <> constexpr Layout layout<Color4b>{GUSSET_PLUGIN_VALUE_U8, 4};
template <> constexpr Layout layout<float>{GUSSET_PLUGIN_VALUE_F32, 1};
template <> constexpr Layout layout<double>{GUSSET_PLUGIN_VALUE_F64, 1};
template <> constexpr Layout layout<Point3f>{GUSSET_PLUGIN_VALUE_F32, 3};
// Below 0 is none. It is copied, never mixed, so that the sign is safe.
template <> constexpr Layout layout<short>{GUSSET_PLUGIN_VALUE_U16, 1};

/// Whether means can be taken of a value.
bool is_finite(Scalarm value) { return std::isfinite(value); }
bool is_finite(const Point3f &p) { return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]); }
bool is_finite(const Color4b &) { return true; }
bool is_finite(short) { return true; }

/// Texture coordinates, with the scaled index of the texture as a third: coordinates in different textures then never
/// form one chart.
constexpr float APART = 1e6f;
constexpr short NO_TEXTURE = -1;
/// MeshLab's value for faces without a texture.
const Point3f nowhere(0.5f, 0.5f, APART *NO_TEXTURE);

Point3f coordinates(const CMeshO::FaceType::TexCoordType &from, short texture) {
    return {from.U(), from.V(), APART * static_cast<float>(texture)};
}

/// The textures of all inputs. Equal names are one texture, as they are where MeshLab itself joins layers.
class Textures {
public:
    explicit Textures(const Inputs &inputs) {
        for (std::size_t input = 0; input < inputs.list().size(); ++input) {
            std::vector<short> &numbers = numbers_.emplace_back();
            for (const std::string &name : inputs.layer(input).cm.textures) {
                const auto found = std::find(names_.begin(), names_.end(), name);
                numbers.push_back(static_cast<short>(found - names_.begin()));
                if (found == names_.end()) {
                    names_.push_back(name);
                }
            }
        }
    }

    const std::vector<std::string> &names() const { return names_; }

    /// The number among all of an input's own texture.
    short number(std::size_t input, short own) const {
        const std::vector<short> &numbers = numbers_[input];
        if (own >= 0 && static_cast<std::size_t>(own) < numbers.size()) {
            return numbers[static_cast<std::size_t>(own)];
        }
        // Without any names, the index may belong to a texture that does not exist yet.
        return names_.empty() ? own : NO_TEXTURE;
    }

private:
    std::vector<std::string> names_;
    std::vector<std::vector<short>> numbers_;
};

/// Mixes the values of layers for the elements of an output.
class Carrier {
public:
    Carrier(const Inputs &inputs, const Outputs &outputs, std::uint32_t index)
        : inputs_(inputs), outputs_(outputs), index_(index) {}

    /// The values of a domain's elements. `get(mesh, element, input)` reads the values of layers that have `what`, a
    /// MeshModel::MM_... Elements are vertices, triangles, or wedges, three to a triangle. Other layers, and
    /// what comes from nothing, have `blank`. Empty if no layer has it.
    template <class T, class Get>
    std::vector<T> carried(int what, std::uint32_t domain, std::uint32_t rule, const T &blank, Get get) const {
        std::vector<std::vector<T>> values;
        std::vector<gusset_plugin_channel_values> given;
        bool any = false;
        for (std::size_t input = 0; input < inputs_.list().size(); ++input) {
            const std::vector<std::size_t> elements = elements_of(input, domain);
            const MeshModel &layer = inputs_.layer(input);
            std::vector<T> &own = values.emplace_back(elements.size(), blank);
            for (std::size_t k = 0; k < elements.size() && layer.hasDataMask(what); ++k) {
                const T value = get(layer.cm, elements[k], input);
                own[k] = is_finite(value) ? value : blank;
                any = true;
            }
            given.push_back({own.data(), own.size(), 0});
        }
        if (!any) {
            return {};
        }
        gusset_plugin_channel channel{};
        channel.struct_size = sizeof channel;
        channel.domain = domain;
        channel.value_type = layout<T>.type;
        channel.components = layout<T>.components;
        channel.rule = rule;
        const gusset_plugin_origins origins = outputs_.origins(index_, domain);
        std::vector<T> made(origins.count, blank);
        outputs_.carry(index_, channel, given, made.data(), made.size());
        for (std::size_t k = 0; k < made.size(); ++k) {
            made[k] = origins.offsets[k] == origins.offsets[k + 1] ? blank : made[k];
        }
        return made;
    }

private:
    /// For each element of the input its element in the layer.
    std::vector<std::size_t> elements_of(std::size_t input, std::uint32_t domain) const {
        const Polygons &faces = inputs_.faces(input);
        if (inputs_.list()[input].kind != GUSSET_KIND_MESH) {
            return {};
        }
        if (domain == GUSSET_PLUGIN_CORNERS) {
            return {faces.wedges.begin(), faces.wedges.end()};
        }
        const bool vertices = domain == GUSSET_PLUGIN_VERTICES;
        std::vector<std::size_t> elements(vertices ? inputs_.layer(input).cm.vert.size() : faces.offsets.size() - 1);
        for (std::size_t k = 0; k < elements.size(); ++k) {
            // A polygon takes the values of the triangle at its first corner.
            elements[k] = vertices ? k : faces.wedges[faces.offsets[k]] / 3;
        }
        return elements;
    }

    const Inputs &inputs_;
    const Outputs &outputs_;
    std::uint32_t index_;
};

} // namespace

Attributes::Attributes(const Inputs &inputs, const Outputs &outputs, std::uint32_t index) {
    if (!outputs.has_origins(index)) {
        return;
    }
    const Textures textures(inputs);
    const Carrier carrier(inputs, outputs, index);
    const auto carry = [&](auto &values, int what, std::uint32_t domain, std::uint32_t rule, const auto &blank,
                           auto get) {
        values = carrier.carried(what, domain, rule, blank, get);
        which_ |= values.empty() ? 0 : what;
    };
    using Mesh = CMeshO;
    using Element = std::size_t;
    carry(vertex_colours_, MeshModel::MM_VERTCOLOR, GUSSET_PLUGIN_VERTICES, GUSSET_PLUGIN_RULE_LINEAR,
          Color4b(Color4b::White), [](const Mesh &mesh, Element v, std::size_t) { return mesh.vert[v].cC(); });
    carry(face_colours_, MeshModel::MM_FACECOLOR, GUSSET_PLUGIN_FACES, GUSSET_PLUGIN_RULE_LINEAR,
          Color4b(Color4b::White), [](const Mesh &mesh, Element f, std::size_t) { return mesh.face[f].cC(); });
    carry(vertex_qualities_, MeshModel::MM_VERTQUALITY, GUSSET_PLUGIN_VERTICES, GUSSET_PLUGIN_RULE_LINEAR, Scalarm(0),
          [](const Mesh &mesh, Element v, std::size_t) { return mesh.vert[v].cQ(); });
    carry(face_qualities_, MeshModel::MM_FACEQUALITY, GUSSET_PLUGIN_FACES, GUSSET_PLUGIN_RULE_LINEAR, Scalarm(0),
          [](const Mesh &mesh, Element f, std::size_t) { return mesh.face[f].cQ(); });

    const auto of_vertex = [&](const Mesh &mesh, Element v, std::size_t input) {
        return textures.number(input, mesh.vert[v].cT().N());
    };
    const auto of_face = [&](const Mesh &mesh, Element f, std::size_t input) {
        return textures.number(input, mesh.face[f].cWT(0).N());
    };
    carry(vertex_textures_, MeshModel::MM_VERTTEXCOORD, GUSSET_PLUGIN_VERTICES, GUSSET_PLUGIN_RULE_NEAREST, NO_TEXTURE,
          of_vertex);
    carry(vertex_coordinates_, MeshModel::MM_VERTTEXCOORD, GUSSET_PLUGIN_VERTICES, GUSSET_PLUGIN_RULE_LINEAR, nowhere,
          [&](const Mesh &mesh, Element v, std::size_t input) {
              return coordinates(mesh.vert[v].cT(), of_vertex(mesh, v, input));
          });
    carry(face_textures_, MeshModel::MM_WEDGTEXCOORD, GUSSET_PLUGIN_FACES, GUSSET_PLUGIN_RULE_NEAREST, NO_TEXTURE,
          of_face);
    carry(corner_coordinates_, MeshModel::MM_WEDGTEXCOORD, GUSSET_PLUGIN_CORNERS, GUSSET_PLUGIN_RULE_TEXTURE, nowhere,
          [&](const Mesh &mesh, Element wedge, std::size_t input) {
              const Element f = wedge / 3;
              return coordinates(mesh.face[f].cWT(static_cast<int>(wedge % 3)), of_face(mesh, f, input));
          });

    textures_ = textures.names();
    for (std::size_t input = 0; input < inputs.list().size(); ++input) {
        for (const auto &[name, image] : inputs.layer(input).getTextures()) {
            if (std::find(textures_.begin(), textures_.end(), name) != textures_.end()) {
                images_.emplace(name, image);
            }
        }
    }
}

void Attributes::put(MeshModel &layer, const Triangles &triangles) const {
    layer.updateDataMask(which_);
    const auto has = [&](int what) { return (which_ & what) != 0; };
    for (std::size_t v = 0; v < layer.cm.vert.size(); ++v) {
        CVertexO &vertex = layer.cm.vert[v];
        if (has(MeshModel::MM_VERTCOLOR)) {
            vertex.C() = vertex_colours_[v];
        }
        if (has(MeshModel::MM_VERTQUALITY)) {
            vertex.Q() = vertex_qualities_[v];
        }
        if (has(MeshModel::MM_VERTTEXCOORD)) {
            vertex.T().P() = {vertex_coordinates_[v][0], vertex_coordinates_[v][1]};
            vertex.T().N() = vertex_textures_[v];
        }
    }
    for (std::size_t f = 0; f < layer.cm.face.size(); ++f) {
        CFaceO &face = layer.cm.face[f];
        const std::uint32_t polygon = triangles.faces[f];
        if (has(MeshModel::MM_FACECOLOR)) {
            face.C() = face_colours_[polygon];
        }
        if (has(MeshModel::MM_FACEQUALITY)) {
            face.Q() = face_qualities_[polygon];
        }
        for (int k = 0; k < 3 && has(MeshModel::MM_WEDGTEXCOORD); ++k) {
            const Point3f &at = corner_coordinates_[triangles.corners[3 * f + static_cast<std::size_t>(k)]];
            face.WT(k).P() = {at[0], at[1]};
            face.WT(k).N() = face_textures_[polygon];
        }
    }
    // Names without images stay names, as in the layers that had them.
    layer.cm.textures = textures_;
    for (const auto &[name, image] : images_) {
        layer.addTexture(name, image);
    }
}

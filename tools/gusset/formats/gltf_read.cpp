// glTF by tinygltf: the triangles of all meshes that the scene shows, where it shows them, with their materials. Skins and
// animations are left.
#include "../attributes.hpp"
#include "../failure.hpp"
#include "bytes.hpp"
#include "formats.hpp"
#include "gltf_materials.hpp"
#include "gltf_matrix.hpp"
#include "gltf_values.hpp"
#include "scanner.hpp"

#include <tiny_gltf.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <unordered_map>

namespace {
const std::set<std::string> read_attributes = {"POSITION", "NORMAL", "TEXCOORD_0", "COLOR_0", vertex_attribute};

/// The most zeros of accessors that have only a count.
constexpr std::size_t most_zeros = std::size_t{1} << 24;

class Reader {
public:
    Reader(const std::string &path_, std::shared_ptr<const tinygltf::Model> model_)
        : path(path_), owned(std::move(model_)), model(*owned) {}

    Mesh read() {
        const auto mesh_nodes = [&](const std::vector<int> &roots) {
            for (const int node : roots) {
                visit(node, identity, 0);
            }
        };
        if (!model.scenes.empty()) {
            const int shown = model.defaultScene >= 0 ? model.defaultScene : 0;
            mesh_nodes(at(model.scenes, shown, "scene").nodes);
        } else {
            for (std::size_t m = 0; m < model.meshes.size(); ++m) {
                add(static_cast<int>(m), identity);
            }
        }
        finish();
        return std::move(mesh);
    }

private:
    [[noreturn]] void fail(const std::string &why) const { throw Failure(Exit::file, path + ": " + why); }

    template <class T> const T &at(const std::vector<T> &all, int place, const char *what) const {
        if (place < 0 || static_cast<std::size_t>(place) >= all.size()) {
            fail(std::string("it names ") + what + ' ' + std::to_string(place) + ", and there are " +
                 std::to_string(all.size()) + ", from 0 on");
        }
        return all[static_cast<std::size_t>(place)];
    }

    void visit(int place, const Matrix &parent, std::size_t depth) {
        if (depth > model.nodes.size()) {
            fail("its nodes are their own children");
        }
        const tinygltf::Node &node = at(model.nodes, place, "node");
        const Matrix own = product(parent, matrix_of(node));
        if (node.mesh >= 0) {
            add(node.mesh, own);
        }
        skinned = skinned || node.skin >= 0;
        for (const int child : node.children) {
            visit(child, own, depth + 1);
        }
    }

    /// All numbers of an accessor of `width` numbers an element.
    std::vector<double> numbers(int place, std::size_t width) const {
        const tinygltf::Accessor &accessor = at(model.accessors, place, "accessor");
        const std::string name = "accessor " + std::to_string(place);
        if (accessor.sparse.isSparse) {
            fail(name + " is sparse, which is not read");
        }
        if (static_cast<std::size_t>(tinygltf::GetNumComponentsInType(static_cast<uint32_t>(accessor.type))) != width) {
            fail(name + " has elements of another size than " + std::to_string(width));
        }
        // Before memory is taken for numbers that are not there.
        if (accessor.bufferView < 0) {
            if (accessor.count > most_zeros) {
                fail(name + " has " + std::to_string(accessor.count) + " elements, and no numbers");
            }
            return std::vector<double>(accessor.count * width);
        }
        const tinygltf::BufferView &view = at(model.bufferViews, accessor.bufferView, "buffer view");
        const auto &bytes = at(model.buffers, view.buffer, "buffer").data;
        const auto size = tinygltf::GetComponentSizeInBytes(static_cast<uint32_t>(accessor.componentType));
        const int stride = accessor.ByteStride(view);
        if (size <= 0 || stride <= 0) {
            fail(name + " has numbers of an unknown type");
        }
        const std::size_t part = static_cast<std::size_t>(size), step = static_cast<std::size_t>(stride);
        const std::size_t start = view.byteOffset + accessor.byteOffset;
        if (accessor.count > 0 &&
            (start > bytes.size() || (accessor.count - 1) * step + width * part > bytes.size() - start)) {
            fail(name + " reaches beyond its buffer");
        }
        std::vector<double> all(accessor.count * width);
        const std::string_view text(reinterpret_cast<const char *>(bytes.data()), bytes.size());
        for (std::size_t k = 0; k < all.size(); ++k) {
            all[k] = number(text, start + k / width * step + k % width * part, accessor);
        }
        return all;
    }

    double number(std::string_view bytes, std::size_t place, const tinygltf::Accessor &accessor) const {
        const auto part = [&](double value, double greatest) {
            return accessor.normalized ? std::max(value / greatest, -1.0) : value;
        };
        switch (accessor.componentType) {
        case TINYGLTF_COMPONENT_TYPE_BYTE:
            return part(number_at<int8_t>(bytes, place), INT8_MAX);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            return part(number_at<uint8_t>(bytes, place), UINT8_MAX);
        case TINYGLTF_COMPONENT_TYPE_SHORT:
            return part(number_at<int16_t>(bytes, place), INT16_MAX);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            return part(number_at<uint16_t>(bytes, place), UINT16_MAX);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
            return number_at<uint32_t>(bytes, place);
        case TINYGLTF_COMPONENT_TYPE_FLOAT:
            return static_cast<double>(number_at<float>(bytes, place));
        default:
            fail("it has numbers of an unknown type");
        }
    }

    void add(int place, const Matrix &by) {
        shared.clear();
        for (const tinygltf::Primitive &primitive : at(model.meshes, place, "mesh").primitives) {
            if (primitive.mode != TINYGLTF_MODE_TRIANGLES && primitive.mode != TINYGLTF_MODE_TRIANGLE_STRIP &&
                primitive.mode != TINYGLTF_MODE_TRIANGLE_FAN && primitive.mode != -1) {
                has_lines = true;
                continue;
            }
            add(primitive, by);
        }
    }

    void add(const tinygltf::Primitive &primitive, const Matrix &by) {
        const auto attribute = [&](const char *name) {
            const auto found = primitive.attributes.find(name);
            return found == primitive.attributes.end() ? -1 : found->second;
        };
        if (attribute("POSITION") < 0) {
            fail("a mesh has no positions");
        }
        morphed = morphed || !primitive.targets.empty();
        for (const auto &[name, accessor] : primitive.attributes) {
            if (read_attributes.count(name) == 0) {
                others.insert(name);
            }
        }
        const auto [known, is_new] = shared.emplace(primitive.attributes, std::pair(mesh.points.size(), 0));
        if (is_new) {
            const std::vector<double> positions = numbers(attribute("POSITION"), 3);
            const std::size_t added = positions.size() / 3;
            for (std::size_t v = 0; v < added; ++v) {
                const Point p{positions[3 * v], positions[3 * v + 1], positions[3 * v + 2]};
                mesh.points.push_back(by == identity ? p : moved(by, p));
            }
            add_normals(attribute("NORMAL"), added, by);
            add_texcoords(attribute("TEXCOORD_0"), added);
            add_colours(attribute("COLOR_0"), added);
            add_numbers(attribute(vertex_attribute), known->second.first, added);
            known->second.second = added;
        }
        const auto [first, count] = known->second;
        std::vector<uint32_t> indices;
        if (primitive.indices >= 0) {
            for (const double index : numbers(primitive.indices, 1)) {
                if (index >= static_cast<double>(count)) {
                    fail(Element{"face", mesh.face_count() + indices.size() / 3}.text() + ": it names vertex " +
                         std::to_string(static_cast<uint32_t>(index)) + ", and there are " + std::to_string(count) +
                         ", from 0 on");
                }
                indices.push_back(static_cast<uint32_t>(first + static_cast<std::size_t>(index)));
            }
        } else {
            for (std::size_t v = 0; v < count; ++v) {
                indices.push_back(static_cast<uint32_t>(first + v));
            }
        }
        add_faces(primitive, indices, determinant(by) < 0);
        add_material(primitive.material);
    }

    /// To all faces since the last one.
    void add_material(int place) {
        uint32_t number = no_material;
        if (place >= 0) {
            static_cast<void>(at(model.materials, place, "material"));
            const auto [found, is_new] = materials.emplace(place, static_cast<uint32_t>(mesh.materials.size()));
            if (is_new) {
                mesh.materials.push_back(
                    material_of(owned, place, std::filesystem::path(path).parent_path().string()));
            }
            number = found->second;
        }
        mesh.face_materials.resize(mesh.face_count(), number);
    }

    /// Values of this primitive behind those of the ones before, which may have had none.
    template <std::size_t N> void add_values(Attribute<N> &into, int accessor, std::size_t count) {
        if (accessor < 0) {
            into.values.resize(into.values.size() + count, missing<N>());
            return;
        }
        const std::vector<double> all = numbers(accessor, N);
        if (all.size() != N * count) {
            fail("an attribute has another number of elements than there are positions");
        }
        into.at = Attribute<N>::At::vertices;
        for (std::size_t v = 0; v < count; ++v) {
            into.values.emplace_back();
            std::copy_n(all.begin() + static_cast<std::ptrdiff_t>(N * v), N, into.values.back().begin());
        }
    }

    void add_normals(int accessor, std::size_t count, const Matrix &by) {
        add_values(mesh.normals, accessor, count);
        const auto turn = cofactors(by);
        for (std::size_t v = mesh.normals.values.size() - count; by != identity && v < mesh.normals.values.size();
             ++v) {
            auto &normal = mesh.normals.values[v];
            std::array<double, 3> made;
            for (std::size_t i = 0; i < 3; ++i) {
                made[i] = turn[i][0] * normal[0] + turn[i][1] * normal[1] + turn[i][2] * normal[2];
            }
            const double length = std::hypot(made[0], made[1], made[2]);
            for (std::size_t i = 0; i < 3; ++i) {
                normal[i] = length > 0 || std::isnan(length) ? made[i] / length : 0;
            }
        }
    }

    void add_texcoords(int accessor, std::size_t count) {
        add_values(mesh.texcoords, accessor, count);
        for (std::size_t v = mesh.texcoords.values.size() - count; v < mesh.texcoords.values.size(); ++v) {
            // Images hang down from their first row here, and stand on their last one elsewhere.
            mesh.texcoords.values[v][1] = 1 - mesh.texcoords.values[v][1];
        }
    }

    void add_colours(int accessor, std::size_t count) {
        mesh.vertex_colours.resize(mesh.vertex_colours.size() + count, white);
        if (accessor < 0) {
            return;
        }
        const bool opacity = at(model.accessors, accessor, "accessor").type == TINYGLTF_TYPE_VEC4;
        const std::size_t width = opacity ? 4 : 3;
        const std::vector<double> all = numbers(accessor, width);
        if (all.size() != width * count) {
            fail("an attribute has another number of elements than there are positions");
        }
        coloured = true;
        Colour *colours = mesh.vertex_colours.data() + mesh.vertex_colours.size() - count;
        for (std::size_t k = 0; k < all.size(); ++k) {
            colours[k / width][k % width] = static_cast<float>(k % width == 3 ? all[k] : shown_of(all[k]));
        }
    }

    void add_numbers(int accessor, std::size_t first, std::size_t count) {
        for (std::size_t v = 0; v < count; ++v) {
            origins.push_back(static_cast<uint32_t>(first + v));
        }
        if (accessor < 0) {
            return;
        }
        numbered = true;
        const std::vector<double> halves = numbers(accessor, 2);
        for (std::size_t v = 0; v < count && 2 * v + 1 < halves.size(); ++v) {
            const double origin = halves[2 * v] + 65536 * halves[2 * v + 1];
            if (origin >= 0 && origin < static_cast<double>(count)) {
                origins[first + v] = static_cast<uint32_t>(first + static_cast<std::size_t>(origin));
            }
        }
    }

    void add_faces(const tinygltf::Primitive &primitive, const std::vector<uint32_t> &indices, bool turned) {
        const bool polygons = primitive.extensions.count(polygons_extension) > 0;
        std::vector<uint32_t> face;
        const auto flush = [&] {
            if (turned) {
                std::reverse(face.begin(), face.end());
            }
            if (!face.empty()) {
                mesh.add_face(face);
            }
            face.clear();
        };
        const std::size_t step =
            primitive.mode == TINYGLTF_MODE_TRIANGLE_STRIP || primitive.mode == TINYGLTF_MODE_TRIANGLE_FAN ? 1 : 3;
        for (std::size_t k = 0; k + 2 < indices.size(); k += step) {
            std::array<uint32_t, 3> triangle{indices[k], indices[k + 1], indices[k + 2]};
            if (primitive.mode == TINYGLTF_MODE_TRIANGLE_FAN) {
                triangle[0] = indices[0];
            } else if (step == 1 && k % 2 == 1) {
                std::swap(triangle[0], triangle[1]);
            }
            if (polygons && !face.empty() && face.front() == triangle[0] && face.back() == triangle[1]) {
                face.push_back(triangle[2]);
                continue;
            }
            flush();
            face.assign(triangle.begin(), triangle.end());
        }
        flush();
    }

    /// Vertices that were divided are one again, and what divided them is at their corners.
    void unite() {
        bool divided = false;
        for (std::size_t v = 0; v < origins.size(); ++v) {
            divided = divided || origins[v] != v;
        }
        if (!divided) {
            return;
        }
        // At the corners, unless it is not what divided them.
        const auto gather = [&](auto &attribute) {
            bool alike = true;
            for (std::size_t v = 0; attribute && v < origins.size(); ++v) {
                alike = alike && attribute.values[v] == attribute.values[origins[v]];
            }
            if (attribute && !alike) {
                attribute = {std::decay_t<decltype(attribute)>::At::corners, at_corners(mesh, attribute)};
                return false;
            }
            return bool(attribute);
        };
        const bool normals_stay = gather(mesh.normals), texcoords_stay = gather(mesh.texcoords);
        std::vector<uint32_t> places(origins.size());
        std::size_t kept = 0;
        for (std::size_t v = 0; v < origins.size(); ++v) {
            if (origins[v] == v) {
                places[v] = static_cast<uint32_t>(kept);
                mesh.points[kept] = mesh.points[v];
                mesh.vertex_colours[kept] = mesh.vertex_colours[v];
                if (normals_stay) {
                    mesh.normals.values[kept] = mesh.normals.values[v];
                }
                if (texcoords_stay) {
                    mesh.texcoords.values[kept] = mesh.texcoords.values[v];
                }
                ++kept;
            }
        }
        mesh.points.resize(kept);
        mesh.vertex_colours.resize(kept);
        mesh.normals.values.resize(normals_stay ? kept : mesh.normals.values.size());
        mesh.texcoords.values.resize(texcoords_stay ? kept : mesh.texcoords.values.size());
        for (uint32_t &v : mesh.corners) {
            v = places[origins[v]];
        }
    }

    /// Vertices that are apart for their normals or texture coordinates are one: those at equal positions. What this
    /// program wrote says itself which ones.
    void merge() {
        const bool apart = bool(mesh.normals) || bool(mesh.texcoords);
        if (!apart || numbered) {
            return;
        }
        std::map<Point, uint32_t> known;
        bool any = false;
        for (std::size_t v = 0; v < mesh.points.size(); ++v) {
            const auto own = static_cast<uint32_t>(v);
            mesh.merge.push_back(known.emplace(mesh.points[v], own).first->second);
            any = any || mesh.merge.back() != own;
        }
        if (!any) {
            mesh.merge.clear();
        }
    }

    void finish() {
        unite();
        merge();
        if (mesh.materials.empty()) {
            mesh.face_materials.clear();
        }
        if (!mesh.normals) {
            mesh.normals = {};
        }
        if (!mesh.texcoords) {
            mesh.texcoords = {};
        }
        if (!coloured) {
            mesh.vertex_colours.clear();
        }
        const auto note = [&](bool there, const char *what) {
            if (there) {
                mesh.unread.emplace_back(what);
            }
        };
        for (const std::string &name : others) {
            note(true, name.c_str());
        }
        note(has_lines, "points and lines");
        note(morphed, "morph targets");
        note(skinned, "skins");
        note(!model.animations.empty(), "animations");
        simplify(mesh);
    }

    const std::string &path;
    std::shared_ptr<const tinygltf::Model> owned;
    const tinygltf::Model &model;
    Mesh mesh;
    /// Of the mesh that is being added, where vertices of the same arrays begin, and how many there are.
    std::map<std::map<std::string, int>, std::pair<std::size_t, std::size_t>> shared;
    /// The numbers that materials have in the mesh.
    std::map<int, uint32_t> materials;
    /// Of each vertex, the one that it was divided from.
    std::vector<uint32_t> origins;
    /// Attributes of vertices that have no place in a mesh.
    std::set<std::string> others;
    bool coloured = false, numbered = false, has_lines = false, morphed = false, skinned = false;
};

} // namespace

Mesh read_gltf(const std::string &path, bool binary) {
    tinygltf::TinyGLTF loader;
    loader.SetImageLoader(keep_image, nullptr);
    const auto owned = std::make_shared<tinygltf::Model>();
    tinygltf::Model &model = *owned;
    std::string error, warning;
    bool read = false;
    try {
        read = binary ? loader.LoadBinaryFromFile(&model, &error, &warning, path)
                      : loader.LoadASCIIFromFile(&model, &error, &warning, path);
    } catch (const std::bad_alloc &) {
        throw;
    } catch (const std::exception &thrown) {
        error = thrown.what();
    }
    if (!read) {
        const std::string reason = error.substr(0, error.find('\n'));
        throw Failure(Exit::file, path + ": " + (reason.empty() ? "it is no glTF file" : reason));
    }
    // What a file requires beyond this nobody can do without.
    static const std::set<std::string> known = {polygons_extension, "KHR_mesh_quantization"};
    for (const std::string &extension : model.extensionsRequired) {
        if (known.count(extension) == 0 && extension.compare(0, 13, "KHR_materials") != 0) {
            throw Failure(Exit::file, path + ": it requires the extension " + extension + ", which is not read");
        }
    }
    return Reader(path, owned).read();
}

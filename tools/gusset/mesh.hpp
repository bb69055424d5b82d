// Meshes and curves as files hold them and as the plugin reads them.
#pragma once

#include "material.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

using Point = std::array<double, 3>;
/// Values of N numbers at vertices or at corners. One that begins with NaN is missing: a corner without a texture, say.
template <std::size_t N> struct Attribute {
    enum class At { nothing, vertices, corners };
    At at = At::nothing;
    std::vector<std::array<double, N>> values;

    explicit operator bool() const { return at != At::nothing; }
};

/// A number for each vertex or each face, by the name and the type that a PLY file has for it: "float", "uchar".
struct Property {
    std::string name, type;
    bool of_faces = false;
    std::vector<double> values;

    bool is_whole() const { return type != "float" && type != "double"; }
};

/// A soup of polygons: face f has the corners offsets[f] to offsets[f + 1] - 1. Nothing is welded, turned over or left
/// out.
struct Mesh {
    std::vector<Point> points;
    std::vector<uint32_t> offsets{0};
    std::vector<uint32_t> corners;

    /// As many as there are points and faces, or none.
    std::vector<Colour> vertex_colours, face_colours;
    Attribute<3> normals;
    Attribute<2> texcoords;
    /// The materials that there are, and for each face the number of its own; none for no face if there are none.
    std::vector<Material> materials;
    std::vector<uint32_t> face_materials;
    std::vector<Property> properties;
    /// For each vertex the one that it is one with, of formats that keep vertices apart for their normals or texture
    /// coordinates; empty if each is for itself.
    std::vector<uint32_t> merge;

    /// What the file had that has no place here: "skins", "groups".
    std::vector<std::string> unread;

    std::size_t face_count() const { return offsets.size() - 1; }
    std::size_t degree(std::size_t face) const { return offsets[face + 1] - offsets[face]; }
    void add_face(const std::vector<uint32_t> &vertices) {
        corners.insert(corners.end(), vertices.begin(), vertices.end());
        offsets.push_back(static_cast<uint32_t>(corners.size()));
    }
};

/// Polylines: curve c has the points offsets[c] to offsets[c + 1] - 1, and closed[c] is 1 if an edge leads back to the
/// first.
struct Curves {
    std::vector<Point> points;
    std::vector<uint32_t> offsets{0};
    std::vector<uint8_t> closed;
};

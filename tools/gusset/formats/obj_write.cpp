// OBJ as text: colours of vertices behind their coordinates, normals and texture coordinates by their own indices.
#include "../attributes.hpp"
#include "formats.hpp"
#include "mtl.hpp"
#include "writer.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>

namespace {
/// The lines of an attribute, and for each corner the number of its line from 1; 0 for none.
template <std::size_t N>
std::vector<uint32_t> write_values(Writer &out, const char *name, const Mesh &mesh, const Attribute<N> &of) {
    if (!of) {
        return {};
    }
    std::vector<uint32_t> lines;
    std::map<std::array<double, N>, uint32_t> known;
    lines.reserve(mesh.corners.size());
    for (const auto &value : at_corners(mesh, of)) {
        if (is_missing(value)) {
            lines.push_back(0);
            continue;
        }
        const auto [place, is_new] = known.emplace(value, static_cast<uint32_t>(known.size() + 1));
        if (is_new) {
            out << name;
            for (const double x : value) {
                out << ' ' << x;
            }
            out << '\n';
        }
        lines.push_back(place->second);
    }
    return lines;
}

void write_points(Writer &out, const std::vector<Point> &points, const std::vector<Colour> &colours) {
    for (std::size_t v = 0; v < points.size(); ++v) {
        out << 'v';
        for (const double x : points[v]) {
            out << ' ' << x;
        }
        for (std::size_t k = 0; !colours.empty() && k < 3; ++k) {
            // Six digits tell all steps of a screen apart.
            char text[32];
            std::snprintf(text, sizeof text, " %.6g", static_cast<double>(colours[v][k]));
            out << static_cast<const char *>(text);
        }
        out << '\n';
    }
}
} // namespace

Losses write_obj(const std::string &path, const Mesh &mesh) {
    Writer out(path);
    const UsedMaterials materials = used_materials(mesh);
    if (!materials.all.empty()) {
        const auto library = std::filesystem::path(path).replace_extension(".mtl");
        write_mtl(library.string(), materials);
        out << "mtllib " << library.filename().string() << '\n';
    }
    // There is no word for none: a name that no library has.
    std::string none = "none";
    while (std::find(materials.names.begin(), materials.names.end(), none) != materials.names.end()) {
        none = '(' + none + ')';
    }
    uint32_t material = no_material;
    write_points(out, mesh.points, mesh.vertex_colours);
    const auto texcoords = write_values(out, "vt", mesh, mesh.texcoords);
    const auto normals = write_values(out, "vn", mesh, mesh.normals);
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        if (!materials.all.empty() && materials.of_faces[f] != material) {
            material = materials.of_faces[f];
            out << "usemtl " << (material == no_material ? none : materials.names[material]) << '\n';
        }
        out << 'f';
        // A face has either all of them or none.
        bool textured = !texcoords.empty(), directed = !normals.empty();
        for (uint32_t c = mesh.offsets[f]; c < mesh.offsets[f + 1]; ++c) {
            textured = textured && texcoords[c] != 0;
            directed = directed && normals[c] != 0;
        }
        for (uint32_t c = mesh.offsets[f]; c < mesh.offsets[f + 1]; ++c) {
            out << ' ' << mesh.corners[c] + 1;
            if (textured) {
                out << '/' << texcoords[c];
            }
            if (directed) {
                out << (textured ? "/" : "//") << normals[c];
            }
        }
        out << '\n';
    }
    out.finish();
    Losses losses;
    if (!mesh.face_colours.empty()) {
        losses.emplace_back("colours of faces, which OBJ files do not hold");
    }
    if (!are_opaque(mesh.vertex_colours)) {
        losses.emplace_back("the opacity of vertices, which OBJ files do not hold");
    }
    return losses;
}

void write_obj_lines(const std::string &path, const Curves &curves) {
    Writer out(path);
    write_points(out, curves.points, {});
    for (std::size_t c = 0; c + 1 < curves.offsets.size(); ++c) {
        const uint32_t first = curves.offsets[c], end = curves.offsets[c + 1];
        if (first == end) {
            continue;
        }
        out << 'l';
        for (uint32_t p = first; p < end; ++p) {
            out << ' ' << p + 1;
        }
        if (curves.closed[c] != 0) {
            out << ' ' << first + 1;
        }
        out << '\n';
    }
    out.finish();
}
